"""Emitted modules of the graded half-space: inverses, pull-off, stick radius, least depth."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from graded_modules import EXPONENTS, POWERS, SLOW, derived, emitted, keywords, values
from selected import in_turn
from test_inverse_steps import MISSED, STEPS, arguments, counted, missed

from axiderive import notation as nt
from axiderive.code import example
from axiderive.profiles import COMPACT_NAMES, load


@pytest.mark.parametrize(("name", "k"), in_turn([n for n in COMPACT_NAMES if n not in SLOW], ("-0.9", "0.5")))
def test_inverses_return(name: str, k: str) -> None:
    check_inverses(name, k)


@pytest.mark.sweep
@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_inverses_of_every_profile(name: str, k: str) -> None:
    check_inverses(name, k)


def check_inverses(name: str, k: str) -> None:
    profile, module, known = load(name), emitted(f"normal.{name}"), values(load(name), k)
    low = float(known[profile.breaks[0]]) if profile.truncated else 0.0
    high = float(known[nt.a])
    high = {"gaussian": 0.9, "sphere": high, "ellipsoid": high}.get(name, 20.0 * high)
    a = low + (high - low) * np.array([1e-6, 1e-3, 0.02, 0.1, 0.5, 0.9, 1.0])
    for quantity, other in (("depth", "force"), ("force", "depth")):
        load_of, radius = getattr(module, quantity), getattr(module, f"radius_from_{quantity}")
        value = load_of(a, **keywords(load_of, profile, known))
        found = radius(value, **keywords(radius, profile, known))
        np.testing.assert_allclose(found, a, rtol=1e-14 if name in POWERS else 2e-14)
        through = getattr(module, f"{other}_from_{quantity}")
        direct = getattr(module, other)
        # at the radius of the load: the one found is rounded, which costs 1e-11 of a force 1e-6 beyond a break
        expected = direct(a, **keywords(direct, profile, known))
        np.testing.assert_allclose(through(value, **keywords(through, profile, known)), expected, rtol=1e-13)


VERTICAL = 2e-15
"""Measured 9e-16."""
GAPS = (0.9, 6e-12, 1e-15, 1e-17, 1e-60, 1e-300)


@cache
def loads_of_a_vertical_end(gap: float, k: float) -> tuple[mp.mpf, mp.mpf, mp.mpf]:
    """Radius, depth and force of a sphere of radius 1 for H = 1: f'(cos y) sin(y)**k over a quarter turn.

    Integrated over s = sin(y), with its power taken into the variable up to the distance to the end, beyond in ln s.
    """
    with mp.workdps(25):
        a, power = 1 - mp.mpf(gap), 1 + mp.mpf(k)
        low = mp.sqrt(gap * (2 - mp.mpf(gap))) / a
        first = min(low, mp.mpf(1))
        ends = mp.linspace(0, -mp.log(first), 2 + int(-mp.log(first) / 6))

        def whole(weight: Callable[[mp.mpf], mp.mpf]) -> mp.mpf:
            def slope(s: mp.mpf) -> mp.mpf:
                return weight(s) / mp.sqrt(low * low + s * s)

            near = first**power / power * mp.quad(lambda u: slope(first * u ** (1 / power)), [0, 0.5, 1])
            return near + mp.quad(lambda x: mp.exp(-power * x) * slope(mp.exp(-x)), ends) if low < 1 else near

        force = 2 / power * a ** (1 + power) * whole(lambda s: 1 - s * s)
        return a, a * whole(lambda s: mp.mpf(1)), force


@pytest.mark.parametrize("name", ["sphere", "ellipsoid"])
@pytest.mark.parametrize("k", (-0.9, -0.5, 1e-9, 0.355, 0.999))
def test_loads_are_known_where_the_radius_is_the_largest(name: str, k: float) -> None:
    """Both loads go on growing over 300 decades of 1 - a/b, of which a radius keeps sixteen: none were left."""
    own = {"R": 1.3} if name == "sphere" else {"h": 0.7, "b": 1.3}
    module, given, power = emitted(f"normal.{name}"), {**own, "H": 2.5, "k": k}, 1 + mp.mpf(k)
    h, b, unit = own.get("h", 1.3), 1.3, 2.5 * own.get("h", 1.3) * mp.mpf(1.3) ** power
    # quadratures of the steepest ones take a second each
    gaps = GAPS[::2] if k < -0.1 else GAPS
    states = [(b * a, h * d, unit * F) for a, d, F in (loads_of_a_vertical_end(gap, k) for gap in gaps)]
    a = np.array([float(state[0]) for state in states])
    d, F = (np.array([float(state[i]) for state in states]) for i in (1, 2))
    # those of the doubles, by dF/dd = 2 H/(1 + k) a**(1 + k)
    stiffness = [2 * 2.5 / power * state[0] ** power for state in states]
    forces = [float(f + c * (x - y)) for x, c, (_, y, f) in zip(d, stiffness, states, strict=True)]
    depths = [float(y + (x - f) / c) for x, c, (_, y, f) in zip(F, stiffness, states, strict=True)]
    np.testing.assert_allclose(module.force_from_depth(d, **given), forces, rtol=VERTICAL)
    np.testing.assert_allclose(module.depth_from_force(F, **given), depths, rtol=VERTICAL)
    np.testing.assert_allclose(module.radius_from_depth(d, **own, k=k), a, rtol=VERTICAL)
    np.testing.assert_allclose(module.radius_from_force(F, **given), a, rtol=VERTICAL)
    assert [module.force_from_depth(float(x), **given) for x in d] == pytest.approx(forces, rel=VERTICAL, abs=0.0)
    last = module.depth(b, **own, k=k)
    assert last == (pytest.approx(h / k, rel=1e-15) if k > 0.0 else math.inf)
    if k > 0.0:
        greatest = module.force(b, **given)
        assert module.force_from_depth(last, **given) == pytest.approx(greatest, rel=VERTICAL, abs=0.0)
        assert math.isnan(module.force_from_depth(1.001 * last, **given))
        assert math.isnan(module.depth_from_force(1.001 * greatest, **given))


@pytest.mark.parametrize("k", (-0.9, -0.3, 0.0, 0.6))
@pytest.mark.parametrize("name", ["truncated_cone", "truncated_paraboloid", "rounded_punch"])
def test_loads_are_known_where_the_radius_is_that_of_the_face(name: str, k: float) -> None:
    """A contact that has hardly passed its face carries what the face does: 2 H/(1 + k) b**(1 + k) d."""
    profile, module = load(name), emitted(f"normal.{name}")
    given = keywords(module.force_from_depth, profile, values(profile, str(k)))
    d = np.array([1e-60, 1e-120, 1e-250]) if name == "rounded_punch" else 1e-9 ** (1.0 + k) * np.array([1e-3, 1e-40])
    F = 2.0 * given["H"] / (1.0 + k) * given["b"] ** (1.0 + k) * d
    np.testing.assert_allclose(module.force_from_depth(d, **given), F, rtol=4e-15)
    np.testing.assert_allclose(module.depth_from_force(F, **given), d, rtol=4e-15)


@pytest.mark.parametrize("k", (0.05, 0.5, 0.9))
@pytest.mark.parametrize("control", ["force", "depth"])
def test_no_adhesive_contact_has_more_than_the_largest_load(control: str, k: float) -> None:
    """For k > 0 the loads of a sphere end at its equator; the largest radius was given for any beyond."""
    module, given = emitted("adhesive.sphere"), {"R": 1.3, "H": 2.5, "k": k, "dgamma": 0.02}
    last = getattr(module, control)(1.3, **given)
    inverse = getattr(module, f"radius_from_{control}")
    assert inverse(last * (1.0 - 1e-12), **given) == pytest.approx(1.3, rel=1e-9)
    assert math.isnan(inverse(last * (1.0 + 1e-12), **given))


@pytest.mark.parametrize("k", (-0.5, 0.0, 0.5, 0.95))
@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_where_the_radius_is_the_largest(control: str, k: float) -> None:
    """Where adhesion is all, the sphere pulls off as the flat punch of its radius; it was NaN."""
    R, H, dgamma = 1.3, 2.5, 1e38
    state = emitted("adhesive.sphere").pull_off(control, R=R, H=H, k=k, dgamma=dgamma)
    moved = math.sqrt(2.0 * math.pi * dgamma * R ** (1.0 - k) / H)
    assert state == pytest.approx((R, -2.0 * H / (1.0 + k) * R ** (1.0 + k) * moved, -moved), rel=1e-14, abs=0.0)


@pytest.mark.parametrize(("name", "k"), in_turn([n for n in COMPACT_NAMES if n not in SLOW], ("-0.5", "0.9")))
@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_is_the_least_load(name: str, k: str, control: str) -> None:
    check_pull_off(name, k, control)


@pytest.mark.sweep
@pytest.mark.parametrize("k", EXPONENTS)
@pytest.mark.parametrize("name", COMPACT_NAMES)
@pytest.mark.parametrize("control", ["force", "depth"])
def test_pull_off_of_every_profile(name: str, k: str, control: str) -> None:
    check_pull_off(name, k, control)


def check_pull_off(name: str, k: str, control: str) -> None:
    profile, module, known = load(name), emitted(f"adhesive.{name}"), values(load(name), k)
    given = keywords(module.pull_off, profile, known)
    state = module.pull_off(control, **given)
    least = getattr(state, control)
    around = state.radius * (1.0 + np.array([-1e-3, -1e-5, 1e-5, 1e-3, 0.1]))
    loads = getattr(module, control)(around, **given)
    assert np.all(np.isnan(loads) | (loads >= least * (1 + 1e-13)))
    assert getattr(module, control)(state.radius, **given) == pytest.approx(least, rel=1e-12, abs=0.0)
    inverse = getattr(module, f"radius_from_{control}")
    assert inverse(least, **given) == pytest.approx(state.radius, rel=1e-6)
    assert math.isnan(inverse(least * 1.001, **given))
    a = state.radius * np.array([1.01, 1.1, 1.3])
    value = getattr(module, control)(a, **given)
    np.testing.assert_allclose(inverse(value, **given), a, rtol=1e-12)


@pytest.mark.parametrize(("name", "k"), in_turn(2 * [name for name in POWERS if name != "polynomial"], EXPONENTS))
def test_pull_off_of_power_laws(name: str, k: str) -> None:
    profile, module = load(name), emitted(f"adhesive.{name}")
    # the doubles that the module is given: a cone takes up the rounding of k = -0.9 hundreds of times
    known = {symbol: sp.Float(float(value), 40) for symbol, value in values(profile, k).items()}
    entries = derived("adhesive", name)
    for control, names in (("force", ("ac", "Fc", "dc")), ("depth", ("am", "Fm", "dm"))):
        state = module.pull_off(control, **keywords(module.pull_off, profile, known))
        radius = entries[names[0]].cases[0].expr
        a_c = example.number(radius, known)
        # and the power of dgamma, ten for it, the rounding of what is raised to that
        power = math.log2(example.number(radius, known | {nt.dgamma: 2 * known[nt.dgamma]}) / a_c)
        for suffix, found in zip(names, state, strict=True):
            expected = float(example.number(entries[suffix].cases[0].expr, known | {nt.a_c: a_c}))
            assert found == pytest.approx(expected, rel=1.2e-14 * (1.0 + power), abs=0.0), suffix


def test_pull_off_of_the_graded_sphere() -> None:
    """-(3 + k)/2 pi dgamma R under force control."""
    sphere = emitted("adhesive.paraboloid")
    k = np.array([-0.9, -0.5, 0.0, 0.4, 0.95])
    force = sphere.pull_off(R=2.0, H=1e3, k=k, dgamma=0.3).force
    np.testing.assert_allclose(force, -(3 + k) / 2 * math.pi * 0.3 * 2.0, rtol=1e-14)


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_stick_radius_returns(name: str) -> None:
    profile, module, known = load(name), emitted(f"tangential.{name}"), values(load(name), "-0.4")
    low = known[profile.breaks[0]] if profile.truncated else sp.S.Zero
    for part in ("0.3", "0.7", "0.99"):
        c = float(low + (known[nt.a] - low) * sp.Rational(part))
        force = module.tangential_force(float(known[nt.a]), c, **keywords(module.tangential_force, profile, known))
        given = keywords(module.stick_radius, profile, known)
        assert module.stick_radius(force, float(known[nt.a]), **given) == pytest.approx(c, rel=1e-13, abs=0.0)
        assert math.isnan(module.stick_radius(10.0 * force + 10.0, float(known[nt.a]), **given))


@pytest.mark.parametrize("k", ("-0.6", "0.3"))
@pytest.mark.parametrize("n", (1.8, 3.7))
def test_least_depth_of_a_concave_face(n: float, k: str) -> None:
    """At d_min the pressure touches zero, at the ring or, for n <= 2, at the centre."""
    face, given = emitted("normal.concave_power"), {"a": 1.5, "h": 0.2, "n": n, "k": float(k)}
    depth, ring = face.minimum_depth(**given), face.zero_radius(**given)
    assert (ring == 0.0) == (n <= 2.0)
    r = np.linspace(0.0, 1.49, 1000)
    p = face.pressure(r, depth, **given, H=2.0)
    scale = face.pressure(0.0, 2 * depth, **given, H=2.0)
    assert face.pressure(ring, depth, **given, H=2.0) == pytest.approx(0.0, abs=1e-13 * scale)
    assert p.min() > -1e-13 * scale
    assert face.minimum_force(**given, H=2.0) == pytest.approx(face.force(depth, **given, H=2.0), rel=1e-14, abs=0.0)
    assert face.depth_from_force(face.minimum_force(**given, H=2.0), **given, H=2.0) == pytest.approx(
        depth, rel=1e-13, abs=0.0
    )


@pytest.mark.parametrize(("name", "n"), [("concave_paraboloid", 2.0), ("concave_quartic", 4.0)])
@pytest.mark.parametrize("k", (-0.6, 0.3))
def test_special_concave_faces_are_those_of_the_law(name: str, n: float, k: float) -> None:
    """Their pressures and least depths are closed, that of the law is a rule and a search."""
    face, law, given = emitted(f"normal.{name}"), emitted("normal.concave_power"), {"a": 1.5, "h": 0.2, "k": k}
    least = face.minimum_depth(**given)
    assert least == pytest.approx(law.minimum_depth(**given, n=n), rel=4e-15, abs=0.0)
    assert face.zero_radius(**given) == pytest.approx(law.zero_radius(**given, n=n), rel=4e-15, abs=0.0)
    r = np.linspace(0.0, 1.49, 40)
    exact = law.pressure(r, 1.3 * least, **given, n=n, H=2.0)
    np.testing.assert_allclose(face.pressure(r, 1.3 * least, **given, H=2.0), exact, rtol=2e-13)
    for module, more in ((face, {}), (law, {"n": n})):
        beyond = module.pressure(np.array([1.5, 1.6]), 1.3 * least, **given, **more, H=2.0)
        assert beyond.tolist() == [math.inf, 0.0]
    assert np.isnan(face.pressure(r, 0.999 * least, **given, H=2.0)).all()


@pytest.mark.parametrize("k", (-0.6, 0.3))
@pytest.mark.parametrize("power", [-450, 900])
@pytest.mark.parametrize("name", ["sphere", "rounded_punch", "capped_paraboloid"])
def test_adhesive_inverses_far_out(name: str, power: int, k: float) -> None:
    """The cubes of such radii are no doubles, nor are those of the lengths of the profile."""
    unit, module = 2.0**power, emitted(f"adhesive.{name}")
    own = {"sphere": {"R": 1.0}, "rounded_punch": {"R": 2.0, "b": 0.5}}.get(name, {"R1": 2.0, "R2": 1.0, "b": 0.3})
    given = {key: value * unit for key, value in own.items()}
    given |= {"H": 2.0 ** (-power * (0.5 + k)), "dgamma": 0.05 * 2.0 ** (power / 2), "k": k}
    for control in ("force", "depth"):
        a = 1.3 * module.pull_off(control, **given).radius
        load = getattr(module, control)(a, **given)
        if 0.0 < abs(load) < math.inf:
            assert getattr(module, f"radius_from_{control}")(load, **given) == pytest.approx(a, rel=2e-14, abs=0.0)
        else:
            assert control == "force"
            assert abs(power) == 900


@pytest.mark.parametrize(
    ("R", "theta", "k", "beyond"),
    [
        (0.3174450131987351, 1.570418062292487, 0.41116877284748965, 2.353672812205332e-14),
        (52.79464147169762, 1.5707942272547115, 1.188828937296306e-12, 1.865174681370263e-14),
        (0.0010450104267523135, 1.5707829109038018, -0.9651225609589957, 9.352894445591176e-07),
    ],
)
def test_graded_contact_beside_a_steep_tip(
    R: float, theta: float, k: float, beyond: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where a unit of the radius is thousands of the depth: 101, 65 and 19 units missed before, in up to 72 steps."""
    module = emitted("normal.sphere_tipped_cone")
    calls, known = counted(module, monkeypatch), {"R": R, "theta": theta, "k": k, "H": 0.5}
    for quantity in ("depth", "force"):
        forward, inverse = getattr(module, f"_{quantity}"), getattr(module, f"_radius_from_{quantity}")
        with np.errstate(all="ignore"):
            value = forward(np.array([R * np.sin(theta) * (1.0 + beyond)]), *arguments(forward, known))
            calls[0] = 0
            found = inverse(value, *arguments(inverse, known))
            steps = calls[0]
            assert missed(forward, found, value, known) <= MISSED
        assert steps <= STEPS
