"""How the catalogue evaluates adhesion, friction, grading and inverses, read back as printed, and as it is coded."""

from __future__ import annotations

import json
import random
import re
from functools import cache
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from misprints import misprints
from stored_book import CATALOGUE, KEYS, stored
from test_misprints import NOT_A_NUMBER

from axicontact import _relaxation
from axicontact._slip import even_gain
from axiderive import notation as nt
from axiderive.contact.medium import GRADED, HOMOGENEOUS
from axiderive.contact.systems import problem
from axiderive.emit.evaluated_adhesive import adhesive_rows, curve_exponents
from axiderive.emit.evaluated_graded import pressure_rows
from axiderive.emit.evaluated_inverses import graded_rows, inverse_rows
from axiderive.emit.evaluated_slip import INNER, OUTER, ring_gain, slip_rows
from axiderive.emit.laws import laws
from axiderive.emit.places import PLACES, UNKNOWN
from axiderive.emit.readback.further import Further, wrong
from axiderive.emit.readback.grammar import read
from axiderive.emit.readback.nodes import environment
from axiderive.emit.readback.printed import holds
from axiderive.emit.transcribed import NAMES, typeset
from axiderive.emit.universal import power_of_depth

Rows = list[dict[str, Any]]


@cache
def rows_of(key: str) -> Rows:
    own = problem(key)
    graded = own.system.name.startswith("graded")
    if own.profile.contact != "compact":
        return []
    if own.system.name == "normal":
        return inverse_rows(own.profile, stored(key))
    if own.system.name == "graded.normal":
        return [*pressure_rows(key, stored(key)), *graded_rows(key, stored(key))]
    make = {"adhesive": adhesive_rows, "tangential": slip_rows}.get(own.system.name.rpartition(".")[2])
    return make(key, stored(key.rpartition(".")[0]), graded) if make else []


def as_read(row: dict[str, Any], tex: str = "", profile: str = "") -> Further:
    kind, *keys = row["comment"].split()
    named = tuple(f"{profile}.{key}" if profile else key for key in keys)
    return Further(kind, named, row["small"].strip("$"), tex or row["tex"])


def passes(one: Further) -> bool:
    try:
        return not wrong(one, stored)
    except NOT_A_NUMBER:
        return False


QUICK = (
    "cone.tan", "quartic.tan", "power_law.adh", "power_law.fgm.adh", "power_law.fgm.tan", "sphere", "sphere.adh",
    "truncated_paraboloid", "rounded_punch.adh", "gaussian.fgm", "truncated_cone.fgm", "sphere.fgm", "polynomial.fgm",
)  # fmt: skip
"""Rows of every kind, none of which takes a second."""
ALL = tuple(key for key in KEYS if not key.startswith(("plane.", "loads.", "materials")))


def survivors(key: str, most: int, rng: random.Random) -> tuple[int, list[str]]:
    """How many misprints of the rows of a problem were tried, and those that pass."""
    count, found = 0, []
    for row in rows_of(key):
        texts = list(dict.fromkeys(tex for _, tex in misprints(row["tex"], rng)))[:most]
        count += len(texts)
        found += [tex for tex in texts if passes(as_read(row, tex))]
    return count, found


@pytest.mark.parametrize("key", QUICK)
def test_rows_say_what_their_entries_are(key: str) -> None:
    costly = (".adh.p", ".tan.tau")
    for row in rows_of(key):
        if r"\int" not in row["tex"] and not (key != "cone.tan" and row["comment"].split()[1].endswith(costly)):
            assert not wrong(as_read(row), stored), row["comment"]


def test_misprints_do_not_survive() -> None:
    rng = random.Random("evaluation of physics")
    counts = []
    for key in ("cone.tan", "power_law.adh", "sphere", "truncated_paraboloid", "sphere.fgm", "gaussian.fgm"):
        for row in rows_of(key):
            if ".adh.p" in row["comment"]:
                continue
            texts = list(dict.fromkeys(tex for _, tex in misprints(row["tex"], rng)))[:6]
            assert [tex for tex in texts if passes(as_read(row, tex))] == []
            counts.append(len(texts))
    assert sum(counts) > 30


SAMPLED = (
    "power_law.tan", "polynomial.tan", "truncated_cone.tan", "cone.fgm", "cone.fgm.tan", "paraboloid.fgm.adh",
    "polynomial", "hyperboloid", "rounded_punch", "capped_paraboloid", "truncated_cone.adh", "capped_paraboloid.adh",
)  # fmt: skip
"""Problems that are read back in every run of the long tests, the others in a sweep."""


def _spread(keys: list[str]) -> list[Any]:
    return [pytest.param(key, marks=pytest.mark.slow if key in SAMPLED else pytest.mark.sweep) for key in keys]


@pytest.mark.parametrize("key", _spread([key for key in ALL if ".fgm" in key or key.endswith(".tan")]))
def test_every_row_of_friction_and_grading_is_read_back(key: str) -> None:
    for row in rows_of(key):
        assert not wrong(as_read(row), stored), row["comment"]


@pytest.mark.parametrize(
    "key", _spread([key for key in ALL if "." not in key or key.endswith(".adh") and ".fgm" not in key])
)
def test_every_row_of_inverses_and_adhesion_is_read_back(key: str) -> None:
    for row in rows_of(key):
        assert not wrong(as_read(row), stored), row["comment"]


@pytest.mark.slow
@pytest.mark.parametrize("key", ["cone.tan", "quartic.tan", "power_law.fgm.tan", "quartic.fgm.adh", "ellipsoid.adh"])
def test_no_misprint_of_a_spread_survives(key: str) -> None:
    count, found = survivors(key, 8, random.Random(key))
    assert count >= 8
    assert found == []


def test_the_share_from_which_growth_is_integrated_is_that_of_the_module() -> None:
    row = next(row for row in rows_of("hyperboloid.tan") if row["comment"].endswith(".u"))
    assert not wrong(as_read(row), stored)
    for other in (r"5 g(c)\ge g(a)", r"4 g(a)\ge g(c)", r"3 g(c)\ge g(a)"):
        assert not passes(Further("evaluation", ("hyperboloid.tan.u",), other, row["tex"]))


@cache
def source(key: str) -> str:
    return (CATALOGUE / problem(key).module).read_text(encoding="utf-8")


POWER_LAWS = ("cone", "paraboloid", "quartic", "sextic", "power_law")


def test_the_modules_of_power_laws_solve_the_printed_curve() -> None:
    for name in (f"{name}{graded}" for name in POWER_LAWS for graded in ("", ".fgm")):
        key, order = f"{name}.adh", power_of_depth(stored(name)["d"])
        assert order is not None
        medium = GRADED if name.endswith("fgm") else HOMOGENEOUS
        for load in ("F", "d"):
            p, q = curve_exponents(load, order, medium)
            calls = re.findall(rf"power_law_radius\({load}, a_c, least, (.*), (.*), plain\)", source(key))
            (found,) = calls
            assert [sp.nsimplify(sp.sympify(text), rational=True) - own.subs(nt.n, sp.Symbol("n")).subs(
                nt.k, sp.Symbol("k")) for text, own in zip(found, (p, q), strict=True)] == [0, 0]  # fmt: skip


CALLED = {
    "cone.tan": "arc_gain(r, c, a)", "paraboloid.tan": "root_gain(r, c, a)", "quartic.tan": "even_gain(r, c, a, 4)",
    "sextic.tan": "even_gain(r, c, a, 6)", "power_law.tan": "power_gain(r, c, a, n)",
    "polynomial.tan": "power_gain(r, c, a, j)", "sphere.tan": "growth_below(", "truncated_cone.tan": "growth_beyond(",
    "cone.fgm": "power_pressure(inside, a, 1.0, k)", "power_law.fgm": "power_pressure(inside, a, n, k)",
    "cone.fgm.tan": 'power_gain("force", 0.0, c, a, 1.0, k)', "sphere.adh": "tension(r, a, E_star, dgamma)",
    "rounded_punch.adh": "radius = stable_radius(",
}  # fmt: skip
"""What the generated module calls for the forms in print."""


@pytest.mark.parametrize("key", CALLED)
def test_the_catalogue_evaluates_what_is_printed(key: str) -> None:
    assert rows_of(key)
    assert CALLED[key] in source(key)


def test_the_unknown_of_an_inverse_is_that_of_the_module() -> None:
    for key in ALL:
        if problem(key).system.name != "normal" or key == "sphere_tipped_cone":  # its slopes take seconds
            continue
        text = source(key)
        solved = {key for row in rows_of(key) if row["comment"].startswith("solved") for key in row["comment"].split()}
        assert bool(re.search(r" inverse(_\w+)?\(", text)) == bool(solved)
        corrected = any(row["comment"].startswith("corrected") for row in rows_of(key))
        assert ("change = np.where((a > 0.0)" in text) == corrected
    t, length = sp.Symbol("t"), sp.Rational(3)
    for place in PLACES.values():
        own = [expr.subs(UNKNOWN, t).subs(t, 0.7) for expr in place.expressions(length)]
        coded = [sp.sympify(part.format("3").replace("np.", "")).subs(t, 0.7) for part in place.code.split(", ")]
        assert all(abs(float(a - b)) < 1e-12 for a, b in zip(own, coded, strict=True))


def test_the_ring_of_an_even_power_is_that_of_the_module() -> None:
    r, c, a = 0.3, 0.7, 1.1
    y, z = np.sqrt(a * a - r * r), np.sqrt(c * c - r * r)
    for n in (2, 4, 6, 8):
        value = ring_gain(sp.Integer(n))
        assert value is not None
        symbols = {nt.r: r, nt.c: c, nt.a: a, OUTER: y, INNER: z, sp.Symbol("gain", positive=True): y - z}
        assert abs(float(value.subs(symbols)) / float(even_gain(r, c, a, n)) - 1) < 1e-13


def test_what_is_set_of_the_chapter_is_what_was_transcribed() -> None:
    """Every text goes back to its transcription, blanks, brackets and braces apart."""
    record = json.loads((CATALOGUE / "evidence" / "chapter11.json").read_bytes())
    texts = [row["title"] for row in record["rows"]] + [step["claim"] for step in record["steps"]]
    texts += [text for erratum in record["errata"] for text in erratum.values()]
    for text in texts:
        assert _bare(_untyped(typeset(text))) == _bare(text)
    assert sum(r"\(" in typeset(text) for text in texts) > 80
    assert typeset("a radius r <= a, a^2") == r"a radius \(r \le a\), \(a^{2}\)"


def _untyped(tex: str) -> str:
    tex = tex.replace(r"\sqrt", "sqrt").replace(r"\int", "int").replace(r"\pm", "+-").replace(r"\,", "", 0)
    tex = tex.replace(r"\lvert ", "abs(").replace(r"\rvert", ")").replace("--", "-")
    for name, printed in sorted(NAMES.items(), key=lambda item: -len(item[1])):
        tex = tex.replace(printed, name)
    return tex.replace(r"\,", "").replace(r"\(", "").replace(r"\)", "")


def _bare(text: str) -> str:
    return re.sub(r"[\s(){}]", "", text)


def test_a_ramp_is_summed_as_printed_up_to_the_age_of_the_module() -> None:
    rows = [row for law in laws() for row in law.evaluated]
    assert [row["comment"][-3:] for row in rows] == ["_mx", "_mx", "sls", "sls"]
    for i, row in enumerate(rows):
        sides = [{"t": mp.mpf(3) * _relaxation.SWITCH * (1 + side), "tau": mp.mpf(3)} for side in (-1e-9, 1e-9)]
        for text, right in ((row["small"], True), (row["small"].replace("40", "41"), False)):
            assert ([holds(text.strip("$"), env) for env in sides] == [i % 2 == 0, i % 2 == 1]) is right
        (first, *definitions), age = read(row["tex"]), 41 if i % 2 else 39
        env = {"t": mp.mpf(age), "tau": mp.mpf(1), "m": mp.mpf("1.5"), "E": mp.mpf(2), "E_infty": 2, "E_1": mp.mpf(5)}
        own = first.members[-1](environment(definitions, env))
        at = np.array([float(age)]), np.array([1.5])
        found = (
            _relaxation.ramp_maxwell(*at, 2.0, 1.0) if i < 2 else _relaxation.ramp_standard_solid(*at, 2.0, 5.0, 1.0)
        )
        assert float(own) == pytest.approx(found[0], rel=1e-14, abs=0.0)
