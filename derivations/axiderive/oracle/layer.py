"""Contact with a layer on a rigid base, in numbers: its surface is where the indenter is.

How far a wave of pressure moves the surface comes from Navier's equations through the thickness.  The pressure is that
of springs, on the half-space d - g(t), on the layer that and an even polynomial, which is found by asking for the
displacement at as many radii of the contact.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..physics.layer import m_0, m_2, thickness
from .half_space import HalfSpace
from .rules import gauss_rule
from .shape import Number

HELD = {"bonded": 0, "frictionless": 1}
"""By the base, the first of two neighbours in (U, W, T, S) that vanish there: U and W, or W and T."""


@lru_cache(maxsize=64)
def waves(nu: Number, base: str, digits: int, wide: int) -> tuple[tuple[Number, Number], ...]:
    """Numbers k of waves for the thickness 1, and the weights of 1 - L there, for radii up to so many thicknesses."""
    # waves that are long for the contact let the rule settle more slowly
    found, step = [], mp.mpf(2) / (digits + 8) / wide
    first, last = (int(end / step) for end in (mp.log(2.5 * digits + 16), mp.log(1.4 * digits + 8)))
    for i in range(-first, last + 1):
        v = i * step
        k = mp.exp(v - mp.exp(-v))
        found.append((k, step * k * (1 + mp.exp(-v)) * (1 - sinking(k, nu, base))))
    return tuple(found)


def sinking(k: Number, nu: Number, base: str) -> Number:
    """L: how far a pressure cos(k x) presses in the surface of a layer of thickness 1, over a half-space."""
    with mp.workdps(mp.mp.dps + int(k) + 10):
        # into the layer, of U sin x, W cos x, the shear T and the stress S, over the shear modulus
        rates = mp.matrix(
            [
                [0, 1, 1, 0],
                [-nu / (1 - nu), 0, 0, (1 - 2 * nu) / (2 * (1 - nu))],
                [2 / (1 - nu), 0, 0, nu / (1 - nu)],
                [0, 0, -1, 0],
            ]
        )
        below, held = mp.expm(rates * k, method="taylor"), HELD[base]
        surface = mp.lu_solve(below[held : held + 2, :2], below[held : held + 2, 3])
        return surface[1] / (1 - nu)


@dataclass(frozen=True)
class Layer:
    """A contact whose springs are pressed in as on the half-space and by a polynomial in (t/a)**2 more.

    At the edge the polynomial is what the last spring carries: nothing, or the pull of adhesion.
    """

    here: HalfSpace
    base: str
    a: Number
    depth: Number
    polynomial: tuple[Number, ...]

    @property
    def _free(self) -> Number | None:
        """The depth of a punch."""
        return self.depth if self.here.profile.complete else None

    def spring(self, t: Number) -> Number:
        """How far the spring at t is pressed in."""
        whole = _whole(self.here, self.a)
        return _short(self.here, whole, t) + mp.polyval([*reversed(self.polynomial)], (t / self.a) ** 2)

    def rate(self, t: Number) -> Number:
        """The derivative of that."""
        slope = [2 * j * c for j, c in enumerate(self.polynomial)][1:]
        bent = mp.mpf(0) if self.here.profile.complete else self.here.face(t).depth_rate(t)
        return t / self.a**2 * mp.polyval([*reversed(slope)], (t / self.a) ** 2) - bent

    def force(self) -> Number:
        """The pressure summed over the contact."""
        more = 2 * self.a * mp.fsum(c / (2 * j + 1) for j, c in enumerate(self.polynomial))
        return self.here.force(self.a, self._free) + self.here.modulus * more

    def pressure(self, r: Number) -> Number:
        """The pressure at r < a; of (t/a)**(2 j) the integral over t**2 = r**2 + (a**2 - r**2) x**2."""
        root, slope = mp.sqrt(self.a**2 - r**2), [2 * j * c for j, c in enumerate(self.polynomial)][1:]

        def rate(x: Number) -> Number:
            return mp.polyval([*reversed(slope)], (r**2 + (root * x) ** 2) / self.a**2)

        edge = mp.fsum(self.polynomial) / root
        more = edge - root / self.a**2 * mp.quad(rate, [0, 1])
        return self.here.pressure(r, self.a, self._free) + self.here.modulus / mp.pi * more

    def value(self, symbol: sp.Symbol) -> Number:
        """Radius, depth, force or pressure."""
        if symbol == nt.p:
            return self.pressure(self.here.at(nt.r))
        return {nt.a: self.a, nt.d: self.depth, nt.F: self.force()}[symbol]

    def stated(self, entry: Entry) -> Number:
        """That of an entry, or what an expansion of it says, with the sums over waves."""
        if entry.status == "equation":
            return self.value(entry.quantity.symbol)
        known = waves(self.here.at(nt.nu), self.base, self.here.digits, 1)
        sums = {symbol: mp.fsum(weight * k**power for k, weight in known) for symbol, power in ((m_0, 0), (m_2, 2))}
        return replace(self.here, values={**self.here.values, **sums}).defined(entry.cases[0].expr)


def layer(here: HalfSpace, base: str, *, adhesive: bool = False) -> Layer:
    """The contact, where its radius is no more than a few times the thickness, to about the digits of `here`.

    With adhesion the energy that the edge releases, E_star q(a)**2 for a unit of radius, is that of its separation.
    """
    a, h, nu = (here.at(symbol) for symbol in (nt.a, thickness, nt.nu))
    count = int(here.digits * (0.4 + 0.3 * float(a / h))) + 4
    wide = max(1, int(mp.ceil(a / h)))
    known = [(k / h, weight / h) for k, weight in waves(nu, base, here.digits, wide)]
    nodes = [(a * x, a * weight) for x, weight in gauss_rule(3 * count, mp.mp.prec)]
    carried = [[weight * (t / a) ** (2 * j) for t, weight in nodes] for j in range(count)]
    rows = [[mp.cos(k * t) for t, _ in nodes] for k, _ in known]
    moments = [[mp.fdot(column, row) for column in carried] for row in rows]
    missing = list(_weighted(here, a))
    lost = [mp.fsum(x * mp.cos(k * t) for t, x in missing) for k, _ in known]
    system, given = mp.eye(count + 1), mp.matrix(count + 1, 1)
    for i in range(count):
        r = a * mp.cos((2 * i + 1) * mp.pi / (4 * count))
        sunk = [2 / mp.pi * weight * mp.besselj(0, k * r) for k, weight in known]
        for j in range(count):
            own = (r / a) ** (2 * j) * mp.binomial(2 * j, j) / 4**j
            system[i, j] = own - mp.fdot(sunk, [row[j] for row in moments])
        given[i] = mp.fdot(sunk, lost)
        if here.profile.compact:  # the depth that goes with it, at which the last spring carries nothing
            system[i, count], system[count, i] = -1, 1
    if here.profile.compact:
        system[count, count] = 0
        given[count] = -mp.sqrt(2 * mp.pi * a * here.at(nt.dgamma) / here.modulus) if adhesive else 0
    *polynomial, less = mp.lu_solve(system, given)
    depth = here.depth(a) + less if here.profile.compact else here.at(nt.d)
    return Layer(here, base, a, depth, tuple(polynomial))


def _whole(here: HalfSpace, a: Number) -> Number:
    """How far the half-space is pressed in by the radius a, or by a punch."""
    return here.at(nt.d) if here.profile.complete else here.depth(a)


def _short(here: HalfSpace, whole: Number, t: Number) -> Number:
    """How far of that the spring at t is pressed in: d - g(t), all of it under a punch."""
    flat = here.at(here.profile.breaks[0]) if here.profile.truncated else mp.mpf(0)
    return whole - (here.depth(t) if here.profile.compact and t > flat else 0)


def _weighted(here: HalfSpace, a: Number) -> Iterator[tuple[Number, Number]]:
    """Radii, and what the half-space is pressed in there times the weight of a rule that bears kinks at breaks."""
    ends = [mp.mpf(0), *(b for b in map(here.at, here.profile.breaks) if b < a), a]
    if nt.wavelength in here.profile.parameters:
        ends[1:1] = [here.at(nt.wavelength) * i for i in range(1, int(mp.ceil(a / here.at(nt.wavelength))))]
    step, whole = mp.mpf(2) / (here.digits + 4), _whole(here, a)
    reach = int(mp.asinh(2.4 * here.digits / mp.pi) / step) + 1
    for low, high in pairwise(ends):
        for i in range(-reach, reach + 1):
            share = 1 / (1 + mp.exp(-mp.pi * mp.sinh(i * step)))
            t = low + (high - low) * share
            weight = (high - low) * step * mp.pi * mp.cosh(i * step) * share * (1 - share)
            yield t, weight * _short(here, whole, t)
