"""Concave quartic: no torsion functions.

Concave quartic turns without slip as a flat punch does while its face is in contact: use flat_punch.
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = "Concave quartic turns without slip as a flat punch does while its face is in contact: use flat_punch"


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{name} is not defined: {_REASON}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
