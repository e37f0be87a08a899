"""Emitted modules of contact on the graded half-space, against the exact entries and the definitions."""

from __future__ import annotations

import inspect
import math
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from graded_modules import EXPONENTS, GROUPS, POWERS, SLOW, derived, emitted, keywords, public, values
from selected import in_turn

from axiderive import notation as nt
from axiderive.code import example
from axiderive.code.graded.families import family
from axiderive.code.systems import alone, superposed
from axiderive.entry import Entry
from axiderive.oracle.evaluate import height
from axiderive.oracle.half_space import HalfSpace
from axiderive.physics.systems import BY_NAME
from axiderive.profiles import COMPACT_NAMES, NAMES, load
from axiderive.profiles.profile import Profile

# measured: 4e-15 for power laws, 2e-14 elsewhere (quotients of Gamma functions at k = 0.95, the sphere at k = -0.9)
CLOSED, INTEGRAL = 1e-14, 1e-13


def at(function: Any, profile: Profile, known: dict[sp.Symbol, Any], *fields: sp.Symbol) -> float:
    return float(function(*(float(known[field]) for field in fields), **keywords(function, profile, known)))


def exact(entry: Entry, known: dict[sp.Symbol, Any]) -> float:
    return float(example.value(entry, known))


def defined(profile: Profile, known: dict[sp.Symbol, Any], physics: str, suffix: str, digits: int = 17) -> float:
    """The value by quadrature of its definition."""
    with mp.workdps(2 * digits):
        half_space = HalfSpace(profile, known, digits, graded=True)
        a = mp.mpf(str(sp.N(known[nt.a], 30)))
        free = mp.mpf(str(sp.N(known[nt.d], 30))) if profile.contact == "complete" else None
        if physics == "normal":
            return float(mp.re(half_space.normal(suffix, a, free)))
        own = BY_NAME[f"graded.{physics}"].physics
        if own.definitions:
            return float(mp.re(half_space.defined(own.definitions(profile, half_space.medium)[suffix])))
        return float(mp.re(getattr(half_space, physics)(suffix, a)))


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_terms_add_up_to_the_profile(name: str) -> None:
    """The shapes a module is made of, as functions, are f(r) of the profile."""
    profile = load(name)
    if name == "polynomial":
        return
    known = values(profile, "0.3")
    r = known[nt.a] * sp.Rational("0.83")
    total = sum(
        float(term.coefficient.subs(known)) * SHAPES[term.shape](r, term, known) for term in family(profile).terms
    )
    assert total == pytest.approx(float(height(profile, known, r)), rel=1e-14, abs=0.0)


def _lengths(term: Any, known: dict[sp.Symbol, Any]) -> list[float]:
    return [float(sp.sympify(length).subs(known)) for length in term.lengths]


SHAPES: dict[str, Any] = {
    "power": lambda r, term, known: float(r) ** _lengths(term, known)[0],
    "flank": lambda r, term, known: max(float(r) - _lengths(term, known)[0], 0.0),
    "rim": lambda r, term, known: max(float(r) ** 2 - _lengths(term, known)[0] ** 2, 0.0) / 2,
    "rounding": lambda r, term, known: max(float(r) - _lengths(term, known)[0], 0.0) ** 2 / 2,
    "rounded": lambda r, term, known: _rounded(float(r), *_lengths(term, known)),
    "sphere": lambda r, term, known: _sphere(float(r), *_lengths(term, known)),
    "tipped": lambda r, term, known: _tipped(float(r), *_lengths(term, known)[:2]),
    "hyperboloid": lambda r, term, known: math.hypot(float(r), *_lengths(term, known)) - _lengths(term, known)[0],
    "gaussian": lambda r, term, known: -math.expm1(-((float(r) / _lengths(term, known)[0]) ** 2)),
    "waves": lambda r, term, known: 1 - math.cos(float(r) * _lengths(term, known)[0]),
}


def _rounded(r: float, b: float) -> float:
    return r * r / (2 * b) if r < b else r - b / 2


def _sphere(r: float, R: float) -> float:
    return R - math.sqrt(R * R - r * r)


def _tipped(r: float, R: float, b: float) -> float:
    return _sphere(min(r, b), R) + max(r - b, 0.0) * b / math.sqrt(R * R - b * b)


@pytest.mark.parametrize(("name", "k"), in_turn([name for name in NAMES if name not in SLOW], ("-0.9", "0.3", "0.95")))
def test_closed_entries(name: str, k: str) -> None:
    check_closed(name, k)


@pytest.mark.sweep
@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", NAMES)
def test_closed_entries_of_every_profile(name: str, k: str) -> None:
    check_closed(name, k)


def check_closed(name: str, k: str) -> None:
    profile, module = load(name), emitted(f"normal.{name}")
    for entry in derived("normal", name).values():
        if entry.status != "closed" or entry.suffix in ("ad", "aF", "Fd", "dF", "dmin", "Fmin", "rz"):
            continue
        known = values(profile, k)
        known[nt.r] = known[nt.a] * sp.Rational("0.3" if entry.suffix == "p" else "1.4")
        function = getattr(module, entry.quantity.function)
        arguments = entry.quantity.arguments or ((nt.d,) if public(module)[entry.quantity.function] else ())
        tolerance = CLOSED if name in POWERS else INTEGRAL
        assert at(function, profile, known, *arguments) == pytest.approx(exact(entry, known), rel=tolerance, abs=0.0), (
            entry.key
        )


FEW = (("truncated_cone", "-0.5"), ("rounded_punch", "0.7"), ("sphere", "-0.9"), ("hyperboloid", "0.95"))


@pytest.mark.parametrize(("name", "k"), FEW)
def test_pressure_and_displacement_from_their_definitions(name: str, k: str) -> None:
    check_definitions(name, k, ("0.2", "0.9"), ("1.05", "3"))


@pytest.mark.sweep
@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", NAMES)
def test_every_profile_from_its_definitions(name: str, k: str) -> None:
    check_definitions(name, k, ("0.02", "0.3", "0.6", "0.99"), ("1.001", "1.3", "40"))


def check_definitions(name: str, k: str, inside: tuple[str, ...], outside: tuple[str, ...]) -> None:
    profile, module = load(name), emitted(f"normal.{name}")
    edge = nt.d if profile.contact == "complete" else nt.a
    for suffix, ratios in (("p", inside), ("w", outside)):
        for ratio in ratios:
            known = values(profile, k)
            known[nt.r] = known[nt.a] * sp.Rational(ratio)
            function = module.pressure if suffix == "p" else module.displacement
            found = at(function, profile, known, nt.r, edge)
            assert found == pytest.approx(defined(profile, known, "normal", suffix), rel=INTEGRAL, abs=0.0), (
                suffix,
                ratio,
            )


@pytest.mark.parametrize("name", NAMES)
def test_without_grading_it_is_the_homogeneous_half_space(name: str) -> None:
    profile, known = load(name), values(load(name), "0") | {nt.E_star: sp.Rational("2.5")}
    graded, plain = emitted(f"normal.{name}"), import_module(f"axicontact.normal.{name}")
    edge = float(known[nt.d if profile.contact == "complete" else nt.a])
    r = float(known[nt.a]) * np.array([0.0, 0.01, 0.3, 0.7, 0.97, 1.03, 2.0, 50.0])
    for function, fields in public(graded).items():
        own, other = getattr(graded, function), getattr(plain, function)
        places = {"r": r, "a": edge, "d": 0.4 * edge if profile.contact == "compact" else edge, "F": 0.2}
        given = [places[field] for field in fields]
        expected = other(*given, **keywords(other, profile, known))
        found = own(*given, **keywords(own, profile, known))
        # the pressure at the edge of the Gaussian nearly vanishes with g'
        np.testing.assert_allclose(found, expected, rtol=2e-14, err_msg=function)


@pytest.mark.parametrize("name", ["cone", "truncated_paraboloid", "gaussian"])
def test_adhesive_and_tangential_fields(name: str) -> None:
    profile, known = load(name), values(load(name), "0.3")
    known |= {nt.c: known[nt.a] * sp.Rational("0.8"), nt.r: known[nt.a] * sp.Rational("0.4")}
    for physics, suffixes in (("adhesive", ("Dl", "d", "F", "p", "w")), ("tangential", ("F", "tau", "u", "us"))):
        module = emitted(f"{physics}.{name}")
        for suffix in suffixes:
            entry = derived(physics, name)[suffix]
            place = known | ({nt.r: known[nt.a] * 2} if suffix == "w" else {})
            found = at(getattr(module, entry.quantity.function), profile, place, *entry.quantity.arguments)
            scale = defined(profile, place, physics, "Dl") if physics == "adhesive" else 0.0
            expected = defined(profile, place, physics, suffix)
            assert found == pytest.approx(expected, rel=INTEGRAL, abs=INTEGRAL * scale), entry.key


def test_a_wrong_factor_is_seen() -> None:
    """The comparison with the entries fails for a formula that is wrong in the grading alone."""
    profile, known = load("paraboloid"), values(load("paraboloid"), "0.3")
    module = emitted("normal.paraboloid")
    entry = derived("normal", "paraboloid")["F"]
    assert at(module.force, profile, known, nt.a) == pytest.approx(exact(entry, known), rel=CLOSED, abs=0.0)
    text = inspect.getsource(module)
    wrong = text.replace("2.0 * H / (1.0 + k) * growth", "2.0 * H / (1.0 + k * k) * growth")
    assert wrong != text
    space: dict[str, Any] = {"__name__": module.__name__ + "_wrong", "__package__": module.__package__}
    exec(compile(wrong, "wrong", "exec"), space)
    assert at(space["force"], profile, known, nt.a) != pytest.approx(exact(entry, known), rel=1e-3)


@pytest.mark.slow
def test_generated_text_is_the_same_twice() -> None:
    def texts() -> list[str]:
        own = {group: derived(group, "paraboloid") for group in GROUPS}
        base = alone(BY_NAME["graded.normal"], own["normal"])
        above = {BY_NAME[f"graded.{group}"]: own[group] for group in GROUPS[1:]}
        others = [superposed(system, entries, own["normal"], base.parameters) for system, entries in above.items()]
        return [module.source() for module in (base, *others)]

    assert texts() == texts()
