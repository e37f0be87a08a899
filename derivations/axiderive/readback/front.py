"""The formulas outside the rows of the problems, each with the value it has to have, found without its LaTeX.

They stand in front of the book (definitions, rules, special functions, laws, all profiles), in panels and in sentences.
A statement of a sentence that is neither compared nor listed is unaccounted for, and so is every misprint of a listed
one.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from importlib import import_module
from types import MappingProxyType
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..book import front, page
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluate
from ..oracle.sampling import points
from ..oracle.shape import number
from ..physics import viscoelastic
from ..physics.systems import BY_NAME, pool_of, problem
from ..print.formula import Printer
from ..profiles.loads import LOADS, Load
from ..profiles.profile import Profile
from ..rows import laws
from ..rows.claims import points_of
from ..rows.row import Region, Row
from .claims import (
    CLOSE,
    DIGITS,
    WORKING,
    Claim,
    Entries,
    Line,
    Printed,
    Stored,
    Values,
    holds,
    name_in_print,
    name_of,
    stated,
    worst_residual,
)
from .ranges import in_order


def _point(entry: Entry, place: sp.Symbol | None, ratio: sp.Rational) -> Values:
    """A point of the last case of an entry; with a place at this share of the contact radius."""
    drawn = points(entry.profile, entry.cases[-1].chain, 6, 23, entry.quantity.arguments)
    # kappa of a square is its exponent, and no misprint of one for the other would be seen there
    point = next(one for one in drawn if one.values.get(nt.n) != 2)
    return point.values | ({place: point.values[nt.a] * ratio} if place else {})


INSIDE, OUTSIDE = sp.Rational(9, 13), sp.Rational(17, 11)


def definitions(compact: Entries, complete: Entries) -> list[Line]:
    """The defining integrals, with the functions of one profile of each contact put in."""
    rows = front.definition_rows()
    whole = "Complete contact: "
    found = []
    for suffix, (label, tex, _) in zip([*front.DEFINED, *front.DEFINED[1:]], rows, strict=True):
        entries = complete if label.startswith(whole) else compact
        place, ratio = {"p": (nt.r, INSIDE), "w": (nt.r, OUTSIDE)}.get(suffix, (None, sp.S.One))
        values = _point(entries["F"], place, ratio)
        found.append(_with_functions(entries, suffix, values).line(f"definition: {label}", tex))
    return found


def _with_functions(entries: Entries, suffix: str, values: Values) -> Claim:
    """A quantity at a point, by the profile, its depth function and the sunk profile as functions."""
    with mp.workdps(WORKING):
        env = _functions(entries, values)
    return stated(case_at(entries[suffix], values).expr, values, name_of(entries[suffix]), **env)


def _functions(entries: Entries, values: Values) -> dict[str, Any]:
    env = Printed(entries, entries).environment(values)
    profile = entries["F"].profile
    shape = profile.pieces[-1].expr
    power = sp.degree(shape, nt.r) if profile.complete else None
    env["f'()"] = _shape(profile, values, 1)
    env["cuts"] = {name: [number(values[b]) for b in profile.breaks] for name in ("t", "r")}
    if power is not None:
        # a power sinks to kappa times itself
        kappa = mp.sqrt(mp.pi) * mp.gamma(mp.mpf(int(power)) / 2 + 1) / mp.gamma((mp.mpf(int(power)) + 1) / 2)
        face, slope = _shape(profile, values, 0), _shape(profile, values, 1)
        env["w_1D()"] = lambda t: env["d"] - kappa * face(t)
        env["w_1D'()"] = lambda t: -kappa * slope(t)
    return env


def _shape(profile: Profile, values: Values, order: int) -> Callable[[Any], Any]:
    """f or its derivative, from the data of the profile."""
    others = [symbol for symbol in values if symbol != nt.r]
    fixed = [number(values[symbol]) for symbol in others]
    pieces = [
        (piece.upper, sp.lambdify((nt.r, *others), sp.diff(piece.expr, nt.r, order), "mpmath"))
        for piece in profile.pieces
    ]
    return lambda r: next(f(r, *fixed) for upper, f in pieces if upper is None or r <= number(values[upper]))


SAMPLES = {
    "varphi": "0.7", "k": "0.61", "b": "0.8", "r": "0.3", "a": "1.7", "x": "0.83", "z": "0.37", "p": "1.4", "q": "0.9",
    "c": "2.3", "R": "2.1", "nu": "0.75",
}  # fmt: skip
"""Arguments at which the special functions are compared with their definitions."""


OF_DEPTH, POWER = "cone", r",\qquad m=2"
"""A contact whose force is printed as a function of the depth, and the power of the depth that it goes with."""


def rules(stored: Stored) -> list[Line]:
    """The rules for every profile, each against an entry that follows from it, in any text of its own."""
    return [Line(f"rule: {one.key}", one.tex, _ruled(one, stored)) for one in front.rule_rows()]


def _ruled(one: front.RuleRow, stored: Stored) -> Callable[[str], bool]:
    of_depth = one.suffix in ("step", "ramp")
    key = f"{OF_DEPTH}.vis" if of_depth else BY_NAME[one.system].said.subject
    entries, below = stored(key), problem(key).base
    base = {"F": stored(OF_DEPTH)["Fd"]} if of_depth else stored(below.key if below else key)
    if one.kind is None:
        return _integral(entries, one.suffix)
    kind, (first, *others) = one.kind, [entries[s] for s in entries if one.suffix in (s, s.partition("_")[0])]
    power = POWER if one.suffix == "ramp" else ""

    def wrong(tex: str) -> bool:
        own = Row(first, kind, (Region("", (tex + power,)),), also=tuple(others))
        return not worst_residual(own, entries, 1, 29, base) <= CLOSE

    return wrong


def _integral(entries: Entries, suffix: str) -> Callable[[str], bool]:
    """A defining integral with the functions of these entries put in."""
    ((_, values),) = points_of(entries[suffix], "formula", entries, 1, 23)
    # an end of the integral that is less singular leaves more digits
    values = values | {nt.k: sp.Rational(3, 5)}
    return _with_functions(entries, suffix, values).wrong


def functions() -> list[Line]:
    """The special functions: the printed integral against what mpmath says about the name, in any text of both."""
    with mp.workdps(WORKING):
        both_sides = Claim({name: mp.mpf(text) for name, text in SAMPLES.items()})
    return [
        both_sides.line(f"special function: {one['name']}", f"{one['name']}={one['definition']}")
        for one in front.master_rows()
    ]


def laws_of_materials() -> list[Line]:
    """What every law says, against the functions that the engine convolves with and the times of the way back."""
    found = []
    names = (nt.E, nt.E_1, nt.E_inf, nt.relaxation, nt.eta, nt.t_0, nt.time)
    # a misprint of what decays late shows at a time that is not late
    values: Values = {s: sp.Rational(7 + 4 * i, 9 + i) for i, s in enumerate(names)} | {nt.alpha: sp.Rational(2, 5)}
    back = {nt.t_1: "3/7", nt.t_m: "8/5", nt.t_h: "19/10", nt.t_c: "13/4", nt.v: "9/4", nt.v_2: "5/7"}
    values |= {s: sp.Rational(text) for s, text in back.items()}
    exponent = sp.Rational(5, 3)
    with mp.workdps(WORKING):
        power = number(exponent)
    for law, text in zip(viscoelastic.LAWS, laws.laws(), strict=True):
        for name, expr in laws.expressions(law).items():
            own = stated(expr.subs(laws.EXPONENT, exponent), values, name, m=power)
            found.append(own.line(f"law: {text.name}", text.texts[name]))
    return found


def panel(profile_id: str, profile: Profile, entries: Entries) -> list[Line]:
    """The shape or the pressure, the shorthands and the slope of a profile."""
    if isinstance(profile, Load):
        ((_, content),) = [line for line in page.panel(profile, {}) if line[0] == "Pressure"]
        pressure = nt.p_0 * (1 - nt.r**2 / nt.a**2) ** profile.exponent
        ((tex, condition),) = _stated("p(r)", content)
        return [_at(f"{profile_id}: p", tex, _panel_point(profile, nt.r, True), pressure, "p(r)", condition)]
    place, printer = pool_of(profile_id).place, Printer()
    found = []
    words = page.shape_tex(profile, str(place)), page.derivation(profile_id, profile, entries)
    for order, (name, text) in enumerate(zip(("f", "f'"), words, strict=True)):
        texts = _stated(f"{name}({place})", text)
        for piece, (tex, condition) in zip(profile.pieces, texts, strict=True) if texts or not order else ():
            values, expr = _panel_point(profile, place, piece is profile.pieces[-1]), sp.diff(piece.expr, place, order)
            found.append(_at(f"{profile_id}: {name}", tex, values, expr, f"{name}({place})", condition))
    for symbol, expr in profile.abbreviations:
        values = {s: v for s, v in _panel_point(profile, place, True).items() if s in expr.free_symbols}
        values |= {s: sp.Rational(2, 7) for s in expr.free_symbols - set(values)}
        tex = f"{printer(symbol)}={printer(expr)}"
        found.append(_at(f"{profile_id}: {symbol}", tex, values, expr, name_in_print(symbol)))
    return found


def _stated(left: str, words: str) -> list[tuple[str, str]]:
    """The formulas in words with this left side, and the range in which each holds."""
    found: list[tuple[str, str]] = re.findall(
        rf"\$(?:\\displaystyle )?({re.escape(left)}=.*?)\$(?: for \$(.*?)\$)?", words
    )
    return found


def _panel_point(profile: Profile, place: sp.Symbol, last: bool) -> Values:
    """A point inside of a piece of the profile."""
    chain = (*profile.breaks[-1:], place, nt.a) if last else (place, *profile.breaks[:1])
    (point,) = points(profile, chain, 1, 31, (place, nt.a))
    return point.values


def _at(place: str, tex: str, values: Values, expr: sp.Expr, name: str, condition: str = "") -> Line:
    own = stated(expr, values, name)
    if condition and not holds(condition, own.env):
        message = f"{place}: {condition} does not hold where the piece does"
        raise LookupError(message)
    return own.line(place, tex)


def master_table(profile_id: str, entries: Entries) -> list[Line]:
    """Depth and force in the table of all profiles."""
    found = []
    for name, cell in front.master_row(entries).items():
        tex = re.fullmatch(r"\$\\displaystyle (.*)\$", cell)
        if tex is None:
            continue
        entry = entries["P" if name == "F" and "P" in entries else name]
        values = _point(entry, None, sp.S.One)
        own = stated(case_at(entry, values).expr, values, **Printed(entries, entries).kappa)
        found.append(own.line(f"table of profiles: {profile_id}", tex[1]))
    return found


LISTED = {
    "definition of a name": (
        r"c_{\mathrm N}(x)=H|x|^{k}", r"c_{\mathrm N}(x)=H|x|^k", r"c_{\mathrm T}(x)=H_x|x|^{k}",
        r"c_{\mathrm T}(x)=H_x|x|^k", "d=v t", r"d=vt", r"m=k^2", r"w_{\mathrm{1D}}=d-g",
        r"p=(\alpha+\beta x)/\sqrt{a^2-x^2}", r"\theta=\pi/2-\alpha", r"\varphi_0=\arccos(b/a)", r"\psi=\arcsin(a/r)",
        "g'=t^{n-1}",
        r"s=\sqrt{r^2-a^2}", r"\mu_{\mathrm T}=\bigl(R\,\Delta\gamma^2/(E^{*2}z_0^3)\bigr)^{1/3}",
        r"\sqrt{R\,d}", r"\frac{\mathrm dw}{\mathrm dx}", "z^{k}",
    ),
    "homogeneous as the case of a graded half-space": ("k=0", r"H=E^{*}", r"H_x=G^{*}"),
    "where the contact is, or the edge of it": (
        r"0\le r\le a", r"|x|\le a", "r=a", "r=0", "x=e", "a>b", "r<a", "r<c", "r>c", "a<r<c",
        "p(r;c)=0", "t<b", "g(t)=0", "q(a)=0",
    ),
    "a place or a case that a sketch or a note points to": (
        r"F_x=\mu F_{\mathrm N}", "r=b", "x=b", "R_1=R_2", "k=-0.5", "k=0.5", "d+h", "|e|=a/2",
        r"4 \lvert e\rvert-3 a", r"\lvert e\rvert=a/2", "n>1",
    ),
    "a case that a number is given for": (
        r"\nu=\tfrac12", r"\nu=0.3", r"\mu=0.3", r"\nu=0.5", r"\nu=0", r"a=0.1\,R", r"a=0.3\,R", r"\mu_{\mathrm T}=5",
        *(rf"\nu={ratio}" for ratio in (0.1, 0.2, 0.4, 0.45)),
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
        r"P \sim a^{n}", r"F_{\mathrm N}\sim d^m", r"F_{\mathrm N} \sim d^{1+1/n}", "a^{2}/R^{2}",
    ),
    "a ratio or an exponent by name": ("b/a", "a/r", "r/a", "a/R", "a/h_0", "h/b", "1-r^2/a^2", "1-r^{2}/a^{2}"),
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
    yield _said(r"\bar p=F_{\mathrm N}/(\pi a^{2})", nt.F / (sp.pi * nt.a**2), "bar p")
    yield _said(r"J=(t/t_0)^{\alpha}/E", viscoelastic.LAWS[-1].creep, "J")
    exponent, time = mp.mpf("1.75"), mp.mpf("0.8")
    with mp.workdps(2 * DIGITS):
        names = {"E()": lambda t: mp.exp(-t) + mp.mpf("0.3"), "m": exponent, "t": time}
        ramp = exponent * mp.quad(lambda x: x ** (exponent - 1) * names["E()"](time * (1 - x)), [0, 1])
    yield Claim(names, ramp, "Phi_m(t)").line(
        PLACE, r"\Phi_m(t)=\int_0^1 m\,\xi^{m-1}E\bigl(t(1-\xi)\bigr)\,\mathrm d\xi"
    )
    yield from _way_back()
    for tex, members in CONDITIONS.items():
        yield Line(PLACE, tex, in_order([sp.sympify(x, {x: sp.Symbol(x)}) for x in members.split()], str))


def _way_back() -> Iterator[Line]:
    """Of a contact that shrinks, for a modulus that fades and a force that goes with a power of the depth."""

    def fades(s: Any) -> Any:
        return mp.exp(-s) + mp.mpf("0.3")

    def memory(s: Any) -> Any:
        return mp.mpf("0.3") * s - mp.expm1(-s)

    with mp.workdps(2 * DIGITS):
        t, t_1, t_m, t_h, v, m = map(mp.mpf, ("1.7", "0.6", "1.3", "1.5", "0.9", "1.75"))
        known = {"E()": fades, "I()": memory, "t": t, "t_1": t_1, "t_m": t_m, "v": v, "m": m}
        known |= {"t_h": t_h, "E*": mp.mpf("1.4")}
        known["v_2"] = v * mp.quad(lambda s: fades(t - s), [t_1, t_m]) / mp.quad(lambda s: fades(t - s), [t_h, t])
        known["Psi_m"] = mp.quad(lambda x: m * x ** (m - 1) * fades(t - t_1 * x), [0, 1])
        known["F_N()"] = lambda d: known["E*"] * mp.mpf("0.7") * d**m
        force = mp.quad(lambda s: fades(t - s) * mp.mpf("0.7") * m * v**m * s ** (m - 1), [0, t_1])
        # the profile with this force, by dF_el = 2 E* a dd
        known["g()"] = lambda x: (2 * x / (mp.mpf("0.7") * m)) ** (1 / (m - 1))
        known["a"] = mp.mpf("0.7") * m * (v * t_1) ** (m - 1) / 2
        summed = memory(t)
        creeping = {"alpha": mp.mpf("0.4"), "t_m": t_m, "v": v, "v_2": known["v_2"]}
        power, ratio = 1 - creeping["alpha"], known["v_2"] / v
        ended = mp.findroot(lambda t: t**power - (1 + ratio) * (t - t_m) ** power, 2 * t_m)
    yield Claim(known, summed, "I(t)").line(PLACE, r"I(t)=\int_0^t E(s)\,\mathrm ds")
    yield _said(r"I(t)=Et+\eta", viscoelastic.LAWS[1].memory, "I(t)")
    yield Claim(known).line(PLACE, r"I(t-t_1)=I(t-t_{\mathrm m})+(v_2/v)\,I(t-t_{\mathrm h})")
    yield Claim(known, known["Psi_m"], "Psi_m").line(PLACE, r"\Psi_m=\int_0^1 m\,\xi^{m-1}E(t-t_1\xi)\,\mathrm d\xi")
    yield Claim(known, force).line(PLACE, r"\Psi_m F_{\mathrm N}(v t_1)/E^{*}")
    yield Claim(known, force).line(PLACE, r"2v\int_0^a\bigl[I(t-g(x)/v)-I(t-t_1)\bigr]\,\mathrm dx")
    yield Claim(known).line(PLACE, "g(a)=vt_1")
    tex = r"t_{\mathrm c}=t_{\mathrm m}+t_{\mathrm m}/\bigl[(1+v_2/v)^{1/(1-\alpha)}-1\bigr]"
    yield Claim(creeping, ended, "t_c").line(PLACE, tex)


def _of_both_bodies(wrong: Callable[[str], bool]) -> Callable[[str], bool]:
    """A sum over both bodies is written out before it is read."""

    def also_summed(tex: str) -> bool:
        left, summed, term = tex.partition(r"\sum_i")
        parts = [re.sub(r"_i(?![a-z])", f"_{body}", term) for body in (1, 2)] if summed else []
        return wrong(re.sub(r"G_(\d)", r"\\tfrac{E_\1}{2(1+\\nu_\1)}", left + "+".join(parts)) if summed else tex)

    return also_summed


ROUNDED = mp.mpf("0.002")
"""A number of three digits."""


def stresses() -> list[Line]:
    """What the numbers below the surface say, by the functions of the package at numbers drawn once."""
    fields = import_module("axicontact._runtime.subsurface.stresses")
    draw = random.Random(37)
    s, d = [[draw.uniform(0.2, 2.0) for _ in range(4)] for _ in range(2)]
    known = {name: draw.uniform(0.2, 2.0) for name in ("r", "z", "W", "varphi")} | {"nu": 0.29, "E*": 1.7, "mu": 0.31}
    # equilibrium, by which the functions take some of their sums
    slopes = [known["z"] * x / known["r"] for x in s[1:3]]
    d[2], d[3] = 2 * slopes[0] - d[0], 4 * slopes[1] - d[1]
    pressure, half = [s[0], (s[0] + s[2]) / 2, s[0] + d[0], s[0] - slopes[0], d[1]], known["r"] * (s[0] + s[2]) / 2
    friction = [s[1], (s[1] + s[3]) / 2, slopes[1], d[1], d[2], s[0] - slopes[0]]
    scale, nu = known["E*"] / math.pi, known["nu"]
    pressed = fields.Stress(*fields.normal_stress(pressure, nu, scale))
    sliding = fields.SlidingStress(*fields.frictional_stress(friction, known["varphi"], nu, known["mu"] * scale))
    moved = fields.Displacement(*fields.normal_displacement([*s[:2], half, known["W"]], known["z"], nu))
    names = {f"{letter}_{i}": value for letter, row in (("S", s), ("D", d)) for i, value in enumerate(row)}
    found = []
    for (title, _, rows), own in zip(front.stress_rows(), (pressed, moved, sliding), strict=True):
        parts = {f"{x}_{name}": value for name, value in own._asdict().items() for x in ("u", "sigma", "tau")}
        env = {name: mp.mpf(float(value)) for name, value in (known | names | parts).items()}
        found += [Claim(env, close=FLOATS).line(f"{title}: {left}", tex) for ((left, _, tex),) in rows]
    return found


FLOATS = mp.mpf(10) ** -12
"""What is compared with functions in double precision agrees to twelve digits or it does not agree."""


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
