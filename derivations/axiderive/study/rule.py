"""The rules of the catalogue with their number of nodes left open."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import import_module
from typing import Any

from .subject import Array


def with_nodes(function: Callable[[Array], Array], x: Array, count: int) -> Array:
    """A function of the catalogue, its rules with that many nodes."""
    with _nodes(count):
        return function(x)


@contextmanager
def _nodes(count: int) -> Iterator[None]:
    """Every rule of the catalogue in one interval of `count` nodes, at each point by itself."""
    integrals, weights = (import_module(f"axicontact._runtime.{name}") for name in ("integrals", "graded.rules"))
    whole, weighted = integrals.integral, weights.weighted

    def fixed(integrand: Callable[[Array], Array], stop: Array, _: int) -> Array:
        return whole(integrand, stop, count)

    def fixed_weighted(
        smooth: Callable[[Array], Array], stop: Array, power: Array, _: int = 0, **above: Array
    ) -> Array:
        return weighted(smooth, stop, power, count, **above)

    # from these numbers of points on they would be put in groups, and interpolated along r
    unbounded = [(integrals, "FEW"), (integrals, "LEAST")]
    changes: list[tuple[Any, str, Any]] = [(one, name, math.inf) for one, name in unbounded]
    changes += [(one, "integral", fixed) for one in _modules_with("integral", whole)]
    changes += [(one, "weighted", fixed_weighted) for one in _modules_with("weighted", weighted)]
    before = [(one, name, getattr(one, name)) for one, name, _ in changes]
    try:
        for one, name, value in changes:
            setattr(one, name, value)
        yield
    finally:
        for one, name, value in before:
            setattr(one, name, value)


def _modules_with(name: str, value: Any) -> list[Any]:
    """Those of the catalogue that have the function by its name, from wherever."""
    loaded = [module for key, module in sys.modules.items() if key.startswith("axicontact.")]
    return [module for module in loaded if getattr(module, name, None) is value]
