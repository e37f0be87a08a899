"""Pressure and displacement of graded contacts far beyond a break and next to it, against enclosures of g'(t).

The rules of the pressure used nodes for twenty decades at most, and took up the roundings of a longer path: of 1008
points each 8e11 units of the last place beside a corner, 9e12 in a rounded cone, all for a/b = 1e200; at r = b they
took the next double instead, which is 1e-8 off.
"""

from __future__ import annotations

import math
import random
from functools import cache, partial
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from flint import arb, ctx

UNITS = 22.5
"""5e-15 in units of 2**-52; 10.3 is the most of 4032 points."""
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
    total = low * integrand(low) / (1 + k)
    panels = math.ceil(float((top / low).log()))
    step = (top / low).log() / panels
    for panel in range(panels):
        for x, w in gauss():
            y = low * ((panel + x) * step).exp()
            total += w * step * y * integrand(y)
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


# of f' = 1 and r where that is finite; a distance of 1e-16 b is 16 % of the value for k = 0.05
@pytest.mark.parametrize(("name", "k"), [("truncated_cone", 0.05), ("truncated_paraboloid", 0.2)])
def test_pressure_at_a_corner(name: str, k: float) -> None:
    """Where r is b its distance is a power of the root: with y = sqrt(a**2 - b**2) x**(1/(2 k)) the path is smooth."""
    ctx.prec = BITS
    own, b, top = arb(k), arb(1.0), arb(3.0).sqrt()

    def integrand(x: Number) -> Number:
        y = top * x ** (1 / (2 * own))
        t = (b * b + y * y).sqrt()
        return rate(name, t, y, b, own) * y**own * (y / t) / (2 * own * x)

    value = sum((w * integrand((panel + x) / 64) / 64 for panel in range(64) for x, w in gauss()), arb(0)) / arb.pi()
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
