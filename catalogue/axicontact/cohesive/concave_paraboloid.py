"""Concave paraboloid: no cohesive functions.

Concave paraboloid is a complete contact, at whose edge no zone of attraction ends freely; use adhesive.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = "Concave paraboloid is a complete contact, at whose edge no zone of attraction ends freely; use adhesive"


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
