"""Bodies of axicontact.graded.tangential.polynomial over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies.graded.normal import polynomial as normal
from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.physics.slip import stick_force
from ....._runtime.plain import MATH as np


def _tangential_force(a, c, A, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain
    gain = sum((A_j * power_gain('force', 0.0, c, a, j, k) for j, A_j in enumerate(A, 1)))
    return mu * (2.0 * H / (1.0 + k)) * gain


def _traction(r, a, c, A, H, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain

    def gain():
        inside = np.minimum(r, c)
        return sum((A_j * power_gain('pressure', inside, c, a, j, k) for j, A_j in enumerate(A, 1)))
    return mu * either(r < c, lambda: H / np.pi * gain(), lambda: normal._pressure(r, a, A, H, k))


def _tangential_displacement(a, c, A, H, H_x, k, mu):
    from ....._programs.bodies._runtime.graded.slip import power_gain
    gain = sum((A_j * power_gain('depth', 0.0, c, a, j, k) for j, A_j in enumerate(A, 1)))
    return mu * (H / H_x) * gain


def _stick_radius(F_x, a, A, H, k, mu):
    F = stick_force(normal._force(a, A, H, k), F_x, mu)
    return a if (F_x == 0.0) & (a >= 0.0) else normal._radius_from_force(F, A, H, k)


def _full_slip_displacement(a, A, H, H_x, k, mu):
    return mu * (H / H_x) * normal._depth(a, A, k)
