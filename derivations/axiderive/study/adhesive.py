"""Other ways to the radius of an adhesive contact at a given depth: g by quadrature less the retraction (11.63)."""

from __future__ import annotations

import math

import mpmath as mp
import numpy as np

from .. import notation as nt
from .problems import RADIUS
from .rivals import quad, radius
from .special_functions import Array
from .subject import Subject


def quad_radius(subject: Subject, d: Array) -> Array:
    """g by quad, the radius by brentq."""

    def depth(x: float) -> float:
        free = x * quad(lambda u: float(subject.slope(x * math.sin(u))), 0.0, math.pi / 2)
        return free - math.sqrt(2 * math.pi * x * subject.values[nt.dgamma] / subject.modulus)

    def one(given: float) -> float:
        return radius(subject, lambda x: depth(x) - given)

    return np.array([one(float(x)) for x in d])


def table_radius(subject: Subject, d: Array, count: int) -> Array:
    """A table of d(a) on a uniform grid from a/2 on, read by linear interpolation."""
    x = np.linspace(RADIUS / 2, RADIUS, count + 1)
    return np.interp(d, subject.depth(x), x)


def mpmath_radius(subject: Subject, d: Array, digits: int) -> list[mp.mpf]:
    with mp.workdps(digits):
        dgamma, modulus = (mp.mpf(x) for x in (subject.values[nt.dgamma], subject.modulus))

        def depth(x: mp.mpf) -> mp.mpf:
            free = x * mp.quad(lambda u: subject.slope_mp(x * mp.sin(u)), [0, mp.pi / 2])
            return free - mp.sqrt(2 * mp.pi * x * dgamma / modulus)

        def one(given: mp.mpf) -> mp.mpf:
            start = mp.mpf(radius(subject, lambda x: float(subject.depth(np.float64(x)) - float(given))))
            nearby = start * (1 + mp.mpf(10) ** (-min(digits, 15) // 2))
            return mp.findroot(lambda x: depth(x) / given - 1, (start, nearby), tol=mp.eps**1.5, verify=False)

        return [one(mp.mpf(float(x))) for x in d]
