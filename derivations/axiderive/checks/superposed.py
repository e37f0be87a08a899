"""What ties the entries of a physics to those of the contact it superposes, and prescribed pressures to a punch.

Adhesion without the rule of Hess: stationarity, crack closure, known pull-off loads.  Partial slip at its smallest
stick zone and summed over the contact.  Viscoelastic laws in their elastic limits.
"""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import FOUR, Entry
from ..oracle.evaluate import case_at, evaluate, evaluated
from ..oracle.integrals import GUARD
from ..oracle.rules import integrate
from ..oracle.sampling import points
from ..oracle.shape import Number, Values, number, shape
from ..physics import adhesive, viscoelastic
from ..profiles.loads import Load
from .comparison import Comparison, Entries, Evidence, Outcome, Rows, not_available, residual
from .identities import traction_carried

KNOWN = {  # Johnson, Kendall & Roberts 1971, Maugis & Barquins 1981; graded: Chen et al. 2009
    "paraboloid.adh.ac": (9 * sp.pi * nt.R**2 * nt.dgamma / (8 * nt.E_star)) ** sp.Rational(1, 3),
    "paraboloid.adh.Fc": -sp.Rational(3, 2) * sp.pi * nt.R * nt.dgamma,
    "paraboloid.adh.Fm": -sp.Rational(5, 6) * sp.pi * nt.R * nt.dgamma,
    "paraboloid.fgm.adh.Fc": -(3 + nt.k) / 2 * sp.pi * nt.R * nt.dgamma,
    "cone.adh.Fc": -54 * nt.dgamma**2 / (sp.pi * nt.E_star * sp.tan(nt.theta) ** 3),
}
STATIONARY = {"force": "F", "depth": "d"}
VANISHING = 60
TINY = sp.Rational(1, 10**VANISHING)
"""What stands for a parameter that vanishes; the formulas depend on it with its first power at least."""


def adhesion(own: Comparison, plain: Entries) -> list[Evidence]:
    """`plain` are the entries of the contact without adhesion; a fixed edge leaves nothing to compare here."""
    if own.profile.complete:
        return []
    found = [without_adhesion(own.entries[suffix], plain[suffix]) for suffix in FOUR]
    for control in adhesive.CONTROLS:
        found += stationary(own, control)
    return [*found, *known_values(own), crack_closure(own)]


def without_adhesion(entry: Entry, plain: Entry) -> Evidence:
    """For dgamma = 0 every formula is the one of the contact without adhesion, symbol by symbol."""
    compared = f"dgamma = 0: {plain.key}, symbolically"
    same = len(entry.cases) == len(plain.cases) and all(
        case.chain == own.chain and sp.expand(case.expr.subs(nt.dgamma, 0) - own.expr) == 0
        for case, own in zip(entry.cases, plain.cases, strict=True)
    )
    return Evidence(entry.key, compared, "passed" if same else "failed", count=len(entry.cases))


def _at_pull_off(own: Comparison, control: str) -> list[Values]:
    """Points of pull-off as the entry for its radius says: the radius if it is closed, else dgamma for a radius."""
    name, digits = adhesive.CONTROLS[control][0], own.digits + 10
    entry = own.entries[name]
    out: list[Values] = []
    for point in own.drawn(name, 2):
        values = {**point.values, nt.a_c: point.values[nt.a]}
        case = case_at(entry, values)
        if entry.status == "closed":
            radius = evaluate(case.expr, {s: x for s, x in values.items() if s not in (nt.a, nt.a_c)}, digits)
            values |= {nt.a: radius, nt.a_c: radius}
        else:
            level = case.expr.rhs / sp.sqrt(nt.dgamma)
            values[nt.dgamma] = (evaluate(case.expr.lhs, values, digits) / evaluate(level, values, digits)) ** 2
        out.append(values)
    return out


def stationary(own: Comparison, control: str) -> list[Evidence]:
    """dX/da = 0 there for X = F or d, differentiated as it stands; force and depth are the entries at that radius."""
    names, quantity, digits = adhesive.CONTROLS[control], STATIONARY[control], own.digits
    rows: dict[str, Rows] = {name: [] for name in names}
    with mp.workdps(digits + 40):
        for values in _at_pull_off(own, control):
            whole = case_at(own.entries[quantity], values).expr
            rest = whole.subs(nt.dgamma, 0)
            slopes = [evaluate(sp.diff(part, nt.a), values, digits) for part in (rest, sp.expand(rest - whole))]
            rows[names[0]].append((values, residual(*slopes)))
            for name in names[1:]:
                suffix = str(own.entries[name].quantity.symbol)
                pair = (evaluate(case_at(own.entries[s], values).expr, values, digits) for s in (name, suffix))
                rows[name].append((values, residual(*pair)))
    compared = (f"d{quantity}/da = 0", f"F at {names[0]}", f"d at {names[0]}")
    return [own.judge(name, what, rows[name]) for name, what in zip(names, compared, strict=True)]


def known_values(own: Comparison) -> list[Evidence]:
    """Pull-off of paraboloid and cone as the literature has it."""
    found = []
    for suffix, entry in own.entries.items():
        if entry.key not in KNOWN:
            continue
        rows: Rows = []
        with mp.workdps(own.digits + 40):
            for values in _at_pull_off(own, entry.quantity.control):
                pair = (case_at(entry, values).expr, KNOWN[entry.key])
                rows.append((values, residual(*(evaluate(x, values, own.digits) for x in pair))))
        found.append(own.judge(suffix, f"known value {sp.sstr(KNOWN[entry.key])}", rows))
    return found


def crack_closure(own: Comparison) -> Evidence:
    """The work that closes the crack over a length t, int p(s) gap(t - s) ds/2 over t -> 0, is dgamma (Irwin).

    Traction and gap at the edge are Q s**((k-1)/2) and B s**((1-k)/2), read off p and w at a relative distance of
    10**-(digits + 10); their leading terms are those with dgamma.
    """
    compared = "work of closing the crack, from p inside and w outside, = dgamma"
    entries, digits = own.entries, own.digits
    rows: Rows = []
    distance = sp.Rational(1, 10 ** (digits + 10))
    if any(entries[s].status != "closed" for s in ("p", "w")):
        return not_available(entries["p"].key, compared, "p or w is an integral, too slow so near to the edge")
    for point in own.drawn("d", 1):
        if point.extreme:
            continue
        values = point.values
        with mp.workdps(4 * digits):
            k, a = number(values.get(nt.k, sp.S.Zero)), values[nt.a]
            inner, outer = ({**values, nt.r: a * (1 + sign * distance)} for sign in (-1, 1))
            pull = -evaluate(case_at(entries["p"], inner).expr, inner, digits)
            depth, surface = (evaluate(case_at(entries[s], outer).expr, outer, 2 * digits + 20) for s in ("d", "w"))
            wide = shape(own.profile, {**values, nt.a: 2 * a})
            gap = wide.height(number(outer[nt.r])) - depth + surface
            step = number(a * distance)
            work = pull * step ** ((1 - k) / 2) * gap / step ** ((1 - k) / 2) * mp.beta((1 + k) / 2, (3 - k) / 2) / 2
            rows.append((values, residual(work, number(values[nt.dgamma]))))
    return own.judge("p", compared, rows)


def slip(own: Comparison, plain: Entries) -> list[Evidence]:
    """Full slip as the stick zone shrinks to what it starts from, and a traction summed over the contact."""
    found, digits = [], own.digits
    if own.physics.shear:
        found = [traction_carried(own), superposed(own.entries["tau"], plain["p"])]
    whole = next((name for name, _ in own.physics.slipped.values() if name in own.entries), "")
    for suffix, (name, compared) in own.physics.slipped.items() if whole else ():
        below, full = name.startswith("plain."), own.entries.get(name) or plain[name.removeprefix("plain.")]
        rows: Rows = []
        for point in own.drawn(whole, 1):
            values = dict(point.values)
            with mp.workdps(3 * digits):
                if own.profile.truncated:
                    gap = mp.mpf(10) ** (-2 * digits - 10)
                    values[nt.c] = evaluated(own.profile.breaks[0], values) * (1 + gap)
                else:
                    values[nt.c] = TINY**3 * values[nt.a]
                got, wanted = (evaluate(case_at(e, values).expr, values, digits) for e in (own.entries[suffix], full))
                rows.append((values, residual(got, (number(values[nt.mu]) if below else 1) * wanted)))
        found.append(own.judge(suffix, f"c at its smallest: {compared}", rows))
    return found


def superposed(entry: Entry, pressure: Entry) -> Evidence:
    """In every case mu times the pressure of the contact of radius a, less that of radius c where it sticks."""
    cases, count = {case.chain: case.expr for case in pressure.cases}, 0
    for case in entry.cases:
        outer = cases.get(tuple(x for x in case.chain if x != nt.c))
        inner = cases.get(tuple(nt.a if x == nt.c else x for x in case.chain if x != nt.a))
        if case.below(nt.c, nt.r):
            inner = sp.S.Zero
        if outer is not None and inner is not None:
            count += sp.expand(case.expr - nt.mu * (outer - inner.subs(nt.a, nt.c))) == 0
    outcome: Outcome = "passed" if count == len(entry.cases) else "failed"
    return Evidence(entry.key, f"mu times the difference of two {pressure.key}, symbolically", outcome, count=count)


ELASTIC = {
    "mx": (lambda at: {nt.relaxation: at[nt.time] / TINY}, lambda at: at[nt.E], "tau -> infinity"),
    "kv": (lambda at: {nt.eta: at[nt.E] * at[nt.time] * TINY}, lambda at: at[nt.E], "eta -> 0"),
    "sls": (
        lambda at: {nt.relaxation: at[nt.time] / TINY}, lambda at: at[nt.E_inf] + at[nt.E_1], "tau -> infinity",
    ),
    "pc": (lambda at: {nt.alpha: TINY}, lambda at: at[nt.E], "alpha -> 0"),
}  # fmt: skip
"""Where each law is elastic: the parameter at its limit, the modulus that is left, and the words."""


SPRING = {
    "earlier": nt.t_m - nt.v_2 / nt.v * (nt.time - nt.t_h),
    "end": nt.t_h + nt.v / nt.v_2 * nt.t_m,
}
"""Times of the way back along the line of the way in."""


def elastic(own: Comparison, plain: Entries) -> list[Evidence]:
    """Every formula of a law in its elastic limit gives the elastic force or radius, at the depth that there is."""
    found = []
    for suffix, entry in own.entries.items():
        kind, law = suffix.split("_")
        given = {"load": nt.F, "radius": nt.d}.get(kind)
        radii = (one for one in plain.values() if one.quantity.symbol == nt.a and given in one.quantity.arguments)
        source = next(radii, viscoelastic.of_depth(plain))
        if entry.status != "closed" or source.status != "closed" or viscoelastic.in_radius(entry):
            continue
        limit, modulus, words = ELASTIC[law]
        rows: Rows = []
        for case in source.cases:
            drawn = own.tame(case.chain, 9, (*entry.parameters, nt.time, nt.d, nt.F))[0]
            shares = {nt.t_1: 1, nt.t_m: sp.Rational(3, 2), nt.t_h: sp.Rational(7, 4), nt.t_c: 4}
            times = {symbol: share * drawn[nt.time] / 2 for symbol, share in shares.items()}
            there = times[nt.t_1] if nt.t_m in entry.parameters else drawn[nt.time]
            values = {**drawn, **times, nt.v: drawn[nt.d] / there}
            values |= {nt.E_star: modulus(values), **limit(values)}
            if own.profile.compact:
                values.pop(nt.a, None)
            digits = own.digits + VANISHING  # a time over tau = 1e60 beside 1 is lost with fewer
            with mp.workdps(digits + GUARD):
                got = evaluate(case_at(entry, values).expr, values, digits)
                known = SPRING[kind] if kind in SPRING else case_at(source, values).expr
                rows.append((values, residual(got, evaluate(known, values, digits))))
        line = "the line of the way in" if kind in SPRING else source.key
        found.append(own.judge(suffix, f"{words}: {line}", rows))
    return found


def check_profile(own: Comparison, plain: Entries) -> list[Evidence]:
    """What ties a contact to the one below it, by what it is: held by adhesion, relaxing, or slipping."""
    if own.physics.tension:
        return adhesion(own, plain)
    return elastic(own, plain) if own.physics.laws else slip(own, plain)


def reciprocity(own: Comparison, load: Load) -> Evidence:
    """Betti with a flat punch of twice the radius and depth d: int p_punch w dA = d p_0 pi a**2/(1 + s)."""
    entry, digits = own.entries["w"], own.digits
    rows: Rows = []
    for point in points(load, (nt.a,), 2, own.seed, (nt.E_star,)):
        values = {**point.values, nt.sigma: sp.Rational(-1, 4)}
        with mp.workdps(2 * digits + GUARD):
            a, modulus = number(values[nt.a]), number(values[nt.E_star])
            s = number(sp.sympify(load.exponent).xreplace(values))

            def carried(r: Number, at: Values = values) -> Number:
                at = {**at, nt.r: r}
                return evaluated(case_at(entry, at).expr, at)

            def sunk(u: Number, a: Number = a, inner: bool = True) -> Number:
                """w r dr/sqrt(4 a**2 - r**2) in r = a sin(u) inside, r = a + u outside up to the middle of the ring."""
                r = a * mp.sin(u) if inner else a + u
                return carried(r) * r / mp.sqrt((2 * a - r) * (2 * a + r)) * (a * mp.cos(u) if inner else 1)

            def at_rim(v: Number, a: Number = a) -> Number:
                return carried(2 * a * mp.cos(v)) * 2 * a * mp.cos(v)

            def from_edge(x: Number, inner: bool, a: Number = a) -> Number:
                if x < mp.mpf(10) ** (-digits - 10) * a:  # where the pressure ends the displacement is finite
                    return mp.mpf(0)
                return sunk(mp.pi / 2 - x if inner else x, a, inner)

            quarter, rim = mp.pi / 4, mp.acos(mp.mpf(3) / 4)
            total = integrate(sunk, mp.mpf(0), quarter, (mp.pi / 2,), digits)
            total += integrate(lambda x: from_edge(x, True), mp.mpf(0), quarter, (0j,), digits)
            total += integrate(lambda x: from_edge(x, False), mp.mpf(0), a / 2, (0j, complex(a)), digits)
            total += integrate(at_rim, mp.mpf(0), rim, (complex(mp.pi / 3), -complex(mp.pi / 3)), digits)
            force = number(values[nt.p_0]) * mp.pi * a**2 / (1 + s)
            rows.append((values, residual(2 * modulus * total, force)))
    return own.judge("w", "reciprocity with a flat punch of twice the radius", rows)
