"""Polynomial: no torsion functions.

Polynomial has no torque that is one integral of known functions; a paraboloid has one, use paraboloid.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = "Polynomial has no torque that is one integral of known functions; a paraboloid has one, use paraboloid"


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
