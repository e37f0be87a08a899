"""Bodies of axicontact.cohesive.gaussian over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, fsum, hypot, inf, nan

from ...._programs.bodies.normal import gaussian as normal
from ...._programs.bodies._runtime.integrals import difference_root
from ...._programs.bodies._runtime.physics.cohesive import lift_of_zone, opening, outer_radius, root_within
from ....cohesive.gaussian import partial
from ...._runtime.plain import sqrt, rule

RULE_0 = rule(((inf, 32),))


def _opened(q, a, h, s):
    """Gap of the normal contact at c, and its rate with c."""
    return opening(lambda t: normal._slope(t, h, s), q, a)


def _zone(a, h, s, E_star, dgamma, sigma_0):
    """sqrt(c**2 - a**2) of the zone."""
    return root_within(partial(_opened, h=h, s=s), a, E_star, dgamma, sigma_0, difference_root(1.5019752682686114 * s, a))


def _cohesive_radius(a, h, s, E_star, dgamma, sigma_0):
    return outer_radius(_zone(a, h, s, E_star, dgamma, sigma_0), a)


def _pressure_of(r, q, a, h, s, E_star, dgamma, sigma_0):
    v8 = a - r
    v13 = sqrt((v8 if v8 > 0.0 or v8 != v8 else 0.0) * (a + r))
    v88 = r < a
    if a <= 1.5019752682686114 * s:
        if v88:
            v16 = r * r
            v23 = 2.0 * h / s
            v87 = []
            for node, weight in RULE_0(v13 / 1.0):
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
    return _pressure_of(r, _zone(a, h, s, E_star, dgamma, sigma_0), a, h, s, E_star, dgamma, sigma_0)


def _displacement_of(r, q, a, h, s, E_star, dgamma, sigma_0):
    return normal._displacement(r, a, h, s) - lift_of_zone(r, q, a, E_star, sigma_0)


def _displacement(r, a, h, s, E_star, dgamma, sigma_0):
    return _displacement_of(r, _zone(a, h, s, E_star, dgamma, sigma_0), a, h, s, E_star, dgamma, sigma_0)
