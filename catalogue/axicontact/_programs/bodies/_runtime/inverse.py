"""Bodies of axicontact._runtime.inverse over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import exp, inf

from ...._runtime.plain import log, log1p, MATH as np

ITERATIONS = 120
LOST = 16.0
PATIENCE = 8
POLISHING = 3
ROUNDING = 1.1102230246251565e-16
SETTLED = 1e-09


def inverse(curve, value, start, exponents, largest=np.inf, share=None, smooth=False, noise=None):
    """The t > 0 with curve(t) = value.  It is at most `largest`.

    `curve` returns its value and its logarithmic slope d ln curve/d ln t.  Where that slope lies between the two
    `exponents`, which count as no more than a guess, the root lies in ln t between ln(value/curve) over either.
    The guarantee are signs, whatever the exponents: an increasing curve that is met below the value at one point and
    above it at another has its root between the two, and no step leaves such an interval.  Steps that do not settle
    within `PATIENCE` alternate with halves of it; if it is still open, with steps that double until it is not.
    A point that is settled stays: where the curve is met within its rounding.  With `noise`, where it is met within
    that.  With `share`, where a step no longer changes what t stands for, a quantity whose logarithm moves with that
    share of that of t.  What is left then is removed by a step that is linear in t.  Where the curve may have kinks
    and is not `smooth`, it is looked at again after that step.
    """
    if hasattr(start, 'root'):
        return start.root(curve, value, largest, exponents)
    t = np.minimum(start, largest)
    position = np.log(t)
    y, slope = curve(t)
    error = _missed(value, y)
    low, high = (np.full_like(position, -np.inf), np.full_like(position, np.log(largest)))
    step = error / slope
    close = ROUNDING * value if noise is None else noise
    known = y == y
    solvable = (value > 0.0) & (value < np.inf) & known
    for iteration in range(ITERATIONS):
        left = solvable & np.logical_not(np.abs(error) <= SETTLED * np.minimum(slope, 1.0))
        left = left & np.logical_not(np.abs(value - y) <= close)
        if share is not None:
            moved = np.maximum(share(t), share(np.minimum(t * np.exp(np.minimum(step, 700.0)), largest)))
            left = left & np.logical_not(np.abs(error) * moved <= 4.0 * ROUNDING * slope)
        if not np.count_nonzero(left):
            break
        low = np.maximum(low, position) if error > 0.0 else low
        high = np.minimum(high, position) if error < 0.0 else high
        step = _safe(position, step, error, exponents, low, high, iteration - PATIENCE)
        position = position + step if left else position
        t = np.exp(position) if left else t
        before, slope_before = (error, slope)
        y, slope = curve(t)
        y = y if y == y else np.inf
        error = _missed(value, y)
        step = _step(step, before, slope_before, error, slope)
    change = _last_step(t, value, y, slope)
    t = t + change
    if not smooth:
        for _ in range(POLISHING):
            if not np.any(np.abs(change) > 1e-14 * t):
                break
            change = _last_step(t, value, *curve(t))
            t = t + change
    root = np.minimum(t, largest) if (value >= 0.0) & known else np.nan
    return 0.0 if value == 0.0 else np.inf if value == np.inf else root


def _last_step(t, value, y, slope):
    v7 = t * ((value - y) / y) / slope
    if abs(v7) < 0.001 * t:
        return v7
    return 0.0


def _missed(value, y):
    v3 = (value - y) / y
    v6 = abs(v3) < 0.5
    if v6:
        return log1p(v3 if v6 else 0.0)
    return log(value / y)


def _safe(position, step, error, exponents, low, high, late):
    """The step, no further and no nearer than the slopes allow; halfway where it leaves the signs met, or is `late`."""
    least, most = exponents
    error = np.minimum(np.maximum(error, -1500.0), 1500.0)
    ends = (position + error / most, position + error * 2.0 ** max(late, 0) / np.maximum(least, 1e-300))
    first, last = (np.minimum(*ends) - 1e-09, np.maximum(*ends) + 1e-09)
    aimed = np.minimum(np.maximum(position + step, first), last)
    from_, to = (np.maximum(first, low), np.minimum(last, high))
    met = np.isfinite(high - low)
    signs = (from_ > to) | met & (late >= 0)
    middle = (low if signs else from_) / 2.0 + (high if signs else to) / 2.0
    if late >= 0:
        aimed = position + step if met else aimed
    within = (low <= aimed) & (aimed <= high) & (late < 0 or late % 2 == 0)
    return (aimed if within else middle) - position


def _step(step, before, slope_before, error, slope):
    v5 = error / slope
    v9 = inf if before == error else before - error
    v10 = step / v9
    v14 = (1.0 / slope - v10) / v9
    v23 = error * error * (v14 + (v14 - (v10 - 1.0 / slope_before) / v9) / v9 * before)
    return v5 + (v23 if abs(v23) < 0.5 * abs(v5) else 0.0)


def inverse_below(curve, value, largest, exponents, like=np.sqrt):
    """The t with curve(t) = value, for 0 < t <= largest where the curve ends with slope zero; not a number beyond.

    What the value is short of the largest, over the value, is nearly a power of the shortfall s of t over t at both
    ends; `exponents` are bounds of that power, `like` is about s of it.
    """
    top = curve(largest)[0]

    def shortfall(s):
        t = largest / (1.0 + s)
        y, slope = curve(t)
        short = (top - y) / y
        return above_noise(short, s / (1.0 + s) * slope * (1.0 + short), 1.0 + short, 2.0, exponents[0])
    short = np.maximum((top - value) / value, 0.0)
    noise = 4.0 * ROUNDING * (1.0 + short)
    s = inverse(shortfall, short, like(short), exponents, smooth=True, noise=noise)
    t = largest / (1.0 + s)
    return t if value <= top * (1.0 + 2.0 ** (-48)) else np.nan


def above_noise(difference, rate, size, power, least):
    """A difference of numbers of one `size` and its logarithmic slope; near zero it is all rounding, its rate is not.

    There it is that rate over its first `power`, if that is known.
    """
    tiny = ROUNDING * size
    if power is None:
        known = np.maximum(difference, tiny)
    else:
        known = difference if difference > LOST * tiny else np.maximum(rate / power, ROUNDING * tiny)
    return (known, np.maximum(rate / known, least))


def between(x, small, large, blend, rest):
    """About the t of a curve known at its ends: ln t where x is the logarithm of the curve over its value at t = 1.

    There t is (exp(x)/c)**(1/e), with c and e for `small` t and for `large`; `blend` is the power of either that
    is summed to q.  In between t is q times a polynomial of q/(1 + q), whose coefficients are the `rest`.
    """
    q = _joined(x, small, large, blend)
    v, factor = (1.0 - 1.0 / (1.0 + q), rest[-1])
    for coefficient in rest[-2::-1]:
        factor = factor * v + coefficient
    return q * factor


def _joined(x, small, large, blend):
    first, last = (blend / e * (x - np.log(c)) for c, e in (small, large))
    return np.exp((np.maximum(first, last) + np.log1p(np.exp(-np.abs(first - last)))) / blend)


def joining(like, slope, small, large):
    """About the t of a curve over its value at t = 1, less steep for large t than for small, from its slopes."""
    x = np.log(like)
    if small == large:
        return np.exp(x / (slope if x < 0.0 else large))
    share = np.minimum(np.maximum((slope - small) / (large - small), 1e-12), 1.0 - 1e-12)
    return _joined(x, (1.0 / (1.0 - share), small), (1.0 / share, large), 0.5 * (small + large))


def leaving_power(like, share, tip, small, large):
    v5 = log(like)
    v7 = 1.0 - share
    v17 = log(share)
    v21 = log(v7 if v7 > 1e-300 or v7 != v7 else 1e-300)
    if v5 < 0.0:
        v15 = -0.5 * (2.0 + small)
        v19 = v15 / 2.0 * (v5 - v17)
        v23 = v15 / small * (v5 - v21)
        return exp(((v19 if v19 > v23 or v19 != v19 else v23) + log1p(exp(-abs(v19 - v23)))) / v15)
    v34 = v5 if v5 > 0.0 or v5 != v5 else 0.0
    v36 = -0.5 * (tip + large)
    v39 = v36 / tip * (v34 - v17)
    v42 = v36 / large * (v34 - v21)
    return exp(((v39 if v39 > v42 or v39 != v39 else v42) + log1p(exp(-abs(v39 - v42)))) / v36)
