"""The blocks of a spread: the rows of one system each, or the reason why there are none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from ..entry import Entry
from ..physics.systems import SYSTEMS, Problem, System, pool_of
from ..print.words import prose
from ..profiles.pools import BODIES, ROUND
from . import laws
from .approaches import Further, approach_rows
from .in_print import printed as in_print
from .laws import universal_rows
from .limits import limit_rows, reduction_rows
from .row import Row, lines, ordered
from .special import HOSTS, ON_TIP, TIPS, sum_rows, tip_rows

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
    own = [Problem(system, name) for system in SYSTEMS if system.pool is pool]
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
    for system in SYSTEMS:
        if system.pool is not pool:
            continue
        if system.name in refusals:
            found[system.name] = _silent(system, prose(_reason(refusals[system.name])))
            continue
        problem = Problem(system, name)
        if problem.key in derived:
            shown = in_print(system, rows[system.name])
            further = _further(problem, derived, (evidence or {}).get(problem.key, {}))
            found[system.name] = _block(system, shown, further, _heading(system, derived[problem.key]))
        else:
            found[system.name] = _silent(system, "left out of this edition because one of its checks did not pass")
    return found


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
