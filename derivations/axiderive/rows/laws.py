"""Rows that hold for many profiles at once.

Viscoelastic laws, with the rows of growing contacts that hold for all of them, and adhesion of a power law as one
curve: force and depth over those of pull-off, for all parameters.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from ..entry import Entry
from ..notation import E_star, a, d, time, v
from ..physics import adhesive, viscoelastic
from ..physics.medium import GRADED, Medium
from ..print.box import width
from ..print.formula import Printer
from ..print.shorthand import LINE, with_kappa
from .approaches import Further
from .row import HALF, Region, Row

EXPONENT = sp.Symbol("m", positive=True)
"""The power of d that the elastic force goes with, as the laws carry it."""
RELAXATION, COMPLIANCE, RAMP = (sp.Symbol(name, positive=True) for name in ("E(t)", "J(t)", "Phi_m(t)"))
KEY = 16.0
"""Points that a key of two letters would take."""
NAMES = {RELAXATION: "E(t)", COMPLIANCE: "J(t)", RAMP: r"\Phi_{m}(t)"}


LABELS = {
    "E(t)": "Relaxation", "J(t)": "Creep", "Phi_m(t)": "Ramp",
    "Psi_m": "Way back", "t_1": "Earlier time", "t_c": "Contact time",
}  # fmt: skip
"""What a law says, by the left side as it is read."""
LEFT = {"Phi_m(t)": r"\Phi_{m}(t)", "Psi_m": r"\Psi_{m}", "t_c": r"t_{\mathrm c}"}


@dataclass(frozen=True)
class LawText:
    """A viscoelastic law in print."""

    suffix: str
    name: str
    texts: Mapping[str, str]
    """Its formulas by their left sides, those of `LABELS` that can be solved for."""

    @property
    def lines(self) -> list[list[tuple[str, str]]]:
        """Label and formula of each row, two side by side where both are narrow."""
        found: list[list[tuple[str, str]]] = []
        for name, tex in self.texts.items():
            last = found[-1] if found else []
            if len(last) == 1 and max(width(tex), width(last[0][1])) <= HALF + KEY:
                last.append((LABELS[name], tex))
            else:
                found.append([(LABELS[name], tex)])
        return found

    def functions(self) -> dict[str, str]:
        """The three functions of a contact that grows, by the name a row calls them by."""
        return {f"{name.removesuffix('(t)')}()": self.texts[name] for name in tuple(LABELS)[:3]}


TITLES = {"mx": "Maxwell fluid", "kv": "Kelvin--Voigt solid", "sls": "Standard solid", "pc": "Power-law creep"}


@cache
def laws() -> tuple[LawText, ...]:
    """The formulas of every law."""
    return tuple(_law(law) for law in viscoelastic.LAWS)


def expressions(law: viscoelastic.Law) -> dict[str, sp.Expr]:
    """What it says, by the left sides."""
    told = (law.relaxation, law.creep, law.ramp, law.kept, law.earlier, law.end)
    return {name: expr for name, expr in zip(LABELS, told, strict=True) if expr is not None}


def _law(law: viscoelastic.Law) -> LawText:
    printer = Printer(names={EXPONENT: "m"})
    # E_1 and the index of 1F1 behind it are read as one without more space
    texts = {
        name: f"{LEFT.get(name, name)}={printer(expr)}".replace(r"\, {}_{1}", r"\,\, {}_{1}")
        for name, expr in expressions(law).items()
    }
    return LawText(law.suffix, TITLES[law.suffix], texts)


def rows(entries: Mapping[str, Entry], plain: Mapping[str, Entry]) -> list[Row]:
    """Step of the depth, step of the load and ramp of the depth: one row each for the four laws."""
    found = [_step(_of("step", entries), plain)]
    if own := _of("load", entries):
        found.append(_load(own, plain))
    if own := tuple(entry for entry in _of("ramp", entries) if not viscoelastic.in_radius(entry)):
        found.append(_ramp(own, plain))
    return found


def _of(kind: str, entries: Mapping[str, Entry]) -> tuple[Entry, ...]:
    return tuple(entry for suffix, entry in entries.items() if suffix.startswith(kind + "_"))


RULES = {
    "step": r"F_{\mathrm N}(t)=\frac{E(t)}{E^{*}}\,F_{\mathrm N}(d)",
    "load": r"F_{\mathrm N}(a)=E^{*}J(t)\,F_{\mathrm N}",
    "ramp": r"F_{\mathrm N}(t)=\frac{\Phi_{m}(t)}{E^{*}}\,F_{\mathrm N}(v t)",
}
"""What holds for every profile, by the first part of the keys."""


def _row(own: tuple[Entry, ...], tex: str, remark: str = "", uses: str = "") -> Row:
    return Row(own[0], "rule", (Region("", (tex,)),), remark, uses, also=own[1:])


def _simple(entry: Entry) -> bool:
    return entry.status == "closed" and len(entry.cases) == 1 and not entry.composed


def _text(entry: Entry, *replaced: tuple[sp.Expr, sp.Expr]) -> str:
    short = with_kappa(entry.cases[0].expr.subs(replaced))
    return Printer(entry.cases[0].chain, NAMES | short.names)(short.expr)


def _step(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    elastic = viscoelastic.of_depth(plain)
    if _simple(elastic):
        return _row(own, rf"F_{{\mathrm N}}(t)={_text(elastic, (E_star, RELAXATION))}")
    if "Fd" not in plain:
        return _row(own, RULES["step"])
    return _row(own, RULES["step"].replace("(d)", "(a)"), "with $a$ from", "ad")


def _load(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    radius = plain["aF"]
    if _simple(radius):
        return _row(own, f"a={_text(radius, (E_star, 1 / COMPLIANCE))}")
    return _row(own, RULES["load"], "solved for $a$")


def _ramp(own: tuple[Entry, ...], plain: Mapping[str, Entry]) -> Row:
    elastic = viscoelastic.of_depth(plain)
    text = RULES["ramp"]
    if _simple(elastic):
        text = rf"F_{{\mathrm N}}(t)={_text(elastic, (E_star, RAMP), (d, v * time))}"
    return _row(own, rf"{text},\qquad m={Printer()(viscoelastic.elastic_exponent(elastic))}")


RATIO = sp.Symbol("x", positive=True)
"""a/a_c, the contact radius over that of pull-off under force control."""


def universal_rows(key: str, depth: Entry, medium: Medium) -> list[Further]:
    """Rows of an adhesive problem whose depth is one power of the contact radius, one if they fit on a line.

    At pull-off the retraction is 2 n/xi of the depth g, by the condition of
    stationarity, and F_N = n/(n + 1 + k) of stiffness times g.
    """
    exponent = power_of_depth(depth)
    if exponent is None:
        return []
    force, depth_ratio = curve(exponent, medium)
    ratio = r",\qquad x=\frac{a}{a_{\mathrm c}}"
    found = {
        f"{key}.F": rf"\frac{{F_{{\mathrm{{adh}}}}}}{{F_{{\mathrm c}}}}={force}",
        f"{key}.d": rf"\frac{{d_{{\mathrm{{adh}}}}}}{{d_{{\mathrm c}}}}={depth_ratio}",
    }
    joined = r",\qquad ".join(found.values()) + ratio
    rows = {tuple(found): joined} if width(joined) <= LINE else {(key,): text + ratio for key, text in found.items()}
    return [Further("universal", keys, "Universal curve", "", text) for keys, text in rows.items()]


def power_of_depth(depth: Entry) -> sp.Expr | None:
    """n of g = c a**n."""
    if depth.status != "closed" or len(depth.cases) != 1:
        return None
    base, exponent = depth.cases[0].expr.as_independent(a, as_Add=False)[1].as_base_exp()
    return exponent if base == a else None


def curve(n: sp.Expr, medium: Medium) -> tuple[str, str]:
    """F/F_c and d/d_c over x = a/a_c as LaTeX."""
    xi, k, whole = adhesive.pull_off_number(medium)["force"], medium.k, n + 1 + medium.k
    pulled = [_power((3 + k) / 2), _power((1 - k) / 2)]
    force = _quotient(2, whole, pulled[0], xi, RATIO**whole, sp.expand(2 * whole - xi))
    depth = _quotient(2, n, pulled[1], xi, RATIO**n, sp.expand(2 * n - xi))
    return force, depth


def _power(exponent: sp.Expr) -> sp.Expr:
    """A power of x that keeps the sign of its exponent in print."""
    if exponent.is_Integer or exponent == sp.S.Half:
        return RATIO**exponent
    above, below = sp.fraction(sp.together(exponent))
    top = f"({Printer()(above)})" if above.is_Add else Printer()(above)
    return sp.Symbol(f"x^{{{top}/{below}}}", positive=True)


def _quotient(number: int, factor: sp.Expr, pulled: sp.Expr, xi: sp.Expr, elastic: sp.Expr, below: sp.Expr) -> str:
    """(number factor pulled - xi elastic)/below, with plain numbers divided."""
    printer = Printer(names={pulled: pulled.name} if isinstance(pulled, sp.Symbol) else {})
    total = number * factor * pulled - xi * elastic
    whole = total / below if below.is_number else sp.factor_terms(total / below)
    if sp.fraction(whole)[1].is_number:
        return printer(whole)
    sign = -1 if below.xreplace({GRADED.k: sp.S.Zero}).is_negative else 1
    return rf"\frac{{{printer(sp.factor_terms(sign * total))}}}{{{Printer()(sign * below)}}}"
