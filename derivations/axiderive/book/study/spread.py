"""The two pages on the study in print: a few panels of error against run time, and where digits are lost."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from typing import Any

from . import error

PANELS = (
    "cone.p", "cone.w", "paraboloid.adh.ad", "rounded_punch.p", "rounded_punch.Fd", "rounded_punch.w",
    "sphere.p", "sphere.Fd", "sphere.w", "power_law.fgm.p", "power_law.fgm.Fd", "power_law.fgm.w",
)  # fmt: skip
"""A closed form, adhesion, a rule with a break, cancellation, and the graded half-space."""
MAPS = ("rounded_punch.p", "sphere.p", "truncated_cone.p", "rounded_punch.w", "sphere.w", "truncated_cone.w")
CELLS = ((0, "10^{-12}"), (6, "10^{-6}"), (9, "10^{-3}"), (12, r"\tfrac12"), (14, "1-10^{-3}"), (17, "1-10^{-6}"),
         (23, "1-10^{-12}"))  # fmt: skip
"""Which cells of a map of one ratio are told, and about which ratio they are."""
MOST = 16
"""Digits of a double."""


def spread(figures: Mapping[str, Any], records: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Panels with the methods that they show, maps, and the digits that printed formulas of one ratio keep."""
    found: dict[str, Any] = {"error": None, "maps": None, "digits": []}
    if whole := figures["error"]:
        panels = _chosen(whole.panels, PANELS)
        letters = {line.letter for panel in panels for line in panel.lines}
        methods = tuple(one for one in whole.methods if one[0] in letters)
        found["error"] = dataclasses.replace(whole, panels=panels, methods=methods)
    if whole := figures["maps"]:
        found["maps"] = dataclasses.replace(whole, square=_chosen(whole.square, MAPS))
        known = {one.key: one.known for one in whole.plain}
        found["digits"] = [_digits(one, known[one["key"]]) for one in records["maps"]["maps"] if _is_of_a_ratio(one)]
    return found


def _chosen(all_of_them: Sequence[Any], keys: Sequence[str]) -> tuple[Any, ...]:
    return tuple(one for key in keys for one in all_of_them if one.key == key)


def _is_of_a_ratio(one: Mapping[str, Any]) -> bool:
    """Whether a map has one axis, from 0 to 1."""
    return len(one["axes"]) == 1 and one["edges"][0][-1] <= 1


def _digits(one: Mapping[str, Any], known: bool) -> dict[str, Any]:
    """Digits of the printed formula over the ratio it depends on."""
    (cells,) = one["naive"]["worst"]
    return {"key": one["key"], "known": known, "ratio": one["axes"][0], "digits": [_kept(cells[i]) for i, _ in CELLS]}


def _kept(ulps: float | None) -> str:
    """Correct digits behind an error in units of the last place."""
    if ulps is None or ulps < 0:
        return "--"
    return str(max(0, min(MOST, math.floor(-math.log10(max(ulps, 1.0) * error.FLOOR)))))
