"""Contact with a viscoelastic half-space: the integrals of Lee and Radok, and of Ting, by quadrature.

The elastic force is the defined one, as a function of the contact radius; the
ramp is an integral over the radii of the earlier contacts, without an inverse:
F = int E(t - g(x)/v) F_el'(x)/E* dx.  Relaxation and creep are stated here once
more, and belong together because their convolution is a unit step.

A way back is met where it leads: at a time t the contact is as large as at a chosen t_1 if the rate of the depth, v,
then 0 and -v_2, has left nothing from t_1 on, which says v_2.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluate, evaluated, of_one_variable
from ..oracle.half_space import HalfSpace
from ..oracle.rules import integrate
from ..oracle.shape import Number, Values, number
from ..physics import normal
from ..physics.viscoelastic import elastic_exponent, in_radius, of_depth, of_radius
from ..profiles.profile import Profile
from .comparison import Comparison, Entries, Evidence, Rows, residual, root

LOST = 8
BACK = 3
"""Points of the way back: its times say the same on every profile."""
SUMMED = 1
"""Points of each case of an integral, which is compared with another one to half the digits."""
ALPHAS = (sp.Rational(1, 5), sp.Rational(1, 2), sp.Rational(2, 5))
POWERS = (sp.Rational(1, 2), sp.Integer(1), sp.Integer(2), sp.Rational(37, 10))


@dataclass(frozen=True)
class Material:
    """E(t) for t > 0, impulse of E at t = 0, J(0), dJ/dt, and the exponents of E and J' at t = 0."""

    relaxation: Callable[[Number], Number]
    impulse: Number
    initial: Number
    creep_rate: Callable[[Number], Number]
    exponent: Number = mp.mpf(0)

    def creep(self, t: Number, digits: int) -> Number:
        """J(t)."""
        return self.initial + integrate(self.creep_rate, mp.mpf(0), t, (0j,), digits, self._least_rate)

    def convolution(self, t: Number, digits: int) -> Number:
        """int_0^t E(t - s) dJ(s) with the impulse of E: 1 for every t > 0."""
        halves = (
            (lambda s: self.relaxation(t - s) * self.creep_rate(s), self._least_rate),
            (lambda s: self.relaxation(s) * self.creep_rate(t - s), self.least),
        )
        parts = [integrate(f, mp.mpf(0), t / 2, (0j, complex(t)), digits, least) for f, least in halves]
        return self.relaxation(t) * self.initial + self.impulse * self.creep_rate(t) + parts[0] + parts[1]

    @property
    def least(self) -> float:
        """The exponent of E at t = 0, as a rule of integration takes it."""
        return min(float(self.exponent), -0.5)

    @property
    def _least_rate(self) -> float:
        return min(float(-1 - self.exponent), -0.5) if self.exponent else -0.5


def material(law: str, values: Values) -> Material:
    """The law at a point, from spring and dashpot."""
    zero = mp.mpf(0)

    def at(symbol: sp.Symbol) -> Number:
        return number(values[symbol])

    if law == "mx":  # spring and dashpot E tau in series
        modulus, tau = at(nt.E), at(nt.relaxation)
        return Material(lambda t: modulus * mp.exp(-t / tau), zero, 1 / modulus, lambda t: 1 / (modulus * tau))
    if law == "kv":  # side by side
        modulus, eta = at(nt.E), at(nt.eta)
        return Material(lambda t: modulus, eta, zero, lambda t: mp.exp(-modulus * t / eta) / eta)
    if law == "sls":  # a spring beside a Maxwell element
        rubber, relaxing, tau = at(nt.E_inf), at(nt.E_1), at(nt.relaxation)
        glass = rubber + relaxing
        rate = rubber / (glass * tau)
        return Material(
            lambda t: rubber + relaxing * mp.exp(-t / tau), zero, 1 / glass,
            lambda t: (1 / rubber - 1 / glass) * rate * mp.exp(-rate * t),
        )  # fmt: skip
    modulus, alpha, scale = at(nt.E), at(nt.alpha), at(nt.t_0)
    # sin(pi alpha)/(pi alpha) = 1/(Gamma(1 + alpha) Gamma(1 - alpha))
    factor = modulus * mp.sin(mp.pi * alpha) / (mp.pi * alpha)
    return Material(
        lambda t: factor * (t / scale) ** -alpha, zero, zero,
        lambda t: alpha / (modulus * scale) * (t / scale) ** (alpha - 1), -alpha,
    )  # fmt: skip


def check(own: Comparison, suffix: str) -> Evidence:
    """Ramp, step of depth, step of load, or a way back against the convolution."""
    entry, (kind, law) = own.entries[suffix], suffix.split("_")
    summed = kind in ("ramp", "retract") and in_radius(entry)
    count = SUMMED if summed else BACK if nt.v_2 in entry.parameters else own.points
    count, digits = min(own.points, count), own.digits // 2 if summed else own.digits
    rows: Rows = []
    plain = _elastic_entries(own.profile)
    fields = (*entry.parameters, nt.time, *own.profile.free_depth)
    cases = plain["d" if "d" in plain else "F"].cases
    for i, drawn in enumerate(x for case in cases for x in own.tame(case.chain, own.points + 8, fields)[:count]):
        values = dict(drawn)
        if nt.alpha in values:
            values[nt.alpha] = ALPHAS[i % len(ALPHAS)]
        if kind in ("ramp", "retract") and nt.n in values:
            values[nt.n] = POWERS[i % len(POWERS)]
        if nt.t_m in values:
            # in order, anywhere
            values[nt.t_m] = values[nt.time] / (1 + values[nt.t_m])
            values[nt.t_h] = values[nt.t_m] + (values[nt.time] - values[nt.t_m]) / (1 + values[nt.t_h])
            values[nt.t_1] = values[nt.t_m] / (1 + values[nt.v_2])
        # the distance from the present is a difference of two defined depths
        with mp.workdps(2 * digits + 30):
            here = HalfSpace(own.profile, {**values, nt.E_star: sp.S.One}, digits + 10, False)
            rows.append((values, _RESIDUALS[kind](here, plain, entry, material(law, values), values, digits)))
    law = "Ting" if nt.t_m in entry.parameters else "Lee and Radok"
    compared = f"quadrature of the convolution of {law}" + (", round trip" if entry.status == "root" else "")
    return own.judge(suffix, compared, rows, digits=digits, lost=LOST)


@lru_cache(maxsize=2)
def _elastic_entries(profile: Profile) -> Entries:
    return normal.derive(profile)


def _step(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """The depth is there at once and the elastic force relaxes with E(t)."""
    a, free_depth = here.contact(here.at(nt.a))
    depth, wanted = here.normal("d", a, free_depth), own.relaxation(here.at(nt.time)) * here.force(a, free_depth)
    known = {**values, nt.d: depth}
    if entry.status != "root":
        if free_depth is None and here.profile.compact:
            known.pop(nt.a)
        return residual(evaluate(case_at(entry, known).expr, known, digits), wanted)
    # the equation F = F_el(a) E(t)/E* at the root of g(a) = d
    known[nt.a] = root(case_at(plain["ad"], known), nt.a, known, digits, here.profile.largest)
    equation = case_at(entry, known).expr
    left, right = (evaluate(side, {**known, nt.F: wanted}, digits) for side in (equation.lhs, equation.rhs))
    return residual(right, left)


def _load(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """The elastic force at unit modulus creeps: F_el(a) = J(t) F, with J checked to be the inverse of E."""
    a, t = here.at(nt.a), here.at(nt.time)
    mismatch = abs(own.convolution(t, digits + 10) - 1)
    known = {**values, nt.F: here.force(a) / own.creep(t, digits + 10)}
    if entry.status == "root":
        found = root(case_at(entry, known), nt.a, known, digits, here.profile.largest)
    else:
        known.pop(nt.a)
        found = evaluate(case_at(entry, known).expr, known, digits)
    return max(residual(found, a), mismatch)


def _ramp(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """The convolution over the contacts up to the present, or up to t_1."""
    t = here.at(nt.time)
    until = here.at(nt.t_1) if nt.t_m in values else t
    counted = _counted if elastic_exponent(of_depth(plain)) is not None else partial(_summed, plain)
    total, speed, scatter = counted(here, t, until, own, digits)
    kept = here.profile.complete or in_radius(entry)
    known = {**{s: x for s, x in values.items() if s != nt.a or kept}, **speed}
    return max(residual(evaluate(case_at(entry, known).expr, known, digits), total), scatter)


def _counted(here: HalfSpace, t: Number, until: Number, own: Material, digits: int) -> tuple[Number, Values, Number]:
    """The convolution over the contacts up to a time, y = g(x)/g(a) from 0 and from 1; the speed; what it is off by.

    Depths and forces of a power law grow as x**n and x**(n + 1), which a smaller contact confirms.
    """
    a, impulse = here.at(nt.a), own.impulse if until == t else mp.mpf(0)
    if here.profile.complete:  # the radius is fixed: the force grows with the depth at the stiffness of the punch
        whole = _since(own, t, mp.mpf(0), until, digits) + impulse
        return here.normal("k", a, mp.mpf(1)) * here.at(nt.v) * whole, {}, mp.mpf(0)
    face = here.face(a).shape.stretches[0]
    n = a * face.slope(a) / face.height(a)
    depth, force, x = here.depth(a), here.force(a), a * mp.mpf(2) / 3
    scatter = max(
        residual(here.depth(x), depth * (x / a) ** n),
        residual(here.force(x), force * (x / a) ** (n + 1)),
    )
    rate, left = (n + 1) / n * force, t - until

    def early(y: Number) -> Number:
        return own.relaxation(t - until * y) * rate * y ** (1 / n)

    def late(z: Number) -> Number:
        return own.relaxation(left + until * z) * rate * (1 - z) ** (1 / n)

    half = mp.mpf(1) / 2
    now = complex(-left / until)
    total = integrate(early, mp.mpf(0), half, (0j, 1 - now), digits)
    total += integrate(late, mp.mpf(0), half, (now, 1 + 0j), digits, own.least) + impulse * rate / until
    return total, {nt.v: depth / until}, scatter


def _summed(
    plain: Entries, here: HalfSpace, t: Number, until: Number, own: Material, digits: int
) -> tuple[Number, Values, Number]:
    """The same for any depth and force, those of the normal contact: int E(t - g(x)/v) F_el'(x)/E* dx."""
    a, total, left = here.at(nt.a), mp.mpf(0), t - until
    depth, force = (case_at(entry, here.values).expr for entry in of_radius(plain))
    sunk = evaluated(depth, here.values)
    scatter = max(residual(sunk, here.depth(a)), residual(evaluated(force, here.values), here.force(a)))
    speed = sunk / until
    ends = [mp.mpf(0), *(b for b in map(here.at, here.profile.breaks) if b < a), a]
    for low, high in pairwise(ends[here.profile.truncated :]):
        place = {**here.values, nt.a: (low + high) / 2}
        cases = [case_at(entry, place).expr for entry in of_radius(plain)]
        g, rate = (_of_radius(expr, here.values) for expr in (cases[0], sp.diff(cases[1], nt.a)))

        def early(y: Number, low: Number = low, g: Any = g, rate: Any = rate) -> Number:
            return own.relaxation(t - g(low, y) / speed) * rate(low, y)

        def late(z: Number, high: Number = high, g: Any = g, rate: Any = rate) -> Number:
            age = left + (sunk - g(high, -z)) / speed
            # nearer to the present than a difference of depths tells
            return own.relaxation(age) * rate(high, -z) if age > 0 else mp.mpf(0)

        # the rates of truncated profiles are infinite at the face like the inverse of a root
        with mp.workdps(digits + 10):
            for part in (early, late):
                half = [0, mp.sqrt((high - low) / 2)]
                total += mp.quad(lambda s, part=part: 2 * s * part(s * s), half, maxdegree=5)
    pulled = own.impulse * 2 * a * speed if until == t else mp.mpf(0)
    return total + pulled, {nt.v: speed}, scatter


def _of_radius(expr: sp.Expr, values: Values) -> Callable[[Number, Number], Number]:
    """A formula of the normal contact at a distance from a radius, with digits for differences."""
    others, precision = {s: x for s, x in values.items() if s != nt.a}, 2 * mp.mp.dps
    of_radius = of_one_variable(expr, nt.a, others)

    def at(start: Number, distance: Number) -> Number:
        with mp.workdps(precision):
            return of_radius(start + distance)

    return at


def _since(own: Material, t: Number, start: Number, end: Number, digits: int) -> Number:
    """int E(t - s) ds from start to end, without the impulse."""
    left = t - end
    at_once = (complex(-left),)
    return integrate(lambda x: own.relaxation(left + x), mp.mpf(0), end - start, at_once, digits, own.least)


def _returned(here: HalfSpace, own: Material, start: Number, digits: int) -> Values:
    """The speed of the way back that makes the contact as large as it was at the start."""
    t, t_m = here.at(nt.time), here.at(nt.t_m)
    back = _since(own, t, here.at(nt.t_h), t, digits) + own.impulse
    return {nt.v_2: here.at(nt.v) * _since(own, t, start, t_m, digits) / back}


def _earlier(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """t_1 at the speed that belongs to it, or both sides of its equation."""
    return _met(entry, {**values, **_returned(here, own, here.at(nt.t_1), digits + 10)}, digits)


def _end(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """The present is the end where t_1 is the first touch."""
    known = {**values, nt.t_c: values[nt.time], **_returned(here, own, mp.mpf(0), digits + 10)}
    return _met(entry, known, digits)


def _met(entry: Entry, known: Values, digits: int) -> Number:
    expr = case_at(entry, known).expr
    if entry.status != "root":
        return residual(evaluate(expr, known, digits), number(known[entry.quantity.symbol]))
    return residual(*(evaluate(side, known, digits) for side in (expr.lhs, expr.rhs)))


def _radius(here: HalfSpace, plain: Entries, entry: Entry, own: Material, values: Values, digits: int) -> Number:
    """The radius that the depth v t_1 went with."""
    a = here.at(nt.a)
    known = {**values, nt.v: here.depth(a) / here.at(nt.t_1)}
    if entry.status == "root":
        return residual(root(case_at(entry, known), nt.a, known, digits, here.profile.largest), a)
    known.pop(nt.a)
    return residual(evaluate(case_at(entry, known).expr, known, digits), a)


_RESIDUALS: dict[str, Callable[[HalfSpace, Entries, Entry, Material, Values, int], Number]] = {
    "ramp": _ramp, "step": _step, "load": _load,
    "earlier": _earlier, "end": _end, "radius": _radius, "retract": _ramp,
}  # fmt: skip
