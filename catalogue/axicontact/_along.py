"""Integrals at many radii of one contact: their rules at Chebyshev points, and polynomials in between.

As a function of r an integral has one singular radius c; in ln abs(r**2 - c**2) it is
analytic in a strip of half-width pi, apart from a root that vanishes at the edge.
On a panel of length ln 4 polynomials through 18 points are as good as the rule.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, wraps
from typing import Any, NamedTuple

import numpy as np

from ._elementwise import Array

LEAST, POINTS, DEPTH = 1024, 18, 10
"""Radii for which panels pay; points of a panel; panels on either side.

DEPTH panels next to the singular radius it is represented too coarsely by r.
"""


class Course(NamedTuple):
    """One side of a singular radius.

    `unit` is the value of abs(r**2 - centre**2) where a panel ends, the last one if `closed`.  The integral is
    proportional to sqrt(edge**2 - r**2) next to an `edge`, and to 1/r far out where there is no last panel.
    """

    centre: float
    outside: bool
    unit: float
    closed: bool
    edge: float | None = None

    def scaled(self, r: Array) -> Array:
        """abs(r**2 - centre**2)/unit on this side, negative on the other."""
        past = r - self.centre if self.outside else self.centre - r
        return past * ((r + self.centre) / self.unit)

    def radius(self, scaled: Array) -> Array:
        square, distance = self.centre * self.centre, self.unit * scaled
        return np.sqrt(square + distance if self.outside else square - distance)

    def trend(self, r: Array) -> Array:
        if self.edge is not None:
            return np.sqrt((self.edge - r) * (self.edge + r))
        return 1.0 if self.closed else self.centre / r


Courses = Callable[..., tuple[Sequence[Course], float, float]]
"""The courses of an integral for what does not change with r, and between which radii it is wanted."""


def at_many_radii(courses: Courses) -> Callable[[Callable[..., Array]], Callable[..., Array]]:
    """The integral as a function of r and other lengths, by `along` where the others are the same at many radii."""

    def decorated(integral: Callable[..., Array]) -> Callable[..., Array]:
        @wraps(integral)
        def at(r: Array, *others: Array) -> Array:
            fixed = same(*others) if isinstance(r, np.ndarray) and r.size >= LEAST else None
            if fixed is None:
                return integral(r, *others)
            return along(lambda r: integral(r, *fixed), r, *courses(*fixed))

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


def along(exact: Callable[[Array], Array], r: Array, courses: Sequence[Course], inner: float, outer: float) -> Array:
    """Values of `exact` at the radii between `inner` and `outer`, and zero at the others."""
    value, left = np.zeros_like(r), (r >= inner) & (r < outer)
    parts = [part for course in courses if (part := _part(course, r, left)) is not None]
    if parts:
        nodes = [part.course.radius(np.ldexp(2.0 * 2.0 ** _points()[0], 2 * part.panels[:, None])) for part in parts]
        values = exact(np.concatenate(nodes).ravel()).reshape(-1, POINTS)
        ends = np.cumsum([len(x) for x in nodes])[:-1]
        for part, x, y in zip(parts, nodes, np.split(values, ends), strict=True):
            trend = part.course.trend(r[part.chosen])
            value[part.chosen] = trend * _polynomials(_table(part, x, y), part.rows, part.place)
            left[part.chosen] = False
    if np.any(left):
        value[left] = exact(r[left])
    return value


class _Part(NamedTuple):
    """The radii of a course in panels that hold more of them than points."""

    course: Course
    panels: Array
    """Panel p reaches from 4**p to 4**(p + 1) units."""
    chosen: Array
    """Where these radii are among all."""
    rows: Array
    """To which of the panels each belongs."""
    place: Array
    """And where it lies on that, from -1 to 1."""


def _part(course: Course, r: Array, left: Array) -> _Part | None:
    # not a number on the other side
    power = np.log2(course.scaled(r))
    last = 0 if course.closed else DEPTH
    panel = np.minimum(np.floor(0.5 * power), last - 1.0)
    chosen = np.flatnonzero(left & (panel >= -DEPTH) & (power <= 2.0 * last))
    panel = panel[chosen]
    number = (panel + DEPTH).astype(np.intp)
    counts = np.bincount(number, minlength=1)
    dense = counts > POINTS
    if not dense.any():
        return None
    if not dense[counts > 0].all():
        keep = dense[number]
        chosen, panel, number = chosen[keep], panel[keep], number[keep]
    place = power[chosen] - (2.0 * panel + 1.0)
    return _Part(course, np.flatnonzero(dense) - DEPTH, chosen, (np.cumsum(dense) - 1)[number], place)


def _table(part: _Part, r: Array, values: Array) -> Array:
    """Coefficients by degree and panel."""
    points, waves, powers, slopes = _points()
    values = (values / part.course.trend(r)).T
    # the radii are rounded: the values belong to places next to the points
    place = np.log2(part.course.scaled(r)) - (2.0 * part.panels[:, None] + 1.0)
    values = values - slopes @ (waves @ values) * (place - points).T
    # in two steps: the powers of a Chebyshev polynomial cancel to six digits
    return powers @ (waves @ values)


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
    total, term = table[-1].take(rows), np.empty_like(x)
    for coefficients in table[-2::-1]:
        np.multiply(total, x, out=total)
        # rows that are too large would only be checked in a buffer
        np.add(total, coefficients.take(rows, out=term, mode="clip"), out=total)
    return total
