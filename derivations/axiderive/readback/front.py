"""The formulas outside the rows of the problems: definitions, rules, special functions, laws, panels, all profiles.

Each comes with the value it has to have, found without its LaTeX.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..book import front, front_rules, page
from ..book import page as panels
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluate, holds
from ..oracle.sampling import points
from ..oracle.shape import number
from ..physics import viscoelastic
from ..physics.systems import pool_of, problem
from ..print.formula import Printer
from ..profiles.loads import Load
from ..profiles.profile import Profile
from ..rows import laws
from ..rows.points import points_of
from ..rows.row import Region, Row
from .compare import DIGITS, difference, worst_residual
from .grammar import read
from .meaning import environment
from .printed import NORMAL, Printed, bound, name_in_print, named
from .printed import holds as in_range

Entries = Mapping[str, Entry]
Values = dict[Any, Any]
WORKING = 60
"""An integrand that is infinite like a root at its end leaves half of them."""


@dataclass(frozen=True)
class Reading:
    """A formula of the book, and how far any text in its place is from what it has to say."""

    place: str
    tex: str
    residual: Callable[[str], Any]

    def worst(self) -> Any:
        """How far the formula is from what it has to say, as it is printed."""
        return self.residual(self.tex)


def against(env: Mapping[str, Any], want: Any, name: str = "") -> Callable[[str], Any]:
    """Every member of a statement against a value, the quantity on its left by name; a lone term has no left side."""

    def residual(tex: str) -> Any:
        with mp.workdps(WORKING):
            (first, *definitions) = read(tex)
            members = first.members
            if bool(name) != (len(members) > 1):
                message = f"{tex} is not of the form {name or 'value'} = value"
                raise SyntaxError(message)
            known = environment(definitions, env)
            own = bound(name, want, known) if name else known
            return max(difference(member(known if i else own), want) for i, member in enumerate(members))

    return residual


def _point(entry: Entry, place: sp.Symbol | None, ratio: sp.Rational) -> Values:
    """A point of the last case of an entry; with a place at this share of the contact radius."""
    (point,) = points(entry.profile, entry.cases[-1].chain, 1, 23, entry.quantity.arguments)
    return point.values | ({place: point.values[nt.a] * ratio} if place else {})


INSIDE, OUTSIDE = sp.Rational(9, 13), sp.Rational(17, 11)


def definitions(compact: Entries, complete: Entries) -> list[Reading]:
    """The defining integrals, with the functions of one profile of each contact put in."""
    rows = front.definition_rows()
    whole = "Complete contact: "
    found = []
    for suffix, (label, tex, _) in zip([*front.DEFINED, *front.DEFINED[1:]], rows, strict=True):
        entries = complete if label.startswith(whole) else compact
        place, ratio = {"p": (nt.r, INSIDE), "w": (nt.r, OUTSIDE)}.get(suffix, (None, sp.S.One))
        values = _point(entries["F"], place, ratio)
        want = evaluate(case_at(entries[suffix], values).expr, values, DIGITS)
        with mp.workdps(WORKING):
            env = _with_functions(entries, values)
        found.append(Reading(f"definition: {label}", tex, against(env, want, NORMAL[suffix])))
    return found


def _with_functions(entries: Entries, values: Values) -> dict[str, Any]:
    """The names of a point, with the profile, its depth function and the sunk profile as functions."""
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


SUBJECTS = {
    "normal": "rounded_punch", "adhesive": "truncated_paraboloid.adh", "tangential": "truncated_paraboloid.tan",
    "viscoelastic": "sphere.vis", "graded.normal": "quartic.fgm", "graded.adhesive": "paraboloid.fgm.adh",
    "graded.tangential": "paraboloid.fgm.tan",
}  # fmt: skip
"""Problems whose entries the rules are compared with: roots where an equation is solved, no integrals in fields."""
OF_DEPTH, POWER = "cone", r",\qquad m=2"
"""A contact whose force is printed as a function of the depth, and the power of the depth that it goes with."""


def rules(stored: Callable[[str], Entries]) -> list[Reading]:
    """The rules for every profile, each against an entry that follows from it, in any text of its own."""
    return [Reading(f"rule: {one.key}", one.tex, _ruled(one, stored)) for one in front_rules.rule_rows()]


def _ruled(one: front_rules.RuleRow, stored: Callable[[str], Entries]) -> Callable[[str], Any]:
    of_depth = one.suffix in ("step", "ramp")
    key = f"{OF_DEPTH}.vis" if of_depth else SUBJECTS[one.system]
    entries, below = stored(key), problem(key).base
    base = {"F": stored(OF_DEPTH)["Fd"]} if of_depth else stored(below.key if below else key)
    if one.kind is None:
        return _integral(entries, one.suffix)
    kind, (first, *others) = one.kind, [entries[s] for s in entries if one.suffix in (s, s.partition("_")[0])]
    power = POWER if one.suffix == "ramp" else ""

    def residual(tex: str) -> Any:
        return worst_residual(Row(first, kind, (Region("", (tex + power,)),), also=tuple(others)), entries, 1, 29, base)

    return residual


def _integral(entries: Entries, suffix: str) -> Callable[[str], Any]:
    """A defining integral with the functions of these entries put in."""
    ((case, values),) = points_of(entries[suffix], "formula", entries, 1, 23)
    # an end of the integral that is less singular leaves more digits
    values = values | {nt.k: sp.Rational(3, 5)}
    want = evaluate(case.expr, values, DIGITS)
    with mp.workdps(WORKING):
        return against(_with_functions(entries, values), want, NORMAL[suffix])


def functions() -> list[Reading]:
    """The special functions: the printed integral against what mpmath says about the name, in any text of both."""
    return [
        Reading(f"special function: {one['name']}", f"{one['name']}={one['definition']}", _both_sides)
        for one in front.master_rows()
    ]


def _both_sides(tex: str) -> Any:
    with mp.workdps(WORKING):
        env = {name: mp.mpf(text) for name, text in SAMPLES.items()}
        left, right = read(tex)[0].members
        return difference(left(env), right(env))


def laws_of_materials() -> list[Reading]:
    """E(t), J(t) and Phi_m(t) of every law, against the functions that the engine convolves with."""
    found = []
    names = (nt.E, nt.E_1, nt.E_inf, nt.relaxation, nt.eta, nt.t_0, nt.time)
    values: Values = {s: sp.Rational(7 + 4 * i, 9 + i) for i, s in enumerate(names)} | {nt.alpha: sp.Rational(2, 5)}
    exponent = sp.Rational(5, 3)
    with mp.workdps(WORKING):
        env = named(values) | {"m": number(exponent)}
    for law, text in zip(viscoelastic.LAWS, laws.laws(), strict=True):
        for (name, tex), expr in zip(text.functions().items(), (law.relaxation, law.creep, law.ramp), strict=True):
            want = evaluate(expr.subs(laws.EXPONENT, exponent), values, DIGITS)
            found.append(Reading(f"law: {text.name}", tex, against(env, want, name.replace("()", "(t)"))))
        # what is used early holds at any time, and at this one a misprint of what is used late shows
    return found


def panel(profile_id: str, profile: Profile, entries: Entries) -> list[Reading]:
    """The shape or the pressure, the shorthands and the slope of a profile."""
    if isinstance(profile, Load):
        return [_pressure(profile_id, profile)]
    place = pool_of(profile_id).place
    found = []
    texts = re.findall(
        r"\$(?:\\displaystyle )?(f\([rx]\)=.*?)\$(?: for \$(.*?)\$)?", panels.shape_tex(profile, str(place))
    )
    for piece, (tex, condition) in zip(profile.pieces, texts, strict=True):
        values = _panel_point(profile, place, piece is profile.pieces[-1])
        found.append(_at(f"{profile_id}.f", tex, values, piece.expr, f"f({place})", condition))
    for symbol, expr in profile.abbreviations:
        values = {s: v for s, v in _panel_point(profile, place, True).items() if s in expr.free_symbols}
        values |= {s: sp.Rational(2, 7) for s in expr.free_symbols - set(values)}
        printer = Printer()
        found.append(
            _at(f"{profile_id}: {symbol}", f"{printer(symbol)}={printer(expr)}", values, expr, name_in_print(symbol))
        )
    words = page.derivation(profile_id, profile, entries)
    slopes = re.findall(r"\$(f'\(r\)=.*?)\$(?: for \$(.*?)\$)?", words)
    for piece, (tex, condition) in zip(profile.pieces, slopes, strict=True) if slopes else ():
        values = _panel_point(profile, place, piece is profile.pieces[-1])
        found.append(_at(f"{profile_id}: f'", tex, values, sp.diff(piece.expr, nt.r), "f'(r)", condition))
    return found


def _pressure(profile_id: str, profile: Load) -> Reading:
    ((_, content),) = [line for line in panels.panel(profile, {}) if line[0] == "Pressure"]
    tex = re.search(r"(p\(r\)=.*?)\$ for \$r<a\$", content)
    assert tex
    values = _panel_point(profile, nt.r, True)
    return _at(f"{profile_id}: p", tex[1], values, nt.p_0 * (1 - nt.r**2 / nt.a**2) ** profile.exponent, "p(r)")


def _panel_point(profile: Profile, place: sp.Symbol, last: bool) -> Values:
    """A point inside of a piece of the profile."""
    chain = (*profile.breaks[-1:], place, nt.a) if last else (place, *profile.breaks[:1])
    (point,) = points(profile, chain, 1, 31, (place, nt.a))
    return point.values


def _at(place: str, tex: str, values: Values, expr: sp.Expr, name: str, condition: str = "") -> Reading:
    with mp.workdps(WORKING):
        env = named(values)
        if condition and not in_range(condition, env):
            message = f"{place}: {condition} does not hold where the piece does"
            raise LookupError(message)
    want = evaluate(expr, values, DIGITS)
    return Reading(place, tex, against(env, want, name))


def master_table(profile_id: str, entries: Entries) -> list[Reading]:
    """Depth and force in the table of all profiles."""
    found = []
    for name, cell in front.master_row(entries).items():
        tex = re.fullmatch(r"\$\\displaystyle (.*)\$", cell)
        if tex is None:
            continue
        entry = entries["P" if name == "F" and "P" in entries else name]
        case = entry.cases[-1]
        (point,) = points(entry.profile, case.chain, 1, 37, entry.quantity.arguments)
        assert holds(case, point.values)
        with mp.workdps(WORKING):
            env = Printed(entries, entries).environment(point.values)
        want = evaluate(case.expr, point.values, DIGITS)
        found.append(Reading(f"table of profiles: {profile_id}", tex[1], against(env, want)))
    return found
