"""Bodies of axicontact._runtime.physics.cohesive over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.inverse import inverse
from ....._runtime.plain import integral, integral_in_strip
from ....._runtime.plain import sqrt, MATH as np

CLOSEST = 1e-09
DECAY = 40.0
EMPTY = 0.5707963267948966
EXPONENTS = (0.5, 4.0,)
NARROW = 0.7
NODES = 32
TIP = 64
WITHIN = 0.999999


def outer_radius(q, a):
    return hypot(a, q)


def opening(slope, q, a):
    """For g' without singularities."""
    c, end = (np.hypot(a, q), np.arctan2(q, a))
    gap = integral(lambda u: slope(c * np.cos(u)) * u * np.sin(u), end, NODES)
    rate = integral(lambda u: slope(c * np.cos(u)) * np.cos(u), end, NODES)
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def opening_power(slope, q, a, n):
    """For g' with singularities on the imaginary axis and at t = 0 only, where it falls as the power n - 1 of t."""
    c = np.hypot(a, q)
    far = q / (a if a > 0.0 else 1.0) if a > 0.0 else np.inf
    end = np.minimum(np.arcsinh(far), DECAY / np.minimum(n, 1.0))

    def gained(v):
        side, secant = (np.sinh(v), np.cosh(v))
        return slope(c / secant) * np.arctan(side) * (side / secant) / secant

    def grown(v):
        secant = np.cosh(v)
        return slope(c / secant) / secant / secant
    return (2.0 / np.pi * c * integral_in_strip(gained, end), 2.0 / np.pi * integral_in_strip(grown, end))


def opening_below(slope, q, a, R):
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    reach = difference_root(R, a)
    left = np.sqrt(np.maximum(reach - q, 0.0) * (reach + q))
    scale = np.arcsinh(left / c)
    inside = scale > 0.0
    scale = scale if inside else 1.0
    end = np.arcsinh(angle / scale)

    def place(v):
        u = scale * np.sinh(v)
        rate = slope(c * np.cos(u), np.hypot(left, c * np.sin(u)))
        return (u, rate * scale * np.cosh(v), np.cos(u))

    def gained(v):
        u, weight, _ = place(v)
        return weight * u * np.sin(u)

    def grown(v):
        _, weight, cosine = place(v)
        return weight * cosine
    gap = 2.0 / np.pi * c * integral_in_strip(gained, end, NARROW)
    rate = 2.0 / np.pi * integral_in_strip(grown, end, NARROW)
    return (gap if inside else np.inf, rate if inside else np.inf)


def opening_tip(slope, q, a, b):
    """What is below a break at b of g' without singularities there."""
    c, end = (np.hypot(a, q), np.arctan2(q, a))
    outer = np.sqrt(np.maximum(q - difference_root(b, a), 0.0) * (q + difference_root(b, a))) if a < b else q
    start = np.arctan2(outer, b) if a < b else end
    start = np.minimum(start if c > b else 0.0, end)
    start = start if a < b else end
    gap = integral(lambda u: slope(c * np.cos(start + u)) * (start + u) * np.sin(start + u), end - start, TIP)
    rate = integral(lambda u: slope(c * np.cos(start + u)) * np.cos(start + u), end - start, TIP)
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def opening_beyond(slope, q, a, b):
    """What is beyond it; `slope` takes t and sqrt(t**2 - b**2), in which it is regular but for the imaginary axis."""
    c, inner, short = (np.hypot(a, q), difference_root(a, b), difference_root(b, a))
    outer = np.sqrt(np.maximum(q - short, 0.0) * (q + short)) if a < b else np.hypot(inner, q)
    whole = outer if a < b else q
    holds = whole > 0.0
    outer, whole = (outer if holds else b, whole if holds else b)
    scale = np.arcsinh(b / outer)
    angle = np.arctan2(whole, inner)
    x, y = (0.5 * np.pi / scale, np.arctan2(inner, whole) / scale)
    last = np.arcsinh(x)
    end = np.arcsinh(angle / scale * (x + y) / (x * np.sqrt(1.0 + y * y) + y * np.sqrt(1.0 + x * x)))

    def place(v):
        turned = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        root, side = (outer * np.cos(turned), outer * np.sin(turned))
        t = np.sqrt(b * b + root * root)
        return (t, root, side, slope(t, root), scale * np.cosh(last - v))

    def gained(v):
        t, root, side, rate, weight = place(v)
        return rate * np.arctan2(side, t) * side * (root / t) * weight

    def grown(v):
        _, root, _, rate, weight = place(v)
        return rate * (root / c) * weight
    gap = 2.0 / np.pi * integral_in_strip(gained, end)
    rate = 2.0 / np.pi * integral_in_strip(grown, end)
    return (gap if holds else 0.0, rate if holds else 0.0)


def work_of_zone(opened, q, a, E_star, sigma_0):
    """sigma_0 times the gap at c."""
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    gap, _ = opened(q, a)
    return sigma_0 * (gap + 4.0 / np.pi * (sigma_0 / E_star) * q * (angle - q / (c + a)))


def root_within(opened, a, E_star, dgamma, sigma_0, largest):
    """The root of a profile that ends; not a number where the zone would reach beyond the largest q."""
    reached = work_of_zone(opened, WITHIN * largest, a, E_star, sigma_0) >= dgamma
    return root_of_zone(opened, a, E_star, dgamma if reached else np.nan, sigma_0, largest)


def root_of_zone(opened, a, E_star, dgamma, sigma_0, largest=np.inf):
    """The q at which the gap at c is dgamma/sigma_0."""
    wanted, load = (dgamma / sigma_0, 4.0 / np.pi * (sigma_0 / E_star))

    def curve(q):
        c, angle = (np.hypot(a, q), np.arctan2(q, a))
        gap, rate = opened(q, a)
        short = q / c * (q / (c + a))
        whole = gap + load * q * (angle - q / (c + a))
        return (whole, q / whole * (q / c) * (rate + load * (angle / (q / c) - short)))
    part = wanted / load
    start = 0.5 * part / EMPTY + np.sqrt((0.5 * part / EMPTY) ** 2 + 2.0 * a * part)
    return inverse(curve, wanted, np.minimum(start, 0.75 * largest), EXPONENTS, largest, smooth=True)


def sunk(q, E_star, sigma_0):
    return 2.0 * (sigma_0 / E_star) * q


def tension_of_zone(r, q, a, sigma_0):
    if r < a:
        v4 = a - r
        v18 = 0.6366197723675814 * atan2(q, sqrt((v4 if v4 > 0.0 or v4 != v4 else 0.0) * (a + r)))
    else:
        v18 = 1.0 if r < hypot(a, q) else 0.0
    return sigma_0 * v18


def lift_of_zone(r, q, a, E_star, sigma_0):
    """What it takes of the displacement: as far as the load reaches, sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a on."""
    c, place = (np.hypot(a, q), np.maximum(r, a))
    wide = difference_root(place, a)
    within = place < c
    near, far = (np.minimum(place, c), np.maximum(place, c))
    reach = wide if within else q
    kc = difference_root(far, near) / far
    held = np.arctan2(a, wide) if place > a else 0.5 * np.pi
    end = np.arctan2(reach, a)
    ring = _ring(near, far, kc, end, within)
    return 4.0 / np.pi * (sigma_0 / E_star) * (q * held + ring)


def _ring(near, far, kc, end, within):
    """Integral of sqrt(c**2 - x**2)/sqrt(r**2 - x**2) from a to the nearer of c and r.

    With x = near cos(u) the longer root is far sqrt(kc**2 + (near/far)**2 sin(u)**2): next to the edge of the ring that
    is a small number beside the sine, and in u = kc sinh(v) regular.
    """
    ratio = near / far
    scale = np.maximum(kc, CLOSEST)
    last = np.arcsinh(end / scale)

    def rate(v):
        u = scale * np.sinh(v)
        sine = np.sin(u)
        root = np.hypot(kc, ratio * sine)
        return (far * root if within else near * (sine / root) * (sine * ratio)) * scale * np.cosh(v)
    return integral_in_strip(rate, last, NARROW)


def alone(opened, c, E_star, dgamma, sigma_0):
    """The depth of surfaces that attract each other up to the radius c without contact."""
    gap, _ = opened(c, np.zeros_like(c))
    return gap - dgamma / sigma_0 - 4.0 / np.pi * (sigma_0 / E_star) * c
