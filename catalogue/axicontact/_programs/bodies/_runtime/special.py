"""Bodies of axicontact._runtime.special over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.functions import from_start, rational
from ...._runtime.special import ARCTAN_GAP, DAWSON, GAMMA_RATIO, HANKEL_P_0, HANKEL_P_1, HANKEL_Q_0, HANKEL_Q_1, ROOT_GAP, STRUVE_0, STRUVE_1, STRUVE_TAIL_0, STRUVE_TAIL_1, TANH_GAP, _NEAR, _SWITCH
from ...._runtime.plain import MATH as np


def arctan_gap(x):
    """x - arctan(x) for x >= 0."""
    t = np.minimum(x, 1.0)
    return t * (t * t) * rational(t * t, *ARCTAN_GAP) if x < 1.0 else x - np.arctan(x)


def root_gap(x, y):
    """arctan_gap(sqrt(x**2 - y**2)/y) for x >= y, through their difference: next to x = y it is a cube of the root."""
    q = (x - y) / y
    near, root = (np.minimum(q, _NEAR), np.sqrt((x - y) * (x + y)) / y)
    return near * np.sqrt(near) * rational(near, *ROOT_GAP) if q < _NEAR else root - np.arctan(root)


def tanh_gap(y, x):
    """y - x for x = tanh(y) >= 0; as the cube of x, which may be rounded less often than the angle."""
    t = np.minimum(y, 1.0)
    return x * (x * x) * rational(t * t, *TANH_GAP) if y < 1.0 else y - x


def gamma_ratio(x):
    """Gamma(x + 1/2)/Gamma(x) for x > 0, from that at x + 2."""
    w, below = (x + 1.75, (x + 0.5) * (x + 1.5))
    down = x * (x + 1.0) / below if x < 1.0 else 1.0 - (x + 0.75) / below
    return down * np.sqrt(w) * from_start(1.0 / (w * w), *GAMMA_RATIO)


def dawson(x):
    """Dawson's integral exp(-x**2) int_0^x exp(u**2) du for 0 <= x <= 25/16; a Gaussian bump asks up to 1.502."""
    return x / rational(x * x, *DAWSON)


def struve_h0(x):
    """Struve function H_0(x) for x >= 0."""

    def far(x):
        v = _SWITCH / x * (_SWITCH / x)
        p, q = (rational(v, *HANKEL_P_0), -rational(v, *HANKEL_Q_0) / x)
        return _wave(x, p + q, q - p) + 2.0 / np.pi / x * rational(v, *STRUVE_TAIL_0)
    return _joined(x, lambda x: x * _series(x, STRUVE_0), far)


def struve_h1(x):
    """Struve function H_1(x) for x >= 0."""

    def far(x):
        v = _SWITCH / x * (_SWITCH / x)
        p, q = (rational(v, *HANKEL_P_1), rational(v, *HANKEL_Q_1) / x)
        return _wave(x, q - p, -p - q) + 2.0 / np.pi * rational(v, *STRUVE_TAIL_1)
    return _joined(x, lambda x: x * x * _series(x, STRUVE_1), far)


def _joined(x, near, far):
    return far(np.maximum(x, _SWITCH)) if x >= _SWITCH else near(np.minimum(x, _SWITCH))


def _series(x, kernel):
    """In powers of 16 - x**2, which are all positive."""
    return rational((_SWITCH - x) * (_SWITCH + x), *kernel)


def _wave(x, sine, cosine):
    """Y_nu(x) from the sums and differences of Hankel's P and Q."""
    return (sine * np.sin(x) + cosine * np.cos(x)) / np.sqrt(np.pi * x)
