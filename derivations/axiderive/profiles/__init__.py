"""The catalogue of axisymmetric profiles, in the order of lists; that of the book is its own."""

from __future__ import annotations

from . import compact, complete
from .profile import Profile, named

PROFILES = compact.PROFILES + complete.PROFILES
COMPACT_NAMES = tuple(own.name for own in compact.PROFILES)
COMPLETE_NAMES = tuple(own.name for own in complete.PROFILES)
NAMES = COMPACT_NAMES + COMPLETE_NAMES


def load(name: str) -> Profile:
    """The profile of that name; `KeyError` with the nearest name if there is none."""
    return named(name, PROFILES, "unknown profile")
