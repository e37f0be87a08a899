"""Bodies of axicontact._runtime.physics.stable over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.inverse import inverse
from ....._programs.bodies._runtime.physics.adhesion import hess_retraction
from ....._runtime.physics.single import at_the_end
from ....._runtime.plain import MATH as np

EPS = 2.220446049250313e-16
LOST = 0.3
NOISE = 4.440892098500626e-16
SLACK = 1e-06
XI = {'force': 3.0, 'depth': 1.0}


def stable_radius(value, found, load, slope_of, pulled, inner, outer=None, corner=None):
    """The largest radius of a stable contact under this load; NaN below pull-off.

    `slope_of` is the derivative of the load, `pulled` the part of it by adhesion.
    A `corner` of the load divides a branch; the unknown is that of `inner` below it and that of `outer` beyond,
    counted from the start of the branch.  The load in excess of the least of a branch, over what it is short of
    the largest where the branch ends, grows from nothing to infinity, as a power at both ends.
    No exponent is assumed: the bracket of the root spans all doubles, and each evaluation cuts it.
    """
    low, high, least, top = _branch_of(value, found, load, pulled)
    if not np.count_nonzero(np.isfinite(least)):
        return least
    beyond = np.full_like(low, corner is None and outer is not None, dtype=bool)
    if corner is not None:
        low, high, least, top, beyond = _divided(value, low, high, least, top, load, corner)
    ends = np.isfinite(top)
    if outer is None and np.any(ends):
        ends = ends & (slope_of(high) < np.inf)
    first, reach, largest, place = _counted(low, high if ends else np.inf, beyond, inner, outer)
    fixed = np.abs(least) + pulled(low)
    parts = fixed + np.abs(value)
    least_short = 4.0 * NOISE * parts

    def excess(t):
        a, step = place(t)
        own = load(a)
        more, short = (own - least, np.maximum(top - own, least_short) if ends else 1.0)
        known = EPS * (fixed + np.abs(own))
        lost = more <= known
        more = known if lost else more
        slope = t * step * slope_of(a) * (1.0 / more + (1.0 / short if ends else 0.0))
        more = more / short
        slope = np.maximum(slope, 0.7) if np.logical_not(ends) & (more < 0.5 * wanted) else slope
        return (more, LOST if lost else slope)

    def share(t):
        a, step = place(t)
        return t * step / a
    short = np.maximum(top - value, least_short) if ends else 1.0
    wanted = np.maximum(value - least, 0.0) / short if value < np.inf else 0.0
    far = ends & (wanted > 1.0)
    order, least_unit = (getattr(inner, name) if outer is None else getattr(outer, name) if beyond else getattr(inner, name) for name in ('order', 'unit'))
    unit = reach if far else np.minimum(np.maximum(first, least_unit), largest)
    scale, slope = excess(unit)
    ratio = wanted / scale
    start = unit * ratio ** (1.0 / (4.0 if (ratio > 1.0) & np.logical_not(far) else order))
    start = reach if ends & (slope == LOST) else start
    noise = NOISE * parts * ((1.0 + wanted) / short if ends else 1.0)
    t = inverse(excess, wanted, start, (SLACK, np.inf), largest, share, smooth=True, noise=noise)
    a = place(t)[0]
    return np.inf if (value == np.inf) & (high == np.inf) else a if np.isfinite(least) else np.nan


def _branch_of(value, found, load, pulled):
    """The last branch with this load: its ends, and the load there, known to the rounding of its parts."""
    low = high = least = largest = np.full_like(value, np.nan)
    for first, last in zip(found.first, found.last, strict=True):
        start = load(first)
        top = at_the_end(load, last) if np.isfinite(last) else np.inf
        top = np.inf if np.isnan(top) else top
        fits = (value >= start - 2.0 * NOISE * (np.abs(start) + pulled(first))) & (value <= top)
        low, high = (first if fits else low, last if fits else high)
        least, largest = (start if fits else least, top if fits else largest)
    return (low, high, least, largest)


def _divided(value, low, high, least, top, load, corner):
    """The part of the branch on the side of the corner where the load is, and whether that is beyond."""
    bend = load(corner + np.zeros_like(low))
    inside = (low < corner) & np.logical_not(high <= corner)
    above = inside & (value > bend)
    below = inside & np.logical_not(above)
    high, top = (corner if below else high, bend if below else top)
    low, least = (corner if above else low, bend if above else least)
    return (low, high, least, top, low >= corner)


def _counted(low, high, beyond, inner, outer):
    """The unknown at `low`, how far it is to `high`, the largest t, and the radius with its derivative by t.

    t is what the unknown exceeds its first value by, times reach over what it is short of the last.
    """

    def of(a):
        return inner.of(a) if outer is None else outer.of(a if beyond else low) if beyond else inner.of(a)
    first = of(low)
    last = np.inf if high == np.inf else of(low if high == np.inf else high)
    reach = last - first

    def place(t):
        open_ = np.logical_not(np.isfinite(reach))
        share = 0.0 if open_ else t / reach
        x = first + (t / (1.0 + share) if share < np.inf else reach)
        step = 1.0 / (1.0 + share) ** 2
        a, rate = inner.back(x)
        if outer is not None:
            own, own_rate = outer.back(x if beyond else 1.0)
            a, rate = (own if beyond else a, own_rate if beyond else rate)
        return (a, rate * step)
    return (first, reach, np.inf if np.isfinite(reach) | beyond else inner.end - first, place)


def growth(slope, a, control, E_star, dgamma):
    """Derivative of the load by that of the depth without adhesion, with the retraction weighed by xi."""
    own = slope - XI[control] * hess_retraction(a, E_star, dgamma) / (2.0 * a)
    return 2.0 * E_star * a * own if control == 'force' else own
