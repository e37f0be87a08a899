"""Bodies of axicontact.normal.paraboloid over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import cbrt

from ...._runtime.plain import sqrt


def _depth(a, R):
    return a * a / R


def _force(a, R, E_star):
    return 4.0 * E_star / (3.0 * R) * (a * (a * a))


def _displacement(r, a, R):
    v4 = a * a
    if r > a:
        v14 = a / (r + sqrt((r - a) * (r + a)))
        v16 = v14 * v14
        return 2.0 * v4 / (3.141592653589793 * R) * (a / r * (0.6666666666666666 + v16 * (((((((((-0.7327347664453868 * v16 + -32.15553480435792) * v16 + -332.23363563146734) * v16 + -1070.7082873491413) * v16 + -85.27694715374247) * v16 + 5044.821368830373) * v16 + 8082.413158212496) * v16 + 3759.725330928701) * v16 + 0.26666666666720995) / ((((((((0.21387262524856868 * v16 + 32.12935731379798) * v16 + 746.8124983579742) * v16 + 6202.125133759036) * v16 + 23553.080984642995) * v16 + 44404.005348491315) * v16 + 40380.01430284195) * v16 + 14099.684276696918) * v16 + 1.0))))
    return v4 / R - r * r / (2.0 * R)


def _radius_from_depth(d, R):
    return sqrt(R * d)


def _radius_from_force(F, R, E_star):
    return cbrt(3.0 * R / (4.0 * E_star) * F)


def _force_from_depth(d, R, E_star):
    return 4.0 * E_star / 3.0 * d * sqrt(R * d)
