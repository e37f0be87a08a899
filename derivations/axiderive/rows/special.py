"""Profiles that are a special case or a sum of others, in print.

A special case stands in the entry of its host, with its keys as anchors; a sum of simpler profiles says in one row
what they add to at equal contact radius, and a rounded tip says what it is to a contact that ends on it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..notation import R1, R2, E_star, R, a, b, h, n, theta
from ..physics.systems import pool_of, problem
from ..print.formula import Printer
from ..print.words import prose
from ..profiles.profile import Piece
from .approaches import Further
from .row import Region

HOSTS = {
    "quartic": "power_law", "sextic": "power_law",
    "concave_paraboloid": "concave_power", "concave_quartic": "concave_power",
    "plane.quartic": "plane.power_law", "plane.sextic": "plane.power_law",
    "plane.concave_parabola": "plane.concave_power", "plane.concave_quartic": "plane.concave_power",
}  # fmt: skip
"""The profile whose entry holds that of the special case."""
MEMBERS: dict[str, dict[int, str]] = {
    "power_law": {1: "cone", 2: "paraboloid", 3: "", 4: "quartic", 6: "sextic"},
    "plane.power_law": {1: "plane.wedge", 2: "plane.parabola", 3: "", 4: "plane.quartic", 6: "plane.sextic"},
    "concave_power": {2: "concave_paraboloid", 4: "concave_quartic"},
    "plane.concave_power": {2: "plane.concave_parabola", 4: "plane.concave_quartic"},
}
"""Profile of each power n; none where the formulas follow from those of the host.

A profile that has an entry of its own is not told again: the tables refer to its page.
"""
COLUMNS = {
    "power_law": (("d", "F", "aF", "p"), ("w",)),
    "plane.power_law": (("P", "p", "s", "d"),),
    "concave_power": (("F", "dmin", "Fmin", "rz"), ("p", "w")),
    "plane.concave_power": (("Pmin", "xz", "p", "s", "d"),),
}
"""What each of the tables of a host gives."""
UNIT: dict[sp.Expr, sp.Expr] = {nt.A: sp.S.One, E_star: sp.S.One, h: sp.S.One, sp.tan(theta): sp.S.One, R: sp.S.Half}
"""Units in which a profile is r^n or -r^n; that of length is a, where the formula has it."""
NARROW = {
    "s": r"\frac{\mathrm dw}{\mathrm dx}", "dmin": r"d_{\min}", "Fmin": r"F_{\min}", "rz": "r_0", "xz": "x_0",
    "Pmin": r"P_{\min}",
}  # fmt: skip
"""Heads of columns that are not set as the left side of a row."""


def hosted(host: str) -> list[str]:
    """The special cases that stand in the entry of a profile."""
    return [name for name, own in HOSTS.items() if own == host]


def member(host: str, power: int) -> Mapping[str, Entry]:
    """The entries of the power: those of its own profile, or derived for it where the catalogue has none."""
    name = MEMBERS[host][power]
    if name:
        return problem(name).derive()
    pool = pool_of(host)
    like = problem(pool.id("quartic"))
    return like.system.derive(replace(like.profile, pieces=(Piece(None, nt.A * pool.place**power),)))


def tables(host: str) -> list[dict[str, Any]]:
    """The tables of a profile: heads, and for every power the profile of its own and the cells."""
    if host not in MEMBERS:
        return []
    own = problem(host).derive()
    return [
        {
            "heads": [NARROW.get(suffix, own[suffix].quantity.called) for suffix in suffixes],
            "suffixes": suffixes,
            "rows": [_row(host, power, suffixes) for power in told(host)],
        }
        for suffixes in COLUMNS[host]
    ]


def told(host: str) -> list[int]:
    """The powers whose formulas stand in the tables: those without an entry of their own."""
    return [power for power, name in MEMBERS[host].items() if not name or name in HOSTS]


def elsewhere(host: str) -> list[dict[str, Any]]:
    """The powers that have an entry of their own: power, profile and title."""
    return [
        {"power": power, "name": name, "title": prose(problem(name).profile.title)}
        for power, name in MEMBERS.get(host, {}).items()
        if power not in told(host)
    ]


def _row(host: str, power: int, suffixes: tuple[str, ...]) -> dict[str, Any]:
    entries, name = member(host, power), MEMBERS[host][power]
    return {
        "power": power,
        "name": name,
        "title": prose(problem(name).profile.title) if name else "",
        "cells": [Printer()(value(entries, suffix, power)) for suffix in suffixes],
    }


def value(entries: Mapping[str, Entry], suffix: str, power: int) -> sp.Expr:
    """The formula of a quantity in the units of the table."""
    entry = entries[suffix]
    expr = entry.cases[-1].expr.subs({**UNIT, n: sp.Integer(power)})
    return expr if entry.quantity.inverts else expr.subs(a, 1)


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

TIPS = {"plane.rounded_wedge": Part(1, "plane.parabola", {R: b / sp.tan(theta)})}
"""What a profile is to a contact that ends on its tip, a < b: the book does not print its formulas again."""
ON_TIP = "a<b"


def tip_rows(name: str) -> list[Further]:
    """The row that stands for all formulas of a contact that ends on the tip."""
    if name not in TIPS:
        return []
    part, entries = TIPS[name], problem(name).derive().values()
    link, values = _linked(part), _values(part)
    several = tuple(entry.key for entry in entries if entry.status == "closed" and len(entry.cases) > 1)
    text = rf"\text{{{link}, page~\pageref{{sec:{part.name}}}, with }}{values}"
    return [Further("sum", several, "Tip", f"${ON_TIP}$", text, words=f"{link} with ${values}$")]


def sum_rows(name: str) -> list[Further]:
    """The row of a profile that is a sum, none of any other."""
    if name not in SUMS:
        return []
    parts = [(_sign(part, i), _linked(part), _values(part)) for i, part in enumerate(SUMS[name])]
    lines = (
        rf"\text{{{sign}{link}, page~\pageref{{sec:{part.name}}}, with }}{values}"
        for (sign, link, values), part in zip(parts, SUMS[name], strict=True)
    )
    keys = tuple(f"{name}.{suffix}" for suffix in ("d", "F", "p", "w"))
    words = ", ".join(f"{sign}{link} with ${values}$" for sign, link, values in parts) + " where $a>b$"
    remark = "where $a>b$; $p$ and $w$ too"
    return [Further("sum", keys, "Sum", "at equal $a$", Region("", tuple(lines)).tex, remark, words=words)]


def _sign(part: Part, index: int) -> str:
    return "" if index == 0 else "plus " if part.sign > 0 else "minus "


def _linked(part: Part) -> str:
    return rf"\hyperref[sec:{part.name}]{{{problem(part.name).profile.title.lower()}}}"


def _values(part: Part) -> str:
    """The parameters that have another name or value there."""
    return ",\\; ".join(f"{Printer()(s)}={Printer()(e)}" for s, e in part.parameters.items() if s != e)
