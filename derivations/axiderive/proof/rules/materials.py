"""The elastic constants against the half-space whose response they stand for.

The moduli of two bodies, and that of a transversely isotropic one, are proved by the equations of equilibrium of the
half-space; h_N is compared in numbers only.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...notation import nu_1, nu_2, r, young_1, young_2
from ..algebra.domain import Domain, NotProvedError, require
from ..statement import Rule, require_regions, require_zero

DEPTH = sp.Symbol("z", positive=True)
RAISED = sp.symbols("raised_1 raised_2", positive=True)
"""1 + nu of both bodies."""
SUM, UPPER = sp.symbols("sum upper", positive=True)
"""Of the rates of decay below a transversely isotropic surface; C_13 + sqrt(C_11 C_33)."""


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


def transverse() -> tuple[sp.Expr, dict[sp.Symbol, sp.Expr]]:
    """What a transversely isotropic half-space yields to a pressure of wave number 1, and its constants.

    Both are rational in C_33, C_44, C_13 + sqrt(C_11 C_33) and the sum of the two rates s of decay; for every choice of
    these there is one half-space of positive energy, and for every such half-space one choice.  U sin x and W cos x are
    sums of exp(-s depth), in which the balance along the surface gives W over U.
    """
    lower = SUM**2 * nt.C_33 * nt.C_44 / (UPPER + 2 * nt.C_44)
    mean, both = (lower + UPPER) / 2, (UPPER - lower) / 2
    near, far = sp.symbols("near far")
    rates = near, far
    ratios = [(nt.C_11 - nt.C_44 * s**2) / ((nt.C_13 + nt.C_44) * s) for s in rates]
    shears = [-nt.C_44 * (s + q) for s, q in zip(rates, ratios, strict=True)]
    presses = [nt.C_13 - nt.C_33 * s * q for s, q in zip(rates, ratios, strict=True)]
    whole = shears[0] * presses[1] - shears[1] * presses[0]
    yielded = sp.factor((shears[1] * ratios[0] - shears[0] * ratios[1]) / whole)
    # s^2 - SUM s + sqrt(C_11/C_33) = 0 for both rates
    constants = {nt.C_11: mean**2 / nt.C_33, nt.C_13: both}
    equation = near**2 - SUM * near + mean / nt.C_33
    top, bottom = (sp.rem(part.subs(far, SUM - near).subs(constants), equation, near) for part in sp.fraction(yielded))
    return sp.factor(top / bottom), constants


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
        # -1 < nu < 1/2
        shifted = {nu: raised - 1 for nu, raised in zip((nu_1, nu_2), RAISED, strict=True)}
        gap = (self._formula(suffix) * two_bodies()[suffix] - 1).subs(shifted)
        domain = Domain(*((raised, sp.Rational(3, 2)) for raised in RAISED))
        return [require_zero(gap, domain, f"1/{suffix} is the compliance of two half-spaces")]

    def transverse(self) -> list[str]:
        """The modulus is what turns the yield to a wave of pressure into 2/E*."""
        yielded, constants = transverse()
        gap = self._formula("E_ti").subs(constants) * yielded / 2 - 1
        domain = Domain(*((0, symbol) for symbol in (SUM, UPPER, nt.C_33, nt.C_44)))
        return [require_zero(gap, domain, "2/E_star is what a transversely isotropic half-space yields")]

    def curvature(self) -> list[str]:
        """The gap between two paraboloids is that of one and a plane; positive radii, and those of a ball in a cup."""
        one, two = nt.radius_1, sp.Symbol("cup", positive=True)
        steps = []
        for radius, order in ((two, Domain((0, one), (0, two))), (-two, Domain((0, one, two)))):
            whole = self._formula("R").subs(nt.radius_2, radius)
            gap = r**2 / (2 * one) + r**2 / (2 * radius) - r**2 / (2 * whole)
            steps.append(require_zero(gap / r**2, order, f"the gap is r^2/(2 R), R_2 = {radius}"))
        return steps

    def number(self, suffix: str) -> list[str]:
        """A power of a number of adhesion is what its definition says."""
        entry = self.entries[suffix]
        power = entry.definition.lhs.subs(entry.quantity.symbol, self._formula(suffix))
        domain = Domain(*((0, symbol) for symbol in entry.parameters))
        return [require_zero(power / entry.definition.rhs - 1, domain, f"{suffix} by its definition")]

    def graded(self) -> list[str]:
        """H is what its definition gives with the formula of h_N."""
        entry, factor = self.entries["H"], self.entries["h_N"].cases[0].expr
        return [self._equal(entry.cases[0].expr, entry.definition.rhs.subs(nt.h_N, factor), "H by its definition")]

    def factor(self) -> list[str]:
        """Raises `NotProvedError`: h_N is compared in numbers only."""
        message = "h_N is compared with a solution of the equations of equilibrium, which is no exact statement"
        raise NotProvedError(message)

    def _formula(self, suffix: str) -> sp.Expr:
        """The one formula of a constant."""
        entry = self.entries[suffix]
        require_regions(entry, ((),))
        return entry.cases[0].expr

    @staticmethod
    def _equal(left: sp.Expr, right: sp.Expr, statement: str) -> str:
        require(sp.cancel(left / right) == 1, "{}: not shown", statement)
        return statement


RULES: dict[str, Rule] = {
    "E_star": ((), Materials.reciprocal, "E_star"),
    "E_ti": ((), Materials.transverse),
    "G_star": ((), Materials.reciprocal, "G_star"),
    "H": (("h_N",), Materials.graded),
    "h_N": ((), Materials.factor),
    "R": ((), Materials.curvature),
    "mu_T": ((), Materials.number, "mu_T"),
    "lambda_M": ((), Materials.number, "lambda_M"),
}
