"""Where a material yields: lines of equal von Mises stress below a contact, to scale, under normal load and sliding.

A contact is flat punches of all radii t, each pressed in by g'(t) dt, and one of its own radius pressed in by d - g(a).
The stress of a punch is elementary; the sum over t is taken by Gauss's rule on panels no longer than the depth of the
point, so that the branch points of the punch at t = r + i z stay away.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from .. import notation as nt
from ..abel.form import Order
from ..abel.reduce import parse
from ..notation import C, a, r
from ..oracle.evaluate import evaluated
from ..physics.complete import fixed_face
from .drawing import Drawing, Point
from .tikz import thinned
from .values import Numbers

Array = NDArray[np.float64]
NU, MU = 0.3, 0.3
"""Poisson's ratio and the coefficient of friction of the pictures."""
WIDE, DEEP = 1.5, 1.4
"""How far a picture reaches beside the axis and below the surface, in contact radii."""
GAP = 0.25
STEP = 0.025
"""Distance of the points at which the stress is known; it is 1e-3 of the mean pressure off between them."""
SHADES = (0.15, 0.3, 0.45, 0.6, 0.9, 1.2)
"""Stresses over the mean pressure at which the tone changes."""
CLOSENESS = 0.0015
"""How far a border may be off the points it is drawn through, in contact radii."""
NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)
"""On (-1, 1)."""
BARYCENTRIC = 1 / np.array([np.prod([x - other for other in NODES if other != x]) for x in NODES])
"""Weights of the polynomial through the nodes."""
PANELS = 32
"""Panels of a piece of the slope, on each of which it is a polynomial through its values at the nodes."""
LEVEL, CLOSE, ZOOMS = 0.01, 1e-8, 14
"""Depths that stand for the surface in a picture and in the search for the greatest stress; steps of the search."""


@dataclass(frozen=True)
class Greatest:
    """The greatest stress over the mean pressure and its place in contact radii; infinite on the surface."""

    value: float
    x: float
    z: float

    @property
    def words(self) -> str:
        """The value and its place, for the words beside a picture."""
        if math.isinf(self.value):
            place = "on the axis" if self.x == 0 else "at the edge" if self.x == 1 else f"at $r={self.x:.3g}\\,a$"
            return f"infinite {place}"
        side = "" if self.x < 0.005 and self.x > -0.005 else f"$x={self.x:.2f}\\,a$, "
        depth = f"$z={self.z:.2f}\\,a$" if self.z > 1e-3 else "the surface"
        return f"${self.value:.3f}\\,\\bar p$ at {side}{depth}"


class Field:
    """The stress below one contact in units of its mean pressure; lengths are contact radii."""

    def __init__(self, numbers: Numbers) -> None:
        self.numbers, profile = numbers, numbers.profile
        self.radius = float(numbers["a"])
        self.mean = float(numbers.mean_pressure)
        inner = [b for b in profile.breaks if numbers[b.name] < self.radius]
        self.ends = [0.0, *(float(numbers[b.name]) for b in inner), self.radius]
        self.edge = 0.0 if profile.compact else float(numbers.depth - self._depth_at_edge())

    @cached_property
    def slopes(self) -> list[sp.Expr]:
        """g' as a function of the contact radius, from each break to the next."""
        profile = self.numbers.profile
        if profile.compact:
            cases = sorted(self.numbers.entries[nt.d.name].cases, key=lambda case: case.chain.index(a))
            found = [sp.diff(case.expr, a) for case in cases]
            return [sp.S.Zero, *found] if profile.truncated else found
        return [sp.diff(self._fixed[0], a).subs(C, self._fixed[1])]

    @cached_property
    def _fixed(self) -> tuple[sp.Expr, sp.Expr]:
        """g of a face whose edge is elsewhere, and its coefficient."""
        face, coefficient = fixed_face(self.numbers.profile)
        own = coefficient.subs(a, nt.L)
        return parse(face).depth(Order((a,))).expr(), own

    def _depth_at_edge(self) -> float:
        expr, coefficient = self._fixed
        return float(self._value(expr.subs(C, coefficient), self.radius))

    def _value(self, expr: sp.Expr, radius: float) -> float:
        """A formula at another contact radius; L is that of the face."""
        numbers = self.numbers
        return float(evaluated(expr, {**numbers.values, nt.L: numbers.values[a], a: sp.Float(radius)}).real)

    @cached_property
    def _known(self) -> dict[int, Array]:
        """The slope at the nodes of panels, by piece; where it is not zero."""
        shares = (np.arange(PANELS)[:, None] + (1 + NODES) / 2) / PANELS
        known = {i: self._place(i, shares) for i in range(len(self.ends) - 1) if self.slopes[i] != 0}
        return {
            i: np.array([[self._value(self.slopes[i], t) for t in row] for row in rows]) for i, rows in known.items()
        }

    def _place(self, piece: int, share: Array) -> Array:
        """The radius at a share of the variable in which roots at both ends of a piece of the slope are smooth."""
        low, high = self.ends[piece : piece + 2]
        return low + (high - low) * share**2 * (3 - 2 * share)

    def _punches(self, piece: int, borders: Array) -> tuple[Array, Array]:
        """Radii of punches for Gauss's rule between shares, and what each is pressed in by."""
        low, width = borders[:-1, None], np.diff(borders)[:, None]
        share = (low + width * (1 + NODES) / 2).ravel()
        panel = np.minimum((share * PANELS).astype(int), PANELS - 1)
        gap = 2 * (share * PANELS - panel)[:, None] - 1 - NODES
        near = BARYCENTRIC / np.where(gap == 0.0, 1e-30, gap)
        slope = (near * self._known[piece][panel]).sum(-1) / near.sum(-1)
        rate = 6 * (self.ends[piece + 1] - self.ends[piece]) * share * (1 - share)
        return self._place(piece, share), slope * rate * (width * WEIGHTS / 2).ravel()

    def _sums(self, x: Array, z: float, borders: Callable[[int], Array]) -> Array:
        """S_0 ... S_3 and D_0 ... D_3 of the contact at places of one depth."""
        parts = [self._punches(piece, borders(piece)) for piece in self._known]
        parts += [(np.array([self.radius]), np.array([self.edge]))] if self.edge else []
        return np.array(sum(punches(np.abs(x)[:, None], z, t) @ weight for t, weight in parts))

    def mises(self, x: Array, z: float, *coefficients: float) -> Array:
        """The stress of von Mises at places of one depth in the plane of the traction, which points to greater x.

        By rows, one for each coefficient of friction.
        """
        count = 2 ** max(1, math.ceil(math.log2(2.0 / z)))
        sums = self._sums(x * self.radius, z * self.radius, lambda _: np.linspace(0.0, 1.0, count + 1))
        return np.array([self._mises(sums, mu * np.where(x < 0.0, -1.0, 1.0)) for mu in coefficients])

    def _mises(self, sums: Array, turned: Array) -> Array:
        """From the sums, and the coefficient of friction with the sign of the cosine at each place."""
        s0, s1, s2, s3, d0, d1, d2, d3 = sums
        mean = (d0 - (1 + 2 * NU) * s0) / 2 + turned * (d1 / 2 - (1 + NU) * s1)
        apart = ((1 - 2 * NU) * s2 - d2) / 2 + turned * ((NU / 2 - 1) * s1 + d1 / 4 - (2 * NU * s3 + d3) / 4)
        along, across, down = mean + apart, mean - apart, -(s0 + d0) - turned * d1
        shear = -d1 - turned * (s0 - d0 / 2 + d2 / 2)
        squares = ((along - across) ** 2 + (across - down) ** 2 + (down - along) ** 2) / 2 + 3 * shear**2
        return np.asarray(np.sqrt(squares) * float(self.numbers[nt.E_star.name]) / (math.pi * self.mean))

    def greatest(self, mu: float, start: Point) -> Greatest:
        """The greatest stress, where the pressure is finite, by ever smaller grids around a place."""
        if (place := self._infinite()) is not None:
            return Greatest(math.inf, place, 0.0)
        best, width = Greatest(-math.inf, *start), 2 * STEP
        for _ in range(ZOOMS):
            grid = np.linspace(-width, width, 5)
            across = np.unique(best.x + grid) if mu else np.unique(np.abs(best.x + grid))
            tried = [self._near(float(x), float(z), mu) for x in across for z in {*np.maximum(best.z + grid, CLOSE)}]
            best, width = max([best, *tried], key=lambda one: one.value), width / 2
        return best

    def _near(self, x: float, z: float, mu: float) -> Greatest:
        """The stress at one place, which may be close to the surface: the panels become short towards its radius."""

        def borders(piece: int) -> Array:
            low, high = self.ends[piece : piece + 2]
            at = min(max((abs(x) * self.radius - low) / (high - low), 0.0), 1.0)
            # inverse of the share**2 (3 - 2 share) of a place
            share = 0.5 - math.sin(math.asin(1.0 - 2.0 * at) / 3.0)
            steps = 0.5 ** np.arange(math.ceil(-2 * math.log2(z)) + 3)
            return np.unique(np.clip([0.0, 1.0, share, *(share + steps), *(share - steps)], 0.0, 1.0))

        sums = self._sums(np.array([x * self.radius]), z * self.radius, borders)
        return Greatest(float(self._mises(sums, np.array(-mu if x < 0.0 else mu))[0]), x, z)

    def _infinite(self) -> float | None:
        """The radius at which the pressure is infinite, in contact radii; None if it is finite."""
        if self.edge:
            return 1.0
        profile, values = self.numbers.profile, self.numbers.values
        rates = [sp.diff(piece.expr, r) for piece in profile.pieces]
        for place, low, high in zip(self.ends[:-1], [sp.S.Zero, *rates], rates, strict=False):
            near = {**values, r: sp.Float(max(place, 1e-30 * self.radius))}
            if float(evaluated(high, near).real) - float(evaluated(low, near).real) > 1e-9:
                return place / self.radius
        return None


def punches(r: Array, z: float, t: Array) -> Array:
    """S_0 ... S_3 and D_0 ... D_3 of flat punches of radii t pressed in by one, as the first axis."""
    zeta = z + 1j * t
    rho = np.sqrt(zeta - 1j * r) * np.sqrt(zeta + 1j * r)
    powers = [(r / (rho + zeta)) ** m / rho for m in range(4)]
    bent = [z * (zeta + m * rho) * own / rho**2 for m, own in enumerate(powers)]
    return -np.array([*powers, *bent]).imag


def pictures(numbers: Numbers) -> Drawing:
    """Half of the section under the normal load, and the whole one while the contact slides to the right."""
    field = Field(numbers)
    across = np.arange(-WIDE, WIDE + STEP / 2, STEP)
    down = np.array([LEVEL, *np.arange(STEP, DEEP + STEP / 2, STEP)])
    pressed, sliding = (np.array(rows) for rows in zip(*(field.mises(across, z, 0.0, MU) for z in down), strict=True))
    middle = across.size // 2
    down[0] = 0.0
    sections = ((0.0, across[middle:], pressed[:, middle:], 0.0), (2 * WIDE + GAP, across, sliding, MU))
    figure = Drawing("contours", (-0.05, -DEEP - 0.02), (3 * WIDE + GAP + 0.02, 0.14), anchor="stress")
    found = []
    for left, x, values, mu in sections:
        frame = [(left + x[0], 0.0), (left + x[-1], 0.0), (left + x[-1], -DEEP), (left + x[0], -DEEP)]
        figure.area("ground", frame)
        for shade, loop in shaded(x, down, values):
            border = thinned([(left + across, -deep) for across, deep in loop], CLOSENESS)
            figure.area(f"level{shade}" if shade >= 0 else "ground", border)
        figure.line("contact", (left + max(x[0], -1.0), 0.0), (left + 1.0, 0.0))
        row, column = np.unravel_index(np.argmax(values), values.shape)
        places = [(float(x[column]), float(down[row])), *([(-1.0, 0.0)] if mu else [])]
        top = max((field.greatest(mu, place) for place in places), key=lambda one: one.value)
        figure.dot("dot peak", (left + top.x, -top.z))
        found.append(top.words)
    figure.line("arrow", (2 * WIDE + GAP - 0.25, 0.08), (2 * WIDE + GAP + 0.25, 0.08), heads=1)
    words = f"greatest at the dots: {found[0]}, sliding {found[1]}."
    figure.caption = ("Von Mises stress", words)
    figure.seen = f"Von Mises stress below the contact, {words}"
    return figure


def shaded(x: Array, z: Array, values: Array) -> list[tuple[int, list[Point]]]:
    """Areas to be painted one over the other, the widest first: the index of the tone within each, and its border."""
    found = [(shade, loop) for shade, level in enumerate(SHADES) for loop in loops(x, z, values - level)]
    sizes = [(abs(area(loop)), shade if area(loop) > 0 else shade - 1, loop) for shade, loop in found]
    return [(shade, loop) for _, shade, loop in sorted(sizes, key=lambda one: -one[0])]


def area(loop: list[Point]) -> float:
    """The area within a border, negative where it is lower inside."""
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(loop, [*loop[1:], loop[0]], strict=True)) / 2


def loops(x: Array, z: Array, values: Array) -> Iterator[list[Point]]:
    """Closed lines around all that is above zero, which lies to their left; the frame closes what reaches it."""
    x, z = np.pad(x, 1, "edge"), np.pad(z, 1, "edge")
    values = np.pad(values, 1, constant_values=-1.0)
    above = values > 0.0

    def crossing(one: Corner, other: Corner) -> Point:
        """Where the value is zero between two corners; on the frame for one that lies beyond it."""
        low, high = values[one], values[other]
        share = float(low / (low - high))
        (i, j), (k, m) = one, other
        return float(x[j] + share * (x[m] - x[j])), float(z[i] + share * (z[k] - z[i]))

    after: dict[Side, Side] = {}
    for i, j in zip(*np.nonzero(above[:-1, :-1] | above[1:, :-1] | above[:-1, 1:] | above[1:, 1:]), strict=True):
        corners = [(int(i), int(j)), (int(i), int(j) + 1), (int(i) + 1, int(j) + 1), (int(i) + 1, int(j))]
        sides = list(zip(corners, [*corners[1:], corners[0]], strict=True))
        enters = [side for side in sides if not above[side[0]] and above[side[1]]]
        leaves = [side for side in sides if above[side[0]] and not above[side[1]]]
        for enter, leave in zip(enters, leaves, strict=True):
            after[leave] = (enter[1], enter[0])
    while after:
        start, here = after.popitem()
        loop = [crossing(*start)]
        while here != start:
            loop.append(crossing(*here))
            here = after.pop(here)
        yield loop


Corner = tuple[int, int]
Side = tuple[Corner, Corner]
