"""The table of the notation in front of the book: nothing that a formula says is missing from it."""

from __future__ import annotations

import re
from functools import cache

import pytest
from stored_book import HANDBOOK, PRINTED

from axiderive import notation as nt
from axiderive.book import notation_table
from axiderive.readback.grammar import names
from axiderive.readback.source import GAP, OPENING, Formula, formulas

ENTRIES = tuple(f"profiles/{name}.tex" for name in PRINTED)


WORDS = re.compile(r"\\text\{(?:[^{}]|\{[^{}]*\})*\}")


@cache
def _text(path: str) -> str:
    return (HANDBOOK / path).read_text(encoding="utf-8")


def _told(text: str) -> set[str]:
    """The names of the first column of the table."""
    table = text.partition(r"\parthead{Notation}")[2].partition(r"\end{longtable}")[0]
    return {name for cell in re.findall(r"^\$(.*?)\$ &", table, re.MULTILINE) for name in _names(cell)}


def _names(tex: str) -> set[str]:
    """The names of a cell or a row; an approach has a formula on both sides."""
    plain = WORDS.sub(r",\\; ", tex.removeprefix(OPENING).removesuffix(r"\end{aligned}").replace(GAP, ""))
    return {name for part in re.split(r",\\;|\\to(?![a-z])", plain) if part.strip() for name in names(part)}


def _missing(rows: list[Formula], told: set[str]) -> set[str]:
    return {name for one in rows if one.kind != "function" for name in _names(one.tex)} - told


def _beside(text: str) -> set[str]:
    """The letters of the numbers below the contact, which rows of the page define, and N_n of a heading."""
    page = text.partition(r"\sect[]{Letters}")[2].partition(r"\sect")[0]
    letters = {name for left in re.findall(r"(?:\}\{\}\{|\\quad\\enspace )(\S+?)=", page) for name in _names(left)}
    return letters | {"N_n" for _ in re.findall(r"\$N_\{n\}\$ that of the slope", text)}


def _with_index(name: str, known: set[str]) -> bool:
    """Whether a letter with an index is one of those that are defined, or told, for any or for the first."""
    letter, line, _ = name.partition("_")
    return bool(line) and bool({f"{letter}_m", f"{letter}_n", f"{letter}_0"} & known)


@pytest.mark.parametrize("path", ("handbook.tex", *ENTRIES))
def test_every_symbol_of_a_formula_is_in_the_table_or_defined_beside_it(path: str) -> None:
    book = _text("handbook.tex")
    told = _told(book)
    beside = _beside(book) if path == "handbook.tex" else set()
    missing = _missing(formulas(_text(path)), told | beside)
    assert {name for name in missing if not (beside and _with_index(name, told | beside))} == set()


def test_a_letter_that_no_row_defines_is_missed() -> None:
    book = _text("handbook.tex")
    for left, name in ((r"\Lambda=", "Lambda"), (r"\omega=", "omega"), ("s_{m}=", "s_m")):
        assert name in _beside(book)
        page, end = book.partition(r"\sect[]{Letters}")[::2]
        assert name not in _beside(page + r"\sect[]{Letters}" + end.replace(left, "r=", 1))


def test_a_row_left_out_of_the_table_is_missed() -> None:
    rows = [one for path in ENTRIES for one in formulas(_text(path))]
    text = _text("handbook.tex")
    for latex in (r"\kappa,\;\kappa_j", r"F_{\mathrm c},\;F_{\mathrm m}", r"E^{*}", "J(t)", r"\mu"):
        assert (line := f"${latex}$ &") in text
        assert _missing(rows, _told(text.replace(line, "$r$ &")))


def test_every_record_has_its_place() -> None:
    stated = [name for members in notation_table.SUBJECTS.values() for name in members]
    placed = [*stated, *(name for _, members in notation_table.of_physics() for name in members)]
    assert len(placed) == len(set(placed))
    # written out, defined in the row that integrates over it, or printed as a stress of another row
    elsewhere = {"stiffness", "u", "psi", "ring", "turn", "shear_tz", "shear_rt"}
    assert {n.name for n in nt.all_notation()} - set(placed) == {*notation_table.INSTEAD, *elsewhere}
    assert set(notation_table.INSTEAD.values()) < set(notation_table.IN_PRINT) < set(stated)
