"""Bodies of axicontact.graded.tangential.truncated_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import truncated_paraboloid as normal
from ....._programs.bodies._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ....._programs.bodies._runtime.physics.slip import stick_force
from ....._runtime.plain import MATH as np


def _tangential_force(a, c, R, b, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import beyond_gain
    gain = beyond_gain('force', rim_force, rim_rate, (b,), 0.0, c, a, k) / R
    return mu * (2.0 * H / (1.0 + k)) * gain if c >= b else np.nan


def _tangential_displacement(a, c, R, b, H, H_x, k, mu):
    from ....._programs.bodies._runtime.graded.slip import beyond_gain
    gain = beyond_gain('depth', rim_depth, rim_rate, (b,), 0.0, c, a, k) / R
    return mu * (H / H_x) * gain if c >= b else np.nan


def _stick_radius(F_x, a, R, b, H, k, mu):
    F = stick_force(normal._force(a, R, b, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R, b, H, k)
