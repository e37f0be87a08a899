"""Viscoelastic half-space: the laws by exact transforms and antiderivatives, the entries by linearity in the modulus.

A law is a sum of terms c t**p exp(-q t); for each of them the Laplace transform
and the factor of a ramp are known in closed form.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from ...abel.form import Chain
from ...abel.masters import IncompleteBeta, Kummer
from ...entry import Case, Entry
from ...notation import E_star, F, a, alpha, d, t_1, t_c, t_h, t_m, time, v, v_2, x
from ...physics.viscoelastic import LAWS, Law, in_radius
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
    """The factor of a ramp, int_0^1 m x^(m-1) E(t (1 - x)) dx + impulse m/t."""
    return _counted(law, time, law.ramp - law.impulse * POWER / time, "ramp factor")


def kept(law: Law) -> list[str]:
    """The factor of a ramp that counts up to t_1, int_0^1 m x^(m-1) E(t - t_1 x) dx: no impulse at t is in it."""
    return _counted(law, t_1, law.kept, "factor of the way back")


def _counted(law: Law, until: sp.Symbol, factor: sp.Expr, words: str) -> list[str]:
    """The integral by antiderivatives in x, up to the present or to an earlier time."""
    lasting = () if until == time else (until, time)
    domain, face, total, steps = Domain(BOUNDS, (x, sp.S.One), lasting), Domain(BOUNDS, lasting), sp.S.Zero, []
    for constant, power, rate in terms(law.relaxation):
        antiderivative = _antiderivative(power, rate, until)
        kernel = POWER * x ** (POWER - 1) * (1 - until / time * x) ** power * sp.exp(-rate * (time - until * x))
        statement = f"d/dx of the antiderivative = {kernel}"
        steps.append(require_zero(sp.diff(antiderivative, x) - kernel, domain, statement))
        steps.append(require_zero(at(antiderivative, x, sp.S.Zero), domain, "it vanishes at x = 0"))
        total += constant * time**power * at(antiderivative, x, sp.S.One, face)
    statement = f"{words} = int_0^1 m x^(m-1) E(t - {until} x) dx = {factor}"
    return [*steps, require_zero(total - factor, face, statement)]


def _antiderivative(power: sp.Expr, rate: sp.Expr, until: sp.Symbol) -> sp.Expr:
    """For a fading term and for a power; its derivative refuses what is both."""
    if power == 0:
        return x**POWER * sp.exp(-rate * (time - until * x)) * Kummer(1, POWER + 1, -rate * until * x)
    return POWER * (until / time) ** -POWER * IncompleteBeta(until / time * x, POWER, power + 1)


def memory(law: Law) -> list[str]:
    """I(t) is the integral of E with its impulse."""
    domain = Domain(BOUNDS)
    gap = sp.diff(law.memory, time) - law.relaxation
    return [
        require_zero(gap, domain, "I'(t) = E(t)"),
        require_zero(at(law.memory, time, sp.S.Zero, domain) - law.impulse, domain, "I(0+) is the impulse of E"),
    ]


def solved(law: Law, expr: sp.Expr, before: sp.Expr, now: sp.Symbol) -> list[str]:
    """The times at which the contact is as large as before: an equation in I, or what its v_2 leads back to."""
    past, held, back = (law.memory.subs(time, now - start) for start in (before, t_m, t_h))
    words = "int E(t - s) d'(s) ds = 0, t_1 < s < t, d' = v, 0, -v_2: I(t - t_1) = I(t - t_m) + v_2/v I(t - t_h)"
    domain = Domain(BOUNDS, (before, t_m, t_h, now) if before.is_Symbol else (t_m, t_h, now))
    if isinstance(expr, sp.Eq):
        gaps = expr.lhs - past, expr.rhs - held - v_2 / v * back
        return [*memory(law), *(require_zero(gap, domain, words) for gap in gaps)]
    unknown = before if before.is_Symbol else now
    gap = _of_exponentials(expr.subs(v_2, v * (past - held) / back)) - unknown
    return [*memory(law), require_zero(gap, domain, f"{words}, solved for v_2, gives {unknown} again")]


def _of_exponentials(expr: sp.Expr) -> sp.Expr:
    """Logarithms of what is one product of exponentials, by exact division, as their exponents."""
    bases: dict[sp.Expr, sp.Symbol] = {}

    def product(exponent: sp.Expr) -> sp.Expr:
        parts = (term.as_coeff_Mul() for term in sp.Add.make_args(sp.expand(exponent)))
        return sp.Mul(*(bases.setdefault(unit, sp.Dummy(positive=True)) ** times for times, unit in parts))

    def exponent(argument: sp.Expr) -> sp.Expr:
        single = sp.cancel(argument.replace(sp.exp, product))
        units = {base: unit for unit, base in bases.items()}
        factors = [factor.as_base_exp() for factor in sp.Mul.make_args(single)]
        if any(base not in units for base, _ in factors):
            return sp.log(argument)
        return sp.Add(*(times * units[base] for base, times in factors))

    return expr.replace(sp.log, exponent)


def _in_time(chain: Chain) -> Chain:
    """Times t_1 at which the depth is v t_1, in the order of depths."""
    return tuple((t_1 if depth == d else depth / v) for depth in chain) if d in chain else chain


class Viscoelastic:
    """The viscoelastic entries of one profile, above those of its elastic contact."""

    def __init__(self, normal: Compact | Complete, entries: dict[str, Entry]) -> None:
        self.normal, self.entries = normal, entries
        self.force_of_radius = normal.entries["F"]
        self.force = normal.entries.get("Fd", self.force_of_radius)
        self.laws = {law.suffix: law for law in LAWS}

    def domain(self, case: Case) -> Domain:
        """The symbols of the chain of a case in their order, and alpha < 1."""
        return Domain(tuple(length for length in case.chain if length.is_Symbol), BOUNDS)

    def _law(self, suffix: str) -> Law:
        return self.laws[suffix.split("_")[1]]

    def ramp(self, suffix: str) -> list[str]:
        """F at d = v t is F_el/E* times the ramp factor of the law, F_el being a power of d, or that of springs."""
        law = self._law(suffix)
        if in_radius(self.entries[suffix]):
            return self._of_springs(suffix, law.impulse)
        return [duality(law), *ramp(law), *self._of_power(suffix, (), time, law.ramp, "the ramp factor")]

    def retract(self, suffix: str) -> list[str]:
        """F is F_el/E* at d = v t_1 times the factor of the way back, F_el being a power of d, or that of springs."""
        law = self._law(suffix)
        if in_radius(self.entries[suffix]):
            return self._of_springs(suffix, sp.S.Zero)
        words = "the factor of the way back"
        return [duality(law), *kept(law), *self._of_power(suffix, (t_1, t_m, t_h, time), t_1, law.kept, words)]

    def _of_springs(self, suffix: str, impulse: sp.Expr) -> list[str]:
        """F of a law that does not fade is E F_el/E*, and v dF_el/dd times its impulse at the present."""
        law, entry, steps = self._law(suffix), closed(self.entries[suffix]), list[str]()
        require(not law.relaxation.has(time), "{} fades", law.relaxation)
        depths = paired(closed(self.normal.entries["d"]), closed(self.force_of_radius))
        for (case, elastic), (sunk, _) in zip(paired(entry, self.force_of_radius), depths, strict=True):
            domain, slope = self.domain(case), sp.diff(sunk.expr, a)
            gap = sp.diff(elastic.expr, a) - 2 * E_star * a * slope
            steps += [self._linear(elastic), require_zero(gap, domain, "dF_el/dd = 2 E* a")]
            wanted = elastic.expr / E_star * law.relaxation + 2 * a * v * impulse
            steps.append(require_zero(case.expr - wanted, domain, f"F = F_el(a)/E* E + {impulse} v dF_el/dd/E*"))
        return [duality(law), *steps]

    def _of_power(
        self, suffix: str, chain: tuple[sp.Symbol, ...], until: sp.Symbol, factor: sp.Expr, words: str
    ) -> list[str]:
        (elastic,), case = closed(self.force).cases, self._case(suffix, chain)
        domain = self.domain(elastic)
        steps = [self._linear(elastic)]
        exponent = normal(d * sp.diff(elastic.expr, d) / elastic.expr, domain)
        require(
            not exponent.has(d) and sign(exponent, domain) > 0, "{} is not shown to be a power of d", self.force.key
        )
        wanted = elastic.expr.subs(d, v * until) / E_star * factor.subs(POWER, exponent)
        statement = f"with d = v {until}, F = F_el/E* times {words} for F_el ~ d^({exponent})"
        return [*steps, require_zero(case.expr - wanted, Domain(*domain.chains(), chain), statement)]

    def radius(self, suffix: str) -> list[str]:
        """a is that of the elastic contact at d = v t_1, by its formula or by the equation g(a) = d."""
        entry, steps = self.entries[suffix], list[str]()
        if entry.status == "root":
            for case, elastic in paired(entry, closed(self.normal.entries["d"])):
                for gap in (case.expr.lhs - elastic.expr, case.expr.rhs - v * t_1):
                    steps.append(require_zero(gap, self.domain(case), "g(a) = v t_1"))
            return steps
        source = closed(self.normal.entries["ad"])
        require_regions(entry, tuple(_in_time(case.chain) for case in source.cases))
        for case, elastic in zip(entry.cases, source.cases, strict=True):
            wanted = elastic.expr.subs(d, v * t_1)
            steps.append(require_zero(case.expr - wanted, self.domain(case), "a = a_el(d) at d = v t_1"))
        return steps

    def earlier(self, suffix: str) -> list[str]:
        """t_1 is that of the equation of the way back."""
        return solved(self._law(suffix), self._case(suffix, (t_m, t_h, time)).expr, t_1, time)

    def end(self, suffix: str) -> list[str]:
        """The contact ends as t_1 comes to the first touch."""
        return solved(self._law(suffix), self._case(suffix, (t_m, t_h, t_c)).expr, sp.S.Zero, t_c)

    def _case(self, suffix: str, chain: tuple[sp.Symbol, ...]) -> Case:
        """The only case of an entry, which holds in this order."""
        require_regions(self.entries[suffix], (chain,))
        return self.entries[suffix].cases[0]

    def step(self, suffix: str) -> list[str]:
        """F after a step of depth, given or by an equation, is F_el/E* times the relaxation E(t)."""
        law, entry = self._law(suffix), self.entries[suffix]
        steps, source = [duality(law)], self.force_of_radius if entry.status == "root" else self.force
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
        kind, law = suffix.split("_")
        own: tuple[str, ...] = ("plain.F",) if kind == "step" and entry.status == "root" else (force,)
        if kind in ("ramp", "retract") and in_radius(entry):
            own = ("plain.F", "plain.d")
        radius, back = "plain.d" if entry.status == "root" else "plain.ad", f"earlier_{law}"
        needs = {
            "load": ("plain.aF",), "radius": (radius, back), "retract": (*own, back), "earlier": (), "end": (),
        }  # fmt: skip
        out[suffix] = (needs.get(kind, own), KINDS[kind], suffix)
    return out


KINDS = {
    "ramp": Viscoelastic.ramp, "step": Viscoelastic.step, "load": Viscoelastic.load,
    "earlier": Viscoelastic.earlier, "radius": Viscoelastic.radius, "retract": Viscoelastic.retract,
    "end": Viscoelastic.end,
}  # fmt: skip
