"""Bodies of axicontact.graded.tangential.capped_paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import capped_paraboloid as normal
from ....._programs.bodies._runtime.graded.breaks import rim_depth, rim_force, rim_rate
from ....._programs.bodies._runtime.physics.slip import stick_force


def _tangential_force(a, c, R1, R2, b, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import beyond_gain, power_gain
    power = power_gain('force', 0.0, c, a, 2.0, k) / (2 * R1)
    rim = beyond_gain('force', rim_force, rim_rate, (b,), 0.0, c, a, k) * (R1 - R2) / (R1 * R2)
    gain = power + rim
    return mu * (2.0 * H / (1.0 + k)) * gain


def _tangential_displacement(a, c, R1, R2, b, H, H_x, k, mu):
    from ....._programs.bodies._runtime.graded.slip import beyond_gain, power_gain
    power = power_gain('depth', 0.0, c, a, 2.0, k) / (2 * R1)
    rim = beyond_gain('depth', rim_depth, rim_rate, (b,), 0.0, c, a, k) * (R1 - R2) / (R1 * R2)
    gain = power + rim
    return mu * (H / H_x) * gain


def _stick_radius(F_x, a, R1, R2, b, H, k, mu):
    F = stick_force(normal._force(a, R1, R2, b, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, R1, R2, b, H, k)


def _full_slip_displacement(a, R1, R2, b, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, R1, R2, b, k)
