"""Bodies of axicontact._runtime.physics.unknowns over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import pow

from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.physics.unknowns import Unknown
from ....._runtime.plain import MATH as np

CLOSEST = 18.3
SETTLED = 1e-09
SHARP = 0.3
STEPS = 12


def radius_itself():
    return Unknown(lambda a: a, lambda x: (x, np.ones_like(x)))


def up_to(R, k=0.0):
    """For a profile that is vertical at R: (1 - exp(-k v))/k with v = artanh(a/R), like the depth near R."""
    k = 1e-30 if np.abs(k) < 1e-30 else k

    def like(v):
        return -np.expm1(-k * v) / k

    def of(a):
        return like(np.minimum(np.arctanh(np.minimum(a / R, 1.0)), CLOSEST))

    def back(x):
        v = -np.log1p(-k * x) / k
        return (R * np.tanh(v), R * np.exp(k * v) / np.cosh(v) ** 2)
    return Unknown(of, back, like(CLOSEST), order=3.0, unit=0.5)


def on_the_bump(s):
    """For f = h (1 - exp(-r**2/s**2)): the share of the height of the bump."""

    def back(x):
        ratio = np.sqrt(-np.log1p(-x))
        return (s * ratio, s / (2.0 * ratio * (1.0 - x)))
    return Unknown(lambda a: -np.expm1(-(a / s) ** 2), back)


def beyond_edge(b, first=1.0, last=1.0):
    """For a load that leaves b as t**first and ends as t**last, t = sqrt(a**2/b**2 - 1)."""
    plain = isinstance(first, float) and first == last == 1.0

    def of(a):
        t = difference_root(a, b) / b
        return t if plain else power_of(t, first, last)

    def back(x):
        t, slope = (x, 1.0) if plain else root_of(x, first, last)
        a = b * np.hypot(1.0, t)
        return (a, a * (t * t / (1.0 + t * t)) / (x * slope))
    return Unknown(of, back, order=3.0 / first, unit=1.0)


def root_of(x, first, last):
    """The t at which x is t**first for small t and t**last for large, and d ln x/d ln t there.

    Joined at t**2 = first/last without a kink; but where the first is near 0 the bend would be sharp, and x is
    t**first (1 + t**2)**((last - first)/2).
    """
    if np.any(first < SHARP):
        return _root_of_product(x, first, last)
    share = first / last
    square = share if x < 1.0 else np.maximum(x, 1.0) ** (2.0 / last) - 1.0 + share
    t = np.sqrt(square) * (np.minimum(x, 1.0) ** (1.0 / first) if x < 1.0 else 1.0)
    return (t, first if x < 1.0 else last * square / (square + 1.0 - share))


def power_of(t, first, last):
    """The x of which `root_of` gives t."""
    if np.any(first < SHARP):
        return _product(t, first, last)
    share = first / last
    low = np.minimum(t / np.sqrt(share), 1.0) ** first
    return low if t * t < share else (np.maximum(t * t - share, 0.0) + 1.0) ** (last / 2.0)


def _product(t, first, last):
    return pow(t, first) * pow(1.0 + t * t, (last - first) / 2.0)


def _root_of_product(x, first, last):
    """Halley's steps in ln t."""
    wanted, gain = (np.log(x), last - first)
    near = 0.5 * np.log(np.expm1(np.minimum(np.maximum(2.0 * wanted / last, 0.0), 600.0)) + first / last)
    log = wanted / first + 0.5 * np.log(first / last) if wanted < 0.0 else near
    log = wanted / last if wanted > 300.0 * last else log
    for _ in range(STEPS):
        share = 1.0 / (1.0 + np.exp(-2.0 * log))
        slope = first + gain * share
        joined = first * log + gain * (np.maximum(log, 0.0) + 0.5 * np.log1p(np.exp(-2.0 * np.abs(log))))
        newton = (wanted - joined) / slope
        step = newton / np.maximum(1.0 + gain * share * (1.0 - share) / slope * newton, 0.3)
        log = log + (step if np.isfinite(step) else 0.0)
        if not np.any(np.abs(step) > SETTLED):
            break
    t, slope = (np.exp(log), first + gain / (1.0 + np.exp(-2.0 * log)))
    missed = x / _product(t, first, last) - 1.0
    return (t * (1.0 + missed / slope if np.abs(missed) < 1e-06 * slope else 1.0), slope)
