"""Adhesion on a layer: the energy of its edge, its limits, and a wrong retraction."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from axicontact.adhesive import paraboloid as adhesive
from axicontact.layer import flat_punch, paraboloid
from axiderive import notation as nt
from axiderive.checks.checks import check_problem
from axiderive.oracle.half_space import HalfSpace
from axiderive.oracle.layer import layer
from axiderive.physics import layer as stated
from axiderive.physics.systems import problem
from axiderive.profiles import load

DIGITS = 18


@pytest.mark.parametrize(
    ("base", "nu", "ratio"),
    [
        ("frictionless", 0.3, 0.5),
        *(pytest.param(*own, marks=pytest.mark.slow) for own in (("bonded", 0.5, 0.25), ("bonded", 0.5, 3.0))),
    ],
)
def test_the_surface_is_where_the_indenter_is(base: str, nu: float, ratio: float) -> None:
    """By collocation; measured 3e-15 at worst."""
    values = {nt.R: sp.Integer(2), nt.a: sp.S.One, nt.E_star: sp.S.One, nt.dgamma: sp.Rational(1, 64)}
    values |= {nt.nu: sp.Rational(nu), stated.thickness: 1 / sp.Rational(ratio)}
    with mp.workdps(DIGITS + 10):
        found = layer(HalfSpace(load("paraboloid"), values, DIGITS, graded=False), base, adhesive=True)
        wanted = [float(own) for own in (found.depth, found.force(), found.pressure(mp.mpf("0.75")))]
    given = {"R": 2.0, "E_star": 1.0, "nu": nu, "thickness": 1.0 / ratio, "dgamma": 1.0 / 64.0, "base": base}
    own = paraboloid.adhesive_depth(1.0, **given), paraboloid.adhesive_force(1.0, **given)
    assert [*own, paraboloid.adhesive_pressure(0.75, 1.0, **given)] == pytest.approx(wanted, rel=2e-14)


def test_the_edge_releases_the_energy_of_its_separation() -> None:
    """U(a, d) is the work of pressing in up to a, and of the punch of radius a from there: dU/da = 2 pi a dgamma."""
    given, moduli = {"nu": 0.3, "thickness": 2.0, "base": "frictionless"}, {"E_star": 1.3}
    a, dgamma, (nodes, weights) = 1.1, 0.02, np.polynomial.legendre.leggauss(6)
    d = paraboloid.adhesive_depth(a, R=1.6, dgamma=dgamma, **given, **moduli)

    def punch(radius: float, depth: float) -> tuple[float, float, float]:
        pressed = paraboloid.depth(radius, R=1.6, **given)
        force = paraboloid.force(radius, R=1.6, **given, **moduli)
        stiffness = flat_punch.force(1.0, a=radius, **given, **moduli)
        moved = depth - pressed
        return pressed, force * moved + stiffness * moved**2 / 2.0, force + stiffness * moved

    def slope(step: float) -> float:
        (low, before, _), (high, after, _) = (punch(a + sign * step, d) for sign in (-1.0, 1.0))
        depths = (low + high + (high - low) * nodes) / 2.0
        pressed = weights @ paraboloid.force_from_depth(depths, R=1.6, **given, **moduli) * (high - low) / 2.0
        return float(after - before + pressed) / (2.0 * step)

    rates = [slope(0.04 / 2**i) for i in range(4)]
    for i in range(1, 4):
        rates = [(4**i * fine - coarse) / (4**i - 1) for coarse, fine in pairwise(rates)]
    assert rates[0] == pytest.approx(2.0 * np.pi * a * dgamma, rel=1e-11)
    # the force is the one at which that state is held
    force = paraboloid.adhesive_force(a, R=1.6, dgamma=dgamma, **given, **moduli)
    assert force == pytest.approx(punch(a, d)[2], rel=1e-13)


def test_adhesion_on_a_thick_layer_and_without_its_work() -> None:
    thick = {"R": 1.6, "E_star": 1.3, "nu": 0.3, "thickness": 1e9}
    calls = {"depth": (1.0,), "force": (1.0,), "pressure": (0.4, 1.0)}
    for name, fields in calls.items():
        own, plain = (getattr(paraboloid, f"{word}{name}") for word in ("adhesive_", ""))
        wanted = getattr(adhesive, name)(*fields, R=1.6, E_star=1.3, dgamma=0.02)
        assert own(*fields, **thick, dgamma=0.02) == pytest.approx(wanted, rel=1e-8)
        thin = thick | {"thickness": 0.7}
        bare = {key: value for key, value in thin.items() if key != "E_star" or name != "depth"}
        assert own(*fields, **thin, dgamma=0.0) == plain(*fields, **bare)


def test_the_pressure_with_adhesion_is_summed_to_its_force() -> None:
    """p 2 pi r dr with r**2 = a**2 - s**2, at whose end the tension is no longer singular."""
    given = {"R": 1.6, "E_star": 1.3, "nu": 0.45, "thickness": 0.8, "dgamma": 0.02}
    nodes, weights = np.polynomial.legendre.leggauss(24)
    s = 0.5 * (1.0 + nodes)
    summed = 0.5 * weights @ (2.0 * np.pi * s * paraboloid.adhesive_pressure(np.sqrt(1.0 - s**2), 1.0, **given))
    assert summed == pytest.approx(paraboloid.adhesive_force(1.0, **given), rel=1e-12)
    assert paraboloid.adhesive_pressure(1.1, 1.0, **given) == 0.0
    assert paraboloid.adhesive_pressure(1.0, 1.0, **given) == -np.inf


@pytest.mark.slow
def test_a_wrong_retraction_fails() -> None:
    """Half the work in the depth; in force and pressure the spring at the edge is that of the surface."""
    wrong = {}
    for suffix, entry in stated.derive(load("paraboloid")).items():
        (case,) = entry.cases
        expr = case.expr.subs(nt.dgamma, nt.dgamma / 2).subs(stated.SPRING(nt.a), sp.S.Zero)
        if expr != case.expr:
            wrong[suffix] = replace(entry, cases=(replace(case, expr=expr),))
    assert wrong.keys() == {"dadh", "padh"}
    entries = stated.derive(load("paraboloid")) | wrong
    found = check_problem(problem("paraboloid.lay"), entries, digits=50, points=8, seed=17)
    assert {check.key for check in found if check.outcome == "failed"} == {entry.key for entry in wrong.values()}
