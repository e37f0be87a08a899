"""The choice of an evaluation form in words: cost, errors, and the form beside it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..stable.slopes import RATE

DOMAINS = {"bench": "usual lengths", "extreme": "extreme ones"}


def all_forms(measured: Mapping[str, Any], suffix: str) -> list[str]:
    """Those of one function of a problem, and of the rate of growth beside the result it is the rate of."""
    lines = forms(measured.get(suffix, {}))
    if suffix == ("P" if "P" in measured else "d"):
        lines += [f"rate of growth: {line}" for line in forms(measured.get(RATE.suffix, {}))]
    return lines


def forms(measured: Mapping[str, Any]) -> list[str]:
    """The form the module has and the next best, none where nothing is recorded of a choice."""
    choice = measured.get("selection")
    if choice is None:
        return []
    lines = [_line(choice["chosen"], measured)]
    if "runner_up" in choice:
        other = choice["runner_up"]
        better = " (better, not taken yet)" if "better" in choice else ""
        lines.append(f"not {_line(other, other)}{better}: {other['formula']}")
    return lines


def _line(form: Mapping[str, Any], errors: Mapping[str, Any]) -> str:
    worst = [
        f"{_worst(errors[name])} at {title}" for name, title in DOMAINS.items() if errors.get(name, {}).get("points")
    ]
    return f"{form['form']}, cost {form['cost']}, at most {', '.join(worst)}"


def _worst(found: Mapping[str, Any]) -> str:
    """In units of the last place, with the number of lost values."""
    lost = f" and {found['lost']} of {found['points']} lost" if found["lost"] else ""
    return f"{found['worst_ulp']:.2g} ulp{lost}" if "worst_ulp" in found else f"all {found['lost']} lost"
