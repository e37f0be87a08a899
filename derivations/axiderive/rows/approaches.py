"""What a contact approaches, as rows without a key: at the edge, far away, at the axis, for a small contact, at onset.

Each formula is the way there in print, and is checked against its entry on that way. Profiles that turn into simpler
ones have the entries of the simpler one there; what the profile files name was found true by the stored checks.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel.masters import C0, IncompleteBeta, StruveH
from ..entry import Case, Entry
from ..notation import R1, R2, E_star, P, R, a, b, h, n, r, x
from ..oracle.evaluate import evaluate, evaluate_case, evaluated, holds
from ..physics import complete, normal, plane
from ..print.box import width
from ..print.formula import Printer
from ..print.shorthand import LINE, with_kappa
from ..profiles import load
from ..profiles import plane as flat
from ..profiles.loads import Load
from ..profiles.profile import Limit, Profile
from .claims import points_of

Entries = Mapping[str, Entry]
NEAR = sp.Symbol("near", positive=True)
"""What is left of the way, zero where the formula is exact."""
DISTANCE = sp.Rational(1, 10**40)
DIGITS = 40
REQUIRED = 20
"""Digits that agree at DISTANCE; at points where two lengths differ by 1e-9 the next order takes 10 of its 40."""
SEED = 41
HALF, HALF_LIMIT, LINKED = 132.0, 139.0, 90.0
"""Points for the formulas of half a row, of half a limit, and for the name of the simpler profile behind them."""
GAP = r",\enspace "
PRINTABLE = 40
"""Operations of a derivative that may fit into a row."""


@dataclass(frozen=True)
class Further:
    """A row without a key of its own: an approach, a limit, a universal curve, a sum."""

    kind: str
    keys: tuple[str, ...]
    """The entries that it is about."""
    label: str
    small: str
    tex: str
    remark: str = ""
    half: bool = False
    """Whether it takes half a line."""
    ruled: bool = False
    """Whether a rule in front of the book says it for every profile."""
    words: str = ""
    """In place of the formula, on the web."""
    checks: tuple[Mapping[str, Any], ...] = ()
    """How well each of its formulas agreed with its entry, where that is recorded nowhere else."""

    @property
    def comment(self) -> str:
        """What stands above it in the source."""
        return " ".join([self.kind, *self.keys])


Rows = list[Further]


@dataclass(frozen=True)
class Approach:
    """One quantity on its way: `way` gives the symbols that move, `cases` the leading formula by region."""

    entry: Entry
    way: tuple[tuple[sp.Symbol, sp.Expr], ...]
    cases: tuple[Case, ...]
    named: str = ""
    """The formula by the name of another row, for where it is too long to be spelled out."""
    recorded: bool = False
    """Whether the record of the profile holds a check of it, passed."""

    @property
    def left(self) -> str:
        """What stands before the arrow."""
        return self.entry.quantity.called

    @property
    def spelled(self) -> str:
        """The formula itself, or nothing where it has several regions."""
        if len({case.expr for case in self.cases}) > 1 or self.cases[-1].expr.has(sp.Integral):
            return ""
        case = self.cases[-1]
        short = with_kappa(case.expr)
        return Printer(tuple(x for x in case.chain if x.is_Symbol), short.names)(short.expr)

    def tex(self, room: float) -> str:
        """What is printed within so many points: the formula, else its name, else nothing."""
        for text in filter(None, (self.spelled, self.named)):
            printed = rf"{self.left}\to {text}"
            if width(printed) <= room:
                return printed
        return ""

    def is_named(self, printed: str) -> bool:
        """Whether the formula stands there by the name of another row, as it does for every profile."""
        return bool(self.named) and printed == rf"{self.left}\to {self.named}"

    @cached_property
    def check(self) -> dict[str, Any]:
        """How many digits of entry and formula agree next to the end of the way, and at how many points."""
        worst, count = mp.mpf(0), 0
        for values in self.points():
            leading = next((case for case in self.cases if holds(case, values)), None)
            own = next((case for case in self.entry.cases if holds(case, values)), None)
            if leading is None or own is None:
                continue
            with mp.workdps(2 * DIGITS):
                wanted = self._leading(leading, values)
                worst = max(worst, abs(self.value(own, values) / wanted - 1))
            count += 1
        digits = int(min(DIGITS, -mp.log10(worst))) if worst else DIGITS
        return {"key": self.entry.key, "digits": digits if count else 0, "count": count}

    @staticmethod
    def _leading(case: Case, values: Mapping[Any, Any]) -> Any:
        if case.expr.has(sp.Integral):
            return evaluated(case.expr, dict(values))
        if case.expr.has(C0):
            return evaluate_case(case, dict(values), DIGITS)
        return evaluate(case.expr, dict(values), DIGITS)

    def value(self, case: Case, values: Mapping[Any, Any]) -> Any:
        """The entry itself in one of its cases."""
        if self.entry.profile.contact == "prescribed":  # Arb has no complete elliptic integrals
            return evaluate(case.expr, dict(values), DIGITS)
        if case.expr.has(sp.Integral) and case.expr.has(StruveH):  # boxes around zero are not enclosed
            return evaluated(case.expr, dict(values))
        return evaluate_case(case, dict(values), DIGITS)

    def points(self) -> list[dict[Any, Any]]:
        """Points at DISTANCE from the end, one or two for every case of the entry."""
        found = []
        for _, values in points_of(self.entry, "formula", {self.entry.suffix: self.entry}, 2, SEED):
            at = dict(values)
            for symbol, expr in self.way:
                at[symbol] = expr.xreplace({**at, NEAR: DISTANCE})
            found.append(at)
        return found

    @property
    def holds(self) -> bool:
        """Whether it is recorded, or was checked at a point at least and agrees to enough digits."""
        return self.recorded or (self.check["count"] > 0 and self.check["digits"] >= REQUIRED)


def approach_row(label: str, small: str, parts: list[Approach], *, half: bool = True, kind: str = "") -> Rows:
    """A row of the parts that hold and fit into half a line or a whole one, none if there is none."""
    if kind == "limit":
        room = HALF_LIMIT if half else LINE - LINKED
    else:
        room = HALF if half else LINE
    kept: dict[str, Approach] = {}
    for part in parts:
        printed = part.tex(room - sum(map(width, kept)) - width(GAP) * len(kept))
        if printed and part.holds:
            kept[printed] = part
    if not kept:
        return []
    kind = kind or label.lower().replace(" ", "-")
    ruled = kind == "far-field" or all(part.is_named(text) for text, part in kept.items())
    checks = tuple(part.check | {"tex": text} for text, part in kept.items() if not part.recorded)
    keys = tuple(part.entry.key for part in kept.values())
    return [Further(kind, keys, label, f"${small}$", GAP.join(kept), half=half, ruled=ruled, checks=checks)]


def fitted_row(label: str, small: str, parts: list[Approach], *, half: bool = True, kind: str = "") -> Rows:
    """The row on half a line, or on a whole one where that is wanted or nothing fits."""
    narrow = approach_row(label, small, parts, kind=kind) if half else []
    return narrow or approach_row(label, small, parts, half=False, kind=kind)


def approach_rows(profile: Profile, entries: Entries) -> Rows:
    """The rows of a profile, as far as their formulas agree with the entries next to the end of the way."""
    if isinstance(profile, Load):
        return _load_rows(profile, entries)
    if nt.e in profile.parameters:
        return []
    place = x if "s" in entries else r
    if place == x:
        rows = [*_edge(profile, entries, x), *approach_row("Far field", r"x\to\infty", [_far_slope(entries)])]
    else:
        rows = [*_edge(profile, entries, r), *approach_row("Far field", r"r\to\infty", [_far(entries)])]
    rows += _axis(entries, place)
    if profile.compact:
        rows += _small(profile, entries) + _onset(profile, entries)
    return rows


def _far(entries: Entries) -> Approach:
    """The displacement of the whole force in a point."""
    cases = tuple(Case(c.chain, c.expr / (sp.pi * E_star * r)) for c in entries["F"].cases)
    return Approach(entries["w"], ((r, a / NEAR),), cases, r"\frac{F_{\mathrm N}}{\pi E^{*}r}")


def _far_slope(entries: Entries) -> Approach:
    """The slope beside the whole load in a line."""
    loads = entries["P"].cases if "P" in entries else (Case((), P),)
    cases = tuple(Case(c.chain, -2 * c.expr / (sp.pi * E_star * x)) for c in loads)
    return Approach(entries["s"], ((x, a / NEAR),), cases, r"-\frac{2 P}{\pi E^{*}x}")


def _edge(profile: Profile, entries: Entries, place: sp.Symbol) -> Rows:
    if profile.compact:
        return approach_row("Edge", rf"{place}\to a", [_root_edge(entries, place)])
    part = _sharp_edge(entries, place)
    beyond = part.cases[0].chain[part.cases[0].chain.index(a) + 1 :]
    small = rf"{place}\to a" + "".join(rf",\; a<{Printer()(length)}" for length in beyond)
    return fitted_row("Edge", small, [part])


def _root_edge(entries: Entries, place: sp.Symbol) -> Approach:
    """The last punches E* g'(a) da/pi, or strips P'(a) da/pi, stand alone next to the edge."""
    grown, scale, named = (entries["P"], 1, "P'(a)") if place == x else (entries["d"], E_star, r"E^{*}g'(a)")
    cases = tuple(
        Case(c.chain, scale * _factored(sp.diff(c.expr, a)) / (sp.pi * a) * _face(place)) for c in grown.cases
    )
    text = rf"\frac{{{named}}}{{\pi}}\sqrt{{\frac{{2 (a-{place})}}{{a}}}}"
    return Approach(entries["p"], ((place, a * (1 - NEAR)),), cases, text)


def _factored(expr: sp.Expr) -> sp.Expr:
    """In factors where it is short enough to be printed; longer ones have taken from a tenth of a second to minutes."""
    return sp.factor(expr) if sp.count_ops(expr) <= PRINTABLE else expr


def _sharp_edge(entries: Entries, place: sp.Symbol) -> Approach:
    """The term of the pressure that is infinite at the edge of the face."""
    reached = [c for c in entries["p"].cases if c.chain.index(a) == c.chain.index(place) + 1]
    root, scale = sp.sqrt(a**2 - place**2), (E_star if place == r else 1) / sp.pi
    cases = tuple(
        Case(c.chain, scale * sp.expand(sp.expand(c.expr * root).subs(place, a) / scale) / _face(place))
        for c in reached
    )
    return Approach(entries["p"], ((place, a * (1 - NEAR)),), cases)


def _face(place: sp.Symbol) -> sp.Expr:
    """sqrt(a**2 - r**2) next to the edge."""
    return sp.sqrt(2 * a * (a - place))


def _axis(entries: Entries, place: sp.Symbol) -> Rows:
    """The pressure in the middle by region, or its logarithm: arcosh(a/r) is ln(2 a/r) there."""
    if entries["p"].cases[0].expr.has(sp.Sum):  # a sum over powers of which the first has a logarithm
        return []
    name, found = ("Axis" if place == r else "Middle"), dict[sp.Expr, list[Case]]()
    for case in entries["p"].cases:
        if case.chain[0] == place:
            value = _in_the_middle(case.expr, place)
            found.setdefault(value, []).append(Case(case.chain, value))
    rows: Rows = []
    for value, cases in found.items():
        if value.has(sp.Integral) and entries["p"].profile.breaks:
            continue  # its integral ends on a branch point, next to which no quadrature reaches the digits of a check
        named = MIDDLE if value.has(sp.Integral) else ""
        part = Approach(entries["p"], ((place, a * NEAR),), tuple(cases), named)
        small = rf"{place}\to 0" + _told_apart(cases, len(found) > 1) + (r",\; n>1" if value.has(nt.n) else "")
        rows += fitted_row(name, small, [part])
    return rows


MIDDLE = r"\frac{E^{*}}{\pi}\int_{0}^{a} \frac{g'(t)}{t}\,\mathrm{d}t"
"""The pressure on the axis where no function in print has its value."""


def _told_apart(cases: list[Case], several: bool) -> str:
    """The range of a formula among several: the lengths beside the place."""
    if not several:
        return ""
    chains = [tuple(Printer().small(x) for x in case.chain[1:]) for case in cases]
    shared = [x for x in chains[0] if all(x in chain for chain in chains)]
    return r",\; " + "<".join(shared)


def _in_the_middle(expr: sp.Expr, place: sp.Symbol) -> sp.Expr:
    """The value, or what is left of it beside a logarithm."""
    if expr.has(sp.Integral):
        return expr.subs(place, 0)
    if expr.has(IncompleteBeta):  # B(1 - (r/a)**2; p, q) goes with (r/a)**(2 q)/(-q), q < 0
        fallen = expr.replace(IncompleteBeta, lambda z, p, q: 2 * (place / a) ** (2 * q) / sp.expand(-2 * q))
        expr = sp.powsimp(sp.factor_terms(sp.expand(sp.expand_power_base(fallen))))
    logarithm = expr.replace(sp.acosh, lambda u: sp.log(2 * u) if u.has(place) else sp.acosh(u))
    kept = {e: sp.Dummy(positive=True) for e in logarithm.atoms(sp.log) if e.has(place)}
    value = logarithm.xreplace(kept).subs(place, 0).xreplace({new: old for old, new in kept.items()})
    return sp.factor_terms(_at_zero(value))


def _at_zero(expr: sp.Expr) -> sp.Expr:
    """The expression without functions that vanish with their argument, arcsin(sqrt(a^2 - b^2)/a) as arccos(b/a)."""
    arc = sp.asin(sp.sqrt((a**2 - b**2) / a**2))
    plain = expr.replace(lambda e: isinstance(e, sp.Function) and e.args == (sp.S.Zero,), lambda e: sp.S.Zero)
    return plain.subs(arc, sp.acos(b / a))


def _small(profile: Profile, entries: Entries) -> Rows:
    """A smooth tip is a paraboloid of the radius 1/f''(0) to a small contact."""
    tip = profile.pieces[0].expr
    if "d" not in entries or "F" not in entries or tip.has(nt.n, nt.coefficients) or tip.is_polynomial(r):
        return []
    if sp.diff(tip, r).subs(r, 0) != 0:
        return []
    curvature = sp.factor_terms(sp.diff(tip, r, 2).subs(r, 0))
    simpler = normal.derive(load("paraboloid"))
    least = sp.Min(*(s for s in profile.parameters if nt.describe(s).dimension == nt.LENGTH))
    parts = [
        Approach(
            entries[suffix],
            ((a, least * NEAR),),
            tuple(Case((), c.expr.subs(nt.R, 1 / curvature)) for c in simpler[suffix].cases),
        )
        for suffix in ("d", "F")
    ]
    found = approach_row("Small contact", r"a\to 0", parts)
    both = found and len(found[0].checks) == len(parts)
    return found if both else approach_row("Small contact", r"a\to 0", parts, half=False)


def _onset(profile: Profile, entries: Entries) -> Rows:
    """A flat face takes up its first load: the leading power of t = sqrt(a^2 - b^2)/b."""
    if not profile.truncated:
        return []
    parts = []
    for suffix in ("d", "F", "P"):
        if suffix in entries and not any(nt.L in c.chain for c in entries[suffix].cases):
            value = _leading(entries[suffix].cases[0].expr)
            if value is not None and value != entries[suffix].cases[0].expr:
                parts.append(Approach(entries[suffix], ((a, b * (1 + NEAR)),), (Case((b, a), value),)))
    return approach_row("Onset", r"a\to b", parts, half=len(parts) == 1)


def _leading(expr: sp.Expr) -> sp.Expr | None:
    """The first term of the Taylor series in t, with a = b sqrt(1 + t^2) and arccos(b/a) = arctan t."""
    t, root = sp.Symbol("t", positive=True), sp.sqrt(a**2 - b**2)
    series = expr.subs(sp.acos(b / a), sp.atan(t)).subs(root, b * t).subs(a, b * sp.sqrt(1 + t**2))
    for order in range(6):
        coefficient = series.subs(t, 0)
        if coefficient != 0:
            return sp.cancel(coefficient / sp.factorial(order) / b**order) * root**order
        series = sp.diff(series, t)
    return None


def _load_rows(profile: Load, entries: Entries) -> Rows:
    """A prescribed pressure: its force in a point far away, the displacement in the middle."""
    force = sp.pi * nt.p_0 * a**2 / (profile.exponent + 1)
    (inside,) = (c.expr for c in entries["w"].cases if c.chain[0] == r)
    far = Approach(entries["w"], ((r, a / NEAR),), (Case((), force / (sp.pi * E_star * r)),))
    rows = approach_row("Far field", r"r\to\infty", [far])
    if inside.has(r):
        middle = Approach(entries["w"], ((r, a * NEAR),), (Case((), inside.subs(r, 0)),))
        rows += approach_row("Middle", r"r\to 0", [middle])
    return rows


IN_LIMITS = ("d", "F", "P", "p")
"""The quantities whose limits are printed; the depth of the plane, which ends at L, is too long."""


@dataclass(frozen=True)
class Reduction:
    """Simpler profile, the symbol that moves, where it goes, and what the parameters of the simpler one are then."""

    target: str
    symbol: sp.Symbol
    end: sp.Expr
    parameters: Mapping[sp.Expr, sp.Expr] = field(default_factory=dict)


BEYOND: dict[str, tuple[Reduction, ...]] = {
    "ellipsoid": (Reduction("sphere", h, b, {R: b}),),
    "hyperboloid": (Reduction("cone", b, sp.S.Zero),),
    "sphere_tipped_cone": (Reduction("cone", R, sp.S.Zero),),
    "capped_paraboloid": (Reduction("truncated_paraboloid", R1, sp.oo, {R: R2}),),
    "rounded_curved_punch": (Reduction("rounded_punch", R1, sp.oo, {R: R2}),),
    "wavy_paraboloid": (Reduction("paraboloid", h, sp.S.Zero),),
    "capped_cylinder": (Reduction("flat_punch", R, sp.oo),),
    "concave_power": (
        Reduction("concave_paraboloid", n, sp.Integer(2)),
        Reduction("concave_quartic", n, sp.Integer(4)),
    ),
    "concave_paraboloid": (Reduction("flat_punch", h, sp.S.Zero),),
    "concave_quartic": (Reduction("flat_punch", h, sp.S.Zero),),
}


def limit_rows(profile: Profile, entries: Entries, evidence: Mapping[str, Any]) -> Rows:
    """A row for each limit that the evidence of the normal contact holds a check of, passed."""
    found: Rows = []
    for limit in profile.limits:
        one = _named(profile, limit, load(limit.target))
        parts = [part for part, key in _parts(profile, entries, one) if _passed(evidence, part.entry, limit, key)]
        found += _row(one, [replace(part, recorded=True) for part in parts], len(profile.limits) > 1)
    return found


def reduction_rows(profile: Profile, entries: Entries) -> Rows:
    """A row for each other limit, and in the plane for each, half a line where there are several."""
    in_plane = "s" in entries
    found: Sequence[Reduction] = BEYOND.get(profile.name, ())
    if in_plane:
        found = [_named(profile, limit, flat.load(limit.target)) for limit in profile.limits]
    rows: Rows = []
    for one in found:
        # the quadrature of an integral takes minutes there
        parts = [part for part, _ in _parts(profile, entries, one) if part.entry.status != "integral"]
        rows += _row(one, parts, len(found) > 1, "plane." if in_plane else "")
    return rows


def _named(profile: Profile, limit: Limit, target: Profile) -> Reduction:
    """A limit of the profile file; parameters that only the simpler profile has follow from both shapes."""
    value, own = sp.sympify(limit.value), [symbol for symbol in target.parameters if symbol not in profile.parameters]
    if not own:
        return Reduction(limit.target, limit.symbol, value)
    reached = profile.pieces[-1].expr.subs(limit.symbol, value)
    (solution,) = sp.solve(sp.expand(target.pieces[-1].expr / reached) - 1, own[0])
    return Reduction(limit.target, limit.symbol, value, {own[0]: solution})


def _passed(evidence: Mapping[str, Any], entry: Entry, limit: Limit, key: str) -> bool:
    """Whether the record holds the check of this limit, passed, as `checks.identities` names it."""
    checks = evidence.get("entries", {}).get(entry.suffix, {}).get("checks", [])
    name = f"limit {limit.symbol} -> {limit.value}: {key}"
    return any(check["compared"] == name and check["outcome"] == "passed" for check in checks)


def _parts(profile: Profile, entries: Entries, one: Reduction) -> list[tuple[Approach, str]]:
    """The quantities of both profiles on their way, each with the key of the simpler formula."""
    in_plane, found = "s" in entries, []
    target = flat.load(one.target) if in_plane else load(one.target)
    simpler = (plane if in_plane else complete if target.complete else normal).derive(target)
    for suffix in IN_LIMITS:
        if suffix in simpler and suffix in entries and not (in_plane and suffix == "d"):
            cases = tuple(Case(c.chain, c.expr.subs(dict(one.parameters))) for c in simpler[suffix].cases)
            found.append((Approach(entries[suffix], _way(profile, one), cases), simpler[suffix].key))
    return found


def _row(one: Reduction, parts: list[Approach], half: bool, pool: str = "") -> Rows:
    title = (flat.load(one.target) if pool else load(one.target)).title
    link = rf"\hyperref[sec:{pool}{one.target}]{{{title if half else title.lower()}}}"
    end = r"\infty" if one.end == sp.oo else Printer()(one.end)
    way = rf"{Printer()(one.symbol)}\to {end}"
    rows = fitted_row("Limit", way, parts, half=half, kind="limit")
    return [replace(row, label=link) if half else replace(row, remark=link) for row in rows]


def _way(profile: Profile, one: Reduction) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The symbol next to its end, measured by the contact radius; what is short for it goes along."""
    if one.end.is_Integer and one.end != 0:
        return ((one.symbol, one.end),)
    next_to = {sp.oo: a / NEAR, sp.S.Zero: a * NEAR}.get(one.end, one.end * (1 + NEAR))
    return ((one.symbol, next_to), *profile.abbreviations)
