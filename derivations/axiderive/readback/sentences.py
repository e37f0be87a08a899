"""What the sentences of the book state in formulas: compared with the engine where they can be, listed where not.

A statement that is neither compared nor listed is unaccounted for, and so is
every misprint of a listed one.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
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
from .claims import DIGITS, Claim, Line
from .printed import holds, name_in_print, named
from .ranges import in_order

Entries = Mapping[str, Entry]
LISTED = {
    "definition of a name": (
        r"c_{\mathrm N}(x)=H\,|x|^k", r"c_{\mathrm N}(x)=H|x|^k", r"c_{\mathrm T}(x)=H_x\,|x|^k",
        r"c_{\mathrm T}(x)=H_x|x|^k", r"d=v\,t", r"d=vt", r"m=k^2", r"w_{\mathrm{1D}}=d-g",
        r"p=(\alpha+\beta x)/\sqrt{a^2-x^2}", r"\theta=\pi/2-\alpha", r"\varphi_0=\arccos(b/a)", r"\psi=\arcsin(a/r)",
        r"s=\sqrt{r^2-a^2}", r"\mu_{\mathrm T}=\bigl(R\,\Delta\gamma^2/(E^{*2}z_0^3)\bigr)^{1/3}", r"\sqrt{R\,d}",
        r"\frac{\mathrm dw}{\mathrm dx}", "z^k",
    ),
    "homogeneous as the case of a graded half-space": ("k=0", r"H=E^{*}", r"H_x=G^{*}"),
    "where the contact is, or the edge of it": (
        r"0\le r\le a", r"|x|\le a", "r=a", "r=0", "x=e", "a>b", "r<a", "r<c", "r>c",
        "p(r;c)=0", "t<b", "g(t)=0",
    ),
    "a place or a case that a sketch or a note points to": (
        r"F_x=\mu\,F_{\mathrm N}", "r=b", "x=b", "R_1=R_2", "k=-0.5", "k=0.5", "d+h", "|e|=a/2",
        r"4\,|e|-3\,a", "n>1",
    ),
    "a case that a number is given for": (
        r"\nu=\tfrac12", r"\nu=0.3", r"\nu=0.5", r"\nu=0", r"a=0.1\,R", r"a=0.3\,R", r"\mu_{\mathrm T}=5",
    ),
    "a number of the guide, computed in book.evidence": (r"0.3100\,p_0", r"0.4809\,a", r"p_0=1.6\,Y"),
    "a result of the work that is cited": (r"(1-2\nu)/(2-2\nu)", r"(1-\nu)\ln(3-4\nu)/(1-2\nu)"),
    "an equation that is a row beside it": ("g(a)=d", r"F_{\mathrm N}(a)=F_{\mathrm N}"),
    "the half of a symmetric field that is printed": (r"x\ge 0",),
    "a power that has a page or a name of its own": ("n=1", "n=2", "n=4", "n=6"),
    "the domain of a sequence": (r"A_j\ge 0", r"A_1 \dots  A_N \ge  0"),
    "an order of magnitude": (
        r"a \ll  R", r"a \ll  R_1", r"a \ll  R_2", r"a \ll", r"h \ll  s", r"a-b \ll  R", r"a-b \ll  R_2",
        r"\tan \theta \ll  1", r"n\,A\,a^{n-1} \ll  1", "r^2",
        r"P \sim  a^n", r"F_{\mathrm N}\sim d^m", r"F_{\mathrm N} \sim  d^{1+1/n}",
    ),
    "a ratio or an exponent by name": ("b/a", "a/r", "r/a", "a/R", "h/b", "1-r^2/a^2", "n=1, 2, 4"),
    "an axis, a legend or a case of a study": (
        r"\frac12", r"1-5\cdot10^{-13}", r"\le 5", r"\le 10^{3}", r"\le 10^{6}", r"\le 10^{9}", r"\le 10^{12}",
        r"\tfrac12", "1-10^{-3}", "1-10^{-6}", "1-10^{-12}", r"b\to 0", r"R\to \infty",
    ),
    "a condition of the derivation": (r"g' \ge  0", "g'=0"),
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


def in_front(bodies: Entries) -> Iterator[Line]:
    """Of the notation, the definitions, the special functions and the laws."""
    with mp.workdps(2 * DIGITS):
        symbols = sorted({s for suffix in MODULI for s in bodies[suffix].cases[0].expr.free_symbols}, key=str)
        values = {s: sp.Rational(7 + 2 * i, 5 + 3 * i) for i, s in enumerate(symbols)}
        values |= {nt.nu_1: sp.Rational(2, 7), nt.nu_2: sp.Rational(3, 11)}
        env = named(values)
        for suffix, texts in MODULI.items():
            modulus = evaluate(bodies[suffix].cases[0].expr, values, DIGITS)
            claim = Claim(env | {name_in_print(bodies[suffix].quantity.symbol): modulus}, 1 / modulus)
            yield from (Line(PLACE, tex, _of_both_bodies(claim)) for tex in texts)
        force, radius = mp.mpf("1.7"), mp.mpf("0.6")
        mean = Claim({"F_N": force, "a": radius}, force / (mp.pi * radius**2))
        yield mean.line(PLACE, r"F_{\mathrm N}/(\pi a^2)")
        yield from _laws()
    for tex, members in CONDITIONS.items():
        yield Line(PLACE, tex, in_order([sp.sympify(x, {x: sp.Symbol(x)}) for x in members.split()], str))


def _of_both_bodies(claim: Claim) -> Callable[[str], bool]:
    """A sum over both bodies is written out before it is read."""

    def wrong(tex: str) -> bool:
        left, summed, term = tex.partition(r"\sum_i")
        parts = [re.sub(r"_i(?![a-z])", f"_{body}", term) for body in (1, 2)] if summed else []
        plain = re.sub(r"G_(\d)", r"\\tfrac{E_\1}{2(1+\\nu_\1)}", left + "+".join(parts)) if summed else tex
        return claim.wrong(plain)

    return wrong


def _laws() -> Iterator[Line]:
    exponent, time = mp.mpf("1.75"), mp.mpf("0.8")
    law = viscoelastic.LAWS[-1]
    values = {s: sp.Rational(4 + i, 3 + 2 * i) for i, s in enumerate(sorted(law.creep.free_symbols, key=str))}
    yield Claim(named(values), evaluate(law.creep, values, DIGITS), "J").line(PLACE, r"J=(t/t_0)^\alpha/E")
    moduli = {"E()": lambda t: mp.exp(-t) + mp.mpf("0.3"), "m": exponent, "t": time}
    ramp = exponent * mp.quad(lambda x: x ** (exponent - 1) * moduli["E()"](time * (1 - x)), [0, 1])
    yield Claim(moduli, ramp, "Phi_m(t)").line(
        PLACE, r"\Phi_m(t)=\int_0^1 m\,\xi^{m-1}E\bigl(t(1-\xi)\bigr)\,\mathrm d\xi"
    )


ROUNDED = mp.mpf("0.002")
"""A number of three digits."""


def in_guide(bodies: Entries, plain: Entries, adhesive: Entries) -> Iterator[Line]:
    """Of the conventions and of the page on validity, by the elastic constants and the paraboloid."""
    with mp.workdps(2 * DIGITS):
        yield from _moduli(bodies["E_star"])
        values = {nt.R: sp.Rational(7, 4), nt.E_star: sp.Rational(5, 3), nt.dgamma: sp.Rational(3, 7)}

        def at(entry: Entry) -> Any:
            return evaluate(entry.cases[0].expr, values, DIGITS)

        env, pulled = named(values), at(adhesive["Fc"])
        yield Claim(env, pulled).line(PLACE, r"-\tfrac32\pi\Delta\gamma R")
        values |= {nt.a: at(adhesive["ac"]), nt.r: sp.S.Zero}
        known = {"mu_T": mp.cbrt(env["R"] * env["Delta gamma"] ** 2 / env["E*"] ** 2), "z_0": mp.mpf(1)}
        shift = Claim(known, at(adhesive["Dl"]), "Delta ell", ROUNDED)
        yield shift.line(PLACE, r"\Delta\ell=3.09\,\mu_{\mathrm T}\,z_0")
        force = Claim(env | {"p_0": at(plain["p"])}, at(plain["F"]))
        yield force.line(PLACE, r"\pi^3R^2p_0^3/(6E^{*2})")


def _moduli(entry: Entry) -> Iterator[Line]:
    """The contact modulus of a rigid indenter, and of two bodies of one material."""
    young, poisson, rigid = sp.Rational(7, 3), sp.Rational(2, 9), sp.Integer(10) ** (3 * DIGITS)
    cases = (
        ((young, poisson, rigid, poisson), (r"E^{*}=E/(1-\nu^2)", r"E/(1-\nu^2)", r"2G/(1-\nu)")),
        ((young, poisson, young, poisson), (r"E/(2-2\nu^2)",)),
        ((young, sp.Rational(1, 2), rigid, poisson), (r"\tfrac43 E",)),
    )
    for numbers, texts in cases:
        values = dict(zip((nt.young_1, nt.nu_1, nt.young_2, nt.nu_2), numbers, strict=True))
        modulus, ratio = (mp.mpf(x.p) / x.q for x in numbers[:2])
        env, want = (
            {"E": modulus, "nu": ratio, "G": modulus / (2 * (1 + ratio))},
            evaluate(entry.cases[0].expr, values, DIGITS),
        )
        yield from (Claim(env, want, "E*" if "=" in tex else "").line(PLACE, tex) for tex in texts)


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
    values = {nt.E_star: sp.Integer(3), nt.d: sp.Rational(2, 7), nt.a: sp.Rational(7, 5), nt.r: sp.Rational(3, 4)}
    with mp.workdps(2 * DIGITS):
        env = named(values)
        env["w_1D()"] = lambda t: env["d"] if t == env["a"] else mp.mpf(0)
        punch = Claim(env, evaluate(entries["flat_punch"]["p"].cases[0].expr, values, DIGITS))
        for tex in (r"E^{*}d/(\pi\sqrt{a^2-r^2})", r"E^{*}w_{\mathrm{1D}}(a)/(\pi\sqrt{a^2-r^2})"):
            yield punch.line(PLACE, tex)
        strip = {nt.P: sp.Rational(5, 3), nt.a: sp.Rational(7, 5), nt.x: sp.Rational(3, 4)}
        flat, known = evaluate(entries["plane.flat_punch"]["p"].cases[0].expr, strip, DIGITS), named(strip)
        within = Claim({"P": known["P"], "t": known["a"], "x": known["x"]}, flat)
        yield within.line(PLACE, r"P/(\pi\sqrt{t^2-x^2})")
        # 2/E* times the integral of r p(r)/sqrt(r^2 - x^2) over (x, a) for a pressure that goes with a power
        p_0, radius, modulus, power, x = map(mp.mpf, ("1.3", "1.7", "2.5", "0.75", "0.6"))
        wide = mp.sqrt(radius**2 - x**2)
        integral = mp.quad(lambda y: p_0 * (1 - (x * x + y * y) / radius**2) ** power, [0, wide])
        sunk = Claim({"p_0": p_0, "a": radius, "E*": modulus, "s": power, "x": x}, 2 / modulus * integral, "w_1D")
        yield sunk.line(PLACE, r"w_{\mathrm{1D}}=(p_0 a/E^{*})\,\mathrm B(\tfrac12,s+1)\,(1-x^2/a^2)^{s+1/2}")
    for load in LOADS:
        if load.exponent != nt.sigma:
            exponent = mp.mpf(load.exponent.p) / load.exponent.q
            yield Claim({}, exponent, "s").line(PLACE, f"s={Printer()(load.exponent)}")


def of_profiles(entries: Mapping[str, Entries]) -> Iterator[Line]:
    """Lengths in the words on single profiles."""
    for key, bound, near in (("gaussian", "1.50198", 0), ("gaussian.fgm", "1.2286", -1), ("gaussian.fgm", "1.8788", 1)):
        yield Line(PLACE, rf"{bound}\,s", _bound(entries[key]["d"], bound, sp.Rational(near, 2)))
    (shape,) = entries["hyperboloid"]["d"].profile.pieces
    curvature = sp.diff(shape.expr, nt.r, 2).subs(nt.r, 0)
    values = {nt.b: sp.Rational(3, 4), nt.theta: sp.Rational(2, 5)}
    with mp.workdps(2 * DIGITS):
        yield Claim(named(values), evaluate(1 / curvature, values, DIGITS)).line(PLACE, r"b/\tan \theta")
        values = {nt.a: sp.Rational(3, 4), nt.R: sp.Rational(9, 5)}
        edge = next(x for case in entries["capped_cylinder"]["F"].cases for x in case.chain if x.has(nt.d))
        depth = mp.findroot(sp.lambdify(nt.d, (edge - nt.a).subs(values), "mpmath"), mp.mpf("0.3"))
        yield Claim(named(values), depth).line(PLACE, "a^2/R")


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
