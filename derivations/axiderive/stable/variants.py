"""The ways in which a formula may be rewritten: the rules of `forms` all together, or without some of them."""

from __future__ import annotations

from dataclasses import dataclass

RULES = frozenset(("angles", "conjugates", "gaps", "lengths", "log1p"))
"""Angles by atan2 and asinh of roots, sums over their conjugates, x - atan(x) and atanh(x) - x as functions, those
and cubes of a root from its lengths, and logarithms as log1p; a root of an exact difference stands in every form."""


@dataclass(frozen=True)
class Variant:
    """One way: its rules, and how it writes what they leave."""

    name: str
    rules: frozenset[str] = RULES
    quotients: bool = False
    """Angles as atan of a quotient instead of atan2, acosh as asinh of one instead of log1p."""
    expanded: bool = False
    """Products of sums multiplied out."""
    closed: bool = True
    """Whether it is taken for free of cancellation; else that must be proved, or a rule stands in for the form."""


FULL = Variant("all rules", closed=False)
VARIANTS = (
    FULL,
    Variant("all rules, closed"),
    Variant("angles of quotients", quotients=True),
    *(Variant(f"without {rule}", RULES - {rule}) for rule in sorted(RULES)),
    Variant("roots alone", frozenset()),
    Variant("expanded sums", expanded=True),
    Variant("expanded sums without lengths", RULES - {"lengths"}, expanded=True),
)
