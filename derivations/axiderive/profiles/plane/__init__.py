"""Profiles of the plane problem, in the order of lists: even functions of x, except for the eccentric punch."""

from __future__ import annotations

import difflib
from importlib import import_module

from ..profile import Profile

COMPACT_NAMES = (
    "wedge", "parabola", "quartic", "sextic", "power_law", "truncated_wedge", "rounded_wedge", "rounded_punch",
)  # fmt: skip
COMPLETE_NAMES = ("flat_punch", "eccentric_punch", "concave_power", "concave_parabola", "concave_quartic")
NAMES = COMPACT_NAMES + COMPLETE_NAMES


def load(name: str) -> Profile:
    """The plane profile of that name; `KeyError` with the nearest name if there is none."""
    if name not in NAMES:
        near = difflib.get_close_matches(name, NAMES, n=1)
        message = f"unknown plane profile {name!r}" + (f"; did you mean {near[0]!r}?" if near else "")
        raise KeyError(message)
    profile: Profile = import_module(f".{name}", __package__).PROFILE
    return profile


def catalogue() -> tuple[Profile, ...]:
    """All plane profiles, in the order of `NAMES`."""
    return tuple(load(name) for name in NAMES)
