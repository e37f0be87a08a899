"""Closed forms of elastic contact as NumPy functions, a package per kind of contact, a module per profile."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
    "adhesive",
    "cohesive",
    "expressions",
    "graded",
    "layer",
    "loads",
    "materials",
    "normal",
    "plane",
    "subsurface",
    "tangential",
    "torsion",
    "viscoelastic",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{name}", __name__)
    message = f"module {__name__!r} has no attribute {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
