"""The elastic energy of a contact, which is the work int F dd of pressing it in without adhesion.

The surface is as good as independent springs of stiffness 2 E* dt at the depths d - g(t), so that it is
E* int_0^a (d - g(t))^2 dt; it is elementary where g^2 is, as of powers of r and of the paraboloid without its tip.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from ...abel.form import Chain, Form, Order
from ...abel.reduce import Reduced
from ...entry import Case, Entry, Quantity, Status
from ...notation import Dimension, F, a, d, define, t
from .. import DEPTH
from ..medium import HOMOGENEOUS, Medium
from . import GAP, GROWTH, SHORT, Consequence, Contact, Rate, Rules

Depths = Mapping[Chain, sp.Expr]
"""The depth by the place of its radius among the breaks."""
U = define("U", "U", Dimension.of(1, 1), "J", "", "elastic energy, the work of pressing the indenter in")
ROOT = sp.Symbol("S", positive=True)


def derive(contact: Contact, entries: Mapping[str, Entry]) -> tuple[Status, tuple[Case, ...]]:
    """Closed where the square of the depth has an elementary integral; else one integral over every piece."""
    depth = {case.chain: case.expr for case in entries["d"].cases}
    status: Status = "closed"
    cases = []
    for chain, sunk in depth.items():
        square = None if contact.summed else _square(depth, chain)
        if square is None:
            status = "integral"
            cases.append(Case(chain, _integral(depth, chain)))
            continue
        # int g dt = a g(a) - F^
        whole = 2 * sunk * contact.reduced.force(Order(chain)).expr() - a * sunk**2 + square
        cases.append(Case(chain, HOMOGENEOUS.modulus * _ordered(whole, chain[: chain.index(a)])))
    return status, tuple(cases)


def pieces(depth: Depths, chain: Chain) -> Iterator[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """Ends of the intervals below a radius, with the depth there in its own radius a; none within a flat face."""
    rest = [b for b in chain if b != a]
    ends = [sp.S.Zero, *chain[: chain.index(a)], a]
    for place, (low, high) in enumerate(zip(ends, ends[1:], strict=False)):
        yield low, high, depth.get((*rest[:place], a, *rest[place:]), sp.S.Zero)


def _square(depth: Depths, chain: Chain) -> sp.Expr | None:
    """int_0^a g^2 dt, where that is a sum of powers of t and of roots of t^2 - b^2."""
    total = sp.S.Zero
    for low, high, sunk in pieces(depth, chain):
        found = _antiderivative(sunk)
        if found is None:
            return None
        total += found.subs(a, high) - (found.subs(a, low) if low != 0 else sp.S.Zero)
    return total


def _antiderivative(sunk: sp.Expr) -> sp.Expr | None:
    """In a, of the square of a depth; zero at a = 0."""
    if sunk == 0:
        return sunk
    square = sp.powsimp(sp.expand(sunk**2), combine="exp")
    roots = {e.base for e in square.atoms(sp.Pow) if e.exp == sp.S.Half and e.has(a)}
    if any(e.has(a) for e in square.atoms(sp.Function)) or len(roots) > 1:
        return None
    (base,) = roots or (a**2,)
    b_square, total = sp.expand(a**2 - base), sp.S.Zero
    for term in sp.Add.make_args(sp.expand(square.subs(sp.sqrt(base), ROOT)) if roots else square):
        factor, power = term.as_independent(a, ROOT, as_Add=False)
        exponent = sp.powsimp(a * sp.diff(power, a) / power)
        if exponent.has(a) or b_square.has(a):
            return None
        if not power.has(ROOT):
            total += factor * power * a / (exponent + 1)
        elif exponent.is_Integer and exponent % 2:  # a da = S dS
            inside = sp.expand((ROOT**2 + b_square) ** ((exponent - 1) / 2) * ROOT**2)
            total += factor * sp.integrate(inside, ROOT).subs(ROOT, sp.sqrt(base))
        else:
            return None
    return total


def _ordered(expr: sp.Expr, outside: Chain) -> sp.Expr:
    """Factored, as a polynomial in the root of a^2 - b^2."""
    if not outside:
        return sp.factor(sp.powsimp(sp.expand(expr), combine="exp"))
    (b,) = outside
    base = a**2 - b**2
    expanded = sp.expand(sp.expand(expr).subs(sp.sqrt(base), ROOT))
    polynomial = sp.rem(sp.Poly(expanded, ROOT), sp.Poly(ROOT**2 - base, ROOT))
    return Form({sp.S.One: polynomial.coeff_monomial(1), sp.sqrt(base): polynomial.coeff_monomial(ROOT)}).expr()


def _integral(depth: Depths, chain: Chain) -> sp.Expr:
    total = sp.S.Zero
    for low, high, sunk in pieces(depth, chain):
        short = depth[chain] - sunk.subs(a, t)
        total += (high - low) * depth[chain] ** 2 if sunk == 0 else sp.Integral(short**2, (t, low, high))
    return HOMOGENEOUS.modulus * total


def fixed(reduced: Reduced, medium: Medium) -> sp.Expr:
    """int (d - g)^2 = a d^2 - 2 d int g + int g^2, the middle one a g(a) - F^."""
    sunk, force = reduced.depth(Order((a,))).expr(), reduced.force(Order((a,))).expr()
    rows = a * d**2, -2 * d * sp.factor(sp.powsimp(sp.expand(a * sunk - force), combine="exp")), _antiderivative(sunk)
    return medium.modulus * sp.Add(*rows)


SUMMARY = "Elastic energy, the work of pressing the indenter in."
CONSEQUENCE = Consequence(
    compact=Quantity("U", "energy", "Elastic energy", U, (a,), after="pm", summary=SUMMARY),
    complete=Quantity("U", "energy", "Elastic energy", U, (d,), after="pm", summary=SUMMARY),
    definition=HOMOGENEOUS.modulus * sp.Integral((DEPTH(a) - DEPTH(t)) ** 2, (t, 0, a)),
    fixed_definition=HOMOGENEOUS.modulus * sp.Integral(SHORT(t) ** 2, (t, 0, a)),
    springs=HOMOGENEOUS.modulus * sp.Integral(SHORT(t) ** 2, (t, 0, a)),
    derive=derive,
    fixed=fixed,
    grown=Rate(F * GROWTH, "dU/da = F g'(a)", ("F", "d")),
    fixed_rate=Rate(HOMOGENEOUS.modulus * GAP**2, "dU/da = E* (d - g(a))^2 for a fixed face", ()),
    rules=Rules(
        "depth",
        "",
        "{b} * sunk * sunk",
        HOMOGENEOUS.modulus,
        anywhere=("sunk = {of_a}",),
        weight="(sunk - {of_x}) ** 2",
        whole="E_star * ({flat} * sunk**2 + whole)",
    ),
    printed=r"U=E^{*} \int_{0}^{a} \bigl[g(a)-g(t)\bigr]^{2}\,\mathrm{d}t",
)
