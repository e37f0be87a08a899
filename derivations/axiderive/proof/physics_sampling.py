"""Points at which the formulas of graded, adhesive and tangential contact are checked."""

from __future__ import annotations

import itertools
import random
from collections.abc import Mapping

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..profiles.profile import Profile
from .half_space import HalfSpace
from .quadrature import INVERSES
from .sampling import Point, points
from .shape import Values, number

Entries = Mapping[str, Entry]

EXPONENTS = tuple(sp.Rational(x) for x in ("-7/10", "-3/10", "1/5", "3/5", "1/2"))
"""Exponents of grading; every sixth point gets a random one."""
MANY = 6
"""Cases above which one point for each is enough."""
PULL_OFF = {
    "ac": ("force", "a"), "Fc": ("force", "F"), "dc": ("force", "d"),
    "am": ("depth", "a"), "Fm": ("depth", "F"), "dm": ("depth", "d"),
}  # fmt: skip
FIELDS = {
    "graded": (nt.H,),
    "adhesive": (nt.dgamma, nt.H),
    "tangential": (nt.mu, nt.G_star, nt.H, nt.H_x),
}


def drawn_points(profile: Profile, entries: Entries, suffix: str, physics: str, count: int, seed: int) -> list[Point]:
    """Points spread over the cases, those of an inverse over the cases of what it inverts."""
    source = entries[suffix]
    graded = nt.k in source.parameters
    if physics == "adhesive" and (suffix in INVERSES or suffix in PULL_OFF) and "d" in entries:
        source = entries["d"]
    elif suffix in INVERSES and profile.contact == "compact":
        source = entries[INVERSES[suffix][0]]
    elif (suffix == "dF" and profile.contact == "complete") or (physics == "tangential" and suffix == "c"):
        source = entries["F"]
    elif suffix in ("k", "pm", "Dl") and "d" in entries:
        source = entries["d"]
    fields = (*source.quantity.arguments, *FIELDS[physics]) + ((nt.d,) if profile.contact == "complete" else ())
    # an unevaluated integral next to a border takes long; the closed formulas get the extreme points
    tame = graded and (suffix in ("p", "tau") or any(case.expr.has(sp.Integral) for case in entries[suffix].cases))
    many = len(source.cases) > MANY
    each = max(1 if tame or many else 2, -(-count // len(source.cases)))
    out: list[Point] = []
    chains = [case.chain for case in source.cases]
    if tame and suffix == "tau":  # seconds each; that every case is a difference of two pressures is shown symbolically
        chains = chains[:: -(-len(chains) // MANY)]
    for chain in chains:
        candidates = (_point(profile, chain, i, len(out), seed, fields, graded, tame) for i in itertools.count())
        growing = profile.contact == "compact" and suffix in PULL_OFF
        kept = (p for p in candidates if not growing or _grows(profile, p.values, graded))
        for _ in range(each):
            out.append(next(kept))
    return out


def _grows(profile: Profile, values: Values, graded: bool) -> bool:
    """Whether the depth grows with the contact: the largest radius that a profile names is that for k = 0."""
    with mp.workdps(20):
        return bool(HalfSpace(profile, values, 10, graded).rates(number(values[nt.a]))[0] > 0)


def _point(
    profile: Profile, chain: tuple[sp.Expr, ...], i: int, index: int, seed: int, fields: tuple[sp.Symbol, ...],
    graded: bool, tame: bool,
) -> Point:  # fmt: skip
    """The i-th point of a case; on the graded half-space the exponent comes first, because chains may contain it."""
    exponents = {nt.k: _exponent(index, profile.name, seed)} if graded else {}
    chain = tuple(length.subs(exponents) for length in chain)
    drawn = [p for p in points(profile, chain, i + 1 + (12 if tame else 0), seed, fields) if not (tame and p.extreme)]
    values = {**drawn[i].values, **exponents}
    if nt.dgamma in fields and nt.n in values and 2 * values[nt.n] + values.get(nt.k, 0) == 1:
        values[nt.n] = sp.Rational(37, 10)  # g and Dl are the same power of a: nothing is stationary
    return Point(values, drawn[i].extreme)


def _exponent(index: int, name: str, seed: int) -> sp.Rational:
    shift = random.Random(f"{seed} {name}").randrange(len(EXPONENTS))
    random_one = sp.Rational(random.Random(f"{seed} {name} {index}").randint(-89, 89), 100)
    return (*EXPONENTS, random_one)[(index + shift) % (len(EXPONENTS) + 1)]
