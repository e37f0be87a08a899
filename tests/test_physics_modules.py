"""Emitted modules beyond the normal contact, against the exact entries at 30 digits."""

from __future__ import annotations

import inspect
import math
import shutil
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.contact import adhesive, loads, tangential, viscoelastic
from axiderive.emit import example
from axiderive.emit.physics import module_sources
from axiderive.emit.physics.text import name_of
from axiderive.entry import Entry
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES, load
from axiderive.profiles.loads import LOADS
from axiderive.profiles.profile import Profile

PACKAGE = "emitted_physics"
MATERIAL = {
    nt.E_star: 2.5, nt.dgamma: 0.0125, nt.mu: 0.3, nt.G_star: 0.8, nt.E: 2.5, nt.E_inf: 1.5, nt.E_1: 2.0,
    nt.relaxation: 0.7, nt.eta: 0.9, nt.alpha: 0.4, nt.t_0: 0.6, nt.v: 0.25, nt.p_0: 1.75, nt.sigma: 0.3,
}  # fmt: skip
CLOSED = 2e-14
ADHESIVE = {
    "retraction": ["a"],
    "depth": ["a"],
    "force": ["a"],
    "pressure": ["r", "a"],
    "displacement": ["r", "a"],
    "radius_from_depth": ["d"],
    "radius_from_force": ["F"],
    "pull_off": ["control"],
}
TANGENTIAL = {
    "tangential_force": ["a", "c"],
    "traction": ["r", "a", "c"],
    "tangential_displacement": ["a", "c"],
    "stick_radius": ["F_x", "a"],
    "full_slip_displacement": ["a"],
}
POWERS = ("cone", "paraboloid", "quartic", "sextic", "power_law")


@pytest.fixture(scope="module")
def package(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    folder = tmp_path_factory.mktemp("catalogue")
    shutil.copytree(import_module("axicontact").__path__[0], folder / PACKAGE)
    for path, text in module_sources().items():
        target = folder / PACKAGE / Path(path).relative_to("axicontact")
        target.parent.mkdir(exist_ok=True)
        target.write_text(text)
    sys.path.insert(0, str(folder))
    yield PACKAGE
    sys.path.remove(str(folder))
    for name in [name for name in sys.modules if name.startswith(PACKAGE)]:
        del sys.modules[name]


def emitted(package: str, name: str) -> ModuleType:
    return import_module(f"{package}.{name}")


def public(module: ModuleType) -> dict[str, inspect.Signature]:
    return {
        key: inspect.signature(value)
        for key, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_")
    }


def positional(signature: inspect.Signature) -> list[str]:
    return [p.name for p in signature.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]


def values(profile: Profile) -> dict[sp.Symbol, sp.Rational]:
    material = {symbol: sp.Rational(str(value)) for symbol, value in MATERIAL.items()}
    known = {**material, **example.numbers(profile)}
    return known | {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}


def keywords(function: Any, profile: Profile, known: dict[sp.Symbol, Any]) -> dict[str, Any]:
    named = {
        name_of(symbol): float(value) for symbol, value in known.items() if name_of(symbol) != "A" or symbol == nt.A
    }
    named |= {"A": tuple(map(float, example.POLYNOMIAL))} if profile.name == "polynomial" else {}
    named |= {"s": float(known[nt.s])} if nt.s in profile.parameters else {}
    wanted = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
    return {name: named[name] for name in wanted}


def exact(entry: Entry, known: dict[sp.Symbol, Any]) -> float:
    case = example._case(entry, known)
    return float(example.number(example._plain(case.expr), known))


def radius(profile: Profile) -> sp.Rational:
    return sp.Rational(str(profile.sketch.a))


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_interface_of_adhesive_and_tangential(package: str, name: str) -> None:
    for group, functions, entries in (
        ("adhesive", ADHESIVE, adhesive.derive(load(name))),
        ("tangential", TANGENTIAL, tangential.derive(load(name))),
    ):
        signatures = public(emitted(package, f"{group}.{name}"))
        assert {key: positional(signature) for key, signature in signatures.items()} == functions
        for entry in entries.values():
            parameters = signatures[entry.quantity.function].parameters.values()
            own = [p.name for p in parameters if p.kind is p.KEYWORD_ONLY]
            assert own == [name_of(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", NAMES)
def test_interface_of_viscoelastic(package: str, name: str) -> None:
    signatures = public(emitted(package, f"viscoelastic.{name}"))
    entries = viscoelastic.derive(load(name))
    assert sorted(signatures) == sorted(entry.quantity.function for entry in entries.values())
    assert all(positional(signature) == ["t"] for signature in signatures.values())


@pytest.mark.parametrize("name", COMPLETE_NAMES)
def test_complete_contacts_say_what_to_use(package: str, name: str) -> None:
    with pytest.raises(AttributeError, match="no partial slip; it slips as a whole at F_x = mu F"):
        _ = emitted(package, f"tangential.{name}").traction
    if name != "flat_punch":
        with pytest.raises(AttributeError, match=f"use axicontact.normal.{name}"):
            _ = emitted(package, f"adhesive.{name}").pull_off


def test_pull_off_of_the_flat_punch(package: str) -> None:
    punch = emitted(package, "adhesive.flat_punch")
    assert list(public(punch)) == ["pull_off"]
    state = punch.pull_off(a=2.0, E_star=3.0, dgamma=0.5)
    assert state.force == pytest.approx(-math.sqrt(8 * math.pi * 3.0 * 0.5 * 8.0), rel=CLOSED)
    assert state.depth == pytest.approx(-math.sqrt(2 * math.pi * 2.0 * 0.5 / 3.0), rel=CLOSED)
    assert state.radius == 2.0


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_adhesive_fields(package: str, name: str) -> None:
    profile, module = load(name), emitted(package, f"adhesive.{name}")
    entries = adhesive.derive(profile)
    a = radius(profile)
    for suffix in ("Dl", "d", "F", "p", "w"):
        entry = entries[suffix]
        known = values(profile) | {nt.a: a, nt.r: a * sp.Rational(3, 10) if suffix == "p" else 2 * a}
        function = getattr(module, entry.quantity.function)
        given = [float(known[argument]) for argument in entry.quantity.arguments]
        found = function(*given, **keywords(function, profile, known))
        # the adhesive part may nearly cancel the other
        scale = exact(entries["Dl"], known) if suffix in ("d", "w") else 0.0
        assert found == pytest.approx(exact(entry, known), rel=CLOSED, abs=CLOSED * scale), entry.key


@pytest.mark.parametrize("name", COMPACT_NAMES)
@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_is_the_least_load(package: str, name: str, control: str) -> None:
    profile, module = load(name), emitted(package, f"adhesive.{name}")
    known = values(profile)
    given = keywords(module.pull_off, profile, known)
    state = module.pull_off(control, **given)
    least = getattr(state, control)
    around = state.radius * (1.0 + np.array([-1e-3, -1e-5, 1e-5, 1e-3, 0.1]))
    loads_around = getattr(module, control)(around, **given)
    assert np.all(np.isnan(loads_around) | (loads_around >= least * (1 + 1e-13)))
    assert getattr(module, control)(state.radius, **given) == pytest.approx(least, rel=1e-13)
    inverse = getattr(module, f"radius_from_{control}")
    assert inverse(least, **given) == pytest.approx(state.radius, rel=1e-7)
    assert math.isnan(inverse(least * 1.001, **given))


@pytest.mark.parametrize("name", POWERS)
@pytest.mark.parametrize("names", [("ac", "Fc", "dc"), ("am", "Fm", "dm")])
def test_pull_off_of_power_laws_is_that_of_the_entries(package: str, name: str, names: tuple[str, ...]) -> None:
    profile, module = load(name), emitted(package, f"adhesive.{name}")
    entries, known = adhesive.derive(profile), values(profile)
    state = module.pull_off("force" if names[0] == "ac" else "depth", **keywords(module.pull_off, profile, known))
    a_c = example.number(entries[names[0]].cases[0].expr, known)
    for suffix, found in zip(names, state, strict=True):
        expected = float(example.number(entries[suffix].cases[0].expr, known | {nt.a_c: a_c}))
        assert found == pytest.approx(expected, rel=CLOSED), suffix


@pytest.mark.parametrize("name", COMPACT_NAMES)
@pytest.mark.parametrize("control", ["force", "depth"])
def test_stable_radius_solves_the_entry(package: str, name: str, control: str) -> None:
    profile, module = load(name), emitted(package, f"adhesive.{name}")
    known = values(profile)
    given = keywords(module.pull_off, profile, known)
    a_c = module.pull_off(control, **given).radius
    largest = {"sphere": 0.99 * float(known.get(nt.R, 1)), "ellipsoid": 1.49, "gaussian": 1.0}.get(
        name, 4.0 * a_c + 1.0
    )
    a = a_c + (largest - a_c) * np.linspace(0.01, 1.0, 23)
    value = getattr(module, control)(a, **given)
    found = getattr(module, f"radius_from_{control}")(value, **given)
    back = getattr(module, control)(found, **given)
    np.testing.assert_allclose(back, value, rtol=1e-13, atol=1e-13 * np.abs(value).max())
    assert np.all(found >= a * (1.0 - 1e-9))


def jkr_failures(package: str, count: int) -> int:
    sphere = emitted(package, "adhesive.paraboloid")
    rng = np.random.default_rng(11)
    given = {"R": 10.0 ** rng.uniform(-9, 1, count), "E_star": 10.0 ** rng.uniform(3, 12, count)}
    given["dgamma"] = 10.0 ** rng.uniform(-4, 1, count)
    a_c = sphere.pull_off("depth", **given).radius
    excess = 10.0 ** rng.uniform(-6, 8, count)
    a = a_c * (1.0 + excess)
    found = sphere.radius_from_depth(sphere.depth(a, **given), **given)
    # near pull-off the depth is flat: rounding of d moves a by eps/excess
    return int(np.sum(~(np.abs(found / a - 1.0) < 1e-14 * (1.0 + 1.0 / excess))))


def test_jkr_radius_from_depth(package: str) -> None:
    assert jkr_failures(package, 2000) == 0


@pytest.mark.slow
def test_jkr_radius_from_depth_in_many_states(package: str) -> None:
    assert jkr_failures(package, 100_000) == 0


def test_jkr_limits(package: str) -> None:
    sphere, given = emitted(package, "adhesive.paraboloid"), {"R": 2.0, "E_star": 1e3, "dgamma": 0.3}
    work = math.pi * 0.3 * 2.0
    assert sphere.pull_off(**given).force == pytest.approx(-1.5 * work, rel=1e-15)
    assert sphere.pull_off("depth", **given).force == pytest.approx(-5 / 6 * work, rel=1e-15)
    # without load the contact of JKR: a^3 = 9 pi dgamma R^2/(2 E_star)
    assert sphere.radius_from_force(0.0, **given) ** 3 == pytest.approx(4.5 * work * 2.0 / 1e3, rel=1e-14)


def test_no_adhesion_is_the_normal_contact(package: str) -> None:
    for name in ("cone", "truncated_cone", "sphere"):
        profile = load(name)
        known = values(profile) | {nt.dgamma: 0}
        module, plain = emitted(package, f"adhesive.{name}"), emitted(package, f"normal.{name}")
        for function, fields in (
            ("force", (0.9,)),
            ("pressure", (0.3, 0.9)),
            ("displacement", (1.4, 0.9)),
            ("radius_from_depth", (0.7,)),
        ):
            own, other = getattr(module, function), getattr(plain, function)
            expected = other(*fields, **keywords(other, profile, known))
            assert own(*fields, **keywords(own, profile, known)) == pytest.approx(expected, rel=1e-14)


def test_edge_of_an_adhesive_contact(package: str) -> None:
    cone, given = emitted(package, "adhesive.cone"), {"theta": 0.3, "E_star": 2.0, "dgamma": 0.1}
    assert cone.pressure(0.9, 0.9, **given) == -math.inf
    assert cone.pressure(0.9, 0.9, theta=0.3, E_star=2.0, dgamma=0.0) == 0.0
    assert cone.pressure(1.0, 0.9, **given) == 0.0
    blunt = emitted(package, "adhesive.truncated_cone")
    assert math.isnan(blunt.pressure(0.2, 0.4, b=0.5, **given))
    assert math.isnan(blunt.force(0.4, b=0.5, **given))


def test_corner_competes_with_the_smooth_minimum(package: str) -> None:
    blunt = emitted(package, "adhesive.truncated_cone")
    given = {"theta": 0.4, "b": 0.5, "E_star": 1.0}
    a = np.linspace(0.5, 20.0, 400_001)
    corners = 0
    for dgamma in (1e-6, 1e-3, 1e-2, 0.02, 0.05, 0.1, 0.3):
        state = blunt.pull_off(dgamma=dgamma, **given)
        curve = blunt.force(a, dgamma=dgamma, **given)
        assert state.force == pytest.approx(curve.min(), rel=1e-8)
        corners += state.radius == 0.5
        branch = blunt.radius_from_force(state.force * (1 - 1e-9), dgamma=dgamma, **given)
        assert branch >= state.radius
    assert 0 < corners < 7


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_tangential_entries(package: str, name: str) -> None:
    profile, module = load(name), emitted(package, f"tangential.{name}")
    a = radius(profile)
    for entry in tangential.derive(profile).values():
        function = getattr(module, entry.quantity.function)
        for part in ("0.7", "0.99"):
            known = values(profile) | {nt.a: a, nt.r: a * sp.Rational(3, 10)}
            least = known[profile.breaks[0]] if profile.truncated else sp.S.Zero
            known[nt.c] = least + (a - least) * sp.Rational(part)
            given = keywords(function, profile, known)
            if entry.suffix == "c":
                force = module.tangential_force(float(a), float(known[nt.c]), **given)
                assert function(force, float(a), **given) == pytest.approx(float(known[nt.c]), rel=1e-13)
                continue
            found = function(*(float(known[argument]) for argument in entry.quantity.arguments), **given)
            assert found == pytest.approx(exact(entry, known), rel=2e-13), (entry.key, part)


def test_beyond_full_slip_and_without_load(package: str) -> None:
    cone, given = emitted(package, "tangential.cone"), {"theta": 0.3, "E_star": 2.0, "mu": 0.4}
    full = cone.tangential_force(0.9, 0.0, **given)
    assert cone.stick_radius(0.0, 0.9, **given) == 0.9
    assert cone.stick_radius(full, 0.9, **given) == 0.0
    assert math.isnan(cone.stick_radius(1.0001 * full, 0.9, **given))
    assert cone.traction(1.0, 0.9, 0.5, **given) == 0.0


@pytest.mark.parametrize("name", NAMES)
def test_viscoelastic_entries(package: str, name: str) -> None:
    profile, module = load(name), emitted(package, f"viscoelastic.{name}")
    for entry in viscoelastic.derive(profile).values():
        function = getattr(module, entry.quantity.function)
        known = values(profile) | {nt.time: sp.Rational(9, 10), nt.d: sp.Rational(3, 5), nt.F: sp.Rational(1, 2)}
        given = keywords(function, profile, known)
        found = function(0.9, **given)
        if entry.status == "closed" and len(entry.cases) == 1:
            assert found == pytest.approx(exact(entry, known), rel=CLOSED), entry.key
        else:
            assert found > 0.0 or math.isnan(found), entry.key


def test_long_ramp(package: str) -> None:
    """m/x - m (m - 1)/x^2 ... for large x = t/tau, where a series in x fails."""
    cone = emitted(package, "viscoelastic.cone")
    given = {"v": 1.0, "theta": 0.3, "E": 1.0, "tau": 1e-3}
    for t in (0.01, 0.0399, 0.0401, 1.0, 1e6):
        x = t / 1e-3
        expected = 2 / x * (1 - (1 - math.exp(-x)) / x) * 2 * t**2 / (math.pi * math.tan(0.3))
        assert cone.ramp_force_maxwell(t, **given) == pytest.approx(expected, rel=1e-14)
    assert cone.ramp_force_maxwell(0.0, **given) == 0.0
    punch = emitted(package, "viscoelastic.flat_punch")
    assert punch.ramp_force_kelvin_voigt(0.0, v=0.5, a=2.0, E=3.0, eta=0.7) == pytest.approx(2 * 2.0 * 0.5 * 0.7)


@pytest.mark.parametrize("index", range(len(LOADS)))
def test_loads(package: str, index: int) -> None:
    profile = LOADS[index]
    module, (entry,) = emitted(package, f"loads.{profile.name}"), loads.derive(profile).values()
    assert {key: positional(signature) for key, signature in public(module).items()} == {"displacement": ["r"]}
    for ratio in ("0.01", "0.5", "0.999", "1.001", "1.5", "3", "1000"):
        for s in ("-0.9", "-0.5", "0", "0.3", "2.5", "40") if nt.sigma in profile.parameters else ("0",):
            known = values(profile) | {nt.a: sp.Rational("1.25"), nt.sigma: sp.Rational(s)}
            known[nt.r] = known[nt.a] * sp.Rational(ratio)
            found = module.displacement(float(known[nt.r]), **keywords(module.displacement, profile, known))
            assert found == pytest.approx(exact(entry, known), rel=CLOSED), (ratio, s)


def test_materials(package: str) -> None:
    materials = emitted(package, "materials")
    assert materials.effective_modulus(1.0, 0.5, math.inf, 0.3) == pytest.approx(4 / 3, rel=1e-15)
    assert materials.effective_shear_modulus(1.0, 0.5, math.inf, 0.3) == pytest.approx(2 / 2.25, rel=1e-15)
    np.testing.assert_allclose(materials.h_N(0.0, [-0.5, 0.0, 0.3, 0.5]), 1.0, rtol=1e-15)
    assert materials.graded_modulus(3.0, 2.0, 0.0, 0.5) == pytest.approx(4.0, rel=1e-15)
    # Gibson's half space, incompressible with G = m z, is Winkler's foundation of modulus 2 m:
    # H = 2 pi m, m = E_0/(3 c_0)
    assert materials.graded_modulus(3.0, 2.0, 1 - 1e-9, 0.5) == pytest.approx(math.pi, rel=1e-7)
    assert list(public(materials)) == ["effective_modulus", "effective_shear_modulus", "graded_modulus", "h_N"]


BAD: list[tuple[str, str, tuple[float, ...], dict[str, Any], str]] = [
    (
        "adhesive.cone",
        "force",
        (1.0,),
        {"theta": 0.3, "E_star": 1.0, "dgamma": -1.0},
        r"dgamma = -1\.0 is outside dgamma >= 0; .*use dgamma = 0",
    ),
    (
        "adhesive.cone",
        "pull_off",
        ("up",),
        {"theta": 0.3, "E_star": 1.0, "dgamma": 1.0},
        "control = 'up' must be 'force' or 'depth'",
    ),
    (
        "adhesive.power_law",
        "pull_off",
        (),
        {"A": 1.0, "n": 0.5, "E_star": 1.0, "dgamma": 1.0},
        r"n = 0\.5: n > 1/2 is violated; .*no pull-off",
    ),
    (
        "adhesive.power_law",
        "radius_from_depth",
        (1.0,),
        {"A": 1.0, "n": 0.4, "E_star": 1.0, "dgamma": 1.0},
        r"n = 0\.4: n > 1/2",
    ),
    (
        "tangential.cone",
        "traction",
        (0.1, 1.0, 0.5),
        {"theta": 0.3, "E_star": 1.0, "mu": -0.1},
        r"mu = -0\.1 is outside mu >= 0; .*positive",
    ),
    (
        "tangential.cone",
        "tangential_force",
        (1.0, 1.5),
        {"theta": 0.3, "E_star": 1.0, "mu": 0.1},
        r"c = 1\.5, a = 1\.0: c <= a is violated; .*exchange a and c",
    ),
    (
        "viscoelastic.cone",
        "ramp_force_maxwell",
        (1.0,),
        {"v": -1.0, "theta": 0.3, "E": 1.0, "tau": 1.0},
        r"v = -1\.0 is outside v > 0; .*shrinking contact",
    ),
    (
        "viscoelastic.cone",
        "step_force_maxwell",
        (1.0,),
        {"d": -1.0, "theta": 0.3, "E": 1.0, "tau": 1.0},
        r"d = -1\.0 is outside d >= 0",
    ),
    (
        "loads.power",
        "displacement",
        (1.0,),
        {"a": 1.0, "p_0": 1.0, "s": -1.0, "E_star": 1.0},
        r"s = -1\.0 is outside s > -1; .*infinite force",
    ),
    ("materials", "effective_modulus", (1.0, 0.6, 1.0, 0.3), {}, r"nu_1 = 0\.6 is outside -1 < nu_1 <= 1/2"),
    ("materials", "h_N", (1.0, 0.3), {}, r"k = 1\.0 is outside -1 < k < 1"),
]


@pytest.mark.parametrize(("name", "function", "fields", "given", "message"), BAD)
def test_bad_input(
    package: str, name: str, function: str, fields: tuple[Any, ...], given: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(emitted(package, name), function)(*fields, **given)


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_fields_and_material_broadcast(package: str, name: str) -> None:
    profile, module = load(name), emitted(package, f"adhesive.{name}")
    given = keywords(module.force, profile, values(profile))
    modulus = np.array([1.0, 2.0, 3.0])
    a = np.full((2, 1), float(radius(profile)))
    value = module.force(a, **(given | {"E_star": modulus}))
    assert value.shape == (2, 3)
    together = module.radius_from_force(value, **(given | {"E_star": modulus}))
    assert together.shape == (2, 3)
    assert isinstance(module.radius_from_force(0.1, **given), float)
    apart = [module.radius_from_force(value[0, i], **(given | {"E_star": modulus[i]})) for i in range(3)]
    np.testing.assert_allclose(together, [apart, apart], rtol=1e-13)
    assert module.pull_off(**(given | {"E_star": modulus})).force.shape == (3,)
