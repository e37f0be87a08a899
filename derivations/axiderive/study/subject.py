"""What the study measures: a problem at chosen parameters, its emitted functions, and what a rival is given.

A rival knows the profile f, or the depth g(t) of the one-dimensional model and
its rate g'(t) in closed form: everything that the method itself does not find.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, cached_property
from importlib import import_module
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..contact import systems
from ..entry import Entry
from ..profiles.profile import Profile

Array = Any
"""A float64 array or a float."""
Function = Callable[..., Any]
NAMES = ("cone", "paraboloid", "rounded_punch", "truncated_cone", "sphere", "power_law")
QUANTITIES = ("p", "Fd", "w")
GRADED, ADHESIVE = "power_law.fgm", ("paraboloid.adh", "cone.adh")
OTHERS = {GRADED: QUANTITIES, **dict.fromkeys(ADHESIVE, ("ad",))}
"""On a graded half space, and with adhesion: the quantities of their own."""
RADIUS = 2.0
PARAMETERS = {
    nt.theta: 0.35, nt.b: 1.0, nt.R: 3.0, nt.A: 0.5, nt.n: 2.7, nt.E_star: 1.0, nt.H: 1.0, nt.k: 0.4, nt.dgamma: 0.01,
}  # fmt: skip
_s = sp.Symbol("s", positive=True)


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
    """One compact profile at RADIUS and PARAMETERS, on the homogeneous half space where its name says nothing else."""

    name: str

    @property
    def profile(self) -> Profile:
        return systems.problem(self.name).profile

    @property
    def entries(self) -> dict[str, Entry]:
        return entries(self.name)

    @property
    def values(self) -> dict[sp.Symbol, float]:
        return {symbol: PARAMETERS[symbol] for symbol in self.entries["F"].parameters} | {nt.a: RADIUS}

    @property
    def graded(self) -> bool:
        return nt.k in self.values

    @property
    def exponent(self) -> float:
        """k of the elastic grading."""
        return self.values.get(nt.k, 0.0)

    @property
    def modulus(self) -> float:
        return self.values[nt.H if self.graded else nt.E_star]

    @cached_property
    def edge(self) -> float:
        """Radius b of the flat face where the contact starts, 0 without one."""
        breaks = self.profile.breaks
        return float(PARAMETERS[breaks[0]]) if breaks else 0.0

    @cached_property
    def largest(self) -> float:
        """Contact radius below which a root is searched."""
        chain = self.profile.chain
        return float(PARAMETERS[chain[1]]) if chain else 100.0 * RADIUS

    @cached_property
    def height(self) -> Function:
        """f(r)."""
        return self._bound(self._in_pieces(nt.r), nt.r, "numpy")

    @cached_property
    def slope(self) -> Function:
        """f'(r) of the part beyond the edge."""
        return self._bound(sp.diff(self.profile.pieces[-1].expr, nt.r), nt.r, "numpy")

    @cached_property
    def slope_mp(self) -> Function:
        return self._bound(sp.diff(self.profile.pieces[-1].expr, nt.r), nt.r, "mpmath")

    @cached_property
    def depth(self) -> Function:
        """g(t), zero below the edge."""
        return self._beyond(self._bound(self._depth, nt.a, "numpy"))

    @cached_property
    def rate(self) -> Function:
        """g'(t), zero below the edge."""
        return self._beyond(self._bound(sp.diff(self._depth, nt.a), nt.a, "numpy"))

    @cached_property
    def rate_scalar(self) -> Function:
        """g'(t) beyond the edge, in the functions of `math`."""
        return self._bound(sp.diff(self._depth, nt.a), nt.a, "math")

    @cached_property
    def rate_mp(self) -> Function:
        return self._bound(sp.diff(self._depth, nt.a), nt.a, "mpmath")

    @cached_property
    def depth_mp(self) -> Function:
        return self._bound(self._depth, nt.a, "mpmath")

    @cached_property
    def growth(self) -> Function:
        """dg/ds in s = sqrt(t**2 - b**2), without the root: what a generated rule integrates."""
        break_ = self.profile.breaks[0] if self.profile.breaks else sp.S.Zero
        depth = self._depth.subs(nt.a, sp.sqrt(_s**2 + break_**2))
        depth = depth.replace(sp.acos, lambda cosine: sp.atan(sp.sqrt(sp.factor(cosine**-2 - 1))))
        return self._bound(sp.diff(depth, _s), _s, "numpy")

    @property
    def _depth(self) -> sp.Expr:
        (case,) = self.entries["d"].cases
        return case.expr

    def _in_pieces(self, r: sp.Symbol) -> sp.Expr:
        pieces = [(piece.expr, True if piece.upper is None else r < piece.upper) for piece in self.profile.pieces]
        return sp.Piecewise(*pieces)

    def _bound(self, expr: sp.Expr, variable: sp.Symbol, modules: str) -> Function:
        parameters = sorted(expr.free_symbols - {variable}, key=str)
        function = sp.lambdify((variable, *parameters), expr, modules)
        numbers = [PARAMETERS[symbol] for symbol in parameters]
        if modules == "mpmath":
            return lambda x: function(x, *map(mp.mpf, numbers))
        if modules == "math":
            return lambda x: function(x, *numbers)
        return lambda x: function(x, *numbers) + 0.0 * x  # a constant broadcasts

    def _beyond(self, function: Function) -> Function:
        if not self.edge:
            return function

        def clipped(t: Array) -> Array:
            return np.where(t > self.edge, function(np.maximum(t, self.edge)), 0.0)

        return clipped


@cache
def subject(name: str) -> Subject:
    return Subject(name)
