"""Contact with a layer on a rigid base: what it adds to the half-space is smooth, one linear system of few nodes.

The springs below the surface carry E_star/pi (g(a) - g(t) + x(t)).  On the half-space x = 0; on a layer x solves a
Fredholm equation of the second kind.  Its kernel is even in t and analytic up to 2 h from the axis, so that Gauss's
rule over half of the nodes settles quickly, and g enters by its integral times that kernel alone.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, wraps
from typing import Any, NamedTuple

import numpy as np

from ..integrals import in_parts
from ..interface import KEPT, Array
from ..inverse import Curve, inverse
from ..nodes import gauss_legendre
from .adhesion import hess_retraction

THINNEST = 20.0
"""Contact radius over thickness up to which the errors were measured."""
NODES = ((0.7, 24, 24), (2.0, 32, 24), (5.0, 64, 64), (THINNEST, 128, 128))
"""Up to which a/h: nodes across the whole contact, and along each stretch of wave numbers."""
THIN = "a layer that thin carries each column or the volume by itself: use the theory of thin layers"
STRETCHES = (0.0, 1.5, 4.0, 8.0, 13.0, 20.0)
"""Of wave numbers u = k h: from a half-space a layer differs by a share that falls as u**2 exp(-2 u)."""
STEP, LEVELS, SETTLED = 0.125, 8, 1e-8
"""Of the double exponential rule: first step, halvings, and the change after which the next one is rounding."""
TERMS = 2**18
"""Values at a time of a sum over waves at nodes at radii."""
BEHIND = 2.0**-24
"""Share of the radius over which the rate of g is a difference: it only steers the search for a root."""
WIDE = (0.3, 12.0)
"""Between which powers of the radius depth and force grow, as a guess."""


class State(NamedTuple):
    """What a layer changes of a contact of radius a: x(t) is a constant and the sum of amplitudes cos(k t)."""

    radius: float
    less: float
    """By how much the depth is smaller than on a half-space."""
    more: float
    """By how much the force is larger, over E_star."""
    edge: float
    """What the last spring of a flat punch carries, over that on a half-space."""
    rate: float
    """Of the depth with the radius."""
    stiffness: float
    """Of the flat punch of this radius, over E_star."""
    waves: Array
    """Wave numbers k."""
    bent: Array
    """Amplitudes times k**2."""
    across: int
    """Nodes across the contact."""


class States(NamedTuple):
    """Contacts of which each is solved once, and which of them stands where."""

    found: list[State]
    places: Array


def number_of(states: States, name: str) -> Array:
    """A number of each contact, by its name in `State`."""
    return np.array([getattr(one, name) for one in states.found])[states.places]


def added_pressure(states: States, r: Array) -> Array:
    """The pressure that the layers add, over E_star; zero outside."""
    r, places = np.broadcast_arrays(r, states.places)
    out = np.zeros(r.shape)
    for i, one in enumerate(states.found):
        inside = (places == i) & (r < one.radius)
        out[inside] = _added(one, r[inside])
    return out


def _added(state: State, r: Array) -> Array:
    """That of one contact, inside it: -1/pi times the integral of x'(t)/sqrt(t**2 - r**2)."""
    nodes, weights, _ = _half(state.across)
    out = np.empty_like(r)
    for part in in_parts(r.size, TERMS // (state.waves.size * nodes.size)):
        near = r[part, None]
        root = np.sqrt((state.radius - near) * (state.radius + near))
        t = np.hypot(near, root * nodes)
        curved = state.bent @ np.sinc(state.waves[:, None] / np.pi * t[:, None, :])
        out[part] = root[:, 0] / np.pi * (curved @ weights)
    return out


def of_states(contact: Callable[..., State]) -> Callable[..., States]:
    """A contact of plain numbers over arrays; coefficients of a polynomial, and words, are handed on."""
    kept = lru_cache(KEPT)(contact)

    @wraps(contact)
    def over_states(*given: Any) -> States:
        several = [i for i, own in enumerate(given) if not isinstance(own, tuple | str)]
        # with one number more: of a scene all that is given may be constants
        arrays = np.broadcast_arrays(0.0, *(np.asarray(given[i], dtype=np.float64) for i in several))
        rows, places = np.unique(np.stack([own.ravel() for own in arrays]), axis=1, return_inverse=True)
        found, arguments = list[State](), [*given]
        with np.errstate(all="ignore"):
            for row in rows.T.tolist():
                for i, own in zip(several, row[1:], strict=True):
                    arguments[i] = own
                found.append(kept(*arguments))
        return States(found, places.reshape(arrays[0].shape))

    return over_states


@of_states
def below_punch(a: float, h: float, nu: float, base: str) -> State:
    """A flat punch that sinks by a unit."""
    return on_layer(a, h, nu, base)


def retraction_on_layer(a: Array, E_star: Array, nu: Array, h: Array, dgamma: Array, base: str) -> Array:
    """By which adhesion moves the punch: its last spring is drawn out by as much as on the half-space."""
    return hess_retraction(a, E_star, dgamma) / number_of(below_punch(a, h, nu, base), "edge")


def require_base(base: str) -> None:
    if base not in STIFFER:
        message = f"base = {base!r} must be {' or '.join(map(repr, STIFFER))}: how the layer lies on what is below it"
        raise ValueError(message)


def _bonded(u: Array, nu: float) -> Array:
    k = 3.0 - 4.0 * nu
    rest = 4.0 * u * u + 1.0 + k * k
    return (2.0 * k * np.exp(-2.0 * u) + 4.0 * u + rest) / (2.0 * k * np.cosh(2.0 * u) + rest)


def _frictionless(u: Array, nu: float) -> Array:
    return (2.0 * u - np.expm1(-2.0 * u)) / (np.sinh(2.0 * u) + 2.0 * u)


STIFFER = {"bonded": _bonded, "frictionless": _frictionless}
"""1 - L(u) by the base: by which share a wave with k = u/h sinks less into the layer than into a half-space."""


@lru_cache(KEPT)
def _waves(nu: float, base: str, count: int) -> tuple[Array, Array]:
    """Wave numbers times the thickness, and the weights of the kernel there."""
    nodes, weights = (np.asarray(own) for own in gauss_legendre(count))
    low, width = np.array(STRETCHES[:-1])[:, None], np.diff(STRETCHES)[:, None]
    u = (low + width * nodes).ravel()
    return u, 2.0 / np.pi * (width * weights).ravel() * STIFFER[base](u, nu)


def wave_sum(nu: Array, base: str, power: int) -> Array:
    """u**power (1 - L), summed over all wave numbers u."""
    given, places = np.unique(nu, return_inverse=True)
    waves = [_waves(own, base, NODES[0][2]) for own in given.tolist()]
    return np.array([0.5 * np.pi * float(v @ u**power) for u, v in waves])[places].reshape(np.shape(nu))


@lru_cache(KEPT)
def _half(count: int) -> tuple[Array, Array, Array]:
    """Gauss's rule over (-1, 1) for even functions, on (0, 1): nodes, weights, and those of interpolation in x**2."""
    nodes, weights = (np.asarray(own) for own in gauss_legendre(count))
    upper = nodes > 0.5
    x = 2.0 * nodes[upper] - 1.0
    apart = 4.0 * np.subtract.outer(x, x) * np.add.outer(x, x) + np.eye(x.size)
    return x, 2.0 * weights[upper], 1.0 / np.prod(apart, axis=1)


@lru_cache(KEPT)
def _level(level: int) -> tuple[Array, Array, Array]:
    """What a halving adds to the double exponential rule on (0, 1): nodes, distances from the end, weights."""
    step = STEP / 2.0**level
    t = np.arange(-3.5 + (step if level else 0.0), 3.5, 2.0 * step if level else step)
    near, far = (1.0 / (1.0 + np.exp(-sign * np.pi * np.sinh(t))) for sign in (1.0, -1.0))
    return near, far, step * np.pi * np.cosh(t) * near * far


def _short(a: float, depth: Callable[[Array], Array], breaks: tuple[float, ...], count: int) -> Array:
    """Weights of the nodes by which the integral of g(a) - g(t), times a smooth even function, is a sum."""
    edges = [0.0, *(b / a for b in breaks if 0.0 < b < a), 1.0]
    low, width = np.array(edges[:-1])[:, None], np.diff(edges)[:, None]
    x, _, barycentric = _half(count)
    whole, total = depth(np.array([a])), np.zeros_like(x)
    for level in range(LEVELS):
        near, far, weights = _level(level)
        t = np.where(near < 0.5, low + width * near, low + width - width * far).ravel()
        apart = np.subtract.outer(t, x) * np.add.outer(t, x)
        # where a node of one rule is one of the other
        shares = barycentric / np.where(apart == 0.0, 1e-300, apart)
        short = (width * weights).ravel() * (whole - depth(a * t)) / shares.sum(axis=1)
        before, total = total, (0.5 * total if level else 0.0) + a * (short @ shares)
        if level and not np.max(np.abs(total - before)) > SETTLED * np.max(np.abs(total)):
            return total
    message = f"a = {a!r}: g has more waves than double precision integrates; use a smaller contact"
    raise ValueError(message)


def on_layer(
    a: float,
    h: float,
    nu: float,
    base: str,
    depth: Callable[[Array], Array] | None = None,
    breaks: tuple[float, ...] = (),
) -> State:
    """The contact of radius a whose springs carry nothing at the edge, by g and the radii where it has kinks.

    Without g a flat punch that sinks by a unit.
    """
    # a search that ends there is off by the rounding of its logarithms
    if a > THINNEST * h * (1.0 + SETTLED):
        message = f"a = {a!r}, thickness = {h!r}: a <= {THINNEST:g} thickness is violated; {THIN}"
        raise ValueError(message)
    count, along = next(((m, n) for most, m, n in NODES if a <= most * h), NODES[-1][1:])
    u, v = _waves(nu, base, along)
    x, w, _ = _half(count)
    cosines, waves, weights = np.cos(np.outer(u * (a / h), x)), u / h, v / h
    kernel, weighted = cosines.T * weights, a * cosines * w
    short = cosines @ _short(a, depth, breaks, count) if depth else np.zeros_like(u)
    system = np.eye(x.size) - kernel @ weighted
    # of a unit at every spring, and of what the half-space leaves out
    found = np.linalg.solve(system, np.stack([np.ones_like(x), kernel @ short], axis=1))
    carried = weighted @ found
    carried[:, 1] += short
    amplitudes = weights[:, None] * carried
    edge = np.cos(waves * a) @ amplitudes
    whole, unit = 1.0 + float(edge[0]), 2.0 * a * float(w @ found[:, 0])
    if depth is None:
        return State(a, 0.0, unit - 2.0 * a, whole, 0.0, unit, waves, amplitudes[:, 0] * waves * waves, count)
    less = float(edge[1]) / whole
    share, amplitude = (own[:, 1] - less * own[:, 0] for own in (found, amplitudes))
    before, after = depth(np.array([a * (1.0 - BEHIND), a]))
    rate = ((after - before) / (BEHIND * a) + (waves * np.sin(waves * a)) @ amplitude) / whole
    more = 2.0 * a * float(w @ share)
    return State(a, less, more, whole, float(rate), unit, waves, amplitude * waves * waves, count)


def radius_on_layer(
    curve: Curve, value: Array, start: Array, thickness: Array, largest: Array | float, smooth: bool
) -> Array:
    """The contact radius at which a curve has the value, from that on the half-space; NaN if the body ends before."""
    reach = np.minimum(THINNEST * thickness, largest)
    found = inverse(curve, value, np.fmin(start, reach), WIDE, reach, smooth=smooth)
    found = np.where(value == 0.0, start, found)
    last = found >= reach * (1.0 - SETTLED)
    if not np.any(last):
        return found
    last = last & (curve(np.where(last, reach, found))[0] < value)
    thin = last & (reach < largest)
    if np.any(thin):
        load = float(value[thin].flat[0])
        message = f"at {load!r} the contact radius is above {THINNEST:g} thickness; {THIN}"
        raise ValueError(message)
    return np.where(last, np.nan, found)
