"""What the page of one profile shows: the rows of all its problems, each with its evidence and its call in Python."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ...contact.systems import Problem
from ...entry import Entry
from ..blocks import TITLES, ending, ending_of, rows_of
from ..calls import called, imported
from ..rows import Row
from ..spread import problems_of
from .figures import figures
from .sketch import sketch
from .words import formula

Derived = Mapping[str, Mapping[str, Entry]]
Evidence = Mapping[str, Any]


@dataclass(frozen=True)
class Formula:
    """One entry: the end of its key, what is known about it in short and in full, the lines of Python that call it."""

    suffix: str
    certified: bool
    short: str
    evidence: list[str]
    python: str


@dataclass(frozen=True)
class WebRow:
    """A row of the book with everything the page knows about the entries it prints."""

    label: str
    small: str
    regions: list[tuple[Any, Any]]
    """Formula and condition, ready for KaTeX."""
    remark: str
    uses: str
    note: str
    entries: list[Formula]


@dataclass(frozen=True)
class Section:
    """The rows of one problem, or the words in place of them."""

    anchor: str
    title: str
    note: str
    rows: list[WebRow]
    words: str = ""


def page(model: Mapping[str, Any], derived: Derived, evidence: Evidence) -> dict[str, Any]:
    """The model of the printed spread, with the rows the web page shows in place of its blocks."""
    profile_id = model["name"]
    agreed = {line["suffix"]: line for part in ("table", "grid") for line in model["evidence"][part]}
    problems = {problem.system.name: problem for problem in problems_of(profile_id)}
    sections = []
    for name, block in model["blocks"].items():
        if block["words"]:
            sections.append(Section(f"about.{name}", block["title"], "", [], block["words"]))
        else:
            sections.append(_section(problems[name], derived, evidence, agreed))
    picture = model["picture"]
    return {
        **model,
        "sections": sections,
        "sketch": sketch(picture, model) if picture else None,
        "figures": figures(model),
        "worked": model.get("worked"),
    }


def _section(problem: Problem, derived: Derived, evidence: Evidence, agreed: Mapping[str, Any]) -> Section:
    title, note = TITLES[problem.system.name]
    records = evidence.get(problem.key, {}).get("entries", {})
    rows = rows_of(problem.system, derived[problem.key], derived, problem.name)
    anchor = f"about.{problem.system.name}"
    return Section(anchor, title, note, [_row(one, problem, records, agreed) for one in rows])


def _row(one: Row, problem: Problem, records: Evidence, agreed: Mapping[str, Any]) -> WebRow:
    label, small = one.label
    profile_id = problem.profile_id
    return WebRow(
        label,
        small,
        [(formula(r.tex, display=True), formula(r.condition) if r.condition else "") for r in one.regions],
        one.remark,
        one.uses and ending_of(one.uses, one.entry, profile_id),
        one.entry.note,
        [
            _formula(entry, problem, records.get(entry.suffix, {}), agreed.get(ending(entry, profile_id)))
            for entry in (one.entry, *one.also)
        ],
    )


def _formula(entry: Entry, problem: Problem, record: Evidence, agreed: Mapping[str, Any] | None) -> Formula:
    python = f"{imported(problem)}\n\n{called(problem, entry)}"
    suffix, certified = ending(entry, problem.profile_id), bool(record.get("certified"))
    if agreed is None:
        return Formula(suffix, certified, "not verified in this edition", [], python)
    short = "certified" if certified else "no exact certificate"
    if agreed["digits"] != "--":
        short += f"; {agreed['digits']} digits at {agreed['count']} points"
    return Formula(suffix, certified, short, record.get("summary", "").split("; "), python)
