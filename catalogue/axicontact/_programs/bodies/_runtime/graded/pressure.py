"""Bodies of axicontact._runtime.graded.pressure over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import axis_power
from ....._programs.bodies._runtime.graded.rules import nodes_for, raised, sinh_over
from ....._programs.bodies._runtime.integrals import difference_root
from ....._runtime.graded.pressure import NODES, _EVEN, _NEAREST, _PANEL, _TERMS, power_factor
from ....._runtime.graded.single import weighted
from ....._runtime.plain import integral, integral_in_strip
from ....._runtime.plain import MATH as np


def growth_beyond(slope, r, a, b, k, order=0.0):
    """The integral from max(r, b) on for a profile with a corner at b.

    `slope` takes t and sqrt(t**2 - b**2) and returns g'(t) (sqrt(t**2 - b**2)/t)**(1 - k), which is finite there
    and begins with the power `order` of the root.
    """
    within, scale, reach = _branches(r, a, b, order + 2.0 * k, r - b, a - b)

    def smooth(near, far):
        root = near if within else far
        t = np.hypot(b, root)
        return slope(t, root) * (far / t) ** k
    value = _from_branch(smooth, scale, reach, k) if reach > 0.0 else 0.0
    at = (r == b) & (reach > 0.0)
    return (growth_from_break(slope, reach if at else b, b, k, order) if at else value) if np.any(at) else value


def growth_from_break(slope, reach, b, k, order):
    """The same for r = b, of positive 2 k + `order`, up to the distance `reach`: both branch points are one."""
    above = 2.0 * k + order if 2.0 * k + order > 0.0 else 1.0

    def smooth(near, far):
        root = np.maximum(near, _NEAREST * b)
        return slope(far, root) * far ** (1.0 - k) / root ** order
    return _from_branch(smooth, b, reach, above - 1.0, above)


def _branches(r, a, b, power, near, far):
    """On which side of the break, the distance of the two branch points r and b, and of the edge to the outer one.

    `near` and `far` are r - b and a - b.

    Where r is b as far as b is known the distance is so small that nothing is left of the power of it by which the
    value differs, nor of its square; the next double is as near as 1e-8.
    """
    within = near < 0.0
    reach = np.sqrt(np.maximum(far, 0.0) * (a + b)) if within else difference_root(a, r)
    least = np.minimum(b, reach) * np.exp(-37.0 / np.minimum(np.maximum(power, 0.107), 2.0))
    return (within, least if near == 0.0 else np.sqrt(np.abs(near) * (r + b)), reach)


def _from_branch(smooth, scale, reach, k, above=None):
    """Integral of y**k smooth(y, far) dy/far from y = 0 to `reach`, with far = sqrt(scale**2 + y**2).

    `above` is 1 + k, as in the rule of the weight.
    """
    first, start = _panel(scale, reach, _PANEL)

    def weighed(v):
        return smooth(scale * np.sinh(v), scale * np.cosh(v)) * sinh_over(v) ** k
    near = weighted(weighed, first, k, nodes_for(first), above)
    rest = growth_far(lambda y, far: y ** k * smooth(y, far), start, reach, scale)
    return scale ** k * (raised(first, k) * near) + rest


def _panel(scale, reach, longest):
    """The length of the first panel in arcsinh(y/scale), and the y where the rest starts, `reach` if there is none."""
    whole = np.arcsinh(reach / scale)
    first = np.minimum(whole, longest)
    return (first, scale * np.sinh(first) if first < whole else reach)


def growth_far(integrand, start, reach, scale):
    """Integral of integrand(y, far) dy/far from y = start on, in ln y, where both branch points are one.

    Counted from either end up to the middle: in a length that counts decades an error is one of every power of it.
    """
    long = reach > start
    if not np.any(long):
        return np.zeros_like(start)
    half = np.log(np.sqrt(reach) / np.sqrt(start if long else 1.0)) if long else 0.0

    def along(y):
        far = np.hypot(scale, y)
        return integrand(y, far) * (y / far)
    rising = integral_in_strip(lambda x: along(start * np.exp(x)), half)
    return rising + integral_in_strip(lambda x: along(reach * np.exp(-x)), half)


def power_pressure(r, a, n, k):
    """The integral for f = r**n."""
    return power_factor(n, k) * n * (a ** n / a * a ** k) * power_growth(r, a, n, k)


def rim_pressure(r, a, b, k):
    """The integral for f' = r beyond b."""

    def slope(t, root):
        return t * ((1.0 - k) / (1.0 + k) * (root / t) ** 2 + 1.0)
    return _cornered(growth_beyond(slope, r, a, b, k), r, a, b, k)


def _cornered(value, r, a, b, k):
    """The pressure at a corner, which is finite for k > 0 only."""
    return np.inf if (r == b) & (a > b) & (k <= 0.0) else value


def power_growth(r, a, n, k):
    """The integral for g'(t) = t**(n - 1), over a**(n + k - 1)."""
    if isinstance(n, int | float) and n % 2.0 == 0.0 and (n <= _EVEN):
        return _even_growth(r, a, int(n), k)
    m = axis_power(n, k)
    length = np.log1p((a - r) / r)
    length = length if np.isfinite(length) else np.log(a) - np.log(r)
    near = np.minimum(np.minimum(length, 1.0), 20.0 / np.maximum(np.abs(m), 1e-300))
    half, above = ((k - 1.0) / 2.0, (k + 1.0) / 2.0)

    def smooth(x):
        shrink = -np.expm1(-2.0 * x) / (x if x > 0.0 else 1.0) if x > 0.0 else 2.0
        return shrink ** half * np.exp(-m * (near - x))
    rest = length - near
    place = np.minimum(r / a * np.exp(near), 1.0)
    far = place ** n / place * place ** k
    first = (far if rest > 0.0 else 1.0) * near ** above
    first = first * weighted(smooth, near, half, above=above)
    total = first + (_steep(rest, near, m, half) if np.abs(m) > 20.0 else _tail(rest, near, m, half, far))
    return total if r > 0.0 else 1.0 / (m if m > 0.0 else 1.0) if m > 0.0 else np.inf


def _even_growth(r, a, n, k):
    """By parts in t**2 - r**2: every step adds what is positive."""
    half, square = ((1.0 + k) / 2.0, (r / a) ** 2)
    total = 0.5 / half
    for j in range(1, n // 2):
        total = (0.5 + j * square * total) / (j + half)
    share = (a - r) / a * ((a + r) / a)
    return np.sqrt(share) * share ** (k / 2.0) * total


def _tail(rest, near, m, half, far):
    """What lies beyond ln(t/r) = `near` = 1: the binomial series in exp(-2 x), whose terms are positive.

    `far` is exp(-m rest), where the logarithm of a ratio far from 1 would cost its number of digits.
    """
    rest = rest if np.isfinite(rest) else 0.0
    factor, total = (np.ones_like(rest + half), np.zeros_like(rest + half))
    for j in range(_TERMS):
        rate = m - 2.0 * j
        span = rest if rate == 0.0 else -np.expm1(-np.abs(rate) * rest) / (1.0 if rate == 0.0 else np.abs(rate))
        level = np.exp(-2.0 * j * (near + rest)) if rate > 0.0 else np.exp(-2.0 * j * near) * far
        total = total + factor * span * level
        factor = factor * (j - half) / (j + 1.0)
    return total


def _steep(rest, near, m, half):
    """What lies beyond ln(t/r) = `near`, for a large power m, of which only the upper end counts."""
    rest = rest if np.isfinite(rest) else np.inf
    stop = np.minimum(rest, 42.0 / np.maximum(np.abs(m), 20.0))

    def integrand(y):
        return np.exp(-m * y) * (-np.expm1(-2.0 * (near + (rest - y)))) ** half
    return integral(integrand, stop, NODES)
