"""The catalogue through the general rules of the chapter: (11.29), and Schubert's inversion back to the pressure."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..entry import Case, Entry
from ..physics.loads import derive as derive_load
from ..physics.medium import GRADED, HOMOGENEOUS, Medium
from ..physics.normal import derive
from ..profiles import NAMES, load
from ..profiles.loads import LOADS
from ..profiles.profile import Profile
from .equation import LENGTH, STRESS, Draw, Formula, Residual, chain
from .quadrature import singular

Function = Callable[[Any], Any]
Values = Mapping[sp.Symbol, Any]
DEGREE = 3
"""Degree of the polynomial profile."""
SPREAD = 0.04
"""How far the random parameters stray from those of the sketch, which keep the rules of the profile."""

_NUMERIC = {
    name: cls.numeric for name, cls in vars(masters).items() if isinstance(cls, type) and hasattr(cls, "numeric")
}


@lru_cache(maxsize=2 * len(NAMES))
def _entries(name: str, medium: Medium) -> dict[str, Entry]:
    return derive(load(name), medium)


@lru_cache(maxsize=512)
def _slope(expr: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    return sp.diff(expr, symbol)


@lru_cache(maxsize=1024)
def _plan(expr: sp.Expr) -> tuple[tuple[tuple[sp.Symbol, sp.Integral], ...], tuple[sp.Symbol, ...], Callable[..., Any]]:
    """The integrals of an expression under names of their own, the names it needs, and the rest as a function."""
    integrals = tuple((sp.Dummy(positive=True), integral) for integral in expr.atoms(sp.Integral))
    rest = expr.xreplace({integral: name for name, integral in integrals})
    names = tuple(sorted(rest.free_symbols, key=str))
    return integrals, names, sp.lambdify(names, rest, [_NUMERIC, "mpmath"])


def _number(expr: sp.Expr, values: Values) -> Any:
    """The value of an expression, its integrals (which are regular by construction) done by quadrature."""
    integrals, names, function = _plan(expr)
    known = dict(values)
    for name, integral in integrals:
        ((variable, lo, hi),) = integral.limits
        integrand = _integrand(integral.function, variable, values)
        known[name] = singular(integrand, _number(lo, values), _number(hi, values))
    return function(*(known[s] for s in names))


def _integrand(expr: sp.Expr, variable: sp.Symbol, values: Values) -> Function:
    return lambda x: _number(expr, {**values, variable: x})


@lru_cache(maxsize=64)
def _spelled(expr: sp.Expr) -> sp.Expr:
    """A sum over the powers of a polynomial written out."""
    if not expr.has(sp.Sum):
        return expr
    return expr.subs(nt.N, DEGREE).doit().xreplace({nt.coefficients[i]: _coefficient(i) for i in range(1, DEGREE + 1)})


@dataclass(frozen=True)
class Indenter:
    """A profile of the catalogue at random parameter values, in the units of the draw."""

    profile: Profile
    values: Values
    a: Any
    d: Any
    breaks: tuple[Any, ...]
    medium: Medium = HOMOGENEOUS

    @property
    def entries(self) -> dict[str, Entry]:
        """What the engine derives for this profile in this medium: an entry for every key of a quantity, as "p"."""
        return _entries(self.profile.name, self.medium)

    @property
    def compact(self) -> bool:
        """Whether the contact grows with the depth, d = g(a), rather than ending at the edge of the body."""
        return self.profile.compact

    def _piece(self, r: Any) -> sp.Expr:
        pieces = self.profile.pieces
        index = sum(1 for b in self.breaks if r > b)
        return _spelled(pieces[index].expr)

    def height(self, r: Any) -> Any:
        """The profile f(r), a length, on the piece where r lies."""
        return _number(self._piece(r), {**self.values, nt.a: self.a, nt.r: r})

    def slope(self, r: Any) -> Any:
        """The slope f'(r), a pure number, on the piece where r lies."""
        return _number(_slope(self._piece(r), nt.r), {**self.values, nt.a: self.a, nt.r: r})

    def _case(self, cases: tuple[Case, ...], at: Values) -> Case | None:
        """The case whose chain of lengths ascends at these values."""
        for case in cases:
            lengths = [_number(sp.sympify(length), at) for length in case.chain]
            if all(x <= y for x, y in zip(lengths, lengths[1:], strict=False)):
                return case
        return None

    def _radius_law(self, x: Any) -> tuple[sp.Expr, Values]:
        """d - g over the contact radius; for a complete contact from dF/da = 2 c_N(a) (d - g) at a fixed face."""
        entries, at = self.entries, {**self.values, nt.a: x}
        if self.compact:
            case = self._case(entries["d"].cases, at)
            return nt.d - (_spelled(case.expr) if case else sp.S.Zero), at
        force = entries["F"].fixed_face[0].expr
        if nt.C in force.free_symbols:
            at = {**at, nt.C: self._face_coefficient()}
        return _slope(force, nt.a) / (self.medium.force_scale * nt.a**self.medium.k), at

    def _face_coefficient(self) -> Any:
        """C of the face -C r**n."""
        _, power = sp.expand_power_base(self.profile.pieces[0].expr).as_independent(nt.r, as_Add=False)
        return -self.height(self.a) / _number(power, {**self.values, nt.a: self.a, nt.r: self.a})

    def w1D(self, x: Any) -> Any:
        """The derived d - g(x)."""
        expr, at = self._radius_law(x)
        return _number(expr, at)

    def w1D_slope(self, x: Any) -> Any:
        """The derivative at x of the derived d - g, a pure number."""
        expr, at = self._radius_law(x)
        return _number(_slope(expr, nt.a), at)

    def pressure(self, r: Any) -> Any:
        """The derived pressure."""
        at = {**self.values, nt.a: self.a, nt.r: r}
        entry = self.entries["p"]
        cases = entry.cases if self.compact or entry.partial is None else entry.cases[-1:]
        case = self._case(cases, at) if self.compact else cases[-1]
        assert case is not None
        return _number(_spelled(case.expr), at)


def _coefficient(i: int) -> sp.Symbol:
    return sp.Symbol(f"A_{i}", positive=True)


def indenter(name: str, draw: Draw, graded: tuple[Any, Any] | None = None) -> Indenter:
    """The profile of that name with parameters scattered about those of its sketch; `graded` is H and k."""
    profile = load(name)
    values: dict[sp.Symbol, Any] = {nt.E_star: draw.stress()}
    medium = HOMOGENEOUS
    if graded is not None:
        medium = GRADED
        values[nt.H], values[nt.k] = graded
    sketch = dict(profile.sketch.values)
    exponent = sketch.get(nt.n)
    if exponent is not None:
        values[nt.n] = draw.number(exponent - SPREAD, exponent + SPREAD)
    for symbol in profile.parameters:
        if symbol is nt.coefficients:
            values |= {_coefficient(i): draw.quantity(1 - i, 0) for i in range(1, DEGREE + 1)}
        elif symbol not in (nt.a, nt.n):
            mean = sketch[symbol]
            values[symbol] = draw.quantity(
                _length_exponent(symbol, profile, values), 0, mean * (1 - SPREAD), mean * (1 + SPREAD)
            )
    for symbol, meaning in profile.abbreviations:
        values[symbol] = _number(meaning, values)
    a = draw.length(profile.sketch.a * (1 - SPREAD), profile.sketch.a * (1 + SPREAD))
    breaks = tuple(_number(sp.sympify(b), values) for b in profile.breaks)
    inside = tuple(b for b in breaks if b < a)
    if profile.complete:
        d = draw.length(1, 2)
    else:
        d = -Indenter(profile, {**values, nt.d: mp.mpf(0)}, a, mp.mpf(0), inside, medium).w1D(a)
    return Indenter(profile, {**values, nt.d: d}, a, d, inside, medium)


def _length_exponent(symbol: sp.Symbol, profile: Profile, values: Values) -> Any:
    if symbol != nt.A:
        return int(nt.describe(symbol).dimension.length)
    power = sp.powsimp(profile.pieces[0].expr / nt.A).as_base_exp()[1]
    return 1 - _number(power, values)


def catalogue_depths(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """(11.29) by quadrature against the derived depth of every compact profile."""
    for name in NAMES if draw.first else ():
        body = indenter(name, draw)
        if body.compact:
            yield Residual(body.d, formula(body.slope, body.a, body.breaks), LENGTH)


def graded_catalogue_depths(draw: Draw, formula: Formula, k: Any) -> Iterator[Residual]:
    """(11.61) by quadrature against the derived graded depth of every compact profile."""
    for name in NAMES if draw.first else ():
        body = indenter(name, draw, (draw.quantity(-2 - k, 1), k))
        if body.compact:
            yield Residual(body.d, formula(body.slope, body.a, k, body.breaks), LENGTH)


def catalogue_inversion(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """w = d - f under the indenter gives back d - g."""
    for name in NAMES if draw.first else ():
        body = indenter(name, draw)
        x = body.a * draw.number(0.2, 0.95)
        inside = tuple(b for b in body.breaks if b < x)
        w = formula(lambda r, body=body: body.d - body.height(r), lambda r, body=body: -body.slope(r), x, inside)
        yield Residual(body.w1D(x), w, LENGTH)


def catalogue_pressures(draw: Draw, formula: Formula) -> Iterator[Residual]:
    """d - g gives back the derived pressure; at the sharp edge of a body the edge term remains."""
    for name in NAMES if draw.first else ():
        body = indenter(name, draw)
        E_star, r = body.values[nt.E_star], body.a * draw.number(0.2, 0.9)
        right = formula(body.w1D_slope, r, body.a, E_star, tuple(b for b in body.breaks if b > r))
        if not body.compact:
            right += edge_pressure(body.w1D(body.a), r, body.a, E_star)
        yield Residual(body.pressure(r), right, STRESS)


def graded_catalogue_pressures(draw: Draw, formula: Callable[..., Any], H: Any, k: Any) -> Iterator[Residual]:
    """(11.53) applied to the derived d - g against every graded pressure that is not itself left as that integral."""
    closed = [name for name in NAMES if _entries(name, GRADED)["p"].status == "closed"]
    for name in closed if draw.first else ():
        body = indenter(name, draw, (H, k))
        r = body.a * draw.number(0.2, 0.9)
        right = formula(body.w1D_slope, r, body.a, tuple(b for b in body.breaks if b > r))
        if not body.compact:
            right += H * body.w1D(body.a) / (mp.pi * ((body.a - r) * (body.a + r)) ** ((1 - k) / 2))
        yield Residual(body.pressure(r), right, STRESS)


def load_displacements(draw: Draw, formula: Formula, chord: Callable[..., Function]) -> Iterator[Residual]:
    """The derived displacements under the prescribed pressures; `chord` makes w1D of a power load."""
    for prescribed in LOADS:
        a, p0, E_star, exponent = draw.length(), draw.stress(), draw.stress(), draw.number(-0.9, 1.5)
        r = a * draw.number(0.2, 0.9)
        values = {nt.a: a, nt.p_0: p0, nt.E_star: E_star, nt.sigma: exponent, nt.r: r}
        power = _number(prescribed.exponent, values)
        known = _number(derive_load(prescribed)["w"].cases[0].expr, values)
        yield from chain(known, formula(chord(p0, a, mp.mpf(power), E_star), r), LENGTH)


def edge_pressure(w1D_at_edge: Any, r: Any, a: Any, E_star: Any) -> Any:
    """The term that (11.107) leaves out: a flat punch of the remaining depth."""
    return E_star * w1D_at_edge / (mp.pi * mp.sqrt((a - r) * (a + r)))
