"""Error against run time on the page of a profile: its formulas that a rule evaluates, in a few panels and sentences.

The letters of the methods are those of the study, which has more of them.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ...entry import COMPACT
from ...physics.plane_quantities import PLANE
from ...physics.systems import problem
from ..evidence import power_of_ten
from .error import DIGITS, FEW, METHODS, Figure, Plots, drawn, lettered, plots, problem_of, widely_measured

WIDTH, HEIGHT = 43.0, 27.0
"""Millimetres of a frame, as high as those of the other plots of a page."""
GOAL = 1e-12
"""The error for which the fastest other way is named."""
REACHED = 1e-14
"""The error for which the nodes of the rule are counted."""
GRADED = "graded half-space"

Row = Mapping[str, Any]


@dataclass(frozen=True)
class Strip:
    """The panels of one contact, its half-space unless it is homogeneous, and what the numbers say of each formula."""

    figure: Figure
    medium: str
    sentences: tuple[str, ...]


@dataclass(frozen=True)
class Timing:
    """What was measured of a profile, contact by contact, and the meaning of the letters."""

    strips: tuple[Strip, ...]
    methods: tuple[tuple[str, str], ...]


def timing(record: Mapping[str, Any], keys: Sequence[str]) -> Timing | None:
    """What was measured of these keys; None if nothing was."""
    everything = plots(record)
    wide = widely_measured(everything)
    found: dict[str, Plots] = {}
    for key in (key for key in keys if key in everything):
        page = FEW if problem_of(key) in wide else FEW | {DIGITS}
        shown = {method: points for method, points in everything[key].items() if method in page}
        found.setdefault(problem_of(key), {})[key] = shown
    if not found:
        return None
    letters = lettered(everything)
    drawn_ones = {method for contact in found.values() for plot in contact.values() for method in plot}
    members = {method: letter for method, letter in letters.items() if method in drawn_ones}
    rows = [row for row in record["rows"] if row["method"] in found.get(problem_of(row["key"]), {}).get(row["key"], {})]
    strips = tuple(
        Strip(
            drawn(contact, letters, frozenset(keys), WIDTH, HEIGHT),
            GRADED if problem(key).system.medium.graded else "",
            tuple(_sentence([row for row in rows if row["key"] == one]) for one in contact),
        )
        for key, contact in found.items()
    )
    meanings = [(letter, METHODS[one].page.format(_settings(one, rows))) for one, letter in members.items()]
    return Timing(strips, tuple(meanings))


def _settings(method: str, rows: Sequence[Row]) -> str:
    """8, 16, 32 and 64, of all formulas together."""
    counts = sorted({_count(row) for row in rows if row["method"] == method and row["setting"]})
    *most, last = map(_whole, counts) if counts else ("",)
    return f"{', '.join(most)} and {last}" if most else last


def _count(row: Row) -> int:
    """Of N = 16 or 15 digits."""
    return int(row["setting"].removeprefix("N = ").removesuffix(" digits"))


def _sentence(rows: Sequence[Row]) -> str:
    """Error of the function, nodes of its rule, and the fastest other way to GOAL."""
    own = rows[0]
    text = f"{_named(own['key'])}: worst error ${_error(own)}$ at {own['points']} points"
    enough = [_count(row) for row in rows if row["method"] == "generated rule" and _reaches(row, REACHED)]
    if enough:
        text += rf"; {min(enough)} nodes of the rule reach ${_power(REACHED)}$"
    others = [row for row in rows if METHODS[row["method"]].sentence and _reaches(row, GOAL)]
    goal = _power(GOAL)
    if not others:
        return rf"{text}. No other way shown reaches ${goal}$."
    best = min(others, key=lambda row: row["ratio"])
    name = METHODS[best["method"]].sentence.format(_whole(_count(best)) if best["setting"] else "")
    return rf"{text}. The fastest other way to ${goal}$, {name}, takes ${_times(best['ratio'])}$ {_compared(best)}."


def _named(key: str) -> str:
    """What stands on the left of the formula, and the half-space where it is not the homogeneous one."""
    of, _, suffix = key.rpartition(".")
    system = problem(of).system
    quantity = (PLANE if system.pool.strip else COMPACT)[suffix]
    left = f"${quantity.left}{'(d)' if quantity.inverts and not system.pool.strip else ''}$"
    return f"{GRADED.capitalize()}, {left}" if system.medium.graded else left


def _reaches(row: Row, goal: float) -> bool:
    return row["worst"] is not None and row["worst"] <= goal and not row["lost"]


def _power(goal: float) -> str:
    return f"10^{{{round(math.log10(goal))}}}"


def _error(row: Row) -> str:
    return power_of_ten(f"{row['worst']:.2g}")


def _compared(row: Row) -> str:
    return "times as long" if row["ratio"] >= 1 else "of the time"


def _times(ratio: float) -> str:
    """Two digits: 0.034, 4.4, 120, 11 000."""
    return _whole(int(ratio)) if ratio >= 10 else f"{ratio:.2g}"


def _whole(number: int) -> str:
    return f"{number:,}".replace(",", r"\,") if number > 9999 else str(number)
