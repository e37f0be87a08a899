"""Rational kernels for functions that cancel near zero: near-minimax fits whose terms do not."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

import mpmath as mp

GOAL = mp.mpf(2) ** -53
"""Relative error of a fit, with its coefficients rounded to doubles: half a unit in the last place."""
DIGITS = 60
HIGHEST = 14
CONDITION = 1.2


@dataclass(frozen=True)
class Kernel:
    """P(v)/Q(v) for 0 <= v <= end, coefficients in ascending order, Q(0) = 1."""

    end: float
    top: tuple[float, ...]
    bottom: tuple[float, ...]

    def __call__(self, v: mp.mpf) -> mp.mpf:
        return mp.polyval(self.top[::-1], v) / mp.polyval(self.bottom[::-1], v)


def fit(function: Callable[[mp.mpf], mp.mpf], end: float, polynomial: bool = False, share: Any = 1) -> Kernel:
    """The shortest rational or polynomial fit of a function that is smooth on [0, end] and positive.

    What is only a `share` of a result may have larger errors, and terms that cancel a little.

    Raises
    ------
    ArithmeticError
        If no fit up to degree HIGHEST reaches GOAL with terms of one sign, so that evaluating it loses nothing.
    """
    function = cache(function)
    with mp.workdps(DIGITS):
        for degree in range(1, HIGHEST + 1):
            for degrees in ((2 * degree, 0),) if polynomial else ((degree, degree), (2 * degree, 0)):
                kernel = _interpolated(function, mp.mpf(end), *degrees, CONDITION / share)
                if kernel is not None and _reaches(kernel, function, GOAL / share):
                    return kernel
    message = f"no kernel up to degree {HIGHEST} on [0, {end}]; shorten the interval"
    raise ArithmeticError(message)


def _interpolated(
    function: Callable[[mp.mpf], mp.mpf], end: mp.mpf, above: int, below: int, condition: Any
) -> Kernel | None:
    """P - f Q = 0 at Chebyshev nodes; None where its terms cancel."""
    count = above + below + 1
    nodes = [end * (1 + mp.cos(mp.pi * (mp.mpf(k) + 0.5) / count)) / 2 for k in range(count)]
    rows, right = mp.matrix(count, count), mp.matrix(count, 1)
    for i, v in enumerate(nodes):
        value = function(v)
        for j in range(above + 1):
            rows[i, j] = v**j / value
        for j in range(1, below + 1):
            rows[i, above + j] = -(v**j)
        right[i] = 1
    try:
        solved = list(mp.lu_solve(rows, right))
    except ZeroDivisionError:
        return None
    top, bottom = solved[: above + 1], [mp.mpf(1), *solved[above + 1 :]]
    if max(_condition(top, end), _condition(bottom, end)) > condition:
        return None
    return Kernel(float(end), tuple(map(float, top)), tuple(map(float, bottom)))


def _condition(coefficients: list[mp.mpf], end: mp.mpf) -> mp.mpf:
    """How much larger the terms are than their sum; 1 where all coefficients have one sign."""
    terms = [coefficient * end**j for j, coefficient in enumerate(coefficients)]
    return sum(map(abs, terms)) / abs(sum(terms))


def _reaches(kernel: Kernel, function: Callable[[mp.mpf], mp.mpf], goal: mp.mpf) -> bool:
    """Whether the relative error is below the goal everywhere; most fits miss it at the first point."""
    points = (mp.mpf(kernel.end) * mp.mpf(i) / 61 for i in range(1, 62))
    return all(abs(kernel(v) / function(v) - 1) < goal for v in points)
