"""Arguments at which the methods are compared, and the defining integral there."""

from __future__ import annotations

from functools import cache
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..proof.definitions import Contact, contact
from . import rivals
from .subject import RADIUS, Array, Subject

DIGITS = 30


def arguments(subject: Subject, suffix: str, count: int) -> Array:
    """Radii in the contact, radii up to 2a outside, or depths of contacts up to a."""
    steps = (np.arange(count) + 0.5) / count
    match suffix:
        case "p":
            return RADIUS * steps
        case "w":
            return RADIUS * (1 + steps)
        case _:
            radii = subject.edge + (RADIUS - subject.edge) * steps
            with mp.workdps(DIGITS + 20):
                return np.array([float(defined(subject, float(x)).quantity("d")) for x in radii])


@cache
def defined(subject: Subject, radius: float, r: float | None = None) -> Contact:
    """The contact of that radius, as the integrals of the definition see it."""
    values: dict[Any, Any] = {symbol: sp.Rational(value) for symbol, value in subject.values.items()}
    values[nt.a] = sp.Rational(radius)
    if r is not None:
        values[nt.r] = sp.Rational(r)
    with mp.workdps(DIGITS + 20):
        return contact(subject.profile, values, DIGITS)


@cache
def exact(subject: Subject, suffix: str, argument: float) -> mp.mpf:
    """The defining integral at the double that the methods are given."""
    with mp.workdps(DIGITS + 20):
        if suffix in ("p", "w"):
            return defined(subject, RADIUS, argument).quantity(suffix)
        radius = rivals.radius(subject, lambda x: float(subject.depth(np.float64(x))) - argument)
        here = defined(subject, radius)
        # the depth of that radius misses the argument by its rounding; dF/dd = 2 E* a is (11.18)
        missed = mp.mpf(argument) - here.quantity("d")
        return here.quantity("F") + 2 * subject.modulus * mp.mpf(radius) * missed
