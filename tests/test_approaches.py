"""What is printed of a quantity on its way to a limit is what its entry does next to it."""

from __future__ import annotations

import dataclasses
import re
from functools import cache
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from stored_book import KEYS, evidence, stored

from axiderive import notation as nt
from axiderive.entry import Case, Entry
from axiderive.oracle.evaluate import case_at, evaluate, evaluated
from axiderive.physics.systems import problem
from axiderive.readback.claims import Claim, Printed, name_in_print, named
from axiderive.rows import approaches
from axiderive.rows.approaches import DIGITS, GAP, Approach, Rows

READ_BACK = mp.mpf(10) ** -20
NAMES = [key for key in KEYS if problem(key).system.name in ("normal", "plane", "loads")]
EXPECTED = {"normal": 132, "plane": 52, "loads": 7}
"""Quantities whose approach is printed, by system."""


@cache
def printed(key: str) -> list[tuple[Approach, str, str]]:
    """The approaches of a profile with their LaTeX and the label of their row."""
    kept: list[tuple[Approach, str, str]] = []
    plain = approaches.approach_row

    def noted(label: str, small: str, parts: list[Approach], **options: Any) -> Rows:
        rows = plain(label, small, parts, **options)
        for row in rows:
            for tex in row.tex.split(GAP):
                (part,) = [p for p in parts if tex.startswith(rf"{p.left}\to ")]
                kept.append((part, tex, label))
        return rows

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(approaches, "approach_row", noted)
        profile, entries = problem(key).profile, stored(key)
        rows = [*approaches.approach_rows(profile, entries), *approaches.reduction_rows(profile, entries)]
        if problem(key).system.name == "normal":
            rows += approaches.limit_rows(profile, entries, evidence(key))
    shown = [tex for row in rows for tex in row.tex.split(GAP)]
    return [one for one in kept if one[1] in shown]


def _names(key: str, values: dict[Any, Any]) -> dict[str, Any]:
    """Symbols, and the quantities that a formula takes from other rows."""
    entries = stored(key)
    env = {**named(values), **Printed(entries, entries).environment(values)}
    for suffix, name in (("F", "F_N"), ("P", "P")):
        if suffix in entries:
            env[name] = _at(entries[suffix], values)
            env[f"{name}'()"] = lambda radius, s=suffix: mp.diff(lambda x: _at(entries[s], {**values, nt.a: x}), radius)
    if "d" in entries and len(entries["d"].cases) == 1:  # for the integral over g'(t)/t
        slope = sp.diff(entries["d"].cases[0].expr, nt.a)
        env["g'()"] = lambda radius: evaluated(slope, {**values, nt.a: radius})
    return env


def _at(entry: Entry, values: dict[Any, Any]) -> Any:
    return evaluate(case_at(entry, values).expr, values, DIGITS)


def _farthest(key: str, part: Approach, tex: str) -> Any:
    """Largest relative difference between the formula as printed and the entry next to the end of the way."""
    found = []
    with mp.workdps(2 * DIGITS):
        for values in part.points():
            own = next((case for case in part.entry.cases if approaches.holds(case, values)), None)
            if own is None or not any(approaches.holds(case, values) for case in part.cases):
                continue
            wanted = part.value(own, values)
            # a limit is a formula of the simpler profile, which does not know what moves
            gone = {name_in_print(symbol) for symbol, _ in part.way if symbol in part.entry.profile.parameters}
            env = {name: value for name, value in _names(key, values).items() if name not in gone}
            found.append(Claim(env, wanted).residual(tex.partition(r"\to ")[2]))
    return max(found)


QUICK = ("cone", "sphere", "truncated_cone", "concave_quartic", "plane.rounded_punch", "loads.hertzian")


@pytest.mark.parametrize("key", [k if k in QUICK else pytest.param(k, marks=pytest.mark.slow) for k in NAMES])
def test_a_printed_approach_is_what_the_entry_tends_to(key: str) -> None:
    for part, tex, _ in printed(key):
        assert _farthest(key, part, tex) < READ_BACK, tex


@pytest.mark.slow
def test_every_profile_has_its_approaches() -> None:
    counts = dict.fromkeys(EXPECTED, 0)
    for key in NAMES:
        found = printed(key)
        counts[problem(key).system.name] += len(found)
        labels = {label for *_, label in found}
        if nt.e not in problem(key).profile.parameters:
            assert {"Far field"} <= labels, key
            assert problem(key).system.name == "loads" or "Edge" in labels, key
    assert counts == EXPECTED


@pytest.mark.parametrize("key", ["cone", "concave_quartic", "plane.wedge", "loads.hertzian"])
def test_no_changed_digit_or_sign_of_an_approach_passes(key: str) -> None:
    mutants = 0
    for part, tex, _ in printed(key):
        start = tex.index(r"\to ")
        for match in re.finditer(r"(\d)|(?<![=&(])([+-])", tex[start:]):
            other = str(int(match[1]) % 9 + 1) if match[1] else "-" if match[2] == "+" else "+"
            wrong = tex[: start + match.start()] + other + tex[start + match.end() :]
            try:
                assert _farthest(key, part, wrong) > READ_BACK, wrong
            except (SyntaxError, ValueError, LookupError, TypeError):
                continue
            mutants += 1
    assert mutants >= 3


@pytest.mark.slow
def test_a_wrong_factor_does_not_hold() -> None:
    """Neither a wrong number nor a formula that is right to fifteen digits only is printed."""
    for key in ("sphere", "rounded_punch"):
        for part, *_ in printed(key):
            for factor in (sp.Rational(1, 2), 1 + sp.Rational(1, 10**15)):
                wrong = tuple(Case(case.chain, case.expr * factor) for case in part.cases)
                off = dataclasses.replace(part, cases=wrong, recorded=False)
                assert dataclasses.replace(part, recorded=False).holds
                assert not off.holds
                assert approaches.approach_row("Wrong", "r", [off]) == []
