"""Parameters of a test of which a few run always; the build does the same for all of them, and so does `-m sweep`."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from functools import wraps
from inspect import signature
from typing import Any

import pytest


def few(every: Iterable[Any], always: Collection[Any], mark: pytest.MarkDecorator = pytest.mark.sweep) -> list[Any]:
    """All parameters in their order, those that do not run always with a mark."""
    found = list(every)
    assert set(always) <= set(found)
    return [one if one in always else _marked(one, mark) for one in found]


def drawn(every: Iterable[Any], count: int, mark: pytest.MarkDecorator = pytest.mark.sweep) -> list[Any]:
    """The same with so many that run always, evenly among all of them."""
    found = list(every)
    return few(found, found[:: -(-len(found) // count)], mark)


def in_turn(every: Iterable[Any], others: Sequence[Any]) -> list[tuple[Any, Any]]:
    """Each of the first with one of the others, which come in turn; that all meet is for `-m sweep`."""
    return [(one, others[index % len(others)]) for index, one in enumerate(every)]


def each_result(function: Callable[..., Any]) -> list[Callable[..., Any]]:
    """The function, or one for each of the numbers that it gives at once, which `result` names."""
    if signature(function).return_annotation != "PeakPressure":
        return [function]
    return [_one(function, name) for name in ("pressure", "radius")]


def _one(function: Callable[..., Any], name: str) -> Callable[..., Any]:
    @wraps(function)
    def alone(*fields: Any, **keywords: Any) -> Any:
        return getattr(function(*fields, **keywords), name)

    alone.result = name  # type: ignore[attr-defined]
    return alone


def _marked(one: Any, mark: pytest.MarkDecorator) -> Any:
    return pytest.param(*(one if isinstance(one, tuple) else (one,)), marks=mark)
