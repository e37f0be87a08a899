"""Integration rules of high precision for integrands whose singular points are known.

A panel that starts at a singular point of the integrand, always the zero of
its variable so that distances to it are exact, is integrated by the double
exponential rule; every other panel is cut until its singular points keep a
distance and then gets a Gauss-Legendre rule of fixed order.  Nothing here
estimates an error: what a rule delivers is measured against closed forms.

The same rules in the arithmetic of Arb are ten times as fast as in mpmath's: for integrals inside integrals.
"""

from __future__ import annotations

import cmath
import itertools
import math
from collections.abc import Callable, Iterable
from functools import lru_cache
from typing import Any, TypeAlias

import mpmath as mp
import sympy as sp
from flint import acb, arb, ctx, fmpq

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
    longest: float = math.inf,
) -> Number:
    """Integral of f from lo to hi at the working precision; `singular` holds the singular points of f.

    Only an end of the interval may be a singular point, and only if it is 0; there f may grow like x**least.
    Panels are no longer than `longest`, which entire functions ask for.
    """
    if lo == hi:
        return mp.mpf(0)
    count, points, prec = max(1, math.ceil((hi - lo) / longest)), tuple(singular), int(mp.mp.prec)
    total = mp.mpf(0)
    for start, end in itertools.pairwise([*(lo + (hi - lo) * i / count for i in range(count)), hi]):
        panels = _panels(float(start), float(end), points)
        ends = [start, *(mp.mpf(right) for _, right, _ in panels[:-1]), end]
        for (left, right, parameter), x, y in zip(panels, ends, ends[1:], strict=False):
            if 0 in points and 0 in (left, right):
                total += panel(f, exponential_rule, (digits, prec, least), mp.mpf(0), y if left == 0 else x)
                continue
            order = 8 * math.ceil((digits + 4) / (16 * math.log10(parameter)))
            total += panel(f, gauss_rule, (order, prec), x, y - x)
    return total


_root = sp.Function("root_of")
NATIVE: dict[str, Callable[..., arb]] = {
    "root_of": lambda x: x.sqrt(),
    "exp": lambda x: x.exp(),
    "sin": lambda x: x.sin(),
    "cos": lambda x: x.cos(),
    "tan": lambda x: x.tan(),
    "IncompleteBeta": lambda z, p, q: z.beta_lower(p, q),
}


@lru_cache(maxsize=1)
def functions() -> dict[str, Callable[..., arb]]:
    """By the name that lambdify prints."""
    from .balls import FUNCTIONS, Ball  # which measures a shape, as the callers of this module do

    plain = Ball({}, False)

    def real(rule: Callable[..., acb]) -> Callable[..., arb]:
        return lambda *args: rule(plain, *map(acb, args)).real

    return {head.__name__: real(rule) for head, rule in FUNCTIONS.items()} | NATIVE


def ball(value: Any) -> arb:
    """The binary fraction that a number of mpmath is; a rational number of SymPy, any other one rounded."""
    if isinstance(value, mp.mpf):
        sign, mantissa, exponent, _ = value._mpf_
        return arb((-int(mantissa) if sign else int(mantissa), int(exponent)))
    if value.is_Rational:
        return arb(fmpq(int(value.p), int(value.q)))
    return ball(value._to_mpmath(ctx.prec + 20))


def foreign(expr: sp.Expr) -> list[str]:
    """Names of the functions of an expression that Arb is not told."""
    return sorted({str(node.func) for node in expr.atoms(sp.Function)} - set(functions()))


@lru_cache(maxsize=512)
def _compiled(expr: sp.Expr, arguments: tuple[sp.Symbol, ...]) -> tuple[Callable[..., arb], tuple[sp.Expr, ...]]:
    """A function of the arguments and of the numbers that Python would read as floats."""
    rooted = expr.replace(
        lambda node: node.is_Pow and node.exp.is_Rational and node.exp.q == 2,
        lambda node: _root(node.base) ** node.exp.p,
    )
    unknown = foreign(rooted)
    if unknown:
        message = f"{expr} has the function {unknown[0]}, which Arb is not told; add it to balls.FUNCTIONS"
        raise ValueError(message)
    numbers = tuple(sorted((n for n in rooted.atoms(sp.Rational, sp.NumberSymbol) if not n.is_Integer), key=str))
    stand_ins = {n: sp.Symbol(f"number_{i}") for i, n in enumerate(numbers)}
    function = sp.lambdify(
        (*arguments, *stand_ins.values()), rooted.xreplace(stand_ins), modules=[functions()], cse=True
    )
    return function, numbers


def bound(expr: sp.Expr, variable: sp.Symbol, known: dict[sp.Symbol, Number]) -> Callable[[arb], arb]:
    """The expression as a function of balls, compiled when it is first called."""

    @lru_cache(maxsize=1)
    def bind() -> tuple[Callable[..., arb], list[arb]]:
        function, numbers = _compiled(expr, (variable, *known))
        return function, [ball(value) for value in (*known.values(), *numbers)]

    def call(x: arb) -> arb:
        function, fixed = bind()
        return arb(function(x, *fixed))

    return call


def at_working_precision() -> Any:
    """Arb at the precision that mpmath has here."""
    return ctx.workprec(int(mp.mp.prec))


def sum_over_balls(
    f: Callable[[arb], arb], rule: Callable[..., Rule], of: tuple[Any, ...], start: Number, length: Number
) -> Number:
    """`sum_over` for a function of balls."""
    origin, reach, total = ball(start), ball(length), arb(0)
    for x, weight in _nodes(rule, of):
        total += weight * f(origin + reach * x)
    return middle(total * abs(reach))


@lru_cache(maxsize=64)
def _nodes(rule: Callable[..., Rule], of: tuple[Any, ...]) -> tuple[tuple[arb, arb], ...]:
    return tuple((ball(x), ball(weight)) for x, weight in rule(*of))
