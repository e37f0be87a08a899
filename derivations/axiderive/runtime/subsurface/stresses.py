"""Stresses and displacements of a contact from its eleven numbers, under normal load and under friction.

Tension is positive, z points into the half-space, cylindrical components.  Friction is uncoupled from the pressure:
the traction is mu p in the direction phi = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from ..interface import Array, Result, numbers
from .punches import Piece, punch, superposed


class Stress(NamedTuple):
    """Stress of an axisymmetric state, tension positive; each a float or an array."""

    rr: Result
    tt: Result
    zz: Result
    rz: Result


class SlidingStress(NamedTuple):
    """Stress under friction in cylindrical components, tension positive; each a float or an array."""

    rr: Result
    tt: Result
    zz: Result
    rt: Result
    rz: Result
    tz: Result


class Displacement(NamedTuple):
    """Displacement away from the axis and into the half-space."""

    r: Result
    z: Result


class SurfaceStress(NamedTuple):
    """Stress of the surface away from the axis and around it."""

    rr: Result
    tt: Result


class Greatest(NamedTuple):
    """The greatest value below a contact and the point at which it is."""

    value: Result
    r: Result
    z: Result


Shape: TypeAlias = Callable[..., tuple[Array, Array, Sequence[Piece]]]
"""Of a, d and the geometry: the contact radius, the depth that its edge is pressed in beyond g, the pieces of g'."""


def eleven(shape: Shape, r: Array, z: Array, a: Array, d: Array | None, geometry: dict[str, Array]) -> Array:
    """The eleven numbers as rows over points of one shape, which all arguments broadcast to; NaN where one is negative.

    They are infinite at the edge of a flat face and at the tip of a cone, NaN where there is no direction to the edge.
    """
    given = [r, z, a, *([] if d is None else [d]), *geometry.values()]
    r, z, a, *others = np.broadcast_arrays(*(np.asarray(x, float) for x in given))
    size = r.shape
    r, z, a, *others = (np.ravel(x) for x in (r, z, a, *others))
    depth, own = (None, others) if d is None else (others[0], others[1:])
    with np.errstate(all="ignore"):
        radius, edge, pieces = shape(a, depth, **dict(zip(geometry, own, strict=True)))
        edge = np.broadcast_to(edge, r.shape)
        total = superposed(r, z, pieces)
        pressed = np.flatnonzero((edge != 0.0) & (radius > 0.0))
        if pressed.size:
            x, y, t = r[pressed], z[pressed], np.broadcast_to(radius, r.shape)[pressed]
            rim = (x == t) & (y == 0.0)
            field = np.array(punch(x, y, t, t - x))
            field[:, rim] = np.nan
            field[np.ix_((0, 8, 9), np.flatnonzero(rim))] = np.inf
            total[:, pressed] += edge[pressed] * field
        total[:, ~((r >= 0.0) & (z >= 0.0) & (radius >= 0.0))] = np.nan
        total[:, np.isinf(r) | np.isinf(z)] = 0.0
    return total.reshape(-1, *size)


def plain(values: Sequence[Array]) -> list[Result]:
    """Floats where the arguments are numbers."""
    return [value[()] if np.ndim(value) else float(value) for value in values]


def normal_stress(found: Array, nu: Array, scale: Array) -> list[Array]:
    """rr, tt, zz, rz of a pressure whose eleven numbers these are; `scale` is E_star/pi."""
    mean, half = (found[4] - (1.0 + 2.0 * nu) * found[0]) / 2.0, ((1.0 - 2.0 * nu) * found[2] - found[6]) / 2.0
    return [scale * x for x in (mean + half, mean - half, -found[8], -found[5])]


def normal_displacement(found: Array, r: Array, z: Array, nu: Array) -> list[Array]:
    """Away from the axis and into the half-space."""
    outward = (1.0 - 2.0 * nu) * (found[0] + found[2]) - (found[4] + found[6])
    sunk = np.where(z == 0.0, 0.0, z * found[0]) / (1.0 - nu)
    return [-r * outward / (2.0 * np.pi * (1.0 - nu)), (2.0 * found[10] + sunk) / np.pi]


def frictional_stress(found: Array, phi: Array, nu: Array, scale: Array) -> list[Array]:
    """What a traction mu p adds, in the order of `SlidingStress`; `scale` is mu E_star/pi."""
    cos, sin = np.cos(phi), np.sin(phi)
    mean = found[5] / 2.0 - (1.0 + nu) * found[1]
    along, across = found[5] / 4.0 - (1.0 - nu / 2.0) * found[1], (2.0 * nu * found[3] + found[7]) / 4.0
    lengthwise, sideways = (mean + along - across) * cos, (mean - along + across) * cos
    shear, turned = found[9], found[6] / 2.0
    parts = (lengthwise, sideways, -found[5] * cos, -(along + across) * sin)
    return [scale * x for x in (*parts, -(shear + turned) * cos, (shear - turned) * sin)]


AnyStress: TypeAlias = Stress | SlidingStress


def _components(stress: AnyStress) -> tuple[Array, ...]:
    """rr, tt, zz, rt, rz, tz as arrays."""
    if isinstance(stress, SlidingStress):
        return tuple(map(np.asarray, stress))
    zero = np.zeros_like(np.asarray(stress.rr, float))
    return (*map(np.asarray, (stress.rr, stress.tt, stress.zz)), zero, np.asarray(stress.rz), zero)


def add(*stresses: AnyStress) -> SlidingStress:
    """The sum of states: normal load and friction."""
    parts = zip(*map(_components, stresses), strict=True)
    return SlidingStress(*plain([sum(own[1:], own[0]) for own in parts]))


def hydrostatic(stress: AnyStress) -> Result:
    """Mean of the three normal stresses [Pa]."""
    return plain([sum(_components(stress)[:3]) / 3.0])[0]


def von_mises(stress: AnyStress) -> Result:
    """Equivalent stress of von Mises [Pa]."""
    rr, tt, zz, rt, rz, tz = _components(stress)
    normal = (rr - tt) ** 2 + (tt - zz) ** 2 + (zz - rr) ** 2
    return plain([np.sqrt(normal / 2.0 + 3.0 * (rt**2 + rz**2 + tz**2))])[0]


def principal(stress: AnyStress) -> tuple[Result, Result, Result]:
    """The principal stresses [Pa], the largest first."""
    rr, tt, zz, rt, rz, tz = np.broadcast_arrays(*_components(stress))
    rows = [np.stack(row, axis=-1) for row in ((rr, rt, rz), (rt, tt, tz), (rz, tz, zz))]
    tensor = np.stack(rows, axis=-2)
    known = np.all(np.isfinite(tensor), axis=(-1, -2))
    values = np.linalg.eigvalsh(np.where(known[..., None, None], tensor, 0.0))
    values = np.where(known[..., None], values, np.nan)
    first, second, third = plain([values[..., 2], values[..., 1], values[..., 0]])
    return first, second, third


def tresca(stress: AnyStress) -> Result:
    """Difference of the greatest and the least principal stress [Pa], twice the greatest shear."""
    first, _, third = principal(stress)
    return first - third


def largest_shear(stress: Stress) -> Array:
    """The greatest shear of an axisymmetric state, by its two principal stresses in the plane and the one around it."""
    half = np.hypot((stress.rr - stress.zz) / 2.0, stress.rz)
    middle = (stress.rr + stress.zz) / 2.0
    return np.maximum(half, (np.abs(middle - stress.tt) + half) / 2.0)


LAYERS, ZOOMS, KEPT, WIDE = 34, 16, 4, 9
"""Depths of the first grid, each 0.7 times the last one; steps of a zoom, the points that are followed, and the points
of a grid in each direction."""


def greatest(measure: Callable[[Array, Array], Array], a: float, marks: Sequence[float]) -> Greatest:
    """The greatest value of a measure of (r, z) below a contact of radius a: of a grid that is finer next to the axis,
    the breaks and the edge (`marks`), and then of ever smaller grids around the best of its points.
    """
    steps = a * 0.7 ** np.arange(LAYERS)
    r = np.unique(np.abs(np.concatenate([[m, *(m + steps), *(m - steps)] for m in marks])))
    r, z = (x.ravel() for x in np.meshgrid(r[r <= 1.5 * a], np.concatenate([steps, [0.0]])))
    value = measure(r, z)
    value = np.where(np.isfinite(value), value, -np.inf)
    best = Greatest(-np.inf, 0.0, 0.0)
    for start in _peaks(r, z, value):
        width = np.array([max(0.4 * z[start], 0.1 * min(abs(r[start] - m) for m in marks)), 0.4 * z[start]])
        here = Greatest(float(value[start]), float(r[start]), float(z[start]))
        width = np.maximum(width, 1e-9 * a)
        for _ in range(ZOOMS):
            grid = np.linspace(-1.0, 1.0, WIDE)
            x, y = np.meshgrid(np.abs(here.r + width[0] * grid), np.maximum(here.z + width[1] * grid, 0.0))
            found = measure(x.ravel(), y.ravel())
            top = int(np.nanargmax(found))
            if found[top] > here.value:
                here = Greatest(float(found[top]), float(x.ravel()[top]), float(y.ravel()[top]))
            width = width * 0.4
        best = max(best, here)
    return best


def _peaks(r: Array, z: Array, value: Array) -> list[int]:
    """The best points of a grid that are not close to a better one."""
    found: list[int] = []
    for own in np.argsort(-value):
        near = any(abs(r[own] - r[o]) + abs(z[own] - z[o]) < 0.8 * (z[own] + z[o]) for o in found)
        if not near:
            found.append(int(own))
        if len(found) == KEPT:
            break
    return found
