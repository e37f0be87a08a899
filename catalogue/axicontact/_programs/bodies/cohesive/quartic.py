"""Bodies of axicontact.cohesive.quartic over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, pow, sin

from ...._programs.bodies.normal import quartic as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.quartic import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.45, 8), (inf, 16)))


def _opened(q, a, A):
    v3 = hypot(a, q)
    v4 = atan2(q, a)
    v14 = 32.0 * A / 3.0
    v23 = []
    v24 = []
    if abs(v4) > 0.0:
        for node, weight in RULE_0(v4 / 1.0):
            v6 = node * v4
            v8 = 0.0 + v6
            v9 = cos(v8)
            v10 = v3 * v9
            v18 = v14 * (v10 * (v10 * v10))
            v21 = v18 * v8 * sin(v8)
            v22 = v18 * v9
            v23.append(weight * v21)
            v24.append(weight * v22)
    v23 = fsum(v23) * v4
    v24 = fsum(v24) * v4
    return (0.6366197723675814 * v3 * v23, 0.6366197723675814 * v24)


def _zone(a, A, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, A, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, A, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, A, E_star, dgamma, sigma_0):
    v12 = a * a
    return 8.0 * A / 3.0 * (v12 * v12) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, A, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _force_of(a, q, A, E_star, dgamma, sigma_0):
    v14 = hypot(a, q)
    return 64.0 * E_star * A / 15.0 * pow(a, 5.0) - 2.0 * sigma_0 * (v14 * v14 * atan2(q, a) + a * q)


def _force(a, A, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, A, E_star, dgamma, sigma_0):
    v7 = a - r
    v8 = a + r
    v11 = r < a
    return (32.0 * E_star * A / 28.274333882308138 * (a * a + 2.0 * (r * r)) * sqrt(v7 * v8) if v11 else 0.0) - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v11 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, A, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, A, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, A) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, A, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, A, E_star, dgamma, sigma_0), A, E_star, dgamma, sigma_0)


def _growth(a, A):
    if a > 0.0:
        return 32.0 * A / 3.0 * (a * (a * a))
    return 0.0


def _radii(A, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, A=A), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, A, E_star, dgamma, sigma_0, control):
    growth = _growth(a, A)
    return state_near(partial(_opened, A=A), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(A, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, A, E_star, dgamma, sigma_0), _radii(A, E_star, dgamma, sigma_0))


def _parted(A, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), A, E_star, dgamma, sigma_0)
    return parted(partial(_opened, A=A), first, E_star, sigma_0)


def _pull_off_zone(a, A, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, A=A), a, E_star, dgamma, sigma_0), lambda: _parted(A, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, A, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, A, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, A=A), q, E_star, dgamma, sigma_0))


def _held_apart(d, A, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(A, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, A=A), _parted(A, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, A, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, A, E_star, dgamma, sigma_0), d, _radii(A, E_star, dgamma, sigma_0))
    return _held_apart(d, A, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, A, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, A, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, A, E_star, dgamma, sigma_0), F, _radii(A, E_star, dgamma, sigma_0))
