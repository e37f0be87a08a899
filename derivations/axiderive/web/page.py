"""What the page of one profile shows: the rows of all its problems, each with its evidence and its call in Python."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from ..book.evidence import power_of_ten
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
    evidence: Evidence
    """What was found about them: `entries` and `evaluation`, by suffix."""
    functions: Signatures
    values: Calls

    def formula(self, entry: Entry) -> Formula:
        """One formula with its evidence in words and its call in Python."""
        suffix = ending(entry, self.problem.profile_id)
        lines = imported(self.problem), assigned(entry, self.values), called(self.problem, entry, self.functions)
        python = "\n\n".join(lines)
        record = self.evidence.get("entries", {}).get(entry.suffix)
        if record is None:
            return Formula(suffix, False, "not verified in this edition", [], python)
        short = "certified" if record["certified"] else "no exact certificate"
        if agreed := [check for check in record["checks"] if check["outcome"] == "passed" and check.get("digits")]:
            digits, count = min(check["digits"] for check in agreed), sum(check["count"] for check in agreed)
            short += f"; {digits} digits at {count} points"
        first, *others = record.get("summary", "").split("; ")
        if reason := "" if record["certified"] else record.get("certificate", {}).get("reason", ""):
            first += f": {reason}"
        errors = measured(self.evidence.get("evaluation", {}).get(entry.suffix, {}))
        return Formula(suffix, record["certified"], short, [first, *others], python, errors)

    def row(self, one: Mapping[str, Any], entries: Mapping[str, Entry]) -> dict[str, Any]:
        """A row as the page shows it, its formulas ready for KaTeX, from what `rows.blocks.told` says of it."""
        own = [entries[key] for key in one["comment"].split()]
        regions = [
            (formula(r["tex"], display=True), r["condition"] and formula(r["condition"])) for r in one["regions"]
        ]
        return {**one, "regions": regions, "note": prose(own[0].note), "entries": list(map(self.formula, own))}


FORMS = {"closed": "closed form", "kernel": "special function", "rule": "Gauss rule", "root": "iteration"}
"""How a function of the catalogue evaluates its formula."""


def measured(found: Mapping[str, Any]) -> str:
    """The way of evaluation and the worst errors in ulps: at usual lengths, at extreme ones, of the printed formula."""
    if not found:
        return ""
    # bodies that rest on another module have no form of their own
    nodes = ", ".join(str(count) for count in found.get("nodes", ()))
    form = FORMS.get(found.get("form", ""), "") + (f", {nodes} nodes" if nodes else "")
    usual, extreme = found["bench"], found["extreme"]
    places = {"error": usual, "at extreme lengths": extreme, "of the formula as printed": usual.get("naive", {})}
    shown = ", ".join(f"{where} {_ulps(one)}" for where, one in places.items() if one.get("points"))
    return (f"evaluation by {form}; " if form else "") + (shown or "error not measured")


NO_DIGIT = 2.0**52
"""Units in the last place from which no digit is right."""


def _ulps(found: Mapping[str, Any]) -> str:
    """The worst error and at how many points, those lost as NaN or infinite in brackets."""
    if found.get("worst_ulp", 0.0) >= NO_DIGIT:
        return "no digit"
    if "worst_ulp" not in found:
        return f"all {found['lost']} lost"
    lost = f" ({found['lost']} lost)" if found["lost"] else ""
    worst = power_of_ten(f"{found['worst_ulp']:.2g}")
    return f"${worst}$ ulp at {found['points']} points{lost}"


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
    problems = {problem.system.name: problem for problem in problems_of(model["name"])}
    sections, pictures = [], figures(model)
    for name, block in model["blocks"].items():
        anchor = f"about.{name}"
        if block.words:
            sections.append(Section(anchor, block.title, "", [], block.words))
            continue
        problem = problems[name]
        title, note = heading(problem.system, derived[problem.key])
        source = modules[problem.module]
        known = Known(problem, evidence.get(problem.key, {}), signatures(source), examples(source))
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
