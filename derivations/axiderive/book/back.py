"""The back of the book: works that profiles, formulas and the guide cite, the index of words and that of symbols."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any, NamedTuple

from .. import notation as nt
from .texts import rows, text


class Work(NamedTuple):
    """Authors and title; where it appeared, with volume and pages; DOI, where that is certain."""

    title: str
    place: str
    doi: str = ""


WORKS = {
    short: Work(*said)
    for short, *said in (map(str.strip, work.splitlines()) for work in text("references").split("\n\n"))
}
"""By the short form used in the profile files."""
WORDS = {word: names for word, names in rows(text("words"))}
"""Words, each with parts, profiles and keys by their names; the search of the web edition shows them in this order."""


def label(work: str) -> str:
    """Name of the LaTeX label of a work."""
    return "ref:" + "".join(c for c in work if c.isalnum() and c.isascii())


def sorted_as(work: str) -> str:
    """Without umlauts and signs, by which the works are put in order."""
    return unicodedata.normalize("NFD", work).encode("ascii", "ignore").decode().replace("&", "").lower()


def word_index(
    summaries: Sequence[Mapping[str, Any]], contents: Mapping[str, Any], within: Mapping[str, str]
) -> list[tuple[str, list[str]]]:
    """Words in alphabetical order with the labels of their places, those that this edition has, by page.

    Parameters
    ----------
    summaries : sequence of mapping
        The profiles in their order.
    contents : mapping
        The parts before and behind them.
    within : mapping
        Labels of sections, and the part they stand in.
    """
    pages = {label: (0, i) for i, (_, _, label) in enumerate(contents["front"])}
    pages |= {label: (2, i) for i, (_, _, label) in enumerate(contents["back"])}
    pages |= {label: pages[part] for label, part in within.items()}
    for i, m in enumerate(summaries):
        pages |= {f"sec:{m['name']}": (1, i)} | {f"eq:{key}": (1, i) for key in m["keys"]}
    keys = {key for m in summaries for key in m["keys"]}
    found = []
    for word, names in WORDS.items():
        labels = [label for label in (_label(name, keys) for name in names.split()) if label in pages]
        if labels:
            found.append((word, sorted(labels, key=pages.__getitem__)))
    return sorted(found, key=lambda one: one[0].replace("ß", "ss").lower())


def _label(name: str, keys: AbstractSet[str]) -> str:
    if name.startswith("part:"):
        return name
    return f"eq:{name}" if name in keys else f"sec:{name}"


NAMES = {"u_0": "u"}
"""Symbols that the rows print under another name than that of their record."""


def symbol_index(summaries: Sequence[Mapping[str, Any]]) -> list[tuple[str, list[tuple[str, str]]]]:
    """The symbols with the runs of sections whose formulas hold them: the name of the first, 1.1--1.5."""
    found = []
    for symbol in nt.all_notation():
        places = [(m["name"], m["number"]) for m in summaries if symbol.name in m["symbols"]]
        if places and symbol.name not in ("j", "N", "stiffness") and 2 * len(places) <= len(summaries):
            found.append((NAMES.get(symbol.name, symbol.latex), _runs(places)))
    return sorted(found, key=lambda one: _alphabetical(one[0]))


GREEK = ("alpha", "beta", "gamma", "Delta", "eta", "theta", "lambda", "mu", "nu", "sigma", "tau", "varphi", "psi")


def _alphabetical(latex: str) -> tuple[int, str, str]:
    """Latin letters before Greek ones, small letters before their capitals, a bar and a type for nothing."""
    first = re.match(r"\\([A-Za-z]+)", latex)
    greek = GREEK.index(first[1]) + 1 if first and first[1] in GREEK else 0
    letters = re.sub(r"\\(?:bar|frac|mathrm)(?![a-z])|[^\w*]|_", "", latex)
    return greek, letters.lower(), letters.swapcase()


def _runs(places: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Sections that follow each other in a chapter as one range, with the name of the first."""
    found: list[tuple[str, str, str]] = []
    for name, number in places:
        chapter, _, section = number.partition(".")
        if found and found[-1][2] == f"{chapter}.{int(section) - 1}":
            found[-1] = (*found[-1][:2], number)
        else:
            found.append((name, number, number))
    return [(name, first if first == last else f"{first}--{last}") for name, first, last in found]
