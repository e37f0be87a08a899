"""Bodies of axicontact._runtime.shapes.across over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.functions import nth_root
from ....._programs.bodies._runtime.inverse import above_noise, inverse, joining, leaving_power
from ....._runtime.plain import at_break
from ....._runtime.plain import MATH as np

NOISE = 5.551115123125783e-16
ROUNDING = 1.1102230246251565e-16


def inverse_beyond(curve, value, b, tip, powers=None, leaving=None):
    """The radius at which a curve has this value that is its power `tip` up to b, where it bends or its slope jumps.

    `curve` gives its value and the derivative by ln radius from b on, from the radius and sqrt(radius**2 - b**2).
    The unknown is t = that root over b, even where the curve leaves b with an infinite slope.  The excess over the
    curve at b begins and ends with the `powers` of t; or `leaving` are those of what comes to the power itself.
    """
    base = curve(b, at_break(b))[0]
    above = value > base
    radius = b * nth_root((base if above else value) / base, tip)
    if not np.count_nonzero(above):
        return radius
    high = value if above else 2.0 * base
    return _beyond(curve, high, base, b, tip, powers, leaving) if above else radius


def inverse_across(curve, value, b, tip, end=None, powers=None):
    """The same for a curve that only begins as that power: one iteration for both sides of b.

    Below it the root is zero, and the unknown the radius; or artanh(radius/end), for a curve that would be infinitely
    steep at `end`.
    """
    base = curve(b, np.zeros_like(b))[0]
    above = value > base
    if np.all(above):
        return _beyond(curve, value, base, b, tip, powers)
    radius_at, share, reach = _tip(b, end)

    def both(t):
        inner = np.minimum(t, reach)
        y, rate = curve(b * np.sqrt(1.0 + t * t) if above else radius_at(inner), b * t if above else 0.0)
        more, slope = _excess(t, y, rate, base, powers[0] if powers else 2.0)
        return (more if above else y, slope if above else rate / y * share(inner))
    last, rate = curve(radius_at(reach), np.zeros_like(b))
    wanted = value - base if above else np.minimum(value, last)
    like = (last if above else wanted) / last
    start = reach * (like ** (1.0 / tip) if end is None else joining(like, rate / last * share(reach), tip, 1.0))
    if np.count_nonzero(above):
        start = _start(curve, wanted if above else base, base, b, tip, powers) if above else start
    least, most = (tip, np.inf) if end is None else (1.0, tip)
    t = inverse(both, wanted, start, (1.0 if above else least, np.inf if above else most), np.inf if above else reach, lambda t: 1.0 if above else share(np.minimum(t, reach)), smooth=True, noise=(NOISE if above else ROUNDING) * value)
    return b * np.sqrt(1.0 + t * t) if above else np.minimum(b, radius_at(np.minimum(t, reach)))


def _beyond(curve, value, base, b, tip, powers, leaving=None):
    small = None if leaving else (powers or (2.0,))[0]

    def excess(t):
        return _excess(t, *curve(b * np.sqrt(1.0 + t * t), b * t), base, small)
    start = _start(curve, value - base, base, b, tip, powers, leaving)
    t = inverse(excess, value - base, start, (1.0, np.inf), smooth=True, noise=NOISE * value)
    return b * np.sqrt(1.0 + t * t)


def _start(curve, more, base, b, tip, powers, leaving=None):
    """About the t at which the excess is this."""
    if powers is None and leaving is None:
        return np.ones_like(more)
    one, slope = _excess(1.0, *curve(b * np.sqrt(2.0), b), base, powers and powers[0])
    if powers is not None:
        return joining(more / one, slope, *powers)
    return leaving_power(more / one, base / one * (2.0 ** (tip / 2.0) - 1.0), tip, *(leaving or ()))


def _excess(t, y, rate, base, small):
    """The excess of a curve over its value at b and its logarithmic slope in t, both as `inverse_beyond` says."""
    return above_noise(y - base, rate * (t * t / (1.0 + t * t)), base, small, 1.0)


def _tip(b, end):
    """The radius of the unknown up to b; the derivative of its logarithm by that of the unknown; the unknown at b."""
    if end is None:
        return (lambda t: t, np.ones_like, b)
    reach = np.arctanh(np.minimum(b / end, 1.0 - ROUNDING))
    return (lambda t: end * np.tanh(t), lambda t: t / (np.sinh(t) * np.cosh(t)), reach)
