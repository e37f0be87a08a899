"""Concave quartic: no layer functions.

Concave quartic has a face that is not flat, which no function on a layer knows: use flat_punch.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = "Concave quartic has a face that is not flat, which no function on a layer knows: use flat_punch"


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
