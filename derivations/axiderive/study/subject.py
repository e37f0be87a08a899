"""What the study measures: a problem at chosen parameters, its emitted functions, and what a rival is given.

A rival knows the profile f, or the depth g(t) of the one-dimensional model and
its rate g'(t) in closed form, one expression between two breaks after the other,
and the special functions of the printed formulas as a first script has them, from
SciPy: everything that the method itself does not find.
"""

from __future__ import annotations

import math
import warnings
from bisect import bisect_left
from collections.abc import Callable, Iterable, Mapping
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
from ..profiles import COMPACT_NAMES
from ..profiles.profile import Profile

Array = Any
Function = Callable[..., Any]

NAMES = ("cone", "paraboloid", "rounded_punch", "truncated_cone", "sphere", "power_law")
"""Normal contacts that are measured beside every other way, whether a rule evaluates them or not."""
QUANTITIES = ("p", "Fd", "w")
OTHER, ADHESIVE = "power_law.fgm", ("paraboloid.adh", "cone.adh")
OTHERS = {OTHER: QUANTITIES, **dict.fromkeys(ADHESIVE, ("ad",))}
"""On a graded half-space, and with adhesion: the quantities of their own."""
NORMAL = {
    **dict.fromkeys(("power_law", "polynomial", "hyperboloid", "truncated_cone", "truncated_paraboloid"), ("p", "w")),
    **dict.fromkeys(("rounded_cone", "capped_paraboloid", "rounded_punch", "rounded_curved_punch"), ("p", "w")),
    **dict.fromkeys(("sphere", "ellipsoid"), ("w",)),
    **dict.fromkeys(("sphere_tipped_cone", "gaussian"), ("p", "w", "Fd")),
    **dict.fromkeys(("wavy_paraboloid", "concave_power"), ("p", "w")),
}
"""Normal contacts and their quantities that the catalogue evaluates by a rule, in the order of the handbook."""
RULED = {
    **NORMAL,
    **{f"{name}.fgm": ("p", "w") for name in (*COMPACT_NAMES, "capped_cylinder", "concave_power")},
    **{f"{name}.fgm": ("w",) for name in ("concave_paraboloid", "concave_quartic")},
    **{f"plane.{name}": ("p",) for name in ("power_law", "rounded_wedge", "rounded_punch", "concave_power")},
}
"""The same with the graded and the plane contacts."""
EVERY = dict.fromkeys(NAMES, QUANTITIES) | {name: RULED[name] for name in NORMAL if name not in NAMES} | OTHERS
EVERY |= {name: RULED[name] for name in RULED if name not in EVERY}
"""The quantities of each problem whose error is measured against run time."""
RADIUS = 2.0
PARAMETERS = {
    nt.theta: 0.35, nt.b: 1.0, nt.R: 3.0, nt.A: 0.5, nt.n: 2.7, nt.E_star: 1.0, nt.H: 1.0, nt.k: 0.4, nt.dgamma: 0.01,
    nt.P: 0.5,
}  # fmt: skip
FURTHER: dict[str, dict[Any, Any]] = {
    "capped_cylinder": {nt.d: 1.5},
    "capped_paraboloid": {nt.R1: 6.0, nt.R2: 3.0},
    **dict.fromkeys(("concave_power", "concave_paraboloid", "concave_quartic"), {nt.h: 0.1, nt.d: 0.5}),
    "ellipsoid": {nt.h: 2.0, nt.b: 3.0},
    "gaussian": {nt.h: 0.5, nt.s: 2.0},
    "polynomial": {nt.coefficients: (0.02, 0.1, 0.03)},
    "rounded_curved_punch": {nt.R1: 6.0, nt.R2: 3.0},
    "wavy_paraboloid": {nt.h: 0.01, nt.wavelength: 1.0},
}
"""What single profiles have beside these."""


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

    @cached_property
    def rate(self) -> Given:
        """The derivative."""
        pieces = tuple(replace(one, expr=sp.diff(one.expr, self.variable)) for one in self.pieces)
        return replace(self, pieces=pieces)

    def __call__(self, x: Array) -> Array:
        return self.numpy(x)

    @cached_property
    def numpy(self) -> Function:
        """Of an array; each expression sees its own range only."""
        functions = self._bound([FUNCTIONS, "numpy"], float)
        if len(functions) == 1 and not self.pieces[0].low:
            return lambda x: functions[0](x) + 0.0 * x  # a constant broadcasts

        def chosen(x: Array) -> Array:
            value = 0.0 * x
            with np.errstate(divide="ignore", invalid="ignore"):  # at a break, whose value is not taken
                for one, function in zip(self.pieces, functions, strict=True):
                    value = np.where(x > one.low, function(np.clip(x, one.low, one.high)), value)
            return value

        return chosen

    @cached_property
    def math(self) -> Function:
        """Of a float above the first break."""
        return self._scalar(self._bound([FUNCTIONS, "math"], float))

    @cached_property
    def mpmath(self) -> Function:
        """Of a number of mpmath above the first break."""
        return self._scalar(self._bound([{master.__name__: master.numeric for master in MASTERS}, "mpmath"], mp.mpf))

    def _scalar(self, functions: list[Function]) -> Function:
        *ends, _ = (one.high for one in self.pieces)
        return lambda x: functions[bisect_left(ends, x)](x)

    def _bound(self, modules: Any, number: Callable[[float], Any]) -> list[Function]:
        """The expressions at the values of their parameters, as numbers of that kind."""
        names = sorted(self.values.keys() & {s for one in self.pieces for s in one.expr.free_symbols}, key=str)
        values = [number(self.values[symbol]) for symbol in names]
        bare = [sp.lambdify((self.variable, *names), one.expr, modules) for one in self.pieces]
        return [lambda x, function=function: function(x, *values) for function in bare]


def joined(pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """In ascending order, neighbours of one expression as one, empty ones left out."""
    found: list[Piece] = []
    for one in sorted((one for one in pieces if one.low < one.high), key=lambda one: one.low):
        if found and found[-1].expr == one.expr:
            found[-1] = replace(found[-1], high=one.high)
        else:
            found.append(one)
    return tuple(found)


@dataclass(frozen=True)
class Subject:
    """One profile at RADIUS and its parameters, on the homogeneous half-space where its name says nothing else."""

    name: str

    @cached_property
    def problem(self) -> systems.Problem:
        """What it is for the engine."""
        return systems.problem(self.name)

    @property
    def profile(self) -> Profile:
        """The profile of the problem."""
        return self.problem.profile

    @cached_property
    def entries(self) -> dict[str, Entry]:
        """The entries of the problem by suffix."""
        return self.problem.derive()

    def emitted(self, suffix: str) -> Function:
        """The function of the catalogue, called with the values of its symbols.

        Raises
        ------
        ImportError
            If the catalogue has no such module yet.
        """
        quantity, own = self.entries[suffix].quantity, self.problem
        function = getattr(import_module(f"{own.system.package}.{own.name}"), quantity.function)
        names = [symbol for symbol in self.entries[suffix].parameters if symbol not in quantity.arguments]

        def call(values: Mapping[sp.Symbol, Array]) -> Array:
            return function(*(values[symbol] for symbol in quantity.arguments), **named({s: values[s] for s in names}))

        return call

    @cached_property
    def parameters(self) -> dict[Any, Any]:
        """The values of what the emitted functions are called with."""
        known = PARAMETERS | FURTHER.get(self.problem.name, {}) | {nt.a: RADIUS}
        free = nt.P if self.plane else nt.d
        given = {symbol: known[symbol] for symbol in self.entries["p" if self.plane else "F"].parameters}
        return given | {nt.a: RADIUS} | ({free: known[free]} if self.profile.complete else {})

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
    def plane(self) -> bool:
        """Whether it is a plane contact."""
        return self.problem.system.pool.strip

    @property
    def graded(self) -> bool:
        """Whether the half-space is graded."""
        return self.problem.system.medium.graded

    @property
    def across(self) -> sp.Symbol:
        """The place at which a field is asked for, r or x."""
        return nt.x if self.plane else nt.r

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
        return self.depth.pieces[0].low

    def spans(self, end: float = RADIUS) -> list[tuple[float, float]]:
        """Radii between which g(t) has one expression, from break to break up to a radius."""
        return [(one.low, min(one.high, end)) for one in self.depth.pieces if one.low < end]

    @cached_property
    def excess(self) -> float:
        """Depth beyond that of the profile, d - g(a): of a complete contact; of a strip the load over E*."""
        return float(self.freed - self.depth(np.float64(RADIUS))) if self.profile.complete else 0.0

    @property
    def freed(self) -> float:
        """The depth of a complete contact; of a strip the load over E*."""
        return float(self.values[nt.P] / self.modulus if self.plane else self.values[nt.d])

    @cached_property
    def largest(self) -> float:
        """Contact radius below which a root is searched."""
        bounds = [self.profile.largest] if self.profile.largest is not None else []
        chain = self.profile.chain
        bounds += chain[chain.index(nt.a) + 1 :] if nt.a in chain else []
        return min(map(self._size, bounds), default=100.0 * RADIUS)

    @cached_property
    def height(self) -> Given:
        """f(r)."""
        ends = [0.0, *map(self._size, self.profile.breaks), math.inf]
        exprs = [concrete(one.expr, self.values) for one in self.profile.pieces]
        return Given(tuple(map(Piece, ends, ends[1:], exprs)), self.across, self.values)

    @cached_property
    def slope(self) -> Given:
        """f'(r), zero on a flat face."""
        return replace(self.height, pieces=tuple(one for one in self.height.pieces if one.expr != 0)).rate

    @property
    def rate(self) -> Given:
        """g'(t), zero below the edge."""
        return self.depth.rate

    @cached_property
    def depth(self) -> Given:
        """g(t) in pieces, from the entry or, at a fixed edge, from the depth that a face of one power has there.

        In a plane contact P(t)/E* has its place.
        """
        if self.profile.complete:
            (face,) = self.profile.pieces
            power = sp.cancel(self.across * sp.diff(face.expr, self.across) / face.expr)
            whole = self._at_edge() * (nt.t / nt.a) ** power
            return Given((Piece(0.0, math.inf, whole),), nt.t, self.values)
        pieces = map(self._case, self.entries["P" if self.plane else "d"].cases)
        return Given(joined(pieces), nt.a, {s: value for s, value in self.values.items() if s != nt.a})

    def _at_edge(self) -> sp.Expr:
        """g(a) of a face between sharp edges."""
        if self.plane:
            return Superposition.of(self.profile.pieces).load((nt.a,)).expr()
        return edge_depth(self.profile, GRADED if self.graded else HOMOGENEOUS)

    def _case(self, case: Case) -> Piece:
        sizes = [0.0 if symbol == nt.a else self._size(symbol) for symbol in case.chain]
        place = case.chain.index(nt.a)
        expr = concrete(case.expr / nt.E_star if self.plane else case.expr, self.values)
        return Piece(sizes[place - 1] if place else 0.0, [*sizes, math.inf][place + 1], expr)

    def _size(self, length: sp.Expr) -> float:
        return float(sp.sympify(length).subs(self.values))


def named(values: Mapping[Any, Any]) -> dict[str, Any]:
    """The values of symbols by what the functions of the catalogue call them."""
    return {str(getattr(symbol, "label", symbol)): value for symbol, value in values.items()}


@cache
def subject(name: str) -> Subject:
    """The subject of a problem, made once; its name is the key of the problem."""
    return Subject(name)
