"""Integration rules of the checks: for any singular ends, for ends of known power, for a full turn.

No rule estimates its own error; agreement with another route is the measure.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

import mpmath as mp
import numpy as np

Function = Callable[[Any], Any]


@lru_cache(maxsize=16)
def _tanh_sinh(wanted: int, carried: int) -> tuple[tuple[Any, Any, Any], ...]:
    """(u, 1 - u, weight) on (0, 1) for `wanted` digits, as far as u and 1 - u stay above 10**-carried."""
    with mp.workdps(carried):
        step = mp.pi**2 / (wanted * mp.log(10)) * mp.mpf("0.45")
        last = int(mp.asinh(carried * mp.log(10) / mp.pi) / step)
        nodes = []
        for i in range(-last, last + 1):
            y = mp.exp(-mp.pi * mp.sinh(i * step))
            u, v = 1 / (1 + y), y / (1 + y)
            nodes.append((u, v, step * mp.pi * mp.cosh(i * step) * u * v))
        return tuple(nodes)


def singular(f: Function, lo: Any, hi: Any, strongest: float = 0.5) -> Any:
    """int f over (lo, hi) whatever happens at the ends, by the tanh-sinh rule.

    f is evaluated at a precision at which the rounding of x next to an end
    where f grows like the power -`strongest` costs none of the digits wanted.
    """
    wanted = mp.mp.dps
    carried = int(wanted / (1 - strongest)) + 5
    width = hi - lo
    offset = max(abs(lo), abs(hi)) / abs(width)
    with mp.workdps(carried + int(mp.log10(offset)) + 1):
        width = hi - lo
        nodes = _tanh_sinh(wanted, carried)
        total = width * mp.fsum(w * f(lo + width * u if u < v else hi - width * v) for u, v, w in nodes)
    return +total


def panels(f: Function, lo: Any, hi: Any, breaks: tuple[Any, ...] = (), strongest: float = 0.5) -> Any:
    """The same where f may also have kinks, jumps or singularities at the breaks."""
    ends = (lo, *breaks, hi)
    return mp.fsum(singular(f, x, y, strongest) for x, y in zip(ends, ends[1:], strict=False))


def to_infinity(f: Function, lo: Any) -> Any:
    """int f over (lo, oo) for an f that falls off like exp(-x), at worst 1/sqrt at lo; x = lo + exp(t - exp(-t))."""
    wanted = mp.mp.dps
    with mp.workdps(2 * wanted + 5):
        step = mp.pi**2 / (wanted * mp.log(10)) * mp.mpf("0.45")
        reach = mp.log(3 * wanted * mp.log(10))
        total = mp.mpf(0)
        for i in range(int(-reach / step), int(reach / step) + 1):
            fall = mp.exp(-i * step)
            x = mp.exp(i * step - fall)
            total += x * (1 + fall) * f(lo + x)
        total *= step
    return +total


@lru_cache(maxsize=64)
def _jacobi(nodes: int, lower: Any, upper: Any, precision: int) -> tuple[tuple[Any, Any], ...]:
    """(u, weight / (u**lower (1 - u)**upper)) of the Gauss rule on (0, 1), by Newton's method from float64 nodes."""
    with mp.workprec(precision + 30):
        al, be = mp.mpf(upper), mp.mpf(lower)
        diagonal, off = _recurrence(nodes, al, be)
        matrix = np.diag([float(x) for x in diagonal])
        matrix += np.diag([float(mp.sqrt(x)) for x in off[1:]], 1) + np.diag([float(mp.sqrt(x)) for x in off[1:]], -1)
        rule = []
        for start in np.linalg.eigvalsh(matrix):
            z = mp.mpf(float(start))
            for _ in range(60):
                value, slope, norm = _orthogonal(z, diagonal, off)
                change = value / slope
                z -= change
                if abs(change) < mp.mpf(2) ** (-precision // 2 - 20):
                    break
            norm = _orthogonal(z, diagonal, off)[2]
            u, v = (1 + z) / 2, (1 - z) / 2
            weight = off[0] / norm / mp.mpf(2) ** (al + be + 1)
            rule.append((u, weight / (u**be * v**al)))
        return tuple(rule)


def _recurrence(nodes: int, al: Any, be: Any) -> tuple[list[Any], list[Any]]:
    """Coefficients of the monic Jacobi polynomials; off[0] is the integral of the weight."""
    s = al + be
    diagonal = [(be - al) / (s + 2)]
    off = [mp.mpf(2) ** (s + 1) * mp.beta(al + 1, be + 1)]
    for i in range(1, nodes):
        t = 2 * i + s
        diagonal.append((be**2 - al**2) / (t * (t + 2)))
        if i == 1:
            off.append(4 * (1 + al) * (1 + be) / ((2 + s) ** 2 * (3 + s)))
        else:
            off.append(4 * i * (i + al) * (i + be) * (i + s) / (t**2 * (t + 1) * (t - 1)))
    return diagonal, off


def _orthogonal(z: Any, diagonal: list[Any], off: list[Any]) -> tuple[Any, Any, Any]:
    """Last polynomial, its derivative, and the sum of squares of the orthonormal ones (times off[0])."""
    before, value = mp.mpf(0), mp.mpf(1)
    slope_before, slope = mp.mpf(0), mp.mpf(0)
    norm, product = mp.mpf(1), mp.mpf(1)
    for i, shift in enumerate(diagonal):
        b = off[i] if i else mp.mpf(0)
        new = (z - shift) * value - b * before
        new_slope = value + (z - shift) * slope - b * slope_before
        before, value, slope_before, slope = value, new, slope, new_slope
        if i + 1 < len(diagonal):
            product *= off[i + 1]
            norm += value**2 / product
    return value, slope, norm


def weighted(f: Function, lo: Any, hi: Any, lower: Any = 0, upper: Any = 0, density: float = 1.3) -> Any:
    """int f over (lo, hi) where f behaves like (x - lo)**lower and (hi - x)**upper times analytic factors.

    `density` is the number of nodes per digit; 1.3 serves down to singularities a fifth of the interval away.
    """
    width = hi - lo
    nodes = int(density * mp.mp.dps)
    return width * mp.fsum(w * f(lo + width * u) for u, w in _jacobi(nodes, mp.mpf(lower), mp.mpf(upper), mp.mp.prec))


def half_turn(f: Function, decay: Any) -> Any:
    """int f over (0, pi) for an even f of period 2 pi, whose singularities are `decay` away from the real axis."""
    count = int(mp.mp.dps * mp.log(10) / decay / 2) + 3
    inner = mp.fsum(f(mp.pi * i / count) for i in range(1, count))
    return mp.pi / count * (inner + (f(mp.mpf(0)) + f(mp.pi)) / 2)
