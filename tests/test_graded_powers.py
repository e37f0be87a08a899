"""Power laws on the graded half-space at the ends of their exponents, against the exact entries."""

from __future__ import annotations

import random

import mpmath as mp
import numpy as np
import pytest
import sympy as sp
from stored_book import stored

from axicontact._runtime.graded.pressure import power_growth
from axicontact.graded.normal import concave_power, power_law
from axiderive import notation as nt
from axiderive.oracle.evaluate import case_at, evaluate

EPS = 2.0**-52


def exact(suffix: str, key: str = "power_law.fgm", **values: float) -> float:
    entries = stored(key)
    known = {getattr(nt, name): sp.Rational(value) for name, value in values.items()}
    return float(evaluate(case_at(entries[suffix], known).expr, known, 30))


@pytest.mark.parametrize("k", [-1 + 1e-15, -0.9, 1e-9, 0.3, 0.6995366749323075, 1 - 1e-15])
def test_depth_and_force_for_any_exponent(k: float) -> None:
    """A product of quotients loses 17 units, quotients of math.gamma 54, a rounded n + 1 + k 325; 8 are left."""
    draw = random.Random(7)
    for n in (2.0, 4.0, 12.0, *(10 ** draw.uniform(-3, 3) for _ in range(60))):
        with mp.workdps(40):
            m, q = mp.mpf(n), mp.mpf(k)
            depth = mp.gamma(m / 2 + 1) * mp.gamma((1 + q) / 2) / mp.gamma((m + 1 + q) / 2)
            force = 2 / (1 + q) * depth * m / (m + 1 + q)
        assert power_law.depth(1.0, A=1.0, n=n, k=k) == pytest.approx(float(depth), rel=10 * EPS, abs=0.0)
        assert power_law.force(1.0, A=1.0, n=n, H=1.0, k=k) == pytest.approx(float(force), rel=10 * EPS, abs=0.0)


@pytest.mark.parametrize("n", [300.0, 896.7655093517493])
def test_displacement_far_outside_a_steep_profile(n: float) -> None:
    """With n in the weight of the rule the sum cancels: a per cent of the value is lost."""
    for k, r in ((0.8, 44162.455), (-0.5, 1.0001), (0.3, 7.0)):
        found = power_law.displacement(r, 1.0, A=1.0, n=n, k=k)
        assert found == pytest.approx(exact("w", r=r, a=1.0, A=1.0, n=n, k=k), rel=40 * EPS, abs=0.0)


@pytest.mark.parametrize("gap", [1e-15, 1e-9])
def test_pressure_next_to_the_least_grading(gap: float) -> None:
    """It grows as 1/(1 + k); (1 + k)/2 from a rounded (k - 1)/2 is an eighth off at 1e-15."""
    k = -1.0 + gap
    for n, r in ((0.13, 0.3), (1.0, 1e-7), (5.7, 0.999)):
        found = power_law.pressure(r, 1.0, A=1.0, n=n, H=1.0, k=k)
        assert found == pytest.approx(exact("p", r=r, a=1.0, A=1.0, n=n, H=1.0, k=k), rel=40 * EPS, abs=0.0)


# two panels from the edge, the longest with 64 and 32 nodes of the hollow and of the punch, and far outside
@pytest.mark.parametrize("beyond", [1e-15, 3e-14, 1.5e-10, 6e-10, 3e-4, 0.0013, 0.0051, 40.0])
@pytest.mark.parametrize("k", [-0.48, -0.24, 0.4])
def test_displacement_beside_a_hollow(beyond: float, k: float) -> None:
    """With plain weights 6 units at k = -0.48, with too few nodes most at -0.24; a power of s 150 at n = 1000."""
    for n in (1.7, 2.0, 16.0, 900.0):
        known = {"a": 1.0, "h": 1.0, "n": n, "k": k}
        d, r = concave_power.minimum_depth(**known) * (1.0 + 1e-9), 1.0 + beyond
        found = concave_power.displacement(r, d, **known)
        assert found == pytest.approx(exact("w", "concave_power.fgm", r=r, d=d, **known), rel=4.5 * EPS, abs=0.0), n


@pytest.mark.parametrize("n", [2, 4, 6, 16])
@pytest.mark.parametrize("k", [-1 + 1e-9, -0.6, 0.3, 0.9999999999984])
def test_even_powers_are_closed(n: int, k: float) -> None:
    """On the axis, where the steps of the sum are seen, next to the edge, where a power of 1 + k misses 7 units."""
    a = 0.37
    for r in (0.0, 0.5 * a, (1 - 2**-50) * a):
        with mp.workdps(40):
            x, h, last = (mp.mpf(r) / a) ** 2, (1 + mp.mpf(k)) / 2, n // 2 - 1
            integral = mp.fsum(
                mp.binomial(last, j) * x ** (last - j) * (1 - x) ** (h + j) / (h + j) / 2 for j in range(n // 2)
            )
            depth = mp.gammaprod([n // 2 + 1, h], [n // 2 + h])
            wanted = n * depth * mp.mpf(a) ** (n - 1 + mp.mpf(k)) * integral / mp.pi
            found = power_law.pressure(r, a, A=1.0, n=float(n), H=1.0, k=k)
            assert abs(found / wanted - 1) * 2**52 <= 6, (n, k, r)


def test_closed_powers_are_those_of_the_rule() -> None:
    r, n = np.linspace(0.01, 0.36, 8), 6.0
    closed, ruled = (power_growth(r, 0.37 + 0.0 * r, power, 0.3) for power in (n, n + 0.0 * r))
    assert closed == pytest.approx(ruled, rel=2e-15, abs=0.0)
