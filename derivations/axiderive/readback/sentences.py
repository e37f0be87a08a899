"""What the sentences of the book state in formulas: compared with the engine where they can be, listed where not.

A statement that is neither compared nor listed is unaccounted for, and so is
every misprint of a listed one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Entry
from ..oracle.evaluate import evaluate
from ..physics import viscoelastic
from ..print.formula import Printer
from ..profiles.loads import LOADS
from .claims import CLOSE, DIGITS, Claim, Entries, Line, holds, name_in_print, stated
from .ranges import in_order

LISTED = {
    "definition of a name": (
        r"c_{\mathrm N}(x)=H|x|^{k}", r"c_{\mathrm N}(x)=H|x|^k", r"c_{\mathrm T}(x)=H_x|x|^{k}",
        r"c_{\mathrm T}(x)=H_x|x|^k", "d=v t", r"d=vt", r"m=k^2", r"w_{\mathrm{1D}}=d-g",
        r"p=(\alpha+\beta x)/\sqrt{a^2-x^2}", r"\theta=\pi/2-\alpha", r"\varphi_0=\arccos(b/a)", r"\psi=\arcsin(a/r)",
        r"s=\sqrt{r^2-a^2}", r"\mu_{\mathrm T}=\bigl(R\,\Delta\gamma^2/(E^{*2}z_0^3)\bigr)^{1/3}", r"\sqrt{R\,d}",
        r"\frac{\mathrm dw}{\mathrm dx}", "z^{k}",
    ),
    "homogeneous as the case of a graded half-space": ("k=0", r"H=E^{*}", r"H_x=G^{*}"),
    "where the contact is, or the edge of it": (
        r"0\le r\le a", r"|x|\le a", "r=a", "r=0", "x=e", "a>b", "r<a", "r<c", "r>c",
        "p(r;c)=0", "t<b", "g(t)=0",
    ),
    "a place or a case that a sketch or a note points to": (
        r"F_x=\mu F_{\mathrm N}", "r=b", "x=b", "R_1=R_2", "k=-0.5", "k=0.5", "d+h", "|e|=a/2",
        r"4 \lvert e\rvert-3 a", r"\lvert e\rvert=a/2", "n>1",
    ),
    "a case that a number is given for": (
        r"\nu=\tfrac12", r"\nu=0.3", r"\nu=0.5", r"\nu=0", r"a=0.1\,R", r"a=0.3\,R", r"\mu_{\mathrm T}=5",
    ),
    "a number of the guide, computed in book.evidence": (r"0.3100\,p_0", r"0.4809\,a", r"p_0=1.6\,Y"),
    "a result of the work that is cited": (r"(1-2\nu)/(2-2\nu)", r"(1-\nu)\ln(3-4\nu)/(1-2\nu)"),
    "an equation that is a row beside it": ("g(a)=d", r"F_{\mathrm N}(a)=F_{\mathrm N}"),
    "the half of a symmetric field that is printed": (r"x\ge 0",),
    "a power that has a page or a name of its own": ("n=1", "n=2", "n=4", "n=6"),
    "the domain of a sequence": (r"A_j\ge 0", r"A_{1} \dots A_{N} \ge 0"),
    "an order of magnitude": (
        r"a \ll R", r"a \ll R_1", r"a \ll R_2", r"a \ll", r"h \ll s", r"a-b \ll R", r"a-b \ll R_2",
        r"\tan \theta \ll 1", r"n A a^{n-1} \ll 1", "r^{2}",
        r"P \sim a^{n}", r"F_{\mathrm N}\sim d^m", r"F_{\mathrm N} \sim d^{1+1/n}",
    ),
    "a ratio or an exponent by name": ("b/a", "a/r", "r/a", "a/R", "h/b", "1-r^2/a^2", "1-r^{2}/a^{2}"),
    "an axis, a legend or a case of a study": (
        r"\frac12", r"1-5\cdot10^{-13}", r"\le 5", r"\le 10^{3}", r"\le 10^{6}", r"\le 10^{9}", r"\le 10^{12}",
        r"\tfrac12", "1-10^{-3}", "1-10^{-6}", "1-10^{-12}", r"b\to 0", r"R\to \infty",
    ),
    "a condition of the derivation": (r"g' \ge 0", "g'=0"),
}  # fmt: skip
"""Formulas in sentences that name, order or point, letter by letter."""

PLACE = "a sentence"
CONDITIONS = {
    "p>0": "0 p", r"0\le z<1": "0 z 1", "c>q>0": "0 q c", "z<1": "z 1", "c>p>0": "0 p c", "b<a": "b a", "b<R": "b R",
}  # fmt: skip
"""Where the integrals of the special functions converge and are real, in ascending order."""
MODULI = {
    "E_star": (r"1/E^{*}=\sum_i(1-\nu_i^2)/E_i", r"1/E^{*}=(1-\nu_1^2)/E_1+(1-\nu_2^2)/E_2"),
    "G_star": (r"1/G^{*}=\sum_i(2-\nu_i)/(4 G_i)",),
}  # fmt: skip
SMALL = {nt.theta, nt.nu, nt.nu_1, nt.nu_2, nt.alpha}
"""Angles, ratios and exponents, which are less than a half."""


def _of(entry: Entry) -> sp.Expr:
    return entry.cases[0].expr


def _said(
    tex: str,
    expr: sp.Expr,
    name: str = "",
    given: Mapping[str, sp.Expr] = MappingProxyType({}),
    close: Any = CLOSE,
    **functions: Any,
) -> Line:
    """That a text is this expression; `given` are names that follow from its symbols."""
    symbols = sorted({s for one in (expr, *given.values()) for s in one.free_symbols}, key=str)
    values = {s: sp.Rational(11 + 4 * i, (57 if s in SMALL else 7) + 3 * i) for i, s in enumerate(symbols)}
    with mp.workdps(2 * DIGITS):
        names = {name: evaluate(one, values, DIGITS) for name, one in given.items()}
        return replace(stated(expr, values, name, **names, **functions), close=close).line(PLACE, tex)


def in_front(bodies: Entries) -> Iterator[Line]:
    """Of the notation, the definitions, the special functions and the laws."""
    for suffix, texts in MODULI.items():
        modulus = _of(bodies[suffix])
        for tex in texts:
            one = _said(tex, 1 / modulus, given={name_in_print(bodies[suffix].quantity.symbol): modulus})
            yield replace(one, wrong=_of_both_bodies(one.wrong))
    yield _said(r"F_{\mathrm N}/(\pi a^{2})", nt.F / (sp.pi * nt.a**2))
    yield _said(r"J=(t/t_0)^{\alpha}/E", viscoelastic.LAWS[-1].creep, "J")
    exponent, time = mp.mpf("1.75"), mp.mpf("0.8")
    with mp.workdps(2 * DIGITS):
        names = {"E()": lambda t: mp.exp(-t) + mp.mpf("0.3"), "m": exponent, "t": time}
        ramp = exponent * mp.quad(lambda x: x ** (exponent - 1) * names["E()"](time * (1 - x)), [0, 1])
    yield Claim(names, ramp, "Phi_m(t)").line(
        PLACE, r"\Phi_m(t)=\int_0^1 m\,\xi^{m-1}E\bigl(t(1-\xi)\bigr)\,\mathrm d\xi"
    )
    for tex, members in CONDITIONS.items():
        yield Line(PLACE, tex, in_order([sp.sympify(x, {x: sp.Symbol(x)}) for x in members.split()], str))


def _of_both_bodies(wrong: Callable[[str], bool]) -> Callable[[str], bool]:
    """A sum over both bodies is written out before it is read."""

    def also_summed(tex: str) -> bool:
        left, summed, term = tex.partition(r"\sum_i")
        parts = [re.sub(r"_i(?![a-z])", f"_{body}", term) for body in (1, 2)] if summed else []
        return wrong(re.sub(r"G_(\d)", r"\\tfrac{E_\1}{2(1+\\nu_\1)}", left + "+".join(parts)) if summed else tex)

    return also_summed


ROUNDED = mp.mpf("0.002")
"""A number of three digits."""


def in_guide(bodies: Entries, plain: Entries, adhesive: Entries) -> Iterator[Line]:
    """Of the conventions and of the page on validity, by the elastic constants and the paraboloid."""
    modulus, nu = _of(bodies["E_star"]), nt.nu
    rigid = modulus.subs({nt.young_2: sp.oo, nt.young_1: nt.E, nt.nu_1: nu})
    alike = modulus.subs({nt.young_1: nt.E, nt.young_2: nt.E, nt.nu_1: nu, nt.nu_2: nu})
    shear = {"G": nt.E / (2 * (1 + nu))}
    yield _said(r"E^{*}=E/(1-\nu^2)", rigid, "E*")
    yield _said(r"E/(1-\nu^2)", rigid)
    yield _said(r"2G/(1-\nu)", rigid, given=shear)
    yield _said(r"E/(2-2\nu^2)", alike)
    yield _said(r"\tfrac43 E", rigid.subs(nu, sp.S.Half))
    yield _said(r"-\tfrac32\pi\Delta\gamma R", _of(adhesive["Fc"]))
    pulled = _of(adhesive["Dl"]).subs(nt.a, _of(adhesive["ac"]))
    tabor = {"mu_T": sp.cbrt(nt.R * nt.dgamma**2 / nt.E_star**2), "z_0": sp.S.One}
    yield _said(r"\Delta\ell=3.09\,\mu_{\mathrm T}\,z_0", pulled, "Delta ell", tabor, ROUNDED)
    (radius,) = sp.solve(_of(plain["p"]).subs(nt.r, 0) - nt.p_0, nt.a)
    yield _said(r"\pi^3R^2p_0^3/(6E^{*2})", _of(plain["F"]).subs(nt.a, radius))


def stable_branch(adhesive: Entries) -> Iterator[Line]:
    """The branch that the rules of pull-off are solved on: where force or depth grows with the radius."""
    radii = (sp.Rational(2, 3), sp.Rational(99, 100), sp.Rational(101, 100), sp.Rational(3, 2))
    for suffix, letter in (("d", "m"), ("F", "c")):
        expr, pulled = adhesive[suffix].cases[0].expr, adhesive[f"a{letter}"].cases[0].expr
        values = {s: sp.Rational(3 + i, 4 + i) for i, s in enumerate(sorted(pulled.free_symbols, key=str))}
        values[nt.theta] = sp.Rational(2, 5)
        least = evaluate(pulled, values, DIGITS)
        slope = sp.diff(expr, nt.a)
        points = [(evaluate(slope, values | {nt.a: sp.Float(str(least), DIGITS) * x}, 15) > 0, x * 1) for x in radii]

        def wrong(tex: str, name: str = f"a_{letter}", least: Any = least, points: Any = points) -> bool:
            return any(holds(tex, {"a": least * x.p / x.q, name: least}) != grows for grows, x in points)

        yield Line(PLACE, rf"a\ge a_{{\mathrm {letter}}}", wrong)


def derivations(entries: Mapping[str, Entries]) -> Iterator[Line]:
    """The pressures that the words on the derivations start from, by what the engine has for them."""
    punch = _of(entries["flat_punch"]["p"])
    yield _said(r"E^{*}d/(\pi\sqrt{a^2-r^2})", punch)
    sunk: dict[str, Any] = {"w_1D()": lambda t: mp.mpf(DEPTH.p) / DEPTH.q}
    yield _said(r"E^{*}w_{\mathrm{1D}}(a)/(\pi\sqrt{a^2-r^2})", punch.subs(nt.d, DEPTH), **sunk)
    within = _of(entries["plane.flat_punch"]["p"])
    yield _said(r"P/(\pi\sqrt{t^2-x^2})", within.subs(nt.a, nt.describe("t").symbol))
    with mp.workdps(2 * DIGITS):
        # 2/E* times the integral of r p(r)/sqrt(r^2 - x^2) over (x, a) for a pressure that goes with a power
        p_0, radius, modulus, power, x = map(mp.mpf, ("1.3", "1.7", "2.5", "0.75", "0.6"))
        wide = mp.sqrt(radius**2 - x**2)
        integral = mp.quad(lambda y: p_0 * (1 - (x * x + y * y) / radius**2) ** power, [0, wide])
        moved = Claim({"p_0": p_0, "a": radius, "E*": modulus, "s": power, "x": x}, 2 / modulus * integral, "w_1D")
        yield moved.line(PLACE, r"w_{\mathrm{1D}}=(p_0 a/E^{*})\,\mathrm B(\tfrac12,s+1)\,(1-x^2/a^2)^{s+1/2}")
    for load in LOADS:
        if load.exponent != nt.sigma:
            yield _said(f"s={Printer()(load.exponent)}", load.exponent, "s")


DEPTH = sp.Rational(2, 7)


def of_profiles(entries: Mapping[str, Entries]) -> Iterator[Line]:
    """Lengths in the words on single profiles."""
    for key, bound, near in (("gaussian", "1.50198", 0), ("gaussian.fgm", "1.2286", -1), ("gaussian.fgm", "1.8788", 1)):
        yield Line(PLACE, rf"{bound}\,s", _bound(entries[key]["d"], bound, sp.Rational(near, 2)))
    (shape,) = entries["hyperboloid"]["d"].profile.pieces
    yield _said(r"b/\tan \theta", 1 / sp.diff(shape.expr, nt.r, 2).subs(nt.r, 0))
    edge = next(x for case in entries["capped_cylinder"]["F"].cases for x in case.chain if x.has(nt.d))
    (depth,) = sp.solve(edge - nt.a, nt.d)
    yield _said("a^{2}/R", depth)


def _bound(depth: Entry, text: str, exponent: sp.Rational) -> Callable[[str], bool]:
    """The contact radius at which the depth no longer grows, to the digits printed."""
    one = depth.cases[0].expr.subs({nt.k: exponent, nt.s: 1, nt.h: 1})
    slope = sp.lambdify(nt.a, sp.diff(one, nt.a), [{master.__name__: master.numeric for master in MASTERS}, "mpmath"])

    def wrong(tex: str) -> bool:
        printed, _, unit = tex.partition(r"\,")
        with mp.workdps(DIGITS):
            half = mp.mpf(10) ** -len(printed.partition(".")[2]) / 2
            return unit != "s" or abs(mp.findroot(slope, mp.mpf(text)) - mp.mpf(printed)) > half

    return wrong
