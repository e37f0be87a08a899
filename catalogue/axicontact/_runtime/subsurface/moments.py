"""Closed forms of the sums over flat punches where the slope is a polynomial.

With zeta = z + i t, rho**2 = r**2 + zeta**2, q = rho + zeta and the radius of the contact for the unit of length, V_jm
is the integral of t**j/(q**m rho) up to 1.  Every one follows from those of lower powers, the first of which are
elementary, by the derivative of t**(j - 1) rho/q**m:

    V_00 = omega - i Lambda,  V_0m = i (q**-m - q_0**-m)/m,  with q = q(1) = |q| exp(i omega), q_0 = q(0)
    (j + m) V_jm = (j - 1) (r**2 + z**2) V_(j-2)m + i (2 j - 1 + m) z V_(j-1)m - i m V_(j-1)(m-1) - [t**(j-1) rho/q**m]

S_m of a slope sum c_j t**j is -r**m Im sum c_j V_jm, and D_m, by parts, z r**m times the real part of
sum j c_j V_(j-1)m + c_0/(q_0**m rho_0) - sum c_j/(q**m rho).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from ..interface import Array


class Sums(NamedTuple):
    """What the numbers of a polynomial slope are made of, at points (r, z)."""

    r: Array
    z: Array
    s: Array
    """S_m/r**m, by m."""
    d: Array
    """D_m/(z r**m), by m."""
    w: Array
    """W."""


def sums(orders: int, r: Array, z: Array, xi: Array, eta: Array, slope: Sequence[Array], *, sunk: bool) -> Sums:
    """The sums for m below `orders` of a slope with these coefficients, and W if `sunk`, off the edge and the tip.

    They lose digits with the distance.  (xi + i eta)**2 is rho**2 at t = 1.
    """
    m = np.arange(orders)[:, None, None]
    h, away = np.sqrt(xi * xi + 1.0), np.sqrt(r * r + z * z)
    start, turn, over = 1.0 / (z + away), 0.5 * np.pi - np.arctan(xi), 1.0 / ((1.0 + eta) * h * h)
    # real and imaginary parts of q**-m, q_0**-m, V_0m
    power, first, row = np.empty((3, orders, 2, r.size))
    power[0, 0], power[0, 1], first[0, 0], first[:, 1] = 1.0, 0.0, 1.0, 0.0
    for k in range(1, orders):
        x, y = power[k - 1]
        power[k, 0], power[k, 1] = (x * xi + y) * over, (y * xi - x) * over
        first[k, 0] = first[k - 1, 0] * start
    row[0, 0], row[0, 1] = turn, -np.log1p(eta * (eta / (h + away) + 1.0 / (h + xi)) * start)
    row[1:] = _turned(power[1:] - first[1:]) / m[1:]
    flat, upright = power[:, 0], power[:, 1]
    end = np.stack((flat * xi - upright * eta, flat * eta + upright * xi), axis=1)
    kernel = (flat * xi + upright * eta) / (xi * xi + eta * eta)
    s, d, w, square, earlier = np.zeros((orders, r.size)), np.zeros((orders, r.size)), 0.0, away * away, row
    for j, c in enumerate(slope):
        loaded = c.any()
        if loaded:
            s -= c * row[:, 1]
            d += c * ((j * earlier[:, 0] if j else first[:, 0] / away) - kernel)
        if not sunk and j + 1 == len(slope):
            break
        turned = _turned(row)
        following = turned * z * (2 * j + 1 + m)
        following[1:] -= m[1:] * turned[:-1]
        following -= end
        following += away * first if j == 0 else earlier * (j * square)
        following /= j + 1 + m
        if loaded:
            w = w + c / (j + 1) * (turn - following[0, 0])
        earlier, row = row, following
    return Sums(r, z, s, d, w)


def _turned(pairs: Array) -> Array:
    """i times complex numbers."""
    return np.stack((-pairs[:, 1], pairs[:, 0]), axis=1)
