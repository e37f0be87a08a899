"""Profiles that are a sum of simpler ones: what they add to at equal contact radius, in one row of the book."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from ..notation import R1, R2, R, b, theta
from ..profiles import load
from .printer import Printer
from .rows import Region


@dataclass(frozen=True)
class Part:
    """A simpler profile, its sign, and its parameters in those of the sum."""

    sign: int
    name: str
    parameters: Mapping[sp.Symbol, sp.Expr] = field(default_factory=dict)


SUMS = {
    "rounded_cone": (
        Part(1, "paraboloid", {R: b / sp.tan(theta)}), Part(-1, "rounded_punch", {R: b / sp.tan(theta), b: b})
    ),
    "capped_paraboloid": (
        Part(1, "paraboloid", {R: R1}), Part(1, "truncated_paraboloid", {R: R1 * R2 / (R1 - R2), b: b})
    ),
    "rounded_curved_punch": (Part(1, "paraboloid", {R: R1}), Part(1, "rounded_punch", {R: R2, b: b})),
}  # fmt: skip


def sum_rows(name: str) -> list[dict[str, Any]]:
    """The row of a profile that is a sum, none of any other."""
    if name not in SUMS:
        return []
    parts = [(_sign(part, i), _linked(part), _values(part)) for i, part in enumerate(SUMS[name])]
    lines = (
        rf"\text{{{sign}{link}, page~\pageref{{sec:{part.name}}}, with }}{values}"
        for (sign, link, values), part in zip(parts, SUMS[name], strict=True)
    )
    return [
        {
            "half": False,
            "kind": "sum",
            "comment": f"sum {name}.d {name}.F {name}.p {name}.w",
            "label": "Sum",
            "small": "at equal $a$",
            "tex": Region("", tuple(lines)).tex,
            "remark": "where $a>b$; $p$ and $w$ too",
            "words": ", ".join(f"{sign}{link} with ${values}$" for sign, link, values in parts) + " where $a>b$",
        }
    ]


def _sign(part: Part, index: int) -> str:
    return "" if index == 0 else "plus " if part.sign > 0 else "minus "


def _linked(part: Part) -> str:
    return rf"\hyperref[sec:{part.name}]{{{load(part.name).title.lower()}}}"


def _values(part: Part) -> str:
    """The parameters that have another name or value there."""
    return ",\\; ".join(f"{Printer()(s)}={Printer()(e)}" for s, e in part.parameters.items() if s != e)
