"""Bodies of axicontact.cohesive.hyperboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import asinh, atan, atan2, cos, cosh, exp, expm1, fsum, hypot, inf, sin, sinh, tan

from ...._programs.bodies.normal import hyperboloid as normal
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii, radius_of_pull_off, radius_under, state_near
from ....cohesive.hyperboloid import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64), (18.03, 128)))
RULE_1 = rule(((0.409, 8), (1.712, 16), (3.012, 24), (4.256, 32), (9.015, 64)))


def _opened(q, a, theta, b):
    v4 = hypot(a, q)
    v7 = asinh(b / v4)
    v10 = 1.5707963267948966 / v7
    v11 = atan2(a, q) / v7
    v12 = asinh(v10)
    v27 = asinh(atan2(q, a) / v7 * (v10 + v11) / (v10 * sqrt(1.0 + v11 * v11) + v11 * sqrt(1.0 + v10 * v10)))
    v31 = 2.0 * v7
    v43 = tan(theta)
    v45 = b * v43
    v48 = b * b
    v60 = []
    v61 = []
    if abs(v27) > 0.0:
        for node, weight in RULE_0(v27 / 0.7):
            v29 = node * v27
            v33 = 0.5 * v29
            v38 = v31 * cosh(v12 - v33) * sinh(v33)
            v39 = cos(v38)
            v40 = v4 * v39
            v55 = (v43 * atan(v40 / b) + v45 * v40 / (v40 * v40 + v48)) * v7 * cosh(v12 - v29)
            v58 = v55 * v38 * sin(v38)
            v59 = v55 * v39
            v60.append(weight * v58)
            v61.append(weight * v59)
    v60 = fsum(v60) * v27
    v61 = fsum(v61) * v27
    return (0.6366197723675814 * v4 * v60, 0.6366197723675814 * v61)


def _zone(a, theta, b, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)


def _cohesive_radius(a, theta, b, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, theta, b, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, theta, b, E_star, dgamma, sigma_0):
    return tan(theta) * a * atan(a / b) - 2.0 * (sigma_0 / E_star) * q


def _depth(a, theta, b, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _force_of(a, q, theta, b, E_star, dgamma, sigma_0):
    v14 = a / b
    if v14 < 1.0:
        v18 = v14 * v14
        v61 = v14 * v18 * (((((((2.229767813968649e-06 * v18 + 0.0021043873129700233) * v18 + 0.04325113828415611) * v18 + 0.2725778671008127) * v18 + 0.7123414383945195) * v18 + 0.8116412201960678) * v18 + 0.3333333333333333) / ((((((0.002445452808893491 * v18 + 0.06453295925870227) * v18 + 0.5368820963772863) * v18 + 1.9680296155712274) * v18 + 3.5294070829658954) * v18 + 3.034923660588189) * v18 + 1.0))
    else:
        v61 = v14 - atan(v14)
    v65 = hypot(a, q)
    return E_star * tan(theta) * (a * a * atan2(a, b) + b * b * v61) - 2.0 * sigma_0 * (v65 * v65 * atan2(q, a) + a * q)


def _force(a, theta, b, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    v12 = a - r
    v17 = sqrt((v12 if v12 > 0.0 or v12 != v12 else 0.0) * (a + r))
    v60 = r < a
    if v60:
        v8 = r * r
        v11 = sqrt(v8 + b * b)
        v19 = asinh(v17 / v11)
        v24 = 0.0 - expm1(-2.0 * v19)
        v27 = v24 if v24 > 0.0 else inf
        v43 = tan(theta)
        v45 = b * v43
        v49 = b * b
        v54 = v11 * v11
        v58 = []
        for node, weight in RULE_1(v19 / 1.0):
            v28 = node * v19
            v37 = v17 * (exp(-v28) * (0.0 - expm1(-2.0 * (v19 - v28))) / v27)
            v38 = v37 * v37
            v40 = sqrt(v8 + v38)
            v57 = (v43 * atan(v40 / b) + v45 * v40 / (v40 * v40 + v49)) / v40 * sqrt(v54 + v38)
            v58.append(weight * v57)
        v58 = fsum(v58) * v19
        v64 = E_star / 3.141592653589793 * v58
    else:
        v64 = 0.0
    return v64 - sigma_0 * (0.6366197723675814 * atan2(q, v17) if v60 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, theta, b, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, theta, b, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, theta, b) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, theta, b, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, theta, b, E_star, dgamma, sigma_0), theta, b, E_star, dgamma, sigma_0)


def _growth(a, theta, b):
    if a > 0.0:
        v7 = tan(theta)
        return v7 * atan(a / b) + b * v7 * a / (a * a + b * b)
    return 0.0


def _radii(theta, b, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    first = zone_like(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0)
    return radii(first)


def _state(a, start, theta, b, E_star, dgamma, sigma_0, control):
    growth = _growth(a, theta, b)
    return state_near(partial(_opened, theta=theta, b=b), growth, start, a, control, E_star, dgamma, sigma_0)


def _pull_off_radius(theta, b, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, theta, b, E_star, dgamma, sigma_0), _radii(theta, b, E_star, dgamma, sigma_0))


def _parted(theta, b, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), theta, b, E_star, dgamma, sigma_0)
    return parted(partial(_opened, theta=theta, b=b), first, E_star, sigma_0)


def _pull_off_zone(a, theta, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, theta=theta, b=b), a, E_star, dgamma, sigma_0), lambda: _parted(theta, b, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, theta, b, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, theta=theta, b=b), q, E_star, dgamma, sigma_0))


def _held_apart(d, theta, b, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(theta, b, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, theta=theta, b=b), _parted(theta, b, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, theta, b, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, theta, b, E_star, dgamma, sigma_0), d, _radii(theta, b, E_star, dgamma, sigma_0))
    return _held_apart(d, theta, b, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, theta, b, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, theta, b, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, theta, b, E_star, dgamma, sigma_0), F, _radii(theta, b, E_star, dgamma, sigma_0))
