"""Bodies of axicontact._runtime.graded.punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, pow

from ....._runtime.plain import sqrt, MATH as np

STATIONARY = {'force': (3.0, 1.0,), 'depth': (1.0, -1.0,)}


def punch_stiffness(a, H, k):
    return 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)


def punch_force(d, a, H, k):
    v14 = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
    if v14 > 0.0 and v14 < inf:
        return v14 * d
    return 0.0


def punch_depth(F, a, H, k):
    v14 = 2.0 * H / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)
    if v14 > 0.0 and v14 < inf:
        return F / v14
    return 0.0


def punch_pressure(r, a, H, k):
    if r < a:
        v4 = a - r
        v9 = sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + r))
        return H / 3.141592653589793 * pow(v9, k) / v9
    if r > a:
        return 0.0
    return inf


def punch_displacement(r, a, k):
    """Displacement per depth."""
    from ....._programs.bodies._runtime.graded.displacement import punch_share
    return punch_share(r, a, k) if r > a else 1.0


def graded_retraction(a, H, k, dgamma):
    if a > 0.0:
        return sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k))
    return 0.0


def separation(load, a, H, k):
    v5 = 1.0 + k
    return v5 / 12.566370614359172 * (load / (2.0 * H / v5 * (a * pow(a, k) if a > 0.0 else 0.0))) * (load / a / a)


def held(a, rate, force, k):
    v19 = 2.0 * a * rate * (2.0 / (1.0 + k) * (a * pow(a, k) if a > 0.0 else 0.0)) / (3.0 + k)
    if v19 < inf:
        return v19 - force
    return inf


def stationary(control, k):
    """The number xi of the condition of stationarity."""
    constant, slope = STATIONARY[control]
    return constant + slope * k


def least_steepness(control, H, k, dgamma):
    """The a**((1 + k)/2) g'(a) beyond which the load grows with the contact radius."""
    return stationary(control, k) * np.sqrt(np.pi * dgamma / (2.0 * H))


def tension(r, a, H, k, dgamma):
    v17 = sqrt(6.283185307179586 * dgamma / H) * sqrt(a) * sqrt(pow(a, -k)) if a > 0.0 else 0.0
    if v17 > 0.0:
        if r < a:
            v19 = a - r
            v23 = sqrt((v19 if v19 > 0.0 or v19 != v19 else 0.0) * (a + r))
            v33 = H / 3.141592653589793 * pow(v23, k) / v23
        else:
            v33 = 0.0 if r > a else inf
        return v17 * v33
    return 0.0


def unloading_radius(rate, p, H, k, dgamma, control):
    """Pull-off radius where g'(a) = rate a**(p - 1): there a**((1 + k)/2) g'(a) = xi sqrt(pi dgamma/(2 H))."""
    return (least_steepness(control, H, k, dgamma) / rate) ** (1.0 / (p - (1.0 - k) / 2.0))


def growth_of(rate, geometry, H, k, dgamma, control):
    """Derivative of the depth or the force of the adhesive contact."""

    def growth(a):
        slope = rate(a, *geometry) - stationary(control, k) * graded_retraction(a, H, k, dgamma) / (2.0 * a)
        return slope * punch_stiffness(a, H, k) if control == 'force' else slope
    return growth


def pull_of(H, k, dgamma, control):
    """The part of the depth or the force by adhesion."""

    def pulled(a):
        moved = graded_retraction(a, H, k, dgamma)
        return moved * punch_stiffness(a, H, k) if control == 'force' else moved
    return pulled
