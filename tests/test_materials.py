"""Effective moduli, and h_N of the graded half-space against a solution of its equations of equilibrium.

The modulus of transverse isotropy against Barnett and Lothe's integral; Tabor's number against the retraction at
pull-off, Maugis' parameter against the attraction of Lennard-Jones.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from physics_package import emitted, positional, public

from axicontact.adhesive import paraboloid
from axiderive import notation as nt
from axiderive.checks import materials as constants
from axiderive.checks.comparison import Comparison
from axiderive.checks.units import Units
from axiderive.code import example
from axiderive.entry import Case
from axiderive.oracle.half_space import surface_compliance
from axiderive.physics import materials
from axiderive.profiles.pools import ELASTIC

HALF_SPACES = tuple((k, nu) for k in ("-0.999999", "-0.5", "0.01", "0.7", "0.999999") for nu in ("-0.9", "0.3", "0.5"))
KERNEL = 2e-15


def test_interface() -> None:
    functions = {key: positional(signature) for key, signature in public(emitted("materials")).items()}
    assert functions == {
        "effective_modulus": ["E_1", "nu_1", "E_2", "nu_2"],
        "effective_shear_modulus": ["E_1", "nu_1", "E_2", "nu_2"],
        "graded_modulus": ["E_0", "c_0", "k", "nu"],
        "h_N": ["k", "nu"],
        "transversely_isotropic_modulus": ["C_11", "C_33", "C_13", "C_44"],
        "effective_radius": ["R_1", "R_2"],
        "tabor": ["R", "E_star", "dgamma", "z_0"],
        "maugis_lambda": ["R", "E_star", "dgamma", "sigma_0"],
    }
    assert {entry.quantity.function for entry in materials.derive().values()} == set(functions)


def test_entries_have_the_dimension_of_their_symbol() -> None:
    for entry in materials.derive().values():
        found = Units().dimension(entry.cases[0].expr)
        assert found == nt.describe(entry.quantity.symbol).dimension, entry.key


def test_two_bodies() -> None:
    module = emitted("materials")
    assert module.effective_modulus(1.0, 0.5, math.inf, 0.3) == pytest.approx(4 / 3, rel=1e-15, abs=0.0)
    assert module.effective_shear_modulus(1.0, 0.5, math.inf, 0.3) == pytest.approx(2 / 2.25, rel=1e-15, abs=0.0)
    # the surface of an incompressible half-space is 8/9 times as stiff sideways: (4 G/(2 - nu))/(2 G/(1 - nu))
    same = (2.0, 0.3, 2.0, 0.3)
    ratio = module.effective_shear_modulus(*same) / module.effective_modulus(*same)
    assert ratio == pytest.approx(2 * 0.7 / 1.7, rel=1e-15, abs=0.0)


@pytest.mark.parametrize(("k", "nu"), HALF_SPACES)
def test_module_is_the_entry(k: str, nu: str) -> None:
    module = emitted("materials")
    known = {
        nt.k: sp.Rational(float(k)),
        nt.nu: sp.Rational(float(nu)),
        nt.E_0: sp.Integer(3),
        nt.c_0: sp.Rational(1, 2),
    }
    entry = materials.derive()["H"]
    known |= {symbol: expr.subs(known) for symbol, expr in entry.profile.abbreviations}
    expected = float(example.number(entry.cases[0].expr, known))
    assert module.graded_modulus(3.0, 0.5, float(k), float(nu)) == pytest.approx(expected, rel=KERNEL, abs=0.0)


def test_homogeneous_limit_is_exact() -> None:
    entry = materials.derive()["h_N"]
    assert entry.cases[0].expr.subs(nt.beta, entry.profile.abbreviations[0][1]).subs(nt.k, 0) == 1
    np.testing.assert_allclose(emitted("materials").h_N(0.0, [-0.5, 0.0, 0.3, 0.5]), 1.0, rtol=1e-15)


def barnett_lothe(C_11: mp.mpf, C_33: mp.mpf, C_13: mp.mpf, C_44: mp.mpf) -> mp.mpf:
    """L_33 = -1/pi int_0^pi N_3 of a transversely isotropic solid, by elements of N_3 = R T^-1 R^T - Q in the plane.

    A line load moves the surface by 1/L_33, which is 2/E* of the isotropic solid.
    """

    def turned(angle: mp.mpf) -> mp.mpf:
        c, s = mp.cos(angle), mp.sin(angle)

        # of vectors m = (c, s) and n = (-s, c): Q = (mm), R = (mn), T = (nn)
        def product(a: tuple[mp.mpf, mp.mpf], b: tuple[mp.mpf, mp.mpf]) -> mp.matrix:
            across = C_13 * a[0] * b[1] + C_44 * a[1] * b[0]
            return mp.matrix(
                [
                    [C_11 * a[0] * b[0] + C_44 * a[1] * b[1], across],
                    [C_13 * a[1] * b[0] + C_44 * a[0] * b[1], C_44 * a[0] * b[0] + C_33 * a[1] * b[1]],
                ]
            )

        m, n = (c, s), (-s, c)
        mixed = product(m, n)
        return (mixed * mp.inverse(product(n, n)) * mixed.T - product(m, m))[1, 1]

    return -mp.quad(turned, mp.linspace(0, mp.pi, 9)) / mp.pi


SOLIDS = (
    # zinc, graphite, and one that grows wider when it is drawn out along its axis
    ("165", "61.8", "50", "39.6"),
    ("1060", "36.5", "15", "4.5"),
    ("1", "8", "-1.5", "2.5"),
)


@pytest.mark.parametrize("constants", SOLIDS)
def test_transverse_isotropy_by_the_integral_of_barnett_and_lothe(constants: tuple[str, ...]) -> None:
    with mp.workdps(30):
        wanted = 2 * barnett_lothe(*map(mp.mpf, constants))
    found = emitted("materials").transversely_isotropic_modulus(*map(float, constants))
    assert found == pytest.approx(float(wanted), rel=1e-14, abs=0.0)


@pytest.mark.parametrize("nu", [-0.9, 0.0, 0.3, 0.49])
def test_an_isotropic_solid_has_its_effective_modulus(nu: float) -> None:
    shear, first = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))
    wide = first + 2 * shear
    found = emitted("materials").transversely_isotropic_modulus(wide, wide, first, shear)
    assert found == pytest.approx(1 / (1 - nu**2), rel=1e-13, abs=0.0)


def test_effective_radius() -> None:
    """Two balls, a ball on a plane, in a cup, and in one that is as wide as it but for a rounding."""
    radius = emitted("materials").effective_radius
    assert radius(3.0, 6.0) == 2.0
    assert radius(3.0, math.inf) == radius(math.inf, 3.0) == 3.0
    assert radius(3.0, -4.0) == pytest.approx(12.0, rel=1e-15, abs=0.0)
    one, cup = 0.1, -math.nextafter(0.1, 1.0)
    exact = 1 / (1 / Fraction(one) + 1 / Fraction(cup))
    assert radius(one, cup) == pytest.approx(float(exact), rel=1e-15, abs=0.0)


def test_tabor_compares_the_retraction_at_pull_off_with_the_range_of_adhesion() -> None:
    """(2 pi)**(1/2) (9 pi/8)**(1/6) = 3.094, whatever the paraboloid."""
    for R, E_star, dgamma in ((1e-6, 1e9, 0.05), (2.0, 3.0, 0.7)):
        own = {"E_star": E_star, "dgamma": dgamma}
        retraction = paraboloid.retraction(paraboloid.pull_off(R=R, **own).radius, **own)
        number = emitted("materials").tabor(R, E_star, dgamma, 2e-10)
        assert retraction / (number * 2e-10) == pytest.approx(3.0937, abs=5e-5)


def test_maugis_and_tabor_of_lennard_jones() -> None:
    """The greatest attraction 8 dgamma/(3 z_0) ((z_0/z)**3 - (z_0/z)**9) is the stress of Maugis: 1.157 mu_T."""
    R, E_star, dgamma, z_0 = 1e-6, 1e9, 0.05, 2e-10

    def attraction(z: float) -> float:
        return 8 * dgamma / (3 * z_0) * ((z_0 / z) ** 3 - (z_0 / z) ** 9)

    work = mp.quad(attraction, [z_0, 3 * z_0, mp.inf])
    assert float(work) == pytest.approx(dgamma, rel=1e-10)
    strongest = max(attraction(z_0 * (1 + step / 10000)) for step in range(1, 10000))
    module = emitted("materials")
    ratio = module.maugis_lambda(R, E_star, dgamma, strongest) / module.tabor(R, E_star, dgamma, z_0)
    assert ratio == pytest.approx(1.157, abs=5e-4)


def test_incompressible_half_space_of_gibson_is_a_foundation_of_winkler() -> None:
    """G = m z: w = p/(2 m), so that H = 2 pi m with m = E_0/(3 c_0)."""
    assert emitted("materials").graded_modulus(3.0, 2.0, 1 - 1e-9, 0.5) == pytest.approx(math.pi, rel=1e-7)


def test_half_space_is_that_of_boussinesq_as_the_grading_vanishes() -> None:
    """A pressure p J0(x) moves it by 2 (1 - nu**2) p/E; the difference is of order k."""
    nu = mp.mpf("0.3")
    for k in (mp.mpf("1e-12"), -mp.mpf("1e-12")):
        assert abs(surface_compliance(k, nu, 20) / (2 * (1 - nu**2)) - 1) < 1e-11


@pytest.mark.parametrize("suffix", sorted(materials.QUANTITIES))
def test_constants_are_those_of_their_definitions(suffix: str) -> None:
    """h_N, and H with it, by the point force on the half-space."""
    evidence = constants.check(Comparison(ELASTIC, materials.derive(), digits=40, points=6), suffix)
    assert evidence.passed
    assert evidence.digits == 40


@pytest.mark.parametrize(
    "wrong",
    [
        lambda e: e * (1 + sp.Rational(1, 10**30)),
        lambda e: e.subs(sp.gamma(1 + nt.k / 2), sp.gamma(1 + nt.k)),
        lambda e: e.subs(nt.beta, -nt.beta / 2),
        lambda e: e * (1 + nt.k),
    ],
)
def test_a_wrong_h_N_is_refused(wrong: Callable[[sp.Expr], sp.Expr]) -> None:
    entry = materials.derive()["h_N"]
    changed = replace(entry, cases=(Case((), wrong(entry.cases[0].expr)),))
    evidence = constants.check(Comparison(entry.profile, {"h_N": changed}, digits=40, points=2), "h_N")
    assert evidence.outcome == "failed"
