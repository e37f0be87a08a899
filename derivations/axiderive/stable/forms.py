"""Exact expression -> evaluation form, by rewriting with fixed rules.

Radicals sqrt(x**2 - y**2) become named roots of exact differences, angles
become atan2 of roots, and where terms cancel three rules are tried: conjugates
(X - Y = (X**2 - Y**2)/(X + Y)), the gap functions x - atan(x) and atanh(x) - x,
and ln(X/Y) = log1p((X - Y)/Y).  The form says whether that was enough; which
of the rules an entry is worth was measured (`variants`).

`plane_form` goes further: with q^2 - p^2 a product of exact differences, asin(p/q) = atan2(p, sqrt(q^2 - p^2))
and atanh(p/q) = asinh(p/sqrt(q^2 - p^2)) hold every digit.  An algebraic sum
X + Y z with z = sqrt(hi^2 - lo^2) becomes (X^2 - Y^2 z^2)/(X - Y z).

`of_lengths` takes what vanishes like the cube of a root through the exact difference of its two lengths: the root of
x**2 - y**2 is rounded twice, its quotient by y once more, and a cube takes all of that up three times: 6 units of the
last place next to x = y.  With q = (x - y)/y the gap is q sqrt(q) times a smooth function of q.
An angle atanh(y/x) takes half the time as log1p(2 y/(x - y))/2, without the root; what it exceeds its tangent by goes
with the cube of that, which is y/x.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import sympy as sp

from .opaque import Arctan2, ArctanGap, Log1p, Root, RootGap, named
from .rewriting import Rewriting, arc_integrals, gamma_ratios, power_integrals
from .signs import Facts, cancels, sign, squares
from .variants import FULL, Variant


@dataclass(frozen=True)
class EvaluationForm:
    """Named intermediates in order of use, the value, and whether cancellation remains."""

    steps: tuple[tuple[sp.Symbol, sp.Expr], ...]
    value: sp.Expr
    cancels: bool


@lru_cache(maxsize=2048)
def evaluation_form(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> EvaluationForm:
    """The form with roots and angles named and, if possible, without cancellation."""
    work = Rewriting(facts, variant)
    value = work.named(work.with_named_ratio(gamma_ratios(arc_integrals(power_integrals(expr)))))
    if cancels(value, work.facts):
        value = work.rewritten(value)
    value = work.with_named_powers(work.with_named_arguments(value))
    value = sp.expand(value) if variant.expanded else value
    steps = work.steps(value)
    loses = not variant.closed and any(cancels(part, work.facts) for part in (value, *(expr for _, expr in steps)))
    return EvaluationForm(steps, value, loses)


ROOT, CONJUGATE = named("root"), named("conjugate")


def plane_form(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> EvaluationForm:
    """The evaluation form after both rewritings, as far as the variant has them."""
    angles = exact_angles(expr, facts, variant)
    form = evaluation_form(angles, facts, replace(variant, closed=False))
    if form.cancels:
        form = _conjugated(angles, facts) or form
    return replace(form, cancels=form.cancels and not variant.closed)


def exact_angles(expr: sp.Expr, facts: Facts, variant: Variant = FULL) -> sp.Expr:
    """Inverse functions of a quotient of roots through the root of the exact difference."""
    tangent = (lambda y, x: sp.atan(y / x)) if variant.quotients else Arctan2

    def opened(angle: sp.Expr) -> sp.Expr:
        top, bottom = sp.fraction(angle.args[0])
        if not any(_is_root(factor) for factor in sp.Mul.make_args(bottom)):
            return angle
        side = _root_of(bottom**2 - top**2, facts)
        if side is None:
            return angle
        if isinstance(angle, sp.atanh):
            return sp.asinh(top / side)
        return tangent(top, side) if isinstance(angle, sp.asin) else tangent(side, top)

    return expr.replace(lambda e: isinstance(e, (sp.asin, sp.acos, sp.atanh)), opened)


def _is_root(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp == sp.S.Half and factor.base.is_Add)


def _root_of(square: sp.Expr, facts: Facts) -> sp.Expr | None:
    """sqrt of a positive product of squares and one difference of squares."""
    letters = {symbol**2: sp.Dummy(symbol.name, positive=True) for symbol in square.free_symbols}
    back = {dummy: power for power, dummy in letters.items()}
    factors = sp.Mul.make_args(sp.factor(sp.expand(square).subs(letters)).subs(back))
    root = sp.S.One
    for factor in factors:
        base, exponent = factor.as_base_exp()
        if not base.is_Add:
            root *= sp.sqrt(abs(factor) if factor.is_number else factor)
            continue
        side = sign(base, facts) if squares(base) or squares(-base) else 0
        if side == 0 or exponent != 1:
            return None
        root *= sp.sqrt(base if side > 0 else sp.expand(-base))
    return root


def _conjugated(expr: sp.Expr, facts: Facts) -> EvaluationForm | None:
    """The form of a sum with one root, its algebraic part over the conjugate; None where that is no gain."""
    radicands = {e.base for e in expr.atoms(sp.Pow) if e.base.is_Add and e.exp.is_Rational and e.exp.q == 2}
    pair = squares(next(iter(radicands))) if len(radicands) == 1 else None
    if pair is None:
        return None
    rooted = expr.replace(
        lambda e: e.is_Pow and e.base in radicands and e.exp.is_Rational and e.exp.q == 2, lambda e: ROOT ** (2 * e.exp)
    )
    scale, inside = sp.factor_terms(rooted).as_independent(sp.Add, as_Add=False)
    algebraic, angles = sp.expand(inside).as_independent(sp.Function, as_Add=True)
    opened = _over_conjugate(algebraic, pair)
    if opened is None:
        return None
    top, conjugate = opened
    value = sp.factor_terms(scale * (top / CONJUGATE + _hyperbolic(angles, pair)))
    loses = cancels(value, facts) or cancels(conjugate, facts)
    form = EvaluationForm(((ROOT, Root(*pair)), (CONJUGATE, conjugate)), value, loses)
    return None if form.cancels else form


def _over_conjugate(expr: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> tuple[sp.Expr, sp.Expr] | None:
    """(top, conjugate) of an algebraic sum of both kinds of terms."""
    high, low = pair
    top, bottom = sp.fraction(sp.together(expr))
    whole = sp.Poly(sp.rem(sp.expand(top), ROOT**2 - high**2 + low**2, ROOT), ROOT)
    plain, slope = whole.coeff_monomial(1), whole.coeff_monomial(ROOT)
    if plain == 0 or slope == 0:
        return None
    product = sp.factor(sp.expand(plain**2 - slope**2 * (high**2 - low**2)))
    below = _in_root(plain, pair) - _in_root(slope, pair) * ROOT
    if all(term.could_extract_minus_sign() for term in sp.Add.make_args(sp.expand(below))):
        product, below = -product, sp.expand(-below)
    content, below = sp.factor_terms(below).as_independent(sp.Add, as_Add=False)
    content, below = (content, below) if below.is_Add else (sp.S.One, content * below)
    return product / (bottom * content), below


def _in_root(polynomial: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """Even powers of the longer length through the root, if only that leaves one sign."""
    high, low = pair
    if not polynomial.is_Add or len({term.could_extract_minus_sign() for term in polynomial.args}) == 1:
        return polynomial
    terms = (
        factor * high ** (power % 2) * (ROOT**2 + low**2) ** (power // 2)
        for (power,), factor in sp.Poly(polynomial, high).terms()
    )
    return sp.expand(sp.Add(*terms))


def _hyperbolic(expr: sp.Expr, pair: tuple[sp.Expr, sp.Expr]) -> sp.Expr:
    """acosh(high/low) as asinh of the root."""
    high, low = pair
    return expr.subs(sp.acosh(high / low), sp.asinh(ROOT / low))


def of_lengths(form: EvaluationForm) -> EvaluationForm:
    """The form with gaps, cubes and hyperbolic angles of its roots taken from their lengths."""
    value = form.value
    for name, root in form.steps:
        if isinstance(root, Root):
            x, y = root.args
            value = value.xreplace({ArctanGap(name / y): RootGap(x, y), name**3: name * (x**2 - y**2)})
    return angles_of_lengths(EvaluationForm(form.steps, value, form.cancels))


def angles_of_lengths(form: EvaluationForm) -> EvaluationForm:
    """The form with the hyperbolic angles alone taken from lengths, and without the roots that nothing else needs."""
    steps, value = form.steps, form.value
    for root, lengths in form.steps:
        if isinstance(lengths, Root):
            x, y = lengths.args
            angle, by_lengths = sp.asinh(y / root), Log1p(2 * y / (x - y)) / 2
            tangents = {sp.tanh(name): y / x for name, expr in steps if expr == angle}
            steps = tuple((name, expr.xreplace({angle: by_lengths})) for name, expr in steps)
            value = value.xreplace(tangents)
    used = value.free_symbols.union(*(expr.free_symbols for _, expr in steps))
    return EvaluationForm(tuple(step for step in steps if step[0] in used), value, form.cancels)
