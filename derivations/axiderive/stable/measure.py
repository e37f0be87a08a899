"""Errors of the emitted functions, in units of the last place, over the bench and the extreme domain."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import numpy as np
import sympy as sp
from flint import arb, ctx

from .. import notation as nt
from ..abel.masters import C0
from ..entry import Entry
from ..letters import name_of
from .reference import CURVES, UnknownError, of_contact, reference
from .samples import LARGEST, SMALLEST, Domain, Floats, floats


@dataclass(frozen=True)
class Sample:
    """One call of an emitted function and the exact value."""

    arguments: tuple[float, ...]
    keywords: dict[str, Any]
    exact: arb
    values: Floats
    """All numbers by symbol; for an inverse with the radius near the exact one."""


@dataclass(frozen=True)
class Errors:
    """Of one function over one domain; `lost` counts results that are no finite number though the exact one is."""

    count: int
    worst: float
    median: float
    above: int
    lost: int
    where: str = ""


def samples(entries: Mapping[str, Entry], suffix: str, domain: Domain, count: int, seed: int = 17) -> Iterator[Sample]:
    """Calls whose exact value is a normal number, or zero everywhere."""
    entry = entries[suffix]
    like = CURVES[suffix][0] if _inverse(entry) else "d" if suffix == "k" and "d" in entries else suffix
    for values in floats(entries[like], domain, count, seed, entry.parameters):
        try:
            _complete(entries, values)
            arguments, exact = reference(dict(entries), suffix, values)
        except UnknownError:
            continue
        if SMALLEST < abs(float(exact)) < LARGEST or exact == 0:
            yield Sample(*_call(entry, arguments), exact, arguments)


def value(function: Callable[..., float], point: Sample) -> float:
    try:
        return float(function(*point.arguments, **point.keywords))
    except OverflowError:
        return math.nan


def _complete(entries: Mapping[str, Entry], values: Floats) -> None:
    """Raise depth, force and load above the threshold of complete contact, a depth by its own size over the contact."""
    for suffix, symbol in (("dmin", nt.d), ("Fmin", nt.F), ("Pmin", nt.P)):
        if suffix in entries and symbol in values:
            least = float(of_contact(entries, suffix, values))
            if not SMALLEST < least < LARGEST:
                message = f"{suffix} = {least} is no normal number"
                raise UnknownError(message)
            values[symbol] = least * max(1.0 + 1e-12, values[symbol] / values[nt.a] if symbol == nt.d else 2.0)


def count_for(entry: Entry, count: int) -> int:
    """Fewer where the reference itself is an integral: a tenth."""
    return count // 10 if any(case.expr.has(sp.Integral, C0) for case in entry.cases) else count


def _inverse(entry: Entry) -> bool:
    return entry.suffix in CURVES and entry.profile.contact == "compact"


def _call(entry: Entry, values: Floats) -> tuple[tuple[float, ...], dict[str, Any]]:
    fields = _fields(entry)
    keywords = {name_of(s): values[s] for s in entry.parameters if s not in fields}
    return tuple(values[symbol] for symbol in fields), keywords


def _fields(entry: Entry) -> tuple[sp.Symbol, ...]:
    """The arguments of the emitted function; a stiffness that depends on the depth asks for it."""
    depth = entry.suffix == "k" and any(case.expr.has(nt.d) for case in entry.cases)
    return (nt.d,) if depth else entry.quantity.arguments


def function_of(entry: Entry, module: Any = None) -> Callable[..., float]:
    """The emitted function of normal contact, or that of another module; of several results the one of the entry."""
    module = module or import_module(f"axicontact.normal.{entry.profile.name}")
    function, member = getattr(module, entry.quantity.function), entry.quantity.member
    return (lambda *fields, **keywords: getattr(function(*fields, **keywords), member)) if member else function


def ulps(got: float, exact: arb) -> float:
    """Distance from the exact value in units of the last place of the exact value."""
    if not math.isfinite(got):
        return math.inf
    before, ctx.prec = ctx.prec, 256
    try:
        return float(abs(arb(got) - exact) / float(np.spacing(abs(float(exact)))))
    finally:
        ctx.prec = before


def measure(function: Callable[..., float], points: list[Sample], tolerance: float = 5.0) -> Errors:
    """The errors of a function at these points."""
    found = [ulps(value(function, s), s.exact) for s in points]
    if not found:
        return Errors(0, math.nan, math.nan, 0, 0)
    finite = [x for x in found if math.isfinite(x)]
    worst = max(range(len(found)), key=found.__getitem__)
    return Errors(
        len(found),
        max(finite, default=math.nan),
        float(np.median(found)),
        sum(x > tolerance for x in found),
        len(found) - len(finite),
        f"{points[worst].arguments} {points[worst].keywords} {found[worst]:.3g}",
    )


def main(arguments: list[str]) -> None:
    """`python -m axiderive.stable.measure COUNT [NAME ...]`: the table of all entries."""
    from ..contact.normal import derive
    from ..profiles import NAMES, load
    from .samples import DOMAINS

    for name in arguments[1:] or NAMES:
        entries = derive(load(name))
        for suffix, entry in entries.items():
            for domain in DOMAINS:
                points = list(samples(entries, suffix, domain, count_for(entry, int(arguments[0]))))
                errors = measure(function_of(entry), points)
                print(
                    f"{entry.key:26s} {domain.name:8s} {errors.count:5d} worst {errors.worst:9.3g} "
                    f"median {errors.median:6.2g} above {errors.above:4d} lost {errors.lost:4d}  {errors.where}",
                    flush=True,
                )


if __name__ == "__main__":
    main(sys.argv[1:])
