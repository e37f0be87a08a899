"""What the words and tables of the compiled book state in formulas, accounted for one by one."""

from __future__ import annotations

import random
import re
from collections import Counter
from functools import cache

import pytest
from examples import Shown, examples, number
from misprints import misprints, range_misprints
from stored_book import HANDBOOK, KEYS, PRINTED, evidence, stored
from test_misprints import NOT_A_NUMBER

from axiderive.physics.systems import pool_of, problem
from axiderive.readback import front, ranges
from axiderive.readback.claims import ENDS, KINDS, Line, wrong
from axiderive.readback.front import LISTED
from axiderive.readback.source import Inline, further, inline

SOURCES = ("handbook.tex", *(f"profiles/{name}.tex" for name in PRINTED))
FOUND = ("flat_punch", "plane.flat_punch", "gaussian", "gaussian.fgm", "hyperboloid", "capped_cylinder")


@cache
def text_of(path: str) -> str:
    return (HANDBOOK / path).read_text(encoding="utf-8")


@cache
def said() -> tuple[Line, ...]:
    """The statements of the words that are compared, whichever page they stand on."""
    entries = {key: stored(key) for key in FOUND}
    return (
        *front.in_front(stored("materials")),
        *front.in_guide(stored("materials"), stored("paraboloid"), stored("paraboloid.adh")),
        *front.stable_branch(stored("cone.adh")),
        *front.derivations(entries),
        *front.of_profiles(entries),
    )


@cache
def domains() -> tuple[Line, ...]:
    return tuple(ranges.domains())


def _rules(path: str) -> list[Line]:
    if not path.startswith("profiles/"):
        return []
    name = path[9:-4]
    return list(ranges.rules(pool_of(name).load(name.rpartition(".")[2]), name.startswith("plane.")))


def _right(one: Line, tex: str) -> bool:
    try:
        return not one.wrong(tex)
    except NOT_A_NUMBER:
        return False


@cache
def _is_a_domain(tex: str) -> bool:
    return any(_right(one, tex) for one in domains())


def _stated(path: str) -> list[Inline]:
    """The statements of a source outside of its rows: figures and tables of numbers are looked at elsewhere."""
    return [
        one for one in inline(text_of(path)) if one.kind != "symbol" and one.where in ("sentence", "domain", "approach")
    ]


def test_statements_that_are_compared_are_right() -> None:
    for one in said():
        assert not one.wrong(one.tex), one.tex


def test_every_statement_of_a_sentence_is_compared_or_listed() -> None:
    listed = {tex for texts in LISTED.values() for tex in texts}
    by_text = {one.tex for one in said()}
    count, met = Counter[str](), set()
    for path in SOURCES:
        rules = _rules(path)
        # compared with their rows below
        ends = {one.small for one in further(text_of(path)) if one.kind != "limit"}
        for one in _stated(path):
            met.add(one.tex)
            if one.tex in ends:
                count["compared"] += 1
                continue
            if one.tex in listed or one.tex in by_text:
                count["listed" if one.tex in listed else "compared"] += 1
                continue
            meant = any(_right(rule, one.tex) for rule in rules) or _is_a_domain(one.tex)
            assert meant, f"{path}: {one.tex} in {one.line[:80]}"
            count["compared"] += 1
    assert listed | by_text <= met  # nothing is excused that the book does not say
    assert count["compared"] > 200
    assert count["listed"] > 200


def test_domains_are_those_of_their_own_symbols() -> None:
    """In the table of the notation every symbol has the domain of its record, in a panel every parameter its own."""
    rows = [one for one in inline(text_of("handbook.tex")) if one.where == "domain"]
    assert len(rows) > 35
    for one in rows:
        symbol = one.line.rpartition(" of ")[2]
        assert symbol in one.tex, one.line
    for path in SOURCES[1:]:
        own = [one.tex for one in inline(text_of(path)) if one.where == "domain"]
        assert len(set(own)) == len(own), path


def test_a_misprint_of_a_statement_does_not_survive() -> None:
    rng = random.Random("statements")
    count = 0
    for one in (*said(), *domains()[:12], *_rules("profiles/capped_paraboloid.tex"), *_rules("profiles/sphere.tex")):
        printed = _printed_as(one)
        texts = [text for _, text in misprints(printed, rng)][:4] + range_misprints(printed)[:6] if printed else []
        changed = {text for text in texts if text != printed and not re.search(r"\\le|\\ge", text) or "=" in text}
        for text in changed:
            assert not _right(one, text), f"{printed} as {text}"
        count += len(changed)
    assert count > 80


@cache
def _relations() -> frozenset[str]:
    return frozenset(one.tex for path in SOURCES for one in _stated(path) if one.kind == "relation")


def _printed_as(one: Line) -> str:
    """The text of a statement; for those that are found by their meaning the one in print."""
    return one.tex if "\\" in one.tex or one in said() else next((t for t in _relations() if _right(one, t)), "")


def _numbers(name: str) -> list[Shown]:
    return list(examples(name, text_of(f"profiles/{name}.tex")))


@pytest.mark.parametrize("name", [name for name in PRINTED if r"{Worked example}" in text_of(f"profiles/{name}.tex")])
def test_printed_numbers_are_what_the_functions_give(name: str) -> None:
    """Of the function whose key stands behind them, at the numbers that stand before them."""
    found = _numbers(name)
    assert len(found) >= (
        3 if name.startswith("plane.") else 4 if name == "materials" else 6 if name.startswith("loads.") else 10
    )
    for group, title in (("tan", "Partial slip"), ("fgm", "Graded half-space"), ("vis", "Standard solid")):
        shown = sum(one.example == title for one in found)
        assert shown >= 3 if f"{name}.{group}" in KEYS else not shown
    for one in found:
        assert not one.wrong(one.tex), one
        digits = [m.start() for m in re.finditer(r"\d(?!\d*\})", one.tex.partition(r"\times")[0])]
        for at in (digits[0], digits[-1]):
            changed = one.tex[:at] + str(int(one.tex[at]) % 9 + 1) + one.tex[at + 1 :]
            assert changed == one.tex or one.wrong(changed), changed


@pytest.mark.parametrize(
    ("tex", "value"),
    [(r"0.288\,785", "0.288785"), (r"2\times10^{13}\,\text{(SI)}", "2e13"), (r"291.0\,\text{\textmu{}m}", "2.91e-4"),
     (r"-5.758\,\text{\textmu{}N}", "-5.758e-6"), (r"10^{4}\,\text{(SI)}", "1e4"), (r"2.000\,\text{mm}", "2e-3"),
     (r"100.0\,\text{kN/m}", "1e5"), (r"20\,\text{mm}^{-2}", "2e7"), (r"0.500\,\text{m}", "0.5")],
)  # fmt: skip
def test_numbers_are_read_in_the_units_of_the_si(tex: str, value: str) -> None:
    assert abs(number(tex)[0] / float(value) - 1) < 1e-14
    with pytest.raises(AssertionError, match="is not a number"):
        number(tex + "x")


@pytest.mark.parametrize("name", PRINTED)
def test_the_line_on_the_evidence_counts_what_is_stored(name: str) -> None:
    """Every formula that is not proved is a root or an integral, or an elastic constant and left uncounted."""
    records = [
        (stored(key)[suffix].status, record)
        for key in KEYS
        if problem(key).profile_id == name and problem(key).system.physics.printed
        for suffix, record in evidence(key)["entries"].items()
    ]
    open_ones = [status for status, record in records if not record["certified"]]
    agreed = [
        [check["digits"] for check in record["checks"] if check["outcome"] == "passed" and check.get("digits")]
        for _, record in records
    ]
    assert all(agreed)
    roots, integrals = open_ones.count("root"), open_ones.count("integral")
    assert _proved(text_of(f"profiles/{name}.tex")) == (
        len(records) - len(open_ones), len(records), min(min(digits) for digits in agreed), roots, integrals, name
    )  # fmt: skip
    assert roots + integrals == len(open_ones) or name == "materials"


PROVED = re.compile(
    r"\\textcolor\{note\}\{Evidence:\}\\enspace(\d+) of (\d+) formulas? proved; [\w ]+ to at least (\d+) digits"
    r"(?:; (\d+) (?:is the root of an equation|are roots of equations))?(?:; (\d+) (?:is an integral|are integrals))?"
    r"\. All of it: \\href\{html/([\w.]+)\.html\}"
)


def _proved(text: str) -> tuple[int | str, ...]:
    match = PROVED.search(text)
    assert match
    *counts, page = match.groups(default="0")
    return *map(int, counts), page


def test_rows_without_a_key_say_what_their_entries_are() -> None:
    """Universal curves and sums, in the source that TeX sets; limits and approaches are compared on their way."""
    rng = random.Random("further rows")
    count, mutants = Counter[str](), 0
    for path in SOURCES[1:]:
        for one in further(text_of(path)):
            if one.kind in ENDS:
                assert one.small.partition(",")[0] in ENDS[one.kind], f"{path}: {one}"
            if one.kind not in KINDS:
                continue
            assert not wrong(one, stored), f"{path}: {one}"
            count[one.kind] += 1
            texts = [tex for _, tex in misprints(one.tex, rng)][:4]
            for other in [type(one)(one.kind, one.keys, one.small, tex) for tex in texts]:
                assert not _passes(other), other
                mutants += 1
    assert set(count) == set(KINDS)
    assert sum(count.values()) >= 12
    assert mutants >= 20, mutants


def _passes(one: object) -> bool:
    try:
        return not wrong(one, stored)  # type: ignore[arg-type]
    except NOT_A_NUMBER:
        return False
