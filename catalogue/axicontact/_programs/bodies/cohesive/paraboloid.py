"""Bodies of axicontact.cohesive.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, sin

from ...._programs.bodies.normal import paraboloid as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.paraboloid import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.45, 8), (inf, 16)))


def _opened(q, a, R):
    v3 = hypot(a, q)
    v4 = atan2(q, a)
    v18 = []
    v19 = []
    if abs(v4) > 0.0:
        for node, weight in RULE_0(v4 / 1.0):
            v6 = node * v4
            v8 = 0.0 + v6
            v9 = cos(v8)
            v13 = 2.0 * (v3 * v9) / R
            v16 = v13 * v8 * sin(v8)
            v17 = v13 * v9
            v18.append(weight * v16)
            v19.append(weight * v17)
    v18 = fsum(v18) * v4
    v19 = fsum(v19) * v4
    return (0.6366197723675814 * v3 * v18, 0.6366197723675814 * v19)


def _zone(a, R, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, R, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, R, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, R, E_star, dgamma, sigma_0):
    return a * a / R - 2.0 * (sigma_0 / E_star) * q


def _depth(a, R, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _force_of(a, q, R, E_star, dgamma, sigma_0):
    v15 = hypot(a, q)
    return 4.0 * E_star / (3.0 * R) * (a * (a * a)) - 2.0 * sigma_0 * (v15 * v15 * atan2(q, a) + a * q)


def _force(a, R, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, R, E_star, dgamma, sigma_0):
    v7 = a - r
    v8 = a + r
    v11 = r < a
    return (2.0 * E_star / (3.141592653589793 * R) * sqrt(v7 * v8) if v11 else 0.0) - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v11 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, R, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, R, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, R) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, R, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, R, E_star, dgamma, sigma_0), R, E_star, dgamma, sigma_0)


def _growth(a, R):
    if a > 0.0:
        return 2.0 * a / R
    return 0.0


def _radii(R, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, R=R), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, R, E_star, dgamma, sigma_0, control):
    growth = _growth(a, R)
    return state_near(partial(_opened, R=R), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(R, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, R, E_star, dgamma, sigma_0), _radii(R, E_star, dgamma, sigma_0))


def _parted(R, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), R, E_star, dgamma, sigma_0)
    return parted(partial(_opened, R=R), first, E_star, sigma_0)


def _pull_off_zone(a, R, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, R=R), a, E_star, dgamma, sigma_0), lambda: _parted(R, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, R, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, R, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, R=R), q, E_star, dgamma, sigma_0))


def _held_apart(d, R, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(R, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, R=R), _parted(R, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, R, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, R, E_star, dgamma, sigma_0), d, _radii(R, E_star, dgamma, sigma_0))
    return _held_apart(d, R, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, R, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, R, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, R, E_star, dgamma, sigma_0), F, _radii(R, E_star, dgamma, sigma_0))
