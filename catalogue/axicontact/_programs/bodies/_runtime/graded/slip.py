"""Bodies of axicontact._runtime.graded.slip over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.graded.growth import power_depth, power_force
from ....._programs.bodies._runtime.graded.rules import raised
from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.interface import either
from ....._programs.bodies._runtime.physics.slip import gained_share
from ....._runtime.graded.growth import power_factor
from ....._runtime.plain import integral_by_panels, integral_in_strip
from ....._runtime.plain import log1p, MATH as np

CLOSE = 0.25
DECAY = 42.0
NODES = 64
PANEL = 9.0


def power_gain(quantity, r, c, a, n, k):
    """For f = r**n."""
    if quantity == 'depth':
        return power_depth(a, n, k) * gained_share(c, a, n)
    if quantity == 'force':
        return power_force(a, n, k) * gained_share(c, a, n + (1.0 + k))
    return power_factor(n, k) * n * _power_growth(r, c, a, n, k)


def _power_growth(r, c, a, n, k):
    """The integral of t**(n - 1) (t**2 - r**2)**((k - 1)/2), from the end where it is larger far from r."""
    inner, outer = (difference_root(c, r), difference_root(a, r))
    falls = n + (k - 1.0) >= 0.0
    end = a if falls else c
    start = outer if falls else inner
    side = 1.0 - 2.0 * falls
    lost = (a / outer) ** 2 * -np.expm1(-2.0 * DECAY / np.maximum(n - 2.0, 0.001))
    cut = -0.5 * np.log1p(-np.minimum(lost, 1.0 - 1e-16))
    last = cut if (n > 2.0) & (lost < 1.0) else np.inf
    stop = np.minimum(_span(c, a, inner), last)

    def integrand(w):
        distance = start * np.exp(side * w)
        base = r * r + distance * distance if falls else c * c
        change = 0.5 * np.log1p(start * start * np.abs(np.expm1(2.0 * side * w)) / base)
        return np.exp(side * ((n - 2.0) * change + (1.0 + k) * w))
    within = integral_by_panels(integrand, stop, PANEL * np.ones_like(stop), NODES)
    return end ** n / end / end * raised(start, k) * within


def beyond_gain(quantity, whole, rate, lengths, r, c, a, k):
    """For g' that begins at the break with a power of the distance to it."""
    b, = lengths
    close = _close(np.maximum(r, b), c, a)
    return either(close, lambda: _grown(quantity, lambda t, root: rate(t, root, *lengths, k), r, c, a, b, k, close), lambda: _difference(quantity, whole, lengths, b, r, c, a, k))


def _close(m, c, a):
    """Where most of what is there at a was there at c, counted from the branch point m."""
    inner = difference_root(c, m)
    return (inner > 0.0) & (inner >= CLOSE * difference_root(a, m))


def _difference(quantity, whole, lengths, b, r, c, a, k):
    if quantity == 'pressure':
        return whole(r, a, *lengths, k) - whole(r, c, *lengths, k)
    return whole(a, difference_root(a, b), *lengths, k) - whole(c, difference_root(c, b), *lengths, k)


def _weight(quantity, t, y, k):
    if quantity == 'depth':
        return 1.0
    return t * t ** k if quantity == 'force' else y ** k / y


def _span(c, a, distance):
    if a > c:
        return 0.5 * log1p((a - c) / distance * ((a + c) / distance))
    return 0.0


def _grown(quantity, rate, r, c, a, b, k, close):
    """The integral from c to a for rate(t, sqrt(t**2 - b**2)), where c is beyond r and b."""
    branch = np.maximum(r, b)
    start = difference_root(c, branch)

    def integrand(w):
        distance = start * np.exp(w)
        t, root, y = (np.sqrt((branch - x) * (branch + x) + distance * distance) for x in (0.0, b, r))
        return rate(t, root) * _weight(quantity, t, y, k) * distance * (distance / t)
    holds = close & (start > 0.0)
    return integral_in_strip(integrand, _span(c, a, start) if holds else 0.0) if holds else 0.0
