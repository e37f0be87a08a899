r"""The formulas of the compiled source: every row that TeX sets, found without the generator.

A row is an argument of \frow or \fpair, a definition or special function in a
box of its own, a cell of the table of profiles, or a line of a definition panel.
All other mathematics of the source stands in a sentence, a range, a figure or a
table of numbers.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Literal

Kind = Literal["row", "definition", "function", "cell", "panel", "slope", "further", "special"]


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
        elif line.startswith(r"\frow"):
            *_, tex, suffix = arguments(line.removeprefix(r"\frow"))
            found.append(Formula("row", without_remark(tex), suffix))
        elif line.startswith(r"\fpair"):
            for half in arguments(line.removeprefix(r"\fpair")):
                *_, tex, suffix = arguments(half)
                found.append(Formula("row", without_remark(tex), suffix))
        elif line.startswith(r"\furtherpair"):
            halves = [arguments(half) for half in arguments(line.removeprefix(r"\furtherpair"))]
            found += [Formula("further", half[2]) for half in halves if len(half) > 2]
        elif line.startswith(r"\further"):
            found.append(Formula("further", without_remark(arguments(line.removeprefix(r"\further"))[2])))
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
