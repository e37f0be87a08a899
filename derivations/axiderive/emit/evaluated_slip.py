"""Partial slip in print as the generated code computes it: what the contact gains while it grows from c to a."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import sympy as sp

from .. import notation as nt
from ..contact.medium import GRADED, HOMOGENEOUS, Medium
from ..entry import Entry
from ..notation import a, r
from .evaluated import Rows
from .height import bracket
from .naming import LEFT
from .physics import RUNTIME
from .printer import Printer
from .rows import Region, broken
from .rules import sliding_ratio
from .shorthand import LINE, with_kappa
from .universal import power_of_depth
from .width import width

GROWTH = sp.Symbol("lambda_", positive=True)
NAMES = {GROWTH: r"\lambda"}
GROWN = r"\lambda=\ln\Bigl(1+\frac{a-c}{c}\Bigr)"
OUTER, INNER, GAIN, WAY = (sp.Symbol(name, positive=True) for name in ("outer", "inner", "gain", "way"))
ROOTS = {OUTER: "y", INNER: "z", GAIN: "s", WAY: "(a-c)"}
CHORDS = (r"s=\frac{(a-c) (a+c)}{y+z}", r"y=\sqrt{(a-r) (a+r)}", r"z=\sqrt{(c-r) (c+r)}")
"""Half chords of both circles at the radius r, and their difference without cancellation."""


def close_share() -> sp.Rational:
    """The share of the whole above which what is stuck is no longer subtracted, from the module itself."""
    text = (RUNTIME / "_slip.py").read_text(encoding="utf-8")
    (found,) = re.findall(r"^CLOSE = ([\d.]+)$", text, re.MULTILINE)
    return sp.Rational(found)


def slip_rows(key: str, plain: Mapping[str, Entry], graded: bool) -> Rows:
    """The rows of a tangential contact; `plain` are the entries of its normal contact on the same medium."""
    medium = GRADED if graded else HOMOGENEOUS
    order = power_of_depth(plain["d"])
    if order is not None:
        return [*_of_powers(key, order, medium), *_traction(key, plain, order, medium)]
    if nt.coefficients in plain["d"].profile.parameters and not graded:
        return [*_of_terms(key, plain), _row(f"{key}.tau", "$r<c$", integrals(medium)["tau"])]
    if graded:
        return []  # the integrals are those of the homogeneous half-space, with their own powers
    return grown_rows(key, medium)


def grown_rows(key: str, medium: Medium) -> Rows:
    """Integrals over the growth from c to a, which take the place of a difference of close values."""
    times, found = Printer()(1 / close_share()), integrals(medium)
    halves = {
        "F": rf"{times} F_{{\mathrm N}}(c)\ge F_{{\mathrm N}}(a)",
        "u": rf"{times} g(c)\ge g(a)",
        "tau": rf"{times} p(r;c)\ge p(r;a)",
    }
    return [_row(f"{key}.{suffix}", f"${where}$", found[suffix], suffix != "tau") for suffix, where in halves.items()]


def integrals(medium: Medium) -> dict[str, str]:
    """Force, displacement and traction as integrals of g'(t) from c to a."""
    printer, t = Printer((r, nt.t)), nt.t
    force = printer(nt.mu * medium.stiffness() / a ** (1 + medium.k))
    weight = printer(t ** (1 + medium.k))
    traction = printer(nt.mu * medium.pressure_scale)
    if medium.k == 0:
        ring = r"\frac{g'(t)}{\sqrt{(t-r) (t+r)}}"
    else:
        ring = rf"\bigl[(t-r) (t+r)\bigr]^{{{printer.exponent((medium.k - 1) / 2)}}} g'(t)"
    return {
        "F": rf"F_x={force}\int_{{c}}^{{a}} {weight} g'(t)\,\mathrm{{d}}t",
        "u": rf"u={sliding_ratio(medium)}\int_{{c}}^{{a}} g'(t)\,\mathrm{{d}}t",
        "tau": rf"\tau(r)={traction}\int_{{c}}^{{a}} {ring}\,\mathrm{{d}}t",
    }


def _row(keys: str, small: str, tex: str, half: bool = False) -> dict[str, Any]:
    return {
        "half": half, "comment": f"evaluation {keys}", "label": "Evaluated as", "small": small, "tex": tex,
        "remark": "",
    }  # fmt: skip


def _share(order: sp.Expr) -> sp.Expr:
    """1 - (c/a)**order."""
    return 1 - sp.exp(-order * GROWTH)


def _bracketed(order: sp.Expr) -> str:
    """The same in print, with the exponential as a power of e."""
    number = "" if order == 1 else Printer()(order)
    return rf"(1-\mathrm{{e}}^{{-{bracket(number) if order.is_Add else number} \lambda}})"


def _of_powers(key: str, order: sp.Expr, medium: Medium) -> Rows:
    """A power law: both values at a, times what the share of c leaves of them."""
    force = rf"F_x=\mu {LEFT['F']}(a) \, {_bracketed(order + 1 + medium.k)}"
    moved = rf"u={sliding_ratio(medium)} g(a) \, {_bracketed(order)}"
    return [_row(f"{key}.F {key}.u", "", Region("", tuple(packed([force, moved, GROWN]))).tex)]


def _of_terms(key: str, plain: Mapping[str, Entry]) -> Rows:
    """A polynomial term by term."""
    found = []
    for suffix, left, scale, more in (("F", "F_x", nt.mu, 1), ("u", "u", nt.mu * nt.E_star / nt.G_star, 0)):
        whole = plain["F" if suffix == "F" else "d"].cases[0].expr
        own = whole.replace(sp.Sum, lambda term, limits, more=more: sp.Sum(term * _share(nt.j + more), limits))
        short = with_kappa(scale * own)
        found.append(f"{left}=" + Printer(names=NAMES | short.names)(short.expr))
    lines = packed([*found, GROWN])
    return [_row(f"{key}.F {key}.u", "", Region("", tuple(lines)).tex)]


def packed(texts: list[str], room: float = LINE) -> list[str]:
    """Formulas one behind the other, in lines that fit."""
    lines = texts[:1]
    for text in texts[1:]:
        if width(lines[-1] + r",\qquad " + text) <= room:
            lines[-1] += r",\qquad " + text
        else:
            lines[-1] += ","
            lines.append(r"\qquad " + text)
    return lines


def _traction(key: str, plain: Mapping[str, Entry], order: sp.Expr, medium: Medium) -> Rows:
    """The ring from c to a: closed for a cone and for even powers, else an integral."""
    gain = ring_gain(order) if medium.k == 0 else None
    if gain is None:
        return [_row(f"{key}.tau", "$r<c$", integrals(medium)["tau"])]
    rate = sp.diff(plain["d"].cases[0].expr, a) / a ** (order - 1)
    value = nt.mu * medium.pressure_scale * sp.powsimp(rate) * gain
    lines = packed([*broken(r"\tau(r)=", value, Printer((r, nt.c, a), ROOTS)), *CHORDS])
    return [_row(f"{key}.tau", "$r<c$", Region("", tuple(lines)).tex)]


def ring_gain(n: sp.Expr) -> sp.Expr | None:
    """Integral of t**(n - 1)/sqrt(t**2 - r**2) from c to a where the module has it in closed form."""
    if n == 1:
        return sp.log(1 + (WAY + GAIN) / (nt.c + INNER))
    if not (n.is_Integer and n % 2 == 0):
        return None
    quotient, power, total = sp.S.Zero, sp.S.One, sp.S.One
    for m in range(4, int(n) + 1, 2):
        quotient, power = a**2 * quotient + power, nt.c**2 * power
        total = ((m - 2) * r**2 * total + quotient * (OUTER + INNER) * OUTER + power) / (m - 1)
    return GAIN * total
