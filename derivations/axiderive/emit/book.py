"""Front and back of the book: from the summaries of its profiles to the model of the main file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from .. import __version__
from . import front, laws, page, references
from .prose import escaped, prose

CHAPTERS = ("Compact contact", "Complete contact", "Plane contact", "Prescribed pressure", "Elastic constants")
PLACES = {"plane": 2, "loads": 3, "materials": 4}
"""Chapters of the profiles whose id begins so, counted from zero; the others are compact or complete."""


def model(summaries: Sequence[Mapping[str, Any]], chapter11: Mapping[str, Any] | None) -> dict[str, Any]:
    """What the template of the main file prints."""
    chapters = [(title, [m for m in summaries if m["chapter"] == i + 1]) for i, title in enumerate(CHAPTERS)]
    keys = sorted(key for m in summaries for key in m["keys"])
    return {
        "chapters": [(title, members) for title, members in chapters if members],
        "suffixes": front.suffixes(),
        "notation": front.notation_rows({s for m in summaries for s in m["symbols"]}),
        "definitions": front.definition_rows(),
        "masters": front.master_rows(),
        "laws": laws.laws(),
        "rules": front.rule_rows(),
        "matrix": front.matrix(summaries),
        "chapter11": chapter11 and _chapter(chapter11),
        "works": [
            (references.label(short), escaped(" ".join(work))) for short, work in sorted(references.WORKS.items())
        ],
        "key_rows": front.columns(keys, 4),
        "keys_count": {"profiles": len(summaries), "entries": len(keys)},
        "version": __version__,
    }


def _chapter(record: Mapping[str, Any]) -> dict[str, Any]:
    """The record of the chapter with its words as LaTeX; formulas of the errata stay as they are written."""
    rows = [
        row | {"title": prose(row["title"]), "residual": page.power_of_ten(row["residual"])} for row in record["rows"]
    ]
    errata = [
        erratum
        | {
            "place": escaped(erratum["place"]),
            "reason": prose(erratum["reason"]),
            "evidence": prose(erratum["evidence"]),
        }
        for erratum in record["errata"]
    ]
    return {"rows": rows, "errata": errata}
