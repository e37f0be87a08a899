"""Bodies of axicontact.cohesive.cone over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, sin, tan

from ...._programs.bodies.normal import cone as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.cone import partial
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.45, 8), (inf, 16)))


def _opened(q, a, theta):
    v4 = atan2(q, a)
    v15 = 3.141592653589793 * tan(theta) / 2.0
    v20 = []
    v21 = []
    if abs(v4) > 0.0:
        for node, weight in RULE_0(v4 / 1.0):
            v6 = node * v4
            v8 = 0.0 + v6
            v18 = v15 * v8 * sin(v8)
            v19 = v15 * cos(v8)
            v20.append(weight * v18)
            v21.append(weight * v19)
    v20 = fsum(v20) * v4
    v21 = fsum(v21) * v4
    return (0.6366197723675814 * hypot(a, q) * v20, 0.6366197723675814 * v21)


def _zone(a, theta, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, theta, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, theta, E_star, dgamma, sigma_0):
    return 3.141592653589793 * tan(theta) * a / 2.0 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, theta, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, theta, E_star, dgamma, sigma_0), theta, E_star, dgamma, sigma_0)


def _force_of(a, q, theta, E_star, dgamma, sigma_0):
    v14 = hypot(a, q)
    return 3.141592653589793 * E_star * tan(theta) * (a * a) / 2.0 - 2.0 * sigma_0 * (v14 * v14 * atan2(q, a) + a * q)


def _force(a, theta, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, theta, E_star, dgamma, sigma_0), theta, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, theta, E_star, dgamma, sigma_0):
    v7 = a - r
    v8 = a + r
    v11 = r < a
    return (E_star * tan(theta) * log1p((v7 + sqrt(v7 * v8)) / r) / 2.0 if v11 else 0.0) - sigma_0 * (0.6366197723675814 * atan2(q, sqrt((v7 if v7 > 0.0 or v7 != v7 else 0.0) * v8)) if v11 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, theta, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, theta, E_star, dgamma, sigma_0), theta, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, theta, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, theta, E_star, dgamma, sigma_0), theta, E_star, dgamma, sigma_0)


def _growth(a, theta):
    if a > 0.0:
        return 3.141592653589793 * tan(theta) / 2.0
    return 0.0


def _radii(theta, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, theta=theta), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, theta, E_star, dgamma, sigma_0, control):
    growth = _growth(a, theta)
    return state_near(partial(_opened, theta=theta), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(theta, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, theta, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, theta, E_star, dgamma, sigma_0), _radii(theta, E_star, dgamma, sigma_0))


def _parted(theta, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), theta, E_star, dgamma, sigma_0)
    return parted(partial(_opened, theta=theta), first, E_star, sigma_0)


def _pull_off_zone(a, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, theta=theta), a, E_star, dgamma, sigma_0), lambda: _parted(theta, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, theta, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, theta, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, theta=theta), q, E_star, dgamma, sigma_0))


def _held_apart(d, theta, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(theta, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, theta=theta), _parted(theta, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, theta, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, theta, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, theta, E_star, dgamma, sigma_0), d, _radii(theta, E_star, dgamma, sigma_0))
    return _held_apart(d, theta, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, theta, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, theta, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, theta, E_star, dgamma, sigma_0), F, _radii(theta, E_star, dgamma, sigma_0))
