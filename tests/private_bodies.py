"""The private functions of the catalogue's modules, and their values without any compiled way."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any

import numpy as np

from axiderive.profiles import NAMES

EPS = np.finfo(float).eps
MODULES = [
    *(f"normal.{name}" for name in NAMES),
    *(
        "tangential.cone",
        "viscoelastic.cone",
        "adhesive.paraboloid",
        "plane.rounded_wedge",
        "loads.uniform",
        "materials",
    ),
]


def bodies(name: str) -> Iterator[Callable[..., Any]]:
    """The private functions of arrays of a module."""
    module = import_module(f"axicontact.{name}")
    for function in vars(module).values():
        if inspect.isfunction(function) and function.__module__ == module.__name__ and function.__name__[0] == "_":
            kinds = set(function.__annotations__.values())
            if kinds == {"Array"} and function.__code__.co_argcount:
                yield function


class Products(np.ndarray[Any, Any]):
    """Arrays whose whole powers are products, as programs have them."""

    def __pow__(self, exponent: Any) -> Any:
        if np.ndim(exponent) or exponent not in (3, 4):
            return super().__pow__(exponent)
        return self * (self * self) if exponent == 3 else (self * self) * (self * self)


def body(function: Callable[..., Any], *values: Any) -> np.ndarray:
    with np.errstate(all="ignore"):
        arrays = (np.asarray(value, dtype=float).view(Products) for value in np.broadcast_arrays(*values))
        return np.asarray(function(*arrays))
