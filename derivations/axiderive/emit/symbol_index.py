"""The index of symbols: in which sections of the book a symbol occurs."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from .. import notation as nt

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
