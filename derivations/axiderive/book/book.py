"""Front and back of the book: from the pages of its profiles to the model of the main file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

from .. import __version__
from ..figures.contours import SHADES
from ..physics.systems import pool_of
from ..print.words import escaped, typeset
from ..rows import laws, layer
from ..store.cache import digest
from . import back, front, guide, notation_table, studies
from .evidence import NONE, power_of_ten

ENTRIES = {
    "Compact contact": (
        *("cone", "plane.wedge", "rounded_cone", "sphere_tipped_cone", "plane.rounded_wedge"),
        *("paraboloid", "plane.parabola", "power_law", "plane.power_law", "polynomial", "sphere", "ellipsoid"),
        *("hyperboloid", "wavy_paraboloid", "gaussian", "truncated_cone", "truncated_paraboloid", "capped_paraboloid"),
        *("rounded_curved_punch", "rounded_punch", "plane.truncated_wedge", "plane.rounded_punch"),
    ),
    "Complete contact": (
        *("flat_punch", "plane.flat_punch", "plane.eccentric_punch"),
        *("concave_power", "plane.concave_power", "capped_cylinder"),
    ),
    "Prescribed pressure": ("loads.uniform", "loads.hertzian", "loads.punch", "loads.power"),
    "Elastic constants": ("materials",),
}
"""The entries by chapter, in the order of the book.

An entry of three pages, from a left one, ends on a left one. The page that faces its end has the plane contact of the
same shape, so that the next entry begins on a left page too, and no page is empty.
"""
CHAPTERS = tuple(ENTRIES)
KINDS = {
    "Compact contact": r"depth $g(a)$, force $F_{\mathrm N}$",
    "Complete contact": r"depth $d$, force $F_{\mathrm N}$",
    "Plane contact": r"depth relative to the surface at the distance $L$, line load $P$",
    **dict.fromkeys(("Prescribed pressure", "Elastic constants"), ""),
}
"""The groups of the tables of all profiles, and what the table of their depths and forces has of them."""
FRONT = (
    ("How to read an entry", "howto"), ("Conventions", "conventions"), ("When does it hold?", "validity"),
    ("Which profile?", "chart"), ("All profiles", "master"), ("Notation", "notation"),
    ("Definitions", "definitions"), ("Viscoelastic laws", "laws"), ("Rules for every profile", "rules"),
    ("Layer on a rigid base", "layer"),
)  # fmt: skip
BACK = (
    ("Stress below the contact", "stress"),
    ("Errata of chapter 11", "errata"), ("Error against run time", "study"), ("References", "references"),
    ("Index", "words"), ("Index of symbols", "symbols"), ("This edition", "imprint"),
)  # fmt: skip
"""Titles and labels of the parts before and behind the entries."""
WITHIN = {"part:matrix": "part:howto", "part:functions": "part:definitions", "part:gradedrules": "part:rules"}
"""Labels of sections of the parts, and the part they stand in."""
NEEDED = {"study": "error", "errata": "chapter11"}
"""What a part prints, by its label, where it is not always there."""

Chapters = Sequence[tuple[str, Sequence[Mapping[str, Any]]]]
"""Title and pages of each chapter."""


def _grouped(titles: Iterable[str], own: Sequence[tuple[str, Mapping[str, Any]]]) -> Chapters:
    """The pages by title, in the order of the titles; without those that have none."""
    return [(t, members) for t in titles if (members := [m for title, m in own if title == t])]


def _contents(chapters: Chapters, left_out: AbstractSet[str]) -> dict[str, Any]:
    """Number, title and label of every part and entry; the chapters with their own numbers and titles."""
    front, back = ([("", t, f"part:{name}") for t, name in part if name not in left_out] for part in (FRONT, BACK))
    return {
        "front": front,
        "back": back,
        "chapters": [
            (own[0]["chapter"], title, [(m["number"], m["title"], f"sec:{m['name']}") for m in own if not m["host"]])
            for title, own in chapters
        ],
    }


def _held(pages: Sequence[Mapping[str, Any]]) -> str:
    """36 profiles, 4 prescribed pressures and the elastic constants: neither of the last two is a profile."""
    kinds = "profile", "profile", "prescribed pressure", ""
    counts = Counter(kinds[m["chapter"] - 1] for m in pages)
    words = [f"{n} {kind}{'s' * (n > 1)}" if kind else "the elastic constants" for kind, n in counts.items()]
    *most, last = words or ["no formula"]
    return f"{', '.join(most)} and {last}" if most else last


def _coverage(pages: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    """How the formulas of all profiles are known."""
    found = Counter(NONE)
    for m in pages:
        found.update({name: count for name, count in m["coverage"].items() if name not in ("digits", "least")})
    digits = min((m["coverage"]["digits"] for m in pages if m["coverage"]["digits"]), default=0)
    return {**found, "digits": digits}


def model(
    pages: Sequence[Mapping[str, Any]],
    chapter11: Mapping[str, Any] | None,
    records: Mapping[str, Mapping[str, Any]] | None = None,
) -> dict[str, Any]:
    """What the template of the main file prints."""
    pages = sorted(pages, key=lambda m: tuple(map(int, m["number"].split("."))))
    parts = [(CHAPTERS[m["chapter"] - 1], m) for m in pages]
    chapters = _grouped(CHAPTERS, parts)
    kinds = _grouped(KINDS, [("Plane contact" if pool_of(m["name"]).strip else title, m) for title, m in parts])
    keys = [key for m in pages for key in m["keys"]]
    drawn = studies.figures(records or {}, frozenset(keys))
    shown = {**drawn, "chapter11": chapter11}
    left_out = {label for label, needed in NEEDED.items() if not shown[needed]}
    contents = _contents(chapters, left_out)
    letters, numbers = front.number_rows()
    return {
        "chapters": chapters,
        "kinds": [(title, KINDS[title], members) for title, members in kinds],
        "pages": pages,
        "contents": contents,
        "suffixes": front.suffixes(),
        "reading": guide.reading(),
        "conventions": guide.conventions(),
        "tips": guide.tips(),
        "moduli": guide.MODULI,
        "validity": guide.validity(),
        "errors": guide.errors(),
        "coverage": _coverage(pages),
        "notation": notation_table.by_subject({*layer.LETTERS, *(s for m in pages for s in m["symbols"])}, pages),
        "definitions": front.definition_rows(),
        "masters": front.master_rows(),
        "laws": laws.laws(),
        "layer": layer.sections(),
        "sums": layer.sums(),
        "compared": (list(map(guide.linked, layer.PUBLISHED)), layer.compared()),
        "rules": (front.homogeneous(), front.graded()),
        "chart": front.chart(pages),
        "chapter11": chapter11 and _chapter(chapter11),
        "studies": drawn,
        "spread": studies.spread(drawn, records or {}),
        "ratios": [ratio for _, ratio in studies.CELLS],
        "works": [
            (back.label(short), escaped(" ".join(work[:2])), work.doi)
            for short, work in sorted(back.WORKS.items(), key=lambda one: back.sorted_as(one[0]))
        ],
        "stresses": [*front.stress_rows(), letters],
        "numbers": numbers,
        "tones": [f"${level:g}$" for level in SHADES],
        "symbol_index": back.symbol_index(pages),
        "word_index": back.word_index(pages, contents, WITHIN),
        "held": _held(pages),
        "formulas": len(keys),
        "version": __version__,
        "edition": digest([(m["name"], m["digest"]) for m in pages])[:8],
    }


def _chapter(record: Mapping[str, Any]) -> dict[str, Any]:
    """The record of the chapter with its words and their formulas as LaTeX."""
    rows = [row | {"title": typeset(row["title"]), "residual": power_of_ten(row["residual"])} for row in record["rows"]]
    errata = [{name: typeset(text) for name, text in erratum.items()} for erratum in record["errata"]]
    steps = [step | {"claim": typeset(step["claim"])} for step in record.get("steps", [])]
    return {"rows": rows, "errata": errata, "steps": steps}
