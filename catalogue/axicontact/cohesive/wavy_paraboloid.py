"""Wavy paraboloid: no cohesive functions.

Wavy paraboloid has waves, over which the definition of the gap is not compared in a minute; use adhesive.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = "Wavy paraboloid has waves, over which the definition of the gap is not compared in a minute; use adhesive"


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
