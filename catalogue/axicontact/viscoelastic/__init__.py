"""Contact with a viscoelastic half-space, while it grows, is held and on the way back."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
    "capped_cylinder",
    "capped_paraboloid",
    "concave_paraboloid",
    "concave_power",
    "concave_quartic",
    "cone",
    "ellipsoid",
    "flat_punch",
    "gaussian",
    "hyperboloid",
    "paraboloid",
    "polynomial",
    "power_law",
    "quartic",
    "rounded_cone",
    "rounded_curved_punch",
    "rounded_punch",
    "sextic",
    "sphere",
    "sphere_tipped_cone",
    "truncated_cone",
    "truncated_paraboloid",
    "wavy_paraboloid",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{name}", __name__)
    message = f"module {__name__!r} has no member {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
