"""The handbook's LaTeX made into a PDF, and TeX's complaints made readable."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

PACKAGES = ("texlive-latex-recommended", "texlive-pictures", "texlive-fonts-recommended", "tex-gyre")
SOURCES = frozenset({".tex", ".sty", ".cls"})
"""Suffixes of what the PDF is made of, beside the web edition in the same folder."""
INSTALL = f"apt-get install --no-install-recommends {' '.join(PACKAGES)}"
NEEDED = ("tikz.sty", "tgpagella.sty", "tgheros.sty", "mathpazo.sty", "booktabs.sty")
# without -halt-on-error a bad label kept pdflatex looping for minutes
PDFLATEX = ("pdflatex", "-no-shell-escape", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error")
TIMEOUT = 600
"""Seconds for one pass: it takes about 20 s of processor time, on a machine that may be busy with other things."""
MOST_PASSES = 7
WIDEST_OVERFULL_PT = 2.0
LEAST_FILLED = 0.5
"""Share of its height that a page holds; only the title page, the first, and the last may hold less."""


class LatexError(RuntimeError):
    """The handbook does not compile; the message has one line per problem, with the key it belongs to."""


class NoLatexError(RuntimeError):
    """pdflatex or one of its packages is missing; the message has the command that installs them."""


def ensure_latex(*, install: bool, say: Callable[[str], None]) -> None:
    """Install the Debian packages if they are missing and this process may; `NoLatexError` otherwise."""
    if has_latex():
        return
    sudo = "" if os.geteuid() == 0 else "sudo "
    hint = f"no PDF, because pdflatex or its packages are missing; to get it: {sudo}{INSTALL}"
    if not install or os.geteuid() != 0 or shutil.which("apt-get") is None:
        raise NoLatexError(hint)
    say(f"first run: installing pdflatex ({len(PACKAGES)} Debian packages, 114 MB) ...")
    environment = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    for command in (["apt-get", "update", "-qq"], [*INSTALL.split(), "--yes", "-qq"]):
        done = _run(command, env=environment)
        if done.returncode:
            last = (done.stderr.strip().splitlines() or ["no message"])[-1]
            message = f"{hint} (tried: {' '.join(command[:2])} said {last!r})"
            raise NoLatexError(message)
    if not has_latex():
        raise NoLatexError(hint)


def has_latex() -> bool:
    """Whether pdflatex and the packages of the handbook are here."""
    if shutil.which("pdflatex") is None or shutil.which("kpsewhich") is None:
        return False
    return len(_run(["kpsewhich", *NEEDED]).stdout.split()) == len(NEEDED)


def _run(command: Sequence[str], **more: Any) -> subprocess.CompletedProcess[str]:
    """A command that is asked nothing and says nothing on the terminal."""
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False, **more)


def main_file(sources: Mapping[str, bytes]) -> str:
    """The one source with a document class."""
    for path, content in sources.items():
        if path.endswith(".tex") and b"\\documentclass" in content:
            return path
    message = "the handbook has no file with a \\documentclass"
    raise LatexError(message)


def compile_pdf(sources: Mapping[str, bytes]) -> tuple[bytes, list[str]]:
    """PDF of the handbook and the warnings of the last pass.

    Passes are repeated until the .aux files no longer change: first with boxes in place of the pictures, which
    take four fifths of the time of a pass, then with the pictures, which as a rule takes one.
    """
    main = main_file(sources)
    with tempfile.TemporaryDirectory(prefix="axicontact-tex-") as name:
        folder = Path(name)
        _write(folder, {path: without_pictures(content) for path, content in sources.items()})
        _until_settled(folder, main, sources)
        _write(folder, sources)
        _until_settled(folder, main, sources)
        job = Path(main).stem
        log = (folder / f"{job}.log").read_text(errors="replace")
        return (folder / f"{job}.pdf").read_bytes(), problems(log, sources)


def compile_page(sources: Mapping[str, bytes]) -> bytes:
    """PDF of a document without references: one pass, and another one only where LaTeX asks for it."""
    main = main_file(sources)
    with tempfile.TemporaryDirectory(prefix="axicontact-tex-") as name:
        folder, job = Path(name), Path(main).stem
        _write(folder, sources)
        for _ in range(MOST_PASSES):
            _one_pass(folder, main, sources)
            if not _RERUN.search((folder / f"{job}.log").read_text(errors="replace")):
                break
        return (folder / f"{job}.pdf").read_bytes()


def _write(folder: Path, sources: Mapping[str, bytes]) -> None:
    for path, content in sources.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)


def _until_settled(folder: Path, main: str, sources: Mapping[str, bytes]) -> None:
    """Passes until one leaves the references as it found them."""
    before = _references(folder)
    for _ in range(MOST_PASSES):
        _one_pass(folder, main, sources)
        after = _references(folder)
        if after == before:
            return
        before = after


def _references(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.rglob("*.aux"))}


_RERUN = re.compile(r"^(?:LaTeX|Package) .*Warning: .*\bRerun\b", re.MULTILINE)
_PICTURE = re.compile(rb"\\begin\{tikzpicture\}(\[[^\]\n]*\])?.*?\\end\{tikzpicture\}", re.DOTALL)
_BOX = re.compile(rb"\\path\[use as bounding box\][^;]*;")


def without_pictures(source: bytes) -> bytes:
    """The source with an empty box of the same size for every picture whose size is known, line for line."""
    return _PICTURE.sub(_box, source)


def _box(match: re.Match[bytes]) -> bytes:
    box = _BOX.search(match[0])
    if box is None:
        return match[0]
    stub = b"\\begin{tikzpicture}" + (match[1] or b"") + box[0] + b"\\end{tikzpicture}"
    # a comment in front: behind the box it would leave an empty line, which ends the paragraph
    return b"%\n" * match[0].count(b"\n") + stub


def _one_pass(folder: Path, main: str, sources: Mapping[str, bytes]) -> None:
    # long lines of the log stay whole, so that its messages can be read
    environment = {**os.environ, "max_print_line": "10000", "openout_any": "p"}
    try:
        done = _run([*PDFLATEX, main], cwd=folder, env=environment, timeout=TIMEOUT, errors="replace")
    except subprocess.TimeoutExpired as error:
        message = f"pdflatex was stopped after {TIMEOUT} s"
        raise LatexError(message) from error
    log = folder / f"{Path(main).stem}.log"
    if done.returncode:
        found = stops(log.read_text(errors="replace"), sources) if log.exists() else []
        raise LatexError("\n".join(found or [f"pdflatex ended with code {done.returncode} and left no log"]))


def problems(log: str, sources: Mapping[str, bytes]) -> list[str]:
    """Errors, overfull lines and dangling references in a log, each with the key of the entry it is in."""
    found = [*stops(log, sources), *_overfull_lines(log, sources)]
    for match in re.finditer(r"^LaTeX Warning: (?:Hyper )?[Rr]eference `([^']+)' on page (\d+) undefined", log, re.M):
        found.append(f"reference {match[1]} (page {match[2]}) does not exist")
    pages = filled(log)
    for page, share in pages.items():
        # the title page, and the end of the index, are as full as they are
        if 1 < page < max(pages) and share < LEAST_FILLED:
            found.append(f"page {page} is filled to {100 * share:.0f} % only")
    for key, count, first in re.findall(r"^Entry (\S+) has (\d+) pages from (\d+)$", log, re.M):
        if int(count) > 1 and int(first) % 2:
            found.append(f"{key} has {count} pages and begins on page {first}, a right one")
    if "LaTeX Font Warning: Font shape" in log:
        found.append(f"a font shape was substituted; the fonts come with: {INSTALL}")
    return found


def filled(log: str) -> dict[int, float]:
    """How much of the height of each page is used, as the preamble of the handbook writes it into the log."""
    found = re.findall(r"^Page (\d+) is filled to (\d+) of 1000$", log, re.M)
    return {int(page): int(share) / 1000 for page, share in found}


def stops(log: str, sources: Mapping[str, bytes]) -> list[str]:
    """What made TeX stop; a pass that stopped early has found none of its references."""
    found = list(_errors(log, sources))
    if missing := re.search(r"LaTeX Error: File `([^']+)' not found", log):
        found.append(f"LaTeX package {missing[1]} is missing; {INSTALL}")
    if runaway := re.search(r"^! (?!LaTeX Error)(.+)\.$", log, re.M):
        found.append(f"{runaway[1]}: a brace does not close")
    return found


def _errors(log: str, sources: Mapping[str, bytes]) -> Iterator[str]:
    for match in re.finditer(r"^(?:\./)?([^\s:]+\.\w+):(\d+): (.+)$", log, re.M):
        path, line, text = match[1], int(match[2]), match[3]
        if "==> Fatal" in text:
            continue
        if "Undefined control" in text and (culprit := re.search(r"(\\[A-Za-z@]+) *$", log[match.end() :], re.M)):
            text += f" {culprit[1]}"
        yield f"{path}:{line}: [{_key_at(sources, path, line)}] {text}"


def _overfull_lines(log: str, sources: Mapping[str, bytes]) -> Iterator[str]:
    current = _file_tracker(log)
    main = main_file(sources)
    for match in re.finditer(r"^Overfull \\hbox \(([\d.]+)pt too wide\)[^\n]*?lines? (\d+)", log, re.M):
        excess, path, line = float(match[1]), current(match.start()), int(match[2])
        if line > sources.get(path, b"").count(b"\n"):  # TeX is back in the file that reads the others
            path = main
        if excess > WIDEST_OVERFULL_PT:
            yield f"{path}:{line}: [{_key_at(sources, path, line)}] line is {excess * 0.3515:.1f} mm too wide"


def _file_tracker(log: str) -> Callable[[int], str]:
    """Which source TeX was reading at a place of the log: it writes `(./file.tex` when one is opened."""
    opened = [(m.start(), m[1]) for m in re.finditer(r"\((?:\./)?([\w./-]+\.tex)", log)]
    return lambda place: next((path for start, path in reversed(opened) if start <= place), "handbook.tex")


def _key_at(sources: Mapping[str, bytes], path: str, line: int) -> str:
    """The key in the last `%% key` comment above a line."""
    for text in reversed(sources.get(path, b"").decode().splitlines()[:line]):
        if match := re.match(r"%% (\S+)", text):
            return match[1]
    return "preamble"
