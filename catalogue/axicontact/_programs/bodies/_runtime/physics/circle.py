"""Bodies of axicontact._runtime.physics.circle over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf

from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.special import gamma_ratio
from ....._runtime.plain import integral_in_strip
from ....._runtime.plain import sqrt, MATH as np

LAST = 44.0
SHORTEST = 1e-09
STEP = 0.23


def elliptic(kc, b):
    v3 = kc if kc > 1e-09 or kc != kc else 1e-09
    v5 = 1.0 + v3
    v6 = 1.0 + b
    v9 = 2.0 * (b + v3)
    v11 = 2.0 * sqrt(v3)
    v14 = v6 + v9 / v5
    v17 = 2.0 * (v9 + v6 * v11)
    v18 = v11 + v5
    v20 = 2.0 * sqrt(v11 * v5)
    v23 = v14 + v17 / v18
    v26 = 2.0 * (v17 + v14 * v20)
    v27 = v20 + v18
    v29 = 2.0 * sqrt(v20 * v18)
    v32 = v23 + v26 / v27
    v35 = 2.0 * (v26 + v23 * v29)
    v36 = v29 + v27
    v38 = 2.0 * sqrt(v29 * v27)
    v41 = v32 + v35 / v36
    v44 = 2.0 * (v35 + v32 * v38)
    v45 = v38 + v36
    v47 = 2.0 * sqrt(v38 * v36)
    v50 = v41 + v44 / v45
    v53 = 2.0 * (v44 + v41 * v47)
    v54 = v47 + v45
    v56 = 2.0 * sqrt(v47 * v45)
    v59 = v50 + v53 / v54
    v62 = 2.0 * (v53 + v50 * v56)
    v63 = v56 + v54
    v65 = 2.0 * sqrt(v56 * v54)
    v72 = v65 + v63
    return (2.0 * (v62 + v59 * v65) + (v59 + v62 / v63) * v72) / (v72 * v72)


def _far(r, a):
    v2 = r if r > a or r != r else a
    if v2 < inf:
        v3 = r if r < a or r != r else a
        v13 = sqrt((v2 - v3) / v2 * ((v2 + v3) / v2))
    else:
        v13 = 1.0
    return (v2, v13)


def power(r, a, s):
    """w E_star/(p_0 a) for any s > -1, as the integral over the circle of (11.105) in the angle psi from the edge."""
    fallen = a / np.maximum(r, a)
    r, a, s = (np.asarray(r), np.asarray(a), np.asarray(s))
    _, kc = _far(r, a)
    strength = 1.0 / gamma_ratio(s + 1.0)
    within, beyond = (r < a, r > a)
    sides = either(within, lambda: _inside(r / a if within else 0.5, kc if within else 1.0, s + 0.5), lambda: _outside(kc if beyond else 1.0, s + 1.0) if beyond else np.sqrt(np.pi) / 2.0 * strength)
    return fallen * (2.0 / np.sqrt(np.pi) * strength * sides)


def _inside(ratio, kc, exponent):
    """Integral of (1 - ratio**2 cos(psi)**2)**exponent over a quarter turn, kc**2 = 1 - ratio**2.

    With tan(psi/2) = least sinh(whole - v) the nearest zeros of the base are pi/2 away from all v.
    """
    least = np.maximum(kc / (1.0 + ratio), SHORTEST)
    whole = np.arcsinh(1.0 / least)
    positive = np.maximum(exponent, 0.0)
    cosine = np.minimum(np.sqrt(-np.expm1(-LAST / positive)) / ratio, 1.0)
    stop = whole - np.arcsinh(np.sqrt((1.0 - cosine) / (1.0 + cosine)) / least)
    scale = 1.0 / np.expm1(-2.0 * whole)

    def places(v):
        """sin(psi), cos(psi) and dpsi/dv over -2 scale."""
        decay = np.exp(-v)
        turned = decay * np.expm1(2.0 * (v - whole))
        tangent = scale * turned
        share = 1.0 / (1.0 + tangent * tangent)
        rest = scale * (1.0 + decay + turned) * np.expm1(-v)
        return (2.0 * tangent * share, rest * (1.0 + tangent) * share, (2.0 * decay + turned) * share)

    def integrand(v):
        sine, cosine, stretch = places(v)
        taken = (ratio * cosine) ** 2
        base = sine * sine + (kc * cosine) ** 2
        logarithm = np.log1p(-np.minimum(taken, 0.5)) if taken < 0.5 else np.log(base)
        return np.exp(exponent * logarithm) * stretch
    return -2.0 * scale * integral_in_strip(integrand, stop, 1.0 / np.sqrt(1.0 + positive / 4.0))


def _outside(kc, power):
    """Sum over equal steps of u, sin(psi) = 1/cosh(u): of sin(psi)**(2 power)/sqrt(1 + kc**2 sinh(u)**2).

    All derivatives vanish at both ends; the nearest singularities are pi/2 away, for large powers less by their width.
    """
    step = STEP / np.sqrt(1.0 + power / 4.0)
    last = np.minimum(LAST / (2.0 * power), (LAST - np.log(np.maximum(kc, SHORTEST))) / (1.0 + 2.0 * power))
    count = (last + np.log1p(np.sqrt(-np.expm1(-2.0 * last)))) / step
    total = 0.0
    for number in range(int(np.ceil(np.max(count if np.isfinite(count) else 0.0))), 0, -1):
        square = np.sinh(number * step) ** 2
        fallen = np.exp(np.maximum(-power * np.log1p(square), -16.0 * LAST))
        total = total + fallen / np.sqrt(1.0 + kc * kc * square)
    return step * (0.5 + total)
