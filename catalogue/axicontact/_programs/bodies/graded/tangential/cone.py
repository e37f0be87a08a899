"""Bodies of axicontact.graded.tangential.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import cone as normal
from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.physics.slip import stick_force
from ....._runtime.plain import MATH as np


def _tangential_force(a, c, theta, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain
    gain = power_gain('force', 0.0, c, a, 1.0, k) * np.tan(theta)
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r, a, c, theta, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain

    def gain():
        inside = np.minimum(r, c)
        return power_gain('pressure', inside, c, a, 1.0, k) * np.tan(theta)
    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, theta, H, k))


def _tangential_displacement(a, c, theta, H, H_x, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain
    gain = power_gain('depth', 0.0, c, a, 1.0, k) * np.tan(theta)
    return mu * (H / H_x) * gain


def _stick_radius(F_x, a, theta, H, k, mu):
    F = stick_force(normal._force(a, theta, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, theta, H, k)


def _full_slip_displacement(a, theta, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, theta, k)
