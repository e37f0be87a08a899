"""Prescribed pressures of Foeppl's direction, as data."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..notation import a, p_0, sigma
from .profile import Profile, Sketch, named


@dataclass(frozen=True)
class Load(Profile):
    """Pressure p_0 (1 - r^2/a^2)**exponent inside a circle of radius a, in place of a shape."""

    exponent: sp.Expr = sp.S.Zero


def _load(name: str, title: str, subtitle: str, exponent: sp.Expr) -> Load:
    return Load(
        name=name,
        title=title,
        subtitle=subtitle,
        contact="prescribed",
        parameters=(a, p_0, sigma) if exponent == sigma else (a, p_0),
        pieces=(),
        validity="prescribed pressure, frictionless half-space",
        sources=("Föppl 1941",),
        sketch=Sketch((), a=1.0),
        exponent=exponent,
    )


LOADS = (
    _load("uniform", "Uniform pressure", "Constant pressure on a circle.", sp.S.Zero),
    _load("hertzian", "Hertzian pressure", "The pressure under a paraboloid, which it sinks parabolically.", sp.S.Half),
    _load("punch", "Pressure of the flat punch", "The pressure that moves its circle as a whole.", -sp.S.Half),
    _load("power", "Power of the distance to the edge", "Any exponent s > -1 of 1 - r^2/a^2.", sigma),
)


def load(name: str) -> Load:
    """The prescribed pressure of that name; `KeyError` with the nearest name if there is none."""
    return named(name, LOADS, "unknown pressure")
