"""Growth and pressure of a sphere with a steep tangent cone, against enclosures of their integrals.

Next to the break b = R sin(theta) of a needle what is past it is less than the rounding of b: at an inclination of
1e3 depth, force and slope lost 590 units of the last place for a = 1.0001 b, the pressure of the tip up to 1e5.
The part of the sphere within was a difference that cancelled next to k = -1: 1e5 units of the slope.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib import import_module

import numpy as np
import pytest
from flint import arb, ctx
from test_graded_extremes import BITS, CLOSE, TIP_UNITS, UNITS, Number, over, over_log, units

GROWN: dict[str, tuple[Callable[..., Number], Callable[..., Number]]] = {
    "depth": (lambda s, far: 1 / far, lambda s: 1 / s),
    "rate": (lambda s, far: 1 / far + 1 / far**3, lambda s: 1 / s),
    "force": (lambda s, far: s * s / far, lambda s: s),
}
"""What z**k is multiplied by within a break of the unit sphere, with far = sqrt(1 - s**2), and beyond it."""


def grown(name: str, a: float, theta: float, own: float) -> Number:
    """Depth, its rate g'(a) and the force over 2 H/(1 + k): integrals over z = sqrt(a**2 - s**2), for a > b."""
    ctx.prec = BITS
    a, k, b, end = arb(a), arb(own), arb(theta).sin(), arb(theta).cos()
    root, (cap, flank) = ((a - b) * (a + b)).sqrt(), GROWN[name]
    turn = min(root, a / 2)
    low = turn * arb(CLOSE)
    beyond = low * low**k * flank(a) / (1 + k)
    beyond += over_log(lambda z: z**k * flank(((a - z) * (a + z)).sqrt()), low, turn)
    if root > turn:
        beyond += over(lambda y: (a * y.sin()) ** k * flank(a * y.cos()) * a * y.cos(), arb.pi() / 6, (root / a).asin())
    # from the z at which the sphere ends
    sphere = ((root - end) * (root + end)).sqrt() if root > end else arb(0)

    def within(y: Number) -> Number:
        z = sphere + y
        more = (z - root) * (z + root)
        return z**k * cap((abs(b * b - more)).sqrt(), (end * end + more).sqrt())

    power = {"depth": a * a**-k, "rate": a**-k, "force": arb(1)}[name]
    return power * (arb(theta).tan() * beyond + over_log(within, root - sphere, a - sphere))


def check_growth(slope: float, ratio: float, k: float) -> None:
    theta = math.atan(slope)
    a, module = ratio * math.sin(theta), import_module("axicontact.graded.normal.sphere_tipped_cone")
    found = {
        "depth": module.depth(a, R=1.0, theta=theta, k=k),
        "force": module.force(a, R=1.0, theta=theta, H=(1.0 + k) / 2.0, k=k),
    }
    for name, value in found.items():
        error = units(value, grown(name, a, theta, k))
        assert error <= TIP_UNITS, (name, slope, ratio, k, error)


@pytest.mark.parametrize(("slope", "ratio", "k"), [(32.0, 1.001, -0.5), (1e3, 1.0001, 0.3), (1e6, 1.0 + 1e-8, 0.6)])
def test_growth_of_a_steep_flank(slope: float, ratio: float, k: float) -> None:
    check_growth(slope, ratio, k)


@pytest.mark.parametrize(("ratio", "k"), [(1.0001, 0.3), (1.000001, -1.0 + 1e-12)])
def test_rate_of_a_steep_flank(ratio: float, k: float) -> None:
    """That of the adhesive contact, which finds its pull-off by it."""
    theta, module = math.atan(1e3), import_module("axicontact.graded.normal.sphere_tipped_cone")
    a = ratio * math.sin(theta)
    (found,) = module._rate(*(np.array([x]) for x in (a, 1.0, theta, k)))
    assert units(found, grown("rate", a, theta, k)) <= TIP_UNITS


def test_rate_of_a_steep_flank_on_the_homogeneous_half_space() -> None:
    theta, module = math.atan(1e3), import_module("axicontact.adhesive.sphere_tipped_cone")
    a = 1.0001 * math.sin(theta)
    with np.errstate(invalid="ignore"):
        (found,) = module._rate(np.array([a]), 1.0, theta)
    assert units(found, grown("rate", a, theta, 0.0)) <= TIP_UNITS


def homogeneous(r: Number, a: Number, theta: float) -> Number:
    """pi p/H for k = 0 and r < b < a, where g' is closed: of the sphere up to b, of its cap and of the cone beyond."""
    ctx.prec = BITS
    r, a, b, end, slope = arb(r), arb(a), arb(theta).sin(), arb(theta).cos(), arb(theta).tan()
    base = ((b - r) * (b + r)).sqrt()
    scale = ((1 - r) * (1 + r)).sqrt()

    def tip(tangent: Number) -> Number:
        # sqrt(t**2 - r**2) is scale times the sine of this tangent
        secant = (1 + tangent * tangent).sqrt()
        t, far = (r * r + (scale * tangent / secant) ** 2).sqrt(), scale / secant
        return (t.atanh() / t + 1 / far**2) * scale / secant**3

    def beyond(root: Number) -> Number:
        t, square = (b * b + root * root).sqrt(), (end - root) * (end + root)
        cap = ((t + 1) / (root + end)).log() + (t - root / end) / square
        return (cap + slope * arb.atan2(root, b)) * root / t / (root * root + base * base).sqrt()

    top, last = base / end, ((a - b) * (a + b)).sqrt()
    low = min(top, arb(1)) * arb(CLOSE)
    return low * tip(low) + over_log(tip, low, top) + over_log(beyond, min(last, end) * arb(CLOSE), last)


def check_pressure(slope: float, place: float, ratio: float) -> None:
    theta = math.atan(slope)
    b, module = math.sin(theta), import_module("axicontact.graded.normal.sphere_tipped_cone")
    found = module.pressure(place * b, ratio * b, R=1.0, theta=theta, H=1.0, k=0.0)
    error = units(found, homogeneous(place * b, ratio * b, theta) / arb.pi())
    assert error <= UNITS, (slope, place, ratio, error)


@pytest.mark.parametrize(("slope", "place", "ratio"), [(1e3, 0.5, 2.0), (1e6, 0.999, 1.0001)])
def test_pressure_in_a_steep_tip(slope: float, place: float, ratio: float) -> None:
    check_pressure(slope, place, ratio)


@pytest.mark.parametrize("length", [1e-200, 1e200])
def test_lengths_whose_squares_leave_the_range_of_doubles(length: float) -> None:
    """They are repeated with numbers of any exponent, of which a rule must use only what those know."""
    value = import_module("axicontact.graded.normal.sphere_tipped_cone").pressure
    wanted = value(0.4, 2.0, R=1.2, theta=0.45, H=1.0, k=0.0)
    found = value(0.4 * length, 2.0 * length, R=1.2 * length, theta=0.45, H=1.0, k=0.0)
    assert found == pytest.approx(wanted, rel=3e-15, abs=0.0)


@pytest.mark.slow
@pytest.mark.parametrize("slope", [1e-3, 1.0, 32.0, 1e3, 1e6])
def test_growth_and_pressure_of_every_flank(slope: float) -> None:
    for ratio in (1.0 + 1e-12, 1.0 + 1e-8, 1.0001, 1.01, 2.0, 1e2):
        for k in (-1.0 + 1e-12, -0.9, -0.5, 0.0, 0.3, 0.95, 1.0 - 1e-12):
            check_growth(slope, ratio, k)
        for place in (1e-6, 0.5, 0.999):
            check_pressure(slope, place, ratio)
