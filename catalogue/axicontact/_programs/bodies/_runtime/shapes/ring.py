"""Bodies of axicontact._runtime.shapes.ring over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._runtime.plain import integral_by_length
from ....._runtime.shapes.ring import GONE, LENGTHS, STEPS
from ....._runtime.plain import MATH as np


def lifted_at_zero_pressure(n, k):
    """n (1 - (r_0/a)**2) - 1 + k, what the depth of a hollow is divided by; next to k = -1 all of that cancels.

    It is n (1 + k)/((n - 2) F) with the hypergeometric F(2 - n/2, 1; (3 + k)/2; 1 - (r_0/a)**2).
    """
    half, length, steep = ((1.0 + k) / 2.0, _log_ratio(n, k), n - 3.0 + k)
    z = -np.expm1(-2.0 * length)

    def integrand(y):
        return np.exp(-steep * length * (1.0 - y)) * (-np.expm1(-2.0 * length * y) / z) ** half
    series = 1.0 - (n - 4.0) * length * _integral(integrand, (n - 1.0) * length)
    return n * (1.0 + k) / ((n - 2.0) * series) if n > 2.0 else n - 1.0 + k


def _log_ratio(n, k):
    """ln(a/r_0) for n > 2, by Newton's method for the logarithm of the balance."""
    n = n if n > 2.0 else 3.0
    length = _start(n - 2.0, k)
    for _ in range(STEPS):
        z, square = (-np.expm1(-2.0 * length), np.exp(-2.0 * np.minimum(length, GONE)))
        lifted = np.maximum(n - 1.0 + k - n * square, 1.0 + k)
        value = _balance(length, n - 2.0, k)
        slope = (1.0 - k) * (1.0 + k) * np.exp((n - 2.0) * length) / (z * lifted)
        slope = slope + (value - 1.0) * (2.0 * (n - 1.0 + k) / lifted - (1.0 + k) / z)
        length = length - np.log(value) * value / slope
    return length


def _balance(length, m, k):
    """The integral as a function of L for m = n - 2, over y with 1 + R s = exp(2 L y)."""
    z = -np.expm1(-2.0 * length)

    def integrand(y):
        inner, outer = (-np.expm1(-2.0 * length * y), -np.expm1(-2.0 * length * (1.0 - y)))
        risen = np.expm1(m * length * y)
        rest = risen - 0.5 * m * (risen + 1.0) * inner * (outer / z)
        return np.exp((1.0 - k) * length * (1.0 - y)) * (inner / z) ** ((k - 1.0) / 2.0) * rest / inner
    return (1.0 - k) * length * _integral(integrand, (m + 1.0) * length)


def _integral(integrand, length):
    """Over 0 < y < 1, for a power of y above zero at its lower end: in the eighth root of y."""

    def rooted(x):
        power = x ** 2 * x
        power = power * power * x
        return 8.0 * power * integrand(power * x)
    return integral_by_length(rooted, np.ones_like(length), 1.0 / length, LENGTHS)


def _start(m, k):
    """(a/r_0)**(1 - k) as 1 + c/m: right for small m, for m = 2, and at both ends of k."""
    small = 4.0 / np.pi * np.sin(np.pi / 2.0 * (1.0 - k)) / (1.0 + k)
    middle = 2.0 * np.expm1(-0.5 * (1.0 - k) * np.log((1.0 - k) / 4.0))
    bend = 0.36 + 0.4 * k
    c = small + (middle - small) * (1.0 + bend) * m / (m + 2.0 * np.maximum(bend, 0.0))
    length = np.log1p(c / m) / (1.0 - k)
    return np.maximum(length, np.log(m * (m + 2.0) / (2.0 * (1.0 - k))) / m) if m < 2.0 else length
