"""What the study measures: a problem at chosen parameters, its emitted functions, and what a rival is given.

A rival knows the profile f, or the depth g(t) of the one-dimensional model and
its rate g'(t) in closed form, one expression between two breaks after the other,
and the special functions of the printed formulas as a first script has them, from
SciPy: everything that the method itself does not find.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp
from scipy import integrate, special

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import Case, Entry
from ..oracle.shape import coefficient, concrete
from ..physics import systems
from ..physics.complete import edge_depth
from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.plane import Superposition
from ..profiles.profile import Piece as ProfilePiece
from ..profiles.profile import Profile
from .problems import FURTHER, NAMES, OTHERS, PARAMETERS, RADIUS, RULED

Array = Any


@np.vectorize(otypes=[float])
def _c0(b: float, r: float, a: float) -> float:
    """The master integral C0 has no function of SciPy: its definition by quad."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what its estimate warns of is what the study measures
        value, _ = integrate.quad(lambda t: np.arccos(b / t) / np.sqrt(t * t - r * r), max(b, r), a)
    return float(value)


def _chi2(x: Array) -> Array:
    return (special.spence(1 - x) - special.spence(1 + x)) / 2


def _arctan_integral(x: Array) -> Array:
    """Ti2(x), the imaginary part of the dilogarithm of ix."""
    return special.spence(1 - 1j * x).imag


def _beta(z: Array, p: Array, q: Array) -> Array:
    return z**p / p * special.hyp2f1(p, 1 - q, p + 1, z)


def _cap_moment(k: float, b: float, R: float, a: Array) -> Array:
    """For a < R; the difference of an antiderivative between the tip and the break."""
    gap, power = (R - a) * (R + a), (k + 1) / 2

    def primitive(v: Array) -> Array:
        return v**power / (k + 1) / np.sqrt(gap) * special.hyp2f1(0.5, power, power + 1, -v / gap)

    return primitive(a * a) - primitive((a - b) * (a + b))


FUNCTIONS: dict[str, Any] = {
    "C0": _c0,
    "LegendreChi2": _chi2,
    "ArctanIntegral": _arctan_integral,
    "IncompleteBeta": _beta,
    "Dawson": special.dawsn,
    "StruveH": special.struve,
    "elliptic_f": special.ellipkinc,
    "elliptic_e": special.ellipeinc,
    "Hypergeometric": special.hyp2f1,
    "Kummer": special.hyp1f1,
    "CapMoment": _cap_moment,
    "gamma": special.gamma,
}
"""By the names that SymPy prints."""


Function = Callable[..., Any]


@dataclass(frozen=True)
class Piece:
    """The expression that holds from `low` to `high`."""

    low: float
    high: float
    expr: sp.Expr


@dataclass(frozen=True)
class Given:
    """A function of one variable at numbers for its parameters, zero below its first piece."""

    pieces: tuple[Piece, ...]
    variable: sp.Symbol
    values: Mapping[Any, float]

    @property
    def rate(self) -> Given:
        """The derivative."""
        pieces = tuple(Piece(one.low, one.high, sp.diff(one.expr, self.variable)) for one in self.pieces)
        return Given(pieces, self.variable, self.values)

    def numpy(self) -> Function:
        """Of an array; each expression sees its own range only."""
        functions = [self._bound(one.expr, [FUNCTIONS, "numpy"]) for one in self.pieces]
        if len(functions) == 1 and not self.pieces[0].low:
            return lambda x: functions[0](x) + 0.0 * x  # a constant broadcasts

        def chosen(x: Array) -> Array:
            value = 0.0 * x
            with np.errstate(divide="ignore", invalid="ignore"):  # at a break, whose value is not taken
                for one, function in zip(self.pieces, functions, strict=True):
                    value = np.where(x > one.low, function(np.clip(x, one.low, one.high)), value)
            return value

        return chosen

    def math(self) -> Function:
        """Of a float above the first break."""
        return self._scalar([FUNCTIONS, "math"], float)

    def mpmath(self) -> Function:
        """Of a number of mpmath above the first break."""
        return self._scalar([{master.__name__: master.numeric for master in MASTERS}, "mpmath"], mp.mpf)

    def _scalar(self, modules: Any, number: Callable[[float], Any]) -> Function:
        functions = [self._bound(one.expr, modules, number) for one in self.pieces]
        if len(functions) == 1:
            return functions[0]
        ends = [one.high for one in self.pieces]

        def chosen(x: Any) -> Any:
            for end, function in zip(ends, functions, strict=True):
                if x <= end:
                    return function(x)
            return math.nan

        return chosen

    def _bound(self, expr: sp.Expr, modules: Any, number: Callable[[float], Any] = float) -> Function:
        parameters = sorted(expr.free_symbols - {self.variable}, key=str)
        function = sp.lambdify((self.variable, *parameters), expr, modules)
        values = [self.values[symbol] for symbol in parameters]
        if number is float:
            return lambda x: function(x, *values)
        return lambda x: function(x, *map(number, values))  # at the digits in force


def joined(pieces: list[Piece]) -> tuple[Piece, ...]:
    """In ascending order, neighbours of one expression as one, empty ones left out."""
    found: list[Piece] = []
    for one in sorted((one for one in pieces if one.low < one.high), key=lambda one: one.low):
        if found and found[-1].expr == one.expr:
            found[-1] = Piece(found[-1].low, one.high, one.expr)
        else:
            found.append(one)
    return tuple(found)


@cache
def entries(problem: str) -> dict[str, Entry]:
    """The entries of a problem by suffix."""
    return systems.problem(problem).derive()


def emitted(entry: Entry, problem: str) -> Function:
    """The function of the catalogue, called with the values of its symbols.

    Raises
    ------
    ImportError
        If the catalogue has no such module yet.
    """
    found = systems.problem(problem)
    function = getattr(import_module(f"{found.system.package}.{found.name}"), entry.quantity.function)
    fields = entry.quantity.arguments
    names = [symbol for symbol in entry.parameters if symbol not in fields]

    def call(values: dict[sp.Symbol, Array]) -> Array:
        keywords = {str(getattr(symbol, "label", symbol)): values[symbol] for symbol in names}
        return function(*(values[symbol] for symbol in fields), **keywords)

    return call


@dataclass(frozen=True)
class Subject:
    """One profile at RADIUS and its parameters, on the homogeneous half-space where its name says nothing else."""

    name: str

    @property
    def profile(self) -> Profile:
        """The profile of the problem."""
        return systems.problem(self.name).profile

    @property
    def entries(self) -> dict[str, Entry]:
        """The entries of the problem by suffix."""
        return entries(self.name)

    @property
    def further(self) -> dict[Any, Any]:
        """The values of its profile alone."""
        return FURTHER.get(systems.problem(self.name).name, {})

    @cached_property
    def parameters(self) -> dict[Any, Any]:
        """The values of what the emitted functions are called with."""
        known = PARAMETERS | self.further | {nt.a: RADIUS}
        given = {symbol: known[symbol] for symbol in self.entries["p" if self.plane else "F"].parameters}
        return given | {nt.a: RADIUS} | ({self.free: known[self.free]} if self.complete else {})

    @cached_property
    def values(self) -> dict[Any, Any]:
        """The same with the shorthands of the profile, and with each coefficient of a sum by itself."""
        found = dict(self.parameters)
        for index, value in enumerate(found.pop(nt.coefficients, ()), 1):
            found |= {coefficient(index): value, nt.N: index}
        return found | {symbol: float(expr.subs(found)) for symbol, expr in self.profile.abbreviations}

    def printed(self, suffix: str) -> Entry:
        """The entry as it is printed, with a sum written out."""
        entry = self.entries[suffix]
        cases = tuple(replace(case, expr=concrete(case.expr, self.values)) for case in entry.cases)
        return replace(entry, cases=cases) if entry.status == "closed" and not entry.composed else entry

    @property
    def few(self) -> bool:
        """Whether it is measured beside a few other ways only, for its own page."""
        return self.name in RULED and self.name not in (*NAMES, *OTHERS)

    @property
    def brief(self) -> bool:
        """Of these the graded and the plane ones, which are many."""
        return self.few and (self.graded or self.plane)

    @property
    def plane(self) -> bool:
        """Whether it is a plane contact."""
        return systems.problem(self.name).system.pool.strip

    @property
    def across(self) -> sp.Symbol:
        """The place at which a field is asked for, r or x."""
        return nt.x if self.plane else nt.r

    @property
    def graded(self) -> bool:
        """Whether the half-space is graded."""
        return nt.k in self.values

    @property
    def complete(self) -> bool:
        """The radius is that of the body and the depth is free, or the load of a strip."""
        return self.profile.complete

    @property
    def free(self) -> sp.Symbol:
        """What a complete contact is loaded by: the depth d, or the line load P in the plane."""
        return nt.P if self.plane else nt.d

    @property
    def exponent(self) -> float:
        """k of the elastic grading."""
        return float(self.values.get(nt.k, 0.0))

    @property
    def power(self) -> float:
        """Of t**2 - r**2 in the pressure."""
        return (self.exponent - 1) / 2

    @property
    def modulus(self) -> float:
        """The value of E_star, on the graded half-space that of H."""
        return float(self.values[nt.H if self.graded else nt.E_star])

    @property
    def edge(self) -> float:
        """Radius b of the flat face where the contact starts, 0 without one."""
        return self.spans[0][0]

    @cached_property
    def spans(self) -> list[tuple[float, float]]:
        """Radii between which g(t) has one expression."""
        return [(one.low, one.high) for one in self._depth.pieces]

    @cached_property
    def excess(self) -> float:
        """Depth beyond that of the profile, d - g(a): of a complete contact; of a strip the load over E*."""
        return float(self._freed - self.depth(np.float64(RADIUS))) if self.complete else 0.0

    def excess_mp(self) -> mp.mpf:
        """The same at the digits in force."""
        return mp.mpf(self._freed) - self.depth_mp(mp.mpf(RADIUS)) if self.complete else mp.mpf(0)

    @property
    def _freed(self) -> float:
        return float(self.values[self.free] / (self.modulus if self.plane else 1.0))

    @cached_property
    def largest(self) -> float:
        """Contact radius below which a root is searched."""
        bounds = [self.profile.largest] if self.profile.largest is not None else []
        chain = self.profile.chain
        bounds += chain[chain.index(nt.a) + 1 :] if nt.a in chain else []
        return min((float(sp.sympify(bound).subs(self.values)) for bound in bounds), default=100.0 * RADIUS)

    @cached_property
    def height(self) -> Function:
        """f(r)."""
        return self._given(self.profile.pieces).numpy()

    @cached_property
    def slope(self) -> Function:
        """f'(r), zero on a flat face."""
        return self._slope.numpy()

    @cached_property
    def slope_mp(self) -> Function:
        """f'(r) of a number of mpmath."""
        return self._slope.mpmath()

    @cached_property
    def depth(self) -> Function:
        """g(t), zero below the edge."""
        return self._depth.numpy()

    @cached_property
    def rate(self) -> Function:
        """g'(t), zero below the edge."""
        return self._depth.rate.numpy()

    @cached_property
    def rate_scalar(self) -> Function:
        """g'(t) beyond the edge, in the functions of `math`."""
        return self._depth.rate.math()

    @cached_property
    def rate_mp(self) -> Function:
        """g'(t) beyond the edge, of a number of mpmath."""
        return self._depth.rate.mpmath()

    @cached_property
    def depth_mp(self) -> Function:
        """g(t) beyond the edge, of a number of mpmath; P(t)/E_star in the plane."""
        return self._depth.mpmath()

    @cached_property
    def _slope(self) -> Given:
        return self._given([one for one in self.profile.pieces if one.expr != 0]).rate

    @cached_property
    def _depth(self) -> Given:
        """g(t) in pieces, from the entry or, at a fixed edge, from the depth that a face of one power has there.

        In a plane contact P(t)/E* has its place.
        """
        if self.complete:
            (face,) = self.profile.pieces
            power = sp.cancel(self.across * sp.diff(face.expr, self.across) / face.expr)
            whole = self._at_edge() * (nt.t / nt.a) ** power
            return Given((Piece(0.0, math.inf, whole),), nt.t, self.values)
        pieces = [self._case(case) for case in self.entries["P" if self.plane else "d"].cases]
        return Given(joined(pieces), nt.a, self.values)

    def _at_edge(self) -> sp.Expr:
        """g(a) of a face between sharp edges."""
        if self.plane:
            return Superposition.of(self.profile.pieces).load((nt.a,)).expr()
        return edge_depth(self.profile, GRADED if self.graded else HOMOGENEOUS)

    def _case(self, case: Case) -> Piece:
        place = case.chain.index(nt.a)
        low = self._size(case.chain[place - 1]) if place else 0.0
        high = self._size(case.chain[place + 1]) if place + 1 < len(case.chain) else math.inf
        return Piece(low, high, concrete(case.expr / nt.E_star if self.plane else case.expr, self.values))

    def _given(self, members: Sequence[ProfilePiece]) -> Given:
        """The pieces of the profile, from the first of these on."""
        ends = [0.0, *map(self._size, self.profile.breaks), math.inf]
        offset = len(self.profile.pieces) - len(members)
        pieces = [
            Piece(ends[offset + i], ends[offset + i + 1], concrete(one.expr, self.values))
            for i, one in enumerate(members)
        ]
        return Given(tuple(pieces), self.across, self.values)

    def _size(self, length: sp.Expr) -> float:
        return float(sp.sympify(length).subs(self.values))


@cache
def subject(name: str) -> Subject:
    """The subject of a problem, made once; its name is the key of the problem."""
    return Subject(name)
