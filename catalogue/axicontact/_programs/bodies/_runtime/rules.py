"""Bodies of axicontact._runtime.rules over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ...._programs.bodies._runtime.integrals import difference_root, of_pressure
from ...._runtime.plain import in_groups, integral_in_strip, over_radii
from ...._runtime.plain import MATH as np

WAVES = ((0.25, 8,), (1.97, 16,), (4.7, 24,), (7.96, 32,), (23.3, 64,),)


def pressure_integral_waves(slope, r, a, wavelength):
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, where g' oscillates with a wavelength."""

    def integrand(u):
        t = np.sqrt(r * r + u * u)
        return slope(t) / t
    return integral_in_strip(integrand, difference_root(a, r), wavelength, WAVES)


def falling(stop, even=0.0):
    """sinh(stop - v)/sinh(stop) as a function of v, or the same of cosh where `even` is 1.

    Counted from the upper end, where the integrands are largest: an error of v in exp(v) would grow with v.
    """
    side = 1.0 - 2.0 * even
    below = 2.0 * even - side * np.expm1(-2.0 * stop)
    below = below if below > 0.0 else np.inf

    def fallen(v):
        return np.exp(-v) * (2.0 * even - side * np.expm1(-2.0 * (stop - v))) / below
    return fallen


@in_groups
def pressure_integral_tanh(slope, r, a, R):
    """Integral of g'(t)/sqrt(t**2 - r**2) from r to a, g' singular at t = R; `slope` takes t and sqrt(R**2 - t**2)."""
    scale = difference_root(R, r)
    ratio = difference_root(a, r) / difference_root(R, a)
    stop = np.arcsinh(ratio)
    fallen = falling(stop)

    def integrand(v):
        side = ratio * fallen(v)
        secant = np.sqrt(1.0 + side * side)
        u, root = (scale * (side / secant), scale / secant)
        t = np.sqrt(r * r + u * u)
        return slope(t, root) / t * (root / secant)
    return (integrand, stop, 1.0, a < R, np.inf)


@over_radii(of_pressure)
@in_groups
def pressure_integral_beyond(slope, r, a, b):
    """Integral of g'(t)/sqrt(t**2 - r**2) from max(r, b) to a > b; `slope` takes t and sqrt(t**2 - b**2)."""
    r = np.nextafter(b, np.inf) if r == b else r
    within = r < b
    outside, reach = (0.0 if within else 1.0, difference_root(a, b))
    stop = np.arcsinh((reach if within else difference_root(a, r)) / np.sqrt(np.abs(r - b) * (r + b)))
    fallen = falling(stop, outside)

    def integrand(v):
        root = reach * fallen(v)
        t = np.sqrt(b * b + root * root)
        return slope(t, root) * root / t
    return (integrand, stop, 1.0, a > np.maximum(r, b), 0.0)


def displacement_integral_waves(slope, r, a, wavelength):
    """Integral of g'(t) arcsin(t/r) from 0 to a < r, where g' oscillates with a wavelength."""

    def integrand(angle):
        return slope(r * np.sin(angle)) * angle * np.cos(angle)
    width = wavelength / (r + wavelength / 2.0)
    return r * integral_in_strip(integrand, np.arctan2(a, difference_root(r, a)), width, WAVES)
