"""What a numerical check leaves behind: plain data, ready for JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

import mpmath as mp

from .shape import Number, Values, numeric_symbols

Outcome = Literal["passed", "failed", "not available"]


@dataclass(frozen=True)
class Evidence:
    """The result of comparing one entry with something independent of it, at `count` points drawn from `seed`."""

    key: str
    compared: str
    outcome: Outcome
    seed: int = 0
    count: int = 0
    extremes: int = 0
    """How many of the points have a ratio of lengths of 1e-9 or 1 - 1e-9."""
    worst: str = ""
    """Largest relative residual."""
    digits: int = 0
    """Digits on which both sides agree at every point."""
    required: int = 0
    worst_point: dict[str, str] = field(default_factory=dict)
    reason: str = ""

    @property
    def passed(self) -> bool:
        """Whether the outcome is "passed"; false also where nothing could be compared."""
        return self.outcome == "passed"


def point_text(values: Values) -> dict[str, str]:
    """The values of a point as text by the names of their symbols, numbers of mpmath to 20 digits."""
    return {str(s): _text(values[s]) for s in numeric_symbols(values)}


def _text(value: Any) -> str:
    return mp.nstr(value, 20) if isinstance(value, mp.mpf) else str(value)


def residual(got: Number, want: Number) -> Number:
    """Relative difference; absolute where the wanted value is zero."""
    return abs(got - want) / abs(want) if want else abs(got)


def agreed(worst: Number, working: int) -> int:
    """Whole digits of agreement, never more than were carried."""
    return working if worst == 0 else max(0, min(working, int(mp.floor(-mp.log10(worst)))))


def not_available(key: str, compared: str, reason: str) -> Evidence:
    """Evidence that nothing could be compared, with the reason."""
    return Evidence(key, compared, "not available", reason=reason)


def judge(
    key: str,
    compared: str,
    rows: Sequence[tuple[Values, Number]],
    *,
    seed: int,
    extremes: int,
    digits: int,
    required: int,
) -> Evidence:
    """Evidence from (point, residual) rows."""
    point, worst = max(rows, key=lambda row: row[1])
    reached = agreed(worst, digits)
    return Evidence(
        key=key,
        compared=compared,
        outcome="passed" if reached >= required else "failed",
        seed=seed,
        count=len(rows),
        extremes=extremes,
        worst=mp.nstr(worst, 2),
        digits=reached,
        required=required,
        worst_point=point_text(point),
    )
