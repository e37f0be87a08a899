"""Identities of adhesive contact without the rule of Hess: stationarity, crack closure, known pull-off loads."""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Entry
from ..oracle.evaluate import case_at, evaluate
from ..oracle.evidence import Evidence, judge, not_available, residual
from ..oracle.shape import Number, Values, number, shape
from ..physics import adhesive
from ..profiles.profile import Profile
from .physics_quadrature import Entries, drawn_points
from .quadrature import LOST

KNOWN = {  # Johnson, Kendall & Roberts 1971, Maugis & Barquins 1981; graded: Chen et al. 2009
    "paraboloid.adh.ac": (9 * sp.pi * nt.R**2 * nt.dgamma / (8 * nt.E_star)) ** sp.Rational(1, 3),
    "paraboloid.adh.Fc": -sp.Rational(3, 2) * sp.pi * nt.R * nt.dgamma,
    "paraboloid.adh.Fm": -sp.Rational(5, 6) * sp.pi * nt.R * nt.dgamma,
    "paraboloid.fgm.adh.Fc": -(3 + nt.k) / 2 * sp.pi * nt.R * nt.dgamma,
    "cone.adh.Fc": -54 * nt.dgamma**2 / (sp.pi * nt.E_star * sp.tan(nt.theta) ** 3),
}
STATIONARY = {"force": "F", "depth": "d"}


def check_profile(
    profile: Profile, entries: Entries, plain: Entries, *, digits: int = 50, seed: int = 0
) -> list[Evidence]:
    """`plain` are the entries of the contact without adhesion; a fixed edge leaves nothing to compare here."""
    if profile.complete:
        return []
    found = [without_adhesion(entries[suffix], plain[suffix]) for suffix in FOUR]
    for control in adhesive.CONTROLS:
        found += stationary(profile, entries, control, digits, seed)
    return [*found, *known_values(profile, entries, digits, seed), crack_closure(profile, entries, digits, seed)]


def without_adhesion(entry: Entry, plain: Entry) -> Evidence:
    """For dgamma = 0 every formula is the one of the contact without adhesion, symbol by symbol."""
    compared = f"dgamma = 0: {plain.key}, symbolically"
    same = len(entry.cases) == len(plain.cases) and all(
        case.chain == own.chain and sp.expand(case.expr.subs(nt.dgamma, 0) - own.expr) == 0
        for case, own in zip(entry.cases, plain.cases, strict=True)
    )
    return Evidence(entry.key, compared, "passed" if same else "failed", count=len(entry.cases))


def _at_pull_off(profile: Profile, entries: Entries, control: str, digits: int, seed: int) -> list[Values]:
    """Points of pull-off as the entry for its radius says: the radius if it is closed, else dgamma for a radius."""
    name = adhesive.CONTROLS[control][0]
    entry = entries[name]
    out: list[Values] = []
    for point in drawn_points(profile, entries, name, adhesive.PHYSICS, 2, seed):
        values = {**point.values, nt.a_c: point.values[nt.a]}
        case = case_at(entry, values)
        if entry.status == "closed":
            radius = evaluate(case.expr, {s: x for s, x in values.items() if s not in (nt.a, nt.a_c)}, digits + 10)
            values |= {nt.a: radius, nt.a_c: radius}
        else:
            level = case.expr.rhs / sp.sqrt(nt.dgamma)
            ratio = evaluate(case.expr.lhs, values, digits + 10) / evaluate(level, values, digits + 10)
            values[nt.dgamma] = ratio**2
        out.append(values)
    return out


def stationary(profile: Profile, entries: Entries, control: str, digits: int, seed: int) -> list[Evidence]:
    """dX/da = 0 there for X = F or d, differentiated as it stands; force and depth are the entries at that radius."""
    names, quantity = adhesive.CONTROLS[control], STATIONARY[control]
    rows: dict[str, list[tuple[Values, Number]]] = {name: [] for name in names}
    with mp.workdps(digits + 40):
        for values in _at_pull_off(profile, entries, control, digits, seed):
            whole = case_at(entries[quantity], values).expr
            rest = whole.subs(nt.dgamma, 0)
            slopes = [evaluate(sp.diff(part, nt.a), values, digits) for part in (rest, sp.expand(rest - whole))]
            rows[names[0]].append((values, residual(*slopes)))
            for name in names[1:]:
                suffix = str(entries[name].quantity.symbol)
                got, want = (evaluate(case_at(entries[s], values).expr, values, digits) for s in (name, suffix))
                rows[name].append((values, residual(got, want)))
    compared = (f"d{quantity}/da = 0", f"F at {names[0]}", f"d at {names[0]}")
    return [
        judge(
            entries[name].key, what, rows[name], seed=seed, extremes=0, digits=digits, required=digits - LOST
        )
        for name, what in zip(names, compared, strict=True)
    ]  # fmt: skip


def known_values(profile: Profile, entries: Entries, digits: int, seed: int) -> list[Evidence]:
    """Pull-off of paraboloid and cone as the literature has it."""
    found = []
    for entry in entries.values():
        if entry.key not in KNOWN:
            continue
        rows = []
        with mp.workdps(digits + 40):
            for values in _at_pull_off(profile, entries, entry.quantity.control, digits, seed):
                pair = [evaluate(x, values, digits) for x in (case_at(entry, values).expr, KNOWN[entry.key])]
                rows.append((values, residual(*pair)))
        compared = f"known value {sp.sstr(KNOWN[entry.key])}"
        found.append(judge(entry.key, compared, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST))
    return found


def crack_closure(profile: Profile, entries: Entries, digits: int, seed: int) -> Evidence:
    """The work that closes the crack over a length t, int p(s) gap(t - s) ds/2 over t -> 0, is dgamma (Irwin).

    Traction and gap at the edge are Q s**((k-1)/2) and B s**((1-k)/2), read off p and w at a relative distance of
    10**-(digits + 10); their leading terms are those with dgamma.
    """
    compared = "work of closing the crack, from p inside and w outside, = dgamma"
    rows: list[tuple[Values, Number]] = []
    distance = sp.Rational(1, 10 ** (digits + 10))
    if any(entries[s].status != "closed" for s in ("p", "w")):
        return not_available(entries["p"].key, compared, "p or w is an integral, too slow so near to the edge")
    for point in drawn_points(profile, entries, "d", adhesive.PHYSICS, 1, seed):
        if point.extreme:
            continue
        values = point.values
        with mp.workdps(4 * digits):
            k, a = number(values.get(nt.k, sp.S.Zero)), values[nt.a]
            inner, outer = ({**values, nt.r: a * (1 + sign * distance)} for sign in (-1, 1))
            pull = -evaluate(case_at(entries["p"], inner).expr, inner, digits)
            depth = evaluate(case_at(entries["d"], outer).expr, outer, 2 * digits + 20)
            surface = evaluate(case_at(entries["w"], outer).expr, outer, 2 * digits + 20)
            wide = shape(profile, {**values, nt.a: 2 * a})
            gap = wide.height(number(outer[nt.r])) - depth + surface
            step = number(a * distance)
            work = pull * step ** ((1 - k) / 2) * gap / step ** ((1 - k) / 2) * mp.beta((1 + k) / 2, (3 - k) / 2) / 2
            rows.append((values, residual(work, number(values[nt.dgamma]))))
    return judge(entries["p"].key, compared, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)
