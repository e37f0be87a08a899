"""The forms that `axicontact study forms` found better than all rules, frozen.

No difference between two machines changes a module, and an engine that writes modules for scenes measures nothing.
"""

from __future__ import annotations

from .variants import FULL, SPLITS, VARIANTS, Variant

CHOSEN = {
    "flat_punch.w": "angles of quotients",
    "hyperboloid.d": "angles of quotients",
    "hyperboloid.slope": "angles of quotients",
    "loads.punch.w": "angles of quotients",
    "plane.rounded_punch.P": "angles of quotients, beyond 2 b",
    "plane.rounded_punch.slope": "angles of quotients",
    "plane.rounded_wedge.P": "angles of quotients",
    "plane.rounded_wedge.slope": "angles of quotients",
    "plane.truncated_wedge.d": "angles of quotients, beyond 128 b",
    "rounded_cone.d": "angles of quotients",
    "rounded_cone.F": "angles of quotients",
    "rounded_cone.pm": "angles of quotients",
    "rounded_cone.slope": "angles of quotients",
    "rounded_curved_punch.slope": "without gaps",
    "rounded_punch.slope": "without gaps",
    "truncated_cone.d": "angles of quotients",
    "truncated_cone.F": "angles of quotients",
    "truncated_cone.pm": "angles of quotients",
    "truncated_cone.slope": "angles of quotients",
    "truncated_paraboloid.pm": "expanded sums",
}
"""Names of variants by key of the entry, of the rate of growth by `slope`; all others are written by all rules."""
_BY_NAME = {variant.name: variant for variant in (*VARIANTS, *SPLITS)}


def chosen(key: str) -> Variant:
    """The variant of an entry."""
    return _BY_NAME[CHOSEN[key]] if key in CHOSEN else FULL
