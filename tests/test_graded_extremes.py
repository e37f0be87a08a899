"""Pressure and displacement of graded contacts far beyond a break and next to it, against enclosures of g'(t).

The rules of the pressure used nodes for twenty decades at most, and took up the roundings of a longer path: of 1008
points each 8e11 units of the last place beside a corner, 9e12 in a rounded cone, all for a/b = 1e200; at r = b they
took the next double instead, which is 1e-8 off.  That of the displacement met the singularity of a sphere just beyond
a steep flank.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from functools import cache, partial
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

UNITS = 22.5
"""5e-15 in units of 2**-52; 10.3 is the most of 4032 points."""
TIP_UNITS = 4.5
"""3.3 is the most of the 924 points of a tip below."""
NODES, BITS, CLOSE = 12, 140, 1e-20
BODIES: dict[str, dict[str, float]] = {
    "truncated_cone": {"theta": 0.36},
    "truncated_paraboloid": {"R": 1.0},
    "rounded_punch": {"R": 1.0},
    "rounded_cone": {"theta": 0.36},
}
GRADINGS = (-1.0 + 1e-15, -0.9, -0.6, -0.2, 1e-9, 0.2, 0.6, 0.9, 1.0 - 1e-15)
Number = Any


@cache
def gauss() -> list[tuple[Number, Number]]:
    pairs = [arb.legendre_p_root(NODES, i, weight=True) for i in range(NODES)]
    return [((x + 1) / 2, w / 2) for x, w in pairs]


def hypergeometric(p: Number, q: Number, s: Number, z: Number) -> Number:
    term, total, n = arb(1), arb(1), 0
    while not abs(term) < arb(2) ** -BITS * abs(total):
        term *= (p + n) * (q + n) / ((s + n) * (n + 1)) * z
        total, n = total + term, n + 1
    return total


def over(integrand: Callable[[Number], Number], start: Number, stop: Number, longest: float = 1.0) -> Number:
    panels = max(1, math.ceil(float(stop - start) / longest))
    step = (stop - start) / panels
    return sum(
        (w * step * integrand(start + (panel + x) * step) for panel in range(panels) for x, w in gauss()), arb(0)
    )


def over_log(integrand: Callable[[Number], Number], low: Number, top: Number) -> Number:
    return over(lambda x: low * x.exp() * integrand(low * x.exp()), arb(0), (top / low).log())


def rate(name: str, t: Number, root: Number, b: Number, k: Number) -> Number:
    """g'(t) beyond the break, of f' = 1, r, r - b or 1 after r/b."""
    sine, cosine = root / t, b / t
    power = sine * sine**k / (1 + k)
    if name == "truncated_paraboloid":
        return t * (2 * power + cosine**2 * sine ** (k - 1))
    if float(cosine) < 0.72:
        whole = arb.pi().sqrt() * ((1 + k) / 2).gamma() / (2 * (1 + k / 2).gamma())
        angle = whole - cosine * hypergeometric(arb(0.5), (1 - k) / 2, arb(1.5), cosine**2)
        log = (-cosine * cosine).log1p() / 2
    else:
        angle, log = power * hypergeometric(arb(0.5), (1 + k) / 2, (3 + k) / 2, sine**2), sine.log()
    if name == "truncated_cone":
        return angle + cosine * sine ** (k - 1)
    if name == "rounded_punch":
        return 2 * t * power - b * angle
    return angle - 2 * t / b * ((1 + k) * log).expm1() / (1 + k)


def pressure(name: str, r: float, a: float, b: float, k: float) -> Number:
    """pi p/H for unit slopes, with panels in the logarithm of the distance to the larger of r and b, r not b."""
    ctx.prec = BITS
    r, a, b, k = arb(r), arb(a), arb(b), arb(k)
    outer = max(r, b)
    base, top = (abs((r - b) * (r + b))).sqrt(), ((a - outer) * (a + outer)).sqrt()

    def integrand(y: Number) -> Number:
        other = (base * base + y * y).sqrt()
        root, u = (y, other) if r < b else (other, y)
        t = (b * b + root * root).sqrt()
        return rate(name, t, root, b, k) * u ** (k - 1) * y / t

    low = min(base, top) * arb(CLOSE)
    total = low * integrand(low) / (1 + k) + over_log(integrand, low, top)
    if name == "rounded_cone" and r < b:
        total += 2 / b / (1 + k) ** 2 * base * base**k
    return total


def units(got: float, wanted: Number) -> float:
    return float(abs(arb(float(got)) / wanted - 1)) * 2.0**52


def check(name: str, r: float, a: float, b: float, k: float) -> None:
    known, module = BODIES[name], import_module(f"axicontact.graded.normal.{name}")
    wanted = pressure(name, r, a, b, k) / arb.pi()
    wanted *= arb(known["theta"]).tan() if "theta" in known else 1
    if 1e-290 < abs(float(wanted)) < 1e290:
        error = units(module.pressure(r, a, **known, b=b, H=1.0, k=k), wanted)
        assert error <= UNITS, (name, r, a, b, k, error)


def drawn(draw: random.Random, widest: float, closest: float) -> tuple[float, float, float, float]:
    """r, a, b and k: the radius next to the break, to the edge and to the axis, and between all of them."""
    b = 10 ** draw.uniform(-widest / 2, -widest / 3)
    a = b * (1 + 10 ** draw.uniform(*draw.choice(((-closest, 0), (0, 6), (0, widest)))))
    near = 10 ** draw.uniform(-closest, 0)
    r = draw.choice((b * (1 - near), b * (1 + near), a * (1 - near), b * near, b * (a / b) ** draw.random()))
    return r, a, b, draw.choice(GRADINGS)


# the longest path, both sides of the break, a power that falls and one that grows
@pytest.mark.parametrize(
    ("name", "ratio", "place", "k"),
    [
        ("truncated_cone", 1e100, 0.999, -0.9),
        ("rounded_cone", 1e100, 1.01, -0.6),
    ],
)
def test_pressure_far_beyond_a_break(name: str, ratio: float, place: float, k: float) -> None:
    b = 1e-100
    check(name, b * place, b * ratio, b, k)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize(("widest", "closest"), [(6.0, 6.0), (200.0, 12.0)], ids=["bench", "extreme"])
def test_pressure_over_both_domains(name: str, widest: float, closest: float) -> None:
    draw = random.Random(f"{name} {widest}")
    for _ in range(100):
        r, a, b, k = drawn(draw, widest, closest)
        if b != r < a:
            check(name, r, a, b, k)


# of f' = 1 and r where that is finite; a distance of 1e-16 b is 16 % of the value for k = 0.05, 69 % for 0.01
@pytest.mark.parametrize(
    ("name", "k"),
    [
        ("truncated_cone", 0.05),
        ("truncated_cone", 0.01),
        ("truncated_paraboloid", 0.2),
        ("rounded_cone", -0.98),
        ("rounded_punch", 0.5),
    ],
)
def test_pressure_at_a_break(name: str, k: float) -> None:
    """Where r is b its distance is a power of the root: with y = sqrt(a**2 - b**2) x**(1/power) the path is smooth."""
    ctx.prec = BITS
    own, b, top = arb(k), arb(1.0), arb(3.0).sqrt()
    power = {"rounded_punch": arb(1), "rounded_cone": 1 + own}.get(name, 2 * own)

    def integrand(x: Number) -> Number:
        y = top * x ** (1 / power)
        t = (b * b + y * y).sqrt()
        return rate(name, t, y, b, own) * y**own * (y / t) / (power * x)

    value = over(integrand, arb(0), arb(1), 1 / 64) / arb.pi()
    slope = arb(BODIES[name]["theta"]).tan() if "theta" in BODIES[name] else 1
    module = import_module(f"axicontact.graded.normal.{name}")
    assert units(module.pressure(1.0, 2.0, **BODIES[name], b=1.0, H=1.0, k=k), value * slope) <= UNITS


@pytest.mark.parametrize("k", [-0.6, 1e-9, 0.3])
@pytest.mark.parametrize("name", ["rounded_cone", "rounded_punch"])
def test_pressure_at_a_break_is_that_of_its_limit(name: str, k: float) -> None:
    """Where the slope is continuous so is the pressure: at r = b it may not differ by 1e-8 from the doubles beside."""
    module = import_module(f"axicontact.graded.normal.{name}")
    value = partial(module.pressure, **BODIES[name], b=1.0, H=1.0, k=k)
    at, below, above = value(np.array([1.0, 1.0 - 1e-15, 1.0 + 1e-15]), 2.0)
    assert at == pytest.approx((below + above) / 2, rel=1e-6 if k < 0 else 1e-12, abs=0.0)


@pytest.mark.parametrize("name", [*BODIES, "sphere_tipped_cone"])
@pytest.mark.parametrize("ratio", [1e6, 1e12])
def test_displacement_far_within_a_contact(name: str, ratio: float) -> None:
    """w = d - f(r) at the tip of a large contact: from distances to its edge it lost 2e5 units at a/b = 2e6."""
    module = import_module(f"axicontact.graded.normal.{name}")
    known = BODIES.get(name, {"R": 1.0 / math.sin(0.3), "theta": 0.3}) | ({"b": 1.0} if name in BODIES else {})
    for place in (0.0, 0.4, 1.5, math.sqrt(ratio)):
        found = module.displacement(place, ratio, **known, k=0.3) + module.profile(place, **known)
        assert found == pytest.approx(module.depth(ratio, **known, k=0.3), rel=3e-15, abs=0.0)


def tipped(r: float, a: float, theta: float, k: float) -> Number:
    """w of a sphere of unit radius and its tangent cone: d - f(r) within, the integral of d - f over z outside."""
    ctx.prec = BITS
    r, a, theta, k = arb(r), arb(a), arb(theta), arb(k)
    b, end, slope = theta.sin(), theta.cos(), theta.tan()
    root, q = ((a - b) * (a + b)).sqrt(), (abs(r - a) * (r + a)).sqrt()

    def total(flank: Callable[[Number, Number], Number], cap: Callable[[Number, Number], Number]) -> Number:
        """Integral of z**k flank(z, s) beyond the break, and of z**k cap(z, sqrt(1 - s**2)) within."""
        turn = min(root, a / 2)
        low = (min(turn, q) if r > a else turn) * arb(CLOSE)
        value = low * low**k * flank(low, a) / (1 + k)
        value += over_log(lambda z: z**k * flank(z, ((a - z) * (a + z)).sqrt()), low, turn)
        if root > turn:
            last = arb.atan2(root, b)
            value += over(
                lambda y: (a * y.sin()) ** k * flank(a * y.sin(), a * y.cos()) * a * y.cos(), arb.pi() / 6, last, 0.2
            )
        # from the z at which the sphere ends
        sphere = ((a - 1) * (a + 1)).sqrt() if a > 1 else arb(0)

        def within(y: Number) -> Number:
            z = sphere + y
            return z**k * cap(z, (end * end + (z - root) * (z + root)).sqrt())

        return value + over_log(within, root - sphere, a - sphere)

    d = a * a**-k * total(lambda z, s: slope / s, lambda z, far: 1 / far)
    if r <= a:
        return d - (1 - ((1 - r) * (1 + r)).sqrt() if r < b else 1 - end + slope * (r - b))
    free = total(
        lambda z, s: (d - (1 - end) - slope * (s - b)) / (q * q + z * z),
        lambda z, far: (d - (1 - far)) / (q * q + z * z),
    )
    return 2 / arb.pi() * (arb.pi() * k / 2).cos() * q * q**-k * free


def check_tip(slope: float, k: float, a: float, r: float) -> None:
    theta, module = math.atan(slope), import_module("axicontact.graded.normal.sphere_tipped_cone")
    error = units(module.displacement(r, a, R=1.0, theta=theta, k=k), tipped(r, a, theta, k))
    assert error <= TIP_UNITS, (slope, k, a, r, error)


# the sphere next to the path, within and outside; a contact that has hardly passed the break, of which a - b is left
@pytest.mark.parametrize(
    ("slope", "k", "a", "r"),
    [(14.0, 0.2, 1.37, 0.0), (32.0, 0.6, 1.37, 2.74), (1e3, 0.6, 1.0001 * math.sin(math.atan(1e3)), 0.4)],
)
def test_displacement_of_a_steep_flank(slope: float, k: float, a: float, r: float) -> None:
    check_tip(slope, k, a, r)


@pytest.mark.slow
@pytest.mark.parametrize("slope", [0.03, 1.0, 9.0, 14.0, 32.0, 1e3, 1e6])
@pytest.mark.parametrize("k", [-0.6, 0.2, 0.6])
def test_displacement_of_every_flank(slope: float, k: float) -> None:
    b = math.sin(math.atan(slope))
    for a in (1.0001 * b, max(1.0, 1.0001 * b), 1.37, 10.0):
        for r in (0.0, b / 2, b, (a + b) / 2, a, *(a * more for more in (1 + 1e-9, 1.001, 1.1, 2.0, 30.0, 1e3))):
            check_tip(slope, k, a, r)
