"""What a printed text has to say, found without its LaTeX, the one comparison of the two, and with it every row.

The printed rows of a problem are functions here: g, F_N, p and w as a reader of the book would evaluate them.
"""

from __future__ import annotations

import itertools
import operator
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import case_at, decades, evaluate, evaluated
from ..oracle.shape import coefficient, number, numeric_symbols
from ..physics.systems import of
from ..rows import laws
from ..rows.blocks import texts_of
from ..rows.claims import Exact, claim, points_of
from ..rows.laws import LawText
from ..rows.row import Region, Row, kappa_row, row
from .grammar import read
from .meaning import Environment, Node, environment
from .source import GAP, OPENING, Further

Entries = Mapping[str, Entry]
Stored = Callable[[str], Entries]
"""The entries of a problem by its key."""
Values = dict[Any, Any]
Function = Callable[..., Any]
SIGNS = {"<": operator.lt, r"\le": operator.le, ">": operator.gt, r"\ge": operator.ge}
WORKING = 60
"""Working digits; an integrand that is infinite like a root at its end leaves half of them."""
DIGITS = 30
"""Of the values that are compared with."""
CLOSE = mp.mpf(10) ** -20
"""A statement agrees with the engine to twenty digits or it does not agree."""


@dataclass(frozen=True)
class Line:
    """A formula, number or phrase in print, and whether any text in its place is wrong."""

    place: str
    tex: str
    wrong: Callable[[str], bool]


@dataclass(frozen=True)
class Claim:
    """What a formula has to say where names have these values."""

    env: Environment
    want: Any = None
    """The value of every member, or one for each; None of an equation, whose members are equal."""
    name: str = ""
    """What stands on the left as the grammar reads it, p(r); the members behind it must do without its value."""
    close: Any = CLOSE

    def residual(self, tex: str) -> Any:
        """The largest relative difference of a member.

        Raises
        ------
        SyntaxError, LookupError
            If the text cannot be read, uses what nothing defines, or has no left side where one is wanted.
        """
        first, *definitions = read(tex)
        env = environment(definitions, self.env)
        members = first.members
        if len(members) == 1 and (self.name or self.want is None):
            message = f"{tex} is not of the form {self.name or 'left'} = value"
            raise SyntaxError(message)
        if self.want is None:
            value = members[-1](env)
            return max(difference(member(env), value) for member in members[:-1])
        own = bound(self.name, self.want, env) if self.name else env
        wanted = self.want if isinstance(self.want, tuple) else (self.want,) * len(members)
        found = (member(env if i else own) for i, member in enumerate(members))
        return max(difference(value, want) for value, want in zip(found, wanted, strict=True))

    def wrong(self, tex: str) -> bool:
        """Whether a text says something else; a value that is no number is none of the right ones."""
        with mp.workdps(WORKING):
            return not self.residual(tex) <= self.close

    def line(self, place: str, tex: str) -> Line:
        """The text in print with its claim."""
        return Line(place, tex, self.wrong)


def stated(expr: sp.Expr, values: Values, name: str = "", **names: Any) -> Claim:
    """That a text has the value of an expression at a point, whose symbols it may use, and further names."""
    with mp.workdps(WORKING):
        return Claim({**named(values), **names}, evaluate(expr, values, DIGITS), name)


def difference(got: Any, want: Any) -> Any:
    """Relative difference of two values; absolute where the wanted one is zero."""
    return abs(got - want) / abs(want) if want else abs(got)


def bound(name: str, value: Any, env: Mapping[str, Any]) -> dict[str, Any]:
    """The names of a point with one of them, or a function at one argument, bound to a value."""
    function, _, argument = name.partition("(")
    if not argument:
        return {**env, name: value}
    return {**env, f"{function}()": _at(name, value, env[argument.rstrip(")")])}


def _at(name: str, value: Any, place: Any) -> Callable[[Any], Any]:
    """A function that is known at one place only."""

    def known(argument: Any) -> Any:
        if argument != place:
            message = f"the row states {name}, and not its value at {argument}"
            raise LookupError(message)
        return value

    return known


class Printed:
    """The rows of a problem, and of the normal contact on the same medium that its rules refer to."""

    def __init__(self, entries: Mapping[str, Entry], base: Mapping[str, Entry]) -> None:
        self.entries, self.base = entries, base
        self.profile = next(iter(base.values())).profile
        self.kappa = _kappa(tuple(base.values()))

    def environment(self, values: Values) -> dict[str, Any]:
        """Every name that a row may use: symbols, kappa, and the functions of other rows."""
        env: dict[str, Any] = named(values) | self.kappa
        tip = number(values[self.profile.breaks[0]]) if self.profile.truncated else None
        env |= {
            "g()": self._of_radius("d", env, tip),
            "F_N()": self._of_radius("F", env, tip),
            "P()": self._of_radius("P", env, tip),
            "p()": self._field("p", env),
            "w()": self._field("w", env),
            "cuts": self._cuts(values),
        }
        env["g'()"] = lambda radius: mp.diff(env["g()"], radius)
        if "Dl" in self.entries:
            env |= {
                "d_adh()": self._of_radius("d", env, tip, self.entries),
                "F_adh()": self._of_radius("F", env, tip, self.entries),
                "Delta ell": Node(lambda known: self.at("Dl", known, self.entries)),
            }
        return env

    def at(self, suffix: str, env: Environment, entries: Mapping[str, Entry] | None = None) -> Any:
        """A printed row of the normal contact, or of other entries, where its names have these values."""
        one = row((self.base if entries is None else entries)[suffix])
        region = holding(one, env) if one.kind == "formula" else one.regions[0]
        return value(region.tex, env)

    def _of_radius(
        self, suffix: str, env: Environment, tip: Any, entries: Mapping[str, Entry] | None = None
    ) -> Function:
        """A quantity at another radius; a contact within the flat tip carries nothing while it is not pressed in."""

        def value(radius: Any) -> Any:
            if tip is not None and radius <= tip:
                return mp.mpf(0)
            # a quadrature that is split at a break may end on it, where no printed range holds
            beyond = radius * (1 + mp.eps) if radius in env["cuts"].get("t", ()) else radius
            return self.at(suffix, {**env, "a": beyond}, entries)

        return value

    def _field(self, suffix: str, env: Environment) -> Function:
        def value(place: Any, radius: Any = None) -> Any:
            radius = env["a"] if radius is None else radius
            if suffix == "p" and place > radius:
                return mp.mpf(0)
            return self.at(suffix, {**env, "a": radius, "r": place})

        return value

    def _cuts(self, values: Values) -> dict[str, list[Any]]:
        """Where the integrals of the rules cross a break of the profile."""
        breaks = [number(values[b]) for b in self.profile.breaks]
        if nt.r not in values:
            return {"t": breaks}
        radius, power = number(values[nt.r]), (1 + number(values.get(nt.k, 0))) / 2
        return {
            "u": [(b * b - radius * radius) ** power for b in breaks if b > radius],
            "psi": [mp.asin(b / radius) for b in breaks if b < radius],
        }


def value(tex: str, env: Environment) -> Any:
    """What a formula gives where its names have these values: its last member, with the definitions behind it."""
    first, *definitions = read(tex)
    return first.members[-1](environment(definitions, env))


def functions_of(law: LawText, env: Environment) -> dict[str, Callable[[Any], Any]]:
    """E(t), J(t) and Phi_m(t) of a viscoelastic law as they are printed."""

    def function(text: str) -> Callable[[Any], Any]:
        return lambda t: value(text, {**env, "t": t})

    return {name: function(text) for name, text in law.functions().items()}


@lru_cache(maxsize=256)
def _kappa(entries: tuple[Entry, ...]) -> dict[str, Any]:
    text = kappa_row(entries)
    return environment(read(text), {}) if text else {}


def holding(one: Row, env: Environment) -> Region:
    """The one region whose printed range contains the point."""
    found = [region for region in one.regions if holds(region.condition, env)]
    if len(found) != 1:
        message = f"{one.key}: {len(found)} printed ranges hold at one point: {[region.condition for region in found]}"
        raise LookupError(message)
    return found[0]


def holds(condition: str, env: Environment) -> bool:
    """Whether a printed range, chains of < and <= separated by commas, contains the point; r <= r is none."""
    for chain in filter(None, condition.split(r",\; ")):
        parts = re.split(r"([<>]|\\[lg]e(?![a-z]))", chain)
        members = [read(part)[0].members[0](env) for part in parts[::2]]
        kept = [SIGNS[sign](*pair) for sign, pair in zip(parts[1::2], itertools.pairwise(members), strict=True)]
        if not all(kept) or any(x.strip() == y.strip() for x, y in itertools.pairwise(parts[::2])):
            return False
    return True


def named(values: Values) -> dict[str, Any]:
    """The values under the names their symbols have in print."""
    env: dict[str, Any] = {name_in_print(s): number(values[s]) for s in numeric_symbols(values) if nt.known(s.name)}
    if nt.N in values:
        env["A_j"] = [number(values[coefficient(i)]) for i in range(1, int(values[nt.N]) + 1)]
    if nt.a_c in values:
        env |= {"a_c": number(values[nt.a_c]), "a_m": number(values[nt.a_c])}
    return env


def name_in_print(symbol: sp.Symbol) -> str:
    """The name under which the reader finds a symbol, read from its LaTeX."""
    return read(nt.describe(symbol).latex)[0].members[0].name


OTHERWISE = {"u": "u", "us": "u_s", "dmin": "d_min", "Fmin": "F_min", "Pmin": "P_min"}
"""Names of quantities in print that are neither their symbol nor that at a place."""


def name_of(entry: Entry) -> str:
    """The quantity of an entry as the grammar reads its name, with its argument in brackets: p(r)."""
    own, physics = entry.quantity, of(entry).physics
    name = OTHERWISE.get(own.suffix) or name_in_print(own.symbol)
    if own.control:
        return f"{name.partition('_')[0]}_{own.suffix[-1]}"
    argument = own.arguments[0] if own.arguments else None
    if marked := re.match(r"\w_\{\\mathrm\{(\w+)\}\}\(", own.left):
        return f"{name.partition('_')[0]}_{marked[1]}({argument})"
    if f"({argument})" in own.left and argument in (nt.r, nt.x):
        return f"{name}({argument})"
    return f"{name}(t)" if physics.laws and own.symbol == nt.F else name


# every row against the entries it was printed from

INTEGRATING = 38
"""Working digits of a row that is an integral, or refers to one."""


def worst_residual(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Any:
    """Largest relative difference between the printed row and its entry over random points of every case.

    `base` are the entries of the normal contact on the same medium, which the rules refer to.

    Raises
    ------
    SyntaxError, KeyError
        If the source cannot be read, or uses what it does not define.
    """
    return max(residuals(one, entries, count, seed, base))


def residuals(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Iterator[Any]:
    """The relative differences one after the other; of a row of several those of the rows that it stands for."""
    base = entries if base is None else base
    for part, text in zip(one.parts, texts_of(one.regions[0].tex), strict=True) if one.parts else ():
        own = replace(part, regions=(replace(part.regions[0], lines=(text,)),))
        yield from residuals(own, entries, count, seed, base)
    if one.parts:
        return
    printed = Printed(entries, base)
    for entry in (one.entry, *one.also):
        for case, values in points_of(entry, one.kind, entries, count, seed):
            # a displacement far outside leaves a^7/r of terms of the size of r^5 a
            with mp.workdps(INTEGRATING if integrates(one, base) else WORKING + 10 * decades(values)):
                said, known = claim(one, entry, case, entries, base), dict(values)
                for symbol, exact in said.given:
                    known[symbol] = value_of(exact, known, DIGITS + 15)
                env = _environment(one, entry, printed, known)
                want = None if said.value is None else value_of(said.value, known)
                name = name_of(one.entry) if want is not None and not isinstance(want, tuple) else ""
                yield Claim(env, want, name).residual(holding(one, env).tex)


def integrates(one: Row, base: Entries) -> bool:
    """Whether reading the row back takes a quadrature, of its own or in a row that it refers to."""
    needed = {"p": "p", "tau": "p", "w": "w"}.get(one.suffix)
    rows = [one, row(base[needed])] if needed and needed in base else [one]
    return any(r"\int" in region.tex for own in rows for region in own.regions)


def value_of(exact: Exact, values: Values, digits: int = DIGITS) -> Any:
    """The value at a point: integrals by quadrature, all else to these digits; of an equation that of each side."""
    expr = case_at(exact, values).expr if isinstance(exact, Entry) else exact
    if isinstance(expr, sp.Equality):
        return tuple(value_of(side, values, digits) for side in expr.args)
    return evaluated(expr, values) if expr.has(sp.Integral) else evaluate(expr, values, digits)


def _environment(one: Row, entry: Entry, printed: Printed, values: Values) -> dict[str, Any]:
    """The names a row may use: of the radii of pull-off that of its own control, and the functions of a law."""
    env, physics = printed.environment(values), of(entry).physics
    if entry.quantity.control:
        env.pop({"c": "a_m", "m": "a_c"}[entry.suffix[-1]], None)
    if physics.laws:
        if "Fd" not in printed.base:
            env["F_N()"] = lambda depth, env=dict(env): printed.at("F", {**env, "d": depth})
        law = next(law for law in laws.laws() if entry.suffix.endswith("_" + law.suffix))
        # the power of the depth, which the row defines behind its formula
        env = environment(read(one.regions[0].tex)[1:], env)
        env |= functions_of(law, env)
    return env


KINDS = ("universal", "sum")
"""Kinds that are read here; an approach or a limit says itself what its formula has to be, and where."""
ENDS = {
    "edge": (r"r\to a", r"x\to a"), "far-field": (r"r\to\infty", r"x\to\infty"), "axis": (r"r\to 0",),
    "middle": (r"x\to 0", r"r\to 0"), "small-contact": (r"a\to 0",), "onset": (r"a\to b",),
}  # fmt: skip
"""Where an approach goes, as it is printed beside its name; a condition may follow."""


def wrong(one: Further, stored: Stored) -> bool:
    """Whether a row says something else than the entries it is about."""
    return {"universal": _universal, "sum": _sum}[one.kind](one, stored)


CURVE = (sp.Rational(3, 10), sp.S.One, sp.Rational(27, 10))
"""Radii over that of pull-off at which a universal curve is compared."""


def _universal(one: Further, stored: Stored) -> bool:
    problem = one.keys[0] if one.keys[0].endswith("adh") else one.keys[0].rpartition(".")[0]
    entries = stored(problem)
    fields = {s for suffix in ("ac", "Fc", "dc", "F", "d") for s in entries[suffix].cases[0].expr.free_symbols}
    values = {s: sp.Rational(11 + 2 * i, 7 + 3 * i) for i, s in enumerate(sorted(fields, key=str))}
    values |= {nt.theta: sp.Rational(2, 5), nt.k: sp.Rational(3, 8), nt.n: sp.Rational(17, 10)}
    with mp.workdps(2 * DIGITS):
        pulled = evaluate(entries["ac"].cases[0].expr, values, DIGITS)
        for ratio in CURVE:
            at = values | {nt.a_c: pulled, nt.a: pulled * mp.mpf(ratio.p) / ratio.q}
            env = named(at) | {"x": mp.mpf(ratio.p) / ratio.q}
            for name, suffix in (("F_adh", "F"), ("d_adh", "d"), ("F_c", "Fc"), ("d_c", "dc")):
                env[name] = evaluate(entries[suffix].cases[0].expr, at, DIGITS)
            if any(map(Claim(env).wrong, one.tex.split(r",\qquad "))):
                return True
    wanted = {f"{suffix}_adh" for suffix in ("F", "d") if f"{problem}.{suffix}" in one.keys}
    return not all(name.replace("_adh", r"_{\mathrm{adh}}") in one.tex for name in wanted)


_PART = re.compile(
    r"\\text\{(plus |minus )?\\hyperref\[sec:([\w.]+)\]\{[^}]*\}, page~\\pageref\{sec:([\w.]+)\}, with \}(.*)"
)


def _sum(one: Further, stored: Stored) -> bool:
    """Whether the parts that are named do not add to the entries at equal contact radius, in the range beside them."""
    lines = one.tex.removeprefix(OPENING).removesuffix(r"\end{aligned}").split(GAP)
    parts = [match.groups() for match in map(_PART.fullmatch, lines) if match]
    if len(parts) != len(lines) or any(name != page for _, name, page, _ in parts):
        return True
    profile = one.keys[0].rpartition(".")[0]
    entries = stored(profile)
    for suffix in (key.rpartition(".")[2] for key in one.keys):
        for case, values in points_of(entries[suffix], "formula", entries, 1, 13):
            if "<" in one.small and not holds(one.small, named(dict(values))):
                continue
            with mp.workdps(2 * DIGITS):
                want = evaluate(case.expr, values, DIGITS)
                if difference(sum(_share(part, suffix, values, stored) for part in parts), want) > CLOSE:
                    return True
    return False


def _share(part: Sequence[str], suffix: str, values: Mapping[Any, Any], stored: Stored) -> Any:
    """What a part adds to a quantity; nothing while its flat face is not pressed in."""
    sign, name, _, text = part
    entry = stored(name)[suffix]
    own = {name_in_print(symbol): symbol for symbol in entry.profile.parameters}
    given = {}
    for statement in read(text):
        given[own[statement.members[0].name]] = sp.Float(str(statement.members[1](named(dict(values)))), 2 * DIGITS)
    known = {**values, **given}
    if entry.profile.truncated and known[nt.a] < known[nt.b]:
        return 0
    value = evaluate(case_at(entry, known).expr, known, DIGITS)
    return -value if sign == "minus " else value
