"""Every emitted function against Arb, in units of the last place, on a bench domain and at the ends of the range.

The points are drawn anew from a fixed seed; with `-m slow` there are 1e5 others.
The bounds are the worst errors found on those, rounded up.
"""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable
from importlib import import_module
from typing import Any

import numpy as np
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.contact.normal import derive
from axiderive.entry import Entry
from axiderive.profiles import NAMES, load
from axiderive.stable.measure import Sample, count_for, function_of, samples, ulps
from axiderive.stable.samples import BENCH, DOMAINS, EXTREME, Domain

POINTS, MANY = 8, 250
CLOSED, RULE = 8.0, 40.0
AMPLIFIED = 60.0
"""Inverses of A r**n per 1/n: the rounding of the argument of the root is raised to the power 1/n."""
SELDOM = {"concave_quartic.p": 1e3}
"""At a depth within 1e-12 of the least one, where the rounding of the least depth counts."""
STATIONARY = ("gaussian.ad", "gaussian.aF", "gaussian.Fd", "gaussian.dF")
"""Next to the largest contact the depth is stationary and its inverse without meaning to a double."""
UNDEFINED = {"concave_power"}
"""The threshold of complete contact is itself a root; without it no sample lies above it for certain."""


def bound(entry: Entry, point: Sample) -> float:
    if entry.profile.name == "power_law" and entry.suffix in ("ad", "aF", "Fd", "dF"):
        return CLOSED + AMPLIFIED * max(1.0, 1.0 / point.keywords["n"])
    if entry.key in SELDOM:
        return SELDOM[entry.key]
    module = import_module(f"axicontact.normal.{entry.profile.name}")
    body = getattr(module, f"_{entry.quantity.function}")
    return RULE if "_integral" in inspect.getsource(body) else CLOSED


def failures(entry: Entry, function: Callable[..., float], points: list[Sample]) -> list[str]:
    rows = []
    for point in points:
        error = ulps(float(function(*point.arguments, **point.keywords)), point.exact)
        if not error <= bound(entry, point):
            rows.append(f"{entry.key}{point.arguments} {point.keywords}: {error:.3g} ulp")
    return rows


def check(name: str, count: int, seed: int) -> None:
    entries, rows, found = derive(load(name)), [], 0
    for suffix, entry in entries.items():
        if suffix == "rz" or entry.key in STATIONARY:
            continue
        for domain in DOMAINS:
            points = list(samples(entries, suffix, domain, max(1, count_for(entry, count)), seed))
            found += len(points)
            rows += failures(entry, function_of(entry), points)
    assert found >= len(entries) * count // 2, f"only {found} points"
    assert not rows, "\n".join(rows)


@pytest.mark.parametrize("name", [name for name in NAMES if name not in UNDEFINED])
def test_fixed_sample(name: str) -> None:
    check(name, POINTS, seed=17)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in NAMES if name not in UNDEFINED])
def test_fresh_points(name: str) -> None:
    check(name, MANY, seed=2026)


def naive(entry: Entry) -> Callable[..., float]:
    """What `lambdify` makes of the printed formula."""
    symbols = [*entry.quantity.arguments, *(p for p in entry.profile.parameters), nt.E_star]
    function = sp.lambdify(symbols, entry.cases[0].expr, "numpy")

    def call(*fields: float, **keywords: Any) -> float:
        given = {"E_star": 1.0, **keywords}
        with np.errstate(all="ignore"):
            return float(
                function(*map(np.float64, fields), *(np.float64(given[str(s)]) for s in symbols[len(fields) :]))
            )

    return call


@pytest.mark.parametrize(
    ("name", "suffix"), [("cone", "w"), ("paraboloid", "w"), ("sphere", "F"), ("rounded_punch", "d")]
)
@pytest.mark.parametrize("domain", DOMAINS, ids=lambda domain: domain.name)
def test_the_printed_form_fails(name: str, suffix: str, domain: Domain) -> None:
    """The bounds would mean nothing if the formula as it is printed kept them."""
    entries = derive(load(name))
    points = list(samples(entries, suffix, domain, 40))
    rows = failures(entries[suffix], naive(entries[suffix]), points)
    assert len(rows) > len(points) // 4


def test_samples_reach_the_ends() -> None:
    entries = derive(load("rounded_punch"))
    for domain, small, close in ((BENCH, 1e-4, 1e-4), (EXTREME, 1e-100, 1e-12)):
        ratios = [s.keywords["b"] / s.arguments[0] for s in samples(entries, "d", domain, 200)]
        assert min(ratios) < small
        assert min(1.0 - ratio for ratio in ratios) < close


def test_an_error_of_two_units_is_seen() -> None:
    point = next(iter(samples(derive(load("cone")), "d", BENCH, 1)))
    near = float(point.exact)
    assert ulps(near, point.exact) <= 0.5
    assert 1.0 < ulps(math.nextafter(math.nextafter(near, math.inf), math.inf), point.exact) < 3.0
    assert ulps(math.nan, point.exact) == math.inf
