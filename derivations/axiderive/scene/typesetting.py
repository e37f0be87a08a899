"""LaTeX at work on a page while the rest of a scene is written."""

from __future__ import annotations

from collections.abc import Mapping
from threading import Thread
from types import TracebackType

from .. import pdf
from ..exits import CommandError


class Typesetting:
    """A page that is typeset in the background; it is waited for at the end of the `with`."""

    def __init__(self) -> None:
        self._thread: Thread | None = None
        self._content = b""
        self._error: Exception | None = None

    def __enter__(self) -> Typesetting:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._join()

    def start(self, sources: Mapping[str, bytes]) -> None:
        """Begin with the page of these sources."""
        self._thread = Thread(target=self._typeset, args=(sources,))
        self._thread.start()

    def page(self) -> bytes:
        """The PDF, as soon as there is one; empty where LaTeX is missing, which is said.

        Raises
        ------
        CommandError
            If the page does not compile.
        """
        self._join()
        if isinstance(self._error, pdf.LatexError):
            message = f"the page does not compile, nothing was written\n{self._error}"
            raise CommandError(message) from self._error
        if isinstance(self._error, pdf.NoLatexError):
            print(self._error)
        elif self._error is not None:
            raise self._error
        return self._content

    def _join(self) -> None:
        if self._thread is not None:
            self._thread.join()

    def _typeset(self, sources: Mapping[str, bytes]) -> None:
        try:
            self._content = pdf.compile_page(sources)
        except (pdf.LatexError, OSError) as error:
            self._error = error
            # asked only now: where all is there it would cost a tenth of the pass
            try:
                pdf.ensure_latex(install=False, say=print)
            except pdf.NoLatexError as missing:
                self._error = missing
