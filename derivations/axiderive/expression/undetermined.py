"""Algebraic profiles outside the normal form: entries by undetermined coefficients, single integrals where none fit.

One radical or pole y = B + s x**2 stands beside the root of the contact: each integral is a root times polynomials over
powers of y, plus multiples of the few functions with the remaining singularities.  The conditions on the coefficients
are linear.  What they give is a conjecture until the certificate proves it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp

from ..abel.form import Chain
from ..abel.masters import ArctanIntegral
from ..entry import Case, Entry, Primitive
from ..notation import E_star, a, r, u, x
from ..physics import general
from ..physics.medium import HOMOGENEOUS
from ..profiles.profile import Profile

LARGEST_DEGREE = 12
V = sp.Dummy("V", positive=True)
"""The square of the variable."""
HALF = sp.S.Half


class NotSolvableError(ValueError):
    """There is no integral of the form that was tried."""


@dataclass(frozen=True)
class Part:
    """x P(x**2) (B + s x**2)**e of f'(x), with a half-integer or a negative integer e; P alone with s = 0."""

    P: sp.Expr
    B: sp.Expr
    s: sp.Expr
    e: sp.Rational

    @property
    def halved(self) -> bool:
        """Whether the exponent e is half-integer, so that y stands under a root."""
        return bool(self.e.q == 2)

    @property
    def falls(self) -> bool:
        """Whether B - |s| x**2 ends at a radius."""
        return bool(self.s.is_negative)

    def y(self, square: sp.Expr) -> sp.Expr:
        """y = B + s x**2, given the square x**2."""
        return self.B + self.s * square

    @property
    def steep(self) -> sp.Expr:
        """sqrt(|s|), a factor in the arguments of the inverse functions."""
        return sp.sqrt(sp.Abs(self.s))

    @property
    def highest(self) -> int:
        """The largest power of y in a denominator."""
        return max(0, int(sp.ceiling(-self.e)))

    # over the profile

    def angle(self) -> sp.Expr:
        """T with dT/dx = x/(sqrt(a**2 - x**2) y**(1/2 or 1)) that vanishes at x = a."""
        root = sp.sqrt(a**2 - x**2)
        if self.halved:
            turn = sp.atanh if self.falls else sp.atan
            return -turn(self.steep * root / sp.sqrt(self.y(x**2))) / self.steep
        turn, edge = (sp.atan if self.falls else sp.atanh), sp.sqrt(self.y(a**2))
        return -turn(self.steep * root / edge) / (self.steep * edge)

    def primitive(self, weight: sp.Expr) -> sp.Expr:
        """Antiderivative of x P y**e weight/sqrt(a**2 - x**2) that vanishes at x = a; the weight is one in V."""
        tau = HALF if self.halved else sp.S.One
        mu = max(tau - 1, -self.e - 1)
        y = self.y(V)
        wanted = sp.expand(self.P * weight * y ** (self.e + mu + 1))
        Q, unknown = polynomial(max(sp.degree(wanted, V), mu + 1))
        C = sp.Dummy("C")
        own = -Q * y + 2 * (a**2 - V) * (sp.diff(Q, V) * y - mu * self.s * Q)
        other = C * y ** (mu + 1 - tau) if self.s != 0 else sp.S.Zero
        q, c = solved([own + other - wanted], [*unknown, C], (Q, C))
        algebraic = sp.sqrt(a**2 - x**2) * q.subs(V, x**2) * self.y(x**2) ** (-mu)
        return algebraic + (c * self.angle() if c != 0 else 0)

    # over the growth of the contact

    @cached_property
    def depth(self) -> sp.Expr:
        """The depth g(a) of this part of f', in closed form; NotSolvableError where there is none."""
        return sp.expand(-a * self.primitive(sp.S.One).subs(x, 0))

    @property
    def theta(self) -> sp.Expr:
        """The function in the depth."""
        if self.halved:
            return (sp.atanh if self.falls else sp.atan)(self.steep * a / sp.sqrt(self.B))
        return (sp.atan if self.falls else sp.atanh)(self.steep * a / sp.sqrt(self.y(a**2)))

    @property
    def _growth(self) -> sp.Expr:
        """y dtheta/da, over sqrt(y) for a pole."""
        return self.steep * (sp.sqrt(self.B) if self.halved else 1)

    def _parts(self) -> tuple[sp.Expr, sp.Expr]:
        """q and kappa in V, of the depth a**2 q + a kappa theta."""
        mark = sp.Dummy("theta")
        marked = self.depth.subs(self.theta, mark)
        if marked.has(sp.atan, sp.atanh):
            raise NotSolvableError
        kappa = sp.diff(marked, mark) / a
        square = {a: sp.sqrt(V)}
        return sp.cancel(sp.expand(marked.subs(mark, 0) / a**2).subs(square)), sp.expand(kappa).subs(square)

    def growth(self) -> sp.Expr:
        """g'(a), with one fraction before each function."""
        q, kappa = self._parts()
        y, delta = self.y(V), sp.S.Zero if self.halved else HALF
        plain = sp.cancel(sp.powsimp(sp.expand(kappa * y**delta)))
        rational = sp.factor(2 * sp.diff(V * q, V) + plain * self._growth / y)
        before = sp.factor(plain + 2 * V * (sp.diff(plain, V) - delta * self.s * plain / y))
        return (a * rational + before * y ** (-delta) * self.theta).subs(V, a**2)

    def over_arc(self) -> sp.Expr:
        """Integral of g(t)/sqrt(r**2 - t**2) from 0 to a < r."""
        if self.falls:
            raise NotSolvableError
        q, kappa = self._parts()
        n, y, s, delta = self.highest, self.y(V), self.s, sp.S.Zero if self.halved else HALF
        goal = sp.cancel(sp.powsimp(sp.expand(kappa * y ** (n + 1 + delta))))
        rest = sp.cancel(V * q * y ** (n + 1))
        gap = r**2 - V

        def conditions(Q1: sp.Expr, Q2: sp.Expr, C1: sp.Expr, C2: sp.Expr) -> list[sp.Expr]:
            of_theta = -Q1 * y + 2 * gap * (sp.diff(Q1, V) * y - (n + delta) * s * Q1) - goal
            of_rest = gap * Q1 * self._growth + gap * (Q2 * y + 2 * V * (sp.diff(Q2, V) * y - n * s * Q2)) - V * Q2 * y
            return [of_theta, of_rest + C1 * y ** (n + 1) + C2 * y**n - rest]

        q1, q2, c1, c2 = fitted(conditions, max(degree_of(goal), degree_of(rest), n + 1), 2 if s != 0 else 1)
        at, z = self.y(a**2), sp.sqrt(r**2 - a**2)
        total = z * a * q2.subs(V, a**2) / at**n + c1 * sp.asin(a / r)
        if s != 0:
            outer = sp.sqrt(self.y(r**2))
            total += z * q1.subs(V, a**2) * self.theta / at ** (n + delta)
            total += c2 * sp.atan(a * outer / (sp.sqrt(self.B) * z)) / (sp.sqrt(self.B) * outer)
        return total

    def over_growth(self) -> sp.Expr:
        """Integral of g'(t)/sqrt(t**2 - r**2) from r to a."""
        if self.falls or not (self.halved or self.s == 0):
            raise NotSolvableError
        q, kappa = self._parts()
        n, y, s = self.highest, self.y(V), self.s
        goal = sp.cancel(kappa + 2 * V * sp.diff(kappa, V))
        rest = sp.cancel((2 * sp.diff(V * q, V) + kappa * self._growth / y) * y ** (n + 1))
        gap = V - r**2

        def conditions(Q1: sp.Expr, Q2: sp.Expr, C1: sp.Expr, C2: sp.Expr) -> list[sp.Expr]:
            of_theta = V * Q1 + gap * (Q1 + 2 * V * sp.diff(Q1, V)) + C2 - goal
            of_rest = gap * Q1 * self._growth * y**n + Q2 * y + 2 * gap * (sp.diff(Q2, V) * y - n * s * Q2)
            return [of_theta, of_rest + C1 * y**n - rest]

        q1, q2, c1, c2 = fitted(conditions, max(degree_of(goal), degree_of(rest), n + 1), 2 if s != 0 else 0)
        at, root = self.y(a**2), sp.sqrt(a**2 - r**2)
        total = root * q2.subs(V, a**2) / at**n
        if s != 0:
            length, outer = sp.sqrt(self.B / s), sp.sqrt(self.y(r**2))
            below = length + outer / self.steep
            total += root * a * q1.subs(V, a**2) * self.theta
            total += c1 * sp.atan(self.steep * root / outer) / (self.steep * outer)
            total += c2 * (ArctanIntegral((a + root) / below) - ArctanIntegral((a - root) / below))
        return total


def polynomial(degree: sp.Expr) -> tuple[sp.Expr, list[sp.Symbol]]:
    """A polynomial in V with unknown coefficients."""
    if degree > LARGEST_DEGREE:
        raise NotSolvableError
    unknown = [sp.Dummy(f"c{i}") for i in range(max(0, int(degree)) + 1)]
    return sp.Add(*(c * V**i for i, c in enumerate(unknown))), unknown


def degree_of(expr: sp.Expr) -> int:
    """Degree of a polynomial in V, 0 for zero; NotSolvableError for what is no polynomial."""
    if not expr.is_polynomial(V):
        raise NotSolvableError
    return int(sp.degree(expr, V)) if expr != 0 else 0


def solved(conditions: Sequence[sp.Expr], unknown: Sequence[sp.Symbol], wanted: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The wanted expressions with the unknowns that make polynomials in V vanish, those left open set to 0.

    Raises
    ------
    NotSolvableError
        If there are none.
    """
    rows = itertools.chain.from_iterable(sp.Poly(sp.expand(c), V).coeffs() for c in conditions)
    solutions = sp.linsolve([row for row in rows if row != 0], list(unknown))
    if not solutions:
        raise NotSolvableError
    (values,) = solutions
    free = dict.fromkeys(unknown, sp.S.Zero)
    found = dict(zip(unknown, (value.xreplace(free) for value in values), strict=True))
    return [sp.factor(expr.xreplace(found)) for expr in wanted]


def fitted(conditions: Callable[..., list[sp.Expr]], size: int, constants: int) -> list[sp.Expr]:
    """The polynomials Q1, Q2 and constants C1, C2 that meet some conditions; with less than both constants Q1 is 0."""
    (Q1, first), (Q2, second) = polynomial(size), polynomial(size)
    C = sp.Dummy("C1"), sp.Dummy("C2")
    none = dict.fromkeys([*first, *C[constants:]] if constants < len(C) else [], sp.S.Zero)
    wanted = [expr.xreplace(none) for expr in (Q1, Q2, *C)]
    return solved(conditions(*wanted), [u for u in (*first, *second, *C) if u not in none], wanted)


Line = tuple[sp.Expr, sp.Expr]
"""B and s of B + s V."""


def parts_of(shape: sp.Expr) -> list[Part]:
    """f' as a sum of x P(x**2) (B + s x**2)**e.

    Raises
    ------
    NotSolvableError
        If it is none.
    """
    slope = 2 * sp.diff(shape.subs(r, sp.sqrt(V)), V)
    lines: dict[sp.Symbol, Line] = {}
    found: dict[tuple[Line, bool], list[tuple[sp.Expr, sp.Rational]]] = {}
    for term in sp.Add.make_args(sp.expand(_marked(slope, lines))):
        marks = [own.as_base_exp() for own in sp.Mul.make_args(term) if own.as_base_exp()[0] in lines]
        factor = term / sp.Mul(*(mark**e for mark, e in marks))
        if len(marks) > 1 or not factor.is_polynomial(V):
            raise NotSolvableError
        line, e = (lines[marks[0][0]], marks[0][1]) if marks else ((sp.S.One, sp.S.Zero), sp.S.Zero)
        found.setdefault((line, e.q == 2), []).append((factor, e))
    return [_joined(*line, terms) for (line, _), terms in found.items()]


def _marked(expr: sp.Expr, lines: dict[sp.Symbol, Line]) -> sp.Expr:
    """Powers of lines in V as powers of symbols."""
    base, e = expr.as_base_exp()
    if expr.is_Pow and base.has(V) and not (e.is_Integer and e.is_positive):
        if not base.is_polynomial(V) or not e.is_Rational:
            raise NotSolvableError
        size, factors = sp.factor_list(base, V)
        if len(factors) != 1 or sp.degree(factors[0][0], V) != 1:
            raise NotSolvableError
        line, power = factors[0]
        B, s = line.subs(V, 0), sp.diff(line, V)
        if not B.is_positive:
            B, s, size = -B, -s, size * (-1) ** power
        e = e * power
        if not (B.is_positive and (s.is_positive or s.is_negative) and size.is_positive and e.q <= 2):
            raise NotSolvableError
        known = {own: mark for mark, own in lines.items()}
        mark = known.get((B, s)) or sp.Dummy("y", positive=True)
        lines[mark] = (B, s)
        return size ** (e / power) * mark**e
    return expr.func(*(_marked(part, lines) for part in expr.args)) if expr.args else expr


def _joined(B: sp.Expr, s: sp.Expr, terms: list[tuple[sp.Expr, sp.Rational]]) -> Part:
    """The terms over the lowest power of their base, written with a length where that is simple."""
    e = min(e for _, e in terms)
    P = sp.expand(sp.Add(*(factor * (B + s * V) ** (own - e) for factor, own in terms)))
    length = sp.sqrt(B / abs(s)) if s != 0 else sp.S.One
    if _rooted(sp.sqrt(B)) and not _rooted(length):
        size = abs(s) ** e
        P, B, s = sp.expand(P * size), length**2, sp.sign(s)
    return Part(P, B, s, e)


def derive(profile: Profile) -> tuple[Profile, dict[str, Entry], dict[str, Entry]]:
    """All entries, and those of p and w as single integrals; the profile learns where it ends.

    Closed are those for which the coefficients could be determined.

    Raises
    ------
    NotSolvableError
        If the profile is not of the kind, or its depth has no such form.
    """
    if len(profile.pieces) != 1:
        raise NotSolvableError
    shape = profile.pieces[0].expr
    # a parameter under a root is worked with as the square of its root: all coefficients stay rational
    under = {s for part in parts_of(shape) if part.s != 0 for s in _under_a_root(sp.sqrt(part.B / abs(part.s)))}
    roots = {s: sp.Dummy(s.name, positive=True) for s in sorted(under, key=str)}
    parts = parts_of(shape.xreplace({s: root**2 for s, root in roots.items()}))
    if any(power.base.is_Add for part in parts for power in sp.sqrt(part.B * part.s).atoms(sp.Pow) if power.exp.q == 2):
        raise NotSolvableError
    back = {root: sp.sqrt(s) for s, root in roots.items()}
    ends = {sp.sqrt(-part.B / part.s) for part in parts if part.falls}
    if len(ends) > 1 or not all(end.is_Symbol for end in ends):
        raise NotSolvableError
    chain = (a, *ends)
    profile = replace(profile, chain=chain if ends else ())

    def whole(quantity: Callable[[Part], sp.Expr]) -> sp.Expr:
        return sp.factor_terms(sp.Add(*(quantity(part) for part in parts)).xreplace(back))

    depth = whole(lambda part: part.depth)
    plain = general.derive(profile)

    def closed(suffix: str, *cases: Case, **more: object) -> Entry:
        return replace(plain[suffix], status="closed", cases=cases, **more)  # type: ignore[arg-type]

    integrand = (sp.diff(shape, r).subs(r, x) * a / sp.sqrt(a**2 - x**2)).doit()
    primitive = a * whole(lambda part: part.primitive(sp.S.One))
    force = sp.factor_terms(-2 * E_star * whole(lambda part: part.primitive(V).subs(x, 0)))
    mean = sp.factor_terms(sp.expand(force / (sp.pi * a**2)))
    growth = closed("d", Case(chain, depth), primitives={chain: (Primitive(sp.S.Zero, a, integrand, primitive),)})
    single = {"p": _over_closed_growth(plain["p"], whole(Part.growth), chain), "w": plain["w"]}
    entries = {
        **plain,
        "d": growth,
        "F": closed("F", Case(chain, force)),
        "pm": closed("pm", Case(chain, mean)),
        "p": _closed(single["p"], lambda: HOMOGENEOUS.pressure_scale * whole(Part.over_growth)),
        "w": _closed(
            single["w"],
            lambda: HOMOGENEOUS.displacement_scale * (sp.asin(a / r) * depth - whole(Part.over_arc)),
        ),
    }
    for own in (entry for entry in plain.values() if entry.quantity.inverts):
        (curve,), (value,) = entries[own.quantity.inverts].cases, own.quantity.arguments
        entries[own.suffix] = replace(own, cases=(Case(chain, sp.Eq(curve.expr, value)),))
    return profile, entries, single


def _rooted(length: sp.Expr) -> bool:
    return any(power.exp.q == 2 for power in length.atoms(sp.Pow))


def _under_a_root(length: sp.Expr) -> set[sp.Symbol]:
    return {s for power in length.atoms(sp.Pow) if power.exp.q == 2 for s in power.base.free_symbols}


def _closed(integral: Entry, value: Callable[[], sp.Expr]) -> Entry:
    """Closed, or the single regular integral where there is no closed form of the kind."""
    try:
        return replace(integral, status="closed", cases=(Case(integral.cases[0].chain, value()),))
    except NotSolvableError:
        return integral


def _over_closed_growth(plain: Entry, growth: sp.Expr, chain: Chain) -> Entry:
    """The pressure as one regular integral over g'(t) in closed form."""
    radius = sp.sqrt(r**2 + u**2)
    integrand = sp.Add(*(term / radius for term in sp.Add.make_args(growth.subs(a, radius))))
    value = HOMOGENEOUS.pressure_scale * sp.Integral(integrand, (u, 0, sp.sqrt(a**2 - r**2)))
    return replace(plain, cases=(Case((r, *chain), value),))
