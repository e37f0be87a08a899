"""Prescribed pressure: (11.105) with w1D(x) = p_0 a B(1/2, s + 1) (1 - x^2/a^2)^(s + 1/2)/E*.

With x = t min(r, a) the range is 0 < t < 1.  The integral is compared with those
that define the functions of the result; a result without such functions is
compared with an antiderivative.
"""

from __future__ import annotations

import sympy as sp

from ...entry import Case, Entry
from ...notation import E_star, a, p_0, r, sigma, t
from ...profiles.loads import Load
from ..algebra.domain import Domain, require
from ..algebra.functions import require_analytic, sign
from ..algebra.identity import at
from ..statement import Rule, require_integral, require_regions, require_zero

SHIFTED = sp.Symbol("sigma_1", positive=True)
"""1 + s, which is positive."""


class Loads:
    """The displacement of one prescribed pressure."""

    def __init__(self, load: Load, entries: dict[str, Entry]) -> None:
        self.load, self.entries = load, entries

    def displacement(self) -> list[str]:
        """w is the integral (11.105), inside the loaded circle and outside."""
        entry = self.entries["w"]
        require_regions(entry, ((r, a), (a, r)))
        places = {(r, a): "inside", (a, r): "outside"}
        return [f"{places[case.chain]}: {self._case(case)}" for case in entry.cases]

    def _case(self, case: Case) -> str:
        s = self.load.exponent.subs(sigma, SHIFTED - 1)
        expr, domain = case.expr.subs(sigma, SHIFTED - 1), Domain(case.chain, (t, 1))
        require_analytic(expr, domain)
        require(sign(s + 1, domain) > 0, "the pressure of exponent {} has no resultant", s)
        reach = case.chain[0]
        beta = sp.gamma(sp.S.Half) * sp.gamma(s + 1) / sp.gamma(s + sp.Rational(3, 2))
        w1D = p_0 * a * beta / E_star * (1 - (reach * t) ** 2 / a**2) ** (s + sp.S.Half)
        wanted = 2 / sp.pi * w1D * reach / sp.sqrt(r**2 - (reach * t) ** 2)
        power = s + sp.S.Half
        if power.is_Integer:
            return _by_antiderivative(expr, wanted, reach, int(power), domain)
        return require_integral(expr, wanted, t, domain)


def _by_antiderivative(expr: sp.Expr, wanted: sp.Expr, reach: sp.Expr, power: int, domain: Domain) -> str:
    """P_i = int t^(2i)/sqrt(q - t^2) dt: 2 i P_i = (2i - 1) q P_{i-1} - t^(2i-1) sqrt(q - t^2), q = r^2/reach^2."""
    q, scale = r**2 / reach**2, reach**2 / a**2
    moment = sp.asin(t / sp.sqrt(q))
    total = moment
    for i in range(1, power + 1):
        moment = sp.Rational(2 * i - 1, 2 * i) * q * moment - t ** (2 * i - 1) * sp.sqrt(q - t**2) / (2 * i)
        total = total + sp.binomial(power, i) * (-scale) ** i * moment
    factor = (wanted * sp.sqrt(q - t**2)).subs(t, 0)
    require_zero(sp.diff(factor * total, t) - wanted, domain, "d/dt of the antiderivative = integrand of (11.105)")
    value = at(total, t, sp.S.One) - at(total, t, sp.S.Zero)
    return require_zero(expr - factor * value, domain, "w = increment of an antiderivative, x = t min(r, a)")


RULES: dict[str, Rule] = {"w": ((), Loads.displacement)}
