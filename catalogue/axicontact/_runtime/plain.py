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

from .nodes import gauss_legendre

PANELS = 4
"""Panels of a rule beyond which its sum is left to the arrays, which carry what rounding loses."""
Pairs = list[tuple[float, float]]
"""Nodes of a rule with their weights."""


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


def _sqrt(x: float) -> float:
    return math.sqrt(x) if x >= 0.0 else math.nan


MATH = SimpleNamespace(
    pi=math.pi, e=math.e, inf=math.inf, nan=math.nan, float64=float,
    sqrt=_sqrt, cbrt=math.cbrt, exp=math.exp, expm1=math.expm1, log=math.log, log1p=math.log1p,
    sin=math.sin, cos=math.cos, tan=math.tan, arctan=math.atan, arctan2=math.atan2, arctanh=math.atanh,
    sinh=math.sinh, cosh=math.cosh, tanh=math.tanh, arcsinh=math.asinh,
    abs=abs, minimum=min, maximum=max, isfinite=math.isfinite, any=bool, all=bool, count_nonzero=bool,
    # bodies write it out: ~True is -2, and an error from Python 3.16 on
    logical_not=not_,
    where=lambda condition, x, y: x if condition else y,
    asarray=lambda x, dtype=None: x, full_like=lambda x, value: value,
    ones_like=lambda x: 1.0, zeros_like=lambda x: 0.0,
)  # fmt: skip
"""What a body that iterates finds as `np` where its arguments are plain numbers."""
