"""The way back of a viscoelastic contact, held before or not: springs that come off, limits, false formulas."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from importlib import import_module
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from false_entries import below, record

from axicontact._runtime.physics import relaxation as summed
from axicontact._runtime.physics import single
from axicontact.expressions import expression
from axiderive import notation as nt
from axiderive.checks import viscoelastic as viscoelastic_checks
from axiderive.checks.comparison import Comparison
from axiderive.entry import Case, Entry
from axiderive.oracle.evaluate import case_at, evaluated
from axiderive.physics import viscoelastic
from axiderive.profiles import load
from axiderive.proof.certificate import certify
from axiderive.verifier.problem import Problem

LAWS = {law.suffix: law for law in viscoelastic.LAWS}
MATERIAL = {
    "maxwell": {"E": 2.5, "tau": 0.7}, "kelvin_voigt": {"E": 2.5, "eta": 0.3},
    "standard_solid": {"E_inf": 1.5, "E_1": 2.0, "tau": 0.7}, "power_creep": {"E": 2.5, "alpha": 0.4, "t_0": 0.6},
}  # fmt: skip
MOVED = {"v": 0.25, "v_2": 0.4, "t_m": 0.8}
HELD = {**MOVED, "t_h": 1.0}
SHAPE = {
    "cone": {"theta": 0.3}, "paraboloid": {"R": 1.6}, "flat_punch": {"a": 0.8}, "power_law": {"A": 0.7, "n": 0.4},
    "rounded_cone": {"theta": 0.3, "b": 0.25}, "truncated_cone": {"theta": 0.3, "b": 0.1},
}  # fmt: skip
POINT = {
    nt.v: 0.25, nt.v_2: 0.4, nt.t_m: 0.8, nt.t_h: 0.9, nt.E: 2.5, nt.relaxation: 0.7, nt.eta: 0.3,
    nt.E_inf: 1.5, nt.E_1: 2.0, nt.alpha: 0.4, nt.t_0: 0.6, nt.theta: 0.3, nt.time: 1.0, nt.t_1: 0.5,
}  # fmt: skip


@cache
def derived(name: str) -> dict[str, Entry]:
    return viscoelastic.derive(load(name))


def module(name: str) -> ModuleType:
    return import_module(f"axicontact.viscoelastic.{name}")


def call(name: str, kind: str, law: str, *fields: object, **other: object) -> np.ndarray:
    own = SHAPE[name] if kind.startswith(("retract", "ramp")) else {}
    return getattr(module(name), f"{kind}_{law}")(*fields, **{**own, **MOVED, **MATERIAL[law], **other})


def springs(law: str, sunk: np.ndarray, speed: float, held: np.ndarray, dt: float) -> np.ndarray:
    """The force of each spring after one more step at constant speed; `held` is that of its Maxwell element."""
    own = MATERIAL[law]
    if law == "kelvin_voigt":
        return own["E"] * sunk + own["eta"] * speed
    stiff, tau = own.get("E", own.get("E_1")), own["tau"]
    held *= np.exp(-dt / tau)
    held += stiff * tau * speed * -np.expm1(-dt / tau)
    return held + own.get("E_inf", 0.0) * sunk


@pytest.mark.parametrize("law", ["maxwell", "kelvin_voigt", "standard_solid"])
@pytest.mark.parametrize(("name", "waited"), [("cone", 0), ("paraboloid", 500), ("truncated_cone", 500)])
def test_springs_that_come_off_one_by_one(name: str, law: str, waited: int) -> None:
    """A foundation whose springs touch as the profile comes down and let go when nothing presses them any more."""
    x, steps = np.linspace(0.0, 1.2, 2401), 2000
    back = steps + waited
    # nothing is below a flat face
    depth_at = np.nan_to_num(import_module(f"axicontact.normal.{name}").depth(x, **SHAPE[name]))
    dt = MOVED["t_m"] / steps
    held, free, depth, t = np.zeros_like(x), np.zeros(x.shape, bool), 0.0, 0.0
    seen = []
    for step in range(back + steps):
        speed = MOVED["v"] if step < steps else -MOVED["v_2"] if step >= back else 0.0
        t, depth, before = t + dt, depth + speed * dt, depth
        touching = ~free & (np.maximum(depth, before) > depth_at)
        # one that is met within the step moves for the rest of it alone: of the order of the step
        force = np.zeros_like(x)
        own = held[touching]
        force[touching] = springs(law, depth - depth_at[touching], speed, own, dt)
        held[touching] = own
        if step >= back:
            free |= touching & (force <= 0.0)
        force[free] = 0.0
        if step % 100 == 99:
            seen.append((t, 2.0 * np.trapezoid(force, x), x[force > 0.0].max(initial=0.0)))
    times, forces, radii = map(np.array, zip(*seen, strict=True))
    # a turn belongs to both speeds
    t_h = dt * back if waited else MOVED["t_m"]
    keep = (np.abs(times - MOVED["t_m"]) > 1.5 * dt) & (np.abs(times - t_h) > 1.5 * dt)
    wanted, radius = (call(name, kind, law, times, t_h=t_h) for kind in ("retract_force", "retract_radius"))
    greatest = wanted[keep].max()
    assert np.abs(forces - wanted)[keep].max() < 2e-3 * greatest
    assert np.abs(radii - radius)[keep].max() < 2e-3 * radius.max() + x[1]
    ended = call(name, "contact_time", law, t_h=t_h)
    assert ((forces > 0.0) == (times < ended))[keep].all()
    assert (forces[keep & (times > t_h)] > 0.0).sum() > 2


def relaxation(law: str, s: mp.mpf) -> mp.mpf:
    """E(s) for s > 0."""
    own = {key: mp.mpf(x) for key, x in MATERIAL[law].items()}
    if law == "power_creep":
        alpha = own["alpha"]
        return own["E"] * mp.sin(mp.pi * alpha) / (mp.pi * alpha) * (own["t_0"] / s) ** alpha
    if law == "kelvin_voigt":
        return own["E"]
    return own.get("E_inf", 0) + own.get("E_1", own.get("E")) * mp.exp(-s / own["tau"])


def moved(law: str, start: mp.mpf, t: mp.mpf) -> mp.mpf:
    """int E(t - s) d'(s) ds from a start to t > t_h: at v, held, and back at v_2, which pulls a dashpot."""
    v, v_2, t_m, t_h = (mp.mpf(HELD[key]) for key in ("v", "v_2", "t_m", "t_h"))
    pulled = mp.mpf(MATERIAL[law].get("eta", 0))

    def since(low: mp.mpf, high: mp.mpf) -> mp.mpf:
        return mp.quad(lambda x: 4 * x**3 * relaxation(law, x**4), [(t - high) ** 0.25, (t - low) ** 0.25])

    return v * since(start, t_m) - v_2 * (since(t_h, t) + pulled)


@pytest.mark.parametrize("law", MATERIAL)
def test_a_hold_by_the_integrals_that_define_it(law: str) -> None:
    """Without what the engine has as I(t): the rate of the depth leaves nothing from t_1 on, up to t_1 the force."""
    with mp.workdps(25):
        ended = mp.mpf(float(call("paraboloid", "contact_time", law, t_h=HELD["t_h"])))
        assert abs(moved(law, mp.mpf(0), ended)) < 1e-14 * MOVED["v"] * MATERIAL[law].get("E", 1.0)
        for share in (0.2, 0.7):
            t = mp.mpf(float(HELD["t_h"] + share * (ended - HELD["t_h"])))
            early = mp.findroot(lambda x, t=t: moved(law, x, t), (0.1, 0.7), solver="anderson", tol=1e-40)
            assert call("paraboloid", "earlier_time", law, float(t), t_h=HELD["t_h"]) == pytest.approx(
                float(early), rel=1e-13
            )
            # F_el = 4/3 sqrt(R) (v s)**(3/2) E*
            rate = 2 * mp.sqrt(mp.mpf(SHAPE["paraboloid"]["R"])) * mp.mpf(MOVED["v"]) ** 1.5
            force = rate * mp.quad(lambda s, t=t: relaxation(law, t - s) * mp.sqrt(s), [0, early / 2, early])
            found = call("paraboloid", "retract_force", law, float(t), t_h=HELD["t_h"])
            assert found == pytest.approx(float(force), rel=1e-13)
            # while it is held all of the ramp counts
            t = mp.mpf(0.8 + 0.2 * share)
            force = rate * mp.quad(lambda s, t=t: relaxation(law, t - s) * mp.sqrt(s), [0, 0.4, 0.7, 0.79, mp.mpf(0.8)])
            found = call("paraboloid", "retract_force", law, float(t), t_h=HELD["t_h"])
            assert found == pytest.approx(float(force), rel=1e-13)


@pytest.mark.parametrize("law", MATERIAL)
@pytest.mark.parametrize("name", ["cone", "rounded_cone", "flat_punch"])
def test_a_hold_begins_and_ends_without_a_jump(name: str, law: str) -> None:
    """But for the dashpot of Kelvin and Voigt, which stops pushing at t_m and begins to pull at t_h."""
    beside = np.array([0.8 * (1 - 1e-12), 0.8 * (1 + 1e-12), 1.0, 1.0 + 1e-12])
    force = call(name, "retract_force", law, beside, t_h=1.0)
    early = call(name, "earlier_time", law, np.array([0.8, 0.9, 1.0]), t_h=1.0)
    assert (early == 0.8).all()
    if law == "kelvin_voigt":
        assert force[1] == pytest.approx(force[2], rel=1e-11) and force[0] > force[1] and force[2] > force[3]
    else:
        assert force[0] == pytest.approx(force[1], rel=1e-5) and force[2] == pytest.approx(force[3], rel=1e-5)
        assert force[1] > force[2]


@pytest.mark.parametrize("law", MATERIAL)
@pytest.mark.parametrize("name", ["cone", "rounded_cone"])
def test_no_hold_is_one_of_no_length(name: str, law: str) -> None:
    """To the last bit, over arrays and plain numbers, and for expressions, which may leave it out too."""
    t = np.linspace(0.05, 1.4, 28)
    for kind in ("earlier_time", "retract_radius", "retract_force", "contact_time"):
        for fields in ((t,), (0.9,)) if kind != "contact_time" else ((),):
            bare = call(name, kind, law, *fields)
            assert np.array_equal(call(name, kind, law, *fields, t_h=0.8), bare), kind
            assert np.array_equal(call(name, kind, law, *fields, t_h=None), bare), kind
            assert not np.array_equal(call(name, kind, law, *fields, t_h=np.float64(0.85)), bare), kind
    function, given = getattr(module("cone"), f"retract_force_{law}"), {**MOVED, **MATERIAL[law], **SHAPE["cone"]}
    held = [expression(function, np)(t, **given, **hold) for hold in ({}, {"t_h": None}, {"t_h": 0.8})]
    assert np.array_equal(held[0], held[1]) and np.array_equal(held[0], held[2])
    assert held[0] == pytest.approx(function(t, **given), rel=1e-9, abs=1e-12)


def test_a_hold_that_ends_before_it_begins() -> None:
    """The message says both times; what is no number of the domain is said as of any parameter."""
    with pytest.raises(ValueError, match=r"t_m = 0.8, t_h = 0.7: t_h >= t_m is violated; the depth is held"):
        call("cone", "contact_time", "maxwell", t_h=0.7)
    with pytest.raises(ValueError, match=r"t_m = 0.8, t_h = \[0.9, 0.7\]: t_h >= t_m is violated"):
        call("cone", "earlier_time", "maxwell", 1.0, t_h=[0.9, 0.7])
    with pytest.raises(ValueError, match=r"t_h = nan is outside t_h >= t_m"):
        call("cone", "contact_time", "maxwell", t_h=np.nan)
    with pytest.raises(ValueError, match=r"t_m = nan is outside t_m > 0"):
        call("cone", "contact_time", "maxwell", t_m=np.nan)
    with pytest.raises(TypeError, match=r"t_h must be a real number"):
        call("cone", "contact_time", "maxwell", t_h="1.0")


def test_a_hold_far_longer_than_the_relaxation_time() -> None:
    """What the ramp pressed in has faded by e**10000: the contact ends as soon as the indenter goes back."""
    for law in ("maxwell", "standard_solid"):
        given = {"t_m": 0.8, "t_h": 7000.8, **({} if law == "maxwell" else {"E_inf": 1e-9})}
        ended = call("cone", "contact_time", law, **given)
        t = np.array([7000.7, 7000.8, np.nextafter(7000.8, 8e3), 7001.0, 7e5])
        early = call("cone", "earlier_time", law, t, **given)
        assert (early[:2] == 0.8).all()
        if law == "maxwell":
            assert ended == 7000.8 and (early[2:] == 0.0).all()
        assert np.isfinite(call("cone", "retract_force", law, t, **given)).all()


@pytest.mark.parametrize("count", [40, pytest.param(150, marks=pytest.mark.slow)])
def test_the_end_after_a_hold_of_power_creep(count: int) -> None:
    """The root for exponents next to 0 and 1, speeds and holds over twenty decades, to what a unit of v_2 leaves."""
    draw = np.random.default_rng(11)
    for _ in range(count):
        ratio, k = 10.0 ** draw.uniform(-10, 10), 10.0 ** draw.uniform(-12, 8)
        alpha = draw.choice([10.0 ** draw.uniform(-12, 0), 1 - 10.0 ** draw.uniform(-12, 0), draw.uniform(0, 1)])
        given = {"v": 1.0, "v_2": ratio, "t_m": 1.0, "t_h": 1.0 + k}
        found = module("cone").contact_time_power_creep(**given, E=1.0, alpha=float(alpha), t_0=1.0)
        with mp.workdps(50):
            beta, k = 1 - mp.mpf(float(alpha)), mp.mpf(given["t_h"]) - 1
            low, high = mp.mpf(-2000), mp.mpf(600)
            for _ in range(80):
                size = (low + high) / 2
                u = mp.exp(size)
                # the rate of the whole since the first touch, over that of the way back
                more = mp.mpf(ratio) * u**beta > (u + k) ** beta * mp.expm1(beta * mp.log1p(1 / (u + k)))
                low, high = (low, size) if more else (size, high)
            u = mp.exp(size)
            wanted = given["t_h"] + u
            slope = beta * (k + u / (u + k + 1) / -mp.expm1(-beta * mp.log1p(1 / (u + k)))) / (u + k)
            spread = 2.0**-53 * u / (slope * wanted)
        assert abs(found / wanted - 1) < 2e-15 + 8 * float(spread), given


@pytest.mark.parametrize("law", MATERIAL)
@pytest.mark.parametrize("name", SHAPE)
def test_the_way_in_is_the_ramp_and_the_way_back_goes_on_from_it(name: str, law: str) -> None:
    inward, turn, ended = np.linspace(0.0, 0.8, 9), MOVED["t_m"], call(name, "contact_time", law)
    ramp = getattr(module(name), f"ramp_force_{law}")(inward, v=0.25, **SHAPE[name], **MATERIAL[law])
    assert (call(name, "retract_force", law, inward) == ramp).all()
    assert (call(name, "earlier_time", law, inward) == inward).all()
    after = call(name, "retract_force", law, np.array([turn * (1 + 1e-9), ended * (1 - 1e-9), ended * (1 + 1e-9), 1e9]))
    if law != "kelvin_voigt":  # its dashpot is pulled at once
        assert after[0] == pytest.approx(ramp[-1], rel=1e-4)
    assert 0.0 <= after[1] < 1e-6 * ramp[-1] + 1e-9
    assert (after[2:] == 0.0).all()
    assert (call(name, "earlier_time", law, np.array([ended * (1 + 1e-9), 1e9])) == 0.0).all()
    assert np.isnan(call(name, "retract_force", law, np.array([-1.0, np.nan]))).all()
    assert getattr(module("cone"), f"contact_time_{law}")(**MOVED, **MATERIAL[law]) == ended


def test_a_spring_goes_back_where_it_came_from() -> None:
    """Without a relaxing part the force is that of the depth on the way back, for any speed."""
    elastic = import_module("axicontact.normal.paraboloid")
    t = np.linspace(0.81, 1.49, 9)
    depth = 0.25 * 0.8 - 0.4 * np.maximum(t - 1.0, 0.0)
    wanted = elastic.force_from_depth(depth, R=1.6, E_star=1.5)
    for law, own in (
        ("standard_solid", {"E_inf": 1.5, "E_1": 0.0}), ("maxwell", {"E": 1.5, "tau": 1e14}),
        ("kelvin_voigt", {"E": 1.5, "eta": 1e-14}), ("power_creep", {"E": 1.5, "alpha": 1e-14}),
    ):  # fmt: skip
        assert call("paraboloid", "retract_force", law, t, **own, t_h=1.0) == pytest.approx(wanted, rel=1e-11), law


def test_equal_speeds_on_a_maxwell_fluid() -> None:
    """The contact ends at t_m + tau ln(2 - exp(-t_m/tau)), never later than tau ln 2 after the turn."""
    ended = call("cone", "contact_time", "maxwell", v_2=0.25)
    assert ended == pytest.approx(0.8 + 0.7 * np.log(2.0 - np.exp(-0.8 / 0.7)), rel=1e-14)
    assert call("cone", "contact_time", "maxwell", v_2=0.25, t_m=1e4) == pytest.approx(
        1e4 + 0.7 * np.log(2.0), rel=1e-15
    )


def test_a_force_may_be_a_third_too_large() -> None:
    """The approach at t_1 in place of the convolution up to it: 33 % for alpha = 0.2 at t = 1.2 t_m."""
    given = {"v_2": 0.25, "alpha": 0.2}
    earlier = call("paraboloid", "earlier_time", "power_creep", 0.96, **given)
    wrong = module("paraboloid").ramp_force_power_creep(
        earlier, R=1.6, v=0.25, **{**MATERIAL["power_creep"], "alpha": 0.2}
    )
    true = call("paraboloid", "retract_force", "power_creep", 0.96, **given)
    assert wrong / true == pytest.approx(1.33, abs=0.01)


def on_the_line(entry: Entry, change: object) -> Entry:
    (case,) = entry.cases
    return replace(entry, cases=(Case(case.chain, change(case.expr)),))


FALSE = [
    # the approach at t_1
    ("retract_pc", lambda x: x.subs(nt.time, nt.t_1)),
    ("retract_mx", lambda x: x.subs(nt.t_1, nt.time)),
    ("retract_sls", lambda x: x.subs(sp.exp((nt.t_1 - nt.time) / nt.relaxation), 1)),
    ("retract_kv", lambda x: x * (1 + nt.eta / (nt.E * nt.t_1))),
    ("earlier_mx", lambda x: x.subs(nt.v_2, 2 * nt.v_2)),
    ("earlier_mx", lambda x: 2 * nt.t_m - x),
    ("earlier_mx", lambda x: x.subs(nt.t_h, nt.t_m)),
    ("earlier_mx", lambda x: x + nt.t_h - nt.t_m),
    ("earlier_kv", lambda x: x.subs(nt.eta, 0)),
    ("earlier_kv", lambda x: x.subs(nt.t_h, nt.t_m)),
    ("earlier_pc", lambda x: x.subs(nt.alpha, -nt.alpha)),
    ("earlier_pc", lambda x: x.subs(nt.t_h, nt.t_m)),
    ("earlier_pc", lambda x: x.subs({nt.t_h: nt.t_m, nt.t_m: nt.t_h}, simultaneous=True)),
    ("earlier_sls", lambda x: sp.Eq(x.lhs, x.rhs.subs(nt.v_2, -nt.v_2))),
    ("earlier_sls", lambda x: sp.Eq(x.lhs, x.rhs.subs(nt.t_h, nt.t_m))),
    ("earlier_sls", lambda x: sp.Eq(x.lhs.subs(nt.E_1, 2 * nt.E_1), x.rhs)),
    ("end_mx", lambda x: x.subs(nt.t_m, 2 * nt.t_m)),
    ("end_mx", lambda x: x.subs(nt.t_h, nt.t_m)),
    ("end_kv", lambda x: x + nt.eta / nt.E),
    ("end_kv", lambda x: x.subs(nt.t_h, nt.t_m)),
    ("end_pc", lambda x: sp.Eq(x.lhs, x.rhs.subs(nt.t_h, nt.t_m))),
    ("end_pc", lambda x: sp.Eq(x.lhs, x.rhs.subs(nt.alpha, nt.alpha / 2))),
    ("end_sls", lambda x: sp.Eq(x.lhs, x.rhs + nt.E_1 * nt.relaxation)),
    ("radius_pc", lambda x: x.subs(nt.t_1, nt.time)),
]


QUICK = ("earlier_pc", "end_mx")
CASES = [
    pytest.param(*case, id=f"{case[0]}{i}", marks=() if case[0] in QUICK else pytest.mark.sweep)
    for i, case in enumerate(FALSE)
]


@pytest.mark.parametrize(("suffix", "change"), CASES)
def test_false_formulas_are_shown_by_neither_prover(suffix: str, change: object) -> None:
    profile, entries = load("cone"), derived("cone")
    wrong = on_the_line(entries[suffix], change)
    assert wrong != entries[suffix]
    changed = {**entries, suffix: wrong}
    assert not certify(profile, changed, suffix).proved
    plain = Problem(below("cone.vis"))
    assert Problem(record("cone.vis", changed), plain).prove(suffix)


SPRINGS = {
    "retract_mx": lambda x: x.subs(nt.t_1, 0),
    "retract_sls": lambda x: x.subs(nt.E_1, 2 * nt.E_1),
    "retract_kv": lambda x: x + 2 * nt.a * nt.v * nt.eta,
    "ramp_kv": lambda x: x.subs(nt.eta, 0),
    "ramp_pc": lambda x: x.subs(nt.t_0, 2 * nt.t_0),
    "radius_kv": lambda x: sp.Eq(x.lhs, x.rhs.subs(nt.t_1, nt.time)),
}
"""Too much is taken off, a law is too stiff, a dashpot pulls on the way back, none on the way in."""


@pytest.mark.parametrize(
    "suffix", [pytest.param(s, marks=() if s == "retract_kv" else pytest.mark.sweep) for s in SPRINGS]
)
def test_false_sums_of_springs_are_seen(suffix: str) -> None:
    """By the convolution, and by both provers where they show the true one."""
    profile, entries = load("truncated_cone"), derived("truncated_cone")
    true, wrong = entries[suffix], on_the_line(entries[suffix], SPRINGS[suffix])
    changed = {**entries, suffix: wrong}
    assert viscoelastic_checks.check(Comparison(profile, entries, digits=30, points=1), suffix).passed
    assert not viscoelastic_checks.check(Comparison(profile, changed, digits=30, points=1), suffix).passed
    assert certify(profile, entries, suffix).proved == (true.status != "integral")
    assert not certify(profile, changed, suffix).proved
    plain = Problem(below("truncated_cone.vis"))
    assert bool(Problem(record("truncated_cone.vis", entries), plain).prove(suffix)) == (true.status == "integral")
    assert Problem(record("truncated_cone.vis", changed), plain).prove(suffix)


@pytest.mark.parametrize("law", MATERIAL)
@pytest.mark.parametrize("name", ["cone", "rounded_cone"])
def test_a_program_gives_what_its_body_gives(name: str, law: str) -> None:
    """The functions run by their programs, so that no other test here sees what the text they were made of says."""
    t, own = np.linspace(0.05, 1.6, 13), {**HELD, **MATERIAL[law]}
    for kind in ("earlier_time", "retract_radius", "retract_force", "contact_time"):
        body = getattr(module(name), f"_{kind}_{law}")
        letters = body.__code__.co_varnames[: body.__code__.co_argcount]
        given = {"t": t, **own, **SHAPE[name]}
        with np.errstate(all="ignore"):
            said = body(*(np.asarray(given[letter]) for letter in letters))
        fields = (t,) if letters[0] == "t" else ()
        assert call(name, kind, law, *fields, t_h=own["t_h"]) == pytest.approx(said, rel=1e-14), kind


def graded(f: object, low: mp.mpf, high: mp.mpf) -> mp.mpf:
    """The integral of what may have any length of its own next to either end."""
    shares = [mp.mpf(10) ** -k for k in range(20, 0, -1)]
    ends = [low, *(low + (high - low) * x for x in shares), *(high - (high - low) * x for x in shares[::-1]), high]
    with mp.workdps(30):
        return mp.quad(f, ends, maxdegree=4)


def exact(name: str, law: str, known: dict) -> tuple[mp.mpf, mp.mpf]:
    """t_1 and the force by the entries, the root of an equation by bisection, a contact radius by secants."""
    entries, suffix = derived(name), next(own.suffix for own in viscoelastic.LAWS if own.name == law)
    expr = entries[f"earlier_{suffix}"].cases[0].expr
    early = evaluated(expr, known) if not isinstance(expr, sp.Eq) else mp.findroot(
        lambda t: evaluated(expr.lhs - expr.rhs, {**known, nt.t_1: t}), (mp.mpf(0), known[nt.t_m]),
        solver="anderson", tol=mp.mpf(10) ** -60, verify=False,
    )  # fmt: skip
    known = {**known, nt.t_1: early}
    force, radius = entries[f"retract_{suffix}"], entries[f"radius_{suffix}"]
    if viscoelastic.in_radius(force):
        start = import_module(f"axicontact.normal.{name}").radius_from_depth(float(known[nt.v] * early), **SHAPE[name])

        def gap(size: mp.mpf) -> mp.mpf:
            at = {**known, nt.a: start * mp.exp(size)}
            equation = case_at(radius, at).expr
            return evaluated(equation.lhs - equation.rhs, at)

        size = mp.findroot(gap, (mp.mpf(0), mp.mpf("1e-9")), tol=mp.mpf(10) ** -60, verify=False)
        known[nt.a] = start * mp.exp(size)
    return early, evaluated(case_at(force, known).expr, known, graded)


@pytest.mark.parametrize("law", MATERIAL)
@pytest.mark.parametrize("name", ["paraboloid", "power_law", pytest.param("rounded_cone", marks=pytest.mark.slow)])
def test_the_module_keeps_its_digits_over_twenty_decades(name: str, law: str) -> None:
    """To as many as one unit more of the time, of the turn or of a speed leaves."""
    draw, count, symbols = np.random.default_rng(7), 0, {nt.describe(s).letter or str(s): s for s in POINT}
    while count < 6:
        scale = {key: 10.0 ** draw.uniform(-10, 10) for key in MATERIAL[law] if key != "alpha"}
        ratio, turn = 10.0 ** draw.uniform(-10, 10), 10.0 ** draw.uniform(-2, 2) * scale.get("tau", 1.0)
        held = turn * (1.0 + 10.0 ** draw.uniform(-12, 1))
        given = {**MATERIAL[law], **scale, "v": 0.25, "v_2": 0.25 * ratio, "t_m": turn, "t_h": held}
        ended = getattr(module(name), f"contact_time_{law}")(**given)
        t = held + (ended - held) * draw.uniform(0.05, 0.7)
        with mp.workdps(60):
            known = {symbols[key]: mp.mpf(x) for key, x in {**given, **SHAPE[name], "t": t}.items() if key in symbols}
            known |= {nt.R: mp.mpf(1.6), nt.A: mp.mpf(0.7), nt.n: mp.mpf(0.4), nt.b: mp.mpf(0.25)}
            if not t > held or exact(name, law, known)[0] < 1e-3 * turn:
                continue
            wanted = exact(name, law, known)[1]
            near = [
                exact(name, law, {**known, s: known[s] * (1 + mp.mpf(2) ** -53)})[1]
                for s in (nt.time, nt.t_m, nt.t_h, nt.v_2)
            ]
            spread = max(abs(own / wanted - 1) for own in near)
        count += 1
        found = getattr(module(name), f"retract_force_{law}")(t, **SHAPE[name], **given)
        assert abs(found / wanted - 1) < 1e-14 + 8 * spread, given


def test_springs_of_single_numbers_are_those_of_arrays() -> None:
    low, high = 0.3, 2.0
    alone = single.springs(lambda x: math.exp(-x), low, high)
    along = summed.springs(lambda x: np.exp(-x), np.array(low), np.array(high))
    assert alone == pytest.approx(math.exp(-low) - math.exp(-high), rel=1e-15)
    assert abs(alone - along) <= 4.0 * np.spacing(alone)
    assert single.springs(lambda x: 1.0 / x, 1.0, 1.0) == 0.0
