"""What guarantees the brackets of the inverses: proved slopes, and the signs that an iteration meets."""

from __future__ import annotations

import math
from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from axicontact._runtime import inverse as roots
from axicontact._runtime.shapes import waves
from axicontact.normal import capped_paraboloid, polynomial, power_law
from axiderive.code.bodies.compact import Compact
from axiderive.code.bodies.growth import DIGITS, Growth, exponents, log_slope, proved
from axiderive.code.private import PrivateFunctions
from axiderive.notation import R, b, r, s
from axiderive.physics.normal import derive
from axiderive.profiles import COMPACT_NAMES, load

EPS = 2.0**-52
PROVED = (
    "sphere", "ellipsoid", "hyperboloid", "truncated_cone", "truncated_paraboloid", "rounded_punch",
)  # fmt: skip
ATTAINED = {
    ("truncated_cone", "ad"): (1.0, 1.2),
    ("rounded_punch", "ad"): (2.0, 3.0),
    ("rounded_punch", "aF"): (3.0, 3.2),
}
"""Elsewhere both ends of the range are limits of the slope."""


@pytest.mark.parametrize("suffix", ["ad", "aF"])
@pytest.mark.parametrize("name", PROVED)
def test_proved_slopes_bound_those_of_the_exact_curves(name: str, suffix: str) -> None:
    compact = Compact(derive(load(name)), PrivateFunctions(load(name)))
    low, high = proved(load(name), suffix) or (0, 0)
    assert exponents(compact, suffix) == (f"{low}.0", f"{high}.0")
    with mp.workdps(DIGITS):
        growth = Growth(compact, suffix)
        slopes = [float(growth.slope(t)) for t in growth.places]
    assert low - 1e-10 <= min(slopes) <= max(slopes) <= high + 1e-10
    least, most = ATTAINED.get((name, suffix), (low, high))
    assert min(slopes) == pytest.approx(least, abs=0.1)
    assert max(slopes) == pytest.approx(most, abs=0.1)


def test_no_range_is_claimed_where_none_is_proved() -> None:
    """With two lengths, a break above a tip, waves, or an end of slope zero."""
    named = {name for name in COMPACT_NAMES if name != "polynomial" and proved(load(name), "aF")}
    assert named == {*PROVED, "cone", "paraboloid", "quartic", "sextic"}


@pytest.mark.parametrize(
    ("shape", "slope"),
    [
        (R - sp.sqrt(R**2 - r**2), R**2 / (R**2 - r**2)),
        ((r - b) ** 2, r / (r - b)),
        (1 - sp.exp(-(r**2) / s**2), 1 - 2 * r**2 / s**2),
    ],
)
def test_slope_of_a_rate(shape: sp.Expr, slope: sp.Expr) -> None:
    assert sp.cancel(log_slope(shape) - slope) == 0


def kinked(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    return np.where(t > 1.0, t**9, t), np.where(t > 1.0, 9.0, 1.0)


def flat(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Slope 7 at both ends, and 1e-3 over six decades in between."""
    middle = np.minimum(np.maximum(t, 1e-3), 1e3) ** 1e-3
    return middle * np.minimum(t / 1e-3, 1.0) ** 7 * np.maximum(t / 1e3, 1.0) ** 7, np.where(
        (t > 1e-3) & (t < 1e3), 1e-3, 7.0
    )


@pytest.mark.parametrize("claimed", [(1e-6, np.inf), (1.0, 9.0), (0.1, 0.2), (20.0, 30.0), (5.0, 5.0)])
@pytest.mark.parametrize("curve", [kinked, flat])
def test_signs_guarantee_the_root(curve: Callable[..., Any], claimed: tuple[float, float]) -> None:
    """Whatever the exponents claim, and from any start: with an interval by exponents alone most of these are lost."""
    value = 10.0 ** np.linspace(-40, 40, 81)
    for start in (1e-12, 1.0, 1e12):
        with np.errstate(all="ignore"):
            t = roots.inverse(curve, value, np.full_like(value, start), claimed)
            below, above = curve(t * (1.0 - 16.0 * EPS))[0], curve(t * (1.0 + 16.0 * EPS))[0]
        assert np.all((below <= value * (1.0 + 4.0 * EPS)) & (value * (1.0 - 4.0 * EPS) <= above))


def test_signs_guarantee_the_root_over_waves(monkeypatch: pytest.MonkeyPatch) -> None:
    """Even where a step goes the whole width of its series the wrong way, twice."""
    reached, calls = waves._reached, SimpleNamespace(count=0)

    def astray(*given: Any) -> np.ndarray:
        calls.count += 1
        return -np.ones_like(given[1]) if calls.count < 3 else reached(*given)

    monkeypatch.setattr(waves, "_reached", astray)
    z = np.array([0.3, 2.0, 30.0, 400.0])
    for power in (1, 2):
        calls.count = 0
        value = waves._series(z, np.array(1.5), z, power)[0]
        found = waves.inverse_over_waves(value, np.array(1.5), power)
        again = waves._series(found, np.array(1.5), z, power)[0]
        assert calls.count > 2
        np.testing.assert_allclose(again, value, rtol=8 * EPS)


def test_a_start_far_below_the_root_is_no_end() -> None:
    """There t stands for hardly anything, as the radius next to a break: what counts is where the step leads."""

    def share(t: np.ndarray) -> np.ndarray:
        return t * t / (1.0 + t * t)

    def straight(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        return t, np.ones_like(t)

    t = roots.inverse(straight, np.ones(1), np.full(1, 1e-9), (0.5, 2.0), share=share)
    assert t[0] == pytest.approx(1.0, rel=4 * EPS, abs=0.0)


def test_a_coefficient_next_to_the_largest_double() -> None:
    """Its product with the numbers of the formula overflows; the radii are those of the power law of the same term."""
    height = 1.7e308
    for inverse, value in (("radius_from_depth", 1e3), ("radius_from_force", 1e-80)):
        given = {"E_star": 1e9} if inverse == "radius_from_force" else {}
        wanted = getattr(power_law, inverse)(value, A=height, n=3.0, **given)
        found = getattr(polynomial, inverse)(value, A=(0.0, 0.0, height), **given)
        assert wanted > 0.0 and abs(found / wanted - 1.0) <= 4 * EPS


@pytest.mark.parametrize("many", [False, True])
def test_a_cap_that_is_sharper_than_any_number_is_not_felt_below_it(many):
    """At the break the root is zero: a number that is nothing beside b is something times the slope of this flank."""
    lengths = {"b": 5.325544031524897e-29, "R1": 4.51567691438525e-06, "R2": 5.979941987306003e-208}
    d = 6.18282823595198e-52
    radius = capped_paraboloid.radius_from_depth(np.array([d]) if many else d, **lengths)
    assert float(np.ravel(radius)[0]) == pytest.approx(math.sqrt(d * lengths["R1"]), rel=1e-14)
