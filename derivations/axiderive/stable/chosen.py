"""What `selection` found better than all rules, frozen: no difference between two machines changes a module."""

from __future__ import annotations

from .variants import FULL, VARIANTS, Variant

CHOSEN = {
    "flat_punch.w": "angles of quotients",
    "hyperboloid.d": "angles of quotients",
    "rounded_cone.d": "angles of quotients",
    "rounded_cone.F": "angles of quotients",
    "rounded_cone.pm": "angles of quotients",
    "truncated_cone.d": "angles of quotients",
    "truncated_cone.F": "angles of quotients",
    "truncated_cone.pm": "angles of quotients",
    "truncated_paraboloid.pm": "expanded sums",
}
"""Names of variants by key of the entry; all others are written by all rules."""
_BY_NAME = {variant.name: variant for variant in VARIANTS}


def chosen(key: str) -> Variant:
    """The variant of an entry."""
    return _BY_NAME[CHOSEN[key]] if key in CHOSEN else FULL
