"""Every formula against the integral that defines it, at 50 digits.

The known side of an inverse is the defining integral at a chosen contact
radius; the inverse must lead back to that radius.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..profiles.profile import Profile
from . import balls, integrals
from .evaluate import at_precision, case_at, decades, evaluate
from .evidence import Evidence, judge, residual
from .sampling import Point, points
from .shape import Number, Shape, Values, number, shape
from .threshold import least_depth, ring_radius

LOST = 10
"""Digits that agreement may fall short of the digits of the quadrature."""
THRESHOLDS = ("rz", "dmin", "Fmin")


@dataclass(frozen=True)
class Contact:
    """A contact at one point: the shape up to the contact radius, the depth if the edge is the end of the face."""

    profile: Profile
    values: Values
    digits: int

    def __post_init__(self) -> None:
        object.__setattr__(self, "shape", shape(self.profile, self.values))
        object.__setattr__(self, "radius", number(self.values[nt.a]))
        object.__setattr__(self, "free", None)
        if self.profile.contact == "complete":
            self._complete()

    shape: Shape = None  # type: ignore[assignment]
    radius: Number = None
    free: Number | None = None

    def _complete(self) -> None:
        """Below the depth at which a convex face is in contact up to its edge, the contact ends at a smaller radius."""
        depth = number(self.values[nt.d])
        if depth >= integrals.depth(self.shape, self.radius, self.digits):
            object.__setattr__(self, "free", depth)
            return

        def gap(a: Number) -> Number:
            return integrals.depth(shape(self.profile, {**self.values, nt.a: a}), a, self.digits) - depth

        start = self.radius * mp.sqrt(depth / integrals.depth(self.shape, self.radius, self.digits))
        radius = mp.findroot(gap, (start, start * mp.mpf("1.001")), solver="secant", tol=mp.mpf(10) ** (-2 * self.digits))
        object.__setattr__(self, "radius", radius)
        object.__setattr__(self, "shape", shape(self.profile, {**self.values, nt.a: radius}))

    def quantity(self, suffix: str) -> Number:
        """What the definition says; E* = 1 is left out until here."""
        modulus, digits, a = number(self.values[nt.E_star]), self.digits, self.radius
        match suffix:
            case "d":
                return integrals.depth(self.shape, a, digits) if self.free is None else self.free
            case "F":
                return modulus * integrals.force(self.shape, a, digits, self.free)
            case "pm":
                return modulus * integrals.force(self.shape, a, digits, self.free) / (mp.pi * a**2)
            case "p":
                return modulus * integrals.pressure(self.shape, a, number(self.values[nt.r]), digits, self.free)
            case "w":
                return integrals.displacement(self.shape, a, number(self.values[nt.r]), digits, self.free)
            case "k" if self.free is None:
                rates = (integrals.force_rate(self.shape, a, digits), integrals.depth_rate(self.shape, a, digits))
                return modulus * rates[0] / rates[1]
            case "k":  # the force is linear in the free depth
                forces = [integrals.force(self.shape, a, digits, self.free + step) for step in (0, 1)]
                return modulus * (forces[1] - forces[0])
        message = f"no integral defines {suffix!r}; known are d, F, p, w, k and pm"
        raise ValueError(message)


# what an inverse is given, and what it must lead back to
INVERSES = {"ad": (nt.d, "d", "a"), "aF": (nt.F, "F", "a"), "Fd": (nt.d, "d", "F"), "dF": (nt.F, "F", "d")}
