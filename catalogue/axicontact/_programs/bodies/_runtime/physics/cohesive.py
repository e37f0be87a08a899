"""Bodies of axicontact._runtime.physics.cohesive over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import atan2, hypot

from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.inverse import inverse
from ....._runtime.plain import both, integral_in_strip
from ....._runtime.plain import sqrt, MATH as np

CLOSEST = 1e-09
DECAY = 40.0
EMPTY = 0.5707963267948966
EXPONENTS = (0.5, 4.0,)
FALLING = 1.2
NARROW = 0.7
SAME = 1e-13
WITHIN = 0.999999


def outer_radius(q, a):
    return hypot(a, q)


def opening(slope, q, a, nodes):
    """For g' without singularities."""
    return _along(slope, np.hypot(a, q), 0.0, np.arctan2(q, a), nodes)


def _along(slope, c, start, length, nodes):

    def gained(v):
        u = start + v
        cosine = np.cos(u)
        growth = slope(c * cosine)
        return (growth * u * np.sin(u), growth * cosine)
    gap, rate = both(gained, length, 1.0, ((np.inf, nodes),))
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def opening_power(slope, q, a, n):
    """For a g' that is a power n - 1 of t."""
    c = np.hypot(a, q)
    far = q / (a if a > 0.0 else 1.0) if a > 0.0 else np.inf
    end = np.arcsinh(np.minimum(np.arcsinh(far), DECAY / np.minimum(n, FALLING)))

    def gained(v):
        steep = np.sinh(v)
        side, secant = (np.sinh(steep), np.cosh(steep))
        growth = slope(c / secant) / secant * np.cosh(v)
        return (growth * np.arctan(side) * (side / secant), growth / secant)
    gap, rate = both(gained, end)
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def opening_beside(slope, q, a, b):
    """For g' with singularities at b on the imaginary axis, which is next to the end of the path where c is far."""
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    scale = np.arcsinh(b / c)
    last, end = _crowded(angle, np.arctan2(a, q), scale)

    def gained(v):
        u = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        cosine = np.cos(u)
        growth = slope(c * cosine) * scale * np.cosh(last - v)
        return (growth * u * np.sin(u), growth * cosine)
    gap, rate = both(gained, end, NARROW)
    return (2.0 / np.pi * c * gap, 2.0 / np.pi * rate)


def _crowded(angle, rest, scale):
    """Of pi/2 - u = scale sinh(last - v): the last v, at pi/2, and the v of an angle u that leaves a rest to it."""
    x, y = (0.5 * np.pi / scale, rest / scale)
    return (np.arcsinh(x), np.arcsinh(angle / scale * (x + y) / (x * np.sqrt(1.0 + y * y) + y * np.sqrt(1.0 + x * x))))


def opening_below(slope, q, a, R):
    """For g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    reach = difference_root(R, a)
    left = np.sqrt(np.maximum(reach - q, 0.0) * (reach + q))
    scale = np.arcsinh(left / c)
    inside = scale > 0.0
    scale = scale if inside else 1.0
    end = np.arcsinh(angle / scale)

    def gained(v):
        u = scale * np.sinh(v)
        sine, cosine = (np.sin(u), np.cos(u))
        growth = slope(c * cosine, np.hypot(left, c * sine)) * scale * np.cosh(v)
        return (growth * u * sine, growth * cosine)
    gap, rate = both(gained, end, NARROW)
    return (2.0 / np.pi * c * gap if inside else np.inf, 2.0 / np.pi * rate if inside else np.inf)


def opening_tip(slope, q, a, b, nodes):
    """What is below a break at b of g' without singularities there."""
    c, end = (np.hypot(a, q), np.arctan2(q, a))
    outer = np.sqrt(np.maximum(q - difference_root(b, a), 0.0) * (q + difference_root(b, a))) if a < b else q
    start = np.arctan2(outer, b) if a < b else end
    start = np.minimum(start if c > b else 0.0, end)
    start = start if a < b else end
    return _along(lambda t: slope(np.minimum(t, b)), c, start, end - start, nodes)


def opening_beyond(slope, q, a, b):
    """What is beyond it; `slope` takes t and sqrt(t**2 - b**2), in which it is regular but for the imaginary axis."""
    c, inner, short = (np.hypot(a, q), difference_root(a, b), difference_root(b, a))
    outer = np.sqrt(np.maximum(q - short, 0.0) * (q + short)) if a < b else np.hypot(inner, q)
    whole = outer if a < b else q
    holds = whole > 0.0
    outer, whole = (outer if holds else b, whole if holds else b)
    scale = np.arcsinh(b / outer)
    angle = np.arctan2(whole, inner)
    last, end = _crowded(angle, np.arctan2(inner, whole), scale)

    def gained(v):
        turned = 2.0 * scale * np.cosh(last - 0.5 * v) * np.sinh(0.5 * v)
        root, side = (outer * np.cos(turned), outer * np.sin(turned))
        t = np.sqrt(b * b + root * root)
        growth = slope(t, root) * root * scale * np.cosh(last - v)
        return (growth * np.arctan2(side, t) * (side / t), growth / c)
    gap, rate = both(gained, end)
    return (2.0 / np.pi * gap if holds else 0.0, 2.0 / np.pi * rate if holds else 0.0)


def work_of_zone(opened, q, a, E_star, sigma_0):
    """sigma_0 times the gap at c."""
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    gap, _ = opened(q, a)
    return sigma_0 * (gap + 4.0 / np.pi * (sigma_0 / E_star) * q * (angle - q / (c + a)))


def zone_within(opened, a, E_star, dgamma, sigma_0, largest):
    """The radius of a contact; not a number where its zone would reach beyond the largest q of a profile that ends."""
    reached = (largest > 0.0) & (work_of_zone(opened, WITHIN * largest, a, E_star, sigma_0) >= dgamma)
    return a if reached else np.nan


def root_of_zone(opened, a, E_star, dgamma, sigma_0, largest=np.inf):
    """The q at which the gap at c is dgamma/sigma_0."""
    part = 0.25 * np.pi * (dgamma / sigma_0) * (E_star / sigma_0)
    start = 0.5 * part / EMPTY + np.sqrt((0.5 * part / EMPTY) ** 2 + 2.0 * a * part)
    return root_near(opened, start, a, E_star, dgamma, sigma_0, largest)[0]


def root_near(opened, start, a, E_star, dgamma, sigma_0, largest=np.inf):
    """The same from a guess on, and the rate of the gap with c there."""
    load, looked = (4.0 / np.pi * (sigma_0 / E_star), [])

    def curve(q):
        c, angle = (np.hypot(a, q), np.arctan2(q, a))
        gap, rate = opened(q, a)
        looked.append((q, rate))
        short = q / c * (q / (c + a))
        whole = gap + load * q * (angle - q / (c + a))
        return (whole, q / whole * (q / c) * (rate + load * (angle / (q / c) - short)))
    start = np.minimum(start, 0.75 * largest)
    q = inverse(curve, dgamma / sigma_0, start, EXPONENTS, largest, smooth=True)
    last, rate = looked[-1]
    return (q, opened(q, a)[1] if np.any(np.abs(q - last) > SAME * q) else rate)


def sunk(q, E_star, sigma_0):
    return 2.0 * (sigma_0 / E_star) * q


def pull_of_zone(q, a, sigma_0):
    v3 = hypot(a, q)
    return 2.0 * sigma_0 * (v3 * v3 * atan2(q, a) + a * q)


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


def still(rate, a, q, control, E_star, sigma_0):
    """Rate of the gap with c over that at which the load does not change with a: above 1 the load grows.

    What the ring adds to the gap and takes of the load has fallen out; no slope of the profile is left.
    """
    c, angle = (np.hypot(a, q), np.arctan2(q, a))
    level = q / c * (q / (c + a))
    if control == 'force':
        rate, level = (rate * (a / c), level * (a / c) + angle * angle)
    return rate / (4.0 / np.pi * (sigma_0 / E_star) * level)


def alone(opened, c, E_star, dgamma, sigma_0):
    """The depth of surfaces that attract each other up to the radius c without contact."""
    gap, _ = opened(c, np.zeros_like(c))
    return gap - dgamma / sigma_0 - 4.0 / np.pi * (sigma_0 / E_star) * c
