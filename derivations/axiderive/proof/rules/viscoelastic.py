"""Viscoelastic half-space: the laws by exact transforms and antiderivatives, the entries by linearity in the modulus.

A law is a sum of terms c t**p exp(-q t); for each of them the Laplace transform
and the factor of a ramp are known in closed form.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from ...abel.masters import IncompleteBeta, Kummer
from ...entry import Case, Entry
from ...notation import E_star, F, alpha, d, time, v, x
from ...physics.viscoelastic import LAWS, Law
from ..algebra.domain import Domain, require
from ..algebra.functions import normal, require_analytic, sign
from ..algebra.identity import at
from ..statement import Rule, closed, paired, require_regions, require_zero
from .compact import Compact
from .complete import Complete

BOUNDS = (alpha, sp.S.One)
LAPLACE = sp.Symbol("laplace", positive=True)
POWER = sp.Symbol("m", positive=True)
"""F_el ~ d**m, the symbol of contact.viscoelastic."""


def terms(expr: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """(c, p, q) of the terms c t**p exp(-q t)."""
    for term in sp.Add.make_args(sp.expand_mul(sp.expand_power_base(expr), deep=False)):
        constant, varying = term.as_independent(time, as_Add=False)
        power, rate = sp.S.Zero, sp.S.Zero
        for factor in sp.Mul.make_args(varying):
            if isinstance(factor, sp.exp):
                rate = rate - factor.args[0] / time
            else:
                base, exponent = factor.as_base_exp()
                power = power + exponent if base == time else sp.nan if factor != 1 else power
        require(not power.has(time, sp.nan) and not rate.has(time), "{} is not c t^p exp(-q t)", term)
        yield constant, power, rate


def transform(expr: sp.Expr, domain: Domain) -> sp.Expr:
    """Laplace transform, term by term: c Gamma(p + 1)/(s + q)**(p + 1), for p > -1."""
    total = sp.S.Zero
    for constant, power, rate in terms(expr):
        require(sign(power + 1, domain) > 0, "t^({}) has no Laplace transform", power)
        total += constant * sp.gamma(power + 1) / (LAPLACE + rate) ** (power + 1)
    return total


def duality(law: Law) -> str:
    """Creep and relaxation belong to one material."""
    domain = Domain(BOUNDS)
    product = LAPLACE**2 * transform(law.creep, domain) * (transform(law.relaxation, domain) + law.impulse)
    return require_zero(product - 1, domain, "s^2 J~(s) E~(s) = 1 for the Laplace transforms of creep and relaxation")


def ramp(law: Law) -> list[str]:
    """The factor of a ramp, int_0^1 m x^(m-1) E(t (1 - x)) dx + impulse m/t, by antiderivatives in x."""
    domain, total, steps = Domain(BOUNDS, (x, sp.S.One)), law.impulse * POWER / time, []
    for constant, power, rate in terms(law.relaxation):
        antiderivative = _antiderivative(power, rate)
        kernel = POWER * x ** (POWER - 1) * (1 - x) ** power * sp.exp(-rate * time * (1 - x))
        statement = f"d/dx of the antiderivative = {kernel}"
        steps.append(require_zero(sp.diff(antiderivative, x) - kernel, domain, statement))
        steps.append(require_zero(at(antiderivative, x, sp.S.Zero), domain, "it vanishes at x = 0"))
        total += constant * time**power * at(antiderivative, x, sp.S.One, Domain(BOUNDS))
    statement = f"ramp factor = int_0^1 m x^(m-1) E(t (1 - x)) dx = {law.ramp}"
    return [*steps, require_zero(total - law.ramp, Domain(BOUNDS), statement)]


def _antiderivative(power: sp.Expr, rate: sp.Expr) -> sp.Expr:
    """For a fading term and for a power; its derivative refuses what is both."""
    if power == 0:
        return x**POWER * sp.exp(-rate * time * (1 - x)) * Kummer(1, POWER + 1, -rate * time * x)
    return POWER * IncompleteBeta(x, POWER, power + 1)


class Viscoelastic:
    """The viscoelastic entries of one profile, above those of its elastic contact."""

    def __init__(self, normal: Compact | Complete, entries: dict[str, Entry]) -> None:
        self.normal, self.entries = normal, entries
        self.force = normal.entries["Fd" if "Fd" in normal.entries else "F"]
        self.laws = {law.suffix: law for law in LAWS}

    def domain(self, case: Case) -> Domain:
        """The symbols of the chain of a case in their order, and alpha < 1."""
        return Domain(tuple(length for length in case.chain if length.is_Symbol), BOUNDS)

    def _law(self, suffix: str) -> Law:
        return self.laws[suffix.split("_")[1]]

    def ramp(self, suffix: str) -> list[str]:
        """F at d = v t is F_el/E* times the ramp factor of the law, F_el being a power of d."""
        law, (elastic,) = self._law(suffix), closed(self.force).cases
        require_regions(self.entries[suffix], ((),))
        (case,) = self.entries[suffix].cases
        domain = self.domain(elastic)
        steps = [duality(law), *ramp(law), self._linear(elastic)]
        exponent = normal(d * sp.diff(elastic.expr, d) / elastic.expr, domain)
        require(
            not exponent.has(d) and sign(exponent, domain) > 0, "{} is not shown to be a power of d", self.force.key
        )
        wanted = elastic.expr.subs(d, v * time) / E_star * law.ramp.subs(POWER, exponent)
        statement = f"with d = v t, F = F_el/E* times the ramp factor for F_el ~ d^({exponent})"
        return [*steps, require_zero(case.expr - wanted, domain, statement)]

    def step(self, suffix: str) -> list[str]:
        """F after a step of depth, given or by an equation, is F_el/E* times the relaxation E(t)."""
        law, entry = self._law(suffix), self.entries[suffix]
        steps, source = [duality(law)], self.normal.entries["F"] if entry.status == "root" else self.force
        for case, elastic in paired(entry, closed(source)):
            wanted = elastic.expr / E_star * law.relaxation
            steps.append(self._linear(elastic))
            force = case.expr
            if entry.status == "root":
                steps.append(require_zero(force.lhs - F, self.domain(case), "the left side is F"))
                force = force.rhs
            gap = force - wanted
            steps.append(require_zero(gap, self.domain(case), "F = F_el/E* E(t) after a step of depth, t > 0"))
        return steps

    def load(self, suffix: str) -> list[str]:
        """F_el(a)/E* = J(t) F: the radius depends on F/E* alone."""
        law, entry = self._law(suffix), self.entries[suffix]
        steps = [duality(law)]
        for case, elastic in paired(entry, closed(self.normal.entries["aF"])):
            wanted = elastic.expr.subs(E_star, 1 / law.creep)
            require_analytic(wanted, self.domain(case))
            gap = case.expr - wanted
            steps.append(require_zero(gap, self.domain(case), "a = a_el(F) with 1/J(t) for E*, after a step of load"))
        return steps

    def _linear(self, elastic: Case) -> str:
        gap = E_star * sp.diff(elastic.expr, E_star) - elastic.expr
        return require_zero(gap, self.domain(elastic), "F_el is proportional to E*")


def rules(entries: dict[str, Entry], normal_entries: dict[str, Entry]) -> dict[str, Rule]:
    """One rule per kind of loading, for every law."""
    force = "plain.Fd" if "Fd" in normal_entries else "plain.F"
    out: dict[str, Rule] = {}
    for suffix, entry in entries.items():
        kind = suffix.split("_")[0]
        own = "plain.F" if kind == "step" and entry.status == "root" else force
        out[suffix] = (("plain.aF" if kind == "load" else own,), KINDS[kind], suffix)
    return out


KINDS = {"ramp": Viscoelastic.ramp, "step": Viscoelastic.step, "load": Viscoelastic.load}
