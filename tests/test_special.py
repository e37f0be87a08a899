"""Special cases in the entry of their host: the cells of the tables, and the profiles that are sums of others."""

from __future__ import annotations

import contextlib
import itertools
import random
import re
from collections.abc import Iterator
from typing import Any

import mpmath as mp
import pytest
import sympy as sp
from misprints import misprints
from stored_book import HANDBOOK, stored
from test_misprints import NOT_A_NUMBER

from axiderive import notation as nt
from axiderive.oracle.evaluate import case_at, evaluate
from axiderive.readback.claims import Claim, named, wrong
from axiderive.readback.source import Further, formulas
from axiderive.rows.claims import points_of
from axiderive.rows.special import COLUMNS, HOSTS, MEMBERS, SUMS, TIPS, elsewhere, hosted, sum_rows, tip_rows, told

READ_BACK = mp.mpf(10) ** -20
DIGITS = 40
UNITS = {nt.a: sp.S.One, nt.A: sp.S.One, nt.h: sp.S.One, nt.E_star: sp.S.One, nt.theta: sp.pi / 4, nt.R: sp.S.Half}
"""A point at which the profiles are r^n or -r^n: A = tan(theta) = 1/(2 R) = 1."""
PLACES = {"p": sp.Rational(3, 8), "w": sp.Rational(19, 12), "s": sp.Rational(19, 12)}
_HEAD = re.compile(r"^%% special (\S+) (\d+) (.*)$", re.M)


def cells(host: str) -> Iterator[tuple[int, str, str]]:
    """Power, quantity and formula of every cell, from the source that TeX sets."""
    text = (HANDBOOK / "profiles" / f"{host}.tex").read_text(encoding="utf-8")
    found = iter([one for one in formulas(text) if one.kind == "special"])
    for _, power, suffixes in _HEAD.findall(text):
        for suffix in suffixes.split():
            cell = next(found)
            assert cell.suffix == power
            yield int(power), suffix, cell.tex
    assert next(found, None) is None


def residual(host: str, power: int, suffix: str, tex: str) -> Any:
    """How far a cell is from the entry of its profile, or of the host, where lengths and moduli are one."""
    entry = stored(MEMBERS[host][power] or host)[suffix]
    values = {**UNITS, nt.n: sp.Integer(power), nt.d: sp.Rational(11, 4), nt.F: sp.Rational(5, 7)}
    values |= {nt.P: sp.Rational(7, 5), nt.L: sp.Rational(8, 3), nt.r: PLACES.get(suffix, sp.S.Half)}
    values |= {nt.x: PLACES.get(suffix, sp.S.Half)}
    with mp.workdps(2 * DIGITS):
        want = evaluate(case_at(entry, values).expr, values, DIGITS)
        return Claim({**named(values), "F_N": mp.mpf(5) / 7}, want).residual(tex)


@pytest.mark.parametrize("host", MEMBERS)
def test_the_tables_of_special_cases_say_what_the_entries_are(host: str) -> None:
    """Those of n = 3 against the power law itself, whose incomplete Beta functions are elementary there."""
    wanted = [(n, suffix) for suffixes in COLUMNS[host] for n in told(host) for suffix in suffixes]
    found = list(cells(host))
    assert [(power, suffix) for power, suffix, _ in found] == wanted
    rng, mutants = random.Random(host), 0
    for power, suffix, tex in found:
        assert residual(host, power, suffix, tex) < READ_BACK, tex
        for _, changed in itertools.islice(misprints(tex, rng), 3):
            with contextlib.suppress(*NOT_A_NUMBER):
                assert residual(host, power, suffix, changed) > READ_BACK, f"{tex} as {changed}"
            mutants += 1
    assert mutants > 2 * len(found)


@pytest.mark.parametrize("host", MEMBERS)
def test_a_power_is_told_in_the_table_or_has_a_page_of_its_own(host: str) -> None:
    text = (HANDBOOK / "profiles" / f"{host}.tex").read_text(encoding="utf-8")
    (heading,) = [line for line in text.splitlines() if line.startswith(r"\sect") and line.endswith("{Special cases}")]
    referred = dict(re.findall(r"\$n=(\d+)\$: \\hyperref\[sec:([\w.]+)\]", heading))
    assert referred == {str(one["power"]): one["name"] for one in elsewhere(host)}
    assert all((HANDBOOK / "profiles" / f"{name}.tex").exists() for name in referred.values())
    assert {*told(host), *map(int, referred)} == set(MEMBERS[host])


def test_special_cases_have_no_entry_but_anchors() -> None:
    for name, host in HOSTS.items():
        assert not (HANDBOOK / "profiles" / f"{name}.tex").exists()
        assert name in hosted(host)
        text = (HANDBOOK / "profiles" / f"{host}.tex").read_text(encoding="utf-8")
        part = text[text.index(rf"\label{{sec:{name}}}") :]
        anchors = set(re.findall(r"\\tolab\{([\w.]+)\}", part) + re.findall(r"\{([\w.]+)\}\}?$", part, re.M))
        anchors |= set(re.findall(r"\{([\w.]+)\}\}\{[\[{]", part))
        assert set(stored(name)) <= anchors


def _row(name: str, **changed: str) -> Further:
    (one,) = sum_rows(name)
    return Further(one.kind, one.keys, one.small, changed.get("tex", one.tex))


@pytest.mark.parametrize("name", SUMS)
@pytest.mark.parametrize("count", [1, pytest.param(3, marks=pytest.mark.slow)])
def test_the_parts_of_a_sum_add_to_its_entries(name: str, count: int) -> None:
    """At points of every case to forty digits, from the data; and the row in print says the same."""
    entries = stored(name)
    for suffix in ("d", "F", "p", "w"):
        for case, values in points_of(entries[suffix], "formula", entries, count, 5):
            total = mp.mpf(0)
            with mp.workdps(2 * DIGITS):
                for part in SUMS[name]:
                    at = {**values, **{s: e.xreplace(values) for s, e in part.parameters.items()}}
                    own = stored(part.name)[suffix]
                    if not own.profile.truncated or values[nt.a] > values[nt.b]:
                        total += part.sign * evaluate(case_at(own, at).expr, at, 2 * DIGITS)
                want = evaluate(case.expr, values, 2 * DIGITS)
                assert abs(total - want) < mp.mpf(10) ** -DIGITS * abs(want), (suffix, case.chain)
    assert not wrong(_row(name), stored)


@pytest.mark.parametrize("name", SUMS)
def test_no_misprint_of_a_sum_passes(name: str) -> None:
    tex = _row(name).tex
    others = [tex.replace("plus ", "minus "), tex.replace("minus ", "plus "), tex.replace("paraboloid", "quartic")]
    others += [tex.replace("R=", "b="), tex.replace("R_1", "R_2"), tex.replace(r"\tan", r"\sin")]
    others += [tex.replace("=", "=2 "), tex.replace(", with }", ", with }2 ")]
    tried = [text for text in others if text != tex]
    assert len(tried) >= 5
    for text in tried:
        try:
            assert wrong(_row(name, tex=text), stored), text
        except NOT_A_NUMBER:
            continue


def _tip(name: str, **changed: str) -> Further:
    (one,) = tip_rows(name)
    return Further(one.kind, one.keys, changed.get("small", one.small.strip("$")), changed.get("tex", one.tex))


@pytest.mark.parametrize("name", TIPS)
def test_a_contact_on_the_tip_is_that_of_the_profile_that_is_named(name: str) -> None:
    """The book says nothing else of it, so that every formula with such a range must be among the keys."""
    assert {key.rpartition(".")[2] for key in _tip(name).keys} == {
        suffix for suffix, entry in stored(name).items() if entry.status == "closed" and len(entry.cases) > 1
    }
    assert not wrong(_tip(name), stored)
    assert wrong(_tip(name, small="b<a"), stored)
    tex = _tip(name).tex
    for other in (tex.replace("parabola", "quartic"), tex.replace("R=", "R=2 "), tex.replace(r"\tan", r"\sin")):
        assert other != tex
        with contextlib.suppress(*NOT_A_NUMBER):
            assert wrong(_tip(name, tex=other), stored)


@pytest.mark.parametrize("name", TIPS)
def test_what_holds_on_the_tip_is_not_printed_again(name: str) -> None:
    text = (HANDBOOK / "profiles" / f"{name}.tex").read_text(encoding="utf-8")
    ranges = [line for line in text.splitlines() if line.startswith((r"\frow", r"\further")) and "a< b" in line]
    assert ranges == []
    assert text.count("%% sum ") == 1
