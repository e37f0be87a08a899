"""Fields below the surface at points in double precision: their exact values, and the errors of the emitted functions.

The numbers of a contact are what their formulas say, sums over flat punches of all radii; where these are integrals
Gauss rules take them that know where the integrand is singular: at r + i z and where the slope g' is.  A stress is the
combination of them that the physics states, and its error is taken beside the largest of its components.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp
from flint import acb, arb

from .. import notation as nt
from ..abel.masters import Eta, Xi
from ..entry import Entry
from ..letters import name_of
from ..oracle import rules
from ..oracle.balls import Ball
from ..oracle.evaluate import case_at, decades, evaluated
from ..oracle.shape import Number, coefficient, concrete, number, shape
from ..physics import subsurface
from ..physics.normal import derive
from ..physics.subsurface import ANGLE, NUMBERS
from .measure import completed
from .reference import BENCH, SMALLEST, TERMS, Floats, floats

Numbers = dict[sp.Symbol, acb]
"""S_m, D_m and W by their symbols."""
DIGITS = 45
"""Of the rules; zz and rz lose twenty of them next to the surface beside the contact."""
CARRIED = 150
"""Digits carried: next to a break the nodes come as close as 1e-102, and the slope is a root of the distance."""
HIGHEST = 6 * CARRIED * CARRIED
"""Digits from which a number is taken for zero; at 1e150 radii a sextic loses 2000 of them."""

SHALLOW = mp.mpf(10) ** -40
"""A depth, over the contact radius, at which all is what it is on the surface."""


def exact_numbers(entries: Mapping[str, Entry], values: Mapping[Any, Any]) -> Numbers:
    """The numbers of a contact at a point, of exact values by symbol, to `DIGITS` digits of what is summed."""
    own = entries["S0"]
    case = case_at(own, values)
    index, found = own.cases.index(case), Numbers()
    for suffix, one in NUMBERS.items():
        expr = concrete(entries[suffix].cases[index].expr, values)
        found[one.symbol] = _closed(expr.xreplace(dict.fromkeys(expr.atoms(sp.Integral), sp.S.Zero)), values)
    with mp.workdps(CARRIED + 2 * decades(values)), rules.at_working_precision():
        known = _numbers(values)
        for integral in concrete(case.expr, values).atoms(sp.Integral):
            slope = integral.function / NUMBERS["S0"].unit(nt.t).expr()
            for symbol, share in _summed(slope, integral.limits[0][1:], known, *_singular(own, values)).items():
                found[symbol] += share
    return found


def _numbers(values: Mapping[Any, Any]) -> dict[sp.Symbol, Number]:
    return {symbol: number(x) for symbol, x in values.items() if isinstance(symbol, sp.Symbol)}


def _closed(expr: sp.Expr, values: Mapping[Any, Any]) -> acb:
    """A formula without integrals, at a precision that leaves `CARRIED` digits of it where it is not zero."""
    digits, value = CARRIED, acb(0)
    while expr != 0 and digits < HIGHEST:
        with mp.workdps(digits), rules.at_working_precision():
            point = {symbol: acb(rules.ball(x)) for symbol, x in _numbers(values).items()}
            value = Ball(point | _oblate(expr, point), False)(expr)
            if value == 0 or value.real.rel_accuracy_bits() > 3 * CARRIED:
                break
        digits *= 2
    return value


def _oblate(expr: sp.Expr, point: Mapping[Any, acb]) -> dict[Any, acb]:
    """The oblate coordinates in a formula."""
    out = {}
    for call in expr.atoms(Xi, Eta):
        r, z, t = (Ball(dict(point), False)(arg) for arg in call.args)
        rho = _rho(z, t - r, t + r)
        out[call] = acb(rho.real if isinstance(call, Xi) else rho.imag)
    return out


def _rho(z: acb, gap: acb, sum_: acb) -> acb:
    i = acb(0, 1)
    return (z + i * gap).sqrt() * (z + i * sum_).sqrt()


def _singular(entry: Entry, values: Mapping[Any, Any]) -> tuple[list[complex], float]:
    """Where the slope is singular, and the length over which it changes by a factor."""
    stretches = shape(entry.profile, values).stretches
    own = {z for piece in stretches for z in piece.singular} | {complex(piece.hi) for piece in stretches[:-1]}
    return sorted({*own, *(-z for z in own)}, key=lambda z: (abs(z), z.real, z.imag)), min(
        p.wavelength for p in stretches
    )


def _summed(
    slope: sp.Expr,
    limits: tuple[sp.Expr, sp.Expr],
    known: dict[sp.Symbol, Number],
    singular: list[complex],
    period: float,
) -> Numbers:
    """The integrals over punches of the radii between two limits."""
    low, high = (known[x] if x in known else mp.mpf(x) for x in limits)
    r, z = known[nt.r], known[nt.z]
    rate = rules.bound(slope, nt.t, {s: x for s, x in known.items() if s in slope.free_symbols})
    total = [acb(0)] * len(NUMBERS)
    ends = [low, *([r] if low < r < high else []), high]
    for start, end in zip(ends, ends[1:], strict=False):
        for origin, way in ((start, 1), (end, -1)):
            nodes: list[tuple[Number, Number]] = []

            def noted(f: object, rule: Callable[..., Any], of: tuple[Any, ...], lo: Number, length: Number) -> Number:
                nodes.extend((lo + length * x, abs(length) * weight) for x, weight in rule(*of))  # noqa: B023
                return length

            near = [complex((x - origin) * way, way * y) for x in (r, -r) for y in (z, -z)]
            near += [
                place if abs(place) > 1e-14 * high else 0j for place in ((s - complex(origin)) * way for s in singular)
            ]
            rules.integrate(None, mp.mpf(0), (end - start) / 2, near, DIGITS, panel=noted, longest=period)
            for x, weight in nodes:
                gap = (origin - r) + way * x
                t, both = rules.ball(origin + way * x), rules.ball(origin + r + way * x)
                share = rules.ball(weight) * rate(t)
                field = _punch(rules.ball(r), rules.ball(z), rules.ball(gap), both, t)
                total = [one + share * x for one, x in zip(total, field, strict=True)]
    return dict(zip((n.symbol for n in NUMBERS.values()), total, strict=True))


def _punch(r: arb, z: arb, gap: arb, both: arb, t: arb) -> list[arb]:
    """The numbers of a flat punch of radius t."""
    zeta, rho = acb(z, t), _rho(acb(z), acb(gap), acb(both))
    q = rho + zeta
    ratio, square = r / q, rho * rho
    X, flat, deep = 1 / rho, [], []
    for m in range(4):
        flat.append(-X.imag)
        deep.append(-z * ((zeta + m * rho) * X / square).imag)
        X = X * ratio
    return [*flat, *deep, q.log().imag]


@dataclass(frozen=True)
class Place:
    """One contact and a point below it, with the exact numbers there."""

    region: str
    values: Floats
    found: Numbers
    inner: Numbers | None
    """Those of the radius c, within which the contact sticks."""


COUNTS = {"bench": 8, "extreme": 14}
STICKING = 2
"""Points of the bench at which a part sticks; of the extreme ones it does at those next to the edge."""
EDGE, LOADED, FAR = "at the edge", "below the surface", "far away"
REGIONS = (EDGE, "at a break", "on the axis", LOADED, "beside the contact", FAR, "on the surface")
"""Of the extreme points, in turn."""


def _point(region: str, radius: float, marks: list[float], dice: random.Random) -> tuple[float, float]:
    """r and z in a region: `marks` are the edge and the breaks."""
    small = radius * 10 ** dice.uniform(-12, -2)
    turn = dice.uniform(0.0, math.pi)
    if region in (EDGE, "at a break"):
        centre = radius if region == EDGE else dice.choice(marks)
        return abs(centre + small * math.cos(turn)), small * math.sin(turn)
    if region == "on the axis":
        return 0.0, radius * 10 ** dice.uniform(-9, 9)
    if region == LOADED:
        return radius * dice.uniform(0.05, 0.9), small
    if region == "beside the contact":
        return radius * dice.uniform(1.1, 5.0), small
    if region == FAR:
        power = 150 if dice.random() < 0.5 else 6
        return radius * 10 ** dice.uniform(1, power), radius * 10 ** dice.uniform(1, power)
    if region == "on the surface":
        return radius * dice.uniform(0.05, 1.5), 0.0
    while True:
        r, z = radius * dice.uniform(0.0, 2.5), radius * dice.uniform(0.01, 2.5)
        if all(math.hypot(r - mark, z) > 0.1 * radius for mark in marks):
            return r, z


def places(
    entries: Mapping[str, Entry], plain: Mapping[str, Entry], domain: str, count: int, seed: int
) -> Iterator[Place]:
    """Contacts with a point away from edge and breaks, or in all `REGIONS` in turn."""
    entry = entries["S0"]
    for i, values in enumerate(floats(entry, BENCH, count, seed, (*entry.parameters, nt.nu, nt.mu, nt.E_star))):
        dice = random.Random(f"{seed} {entry.key} {domain} {i}")
        completed(plain, values)
        if nt.d in values:
            # at the least depth there is no stress below the ring of zero pressure to measure by
            values[nt.d] *= 2.0
        values |= {nt.nu: dice.uniform(-0.9, 0.5), ANGLE: dice.uniform(-3.0, 3.0)}
        point = _exact(entry, values)
        case = case_at(entry, point)
        lengths = [float(evaluated(x, point)) for x in case.chain]
        radius = lengths[case.chain.index(nt.a)] if entry.profile.compact else lengths[0]
        marks = [x for x in lengths if x <= radius]
        where = REGIONS[i % len(REGIONS)] if domain == "extreme" else ""
        values[nt.r], values[nt.z] = _point(where, radius, marks, dice)
        # elsewhere within the zone of stick a component may be what two sums of 1e10 times its size leave
        sticks = entry.profile.compact and (where == EDGE if where else i < STICKING)
        values[nt.c] = marks[0] + (radius - marks[0]) * 0.8 if len(marks) > 1 else 0.8 * radius
        point = _exact(entry, values)
        if values[nt.z] == 0.0:
            point[nt.z] = SHALLOW * number(radius)
        inner = exact_numbers(entries, {**point, nt.a: point[nt.c]}) if sticks else None
        yield Place(where, values, exact_numbers(entries, point), inner)


def _exact(entry: Entry, values: Floats) -> dict[Any, Any]:
    """The doubles as the rational numbers they are, the coefficients of a polynomial by their own symbols."""
    out: dict[Any, Any] = {s: sp.Rational(x) for s, x in values.items() if isinstance(x, float)}
    if nt.coefficients in values:
        out |= {coefficient(j): sp.Rational(x) for j, x in enumerate(values[nt.coefficients], 1)}
        out[nt.N] = sp.Integer(TERMS)
    return out | {symbol: expr.subs(out) for symbol, expr in entry.profile.abbreviations}


def _split(stated: Mapping[str, sp.Expr], members: tuple[str, ...]) -> dict[str, sp.Expr]:
    """The components of a result, of which the physics states sum and difference of two."""
    known = dict(stated)
    if "rr + tt" in known:
        both, apart = known["rr + tt"], known["rr - tt"]
        known |= {"rr": (both + apart) / 2, "tt": (both - apart) / 2}
    return {member: known[member] for member in members}


SLIDING = ("rr", "tt", "zz", "rt", "rz", "tz")
RESULTS = {
    "stress": _split(subsurface.STRESS, ("rr", "tt", "zz", "rz")),
    "displacement": _split(subsurface.DISPLACEMENT, ("r", "z")),
    "sliding_stress": _split(subsurface.FRICTION, SLIDING),
    "partial_slip_stress": _split(subsurface.FRICTION, SLIDING),
    "surface_stress": _split(subsurface.STRESS, ("rr", "tt")),
    "surface_displacement": _split(subsurface.DISPLACEMENT, ("r",)),
}
"""The components of every function of a point."""
STEP = 1e-5
"""Relative steps of r and z by which the condition of a component is found."""


def errors(module: Any, entry: Entry, function: str, place: Place) -> tuple[list[float], list[float]]:
    """Errors of a function at a place: of its components in units of the last place of the largest one, and of each in
    its own units over 1 + |d ln/d ln r| + |d ln/d ln z|, which is large next to its zeros.
    """
    along, own = [], []
    with mp.workdps(CARRIED), rules.at_working_precision():
        wanted = _wanted(entry, RESULTS[function], place, sticks=function == "partial_slip_stress")
        got, *moved = (_called(module, entry, function, place.values | one) for one in _moves(place.values))
        largest = max(abs(float(exact)) for exact in wanted)
        for exact, value, *others in zip(wanted, got, *moved, strict=True):
            along.append(_over(value, exact, largest))
            size = abs(float(exact))
            # on the surface the exact point is next to it
            if size > max(SMALLEST / STEP, 1e-20 * largest):
                change = sum(abs(x - value) for x in others) / (STEP * size)
                own.append(_over(value, exact, size) / (1.0 + change))
    return along, own


def _moves(values: Floats) -> list[dict[sp.Symbol, float]]:
    return [{}, {nt.r: values[nt.r] * (1.0 + STEP)}, {nt.z: values[nt.z] * (1.0 + STEP)}]


def _over(value: float, exact: arb, size: float) -> float:
    return float(abs(arb(value) - exact) / float(np.spacing(size))) if math.isfinite(value) else math.inf


def _wanted(entry: Entry, components: Mapping[str, sp.Expr], place: Place, *, sticks: bool) -> list[arb]:
    point: dict[Any, acb] = {s: acb(rules.ball(number(x))) for s, x in _exact(entry, place.values).items()}
    if place.values[nt.z] == 0.0:
        point[nt.z] = acb(0)
    states = [place.found, *([place.inner] if sticks and place.inner else [])]
    found = [[Ball(point | state, False)(expr).real for expr in components.values()] for state in states]
    return [one - sum(rest, arb(0)) for one, *rest in zip(*found, strict=True)]


def _called(module: Any, entry: Entry, function: str, values: Floats) -> list[float]:
    fields = [nt.r] if function.startswith("surface") else [nt.r, ANGLE, nt.z]
    if function in ("stress", "displacement"):
        fields.remove(ANGLE)
    given = (nt.a, *([nt.c] if function == "partial_slip_stress" else [])) if entry.profile.compact else (nt.d,)
    material = (nt.nu, *([nt.E_star] if function.endswith("stress") else []))
    material += (nt.mu,) if ANGLE in fields else ()
    keywords = {name_of(s): values[s] for s in (*entry.parameters, *material)}
    found = getattr(module, function)(*(values[s] for s in (*fields, *given)), **keywords)
    return list(found) if isinstance(found, tuple) else [found]


def measured(
    module: Any, entries: Mapping[str, Entry], seed: int
) -> Iterator[tuple[str, str, list[float], list[float]]]:
    """Function, domain, and the errors of it there: beside the largest component, and of each component.

    Those of components leave out the points just below the loaded surface, where rz and the zz of friction vanish like
    the depth and keep their digits beside the pressure alone, and far ones, where the tt of friction does so.
    """
    plain = derive(entries["S0"].profile)
    for domain, count in COUNTS.items():
        drawn = list(places(entries, plain, domain, count, seed))
        for function in filter(partial(hasattr, module), RESULTS):
            some = [place for place in drawn if _asked(function, place)]
            pairs = [errors(module, entries["S0"], function, place) for place in some]
            own = [x for place, (_, each) in zip(some, pairs, strict=True) if not _grazing(place) for x in each]
            yield function, domain, [x for along, _ in pairs for x in along], own


def _grazing(place: Place) -> bool:
    far = place.region == FAR and place.values[nt.z] < 1e-3 * place.values[nt.r]
    return far or place.region == LOADED


def _asked(function: str, place: Place) -> bool:
    """Whether a function is measured at a place."""
    if function == "partial_slip_stress":
        return place.inner is not None
    return place.values[nt.z] == 0.0 or not function.startswith("surface")
