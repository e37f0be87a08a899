"""Rules for the punch under an eccentric load: equilibrium by antiderivatives, level base by Plemelj's formula.

In the coordinate xi from the middle of the contact, of half-width c, the
pressure is p = (alpha + beta xi)/sqrt(c^2 - xi^2).  The function

    Phi(z) = pi [(alpha + beta z)/sqrt(z^2 - c^2) - beta]

jumps by -2 pi i p across the contact and vanishes at infinity, so it is
int p(s)/(z - s) ds; the mean of its boundary values is the principal value
-pi beta, the same all over the contact.  While both edges touch, e and x may
have either sign and stand in one formula; with one edge lifted the formulas are
odd or even under x -> -x, e -> -e, so that e > 0 is enough.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ...entry import Entry
from ...notation import E_star, P, a, e, x
from ...notation import c as half
from ..algebra.domain import Domain, NotProvedError
from ..algebra.functions import require_analytic, sign, tower
from ..algebra.identity import at
from ..statement import require_regions, require_zero

PLACE, SHARE = sp.symbols("place share", positive=True)
"""Where x and e are between their bounds, from 0 to 1."""
NOTHING = sp.Symbol("nothing", positive=True)
"""Stands for a greater of zero and a negative number until what is made of it is shown to be finite."""


@dataclass(frozen=True)
class Regime:
    """An eccentricity, and the contact that belongs to it: its middle and half-width."""

    eccentricity: sp.Expr
    middle: sp.Expr
    width: sp.Expr
    domain: Domain

    @property
    def xi(self) -> sp.Expr:
        """The distance from the middle, from one edge to the other."""
        return self.width * (2 * PLACE - 1)


TOUCHING = Regime(a * (SHARE - sp.S.Half), sp.S.Zero, a, Domain((PLACE, 1), (SHARE, 1)))
LIFTED = Regime(a - half / 2, a - half, half, Domain((PLACE, 1), (half, a)))
DISTANCE = sp.Abs(e)
REGIONS = {(DISTANCE, a / 2): TOUCHING, (a / 2, DISTANCE): LIFTED}


class Tilted:
    """The two regimes of the entries: touching all over, and one edge lifted."""

    def __init__(self, entries: dict[str, Entry]) -> None:
        self.entries = entries

    def _expr(self, suffix: str, regime: Regime, place: sp.Expr | None = None) -> sp.Expr:
        """The formula at a place, which is one of the contact if nothing else is said."""
        require_regions(self.entries[suffix], tuple(REGIONS))
        (expr,) = (case.expr for case in self.entries[suffix].cases if REGIONS[case.chain] is regime)
        place = regime.middle + regime.xi if place is None else place

        def signed(inside: sp.Expr) -> int:
            found = sign(sp.expand(inside), regime.domain)
            if found == 0:
                message = f"the sign of {inside} is not shown"
                raise NotProvedError(message)
            return found

        def greater(*terms: sp.Expr) -> sp.Expr:
            """Of zero and a term."""
            (term,) = (term for term in terms if term != 0)
            return term if signed(term) > 0 else NOTHING

        moved = expr.subs({e: regime.eccentricity, x: place}, simultaneous=True)
        moved = moved.replace(sp.Abs, lambda inside: signed(inside) * inside).replace(sp.sign, signed)
        return moved.replace(sp.Max, greater)

    def _mirrored(self, suffix: str, parity: int) -> str:
        """With an edge lifted the contact for e < 0 is the mirror image of that for e > 0."""
        for case in self.entries[suffix].cases:
            mirrored = case.expr.subs({x: -x, e: -e}, simultaneous=True)
            if sp.expand(mirrored - parity * case.expr) != 0:
                message = f"{suffix} is not mirrored by x -> -x, e -> -e"
                raise NotProvedError(message)
        return f"{suffix} for e < 0 is the mirror image"

    def _numerator(self, regime: Regime) -> tuple[sp.Expr, sp.Expr]:
        """alpha and beta: p sqrt(c^2 - xi^2) is a polynomial of first degree."""
        domain = regime.domain
        weighted = self._expr("p", regime) * sp.sqrt(regime.width**2 - regime.xi**2)
        arithmetic = tower(domain, weighted)
        plain = sp.expand(arithmetic.expr(arithmetic.collect(arithmetic.convert(weighted))))
        beta = sp.expand(sp.diff(plain, PLACE) / (2 * regime.width))
        if beta.has(PLACE):
            message = "p sqrt(c^2 - xi^2) is not of first degree in xi"
            raise NotProvedError(message)
        return plain.subs(PLACE, sp.S.Half), beta

    def pressure(self) -> list[str]:
        """p carries P with the moment P e; it is positive at both edges, or vanishes at a lifted one and beyond."""
        steps = [self._mirrored("p", 1)]
        for regime in REGIONS.values():
            alpha, beta = self._numerator(regime)
            domain, width, xi = regime.domain, regime.width, regime.xi
            root, arc = sp.sqrt(width**2 - xi**2), sp.asin(xi / width)
            pressure = self._expr("p", regime)
            load = alpha * arc - beta * root
            moment = -alpha * root + beta * (width**2 * arc - xi * root) / 2
            for power, primitive in enumerate((load, moment)):
                gap = sp.diff(primitive, PLACE) - 2 * width * xi**power * pressure
                steps.append(require_zero(gap, domain, f"d/dxi of the antiderivative = xi^{power} p"))
            ends = [at(primitive, PLACE, sp.S.One) - at(primitive, PLACE, sp.S.Zero) for primitive in (load, moment)]
            steps.append(require_zero(ends[0] - P, domain, "int p dx = P"))
            balance = ends[1] + regime.middle * P - regime.eccentricity * P
            steps.append(require_zero(balance, domain, "int x p dx = P e"))
            edges = [alpha - beta * width, alpha + beta * width]
            if regime is LIFTED:
                steps.append(require_zero(edges[0], domain, "p = 0 at the lifted edge"))
            elif any(sign(edge, domain) <= 0 for edge in edges):
                message = "p > 0 at both edges for abs(e) < a/2 is not shown"
                raise NotProvedError(message)
        beyond = self._expr("p", LIFTED, -a + 2 * (a - half) * PLACE)
        require_analytic(beyond, LIFTED.domain)
        nothing = at(beyond, NOTHING, sp.S.Zero)
        return [*steps, require_zero(nothing, LIFTED.domain, "p = 0 where the punch has lifted")]

    def inclination(self) -> list[str]:
        """phi belongs to the pressure by Plemelj's formula, and changes its sign with e."""
        steps = [self._mirrored("phi", -1)]
        for regime in REGIONS.values():
            alpha, beta = self._numerator(regime)
            domain = regime.domain
            jump = self._expr("p", regime) - (alpha + beta * regime.xi) / sp.sqrt(regime.width**2 - regime.xi**2)
            steps.append(require_zero(jump, domain, "Phi jumps by -2 pi i p across the contact"))
            gap = self._expr("phi", regime) - 2 / (sp.pi * E_star) * sp.pi * beta
            steps.append(require_zero(gap, domain, "phi = 2/(pi E*) pi beta, with -pi beta the principal value"))
        return steps

    def width(self) -> list[str]:
        """The contact width is twice the half-width c, touching all over and with an edge lifted."""
        steps = [self._mirrored("cw", 1)]
        for regime in REGIONS.values():
            gap = self._expr("cw", regime) - 2 * regime.width
            steps.append(require_zero(gap, regime.domain, "contact width = 2 c"))
        return steps
