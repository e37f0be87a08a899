"""Effective moduli, and h_N of the graded half-space against a solution of its equations of equilibrium."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from physics_package import emitted, positional, public

from axiderive import notation as nt
from axiderive.checks import materials as constants
from axiderive.checks.comparison import Comparison
from axiderive.checks.units import Units
from axiderive.code import example
from axiderive.entry import Case
from axiderive.oracle.half_space import surface_compliance
from axiderive.physics import materials
from axiderive.proof.rules import materials as proof

HALF_SPACES = tuple((k, nu) for k in ("-0.999999", "-0.5", "0.01", "0.7", "0.999999") for nu in ("-0.9", "0.3", "0.5"))
KERNEL = 2e-15


def test_interface() -> None:
    functions = {key: positional(signature) for key, signature in public(emitted("materials")).items()}
    assert functions == {
        "effective_modulus": ["E_1", "nu_1", "E_2", "nu_2"],
        "effective_shear_modulus": ["E_1", "nu_1", "E_2", "nu_2"],
        "graded_modulus": ["E_0", "c_0", "k", "nu"],
        "h_N": ["k", "nu"],
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


def test_incompressible_half_space_of_gibson_is_a_foundation_of_winkler() -> None:
    """G = m z: w = p/(2 m), so that H = 2 pi m with m = E_0/(3 c_0)."""
    assert emitted("materials").graded_modulus(3.0, 2.0, 1 - 1e-9, 0.5) == pytest.approx(math.pi, rel=1e-7)


def test_half_space_is_that_of_boussinesq_as_the_grading_vanishes() -> None:
    """A pressure p J0(x) moves it by 2 (1 - nu**2) p/E; the difference is of order k."""
    nu = mp.mpf("0.3")
    for k in (mp.mpf("1e-12"), -mp.mpf("1e-12")):
        assert abs(surface_compliance(k, nu, 20) / (2 * (1 - nu**2)) - 1) < 1e-11


@pytest.mark.parametrize("suffix", ["E_star", "G_star", "H", "h_N"])
def test_constants_are_those_of_their_definitions(suffix: str) -> None:
    """h_N, and H with it, by the point force on the half-space."""
    evidence = constants.check(Comparison(proof.PROFILE, materials.derive(), digits=40, points=6), suffix)
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
