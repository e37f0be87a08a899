"""The field of a contact as that of flat punches of all radii, each pressed in by what its slope g' adds to the depth.

With zeta = z + i t, rho**2 = r**2 + zeta**2, q = rho + zeta and X_m = (r/q)**m/rho a flat punch of radius t, pressed in
by one, has S_m = -Im X_m, D_m = -z Im((zeta + m rho) X_m/rho**2) and W = arg q; a contact has their integrals times
g'(t), and those of its own radius times d - g(a).  They are integrals over k of k**(1, 2, 0) P(k) exp(-k z) J_m(k r)
with P(k) the Hankel transform of pi p/E*, D_m with z in front; on the surface S_0 is pi p/E* itself.

The numbers of one punch are sums of terms of one sign, to the last digits everywhere.  The integrand of a contact is
analytic but for t = r + i z and its mirror images, which come as close as the point is to the surface.  So panels
get longer with the distance from there, in v - alpha = beta sinh(u) with alpha + i beta the place of r + i z in
a variable v(t) in which the slope itself has no singular point nearer than a right angle.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from ..interface import Array
from ..nodes import gauss_legendre

MANY, FEW = 16, 8
"""Nodes of a panel, and of one that is far away."""
PANEL = 2.4
"""In u, where the next singular point is a right angle away: 16 nodes leave 1e-15 of the integral."""
CLEAR, FAR = 0.75, 3.0
"""Distances of the singular point, in lengths of a panel, from which 16 and 8 nodes need no sinh(u)."""
SURFACE = 1e-30
"""Depths below the surface, in lengths of the contact, that change nothing."""
SMOOTH = 8.0
"""Order to which a power of t is smooth in t**(1/m) at least, in which it is integrated next to the axis."""
POINTS = 512
"""Panels that are summed together, so that what they need stays in the cache."""
NUMBERS = 12
"""S_0 ... S_3, D_0 ... D_3, S_0 + D_0, S_0 - (D_0 + D_2)/2 = S_0 - z S_1/r, r (S_0 + S_2)/2 and W."""


class Variable(NamedTuple):
    """A variable v of the radius t, and differences of it that keep their digits."""

    place: Callable[[Any, Any], Any]
    """v of a complex radius, with the length that goes with the variable."""
    difference: Callable[[Any, Any, Any], Any]
    """t' - t of the places v and v + x."""
    away: Callable[[Any, Any, Any, Any, Any], Any]
    """v - v' of t and t', whose places are about known."""
    radius: Callable[[Any, Any], tuple[Any, Any]]
    """t and dt/dv."""


PLAIN = Variable(
    lambda t, b: t,
    lambda v, x, b: x,
    lambda t, s, v, w, b: t - s,
    lambda v, b: (v, 1.0),
)
"""v = t: slopes without singular points."""
COSH = Variable(
    lambda t, b: 2.0 * np.arcsinh(np.sqrt((t - b) / (2.0 * b))),
    lambda v, x, b: 2.0 * b * np.sinh(v + x / 2.0) * np.sinh(x / 2.0),
    lambda t, s, v, w, b: 2.0 * np.arcsinh((t - s) / (2.0 * b * np.sinh((v + w) / 2.0))),
    lambda v, b: (b * np.cosh(v), b * np.sinh(v)),
)
"""t = b cosh(v): slopes with the root of t**2 - b**2, beyond a break."""
TANH = Variable(
    lambda t, b: np.where(np.abs(t) < b / 2.0, np.arctanh(t / b), (np.log(b + t) - np.log(b - t)) / 2.0),
    lambda v, x, b: b * np.sinh(x) / (np.cosh(v) * np.cosh(v + x)),
    lambda t, s, v, w, b: np.arctanh(b * (t - s) / ((b - t) * (b + t) + t * (t - s))),
    lambda v, b: (b * np.tanh(v), b / np.cosh(v) ** 2),
)
"""t = R tanh(v): slopes with the root of R**2 - t**2."""
SINH = Variable(
    lambda t, b: np.arcsinh(t / b),
    lambda v, x, b: 2.0 * b * np.cosh(v + x / 2.0) * np.sinh(x / 2.0),
    lambda t, s, v, w, b: 2.0 * np.arcsinh((t - s) / (2.0 * b * np.cosh((v + w) / 2.0))),
    lambda v, b: (b * np.sinh(v), b * np.cosh(v)),
)
"""t = b sinh(v): slopes with poles at i b."""
EXP = Variable(
    lambda t, b: np.log(t / b),
    lambda v, x, b: b * np.exp(v) * np.expm1(x),
    lambda t, s, v, w, b: 2.0 * np.arctanh((t - s) / (t + s)),
    lambda v, b: (b * np.exp(v), b * np.exp(v)),
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


def punch(r: Array, z: Array, t: Array, gap: Array) -> tuple[Array, ...]:
    """The twelve numbers of flat punches of radii t, pressed in by one; `gap` is t - r.

    With (xi + i eta)**2 = r**2 + (z + i t)**2.
    """
    both = r + t
    size = np.hypot(gap, z) * np.hypot(both, z)
    rest = z * z - gap * both
    large = np.sqrt((size + np.abs(rest)) / 2.0)
    small = z * (t / large)
    ahead = rest >= 0.0
    xi, eta = np.where(ahead, large, small), np.where(ahead, small, large)
    root = np.sqrt(size)
    x, y = xi / root, eta / root
    h = np.hypot(xi, t)
    c, s, flat = xi / h, t / h, eta / t
    kappa = (r / h) * (t / (t + eta))
    xx, yy = x * x, y * y
    double = xx - yy, -2.0 * x * y
    triple = x * (xx - 3.0 * yy), -y * (3.0 * xx - yy)
    wide, depth = (1.0 + flat) * (h / root), z / size
    tt = t * t
    found = [y / root]
    bent = [-depth * (x / t) * (xx * (tt - 3.0 * eta * eta) + yy * (eta * eta - 3.0 * tt)) / root]
    before, now, scale = (1.0, 0.0), (c, -s), kappa
    for m in (1, 2, 3):
        found.append(scale * (now[0] * y - now[1] * x) / root)
        turned = before[0] * triple[1] + before[1] * triple[0]
        bent.append(-depth * scale * (wide * turned + (m - 1) * (now[0] * double[1] + now[1] * double[0])))
        before, now = now, (now[0] * c + now[1] * s, now[1] * c - now[0] * s)
        scale = scale * kappa
    # z/root is xi y/t, in which nothing overflows
    whole = y * (yy * (yy + xx * (4.0 + (1.0 - flat) * (1.0 + flat))) + 3.0 * xx * (z / root) ** 2) / root
    return (*found, *bent, whole, y * s * s / root, kappa * s, np.arctan2(t, xi))


def superposed(r: Array, z: Array, pieces: Sequence[Piece]) -> Array:
    """The twelve numbers of the slopes of all pieces at points (r, z) with z >= 0, flat arrays, as rows."""
    total = np.zeros((NUMBERS, r.size))
    for piece in pieces:
        shape = [np.broadcast_to(np.asarray(x, float), r.shape) for x in _arrays(piece)]
        here = np.flatnonzero((shape[1] > shape[0]) & np.isfinite(r + z) & (r >= 0.0) & (z >= 0.0))
        if here.size:
            low, high, length, longest, power, sharp, *others = (x[here] for x in shape)
            own = Piece(piece.variable, low, high, piece.slope, tuple(others), length, longest, power)
            total[:, here] += _of_piece(r[here], z[here], own)
            ends = here[(sharp != 0.0) & (r[here] == low) & (z[here] == 0.0)]
            for row in (0, 8, 9):
                total[row, ends] = np.inf
    return total


def _arrays(piece: Piece) -> tuple[Array, ...]:
    return (piece.low, piece.high, piece.length, piece.longest, piece.power, piece.sharp, *piece.parameters)


class Panels(NamedTuple):
    """Panels of integrals: the point of each, where it begins and how far it goes in its own variable."""

    point: Array
    start: Array
    step: Array
    offset: Callable[[Array, Array], tuple[Array, Array, Array]]
    """v, v - alpha and the derivative of both, of the panel's variable and the points."""
    few: bool = False


def _of_piece(r: Array, z: Array, piece: Piece) -> Array:
    variable, b = piece.variable, piece.length
    with np.errstate(all="ignore"):
        z = np.where(z < SURFACE * (r + piece.high), 0.0, z)
        w = r + 1j * z
        star = variable.place(w, b)
        top = _away(piece, piece.high, w, star)
        if variable is EXP:
            lowest = np.minimum(star.real, 0.0) - np.log(_tail_of(piece.power))
            bottom = lowest - star.real
        else:
            lowest = variable.place(piece.low + 0j, b).real
            bottom = _away(piece, piece.low, w, star).real
        alpha, beta, top = star.real, np.abs(top.imag), top.real
        highest = variable.place(piece.high + 0j, b).real
        # not as the difference of both distances, which far away have lost its digits
        whole = highest - lowest
        mirror = np.full(r.shape, 4.0) if variable is EXP else 2.0 * alpha
        count = np.maximum(1.0, np.ceil(whole / piece.longest)).astype(int)
        point, share, share_1 = _split(count)
        low, high, width = bottom[point], top[point], whole[point]
        # from the nearer end, whose distance is known to its last digits
        left = np.where(share < 0.5, low + width * share, high - width * (1.0 - share))
        right = np.where(share_1 < 0.5, low + width * share_1, high - width * (1.0 - share_1))
        total = _tail(r, z, piece) if variable is EXP else np.zeros((NUMBERS, r.size))
        begin = lowest[point] + width * share
        # a high power takes its digits from the end at which it is large
        begin = np.where((variable is EXP) & (share >= 0.5), highest[point] - width * (1.0 - share), begin)
        # eight nodes are enough for the kernel, and for a slope that is a power
        power = (variable is EXP) | np.isinf(piece.longest)[point]
        for panels in _panels(point, power, begin, (whole / count)[point], left, right, alpha, beta, mirror):
            _add(total, r, z, piece, alpha + 1j * beta, panels)
    return total


def _tail_of(power: Array) -> Array:
    """The part of the distance, or of the contact, to which the tail of a power reaches; m is large where it is low."""
    return np.where(power < 1.0, 8.0 ** (2.0 / power), 8.0)


def _tail(r: Array, z: Array, piece: Piece) -> Array:
    """The numbers of radii that are small beside the contact and the point."""
    nodes, weights = gauss_legendre(MANY)
    reach, m = np.minimum(np.hypot(r, z), piece.high), np.ceil(SMOOTH / piece.power)[:, None]
    end = np.where(reach > 0.0, reach, piece.high) / _tail_of(piece.power)
    t = end[:, None] * nodes**m
    weight = piece.slope(t, *(x[:, None] for x in piece.parameters)) * weights * m * t / nodes
    return np.array([(weight * x).sum(-1) for x in punch(r[:, None], z[:, None], t, t - r[:, None])])


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
    clear = (distance > CLEAR * width) | ((beta == 0.0) & (mirror == 0.0))[point]
    far = power & (distance > FAR * width)
    found = [
        Panels(point[own], first[own], width[own], lambda v, o: (v, v - alpha[o], 1.0), few)
        for own, few in ((far, True), (clear & ~far, False))
    ]

    def along(away: Array, rate: Array, o: Array) -> tuple[Array, Array, Array]:
        return alpha[o] + away, away, rate

    near = ~clear & (beta[point] > 0.0)
    o, scale = point[near], beta[point[near]]
    found.append(
        _cut(o, np.arcsinh(left[near] / scale), np.arcsinh(right[near] / scale),
             lambda u, o: along(beta[o] * np.sinh(u), beta[o] * np.cosh(u), o))
    )  # fmt: skip
    on = ~clear & (beta[point] == 0.0)
    beyond, within = on & (right > 0.0), on & (left < 0.0)
    o = point[beyond]
    low, high = (2.0 * np.arcsinh(np.sqrt(np.maximum(x[beyond], 0.0) / mirror[o])) for x in (left, right))
    found.append(_cut(o, low, high, lambda u, o: along(mirror[o] * np.sinh(u / 2) ** 2, mirror[o] / 2 * np.sinh(u), o)))
    o = point[within]
    low, high = (2.0 * np.arcsin(np.sqrt(np.clip(-x[within] / mirror[o], 0.0, 1.0))) for x in (right, left))
    found.append(_cut(o, low, high, lambda u, o: along(-mirror[o] * np.sin(u / 2) ** 2, mirror[o] / 2 * np.sin(u), o)))
    return [panels for panels in found if panels.point.size]


def _cut(point: Array, start: Array, end: Array, offset: Any) -> Panels:
    count = np.maximum(1.0, np.ceil((end - start) / PANEL)).astype(int)
    own, share, _ = _split(count)
    step = ((end - start) / count)[own]
    return Panels(point[own], start[own] + share * (end - start)[own], step, offset)


def _add(total: Array, r: Array, z: Array, piece: Piece, star: Array, panels: Panels) -> None:
    """Adds the integrals over panels to those of their points."""
    nodes, weights = gauss_legendre(FEW if panels.few else MANY)
    for begin in range(0, panels.point.size, POINTS):
        part = slice(begin, begin + POINTS)
        point, step = panels.point[part], panels.step[part, None]
        o = point[:, None]
        v, away, rate = panels.offset(panels.start[part, None] + step * nodes, o)
        place, b = star[o], piece.length[o]
        t, pace = piece.variable.radius(v, b)
        gap = away if piece.variable is PLAIN else piece.variable.difference(place, away - 1j * place.imag, b).real
        # far away the places of all radii are alike to the last digits
        gap = np.where(np.hypot(r[o], z[o]) > 2.0 * piece.high[o], t - r[o], gap)
        roots = {COSH: pace, TANH: np.sqrt(pace * b), SINH: None, PLAIN: None, EXP: None}[piece.variable]
        given = (t,) if roots is None else (t, roots)
        weight = piece.slope(*given, *(x[o] for x in piece.parameters)) * pace * rate * step * weights
        first = np.flatnonzero(np.diff(point, prepend=-1))
        sums = np.array([(weight * x).sum(-1) for x in punch(r[o], z[o], t, gap)])
        total[:, point[first]] += np.add.reduceat(sums, first, axis=1)
