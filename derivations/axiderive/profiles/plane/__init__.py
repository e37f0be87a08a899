"""Profiles of the plane problem, in the order of lists: even functions of x, except for the eccentric punch."""

from __future__ import annotations

from importlib import import_module

from ..profile import Profile, unknown

COMPACT_NAMES = (
    "wedge", "parabola", "quartic", "sextic", "power_law", "truncated_wedge", "rounded_wedge", "rounded_punch",
)  # fmt: skip
COMPLETE_NAMES = ("flat_punch", "eccentric_punch", "concave_power", "concave_parabola", "concave_quartic")
NAMES = COMPACT_NAMES + COMPLETE_NAMES


def load(name: str) -> Profile:
    """The plane profile of that name; `KeyError` with the nearest name if there is none."""
    if name not in NAMES:
        raise unknown(name, NAMES, "unknown plane profile")
    profile: Profile = import_module(f".{name}", __package__).PROFILE
    return profile
