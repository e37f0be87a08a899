"""Cylinder with a parabolic cap: no layer functions.

Cylinder with a parabolic cap has a face that is not flat, which no function on a layer knows: use
flat_punch.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = (
    "Cylinder with a parabolic cap has a face that is not flat, which no function on a layer knows: use flat_punch"
)


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
