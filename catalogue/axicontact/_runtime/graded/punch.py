"""The flat punch on the graded half-space, and adhesion as its retraction."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ..integrals import difference_root
from ..interface import Array
from .rules import raised

Rate = Callable[..., Array]
STATIONARY = {"force": (3.0, 1.0), "depth": (1.0, -1.0)}
"""xi = 3 + k under control of the force, 1 - k of the depth: at pull-off the retraction is 2 a g'(a)/xi."""


def punch_stiffness(a: Array, H: Array, k: Array) -> Array:
    """dF/dd of a contact of radius a."""
    return 2.0 * H / (1.0 + k) * raised(a, k)


def punch_force(d: Array, a: Array, H: Array, k: Array) -> Array:
    """Force at a depth, none at the radii zero and infinity."""
    stiffness = punch_stiffness(a, H, k)
    return np.where((stiffness > 0.0) & (stiffness < np.inf), stiffness * d, 0.0)


def punch_depth(F: Array, a: Array, H: Array, k: Array) -> Array:
    """Depth under a force, none at the radii zero and infinity."""
    stiffness = punch_stiffness(a, H, k)
    return np.where((stiffness > 0.0) & (stiffness < np.inf), F / stiffness, 0.0)


def punch_pressure(r: Array, a: Array, H: Array, k: Array) -> Array:
    """Pressure per depth: infinite at the edge, zero outside."""
    root = difference_root(a, r)
    return np.where(r < a, H / np.pi * root**k / root, np.where(r > a, 0.0, np.inf))


def punch_displacement(r: Array, a: Array, k: Array) -> Array:
    """Displacement per depth."""
    from .displacement import punch_share  # a module has more to it than its displacement

    return np.where(r > a, punch_share(r, a, k), 1.0)


def graded_retraction(a: Array, H: Array, k: Array, dgamma: Array) -> Array:
    """sqrt(2 pi dgamma a**(1 - k)/H)."""
    # no power (1 - k)/2, whose rounding 600 decades of radii turn into 200 units of the last place
    return np.where(a > 0.0, np.sqrt(2.0 * np.pi * dgamma / H) * np.sqrt(a) * np.sqrt(a**-k), 0.0)


def separation(load: Array, a: Array, H: Array, k: Array) -> Array:
    """Work of separation of a contact whose force is `load` less than without adhesion."""
    return (1.0 + k) / (4.0 * np.pi) * (load / punch_stiffness(a, H, k)) * (load / a / a)


def held(a: Array, rate: Array, force: Array, k: Array) -> Array:
    """Tension at which a contact of this radius comes off, over the modulus as its `force` without adhesion is."""
    pulled = 2.0 * a * rate * punch_stiffness(a, 1.0, k) / stationary("force", k)
    return np.where(pulled < np.inf, pulled - force, np.inf)


def stationary(control: str, k: Array) -> Array:
    """The number xi of the condition of stationarity."""
    constant, slope = STATIONARY[control]
    return constant + slope * k


def least_steepness(control: str, H: Array, k: Array, dgamma: Array) -> Array:
    """The a**((1 + k)/2) g'(a) beyond which the load grows with the contact radius."""
    return stationary(control, k) * np.sqrt(np.pi * dgamma / (2.0 * H))


def tension(r: Array, a: Array, H: Array, k: Array, dgamma: Array) -> Array:
    """Pressure of the retracted punch."""
    moved = graded_retraction(a, H, k, dgamma)
    return np.where(moved > 0.0, moved * punch_pressure(r, a, H, k), 0.0)


def unloading_radius(rate: Array, p: Array, H: Array, k: Array, dgamma: Array, control: str) -> Array:
    """Pull-off radius where g'(a) = rate a**(p - 1): there a**((1 + k)/2) g'(a) = xi sqrt(pi dgamma/(2 H))."""
    return (least_steepness(control, H, k, dgamma) / rate) ** (1.0 / (p - (1.0 - k) / 2.0))


def growth_of(
    rate: Rate, geometry: tuple[Array, ...], H: Array, k: Array, dgamma: Array, control: str
) -> Callable[[Array], Array]:
    """Derivative of the depth or the force of the adhesive contact."""

    def growth(a: Array) -> Array:
        slope = rate(a, *geometry) - stationary(control, k) * graded_retraction(a, H, k, dgamma) / (2.0 * a)
        return slope * punch_stiffness(a, H, k) if control == "force" else slope

    return growth


def pull_of(H: Array, k: Array, dgamma: Array, control: str) -> Callable[[Array], Array]:
    """The part of the depth or the force by adhesion."""

    def pulled(a: Array) -> Array:
        moved = graded_retraction(a, H, k, dgamma)
        return moved * punch_stiffness(a, H, k) if control == "force" else moved

    return pulled
