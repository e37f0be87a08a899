"""Rules for the punch under an eccentric load: equilibrium by antiderivatives, level base by Plemelj's formula.

In the coordinate xi from the middle of the contact, of half-width c, the
pressure is p = (alpha + beta xi)/sqrt(c^2 - xi^2).  The function

    Phi(z) = pi [(alpha + beta z)/sqrt(z^2 - c^2) - beta]

jumps by -2 pi i p across the contact and vanishes at infinity, so it is
int p(s)/(z - s) ds; the mean of its boundary values is the principal value
-pi beta, the same all over the contact.  Both are odd under x -> -x, e -> -e,
so that e > 0 is enough.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Entry
from ..notation import E_star, P, a, e, t, x
from ..notation import c as half
from ..profiles.profile import Profile
from .domain import Domain, NotProvedError
from .functions import sign, tower
from .identity import at
from .statement import require_zero


class Tilted:
    """The two regimes of the entries: touching all over, and one edge lifted."""

    def __init__(self, profile: Profile, entries: dict[str, Entry]) -> None:
        self.entries = entries
        distance = sp.Abs(e)
        wanted = ((distance, a / 2), (a / 2, distance))
        for entry in entries.values():
            if tuple(case.chain for case in entry.cases) != wanted:
                message = f"the cases of {entry.key} do not change at abs(e) = a/2"
                raise NotProvedError(message)
        # touching: every t > 0 gives an e < a/2, c = a; lifted: e = a - c/2 > a/2, the middle of the contact at a - c
        touching, lifted = a**2 / (2 * (a + t)), a - half / 2
        self.regimes = (
            (touching, a, sp.S.Zero, Domain((x, a))),
            (lifted, half, a - half, Domain((x, half, a))),
        )

    def _expr(self, suffix: str, regime: int) -> sp.Expr:
        """The formula for e > 0, with x counted from the middle of the contact."""
        eccentricity, _, middle, domain = self.regimes[regime]
        expr = self.entries[suffix].cases[regime].expr
        moved = expr.replace(sp.sign, lambda _: sp.S.One).replace(sp.Abs, lambda inside: inside)
        moved = moved.subs(e, eccentricity).subs(x, x + middle)

        def positive(*terms: sp.Expr) -> sp.Expr:
            (term,) = (sp.expand(term) for term in terms if term != 0)
            if sign(term, domain) <= 0:
                message = f"{term} > 0 is not shown"
                raise NotProvedError(message)
            return term

        return moved.replace(sp.Max, positive)

    def _odd(self, suffix: str, parity: int) -> str:
        for case in self.entries[suffix].cases:
            mirrored = case.expr.subs({x: -x, e: -e}, simultaneous=True)
            if sp.expand(mirrored - parity * case.expr) != 0:
                message = f"{suffix} is not mirrored by x -> -x, e -> -e"
                raise NotProvedError(message)
        return f"{suffix} for e < 0 is the mirror image"

    def _numerator(self, regime: int) -> tuple[sp.Expr, sp.Expr]:
        """alpha and beta: p sqrt(c^2 - xi^2) is a polynomial of first degree."""
        _, width, _, domain = self.regimes[regime]
        weighted = self._expr("p", regime) * sp.sqrt(width**2 - x**2)
        arithmetic = tower(domain, weighted)
        plain = sp.expand(arithmetic.expr(arithmetic.collect(arithmetic.convert(weighted))))
        beta = sp.diff(plain, x)
        if beta.has(x):
            message = "p sqrt(c^2 - xi^2) is not of first degree in xi"
            raise NotProvedError(message)
        return plain.subs(x, 0), beta

    def pressure(self) -> list[str]:
        steps = [self._odd("p", 1)]
        for regime, (eccentricity, width, middle, domain) in enumerate(self.regimes):
            alpha, beta = self._numerator(regime)
            root, arc = sp.sqrt(width**2 - x**2), sp.asin(x / width)
            pressure = self._expr("p", regime)
            load = alpha * arc - beta * root
            moment = -alpha * root + beta * (width**2 * arc - x * root) / 2
            for power, primitive in enumerate((load, moment)):
                statement = f"d/dxi of the antiderivative = xi^{power} p"
                steps.append(require_zero(sp.diff(primitive, x) - x**power * pressure, domain, statement))
            ends = [at(primitive, x, width) - at(primitive, x, -width) for primitive in (load, moment)]
            edge = domain.at(x, width)
            steps.append(require_zero(ends[0] - P, edge, "int p dx = P"))
            steps.append(require_zero(ends[1] + middle * P - eccentricity * P, edge, "int x p dx = P e"))
            if regime:
                steps.append(require_zero(alpha - beta * width, edge, "p = 0 at the lifted edge"))
            elif sign(alpha - beta * width, edge) <= 0:
                message = "p > 0 at both edges for abs(e) < a/2 is not shown"
                raise NotProvedError(message)
        return steps

    def inclination(self) -> list[str]:
        steps = [self._odd("phi", -1)]
        for regime, (_, width, _, domain) in enumerate(self.regimes):
            alpha, beta = self._numerator(regime)
            jump = self._expr("p", regime) - (alpha + beta * x) / sp.sqrt(width**2 - x**2)
            steps.append(require_zero(jump, domain, "Phi jumps by -2 pi i p across the contact"))
            gap = self._expr("phi", regime) - 2 / (sp.pi * E_star) * sp.pi * beta
            steps.append(require_zero(gap, domain, "phi = 2/(pi E*) pi beta, with -pi beta the principal value"))
        return steps

    def width(self) -> list[str]:
        return [
            require_zero(self._expr("cw", regime) - 2 * width, domain, "contact width = 2 c")
            for regime, (_, width, _, domain) in enumerate(self.regimes)
        ]
