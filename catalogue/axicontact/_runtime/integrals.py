"""Gauss-Legendre rules for intervals of any length, by groups of points and at many radii of one contact.

At many radii the rules are evaluated at Chebyshev points, with polynomials in between: as a function of r an integral
has one singular radius c; in ln abs(r**2 - c**2) it is analytic in a strip of half-width pi, apart from a root that
vanishes at the edge.  On a panel of length ln 2 polynomials through 14 points are as good as the rule; through 12 they
miss it by 3 units.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from functools import cache, partial, wraps
from typing import Any, TypeAlias

import numpy as np

from .interface import Array
from .nodes import gauss_legendre

Slope = Callable[..., Array]
Strip: TypeAlias = tuple[Any, ...]
"""What `in_groups` makes an integral of."""
PANELS = 4096
"""Panels beyond which a rule is no longer refined: this many waves in the contact."""
STRIPS = ((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64))
"""Lengths of an interval and the nodes that leave 1e-19 there, for singularities at a distance pi/2.

Gauss-Legendre converges as rho**(-2 count) with rho - 1/rho = 2 pi/length (Bernstein's ellipse); the lengths are cut
after three places, since their last bits depend on the processor.
Poles of the integrands near that distance cost a factor of up to 1e3.
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
    if rows.size == len(rows) and np.sum(np.abs(rows)) < np.inf:
        # of one point in a third of the time
        return np.full(rows.shape[1:], np.sum(rows) if np.iscomplexobj(rows) else math.fsum(rows.ravel().tolist()))
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


LEAST, POINTS, DEPTH = 1024, 14, 20
"""Radii for which panels pay; points of a panel; panels on either side.

DEPTH panels next to the singular radius it is represented too coarsely by r.
"""
ROWS = 2 * DEPTH + 2
"""The panels of one side, between one for the radii below and one for those above."""
BELOW_ONE = np.nextafter(1.0, 0.0)


class Course:
    """The sides of a singular radius.

    `unit` is the value of r**2 - centre**2 where a panel ends, the last one if `closed`, and `within` that of
    centre**2 - r**2 where the last one does on the inner side, if there is any.  The integral is proportional to
    sqrt(edge**2 - r**2) next to an `edge`, and to 1/r far out where there is no last panel.
    """

    # a named tuple would take as long as the rest of this file
    def __init__(
        self, centre: float, unit: float, closed: bool, edge: float | None = None, within: float | None = None
    ) -> None:
        self.centre, self.unit, self.closed, self.edge, self.within = centre, unit, closed, edge, within

    def sides(self, r: Array) -> Array:
        """0 inside the centre, 1 outside; one 1 if there is no inner side."""
        return np.ones(1, dtype=np.intp) if self.within is None else (r > self.centre).astype(np.intp)

    def scaled(self, r: Array, sides: Array) -> Array:
        """abs(r**2 - centre**2) over the unit of the side, below 1 if there is a last panel."""
        past, mean = r - self.centre, r + self.centre
        mean /= self.unit if self.within is None else np.array([-self.within, self.unit]).take(sides)
        past *= mean
        return np.minimum(past, BELOW_ONE, out=past) if self.closed else past

    def radius(self, scaled: Array, sides: Array) -> Array:
        square, distance = self.centre * self.centre, self.unit * scaled
        if self.within is not None:
            distance = np.where(sides, distance, -self.within * scaled)
        return np.sqrt(square + distance)

    def trend(self, r: Array) -> Array:
        if self.edge is not None:
            difference, total = self.edge - r, self.edge + r
            difference *= total
            return np.sqrt(difference, out=difference)
        return 1.0 if self.closed else self.centre / r


Courses = Callable[..., tuple[Course | None, float, float]]
"""The course of an integral for what does not change with r, if panels pay, and between which radii it is wanted."""


def at_many_radii(
    courses: Courses, share: float = 1.0, *, everywhere: bool = False
) -> Callable[[Callable[..., Array]], Callable[..., Array]]:
    """The integral as a function of r and other lengths, by `along` where the others are the same at many radii.

    Many are a `share` of LEAST; it is zero at the radii where no course leads, or wanted `everywhere`.
    """

    def decorated(integral: Callable[..., Array]) -> Callable[..., Array]:
        @wraps(integral)
        def at(r: Array, *others: Array) -> Array:
            fixed = same(*others) if isinstance(r, np.ndarray) and r.size >= share * LEAST else None
            if fixed is None:
                return integral(r, *others)
            course, inner, outer = courses(*fixed)
            value = along(lambda r: integral(r, *fixed), r, course, inner, outer)
            apart = ~((r > inner) & (r < outer)) if everywhere else np.False_
            if np.any(apart):
                value[apart] = integral(r[apart], *fixed)
            return value

        return at

    return decorated


def same(*values: Array) -> tuple[Any, ...] | None:
    """The one number each of these consists of; None if any varies."""
    numbers = []
    for value in values:
        number = value if np.ndim(value) == 0 else value[0]
        if number is not value and not (value == number).all():
            return None
        numbers.append(number)
    return tuple(numbers)


def along(exact: Callable[[Array], Array], r: Array, course: Course | None, inner: float, outer: float) -> Array:
    """Values of `exact` at the radii between `inner` and `outer`, and zero at the others."""
    wanted = (r >= inner) & (r < outer)
    if not wanted.all():
        value = np.zeros_like(r)
        value[wanted] = along(exact, r[wanted], course, inner, outer)
        return value
    if course is None:
        return exact(r)
    sides = course.sides(r)
    rows, place = _panels(course.scaled(r, sides))
    rows += ROWS * sides
    count = np.bincount(rows, minlength=2 * ROWS)
    dense = count > POINTS
    dense[[0, ROWS - 1, ROWS, -1]] = False
    panels = np.flatnonzero(dense)
    if not panels.size:
        return exact(r)
    side, power = np.divmod(panels[:, None], ROWS)
    nodes = course.radius(np.ldexp(2.0 ** (0.5 + 0.5 * _points()[0]), power - (DEPTH + 1)), side)
    rest = np.flatnonzero(~dense.take(rows))
    # all in one call: a rule for few radii costs mostly its steps
    values, others = np.split(exact(np.concatenate([nodes.ravel(), r[rest]])), [nodes.size])
    table = _table(course, nodes, side, values.reshape(-1, POINTS))
    found = _polynomials(table, (np.cumsum(dense) - 1).take(rows), place)
    found *= course.trend(r)
    found[rest] = others
    return found


def _panels(scaled: Array) -> tuple[Array, Array]:
    """The row of each panel from 2**p to 2**(p + 1), p + DEPTH + 1 between the ends, and the place on it, from -1 to 1.

    Both are read off the bits; `scaled` is overwritten.
    """
    bits = scaled.view(np.int64)
    rows = bits >> 52
    rows -= 1023 - (DEPTH + 1)
    np.maximum(rows, 0, out=rows)
    np.minimum(rows, ROWS - 1, out=rows)
    bits &= (1 << 52) - 1
    bits |= 1023 << 52
    place = np.log2(scaled, out=scaled)
    place *= 2.0
    place -= 1.0
    return rows, place


def _table(course: Course, r: Array, side: Array, values: Array) -> Array:
    """Coefficients by degree and panel."""
    points, waves, powers, slopes = _points()
    values = (values / course.trend(r)).T
    # of differences to one of the values the sums below lose nothing, of the values 3 units in a whole panel
    first = values[POINTS // 2]
    values = values - first
    # the radii are rounded: the values belong to places next to the points
    _, place = _panels(course.scaled(r, np.broadcast_to(side, r.shape)))
    values = values - slopes @ (waves @ values) * (place - points).T
    # in two steps: the powers of a Chebyshev polynomial cancel to six digits
    table = powers @ (waves @ values)
    table[0] += first
    return table


@cache
def _points() -> tuple[Array, Array, Array, Array]:
    """Chebyshev points; from values there to coefficients of the polynomials, from those to powers and to slopes."""
    degrees = np.arange(POINTS)
    # in quarters of a turn over POINTS, brought below one: a large angle would round to 1e-15
    quarters = degrees[:, None] * (2 * degrees + 1) % (4 * POINTS)
    quarters = np.minimum(quarters, 4 * POINTS - quarters)
    turned = np.minimum(quarters, 2 * POINTS - quarters)
    cosines = np.sign(POINTS - quarters) * np.cos(turned * (np.pi / (2 * POINTS)))
    waves = 2.0 / POINTS * cosines
    waves[0] /= 2.0
    powers = np.zeros((POINTS, POINTS))
    powers[0, 0] = powers[1, 1] = 1.0
    for k in range(2, POINTS):
        powers[1:, k] = 2.0 * powers[:-1, k - 1]
        powers[:, k] -= powers[:, k - 2]
    angles = np.arccos(cosines[1])[:, None]
    slopes = degrees * np.sin(degrees * angles) / np.sin(angles)
    return cosines[1], waves, powers, slopes


def _polynomials(table: Array, rows: Array, x: Array) -> Array:
    # rows that are too large would only be checked in a buffer
    term, total = np.empty_like(x), table[-1].take(rows, mode="clip")
    for coefficients in table[-2::-1]:
        np.multiply(total, x, out=total)
        np.add(total, coefficients.take(rows, out=term, mode="clip"), out=total)
    return total
