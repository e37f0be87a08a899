"""The compliance of one homogeneous body in numbers, from its equations of equilibrium alone.

Under a load of wave number 1 the state at a depth is exp(A z) times that at the surface; displacements that vanish at
a large depth and the loads leave one state.  The image of that depth in the surface is exp(-2 depth).
"""

from __future__ import annotations

import mpmath as mp

from .shape import Number

DEPTH = 1.5
"""Depth at which the displacements are set to zero, per digit wanted."""


def body_compliance(modulus: str, E: Number, nu: Number, digits: int) -> Number:
    """What a body with Young's modulus E and Poisson's ratio nu adds to 1/E* or 1/G*.

    A pressure moves the surface by twice its share of 1/E*.  Shears along and across a wave, of all directions alike,
    move it by twice its share of 1/G* at the mean.
    """
    depth = DEPTH * digits
    with mp.workdps(digits + int(depth) + 20):
        shear = E / (2 * (1 + nu))
        first = 2 * shear * nu / (1 - 2 * nu)
        if modulus == "E_star":
            return _plane(shear, first, depth, 1) / 2
        # U'' = U across the wave
        across = mp.tanh(depth) / shear
        return (_plane(shear, first, depth, 0) + across) / 4


def _plane(shear: Number, first: Number, depth: float, load: int) -> Number:
    """U under a shear 1 (load 0) or W under a pressure 1 (load 1), by u_x = U sin x, u_z = W cos x."""
    wide = first + 2 * shear
    # U' = W + T/mu, W' = (S - lambda U)/wide, T' = wide U + lambda W', S' = -T
    rates = mp.matrix(
        [
            [0, 1, 1 / shear, 0],
            [-first / wide, 0, 0, 1 / wide],
            [wide - first**2 / wide, 0, 0, first / wide],
            [0, 0, -1, 0],
        ]
    )
    below = mp.expm(rates * depth, method="taylor")
    loads = mp.matrix([-1 if load == 0 else 0, 0 if load == 0 else -1])
    surface = mp.lu_solve(below[:2, :2], -below[:2, 2:] * loads)
    return surface[load]
