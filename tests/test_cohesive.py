"""The cohesive zone against what knows nothing of its formulas: point forces, published numbers, both limits."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from false_entries import below, record

from axicontact._runtime.physics import cohesive_states
from axicontact._runtime.plain import both
from axicontact.expressions import expression
from axiderive import notation as nt
from axiderive.letters import name_of
from axiderive.oracle.evaluate import case_at, evaluated
from axiderive.physics import cohesive
from axiderive.profiles import COMPACT_NAMES, load
from axiderive.proof.certificate import certify
from axiderive.stable import measure
from axiderive.stable.reference import BENCH, reference
from axiderive.verifier.problem import Problem

C = cohesive.cohesive
GEOMETRY: dict[str, dict[str, float]] = {
    "paraboloid": {"R": 1.0},
    "cone": {"theta": 0.2},
    "sphere": {"R": 2.0},
    "hyperboloid": {"theta": 0.3, "b": 0.4},
    "power_law": {"A": 0.3, "n": 2.7},
    "rounded_cone": {"theta": 0.3, "b": 0.5},
    "truncated_paraboloid": {"R": 1.5, "b": 0.4},
    "capped_paraboloid": {"R1": 2.0, "R2": 1.0, "b": 0.3},
    "sphere_tipped_cone": {"R": 0.3, "theta": 0.4},
}
"""Of every way in which the gap is integrated."""
GIVEN = {"E_star": 1.0, "dgamma": 0.01}


def module(name: str, physics: str = "cohesive") -> ModuleType:
    return import_module(f"axicontact.{physics}.{name}")


def of_maugis(number: float, R: float = 1.0) -> float:
    """sigma_0 with which Maugis' parameter has this value."""
    return number * (2.0 * np.pi * GIVEN["dgamma"] * GIVEN["E_star"] ** 2 / (9.0 * R)) ** (1.0 / 3.0)


@pytest.mark.parametrize(("number", "force"), [(4.0, -1.50976), (1.0, -1.600735), (0.05, -1.98144)])
def test_pull_off_of_a_paraboloid_is_the_published_one(number: float, force: float) -> None:
    state = module("paraboloid").pull_off(R=1.0, **GIVEN, sigma_0=of_maugis(number))
    assert state.force / (np.pi * GIVEN["dgamma"]) == pytest.approx(force, abs=6e-6)


def test_a_far_reaching_attraction_pulls_with_twice_pi_R_dgamma() -> None:
    state = module("paraboloid").pull_off(R=3.0, **GIVEN, sigma_0=of_maugis(1e-8, 3.0))
    assert state.force == pytest.approx(-2.0 * np.pi * 3.0 * GIVEN["dgamma"], rel=1e-10)


@pytest.mark.parametrize("name", GEOMETRY)
def test_a_short_ranged_attraction_is_that_of_johnson_kendall_roberts(name: str) -> None:
    """What is left of the zone falls as q/a ~ dgamma E_star/(a sigma_0^2), here below 1e-15."""
    own, limit = module(name), module(name, "adhesive")
    material, a = GEOMETRY[name] | GIVEN, 0.9
    for function, places in (("depth", ()), ("force", ()), ("pressure", (0.5,)), ("displacement", (1.3,))):
        got = getattr(own, function)(*places, a, **material, sigma_0=1e9)
        assert got == pytest.approx(getattr(limit, function)(*places, a, **material), rel=1e-12), function
    for control in ("force", "depth"):
        got, want = own.pull_off(control, **material, sigma_0=1e9), limit.pull_off(control, **material)
        assert got == pytest.approx(want, rel=1e-9)


@pytest.mark.parametrize("name", ["rounded_cone"])
def test_the_surface_is_where_point_forces_move_it(name: str) -> None:
    """Rings of pressure move it by 4 s/(pi E* (r + s)) K: to the face in the contact, dgamma/sigma_0 from it at c."""
    own, a, sigma = module(name), 0.9, 0.07
    material = GEOMETRY[name] | GIVEN | {"sigma_0": sigma}
    c, depth = own.cohesive_radius(a, **material), own.depth(a, **material)

    def moved(r: float) -> float:
        """By Gauss' rule in t, which crowds at both ends: at the ring at r the kernel is a logarithm."""
        nodes, weights = np.polynomial.legendre.leggauss(200)
        t, total = 0.5 * (nodes + 1.0), 0.0
        up, down = t**4, (1.0 - t) ** 4
        ends = sorted({0.0, 0.5, a, min(r, c), c})
        for low, high in zip(ends, ends[1:], strict=False):
            s = low + (high - low) * up / (up + down)
            pressure = np.where(s < a, own.pressure(s, a, **material), -sigma)
            mean, root = np.ones_like(s), np.abs(r - s) / (r + s)
            for _ in range(8):
                mean, root = 0.5 * (mean + root), np.sqrt(mean * root)
            rate = 2.0 * s / (r + s) / mean * pressure * (high - low) * 4.0 * (t - t * t) ** 3 / (up + down) ** 2
            total += float(np.sum(0.5 * weights * rate))
        return total

    face = module(name, "normal").profile
    geometry = GEOMETRY[name]
    assert moved(0.5) == pytest.approx(depth - face(0.5, **geometry), rel=1e-6)
    gap = face(c, **geometry) - depth + moved(c)
    assert gap == pytest.approx(GIVEN["dgamma"] / sigma, rel=1e-5)
    assert moved(1.6 * c) == pytest.approx(own.displacement(1.6 * c, a, **material), rel=1e-6)
    between = 0.5 * (a + c)
    assert moved(between) == pytest.approx(own.displacement(between, a, **material), rel=1e-5)


@pytest.mark.parametrize("name", GEOMETRY)
def test_pressure_and_ring_add_up_to_the_force(name: str) -> None:
    own, a = module(name), 0.9
    material = GEOMETRY[name] | GIVEN | {"sigma_0": 0.07}
    # where the slope has a corner, if it has one
    b = GEOMETRY[name].get("b", 0.3 * np.sin(0.4) if name == "sphere_tipped_cone" else 0.5)
    c = own.cohesive_radius(a, **material)

    def carried(r: mp.mpf) -> mp.mpf:
        # at the edge of a flat face the pressure is infinite
        place = float(r) if float(r) != b else np.nextafter(b, a)
        return 2 * mp.pi * r * own.pressure(place, a, **material)

    with mp.workdps(15):
        inside = mp.quad(carried, [0, b, a])
    assert own.force(a, **material) == pytest.approx(float(inside) - np.pi * 0.07 * (c * c - a * a), rel=1e-9)
    assert own.pressure(0.5 * (a + c), a, **material) == -0.07
    assert own.pressure(1.01 * c, a, **material) == 0.0


@pytest.mark.parametrize("name", [name for name in COMPACT_NAMES if not cohesive.refusal(load(name))])
def test_one_zone_closes_around_a_contact(name: str) -> None:
    """The work of separation grows with c from 0 on, as both of its terms do: the root is the only one."""
    own, values = module(name), {str(s): float(x) for s, x in load(name).sketch.values}
    geometry = {n: values[n] for n in map(name_of, load(name).parameters) if n in values} or {"A": (0.1, 0.25, 0.05)}
    a = values.get("b", 0.4) * (1.3 if load(name).truncated else 0.5)
    c = a * (1.0 + np.geomspace(1e-12, 0.5, 200))
    works = own.work_of_separation(a, c, **geometry, E_star=1.0, sigma_0=0.05)
    assert np.all(np.diff(works) > 0.0) and works[0] > 0.0
    assert own.work_of_separation(a, a, **geometry, E_star=1.0, sigma_0=0.05) == 0.0


SLOW = [pytest.param(name, marks=pytest.mark.slow) for name in ("truncated_paraboloid", "rounded_cone")]
CHANGES = (lambda x: x.subs(C, 2 * C), lambda x: 2 * x, lambda x: x.subs(nt.sigma_0, 2 * nt.sigma_0))
"""A length put in for another, a factor, a lost ring."""


@pytest.mark.parametrize("name", ["paraboloid", *SLOW])
@pytest.mark.parametrize("suffix", cohesive.QUANTITIES)
def test_formulas_are_proved_twice_and_wrong_ones_by_none(name: str, suffix: str) -> None:
    profile, key = load(name), f"{name}.{cohesive.GROUP}"
    entries = cohesive.derive(profile)
    assert certify(profile, entries, suffix).proved
    assert Problem(record(key, entries), Problem(below(key))).prove(suffix) == ""
    long = name == "rounded_cone" and suffix in ("work", "c")
    for change in CHANGES[1:] if long else CHANGES:
        none_proves(name, suffix, change)


@pytest.mark.sweep
@pytest.mark.parametrize("suffix", ["work", "c"])
def test_another_length_is_proved_by_none_under_the_rounded_cone(suffix: str) -> None:
    """The second prover looks for two minutes before it gives up."""
    none_proves("rounded_cone", suffix, CHANGES[0])


def none_proves(name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr]) -> None:
    profile, key, entries = load(name), f"{name}.{cohesive.GROUP}", cohesive.derive(load(name))
    case = entries[suffix].cases[-1]
    changed = sp.Eq(change(case.expr.lhs), case.expr.rhs) if suffix == "c" else change(case.expr)
    cases = (*entries[suffix].cases[:-1], replace(case, expr=changed))
    wrong = {**entries, suffix: replace(entries[suffix], cases=cases)}
    assert not certify(profile, wrong, suffix).proved
    assert Problem(record(key, wrong), Problem(below(key))).prove(suffix)


def test_an_equation_for_anything_but_the_work_is_no_proof() -> None:
    profile, entries = load("cone"), cohesive.derive(load("cone"))
    (case,) = entries["c"].cases
    for other in (sp.Eq(case.expr.lhs, nt.sigma_0), case.expr.lhs):
        wrong = {**entries, "c": replace(entries["c"], cases=(replace(case, expr=other),))}
        assert not certify(profile, wrong, "c").proved


OFTEN = ("paraboloid", "truncated_paraboloid")
RARELY = [pytest.param(name, marks=pytest.mark.slow) for name in GEOMETRY if name not in OFTEN]


@pytest.mark.parametrize("sigma", [0.01, 0.3, 30.0])
@pytest.mark.parametrize("name", [*OFTEN, *RARELY])
def test_pull_off_is_the_least_load(name: str, sigma: float) -> None:
    """Of all contact radii on a fine grid around it, and radii from loads lead back."""
    own, material = module(name), GEOMETRY[name] | GIVEN | {"sigma_0": sigma}
    for control, load_of, inverse in (
        ("force", own.force, own.radius_from_force),
        ("depth", own.depth, own.radius_from_depth),
    ):
        state = own.pull_off(control, **material)
        least = getattr(state, control)
        radii = max(state.radius, 1e-3) * np.geomspace(0.2, 1.8, 81)
        assert np.nanmin(load_of(radii, **material)) >= least - 1e-12 * abs(least)
        assert np.isnan(inverse(least - 1e-6 * abs(least), **material))
        a = max(1.2 * state.radius, 0.3 if state.radius else 1e-2)
        if state.radius > 0.0:
            assert load_of(state.radius, **material) == pytest.approx(least, rel=1e-13)
            assert inverse(load_of(1.7 * a, **material), **material) == pytest.approx(1.7 * a, rel=1e-9)


@pytest.mark.parametrize("sigma", [0.01, 0.3, 30.0])
@pytest.mark.parametrize("name", [*OFTEN, *RARELY])
def test_plain_numbers_are_found_where_arrays_are(name: str, sigma: float) -> None:
    """The search is one text, with NumPy's functions and with those of `math`."""
    own, material = module(name), GEOMETRY[name] | GIVEN | {"sigma_0": sigma}
    for control, load_of, inverse in (
        ("force", own.force, own.radius_from_force),
        ("depth", own.depth, own.radius_from_depth),
    ):
        one, pair = (
            own.pull_off(control, **material),
            own.pull_off(control, **{k: [x] * 2 for k, x in material.items()}),
        )
        least = getattr(one, control)
        assert getattr(pair, control) == pytest.approx([least] * 2, rel=1e-13)
        assert pair.radius == pytest.approx([one.radius] * 2, rel=1e-6)
        loads = load_of(max(one.radius, 0.02) * np.array([1.001, 1.1, 1.4]), **material)
        loads = np.append(loads, least - 0.1 * abs(least))
        many, singles = inverse(loads, **material), [inverse(float(x), **material) for x in loads]
        for found in (many, np.array(singles)):
            # next to pull-off a radius has half of the digits of its load
            assert load_of(found[:-1], **material) == pytest.approx(loads[:-1], rel=1e-12)
            assert np.isnan(found[-1])
        assert many[:-1] == pytest.approx(singles[:-1], rel=1e-5)


@pytest.mark.parametrize("control", ["force", "depth"])
@pytest.mark.parametrize("name", GEOMETRY)
def test_a_state_knows_how_it_goes_on(name: str, control: str) -> None:
    """From half a per cent beside the root of the zone: the state there, and the rates of its numbers with ln a.

    The ratio goes on like that of a power, which the powers are; elsewhere that is a guess.
    """
    own, material = module(name), GEOMETRY[name] | GIVEN | {"sigma_0": 0.07}

    def state(a: float, off: float = 0.0) -> cohesive_states.State:
        root = own._zone(np.array(a), **material)
        return own._state(np.array(a), np.exp(off) * root, **material, control=control)

    def loaded(state: cohesive_states.State) -> float:
        with np.errstate(invalid="ignore"):
            return float(getattr(own, f"_{control}_of")(state.a, state.q, **material))

    middle, step = 0.9, 1e-5
    with np.errstate(invalid="ignore"):
        low, high = state(middle * np.exp(-step)), state(middle * np.exp(step))
        both_ways = {off: state(middle, off) for off in (0.0, 0.005)}
    for off, here in both_ways.items():
        assert here.q == pytest.approx(own._zone(np.array(middle), **material), rel=1e-13 + 2.0 * off**2)
        assert here.off == pytest.approx(-off, rel=0.05, abs=1e-12)
        assert here.widening == pytest.approx(np.log(high.q / low.q) / (2.0 * step), rel=1e-7 + 4.0 * off)
        assert here.gain == pytest.approx((loaded(high) - loaded(low)) / (2.0 * step), rel=1e-7 + 4.0 * off)
        if name in ("paraboloid", "cone", "power_law"):
            steepening = np.log(high.ratio / low.ratio) / (2.0 * step)
            assert here.steepening == pytest.approx(steepening, rel=1e-7 + 4.0 * off)


def test_long_stretches_are_integrated_in_panels() -> None:
    """States next to no contact need five; the search itself asks only on which side of the minimum they are."""
    found = both(lambda x: (math.exp(-x), x * math.exp(-x)), 30.0)
    assert found == pytest.approx((1.0 - math.exp(-30.0), 1.0 - 31.0 * math.exp(-30.0)), rel=1e-14)


def test_a_weak_attraction_lets_go_without_contact() -> None:
    """Under control of the depth a ring without contact holds until f'(c) = 4 sigma_0/(pi E_star)."""
    own, material = module("paraboloid"), {"R": 1.0, **GIVEN, "sigma_0": 0.01}
    state = own.pull_off("depth", **material)
    c = 4.0 * 0.01 / np.pi
    assert state.radius == 0.0
    assert state.force == pytest.approx(-np.pi * 0.01 * c * c, rel=1e-13)
    assert state.depth == pytest.approx(c * c / 2.0 - 1.0 - 4.0 * 0.01 * c / np.pi, rel=1e-13)
    assert own.without_contact(c, **material) == pytest.approx((state.depth, state.force), rel=1e-13)
    first = own.cohesive_radius(0.0, **material)
    touching = own.without_contact(first * (1.0 - 1e-12), **material)
    assert touching == pytest.approx((own.depth(0.0, **material), own.force(0.0, **material)), rel=1e-10)
    assert np.isnan(own.without_contact(1.001 * first, **material).depth)
    # as far away as anything attracts
    for name in ("paraboloid", "sphere", "hyperboloid"):
        assert module(name).without_contact(0.0, **GEOMETRY[name], **GIVEN, sigma_0=0.01) == (-1.0, 0.0)
    assert own.radius_from_depth(0.5 * (state.depth + own.depth(0.0, **material)), **material) == 0.0


@pytest.mark.parametrize("sigma", [0.105, 0.12, 0.136, 0.15, 0.17])
def test_a_corner_holds_surfaces_apart(sigma: float) -> None:
    """Where the slope jumps at b over the one at which the depth is least, to four times as much."""
    geometry, rim, work = {"R1": 4.0, "R2": 1.0, "b": 0.5}, 0.5, 0.16 * sigma
    state = module("capped_paraboloid").pull_off("depth", **geometry, E_star=1.0, dgamma=work, sigma_0=sigma)
    assert state.radius == 0.0
    assert state.force == pytest.approx(-np.pi * sigma * rim**2, rel=1e-13)
    assert state.depth == pytest.approx(rim**2 / 8.0 - work / sigma - 4.0 * sigma * rim / np.pi, rel=1e-13)


def test_what_is_asked_wrongly_is_refused() -> None:
    own = module("paraboloid")
    with pytest.raises(ValueError, match="a <= c"):
        own.work_of_separation(1.0, 0.5, R=1.0, E_star=1.0, sigma_0=0.1)
    with pytest.raises(ValueError, match="control"):
        own.pull_off("displacement", R=1.0, **GIVEN, sigma_0=0.1)
    with pytest.raises(ValueError, match="sigma_0"):
        own.depth(1.0, R=1.0, **GIVEN, sigma_0=0.0)
    with pytest.raises(ValueError, match="use adhesive"):
        cohesive.derive(load("flat_punch"))
    assert np.isnan(module("sphere").depth(0.99, R=1.0, E_star=1.0, dgamma=1.0, sigma_0=0.01))


@pytest.mark.parametrize("a", [0.3, 0.4])
def test_no_zone_surrounds_a_contact_that_reaches_the_end_of_its_profile(a: float) -> None:
    """As an expression too, whose root is found in steps that look at nothing."""
    own, material = module("ellipsoid"), {"h": 0.3, "b": 0.3, **GIVEN, "sigma_0": 0.1}
    with np.errstate(all="ignore"):
        assert np.isnan(expression(own.cohesive_radius, np)(np.float64(a), **material))
    assert np.isnan(own.cohesive_radius(a, **material))


def missed(name: str, a: float, ratio: float, share: float, place: float) -> float:
    """Largest error of a state with q = ratio a and sigma_0 = share E_star, of each value over its parts."""
    profile, entries, own = load(name), cohesive.derive(load(name)), module(name)
    geometry = {s: GEOMETRY[name][name_of(s)] for s in profile.parameters}
    with mp.workdps(70):
        known = {s: mp.mpf(x) for s, x in geometry.items()}
        known |= {nt.a: mp.mpf(a), nt.E_star: mp.mpf(1), nt.sigma_0: mp.mpf(share)}
        known |= {symbol: evaluated(expr, known) for symbol, expr in profile.abbreviations}
        start = known[nt.a] * mp.sqrt(1 + mp.mpf(ratio) ** 2)
        case = case_at(entries["work"], {**known, C: start})
        work = float(evaluated(case.expr, {**known, C: start}))
        # the root of the work as the module gets it
        c = mp.findroot(
            lambda x: evaluated(case.expr, {**known, C: x}) / work - 1,
            (start, start + (start - a) * mp.mpf("1e-18")), tol=mp.mpf(10) ** -90, verify=False,
        )  # fmt: skip
        known |= {C: c, nt.r: mp.mpf(place * a)}
        q = mp.sqrt(c * c - known[nt.a] ** 2)
        parts = {"d": 2 * share * q, "F": 2 * share * (c * c * mp.acos(a / c) + a * q), "p": share, "w": 2 * share * q}
        exact = {s: evaluated(case_at(entries[s], known).expr, known) for s in parts if (s == "w") == (place > 1)
                 or s in "dF"}  # fmt: skip
    material = {name_of(s): x for s, x in geometry.items()} | {"E_star": 1.0, "dgamma": work, "sigma_0": share}
    worst = [abs(own.cohesive_radius(a, **material) / c - 1)]
    for suffix, value in exact.items():
        fields = (place * a, a) if suffix in "pw" else (a,)
        got = getattr(own, entries[suffix].quantity.function)(*fields, **material)
        worst.append(abs(got - value) / (abs(value) + parts[suffix]))
    return float(max(worst))


@pytest.mark.parametrize("name", GEOMETRY)
@pytest.mark.parametrize(("ratio", "share"), [(1e-10, 1e-2), (1e-4, 1e-5), (0.3, 0.1), (20.0, 1e-6)])
def test_the_module_keeps_its_digits_at_all_sizes_of_the_zone(name: str, ratio: float, share: float) -> None:
    a = 0.45 if ratio < 1.0 else 0.05
    if load(name).truncated:
        a, ratio = 0.45, min(ratio, 3.0)
    assert missed(name, a, ratio, share, 0.6) < 1e-13
    assert missed(name, a, ratio, share, 1.4) < 1e-13


@pytest.mark.parametrize("suffix", ["c", "d", "F"])
def test_errors_are_measured_at_the_root_of_the_zone(suffix: str) -> None:
    """Of the double dgamma; with another length in the formula the value would be another one."""
    entries = cohesive.derive(load("cone"))
    evaluate = measure.function_of(entries[suffix], module("cone"))
    for point in measure.samples(entries, suffix, BENCH, 4):
        assert measure.ulps(measure.value(evaluate, point), point.exact) < 8.0
        drawn = {**point.values, C: point.values[C] * 2.0}
        assert reference(dict(entries), suffix, drawn)[1] != point.exact


@pytest.mark.sweep
@pytest.mark.parametrize("name", GEOMETRY)
def test_no_state_of_many_is_lost(name: str) -> None:
    """Over thirteen decades of q/a and nine of sigma_0/E_star."""
    draw = random.Random(name)
    for _ in range(200):
        ratio = 10.0 ** draw.uniform(-10.0, 3.0)
        a = 0.4 * (1.0 + 10.0 ** draw.uniform(-8.0, 0.0)) if load(name).truncated else 10.0 ** draw.uniform(-4.0, 0.5)
        if name == "sphere":
            a, ratio = 0.3 * a, min(ratio, 1.0 / a)
        place = draw.choice([0.3, 0.999, 1.0 + draw.random(), 1e3])
        assert missed(name, a, ratio, 10.0 ** draw.uniform(-9.0, 0.0), place) < 1e-12


def drawn(name: str, count: int) -> dict[str, np.ndarray]:
    """Over twelve decades of sigma_0/E_star and nine of dgamma: from hardly any contact to that without a zone."""
    draw = np.random.default_rng([count, *name.encode()])
    given = {"E_star": np.ones(count), "dgamma": 10.0 ** draw.uniform(-8.0, 1.0, count)}
    whole = {key: np.full(count, value) for key, value in GEOMETRY[name].items()}
    return whole | given | {"sigma_0": 10.0 ** draw.uniform(-6.0, 6.0, count)}


MANY = [
    ("capped_paraboloid", 40),
    ("sphere", 100),
    *(pytest.param(name, 100, marks=pytest.mark.slow) for name in GEOMETRY),
    *(pytest.param(name, 12_000, marks=pytest.mark.sweep) for name in GEOMETRY),
]


@pytest.mark.parametrize("control", ["force", "depth"])
@pytest.mark.parametrize(("name", "count"), MANY)
def test_no_search_of_many_is_lost(name: str, count: int, control: str) -> None:
    """No load beside pull-off is less, and loads above it lead back, at the break and next to it as well."""
    own, material = module(name), drawn(name, count)
    load_of, inverse = getattr(own, control), getattr(own, f"radius_from_{control}")
    state = own.pull_off(control, **material)
    least, a = getattr(state, control), state.radius
    # a zone that reaches the equator
    known = ~np.isnan(a)
    assert name == "sphere" or np.all(known)
    assert np.all(np.isnan(own.cohesive_radius(0.0, **material)[~known]))
    for share in (0.3, 0.5, 0.9, 0.99, 0.999, 1.001, 1.01, 1.1, 2.0, 5.0):
        beside = load_of(share * a, **material)
        assert not np.any((a > 0.0) & (beside < least - 1e-12 * np.abs(least))), share
    draw = np.random.default_rng(count)
    radii = [np.where(a > 0.0, a, 1e-3) * (1.0 + 10.0 ** draw.uniform(-3.0, 3.0, count))]
    if "b" in GEOMETRY[name]:
        beyond = 1.0 + 10.0 ** draw.uniform(-9.0, -2.0, count)
        radii += [material["b"] * share for share in (beyond, 1.01, 1.1)]
    for wide in radii:
        load = load_of(wide, **material)
        # where it grows; the zone of a wider contact reaches beyond a sphere
        grows = (load >= least) & (load_of(wide * (1.0 + 1e-6), **material) > load) & (wide > a)
        found = inverse(load, **material)
        back = np.abs(load_of(found, **material) - load) <= 1e-12 * (np.abs(load) + np.abs(least))
        # beyond a break a load changes by more than that from one double to the next
        wrong = grows & ~(back | (np.abs(found - wide) <= 8.0 * np.spacing(wide)))
        assert not np.any(wrong), {key: value[wrong][:2] for key, value in material.items()} | {"a": wide[wrong][:2]}


@pytest.mark.parametrize(
    ("name", "dgamma", "sigma_0", "a"),
    [
        # next to no contact, where a state that is guessed was taken for the least
        ("truncated_paraboloid", 3.283350862552602e-05, 0.0052755941608602815, 0.0018685280081327145),
        ("sphere", 0.001165735789822709, 0.062015923677816776, 0.001248644870173628),
        # just beyond a break, where the load grows like a root
        ("truncated_paraboloid", 2.8614196222587404e-08, 2.7514221195376833e-06, 0.400000004),
        ("rounded_cone", 0.0002649790861586865, 120.39760652730418, 0.500005),
        # so wide that its load is far above that of pull-off
        ("cone", 0.00394608876831927, 5.514305415532774e-05, 175.2437790911659),
        # where a search begins
        ("rounded_cone", 0.0035603438976867614, 0.005824206633646045, 0.505),
    ],
)
def test_a_radius_comes_back(name: str, dgamma: float, sigma_0: float, a: float) -> None:
    """From plain numbers and from arrays, under either control."""
    own, material = module(name), GEOMETRY[name] | {"E_star": 1.0, "dgamma": dgamma, "sigma_0": sigma_0}
    for load_of, inverse in ((own.force, own.radius_from_force), (own.depth, own.radius_from_depth)):
        load = load_of(a, **material)
        found = np.array([inverse(load, **material), inverse(np.array([load]), **material)[0]])
        near = np.abs(load_of(found, **material) - load) <= 1e-12 * abs(load)
        assert np.all(near | (np.abs(found - a) <= 8.0 * np.spacing(a)))


def test_pull_off_is_that_of_each_in_an_array() -> None:
    """A state that others need is not taken for the least load of one that does not."""
    work, stress = [0.0003564870651041903, 0.02, 1.0, 1e-5], [0.0011109795440306745, 0.3, 0.5, 100.0]
    own, given = module("sphere"), {"R": 2.0, "E_star": 1.0}
    whole = own.pull_off("force", **given, dgamma=np.array(work), sigma_0=np.array(stress))
    each = [own.pull_off("force", **given, dgamma=x, sigma_0=y) for x, y in zip(work, stress, strict=True)]
    assert whole.radius == pytest.approx([state.radius for state in each], rel=1e-9)
    assert whole.force == pytest.approx([state.force for state in each], rel=1e-13)


@pytest.mark.parametrize(
    ("name", "dgamma", "sigma_0"),
    [
        ("capped_paraboloid", 0.0016852463027864652, 0.08320347630193327),
        ("truncated_paraboloid", 9.888930979100971e-08, 0.31674322873043503),
        ("truncated_paraboloid", 1.7922414045118298e-08, 232272.7513099397),
        ("truncated_paraboloid", 7.259111113290024e-07, 0.004343247370077945),
        ("truncated_paraboloid", 2.0488542045094242e-05, 0.01344756684784493),
        ("truncated_paraboloid", 6.246945355248646e-08, 0.0014971341042785608),
        ("truncated_paraboloid", 3.8710447578582e-08, 4288.381466520496),
    ],
)
@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_where_the_zone_reaches_a_break(name: str, dgamma: float, sigma_0: float, control: str) -> None:
    """The rate of the load jumps there; the last step to a state may lead from one side of it to the other."""
    own, material = module(name), GEOMETRY[name] | {"E_star": 1.0, "dgamma": dgamma, "sigma_0": sigma_0}
    state = own.pull_off(control, **material)
    pair = own.pull_off(control, **{key: np.full(2, value) for key, value in material.items()})
    assert pair.radius == pytest.approx([state.radius] * 2, rel=1e-13)
    if control == "force":
        assert own.cohesive_radius(state.radius, **material) == pytest.approx(material["b"], rel=1e-9)
    radii = state.radius * (1.0 + np.concatenate([-np.geomspace(1e-7, 0.5, 40), np.geomspace(1e-7, 0.5, 40)]))
    beside = np.min(getattr(own, control)(radii, **material))
    for least in (getattr(state, control), *getattr(pair, control)):
        assert beside >= least - 1e-12 * abs(least)
