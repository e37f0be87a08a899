"""Front and back of the book: from the summaries of its profiles to the model of the main file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

from .. import __version__
from . import front, front_rules, laws, notation_table, references, study
from .evidence import power_of_ten
from .prose import escaped
from .symbol_index import symbol_index
from .transcribed import typeset

CHAPTERS = ("Compact contact", "Complete contact", "Plane contact", "Prescribed pressure", "Elastic constants")
PLACES = {"plane": 2, "loads": 3, "materials": 4}
"""Chapters of the profiles whose id begins so, counted from zero; the others are compact or complete."""


QUESTIONS = (
    ("Is the pressure given, and not the shape?", ("loads.uniform", "loads.hertzian", "loads.punch", "loads.power")),
    ("Is the body long, and the same in every section: a roller, a wedge, a rail?", (
        "plane.parabola", "plane.wedge", "plane.power_law", "plane.truncated_wedge", "plane.rounded_wedge",
        "plane.rounded_punch", "plane.flat_punch", "plane.eccentric_punch", "plane.quartic", "plane.sextic",
        "plane.concave_parabola", "plane.concave_quartic", "plane.concave_power",
    )),
    ("Does a sharp edge bound the contact whatever the load?", (
        "flat_punch", "capped_cylinder", "concave_paraboloid", "concave_quartic", "concave_power",
    )),
    ("Is the edge of a flat or slightly curved face rounded?", ("rounded_punch", "rounded_curved_punch")),
    ("Is a tip worn or ground flat?", ("truncated_cone", "truncated_paraboloid")),
    ("Is a pointed tip blunt?", ("sphere_tipped_cone", "rounded_cone", "hyperboloid")),
    ("Does the radius of curvature change at a known distance from the axis?", ("capped_paraboloid",)),
    ("Is the surface wavy, or a single smooth bump?", ("wavy_paraboloid", "gaussian")),
    ("Is the shape a ball or an ellipsoid, and the contact not small against it?", ("sphere", "ellipsoid")),
    ("Is the tip pointed, with straight flanks?", ("cone",)),
    ("Is it round, with one radius of curvature?", ("paraboloid",)),
    ("Is it flatter than that at the tip, or a power of $r$ that was measured?", (
        "quartic", "sextic", "power_law", "polynomial",
    )),
)  # fmt: skip
"""What to ask about a body, and the profiles that answer it."""


def _chart(summaries: Sequence[Mapping[str, Any]]) -> list[tuple[str, list[tuple[str, str, str]]]]:
    known = {m["name"]: (m["name"], m["number"], m["title"]) for m in summaries}
    return [(words, [known[name] for name in names if name in known]) for words, names in QUESTIONS]


FRONT = (
    ("How to read an entry", "howto"), ("Notation", "notation"), ("Definitions", "definitions"),
    ("Rules for every profile", "rules"), ("Viscoelastic laws", "laws"), ("All profiles", "master"),
    ("Which profile?", "chart"),
)  # fmt: skip
BACK = (
    ("Profile and physics", "matrix"), ("Error against run time", "study"), ("What a call costs", "speed"),
    ("Stability maps", "maps"), ("Stiff and extreme cases", "extremes"),
    ("Chapter 11, equation by equation", "chapter"), ("Errata of chapter 11", "errata"),
    ("References", "references"), ("Index", "symbols"),
)  # fmt: skip
"""Titles and labels of the parts before and behind the entries."""
NEEDED = {
    "study": "error", "speed": "speed", "maps": "maps", "extremes": "extremes",
    "chapter": "chapter11", "errata": "chapter11",
}  # fmt: skip
"""What a part prints, by its label, where it is not always there."""


Chapters = Sequence[tuple[str, Sequence[Mapping[str, Any]]]]
"""Title and summaries of each chapter."""


def _contents(chapters: Chapters, left_out: AbstractSet[str]) -> dict[str, Any]:
    """Number, title and label of every part and entry; the chapters with their own numbers and titles."""
    front, back = ([("", t, f"part:{name}") for t, name in part if name not in left_out] for part in (FRONT, BACK))
    return {
        "front": front,
        "back": back,
        "chapters": [
            (
                members[0]["chapter"],
                title,
                [(m["number"], m["title"], f"sec:{m['name']}") for m in members if not m["host"]],
            )
            for title, members in chapters
        ],
    }


def _held(chapters: Chapters) -> str:
    """36 profiles, 4 prescribed pressures and the elastic constants: neither of the last two is a profile."""
    kinds = dict(zip(CHAPTERS, ("profile",) * 3 + ("prescribed pressure", ""), strict=True))
    counts: Counter[str] = Counter()
    for title, members in chapters:
        counts[kinds[title]] += len(members)
    words = [
        f"{count} {kind}{'s' * (count > 1)}" if kind else "the elastic constants" for kind, count in counts.items()
    ]
    *most, last = words or ["no formula"]
    return f"{', '.join(most)} and {last}" if most else last


def model(
    summaries: Sequence[Mapping[str, Any]],
    chapter11: Mapping[str, Any] | None,
    studies: Mapping[str, Mapping[str, Any]] | None = None,
) -> dict[str, Any]:
    """What the template of the main file prints."""
    chapters = [(title, [m for m in summaries if m["chapter"] == i + 1]) for i, title in enumerate(CHAPTERS)]
    chapters = [(title, members) for title, members in chapters if members]
    keys = [key for m in summaries for key in m["keys"]]
    drawn = study.figures(studies or {}, frozenset(keys))
    shown = {**drawn, "chapter11": chapter11}
    left_out = {label for label, needed in NEEDED.items() if not shown[needed]}
    return {
        "chapters": chapters,
        "summaries": summaries,
        "contents": _contents(chapters, left_out),
        "suffixes": front.suffixes(),
        "notation": notation_table.by_subject({s for m in summaries for s in m["symbols"]}),
        "definitions": front.definition_rows(),
        "masters": front.master_rows(),
        "laws": laws.laws(),
        "rules": front_rules.rule_rows(),
        "chart": _chart(summaries),
        "matrix": front.matrix_rows(summaries),
        "signs": front.matrix_legend(),
        "full": front.FULL,
        "chapter11": chapter11 and _chapter(chapter11),
        "studies": drawn,
        "works": [
            (references.label(short), escaped(" ".join(work))) for short, work in sorted(references.WORKS.items())
        ],
        "symbol_index": symbol_index(summaries),
        "key_groups": front.by_problem(keys),
        "held": _held(chapters),
        "formulas": len(keys),
        "version": __version__,
    }


def _chapter(record: Mapping[str, Any]) -> dict[str, Any]:
    """The record of the chapter with its words and their formulas as LaTeX."""
    rows = [row | {"title": typeset(row["title"]), "residual": power_of_ten(row["residual"])} for row in record["rows"]]
    errata = [{name: typeset(text) for name, text in erratum.items()} for erratum in record["errata"]]
    steps = [step | {"claim": typeset(step["claim"])} for step in record.get("steps", [])]
    return {"rows": rows, "errata": errata, "steps": steps}
