"""Unknowns of the inverses, in which depth and force are nearly powers where the radius is close to an end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp

UNKNOWN = sp.Symbol("zeta", positive=True)


@dataclass(frozen=True)
class Place:
    """A radius and its root over the unknown of an iteration, exact where the radius alone says too little."""

    code: str
    expressions: Callable[[sp.Expr], tuple[sp.Expr, sp.Expr]]
    root: Callable[[sp.Expr, sp.Expr], sp.Expr]


PLACES = {
    "beyond": Place(
        "{0} * np.sqrt(1.0 + t * t), {0} * t",
        lambda b: (b * sp.sqrt(1 + UNKNOWN**2), b * UNKNOWN),
        lambda a, b: sp.sqrt(a**2 - b**2),
    ),
    "below": Place(
        "{0} * np.tanh(t), {0} / np.cosh(t)",
        lambda R: (R * sp.tanh(UNKNOWN), R / sp.cosh(UNKNOWN)),
        lambda a, R: sp.sqrt(R**2 - a**2),
    ),
}
"""Beyond a flat face or a break, and below an end of the profile."""
