"""Rules for compact contact: what has to be shown for depth, force, pressure, displacement and their relatives.

Every quantity but the depth is an integral whose upper limit is the contact
radius, so that its derivative in a and one end value determine it.
"""

from __future__ import annotations

import sympy as sp

from ..abel.order import Chain, insert
from ..entry import Case, Entry, Primitive
from ..notation import E_star, N, a, coefficients, j, r, x
from ..profiles.profile import Profile
from .domain import Domain, NotProvedError
from .functions import require_analytic, sign
from .identity import at, is_zero, logarithmic


def require_zero(expr: sp.Expr, domain: Domain, statement: str) -> str:
    """The statement as a step of the certificate, if the expression vanishes on the domain."""
    if not is_zero(expr, domain) and not (expr.has(sp.log) and is_zero(logarithmic(expr, domain), domain)):
        message = f"{statement} does not hold"
        raise NotProvedError(message)
    return statement


def summand(expr: sp.Expr) -> sp.Expr:
    """The term of a sum over powers with coefficient 1: all results are linear in the profile."""
    sums = expr.atoms(sp.Sum)
    if not sums:
        return expr
    (total,) = sums
    factor = expr.xreplace({total: j}) / j
    term = total.function / coefficients[j]
    if total.limits != ((j, 1, N),) or factor.has(j) or term.has(coefficients):
        message = f"{expr} is not a multiple of one sum over j = 1 ... N of A[j]"
        raise NotProvedError(message)
    return factor * term


class Compact:
    """The entries of one profile and the domains of their cases."""

    base = "d"
    """The quantity that antiderivatives prove; its growth with a decides all others."""
    points: tuple[sp.Symbol, ...] = (r,)
    """Where a field is asked for."""

    def __init__(self, profile: Profile, entries: dict[str, Entry]) -> None:
        self.profile = profile
        self.entries = entries
        self._domains: dict[Chain, Domain] = {}

    def domain(self, chain: Chain) -> Domain:
        """The chain of a case together with what the profile says about its parameters."""
        if chain not in self._domains:
            rules = [(rule.left, rule.right) for rule in self.profile.rules if rule.right.is_Symbol]
            known = [pair for pair in rules if pair[0].is_Symbol or pair[0].is_Number]
            self._domains[chain] = Domain(chain, self.profile.chain, *known)
        return self._domains[chain]

    def entry(self, suffix: str) -> Entry:
        entry = self.entries[suffix]
        if entry.status != "closed":
            reasons = {"integral": "an integral without a known closed form", "root": "the root of an equation"}
            message = f"{entry.key} is {reasons[entry.status]}"
            raise NotProvedError(message)
        return entry

    def depth_of(self, chain: Chain) -> sp.Expr:
        """g, or what else is the base, on the regime a chain belongs to."""
        regime = tuple(length for length in chain if length not in self.points)
        for case in self.entry(self.base).cases:
            if case.chain == regime:
                return summand(case.expr)
        message = f"no {self.base} is given for {' < '.join(map(str, regime))}"
        raise NotProvedError(message)

    # depth

    def depth(self) -> list[str]:
        """(11.29) by antiderivatives in x, piece by piece."""
        return self._by_antiderivatives("a f'(x)/sqrt(a^2 - x^2)")

    def integrand(self, slope: sp.Expr) -> sp.Expr:
        return a * slope / sp.sqrt(a**2 - x**2)

    def _by_antiderivatives(self, integrand: str) -> list[str]:
        entry, steps = self.entry(self.base), []
        self._require_regimes(entry)
        for case in entry.cases:
            primitives = entry.primitives.get(case.chain, ())
            total = sp.Add(*(self._increment(primitive, case.chain) for primitive in primitives))
            for lower, upper, slope in self._intervals(case.chain):
                self._require_antiderivative(primitives, case.chain, (lower, upper), slope)
                steps.append(f"d/dx of the antiderivative = {integrand} on {lower} < x < {upper}")
            domain, expr = self.domain(case.chain), summand(case.expr)
            require_analytic(expr, domain)
            statement = f"{self.base} = sum of the increments of the antiderivatives"
            steps.append(require_zero(expr - total, domain, statement))
        return steps

    def _require_regimes(self, entry: Entry) -> None:
        """A case for every place of a among the breaks; a truncated profile has none below its first break."""
        breaks = self.profile.breaks
        found = {tuple(b for b in breaks if b in case.chain and case.below(b, a)) for case in entry.cases}
        wanted = {breaks[:i] for i in range(1 if self.profile.truncated else 0, len(breaks) + 1)}
        if found != wanted:
            message = f"the cases of {entry.key} do not cover every place of a among the breaks once"
            raise NotProvedError(message)

    def _intervals(self, chain: Chain) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """The pieces of the profile inside the contact, with the slope in x."""
        inner = [b for b in self.profile.breaks if b in chain and chain.index(b) < chain.index(a)]
        ends = [sp.S.Zero, *inner, a]
        slopes = (sp.diff(summand(piece.expr), r).subs(r, x) for piece in self.profile.pieces)
        return list(zip(ends, ends[1:], slopes, strict=False))

    def _increment(self, primitive: Primitive, chain: Chain) -> sp.Expr:
        inner = [upper for _, upper, _ in self._intervals(chain)]
        if primitive.hi not in inner or primitive.lo not in [sp.S.Zero, *inner]:
            message = f"the antiderivative from {primitive.lo} to {primitive.hi} does not end at breaks of the profile"
            raise NotProvedError(message)
        for point in inner:
            at(primitive.expr, x, point)
        return at(primitive.expr, x, primitive.hi) - at(primitive.expr, x, primitive.lo)

    def _require_antiderivative(
        self, primitives: tuple[Primitive, ...], chain: Chain, interval: tuple[sp.Expr, sp.Expr], slope: sp.Expr
    ) -> None:
        lower, upper = interval
        place = chain.index(upper)
        domain = self.domain((*chain[:place], x, *chain[place:]))
        order = (sp.S.Zero, *chain)
        active = [
            p for p in primitives if order.index(p.lo) <= order.index(lower) and order.index(upper) <= order.index(p.hi)
        ]
        integrand = self.integrand(slope)
        if slope != 0 and not active:
            message = f"no antiderivative of {integrand} is at hand"
            raise NotProvedError(message)
        for primitive in active:
            require_analytic(primitive.expr, domain)
            statement = f"d/dx ({primitive.expr}) = {primitive.integrand}"
            require_zero(sp.diff(primitive.expr, x) - primitive.integrand, domain, statement)
        missing = integrand - sp.Add(*(primitive.integrand for primitive in active))
        if not is_zero(missing, domain):
            message = f"the antiderivatives at hand leave {missing} on {lower} < x < {upper}"
            raise NotProvedError(message)

    # integrals up to a

    def force(self) -> list[str]:
        return self._integral("F", lambda slope: 2 * E_star * a * slope, "dF/da = 2 E* a g'(a)", lambda chain: [chain])

    def pressure(self) -> list[str]:
        def derivative(slope: sp.Expr) -> sp.Expr:
            return E_star / sp.pi * slope / sp.sqrt(a**2 - r**2)

        return self._integral(
            "p", derivative, "dp/da = E*/pi g'(a)/sqrt(a^2 - r^2)", lambda chain: list(insert(chain, r, below=a))
        )

    def displacement(self) -> list[str]:
        def derivative(slope: sp.Expr) -> sp.Expr:
            return 2 / sp.pi * slope * sp.asin(a / r)

        return self._integral(
            "w", derivative, "dw/da = 2/pi g'(a) asin(a/r)", lambda chain: list(insert(chain, r, above=a))
        )

    def _integral(self, suffix, derivative, statement, chains) -> list[str]:  # type: ignore[no-untyped-def]
        entry, steps = self.entry(suffix), []
        wanted = {chain for regime in self.entry(self.base).cases for chain in chains(regime.chain)}
        if {case.chain for case in entry.cases} != wanted or len(entry.cases) != len(wanted):
            message = f"the cases of {entry.key} do not cover the regimes of {self.base} once"
            raise NotProvedError(message)
        for case in entry.cases:
            domain, expr = self.domain(case.chain), summand(case.expr)
            require_analytic(expr, domain)
            slope = sp.diff(self.depth_of(case.chain), a)
            steps.append(require_zero(sp.diff(expr, a) - derivative(slope), domain, statement))
            steps.append(self._end_value(entry, case, expr))
        return steps

    def _end_value(self, entry: Entry, case: Case, expr: sp.Expr) -> str:
        """Zero where the contact begins, or the value of the neighbouring case."""
        chain, place = case.chain, case.chain.index(a)
        lower = chain[place - 1] if place else sp.S.Zero
        if lower in (0, *self.points) or (self.profile.truncated and lower == self.profile.breaks[0]):
            below, domain_below, statement = sp.S.Zero, None, f"{entry.suffix} -> 0 as a -> {lower}"
        else:
            swapped = (*chain[: place - 1], a, lower, *chain[place + 1 :])
            below = next(summand(other.expr) for other in entry.cases if other.chain == swapped)
            domain_below, statement = self.domain(swapped), f"{entry.suffix} is continuous at a = {lower}"
        domain = self.domain(chain)
        face = domain.at(a, lower)
        try:
            difference = at(expr, a, lower) - at(below, a, lower)
        except NotProvedError:
            if domain_below is None:
                raise
            difference = at(logarithmic(expr, domain), a, lower) - at(logarithmic(below, domain_below), a, lower)
        return require_zero(difference, face, statement)

    # algebra on what is proved

    def stiffness(self) -> list[str]:
        (case,), steps = self.entry("k").cases, []
        for regime in self.entry("F").cases:
            slopes = sp.diff(summand(regime.expr), a), sp.diff(self.depth_of(regime.chain), a)
            steps.append(require_zero(slopes[0] - case.expr * slopes[1], self.domain(regime.chain), "k g'(a) = dF/da"))
        return steps

    def mean_pressure(self) -> list[str]:
        forces, steps = {case.chain: case.expr for case in self.entry("F").cases}, []
        cases = self.entry("pm").cases
        if [case.chain for case in cases] != list(forces):
            message = "the cases of the mean pressure are not those of the force"
            raise NotProvedError(message)
        for case in cases:
            gap = sp.pi * a**2 * summand(case.expr) - summand(forces[case.chain])
            steps.append(require_zero(gap, self.domain(case.chain), "pi a^2 p_mean = F"))
        return steps

    def composition(self, suffix: str, value: sp.Symbol, inner: str, target: str | None) -> list[str]:
        """An inverse or a composed formula: substituting the forward formula gives back a, d or F."""
        entry, steps = self.entry(suffix), []
        results = {case.chain: case.expr for case in self.entry(target).cases} if target else {}
        for forward in self.entry(inner).cases:
            domain, given = self.domain(forward.chain), forward.expr
            case = self._case_for(entry, value, given, domain)
            wanted = results[forward.chain] if target else a
            statement = f"{suffix}({inner}(a)) = {target + '(a)' if target else 'a'}"
            steps.append(require_zero(case.expr.subs(value, given) - wanted, domain, statement))
        return steps

    def _case_for(self, entry: Entry, value: sp.Symbol, given: sp.Expr, domain: Domain) -> Case:
        for case in entry.cases:
            chain = [member.subs(value, given) for member in case.chain]
            if all(sign(high - low, domain) > 0 for low, high in zip(chain, chain[1:], strict=False)):
                return case
        message = f"no case of {entry.key} is shown to hold where {value} = {given}"
        raise NotProvedError(message)
