"""The ways in which a formula may be rewritten, and the choices among them that were measured and are frozen.

No difference between two machines changes a module, and an engine that writes modules for scenes measures nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

BEYOND = ", beyond"


@dataclass(frozen=True)
class Variant:
    """One way to write a formula; a root of an exact difference stands in every one.

    By all rules angles are atan2 and asinh of roots, sums stand over their conjugates, and logarithms are log1p.
    """

    name: str
    gaps: bool = True
    """Whether x - atan(x) and atanh(x) - x are functions of their own."""
    quotients: bool = False
    """Angles as atan of a quotient instead of atan2, acosh as asinh of one instead of log1p."""
    expanded: bool = False
    """Products of sums multiplied out."""
    closed: bool = True
    """Whether it is taken for free of cancellation; else that must be proved, or a rule stands in for the form."""
    beyond: float = 0.0
    """From how many times the break of the profile on; the form by all rules below."""

    @property
    def below(self) -> Variant:
        """The way below the split, or everywhere."""
        return FULL if self.beyond else self

    @property
    def above(self) -> Variant:
        """The same way everywhere."""
        return replace(self, name=self.name.partition(BEYOND)[0], beyond=0.0)


FULL = Variant("all rules", closed=False)
QUOTIENTS = Variant("angles of quotients", quotients=True)
VARIANTS = (FULL, QUOTIENTS, Variant("without gaps", gaps=False), Variant("expanded sums", expanded=True))
PLACES = (2.0, 16.0, 128.0)
SPLITS = tuple(replace(QUOTIENTS, name=f"{QUOTIENTS.name}{BEYOND} {at:g} b", beyond=at) for at in PLACES)
"""A rule next to the break, where a closed form cancels, and that form where the strips of the rule become too long."""


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
