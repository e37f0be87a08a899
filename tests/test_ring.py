"""Where the pressure under a concave face vanishes first on unloading: the root of a hypergeometric equation."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from axicontact._programs.plane import concave_power as programs
from axicontact._runtime.shapes.ring import lifted_at_zero_pressure, outside_zero_pressure, ring_of_zero_pressure
from axicontact.plane import concave_power

EPS = 2.0**-52
K = (-1.0 + 1e-6, -0.9, -0.3, 0.0, 0.4, 0.7)
N = (2.03, 2.5, 3.0, 5.5, 40.0, 900.0)
UNITS = 24.0
"""Of the last place; 18 are measured, for the difference next to k = -1."""


@pytest.mark.parametrize("k", K)
def test_the_pressure_and_its_slope_vanish_there(k: float) -> None:
    """(n - 2) F(2 - n/2, 1; (3 + k)/2; z) (n z - 1 + k) = n (1 + k), by another way than the rule of the module."""
    with mp.workdps(40):
        for n in N:
            ring = float(ring_of_zero_pressure(np.float64(n), np.float64(k)))
            x, y = mp.mpf(n), mp.mpf(k)

            def gap(log: mp.mpf, x: mp.mpf = x, y: mp.mpf = y) -> mp.mpf:
                z = -mp.expm1(-2 * log)
                return (x - 2) * mp.hyp2f1(2 - x / 2, 1, (3 + y) / 2, z) * (x * z - 1 + y) / (x * (1 + y)) - 1

            start = -mp.log(ring)
            log = mp.findroot(gap, (start, start * (1 + mp.mpf(10) ** -9)), tol=mp.mpf(10) ** -50, verify=False)
            z = -mp.expm1(-2 * log)
            assert abs(ring / mp.exp(-log) - 1) < UNITS * EPS, n
            for function, exact in ((outside_zero_pressure, z), (lifted_at_zero_pressure, x * z - 1 + y)):
                value = float(function(np.float64(n), np.float64(k)))
                assert abs(value / exact - 1) < UNITS * EPS, (n, function.__name__)


def test_the_quartic_face_is_closed() -> None:
    """r_0 = a sqrt(1 - k)/2, also next to both ends of k; there the condition of 1 - k is that of the ring."""
    k = np.array([-1.0 + 1e-12, -0.5, 0.0, 0.5, 1.0 - 1e-6])
    ring = ring_of_zero_pressure(np.full_like(k, 4.0), k)
    np.testing.assert_allclose(ring, np.sqrt(1.0 - k) / 2.0, rtol=8 * EPS)


def test_no_ring_up_to_the_paraboloid() -> None:
    n, k = np.array([1.2, 2.0]), np.array([0.3, -0.4])
    with np.errstate(divide="ignore"):  # as in every function of a module
        assert (ring_of_zero_pressure(n, k) == 0.0).all()
        assert (outside_zero_pressure(n, k) == 1.0).all()
        np.testing.assert_allclose(lifted_at_zero_pressure(n, k), n - 1.0 + k, rtol=EPS)


def test_a_ring_next_to_the_centre_and_one_next_to_the_edge() -> None:
    """r_0 = (n - 2) pi/4 for n near 2; for large n as in n (1 - r_0**2) = const, both for k = 0."""
    near = 1e-9
    assert float(ring_of_zero_pressure(2.0 + near)) == pytest.approx(np.pi / 4.0 * ((2.0 + near) - 2.0), rel=1e-7)
    first, second = (n * float(outside_zero_pressure(np.float64(n))) for n in (1e6, 1e7))
    assert first == pytest.approx(second, rel=1e-5)
    assert second == pytest.approx(4.512, rel=1e-3)


def test_plain_numbers_need_no_arrays() -> None:
    """A search over arrays took 7 ms for one number."""
    for n in (1.5, 2.0, 2.7, 4.0, 11.0):
        value = programs.minimum_load(0.1, n, 3.0)
        exact = concave_power.minimum_load(a=1.0, h=np.full(2, 0.1), n=n, E_star=3.0)[0]
        assert value == pytest.approx(exact, rel=8 * EPS, abs=0.0)
