"""What the page of one profile shows: the rows of all its problems, each with its evidence and its call in Python."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from ..book.evidence import power_of_ten
from ..book.page import Calls, Signatures, assigned, called, examples, imported, signatures
from ..book.spread import problems_of
from ..entry import Entry
from ..figures.axes import SCREEN, drawn
from ..figures.svg import Picture, svg
from ..physics import subsurface
from ..physics.systems import SYSTEMS, Problem
from ..rows import fields
from ..rows.approaches import Further
from ..rows.blocks import Block
from ..rows.row import Region, Row

Derived = Mapping[str, Mapping[str, Entry]]
Evidence = Mapping[str, Any]
Module = tuple[Signatures, Calls]
"""The arguments of its functions, and the values of their examples."""


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


def _formula(suffix: str, entry: Entry, problem: Problem, evidence: Evidence, module: Module) -> Formula:
    """One formula with its evidence in words and its call in Python."""
    functions, values = module
    given = [assigned(entry, values)] if entry.quantity.function in values else []
    python = "\n\n".join([imported(problem), *given, called(problem, entry, functions)])
    record = evidence.get("entries", {}).get(entry.suffix)
    if record is None:
        return Formula(suffix, False, "not verified in this edition", [], python)
    short = "certified" if record["certified"] else "no exact certificate"
    if agreed := [check for check in record["checks"] if check["outcome"] == "passed" and check.get("digits")]:
        digits, count = min(check["digits"] for check in agreed), sum(check["count"] for check in agreed)
        short += f"; {digits} digits at {count} points"
    first, *others = record.get("summary", "").split("; ")
    if reason := "" if record["certified"] else record.get("certificate", {}).get("reason", ""):
        first += f": {reason}"
    errors = measured(evidence.get("evaluation", {}).get(entry.suffix, {}))
    return Formula(suffix, record["certified"], short, [first, *others], python, errors)


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


def _of_functions(found: Mapping[str, Evidence]) -> str:
    """The worst errors of functions with several components, which are sums of entries."""
    rows = [f"{name.replace('_', ' ')}: {measured(row)}" for name, row in found.items()]
    return "; ".join([*rows, "all beside the largest component"]) if rows else ""


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


def _addressed(rows: Sequence[Further], profile_id: str) -> list[tuple[str, Further]]:
    """Each with its address: limit.cone of what it tends to, or universal.adh.F of the first formula it gives.

    Of rows of one kind and key, for several ranges, all but the first have a number behind it.
    """
    seen: Counter[str] = Counter()
    found = []
    for one in rows:
        target = TARGET.search(one.label + one.remark)
        anchor = f"{one.kind}.{target[1] if target else one.keys[0].removeprefix(profile_id + '.')}"
        seen[anchor] += 1
        found.append((f"{anchor}.{seen[anchor]}" if seen[anchor] > 1 else anchor, one))
    return found


def page(model: Mapping[str, Any], derived: Derived, evidence: Evidence, modules: Mapping[str, str]) -> dict[str, Any]:
    """The model of the printed spread, with all rows of every block, what is known of their formulas, and figures."""
    problems = {problem.system.name: problem for problem in problems_of(model["name"])}
    sections: list[Section] = []
    pictures = figures(model)
    for name, block in model["blocks"].items():
        shown: list[tuple[Row, list[Formula]]] = []
        if not block.words:
            problem = problems[name]
            module = signatures(modules[problem.module]), examples(modules[problem.module])
            known = partial(_formula, problem=problem, evidence=evidence.get(problem.key, {}), module=module)
            shown = [(one, list(map(known, one.anchors, one.entries))) for one in model["rows"][name]]
        further = _addressed(block.approached, model["name"])
        sections.append((f"about.{name}", block, shown, further, pictures.get(name, ())))
    sections += _below(model, derived, evidence, modules, pictures.get(BELOW.name, ()))
    return {**model, "sections": sections, "sketch": svg(model["picture"], UNIT) if model["picture"] else None}


Section = tuple[str, Block, list[tuple[Row, list[Formula]]], list[tuple[str, Further]], Sequence[Picture]]
"""Anchor, heading, rows with their formulas, rows without a key, pictures."""
(BELOW,) = (system for system in SYSTEMS if system.physics is subsurface.PHYSICS)


def _below(
    model: Mapping[str, Any],
    derived: Derived,
    evidence: Evidence,
    modules: Mapping[str, str],
    pictures: Sequence[Picture],
) -> list[Section]:
    """The numbers below the surface: what those of a round profile are made of, with letters and formulas."""
    problem = Problem(BELOW, model["name"])
    if problem.key not in derived:
        return []
    first, *others = derived[problem.key].values()
    own = fields.parts(problem.profile)
    words = "edge in contact" if fields.touches_later(problem.profile) else ""
    region = Region("", (fields.total(own) if own else fields.EVERY,))
    row = Row(first, "formula", (region,), also=tuple(others), title=("Numbers of the profile", words))
    # its functions give stresses, of which no number is one of the nine
    module = signatures(modules[problem.module]), Calls()
    known = partial(_formula, problem=problem, evidence=evidence.get(problem.key, {}), module=module)
    further = [Further("letters", (first.key,), title, "", tex) for title, tex in fields.shorthands()]
    further += [
        Further("slope", (first.key,), f"$n={n}$", fields.SLOPES[n], fields.beside(line))
        for n in own or (0,)
        for line in fields.lines(n)
    ]
    block = Block(BELOW.heading, fields.MADE_OF, [], [])
    head, *rest = map(known, row.anchors, row.entries)
    errors = _of_functions(evidence.get(problem.key, {}).get("evaluation", {}))
    shown = [(row, [replace(head, measured=errors), *rest])]
    return [(f"about.{BELOW.name}", block, shown, _addressed(further, model["name"]), pictures)]


UNIT = 84.0
"""SVG units to one unit of a sketch."""


def figures(model: Mapping[str, Any]) -> dict[str, list[Picture]]:
    """The plots of a page by the system they stand with, in the order of the book."""
    found = [svg(drawn(axes, SCREEN)) for part in ("plots", "curves", "axes") for axes in model[part]]
    return {
        model["first"]: found,
        "graded.normal": [svg(drawn(axes, SCREEN)) for axes in model["graded"]],
        BELOW.name: [svg(model["stress"], 130.0)] if model["stress"] else [],
    }
