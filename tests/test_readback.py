"""What is printed is what was checked: every formula of the compiled handbook, read back from its LaTeX."""

from __future__ import annotations

import itertools
from collections import Counter

import mpmath as mp
import pytest
from stored_book import (
    HANDBOOK,
    KEYS,
    PRINTED,
    PROFILES,
    front_readings,
    panel_readings,
    printed,
    readings_below,
    residual,
    rows,
    stored,
)

from axiderive.book import front
from axiderive.book.handbook import behind
from axiderive.book.page import derivation
from axiderive.physics.systems import problem
from axiderive.profiles import load
from axiderive.readback import fields
from axiderive.readback.claims import WORKING
from axiderive.readback.source import Formula, arguments, formulas, without_remark
from axiderive.rows.special import hosted

READ_BACK = mp.mpf(10) ** -20
"""A printed row agrees with its entry to twenty digits or it does not agree."""
SAMPLE = ("rounded_punch", "truncated_cone.adh", "polynomial.tan", "power_law.fgm.tan", "sphere.vis")
"""Problems of many regions, and of rows that need more than one formula; all run with their spreads."""
SPREADS = (
    "cone",
    "concave_quartic",
    "flat_punch",
    "plane.rounded_wedge",
    "plane.eccentric_punch",
    "loads.power",
    "materials",
)
"""Profiles without long integrals, of every kind of contact."""


@pytest.mark.parametrize("key", SAMPLE)
def test_rows_say_what_their_entries_are(key: str) -> None:
    for one in rows(key):
        assert residual(key, one) < READ_BACK, one.key


LONG = ("definition: Pressure", "any profile", "rule: coh.c")
"""Integrals of integrals, which take half of the time of all."""


@pytest.mark.parametrize("long", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_the_front_of_the_book_says_what_the_engine_computes(long: bool) -> None:
    """Definitions, special functions, material laws and the table of profiles."""
    chosen = [reading for reading in front_readings() if (reading.place in LONG) is long]
    assert len(chosen) >= (2 if long else 160)
    for reading in chosen:
        assert not reading.wrong(reading.tex), reading.place


@pytest.mark.slow
def test_numbers_below_the_surface_are_those_of_their_entries() -> None:
    assert len(readings_below()) >= 38
    for reading in readings_below():
        assert not reading.wrong(reading.tex), reading.place


def test_some_numbers_below_the_surface_are_those_of_their_entries() -> None:
    """The letters, the slopes whose formulas are short, and the profiles that are made of one of these."""
    with mp.workdps(WORKING):
        letters_and_slopes = itertools.islice(fields._rows(stored), 11)
        readings = [*letters_and_slopes, *itertools.islice(fields.sums(stored), 2)]
    assert {"Logarithm", "slope 2: D_{0}", "paraboloid"} <= {reading.place for reading in readings}
    for reading in readings:
        assert not reading.wrong(reading.tex), reading.place


@pytest.mark.parametrize("name", PROFILES)
def test_panels_say_what_the_profiles_are(name: str) -> None:
    for reading in panel_readings(name):
        assert not reading.wrong(reading.tex), f"{reading.place}: {reading.tex}"


@pytest.mark.parametrize("name", [name for name in PROFILES if "." not in name])
def test_the_derivation_names_the_slope_of_every_piece(name: str) -> None:
    """It left out the slope of the tip, and with it half of what is integrated."""
    profile = load(name) if name != "materials" else None
    if profile and profile.contact == "compact":
        slopes = [reading for reading in panel_readings(name) if reading.place == f"{name}: f'"]
        assert len(slopes) == len(profile.pieces)
        assert all(f"${reading.tex}$" in derivation(name, profile, stored(name)) for reading in slopes)


def _compiled(path: str) -> list[Formula]:
    return formulas((HANDBOOK / path).read_text(encoding="utf-8"))


def _printed(name: str, kind: str) -> list[str]:
    return sorted(found.tex for found in _compiled(f"profiles/{name}.tex") if found.kind == kind)


@pytest.mark.parametrize(
    "name", [name if name in SPREADS else pytest.param(name, marks=pytest.mark.slow) for name in PRINTED]
)
def test_every_row_of_a_spread_says_what_its_entry_is(name: str) -> None:
    """The rows TeX sets and the rows that are compared are the same, letter by letter, and none is left over."""
    compared = []
    for key in (key for key in KEYS if problem(key).profile_id in (name, *hosted(name))):
        if any(entry.status == "equation" for entry in stored(key).values()):
            continue  # for what stands in a whole contact: it has no value at a point, and no row on the page
        for one in rows(key):
            assert residual(key, one) < READ_BACK, one.key
        if problem(key).system.physics.printed and problem(key).profile_id == name:
            compared += [region.tex for one in printed(key) if not one.listed for region in one.regions]
        for one in (one for one in printed(key) if one.parts):
            assert residual(key, one) < READ_BACK, one.key
    assert _printed(name, "row") == sorted(compared)
    panel = [reading.tex for reading in panel_readings(name)]
    assert set(_printed(name, "panel") + _printed(name, "slope")) <= {*panel, *_kappa(name)}


def _kappa(name: str) -> set[str]:
    """The definition of kappa, which the rows are read back with."""
    return {tex for tex in _printed(name, "panel") if tex.startswith(r"\kappa")}


BELOW = r"\parthead{Stress below the contact}", r"\sect{Where it yields}"


@pytest.mark.parametrize("below", [False, pytest.param(True, marks=pytest.mark.slow)])
def test_every_formula_in_front_was_read_back(below: bool) -> None:
    before, rest = (HANDBOOK / "handbook.tex").read_text(encoding="utf-8").split(BELOW[0])
    part, after = rest.split(BELOW[1])
    found = formulas(part if below else before + after)
    compared = {reading.tex for reading in (*front_readings(), *(readings_below() if below else ()))}
    compared |= {f"{one['name']}={one['definition']}" for one in front.master_rows()}
    assert {one.tex for one in found} <= compared
    assert below or [one.suffix for one in found if one.suffix] == [one.key for one in front.rule_rows()]


def test_the_source_is_searched_to_its_end() -> None:
    """As many rows are found as TeX is told to set: a row the search overlooks would not be compared."""
    count: Counter[str] = Counter()
    told = 0
    for path in sorted(HANDBOOK.rglob("*.tex")):
        if path.name == "preamble.tex":
            continue
        text = path.read_text(encoding="utf-8")
        count.update(one.kind for one in formulas(text))
        told += text.count("\n\\frow") + 2 * text.count("\n\\fpair")
        displayed = text.count(r"\displaystyle")
        shown = [one for one in formulas(text) if one.kind in ("definition", "function", "cell", "special")]
        panels = sum(
            line.count(r"\displaystyle") for line in text.splitlines() if line[:6] in (" Profi", " Short", " Press")
        )
        assert displayed == len(shown) + panels, path
    assert count["row"] == told > 300
    assert count["definition"] == len(front.definition_rows())
    assert count["function"] == len(front.master_rows())


def test_arguments_of_a_row() -> None:
    tex = r"[p, q]{Force}{$a<b$}{\frac{1}{2}\{x\}\remark{with $a$ from \own{ad}}}{}"
    assert arguments(tex) == ["Force", "$a<b$", r"\frac{1}{2}\{x\}\remark{with $a$ from \own{ad}}", ""]
    assert without_remark(arguments(tex)[2]) == r"\frac{1}{2}\{x\}"


@pytest.mark.parametrize("words", ["", "at small $s$", "words that fill a line of their own " * 4])
@pytest.mark.parametrize("tex", ["a=b", r"\begin{aligned}[t]&a=b,\\[1.5mm]&\qquad c=d\end{aligned}"])
def test_words_stand_behind_the_last_line_and_are_taken_off_again(tex: str, words: str) -> None:
    shown = behind(tex, words)
    assert without_remark(shown) == tex
    *_, last = shown.removesuffix(r"\end{aligned}").split(r"\\[1.5mm]&")
    assert last.endswith(f"\\remark{{{words}}}" if words else ("c=d", "a=b"))
    assert last.startswith(r"\remark") == (len(words) > 60)


HAND_SET = 0.15
"""Largest share of display strings that were not composed by the printer."""


@pytest.mark.slow
def test_few_display_strings_are_set_by_hand() -> None:
    """Rules, equations to solve, compositions and special functions, all counted although the printer sets many.

    Each is read back above against the result that it stands for.
    """
    texts = [(one.kind, region.tex) for key in KEYS for one in rows(key) for region in one.regions]
    printed = {tex for kind, tex in texts if kind == "formula"}
    by_hand = {tex for kind, tex in texts if kind != "formula"} | {one["definition"] for one in front.master_rows()}
    assert 0 < len(by_hand) / len(printed | by_hand) < HAND_SET
