"""The catalogue through the general rules of the chapter: (11.29), and Schubert's inversion back to the pressure."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Case, Entry
from ..oracle.evaluate import evaluated, holds
from ..oracle.shape import Shape, coefficient, concrete, shape
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


def _number(expr: sp.Expr, values: Values) -> Any:
    """The value of an expression, its integrals (which are regular by construction) done by quadrature."""
    return evaluated(expr, values, singular)


@lru_cache(maxsize=2 * len(NAMES))
def _entries(name: str, medium: Medium) -> dict[str, Entry]:
    return derive(load(name), medium)


@lru_cache(maxsize=512)
def _slope(expr: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    return sp.diff(expr, symbol)


@dataclass(frozen=True)
class Indenter:
    """A profile of the catalogue at random parameter values, in the units of the draw."""

    profile: Profile
    values: Values
    a: Any
    d: Any
    medium: Medium = HOMOGENEOUS

    @property
    def entries(self) -> dict[str, Entry]:
        """What the engine derives for this profile in this medium: an entry for every key of a quantity, as "p"."""
        return _entries(self.profile.name, self.medium)

    @property
    def compact(self) -> bool:
        """Whether the contact grows with the depth, d = g(a), rather than ending at the edge of the body."""
        return self.profile.compact

    @cached_property
    def _shape(self) -> Shape:
        return shape(self.profile, {**self.values, nt.a: self.a})

    @property
    def breaks(self) -> tuple[Any, ...]:
        """Radii below a at which one piece of the profile follows on another."""
        return tuple(piece.hi for piece in self._shape.stretches[:-1])

    def height(self, r: Any) -> Any:
        """The profile f(r), a length, on the piece where r lies."""
        return self._shape.height(r)

    def slope(self, r: Any) -> Any:
        """The slope f'(r), a pure number, on the piece where r lies."""
        return next(piece for piece in self._shape.stretches if r <= piece.hi).slope(r)

    def _case(self, cases: tuple[Case, ...], at: Values) -> Case | None:
        return next((case for case in cases if holds(case, at)), None)

    def _radius_law(self, x: Any) -> tuple[sp.Expr, Values]:
        """d - g over the contact radius; for a complete contact from dF/da = 2 c_N(a) (d - g) at a fixed face."""
        entries, at = self.entries, {**self.values, nt.a: x}
        if self.compact:
            case = self._case(entries["d"].cases, at)
            return nt.d - (concrete(case.expr, at) if case else sp.S.Zero), at
        force = entries["F"].fixed_face[0].expr
        if nt.C in force.free_symbols:
            # C of the face -C r**n
            _, power = sp.expand_power_base(self.profile.pieces[0].expr).as_independent(nt.r, as_Add=False)
            at = {**at, nt.C: -self.height(self.a) / _number(power, {**self.values, nt.a: self.a, nt.r: self.a})}
        return _slope(force, nt.a) / (self.medium.force_scale * nt.a**self.medium.k), at

    def w1D(self, x: Any) -> Any:
        """The derived d - g(x)."""
        return _number(*self._radius_law(x))

    def w1D_slope(self, x: Any) -> Any:
        """The derivative at x of the derived d - g, a pure number."""
        expr, at = self._radius_law(x)
        return _number(_slope(expr, nt.a), at)

    def pressure(self, r: Any) -> Any:
        """The derived pressure."""
        at = {**self.values, nt.a: self.a, nt.r: r}
        cases = self.entries["p"].cases
        case = self._case(cases, at) if self.compact else cases[-1]
        assert case is not None
        return _number(case.expr, at)


def indenter(name: str, draw: Draw, graded: tuple[Any, Any] | None = None) -> Indenter:
    """The profile of that name with parameters scattered about those of its sketch; `graded` is H and k."""
    profile = load(name)
    values: dict[sp.Symbol, Any] = {nt.E_star: draw.stress()}
    if graded is not None:
        values[nt.H], values[nt.k] = graded
    sketch = dict(profile.sketch.values)
    exponent = sketch.get(nt.n)
    if exponent is not None:
        values[nt.n] = draw.number(exponent - SPREAD, exponent + SPREAD)
    for symbol in profile.parameters:
        if symbol is nt.coefficients:
            values[nt.N] = sp.Integer(DEGREE)
            values |= {coefficient(i): draw.quantity(1 - i, 0) for i in range(1, DEGREE + 1)}
        elif symbol not in (nt.a, nt.n):
            lo, hi = (sketch[symbol] * (1 + sign * SPREAD) for sign in (-1, 1))
            values[symbol] = draw.quantity(_length_exponent(symbol, profile, values), 0, lo, hi)
    for symbol, meaning in profile.abbreviations:
        values[symbol] = _number(meaning, values)
    a = draw.length(profile.sketch.a * (1 - SPREAD), profile.sketch.a * (1 + SPREAD))
    medium = HOMOGENEOUS if graded is None else GRADED
    if profile.complete:
        d = draw.length(1, 2)
    else:
        d = -Indenter(profile, {**values, nt.d: mp.mpf(0)}, a, mp.mpf(0), medium).w1D(a)
    return Indenter(profile, {**values, nt.d: d}, a, d, medium)


def _length_exponent(symbol: sp.Symbol, profile: Profile, values: Values) -> Any:
    if symbol != nt.A:
        return int(nt.describe(symbol).dimension.length)
    power = sp.powsimp(profile.pieces[0].expr / nt.A).as_base_exp()[1]
    return 1 - _number(power, values)


def catalogue_depths(draw: Draw, formula: Formula, *grading: Any) -> Iterator[Residual]:
    """(11.29), with the exponent of a grading (11.61), by quadrature against the depth of every compact profile."""
    for name in NAMES if draw.first else ():
        body = indenter(name, draw, *((draw.quantity(-2 - k, 1), k) for k in grading))
        if body.compact:
            yield Residual(body.d, formula(body.slope, body.a, *grading, body.breaks), LENGTH)


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
