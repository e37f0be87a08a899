"""The formulas outside the rows of the problems: definitions, rules, special functions, laws, panels, all profiles.

Each comes with the value it has to have, found without its LaTeX.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..book import front, front_rules, page
from ..entry import Entry
from ..oracle.evaluate import case_at
from ..oracle.sampling import points
from ..oracle.shape import number
from ..physics import viscoelastic
from ..physics.systems import BY_NAME, pool_of, problem
from ..print.formula import Printer
from ..profiles.loads import Load
from ..profiles.profile import Profile
from ..rows import laws
from ..rows.claims import points_of
from ..rows.row import Region, Row
from .claims import (
    CLOSE,
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
)
from .compare import worst_residual


def _point(entry: Entry, place: sp.Symbol | None, ratio: sp.Rational) -> Values:
    """A point of the last case of an entry; with a place at this share of the contact radius."""
    (point,) = points(entry.profile, entry.cases[-1].chain, 1, 23, entry.quantity.arguments)
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
    return [Line(f"rule: {one.key}", one.tex, _ruled(one, stored)) for one in front_rules.rule_rows()]


def _ruled(one: front_rules.RuleRow, stored: Stored) -> Callable[[str], bool]:
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
    """E(t), J(t) and Phi_m(t) of every law, against the functions that the engine convolves with."""
    found = []
    names = (nt.E, nt.E_1, nt.E_inf, nt.relaxation, nt.eta, nt.t_0, nt.time)
    # a misprint of what decays late shows at a time that is not late
    values: Values = {s: sp.Rational(7 + 4 * i, 9 + i) for i, s in enumerate(names)} | {nt.alpha: sp.Rational(2, 5)}
    exponent = sp.Rational(5, 3)
    with mp.workdps(WORKING):
        power = number(exponent)
    for law, text in zip(viscoelastic.LAWS, laws.laws(), strict=True):
        for (name, tex), expr in zip(text.functions().items(), (law.relaxation, law.creep, law.ramp), strict=True):
            own = stated(expr.subs(laws.EXPONENT, exponent), values, name.replace("()", "(t)"), m=power)
            found.append(own.line(f"law: {text.name}", tex))
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
