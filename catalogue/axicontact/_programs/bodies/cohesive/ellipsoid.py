"""Bodies of axicontact.cohesive.ellipsoid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan2, cos, cosh, fsum, hypot, inf, sin, sinh

from ...._programs.bodies.normal import ellipsoid as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, tension_of_zone, zone_like, zone_within
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii_up_to, radius_of_pull_off, radius_under, state_near
from ....cohesive.ellipsoid import partial
from ...._runtime.plain import log1p, sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))


def _opened(q, a, h, b):
    v4 = hypot(a, q)
    v6 = b - a
    v11 = sqrt((v6 if v6 > 0.0 or v6 != v6 else 0.0) * (b + a))
    v12 = v11 - q
    v16 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (v11 + q))
    v18 = asinh(v16 / v4)
    v19 = v18 > 0.0
    v21 = v18 if v19 else 1.0
    v23 = asinh(atan2(q, a) / v21)
    v35 = h / b
    v48 = []
    v49 = []
    if abs(v23) > 0.0:
        for node, weight in RULE_0(v23 / 0.7):
            v25 = node * v23
            v27 = v21 * sinh(v25)
            v28 = sin(v27)
            v29 = cos(v27)
            v30 = v4 * v29
            v32 = hypot(v16, v4 * v28)
            v44 = (v35 * asinh(v30 / v32) + h * v30 / (v32 * v32)) * v21 * cosh(v25)
            v46 = v44 * v27 * v28
            v47 = v44 * v29
            v48.append(weight * v46)
            v49.append(weight * v47)
    v48 = fsum(v48) * v23
    v49 = fsum(v49) * v23
    v52 = 0.6366197723675814 if v19 else inf
    return (v52 * v4 * v48, v52 * v49)


def _zone(a, h, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    largest = difference_root(b, a)
    a = zone_within(partial(_opened, h=h, b=b), a, E_star, dgamma, sigma_0, largest)
    return np.nan if np.isnan(a) else root_of_zone(partial(_opened, h=h, b=b), a, E_star, dgamma, sigma_0, largest)


def _cohesive_radius(a, h, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, h, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, h, b, E_star, dgamma, sigma_0):
    return h / b * a * (log1p(2.0 * a / (b - a)) / 2.0) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, h, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, h, b, E_star, dgamma, sigma_0), h, b, E_star, dgamma, sigma_0)


def _force_of(a, q, h, b, E_star, dgamma, sigma_0):
    v12 = log1p(2.0 * a / (b - a)) / 2.0
    v17 = a / b
    if v12 < 1.0:
        v23 = v12 * v12
        v58 = v17 * (v17 * v17) * ((((((1.0716932453474512e-06 * v23 + 0.00019982814521087247) * v23 + 0.007076196047699156) * v23 + 0.08608622548411103) * v23 + 0.3073858328214721) * v23 + 0.3333333333333333) / (((((2.565078604208634e-08 * v23 + 2.0203143566039827e-05) * v23 + 0.001617010334189783) * v23 + 0.03639274880225476) * v23 + 0.32215749846441627) * v23 + 1.0))
    else:
        v58 = v12 - v17
    v62 = hypot(a, q)
    return E_star * h * (a * a * v12 / b + b * v58) - 2.0 * sigma_0 * (v62 * v62 * atan2(q, a) + a * q)


def _force(a, h, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, h, b, E_star, dgamma, sigma_0), h, b, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, h, b, E_star, dgamma, sigma_0):
    return normal._pressure(r, a, h, b, E_star) - tension_of_zone(r, q, a, sigma_0)


def _pressure(r, a, h, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, h, b, E_star, dgamma, sigma_0), h, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, h, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, h, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, h, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, h, b, E_star, dgamma, sigma_0), h, b, E_star, dgamma, sigma_0)


def _growth(a, h, b):
    if a > 0.0:
        v5 = b - a
        v9 = sqrt((v5 if v5 > 0.0 or v5 != v5 else 0.0) * (b + a))
        return h / b * asinh(a / v9) + h * a / (v9 * v9)
    return 0.0


def _radii(h, b, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    largest = difference_root(b, a)
    a = zone_within(partial(_opened, h=h, b=b), a, E_star, dgamma, sigma_0, largest)
    first = np.nan if np.isnan(a) else zone_like(partial(_opened, h=h, b=b), a, E_star, dgamma, sigma_0, largest)
    return radii_up_to(first, b)


def _state(a, start, h, b, E_star, dgamma, sigma_0, control):
    growth = _growth(a, h, b)
    return state_near(partial(_opened, h=h, b=b), growth, start, a, control, E_star, dgamma, sigma_0, difference_root(b, a))


def _pull_off_radius(h, b, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, h, b, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, h, b, E_star, dgamma, sigma_0), _radii(h, b, E_star, dgamma, sigma_0))


def _parted(h, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), h, b, E_star, dgamma, sigma_0)
    return parted(partial(_opened, h=h, b=b), first, E_star, sigma_0)


def _pull_off_zone(a, h, b, E_star, dgamma, sigma_0):
    largest = difference_root(b, a)
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, h=h, b=b), a, E_star, dgamma, sigma_0, largest), lambda: _parted(h, b, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, h, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, h, b, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, h=h, b=b), q, E_star, dgamma, sigma_0))


def _held_apart(d, h, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(h, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, h=h, b=b), _parted(h, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, h, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, h, b, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, h, b, E_star, dgamma, sigma_0), d, _radii(h, b, E_star, dgamma, sigma_0))
    return _held_apart(d, h, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, h, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, h, b, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, h, b, E_star, dgamma, sigma_0), F, _radii(h, b, E_star, dgamma, sigma_0))
