r"""The mathematics in the words of the compiled source: everything between dollars that is no row of its own.

Each formula is found by the line it stands in, without the generator: a range
beside a row, an approach to a limit, a domain of a parameter, a number of a
table, a figure, or a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from .source import arguments, formulas

Where = Literal["range", "approach", "domain", "number", "figure", "sentence"]
Kind = Literal["relation", "value", "symbol"]
_MATHEMATICS = re.compile(r"(?<!\\)\$((?:[^$\\]|\\.)+)\$")
_RELATION = re.compile(r"=|<|>|\\(?:le|ge|to|ll|sim|approx)(?![a-z])")
_VALUE = re.compile(r"\\(?:[dt]?frac|sqrt|int|sum)(?![a-z])|[\w})|]\s*[-+/]\s*[\w({\\|]|\d\\,[A-Za-z\\]|\w\^\{?[\w(]")
_PLAIN = re.compile(
    r"(?:10)?\^\{[^}]*\}|u\^\{\(0\)\}|E\^\{\*\}|G\^\{\*\}|[-\d.]+(?:\\,\d+)*(?:\\times10\^\{-?\d+\})?|1/[\w\\{}]+"
    r"|\\(?:int|surd|circ)_\{\d+\}|\\(?:int|surd|circ)"
)
_LABELS = {"Parameter": "domain", "Parameters": "domain", "Limits": "approach"}


@dataclass(frozen=True)
class Inline:
    """A formula within words: the kind of its place, its LaTeX, and the words it stands in."""

    where: Where
    tex: str
    line: str

    @property
    def kind(self) -> Kind:
        """A relation says something, and so does a value that is more than a name; a symbol or a number does not."""
        if _RELATION.search(self.tex):
            return "relation"
        return "value" if _VALUE.search(self.tex) and not _PLAIN.fullmatch(self.tex) else "symbol"


def inline(text: str) -> list[Inline]:
    """The formulas within the words of one source file, in their order."""
    own = {one.tex for one in formulas(text) if one.kind not in ("row", "further")}
    found = [one for where, line in _places(text) for one in _in_line(where, line)]
    return [one for one in found if one.tex.removeprefix(r"\displaystyle ") not in own]


def _places(text: str) -> Iterator[tuple[Where, str]]:
    """The lines of a source with what they belong to."""
    drawn = counted = tabled = False
    for line in text.splitlines():
        drawn = drawn or r"\begin{tikzpicture}" in line
        tabled = (tabled or line.startswith(r"\parthead{Notation}")) and not line.startswith(r"\end{longtable}")
        counted = counted or line.endswith((r"{Check values}", r"{Worked example}"))
        label, _, content = line.strip().partition(" & ")
        if drawn or line.startswith(r"\figcap"):
            yield "figure", line
        elif counted:
            yield "number", line
        elif line.startswith((r"\frow", r"\fpair", r"\further")):
            yield from _of_row(line)
        elif tabled and line.count(" & ") == 3:
            symbol, unit, domain, meaning = line.split(" & ")
            yield "domain", f"{domain} of {symbol.strip().strip('$')}"
            yield "sentence", f"{symbol} {unit} {meaning}"
        elif line.startswith(" ") and label in _LABELS:
            yield ("approach" if label == "Limits" else "domain"), content
        else:
            yield "sentence", line
        drawn = drawn and r"\end{tikzpicture}" not in line
        counted = counted and not line.startswith((r"\bottomrule", r"\par}"))


def _of_row(line: str) -> Iterator[tuple[Where, str]]:
    """Beside the formula of a row: its range or approach, and the words behind it."""
    halves = arguments(line) if line.startswith((r"\fpair", r"\furtherpair")) else [line]
    for half in halves:
        _, small, tex, *_ = [*arguments(half), "", ""]
        yield ("approach" if r"\to" in small else "range"), small
        yield "sentence", tex.partition(r"\remark{")[2]


def _in_line(where: Where, line: str) -> Iterator[Inline]:
    return (Inline(where, match[1], line) for match in _MATHEMATICS.finditer(line))
