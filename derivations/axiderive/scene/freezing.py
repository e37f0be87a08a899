"""Values of a scene: read with their units, checked against the domain of their symbol, kept as SI."""

from __future__ import annotations

import math
from typing import Any

from .. import notation as nt
from ..emit.symbols import bounds
from ..profiles.profile import Profile
from . import interface
from .text import SceneText
from .units import UnitError, kind_of, value_of


def frozen(
    text: SceneText, values: dict[str, float], section: str, key: str, raw: Any, profile: Profile | None = None
) -> None:
    """Read, check and keep one value; `key` names a parameter of the functions."""
    record = interface.record(key, profile)
    try:
        value = value_of(raw, kind_of(record))
    except UnitError as error:
        text.problem(section, key, f"{key} {error}" if str(error).startswith("must") else f"{key}: {error}")
        return
    low, high = _bounds(record)
    if not low < value < high:
        bare = record.unit == "rad" and not isinstance(raw, str) and high < value < 90
        hint = f'degrees need a unit: {key} = "{value:g} deg"' if bare else "change the value"
        given = repr(raw) if isinstance(raw, str) else f"{value:g}"
        text.problem(section, key, f"{key} = {given:.40} is outside {record.domain}; {hint}")
        return
    values[key] = value


def _bounds(record: nt.Notation) -> tuple[float, float]:
    try:
        low, high, _ = bounds(record.domain)
    except (ValueError, TypeError):
        return 0.0 if record.symbol.is_positive else -math.inf, math.inf
    return float(low), float(high)


def inline(text: SceneText, values: dict[str, float], name: str, key: str, value: Any) -> None:
    """A value of an inline table: its line is that of the table."""
    before = len(text.problems)
    frozen(text, values, "physics", key, value)
    line = text.line_of("physics", name)
    for i in range(before, len(text.problems)):
        message = text.problems[i][1].split(": ", 1)[1].split("\n  ")[0]
        text.problems[i] = (line, text.at(line, message))
