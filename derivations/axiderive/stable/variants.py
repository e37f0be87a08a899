"""The ways in which a formula may be rewritten, and the choices among them that were measured and are frozen.

No difference between two machines changes a module, and an engine that writes modules for scenes measures nothing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace


@dataclass(frozen=True)
class Variant:
    """One way to write a formula; a root of an exact difference stands in every one.

    By all rules angles are atan2 and asinh of roots, sums stand over their conjugates, and logarithms are log1p.
    """

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
        return replace(self, beyond=0.0)


FULL = Variant(closed=False)
QUOTIENTS = Variant(quotients=True)
CHOSEN = {
    **dict.fromkeys(("flat_punch.w", "loads.punch.w", "hyperboloid.d", "hyperboloid.slope"), QUOTIENTS),
    **{f"{name}.{own}": QUOTIENTS for name in ("rounded_cone", "truncated_cone") for own in ("d", "F", "pm", "slope")},
    **dict.fromkeys(("plane.rounded_punch.slope", "plane.rounded_wedge.P", "plane.rounded_wedge.slope"), QUOTIENTS),
    # a rule next to the break, where a closed form cancels, and that form where its strips become too long
    "plane.rounded_punch.P": replace(QUOTIENTS, beyond=2.0),
    "plane.truncated_wedge.d": replace(QUOTIENTS, beyond=128.0),
    **dict.fromkeys(("rounded_curved_punch.slope", "rounded_punch.slope"), Variant(gaps=False)),
    "truncated_paraboloid.pm": Variant(expanded=True),
}
"""By key of the entry, of the rate of growth by `slope`: the cheapest that kept its digits; all others are FULL."""


def chosen(key: str) -> Variant:
    """The variant of an entry."""
    return CHOSEN.get(key, FULL)
