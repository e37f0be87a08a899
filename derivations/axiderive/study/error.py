"""Error against run time of p(r), w(r), F(d) and a(d): the emitted function beside every other way, at every setting.

Each method runs in turn with the emitted function, repeated; only the median
of the ratios of their processor times per point is kept, because times belong
to a machine.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass, replace
from functools import cache, cached_property, partial
from importlib import import_module
from typing import Any
from unittest.mock import patch

import mpmath as mp
import numpy as np
import sympy as sp

from .. import notation as nt
from ..build.pool import Jobs, run
from ..oracle.half_space import HalfSpace
from ..oracle.plane import defined as plane_defined
from . import rivals
from .naive import naive, per_point, printed
from .report import Record, paired, relative, rounded, seconds, summary, table, versions
from .subject import EVERY, FURTHER, NAMES, PARAMETERS, RADIUS, RULED, Array, Subject, named, subject

DIGITS = 30
KNOWN = tuple(EVERY)
NOTE = (
    "ratio: median over interleaved repeats in one run of (processor time per point of the method)/(of the emitted "
    "function, over settings.vector points, or as many as settings.longest, in s, allows), "
    "two digits; no times are kept, they differ from machine to machine and so, less, do the ratios. "
    "Graded and plane contacts of the pages of the profiles have the settings of settings.brief. "
    "Errors are relative to the defining integral at the doubles given, at `points` points. "
    "Rivals are given f', g and g' in closed form, from break to break. Grid methods are compared at their nodes next "
    "to the points."
)


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
        start = rivals.radius(subject, argument)
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


DEFINED = {"p": "pressure", "w": "displacement", "Fd": "force", "ad": "radius"}
"""What the rivals call a quantity."""


def brief(subject: Subject) -> bool:
    """Whether it is one of the many graded and plane contacts that only their own pages show."""
    return subject.few and (subject.graded or subject.plane)


def methods(subject: Subject, suffix: str, plan: Plan) -> Iterator[Method]:
    """The emitted function first, then the others."""
    setup = _Setup(subject, suffix, replace(plan, **plan.brief) if brief(subject) else plan)
    yield from setup.own()
    yield from setup.rules()
    yield from setup.scripts()
    if not (subject.graded or subject.plane):
        yield from setup.grids()


class _Setup:
    """The points of one quantity, and the methods made from functions over them."""

    def __init__(self, subject: Subject, suffix: str, plan: Plan) -> None:
        self.subject, self.suffix, self.plan = subject, suffix, plan
        self.points = arguments(subject, suffix, plan.samples)
        self.many = np.resize(self.points, max(plan.vector, plan.samples))
        self.slow = self.points[:: max(1, plan.samples // plan.slow)][: plan.slow]
        self.field = suffix in ("p", "w")

    def over(self, name: str, setting: str, function: Callable[..., Any], x: Array) -> Method:
        """A method that takes any arguments."""
        distinct = min(len(x), len(self.points))
        return Method(name, setting, partial(function, x), x[:distinct], np.arange(distinct), len(x))

    def sized(self, name: str, function: Callable[..., Any], counts: tuple[int, ...], x: Array) -> Iterator[Method]:
        """A method at several numbers of nodes."""
        for count in counts:
            yield self.over(name, f"N = {count}", partial(function, self.subject, count=count), x)

    def gridded(
        self, name: str, function: Callable[..., Any], counts: tuple[int, ...], setting: str = "N = {0}"
    ) -> Iterator[Method]:
        """A method at several numbers of nodes, with radii of its own: those next to the points are compared."""
        for count in counts:
            run = partial(function, self.subject, count=count)
            nodes, _ = run()
            pick = np.unique(np.abs(nodes[:, None] - self.points).argmin(axis=0))
            yield Method(name, setting.format(count), partial(_second, run), nodes[pick], pick, len(nodes))

    def affordable(self, function: Callable[[Array], Any]) -> Array:
        """The many points, or as many as take the longest time of a call."""
        function(self.points[:1])  # what it is given is made at the first call
        count = len(self.points)
        while count < len(self.many) and seconds(partial(function, self.many[:count])) < self.plan.longest / 4:
            count *= 4
        return self.many[:count]

    @cached_property
    def emitted(self) -> Callable[[Array], Any]:
        """The function of the catalogue, of what is varied."""
        return partial(_at_values, self.subject.emitted(self.suffix), self.subject.parameters, self.varied)

    @property
    def varied(self) -> Any:
        """The place of a field, else the depth."""
        return self.subject.across if self.field else nt.d

    @cached_property
    def most(self) -> Array:
        """The points of the functions of the catalogue."""
        return self.affordable(self.emitted)

    def own(self) -> Iterator[Method]:
        """The emitted function, and where the formula is printed in closed form also its `lambdify`."""
        yield self.over("emitted", "", self.emitted, self.most)
        entry = self.subject.printed(self.suffix)
        if printed(entry):
            values = naive(entry, self.subject.entries)
            function = partial(_at_values, values, self.subject.values, self.varied)
            yield self.over("lambdify", "", function, self.points if per_point(entry) else self.most)

    def rules(self) -> Iterator[Method]:
        """The rule of the catalogue, where it has one, and that of Gauss and Jacobi for the definition."""
        if self.suffix in RULED.get(self.subject.name, ()):
            for count in self.plan.rule:
                run = partial(with_nodes, self.emitted, count=count)
                yield self.over("generated rule", f"N = {count}", run, self.most)
        function = getattr(rivals, f"jacobi_{DEFINED[self.suffix]}", None)
        if function:
            dearest = partial(function, self.subject, count=self.plan.jacobi[-1])
            x = self.affordable(dearest) if self.field else self.points
            yield from self.sized("Gauss-Jacobi", function, self.plan.jacobi, x)

    def scripts(self) -> Iterator[Method]:
        """Adaptive quadrature in double precision, and where not both are left out for a page, in many digits."""
        subject, defined = self.subject, DEFINED[self.suffix]
        quad = rivals.Script(subject)
        if self.field:
            yield self.over("quad", "", getattr(quad, defined), self.points)
        else:
            yield self.over("quad and root", "", getattr(quad, defined), self.slow)
        ways = [("", False), (", substituted", True)] if self.suffix == "p" and not subject.few else [("", False)]
        if ways[1:]:
            yield self.over("quad, substituted", "", replace(quad, substituted=True).pressure, self.points)
        for name, substituted in ways if brief(subject) or not subject.few else ():
            for digits in self.plan.digits:
                script = rivals.Digits(subject, substituted, digits)
                yield self.over(f"mpmath{name}", f"{digits} digits", getattr(script, defined), self.slow)

    def grids(self) -> Iterator[Method]:
        """Tables and grids of the homogeneous half-space."""
        plan, wide = self.plan, self.subject.name in NAMES
        match self.suffix:
            case "p":
                yield from self.gridded("trapezoid MDR", rivals.trapezoid_pressure, plan.trapezoid)
            case "w":
                yield from self.sized("trapezoid MDR", rivals.trapezoid_displacement, plan.trapezoid, self.points)
            case "Fd":
                yield from self.sized("trapezoid MDR", rivals.trapezoid_force, plan.table, self.many)
            case _:
                yield from self.sized("table", rivals.table_radius, plan.table, self.many)
        if wide and self.field:
            function = rivals.fft_pressure if self.suffix == "p" else rivals.fft_displacement
            yield from self.gridded("FFT MDR", function, plan.fft)
        if wide and self.suffix == "p" and not rivals.no_boundary_elements():
            force = float(defined(self.subject, RADIUS)("F"))
            yield from self.gridded("BEM", partial(rivals.boundary_elements, force=force), plan.bem, "{0} x {0}")


def with_nodes(function: Callable[[Array], Array], x: Array, count: int) -> Array:
    """A function of the catalogue, every rule of it in one interval of `count` nodes, at each point by itself."""
    integrals, weights = (import_module(f"axicontact._runtime.{name}") for name in ("integrals", "graded.rules"))
    whole, weighted = integrals.integral, weights.weighted

    def fixed(integrand: Callable[[Array], Array], stop: Array, _: int) -> Array:
        return whole(integrand, stop, count)

    def fixed_weighted(
        smooth: Callable[[Array], Array], stop: Array, power: Array, _: int = 0, above: Array | None = None
    ) -> Array:
        return weighted(smooth, stop, power, count, above)

    changes = {"integral": (whole, fixed), "weighted": (weighted, fixed_weighted)}
    with ExitStack() as changed:
        for module in [module for key, module in sys.modules.items() if key.startswith("axicontact.")]:
            for name, (before, after) in changes.items():
                if getattr(module, name, None) is before:
                    changed.enter_context(patch.object(module, name, after))
        for name in ("FEW", "LEAST"):  # from these numbers of points on they would be put in groups, and interpolated
            changed.enter_context(patch.object(integrals, name, math.inf))
        return function(x)


def _second(function: Callable[[], tuple[Array, Array]]) -> Array:
    return function()[1]


def _at_values(function: Callable[..., Any], values: dict[Any, Any], symbol: Any, x: Array) -> Any:
    return function({**values, symbol: x})


def skipped(subject: Subject, suffix: str) -> list[dict[str, str]]:
    """What has nothing to run for a quantity, with the reason; of a problem beside few ways, among these."""
    found = {}
    if not printed(subject.printed(suffix)):
        found["lambdify"] = "no closed form in standard functions was found"
    if not subject.few:
        if suffix not in RULED.get(subject.name, ()):
            found["generated rule"] = "the function is closed: no rule is generated"
        if subject.graded:
            found |= dict.fromkeys(("trapezoid MDR", "FFT MDR", "BEM"), "its half-space is homogeneous")
        else:
            if suffix not in ("p", "w"):
                found["FFT MDR"] = "a convolution gives fields"
            if suffix != "p" or rivals.no_boundary_elements():
                found["BEM"] = rivals.no_boundary_elements() if suffix == "p" else "its pressures are compared"
    return [{"key": f"{subject.name}.{suffix}", "method": name, "reason": reason} for name, reason in found.items()]


def measure(names: Sequence[str] = KNOWN, *, quick: bool = False, jobs: Jobs = 1) -> Record:
    """The record of the study."""
    plan = QUICK if quick else Plan()
    rows: list[Record] = []
    missing: list[dict[str, str]] = []
    tasks = [(name, suffix, plan) for name in names for suffix in EVERY[name]]
    for found, left_out in run(_quantity, tasks, jobs, ordered=True):
        rows += found
        missing += left_out
    parameters = named(PARAMETERS) | {"a": RADIUS}
    own = {name: FURTHER.get(subject(name).problem.name) for name in names}
    parameters |= {name: named(values) for name, values in own.items() if values}
    return {
        "study": "error",
        "note": NOTE,
        "settings": {
            **_plain(asdict(plan)),
            "brief": _plain(plan.brief),
            "reference_digits": DIGITS,
            "parameters": parameters,
            "versions": versions(),
        },
        "rows": rows,
        "skipped": missing,
    }


def _quantity(name: str, suffix: str, plan: Plan) -> tuple[list[Record], list[dict[str, str]]]:
    """The rows of one quantity, and what is left out of them."""
    return list(_rows(subject(name), suffix, plan)), skipped(subject(name), suffix)


def _plain(settings: Mapping[str, Any]) -> Record:
    return {name: list(value) if isinstance(value, tuple) else value for name, value in settings.items()}


def _rows(subject: Subject, suffix: str, plan: Plan) -> Iterator[Record]:
    own: Method | None = None
    for method in methods(subject, suffix, plan):
        own = own or method
        ratio = paired(method.run, own.run, plan.rounds) * own.count / method.count
        told = {"key": f"{subject.name}.{suffix}", "method": method.name, "setting": method.setting}
        yield told | {"ratio": rounded(ratio)} | summary(errors(subject, suffix, method))


def errors(subject: Subject, suffix: str, method: Method) -> list[float]:
    """Relative errors at the arguments of the method."""
    values = method.run()
    pairs = zip(method.pick, method.at, strict=True)
    return [relative(values[i], exact(subject, suffix, float(x))) for i, x in pairs]


def text(record: Record) -> str:
    """One line per method and setting."""
    columns = ("key", "method", "setting", "ratio", "worst", "median", "lost")
    rows = [[row[column] for column in columns] for row in record["rows"]]
    notes = sorted({f"{row['method']}: {row['reason']}" for row in record["skipped"]})
    return "\n".join([table(columns, rows), *(f"skipped  {note}" for note in notes)])
