"""The blocks of a spread: the rows of one system each, or the reason why there are none.

In print stands what is more closed than the rule in front of the book; the web edition shows every row.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

from ..entry import Entry
from ..notation import a, b
from ..physics.adhesive import CONTROLS
from ..physics.systems import PRINTED, Problem, System, pool_of
from ..print.words import prose
from ..profiles.pools import BODIES, ROUND
from . import laws
from .approaches import Further, approach_rows, limit_rows, reduction_rows
from .laws import universal_rows
from .ranges import regions
from .row import LETTER, WIDEST, Region, Row, fits_half, lines, ordered
from .special import HOSTS, ON_TIP, SUMS, TIPS, sum_rows, tip_rows

PULL_OFF = r"pull-off under force control, $a_{\mathrm c}$, and under depth control, $a_{\mathrm m}$"


@dataclass(frozen=True)
class Block:
    """What a spread says about one system."""

    title: str
    note: str
    lines: list[tuple[Row, ...]]
    listed: list[str]
    """Ends of the keys whose rule stands in front of the book."""
    further: list[list[Further]] = field(default_factory=list)
    """Lines of rows without a key: approaches, limits, the universal curve."""
    approached: list[Further] = field(default_factory=list)
    """All of them, with those that a rule in front of the book says for every profile."""
    words: str = ""
    """In place of rows: why there are none."""


def _heading(system: System, entries: Mapping[str, Entry]) -> tuple[str, str]:
    """Title and note of a block; a note speaks of what the block has rows for only."""
    title, note = system.heading, system.said.note
    if "am" in entries and not system.medium.graded:
        return title, f"{note}; {PULL_OFF}"
    if "phi" in entries:
        return title, "load $P$ per length at $x=e$"
    return title, note


def every(profile_id: str, derived: Mapping[str, Mapping[str, Entry]]) -> dict[str, list[Row]]:
    """All rows of the problems of a profile, by name of the system."""
    pool, name = pool_of(profile_id), profile_id.rpartition(".")[2]
    own = [Problem(system, name) for system in PRINTED if system.pool is pool]
    return {p.system.name: rows_of(p.system, derived[p.key], derived, name) for p in own if p.key in derived}


def blocks(
    profile_id: str,
    derived: Mapping[str, Mapping[str, Entry]],
    rows: Mapping[str, list[Row]],
    refusals: Mapping[str, str],
    evidence: Mapping[str, Any] | None = None,
) -> dict[str, Block]:
    """Blocks by name of the system, in the order of the systems, of `every` row; `refusals` says why one has none."""
    found, pool, name = {}, pool_of(profile_id), profile_id.rpartition(".")[2]
    for system in PRINTED:
        if system.pool is not pool:
            continue
        if system.name in refusals:
            if _rare(system):
                continue
            found[system.name] = _silent(system, prose(_reason(refusals[system.name])))
            continue
        problem = Problem(system, name)
        if problem.key in derived:
            shown = printed(system, rows[system.name])
            further = _further(problem, derived, (evidence or {}).get(problem.key, {}))
            found[system.name] = _block(system, shown, further, _heading(system, derived[problem.key]))
        else:
            found[system.name] = _silent(system, "left out of this edition because one of its checks did not pass")
    return found


@cache
def _rare(system: System) -> bool:
    """Whether it is known of less than a tenth of the profiles: the pages of the others need not say why."""
    names = system.pool.names
    return 10 * sum(not system.refusal(system.pool.load(name)) for name in names) < len(names)


def _further(
    problem: Problem, derived: Mapping[str, Mapping[str, Entry]], evidence: Mapping[str, Any]
) -> list[Further]:
    """Rows that follow from those of the problem: approaches, limits as checked, adhesive power-law curves."""
    system, entries, base = problem.system, derived[problem.key], problem.base
    if base:
        plain = derived.get(base.key, {})
        return universal_rows(problem.key, plain["d"], system.medium) if "Fc" in entries and "d" in plain else []
    if system.medium.graded or system.pool is BODIES:
        return []
    limits = reduction_rows(problem.profile, entries)
    if system.pool is ROUND:
        limits = [*limit_rows(problem.profile, entries, evidence), *limits]
    approached = approach_rows(problem.profile, entries)
    if problem.profile_id in TIPS:
        approached = [replace(one, ruled=one.ruled or ON_TIP in one.small) for one in approached]
    own = [*sum_rows(problem.profile_id), *tip_rows(problem.profile_id)]
    return [*own, *approached, *_limits(problem, limits)]


def _limits(problem: Problem, rows: list[Further]) -> list[Further]:
    """The limits; a profile of the plane names them in its panel, and special cases stand in the entry."""
    named = problem.system.pool.strip or problem.profile_id in HOSTS.values()
    return [replace(one, ruled=True) for one in rows] if named else rows


def halved(rows: list[Further]) -> list[list[Further]]:
    """Lines of one row, or of two limits or two others that take half a line each."""
    lines: list[list[Further]] = []
    for one in rows:
        last = lines[-1] if lines else []
        if len(last) == 1 and one.half and last[0].half and (one.kind == "limit") == (last[0].kind == "limit"):
            last.append(one)
        else:
            lines.append([one])
    return lines


def _reason(message: str) -> str:
    """The message of the refusal without the name of the profile and without the call to use instead."""
    text = message.partition(" is ")[2].partition(": use ")[0] or message
    return text.replace("complete contact and knows", "complete contact knows")


def _silent(system: System, words: str) -> Block:
    return Block(system.heading, "", [], [], words=words)


def rows_of(
    system: System, entries: Mapping[str, Entry], derived: Mapping[str, Mapping[str, Entry]], name: str
) -> list[Row]:
    """The rows of a problem; those of the viscoelastic one are printed from the normal contact."""
    base = Problem(system, name).base
    return laws.rows(entries, derived[base.key]) if base and system.physics.laws else ordered(entries)


def _block(system: System, rows: list[Row], further: list[Further], head: tuple[str, str]) -> Block:
    shown = [one for one in rows if not one.listed]
    return Block(
        *head,
        [(one,) for one in shown] if system.physics.laws else lines(shown),
        [anchor for one in rows if one.listed for anchor in one.anchors],
        halved([one for one in further if not one.ruled]),
        further,
    )


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
