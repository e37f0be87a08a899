"""Parameters of a test of which a few run always; the build does the same for all of them, and so does `-m sweep`."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def few(every: Iterable[Any], always: Collection[Any], mark: pytest.MarkDecorator = pytest.mark.sweep) -> list[Any]:
    """All parameters in their order, those that do not run always with a mark."""
    found = list(every)
    assert set(always) <= set(found)
    return [one if one in always else _marked(one, mark) for one in found]


def _marked(one: Any, mark: pytest.MarkDecorator) -> Any:
    return pytest.param(*(one if isinstance(one, tuple) else (one,)), marks=mark)
