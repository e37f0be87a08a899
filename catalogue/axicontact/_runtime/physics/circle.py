"""Surface displacement under a pressure p_0 (1 - r**2/a**2)**s on a circle."""

from __future__ import annotations

import numpy as np

from ..integrals import integral_in_strip
from ..interface import Array, either
from ..special import gamma_ratio

STEPS, SHORTEST = 7, 1e-9
"""Of the means: with six of them the neighbours of the edge lose 44 units; their root is 1.5e-8 of the radius."""


def elliptic(kc: Array, b: Array) -> Array:
    """4/pi times the integral of (cos**2 + b sin**2)/sqrt(cos**2 + kc**2 sin**2) over a quarter turn, by Bulirsch.

    E = pi/4 elliptic(kc, kc**2); (E - kc**2 K)/k**2 = pi/4 elliptic(kc, 0): sums of positive terms.
    """
    kc = np.maximum(kc, SHORTEST)
    product, mean = kc, 1.0 + kc
    last, a, b = 1.0, 1.0 + b, 2.0 * (b + kc)
    for _ in range(STEPS):
        kc = 2.0 * np.sqrt(product)
        product = kc * mean
        last, a = a, a + b / mean
        b = 2.0 * (b + last * kc)
        mean = kc + mean
    return (b + a * mean) / (mean * mean)


def _far(r: Array, a: Array) -> tuple[Array, Array]:
    """The longer length, and the root of 1 - (shorter/longer)**2."""
    far, near = np.maximum(r, a), np.minimum(r, a)
    return far, np.where(far < np.inf, np.sqrt((far - near) / far * ((far + near) / far)), 1.0)


def uniform(r: Array, a: Array) -> Array:
    """w E_star/(p_0 a) for s = 0: one integral on either side of the edge."""
    far, kc = _far(r, a)
    return a / far * elliptic(kc, np.where(r <= a, kc * kc, 0.0))


LAST, STEP = 44.0, 0.23
"""Exponents of e at which a term is nothing, and the step of the sum outside: with 0.27 it loses 190 units."""


def power(r: Array, a: Array, s: Array) -> Array:
    """w E_star/(p_0 a) for any s > -1, as the integral over the circle of (11.105) in the angle psi from the edge."""
    fallen = a / np.maximum(r, a)
    # all else stays in the range of doubles
    r, a, s = np.asarray(r), np.asarray(a), np.asarray(s)
    _, kc = _far(r, a)
    # Gamma(s + 1)/Gamma(s + 3/2)
    strength = 1.0 / gamma_ratio(s + 1.0)
    within, beyond = r < a, r > a
    sides = either(
        within,
        lambda: _inside(np.where(within, r / a, 0.5), np.where(within, kc, 1.0), s + 0.5),
        lambda: np.where(beyond, _outside(np.where(beyond, kc, 1.0), s + 1.0), np.sqrt(np.pi) / 2.0 * strength),
    )
    return fallen * (2.0 / np.sqrt(np.pi) * strength * sides)


def _inside(ratio: Array, kc: Array, exponent: Array) -> Array:
    """Integral of (1 - ratio**2 cos(psi)**2)**exponent over a quarter turn, kc**2 = 1 - ratio**2.

    With tan(psi/2) = least sinh(whole - v) the nearest zeros of the base are pi/2 away from all v.
    """
    least = np.maximum(kc / (1.0 + ratio), SHORTEST)
    whole = np.arcsinh(1.0 / least)
    positive = np.maximum(exponent, 0.0)
    cosine = np.minimum(np.sqrt(-np.expm1(-LAST / positive)) / ratio, 1.0)
    stop = whole - np.arcsinh(np.sqrt((1.0 - cosine) / (1.0 + cosine)) / least)
    scale = 1.0 / np.expm1(-2.0 * whole)

    def places(v: Array) -> tuple[Array, Array, Array]:
        """sin(psi), cos(psi) and dpsi/dv over -2 scale."""
        decay = np.exp(-v)
        turned = decay * np.expm1(2.0 * (v - whole))
        tangent = scale * turned
        share = 1.0 / (1.0 + tangent * tangent)
        # 1 - tangent: as a difference its rounding grows with the root of the exponent, 300 units at 3e5
        rest = scale * (1.0 + decay + turned) * np.expm1(-v)
        return 2.0 * tangent * share, rest * (1.0 + tangent) * share, (2.0 * decay + turned) * share

    def integrand(v: Array) -> Array:
        sine, cosine, stretch = places(v)
        taken = (ratio * cosine) ** 2
        base = sine * sine + (kc * cosine) ** 2
        logarithm = np.where(taken < 0.5, np.log1p(-np.minimum(taken, 0.5)), np.log(base))
        return np.exp(exponent * logarithm) * stretch

    return -2.0 * scale * integral_in_strip(integrand, stop, 1.0 / np.sqrt(1.0 + positive / 4.0))


def _outside(kc: Array, power: Array) -> Array:
    """Sum over equal steps of u, sin(psi) = 1/cosh(u): of sin(psi)**(2 power)/sqrt(1 + kc**2 sinh(u)**2).

    All derivatives vanish at both ends; the nearest singularities are pi/2 away, for large powers less by their width.
    """
    step = STEP / np.sqrt(1.0 + power / 4.0)
    # ln(cosh(u)) of the last term
    last = np.minimum(LAST / (2.0 * power), (LAST - np.log(np.maximum(kc, SHORTEST))) / (1.0 + 2.0 * power))
    count = (last + np.log1p(np.sqrt(-np.expm1(-2.0 * last)))) / step
    total = 0.0
    # the smallest terms first
    for number in range(int(np.ceil(np.max(np.where(np.isfinite(count), count, 0.0)))), 0, -1):
        square = np.sinh(number * step) ** 2
        fallen = np.exp(np.maximum(-power * np.log1p(square), -16.0 * LAST))
        total = total + fallen / np.sqrt(1.0 + kc * kc * square)
    return step * (0.5 + total)
