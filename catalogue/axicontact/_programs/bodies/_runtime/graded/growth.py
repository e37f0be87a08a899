"""Bodies of axicontact._runtime.graded.growth over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import inf, sinh

from ....._programs.bodies._runtime.graded.rules import nodes_for, raised, sine_mean, sine_over, sinh_over
from ....._runtime.graded.growth import power_factor
from ....._runtime.graded.single import weighted
from ....._runtime.plain import integral_in_strip
from ....._runtime.plain import MATH as np

_LONGEST = 8.0


def axis_power(n, k):
    if n < 0.5:
        return k - 1.0 + n
    return n - 1.0 + k


def power_depth(a, n, k):
    """g(a) of f = r**n."""
    return power_factor(n, k) * a ** n


def power_rate(t, n, k):
    return power_factor(n, k) * n * (t ** n / t)


def power_force(a, n, k):
    return power_factor(n, k) * (n / (n + (1.0 + k))) * a ** n * raised(a, k)


def power_mean(a, n, k):
    """Force over the square of the radius."""
    m = axis_power(n, k)
    power = a ** n / a * a ** k if a > 0.0 else 0.0 if m > 0.0 else np.inf if m < 0.0 else 1.0
    return power_factor(n, k) * (n / (n + (1.0 + k))) * power


def sphere_depth(a, root, k):
    """g(a) of f = R - sqrt(R**2 - r**2); the ellipsoid is the sphere stretched by h/b."""
    open_ = root if root > 0.0 else a
    v = np.arcsinh(a / open_)
    value = a * _steepness(a, open_, v, k) ** k * v * weighted(lambda x: sinh_over(x) ** k, v, k, nodes_for(v))
    return 0.0 if a == 0.0 else value if root > 0.0 else a * _last(k)


def sphere_rate(t, root, k):
    open_ = root if root > 0.0 else t
    v, far = (np.arcsinh(t / open_), np.hypot(t, root) / open_)

    def integrand(x):
        return sinh_over(x) ** k * (1.0 + (far / np.cosh(x)) ** 2)
    first = np.minimum(v, _LONGEST)
    total = (open_ / t * first) ** k * first * weighted(integrand, first, k, nodes_for(first))
    if np.any(v > first):
        rest = integral_in_strip(lambda x: integrand(first + x) * (first + x) ** k, v - first)
        total = total + (open_ / t) ** k * rest
    return total if root > 0.0 else np.inf


def sphere_force(a, root, k):
    open_ = root if root > 0.0 else a
    v = np.arcsinh(a / open_)
    whole = np.sinh(v)

    def integrand(x):
        over = sinh_over(x)
        return over ** k * (1.0 - (over * (x / whole)) ** 2)
    value = a * raised(a, k) * _steepness(a, open_, v, k) ** k * v * weighted(integrand, v, k, nodes_for(v))
    return 0.0 if a == 0.0 else value if root > 0.0 else a * raised(a, k) * 2.0 / (2.0 + k) * _last(k)


def _steepness(a, root, v, k):
    if k > 0.0:
        return v / sinh(v)
    return root / a * v


def _last(k):
    if k > 0.0:
        return 1.0 / k
    return inf


def hyperboloid_depth(a, b, k):
    """g(a) of f = sqrt(r**2 + b**2) - b."""
    angle = np.arctan2(a, b)
    return a * angle * (np.hypot(a, b) / a * angle) ** k * sine_mean(angle, k) if a > 0.0 else 0.0


def hyperboloid_rate(t, b, k):
    c, angle = (np.hypot(t, b), np.arctan2(t, b))
    return angle * (c / t * angle) ** k * sine_mean(angle, k) * (1.0 - k * (b / c) ** 2) + t / c * (b / c)


def hyperboloid_force(a, b, k):
    angle = np.arctan2(a, b)

    def integrand(y):
        return sine_over(y) ** k * np.sin(angle - y) * np.sin(angle + y)
    c = np.hypot(a, b)
    return c * c * angle * (c * angle) ** k * weighted(integrand, angle, k) if a > 0.0 else 0.0


def gaussian_depth(a, s, k):
    """g(a) of f = 1 - exp(-r**2/s**2)."""
    return 2.0 * (a / s) ** 2 * _bell(a, s, k, lambda fall: np.exp(-fall))


def gaussian_rate(t, s, k):
    return 4.0 * t / s / s * _bell(t, s, k, lambda fall: (1.0 - fall) * np.exp(-np.minimum(fall, 700.0)))


def gaussian_force(a, s, k):
    return 2.0 * raised(a, k) * _bell(a, s, k, lambda fall: fall * np.exp(-fall))


def _bell(a, s, k, of):
    """Integral of x**k of(fall) from 0 to 1, where fall = (a/s)**2 (1 - x**2)."""
    square = (a / s) ** 2
    one = np.ones_like(np.asarray(square, dtype=np.float64))
    return weighted(lambda x: of((1.0 - x) * (1.0 + x) * square), one, k)
