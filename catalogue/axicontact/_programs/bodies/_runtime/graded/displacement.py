"""Bodies of axicontact._runtime.graded.displacement over plain numbers: the same with `math` for NumPy."""

from __future__ import annotations

from math import pow, sin

from ....._programs.bodies._runtime.graded.breaks import past_tip
from ....._programs.bodies._runtime.graded.rules import raised, sine_over
from ....._programs.bodies._runtime.integrals import difference_root, of_displacement
from ....._runtime.graded.displacement import _Break, _Gap
from ....._runtime.graded.growth import power_excess
from ....._runtime.graded.single import weighted
from ....._runtime.plain import at_many_radii, integral, integral_by_panels, integral_in_strip
from ....._runtime.plain import MATH as np

EDGE = ((3.0, 32,), (11.0, 64,),)
NODES = 64
SHARE = 0.125
SPLIT = 0.5235987755982988
STEEP = 16.0
_SMOOTHING = 8


def punch_scale(k):
    return 0.6366197723675814 * sin(1.5707963267948966 * (1.0 - abs(k)))


@at_many_radii(of_displacement, SHARE)
def punch_share(r, a, k):
    """w/d outside a flat punch, for r > a."""
    q = difference_root(r, a)
    stop = np.arcsinh(a / q)
    return punch_scale(k) * from_edge(lambda s, z: np.ones_like(z), a, q, q, stop, k)


@at_many_radii(of_displacement, SHARE)
def power_sag(r, a, n, k):
    """Of f = r**n."""
    q = difference_root(r, a)
    near = _from_edge_of_power(lambda s, z: np.exp(n / 2.0 * np.log1p(-(z / a) ** 2)), q, a, n, k)
    whole = np.floor(n)
    weight = n - whole

    def smooth(x):
        return sine_over(x) ** weight * np.sin(x) ** whole * kernel(np.cos(x), np.sin(x), a / q, k)
    reach = _to_axis(q)
    far = reach ** weight * reach * weighted(smooth, reach, weight)
    return punch_scale(k) * a ** n * (near + far)


def power_displacement(r, a, n, k):
    """The displacement of f = r**n inside and outside the contact: what d is above f(a), and f(a) above f(s)."""
    ratio = np.log(r / a) if r < 0.5 * a else np.log1p((r - a) / a) if r < a else 0.0
    excess = power_excess(n, k)
    over = _beside_power(r, a, n, k, excess) if r > a else excess - np.expm1(n * ratio)
    return a ** n * over if a > 0.0 else 0.0


@at_many_radii(of_displacement, SHARE)
def _beside_power(r, a, n, k, excess):
    q = difference_root(r, a)
    near = _from_edge_of_power(lambda s, z: excess - np.expm1(n / 2.0 * np.log1p(-(z / a) ** 2)), q, a, n, k)

    def smooth(u):
        x = reach * u ** _SMOOTHING
        over = (excess - np.expm1(n * np.log(np.sin(x)))) * _SMOOTHING * reach * u ** (_SMOOTHING - 1)
        return over * kernel(np.cos(x), np.sin(x), a / q, k)
    reach = _to_axis(q)
    return punch_scale(k) * (near + integral(smooth, np.ones_like(reach), NODES))


def _to_axis(q):
    """The angle that is left beyond the split, one number for all points: they share their nodes."""
    return np.full((1,) * np.ndim(q), np.pi / 2.0 - SPLIT)


def _from_edge_of_power(shape, q, a, n, k):
    return from_edge(shape, a, q, q, np.arcsinh(a / q / 2.0), k, np.any(n > STEEP))


def from_edge(shape, a, q, c, stop, k, steep=False):
    """From z = 0 on in z = c sinh(v), where the path is long in two panels of which the first carries the weight."""
    ratio = c / q

    def smooth(v, sinh):
        z = c * sinh
        return shape(difference_root(a, z), z) * np.cosh(v) / (1.0 + (ratio * sinh) ** 2)

    def first(v):
        sinh = np.sinh(v)
        return smooth(v, sinh) * (sinh / (v if v > 0.0 else 1.0) if v > 0.0 else 1.0) ** k

    def second(v):
        sinh = np.sinh(half + v)
        return smooth(half + v, sinh) * sinh ** k
    longest = np.inf if steep else float(np.max(stop if np.isfinite(stop) else 0.0, initial=0.0))
    for length, count in EDGE:
        if longest <= length:
            return raised(ratio, k) * raised(stop, k) * weighted(first, stop, k, count)
    half = stop / 2.0
    return raised(ratio, k) * (raised(half, k) * weighted(first, half, k) + integral(second, half, NODES))


def over_angle(shape, a, q, stop, k):
    """In z = a sin(y) from the split to `stop`, with nodes in s: sines cost ten roots."""
    low = a * np.cos(stop) + np.zeros_like(q)

    def smooth(x):
        s = low + x
        z = difference_root(a, s)
        return shape(s, z) * (s / z) * (z / q) ** k / (1.0 + (z / q) ** 2) / q
    return integral(smooth, a * np.cos(SPLIT) - low, 32)


def kernel(sine, cosine, ratio, k):
    v9 = ratio * sine
    return ratio * pow(ratio, k) * (pow(sine, k) * cosine) / (1.0 + v9 * v9)


def over_cap(shape, q, root, b, k, end=np.inf):
    """The part within a break at s = b, where z = root, of a function of more = b**2 - s**2 and z.

    All its singularities are at negative `more`: z = 0, z = i q and that of the function, -end**2.  In the logarithm
    of the distance to the nearest of them they are pi/2 away from the path, which is counted from either end.
    """
    low = np.minimum(root, end)
    top, half = (np.hypot(low, b), np.log1p((b / low) ** 2) / 4.0 + np.zeros_like(q))

    def along(near, risen):
        more = risen * (near + low)
        z = np.sqrt(root * root + more)
        return shape(more, z) * (near / z) * (near / q) * (z / q) ** k / (1.0 + (z / q) ** 2)

    def from_low(x):
        return along(low * np.exp(x), low * np.expm1(x))

    def from_top(x):
        near = top * np.exp(-x)
        return along(near, near - low if near > 2.0 * low else b * (b / (top + low)) + top * np.expm1(-x))
    return integral_in_strip(from_low, half) + integral_in_strip(from_top, half)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def sphere_displacement(r, a, R, k):
    """Of a sphere of unit height over radius."""
    end = difference_root(R, a)
    return _smooth(lambda s, z: a * (a / (end + np.hypot(end, z))), r, a, k, end)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def hyperboloid_displacement(r, a, b, k):
    """Of f = sqrt(r**2 + b**2) - b, with a singularity at s = i b, close to the tip where b is small."""
    gap = _gap(r, a, k)
    shape = _weighed(gap, lambda s, z: a * (a / (np.hypot(a, b) + np.hypot(s, b))), a)
    near = from_edge(shape, a, gap.q, gap.q, np.arcsinh(a / gap.q / 2.0), k)
    ratio = b / a

    def smooth(x):
        y = ratio * np.sinh(x)
        value = shape(a * np.sin(y), a * np.cos(y)) * kernel(np.cos(y), np.sin(y), a / gap.q, k)
        return value * ratio * np.cosh(x)
    far = integral(smooth, np.arcsinh((np.pi / 2.0 - SPLIT) / ratio) + np.zeros_like(gap.q), NODES)
    root = difference_root(a, r)
    return _joined(gap, a, near + far, root * (root / (np.hypot(a, b) + np.hypot(r, b))))


@at_many_radii(of_displacement, SHARE, everywhere=True)
def gaussian_displacement(r, a, s, k):
    """Of f = 1 - exp(-r**2/s**2)."""
    square = (a / s) ** 2

    def shape(_, z):
        x = (z / s) ** 2
        return square * np.exp(-square) * (np.expm1(x) / (x if x > 0.0 else 1.0) if x > 0.0 else 1.0)
    return _smooth(shape, r, a, k)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def waves_displacement(r, a, q, k):
    """Of f = 1 - cos(q r)."""
    gap = _gap(r, a, k)

    def fall(s, z):
        x = q / 2.0 * z * (z / (a + s))
        return q * a * (a / (a + s)) * np.sin(q / 2.0 * (a + s)) * (np.sin(x) / x if x > 0.0 else 1.0)
    shape = _weighed(gap, fall, a)
    first = np.minimum(SPLIT, 2.0 * np.pi / q / a)
    near = from_edge(shape, a, gap.q, gap.q, np.arcsinh(a * np.sin(first) / gap.q), k)

    def smooth(y):
        sine, cosine = (np.sin(first + y), np.cos(first + y))
        return shape(a * cosine, a * sine) * kernel(sine, cosine, a / gap.q, k)
    far = integral_by_panels(smooth, np.pi / 2.0 - first + np.zeros_like(gap.q), first, NODES)
    return _joined(gap, a, near + far, _fall(fall, r, a))


@at_many_radii(of_displacement, SHARE, everywhere=True)
def flank_displacement(r, a, b, k):
    """Of f' = 1 for r > b."""
    at = _break_at(r, a, b)
    return _broken(lambda s, z: a * (a / (a + s)), lambda _: at.root * (at.root / (a + b)), r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rim_displacement(r, a, b, k):
    """Of f' = r for r > b."""
    at = _break_at(r, a, b)
    return _broken(lambda s, z: a * a / 2.0 + 0.0 * z, lambda _: at.root * at.root / 2.0, r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rounding_displacement(r, a, b, k):
    """Of f' = r - b for r > b."""
    at = _break_at(r, a, b)
    last = at.root * (at.root / (a + b))

    def beyond(s, z):
        square = (s - b) * (s + b) if s < z else (at.root - z) * (at.root + z)
        return a * (a / (a + s)) * (last + square / (s + b)) / 2.0
    return _broken(beyond, lambda _: last * last / 2.0, r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def rounded_displacement(r, a, b, k):
    """Of f' = r/b for r < b, 1 beyond."""
    at = _break_at(r, a, b)

    def within(more):
        return at.root * (at.root / (a + b)) + more / (2.0 * b)
    tip = power_displacement(r, a, 2.0, k) / (2.0 * b)
    return tip if a <= b else _broken(lambda s, z: a * (a / (a + s)), within, r, a, k, at)


@at_many_radii(of_displacement, SHARE, everywhere=True)
def tipped_displacement(r, a, R, b, end, k):
    """Of the sphere R up to r = b, continued by its tangent cone."""
    slope = b / end

    def past(x):
        return past_tip(x, R, b, end)

    def within(more):
        return slope * past(a) + more / (end + np.sqrt(end * end + more))
    at = _Break(b, np.sqrt(np.maximum(past(a), 0.0) * (a + b)), -past(r) * (b + r), end)
    tip = sphere_displacement(r, np.minimum(a, b), R, k)
    return tip if a <= b else _broken(lambda s, z: slope * a * (a / (a + s)), within, r, a, k, at)


def _gap(r, a, k):
    outside = r > a
    q = difference_root(np.maximum(r, a), a) if outside else a
    share = (1.0 - k) * (punch_share(r, a, k) if outside else 1.0)
    even = share * raised(q / a, k) if share > 0.0 else 0.0
    return _Gap(outside, q, even, (punch_scale(k) if outside else 0.0) + share * raised(a / q, -k))


def _weighed(gap, shape, a):
    return lambda s, z: shape(s, z) * (gap.grown * (z / a) ** 2 + gap.even)


def _fall(shape, r, a):
    """That of the profile at r."""
    root = difference_root(a, r)
    return shape(r, root) * (root / a) ** 2


def _joined(gap, a, value, fall):
    return (value if gap.outside else value + fall) if a > 0.0 else 0.0


def _smooth(shape, r, a, k, c=np.inf):
    """Of a profile without singularities near, but for one at z = i c."""
    gap = _gap(r, a, k)
    own, close = (_weighed(gap, shape, a), np.minimum(gap.q, c))
    near = from_edge(own, a, gap.q, close, np.arcsinh(a / close / 2.0), k)
    return _joined(gap, a, near + over_angle(own, a, gap.q, np.full_like(gap.q, np.pi / 2.0), k), _fall(shape, r, a))


def _break_at(r, a, b):
    return _Break(b, difference_root(a, b), (b - r) * (b + r))


def _broken(beyond, within, r, a, k, at):
    """Of a profile with a break, for a > b; `within` is the fall itself, as a function of b**2 - s**2."""
    gap = _gap(r, a, k)
    own = _weighed(gap, beyond, a)
    near = from_edge(own, a, gap.q, gap.q, np.arcsinh(np.minimum(at.root, a / 2.0) / gap.q), k)
    value = near + over_angle(own, a, gap.q, np.maximum(np.arctan2(at.root, at.b), SPLIT), k)
    tip = _weighed(gap, lambda more, z: within(more) / (z / a) ** 2, a)
    value = value + over_cap(tip, gap.q, at.root, at.b, k, at.end)
    fall = _fall(beyond, r, a) if at.more < 0.0 else within(np.maximum(at.more, 0.0))
    return _joined(gap, a, value, fall) if a > at.b else 0.0
