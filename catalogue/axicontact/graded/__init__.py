"""Contact on a half-space whose modulus grows as a power of the depth."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
    "adhesive",
    "normal",
    "tangential",
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{name}", __name__)
    message = f"module {__name__!r} has no member {name!r}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
