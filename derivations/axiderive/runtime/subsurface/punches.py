"""The field of a contact as that of flat punches of all radii, each pressed in by what its slope g' adds to the depth.

With zeta = z + i t, rho**2 = r**2 + zeta**2, q = rho + zeta and X_m = (r/q)**m/rho a flat punch of radius t, pressed in
by one, has S_m = -Im X_m, D_m = -z Im((zeta + m rho) X_m/rho**2) and W = arg q; a contact has their integrals times
g'(t), and those of its own radius times d - g(a).  They are integrals over k of k**(1, 2, 0) P(k) exp(-k z) J_m(k r)
with P(k) the Hankel transform of pi p/E*, D_m with z in front; on the surface S_0 is pi p/E* itself.

A field needs few sums of them, with r (D_0 + D_2) = 2 z S_1 and r (D_1 + D_3) = 4 z S_2, most of one punch without
terms that cancel.  The integrand of a contact is
analytic but for t = r + i z and its mirror images, which come as close as the point is to the surface.  So panels
get longer with the distance from there, in v - alpha = beta sinh(u) with alpha + i beta the place of r + i z in
a variable v(t) in which the slope itself has no singular point nearer than a right angle.  A slope that is a polynomial
has closed forms (`moments`), which the integrals complete where those lose digits: far away, and beside the contact
next to the surface.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..interface import Array
from ..nodes import gauss_legendre
from .moments import Sums, sums

MANY, FEW = 16, 8
"""Nodes of a panel, and of one that is far away."""
PANEL = 2.4
"""In u, where the next singular point is a right angle away: 16 nodes leave 1e-15 of the integral."""
CORE, LONGEST = 1.2, PANEL * np.array([1.0, 2.0, 1.0, 2.0, 1.0])
"""Half the middle of a long way in u, and panels of its parts: off the middle the singular point is two right angles
away, and at the ends the slope and the mirror image come close."""
CLEAR, FAR = 0.75, 3.0
"""Distances of the singular point, in lengths of a panel, from which 16 and 8 nodes need no sinh(u)."""
DIGITS = 0.01
"""The distance, in places v, below which it is not known as a difference of them."""
SMOOTH = 8.0
"""Order to which a power of t is smooth in t**(1/m) at least, in which it is integrated next to the axis."""
TIP = -700.0
"""Place of the tip in log(t), below that of every radius that counts."""
BORDER = 40.0
"""Place of the radius R itself in artanh(t/R), beyond that of every radius of a contact."""
POINTS = 512
"""Panels that are summed together, so that what they need stays in the cache."""
HIGHEST = 6
"""Terms of a slope with closed forms: each loses digits with the distance."""
POINTED, SHALLOW = 1e-12, 0.3
"""Distances from the tip, in contact radii, and depths beside the contact, in those from the edge, of closed forms."""
AROUND = ((1.2, 32), (2.2, 16))
"""Half the sums of the distances from both ends of a diameter, in contact radii, from which a slope t**j needs no more
than half so many nodes: the error of a rule is a power of the axes of this ellipse."""
PANELS, NONE = -1, -2
"""In place of a number of nodes: by panels, and nothing at all."""
BLOCKS = ((0, 4 * POINTS), (32, POINTS), (16, 2 * POINTS))
"""Points that are taken together, by the nodes of a rule; of the closed form 0."""
BETWEEN = ((5.8, FEW), (2.2, MANY))
"""Sums of the distances from two radii, over what is between them, from which so many nodes there are enough."""
CLOSE = 0.8
"""An inner radius, in contact radii, from which on its numbers are too much like those of the contact."""


class Variable(NamedTuple):
    """A variable v of the radius t, and differences of it that keep their digits."""

    place: Callable[[Any, Any], Any]
    """v of a complex radius, with the length that goes with the variable."""
    away: Callable[[Any, Any, Any, Any, Any], Any]
    """v - v' of t and t', whose places are about known."""
    radius: Callable[[Any, Any], tuple[Any, Any]]
    """t and dt/dv."""
    at: Callable[[Array, Array], tuple[Array, ...]]
    """What `gap` takes of the place alpha + i beta of r + i z."""
    gap: Callable[..., Array]
    """(t - r)/length at v = alpha + w, of w, v and `at`: with digits beside |r + i z - t|."""
    given: Callable[[Array, Array, Array], tuple[Array, ...]]
    """What a slope takes of t, dt/dv and the length: t, and the root behind it."""
    endless: bool = False
    """Whether the radius zero is infinitely far away."""


def _both(x: Array) -> tuple[Array, Array]:
    """sinh and cosh."""
    more = np.expm1(np.abs(x))
    whole = 1.0 + more
    return np.copysign(0.5 * more * (1.0 + 1.0 / whole), x), 0.5 * (whole + 1.0 / whole)


def _of_cosh(v: Array, b: Array) -> tuple[Array, Array]:
    sinh, cosh = _both(v)
    return b * cosh, b * sinh


def _of_sinh(v: Array, b: Array) -> tuple[Array, Array]:
    sinh, cosh = _both(v)
    return b * sinh, b * cosh


def _of_tanh(v: Array, b: Array) -> tuple[Array, Array]:
    more = np.expm1(2.0 * v)
    whole = 2.0 + more
    return b * (more / whole), 4.0 * b * (1.0 + more) / (whole * whole)


def _at_tanh(alpha: Array, beta: Array) -> tuple[Array, ...]:
    sinh, cosh, sin, cos = np.sinh(alpha), np.cosh(alpha), np.sin(beta), np.cos(beta)
    size = (cosh - sin) * (cosh + sin)
    return cos * cos * cosh / size, sin * sin * sinh / size


def _gap_tanh(w: Array, v: Array, near: Array, aside: Array) -> Array:
    sinh, cosh = _both(w)
    return (near * sinh - aside * cosh) / np.cosh(v)


PLAIN = Variable(
    lambda t, b: t,
    lambda t, s, v, w, b: t - s,
    lambda v, b: (v, 1.0),
    lambda alpha, beta: (),
    lambda w, v: w,
    lambda t, rate, b: (t,),
)
"""v = t: slopes without singular points."""
COSH = Variable(
    lambda t, b: 2.0 * np.arcsinh(np.sqrt((t - b) / (2.0 * b))),
    lambda t, s, v, w, b: 2.0 * np.arcsinh((t - s) / (2.0 * b * np.sinh((v + w) / 2.0))),
    _of_cosh,
    lambda alpha, beta: (2.0 * np.cosh(alpha) * np.sin(beta / 2.0) ** 2,),
    lambda w, v, aside: 2.0 * _both(v - w / 2.0)[0] * _both(w / 2.0)[0] + aside,
    lambda t, rate, b: (t, rate),
)
"""t = b cosh(v): slopes with the root of t**2 - b**2, beyond a break."""
TANH = Variable(
    lambda t, b: np.where(np.abs(t) < b / 2.0, np.arctanh(t / b), (np.log(b + t) - np.log(b - t)) / 2.0),
    lambda t, s, v, w, b: np.arctanh(b * (t - s) / ((b - t) * (b + t) + t * (t - s))),
    _of_tanh,
    _at_tanh,
    _gap_tanh,
    lambda t, rate, b: (t, np.sqrt(rate * b)),
)
"""t = R tanh(v): slopes with the root of R**2 - t**2."""
SINH = Variable(
    lambda t, b: np.arcsinh(t / b),
    lambda t, s, v, w, b: 2.0 * np.arcsinh((t - s) / (2.0 * b * np.cosh((v + w) / 2.0))),
    _of_sinh,
    lambda alpha, beta: (2.0 * np.sinh(alpha) * np.sin(beta / 2.0) ** 2,),
    lambda w, v, aside: 2.0 * np.cosh(v - w / 2.0) * _both(w / 2.0)[0] + aside,
    lambda t, rate, b: (t,),
)
"""t = b sinh(v): slopes with poles at i b."""
EXP = Variable(
    lambda t, b: np.log(t / b),
    lambda t, s, v, w, b: 2.0 * np.arctanh((t - s) / (t + s)),
    lambda v, b: (b * np.exp(v),) * 2,
    lambda alpha, beta: (np.exp(alpha), 2.0 * np.sin(beta / 2.0) ** 2),
    lambda w, v, far, aside: far * (np.expm1(w) + aside),
    lambda t, rate, b: (t,),
    endless=True,
)
"""t = a exp(v): slopes that are any power of t."""


class Piece(NamedTuple):
    """Between two radii, arrays as all that it holds, the slope g'(t, *parameters) as a function of t.

    With `root` it takes the root behind t: of t**2 - b**2 beyond a break b, of R**2 - t**2 in a sphere.
    """

    variable: Variable
    low: Array
    high: Array
    slope: Callable[..., Array]
    parameters: tuple[Array, ...]
    length: Array = 1.0
    """b or R of the variable."""
    longest: Array = np.inf
    """What a panel may have in v for the sake of the slope."""
    power: Array = np.nan
    """The exponent of the slope plus one, where it is a power down to the radius zero."""
    sharp: Array = False
    """Whether the pressure is infinite at the inner end: at a tip, or where the profile has a kink."""


class Punch(NamedTuple):
    """What the numbers of flat punches have in common, with (xi + i eta)**2 = r**2 + (z + i t)**2 = rho**2."""

    r: Array
    z: Array
    t: Array
    xi: Array
    flat: Array
    """eta/t."""
    root: Array
    """The root of |rho**2|."""
    x: Array
    y: Array
    """rho over its size."""


def punch(r: Array, z: Array, t: Array, gap: Array) -> Punch:
    """Flat punches of radii t, pressed in by one; `gap` is t - r."""
    both, zz = r + t, z * z
    # the squares of lengths stay in range where those of squares would not
    size = np.maximum(np.sqrt(gap * gap + zz), z) * np.sqrt(both * both + zz)
    rest = zz - gap * both
    large = np.sqrt((size + np.abs(rest)) * 0.5)
    small = np.where(large > 0.0, z * (t / large), 0.0)
    ahead = rest >= 0.0
    xi, eta = np.where(ahead, large, small), np.where(ahead, small, large)
    root = np.sqrt(size)
    return Punch(r, z, t, xi, eta / t, root, xi / root, eta / root)


def _of_stress(own: Punch) -> tuple[Array, ...]:
    r, z, t, xi, flat, root, x, y = own
    xx, yy, h = x * x, y * y, np.sqrt(xi * xi + t * t)
    deep, pressed, s = z / root, y / root, t / h
    # deep is xi y/t, in which nothing overflows
    whole = pressed * (yy * (yy + xx * (4.0 + (1.0 - flat) * (1.0 + flat))) + 3.0 * xx * deep * deep)
    sheared = pressed * (3.0 * xx - yy) * deep * (r / root)
    return pressed, s / (h * (1.0 + flat)), whole, pressed * s * s, sheared


def _turned(own: Punch) -> tuple[Array, Array, Array]:
    """Cosine and sine of omega = arg q, and |1/q|."""
    h = np.sqrt(own.xi * own.xi + own.t * own.t)
    return own.xi / h, own.t / h, 1.0 / (h * (1.0 + own.flat))


def _of_displacement(own: Punch) -> tuple[Array, ...]:
    c, s, outward = _turned(own)
    kappa = own.r * outward
    return own.y / own.root, kappa * (c * own.y + s * own.x) / own.root, kappa * s, np.arctan(own.t / own.xi)


def _of_friction(own: Punch) -> tuple[Array, ...]:
    r, z, t, xi, flat, root, x, y = own
    c, s, outward = _turned(own)
    kappa, deep = r * outward, z / root
    xx, yy, cc, ss, cs = x * x, y * y, c * c, s * s, c * s
    double, twice = xx - yy, 2.0 * x * y
    pressed = y / root
    # (1 + flat) h/root is the size of q over that of rho
    bent = (1.0 + flat) * (t / (s * root)) * (x * (3.0 * yy - xx) * s - y * (3.0 * xx - yy) * c)
    bent = bent - (cc - ss) * twice - 2.0 * cs * double
    return (
        kappa * (c * y + s * x) / root,
        2.0 * kappa * outward * cs,
        kappa * outward * deep * ((cc - ss) * y + 2.0 * cs * x),
        pressed * (3.0 * xx - yy) * deep * (r / root),
        -kappa * kappa * (deep / root) * bent,
        pressed * ss,
    )


class Numbers(NamedTuple):
    """Sums over punches of which a field is made."""

    of: Callable[[Punch], tuple[Array, ...]]
    size: int
    made: Callable[[Sums, Array], tuple[Array, ...]]
    """Of the sums over a polynomial slope, and of the contact radius."""
    orders: int
    """How many of the sums S_m and D_m it takes."""
    sunk: bool
    """Whether it takes W."""
    infinite: tuple[int, ...]
    """Those that are infinite where the pressure is."""
    lost: tuple[int, ...]
    """Those that depend on the side from which the edge of a flat punch is reached."""


def _stress_of(own: Sums, a: Array) -> tuple[Array, ...]:
    r, z, s, d, _ = own
    return s[0], 0.5 * (s[0] + r * r * s[2]), s[0] + z * d[0], s[0] - z * s[1], z * r * d[1]


def _displacement_of(own: Sums, a: Array) -> tuple[Array, ...]:
    r, _, s, _, w = own
    return s[0], r * s[1], a * (0.5 * r * (s[0] + r * r * s[2])), a * w


def _friction_of(own: Sums, a: Array) -> tuple[Array, ...]:
    r, z, s, d, _ = own
    deep = z * r
    return r * s[1], 0.5 * r * (s[1] + r * r * s[3]), deep * s[2], deep * d[1], deep * r * d[2], s[0] - z * s[1]


STRESS = Numbers(_of_stress, 5, _stress_of, 3, False, (0, 2, 3), (1, 4))
"""S_0, (S_0 + S_2)/2, S_0 + D_0, S_0 - z S_1/r and D_1."""
DISPLACEMENT = Numbers(_of_displacement, 4, _displacement_of, 3, True, (0,), (1,))
"""S_0, S_1, r (S_0 + S_2)/2 and W."""
FRICTION = Numbers(_of_friction, 6, _friction_of, 4, False, (5,), (0, 1, 2, 3, 4))
"""S_1, (S_1 + S_3)/2, z S_2/r, D_1, D_2 and S_0 - z S_1/r."""


def superposed(numbers: Numbers, r: Array, z: Array, pieces: Sequence[Piece]) -> Array:
    """The numbers of the slopes of all pieces at points (r, z) with z >= 0, flat arrays, as rows."""
    total = np.zeros((numbers.size, r.size))
    for piece in pieces:
        shape = [np.broadcast_to(np.asarray(x, float), r.shape) for x in _arrays(piece)]
        inside = (shape[1] > shape[0]) & np.isfinite(r + z) & (r >= 0.0) & (z >= 0.0)
        if inside.any():
            here = slice(None) if inside.all() else np.flatnonzero(inside)
            low, high, length, longest, power, _, *others = (x[here] for x in shape)
            own = Piece(piece.variable, low, high, piece.slope, tuple(others), length, longest, power)
            rule = _of_polynomial if piece.slope is polynomial and len(others) <= HIGHEST else _of_piece
            total[:, here] += rule(numbers, r[here], z[here], own)
            ends = inside & (shape[5] != 0.0) & (r == shape[0]) & (z == 0.0)
            for row in numbers.infinite:
                total[row, ends] = np.inf
    return total


def _arrays(piece: Piece) -> tuple[Array, ...]:
    return (piece.low, piece.high, piece.length, piece.longest, piece.power, piece.sharp, *piece.parameters)


def polynomial(t: Array, *coefficients: Array) -> Array:
    """A slope from the axis on, with these coefficients from the constant on."""
    value = 0.0 * t
    for c in reversed(coefficients):
        value = value * t + c
    return value


def _of_polynomial(numbers: Numbers, r: Array, z: Array, piece: Piece) -> Array:
    """The numbers of a polynomial slope: closed next to the contact, from a rule around it, else from panels.

    Of radii from an inner one on, a rule between them takes those points that are away from both. Elsewhere those up to
    the inner one are taken away, unless it is close to the edge.
    """
    total, nodes = np.zeros((numbers.size, r.size)), _nodes(r, z, piece.high)
    parts, inner = [(1.0, piece.high, nodes)], piece.low > 0.0
    if inner.any():
        less = np.where(inner, _nodes(r, z, np.where(inner, piece.low, piece.high)), NONE)
        nodes[inner & ((less == PANELS) | (piece.low > CLOSE * piece.high))] = PANELS
        away = np.hypot(r - piece.low, z) + np.hypot(r - piece.high, z)
        for distance, count in BETWEEN:
            o = np.flatnonzero(inner & (nodes != NONE) & (away >= distance * (piece.high - piece.low)))
            for some in np.split(o, range(POINTS, o.size, POINTS)):
                there = [x[some] for x in (r, z, piece.low, piece.high, *piece.parameters)]
                total[:, some] = _between(numbers, count, *there)
            nodes[o] = NONE
        parts.append((-1.0, piece.low, np.where(nodes < 0, NONE, less)))
    rest = np.flatnonzero(nodes == PANELS)
    if rest.size:
        shape = (piece.low, piece.high, piece.length, piece.longest, piece.power)
        low, high, length, longest, power, *others = (own[rest] for own in (*shape, *piece.parameters))
        own = Piece(piece.variable, low, high, polynomial, tuple(others), length, longest, power)
        total[:, rest] = _of_piece(numbers, r[rest], z[rest], own)

    for sign, end, own_nodes in parts:
        for count, block in BLOCKS:
            points = np.flatnonzero(own_nodes == count)
            for begin in range(0, points.size, block):
                o = points[begin : begin + block]
                total[:, o] += _from_axis(numbers, count, r[o], z[o], end[o], [sign * c[o] for c in piece.parameters])
    return total


def _nodes(r: Array, z: Array, a: Array) -> Array:
    """How many nodes the rule over a diameter needs, 0 where the closed form keeps its digits; or `PANELS`."""
    x, y, gap = r / a, z / a, (a - r) / a
    around = 0.5 * (np.sqrt(gap * gap + y * y) + np.sqrt((x + 1.0) ** 2 + y * y))
    (near, many), (far, few) = AROUND
    closed = (y >= -SHALLOW * gap) & (x + y > POINTED) & ((gap != 0.0) | (y > 0.0))
    return np.where(around < near, np.where(closed, 0, PANELS), np.where(around < far, many, few))


def _from_axis(numbers: Numbers, count: int, r: Array, z: Array, a: Array, slope: list[Array]) -> Array:
    """The numbers of radii up to a, in closed form or by a rule."""
    scale, rates = 1.0, []
    for c in slope:
        rates.append(c * scale)
        scale = scale * a
    if count:
        return _around(numbers, count, r[:, None], z[:, None], a[:, None], rates)
    one = punch(r / a, z / a, np.ones(r.size), (a - r) / a)
    made = sums(numbers.orders, one.r, one.z, one.xi, one.flat, rates, sunk=numbers.sunk)
    return np.array(numbers.made(made, a))


def _around(numbers: Numbers, count: int, r: Array, z: Array, a: Array, slope: list[Array]) -> Array:
    """The numbers by half the nodes of a rule over a diameter, as they are odd in t.

    Those of the even powers of the slope come from nodes in t**2, each weighed by 1/(2 t).
    """
    total = np.zeros((numbers.size, len(r)))
    for odd in (0, 1):
        rates = slope[odd::2]
        if any(c.any() for c in rates):
            nodes, weights = (x[-count // 2 :] for x in gauss_legendre(count if odd else count // 2))
            t = 2.0 * nodes - 1.0 if odd else np.sqrt(nodes)
            share = 2.0 * weights * t if odd else weights / (2.0 * t)
            weight = polynomial(t * t, *(c[:, None] for c in rates)) * share * a
            total += _sums(numbers, punch(r, z, a * t, a * t - r), weight)
    return total


def _between(numbers: Numbers, count: int, r: Array, z: Array, low: Array, high: Array, *slope: Array) -> Array:
    nodes, weights = gauss_legendre(count)
    further = (high - low)[:, None] * nodes
    t = low[:, None] + further
    weight = polynomial(t, *(c[:, None] for c in slope)) * weights * (high - low)[:, None]
    return _sums(numbers, punch(r[:, None], z[:, None], t, (low - r)[:, None] + further), weight)


class Panels(NamedTuple):
    """Panels of integrals: the point of each, where it begins and how far it goes in its own variable."""

    point: Array
    start: Array
    step: Array
    offset: Callable[[Array, Array, Array], tuple[Array, Array, Array]]
    """v, v - alpha and the derivative of both, of the panel's variable, the points and `over`."""
    over: Array
    """What exp(u) of a panel at either end lacks, because u there has its last digit of a large number."""
    few: bool = False


def _of_piece(numbers: Numbers, r: Array, z: Array, piece: Piece) -> Array:
    variable, b = piece.variable, piece.length
    with np.errstate(all="ignore"):
        w = r + 1j * z
        star = np.where((w == 0.0) & (variable.endless), TIP, variable.place(w, b))
        star = np.where(np.isfinite(star), star, BORDER)
        top = _away(piece, piece.high, w, star)
        lowest, bottom = variable.place(piece.low + 0j, b).real, _away(piece, piece.low, w, star).real
        if variable.endless:
            tail = np.where(w == 0.0, 0.0, np.minimum(star.real, 0.0)) - np.log(_tail_of(piece.power))
            lowest = np.where(piece.low > 0.0, lowest, tail)
            bottom = np.where(piece.low > 0.0, bottom, tail - star.real)
        alpha, beta, top = star.real, np.abs(top.imag), top.real
        highest = variable.place(piece.high + 0j, b).real
        # not as the difference of both distances, which far away have lost its digits
        whole = np.where(piece.low > 0.0, _away(piece, piece.high, piece.low + 0j, lowest).real, highest - lowest)
        mirror = np.full(r.shape, 4.0) if variable.endless else 2.0 * alpha
        count = np.maximum(1.0, np.ceil(whole / piece.longest)).astype(int)
        point, share, share_1 = _split(count)
        low, high, width = bottom[point], top[point], whole[point]
        # from the nearer end, whose distance is known to its last digits
        left = np.where(share < 0.5, low + width * share, high - width * (1.0 - share))
        right = np.where(share_1 < 0.5, low + width * share_1, high - width * (1.0 - share_1))
        total = np.zeros((numbers.size, r.size))
        if variable.endless:
            total += np.where(piece.low > 0.0, 0.0, _tail(numbers, r, z, piece))
        begin = lowest[point] + width * share
        # a high power takes its digits from the end at which it is large
        begin = np.where((variable.endless) & (share >= 0.5), highest[point] - width * (1.0 - share), begin)
        # eight nodes are enough for the kernel, and for a slope that is a power
        power = (variable.endless) | np.isinf(piece.longest)[point]
        place = variable.at(alpha, beta)
        for panels in _panels(point, power, begin, (whole / count)[point], left, right, alpha, beta, mirror):
            _add(total, numbers, r, z, piece, place, panels)
    return total


def _tail_of(power: Array) -> Array:
    """The part of the distance, or of the contact, to which the tail of a power reaches; m is large where it is low."""
    return np.where(power < 1.0, 8.0 ** (2.0 / power), 8.0)


def _tail(numbers: Numbers, r: Array, z: Array, piece: Piece) -> Array:
    """The numbers of radii that are small beside the contact and the point."""
    nodes, weights = gauss_legendre(MANY)
    reach, m = np.minimum(np.hypot(r, z), piece.high), np.ceil(SMOOTH / piece.power)[:, None]
    end = np.where(reach > 0.0, reach, piece.high) / _tail_of(piece.power)
    t = end[:, None] * nodes**m
    weight = piece.slope(t, *(x[:, None] for x in piece.parameters)) * weights * m * t / nodes
    return _sums(numbers, punch(r[:, None], z[:, None], t, t - r[:, None]), weight)


def _sums(numbers: Numbers, own: Punch, weight: Array) -> Array:
    return np.array([np.einsum("ij,ij->i", weight, x) for x in numbers.of(own)])


def _away(piece: Piece, end: Array, w: Array, star: Array) -> Array:
    """v of an end less that of r + i z: with the digits of both where they are close."""
    v = piece.variable.place(end + 0j, piece.length).real
    exact = piece.variable.away(end, w, v, star, piece.length)
    return np.where((np.abs(v - star) > 1.0) | ~np.isfinite(exact), v - star, exact)


def _split(count: Array) -> tuple[Array, Array, Array]:
    """For each of so many parts of each of some things: the thing, and the ends of the part in lengths of it."""
    own = np.repeat(np.arange(count.size), count)
    part = np.arange(own.size) - np.repeat(np.cumsum(count) - count, count)
    return own, part / count[own], (part + 1) / count[own]


def _panels(
    point: Array,
    power: Array,
    first: Array,
    width: Array,
    left: Array,
    right: Array,
    alpha: Array,
    beta: Array,
    mirror: Array,
) -> list[Panels]:
    """Panels from `left` to `right` of v - alpha, from `first` of v on, by how close the singular point is."""
    distance = np.hypot(np.maximum(np.maximum(left, -right), 0.0), beta[point])
    # at the inner end of a piece, on the surface, the kernel only makes up for the slope
    clear = (distance > CLEAR * width) & (distance > DIGITS * np.abs(first + width))
    clear |= ((beta == 0.0) & (mirror == 0.0))[point]
    far = power & clear & (distance > FAR * width)

    def straight(v: Array, o: Array, _: Array) -> tuple[Array, Array, Array]:
        return v, v - alpha[o], 1.0

    found = []
    for own, few in ((far, True), (clear & ~far, False)):
        found.append(Panels(point[own], first[own], width[own], straight, width[own], few))

    def along(away: Array, rate: Array, o: Array) -> tuple[Array, Array, Array]:
        return alpha[o] + away, away, rate

    near = ~clear & (beta[point] > 0.0)
    o, scale = point[near], beta[point[near]]

    def beside(u: Array, o: Array, over: Array) -> tuple[Array, Array, Array]:
        half = 0.5 * beta[o]
        e = half * np.exp(u) * over
        other = half * half / e
        return along(e - other, e + other, o)

    found.append(_beside(o, left[near] / scale, right[near] / scale, beside))
    on = ~clear & (beta[point] == 0.0)
    beyond, within = on & (right > 0.0), on & (left < 0.0)
    o = point[beyond]
    start, end = (2.0 * np.arcsinh(np.sqrt(np.maximum(x[beyond], 0.0) / mirror[o])) for x in (left, right))

    def after(u: Array, o: Array, _: Array) -> tuple[Array, Array, Array]:
        sinh, cosh = _both(u / 2.0)
        return along(mirror[o] * sinh * sinh, mirror[o] * sinh * cosh, o)

    found.append(_cut(o, start, end, after))
    o = point[within]
    start, end = (2.0 * np.arcsin(np.sqrt(np.clip(-x[within] / mirror[o], 0.0, 1.0))) for x in (right, left))

    def before(u: Array, o: Array, _: Array) -> tuple[Array, Array, Array]:
        sin, cos = np.sin(u / 2.0), np.cos(u / 2.0)
        return along(-mirror[o] * sin * sin, mirror[o] * sin * cos, o)

    found.append(_cut(o, start, end, before))
    return [panels for panels in found if panels.point.size]


def _beside(point: Array, left: Array, right: Array, offset: Any) -> Panels:
    """Panels in u from arcsinh(left) to arcsinh(right); on a long way longer ones between its ends and its middle."""
    start, end = np.arcsinh(left), np.arcsinh(right)
    inner, outer = np.clip(-CORE, start, end), np.clip(CORE, start, end)
    cuts = np.array([start, np.minimum(start + PANEL, inner), inner, outer, np.maximum(end - PANEL, outer), end])
    cuts[1:-1] = np.where(end - start > 3.0 * PANEL, cuts[1:-1], end)
    length = np.diff(cuts, axis=0).T
    count = np.ceil(length / LONGEST - 1e-9).astype(int)
    own, share, _ = _split(count.ravel())
    begin, step = cuts[:-1].T.ravel()[own] + share * length.ravel()[own], (length / count).ravel()[own]
    way, over = own // len(LONGEST), np.ones(own.size)
    first, last = np.diff(way, prepend=-1) != 0, np.diff(way, append=-1) != 0
    for here, u, x in ((first, begin, left), (last, begin + step, right)):
        far = np.abs(x) + np.sqrt(x * x + 1.0)
        over[here] = np.where(x < 0.0, 1.0 / far, far)[way[here]] / np.exp(u[here])
    return Panels(point[way], begin, step, offset, over)


def _cut(point: Array, start: Array, end: Array, offset: Any) -> Panels:
    count = np.maximum(1.0, np.ceil((end - start) / PANEL)).astype(int)
    own, share, _ = _split(count)
    step = ((end - start) / count)[own]
    return Panels(point[own], start[own] + share * (end - start)[own], step, offset, step)


def _add(
    total: Array, numbers: Numbers, r: Array, z: Array, piece: Piece, place: tuple[Array, ...], panels: Panels
) -> None:
    """Adds the integrals over panels of a piece to those of their points."""
    nodes, weights = gauss_legendre(FEW if panels.few else MANY)
    variable = piece.variable
    # far away the places of all radii are alike to the last digits, and at the tip the radii are the distances
    far = (np.hypot(r, z) > 2.0 * piece.high) | (r + z == 0.0)
    for begin in range(0, panels.point.size, POINTS):
        part = slice(begin, begin + POINTS)
        point, step = panels.point[part], panels.step[part, None]
        o = point[:, None]
        v, away, rate = panels.offset(panels.start[part, None] + step * nodes, o, panels.over[part, None])
        x, b = r[o], piece.length[o]
        t, pace = variable.radius(v, b)
        gap = np.where(far[o], t - x, b * variable.gap(away, v, *(own[o] for own in place)))
        given = variable.given(t, pace, b)
        weight = piece.slope(*given, *(own[o] for own in piece.parameters)) * (pace * rate * (step * weights))
        sums = _sums(numbers, punch(x, z[o], t, gap), weight)
        first = np.flatnonzero(np.diff(point, prepend=-1))
        total[:, point[first]] += np.add.reduceat(sums, first, axis=1)
