"""The graded half-space: its exponent as a bounded symbol, and the limit k -> 0.

With kappa = 1 + k, 0 < kappa < 2, the exponents that decide end values, like
1 + k, are visibly positive; k itself, which notation declares positive, may be
negative and never enters a proof.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ...entry import Case, Entry, Primitive
from ...notation import E_star, F, F_x, G_star, H, H_x, a, a_c, c, d, k, mu, n
from ...physics.adhesive import CONTROLS
from ...physics.medium import GRADED
from ..algebra import special
from ..algebra.domain import Domain, NotProvedError
from ..algebra.functions import canonical
from ..statement import require_zero
from .compact import Compact
from .complete import Complete

KAPPA = sp.Symbol("kappa", positive=True)
MEDIUM = replace(GRADED, k=KAPPA - 1)
BOUNDS = ((KAPPA, sp.Integer(2)),)


def in_kappa(expr: sp.Expr) -> sp.Expr:
    """The expression with kappa - 1 for k."""
    return expr.xreplace({k: KAPPA - 1})


def shifted(entries: dict[str, Entry]) -> dict[str, Entry]:
    """Entries with kappa - 1 for k."""
    return {suffix: _shifted(entry) for suffix, entry in entries.items()}


def _case(case: Case) -> Case:
    return Case(tuple(map(in_kappa, case.chain)), in_kappa(case.expr))


def _primitive(primitive: Primitive) -> Primitive:
    return replace(primitive, integrand=in_kappa(primitive.integrand), expr=in_kappa(primitive.expr))


def _shifted(entry: Entry) -> Entry:
    return replace(
        entry,
        cases=tuple(map(_case, entry.cases)),
        fixed_face=tuple(map(_case, entry.fixed_face)),
        primitives={chain: tuple(map(_primitive, found)) for chain, found in entry.primitives.items()},
    )


def homogeneous_limit(
    suffix: str, graded: dict[str, Entry], plain: dict[str, Entry], normal: Compact | Complete
) -> list[str]:
    """At k = 0, where all functions of k are continuous, the graded entry is the homogeneous one.

    Of an equation both sides are.

    Raises
    ------
    NotProvedError
        If one of both is an integral, only one an equation, or the formulas differ.
    """
    entry, wanted = graded[suffix], plain[suffix]
    if entry.status != wanted.status or entry.status == "integral":
        message = f"{entry.key} is {entry.status}, {wanted.key} is {wanted.status}: no pair of formulas or equations"
        raise NotProvedError(message)
    found = [Case(tuple(map(_at_zero, case.chain)), _at_zero(case.expr)) for case in entry.cases]
    steps = []
    for case in wanted.cases:
        limit = _counterpart(case, found, suffix, plain)
        pairs = [(case.expr, limit)]
        if isinstance(case.expr, sp.Equality):
            pairs = [(case.expr.lhs, limit.lhs), (case.expr.rhs, limit.rhs)]
        steps += [_same_case(wanted, replace(case, expr=expr), other, normal) for expr, other in pairs]
    return steps


def _at_zero(expr: sp.Expr) -> sp.Expr:
    return expr.subs(k, sp.S.Zero).subs({H: E_star, H_x: G_star})


def _counterpart(case: Case, found: list[Case], suffix: str, plain: dict[str, Entry]) -> sp.Expr:
    """The graded formula of the same region; a closed radius of pull-off is put in where the other side has it."""
    same = [other.expr for other in found if other.chain == case.chain]
    if len(same) == 1:
        return same[0]
    radius = {name: names[0] for names in CONTROLS.values() for name in names[1:]}.get(suffix)
    if case.chain or len(found) != 1 or radius not in plain or plain[radius].status != "closed":
        message = f"no case of the graded half-space is that of {' < '.join(map(str, case.chain))}"
        raise NotProvedError(message)
    return found[0].expr.subs(a_c, plain[radius].cases[0].expr)


def _same_case(wanted: Entry, case: Case, found: sp.Expr, normal: Compact | Complete) -> str:
    gap = (found - case.expr).subs(a_c, a)
    if gap.has(F_x) and gap.has(F):
        gap = gap.subs(F, F + F_x / mu)  # F_x < mu F as long as the contact sticks
    domain = normal.domain(tuple(length.subs(a_c, a) for length in case.chain if length.is_Symbol))
    if (
        isinstance(normal, Compact)
        and n in wanted.parameters
        and any(wanted.suffix in names for names in CONTROLS.values())
    ):
        domain = Domain(*domain.chains(), (sp.S.Half, n))  # a sharper profile has no pull-off
    for current in (length for length in case.chain if length.has(d)):
        # the contact radius c before the edge is reached, a power of d
        factor, power = current.as_independent(d, as_Add=False)
        gap = gap.subs(d, (c / factor) ** (1 / power.as_base_exp()[1]))
        domain = Domain(tuple(c if length == current else length for length in case.chain))
    gap = special.elementary(canonical(gap, domain))
    return require_zero(gap, domain, f"at k = 0, H = E* the formula is that of {wanted.key}")
