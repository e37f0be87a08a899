"""Rules for compact contact: what has to be shown for depth, force, pressure, displacement and their relatives.

Every quantity but the depth is an integral whose upper limit is the contact
radius, so that its derivative in a and one end value determine it.
"""

from __future__ import annotations

import itertools

import sympy as sp

from ...abel.form import Chain, insert
from ...entry import Case, Entry, Primitive
from ...notation import a, r, t, x
from ...physics.consequences import GROWTH, Consequence
from ...physics.medium import HOMOGENEOUS, Medium
from ...profiles.profile import Profile
from ..algebra.domain import Domain, NotProvedError, require
from ..algebra.functions import require_analytic
from ..algebra.identity import at, is_zero, logarithmic
from ..statement import closed, require_integral, require_regions, require_zero, summand


class Compact:
    """The entries of one profile and the domains of their cases."""

    base = "d"
    """The quantity that antiderivatives prove; its growth with a decides all others."""
    points: tuple[sp.Symbol, ...] = (r,)
    """Where a field is asked for."""

    def __init__(
        self, profile: Profile, entries: dict[str, Entry], medium: Medium = HOMOGENEOUS, bounds: tuple[Chain, ...] = ()
    ) -> None:
        self.profile, self.entries = profile, entries
        self.medium, self.bounds = medium, bounds
        self._domains: dict[Chain, Domain] = {}

    def domain(self, chain: Chain) -> Domain:
        """The chain of a case together with what the profile says about its parameters."""
        if chain not in self._domains:
            rules = [(rule.left, rule.right) for rule in self.profile.rules if rule.right.is_Symbol]
            known = [pair for pair in rules if pair[0].is_Symbol or pair[0].is_Number]
            self._domains[chain] = Domain(chain, self.profile.chain, *known, *self.bounds)
        return self._domains[chain]

    def entry(self, suffix: str) -> Entry:
        """The closed entry of a quantity."""
        return closed(self.entries[suffix])

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
        """(11.29), (11.61) by antiderivatives in x, piece by piece, or by the integral that defines a function."""
        kernel = "a/sqrt(a^2 - x^2)" if self.medium.k == 0 else "a^(1-k) (a^2 - x^2)^((k-1)/2)"
        return self._by_antiderivatives(f"f'(x) {kernel}")

    def integrand(self, slope: sp.Expr) -> sp.Expr:
        """What (11.29), (11.61) integrate over x, with `slope` for f'(x)."""
        k = self.medium.k
        return a ** (1 - k) * slope * (a**2 - x**2) ** ((k - 1) / 2)

    def _by_definition(self, rest: sp.Expr, integrand: sp.Expr, chain: Chain) -> str:
        """With x = a t the integrand is that of the functions of the rest over 0 < t < 1."""
        require(len(self._intervals(chain)) <= 1, "the antiderivatives at hand leave {}", integrand)
        domain = Domain((t, 1), *self.domain(chain).chains())
        return require_integral(rest, a * integrand.subs(x, a * t), t, domain)

    def _by_antiderivatives(self, integrand: str) -> list[str]:
        entry, steps = self.entry(self.base), []
        require_regions(entry, self._regimes())
        for case in entry.cases:
            primitives = entry.primitives.get(case.chain, ())
            domain, expr = self.domain(case.chain), summand(case.expr)
            require_analytic(expr, domain)
            rest = expr - sp.Add(*(self._increment(primitive, case.chain) for primitive in primitives))
            for lower, upper, face in self._intervals(case.chain):
                missing = self._without_antiderivative(primitives, case.chain, (lower, upper), face)
                if missing != 0:
                    steps.append(self._by_definition(rest, missing, case.chain))
                    break
                steps.append(f"d/dx of the antiderivative = {integrand} on {lower} < x < {upper}")
            else:
                statement = f"{self.base} = sum of the increments of the antiderivatives"
                steps.append(require_zero(rest, domain, statement))
        return steps

    def _regimes(self) -> tuple[Chain, ...]:
        """Every place of a among the breaks; a truncated profile has none below its first break."""
        fixed = self.profile.chain or self.profile.breaks
        if a in fixed:
            return (fixed,)
        return tuple(insert(fixed, a, above=self.profile.breaks[0] if self.profile.truncated else None))

    def _intervals(self, chain: Chain) -> list[tuple[sp.Expr, sp.Expr, sp.Expr]]:
        """The pieces of the profile inside the contact, in x."""
        inner = [b for b in self.profile.breaks if b in chain and chain.index(b) < chain.index(a)]
        ends = [sp.S.Zero, *inner, a]
        faces = (summand(piece.expr).subs(r, x) for piece in self.profile.pieces)
        return list(zip(ends, ends[1:], faces, strict=False))

    def _increment(self, primitive: Primitive, chain: Chain) -> sp.Expr:
        ends = [sp.S.Zero, *(upper for _, upper, _ in self._intervals(chain))]
        if (primitive.lo, primitive.hi) not in itertools.combinations(ends, 2):
            message = f"the antiderivative from {primitive.lo} to {primitive.hi} does not end at breaks of the profile"
            raise NotProvedError(message)
        for point in ends[1:]:
            at(primitive.expr, x, point)
        return at(primitive.expr, x, primitive.hi) - at(primitive.expr, x, primitive.lo)

    def _without_antiderivative(
        self, primitives: tuple[Primitive, ...], chain: Chain, interval: tuple[sp.Expr, sp.Expr], face: sp.Expr
    ) -> sp.Expr:
        """What the antiderivatives leave of the integrand on one interval."""
        lower, upper = interval
        place = chain.index(upper)
        domain = self.domain((*chain[:place], x, *chain[place:]))
        order = (sp.S.Zero, *chain)
        active = [
            p for p in primitives if order.index(p.lo) <= order.index(lower) and order.index(upper) <= order.index(p.hi)
        ]
        # the integral of the slope is that of the face only where the face has no jump
        require_analytic(face, domain)
        integrand = self.integrand(sp.diff(face, x))
        for primitive in active:
            require_analytic(primitive.expr, domain)
            statement = f"d/dx ({primitive.expr}) = {primitive.integrand}"
            require_zero(sp.diff(primitive.expr, x) - primitive.integrand, domain, statement)
        missing = integrand - sp.Add(*(primitive.integrand for primitive in active))
        return sp.S.Zero if is_zero(missing, domain) else missing

    # integrals up to a

    def force(self) -> list[str]:
        """F grows with a by the stiffness of a flat punch times g'(a), from zero where the contact begins."""
        rule = "2 E* a" if self.medium.k == 0 else "2 H a^(1+k)/(1 + k)"
        return self._grown("F", self.medium.stiffness(), f"dF/da = {rule} g'(a)", lambda chain: [chain])

    def pressure(self) -> list[str]:
        """p grows with a by the pressure of a flat punch of unit depth times g'(a), from zero at a = r."""
        rule = "E*/(pi sqrt(a^2 - r^2))" if self.medium.k == 0 else "H/pi (a^2 - r^2)^((k-1)/2)"
        unit, places = self.medium.punch_pressure(), lambda chain: list(insert(chain, r, below=a))
        return self._grown("p", unit, f"dp/da = {rule} g'(a)", places)

    def displacement(self) -> list[str]:
        """w grows with a by that of a flat punch of unit depth times g'(a), from zero where the contact begins."""
        rule = "2/pi asin(a/r)" if self.medium.k == 0 else "cos(k pi/2)/pi B(a^2/r^2; (1+k)/2, (1-k)/2)"
        unit, places = self.medium.punch_displacement().expr(), lambda chain: list(insert(chain, r, above=a))
        return self._grown("w", unit, f"dw/da = {rule} g'(a)", places)

    def _grown(self, suffix, unit, statement, chains) -> list[str]:  # type: ignore[no-untyped-def]
        """While the contact grows by da, a flat punch of unit depth is added g'(a) da times."""
        return self._integral(suffix, lambda slope: unit * slope, statement, chains)

    def _integral(self, suffix, derivative, statement, chains) -> list[str]:  # type: ignore[no-untyped-def]
        entry, steps = self.entry(suffix), []
        require_regions(entry, tuple(chain for regime in self._regimes() for chain in chains(regime)))
        for case in entry.cases:
            domain, expr = self.domain(case.chain), summand(case.expr)
            require_analytic(expr, domain)
            slope = sp.diff(self.depth_of(case.chain), a)
            steps.append(require_zero(sp.diff(expr, a) - derivative(slope), domain, statement))
            steps.append(self._end_value(entry, case, expr))
        return steps

    def _end_value(self, entry: Entry, case: Case, expr: sp.Expr, start: str = "") -> str:
        """Zero where the contact begins, or another quantity at a place, or the value of the neighbouring case."""
        chain, place = case.chain, case.chain.index(a)
        lower = chain[place - 1] if place else sp.S.Zero
        if start and lower in self.points:
            below = self._beside(start, chain)
            domain_below, statement = self.domain(chain), f"{entry.suffix} -> {start} as a -> {lower}"
        elif lower in (0, *self.points) or (self.profile.truncated and lower == self.profile.breaks[0]):
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
                # a power may be finite only together with the factor before it
                return require_zero(at(sp.powsimp(sp.expand_mul(expr), combine="exp"), a, lower), face, statement)
            difference = at(logarithmic(expr, domain), a, lower) - at(logarithmic(below, domain_below), a, lower)
        return require_zero(difference, face, statement)

    def follows(self, own: Consequence) -> list[str]:
        """A consequence grows with a at its rate, from zero where the contact begins or from what it is at a = r."""
        entry, rate, steps = self.entry(own.suffix), own.grown, list[str]()
        inside = own.compact.place == "inside"
        places = (chain for regime in self._regimes() for chain in (insert(regime, r, below=a) if inside else [regime]))
        require_regions(entry, tuple(places))
        for case in entry.cases:
            domain, expr = self.domain(case.chain), summand(case.expr)
            require_analytic(expr, domain)
            known = {self.entries[need].quantity.symbol: self._beside(need, case.chain) for need in rate.needs}
            slope = rate.slope.subs({GROWTH: sp.diff(self.depth_of(case.chain), a)} | known)
            steps.append(require_zero(sp.diff(expr, a) - slope, domain, rate.statement))
            steps.append(self._end_value(entry, case, expr, rate.start))
        return steps

    def _beside(self, suffix: str, chain: Chain) -> sp.Expr:
        """A quantity without a place on the lengths of a chain."""
        regime = tuple(length for length in chain if length not in self.points)
        return next(summand(own.expr) for own in self.entry(suffix).cases if own.chain == regime)

    # algebra on what is proved

    def stiffness(self) -> list[str]:
        """k g'(a) = dF/da, in every regime."""
        entry, steps = self.entry("k"), []
        require_regions(entry, ((a,),))
        (case,) = entry.cases
        for regime in self.entry("F").cases:
            slopes = sp.diff(summand(regime.expr), a), sp.diff(self.depth_of(regime.chain), a)
            steps.append(require_zero(slopes[0] - case.expr * slopes[1], self.domain(regime.chain), "k g'(a) = dF/da"))
        return steps

    def mean_pressure(self) -> list[str]:
        """pi a^2 p_mean = F, in every regime."""
        entry, steps = self.entry("pm"), []
        require_regions(entry, self._regimes())
        forces = {case.chain: case.expr for case in self.entry("F").cases}
        for case in entry.cases:
            gap = sp.pi * a**2 * summand(case.expr) - summand(forces[case.chain])
            steps.append(require_zero(gap, self.domain(case.chain), "pi a^2 p_mean = F"))
        return steps

    def composition(self, suffix: str, value: sp.Symbol, inner: str, target: str | None) -> list[str]:
        """An inverse or a composed formula: substituting the forward formula gives back a, d or F."""
        entry, steps = self.entry(suffix), []
        results = {case.chain: case.expr for case in self.entry(target).cases} if target else {}
        # both in ascending order
        forwards = sorted(self.entry(inner).cases, key=lambda case: case.chain.index(a))
        for case, forward in zip(entry.cases, forwards, strict=True):
            domain, given = self.domain(forward.chain), forward.expr
            steps += self._range(case, value, forward)
            wanted = results[forward.chain] if target else a
            statement = f"{suffix}({inner}(a)) = {target + '(a)' if target else 'a'}"
            steps.append(require_zero(case.expr.subs(value, given) - wanted, domain, statement))
        return steps

    def _range(self, case: Case, value: sp.Symbol, forward: Case) -> list[str]:
        """The region of the inverse is the range of the forward formula, from one break to the next.

        What has an inverse and is continuous is monotone, so that the values at both ends tell its range.
        """
        domain, given, place = self.domain(forward.chain), forward.expr, forward.chain.index(a)
        region = case.chain or (value,)
        at_value = region.index(value)
        if at_value > 1:
            message = f"{' < '.join(map(str, region))} is no range of {value}"
            raise NotProvedError(message)
        lower = forward.chain[place - 1] if place else sp.S.Zero
        below = region[at_value - 1] if at_value else sp.S.Zero
        gap = at(given, a, lower, domain) - below
        statement = f"{value} = {below} at a = {lower}"
        steps = [require_zero(gap, domain.at(a, lower), statement)]
        above, beyond = region[at_value + 1 :], forward.chain[place + 1 :]
        require(len(above) == len(beyond[:1]), "the region of the inverse does not end where that of {}(a) does", value)
        for high, end in zip(above, beyond, strict=False):
            gap = at(given, a, end, domain) - high
            steps.append(require_zero(gap, domain.at(a, end), f"{value} = {high} at a = {end}"))
        return steps
