"""Plane contact: certificates, defining integrals, the singular integral equation, limits, borders and units."""

from dataclasses import replace
from functools import cache

import mpmath as mp
import pytest
import sympy as sp
from selected import drawn, few
from stored_book import suffixes

from axiderive import notation as nt
from axiderive.checks import strips, units
from axiderive.checks.comparison import Comparison
from axiderive.entry import Case
from axiderive.oracle.evaluate import case_at, evaluate, evaluated
from axiderive.oracle.sampling import points
from axiderive.physics.plane import PHYSICS, derive
from axiderive.profiles import plane as profiles
from axiderive.proof import certificate as proof

COMPACT = {"load", "pressure", "slope", "depth", "half_width_from_load"}
COMPLETE = {"pressure", "slope"}
CONCAVE = COMPLETE | {"minimum_load"}
ECCENTRIC = {"pressure", "tilt", "contact_width"}
Q = sp.Rational


@pytest.fixture(autouse=True)
def _precision():
    with mp.workdps(100):
        yield


@cache
def entries(name):
    return derive(profiles.load(name))


def all_keys():
    # what a derivation gives is not asked for while tests are collected, by every worker; `test_interface` compares
    return [(name, suffix) for name in profiles.NAMES for suffix in suffixes(f"plane.{name}")]


def value(name, suffix, values, digits=30):
    return evaluate(case_at(entries(name)[suffix], values).expr, values, digits)


@pytest.mark.parametrize("name", profiles.NAMES)
def test_interface(name):
    assert set(entries(name)) == set(suffixes(f"plane.{name}"))
    functions = {entry.quantity.function for entry in entries(name).values()}
    if name in profiles.COMPACT_NAMES:
        assert functions == COMPACT
    elif name == "eccentric_punch":
        assert functions == ECCENTRIC
    else:
        assert functions >= (CONCAVE if name.startswith("concave") else COMPLETE)


@pytest.mark.parametrize("name", drawn(profiles.NAMES, 4))
def test_every_formula_is_certified(name):
    certificates = proof.certify_profile(profiles.load(name), entries(name))
    assert {key: c.reason for key, c in certificates.items() if not c.proved} == {}


SECONDS = ("concave_power", "concave_quartic", "rounded_wedge")
"""Of which every corrupted formula takes seconds: other concave faces and breaks stand for them in a plain run."""


def mutants(expr):
    """Wrong sign, factor and exponent, and a length taken for its double in one place."""
    if isinstance(expr, sp.Eq):
        return [sp.Eq(2 * expr.lhs, expr.rhs, evaluate=False)]
    out = [2 * expr, -expr, expr * nt.a, expr**2] if expr != 0 else [expr + nt.a]
    roots = sorted((p for p in expr.atoms(sp.Pow) if p.exp == sp.S.Half), key=str)
    out += [expr.subs(roots[0], 1 / roots[0])] if roots else []
    functions = sorted((f for f in expr.atoms(sp.Function) if f.args[0].has(nt.a)), key=str)
    return out + ([expr.subs(functions[0], functions[0].subs(nt.a, 2 * nt.a))] if functions else [])


@pytest.mark.parametrize("name", few(profiles.NAMES, [n for n in profiles.NAMES if n not in SECONDS], pytest.mark.slow))
def test_no_corrupted_formula_is_certified(name):
    profile, found, tried = profiles.load(name), entries(name), 0
    for suffix, entry in found.items():
        for i, case in enumerate(entry.cases):
            for wrong in mutants(case.expr):
                cases = (*entry.cases[:i], Case(case.chain, wrong), *entry.cases[i + 1 :])
                certificate = proof.certify(profile, {**found, suffix: replace(entry, cases=cases)}, suffix)
                assert not certificate.proved, f"{entry.key}: {wrong} was certified"
                tried += 1
    assert tried >= 4 * len(found) - 3


INTEGRALS = [k for k in all_keys() if k[0] != "eccentric_punch"]


@pytest.mark.parametrize(
    ("name", "suffix"), few(INTEGRALS, [k for k in INTEGRALS if k[0] == "wedge" or k == ("rounded_punch", "P")])
)
def test_defining_integral(name, suffix):
    evidence = strips.check(
        Comparison(profiles.load(name), entries(name), PHYSICS, digits=46, points=5, seed=3), suffix
    )
    assert evidence.passed, evidence
    assert evidence.required >= 36


@pytest.mark.parametrize("name", few(profiles.NAMES, ["wedge", "parabola"]))
def test_pressure_closes_the_integral_equation(name):
    for evidence in strips.closure(
        Comparison(profiles.load(name), entries(name), PHYSICS, digits=26, points=2, seed=5)
    ):
        assert evidence.passed, evidence


REACHED = {nt.theta: sp.atan(nt.A), nt.R: 1 / (2 * nt.A)}
"""Parameters of the wedge and of the parabola that a power law becomes."""


@pytest.mark.parametrize(
    ("name", "limit"), [(p.name, limit) for p in map(profiles.load, profiles.NAMES) for limit in p.limits], ids=str
)
def test_limits(name, limit):
    """At the limit itself, or 1e-30 of the half-width away from a length that vanishes."""
    target, found = entries(limit.target), entries(name)
    drawn = points(profiles.load(name), (nt.x, nt.a, nt.L), 1, 7, (nt.P,))[0].values
    here = {**drawn, limit.symbol: limit.value if limit.value != 0 else Q(1, 10**30) * drawn[nt.a]}
    here |= {symbol: expr.subs(here) for symbol, expr in REACHED.items() if name == "power_law"}
    compared = [suffix for suffix in target if suffix in found and suffix not in ("xz", "Pmin")]
    assert len(compared) >= (1 if name == "eccentric_punch" else 3)
    for suffix in compared:
        if found[suffix].status == "closed" and target[suffix].status == "root":
            continue
        at = {**here, nt.x: 2 * here[nt.a]} if suffix == "s" else here
        if found[suffix].status == "root":
            got = evaluated(case_at(found[suffix], at).expr.lhs, at)
            want = evaluated(target["P"].cases[0].expr, at)
        else:
            at = {**at, nt.P: evaluated(target["P"].cases[0].expr, at)} if suffix == "aP" else at
            got, want = (evaluated(case_at(source[suffix], at).expr, at) for source in (found, target))
        assert abs(got - want) <= mp.mpf(10) ** -12 * abs(want), suffix


@pytest.mark.parametrize("name", ["rounded_wedge", "rounded_punch", "truncated_wedge"])
def test_pressure_is_the_same_on_both_sides_of_the_break(name):
    """The logarithms cancel at x = b; at a corner both sides are infinite in the same way."""
    epsilon = Q(1, 10**40)
    base = {nt.theta: Q(1, 5), nt.R: Q(7, 3), nt.b: Q(1), nt.a: Q(3, 2), nt.E_star: Q(2)}
    sides = [value(name, "p", {**base, nt.x: 1 + sign * epsilon}, 60) for sign in (-1, 1)]
    assert abs(sides[0] - sides[1]) < mp.mpf(10) ** -36 * abs(sides[0])
    closer = value(name, "p", {**base, nt.x: 1 - epsilon**2}, 60)
    if name == "truncated_wedge":  # p ~ -E* tan(theta) ln(abs(x - b))/(2 pi)
        growth = 2 * mp.tan(mp.mpf(1) / 5) * 40 * mp.log(10) / (2 * mp.pi)
        assert abs((closer - sides[0]) / growth - 1) < 1e-30
    else:
        assert abs(closer - sides[0]) < mp.mpf(10) ** -36 * abs(sides[0])


@pytest.mark.parametrize("suffix", ["P", "p", "s", "d"])
def test_rounded_wedge_is_continuous_where_the_contact_leaves_the_tip(suffix):
    epsilon = Q(1, 10**40)
    base = {nt.theta: Q(1, 5), nt.b: Q(1), nt.E_star: Q(2), nt.x: Q(1, 3) if suffix == "p" else Q(5, 2), nt.L: Q(4)}
    below, above = (value("rounded_wedge", suffix, {**base, nt.a: 1 + sign * epsilon}, 60) for sign in (-1, 1))
    assert abs(above - below) < mp.mpf(10) ** -38 * abs(below)


def test_depth_at_the_edge_is_the_profile():
    """At L = a the reference point is the edge; just beyond it the surface leaves the punch."""
    values = {nt.R: Q(2), nt.a: Q(1), nt.L: 1 + Q(1, 10**60), nt.E_star: Q(1)}
    assert abs(value("parabola", "d", values, 40) - mp.mpf(1) / 4) < mp.mpf(10) ** -55


def test_least_load_of_the_concave_quartic():
    found = entries("concave_quartic")
    assert found["Pmin"].cases[0].expr == 3 * sp.pi * nt.E_star * nt.h / 8
    assert found["xz"].cases[0].expr == nt.a / 2


@pytest.mark.parametrize("n", [Q(11, 10), Q(3, 2), Q(19, 10), Q(21, 10), Q(3), Q(37, 10), Q(6), Q(40)])
def test_least_load_keeps_the_contact_closed(n):
    """Under P_min the pressure touches zero at x_0 and nowhere else; under a little less it is negative there."""
    values = {nt.a: Q(2), nt.h: Q(1, 7), nt.n: n, nt.E_star: Q(3)}
    place = case_at(entries("concave_power")["xz"], values)
    x_0 = strips.zero_distance(place, values)
    least = evaluated(entries("concave_power")["Pmin"].cases[0].expr, {**values, nt.x_zero: x_0})
    pressure = entries("concave_power")["p"].cases[0].expr

    def p(x, load):
        return evaluated(pressure, {**values, nt.x: x, nt.P: load})

    # in the middle the pressure rises as x**(n - 1)
    nearest, small = (x_0, mp.mpf(10) ** -40) if x_0 > 0 else (mp.mpf(10) ** -20, mp.mpf(10) ** (-20 * (n - 1)))
    assert abs(p(nearest, least)) < small * p(mp.mpf("1.99"), least)
    assert p(nearest, least * (1 - 2 * small)) < 0
    # at an odd n a value takes a tenth of a second, its series being the limit of others
    places = range(1, 100, 9 if n % 2 == 1 else 1)
    assert all(p(mp.mpf(i) / 50, least) > 0 for i in places if abs(mp.mpf(i) / 50 - x_0) > 1e-3)
    assert (x_0 > 0) == (n > 2)


def test_concave_faces_agree_with_the_power_law():
    for name, n in (("concave_parabola", 2), ("concave_quartic", 4)):
        values = {nt.a: Q(2), nt.h: Q(1, 7), nt.n: Q(n), nt.E_star: Q(3), nt.P: Q(5), nt.x: Q(1, 3)}
        for suffix in ("p", "s", "d"):
            at = {**values, nt.x: Q(1, 3) if suffix == "p" else Q(5), nt.L: Q(9)}
            assert abs(value(name, suffix, at) / value("concave_power", suffix, at) - 1) < mp.mpf(10) ** -28


def test_eccentric_punch_at_lift_off():
    """Both branches agree at abs(e) = a/2; beyond, the pressure ends at 4 e - 3 a and the width is 4 (a - e)."""
    at = {nt.a: Q(2), nt.P: Q(3), nt.E_star: Q(5)}
    for suffix, x in (("p", Q(-1)), ("p", Q(3, 2)), ("phi", None), ("cw", None)):
        touching, lifted = (case.expr for case in entries("eccentric_punch")[suffix].cases)
        for e in (Q(1), Q(-1)):
            values = {**at, nt.e: e} | ({nt.x: x} if x is not None else {})
            assert sp.simplify((touching - lifted).subs(values)) == 0
    values = {**at, nt.e: Q(7, 5)}
    assert abs(value("eccentric_punch", "cw", values) - mp.mpf(12) / 5) < 1e-50
    assert evaluated(case_at(entries("eccentric_punch")["p"], values).expr, {**values, nt.x: Q(-41, 100)}) == 0
    assert value("eccentric_punch", "p", {**values, nt.x: Q(-39, 100)}) > 0
    mirrored = value("eccentric_punch", "p", {**values, nt.e: Q(-7, 5), nt.x: Q(-1, 2)})
    assert mirrored == value("eccentric_punch", "p", {**values, nt.x: Q(1, 2)})


@pytest.mark.parametrize(("name", "suffix"), drawn(all_keys(), 8))
def test_units(name, suffix):
    assert units.check(profiles.load(name), entries(name), suffix).passed
