"""Values a module is checked with: integrals of the definition at 20 digits, never the module's own rules."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..contact.medium import GRADED
from ..contact.normal import derive
from ..emit import example
from ..entry import Entry
from ..expression.definition import Definition
from ..profiles.profile import Profile
from . import interface

if TYPE_CHECKING:
    from .compose import Request

DIGITS = 20
MATERIAL = {"E_star": 1.0e6, "dgamma": 0.05, "G_star": 8.0e5, "mu": 0.3, "H": 1.0e6, "k": 0.25}
"""Material values where a scene leaves them free."""
LARGEST_ERROR = 1e-6


@dataclass(frozen=True)
class Value:
    """One call and its result."""

    function: str
    fields: tuple[float, ...]
    keywords: tuple[tuple[str, float], ...]
    wanted: float

    def record(self) -> dict[str, Any]:
        return {
            "function": self.function,
            "fields": list(self.fields),
            "keywords": dict(self.keywords),
            "value": self.wanted,
        }


class _Contact:
    """Numbers of one contact at frozen and chosen values."""

    def __init__(self, profile: Profile, entries: Mapping[str, Entry], request: Request) -> None:
        self.profile, self.entries = profile, entries
        drawn = dict(profile.sketch.values)
        self.all = {p.name: request.values.get(p.name, float(drawn.get(p, 1.0))) for p in profile.parameters}
        self.all |= {n: request.values.get(n, MATERIAL[n]) for n in interface.MATERIAL[request.physics]}
        self.exact = {p: sp.Rational(self.all[p.name]) for p in profile.parameters}
        self.compact = profile.contact == "compact"
        self.definition = Definition(profile, self.given(), DIGITS) if self.compact else None

    def given(self) -> dict[sp.Symbol, sp.Expr]:
        """Parameters, and abbreviations as floats of 40 digits."""
        known: dict[sp.Symbol, sp.Expr] = dict(self.exact)
        for symbol, expr in self.profile.abbreviations:
            known[symbol] = sp.Rational(str(sp.N(expr.xreplace(known), 40)))
        return known

    def radii(self) -> list[float]:
        """Contact radii of the size of the profile, on both sides of its breaks."""
        known = {s: float(v) for s, v in self.given().items()}
        breaks = [known[b] for b in self.profile.breaks]
        if breaks:
            inner = [] if self.profile.truncated else [0.6 * breaks[0]]
            return [*inner, 1.4 * breaks[-1]]
        drawn = dict(self.profile.sketch.values)
        lengths = [p for p in self.profile.parameters if nt.describe(p).dimension == nt.LENGTH]
        scale = min((known[p] / float(drawn[p]) for p in lengths), default=1e-3)
        top = scale * self.profile.sketch.a if lengths else 1e-3
        if self.profile.largest is not None:
            top = min(top, 0.9 * float(self.profile.largest.xreplace(self.given())))
        if self.profile.chain and self.profile.chain[-1] in known:
            top = min(top, 0.8 * known[self.profile.chain[-1]])
        return [0.4 * top, top]

    def normal(self, suffix: str, a: float, at: float | None = None) -> mp.mpf:
        assert self.definition is not None
        with mp.workdps(DIGITS + 10):
            if suffix == "w" and at is not None and at <= a:
                return self.normal("d", a) - self.height(at)
            if suffix == "p" and at is not None and at >= a:
                return mp.mpf(0)
            scale = mp.mpf(self.all["E_star"]) if suffix in ("F", "p") else mp.mpf(1)
            return scale * self.definition.quantity(suffix, a, at)

    def height(self, at: float) -> mp.mpf:
        known = self.given() | {nt.r: sp.Rational(at)}
        return mp.mpf(str(sp.N(example.shape_value(self.profile, known), 30)))


def check_values(
    profile: Profile,
    entries: Mapping[str, Entry],
    request: Request,
    keywords: Callable[[Sequence[str]], tuple[str, ...]],
) -> list[Value]:
    """A few values of every function that is wanted, `pull_off` left out."""
    contact = _Contact(profile, entries, request)
    found = []
    for name in request.quantities:
        if name == interface.PULL_OFF:
            continue
        if request.physics == "graded":
            rows = _graded(contact, name)
        else:
            rows = _compact(contact, request.physics, name) if contact.compact else _complete(contact, name)
        parameters = [*(p.name for p in profile.parameters), *interface.MATERIAL[request.physics]]
        free = tuple((k, contact.all[k]) for k in keywords(parameters))
        found += [Value(name, fields, free, float(wanted)) for fields, wanted in rows]
    return found


def _compact(contact: _Contact, physics: str, name: str) -> list[tuple[tuple[float, ...], Any]]:
    rows: list[tuple[tuple[float, ...], Any]] = []
    for a in contact.radii():
        with mp.workdps(DIGITS + 10):
            rows += [(fields, value) for fields, value in _at(contact, physics, name, a) if value is not None]
    return rows


def _at(contact: _Contact, physics: str, name: str, a: float) -> list[tuple[tuple[float, ...], Any]]:
    """Calls at one contact radius with their results."""
    E, pi = mp.mpf(contact.all["E_star"]), mp.pi
    moved = mp.sqrt(2 * pi * a * mp.mpf(contact.all["dgamma"]) / E) if physics == "adhesive" else mp.mpf(0)

    def depth(x: float) -> Any:
        return contact.normal("d", x)

    def force(x: float) -> Any:
        return contact.normal("F", x)

    inside, outside = 0.45 * a, 1.6 * a
    ball = mp.sqrt((mp.mpf(a) - inside) * (mp.mpf(a) + inside))
    match name:
        case "profile":
            return [((inside,), contact.height(inside))]
        case "depth":
            return [((a,), depth(a) - moved)]
        case "force":
            return [((a,), force(a) - 2 * E * a * moved)]
        case "pressure":
            return [((inside, a), contact.normal("p", a, inside) - E * moved / (pi * ball)), ((outside, a), mp.mpf(0))]
        case "displacement":
            lift = 2 / pi * mp.asin(mp.mpf(a) / outside) * moved
            under = depth(a) - contact.height(inside) - moved
            return [((outside, a), contact.normal("w", a, outside) - lift), ((inside, a), under)]
        case "stiffness":
            return [((a,), 2 * E * a)]
        case "mean_pressure":
            return [((a,), force(a) / (pi * mp.mpf(a) ** 2))]
        case "retraction":
            return [((a,), moved)]
        case "radius_from_depth" | "radius_from_force" | "force_from_depth" | "depth_from_force" if physics == "normal":
            given = float(depth(a) if name.endswith("depth") else force(a))
            target = {"radius": mp.mpf(a), "force": force(a), "depth": depth(a)}[name.split("_")[0]]
            return [((given,), target)]
    return []


def _graded(contact: _Contact, name: str) -> list[tuple[tuple[float, ...], Any]]:
    """The closed formulas of the graded half space with 30 digits; those that stay integrals are left out."""
    function = interface.functions("normal")[name]
    # doubles with 40 digits: as exact fractions their powers would have thousands of digits
    numbers = {nt.H: contact.all["H"], nt.k: contact.all["k"], **contact.given()}
    known = {symbol: sp.Float(value, 40) for symbol, value in numbers.items()}
    if name == "profile":
        return []
    entry = derive(contact.profile, GRADED)[function.quantity.suffix]
    if entry.status != "closed":
        return []
    rows: list[tuple[tuple[float, ...], Any]] = []
    for a in contact.radii():
        place = {"a": a, "r": a * (1.6 if name == "displacement" else 0.45), "d": a / 50, "F": a}
        own = {nt.describe(field).symbol: sp.Float(place[field], 40) for field in function.fields}
        fields = tuple(float(place[field]) for field in function.fields)
        rows.append((fields, example.value(contact.profile, entry, known | own)))
    return rows


def _complete(contact: _Contact, name: str) -> list[tuple[tuple[float, ...], Any]]:
    """A complete contact by its closed entries, at a depth above the least one."""
    functions = interface.functions("normal", "complete")
    entry = contact.entries.get(functions[name].quantity.suffix)
    known: dict[sp.Symbol, sp.Expr] = {**contact.given(), nt.E_star: sp.Rational(contact.all["E_star"])}
    if entry is None or entry.status == "root" or any(e.has(nt.r_zero) for e in [c.expr for c in entry.cases]):
        return []
    a = known.get(nt.a, sp.S.One)
    least = contact.entries.get("dmin")
    depth = a / 100
    if least is not None and least.status == "closed" and not least.cases[0].expr.has(nt.r_zero):
        depth = 2 * sp.Rational(str(example.value(contact.profile, least, known)))
    fields = {nt.d: float(depth), nt.r: float(a) * (1.5 if name == "displacement" else 0.4)}
    if name == "depth_from_force":
        at = known | {nt.d: sp.Rational(fields[nt.d])}
        fields[nt.F] = float(example.value(contact.profile, contact.entries["F"], at))
    arguments = interface.arguments(functions[name], contact.entries)
    own = {nt.describe(n).symbol: sp.Rational(fields[nt.describe(n).symbol]) for n in arguments}
    return [(tuple(float(v) for v in own.values()), example.value(contact.profile, entry, known | own))]


def measured(
    text: str, values: Sequence[Value], request: Request, free: Mapping[str, float]
) -> tuple[list[Value], dict[str, float]]:
    """The values with the keywords each function really has, and its worst relative deviation, found by running it.

    Raises
    ------
    ArithmeticError
        If a value is off by more than any rule may be.
    """
    space: dict[str, Any] = {"__name__": request.module.removesuffix(".py")}
    exec(compile(text, request.module, "exec"), space)  # text of our own making
    if interface.PULL_OFF in request.quantities:
        for control in ("force", "depth"):
            space[interface.PULL_OFF](control, **free)
    errors: dict[str, float] = {}
    called = []
    for value in values:
        function = space[value.function]
        code = getattr(function, "__wrapped__", function).__code__
        names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        own = replace(value, keywords=tuple((k, v) for k, v in value.keywords if k in names))
        got = function(*own.fields, **dict(own.keywords))
        error = abs(got - own.wanted) / abs(own.wanted) if own.wanted else abs(got)
        if not error <= LARGEST_ERROR:
            message = f"{own.function}{own.fields} gives {got!r} instead of {own.wanted!r}; the module is not written"
            raise ArithmeticError(message)
        errors[own.function] = max(errors.get(own.function, 0.0), error)
        called.append(own)
    return called, errors
