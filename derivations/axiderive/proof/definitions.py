"""One contact at one point, and what the definitions say about it."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath as mp

from .. import notation as nt
from ..profiles.profile import Profile
from . import integrals
from .shape import Number, Shape, Values, number, shape


@dataclass(frozen=True)
class Contact:
    """The shape up to the contact radius, and the depth where the edge of the face leaves it free."""

    values: Values
    digits: int
    shape: Shape
    radius: Number
    free_depth: Number | None

    def quantity(self, suffix: str) -> Number:
        """The quantity as its defining integral."""
        modulus, digits, a = number(self.values[nt.E_star]), self.digits, self.radius
        match suffix:
            case "d":
                return integrals.depth(self.shape, a, digits) if self.free_depth is None else self.free_depth
            case "F":
                return modulus * integrals.force(self.shape, a, digits, self.free_depth)
            case "pm":
                return modulus * integrals.force(self.shape, a, digits, self.free_depth) / (mp.pi * a**2)
            case "p":
                return modulus * integrals.pressure(self.shape, a, number(self.values[nt.r]), digits, self.free_depth)
            case "w":
                return integrals.displacement(self.shape, a, number(self.values[nt.r]), digits, self.free_depth)
            case "k" if self.free_depth is not None:  # the force is linear in the free depth
                deeper = integrals.force(self.shape, a, digits, self.free_depth + 1)
                return modulus * (deeper - integrals.force(self.shape, a, digits, self.free_depth))
            case "k":
                # both rates vanish where the contact ceases to be compact, hence the extra digits
                rates = [rate(self.shape, a, digits + 20) for rate in (integrals.force_rate, integrals.depth_rate)]
                return modulus * rates[0] / rates[1]
        message = f"no integral defines {suffix!r}; use d, F, p, w, k or pm"
        raise ValueError(message)


def contact(profile: Profile, values: Values, digits: int) -> Contact:
    """The contact of radius a; a complete one at the depth d, which may leave a convex face partly out of contact."""
    face, a = shape(profile, values), number(values[nt.a])
    if profile.contact == "compact":
        return Contact(values, digits, face, a, None)
    depth, full = number(values[nt.d]), integrals.depth(face, a, digits)
    if depth >= full:
        return Contact(values, digits, face, a, depth)
    radius = _partial_radius(profile, values, a * mp.sqrt(depth / full), digits)
    return Contact(values, digits, shape(profile, {**values, nt.a: radius}), radius, None)


def _partial_radius(profile: Profile, values: Values, start: Number, digits: int) -> Number:
    """g(a) = d by secants, with g by quadrature."""
    wanted = number(values[nt.d])

    def gap(a: Number) -> Number:
        return integrals.depth(shape(profile, {**values, nt.a: a}), a, digits) / wanted - 1

    nearby, tolerance = start * mp.mpf("1.001"), mp.mpf(10) ** (-2 * digits)
    return mp.findroot(gap, (start, nearby), solver="secant", tol=tolerance, verify=False)
