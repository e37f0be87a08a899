"""Surface displacement under a pressure p_0 (1 - r**2/a**2)**s on a circle."""

from __future__ import annotations

import numpy as np

from ._elementwise import Array
from ._gamma import gamma_quotient
from ._integrals import difference_root, integral


def elliptic(kc: Array, a: float, b: Array) -> Array:
    """Integral of (a cos**2 + b sin**2)/sqrt(cos**2 + kc**2 sin**2) over a quarter turn, by Bulirsch's cel.

    E = elliptic(kc, 1, kc**2); (E - kc**2 K)/k**2 = elliptic(kc, 1, 0): sums of positive terms.
    """
    kc = np.maximum(kc, 1e-160)
    e, m, p = kc, np.ones_like(kc), np.ones_like(kc)
    f, a = a * np.ones_like(kc), a + b * np.ones_like(kc)
    b = 2.0 * (b + f * e)
    p, g, m = e + p, m, kc + m
    for _ in range(13):
        kc = 2.0 * np.sqrt(e)
        e = kc * m
        f, a = a, a + b / p
        g = e / p
        b = 2.0 * (b + f * g)
        p, m = g + p, kc + m
    return np.pi / 2.0 * (b + a * m) / (m * (m + p))


def uniform(r: Array, a: Array) -> Array:
    """w E_star/p_0 for s = 0."""
    inner = np.minimum(r, a)
    kc = difference_root(a, inner) / a
    inside = 4.0 * a / np.pi * elliptic(kc, 1.0, kc * kc)
    ratio = a / np.maximum(r, a)
    outside = 4.0 * a / np.pi * ratio * elliptic(difference_root(np.maximum(r, a), a) / np.maximum(r, a), 1.0, 0.0)
    return np.where(r <= a, inside, outside)


STEP, ENDS = 1.0 / 48.0, 6.3
_t = np.arange(-ENDS, ENDS, STEP)
# psi = pi/2 x, x = 1/(1 + exp(-pi sinh t)): nodes crowd at both ends and psi is exact near 0
_x = 1.0 / (1.0 + np.exp(np.minimum(-np.pi * np.sinh(_t), 700.0)))
_rest = 1.0 / (1.0 + np.exp(np.minimum(np.pi * np.sinh(_t), 700.0)))
PSI, WEIGHTS = np.pi / 2.0 * _x, STEP * np.pi**2 / 2.0 * np.cosh(_t) * _x * _rest


def power(r: Array, a: Array, s: Array) -> Array:
    """w E_star/p_0 for any s > -1, as the integral over the circle of (11.105) in the angle from the edge."""
    # B(1/2, s + 1)
    beta = np.sqrt(np.pi) * gamma_quotient(s + 1.0, s + 1.5)
    scale = 2.0 / np.pi * a * beta
    power = np.asarray(s) + 0.5
    inside, outside = np.zeros_like(r), np.zeros_like(r)
    gap = difference_root(a, np.minimum(r, a)) / a
    beyond = difference_root(np.maximum(r, a), a) / a
    for psi, weight in zip(PSI, WEIGHTS, strict=True):
        sine = np.sin(psi)
        inside = inside + weight * (np.hypot(sine, gap * np.cos(psi))) ** (2.0 * power)
        outside = outside + weight * sine ** (2.0 * power + 1.0) / np.hypot(beyond, sine)
    return scale * np.where(r <= a, inside, outside)


def hertzian(r: Array, a: Array) -> Array:
    """w E_star/p_0 for s = 1/2; outside the arc sine and its root nearly cancel far away."""
    far = np.maximum(r, a)
    root = difference_root(far, a)
    angle = np.arctan2(a, root)
    near = ((2.0 * a * a - far * far) * angle + a * root) / (2.0 * a)
    # with z = sin(angle): angle - z sqrt(1 - z**2) over 2 z**2, as an integral of positive terms
    z = a / far
    gap = integral(lambda x: 2.0 * np.sin(x) ** 2, angle, 16)
    outside = np.where(z > 0.5, near, a * (angle - gap / (2.0 * z * z)))
    return np.where(r > a, outside, np.pi * (2.0 * a * a - r * r) / (4.0 * a))
