"""Plane contact without adhesion: rigid strips on an elastic half plane, per length of the strip."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
    "concave_parabola",
    "concave_power",
    "concave_quartic",
    "eccentric_punch",
    "flat_punch",
    "parabola",
    "power_law",
    "quartic",
    "rounded_punch",
    "rounded_wedge",
    "sextic",
    "truncated_wedge",
    "wedge",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{name}", __name__)
    message = f"module {__name__!r} has no member {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
