"""Bodies of axicontact.graded.normal.capped_cylinder over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force
from ....._programs.bodies._runtime.graded.punch import punch_displacement, punch_pressure, punch_stiffness
from ....._runtime.plain import MATH as np


def _contact(d, a, R, k):
    """Contact radius, and the depth that the edge adds."""
    free = power_depth(a, 2.0, k) / (2 * R)
    rho = a * np.minimum(d / free, 1.0) ** (1.0 / 2.0)
    return (rho, np.maximum(d - free, 0.0))


def _force(d, a, R, H, k):
    rho, rest = _contact(d, a, R, k)
    cap = 2.0 * H / (1.0 + k) * power_force(rho, 2.0, k) / (2 * R)
    return cap + rest * punch_stiffness(rho, H, k)


def _pressure(r, d, a, R, H, k):
    from ....._programs.bodies._runtime.graded.pressure import power_pressure
    rho, rest = _contact(d, a, R, k)
    edge = rest * punch_pressure(r, rho, H, k) if rest > 0.0 else 0.0
    cap = H / np.pi * power_pressure(np.minimum(r, rho), rho, 2.0, k) / (2 * R)
    return edge + (cap if r < rho else 0.0) if r <= rho else 0.0


def _displacement(r, d, a, R, k):
    from ....._programs.bodies._runtime.graded.displacement import power_displacement
    rho, rest = _contact(d, a, R, k)
    cap = power_displacement(r, rho, 2.0, k) / (2 * R)
    return cap + rest * punch_displacement(r, rho, k)


def _stiffness(d, a, R, H, k):
    rho, rest = _contact(d, a, R, k)
    return punch_stiffness(rho, H, k)


def _depth_from_force(F, a, R, H, k):
    full = 2.0 * H / (1.0 + k) * power_force(a, 2.0, k) / (2 * R)
    free = power_depth(a, 2.0, k) / (2 * R)
    before = free * (F / full) ** (2.0 / (2.0 + 1.0 + k))
    return before if full > F else free + (F - full) / punch_stiffness(a, H, k)
