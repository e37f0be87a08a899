"""Stresses and displacements below a rigid indenter on an elastic half-space, under normal load and friction."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .._runtime.subsurface.stresses import (
    Displacement,
    Greatest,
    SlidingStress,
    Stress,
    add,
    hydrostatic,
    principal,
    tresca,
    von_mises,
)

__all__ = [
    "Displacement",
    "Greatest",
    "SlidingStress",
    "Stress",
    "add",
    "capped_cylinder",
    "capped_paraboloid",
    "concave_paraboloid",
    "concave_power",
    "concave_quartic",
    "cone",
    "ellipsoid",
    "flat_punch",
    "gaussian",
    "hydrostatic",
    "hyperboloid",
    "paraboloid",
    "polynomial",
    "power_law",
    "principal",
    "quartic",
    "rounded_cone",
    "rounded_curved_punch",
    "rounded_punch",
    "sextic",
    "sphere",
    "sphere_tipped_cone",
    "tresca",
    "truncated_cone",
    "truncated_paraboloid",
    "von_mises",
    "wavy_paraboloid",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{name}", __name__)
    message = f"module {__name__!r} has no profile {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
