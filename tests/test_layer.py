"""A layer on a rigid base: its surface in other numbers, its limits, and what is published."""

from __future__ import annotations

import warnings
from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from axicontact._runtime.physics import layer as runtime
from axicontact.layer import cone, flat_punch, paraboloid, rounded_punch
from axicontact.normal import paraboloid as half_space
from axiderive import notation as nt
from axiderive.checks.checks import check_problem
from axiderive.code.example import POLYNOMIAL, numbers
from axiderive.commands.show import shown
from axiderive.letters import name_of
from axiderive.oracle.half_space import HalfSpace
from axiderive.oracle.layer import Layer, layer, sinking
from axiderive.oracle.shape import coefficient
from axiderive.physics import layer as stated
from axiderive.physics.systems import problem
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, load
from axiderive.rows import layer as printed
from axiderive.store.index import load as catalogue

STATES = (("bonded", 0.5, 0.2), ("bonded", 0.5, 3.0), ("bonded", 0.0, 1.0), ("frictionless", 0.3, 2.0))
"""Base, Poisson's ratio, contact radius over thickness."""
FIRST = [("paraboloid", *STATES[1]), ("cone", *STATES[3]), ("truncated_cone", *STATES[2])]
OTHERS = [(name, *state) for name in COMPACT_NAMES for state in (STATES if name == "paraboloid" else STATES[1:2])]
DIGITS = 18
"""Of the reference: with 14 its force on a cone is off by 3.7e-12 at three thicknesses; with 22 it is the module's."""


@cache
def solved(name: str, base: str, nu: float, ratio: float) -> tuple[Layer, dict[str, Any]]:
    """By the surface, and the geometry of its module."""
    profile = load(name)
    known = numbers(profile)
    known |= {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}
    known |= {nt.N: sp.Integer(len(POLYNOMIAL)), **{coefficient(i): c for i, c in enumerate(POLYNOMIAL, 1)}}
    radius = known.get(nt.a, sp.Rational(str(profile.sketch.a)))
    at = {**known, nt.a: radius, stated.thickness: radius / sp.Rational(ratio), nt.nu: sp.Rational(nu)}
    at |= {nt.E_star: sp.Integer(1), nt.d: sp.Rational(1, 5), nt.r: radius * sp.Rational(3, 10)}
    with mp.workdps(DIGITS + 10):
        found = layer(HalfSpace(profile, at, DIGITS, graded=False), base)
    geometry = {name_of(symbol): float(at[symbol]) for symbol in profile.parameters if symbol in at}
    geometry |= {"A": tuple(map(float, POLYNOMIAL))} if nt.coefficients in profile.parameters else {}
    return found, {**geometry, "nu": nu, "thickness": float(at[stated.thickness])}


@pytest.mark.parametrize(
    ("name", "base", "nu", "ratio"), [*FIRST, *(pytest.param(*own, marks=pytest.mark.slow) for own in OTHERS)]
)
def test_the_functions_put_the_surface_where_the_indenter_is(name: str, base: str, nu: float, ratio: float) -> None:
    """Depth, force, pressure and inverses against the oracle, which knows no Fredholm equation and no closed L."""
    found, given = solved(name, base, nu, ratio)
    module, a = import_module(f"axicontact.layer.{name}"), float(found.a)
    with mp.workdps(DIGITS + 10):
        depth, force, pressure = (float(found.value(symbol)) for symbol in (nt.d, nt.F, nt.p))
    elastic = {**given, "E_star": 1.0, "base": base}
    assert module.depth(a, **given, base=base) == pytest.approx(depth, rel=1e-12)
    assert module.force(a, **elastic) == pytest.approx(force, rel=1e-12)
    assert module.pressure(0.3 * a, a, **elastic) == pytest.approx(pressure, rel=1e-11)
    assert module.radius_from_depth(depth, **given, base=base) == pytest.approx(a, rel=1e-12)
    assert module.radius_from_force(force, **elastic) == pytest.approx(a, rel=1e-12)
    assert module.force_from_depth(depth, **elastic) == pytest.approx(force, rel=1e-11)
    assert module.depth_from_force(force, **elastic) == pytest.approx(depth, rel=1e-11)


@pytest.mark.parametrize(("base", "nu", "ratio"), STATES[1::2])
def test_a_flat_punch_puts_the_surface_at_its_face(base: str, nu: float, ratio: float) -> None:
    found, given = solved("flat_punch", base, nu, ratio)
    elastic = {**given, "E_star": 1.0, "base": base}
    with mp.workdps(DIGITS + 10):
        force, pressure = float(found.force()), float(found.value(nt.p))
    assert flat_punch.force(0.2, **elastic) == pytest.approx(force, rel=1e-12)
    assert flat_punch.pressure(0.3 * given["a"], 0.2, **elastic) == pytest.approx(pressure, rel=1e-11)
    assert flat_punch.depth_from_force(force, **elastic) == pytest.approx(0.2, rel=1e-12)


@pytest.mark.parametrize("base", stated.BASES)
def test_the_closed_share_is_that_of_navier(base: str) -> None:
    """L derived, against the equations integrated through the thickness, and 1 - L as the functions have it."""
    u = sp.Symbol("u", positive=True)
    with mp.workdps(30):
        for nu, k in ((sp.Rational(1, 2), "0.3"), (sp.Rational(3, 10), "2"), (sp.S.Zero, "9")):
            closed = stated.sinking(u, base).subs(nt.nu, nu)
            exact = sp.lambdify(u, closed, "mpmath")(mp.mpf(k))
            assert abs(exact - sinking(mp.mpf(k), mp.mpf(str(nu.evalf(30))), base)) < mp.mpf(10) ** -28
            assert runtime.STIFFER[base](np.float64(k), float(nu)) == pytest.approx(float(1 - exact), rel=1e-14)


def test_the_share_is_that_of_the_literature() -> None:
    """Bonded: (2 k sinh 2u - 4 u)/(2 k cosh 2u + 4 u^2 + 1 + k^2), k = 3 - 4 nu; frictionless."""
    u = sp.Symbol("u", positive=True)
    k = 3 - 4 * nt.nu
    bonded = (2 * k * sp.sinh(2 * u) - 4 * u) / (2 * k * sp.cosh(2 * u) + 4 * u**2 + 1 + k**2)
    sliding = (sp.cosh(2 * u) - 1) / (sp.sinh(2 * u) + 2 * u)
    for base, known in zip(stated.BASES, (bonded, sliding), strict=True):
        assert sp.simplify((stated.sinking(u, base) - known).rewrite(sp.exp)) == 0


FORCES = ((0.2, 1.26977), (0.5, 1.85712), (1.0, 3.37110), (2.0, 8.46801))
"""Contact radius over thickness, and force over that on a half-space of the same depth: bonded, nu = 1/2."""


@pytest.mark.parametrize(("a", "share"), FORCES)
def test_the_force_of_a_sphere_at_a_depth(a: float, share: float) -> None:
    depth = paraboloid.depth(a, R=1.0, nu=0.5, thickness=1.0)
    force = paraboloid.force_from_depth(depth, R=1.0, E_star=1.0, nu=0.5, thickness=1.0)
    assert force / half_space.force_from_depth(depth, R=1.0, E_star=1.0) == pytest.approx(share, abs=5e-6)


M_0 = {0.5: 1.770217, 0.3: 1.376854, 0.0: 1.211062}
"""The integral of 1 - L over u, bonded."""


@pytest.mark.parametrize("nu", M_0)
def test_first_and_second_order(nu: float) -> None:
    """d = g - m_0 F/(pi E* h) with F as it is; a paraboloid to the order of e = a/h behind."""
    u, weights = runtime._waves(nu, "bonded", 64)
    m_0, m_2 = (float(np.pi / 2.0 * np.sum(weights * u**power)) for power in (0, 2))
    assert m_0 == pytest.approx(M_0[nu], abs=5e-7)
    e = 0.02
    force, depth = (4.0 / 3.0 * e**3, e**2)
    found = cone.force(e, theta=0.3, E_star=1.0, nu=nu, thickness=1.0), cone.depth(e, theta=0.3, nu=nu, thickness=1.0)
    assert found[0] == pytest.approx(np.pi / 2.0 * np.tan(0.3) * e**2, rel=10.0 * e**3)
    assert found[1] == pytest.approx(np.pi / 2.0 * np.tan(0.3) * e - m_0 / np.pi * found[0], rel=10.0 * e**3)
    k_0, k_1, less = 2.0 * m_0 / np.pi, m_2 / np.pi, 1.0 - 2.0 / 3.0 * m_2 / np.pi * e**3
    wanted = force / less, depth * (1.0 - 2.0 / 3.0 * k_0 * e + 2.0 / 15.0 * k_1 * e**3) / less
    assert paraboloid.force(e, R=1.0, E_star=1.0, nu=nu, thickness=1.0) == pytest.approx(wanted[0], rel=10.0 * e**5)
    assert paraboloid.depth(e, R=1.0, nu=nu, thickness=1.0) == pytest.approx(wanted[1], rel=10.0 * e**5)


@pytest.mark.parametrize(("name", "known"), [("cone", {"theta": 0.3}), ("power_law", {"A": 1.0, "n": 3.5})])
@pytest.mark.parametrize(("base", "nu"), [("bonded", 0.5), ("frictionless", 0.2)])
def test_what_an_expansion_leaves_out(name: str, known: dict[str, float], base: str, nu: float) -> None:
    """Half the radius is wrong by an eighth of the share, and to the second order by the fifth power of that."""
    module, given = import_module(f"axicontact.layer.{name}"), {**known, "nu": nu, "thickness": 1.0, "base": base}
    found = {}
    for a in (0.05, 0.025):
        depth, force = module.depth(a, **given), module.force(a, **given, E_star=2.0)
        found[a] = {
            3: module.depth_first_order(a, **given) / depth - 1.0,
            5: module.depth_second_order(a, **given) / depth - 1.0,
            -5: module.force_second_order(a, **given, E_star=2.0) / force - 1.0,
        }
    for order, share in found[0.05].items():
        assert np.log2(share / found[0.025][order]) == pytest.approx(abs(order), abs=0.4)
    ends = module.depth_second_order(np.array([0.0, -1.0]), **given)
    assert ends[0] == 0.0
    assert np.isnan(ends[1])
    several = given | {"nu": np.array([[0.1], [nu]])}
    grid = module.depth_first_order(np.array([0.05, 0.025]), **several)
    assert grid[1].tolist() == pytest.approx([module.depth_first_order(a, **given) for a in found], rel=1e-14)


def test_what_is_shown_says_what_its_letters_stand_for() -> None:
    """Once, under the first formula that has them, and again with adhesion, where another spring is the last one.

    An equation for the radius is none of its values.
    """
    whole = shown(catalogue(), "layer.paraboloid", "text")
    assert whole.count("q(t) = d - g(t) + Integral(K(t, s)*q(s), (s, 0, a)), zero at t = a") == 1
    assert whole.count("(s, 0, a)), -sqrt(2)*sqrt(pi)*sqrt(a)*sqrt(dgamma)/sqrt(E_star) at t = a") == 1
    assert whole.count("K(t, s) = 2*Integral((1 - L(u))*") == 2
    assert "m_0 = Integral(1 - L(u), (u, 0, oo))" in whole
    assert "a from g(a) - Integral(K(a, t)*q(t), (t, 0, a)) = d" in whole
    assert "integral equation, solved in numbers" in shown(catalogue(), "paraboloid.lay.d", "text")


def test_published_series_beside_the_solution() -> None:
    """(1, k_0, 7/6 k_0^2, 40/27 k_0^3 - 8/15 k_1, 143/72 k_0^4 - 8/5 k_0 k_1) in powers of chi, and the table."""
    own = printed.moments(0.5)
    k_0, k_1 = 2 / mp.pi * own[stated.m_0], own[stated.m_2] / mp.pi
    wanted = (1, k_0, 7 * k_0**2 / 6, 40 * k_0**3 / 27 - 8 * k_1 / 15, 143 * k_0**4 / 72 - 8 * k_0 * k_1 / 5)
    found = [float(c.subs(own)) for c in printed.coefficients()]
    assert found == pytest.approx([float(c) for c in wanted], rel=1e-12)
    shares = {float(ratio): float(share) for (ratio, _, share), _ in printed.compared()}
    both = [ratio for ratio, _ in FORCES if ratio in shares]
    assert len(both) == 3
    assert [shares[ratio] for ratio in both] == pytest.approx([dict(FORCES)[ratio] for ratio in both], abs=1e-4)
    for nu, wanted in M_0.items():
        assert float(printed.moments(nu)[stated.m_0]) == pytest.approx(wanted, abs=1e-6)


def test_far_from_the_base_it_is_a_half_space() -> None:
    given = {"R": 1.0, "E_star": 1.0, "nu": 0.3, "thickness": 1e9}
    assert paraboloid.force_from_depth(0.1, **given) == pytest.approx(
        half_space.force_from_depth(0.1, R=1.0, E_star=1.0), rel=1e-8
    )


def test_thin_layers() -> None:
    """On a frictionless base columns of modulus E*/h; bonded and incompressible the volume that is pressed out is 0."""
    thin = {"R": 1.0, "nu": 0.3, "thickness": 0.05, "base": "frictionless"}
    assert paraboloid.depth(1.0, **thin) == pytest.approx(1.0 / 2.0, rel=0.05)
    assert paraboloid.force(1.0, **thin, E_star=1.0) == pytest.approx(np.pi / (4.0 * 0.05), rel=0.1)
    # that one is approached with the first power of the thickness
    bonded = [paraboloid.depth(1.0, R=1.0, nu=0.5, thickness=h) for h in (0.05, 0.1)]
    assert 2.0 * bonded[0] - bonded[1] == pytest.approx(1.0 / 4.0, rel=0.02)


def test_arrays_are_the_numbers() -> None:
    given = {"R": 1.0, "E_star": 1.0, "nu": 0.3, "thickness": 0.7}
    radii = np.linspace(0.0, 1.2, 7)
    along = paraboloid.pressure(radii, 1.0, **given)
    assert along.tolist() == pytest.approx([paraboloid.pressure(float(r), 1.0, **given) for r in radii], rel=1e-13)
    assert along[-1] == 0.0
    grid = paraboloid.force(radii[1:, None], **(given | {"thickness": np.array([0.5, 2.0])}))
    assert grid.shape == (6, 2)
    assert grid[3, 1] == pytest.approx(paraboloid.force(float(radii[4]), **(given | {"thickness": 2.0})), rel=1e-14)
    assert np.isnan(paraboloid.depth(-1.0, R=1.0, nu=0.3, thickness=1.0))
    assert paraboloid.depth(0.0, R=1.0, nu=0.3, thickness=1.0) == 0.0


def test_without_a_load_the_contact_is_the_flat_face() -> None:
    given = {"R": 1.4, "b": 0.5, "nu": 0.3, "thickness": 0.7}
    assert (
        rounded_punch.radius_from_depth(0.0, **given)
        == rounded_punch.radius_from_force(0.0, **given, E_star=1.0)
        == 0.5
    )
    assert rounded_punch.force_from_depth(0.0, **given, E_star=1.0) == 0.0
    assert paraboloid.radius_from_depth(0.0, R=1.0, nu=0.3, thickness=1.0) == 0.0


def test_units_of_any_size() -> None:
    """A nanometre and a light year, without a warning."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for unit in (1e-9, 1e16, 1e-120):
            depth = paraboloid.depth(unit, R=10.0 * unit, nu=0.5, thickness=unit)
            assert depth / unit == pytest.approx(paraboloid.depth(1.0, R=10.0, nu=0.5, thickness=1.0), rel=1e-12)


def test_bad_input_is_named() -> None:
    with pytest.raises(ValueError, match="base = 'glued' must be 'bonded' or 'frictionless'"):
        paraboloid.depth(1.0, R=1.0, nu=0.3, thickness=1.0, base="glued")
    with pytest.raises(ValueError, match="a = 25.0, thickness = 1.0: a <= 20 thickness is violated"):
        paraboloid.depth(25.0, R=1.0, nu=0.3, thickness=1.0)
    with pytest.raises(ValueError, match="above 20 thickness"):
        paraboloid.radius_from_depth(1e6, R=1.0, nu=0.3, thickness=1.0)
    with pytest.raises(ValueError, match="nu = 0.6"):
        paraboloid.depth(1.0, R=1.0, nu=0.6, thickness=1.0)


def test_refusals_say_what_to_use() -> None:
    for name in COMPLETE_NAMES:
        assert (stated.refusal(load(name)) == "") == (name == "flat_punch")
        assert name == "flat_punch" or "use flat_punch" in stated.refusal(load(name))


@pytest.mark.slow
def test_a_wrong_formula_fails() -> None:
    """With the sign of its integral turned: a layer that is softer than the half-space, a force that pulls.

    Of an expansion with sums over waves that are larger by a thousandth.
    """
    wrong = {}
    for suffix, entry in stated.derive(load("paraboloid")).items():
        (case,) = entry.cases
        turned = case.expr.replace(sp.Integral, lambda *given: -sp.Integral(*given))
        turned = turned.subs({m: sp.Rational(1001, 1000) * m for m in stated.MOMENTS})
        wrong[suffix] = replace(entry, cases=(replace(case, expr=turned),))
    found = check_problem(problem("paraboloid.lay"), wrong, digits=50, points=8, seed=17)
    assert {check.key for check in found if check.outcome == "failed"} == {entry.key for entry in wrong.values()}
