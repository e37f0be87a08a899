"""The graded functions against enclosures over the bench and the extreme domain: lengths over 600 decades."""

from __future__ import annotations

from collections.abc import Callable, Collection
from importlib import import_module

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from graded_modules import derived, emitted
from stored_book import evidence, stored

from axiderive.profiles import COMPACT_NAMES
from axiderive.stable.measure import Sample, samples, ulps, value
from axiderive.stable.records import DIRECT
from axiderive.stable.reference import DOMAINS, condition

TOLERANCE = 45.0
"""1e-14 in units of the last place."""
CONDITIONED = 4.0
"""Beyond it, over 1 + the sum of |d ln value/d ln argument|; 3.8 is the most of 120 points of every quantity."""


def check(group: str, name: str, suffixes: Collection[str], count: int) -> None:
    entries, module = derived(group, name), emitted(f"{group}.{name}")
    for suffix in suffixes:
        function = getattr(module, entries[suffix].quantity.function)
        for domain in DOMAINS:
            for point in samples(entries, suffix, domain, count):
                error = _error(function, point)
                fits = error <= TOLERANCE or error <= CONDITIONED * (1.0 + condition(entries, suffix, point.values))
                assert fits, f"{name} {suffix} {domain.name}: {error} at {point.arguments} {point.keywords}"


def _error(function: Callable[..., float], point: Sample) -> float:
    try:
        return ulps(value(function, point), point.exact)
    except ValueError:  # the rule of the waves depends on the grading
        return 0.0


# the edge of small exponents, lengths whose squares leave the range, a break next to the edge, the exponent of a root
@pytest.mark.parametrize(
    ("group", "name", "suffixes"),
    [("normal", "power_law", "pw"), ("normal", "truncated_cone", "dF"), ("adhesive", "power_law", ("p", "w", "Dl"))],
)
def test_whole_range(group: str, name: str, suffixes: Collection[str]) -> None:
    check(group, name, suffixes, 16)


@pytest.mark.parametrize("group", ["", ".adh"])
@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_whole_range_of_every_profile(group: str, name: str) -> None:
    """What the build has measured at 30 points of either domain; `test_catalogue` asks whether of these functions."""
    key = f"{name}.fgm{group}"
    measured = evidence(key)["evaluation"]
    closed = {suffix for suffix, entry in stored(key).items() if suffix in DIRECT and entry.status == "closed"}
    assert measured.keys() >= {own for own in closed if not stored(key)[own].cases[0].expr.has(sp.Integral)}
    for suffix in closed & measured.keys():
        for domain in (measured[suffix][own.name] for own in DOMAINS):
            assert not domain["lost"], (key, suffix)
            assert domain["worst_ulp"] <= TOLERANCE or domain["over_condition"] <= CONDITIONED, (key, suffix, domain)


def test_excess_of_the_depth() -> None:
    """g(a)/f(a) - 1 of a power keeps its digits where it vanishes: at n = 0 and k = 1."""
    power_excess = import_module("axicontact._runtime.graded.growth").power_excess
    for n in (1e-3, 0.02, 1.0, 7.5, 1000.0):
        for k in (-1.0 + 1e-15, -0.6, -1e-15, 0.3, 1.0 - 1e-15):
            with mp.workdps(60):
                x, h = mp.mpf(n) / 2, (1 + mp.mpf(k)) / 2
                exact = mp.gamma(x + 1) * mp.gamma(h) / mp.gamma(x + h) - 1
                error = abs(mp.mpf(float(power_excess(np.float64(n), np.float64(k)))) / exact - 1)
            assert error < 16 * np.finfo(float).eps, (n, k, error)


@pytest.mark.parametrize("name", ["sphere", "hyperboloid", "rounded_punch", "gaussian"])
@pytest.mark.parametrize("power", [-900, 900])
def test_round_trips_far_out(name: str, power: int) -> None:
    """All lengths times a power of two: the inverse is scaled by it too."""
    unit, module = 2.0**power, emitted(f"normal.{name}")
    lengths = {"sphere": {"R": 1.0}, "rounded_punch": {"R": 2.0, "b": 0.5}, "gaussian": {"h": 0.7, "s": 1.0}}
    own = {key: x * unit for key, x in lengths.get(name, {"b": 0.4}).items()}
    own |= {"theta": 0.4} if name == "hyperboloid" else {}
    radius = module.radius_from_depth(module.depth(0.6 * unit, **own, k=0.3), **own, k=0.3)
    assert radius == pytest.approx(0.6 * unit, rel=1e-14, abs=0.0)


@pytest.mark.parametrize("k", [-0.3, 0.3])
def test_below_its_break_a_cap_is_a_paraboloid(k: float) -> None:
    """Outside such a contact a term that is zero must not come out as 0/0."""
    capped, plain = emitted("normal.capped_paraboloid"), emitted("normal.paraboloid")
    exact = plain.displacement(2.0, 1.0, R=3.0, k=k)
    assert capped.displacement(2.0, 1.0, R1=3.0, R2=1.0, b=2.5, k=k) == pytest.approx(exact, rel=1e-14, abs=0.0)


def test_reach_of_a_gaussian_bump_is_a_contact() -> None:
    """The largest radius may not round to one that the depth refuses: every radius below would be refused with it."""
    gaussian, k = emitted("normal.gaussian"), np.linspace(-0.95, 0.95, 96)
    for s in (1.0, 0.3, 15107975.526163526):
        assert np.isfinite(gaussian.radius_from_depth(1e-6 * s, h=0.7 * s, s=s, k=k)).all()
