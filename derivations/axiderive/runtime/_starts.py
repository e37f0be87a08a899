"""Where the iterations of the inverses begin: curves joined from what is known of their ends."""

from __future__ import annotations

import numpy as np

from ._elementwise import Array


def between(
    x: Array, small: tuple[float, float], large: tuple[float, float], blend: float, rest: tuple[float, ...]
) -> Array:
    """About the t of a curve known at its ends: ln t where x is the logarithm of the curve over its value at t = 1.

    There t is (exp(x)/c)**(1/e), with c and e for `small` t and for `large`; `blend` is the power of either that
    is summed to q.  In between t is q times a polynomial of q/(1 + q), whose coefficients are the `rest`.
    """
    q = _joined(x, small, large, blend)
    v, factor = 1.0 - 1.0 / (1.0 + q), rest[-1]
    for coefficient in rest[-2::-1]:
        factor = factor * v + coefficient
    return q * factor


def _joined(x: Array, small: tuple[Array, float], large: tuple[Array, float], blend: float) -> Array:
    first, last = (blend / e * (x - np.log(c)) for c, e in (small, large))
    return np.exp((np.maximum(first, last) + np.log1p(np.exp(-np.abs(first - last)))) / blend)


def joining(like: Array, slope: Array, small: float, large: float) -> Array:
    """About the t of a curve over its value at t = 1, less steep for large t than for small, from its slopes."""
    x = np.log(like)
    if small == large:
        return np.exp(x / np.where(x < 0.0, slope, large))
    share = np.minimum(np.maximum((slope - small) / (large - small), 1e-12), 1.0 - 1e-12)
    return _joined(x, (1.0 / (1.0 - share), small), (1.0 / share, large), 0.5 * (small + large))


def leaving_power(like: Array, share: Array, tip: Array | float, small: float, large: float) -> Array:
    """The same where a power of the radius, `share` at t = 1, is left by a sum with powers of t."""
    x, rest = np.log(like), np.maximum(1.0 - share, 1e-300)
    below = _joined(np.minimum(x, 0.0), (share, 2.0), (rest, small), -0.5 * (2.0 + small))
    return np.where(x < 0.0, below, _joined(np.maximum(x, 0.0), (share, tip), (rest, large), -0.5 * (tip + large)))
