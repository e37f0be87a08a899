"""Entries as rows of the handbook: label, range, formula in lines that fit, permanent key."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import sympy as sp

from ..entry import Entry
from .printer import Printer
from .ranges import Pairs, chain_of, condition, regions
from .shorthand import LINE, Short, shortened, with_kappa
from .width import width

Kind = Literal["formula", "root", "composition"]
LEFT = {
    "d": "d=g(a)", "F": r"F_{\mathrm N}", "p": "p(r)", "w": "w(r)", "k": r"\frac{\mathrm{d}F_{\mathrm N}}{\mathrm{d}d}",
    "pm": r"\bar p=\frac{F_{\mathrm N}}{\pi a^{2}}", "ad": "a", "aF": "a", "Fd": r"F_{\mathrm N}", "dF": "d",
    "rz": "r_{0}",
    "dmin": r"d_{\mathrm{min}}", "Fmin": r"F_{\mathrm{min}}",
}  # fmt: skip
INDENT = r"\enspace\enspace "


@dataclass(frozen=True)
class Region:
    """One formula of a row: the range in which it holds, and its lines of LaTeX."""

    condition: str
    lines: tuple[str, ...]

    @property
    def tex(self) -> str:
        if len(self.lines) == 1:
            return self.lines[0]
        return r"\begin{aligned}[t]&" + r"\\[1.5mm]&".join(self.lines) + r"\end{aligned}"

    @property
    def width(self) -> float:
        return max(map(width, self.lines))


@dataclass(frozen=True)
class Row:
    """What is printed for one entry."""

    entry: Entry
    kind: Kind
    regions: tuple[Region, ...]
    remark: str = ""
    """Words behind the formula, as `solved for a`."""
    uses: str = ""
    """Suffix of the row the remark refers to."""

    @property
    def key(self) -> str:
        return self.entry.key

    @property
    def suffix(self) -> str:
        return self.entry.suffix

    @property
    def label(self) -> tuple[str, str]:
        """Label and the grey words under it: Contact radius, from force."""
        first, word, second = self.entry.quantity.label.partition(" from ")
        if first == "Displacement outside":
            first = "Displacement"
        return first, f"{word.strip()} {second}".strip()

    @property
    def narrow(self) -> bool:
        """Whether the row takes half a line only."""
        return len(self.regions) == 1 and len(self.regions[0].lines) == 1 and not self.regions[0].condition


@lru_cache(maxsize=1024)
def row(entry: Entry) -> Row:
    """The row of an entry."""
    if entry.composed:
        outer, inner = entry.composed
        left = LEFT[entry.suffix]
        function = "g(a)" if outer == "d" else r"F_{\mathrm N}(a)"
        return Row(entry, "composition", (Region("", (f"{left}={function}",)),), "with $a$ from", inner)
    if entry.status == "root" and entry.suffix in ("ad", "aF"):
        equation = "g(a)=d" if entry.suffix == "ad" else r"F_{\mathrm N}(a)=F_{\mathrm N}"
        return Row(entry, "root", (Region("", (equation,)),), "solved for $a$")
    left = LEFT[entry.suffix]
    found = []
    for pairs, expr in regions(entry):
        found.append(_region(entry, pairs, expr, left))
        left = left.partition("=")[0]
    return Row(entry, "formula", tuple(found))


def _region(entry: Entry, pairs: Pairs, expr: sp.Expr, left: str) -> Region:
    chain = chain_of(entry, expr)
    if isinstance(expr, sp.Equality):
        printer = Printer(chain, with_kappa(expr).names)
        return Region(condition(entry, pairs, chain, printer), (printer(expr),))
    left += "="
    short = shortened(expr, chain, width(left))
    printer = Printer(chain, short.names)
    lines = _broken(left, short.expr, printer)
    return Region(condition(entry, pairs, chain, printer), tuple(_with_definitions(lines, short, printer)))


def _broken(left: str, expr: sp.Expr, printer: Printer) -> list[str]:
    """The formula in lines that fit, broken between terms."""
    whole = left + printer(expr)
    parts = printer.scaled_sum(expr)
    if width(whole) <= LINE or parts is None:
        return [whole]
    sign, scale, terms = parts
    start = left + ("-" if sign < 0 else "") + (scale + r"\," if scale else "")
    opening, closing = (r"\Bigl[", r"\Bigr]") if scale or sign < 0 else ("", "")
    if any("[" in text.replace(r"\sqrt[", "") for _, text in terms) and opening:
        opening, closing = r"\Bigl\{", r"\Bigr\}"
    lines, current = [], start + opening
    for i, (sign_of, text) in enumerate(terms):
        piece = ("-" if sign_of < 0 else "+" if i else "") + text
        if i and width(current + piece) > LINE:
            lines.append(current)
            current = INDENT + "{}"
        current += piece
    return [*lines, current + closing]


def _with_definitions(lines: list[str], short: Short, printer: Printer) -> list[str]:
    """The definitions behind the formula, on its last line if they fit."""
    if not short.definitions:
        return lines
    texts = [f"{short.names[s]}={printer(d)}" for s, d in short.definitions.items() if not _is_kappa(s)]
    out = list(lines)
    for i, text in enumerate(texts):
        gap = r",\qquad " if i == 0 else r",\quad "
        if width(out[-1] + gap + text) <= LINE:
            out[-1] += gap + text
        else:
            out[-1] += ","
            out.append(r"\qquad " + text)
    return out


def _is_kappa(symbol: sp.Expr) -> bool:
    """kappa is explained once per profile, in the definition panel."""
    return str(symbol).startswith("kappa")


def kappa_row(entries: tuple[Entry, ...]) -> str:
    """The definition of kappa if a profile uses it, else an empty string."""
    for entry in entries:
        for case in entry.cases:
            short = with_kappa(case.expr)
            if short.definitions:
                ((symbol, definition),) = short.definitions.items()
                return f"{short.names[symbol]}={Printer()(definition)}"
    return ""


def lines(rows: list[Row]) -> list[tuple[Row, ...]]:
    """Rows in printing order: depth and force first, fields last, two narrow ones on one line."""
    narrow = [one for one in rows if one.narrow and _half(one)]
    if not {"d", "F"} <= {one.suffix for one in narrow}:
        narrow = [one for one in narrow if one.suffix not in ("d", "F")]
    wide = [one for one in rows if one not in narrow]
    out = [tuple(narrow[i : i + 2]) for i in range(0, len(narrow), 2)] + [(one,) for one in wide]
    return sorted(out, key=lambda line: min(_place(one, line in out[-len(wide) :]) for one in line))


def _place(one: Row, wide: bool) -> float:
    """The force follows the depth at once where they have lines of their own."""
    return 0.5 if wide and one.suffix == "F" else ORDER.index(one.suffix)


HALF = 122.0
"""Points for the formula of half a row."""


def _half(one: Row) -> bool:
    remark = 12 + 3.7 * len(one.remark.replace("$", "")) + (12 if one.uses else 0) if one.remark else 0
    return one.regions[0].width + remark <= HALF


ORDER = ("d", "ad", "F", "Fd", "aF", "dF", "k", "pm", "p", "w", "rz", "dmin", "Fmin")


def ordered(entries: Mapping[str, Entry]) -> list[Row]:
    """The rows of a profile, the short ones first, fields last."""
    return [row(entries[suffix]) for suffix in ORDER if suffix in entries]
