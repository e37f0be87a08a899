"""Every way to p(r), w(r) and F(d) at every setting.

Arguments at which the methods are compared, and the defining integral there.

Every way to p(r), w(r) and F(d) at every setting, as the study of error against run time runs it.

Methods that have nothing to run for a quantity, with the reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..oracle.half_space import HalfSpace
from ..oracle.plane import defined as plane_defined
from . import graded, grids, rivals, rule
from .naive import naive, per_point, printed
from .problems import RADIUS, RULED
from .subject import Array, Subject, emitted
from .timing import seconds

DIGITS = 30


def arguments(subject: Subject, suffix: str, count: int) -> Array:
    """Radii in the contact, radii up to 2a outside, or depths of contacts up to a; with adhesion from a/2 on."""
    steps = (np.arange(count) + 0.5) / count
    match suffix:
        case "p":
            return RADIUS * steps
        case "w":
            return RADIUS * (1 + steps)
        case _:
            smallest = RADIUS / 2 if suffix == "ad" else subject.edge
            radii = smallest + (RADIUS - smallest) * steps
            with mp.workdps(DIGITS + 20):
                return np.array([float(defined(subject, float(x))("d")) for x in radii])


@cache
def defined(subject: Subject, radius: float, r: float | None = None) -> Callable[[str], mp.mpf]:
    """The quantities of the contact of that radius, as the integrals of the definition see it."""
    values = _values(subject, radius) | ({} if r is None else {subject.across: sp.Rational(r)})
    with mp.workdps(DIGITS + 20):
        if subject.plane:
            return lambda suffix: plane_defined(subject.profile, suffix, values, DIGITS)
        here = _half_space(subject, values)
        if nt.dgamma in values:
            return partial(here.adhesive, a=mp.mpf(radius))
        reached, depth = here.contact(mp.mpf(radius))
        return partial(here.normal, a=reached, free_depth=depth)


def _half_space(subject: Subject, values: dict[Any, Any]) -> HalfSpace:
    return HalfSpace(subject.profile, values, DIGITS, subject.graded)


def _values(subject: Subject, radius: float) -> dict[Any, Any]:
    values = {symbol: sp.Rational(value) for symbol, value in subject.values.items()} | {nt.a: sp.Rational(radius)}
    return values | {symbol: expr.subs(values) for symbol, expr in subject.profile.abbreviations}


@cache
def exact(subject: Subject, suffix: str, argument: float) -> mp.mpf:
    """The defining integral at the double that the methods are given."""
    with mp.workdps(DIGITS + 20):
        if suffix in ("p", "w"):
            return defined(subject, RADIUS, argument)(suffix)
        start = rivals.radius(subject, lambda x: float(subject.depth(np.float64(x))) - argument)
        radius, here = mp.mpf(start), defined(subject, start)
        # the depth of that radius misses the argument by its rounding
        missed = mp.mpf(argument) - here("d")
        if suffix == "ad":
            return radius + missed / _rate(subject, start)
        # dF/dd is the stiffness of a flat punch, (11.18)
        k = mp.mpf(subject.exponent)
        return here("F") + 2 * subject.modulus * radius ** (1 + k) / (1 + k) * missed


def _rate(subject: Subject, radius: float) -> mp.mpf:
    """dd/da of an adhesive contact, whose retraction grows as a**((1 - k)/2)."""
    here = _half_space(subject, _values(subject, radius))
    rate, _ = here.rates(mp.mpf(radius))
    return rate - here.retraction(mp.mpf(radius)) * (1 - here.k) / (2 * mp.mpf(radius))


@dataclass(frozen=True)
class Plan:
    """How much is measured: points, repeats and settings."""

    samples: int = 24
    """Points at which errors are taken."""
    vector: int = 10_000
    """Points of one call of an array function."""
    slow: int = 4
    """Points of a script."""
    rounds: int = 7
    rule: tuple[int, ...] = (8, 16, 32, 64)
    jacobi: tuple[int, ...] = (16, 64, 256)
    trapezoid: tuple[int, ...] = (100, 400, 1600)
    table: tuple[int, ...] = (100, 1000, 100_000)
    fft: tuple[int, ...] = (1000, 10_000, 100_000)
    digits: tuple[int, ...] = (15, 30, 50)
    bem: tuple[int, ...] = (64, 128, 256)
    longest: float = 1.0
    """Seconds of one call of an array function, which rather has fewer points."""

    @property
    def brief(self) -> dict[str, Any]:
        """What changes where there are many contacts, the graded and the plane ones."""
        samples, digits = max(4, self.samples // 2), self.digits[:2]
        return {"samples": samples, "slow": 2, "digits": digits, "longest": self.longest / 50}


QUICK = Plan(4, 200, 2, 1, rule=(32,), jacobi=(16,), trapezoid=(100,), table=(100,), fft=(1000,), digits=(15,), bem=())


@dataclass(frozen=True)
class Method:
    """One way at one setting: `run` gives its values, of which `pick` belong to the arguments `at`."""

    name: str
    setting: str
    run: Callable[[], Any]
    at: Array
    pick: Array
    count: int
    """Points that a run computes."""


def methods(subject: Subject, suffix: str, plan: Plan) -> Iterator[Method]:
    """The emitted function first, then the others."""
    setup = _Setup(subject, suffix, replace(plan, **plan.brief) if subject.brief else plan)
    yield from setup.closed()
    if subject.few:
        yield from _few(setup)
        return
    if subject.graded:
        yield from _graded(setup)
        return
    match suffix:
        case "ad":
            yield from _adhesive(setup)
        case "p":
            yield from _pressure(setup)
        case "w":
            yield from _displacement(setup)
        case _:
            yield from _force(setup)


class _Setup:
    """The points of one quantity, and the methods made from functions over them."""

    def __init__(self, subject: Subject, suffix: str, plan: Plan) -> None:
        self.subject, self.suffix, self.plan = subject, suffix, plan
        self.points = arguments(subject, suffix, plan.samples)
        self.many = np.resize(self.points, max(plan.vector, plan.samples))
        self.few = self.points[:: max(1, plan.samples // plan.slow)][: plan.slow]

    def over(self, name: str, setting: str, function: Callable[..., Any], x: Array) -> Method:
        """A method that takes any arguments."""
        distinct = min(len(x), len(self.points))
        return Method(name, setting, partial(function, x), x[:distinct], np.arange(distinct), len(x))

    def on_grid(self, name: str, setting: str, function: Callable[[], tuple[Array, Array]]) -> Method:
        """A method with radii of its own: those next to the points are compared."""
        nodes, _ = function()
        pick = np.unique(np.abs(nodes[:, None] - self.points).argmin(axis=0))
        return Method(name, setting, lambda: function()[1], nodes[pick], pick, len(nodes))

    def sized(self, name: str, function: Callable[..., Any], counts: tuple[int, ...], x: Array) -> Iterator[Method]:
        """A method at several numbers of nodes."""
        for count in counts:
            yield self.over(name, f"N = {count}", partial(_with_count, function, self.subject, count), x)

    def affordable(self, function: Callable[[Array], Any]) -> Array:
        """The many points, or as many as take the longest time of a call."""
        function(self.points[:1])  # what it is given is made at the first call
        count = len(self.points)
        while count < len(self.many) and seconds(partial(function, self.many[:count])) < self.plan.longest / 4:
            count *= 4
        return self.many[:count]

    @cached_property
    def own(self) -> Array:
        """The points of the functions of the catalogue."""
        return self.affordable(self._emitted)

    def gridded(self, name: str, function: Callable[..., Any], counts: tuple[int, ...]) -> Iterator[Method]:
        """One method for every number of nodes, with radii of its own."""
        for count in counts:
            yield self.on_grid(name, f"N = {count}", partial(function, self.subject, count))

    def closed(self) -> Iterator[Method]:
        """The emitted function, and where the formula is printed in closed form also its `lambdify`."""
        entry = self.subject.printed(self.suffix)
        yield self.over("emitted", "", self._emitted, self.own)
        if printed(entry):
            x = self.points if per_point(entry) else self.own
            values = naive(entry, self.subject.entries)
            yield self.over("lambdify", "", partial(_at_values, values, self.subject.values, self._symbol), x)

    @property
    def _symbol(self) -> Any:
        return self.subject.across if self.suffix in ("p", "w") else nt.d

    @property
    def _emitted(self) -> Callable[[Array], Any]:
        function = emitted(self.subject.entries[self.suffix], self.subject.name)
        return partial(_at_values, function, self.subject.parameters, self._symbol)

    def rule(self, function: Callable[..., Any] | None = None) -> Iterator[Method]:
        """The rule of the catalogue, or, where that has a closed form, the one that it would have."""
        if self.suffix not in RULED.get(self.subject.name, ()):
            yield from self.sized("generated rule", function, self.plan.rule, self.many) if function else ()
            return
        for count in self.plan.rule:
            run = partial(rule.with_nodes, self._emitted, count=count)
            yield self.over("generated rule", f"N = {count}", run, self.own)

    def digits(self, function: Callable[..., Any], name: str = "mpmath") -> Iterator[Method]:
        """One method for every number of digits, at few points because each takes long."""
        for digits in self.plan.digits:
            run = partial(_with_count, function, self.subject, digits)
            yield self.over(name, f"{digits} digits", run, self.few)


def _with_count(function: Callable[..., Any], subject: Subject, count: int, x: Array) -> Any:
    return function(subject, x, count)


def _at_values(function: Callable[..., Any], values: dict[Any, Any], symbol: Any, x: Array) -> Any:
    return function({**values, symbol: x})


def _pressure(setup: _Setup) -> Iterator[Method]:
    subject, plan = setup.subject, setup.plan
    yield from setup.rule(rule.pressure)
    yield from setup.sized("Gauss-Jacobi", rivals.jacobi_pressure, plan.jacobi, setup.many)
    for suffix, substituted in (("", False), (", substituted", True)):
        quad = partial(rivals.quad_pressure, subject, substituted=substituted)
        yield setup.over(f"quad{suffix}", "", quad, setup.points)
        yield from setup.digits(partial(rivals.mpmath_pressure, substituted=substituted), f"mpmath{suffix}")
    yield from setup.gridded("trapezoid MDR", grids.trapezoid_pressure, plan.trapezoid)
    yield from setup.gridded("FFT MDR", grids.fft_pressure, plan.fft)
    if not grids.no_boundary_elements():
        force = float(defined(subject, RADIUS)("F"))
        for count in plan.bem:
            yield setup.on_grid("BEM", f"{count} x {count}", partial(grids.boundary_elements, subject, force, count))


def _displacement(setup: _Setup) -> Iterator[Method]:
    subject, plan = setup.subject, setup.plan
    yield from setup.rule(rule.displacement)
    yield from setup.sized("Gauss-Jacobi", rivals.jacobi_displacement, plan.jacobi, setup.many)
    yield setup.over("quad", "", partial(rivals.quad_displacement, subject), setup.points)
    yield from setup.sized("trapezoid MDR", grids.trapezoid_displacement, plan.trapezoid, setup.points)
    yield from setup.gridded("FFT MDR", grids.fft_displacement, plan.fft)
    yield from setup.digits(rivals.mpmath_displacement)


def _force(setup: _Setup) -> Iterator[Method]:
    subject, plan = setup.subject, setup.plan
    yield from setup.sized("Gauss-Jacobi", rivals.jacobi_force, plan.jacobi, setup.points)
    yield setup.over("quad and root", "", partial(rivals.quad_force, subject), setup.few)
    yield from setup.sized("trapezoid MDR", grids.trapezoid_force, plan.table, setup.many)
    yield from setup.digits(rivals.mpmath_force)


def _few(setup: _Setup) -> Iterator[Method]:
    """What the page of a profile shows beside its own functions: one way of each kind."""
    subject, plan = setup.subject, setup.plan
    yield from setup.rule()
    match setup.suffix:
        case "w" if subject.graded:
            many = setup.affordable(partial(graded.jacobi_displacement, subject, count=plan.jacobi[-1]))
            yield from setup.sized("Gauss-Jacobi", graded.jacobi_displacement, plan.jacobi, many)
            yield setup.over("quad", "", partial(graded.quad_displacement, subject, weighted=False), setup.points)
            yield from setup.digits(graded.mpmath_displacement)
        case "p":
            many = setup.affordable(partial(rivals.jacobi_pressure, subject, count=plan.jacobi[-1]))
            yield from setup.sized("Gauss-Jacobi", rivals.jacobi_pressure, plan.jacobi, many)
            yield setup.over("quad", "", partial(rivals.quad_pressure, subject, substituted=False), setup.points)
            if subject.brief:
                yield from setup.digits(graded.mpmath_pressure)
            else:
                yield from setup.gridded("trapezoid MDR", grids.trapezoid_pressure, plan.trapezoid)
        case "w":
            yield from setup.sized("Gauss-Jacobi", rivals.jacobi_displacement, plan.jacobi, setup.many)
            yield setup.over("quad", "", partial(rivals.quad_displacement, subject), setup.points)
            yield from setup.sized("trapezoid MDR", grids.trapezoid_displacement, plan.trapezoid, setup.points)
        case _:
            yield from setup.sized("Gauss-Jacobi", rivals.jacobi_force, plan.jacobi, setup.points)
            yield setup.over("quad and root", "", partial(rivals.quad_force, subject), setup.few)
            yield from setup.sized("trapezoid MDR", grids.trapezoid_force, plan.table, setup.many)


def _adhesive(setup: _Setup) -> Iterator[Method]:
    subject, plan = setup.subject, setup.plan
    yield setup.over("quad and root", "", partial(rivals.quad_radius, subject), setup.few)
    yield from setup.sized("table", rivals.table_radius, plan.table, setup.many)
    yield from setup.digits(rivals.mpmath_radius)


def _graded(setup: _Setup) -> Iterator[Method]:
    subject, plan, few = setup.subject, setup.plan, setup.few
    if setup.suffix == "Fd":
        yield from setup.sized("Gauss-Jacobi", graded.jacobi_force, plan.jacobi, setup.points)
        yield setup.over("quad and root", "", partial(graded.quad_force, subject), few)
        yield from setup.digits(graded.mpmath_force)
        return
    yield from setup.rule()
    if setup.suffix == "p":
        yield from setup.sized("Gauss-Jacobi", rivals.jacobi_pressure, plan.jacobi, setup.many)
        yield setup.over("quad", "", partial(rivals.quad_pressure, subject, substituted=False), setup.points)
        yield setup.over("quad, weighted", "", partial(graded.quad_weighted_pressure, subject), setup.points)
        yield from setup.digits(graded.mpmath_pressure)
        return
    yield from setup.sized("Gauss-Jacobi", graded.jacobi_displacement, plan.jacobi, setup.many)
    for suffix, weighted in (("", False), (", weighted", True)):
        quad = partial(graded.quad_displacement, subject, weighted=weighted)
        yield setup.over(f"quad{suffix}", "", quad, setup.points)
    yield from setup.digits(graded.mpmath_displacement)


def skipped(subject: Subject, suffix: str) -> list[dict[str, str]]:
    """One record for each; of a problem that is measured beside a few ways, among these."""
    reasons = (
        _of_few(subject, suffix) if subject.few else _on_grids(subject, suffix) | _boundary_elements(subject, suffix)
    )
    key = f"{subject.name}.{suffix}"
    return [{"key": key, "method": method, "reason": reason} for method, reason in reasons.items()]


def _of_few(subject: Subject, suffix: str) -> dict[str, str]:
    if printed(subject.printed(suffix)):
        return {}
    return {"lambdify": "no closed form in standard functions was found"}


def _on_grids(subject: Subject, suffix: str) -> dict[str, str]:
    if subject.graded:
        closed = {"generated rule": "depth and force are closed: no rule is generated"} if suffix == "Fd" else {}
        return closed | dict.fromkeys(
            ("trapezoid MDR", "FFT MDR"), "their weights are those of the homogeneous half-space"
        )
    if suffix == "ad":
        return {"FFT MDR": "a convolution gives fields, not a(d)"}
    if suffix == "Fd":
        closed = {"generated rule": "depth and force are closed: no rule is generated"}
        return closed | {"FFT MDR": "a convolution gives fields, not F(d)"}
    return {}


def _boundary_elements(subject: Subject, suffix: str) -> dict[str, str]:
    if subject.graded:
        return {"BEM": "its half-space is homogeneous"}
    if suffix != "p":
        return {"BEM": "its pressures are compared"}
    return {"BEM": grids.no_boundary_elements()} if grids.no_boundary_elements() else {}
