"""Prescribed pressures of Foeppl's direction, as data."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..notation import sigma


@dataclass(frozen=True)
class Load:
    """Pressure p_0 (1 - r^2/a^2)^s inside a circle of radius a."""

    name: str
    title: str
    exponent: sp.Expr
    subtitle: str


LOADS = (
    Load("uniform", "Uniform pressure", sp.S.Zero, "Constant pressure on a circle."),
    Load(
        "hertzian", "Hertzian pressure", sp.S.Half, "The pressure under a paraboloid: a parabolic displacement inside."
    ),
    Load("punch", "Pressure of the flat punch", -sp.S.Half, "A constant displacement inside."),
    Load("power", "Power of the distance to the edge", sigma, "Any exponent s > -1."),
)
