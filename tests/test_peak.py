"""The greatest pressure and its ring: against published numbers, and against an integral and a search of their own."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from false_entries import record
from scenes import composed_from, problems, run_plainly

from axicontact.normal import (
    ellipsoid,
    gaussian,
    hyperboloid,
    paraboloid,
    power_law,
    quartic,
    rounded_cone,
    rounded_punch,
    sextic,
    sphere,
)
from axiderive import notation as nt
from axiderive.checks import quadrature
from axiderive.checks.comparison import Comparison
from axiderive.code.docstring import formula
from axiderive.entry import Case, Entry
from axiderive.expression import own_profile
from axiderive.notation import E_star, R, a, b, r, r_peak
from axiderive.physics import peak
from axiderive.physics.normal import derive
from axiderive.profiles import COMPACT_NAMES, load
from axiderive.proof.algebra.domain import NotProvedError
from axiderive.proof.certificate import certify
from axiderive.proof.rules import rings
from axiderive.proof.rules.compact import Compact
from axiderive.stable.measure import ulps
from axiderive.stable.reference import condition, of_contact
from axiderive.verifier.problem import Problem

EPS = 2.0**-52
FLAT = {"R": 1.0, "E_star": 1.0}
UNITS = {"radius": 4.0, "pressure": 6.0}
"""Of the last place; 2.3 and 3.7 are measured at 120 contacts between a/b - 1 = 1e-15 and a/b = 1e12."""


def mpmath_pressure(face: float, radius: float, place: Any) -> Any:
    """pi p/E* under a flat face with a rounding of unit curvature, by (11.23) with t = sqrt(r^2 + u^2)."""

    def over_radius(u: Any) -> Any:
        t = mp.hypot(place, u)
        return (2 * mp.sqrt((t - face) * (t + face)) - face * mp.acos(face / t)) / t

    end = mp.sqrt((radius - place) * (radius + place))
    return mp.quad(over_radius, [0, end / 20, end / 4, end])


def searched(height: Callable[[Any], Any], low: Any, high: Any) -> tuple[Any, Any]:
    """The place and value of the greatest height by golden sections: half of the digits of the height."""
    ratio = (mp.sqrt(5) - 1) / 2
    left, right = high - ratio * (high - low), low + ratio * (high - low)
    at_left, at_right = height(left), height(right)
    while high - low > mp.mpf(10) ** -9 * high:
        if at_left < at_right:
            low, left, at_left, right = left, right, at_right, left + ratio * (high - left)
            at_right = height(right)
        else:
            high, right, at_right, left = right, left, at_left, right - ratio * (right - low)
            at_left = height(left)
    return (low + high) / 2, height((low + high) / 2)


@pytest.mark.parametrize(
    ("ratio", "over_mean", "place"),
    [
        (0.25, 1.2947, 0.4487),
        (0.5, 1.2860, 0.6513),
        (0.75, 1.5097, 0.8276),
        (0.9, 2.1509, 0.9308),
        (0.95, 2.9412, 0.9653),
    ],
)
def test_the_numbers_known_before(ratio: float, over_mean: float, place: float) -> None:
    found = rounded_punch.peak_pressure(1.0, b=ratio, **FLAT)
    assert found.pressure / rounded_punch.mean_pressure(1.0, b=ratio, **FLAT) == pytest.approx(over_mean, abs=5e-5)
    assert found.radius == pytest.approx(place, abs=6e-5)


@pytest.mark.parametrize("ratio", [1e-3, 0.4, 0.97])
def test_a_search_over_another_integral_finds_it(ratio: float) -> None:
    with mp.workdps(20):
        place, height = searched(lambda r: mpmath_pressure(ratio, 1.0, r), mp.mpf(ratio), mp.mpf(1))
        found = rounded_punch.peak_pressure(1.0, b=ratio, **FLAT)
        assert abs(found.pressure * mp.pi / height - 1) < 8 * EPS
        assert abs(found.radius / place - 1) < 1e-8


def test_a_narrow_rounding_has_the_peak_of_an_asymptote() -> None:
    """p_max/p_mean = 0.8998/phi_0 at r/b = 1 + 0.1526 phi_0^2, phi_0 = arccos(b/a), to terms of phi_0^2."""
    for phi in (1e-2, 1e-4, 1e-6):
        radius = 1.0 / math.cos(phi)
        found = rounded_punch.peak_pressure(radius, b=1.0, **FLAT)
        exact = math.acos(1.0 / radius)
        mean = rounded_punch.mean_pressure(radius, b=1.0, **FLAT)
        assert found.pressure / mean * exact == pytest.approx(0.8998, abs=2e-4)
        assert (found.radius - 1.0) / exact**2 == pytest.approx(0.1526, abs=2e-4 + 4 * EPS / exact**2)


@pytest.mark.parametrize("ratio", [1e-12, 1e-5, 0.02, 0.249, 0.251, 0.6, 0.99, 1 - 1e-6, 1 - 1e-11, 1 - 4 * EPS])
def test_the_last_places(ratio: float) -> None:
    """Where a and b are neighbours the radius cannot say where in the rounding it is, and the pressure still knows."""
    entries = derive(load("rounded_punch"))
    given = {"R": 0.7, "b": ratio * 3.0, "E_star": 2.5}
    exact = {
        suffix: of_contact(entries, suffix, {a: 3.0, R: 0.7, b: ratio * 3.0, E_star: 2.5}) for suffix in ("rp", "pp")
    }
    alone, many = rounded_punch.peak_pressure(3.0, **given), rounded_punch.peak_pressure(np.full(3, 3.0), **given)
    for suffix, member in (("rp", "radius"), ("pp", "pressure")):
        for got in (getattr(alone, member), float(getattr(many, member)[1])):
            assert ulps(got, exact[suffix]) <= UNITS[member], (suffix, member)


@pytest.mark.parametrize(("module", "share"), [(quartic, math.sqrt(0.5)), (sextic, math.sqrt((1 + math.sqrt(3)) / 4))])
def test_powers_have_it_at_a_fixed_share_of_the_radius(module: Any, share: float) -> None:
    found = module.peak_pressure(0.3, A=2.0, E_star=5.0)
    assert found.radius == pytest.approx(0.3 * share, rel=4 * EPS)
    assert found.pressure == pytest.approx(module.pressure(found.radius, 0.3, A=2.0, E_star=5.0), rel=8 * EPS)
    places = np.linspace(0.0, 0.3, 2001)
    assert module.pressure(places, 0.3, A=2.0, E_star=5.0).max() <= found.pressure * (1 + 4 * EPS)


@pytest.mark.parametrize("n", [2.0 + 1e-12, 2.001, 2.4, 3.0, 3.5, 4.0, 6.0, 7.3, 25.0, 300.0])
def test_the_last_places_of_any_power(n: float) -> None:
    """1 and 3.5 are measured at 70 powers between 2 + 1e-12 and 1000."""
    entries = derive(load("power_law"))
    values = {a: 0.7, nt.A: 1.3, nt.n: n, E_star: 2.5}
    found = power_law.peak_pressure(0.7, A=1.3, n=n, E_star=2.5)
    assert ulps(found.radius, of_contact(entries, "rp", values)) <= 4.0
    assert ulps(found.pressure, of_contact(entries, "pp", values)) <= 8.0


@pytest.mark.parametrize(("n", "module"), [(4.0, quartic), (6.0, sextic)])
def test_the_power_law_has_the_peak_of_its_special_cases(n: float, module: Any) -> None:
    found, own = power_law.peak_pressure(0.3, A=2.0, n=n, E_star=5.0), module.peak_pressure(0.3, A=2.0, E_star=5.0)
    assert found == pytest.approx(own, rel=8 * EPS)


def test_up_to_the_paraboloid_the_peak_is_on_the_axis() -> None:
    """Without bound for n <= 1; beyond n = 2 it leaves the axis as pi (n - 2)/2."""
    powers = np.array([0.5, 1.0, 1.2, 1.9, 2.0])
    found = power_law.peak_pressure(0.4, A=1.5, n=powers, E_star=3.0)
    assert (found.radius == 0.0).all()
    assert np.isinf(found.pressure[:2]).all()
    assert found.pressure[2:] == pytest.approx(power_law.pressure(0.0, 0.4, A=1.5, n=powers[2:], E_star=3.0), rel=1e-14)
    assert power_law.peak_pressure(0.4, A=1.5, n=2.0, E_star=3.0) == pytest.approx(
        (paraboloid.pressure(0.0, 0.4, R=1 / 3.0, E_star=3.0), 0.0), rel=4 * EPS, abs=0.0
    )
    left = power_law.peak_pressure(1.0, A=1.5, n=2.0 + 2.0**-30, E_star=3.0)
    assert left.radius == pytest.approx(math.pi * 2.0**-31, rel=1e-8)


@pytest.mark.parametrize("n", [2.02, 2.5, 3.0, 5.0, 11.0, 60.0])
def test_no_place_under_a_power_has_more_pressure(n: float) -> None:
    found = power_law.peak_pressure(1.0, A=1.0, n=n, E_star=1.0)
    close = np.clip(found.radius * (1.0 + np.linspace(-0.01, 0.01, 201)), 0.0, 1.0)
    for places in (np.linspace(0.0, 1.0, 999), close):
        assert power_law.pressure(places, 1.0, A=1.0, n=n, E_star=1.0).max() <= found.pressure * (1 + 16 * EPS)
    assert found.pressure == pytest.approx(power_law.pressure(found.radius, 1.0, A=1.0, n=n, E_star=1.0), rel=16 * EPS)


LEAVES = 0.9376121436530147
"""a/R, by 3 z = (3 z^2 - 1) artanh(z), where the greatest pressure under a sphere leaves the axis."""


def under_sphere(radius: Any, place: Any) -> Any:
    """pi p/E* under a sphere of R = 1 by (11.23): int_r^a g'(t)/sqrt(t^2 - r^2) dt with t = sqrt(r^2 + u^2)."""
    end = mp.sqrt((radius - place) * (radius + place))

    def rate(u: Any) -> Any:
        t = mp.hypot(place, u)
        return (mp.atanh(t) + t / (1 - t) / (1 + t)) / t

    # the singularity at t = 1 is next to the edge
    return mp.quad(rate, [0, end / 2, *(end * (1 - mp.mpf(10) ** -k) for k in (1, 2, 3)), end])


@pytest.mark.parametrize("share", [0.938, 0.96, 0.995])
def test_a_search_over_the_definition_finds_the_ring_of_a_sphere(share: float) -> None:
    with mp.workdps(20):
        place, height = searched(lambda r: under_sphere(mp.mpf(share), r), mp.mpf(0), mp.mpf(share) * (1 - 1e-4))
        found = sphere.peak_pressure(share, R=1.0, E_star=1.0)
        assert abs(found.pressure * mp.pi / height - 1) < 8 * EPS
        assert abs(found.radius / place - 1) < 1e-7


def test_the_ring_of_a_sphere_leaves_the_axis_as_a_root() -> None:
    """With z = a/R and y = artanh(z), r_max^2/a^2 begins as 4 coth(y) dy/dz times what z is beyond that share."""
    assert sphere.peak_pressure(LEAVES - 1e-15, R=1.0, E_star=1.0).radius == 0.0
    slope = 4.0 / LEAVES / (1.0 - LEAVES**2)
    for beyond in (1e-6, 1e-9, 1e-11):
        found = sphere.peak_pressure(LEAVES + beyond, R=1.0, E_star=1.0)
        assert (found.radius / LEAVES) ** 2 == pytest.approx(slope * beyond, rel=40 * beyond + 8 * EPS / beyond)


@pytest.mark.parametrize("share", [1e-9, 0.3, 0.93, 0.9377, 0.95, 0.98, 0.987, 0.9999, 1 - 1e-8, 1 - 1e-13, 1 - EPS])
def test_the_last_places_of_a_sphere_and_of_an_ellipsoid(share: float) -> None:
    """Beside what a unit of a/R does to the ring, which leaves the axis as a root."""
    radius = 0.7 * share
    for name, found, given in (
        ("sphere", sphere.peak_pressure(radius, R=0.7, E_star=2.5), {R: 0.7}),
        ("ellipsoid", ellipsoid.peak_pressure(radius, h=1.3, b=0.7, E_star=2.5), {nt.h: 1.3, b: 0.7}),
    ):
        values, entries = {a: radius, E_star: 2.5, **given}, derive(load(name))
        assert ulps(found.pressure, of_contact(entries, "pp", values)) <= 4.0 + condition(entries, "pp", values)
        if share < LEAVES:
            assert found.radius == 0.0
        else:
            assert ulps(found.radius, of_contact(entries, "rp", values)) <= 4.0 + condition(entries, "rp", values)


def test_no_place_under_a_sphere_has_more_pressure() -> None:
    for share in (0.2, 0.9, 0.9376, 0.95, 0.99):
        found = sphere.peak_pressure(share, R=1.0, E_star=1.0)
        places = np.append(np.linspace(0.0, share, 999), found.radius)
        many = sphere.pressure(places, share, R=1.0, E_star=1.0)
        assert many[:-1].max() <= found.pressure * (1 + 8 * EPS)
        assert found.pressure == pytest.approx(many[-1], rel=16 * EPS)


def test_at_the_edge_of_a_sphere_the_pressure_has_no_bound() -> None:
    found = sphere.peak_pressure(np.array([0.0, 1.0, 1.0 + 1e-15, -1.0, np.nan]), R=1.0, E_star=1.0)
    assert found.pressure[:2].tolist() == [0.0, np.inf]
    assert found.radius[:2].tolist() == [0.0, 1.0]
    assert np.isnan(found.pressure[2:]).all()
    assert np.isnan(found.radius[2:]).all()


def test_no_place_has_more_pressure() -> None:
    for ratio in (1e-4, 0.1, 0.7, 0.999):
        found = rounded_punch.peak_pressure(1.0, b=ratio, **FLAT)
        places = np.concatenate(
            [np.linspace(0.0, 1.0, 999), found.radius * (1.0 + (1.0 - ratio) * np.linspace(-0.05, 0.05, 99))]
        )
        assert rounded_punch.pressure(places, 1.0, b=ratio, **FLAT).max() <= found.pressure * (1 + 64 * EPS)
        assert ratio < found.radius < 1.0


def test_arrays_broadcast_and_what_is_no_contact_is_no_number() -> None:
    found = rounded_punch.peak_pressure(np.array([[2.0], [3.0]]), b=[0.5, 1.0, 1.5], **FLAT)
    assert found.pressure.shape == found.radius.shape == (2, 3)
    alone = rounded_punch.peak_pressure(3.0, b=1.5, **FLAT)
    assert (found.pressure[1, 2], found.radius[1, 2]) == pytest.approx((alone.pressure, alone.radius), rel=8 * EPS)
    some = rounded_punch.peak_pressure(np.array([0.5, 1.0, 2.0, -1.0, np.nan]), b=1.0, **FLAT)
    assert np.isnan(some.pressure).tolist() == np.isnan(some.radius).tolist() == [True, False, False, True, True]
    assert (some.pressure[1], some.radius[1]) == (0.0, 1.0)
    assert quartic.peak_pressure(0.0, A=1.0, E_star=1.0) == (0.0, 0.0)
    assert rounded_punch.peak_pressure(np.inf, b=1.0, **FLAT) == (np.inf, np.inf)
    with pytest.raises(ValueError, match="the contact starts at a = b"):
        rounded_punch.peak_pressure(0.5, b=1.0, **FLAT)
    with pytest.raises(ValueError, match=r"R = -1\.0 is outside R > 0"):
        rounded_punch.peak_pressure(2.0, b=1.0, R=-1.0, E_star=1.0)
    with pytest.raises(TypeError, match="must be a real number"):
        rounded_punch.peak_pressure("2 mm", b=1.0, **FLAT)


def test_it_is_derived_on_the_axis_or_where_one_ring_alone_has_it() -> None:
    found = {name: derive(load(name)) for name in COMPACT_NAMES}
    known = {name: all(case.expr == 0 for case in own["rp"].cases) for name, own in found.items() if "rp" in own}
    assert {name for name in known if known[name]} == {"paraboloid", "rounded_cone", "hyperboloid", "gaussian"}
    assert known.keys() - {*ON_AXIS} == {"quartic", "sextic", "power_law", "rounded_punch", "sphere", "ellipsoid"}


ON_AXIS: dict[str, tuple[Any, dict[str, float], Callable[[Any], Any], list[float]]] = {
    "paraboloid": (paraboloid, {"R": 1.3}, lambda r: r / 1.3, []),
    "rounded_cone": (rounded_cone, {"theta": 0.4, "b": 0.5}, lambda r: mp.tan(0.4) * min(r / 0.5, 1), [0.5]),
    "hyperboloid": (hyperboloid, {"theta": 0.4, "b": 0.5}, lambda r: mp.tan(0.4) * r / mp.hypot(r, 0.5), []),
    "gaussian": (gaussian, {"h": 0.3, "s": 1.1}, lambda r: 0.6 * r / 1.21 * mp.exp(-((r / 1.1) ** 2)), []),
}
"""Modules, parameters, f' and where it bends."""


def middle(slope: Callable[[Any], Any], radius: float, bends: list[float]) -> Any:
    """pi p(0)/E* = g(a)/a + int_0^a g(t)/t^2 dt with g by (11.29), its integrals exchanged, r = a sin(u)."""
    breaks = [mp.asin(b / radius) for b in bends if b < radius]
    return mp.quad(lambda u: slope(radius * mp.sin(u)) * (1 + (mp.pi / 2 - u) * mp.cot(u)), [0, *breaks, mp.pi / 2])


@pytest.mark.parametrize("name", ON_AXIS)
@pytest.mark.parametrize("radius", [0.3, 1.4])
def test_the_pressure_of_the_axis(name: str, radius: float) -> None:
    module, given, slope, bends = ON_AXIS[name]
    found = module.peak_pressure(radius, E_star=2.5, **given)
    with mp.workdps(20):
        assert abs(found.pressure * mp.pi / 2.5 / middle(slope, radius, bends) - 1) < 1e-14
    assert found.radius == 0.0
    places = np.linspace(0.0, radius, 999)
    assert module.pressure(places, radius, E_star=2.5, **given).max() <= found.pressure * (1 + 8 * EPS)


def test_there_is_none_where_there_is_no_contact() -> None:
    found = hyperboloid.peak_pressure(np.array([0.0, 1.0, -1.0, np.nan]), theta=0.4, b=1.0, E_star=2.5)
    for own in found:
        assert np.isnan(own).tolist() == [False, False, True, True]
    assert (found.pressure[0], found.radius[0]) == (0.0, 0.0)
    beyond = gaussian.peak_pressure(np.array([1.5, 1.51]), h=0.3, s=1.0, E_star=2.5)
    assert [np.isnan(own).tolist() for own in beyond] == [[False, True]] * 2


@pytest.mark.parametrize(
    ("text", "on_axis"),
    [
        *((text, True) for text in ("q*r**2", "r**(3/2)", "sqrt(r**2 + q**2) - q", "1 - exp(-r**2/q**2)")),
        *((text, False) for text in ("q*r", "r**2 + r**4", "q*r**2 - c*r**4", "q*r**2 + c*Max(0, r - b)")),
    ],
)
def test_curvatures_that_fall(text: str, on_axis: bool) -> None:
    """Of faces that someone types; the third of the others falls beyond some radius, and the last has an edge."""
    own = own_profile(text)
    with nt.extended(own.notation):
        assert peak.has_falling_curvature(own.profile) == on_axis


@pytest.mark.parametrize("name", ["cone", "capped_paraboloid", "rounded_curved_punch", "sphere", "truncated_cone"])
def test_the_axis_of_another_profile_is_refused(name: str) -> None:
    """Where f' does not begin at zero, f'(r)/r rises, steadily or by a jump, or nothing touches the axis first."""
    entries, ring = derive(load(name)), derive(load("paraboloid"))["rp"]
    cases = tuple(Case(regime.chain, sp.S.Zero) for regime in entries["d"].cases)
    wrong = replace(ring, key=f"{name}.rp", profile=load(name), cases=cases, parameters=entries["F"].parameters)
    certificate = certify(load(name), {**entries, "rp": wrong}, "rp")
    assert not certificate.proved
    assert re.search(r"f'\(r\) has no jump|f'\(r\) > 0|\(f'\(r\)/r\)' <= 0", certificate.reason)
    assert Problem(record(name, {**entries, "rp": wrong})).prove("rp")


def test_the_certificates_and_the_search_hold() -> None:
    for name in ("ellipsoid", "hyperboloid", "rounded_cone", "quartic", "power_law", "rounded_punch"):
        profile, entries = load(name), derive(load(name))
        assert all(certify(profile, entries, suffix).proved for suffix in ("rp", "pp"))
    assert quadrature.check(Comparison(profile, entries, digits=20, points=2), "pp").passed


def test_the_axis_under_a_bump_is_proved_without_a_closed_pressure() -> None:
    """Twice, and with another place not; the pressure there is an integral."""
    profile, entries = load("gaussian"), derive(load("gaussian"))
    wrong = moved(entries, "rp", lambda radius: nt.s / 5)
    for own, shown in ((entries, True), (wrong, False)):
        assert certify(profile, own, "rp").proved == shown
        assert (Problem(record("gaussian", own)).prove("rp") == "") == shown
    assert entries["pp"].status == entries["p"].status == "integral"


@pytest.mark.slow
@pytest.mark.parametrize(("share", "passed"), [(1, True), (1 + sp.Rational(1, 10**10), False)])
def test_the_search_measures_a_pressure_that_is_an_integral(share: Any, passed: bool) -> None:
    profile, entries = load("gaussian"), derive(load("gaussian"))
    scaled = moved(entries, "pp", lambda pressure: pressure * share)
    assert quadrature.check(Comparison(profile, scaled, digits=20, points=1), "pp").passed == passed


def moved(entries: dict[str, Entry], suffix: str, change: Callable[[sp.Expr], sp.Expr]) -> dict[str, Entry]:
    *others, case = entries[suffix].cases
    return {**entries, suffix: replace(entries[suffix], cases=(*others, replace(case, expr=change(case.expr))))}


def other_side(change: Callable[[sp.Expr], sp.Expr]) -> Callable[[sp.Expr], sp.Expr]:
    return lambda equation: sp.Eq(change(equation.lhs), equation.rhs, evaluate=False)


@pytest.mark.parametrize(
    ("name", "suffix", "change"),
    [
        ("quartic", "rp", lambda radius: radius / 2),
        ("quartic", "rp", lambda radius: sp.S.Zero),
        ("quartic", "pp", lambda pressure: pressure * sp.sqrt(2) * sp.Rational(17, 24)),
        ("sextic", "rp", lambda radius: sp.sqrt(sp.sqrt(3) - 1) * a / 2),
        ("hyperboloid", "rp", lambda radius: a / 3),
        ("rounded_cone", "pp", lambda pressure: pressure.subs(sp.asin, sp.atan)),
        ("rounded_cone", "pp", lambda pressure: 2 * pressure),
        ("rounded_punch", "rp", other_side(lambda left: -left)),
        ("rounded_punch", "rp", other_side(lambda left: left.subs(sp.acos(b / a), sp.asin(b / a)))),
        ("rounded_punch", "rp", other_side(lambda left: left + (a - r_peak) / R)),
        ("rounded_punch", "pp", lambda pressure: pressure.subs(r_peak, (r_peak + a) / 2)),
        ("rounded_punch", "pp", lambda pressure: pressure.subs(r_peak, b)),
        ("power_law", "rp", other_side(lambda left: -left)),
        ("power_law", "rp", other_side(lambda left: left * (nt.n - 2))),
        ("power_law", "rp", other_side(lambda left: left.subs(nt.n, nt.n + 1))),
        ("power_law", "pp", lambda pressure: pressure * (nt.n - 1)),
        ("power_law", "pp", lambda pressure: pressure.subs(r_peak, r_peak / 2)),
        ("ellipsoid", "rp", other_side(lambda left: -left)),
        ("ellipsoid", "rp", other_side(lambda left: left.subs(sp.atanh, sp.asinh))),
        ("ellipsoid", "rp", other_side(lambda left: left * a / b)),
        ("ellipsoid", "pp", lambda pressure: pressure.subs(r_peak, r_peak / 2)),
        ("ellipsoid", "pp", lambda pressure: pressure.subs(r_peak, 0)),
    ],
)
def test_another_place_or_pressure_is_refused(name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr]) -> None:
    entries = moved(derive(load(name)), suffix, change)
    assert not certify(load(name), entries, suffix).proved


@pytest.mark.parametrize(("roots", "shown"), [((2,), True), ((2, 5, 8), False)])
def test_a_slope_that_changes_its_sign_more_than_once_is_refused(roots: tuple[int, ...], shown: bool) -> None:
    """Of a pressure with sqrt(a^2 - r^2)/r dp/dr = 0 at r^2/a^2 = 2/10 and further out: the ring may be another one."""
    height, slope = sp.Symbol("height", positive=True), sp.Integer(1)
    for root in roots:
        slope *= sp.Rational(root, 10) - 1 + height**2
    pressure = -sp.integrate(sp.expand(slope), (height, 0, sp.sqrt(1 - r**2 / a**2)))
    entries = moved(moved(derive(load("quartic")), "p", lambda p: pressure), "rp", lambda radius: a / sp.sqrt(5))
    proof = Compact(load("quartic"), entries)
    if shown:
        assert rings.greatest(proof)
    else:
        with pytest.raises(NotProvedError, match="one change of the sign"):
            rings.greatest(proof)


def test_the_docstring_has_the_paraboloid_in_one_range() -> None:
    ring = derive(load("power_law"))["rp"]
    text = " ".join(formula(ring.profile, ring.quantity, ring))
    assert re.findall(r" for ([^A-Z=]* n\b(?: <=? 2)?)", text) == ["1 < n <= 2", "2 < n"]


@pytest.mark.parametrize("place", [a / 100, (2 - nt.n) * a])
def test_a_ring_beside_the_axis_is_refused_up_to_the_paraboloid(place: sp.Expr) -> None:
    """Of which the second one is wrong below n = 2 alone."""
    entries = derive(load("power_law"))
    axis, ring = entries["rp"].cases
    wrong = entries | {"rp": replace(entries["rp"], cases=(replace(axis, expr=place), ring))}
    assert not certify(load("power_law"), wrong, "rp").proved


def test_the_search_sees_a_wrong_place() -> None:
    profile, entries = load("quartic"), derive(load("quartic"))
    wrong = moved(entries, "rp", lambda radius: radius * (1 + sp.Rational(1, 10**18)))
    assert not quadrature.check(Comparison(profile, wrong, digits=30, points=1), "rp").passed


SCENE = """\
name = "scene"

[profile]
kind = "{kind}"

[want]
quantities = ["peak_pressure", "peak_radius"]

[output]
formats = ["python"]
"""


def test_a_scene_has_a_function_for_either_result(tmp_path: Any) -> None:
    made = composed_from(SCENE.format(kind="rounded_punch"))
    assert run_plainly(made, tmp_path)
    space: dict[str, Any] = {}
    exec(made.files["scene.py"].decode(), space)
    wanted = rounded_punch.peak_pressure(1.62, R=1.45, b=1.15, E_star=3.0)
    assert space["peak_pressure"](1.62, R=1.45, b=1.15, E_star=3.0) == pytest.approx(wanted.pressure, rel=8 * EPS)
    assert space["peak_radius"](1.62, b=1.15) == pytest.approx(wanted.radius, rel=8 * EPS)


def test_a_scene_of_a_power_has_them_too(tmp_path: Any) -> None:
    made = composed_from(SCENE.format(kind="power_law"))
    assert run_plainly(made, tmp_path)
    space: dict[str, Any] = {}
    exec(made.files["scene.py"].decode(), space)
    wanted = power_law.peak_pressure(0.3, A=1.2, n=3.4, E_star=2.0)
    assert space["peak_pressure"](0.3, A=1.2, n=3.4, E_star=2.0) == pytest.approx(wanted.pressure, rel=8 * EPS)
    assert space["peak_radius"](0.3, n=3.4) == pytest.approx(wanted.radius, rel=8 * EPS)


def test_a_scene_of_another_profile_has_none() -> None:
    assert "unknown quantity 'peak_pressure' of normal" in problems(SCENE.format(kind="cone"))


def test_the_symbols_are_those_of_the_notation() -> None:
    assert [nt.describe(name).unit for name in ("r_peak", "p_peak")] == ["m", "Pa"]
