"""Bodies of axicontact._runtime.graded.punch over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.rules import raised
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.graded.punch import STATIONARY
from ....._runtime.plain import MATH as np


def punch_stiffness(a, H, k):
    """dF/dd of a contact of radius a."""
    return 2.0 * H / (1.0 + k) * raised(a, k)


def punch_force(d, a, H, k):
    """Force at a depth, none at the radii zero and infinity."""
    stiffness = punch_stiffness(a, H, k)
    return stiffness * d if (stiffness > 0.0) & (stiffness < np.inf) else 0.0


def punch_depth(F, a, H, k):
    """Depth under a force, none at the radii zero and infinity."""
    stiffness = punch_stiffness(a, H, k)
    return F / stiffness if (stiffness > 0.0) & (stiffness < np.inf) else 0.0


def punch_pressure(r, a, H, k):
    """Pressure per depth: infinite at the edge, zero outside."""
    root = difference_root(a, r)
    return H / np.pi * root ** k / root if r < a else 0.0 if r > a else np.inf


def punch_displacement(r, a, k):
    """Displacement per depth."""
    from ....._programs.bodies._runtime.graded.displacement import punch_share
    return punch_share(r, a, k) if r > a else 1.0


def graded_retraction(a, H, k, dgamma):
    """sqrt(2 pi dgamma a**(1 - k)/H)."""
    return np.sqrt(2.0 * np.pi * dgamma / H) * np.sqrt(a) * np.sqrt(a ** (-k)) if a > 0.0 else 0.0


def stationary(control, k):
    """The number xi of the condition of stationarity."""
    constant, slope = STATIONARY[control]
    return constant + slope * k


def least_steepness(control, H, k, dgamma):
    """The a**((1 + k)/2) g'(a) beyond which the load grows with the contact radius."""
    return stationary(control, k) * np.sqrt(np.pi * dgamma / (2.0 * H))


def tension(r, a, H, k, dgamma):
    """Pressure of the retracted punch."""
    moved = graded_retraction(a, H, k, dgamma)
    return moved * punch_pressure(r, a, H, k) if moved > 0.0 else 0.0


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
