r"""The formulas of the compiled source, found by the line they stand in, without the generator.

A row is an argument of \frow or \fpair, a definition or special function in a
box of its own, a cell of the table of profiles, or a line of a definition panel.
A limit, an approach or a universal curve has no key of its own: the comment
above it says which entries it is about, `%% limit cone.d`.  All other mathematics
stands in words: a range beside a row, a domain, a number of a table, a figure,
or a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

Kind = Literal["row", "definition", "function", "cell", "panel", "slope", "special"]


@dataclass(frozen=True)
class Formula:
    """A formula in print: its LaTeX, and the end of its key where it carries one."""

    kind: Kind
    tex: str
    suffix: str = ""


OPENING, GAP = r"\begin{aligned}[t]&", r"\\[1.5mm]&"
"""Between the lines of a formula; the words behind it stand in the last one, or alone in it."""
_BOXED = re.compile(r"\\labelbox\{[^}]*\}\{\}\\hspace\{2mm\}\$\\displaystyle (.*?)\$\\hfill")
_NAMED = re.compile(r"\\hbox to\\textwidth\{\$\\displaystyle (.*?)\$\\hfill\\parbox")
_CELL = re.compile(r"& \$\\displaystyle (.*?)\$(?= &|\\\\)")
_SHAPE = re.compile(r"\$(?:\\displaystyle )?([fp]\([rx]\)=.*?)\$")
_SHORTHAND = re.compile(r"\$(?:\\displaystyle )?([^$]*?=[^$]*?)\$")
_SLOPE = re.compile(r"\$(f'\(r\)=.*?)\$")


def formulas(text: str) -> list[Formula]:
    """The formulas of one source file in their order by kind."""
    found = [Formula("definition", tex) for tex in _BOXED.findall(text)]
    found += [Formula("function", tex) for tex in _NAMED.findall(text)]
    found += [Formula("slope", tex) for tex in _SLOPE.findall(text)]
    for line in text.splitlines():
        label, _, content = line.strip().partition(" & ")
        if label.isdecimal() and r" & $\displaystyle " in content:
            found += [Formula("special", tex, label) for tex in _CELL.findall(line)]
        elif line.startswith(r"\hyperref[sec:"):
            found += [Formula("cell", tex) for tex in _CELL.findall(line)]
        elif label in ("Profile", "Pressure"):
            found += [Formula("panel", tex) for tex in _SHAPE.findall(content)]
        elif label == "Shorthand":
            found += [Formula("panel", tex) for tex in _SHORTHAND.findall(content)]
        elif line.startswith((r"\frow", r"\fpair")):
            for half in arguments(line) if line.startswith(r"\fpair") else [line]:
                *_, tex, suffix = arguments(half)
                found.append(Formula("row", without_remark(tex), suffix))
    return found


def without_remark(tex: str) -> str:
    r"""The formula without the words behind it."""
    formula, words, _ = tex.partition(r"\remark{")
    if not words or not formula.startswith(OPENING):
        return formula
    lines = formula.removeprefix(OPENING).split(GAP)
    lines = lines if lines[-1] else lines[:-1]
    return lines[0] if len(lines) == 1 else OPENING + GAP.join(lines) + r"\end{aligned}"


def arguments(text: str) -> list[str]:
    """The groups in braces that follow one another, without the optional argument or the macro before them."""
    found, depth, start = [], 0, 0
    for i, letter in enumerate(text):
        escaped = i > 0 and text[i - 1] == "\\"
        if letter == "{" and not escaped:
            depth, start = depth + 1, start if depth else i + 1
        elif letter == "}" and not escaped:
            depth -= 1
            if depth == 0:
                found.append(text[start:i])
    return found


_HEADS = re.compile(r"([a-z-]+)((?: [\w.]+\.\w+)+)")


@dataclass(frozen=True)
class Further:
    """A row as TeX sets it: its kind, the keys it is about, its range or approach, its formula."""

    kind: str
    keys: tuple[str, ...]
    small: str
    tex: str


def further(text: str) -> Iterator[Further]:
    """The rows of one source file in their order."""
    comment = ""
    for line in text.splitlines():
        if line.startswith("%% "):
            comment = line.removeprefix("%% ")
        elif line.startswith(r"\further"):
            whole = arguments(line)
            halves = [arguments(half) for half in whole] if line.startswith(r"\furtherpair") else [whole]
            kinds = _HEADS.findall(comment)
            for half, (kind, keys) in zip((half for half in halves if any(half[2:3])), kinds, strict=True):
                yield Further(kind, tuple(keys.split()), half[1].strip("$"), without_remark(half[2]))


Where = Literal["range", "approach", "domain", "number", "figure", "sentence"]
Says = Literal["relation", "value", "symbol"]
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
    def kind(self) -> Says:
        """A relation says something, and so does a value that is more than a name; a symbol or a number does not."""
        if _RELATION.search(self.tex):
            return "relation"
        return "value" if _VALUE.search(self.tex) and not _PLAIN.fullmatch(self.tex) else "symbol"


def inline(text: str) -> list[Inline]:
    """The formulas within the words of one source file, in their order."""
    own = {one.tex for one in formulas(text) if one.kind != "row"}
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
