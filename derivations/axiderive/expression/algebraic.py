"""Algebraic profiles outside the normal form: entries by undetermined coefficients, single integrals where none fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import sympy as sp

from ..abel.order import Chain
from ..contact import general
from ..contact.medium import HOMOGENEOUS
from ..entry import Case, Entry, Primitive
from ..notation import E_star, F, a, d, r, u, x
from ..profiles.profile import Profile
from .undetermined import NotSolvableError, Part, V

Line = tuple[sp.Expr, sp.Expr]
"""B and s of B + s V."""
Whole = Callable[[Callable[[Part], sp.Expr]], sp.Expr]
"""The sum of a quantity over all parts."""


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
        "p": _pressure(whole, single["p"]),
        "w": _displacement(whole, depth, single["w"]),
    }
    for suffix, source, value in (("ad", depth, d), ("aF", force, F), ("Fd", depth, d), ("dF", force, F)):
        entries[suffix] = replace(plain[suffix], cases=(Case(chain, sp.Eq(source, value)),))
    return profile, entries, single


def _rooted(length: sp.Expr) -> bool:
    return any(power.exp.q == 2 for power in length.atoms(sp.Pow))


def _under_a_root(length: sp.Expr) -> set[sp.Symbol]:
    return {s for power in length.atoms(sp.Pow) if power.exp.q == 2 for s in power.base.free_symbols}


def _pressure(whole: Whole, integral: Entry) -> Entry:
    """Closed, or one regular integral over the closed g'(t)."""
    try:
        value = HOMOGENEOUS.pressure_scale * whole(Part.over_growth)
    except NotSolvableError:
        return integral
    return replace(integral, status="closed", cases=(Case(integral.cases[0].chain, value),))


def _displacement(whole: Whole, depth: sp.Expr, integral: Entry) -> Entry:
    """Closed, or the single integral over the profile."""
    try:
        value = HOMOGENEOUS.displacement_scale * (sp.asin(a / r) * depth - whole(Part.over_arc))
    except NotSolvableError:
        return integral
    return replace(integral, status="closed", cases=(Case(integral.cases[0].chain, value),))


def _over_closed_growth(plain: Entry, growth: sp.Expr, chain: Chain) -> Entry:
    """The pressure as one regular integral over g'(t) in closed form."""
    radius = sp.sqrt(r**2 + u**2)
    integrand = sp.Add(*(term / radius for term in sp.Add.make_args(growth.subs(a, radius))))
    value = HOMOGENEOUS.pressure_scale * sp.Integral(integrand, (u, 0, sp.sqrt(a**2 - r**2)))
    return replace(plain, cases=(Case((r, *chain), value),))
