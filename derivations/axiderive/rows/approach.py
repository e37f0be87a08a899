"""A formula that a quantity approaches: the way there in print, and its check against the entry on that way."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from ..abel.masters import C0, StruveH
from ..entry import Case, Entry
from ..oracle.evaluate import evaluate, evaluate_case, evaluated, holds
from ..print.box import width
from ..print.formula import Printer
from ..print.shorthand import LINE, with_kappa
from .points import points_of

NEAR = sp.Symbol("near", positive=True)
"""What is left of the way, zero where the formula is exact."""
DECADES = 40
DISTANCE = sp.Rational(1, 10**DECADES)
DIGITS = 40
REQUIRED = 20
"""Digits that agree at DISTANCE; at points where two lengths differ by 1e-9 the next order takes 10 of its 40."""
SEED = 41
HALF, LINKED = 132.0, 90.0
"""Points for the formulas of half a row, and for the name of the simpler profile behind them."""
GAP = r",\enspace "


@dataclass(frozen=True)
class Approach:
    """One quantity on its way: `way` gives the symbols that move, `cases` the leading formula by region."""

    entry: Entry
    left: str
    way: tuple[tuple[sp.Symbol, sp.Expr], ...]
    cases: tuple[Case, ...]
    named: str = ""
    """The formula by the name of another row, for where it is too long to be spelled out."""

    @property
    def spelled(self) -> str:
        """The formula itself, or nothing where it has several regions."""
        if len({case.expr for case in self.cases}) > 1:
            return ""
        case = self.cases[-1]
        short = with_kappa(case.expr)
        chain = tuple(x for x in case.chain if x.is_Symbol)
        return "" if case.expr.has(sp.Integral) else Printer(chain, short.names)(short.expr)

    def tex(self, room: float) -> str:
        """What is printed within so many points: the formula, else its name, else nothing."""
        for text in filter(None, (self.spelled, self.named)):
            printed = rf"{self.left}\to {text}"
            if width(printed) <= room:
                return printed
        return ""

    def is_named(self, printed: str) -> bool:
        """Whether the formula stands there by the name of another row, as it does for every profile."""
        return bool(self.named) and printed == rf"{self.left}\to {self.named}"

    def on_the_way(self, values: Mapping[Any, Any], distance: sp.Expr = DISTANCE) -> dict[Any, Any]:
        """The values with those that move put at a distance from the end."""
        at = dict(values)
        for symbol, expr in self.way:
            at[symbol] = expr.xreplace({**at, NEAR: distance})
        return at

    @cached_property
    def check(self) -> dict[str, Any]:
        """How many digits of entry and formula agree next to the end of the way, and at how many points."""
        worst, count = mp.mpf(0), 0
        for values in self.points():
            leading = next((case for case in self.cases if holds(case, values)), None)
            own = next((case for case in self.entry.cases if holds(case, values)), None)
            if leading is None or own is None:
                continue
            with mp.workdps(2 * DIGITS):
                wanted = self._leading(leading, values)
                worst = max(worst, abs(self.value(own, values) / wanted - 1))
            count += 1
        digits = int(min(DIGITS, -mp.log10(worst))) if worst else DIGITS
        return {"key": self.entry.key, "digits": digits if count else 0, "count": count}

    @staticmethod
    def _leading(case: Case, values: Mapping[Any, Any]) -> Any:
        if case.expr.has(sp.Integral):
            return evaluated(case.expr, dict(values))
        if case.expr.has(C0):
            return evaluate_case(case, dict(values), DIGITS)
        return evaluate(case.expr, dict(values), DIGITS)

    def value(self, case: Case, values: Mapping[Any, Any]) -> Any:
        """The entry itself in one of its cases."""
        if self.entry.profile.contact == "prescribed":  # Arb has no complete elliptic integrals
            return evaluate(case.expr, dict(values), DIGITS)
        if case.expr.has(sp.Integral) and case.expr.has(StruveH):  # boxes around zero are not enclosed
            return evaluated(case.expr, dict(values))
        return evaluate_case(case, dict(values), DIGITS)

    def points(self) -> list[dict[Any, Any]]:
        """Points next to the end, one or two for every case of the entry."""
        entries = {self.entry.suffix: self.entry}
        return [self.on_the_way(values) for _, values in points_of(self.entry, "formula", entries, 2, SEED)]

    @property
    def holds(self) -> bool:
        """Whether the formula was checked at a point at least, and agrees to enough digits."""
        return self.check["count"] > 0 and self.check["digits"] >= REQUIRED


def approach_row(
    label: str, small: str, parts: list[Approach], half: bool = True, kind: str = "approach"
) -> list[dict[str, Any]]:
    """A row of the parts that hold and fit into half a line or a whole one, none if there is none."""
    room = HALF if half else LINE - LINKED * (kind == "limit")
    texts: list[str] = []
    kept: list[Approach] = []
    for part in parts:
        printed = part.tex(room - sum(map(width, texts)) - width(GAP) * len(texts))
        if printed and part.holds:
            texts.append(printed)
            kept.append(part)
    if not kept:
        return []
    name = kind if kind == "limit" else label.lower().replace(" ", "-")
    return [
        {
            "half": half,
            "kind": kind,
            "comment": " ".join([name, *(part.entry.key for part in kept)]),
            "label": label,
            "small": f"${small}$",
            "tex": GAP.join(texts),
            "remark": "",
            "ruled": name == "far-field" or all(map(Approach.is_named, kept, texts)),
            "checks": [part.check | {"tex": text} for part, text in zip(kept, texts, strict=True)],
        }
    ]
