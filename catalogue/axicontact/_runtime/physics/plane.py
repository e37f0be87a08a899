"""Plane contact: fields on both sides of the middle, and integrals over flat strips of growing half-width.

A contact of half-width a is the sum of flat strips of half-width t < a under
the loads P'(t) dt.  `growth` gives P'(t) beyond a break b of the profile, from
t and sqrt(t**2 - b**2).  All integrands are positive, and the substitutions
keep their singularities pi/2 away from the path.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from ..integrals import Strip, difference_root, in_groups
from ..interface import Array, Result, elementwise, numbers
from ..rules import falling

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Growth = Callable[..., Array]
FADED = 42.0
"""exp(-42) = 6e-19: strips that much narrower than the contact, in powers of e, add nothing to it."""


def even(function: Callable[..., Array], x: ArrayLike, *fields: ArrayLike, **parameters: ArrayLike) -> Result:
    """Values of a field that is the same at x and -x; `function` takes the distance from the middle."""
    return elementwise(function, abs(x) if type(x) is float else np.abs(numbers("x", x)), *fields, **parameters)


def odd(function: Callable[..., Array], x: ArrayLike, *fields: ArrayLike, **parameters: ArrayLike) -> Result:
    """Values of a field that changes its sign with x; `function` takes the distance from the middle."""
    values = even(function, x, *fields, **parameters)
    # no negative zeros
    return values * _sign(x) + 0.0


def turned(x: ArrayLike, e: ArrayLike) -> Array:
    """The eccentricity as seen from the side of x: the pressure at -x is that at x under a load at -e."""
    return _sign(x) * (e if type(e) is float else numbers("e", e))


def _sign(x: ArrayLike) -> Array:
    return math.copysign(1.0, x) if type(x) is float else np.copysign(1.0, numbers("x", x))


def require_eccentricity(a: ArrayLike, e: ArrayLike) -> None:
    """Raise ValueError if the load does not act between the edges of the punch."""
    if type(a) is float and type(e) is float and abs(e) < a:
        return
    half_width, place = np.broadcast_arrays(numbers("a", a), numbers("e", e))
    outside = ~(np.abs(place) < half_width)
    if outside.any():
        message = (
            f"e = {float(place[outside].flat[0])!r}, a = {float(half_width[outside].flat[0])!r}: abs(e) < a is "
            "violated; a load at the edge or beyond overturns the punch, move it inside"
        )
        raise ValueError(message)


@in_groups
def load_beyond(growth: Growth, root: Array, b: Array) -> Strip:
    """Integral of P'(t) from b to a = sqrt(b**2 + root**2)."""
    stop = np.arcsinh(root / b)
    fallen = falling(stop)

    def integrand(v: Array) -> Array:
        side = root * fallen(v)
        return growth(np.sqrt(b * b + side * side), side) * side

    return integrand, np.minimum(stop, FADED), 1.0, True, 0.0


@in_groups
def slope_beyond(growth: Growth, x: Array, a: Array, b: Array) -> Strip:
    """Integral of P'(t)/sqrt(x**2 - t**2) from b to a < x."""
    edge, far = difference_root(a, b), difference_root(x, a)
    stop, place = _beyond(x, edge, far, b)

    def integrand(v: Array) -> Array:
        t, root, _, stretch = place(v)
        return growth(t, root) * stretch

    return integrand, stop, edge / far, a > b, 0.0


@in_groups
def depth_beyond(growth: Growth, L: Array, a: Array, b: Array) -> Strip:
    """Integral of P'(t) arcosh(L/t) from b to a < L."""
    edge, far = difference_root(a, b), difference_root(L, a)
    stop, place = _beyond(L, edge, far, b)

    def integrand(v: Array) -> Array:
        t, root, narrowed, stretch = place(v)
        return growth(t, root) * stretch * narrowed * np.arcsinh(far * narrowed / t)

    return integrand, stop, edge, a > b, 0.0


def _beyond(x: Array, edge: Array, far: Array, b: Array) -> tuple[Array, Callable[[Array], tuple[Array, ...]]]:
    """End of the variable, and what it stands for: t, its root, `narrowed`, and dt/sqrt(x**2 - t**2) by edge/far.

    The variable is tan(phi) = root/rest, with rest = sqrt(x**2 - t**2) = `far` at the edge.  There `narrowed` is 1:
    a rest from that of the edge keeps more digits than one from x.
    """
    ratio, end = b / x, edge / far
    stop, widest = np.arcsinh(end / ratio), np.sqrt(1.0 + end * end)
    fallen = falling(stop)
    # where x is close to the edge the strips count from tan(phi) = 1 on
    stop = np.minimum(stop, FADED + np.arcsinh(end))

    def place(v: Array) -> tuple[Array, ...]:
        part = fallen(v)
        square = 1.0 + (end * part) * (end * part)
        narrowed = widest / np.sqrt(square)
        root = edge * part * narrowed
        t = np.sqrt(b * b + root * root)
        return t, root, narrowed, root / t * (np.sqrt((ratio / end) ** 2 + part * part) / square)

    return stop, place
