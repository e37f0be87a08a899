"""What follows from depth, force and pressure: the load within a radius and the elastic energy.

Their certificates rest on rates in a, their evidence on springs.  Here they are sums of the published pressure and
force, which share neither, and false formulas show that both say no.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import import_module
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp

from axicontact.normal import cone, paraboloid, rounded_punch, sphere
from axiderive.checks import quadrature
from axiderive.checks.comparison import Comparison
from axiderive.code.example import POLYNOMIAL, numbers
from axiderive.letters import name_of
from axiderive.notation import E_star, R, a, b, coefficients, d, r
from axiderive.physics.consequences import CONSEQUENCES
from axiderive.physics.normal import derive
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES, load
from axiderive.proof.certificate import certify
from axiderive.stable.reference import of_contact

NODES, WEIGHTS = np.polynomial.legendre.leggauss(200)
EPS = 2.0**-52


def over(stop: float, integrand: Callable[[Any], Any], breaks: Sequence[float] = ()) -> float:
    """The integral from 0 on, with places that crowd at both ends of what lies between breaks."""
    share = (1.0 + NODES) / 2.0
    place, width = share * share * (3.0 - 2.0 * share), 6.0 * share * (1.0 - share)
    ends = [0.0, *(b for b in breaks if b < stop), stop]
    return sum(
        float(np.sum(WEIGHTS / 2.0 * width * integrand(low + (high - low) * place)) * (high - low))
        for low, high in pairwise(ends)
    )


def contact(name: str) -> tuple[Any, float, dict[str, Any]]:
    """The module, what the contact is given, and its parameters: those of the sketch."""
    profile = load(name)
    given: dict[str, Any] = {name_of(symbol): float(value) for symbol, value in numbers(profile).items()}
    if coefficients in profile.parameters:
        given["A"] = tuple(map(float, POLYNOMIAL))
    size = float(profile.sketch.d or 0.2) if profile.complete else float(profile.sketch.a)
    return import_module(f"axicontact.normal.{name}"), size, {**given, "E_star": 2.5}


def breaks_of(name: str) -> list[float]:
    profile, known = load(name), numbers(load(name))
    return [float(place.subs(dict(profile.abbreviations)).subs(known)) for place in profile.breaks]


@pytest.mark.parametrize("name", NAMES)
def test_the_load_within_is_the_sum_of_the_pressure(name: str) -> None:
    module, size, given = contact(name)
    edge = size if name in COMPACT_NAMES else given["a"]
    for share in (0.05, 0.6):
        carried = over(share * edge, lambda s: 2.0 * np.pi * s * module.pressure(s, size, **given), breaks_of(name))
        assert module.load_within(share * edge, size, **given) == pytest.approx(carried, rel=1e-9)
    whole = module.force(size, **given)
    assert module.load_within([edge, 2.0 * edge], size, **given) == pytest.approx([whole, whole], rel=8 * EPS)
    assert module.load_within(0.0, size, **given) == 0.0


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_the_energy_is_the_work_of_the_force(name: str) -> None:
    module, size, given = contact(name)
    plain = {key: value for key, value in given.items() if key != "E_star"}
    turns = [module.depth(b, **plain) for b in breaks_of(name) if not load(name).truncated]
    work = over(module.depth(size, **plain), lambda depth: module.force_from_depth(depth, **given), turns)
    assert module.energy(size, **given) == pytest.approx(work, rel=1e-8)


@pytest.mark.parametrize("name", COMPLETE_NAMES)
def test_the_energy_of_a_fixed_edge_grows_by_the_force(name: str) -> None:
    module, size, given = contact(name)
    steps = size * np.array([0.999, 1.001])
    low, high = module.energy(steps, **given)
    mean = module.force(size, **given)  # the energy is a square of the depth
    assert (high - low) / np.ptp(steps) == pytest.approx(mean, rel=1e-6)


def test_powers_have_the_share_of_their_exponent() -> None:
    """U = F d n/(2 n + 1)."""
    material = {"E_star": 3.0}
    for module, shape, share in ((cone, {"theta": 0.2}, 1 / 3), (paraboloid, {"R": 2.0}, 2 / 5)):
        pressed = module.force(0.7, **shape, **material) * module.depth(0.7, **shape)
        assert module.energy(0.7, **shape, **material) == pytest.approx(share * pressed, rel=8 * EPS)


@pytest.mark.parametrize("place", [1e-12, 1e-7, 1e-3, 0.3, 0.999999])
def test_next_to_the_axis_no_digit_is_lost(place: float) -> None:
    """The load less that outside would keep none at r = 1e-8 a."""
    for name, module, values in (
        ("rounded_punch", rounded_punch, {R: 0.7, b: 2.1}),
        ("sphere", sphere, {R: 4.0}),
        ("paraboloid", paraboloid, {R: 4.0}),
    ):
        known = {r: place * 3.0, a: 3.0, E_star: 2.5, **values}
        exact = float(of_contact(derive(load(name)), "Fr", known))
        given = {str(symbol): value for symbol, value in known.items() if symbol not in (r, a)}
        assert module.load_within(place * 3.0, 3.0, **given) == pytest.approx(exact, rel=40 * EPS), name


def test_what_is_no_contact_is_no_number() -> None:
    flat = {"R": 0.7, "b": 2.0, "E_star": 2.5}
    found = rounded_punch.load_within([1.0, 1.0, -1.0], [1.0, 3.0, 3.0], **flat)
    assert np.isnan(found).tolist() == [True, False, True]
    assert np.isnan(rounded_punch.energy(np.array([1.0, 3.0]), **flat)).tolist() == [True, False]
    assert np.isnan(sphere.energy(5.0, R=4.0, E_star=1.0))
    with pytest.raises(ValueError, match="E_star = 0"):
        cone.energy(1.0, theta=0.1, E_star=0.0)


def changed(name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr]) -> Any:
    entries = derive(load(name))
    cases = tuple(replace(case, expr=change(case.expr)) for case in entries[suffix].cases)
    return {**entries, suffix: replace(entries[suffix], cases=cases)}


@pytest.mark.parametrize(
    ("name", "suffix", "change"),
    [
        ("paraboloid", "U", lambda expr: expr * sp.Rational(8, 7)),
        ("truncated_paraboloid", "U", lambda expr: expr + E_star * b**5 / R**2),
        ("flat_punch", "U", lambda expr: expr / 2),
        ("concave_paraboloid", "U", lambda expr: expr + E_star * a * d**2),
        ("cone", "Fr", lambda expr: expr + E_star * r**2),
        ("sphere", "Fr", lambda expr: expr.subs(r, r / 2)),
        ("rounded_punch", "Fr", lambda expr: expr * (1 + r / a)),
        ("flat_punch", "Fr", lambda expr: expr - 2 * E_star * d * r),
    ],
)
def test_a_false_formula_is_refused_by_proof_and_by_numbers(
    name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr]
) -> None:
    profile, entries = load(name), changed(name, suffix, change)
    assert not certify(profile, entries, suffix).proved
    assert not quadrature.check(Comparison(profile, entries, digits=20, points=1), suffix).passed


def test_each_is_stated_everywhere_by_its_own_file() -> None:
    """A consequence has its row, its definition in numbers and its function of the same name."""
    for suffix, own in CONSEQUENCES.items():
        for name in NAMES:
            assert derive(load(name))[suffix].quantity == own.quantity(compact=load(name).compact)
            assert hasattr(import_module(f"axicontact.normal.{name}"), own.compact.function)
