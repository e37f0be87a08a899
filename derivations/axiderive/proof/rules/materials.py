"""The elastic constants against the half-space whose response they stand for.

The moduli of two bodies are proved by the equations of equilibrium of the homogeneous half-space; h_N is compared in
numbers only.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...notation import nu_1, nu_2, young_1, young_2
from ...profiles.materials import PROFILE as PROFILE
from ..algebra.domain import Domain, NotProvedError, require
from ..statement import Rule, require_regions, require_zero

DEPTH = sp.Symbol("z", positive=True)
RAISED = sp.symbols("raised_1 raised_2", positive=True)
"""1 + nu of both bodies."""


def compliances() -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """What a homogeneous half-space yields to loads of wave number 1 on its surface, from the equations of equilibrium.

    Displacements U sin x along x and W cos x into the half-space under the pressure cos x and under the shear sin x,
    and V across under the shear of a wave that runs across: W, U, V on the surface, with U, W and V linear functions
    of the depth times exp(-depth).
    """
    shear, first = sp.symbols("shear first")
    unknown = sp.symbols("u_0 u_1 w_0 w_1 v_0")
    U, W, V = unknown[0] + unknown[1] * DEPTH, unknown[2] + unknown[3] * DEPTH, unknown[4]

    def rate(factor: sp.Expr) -> sp.Expr:
        """Of the factor of exp(-depth)."""
        return sp.diff(factor, DEPTH) - factor

    wide = first + 2 * shear
    along, into, both = wide * U + first * rate(W), wide * rate(W) + first * U, shear * (rate(U) - W)
    balance = [rate(both) - along, both + rate(into), shear * (rate(rate(V)) - V)]
    equations = [c for row in balance for c in sp.Poly(sp.expand(row), DEPTH).coeffs() if c != 0]
    surface = [side.subs(DEPTH, 0) for side in (into, both, shear * rate(V))]
    elastic = {shear: young_1 / (2 * (1 + nu_1)), first: young_1 * nu_1 / ((1 + nu_1) * (1 - 2 * nu_1))}
    found = []
    for load, answer in enumerate((W, U, V)):
        loaded = [side + (1 if place == load else 0) for place, side in enumerate(surface)]
        (solution,) = sp.linsolve(equations + loaded, unknown)
        yielded = answer.subs(DEPTH, 0).subs(dict(zip(unknown, solution, strict=True)))
        found.append(sp.factor(yielded.subs(elastic)))
    return found[0], found[1], found[2]


def two_bodies() -> dict[str, sp.Expr]:
    """1/E* and 1/G*: a body yields to a wave of pressure, and to the mean of all shears, by twice its share."""
    pressed, sheared, across = compliances()
    other = {young_1: young_2, nu_1: nu_2}
    bodies = {"E_star": pressed / 2, "G_star": (sheared + across) / 4}
    return {suffix: body + body.subs(other) for suffix, body in bodies.items()}


class Materials:
    """The entries, and the half-space under the loads they are defined for."""

    def __init__(self, entries: Mapping[str, Entry]) -> None:
        self.entries = entries

    def reciprocal(self, suffix: str) -> list[str]:
        """1/modulus is the sum over the bodies, an identity of rational functions."""
        entry = self.entries[suffix]
        require_regions(entry, ((),))
        # -1 < nu < 1/2
        shifted = {nu: raised - 1 for nu, raised in zip((nu_1, nu_2), RAISED, strict=True)}
        gap = (entry.cases[0].expr * two_bodies()[suffix] - 1).subs(shifted)
        domain = Domain(*((raised, sp.Rational(3, 2)) for raised in RAISED))
        return [require_zero(gap, domain, f"1/{suffix} is the compliance of two half-spaces")]

    def graded(self) -> list[str]:
        """H is what its definition gives with the formula of h_N."""
        entry, factor = self.entries["H"], self.entries["h_N"].cases[0].expr
        return [self._equal(entry.cases[0].expr, entry.definition.rhs.subs(nt.h_N, factor), "H by its definition")]

    def factor(self) -> list[str]:
        """Raises `NotProvedError`: h_N is compared in numbers only."""
        message = "h_N is compared with a solution of the equations of equilibrium, which is no exact statement"
        raise NotProvedError(message)

    @staticmethod
    def _equal(left: sp.Expr, right: sp.Expr, statement: str) -> str:
        require(sp.cancel(left / right) == 1, "{}: not shown", statement)
        return statement


RULES: dict[str, Rule] = {
    "E_star": ((), Materials.reciprocal, "E_star"),
    "G_star": ((), Materials.reciprocal, "G_star"),
    "H": (("h_N",), Materials.graded),
    "h_N": ((), Materials.factor),
}
