"""Emitted modules of contact on the graded half space, against the exact entries and the definitions."""

from __future__ import annotations

import inspect
import math
import warnings
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from graded_modules import EXPONENTS, POWERS, SLOW, derived, emitted, keywords, values

from axiderive import notation as nt
from axiderive.abel.reduce import NotReducibleError
from axiderive.emit import example
from axiderive.emit.graded import TITLES, examples, module_sources
from axiderive.emit.graded.families import family
from axiderive.emit.physics.text import name_of
from axiderive.entry import Entry
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES, load
from axiderive.profiles.profile import Piece, Profile
from axiderive.proof.half_space import HalfSpace

EMIT = Path(examples.__file__).parents[1]


# measured: 4e-15 for power laws, 2e-14 elsewhere (quotients of Gamma functions at k = 0.95, the sphere at k = -0.9)
CLOSED, INTEGRAL = 1e-14, 1e-13
COMPACT = {
    "profile": ["r"], "depth": ["a"], "force": ["a"], "pressure": ["r", "a"], "displacement": ["r", "a"],
    "stiffness": ["a"], "mean_pressure": ["a"], "radius_from_depth": ["d"], "radius_from_force": ["F"],
    "force_from_depth": ["d"], "depth_from_force": ["F"],
}  # fmt: skip
COMPLETE = {
    "profile": ["r"], "force": ["d"], "pressure": ["r", "d"], "displacement": ["r", "d"], "stiffness": [],
    "depth_from_force": ["F"],
}  # fmt: skip
CONCAVE = {"zero_radius": [], "minimum_depth": [], "minimum_force": []}
ADHESIVE = {
    "retraction": ["a"], "depth": ["a"], "force": ["a"], "pressure": ["r", "a"], "displacement": ["r", "a"],
    "radius_from_depth": ["d"], "radius_from_force": ["F"], "pull_off": ["control"],
}  # fmt: skip
TANGENTIAL = {
    "tangential_force": ["a", "c"], "traction": ["r", "a", "c"], "tangential_displacement": ["a", "c"],
    "stick_radius": ["F_x", "a"], "full_slip_displacement": ["a"],
}  # fmt: skip


def public(module: ModuleType) -> dict[str, list[str]]:
    functions = {
        key: inspect.signature(value)
        for key, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_")
    }
    return {
        key: [p.name for p in own.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]
        for key, own in functions.items()
    }


def at(function: Any, profile: Profile, known: dict[sp.Symbol, Any], *fields: sp.Symbol) -> float:
    return float(function(*(float(known[field]) for field in fields), **keywords(function, profile, known)))


def exact(entry: Entry, known: dict[sp.Symbol, Any]) -> float:
    return float(example.number(example._plain(example._case(entry, known).expr), known))


def defined(profile: Profile, known: dict[sp.Symbol, Any], physics: str, suffix: str, digits: int = 17) -> float:
    """The value by quadrature of its definition."""
    with mp.workdps(2 * digits):
        half_space = HalfSpace(profile, known, digits, graded=True)
        a = mp.mpf(str(sp.N(known[nt.a], 30)))
        free = mp.mpf(str(sp.N(known[nt.d], 30))) if profile.contact == "complete" else None
        if physics == "normal":
            return float(mp.re(half_space.normal(suffix, a, free)))
        return float(mp.re(getattr(half_space, physics)(suffix, a)))


@pytest.mark.parametrize("name", NAMES)
def test_interface(name: str) -> None:
    normal = public(emitted(f"normal.{name}"))
    if name in COMPACT_NAMES:
        assert normal == COMPACT
        assert public(emitted(f"adhesive.{name}")) == ADHESIVE
        assert public(emitted(f"tangential.{name}")) == TANGENTIAL
    else:
        stiffness = {"stiffness": ["d"]} if name == "capped_cylinder" else {}
        assert normal == COMPLETE | (CONCAVE if name.startswith("concave") else {}) | stiffness
    for group in TITLES:
        for entry in derived(group, name).values():
            function = getattr(emitted(f"{group}.{name}"), entry.quantity.function)
            own = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
            assert own == [name_of(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", COMPLETE_NAMES)
def test_complete_contacts_say_what_to_use(name: str) -> None:
    with pytest.raises(AttributeError, match=r"slips as a whole at F_x = mu F, with F from axicontact\.graded\.normal"):
        _ = emitted(f"tangential.{name}").traction
    if name == "capped_cylinder":
        with pytest.raises(AttributeError, match=r"use axicontact\.graded\.adhesive\.paraboloid"):
            _ = emitted(f"adhesive.{name}").pull_off


def test_a_profile_without_graded_integrals_is_refused() -> None:
    odd = load("cone")
    pieces = (Piece(None, nt.h * (1 - sp.exp(-nt.r / nt.s))),)
    with pytest.raises(NotReducibleError, match="add its depth, rate, force, pressure and sag"):
        family(Profile(**{**vars(odd), "pieces": pieces}))


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
    assert total == pytest.approx(float(example.shape_value(profile, known | {nt.r: r})), rel=1e-14)


def _lengths(term: Any, known: dict[sp.Symbol, Any]) -> list[float]:
    return [float(sp.sympify(length).subs(known)) for length in term.lengths]


SHAPES: dict[str, Any] = {
    "power": lambda r, term, known: float(r) ** _lengths(term, known)[0],
    "flank": lambda r, term, known: max(float(r) - _lengths(term, known)[0], 0.0),
    "rim": lambda r, term, known: max(float(r) ** 2 - _lengths(term, known)[0] ** 2, 0.0) / 2,
    "rounding": lambda r, term, known: max(float(r) - _lengths(term, known)[0], 0.0) ** 2 / 2,
    "rounded": lambda r, term, known: _rounded(float(r), *_lengths(term, known)),
    "sphere": lambda r, term, known: _sphere(float(r), *_lengths(term, known)),
    "tipped": lambda r, term, known: _tipped(float(r), *_lengths(term, known)),
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


@pytest.mark.parametrize("k", ("-0.9", "0.3", "0.95"))
@pytest.mark.parametrize("name", [name for name in NAMES if name not in SLOW])
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
        assert at(function, profile, known, *arguments) == pytest.approx(exact(entry, known), rel=tolerance), entry.key


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
            assert found == pytest.approx(defined(profile, known, "normal", suffix), rel=INTEGRAL), (suffix, ratio)


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


BAD: list[tuple[str, str, tuple[Any, ...], dict[str, Any], str]] = [
    ("normal.cone", "depth", (1.0,), {"theta": 0.3, "k": 1.0}, r"k = 1\.0 is outside -1 < k < 1; .*k = 0 for a homog"),
    ("normal.cone", "force", (1.0,), {"theta": 0.3, "H": 1.0, "k": -1.0}, r"k = -1\.0 is outside -1 < k < 1"),
    ("normal.cone", "force", (1.0,), {"theta": 0.3, "H": 0.0, "k": 0.2}, r"H = 0\.0 is outside H > 0"),
    (
        "normal.truncated_cone",
        "depth",
        (0.2,),
        {"theta": 0.3, "b": 0.5, "k": 0.2},
        r"a = 0\.2 is below b = 0\.5: .*use",
    ),
    ("normal.concave_power", "force", (1.0,), {"a": 1.0, "h": 1.0, "n": 1.2, "H": 1.0, "k": -0.3}, "n > 1 - k is viol"),
    (
        "normal.wavy_paraboloid",
        "depth",
        (1.0,),
        {"R": 1.0, "h": 0.01, "wavelength": 0.38, "k": -0.5},
        r"steepest_waves\(k\)\*R\*h <= wavelength\*\*2 is violated; steeper waves leave gaps",
    ),
    ("adhesive.power_law", "pull_off", (), {"A": 1.0, "n": 0.3, "H": 1.0, "k": 0.2, "dgamma": 1.0}, r"n > \(1 - k\)/2"),
    ("adhesive.cone", "pull_off", ("up",), {"theta": 0.3, "H": 1.0, "k": 0.2, "dgamma": 1.0}, "'force' or 'depth'"),
    ("adhesive.cone", "depth", (1.0,), {"theta": 0.3, "H": 1.0, "k": 0.2, "dgamma": -1.0}, "dgamma >= 0"),
    (
        "tangential.cone",
        "tangential_force",
        (1.0, 1.5),
        {"theta": 0.3, "H": 1.0, "k": 0.2, "mu": 0.1},
        "c <= a is viol",
    ),
]


@pytest.mark.parametrize(("name", "function", "fields", "given", "message"), BAD)
def test_bad_input(name: str, function: str, fields: tuple[Any, ...], given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(emitted(name), function)(*fields, **given)


def test_waves_that_only_some_grading_allows() -> None:
    """wavelength**2 >= 12.39 h R without grading; a softer surface (k < 0) follows the waves into their troughs."""
    wavy = emitted("normal.wavy_paraboloid")
    limit = import_module("axicontact._graded_growth").steepest_waves
    least = float(load("wavy_paraboloid").rules[0].left.subs({nt.R: 1, nt.h: 1}))
    assert limit(0.0) == pytest.approx(least, rel=1e-6)
    assert np.all(np.diff(limit([-0.9, -0.5, 0.0, 0.5, 0.9])) < 0.0)
    assert wavy.depth(1.0, R=1.0, h=0.01, wavelength=0.38, k=0.3) > 0.0


@pytest.mark.parametrize("name", NAMES)
def test_shapes_limits_and_silence(name: str) -> None:
    profile, module, known = load(name), emitted(f"normal.{name}"), values(load(name), "0.3")
    edge = float(known[nt.d if profile.contact == "complete" else nt.a])
    a = float(known[nt.a])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        p = module.pressure([0.0, a / 2, a, 2 * a, -1.0, math.nan], edge, **keywords(module.pressure, profile, known))
        assert p[3] == 0.0 and np.isnan(p[4:]).all() and p[1] > 0.0
        given = keywords(module.displacement, profile, known)
        w = module.displacement([0.3 * a, a, a * (1 + 1e-12)], edge, **given)
        f = module.profile([0.3 * a, a], **keywords(module.profile, profile, known))
        depth = edge if profile.contact == "complete" else module.depth(edge, **keywords(module.depth, profile, known))
        np.testing.assert_allclose(w[:2], depth - f, rtol=1e-14)
        assert w[2] == pytest.approx(w[1], rel=1e-4)
        assert isinstance(module.force(edge, **keywords(module.force, profile, known)), float)
        k = np.array([-0.6, 0.2, 0.8])
        force = keywords(module.force, profile, known) | {"k": k}
        value = module.force(np.full((2, 1), edge), **force)
        assert value.shape == (2, 3)
        alone = [module.force(edge, **(force | {"k": own})) for own in k]
        np.testing.assert_allclose(value, [alone, alone], rtol=1e-14)


def test_a_wrong_factor_is_seen() -> None:
    """The comparison with the entries fails for a formula that is wrong in the grading alone."""
    profile, known = load("paraboloid"), values(load("paraboloid"), "0.3")
    module = emitted("normal.paraboloid")
    entry = derived("normal", "paraboloid")["F"]
    assert at(module.force, profile, known, nt.a) == pytest.approx(exact(entry, known), rel=CLOSED)
    text = inspect.getsource(module)
    wrong = text.replace("2.0 * H / (1.0 + k) * growth", "2.0 * H / (1.0 + k * k) * growth")
    assert wrong != text
    space: dict[str, Any] = {"__name__": module.__name__ + "_wrong", "__package__": module.__package__}
    exec(compile(wrong, "wrong", "exec"), space)
    assert at(space["force"], profile, known, nt.a) != pytest.approx(exact(entry, known), rel=1e-3)


@pytest.mark.slow
def test_generated_text_is_the_same_twice() -> None:
    entries = {f"graded.{group}": {"paraboloid": derived(group, "paraboloid")} for group in TITLES}
    assert module_sources(["paraboloid"], entries) == module_sources(["paraboloid"], entries)
