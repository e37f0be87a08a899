"""The rows of a problem that stand in the book: what is more closed than the rule in front of it.

The web edition shows every row.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..notation import a, b
from ..physics.adhesive import CONTROLS
from ..physics.systems import System
from .ranges import regions
from .row import LETTER, WIDEST, Region, Row, fits_half
from .special import SUMS, TIPS

JOINT = r",\quad\enspace "
"""Between the formulas that share a row."""
JOINT_WIDTH = 15.0
MOST_LINES = 10
"""Of a row in print; a longer one is left to the web edition and its definition."""


def printed(system: System, rows: Sequence[Row]) -> list[Row]:
    """The rows in print; those the book says by a rule are marked as listed."""
    if not rows or system.pool.strip:
        return [_beyond_tip(one) if system.pool.id(one.entry.profile.name) in TIPS else one for one in rows]
    if not rows[0].entry.profile.compact:
        return [replace(one, listed=one.suffix in system.said.by_rule_complete) for one in rows]
    known = {one.suffix: one for one in rows}
    found: list[Row] = []
    for one in rows:
        if one.suffix in known:
            found += _row(system, one, known)
    return found


def _beyond_tip(one: Row) -> Row:
    """The row without what it says of a contact that ends on the tip, which is another profile to it."""
    if one.kind != "formula":
        return one
    both = zip(one.regions, regions(one.entry), strict=True)
    return replace(one, regions=tuple(region for region, (pairs, _) in both if (a, b) not in pairs))


def _row(system: System, one: Row, known: dict[str, Row]) -> list[Row]:
    if not (system.base or system.medium.graded) and one.kind == "root":
        for through in [row for row in known.values() if row.kind == "composition" and row.uses == one.suffix]:
            del known[through.suffix]
            return [joined((one, through), one.label[1].capitalize(), "solved for $a$")]
    if _is_ruled(system, one):
        return [replace(one, listed=True)]
    for suffixes in CONTROLS.values():
        if one.suffix == suffixes[0] and all(s in known and known[s].kind == "formula" for s in suffixes):
            return _packed([known.pop(suffix) for suffix in suffixes])
    return [one]


def _packed(rows: list[Row]) -> list[Row]:
    """Radius, force and depth at pull-off on one line, on two, or each on its own."""
    title = "Pull-off", f"{rows[0].entry.quantity.control} control"
    for first in (len(rows), 1, 2):
        groups = [tuple(group) for group in (rows[:first], rows[first:]) if group]
        found = [joined(group, *title) for group in groups]
        if all(one.regions[0].width + LETTER * len(one.ends) <= WIDEST for one in found):
            return found
    return rows


def _is_ruled(system: System, one: Row) -> bool:
    if one.entry.profile.name in SUMS and system.base is None:
        return one.suffix not in ("d", "F", "ad") or system.medium.graded
    if one.suffix == "pp":
        return False
    if one.suffix in system.said.by_rule or one.kind in ("rule", "root", "composition"):
        # what a law does to a closed formula is printed with it
        return not system.physics.laws or r"F_{\mathrm N}(" in one.regions[0].tex
    if sum(len(region.lines) for region in one.regions) > MOST_LINES:
        return True
    return one.suffix == "pm" and not (one.narrow and fits_half(one))


def joined(parts: tuple[Row, ...], title: str, small: str) -> Row:
    """Rows of one line each as one row, with the keys of all."""
    text = JOINT.join(part.regions[0].tex for part in parts)
    points = sum(part.regions[0].width for part in parts) + JOINT_WIDTH * (len(parts) - 1)
    also = tuple(part.entry for part in parts[1:])
    region = Region("", (text,), points=points)
    return Row(parts[0].entry, "joined", (region,), also=also, parts=parts, title=(title, small))


def texts_of(tex: str) -> list[str]:
    """The formulas that share a row."""
    return tex.split(JOINT)
