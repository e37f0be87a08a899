"""Adhesion in print as the generated code computes it: fields at the edge, and the unknown of each stable radius."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from .. import notation as nt
from ..contact.adhesive import pull_off_number
from ..contact.medium import GRADED, HOMOGENEOUS, Medium
from ..entry import Entry
from ..notation import a, r
from ..profiles.profile import Profile
from .evaluated import Rows
from .evaluated_fields import ROOT_INSIDE, ROOT_OUTSIDE
from .evaluated_slip import packed
from .height import bracket
from .printer import Printer
from .rows import Region
from .rules import ADH, radius_name
from .shorthand import LINE
from .universal import power_of_depth
from .width import width

LOADS = {"F": ("c", r"F_{\mathrm N}", rf"F{ADH}"), "d": ("m", "d", rf"d{ADH}")}
"""Subscript of pull-off, name of the load, and the load over the radius, by what is given."""
REMARK = 45.0
"""Points for the few words behind a formula."""
CONTROLS = {"F": "force", "d": "depth"}


def adhesive_rows(key: str, plain: Mapping[str, Entry], graded: bool) -> Rows:
    """The rows of an adhesive contact; `plain` are the entries of its normal contact on the same medium."""
    medium, profile = GRADED if graded else HOMOGENEOUS, plain["d"].profile
    order = power_of_depth(plain["d"])
    fields = [] if graded else field_rows(key)
    if order is not None:
        return [*fields, *(_by_curve(key, load, order, medium) for load in LOADS)]
    if graded or not _one_branch(profile):
        return fields
    return [*fields, *(_by_excess(key, load, profile) for load in LOADS)]


def field_rows(key: str) -> Rows:
    """Pressure and displacement with the exact differences at the edge of the punch that is retracted."""
    scale = Printer()
    pressure = rf"\frac{{{scale(nt.E_star)} \Delta\ell}}{{\pi {ROOT_INSIDE}}}"
    surface = rf"\frac{{2 \Delta\ell}}{{\pi}} \arctan \frac{{a}}{{{ROOT_OUTSIDE}}}"
    both = rf"p{ADH}(r)=p(r)-{pressure},\quad w{ADH}(r)=w(r)-{surface}"
    return [_row("evaluation", f"{key}.p {key}.w", "Evaluated as", "", both)]


def _row(kind: str, keys: str, label: str, small: str, tex: str, remark: str = "") -> dict[str, Any]:
    return {
        "half": False, "comment": f"{kind} {keys}", "label": label, "small": small, "tex": tex, "remark": remark,
    }  # fmt: skip


def curve_exponents(load: str, n: sp.Expr, medium: Medium) -> tuple[sp.Expr, sp.Expr]:
    """Exponents of the load A a**p - B a**q of a power law."""
    return n + (1 + medium.k if load == "F" else 0), pull_off_number(medium)[CONTROLS[load]] / 2


def _by_curve(key: str, load: str, n: sp.Expr, medium: Medium) -> dict[str, Any]:
    """The universal curve of a power law, solved for the growth of a**q since pull-off."""
    letter, name, _ = LOADS[load]
    p, q = curve_exponents(load, n, medium)
    m, growth = sp.cancel(p / q), _quotient(sp.S.One, 2 * q, "{}/{}", "({})")
    power = f"^{{{growth}}}" if growth != "1" else ""
    parts = [rf"a={radius_name(letter)} \, (1+s){power}"]
    excess = rf"1-\frac{{{name}}}{{{name[0]}_{{\mathrm {letter}}}}}"
    if m == 2:
        parts.append(f"s^{{2}}={excess}")
    elif m.is_number:
        start = Printer(names={EXCESS: "y"})(sp.sqrt(2 * EXCESS / m))
        parts += [f"{_curve(m)}=y", f"y={excess}", f"s_0={start}"]
    else:
        own = _quotient(p, 2 * q, r"\frac{{{}}}{{{}}}", "{}")
        parts += [r"\frac{(1+s)^{m}-1-m s}{m-1}=y", f"y={excess}", f"m={own}", r"s_0=\sqrt{\frac{2 y}{m}}"]
    lines = packed(parts)
    remark = "at small $s$" if m != 2 and width(lines[-1]) + REMARK <= LINE else ""
    return _row("solved", f"{key}.a{load}", "Solved for $s$", _from(load), Region("", tuple(lines)).tex, remark)


EXCESS = sp.Symbol("excess", positive=True)


def _quotient(p: sp.Expr, xi: sp.Expr, form: str, group: str) -> str:
    """2 p/xi with the numbers taken together and sums as they are."""
    if (2 * p / xi).is_number or xi == 1:
        return Printer()(2 * p / xi) if form.startswith("\\") else str(2 * p / xi)
    printer = Printer()
    above = f"2 ({printer(p)})" if p.is_Add else printer(2 * p)
    return form.format(above, group.format(printer(xi)) if xi.is_Add else printer(xi))


def _curve(m: sp.Rational) -> str:
    """((1 + s)**m - 1 - m s)/(m - 1) with a number for m."""
    number = f"{m.q} " if m.q != 1 else ""
    above = f"{number}(1+s)^{{{Printer().exponent(m)}}}-{m.q}-{m.p} s"
    return above if m.p - m.q == 1 else rf"\frac{{{above}}}{{{m.p - m.q}}}"


def _from(load: str) -> str:
    return f"from {CONTROLS[load]}"


def _one_branch(profile: Profile) -> bool:
    """Whether the contact is stable from pull-off on to the end of its domain, with a load that has no corner."""
    inside = profile.breaks and not profile.truncated
    return not inside and profile.largest is None and nt.wavelength not in profile.parameters


def place(profile: Profile, least: sp.Expr, t: sp.Expr) -> sp.Expr:
    """The radius over the unknown t: it grows from that of pull-off to the end of the domain."""
    end = profile.chain[-1] if profile.chain and not profile.truncated else sp.oo
    return sp.cancel(least * (1 + t) / (1 + t * least / end))


def _by_excess(key: str, load: str, profile: Profile) -> dict[str, Any]:
    """The load in excess of the least one, over the growth t of the radius since pull-off."""
    letter, name, function = LOADS[load]
    least, t = nt.a_c, sp.Symbol("t", positive=True)
    printer = Printer((r, a), {least: radius_name(letter), t: "t"})
    pulled = rf"{name[0]}_{{\mathrm {letter}}}"
    one = bracket(printer(place(profile, least, sp.S.One)))
    start = rf"\sqrt{{\frac{{{name}-{pulled}}}{{{function}{one}-{pulled}}}}}"
    parts = [f"a={printer(sp.factor(place(profile, least, t)))}", rf"{function}(a)={name}", rf"t_0={start}"]
    region = Region("", tuple(packed(parts)))
    return _row("solved", f"{key}.a{load}", "Solved for $t$", _from(load), region.tex, "start at most 1")
