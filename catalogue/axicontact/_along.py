"""Integrals at many radii of one contact: their rules at Chebyshev points, and polynomials in between.

As a function of r an integral has one singular radius c; in ln abs(r**2 - c**2) it is
analytic in a strip of half-width pi, apart from a root that vanishes at the edge.
On a panel of length ln 2 polynomials through 12 points are as good as the rule.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, wraps
from typing import Any, NamedTuple

import numpy as np

from ._elementwise import Array

LEAST, POINTS, DEPTH = 1024, 12, 20
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
        past, mean = r - self.centre if self.outside else self.centre - r, r + self.centre
        mean /= self.unit
        past *= mean
        return past

    def radius(self, scaled: Array) -> Array:
        square, distance = self.centre * self.centre, self.unit * scaled
        return np.sqrt(square + distance if self.outside else square - distance)

    def trend(self, r: Array) -> Array:
        if self.edge is not None:
            difference, total = self.edge - r, self.edge + r
            difference *= total
            return np.sqrt(difference, out=difference)
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
    for part in parts:
        left[part.chosen] = False
    rest = np.flatnonzero(left)
    nodes = [part.course.radius(np.ldexp(2.0 ** (0.5 + 0.5 * _points()[0]), part.panels[:, None])) for part in parts]
    # all in one call: a rule for few radii costs mostly its steps
    radii = [*(x.ravel() for x in nodes), r[rest]]
    *values, value[rest] = np.split(exact(np.concatenate(radii)), np.cumsum([x.size for x in nodes]))
    for part, x, y in zip(parts, nodes, values, strict=True):
        found = _polynomials(_table(part, x, y.reshape(-1, POINTS)), part.rows, part.place)
        found *= part.trend
        value[part.chosen] = found
    return value


class _Part(NamedTuple):
    """The radii of a course in panels that hold more of them than points."""

    course: Course
    panels: Array
    """Panel p reaches from 2**p to 2**(p + 1) units."""
    chosen: Array
    """Where these radii are among all."""
    trend: Array
    """The trend of the course there."""
    rows: Array
    """To which of the panels each belongs."""
    place: Array
    """And where it lies on that, from -1 to 1."""


def _part(course: Course, r: Array, left: Array) -> _Part | None:
    chosen = np.flatnonzero(left & (r > course.centre if course.outside else r < course.centre))
    if chosen.size <= POINTS:
        return None
    radii = r[chosen]
    power = course.scaled(radii)
    np.log2(power, out=power)
    # all panels from -DEPTH, between two rows for the radii below and above
    last = 0 if course.closed else DEPTH
    shift, rows = DEPTH + 1.0, last + DEPTH + 2
    row = np.clip(power + shift, 0.0, rows - 2.0 if course.closed else rows - 1.0).astype(np.intp)
    dense = np.bincount(row, minlength=rows) > POINTS
    dense[[0, -1]] = False
    kept = dense[row]
    if not kept.all():
        if not dense.any():
            return None
        chosen, radii, power, row = chosen[kept], radii[kept], power[kept], row[kept]
    starts = np.arange(rows) - shift
    panels = np.flatnonzero(dense) - (DEPTH + 1)
    power -= starts[row]
    power *= 2.0
    power -= 1.0
    return _Part(course, panels, chosen, course.trend(radii), (np.cumsum(dense) - 1)[row], power)


def _table(part: _Part, r: Array, values: Array) -> Array:
    """Coefficients by degree and panel."""
    points, waves, powers, slopes = _points()
    values = (values / part.course.trend(r)).T
    # the radii are rounded: the values belong to places next to the points
    place = 2.0 * (np.log2(part.course.scaled(r)) - part.panels[:, None]) - 1.0
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
    # rows that are too large would only be checked in a buffer
    term, total = np.empty_like(x), table[-1].take(rows, mode="clip")
    for coefficients in table[-2::-1]:
        np.multiply(total, x, out=total)
        np.add(total, coefficients.take(rows, out=term, mode="clip"), out=total)
    return total
