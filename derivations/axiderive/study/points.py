"""Arguments at which the methods are compared, and the defining integral there."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..proof import plane_quadrature
from ..proof.definitions import contact
from ..proof.half_space import HalfSpace
from ..proof.shape import number
from . import rivals
from .problems import RADIUS
from .special_functions import Array
from .subject import Subject

DIGITS = 30


def arguments(subject: Subject, suffix: str, count: int) -> Array:
    """Radii in the contact, radii up to 2a outside, or depths of contacts up to a; with adhesion from a/2 on."""
    steps = (np.arange(count) + 0.5) / count
    match suffix:
        case "p":
            return RADIUS * steps
        case "w":
            return RADIUS * (1 + steps)
        case _:
            smallest = RADIUS / 2 if suffix == "ad" else subject.edge
            radii = smallest + (RADIUS - smallest) * steps
            with mp.workdps(DIGITS + 20):
                return np.array([float(defined(subject, float(x))("d")) for x in radii])


@cache
def defined(subject: Subject, radius: float, r: float | None = None) -> Callable[[str], mp.mpf]:
    """The quantities of the contact of that radius, as the integrals of the definition see it."""
    values = _values(subject, radius) | ({} if r is None else {subject.across: sp.Rational(r)})
    with mp.workdps(DIGITS + 20):
        if subject.plane:
            return lambda suffix: plane_quadrature.defined(subject.profile, suffix, values, DIGITS)
        if nt.dgamma in values:
            return partial(_half_space(subject, values).adhesive, a=mp.mpf(radius))
        if subject.graded:
            depth = number(values[nt.d]) if subject.complete else None
            return partial(_half_space(subject, values).normal, a=mp.mpf(radius), free_depth=depth)
        return contact(subject.profile, values, DIGITS).quantity


def _half_space(subject: Subject, values: dict[Any, Any]) -> HalfSpace:
    return HalfSpace(subject.profile, values, DIGITS, subject.graded)


def _values(subject: Subject, radius: float) -> dict[Any, Any]:
    values = {symbol: sp.Rational(value) for symbol, value in subject.values.items()} | {nt.a: sp.Rational(radius)}
    return values | {symbol: expr.subs(values) for symbol, expr in subject.profile.abbreviations}


@cache
def exact(subject: Subject, suffix: str, argument: float) -> mp.mpf:
    """The defining integral at the double that the methods are given."""
    with mp.workdps(DIGITS + 20):
        if suffix in ("p", "w"):
            return defined(subject, RADIUS, argument)(suffix)
        start = rivals.radius(subject, lambda x: float(subject.depth(np.float64(x))) - argument)
        radius, here = mp.mpf(start), defined(subject, start)
        # the depth of that radius misses the argument by its rounding
        missed = mp.mpf(argument) - here("d")
        if suffix == "ad":
            return radius + missed / _rate(subject, start)
        # dF/dd is the stiffness of a flat punch, (11.18)
        k = mp.mpf(subject.exponent)
        return here("F") + 2 * subject.modulus * radius ** (1 + k) / (1 + k) * missed


def _rate(subject: Subject, radius: float) -> mp.mpf:
    """dd/da of an adhesive contact, whose retraction grows as a**((1 - k)/2)."""
    here = _half_space(subject, _values(subject, radius))
    rate, _ = here.rates(mp.mpf(radius))
    return rate - here.retraction(mp.mpf(radius)) * (1 - here.k) / (2 * mp.mpf(radius))
