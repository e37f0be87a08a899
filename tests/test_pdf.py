"""Compiling the handbook: same bytes, messages that name the key, and what is said without LaTeX."""

from __future__ import annotations

import os
import re

import pytest
from scenes import NEEDLE, NO_PDF, OUTSIDE

from axiderive.book.handbook import templates
from axiderive.build import pdf
from axiderive.scene import reading, text
from axiderive.scene.compose import composed

DOCUMENT = rb"""\documentclass{article}
\begin{document}
%% cone.p
See \ref{two}.\label{one}\par
%% cone.w
THE ROW
\newpage Second page.\label{two}
\end{document}
"""

with_latex = pytest.mark.skipif(not pdf.has_latex(), reason="needs pdflatex")


@with_latex
def test_a_document_is_compiled_until_its_references_settle_and_always_to_the_same_bytes():
    sources = {"main.tex": b"\\pdfinfoomitdate=1 \\pdfsuppressptexinfo=-1 \\pdftrailerid{}\n" + DOCUMENT}
    content, warnings = pdf.compile_pdf(sources)
    assert content.startswith(b"%PDF")
    assert warnings == []
    assert pdf.compile_pdf(sources)[0] == content


@with_latex
@pytest.mark.parametrize("source", [NEEDLE + NO_PDF, f'profile = "{OUTSIDE}"{NO_PDF}'], ids=["catalogue", "own"])
def test_the_page_of_a_scene_needs_one_pass(source: str, monkeypatch: pytest.MonkeyPatch):
    passes, one_pass = [], pdf._one_pass
    monkeypatch.setattr(pdf, "_one_pass", lambda *given: passes.append(one_pass(*given)))
    pages: list[dict[str, bytes]] = []
    composed(reading.read(text.parse("scene", source.encode())), typeset=pages.append)
    assert pdf.compile_page(pages[0]).startswith(b"%PDF")
    assert len(passes) == 1


@with_latex
def test_a_page_with_a_reference_gets_another_pass():
    sources = {"main.tex": b"\\pdfinfoomitdate=1 \\pdfsuppressptexinfo=-1 \\pdftrailerid{}\n" + DOCUMENT}
    assert pdf.compile_page(sources) == pdf.compile_pdf(sources)[0]


def test_pictures_are_left_out_line_for_line_and_by_boxes_of_their_size():
    box = b" \\path[use as bounding box] (0,0) rectangle (1,1);\n"
    sketched = b"a\n\\begin{tikzpicture}[x=9mm]\n" + box + b" x\n\\end{tikzpicture}\nb"
    unknown = b"\\begin{tikzpicture}\n x\n\\end{tikzpicture}"
    found = pdf.without_pictures(b"\n".join((sketched, unknown)))
    assert found.count(b"\n") == b"\n".join((sketched, unknown)).count(b"\n")
    assert b"\n\n" not in found
    assert rb"\begin{tikzpicture}[x=9mm]\path[use as bounding box] (0,0) rectangle (1,1);\end{tikzpicture}" in found
    assert found.endswith(unknown)


@with_latex
@pytest.mark.parametrize(
    ("row", "message"),
    [
        (rb"\arccosh x", r"main.tex:6: [cone.w] Undefined control sequence. \arccosh"),
        (rb"x^2", "main.tex:6: [cone.w] Missing $ inserted."),
    ],
)
def test_errors_of_tex_name_the_key(row, message):
    with pytest.raises(pdf.LatexError) as stopped:
        pdf.compile_pdf({"main.tex": DOCUMENT.replace(b"THE ROW", row)})
    assert message in str(stopped.value).splitlines()


@with_latex
def test_overfull_lines_and_dangling_references_are_remarks_with_a_key():
    row = rb"\noindent\rule{500pt}{1pt}\par See \ref{nowhere}."
    remarks = pdf.compile_pdf({"main.tex": DOCUMENT.replace(b"THE ROW", row)})[1]
    assert any(re.fullmatch(r"main\.tex:\d+: \[cone\.w\] line is \d+\.\d mm too wide", remark) for remark in remarks)
    assert any(remark.startswith("reference nowhere ") for remark in remarks)


def test_an_overfull_line_is_in_the_file_that_is_read():
    """A name with a dot too: else the line was one of the file before, which may have a key there."""
    files = ("profiles/cone.tex", "profiles/loads.uniform.tex")
    log = f"(./{files[0]}) (./{files[1]}\nOverfull \\hbox (99.0pt too wide) in alignment at lines 2--3\n"
    sources = {"main.tex": DOCUMENT} | {file: f"%% {file[9:-4]}.w\nx\ny\n".encode() for file in files}
    assert pdf.problems(log, sources) == [f"{files[1]}:2: [loads.uniform.w] line is 34.8 mm too wide"]


def test_a_page_under_half_full_is_a_remark_unless_it_is_the_first_or_the_last():
    shares = {1: 20, 2: 1004, 3: 490, 4: 500, 5: 9}
    log = "".join(f"Page {page} is filled to {share} of 1000\n" for page, share in shares.items())
    assert pdf.filled(log) == {page: share / 1000 for page, share in shares.items()}
    assert pdf.problems(log, {"main.tex": DOCUMENT}) == ["page 3 is filled to 49 % only"]


def test_an_entry_of_some_pages_that_begins_on_a_right_one_is_a_remark():
    log = "Entry cone has 3 pages from 14\nEntry plane.wedge has 1 pages from 17\nEntry gaussian has 2 pages from 19\n"
    assert pdf.problems(log, {"main.tex": DOCUMENT}) == ["gaussian has 2 pages and begins on page 19, a right one"]


def _entry(key: str, rows: int) -> str:
    shown = "\\hairline\n".join(rf"\frow{{Row}}{{}}{{x=\frac{{a}}{{b}}}}{{k{i}}}" for i in range(rows))
    return rf"\entryhead{{1}}{{{key}}}{{{key}}}{{words}}\sect{{Rows}}{shown}\entryend"


@with_latex
@pytest.mark.slow
def test_an_entry_ends_on_a_full_page_or_shares_the_last_two(tmp_path):
    """25 rows are set tighter on one page, and of 33 enough move on to the second; 40 fill two as they are."""
    entries = "\n".join(_entry(key, rows) for key, rows in (("early", 33), ("plain", 40), ("tight", 25)))
    head = b"\\documentclass[10pt,a4paper,twoside]{article}\\input{preamble}\\begin{document}\\thispagestyle{empty}x\n"
    sources = {
        "book.tex": head + entries.encode() + b"\n\\end{document}\n",
        "preamble.tex": templates().get_template("preamble.tex.j2").render(version="0", edition="0").encode(),
    }
    pdf._write(tmp_path, sources)
    pdf._until_settled(tmp_path, "book.tex", sources)
    log = (tmp_path / "book.log").read_text(errors="replace")
    found = pdf.filled(log)
    assert pdf.problems(log, sources) == []
    assert len(found) == 6
    assert found[6] > 0.9
    assert min(found[page] for page in range(2, 7)) > pdf.LEAST_FILLED


def test_without_latex_the_command_that_installs_it_is_printed(monkeypatch):
    monkeypatch.setattr(pdf, "has_latex", lambda: False)
    with pytest.raises(
        pdf.NoLatexError, match="apt-get install --no-install-recommends texlive-latex-recommended .* tex-gyre"
    ):
        pdf.ensure_latex(install=False, say=lambda text: None)


def test_as_root_latex_is_installed(monkeypatch, tmp_path):
    """With a stand-in for apt-get that notes how it is called."""
    log = tmp_path / "log"
    (tmp_path / "apt-get").write_text(f'#!/bin/sh\necho "$DEBIAN_FRONTEND $@" >> {log}\n')
    (tmp_path / "apt-get").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    monkeypatch.setattr(os, "geteuid", lambda: 0)
    monkeypatch.setattr(pdf, "has_latex", lambda: log.exists() and "install" in log.read_text())
    said = []
    pdf.ensure_latex(install=True, say=said.append)
    assert said == ["first run: installing pdflatex (4 Debian packages, 114 MB) ..."]
    update, install = log.read_text().splitlines()
    assert update.startswith("noninteractive update")
    assert install.split()[1:3] == ["install", "--no-install-recommends"]
    assert set(pdf.PACKAGES) < set(install.split())
