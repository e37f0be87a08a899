"""Identities across the entries of tangential, graded and viscoelastic contact, independent of their derivation."""

from __future__ import annotations

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.balls import NotAvailableError, enclose_value
from ..oracle.evaluate import case_at, evaluate, evaluated
from ..oracle.evidence import Evidence, Outcome, judge, residual
from ..oracle.integrals import GUARD
from ..oracle.rules import integrate
from ..oracle.sampling import points
from ..oracle.shape import Number, Values, number
from ..physics import normal, tangential
from ..physics.viscoelastic import of_depth
from ..profiles.profile import Profile
from . import resultants
from .physics_quadrature import Entries, drawn_points
from .quadrature import LOST

Rows = list[tuple[Values, Number]]
TINY = sp.Rational(1, 10**60)
"""What stands for a parameter that vanishes; the formulas depend on it with its first power at least."""


def _judge(entry: Entry, compared: str, rows: Rows, digits: int, seed: int) -> Evidence:
    return judge(entry.key, compared, rows, seed=seed, extremes=0, digits=digits, required=digits - LOST)


# tangential


def slip(profile: Profile, entries: Entries, plain: Entries, *, digits: int = 50, seed: int = 0) -> list[Evidence]:
    """Full slip as the stick zone shrinks to what it starts from, and the traction summed over the contact."""
    found = [resultants.traction(profile, entries, digits=digits, seed=seed), superposed(entries["tau"], plain["p"])]
    floor = profile.breaks[0] if profile.truncated else None
    for suffix, source, compared in (("F", "F", "mu F"), ("u", "us", "displacement at full slip")):
        rows: Rows = []
        for point in drawn_points(profile, entries, "us", tangential.PHYSICS, 1, seed):
            values = dict(point.values)
            with mp.workdps(3 * digits):
                least = TINY**3 if floor is None else evaluated(floor, values) * (1 + mp.mpf(10) ** (-2 * digits - 10))
                values[nt.c] = least * values[nt.a] if floor is None else least
                got = evaluate(case_at(entries[suffix], values).expr, values, digits)
                other = plain if source == "F" else entries
                scale = number(values[nt.mu]) if source == "F" else 1
                wanted = scale * evaluate(case_at(other[source], values).expr, values, digits)
                rows.append((values, residual(got, wanted)))
        found.append(_judge(entries[suffix], f"c at its smallest: {compared}", rows, digits, seed))
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


# graded


def stiffness(profile: Profile, entries: Entries, *, digits: int = 50, seed: int = 0) -> Evidence:
    """dF/dd by differentiating force and depth, or the force by a depth that is free."""
    free = profile.complete
    rows: Rows = []
    for point in drawn_points(profile, entries, "F", normal.PHYSICS, 1, seed):
        if point.extreme:
            continue
        values = point.values
        with mp.workdps(digits + GUARD):
            force = case_at(entries["F"], values).expr
            slope = (
                sp.diff(force, nt.d)
                if free
                else sp.diff(force, nt.a) / sp.diff(case_at(entries["d"], values).expr, nt.a)
            )
            wanted = evaluate(case_at(entries["k"], values).expr, values, digits)
            rows.append((values, residual(_value(slope, values, digits), wanted)))
    return _judge(entries["k"], "dF/dd, by differentiating F and d", rows, digits, seed)


def _value(expr: sp.Expr, values: Values, digits: int) -> Number:
    try:
        return enclose_value(expr, values, digits)
    except NotAvailableError:
        return evaluate(expr, values, digits)


# viscoelastic

ELASTIC = {
    "mx": (lambda at: {nt.relaxation: at[nt.time] / TINY}, lambda at: at[nt.E], "tau -> infinity"),
    "kv": (lambda at: {nt.eta: at[nt.E] * at[nt.time] * TINY}, lambda at: at[nt.E], "eta -> 0"),
    "sls": (
        lambda at: {nt.relaxation: at[nt.time] / TINY}, lambda at: at[nt.E_inf] + at[nt.E_1], "tau -> infinity",
    ),
    "pc": (lambda at: {nt.alpha: TINY}, lambda at: at[nt.E], "alpha -> 0"),
}  # fmt: skip
"""Where each law is elastic: the parameter at its limit, the modulus that is left, and the words."""


def elastic(profile: Profile, entries: Entries, plain: Entries, *, digits: int = 50, seed: int = 0) -> list[Evidence]:
    """Every formula of a law in its elastic limit gives the elastic force or radius."""
    found = []
    for suffix, entry in entries.items():
        kind, law = suffix.split("_")
        source = plain["aF"] if kind == "load" else of_depth(plain)
        if entry.status != "closed" or source.status != "closed":
            continue
        limit, modulus, words = ELASTIC[law]
        rows: Rows = []
        for case in source.cases:
            fields = (*entry.parameters, nt.time, nt.d, nt.F)
            drawn = [point.values for point in points(profile, case.chain, 9, seed, fields) if not point.extreme]
            values = {**drawn[0], nt.v: drawn[0][nt.d] / drawn[0][nt.time]}
            values |= {nt.E_star: modulus(values), **limit(values)}
            if profile.compact:
                values.pop(nt.a, None)
            with mp.workdps(digits + GUARD):
                got, want = (evaluate(case_at(e, values).expr, values, digits) for e in (entry, source))
            rows.append((values, residual(got, want)))
        found.append(_judge(entry, f"{words}: {source.key}", rows, digits, seed))
    return found


# prescribed pressure


def reciprocity(load: Profile, entries: Entries, *, digits: int = 50, seed: int = 0) -> Evidence:
    """Betti with a flat punch of twice the radius and depth d: int p_punch w dA = d p_0 pi a**2/(1 + s)."""
    entry = entries["w"]
    rows: Rows = []
    for point in points(load, (nt.a,), 9, seed, (nt.E_star,)):
        values = {**point.values, nt.sigma: sp.Rational(-1, 4)}
        with mp.workdps(2 * digits + GUARD):
            a, modulus = number(values[nt.a]), number(values[nt.E_star])
            s = number(sp.sympify(load.exponent).xreplace(values))  # type: ignore[attr-defined]

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
        if len(rows) == 2:
            break
    return _judge(entry, "reciprocity with a flat punch of twice the radius", rows, digits, seed)
