"""The quantities that follow from others: the surface is as good as springs of stiffness 2 E* dt along 0 < t < a.

At t they are pressed in by w1D = d - g(t), with d = g(a) for a contact that grows.  A contact carries within r what its
springs carry, less those of t = sqrt(r^2 + u^2) over u.  The depth comes by quadrature of f', so that these are
integrals of integrals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import mpmath as mp

from .. import notation as nt
from .shape import Number

if TYPE_CHECKING:
    from .half_space import HalfSpace


def load_within(here: HalfSpace, a: Number, free_depth: Number | None) -> Number:
    """2 E* [int_0^a w1D dt - int_0^sqrt(a^2 - r^2) w1D du]."""
    r = here.at(nt.r)
    lost = int(mp.ceil(2 * mp.log10(a / r)))
    with mp.extradps(lost):
        finer = replace(here, digits=here.digits + lost)
        springs = _Springs(finer, a, free_depth)
        breaks = [mp.sqrt((b - r) * (b + r)) for b in springs.breaks if b > r]
        outside = springs.integral(lambda u: springs.share(mp.hypot(r, u)), [*breaks, mp.sqrt((a - r) * (a + r))])
        return finer.force(a, free_depth) - 2 * here.modulus * springs.depth * outside


def energy(here: HalfSpace, a: Number, free_depth: Number | None) -> Number:
    """E* int_0^a w1D^2 dt."""
    springs = _Springs(here, a, free_depth)
    whole = springs.integral(lambda t: springs.share(t) ** 2, [*springs.breaks, a])
    return here.modulus * springs.depth**2 * whole


class _Springs:
    """w1D up to a; the profile is built once and ends at t."""

    def __init__(self, here: HalfSpace, a: Number, free_depth: Number | None) -> None:
        self.face = here.face(a)
        self.depth = self.face.depth(a) if free_depth is None else free_depth
        self.breaks = [piece.lo for piece in self.face.shape.stretches if piece.lo > 0]

    def share(self, t: Number) -> Number:
        """w1D over d."""
        below = (replace(piece, hi=min(piece.hi, t)) for piece in self.face.shape.stretches if piece.lo < t)
        face = replace(self.face, shape=replace(self.face.shape, stretches=tuple(below)))
        return 1 - face.depth(t) / self.depth

    def integral(self, function: Callable[[Number], Number], ends: list[Number]) -> Number:
        """Over a length that is brought to one: mpmath stops at an error that is small beside one."""
        *_, length = ends
        return length * mp.quad(lambda x: function(length * x), [0, *(end / length for end in ends)])


DEFINED: dict[str, Callable[[HalfSpace, Number, Number | None], Number]] = {"Fr": load_within, "U": energy}
"""By suffix."""
