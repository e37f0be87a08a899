"""The definition panel of a spread: profile, parameters, medium, contact, validity."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from .printer import Printer
from .prose import domain, prose
from .rows import kappa_row

HALF_SPACE = r"homogeneous half-space, $1/E^{*}=\sum_i(1-\nu_i^2)/E_i$"
NOT_ABOVE, NOT_BELOW = r"\le ", r"\ge "


def panel(profile: Profile, entries: Mapping[str, Entry], plane: bool = False) -> list[tuple[str, str]]:
    """Label and content of each line of the definition panel."""
    if profile.contact == "prescribed":
        return _load_panel(profile)
    if not profile.pieces:
        shorthands = [
            rf"$\displaystyle {Printer()(symbol)}={Printer()(expr)}$" for symbol, expr in profile.abbreviations
        ]
        return [("Valid for", prose(profile.validity)), *(("Shorthand", text) for text in shorthands)]
    place = "x" if plane else "r"
    lines = [("Profile", shape_tex(profile, place))]
    # of these a rule says what their domain says, or more
    bounded = {rule.right for rule in profile.rules if rule.left.is_number}
    bounded |= {rule.left.args[0] for rule in profile.rules if isinstance(rule.left, sp.Abs)}
    parameters = [_domain(symbol) for symbol in profile.parameters if symbol not in bounded]
    for rule in profile.rules:
        left, right = Printer()(rule.left), Printer()(rule.right)
        if rule.left.is_number:
            parameters.append(f"${right}{'>' if rule.strict else NOT_BELOW}{left}$")
        else:
            parameters.append(f"${left}{'<' if rule.strict else NOT_ABOVE}{right}$")
    if len(profile.chain) > 1:
        parameters.append("$" + "<".join(Printer()(x) for x in profile.chain) + "$")
    lines.append(("Parameters" if len(parameters) > 1 else "Parameter", ", ".join(p for p in parameters if p)))
    shorthands = [f"${Printer()(symbol)}={Printer()(expr)}$" for symbol, expr in profile.abbreviations]
    if kappa := kappa_row(tuple(entries.values())):
        shorthands.append(rf"$\displaystyle {kappa}$\rule[-4mm]{{0pt}}{{9mm}}")
    if shorthands:
        lines.append(("Shorthand", ", ".join(shorthands)))
    lines.append(("Medium", HALF_SPACE.replace("half-space", "half-plane") if plane else HALF_SPACE))
    span = r"$|x|\le a$" if plane else r"$0\le r\le a$"
    if profile.contact == "compact":
        start = Printer()(profile.breaks[0]) if profile.truncated else None
        lines.append(("Contact", rf"frictionless, compact, {span}" + (f", $a\\ge {start}$" if start else "")))
    elif plane:
        lines.append(("Contact", r"frictionless, complete: the edges $x=\pm a$ are fixed, $P$ is free"))
    else:
        lines.append(("Contact", r"frictionless, complete: the edge $r=a$ is fixed, $d$ is free"))
    if plane and nt.e not in profile.parameters:
        lines.append(("Symmetry", r"$f(-x)=f(x)$; formulas for $x\ge 0$"))
    if profile.largest is not None:
        lines.append(("Largest", f"$a<{_largest(profile.largest)}$; beyond it the contact is not compact"))
    lines.append(("Valid for", prose(profile.validity)))
    if profile.limits:
        lines.append(("Limits", "; ".join(_limit(limit, "plane." if plane else "") for limit in profile.limits)))
    if profile.note:
        lines.append(("Note", prose(profile.note)))
    if profile.synonyms:
        lines.append(("Also called", prose(", ".join(profile.synonyms))))
    return lines


def _largest(bound: sp.Expr) -> str:
    number, rest = bound.as_coeff_Mul()
    return f"{mp.nstr(mp.mpf(str(number)), 6)}\\,{Printer()(rest)}"


def _limit(limit: Any, prefix: str) -> str:
    name = limit.target.replace("_", " ")
    approach = rf"${Printer()(limit.symbol)}\to {Printer()(sp.sympify(limit.value))}$"
    return rf"{approach} \hyperref[sec:{prefix}{limit.target}]{{{name}}}"


def _load_panel(profile: Profile) -> list[tuple[str, str]]:
    exponent = getattr(profile, "exponent", sp.S.Zero)
    pressure = Printer((nt.r, nt.a))(nt.p_0 * sp.Pow(1 - nt.r**2 / nt.a**2, exponent))
    return [
        ("Pressure", f"$\\displaystyle p(r)={pressure}$ for $r<a$, none outside"),
        ("Parameters", ", ".join(text for symbol in profile.parameters if (text := _domain(symbol)))),
        ("Medium", HALF_SPACE),
        ("Valid for", prose(profile.validity)),
    ]


def shape_tex(profile: Profile, place: str = "r") -> str:
    """f(r), piece by piece."""
    texts = []
    lower = None
    for piece in profile.pieces:
        expr = Printer((nt.describe(place).symbol, piece.upper) if piece.upper is not None else ())(piece.expr)
        side, end = (r"\le ", piece.upper) if piece.upper is not None else (">", lower)
        built_up = r"\rule[-3.6mm]{0pt}{8.4mm}" if r"\frac" in expr or r"\sum" in expr else ""
        texts.append(
            rf"{built_up}$\displaystyle f({place})={expr}$"
            + (f" for ${place}{side}{Printer()(end)}$" if end is not None else "")
        )
        lower = piece.upper
    return r",\newline ".join(texts)


def _domain(symbol: Any) -> str:
    """Domain of a parameter in print: 0 < theta < pi/2."""
    if isinstance(symbol, sp.IndexedBase):
        return r"$A_j\ge 0$, not all zero"
    text = domain(nt.describe(symbol))
    return f"${text}$" if text else ""
