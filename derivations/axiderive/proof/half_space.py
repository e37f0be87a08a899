"""Contact on the homogeneous or the graded half-space as its definitions say: normal, adhesive, tangential.

Adhesion is not derived here by the formulas of the engine but as the normal
contact with the free depth g(a) - Dl, with Dl from the balance of energies
(11.63); partial slip as the difference of two normal contacts.
"""

from __future__ import annotations

from dataclasses import dataclass

import mpmath as mp

from .. import notation as nt
from ..profiles.profile import Profile
from . import integrals
from .graded_integrals import Graded
from .shape import Number, Values, number, shape


@dataclass(frozen=True)
class HalfSpace:
    """One profile at one point on a half-space with c_N(x) = modulus * |x|**k."""

    profile: Profile
    values: Values
    digits: int
    graded: bool

    @property
    def k(self) -> Number:
        return number(self.values[nt.k]) if self.graded else mp.mpf(0)

    @property
    def modulus(self) -> Number:
        return number(self.values[nt.H if self.graded else nt.E_star])

    def at(self, symbol: object) -> Number:
        return number(self.values[symbol])

    def face(self, a: Number, digits: int | None = None) -> Graded:
        """The profile up to the radius a."""
        return Graded(shape(self.profile, {**self.values, nt.a: a}), self.k, digits or self.digits)

    def depth(self, a: Number) -> Number:
        """g(a)."""
        face = self.face(a)
        return face.depth(a) if self.graded else integrals.depth(face.shape, a, self.digits)

    def force(self, a: Number, free_depth: Number | None = None) -> Number:
        face = self.face(a)
        if self.graded:
            return self.modulus * face.force(a, free_depth)
        return self.modulus * integrals.force(face.shape, a, self.digits, free_depth)

    def pressure(self, r: Number, a: Number, free_depth: Number | None = None) -> Number:
        face = self.face(a)
        if self.graded:
            return self.modulus * face.pressure(a, r, free_depth)
        return self.modulus * integrals.pressure(face.shape, a, r, self.digits, free_depth)

    def displacement(self, r: Number, a: Number, free_depth: Number | None = None) -> Number:
        face = self.face(a)
        if self.graded:
            return face.displacement(a, r, free_depth)
        return integrals.displacement(face.shape, a, r, self.digits, free_depth)

    def rates(self, a: Number) -> tuple[Number, Number]:
        """dg/da and dF/da of the compact contact, the definitions differentiated under their signs."""
        face, digits = self.face(a, self.digits + 20), self.digits + 20
        if self.graded:
            return face.depth_rate(a), self.modulus * face.force_rate(a)
        return integrals.depth_rate(face.shape, a, digits), self.modulus * integrals.force_rate(face.shape, a, digits)

    def retraction(self, a: Number) -> Number:
        """Dl from 2 pi a dgamma = c_N(a) Dl**2, (11.63)."""
        return mp.sqrt(2 * mp.pi * a * self.at(nt.dgamma) / (self.modulus * a**self.k))

    def normal(self, suffix: str, a: Number, free_depth: Number | None = None) -> Number:
        """d, F, pm, p, w or k; `free_depth` is that of a complete contact."""
        match suffix:
            case "d":
                return self.depth(a) if free_depth is None else free_depth
            case "F":
                return self.force(a, free_depth)
            case "pm":
                return self.force(a, free_depth) / (mp.pi * a**2)
            case "p":
                return self.pressure(self.at(nt.r), a, free_depth)
            case "w":
                return self.displacement(self.at(nt.r), a, free_depth)
            case "k" if free_depth is None:
                depth_rate, force_rate = self.rates(a)
                return force_rate / depth_rate
            case "k" if free_depth is not None:  # the force is linear in the free depth
                return self.force(a, free_depth + 1) - self.force(a, free_depth)
        message = f"no integral defines {suffix!r}; use d, F, pm, p, w or k"
        raise ValueError(message)

    def adhesive(self, suffix: str, a: Number) -> Number:
        """The contact without adhesion whose depth is left short by Dl."""
        retraction = self.retraction(a)
        return retraction if suffix == "Dl" else self.normal(suffix, a, self.depth(a) - retraction)

    def separation(self, control: str, a: Number) -> Number:
        """The work of separation at which the defined F(a) resp. d(a) is stationary at this radius.

        X(a) = X_0(a) - sqrt(dgamma) Y(a): the stationary point asks for sqrt(dgamma) = X_0'/Y'.
        """
        depth_rate, force_rate = self.rates(a)
        unit = mp.sqrt(2 * mp.pi / self.modulus)

        def lost(x: Number) -> Number:
            short = unit * x ** ((1 - self.k) / 2)
            stiffness = 2 * self.modulus * x ** (1 + self.k) / (1 + self.k)
            return short if control == "depth" else stiffness * short

        # the punch alone: a power of a, whose derivative is an exact ratio of its value
        power = (1 - self.k) / 2 if control == "depth" else (3 + self.k) / 2
        own_rate = depth_rate if control == "depth" else force_rate
        return (own_rate * a / (power * lost(a))) ** 2

    def tangential(self, suffix: str, a: Number) -> Number:
        """mu times the difference of two normal contacts; u0 with the ratio of the moduli, (11.78)-(11.80)."""
        mu = self.at(nt.mu)
        ratio = mu * self.modulus / self.at(nt.H_x if self.graded else nt.G_star)
        if suffix == "us":  # a flat tip slips at once: its normal contact needs no depth
            return ratio * self.depth(a)
        c = self.at(nt.c)
        if suffix == "F":
            return mu * (self.force(a) - self.force(c))
        if suffix == "u":
            return ratio * (self.depth(a) - self.depth(c))
        r = self.at(nt.r)
        stuck = self.pressure(r, c) if r < c else mp.mpf(0)
        return mu * (self.pressure(r, a) - stuck)
