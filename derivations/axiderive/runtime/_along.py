"""Integrals at many radii of one contact: their rules at Chebyshev points, and polynomials in between.

As a function of r an integral has one singular radius c; in ln abs(r**2 - c**2) it is
analytic in a strip of half-width pi, apart from a root that vanishes at the edge.
On a panel of length ln 2 polynomials through 14 points are as good as the rule; through 12 they miss it by 3 units.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, wraps
from typing import Any

import numpy as np

from ._elementwise import Array

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
