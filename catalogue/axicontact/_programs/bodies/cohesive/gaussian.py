"""Bodies of axicontact.cohesive.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, cos, fsum, hypot, inf, nan, sin

from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.interface import either
from ...._programs.bodies._runtime.physics.cohesive import alone, lift_of_zone, outer_radius, root_of_zone, zone_like, zone_within
from ...._programs.bodies._runtime.physics.cohesive_states import parted, radii_on_bump, radius_of_pull_off, radius_under, state_near
from ....cohesive.gaussian import partial
from ...._runtime.plain import sqrt, rule, MATH as np

RULE_0 = rule(((0.5, 16), (inf, 32)))
RULE_1 = rule(((inf, 32),))


def _opened(q, a, h, s):
    v4 = hypot(a, q)
    v5 = atan2(q, a)
    v15 = 2.0 * h / s
    v82 = []
    v83 = []
    if abs(v5) > 0.0:
        for node, weight in RULE_0(v5 / 1.0):
            v7 = node * v5
            v9 = 0.0 + v7
            v10 = cos(v9)
            v12 = v4 * v10 / s
            v16 = v12 * v12
            v54 = ((((((((((((1.567077144036674e-13 * v16 + -3.840375691006307e-12) * v16 + 3.8015754128174666e-11) * v16 + -1.8423006918213799e-10) * v16 + 4.472469827763728e-10) * v16 + -1.1927516362741588e-09) * v16 + 6.225892246861416e-09) * v16 + 3.4413148480148793e-09) * v16 + -9.933344851449817e-08) * v16 + -5.127541706569233e-07) * v16 + 1.8119768160503268e-06) * v16 + 2.151585040783394e-05) * v16 + 4.61098799999374e-06) * v16
            v71 = v12 / ((((((v54 + -0.000684089638073553) * v16 + -0.002257495580553435) * v16 + 0.016931216930225715) * v16 + 0.17777777777782838) * v16 + 0.6666666666666656) * v16 + 1.0)
            v77 = v15 * (v71 + (1.0 - 2.0 * v71 * v12) * v12)
            v80 = v77 * v9 * sin(v9)
            v81 = v77 * v10
            v82.append(weight * v80)
            v83.append(weight * v81)
    v82 = fsum(v82) * v5
    v83 = fsum(v83) * v5
    return (0.6366197723675814 * v4 * v82, 0.6366197723675814 * v83)


def _zone(a, h, s, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    largest = difference_root(1.5019752682686114 * s, a)
    a = zone_within(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)
    return np.nan if np.isnan(a) else root_of_zone(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)


def _cohesive_radius(a, h, s, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, h, s, E_star, dgamma, sigma_0), a)


def _depth_of(a, q, h, s, E_star, dgamma, sigma_0):
    if a <= 1.5019752682686114 * s:
        v7 = a / s
        v13 = v7 * v7
        v51 = ((((((((((((1.567077144036674e-13 * v13 + -3.840375691006307e-12) * v13 + 3.8015754128174666e-11) * v13 + -1.8423006918213799e-10) * v13 + 4.472469827763728e-10) * v13 + -1.1927516362741588e-09) * v13 + 6.225892246861416e-09) * v13 + 3.4413148480148793e-09) * v13 + -9.933344851449817e-08) * v13 + -5.127541706569233e-07) * v13 + 1.8119768160503268e-06) * v13 + 2.151585040783394e-05) * v13 + 4.61098799999374e-06) * v13
        v73 = 2.0 * h * (v7 / ((((((v51 + -0.000684089638073553) * v13 + -0.002257495580553435) * v13 + 0.016931216930225715) * v13 + 0.17777777777782838) * v13 + 0.6666666666666656) * v13 + 1.0)) * v7
    else:
        v73 = nan
    return v73 - 2.0 * (sigma_0 / E_star) * q


def _depth(a, h, s, E_star, dgamma, sigma_0):
    return _depth_of(a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _force_of(a, q, h, s, E_star, dgamma, sigma_0):
    if a <= 1.5019752682686114 * s:
        v13 = 2.0 * h / s
        v77 = []
        for node, weight in RULE_1(a / 1.0):
            v10 = node * a
            v11 = v10 / s
            v14 = v11 * v11
            v52 = ((((((((((((1.567077144036674e-13 * v14 + -3.840375691006307e-12) * v14 + 3.8015754128174666e-11) * v14 + -1.8423006918213799e-10) * v14 + 4.472469827763728e-10) * v14 + -1.1927516362741588e-09) * v14 + 6.225892246861416e-09) * v14 + 3.4413148480148793e-09) * v14 + -9.933344851449817e-08) * v14 + -5.127541706569233e-07) * v14 + 1.8119768160503268e-06) * v14 + 2.151585040783394e-05) * v14 + 4.61098799999374e-06) * v14
            v69 = v11 / ((((((v52 + -0.000684089638073553) * v14 + -0.002257495580553435) * v14 + 0.016931216930225715) * v14 + 0.17777777777782838) * v14 + 0.6666666666666656) * v14 + 1.0)
            v76 = v10 * (v13 * (v69 + (1.0 - 2.0 * v69 * v11) * v11))
            v77.append(weight * v76)
        v77 = fsum(v77) * a
        v83 = 2.0 * E_star * v77
    else:
        v83 = nan
    v84 = hypot(a, q)
    return v83 - 2.0 * sigma_0 * (v84 * v84 * atan2(q, a) + a * q)


def _force(a, h, s, E_star, dgamma, sigma_0):
    return _force_of(a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _pressure_of(r, a, q, h, s, E_star, dgamma, sigma_0):
    v8 = a - r
    v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (a + r))
    v88 = r < a
    if a <= 1.5019752682686114 * s:
        if v88:
            v16 = r * r
            v23 = 2.0 * h / s
            v87 = []
            for node, weight in RULE_1(v13 / 1.0):
                v15 = node * v13
                v19 = sqrt(v16 + v15 * v15)
                v20 = v19 / s
                v24 = v20 * v20
                v62 = ((((((((((((1.567077144036674e-13 * v24 + -3.840375691006307e-12) * v24 + 3.8015754128174666e-11) * v24 + -1.8423006918213799e-10) * v24 + 4.472469827763728e-10) * v24 + -1.1927516362741588e-09) * v24 + 6.225892246861416e-09) * v24 + 3.4413148480148793e-09) * v24 + -9.933344851449817e-08) * v24 + -5.127541706569233e-07) * v24 + 1.8119768160503268e-06) * v24 + 2.151585040783394e-05) * v24 + 4.61098799999374e-06) * v24
                v79 = v20 / ((((((v62 + -0.000684089638073553) * v24 + -0.002257495580553435) * v24 + 0.016931216930225715) * v24 + 0.17777777777782838) * v24 + 0.6666666666666656) * v24 + 1.0)
                v86 = v23 * (v79 + (1.0 - 2.0 * v79 * v20) * v20) / v19
                v87.append(weight * v86)
            v87 = fsum(v87) * v13
            v92 = E_star / 3.141592653589793 * v87
        else:
            v92 = 0.0
        v97 = v92
    else:
        v97 = nan
    return v97 - sigma_0 * (0.6366197723675814 * atan2(q, v13) if v88 else 1.0 if r < hypot(a, q) else 0.0)


def _pressure(r, a, h, s, E_star, dgamma, sigma_0):
    return _pressure_of(r, a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _displacement_of(r, a, q, h, s, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, h, s) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, h, s, E_star, dgamma, sigma_0):
    return _displacement_of(r, a, _zone(a, h, s, E_star, dgamma, sigma_0), h, s, E_star, dgamma, sigma_0)


def _growth(a, h, s):
    if a > 0.0:
        v5 = a / s
        v9 = v5 * v5
        v47 = ((((((((((((1.567077144036674e-13 * v9 + -3.840375691006307e-12) * v9 + 3.8015754128174666e-11) * v9 + -1.8423006918213799e-10) * v9 + 4.472469827763728e-10) * v9 + -1.1927516362741588e-09) * v9 + 6.225892246861416e-09) * v9 + 3.4413148480148793e-09) * v9 + -9.933344851449817e-08) * v9 + -5.127541706569233e-07) * v9 + 1.8119768160503268e-06) * v9 + 2.151585040783394e-05) * v9 + 4.61098799999374e-06) * v9
        v65 = v5 / ((((((v47 + -0.000684089638073553) * v9 + -0.002257495580553435) * v9 + 0.016931216930225715) * v9 + 0.17777777777782838) * v9 + 0.6666666666666656) * v9 + 1.0)
        return 2.0 * h / s * (v65 + (1.0 - 2.0 * v65 * v5) * v5)
    return 0.0


def _radii(h, s, E_star, dgamma, sigma_0):
    a = np.zeros_like(sigma_0)
    largest = difference_root(1.5019752682686114 * s, a)
    a = zone_within(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)
    first = np.nan if np.isnan(a) else zone_like(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest)
    return radii_on_bump(first, 1.5019752682686114 * s)


def _state(a, start, h, s, E_star, dgamma, sigma_0, control):
    growth = _growth(a, h, s)
    return state_near(partial(_opened, h=h, s=s), growth, start, a, control, E_star, dgamma, sigma_0, difference_root(1.5019752682686114 * s, a))


def _pull_off_radius(h, s, E_star, dgamma, sigma_0, control):
    load = _force_of if control == 'force' else _depth_of
    return radius_of_pull_off(lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, control), lambda a, q: load(a, q, h, s, E_star, dgamma, sigma_0), _radii(h, s, E_star, dgamma, sigma_0))


def _parted(h, s, E_star, dgamma, sigma_0):
    first = _zone(np.zeros_like(sigma_0), h, s, E_star, dgamma, sigma_0)
    return parted(partial(_opened, h=h, s=s), first, E_star, sigma_0)


def _pull_off_zone(a, h, s, E_star, dgamma, sigma_0):
    largest = difference_root(1.5019752682686114 * s, a)
    return either(a > 0.0, lambda: root_of_zone(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, largest), lambda: _parted(h, s, E_star, dgamma, sigma_0) if a == 0.0 else np.nan)


def _pull_off_depth(a, q, h, s, E_star, dgamma, sigma_0):
    return either(a > 0.0, lambda: _depth_of(a, q, h, s, E_star, dgamma, sigma_0), lambda: alone(partial(_opened, h=h, s=s), q, E_star, dgamma, sigma_0))


def _held_apart(d, h, s, E_star, dgamma, sigma_0):
    apart = _pull_off_radius(h, s, E_star, dgamma, sigma_0, 'depth') == 0.0
    deeper = d >= alone(partial(_opened, h=h, s=s), _parted(h, s, E_star, dgamma, sigma_0), E_star, dgamma, sigma_0)
    return 0.0 if apart & deeper else np.nan


def _radius_from_depth(d, h, s, E_star, dgamma, sigma_0):
    a = radius_under(lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, 'depth'), lambda a, q: _depth_of(a, q, h, s, E_star, dgamma, sigma_0), d, _radii(h, s, E_star, dgamma, sigma_0))
    return _held_apart(d, h, s, E_star, dgamma, sigma_0) if np.isnan(a) else a


def _radius_from_force(F, h, s, E_star, dgamma, sigma_0):
    return radius_under(lambda a, start: _state(a, start, h, s, E_star, dgamma, sigma_0, 'force'), lambda a, q: _force_of(a, q, h, s, E_star, dgamma, sigma_0), F, _radii(h, s, E_star, dgamma, sigma_0))
