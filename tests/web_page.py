"""A page of the web edition as its HTML says it, without a browser."""

from __future__ import annotations

from html.parser import HTMLParser


class Page(HTMLParser):
    """The ids, the addresses and the formulas of a page, and what stands in each element with an id."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.addresses: list[str] = []
        self.formulas: list[str] = []
        self._formula = False
        self.feed(text)

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        known = dict(attributes)
        self.ids += [known["id"] or ""] if "id" in known else []
        self.addresses += [known[name] or "" for name in ("href", "src", "action") if name in known]
        self._formula = known.get("class") == "tex"
        if self._formula:
            self.formulas.append("")

    def handle_data(self, data: str) -> None:
        if self._formula:
            self.formulas[-1] += data

    def handle_endtag(self, tag: str) -> None:
        self._formula = False
