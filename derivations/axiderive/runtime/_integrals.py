"""Gauss-Legendre rules for intervals of any length, by groups of points and at many radii of one contact."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial, wraps
from typing import Any, TypeAlias

import numpy as np

from ._along import LEAST, Course, Courses, along, same
from ._elementwise import Array
from ._nodes import gauss_legendre

Slope = Callable[..., Array]
Strip: TypeAlias = tuple[Any, ...]
"""What `in_groups` makes an integral of."""
PANELS = 4096
"""Panels beyond which a rule is no longer refined: this many waves in the contact."""
STRIPS = tuple((float(np.pi / np.sinh(np.log(1e19) / (2.0 * count))), count) for count in (8, 16, 24, 32, 64))
"""Lengths of an interval and the nodes that leave 1e-19 there, for singularities at a distance pi/2.

Gauss-Legendre converges as rho**(-2 count) with rho - 1/rho = 2 pi/length (Bernstein's ellipse);
poles of the integrands near that distance cost a factor of up to 1e3.
Beyond the last length there are panels of it.
"""
FEW = 512
"""Points for which the nodes of the longest interval cost less than calls by groups."""
TERMS = 4096
"""Values of an integrand at a time: larger arrays come and go as pages of the system, which costs more than they do."""
WAVES = ((0.25, 8), (1.97, 16), (4.7, 24), (7.96, 32), (23.3, 64))
"""The same for exp(2 pi i u) and what grows no faster off the real axis: 1e-18 by the best ellipse."""


def integral(integrand: Callable[[Array], Array], stop: Array, count: int) -> Array:
    """Integral of `integrand` from 0 to `stop`, elementwise, with `count` nodes along a new first axis."""
    if hasattr(stop, "integral"):
        return stop.integral(integrand, 1.0, ((np.inf, count),))
    nodes, weights = (column.reshape(-1, *(1,) * np.ndim(stop)) for column in gauss_legendre(count))
    parts = in_parts(count, TERMS // max(1, np.size(stop)))
    return summed(weights[part] * integrand(nodes[part] * stop) for part in parts) * stop


def in_parts(count: int, most: int) -> list[slice]:
    """As many terms at a time as are no more than `most`, a power of two."""
    step = 1 << max(0, most.bit_length() - 1)
    return [slice(first, first + step) for first in range(0, count, step)]


def summed(parts: Iterable[Array]) -> Array:
    """The sum of the rows of all parts, neighbours first, in whatever parts: one after another 64 lose 8 units."""
    sums: list[Array] = []
    for number, rows in enumerate(parts, 1):
        total = _of_neighbours(rows) if isinstance(rows, np.ndarray) else np.sum(rows, axis=0)
        while number % 2 == 0:
            total, number = sums.pop() + total, number // 2
        sums.append(total)
    while len(sums) > 1:
        last = sums.pop()
        sums[-1] = sums[-1] + last
    return sums[0]


def _of_neighbours(rows: Array) -> Array:
    while len(rows) > 1:
        pairs = rows[0:-1:2] + rows[1::2]
        rows = np.concatenate([pairs, rows[-1:]]) if len(rows) % 2 else pairs
    return rows[0]


def integral_by_panels(integrand: Callable[[Array], Array], stop: Array, width: Array, count: int) -> Array:
    """Integral from 0 to `stop` in equal panels no wider than about `width`, as many as the largest `stop` needs."""
    largest = float(np.max(np.where(np.isfinite(stop), stop / width, 0.0), initial=1.0))
    panels = int(np.ceil(min(largest, PANELS)))
    if panels == 1:
        return integral(integrand, stop, count)
    width, total, lost = stop / panels, np.zeros_like(stop), np.zeros_like(stop)
    for panel in range(panels):
        start = panel * width
        # equal panels of one integrand round alike, up to 50 units over 300 decades (Kahan's sum)
        part = integral(partial(_shifted, integrand, start), width, count) - lost
        total, before = total + part, total
        lost = (total - before) - part
    return total


def _shifted(integrand: Callable[[Array], Array], start: Array, x: Array) -> Array:
    return integrand(start + x)


def integral_in_strip(
    integrand: Callable[[Array], Array],
    stop: Array,
    width: Array | float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> Array:
    """Integral from 0 to `stop` by the rules of STRIPS, without singularities closer than pi/2 to the real axis.

    With a `width`, closer than width*pi/2.
    """
    longest = float(np.max(np.where(np.isfinite(stop), stop / width, 0.0), initial=0.0))
    for length, count in lengths:
        if longest <= length:
            return integral(integrand, stop, count)
    return integral_by_panels(integrand, stop, np.full_like(stop, length * width), count)


def integral_by_length(
    integrand: Callable[[Array], Array],
    stop: Array,
    width: Array | float = 1.0,
    lengths: tuple[tuple[float, int], ...] = STRIPS,
) -> Array:
    """The same, also of a traced body; not for waves, of whose panels the sum above keeps what rounding loses."""
    if hasattr(stop, "integral"):
        return stop.integral(integrand, width, lengths)
    return integral_in_strip(integrand, stop, width, lengths)


def in_groups(rule: Callable[..., Strip]) -> Callable[..., Array]:
    """The integral of a rule for slope(..., *parameters), called once for all points that need the same nodes.

    `rule(slope, *lengths)` gives the integrand, the end of its interval, a factor, where it holds, and what else is.
    """

    def called(slope: Slope, parameters: tuple[Array, ...], lengths: tuple[Array, ...]) -> Strip:
        return rule(lambda *t: slope(*t, *parameters), *lengths)

    @wraps(rule)
    def grouped(slope: Slope, parameters: tuple[Array, ...], *lengths: Array, width: Array | float = 1.0) -> Array:
        strip = called(slope, parameters, lengths)
        stop = strip[1]
        if not isinstance(stop, np.ndarray) or stop.size <= FEW:
            return _over(strip, width)
        if stop.ndim > 1:
            shape = np.broadcast_shapes(*map(np.shape, (stop, width, *parameters, *lengths)))
            flat = [np.broadcast_to(x, shape).ravel() if np.ndim(x) else x for x in (*parameters, *lengths, width)]
            own, others = tuple(flat[: len(parameters)]), flat[len(parameters) : -1]
            return grouped(slope, own, *others, width=flat[-1]).reshape(shape)
        group = np.searchsorted([length for length, _ in STRIPS], np.where(np.isfinite(stop), stop / width, 0.0))
        if (group == group[0]).all():
            return _over(strip, width)
        total = np.empty_like(stop)
        for number in np.unique(group):
            chosen = group == number
            some = (tuple(_part(x, chosen) for x in xs) for xs in (parameters, lengths))
            total[chosen] = _over(called(slope, *some), _part(width, chosen))
        return total

    return grouped


def _over(strip: Strip, width: Array | float) -> Array:
    integrand, stop, factor, holds, otherwise = strip
    return np.where(holds, factor * integral_by_length(integrand, stop, width), otherwise)


def _part(value: Array, chosen: Array) -> Array:
    return value[chosen] if np.ndim(value) else value


def over_radii(courses: Courses) -> Callable[[Callable[..., Array]], Callable[..., Array]]:
    """The rule, called at few of many radii where nothing else changes and no width is given."""

    def decorated(rule: Callable[..., Array]) -> Callable[..., Array]:
        @wraps(rule)
        def at(slope: Slope, parameters: tuple[Array, ...], r: Array, *lengths: Array, **width: Array) -> Array:
            many = isinstance(r, np.ndarray) and r.size >= LEAST and not width
            fixed = same(*parameters, *lengths) if many else None
            if fixed is None:
                return rule(slope, parameters, r, *lengths, **width)
            own, others = fixed[: len(parameters)], fixed[len(parameters) :]
            return along(lambda r: rule(slope, own, r, *others), r, *courses(*others))

        return at

    return decorated


def of_pressure(a: float, b: float) -> tuple[Course | None, float, float]:
    """Inside and outside the break at b; next to it where the contact has hardly passed it, r says too little."""
    if not a > b * (1.0 + 1e-6):
        return None, 0.0, a
    return Course(b, (a - b) * (a + b), True, a, b * b), 0.0, a


def of_displacement(a: float, *other: float) -> tuple[Course, float, float]:
    """Outside the contact."""
    return Course(a, a * a, False), a, np.inf


def difference_root(x: Array, y: Array) -> Array:
    """sqrt(x**2 - y**2), and zero for x < y."""
    return np.sqrt(np.maximum(x - y, 0.0) * (x + y))
