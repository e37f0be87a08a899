"""Emitted adhesive modules against the exact entries at 30 digits, and the limits of Johnson, Kendall and Roberts."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp
from physics_package import CLOSED, derived, emitted, exact, keywords, public, radius, values

from axiderive import notation as nt
from axiderive.code import example
from axiderive.profiles import COMPACT_NAMES, load

POWERS = ("cone", "paraboloid", "quartic", "sextic", "power_law")


def test_pull_off_of_the_flat_punch() -> None:
    punch = emitted("adhesive.flat_punch")
    assert list(public(punch)) == ["retraction", "pull_off", "work_of_adhesion_from_pull_off"]
    state = punch.pull_off(a=2.0, E_star=3.0, dgamma=0.5)
    assert state.force == pytest.approx(-math.sqrt(8 * math.pi * 3.0 * 0.5 * 8.0), rel=CLOSED, abs=0.0)
    assert state.depth == pytest.approx(-math.sqrt(2 * math.pi * 2.0 * 0.5 / 3.0), rel=CLOSED, abs=0.0)
    assert state.radius == 2.0


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_adhesive_fields(name: str) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
    entries = derived()["adhesive"][profile.name]
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
def test_pull_off_is_the_least_load(name: str, control: str) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
    known = values(profile)
    given = keywords(module.pull_off, profile, known)
    state = module.pull_off(control, **given)
    least = getattr(state, control)
    around = state.radius * (1.0 + np.array([-1e-3, -1e-5, 1e-5, 1e-3, 0.1]))
    loads_around = getattr(module, control)(around, **given)
    assert np.all(np.isnan(loads_around) | (loads_around >= least * (1 + 1e-13)))
    assert getattr(module, control)(state.radius, **given) == pytest.approx(least, rel=1e-13, abs=0.0)
    inverse = getattr(module, f"radius_from_{control}")
    assert inverse(least, **given) == pytest.approx(state.radius, rel=1e-7)
    assert math.isnan(inverse(least * 1.001, **given))


@pytest.mark.parametrize("name", POWERS)
@pytest.mark.parametrize("names", [("ac", "Fc", "dc"), ("am", "Fm", "dm")])
def test_pull_off_of_power_laws_is_that_of_the_entries(name: str, names: tuple[str, ...]) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
    entries, known = derived()["adhesive"][profile.name], values(profile)
    state = module.pull_off("force" if names[0] == "ac" else "depth", **keywords(module.pull_off, profile, known))
    a_c = example.number(entries[names[0]].cases[0].expr, known)
    for suffix, found in zip(names, state, strict=True):
        expected = float(example.number(entries[suffix].cases[0].expr, known | {nt.a_c: a_c}))
        assert found == pytest.approx(expected, rel=CLOSED, abs=0.0), suffix


@pytest.mark.parametrize("name", COMPACT_NAMES)
@pytest.mark.parametrize("control", ["force", "depth"])
def test_stable_radius_solves_the_entry(name: str, control: str) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
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


def jkr_failures(count: int) -> int:
    sphere = emitted("adhesive.paraboloid")
    rng = np.random.default_rng(11)
    given = {"R": 10.0 ** rng.uniform(-9, 1, count), "E_star": 10.0 ** rng.uniform(3, 12, count)}
    given["dgamma"] = 10.0 ** rng.uniform(-4, 1, count)
    a_c = sphere.pull_off("depth", **given).radius
    excess = 10.0 ** rng.uniform(-6, 8, count)
    a = a_c * (1.0 + excess)
    found = sphere.radius_from_depth(sphere.depth(a, **given), **given)
    # near pull-off the depth is flat: rounding of d moves a by eps/excess
    return int(np.sum(~(np.abs(found / a - 1.0) < 1e-14 * (1.0 + 1.0 / excess))))


def test_jkr_radius_from_depth() -> None:
    assert jkr_failures(2000) == 0


@pytest.mark.slow
def test_jkr_radius_from_depth_in_many_states() -> None:
    assert jkr_failures(100_000) == 0


def test_jkr_limits() -> None:
    sphere, given = emitted("adhesive.paraboloid"), {"R": 2.0, "E_star": 1e3, "dgamma": 0.3}
    work = math.pi * 0.3 * 2.0
    assert sphere.pull_off(**given).force == pytest.approx(-1.5 * work, rel=1e-15, abs=0.0)
    assert sphere.pull_off("depth", **given).force == pytest.approx(-5 / 6 * work, rel=1e-15, abs=0.0)
    # without load the contact of JKR: a^3 = 9 pi dgamma R^2/(2 E_star)
    assert sphere.radius_from_force(0.0, **given) ** 3 == pytest.approx(4.5 * work * 2.0 / 1e3, rel=1e-14, abs=0.0)


def test_no_adhesion_is_the_normal_contact() -> None:
    for name in ("cone", "truncated_cone", "sphere"):
        profile = load(name)
        known = values(profile) | {nt.dgamma: 0}
        module, plain = emitted(f"adhesive.{name}"), emitted(f"normal.{name}")
        for function, fields in (
            ("force", (0.9,)),
            ("pressure", (0.3, 0.9)),
            ("displacement", (1.4, 0.9)),
            ("radius_from_depth", (0.7,)),
        ):
            own, other = getattr(module, function), getattr(plain, function)
            expected = other(*fields, **keywords(other, profile, known))
            assert own(*fields, **keywords(own, profile, known)) == pytest.approx(expected, rel=1e-14, abs=0.0)


def test_edge_of_an_adhesive_contact() -> None:
    cone, given = emitted("adhesive.cone"), {"theta": 0.3, "E_star": 2.0, "dgamma": 0.1}
    assert cone.pressure(0.9, 0.9, **given) == -math.inf
    assert cone.pressure(0.9, 0.9, theta=0.3, E_star=2.0, dgamma=0.0) == 0.0
    assert cone.pressure(1.0, 0.9, **given) == 0.0
    blunt = emitted("adhesive.truncated_cone")
    with pytest.raises(ValueError, match=r"a = 0\.4 is below b = 0\.5"):
        blunt.force(0.4, b=0.5, **given)
    np.testing.assert_array_equal(np.isnan(blunt.force([0.4, 0.6], b=0.5, **given)), [True, False])


def test_corner_competes_with_the_smooth_minimum() -> None:
    blunt = emitted("adhesive.truncated_cone")
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
def test_fields_and_material_broadcast(name: str) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
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


FAR = {
    "sphere": {"R": 1.0},
    "rounded_punch": {"R": 2.0, "b": 0.5},
    "capped_paraboloid": {"R1": 2.0, "R2": 1.0, "b": 0.3},
    "rounded_cone": {"theta": 0.3, "b": 0.31},
}


@pytest.mark.parametrize("name", FAR)
@pytest.mark.parametrize("power", [-900, 300])
def test_inverses_are_scaled_by_powers_of_two(name: str, power: int) -> None:
    """To the last digit, over 600 decades: the cubes of such radii are no doubles.

    In arrays, since plain numbers of that size are left to them.
    """
    module, unit = emitted(f"adhesive.{name}"), 2.0**power
    far = {key: value if key == "theta" else value * unit for key, value in FAR[name].items()}
    near = FAR[name] | {"E_star": 3.0, "dgamma": np.array([0.05])}
    far |= {"E_star": 3.0, "dgamma": np.array([0.05 * unit])}
    for control, scale in (("depth", unit), ("force", unit * unit if abs(power) < 500 else 0.0)):
        if not scale:
            continue
        a = module.pull_off(control, **near).radius
        assert module.pull_off(control, **far).radius == a * unit
        load = getattr(module, control)(1.3 * a, **near)
        inverse = getattr(module, f"radius_from_{control}")
        assert inverse(load * scale, **far) == inverse(load, **near) * unit
        assert inverse(load, **near) == pytest.approx(1.3 * a, rel=2e-14, abs=0.0)
