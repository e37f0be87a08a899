"""What formulas for plain numbers are written with, beside `math`: its functions under NumPy's names, and rules.

A ufunc takes half a microsecond for one number and `math` a tenth of that.  The formulas themselves stand in
`_programs`, written by the build: flat functions of `math`, and below `bodies` what iterates, with `MATH` for `np`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from operator import not_
from types import SimpleNamespace

from .integrals import STRIPS
from .nodes import gauss_legendre

PANELS = 4
"""Panels of a rule beyond which its sum is left to the arrays, which carry what rounding loses."""
Pairs = list[tuple[float, float]]
"""Nodes of a rule with their weights."""
Strip = tuple[Callable[[float], float], float, float, bool, float]
"""An integrand, the end of its interval, a factor, whether it holds, and what else is."""


def rule(lengths: tuple[tuple[float, int], ...]) -> Callable[[float], Pairs]:
    """Nodes and weights on (0, 1) for an interval of a length, in panels beyond the last one."""

    def pairs(length: float) -> Pairs:
        for longest, count in lengths:
            if length <= longest:
                return _pairs(count, 1)
        panels = math.ceil(length / longest)
        if panels > PANELS:
            raise ArithmeticError
        return _pairs(count, panels)

    return pairs


@cache
def _pairs(count: int, panels: int) -> Pairs:
    nodes, weights = (column.tolist() for column in gauss_legendre(count))
    panel = list(zip(nodes, weights, strict=True))
    return [((start + node) / panels, weight / panels) for start in range(panels) for node, weight in panel]


def integral(integrand: Callable[[float], float], stop: float, count: int) -> float:
    """Integral from 0 to `stop` with `count` nodes."""
    return math.fsum([weight * integrand(node * stop) for node, weight in _pairs(count, 1)]) * stop


def integral_in_strip(
    integrand: Callable[[float], float],
    stop: float,
    width: float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> float:
    """Integral from 0 to `stop` with as many nodes as its length in units of `width` asks for."""
    return math.fsum([weight * integrand(node * stop) for node, weight in rule(lengths)(stop / width)]) * stop


integral_by_length = integral_in_strip


def integral_by_panels(integrand: Callable[[float], float], stop: float, width: float, count: int) -> float:
    """Integral from 0 to `stop` in equal panels no wider than about `width`."""
    panels = max(math.ceil(stop / width), 1)
    if panels > PANELS:
        raise ArithmeticError
    return math.fsum([weight * integrand(node * stop) for node, weight in _pairs(count, panels)]) * stop


def both(
    integrand: Callable[[float], tuple[float, float]],
    stop: float,
    width: float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> tuple[float, float]:
    """The integrals of both members of a pair from 0 to `stop`, from the same nodes."""
    first, second = list[float](), list[float]()
    for node, weight in rule(lengths)(stop / width) if abs(stop) > 0.0 else ():
        x, y = integrand(node * stop)
        first.append(weight * x)
        second.append(weight * y)
    return math.fsum(first) * stop, math.fsum(second) * stop


def in_groups(
    rule_of: Callable[..., tuple[Callable[[float], float], float, float, bool, float]],
) -> Callable[..., float]:
    """The integral of a rule, as over arrays, at one point."""

    def at(slope: Callable[..., float], parameters: tuple[float, ...], *lengths: float, width: float = 1.0) -> float:
        integrand, stop, factor, holds, otherwise = rule_of(lambda *t: slope(*t, *parameters), *lengths)
        return factor * integral_in_strip(integrand, stop, width) if holds else otherwise

    return at


def over_radii(*courses: object, everywhere: bool = False) -> Callable[[Callable[..., float]], Callable[..., float]]:
    """The rule itself: there is one radius."""
    return lambda rule_of: rule_of


at_many_radii = over_radii


def at_break(b: float) -> float:
    """A root that is nothing beside b: a slope that is infinite at the break is a number there."""
    # lengths of plain numbers are within 1e60 of each other, so that no factor makes it something
    return 1e-100 * b


def _minimum(x: float, y: float) -> float:
    """Not a number where one of them is none, unlike Python's."""
    return x if x < y or x != x else y


def _maximum(x: float, y: float) -> float:
    return x if x > y or x != x else y


def sqrt(x: float) -> float:
    return math.sqrt(x) if x >= 0.0 else math.nan


def log(x: float) -> float:
    return math.log(x) if x > 0.0 else -math.inf if x == 0.0 else math.nan


def log1p(x: float) -> float:
    return math.log1p(x) if x > -1.0 else -math.inf if x == -1.0 else math.nan


MATH = SimpleNamespace(
    pi=math.pi, e=math.e, inf=math.inf, nan=math.nan, float64=float,
    sqrt=sqrt, cbrt=math.cbrt, exp=math.exp, expm1=math.expm1, log=log, log1p=log1p,
    sin=math.sin, cos=math.cos, tan=math.tan, arctan=math.atan, arctan2=math.atan2, arctanh=math.atanh,
    sinh=math.sinh, cosh=math.cosh, tanh=math.tanh, arcsinh=math.asinh, hypot=math.hypot,
    ldexp=math.ldexp, frexp=math.frexp, exp2=math.exp2, floor=math.floor, nextafter=math.nextafter,
    abs=abs, minimum=_minimum, maximum=_maximum, isfinite=math.isfinite, isnan=math.isnan,
    any=bool, all=bool, count_nonzero=bool,
    # bodies write it out: ~True is -2, and an error from Python 3.16 on
    logical_not=not_,
    where=lambda condition, x, y: x if condition else y,
    asarray=lambda x, dtype=None: x, full_like=lambda x, value, dtype=None: value,
    ones_like=lambda x: 1.0, zeros_like=lambda x: 0.0, zeros=lambda shape: 0.0,
    ndim=lambda x: 0, full=lambda shape, value: value, max=lambda x, initial=-math.inf: max(x, initial), ceil=math.ceil,
    clip=lambda x, low, high: min(max(x, low), high), vectorize=lambda function, otypes=None: function,
)  # fmt: skip
"""What a body that iterates finds as `np` where its arguments are plain numbers."""
