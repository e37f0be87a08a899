"""The equation of a layer on a rigid base: it holds for the springs that put its surface where the indenter is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache, partial
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..oracle.evaluate import decades
from ..oracle.half_space import HalfSpace
from ..oracle.integrals import GUARD
from ..oracle.layer import layer
from ..oracle.rules import gauss_rule
from ..oracle.shape import Number, Values, number
from ..physics.layer import ADHESIVE, BASES, EQUATION, KERNEL, SPRING, order, sinking, thickness
from .comparison import Comparison, Evidence, Rows, residual

DIGITS, LOST = 14, 3
CASES = tuple(zip(BASES, (sp.Rational(1, 2), sp.Rational(3, 10)), (sp.S.One, sp.S.Half), strict=True))
"""Base, Poisson's ratio, and contact radius over thickness."""
STRETCHES, NODES = (0, 2, 6, 12, 21), 24
"""Of the integral over wave numbers for the thickness 1, and nodes on each."""
AMONG = 12
"""Points of which those are taken whose lengths are nearest to each other."""
LEAST = mp.mpf(10) ** -(DIGITS - 2)
"""What an expansion leaves out, but for a factor, where it is compared."""
PLACES = (sp.Rational(1, 5), sp.Rational(7, 10))
"""Over the contact radius, where the equation is asked for."""
PULLED = sp.Rational(1, 5)
"""Root of dgamma a/E_star, over the depth without adhesion."""
RATE = sp.Function("rate")
"""The derivative of what a spring is pressed in."""


def check_profile(own: Comparison) -> list[Evidence]:
    """Every entry at a few contacts, and the equation at radii inside."""
    rows: dict[str, Rows] = {suffix: [] for suffix, entry in own.entries.items() if entry.status == "equation"}
    inside: Rows = []
    with mp.workdps(DIGITS + GUARD):
        for (base, nu, ratio), drawn in zip(CASES, _drawn(own), strict=False):
            here = _contact(own, drawn, nu, ratio)
            values, kernel = here.values, _kernel(here.values, base)
            for adhesive in (False, True) if own.profile.compact else (False,):
                found = layer(here, base, adhesive=adhesive)
                # the same integrals and nodes come again
                taken: dict[Any, Callable[..., Number]] = {
                    SPRING: cache(found.spring),
                    RATE: found.rate,
                    KERNEL: kernel,
                }
                stated = replace(here, known=taken)
                value, wanted = cache(stated.defined), cache(found.value)
                for suffix in (suffix for suffix in rows if (suffix in ADHESIVE) == adhesive):
                    entry = own.entries[suffix]
                    formula, symbol = entry.cases[0].expr, entry.quantity.symbol
                    left, right = formula.args if isinstance(formula, sp.Equality) else (formula, symbol)
                    rows[suffix].append((values, residual(value(_regular(left)), wanted(right))))
                for place in PLACES:
                    there = replace(stated, values={**values, nt.t: place * values[nt.a], nt.d: found.depth})
                    inside.append((there.values, residual(there.defined(EQUATION), there.defined(SPRING(nt.t)))))
    first = next(iter(own.entries))
    equation = own.judge(first, "the equation at radii inside, of those springs", inside, digits=DIGITS, lost=LOST)
    return [
        *(own.judge(suffix, own.physics.compared, rows[suffix], digits=DIGITS, lost=LOST) for suffix in rows),
        equation,
        *_expanded(own),
    ]


def _contact(own: Comparison, drawn: Values, nu: sp.Expr, ratio: sp.Expr) -> HalfSpace:
    """What adhesion takes of the depth is of the size of the depth without it."""
    a, values = drawn[nt.a], {**drawn, nt.nu: nu, thickness: drawn[nt.a] / ratio}
    here = HalfSpace(own.profile, values, DIGITS, graded=False)
    if not own.profile.compact:
        return here
    pulled = PULLED * sp.Rational(str(mp.nstr(here.depth(here.at(nt.a)), DIGITS)))
    return replace(here, values={**values, nt.dgamma: drawn[nt.E_star] * pulled**2 / a})


def _expanded(own: Comparison) -> Iterator[Evidence]:
    """The expansions where what they leave out is less than the digits that are asked for."""
    base, nu, _ = CASES[0]
    solved = cache(partial(_contact, own, _drawn(own)[0], nu))
    for suffix, entry in own.entries.items():
        if entry.status != "expansion":
            continue
        power = order(entry.definition)
        with mp.workdps(DIGITS + GUARD):
            # a rational number, by which a thickness is exact
            here = solved(sp.Rational(1, int(LEAST ** (-mp.mpf(1) / power))))
            found = layer(here, base)
            rows = [(here.values, residual(found.stated(entry), found.value(entry.quantity.symbol)))]
        compared = f"{own.physics.compared} at a = {rows[0][0][nt.a] / rows[0][0][thickness]} thickness"
        yield own.judge(suffix, f"{compared}, which differs by (a/thickness)**{power}", rows, digits=DIGITS, lost=LOST)


def _drawn(own: Comparison) -> list[Values]:
    """Of a profile with kinks one contact, of which every depth is a sum of integrals; with waves that with fewest."""
    drawn = own.tame((*own.profile.breaks, nt.r, nt.a), AMONG, (nt.E_star, *own.profile.free_depth))
    if nt.wavelength in own.profile.parameters:
        return [max(drawn, key=lambda values: values[nt.wavelength] / values[nt.a])]
    return sorted(drawn, key=decades)[: 1 if own.profile.breaks else len(CASES)]


def _regular(formula: sp.Expr) -> sp.Expr:
    """With `RATE`, and t**2 = r**2 + u**2 where an integral begins at r."""
    rated = formula.replace(sp.Derivative, lambda spring, _: RATE(*spring.args))
    return rated.replace(
        lambda part: isinstance(part, sp.Integral) and part.has(RATE),
        lambda part: part.transform(nt.t, (sp.sqrt(nt.r**2 + nt.u**2), nt.u)),
    )


def _kernel(values: Values, base: str) -> Callable[..., Number]:
    """The kernel by its integral, with the closed L."""
    h = number(values[thickness])
    share = sp.lambdify(nt.u, 1 - sinking(nt.u, base).subs(nt.nu, values[nt.nu]), "mpmath")
    known = [
        (k / h, 2 * (high - low) * weight * share(k) / (mp.pi * h))
        for low, high in pairwise(STRETCHES)
        for x, weight in gauss_rule(NODES, mp.mp.prec)
        for k in (low + (high - low) * x,)
    ]
    return lambda s, t: mp.fsum(weight * mp.cos(k * s) * mp.cos(k * t) for k, weight in known)
