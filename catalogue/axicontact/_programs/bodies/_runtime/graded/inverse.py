"""Bodies of axicontact._runtime.graded.inverse over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations


from ....._programs.bodies._runtime.integrals import difference_root
from ....._programs.bodies._runtime.inverse import inverse
from ....._programs.bodies._runtime.physics.unknowns import beyond_edge, power_of, radius_itself, root_of, up_to
from ....._programs.bodies._runtime.shapes.across import inverse_across
from ....._runtime.physics.unknowns import at_break
from ....._runtime.plain import MATH as np

CLOSE = 0.0001
LOST = 16.0
NEAREST = 1e-12
ROUNDING = 1.1102230246251565e-16
SHORT = (1.7763568394002505e-15, 2.9103830456733704e-11, 9.5367431640625e-07, 0.0009765625, 0.03125,)
SLACK = 1e-06
STEEPEST = 100000000.0


def radius_to(load, rate, value, start, needs):
    """The a with load(a, *needs) = value; `rate` is the derivative of the load."""
    value = value + np.zeros(1)
    start = start + np.zeros_like(value)
    return inverse(_curve(load, rate, needs), value, start, (SLACK, np.inf), smooth=True)


def radius_up_to(load, rate, value, largest, needs, unknown):
    """The same where the load ends at `largest` with slope zero; NaN beyond.

    Solved for the load over what it is short of its largest, which is the first or the second power of
    t = x/(1 - x/x(largest)) at either end, even where the grading makes the end an asymptote.
    """
    value = value + np.zeros(1)
    end, top = (largest, np.full_like(value, np.nan))
    for part in SHORT:
        end = largest * (1.0 - part) if np.isnan(top) else end
        top = load(end, *needs)
        if not np.any(np.isnan(top)):
            break
    held = value <= top * (1.0 + 2.0 ** (-48))
    if not np.count_nonzero(held):
        return value if held else np.nan
    reach = unknown.of(end)
    least_short = 6.0 * ROUNDING * top

    def place(t):
        a, step = unknown.back(t / (1.0 + t / reach))
        return (a, step / (1.0 + t / reach) ** 2)

    def curve(t):
        a, step = place(t)
        own = load(a, *needs)
        short = np.maximum(top - own, least_short)
        return (own / short, t * step * rate(a, *needs) * (1.0 / own + 1.0 / short))
    wanted = value / np.maximum(top - value, least_short)
    noise = 2.0 * ROUNDING * wanted * (1.0 + wanted)
    t = inverse(curve, wanted, reach * np.sqrt(wanted), (SLACK, np.inf), smooth=True, noise=noise)
    return place(t)[0] if held else np.nan


def _curve(load, rate, needs):

    def curve(a):
        own = load(a, *needs)
        return (own, a * rate(a, *needs) / own)
    return curve


def contact_beyond(load, rate, value, b, needs, exponents):
    """The same for a flat face of radius b, with the root b t = sqrt(a**2 - b**2); load and rate take both.

    The load grows as a power of t for small and for large t, with the two `exponents`; so does the unknown, which
    does not run away where the first is 1 + k near 0.
    """
    first, last = exponents
    value = value + np.zeros(1)
    unknown = beyond_edge(b, first, last)

    def curve(x):
        t, slope = root_of(x, first, last)
        a, root = (np.hypot(b, b * t), b * t)
        own = load(a, root, *needs)
        return (own, root * (root / a) * rate(a, root, *needs) / own / slope)
    unit = unknown.of(b * np.sqrt(2.0)) * np.ones_like(value)
    x = inverse(curve, value, unit * (value / curve(unit)[0]), (SLACK, np.inf), smooth=True)
    return (unknown.back(x)[0], b * root_of(x, first, last)[0])


def contact_below(load, rate, value, R, needs, exponent, k):
    """The same for a sphere, in t = a/sqrt(R**2 - a**2), with that root; NaN where the load is beyond that of a = R.

    It begins as t**`exponent`, and ends as const - t**-k, log(t) or t**-k, by the sign of k; the unknown is
    (1 - (1 + t**exponent)**(-k/exponent))/k, which does the same.
    From STEEPEST on the radius is R to the last digit, and the contact that of STEEPEST: the load in excess of it
    is what a flat face of that radius carries.
    """
    value = value + np.zeros(1)
    k = 1e-30 if np.abs(k) < 1e-30 else k

    def like(t):
        power = t ** exponent
        log = np.log1p(power)
        x = -np.expm1(-k / exponent * log) / k
        return (x, power / (1.0 + power) * np.exp(-k / exponent * log) / x)

    def place(x):
        power = np.expm1(-exponent / k * np.log1p(-k * x))
        return power ** (1.0 / exponent)

    def contact(t):
        root = R / np.hypot(1.0, t)
        return (root * t, root)

    def curve(x):
        t = place(x)
        a, root = contact(t)
        own = load(a, root, *needs)
        return (own, a * (root / R) ** 2 * rate(a, root, *needs) / own / like(t)[1])
    steepest = STEEPEST * np.ones_like(value)
    half = 0.5 * np.ones_like(value)
    largest = like(steepest)[0]
    last = load(*contact(steepest), *needs)
    wanted = np.minimum(value, last)
    x = inverse(curve, wanted, half * (wanted / curve(half)[0]), (SLACK, np.inf), largest, smooth=True)
    a, root = contact(place(x))
    if np.any(value > last):
        a = a if value <= load(R, np.zeros_like(R), *needs) * (1.0 + 2.0 ** (-48)) else np.nan
    return (a, root)


def radius_across(load, rate, value, b, needs, tip, least=None, end=None):
    """The a with load(a, root, *needs) = value, with root = sqrt(a**2 - b**2) for a break at b and 0 below it.

    Below the load is the power `tip` of a, in excess from t**least on beyond.
    """
    value = value + np.zeros(1)
    if end is None and least is None:
        return inverse_across(_with_rate(load, rate, needs), value, b + np.zeros_like(value), tip)
    base, *close = at_break((load, rate), b, 0.0 * b if end is None else NEAREST * b, *needs)
    base = base + np.zeros_like(value)
    above = value > base
    below = radius_itself() if end is None else up_to(end, needs[-1])
    radius = b + np.zeros_like(value)
    if not np.all(above):
        radius = _below(load, rate, base if above else value, base, b, needs, below, tip)
    if not np.any(above):
        return radius
    return _beyond(load, rate, value - base if above else 0.0, base, b, needs, 1.0 if least is None else least, tip, *close) if above else radius


def _with_rate(load, rate, needs):
    """Value and derivative by ln a."""
    return lambda a, root: (load(a, root, *needs), a * rate(a, root, *needs))


def _below(load, rate, value, base, b, needs, unknown, tip):
    """The radius up to b."""
    largest = unknown.of(b + np.zeros_like(value))

    def share(x):
        a, step = unknown.back(x)
        return x * step / a

    def curve(x):
        a, step = unknown.back(x)
        own = load(a, difference_root(a, b), *needs)
        return (own, x * step * rate(a, difference_root(a, b), *needs) / own)
    start = largest * (value / base) ** (1.0 / tip)
    x = inverse(curve, value, start, (SLACK, np.inf), largest, share=share, smooth=True)
    return np.minimum(unknown.back(x)[0], b)


def _beyond(load, rate, excess, base, b, needs, least, tip, at_close, slope_at_close):
    """The radius beyond b, where the load exceeds that of b by nearly c t**least + C t**2.

    Both terms are read from the load close to b, and with them the t at which one gives way to the other.
    """
    curve_at = _with_rate(load, rate, needs)

    def more_and_rate(t, y, slope):
        slope = slope * (t * t / (1.0 + t * t))
        more = np.maximum(y - base, ROUNDING * base)
        return (more, slope if more > LOST * ROUNDING * base else np.maximum(slope, np.minimum(least, 1.0) * more))
    near = CLOSE * np.ones_like(excess)
    more, slope = more_and_rate(near, at_close, slope_at_close)
    second = np.clip((slope / more - least) / np.maximum(2.0 - least, ROUNDING), ROUNDING, 1.0 - ROUNDING)
    meet = near * ((1.0 - second) / second) ** (1.0 / np.maximum(2.0 - least, 0.2))
    meet = np.minimum(np.maximum(meet, NEAREST), 1.0 / NEAREST)
    unit = more * (1.0 - second) * (meet / near) ** least

    def place(x):
        t, power = root_of(x, least, 2.0)
        return (meet * t, power)

    def curve(x):
        t, power = place(x)
        own, slope = more_and_rate(t, *curve_at(b * np.sqrt(1.0 + t * t), b * t))
        return (own, slope / own / power)

    def share(x):
        t, power = place(x)
        return t * t / (1.0 + t * t) / power
    noise = 8.0 * ROUNDING * (base + excess)
    first = place(excess / unit if excess > 0.0 else 1.0)[0]
    start = power_of((first ** (2.0 / tip) if first > 1.0 else first) / meet, least, 2.0)
    wanted = excess if excess > 0.0 else unit
    x = inverse(curve, wanted, start, (SLACK, np.inf), share=share, smooth=True, noise=noise)
    t = place(x)[0]
    return b * np.sqrt(1.0 + t * t) if excess > 0.0 else b
