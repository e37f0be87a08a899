"""Integration rules of high precision for integrands whose singular points are known.

A panel that starts at a singular point of the integrand, always the zero of
its variable so that distances to it are exact, is integrated by the double
exponential rule; every other panel is cut until its singular points keep a
distance and then gets a Gauss-Legendre rule of fixed order.  Nothing here
estimates an error: what a rule delivers is measured against closed forms.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any, TypeAlias

import mpmath as mp
from flint import arb, ctx

Number: TypeAlias = mp.mpf
Integrand = Callable[[Number], Number]
Rule = tuple[tuple[Number, Number], ...]

# a panel is cut until every singular point lies outside the Bernstein ellipse of this parameter
NARROWEST_ELLIPSE = 2.7
# above it the growth of the integrand, not its nearest singular point, decides the order
WIDEST_ELLIPSE = 6.0
# the same for the double exponential rule, whose step is chosen for a strip of height 1
NARROWEST_STRIP = 1.0
DEEPEST_CUT = 200


class LostError(ArithmeticError):
    """All digits of a value are lost."""


def middle(ball: arb) -> Number:
    """The number in the middle of a ball of Arb, rounded to the working precision.

    Raises
    ------
    LostError
        If the ball has no middle: a root of something that rounding left on the wrong side of zero.
    """
    if not ball.is_finite():
        message = f"nothing is left of a value at {mp.mp.dps} digits; carry more"
        raise LostError(message)
    mantissa, exponent = ball.mid().man_exp()
    return mp.ldexp(mp.mpf(int(mantissa)), int(exponent))


@lru_cache(maxsize=64)
def gauss_rule(order: int, prec: int) -> Rule:
    """Nodes and weights on (0, 1): the zeros of P_order, which Arb encloses a hundred times as fast as Newton here."""
    nodes = []
    with mp.workprec(prec + 20), ctx.workprec(prec + 40):
        for i in range(order):
            root, weight = arb.legendre_p_root(order, i, weight=True)
            nodes.append((middle((1 - root) / 2), middle(weight / 2)))
    return tuple(nodes)


@lru_cache(maxsize=64)
def exponential_rule(digits: int, prec: int, least: float = -0.5) -> Rule:
    """Double exponential rule on (0, 1), exact distances to the singular end 0, good for x**least and log(x)."""
    with mp.workprec(prec + 20):
        # the strip of analyticity is taken as |Im t| < 1 instead of pi/2: singular points wait beyond the far end
        step = mp.mpf(2 * math.pi / ((digits + 4) * math.log(10)))
        nodes = []
        for direction in (1, -1):
            reach = (1 / (1 + least) if direction > 0 else 1) * (digits + 6) * math.log(10)
            count = int(math.asinh(reach / math.pi) / step)
            for i in range(0 if direction > 0 else 1, count + 1):
                t = direction * i * step
                q = mp.exp(-mp.pi * mp.sinh(t))
                weight = step * mp.pi * mp.cosh(t) * q / (1 + q) ** 2
                nodes.append((q / (1 + q), weight))
    return tuple(nodes)


def ellipse(lo: float, hi: float, point: complex) -> float:
    """Parameter of the Bernstein ellipse of (lo, hi) through the point; 1 on the interval itself."""
    z = (2 * point - lo - hi) / (hi - lo)
    root = cmath.sqrt(z * z - 1)
    return max(abs(z + root), abs(z - root))


def strip(lo: float, hi: float, point: complex) -> float:
    """Height of the strip in which the double exponential map of (lo, hi) keeps clear of the point."""
    w = (2 * point - lo - hi) / (hi - lo)
    if abs(w * w - 1) < 1e-15:  # too near to an end to be told from it
        return 0.0
    return abs(cmath.asinh(2 / cmath.pi * cmath.atanh(w)).imag)


def _panels(lo: float, hi: float, singular: tuple[complex, ...], depth: int = 0) -> list[tuple[float, float, float]]:
    """Panels with their ellipse; in a panel that ends at a singular point 0 the others need a strip, not an ellipse."""
    exponential = 0 in singular and 0 in (lo, hi)
    others = [z for z in singular if not (exponential and z == 0)]
    if not others:
        return [(lo, hi, WIDEST_ELLIPSE)]
    near = min(others, key=lambda z: ellipse(lo, hi, z))
    parameter = ellipse(lo, hi, near)
    if exponential:
        clear = min(strip(lo, hi, z) for z in others) >= NARROWEST_STRIP
    else:
        clear = parameter >= NARROWEST_ELLIPSE
    if clear:
        return [(lo, hi, min(parameter, WIDEST_ELLIPSE))]
    if depth > DEEPEST_CUT:
        message = f"singular point {near} on the panel ({lo}, {hi}); split the integral there"
        raise ArithmeticError(message)
    # geometric panels of ratio 4 towards the singular point
    position = (near.real - lo) / (hi - lo)
    cut = lo + (hi - lo) * (0.5 if 0.3 < position < 0.7 else 0.25 if position <= 0.3 else 0.75)
    return _panels(lo, cut, singular, depth + 1) + _panels(cut, hi, singular, depth + 1)


Panel = Callable[[Any, Callable[..., Rule], tuple[Any, ...], Number, Number], Number]
"""Sums a function over a rule of these arguments, scaled to a start and a length of either sign."""


def sum_over(f: Integrand, rule: Callable[..., Rule], of: tuple[Any, ...], start: Number, length: Number) -> Number:
    """The sum of the weights times f at start + length * node, over all nodes of the rule, times abs(length)."""
    return abs(length) * mp.fsum(w * f(start + length * x) for x, w in rule(*of))


def integrate(
    f: Any,
    lo: Number,
    hi: Number,
    singular: Iterable[complex],
    digits: int,
    least: float = -0.5,
    panel: Panel = sum_over,
) -> Number:
    """Integral of f from lo to hi at the working precision; `singular` holds the singular points of f.

    Only an end of the interval may be a singular point, and only if it is 0; there f may grow like x**least.
    """
    if lo == hi:
        return mp.mpf(0)
    points = tuple(singular)
    prec = int(mp.mp.prec)
    total = mp.mpf(0)
    panels = _panels(float(lo), float(hi), points)
    ends = [lo, *(mp.mpf(right) for _, right, _ in panels[:-1]), hi]
    for (left, right, parameter), start, end in zip(panels, ends, ends[1:], strict=False):
        if 0 in points and 0 in (left, right):
            length = end if left == 0 else start
            total += panel(f, exponential_rule, (digits, prec, least), mp.mpf(0), length)
            continue
        order = 8 * math.ceil((digits + 4) / (16 * math.log10(parameter)))
        total += panel(f, gauss_rule, (order, prec), start, end - start)
    return total
