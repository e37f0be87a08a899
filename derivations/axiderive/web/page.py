"""What the page of one profile shows: the rows of all its problems, each with its evidence and its call in Python."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..book.page import Calls, Signatures, assigned, called, examples, imported, signatures
from ..book.spread import problems_of
from ..entry import Entry
from ..figures.axes import SCREEN, drawn
from ..figures.svg import Picture, svg
from ..physics.systems import Problem
from ..print.words import prose
from ..rows.approaches import Further as Printed
from ..rows.blocks import ending, heading
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
    measured: str = ""
    """How the function evaluates the formula, and the errors that were measured."""


@dataclass(frozen=True)
class Further:
    """A row without a key of its own: a limit, a universal curve."""

    anchor: str
    label: str
    small: str
    tex: Any
    remark: str


@dataclass(frozen=True)
class Section:
    """The rows of one problem, or the words in place of them."""

    anchor: str
    title: str
    note: str
    rows: list[dict[str, Any]]
    """The rows of the book with everything the page knows about the entries they print."""
    words: str = ""
    further: Sequence[Further] = ()
    figures: Sequence[Picture] = ()


@dataclass(frozen=True)
class Known:
    """What the rows of one problem are completed with."""

    problem: Problem
    records: Evidence
    agreed: Mapping[str, Any]
    """Digits and points by the end of the key."""
    functions: Signatures
    values: Calls

    def formula(self, entry: Entry) -> Formula:
        """One formula with its evidence in words and its call in Python."""
        suffix, record = ending(entry, self.problem.profile_id), self.records.get(entry.suffix, {})
        lines = imported(self.problem), assigned(entry, self.values), called(self.problem, entry, self.functions)
        python = "\n\n".join(lines)
        certified = bool(record.get("certified"))
        if suffix not in self.agreed:
            return Formula(suffix, certified, "not verified in this edition", [], python)
        short, agreed = "certified" if certified else "no exact certificate", self.agreed[suffix]
        if agreed["digits"] != "--":
            short += f"; {agreed['digits']} digits at {agreed['count']} points"
        measured = _measured(agreed["evaluation"])
        return Formula(suffix, certified, short, record.get("summary", "").split("; "), python, measured)

    def row(self, one: Mapping[str, Any], entries: Mapping[str, Entry]) -> dict[str, Any]:
        """A row as the page shows it, its formulas ready for KaTeX, from what `rows.blocks.told` says of it."""
        own = [entries[key] for key in one["comment"].split()]
        regions = [
            (formula(r["tex"], display=True), r["condition"] and formula(r["condition"])) for r in one["regions"]
        ]
        return {**one, "regions": regions, "note": prose(own[0].note), "entries": list(map(self.formula, own))}


def _measured(evaluation: Sequence[str]) -> str:
    """The cells of the evidence table of the book as words; none where nothing was measured."""
    if not evaluation:
        return ""
    form, *errors = evaluation
    places = ("error ", "at extreme lengths ", "of the formula as printed ")
    shown = [where + _in_ulp(error) for where, error in zip(places, errors, strict=True) if error != "--"]
    return ("" if form == "--" else f"evaluation by {form}; ") + (", ".join(shown) or "error not measured")


def _in_ulp(cell: str) -> str:
    """1.4 / 30 (2 lost) with the words the head of the table has."""
    worst, of, points = cell.partition(r"\,/\,")
    if not of:
        return cell
    count, _, lost = points.partition(" ")
    return f"{worst} ulp at {count} points {lost}".rstrip()


TARGET = re.compile(r"\\hyperref\[sec:([\w.]+)\]")


def _further(one: Printed, profile_id: str) -> Further:
    """Its address is limit.cone of what it tends to, or universal.adh.F of the first formula it gives."""
    target = TARGET.search(one.label + one.remark)
    anchor = f"{one.kind}.{target[1] if target else one.keys[0].removeprefix(profile_id + '.')}"
    tex = "" if one.words else formula(one.tex, display=True)
    return Further(anchor, one.label, one.small, tex, one.words or one.remark)


def _apart(rows: list[Further]) -> list[Further]:
    """Rows of one kind and key, for several ranges, with a number behind the address of all but the first."""
    seen: Counter[str] = Counter()
    found = []
    for one in rows:
        seen[one.anchor] += 1
        found.append(replace(one, anchor=f"{one.anchor}.{seen[one.anchor]}") if seen[one.anchor] > 1 else one)
    return found


def page(model: Mapping[str, Any], derived: Derived, evidence: Evidence, modules: Mapping[str, str]) -> dict[str, Any]:
    """The model of the printed spread, with the rows the web page shows in place of its blocks."""
    agreed = {line["suffix"]: line for part in ("table", "grid") for line in model["evidence"][part]}
    problems = {problem.system.name: problem for problem in problems_of(model["name"])}
    sections, pictures = [], figures(model)
    for name, block in model["blocks"].items():
        anchor = f"about.{name}"
        if block.words:
            sections.append(Section(anchor, block.title, "", [], block.words))
            continue
        problem = problems[name]
        title, note = heading(problem.system, derived[problem.key])
        records = evidence.get(problem.key, {}).get("entries", {})
        source = modules[problem.module]
        known = Known(problem, records, agreed, signatures(source), examples(source))
        entries = {entry.key: entry for entry in derived[problem.key].values()}
        further = _apart([_further(one, model["name"]) for one in block.approached])
        shown = [known.row(one, entries) for one in model["rows"][name]]
        sections.append(Section(anchor, title, note, shown, further=further, figures=pictures.get(name, ())))
    return {**model, "sections": sections, "sketch": svg(model["picture"], UNIT) if model["picture"] else None}


UNIT = 84.0
"""SVG units to one unit of a sketch."""


def figures(model: Mapping[str, Any]) -> dict[str, list[Picture]]:
    """The plots of a page by the system they stand with, in the order of the book."""
    found = [svg(drawn(axes, SCREEN)) for part in ("plots", "curves", "axes") for axes in model[part]]
    found += [svg(model["stress"], 130.0)] if model["stress"] else []
    return {model["first"]: found, "graded.normal": [svg(drawn(axes, SCREEN)) for axes in model["graded"]]}
