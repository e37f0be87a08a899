"""The rate g'(t) at which flat punches are added to a growing contact, as an evaluation form."""

from __future__ import annotations

from functools import lru_cache

import sympy as sp

from ..entry import Entry
from ..notation import a, t
from .forms import EvaluationForm
from .rewriting import Rewriting, gamma_ratios
from .signs import Facts, cancels, squares
from .variants import FULL, Variant

ROOT = "root"
RATE = "slope"
"""As what the choice of its form is recorded: it is no result of its own, but all rules and iterations call it."""


def rate_key(entry: Entry) -> str:
    """The key under which the form of the rate is chosen, from that of any entry of the problem."""
    return f"{entry.key.rpartition('.')[0]}.{RATE}"


@lru_cache(maxsize=512)
def slope_form(depth: sp.Expr, facts: Facts, variant: Variant = FULL) -> EvaluationForm:
    """g'(t) with t for the radius; a root of t and a length of the profile is called `root`.

    The algebraic part is brought to a form without cancellation: first by writing
    t**2 as root**2 + b**2 over a root, then by clearing the roots from its denominator.
    """
    work = Rewriting(facts, variant)
    start = work.with_named_logarithms(work.named(gamma_ratios(depth)))
    kept = work.fixed_differences(start)
    slope = _derivative(work, start.subs(kept))
    value = work.rewritten(_over_roots(work, slope))
    if work.square and cancels(value, work.facts):
        algebraic, angles = slope.as_independent(*work.tangent, *work.hyperbolic, *work.ratio, as_Add=True)
        value = angles + work.conjugates(_rationalised(algebraic, work))
    value = value.subs({dummy: node for node, dummy in kept.items()})
    value = work.with_named_arguments(value)
    steps = tuple((name, expr.subs(a, t)) for name, expr in work.steps(value))
    return EvaluationForm(steps, value.subs(a, t), cancels(value, work.facts))


def _derivative(work: Rewriting, value: sp.Expr) -> sp.Expr:
    """d/da with the roots and angles kept as names."""
    total = _algebraic_derivative(work, value)
    for logarithm, ratio in work.ratio.items():
        top, bottom = sp.fraction(ratio)
        rate = _algebraic_derivative(work, top) / top - _algebraic_derivative(work, bottom) / bottom
        total += sp.diff(value, logarithm) * rate
    for angle, tangent in (work.tangent | work.hyperbolic).items():
        plain = tangent.subs({root: sp.sqrt(square) for root, square in work.square.items()})
        side = 1 if angle in work.tangent else -1
        rate = sp.factor(sp.cancel(sp.diff(plain**2, a) / (1 + side * plain**2))) / (2 * tangent)
        total += sp.diff(value, angle) * _with_roots(work, rate)
    return sp.expand(total)


def _algebraic_derivative(work: Rewriting, value: sp.Expr) -> sp.Expr:
    through = (sp.diff(value, root) * sp.diff(square, a) / (2 * root) for root, square in work.square.items())
    return sp.diff(value, a) + sp.Add(*through)


def _with_roots(work: Rewriting, expr: sp.Expr) -> sp.Expr:
    """Differences of squares as squares of the roots that have a name."""
    for root, square in work.square.items():
        pair = squares(square)
        if pair:
            x, y = pair
            expr = expr.subs(x - y, root**2 / (x + y)).subs(y - x, -(root**2) / (x + y))
    return sp.cancel(expr)


def _over_roots(work: Rewriting, slope: sp.Expr) -> sp.Expr:
    terms = []
    for term in sp.Add.make_args(slope):
        for root, square in work.square.items():
            other = sp.expand(a**2 - square)
            if sp.denom(term).has(root) and not other.has(a):
                term = sp.expand(term.subs(a**2, root**2 + other))
        terms.append(sp.expand(term))
    return sp.Add(*terms)


def _rationalised(expr: sp.Expr, work: Rewriting) -> sp.Expr:
    """A fraction without roots in its denominator, except as factors."""
    top, bottom = sp.fraction(sp.together(expr))
    for root, square in work.square.items():
        mirrored = bottom.subs(root, -root)
        top = sp.rem(sp.expand(top * mirrored), root**2 - square, root)
        bottom = sp.rem(sp.expand(bottom * mirrored), root**2 - square, root)
    terms = sp.Poly(top, *work.square).terms()
    names = list(work.square)
    return sp.Add(
        *(
            sp.factor(sp.cancel(factor / bottom))
            * sp.Mul(*(name**power for name, power in zip(names, powers, strict=True)))
            for powers, factor in terms
        )
    )


def singular_at_break(form: EvaluationForm) -> sp.Expr:
    """The coefficient of 1/root: where it is positive the pressure is infinite at the break."""
    root = next((symbol for symbol in form.value.free_symbols if symbol.name == ROOT), None)
    if root is None:
        return sp.S.Zero
    return sp.factor(sp.expand(form.value).coeff(root, -1))
