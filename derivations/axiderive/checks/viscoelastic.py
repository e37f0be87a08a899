"""Growing contact with a viscoelastic half-space: the integral of Lee and Radok by quadrature.

The elastic force is the defined one, as a function of the contact radius; the
ramp is an integral over the radii of the earlier contacts, without an inverse:
F = int E(t - g(x)/v) F_el'(x)/E* dx.  Relaxation and creep are stated here once
more, and belong together because their convolution is a unit step.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluate
from ..oracle.half_space import HalfSpace
from ..oracle.rules import integrate
from ..oracle.shape import Number, Values, number
from ..physics import normal
from ..profiles.profile import Profile
from .comparison import Comparison, Entries, Evidence, Rows, residual, root

LOST = 8
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
    """Ramp, step of depth or step of load against the convolution."""
    entry, (kind, law) = own.entries[suffix], suffix.split("_")
    rows: Rows = []
    plain = _elastic_entries(own.profile)
    fields = (*entry.parameters, nt.time, *own.profile.free_depth)
    cases = plain["d" if "d" in plain else "F"].cases
    for i, drawn in enumerate(x for case in cases for x in own.tame(case.chain, own.points + 8, fields)[: own.points]):
        values = dict(drawn)
        if nt.alpha in values:
            values[nt.alpha] = ALPHAS[i % len(ALPHAS)]
        if kind == "ramp" and nt.n in values:
            values[nt.n] = POWERS[i % len(POWERS)]
        # the distance from the present is a difference of two defined depths
        with mp.workdps(2 * own.digits + 30):
            here = HalfSpace(own.profile, {**values, nt.E_star: sp.S.One}, own.digits + 10, False)
            rows.append((values, _RESIDUALS[kind](here, plain, entry, material(law, values), values, own.digits)))
    compared = "quadrature of the convolution of Lee and Radok" + (", round trip" if entry.status == "root" else "")
    return own.judge(suffix, compared, rows, lost=LOST)


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
    """The convolution over the earlier contacts of a power law, y = g(x)/g(a) from 0 and from 1.

    Their depths and forces grow as x**n and x**(n + 1), which a smaller contact confirms.
    """
    a, t = here.at(nt.a), here.at(nt.time)
    if here.profile.complete:  # the radius is fixed: the force grows with the depth at the stiffness of the punch
        stiffness = here.normal("k", a, mp.mpf(1))
        whole = integrate(own.relaxation, mp.mpf(0), t, (0j,), digits) + own.impulse
        got = evaluate(case_at(entry, values).expr, values, digits)
        return residual(got, stiffness * here.at(nt.v) * whole)
    face = here.face(a).shape.stretches[0]
    n = a * face.slope(a) / face.height(a)
    depth, force, x = here.depth(a), here.force(a), a * mp.mpf(2) / 3
    scatter = max(
        residual(here.depth(x), depth * (x / a) ** n),
        residual(here.force(x), force * (x / a) ** (n + 1)),
    )
    rate = (n + 1) / n * force

    def early(y: Number) -> Number:
        return own.relaxation(t * (1 - y)) * rate * y ** (1 / n)

    def late(z: Number) -> Number:
        return own.relaxation(t * z) * rate * (1 - z) ** (1 / n)

    half = mp.mpf(1) / 2
    total = integrate(early, mp.mpf(0), half, (0j, 1 + 0j), digits)
    total += integrate(late, mp.mpf(0), half, (0j, 1 + 0j), digits, own.least) + own.impulse * rate / t
    known = {s: x for s, x in values.items() if s != nt.a} | {nt.v: depth / t}
    return max(residual(evaluate(case_at(entry, known).expr, known, digits), total), scatter)


_RESIDUALS: dict[str, Callable[[HalfSpace, Entries, Entry, Material, Values, int], Number]] = {
    "ramp": _ramp, "step": _step, "load": _load,
}  # fmt: skip
