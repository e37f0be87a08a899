"""Numbers of fields below the surface as entries: which are proved, that false ones are not, and what ties them."""

from __future__ import annotations

import random
from dataclasses import replace
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from false_entries import with_formula
from selected import few
from test_interface import PARAMETERS
from test_mutations import differs, flipped_sign, wrong_exponent, wrong_factor

from axiderive import notation as nt
from axiderive.abel.field_moments import Moments, kernel
from axiderive.oracle.evaluate import case_at, evaluated
from axiderive.physics import systems
from axiderive.profiles.pools import ROUND
from axiderive.proof.certificate import certify, certify_profile

ELEMENTARY = (
    "cone", "paraboloid", "quartic", "sextic", "flat_punch", "capped_cylinder", "concave_paraboloid", "concave_quartic",
)  # fmt: skip
QUICK = ("cone", "flat_punch", "capped_cylinder", "concave_paraboloid")


def entries(name: str) -> dict[str, Any]:
    return systems.problem(f"{name}.sub").derive()


def test_every_profile_has_all_numbers_and_polynomial_slopes_need_no_integral() -> None:
    closed = set()
    for name in ROUND.names:
        found = entries(name)
        assert set(found) == {"W", *(f"{letter}{m}" for letter in "SD" for m in range(4))}
        if all(entry.status == "closed" for entry in found.values()):
            closed.add(name)
        else:
            assert {entry.status for entry in found.values()} == {"integral"}
    assert closed == set(ELEMENTARY)


@pytest.mark.parametrize("name", few(ELEMENTARY, QUICK, pytest.mark.slow))
def test_elementary_numbers_are_certified(name: str) -> None:
    found = certify_profile(ROUND.load(name), entries(name))
    assert not [own.reason for own in found.values() if not own.proved]


@pytest.mark.parametrize("name", few(ELEMENTARY, QUICK, pytest.mark.slow))
def test_a_formula_with_one_error_is_not_certified(name: str) -> None:
    dice, profile, true = random.Random(name), ROUND.load(name), entries(name)
    for suffix, entry in true.items():
        for change in (flipped_sign, wrong_factor, wrong_exponent):
            index = dice.randrange(len(entry.cases))
            wrong = change(entry.cases[index].expr, dice)
            if wrong is None or not differs(wrong, entry.cases[index]):
                continue
            false = with_formula(entry, index, wrong)
            assert not certify(profile, {**true, suffix: false}, suffix).proved, (suffix, change.__name__, wrong)


def test_what_stands_beside_a_formula_is_not_certified_if_it_is_another() -> None:
    profile, true = ROUND.load("cone"), entries("cone")
    loss = true["D1"]
    for false in (
        replace(loss, definition=true["D2"].definition),
        replace(loss, cases=(*loss.cases, *loss.cases)),
        replace(loss, cases=true["S1"].cases),
        replace(loss, cases=tuple(replace(case, expr=case.expr.subs(nt.a, nt.R)) for case in loss.cases)),
        replace(loss, parameters=()),
    ):
        assert not certify(profile, {**true, "D1": false}, "D1").proved
    assert not certify(profile, {**true, "S1": replace(true["S1"], cases=true["S2"].cases)}, "D1").proved


@pytest.mark.parametrize(("j", "m"), [(0, 0), (0, 3), (1, 0), (2, 1), (4, 3)])
def test_moments_are_integrals_of_the_field_of_a_punch(j: int, m: int) -> None:
    values = {nt.r: sp.Rational(7, 10), nt.z: sp.Rational(2, 5), nt.a: sp.Rational(13, 10)}
    moment = Moments()(j, m)
    with mp.workdps(40):
        r, z, a = (mp.mpf(x.p) / x.q for x in values.values())

        def field(t: Any) -> Any:
            rho = mp.sqrt(z + 1j * (t - r)) * mp.sqrt(z + 1j * (t + r))
            return (r / (rho + z + 1j * t)) ** m / rho

        wanted = mp.quad(lambda t: t**j * field(t), [0, r, a])
        assert abs(evaluated(moment.real.expr(), values) - wanted.real) < 1e-35
        assert abs(evaluated(moment.imaginary.expr(), values) - wanted.imag) < 1e-35
        assert abs(evaluated(kernel(m, nt.a).imaginary.expr(), values) - field(a).imag) < 1e-35


REGIONS = {
    "around": (lambda dice: (dice.uniform(0, 2.5), dice.uniform(0.01, 2.5)), 1e-14),
    "edge": (lambda dice: _beside(dice, 10 ** dice.uniform(-9, -2)), 6e-14),
    "near the surface": (lambda dice: (dice.uniform(0.05, 0.9), 10 ** dice.uniform(-9, -2)), 2e-14),
    "far": (lambda dice: (10 ** dice.uniform(1, 5), 10 ** dice.uniform(1, 5)), 2e-14),
}
"""Points in radii of the contact by region, and the greatest error over the largest component of the stress."""


def _beside(dice: random.Random, distance: float) -> tuple[float, float]:
    angle = dice.uniform(0.01, np.pi - 0.01)
    return 1 + distance * np.cos(angle), distance * np.sin(angle)


def stress_of(found: dict[str, Any], nu: Any) -> list[Any]:
    """rr, tt, zz and rz over E_star/pi."""
    mean = (found["D0"] - (1 + 2 * nu) * found["S0"]) / 2
    half = ((1 - 2 * nu) * found["S2"] - found["D2"]) / 2
    return [mean + half, mean - half, -found["S0"] - found["D0"], -found["D1"]]


@pytest.mark.parametrize("region", REGIONS)
@pytest.mark.parametrize("name", few(ELEMENTARY[:6], ["cone", "quartic", "flat_punch"], pytest.mark.slow))
def test_emitted_stresses_have_the_digits_of_the_formulas(name: str, region: str) -> None:
    draw, bound = REGIONS[region]
    dice, module, geometry = (
        random.Random(f"{name} {region}"),
        import_module(f"axicontact.subsurface.{name}"),
        PARAMETERS[name],
    )
    true, given, radius = entries(name), 0.9, geometry.get("a", 0.9)
    symbols = {str(symbol): symbol for symbol in (*ROUND.load(name).parameters, nt.r, nt.z, nt.a, nt.d)}
    for _ in range(6):
        r, z = (radius * x for x in draw(dice))
        values = {symbols[n]: sp.Rational(x) for n, x in {**geometry, "r": r, "z": z}.items()}
        values |= {nt.a: sp.Rational(radius), nt.d: sp.Rational(given)}
        with mp.workdps(120):
            exact = {s: evaluated(case_at(entry, values).expr, values) for s, entry in true.items()}
            wanted = [mp.mpf(1.3) / mp.pi * x for x in stress_of(exact, mp.mpf(0.3))]
            found = module.stress(r, z, given, E_star=1.3, nu=0.3, **geometry)
            error = max(abs(mp.mpf(x) - own) for x, own in zip(found, wanted, strict=True)) / max(map(abs, wanted))
            assert error < bound, (r, z, mp.nstr(error, 3))
            sunk = 2 * exact["W"] / mp.pi + values[nt.z] * exact["S0"] / (mp.mpf("0.7") * mp.pi)
            assert abs(module.displacement(r, z, given, nu=0.3, **geometry).z / sunk - 1) < 2e-14
