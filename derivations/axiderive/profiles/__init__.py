"""The catalogue of axisymmetric profiles, in the order of lists; that of the book is its own."""

from __future__ import annotations

from importlib import import_module

from .profile import Profile, unknown

COMPACT_NAMES = (
    "cone", "sphere_tipped_cone", "rounded_cone", "paraboloid", "quartic", "sextic", "power_law", "polynomial",
    "sphere", "ellipsoid", "hyperboloid", "truncated_cone", "truncated_paraboloid", "capped_paraboloid",
    "wavy_paraboloid", "gaussian", "rounded_curved_punch", "rounded_punch",
)  # fmt: skip
COMPLETE_NAMES = ("flat_punch", "capped_cylinder", "concave_power", "concave_paraboloid", "concave_quartic")
NAMES = COMPACT_NAMES + COMPLETE_NAMES


def load(name: str) -> Profile:
    """The profile of that name; `KeyError` with the nearest name if there is none."""
    if name not in NAMES:
        raise unknown(name, NAMES, "unknown profile")
    profile: Profile = import_module(f".{name}", __package__).PROFILE
    return profile
