"""Stresses and displacements of a contact from sums over flat punches, under normal load and under friction.

Tension is positive, z points into the half-space, cylindrical components.  Friction is uncoupled from the pressure:
the traction is mu p in the direction phi = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import NamedTuple, TypeAlias

import numpy as np

from ..interface import Array, Result, numbers
from .punches import DISPLACEMENT, FRICTION, STRESS, Numbers, Piece, punch, superposed


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


SURFACE = 1e-150
"""Depths, in lengths of the contact, that are the surface: their squares are nothing beside its own."""
BLOCK = 8192
"""Points that are taken together, so that what they need stays in the cache."""
Shape: TypeAlias = Callable[..., tuple[Array, Array, Sequence[Piece]]]
"""Of the given radius or depth and of the geometry: the contact radius, NaN where there is no contact; the depth by
which the edge is pressed in beyond g; the pieces of g'."""


def summed(numbers: Numbers, shape: Shape, r: Array, z: Array, given: Array, geometry: dict[str, Array]) -> Array:
    """The numbers as rows over points of one shape, to which all arguments broadcast; NaN where one is negative.

    They are infinite where the pressure is: at the edge of a flat face, a tip, a kink.
    """
    r, z, given, *own = np.broadcast_arrays(r, z, given, *geometry.values())
    size, known = r.shape, [np.ravel(x) for x in (r, z, given, *own)]
    total = np.empty((numbers.size, r.size))
    with np.errstate(all="ignore"):
        for begin in range(0, r.size, BLOCK):
            part = slice(begin, begin + BLOCK)
            r, z, given, *own = (x[part] for x in known)
            total[:, part] = _of_contacts(numbers, r, z, shape(given, **dict(zip(geometry, own, strict=True))))
    return total.reshape(numbers.size, *size)


def _of_contacts(numbers: Numbers, r: Array, z: Array, contacts: tuple[Array, Array, Sequence[Piece]]) -> Array:
    radius, edge, pieces = contacts
    radius, edge = np.broadcast_to(radius, r.shape), np.broadcast_to(edge, r.shape)
    z = np.where((z > 0.0) & (z < SURFACE * (r + radius)), 0.0, z)
    total = superposed(numbers, r, z, pieces)
    pressed = np.flatnonzero((edge != 0.0) & (radius > 0.0))
    x, y, t = r[pressed], z[pressed], radius[pressed]
    field = np.array(numbers.of(punch(x, y, t, t - x)))
    rim = np.flatnonzero((x == t) & (y == 0.0))
    for rows, value in ((numbers.infinite, np.inf), (numbers.lost, np.nan)):
        field[np.ix_(np.array(rows), rim)] = value
    total[:, pressed] += edge[pressed] * field
    total[:, ~((r >= 0.0) & (z >= 0.0) & (radius >= 0.0))] = np.nan
    total[:, (np.isinf(r) | np.isinf(z)) & (radius >= 0.0)] = 0.0
    return total


def held(d: Result | None) -> dict[str, Result]:
    """A depth, where it is given."""
    return {} if d is None else {"d": d}


def stress_below(
    shape: Shape, r: Result, z: Result, given: Result, E_star: Result, nu: Result, **geometry: Result
) -> Stress:
    """The stress under the normal load."""
    found, (nu, E_star) = _found(STRESS, shape, r, z, given, geometry, nu=nu, E_star=E_star)
    return Stress(*plain(normal_stress(found, nu, E_star / np.pi)))


def displacement_below(
    shape: Shape, r: Result, z: Result, given: Result, nu: Result, **geometry: Result
) -> Displacement:
    """The displacement under the normal load."""
    found, (nu,) = _found(DISPLACEMENT, shape, r, z, given, geometry, nu=nu)
    return Displacement(*plain(normal_displacement(found, np.asarray(z), nu)))


def sliding_below(
    shape: Shape, r: Result, phi: Result, z: Result, given: Result,
    E_star: Result, nu: Result, mu: Result, inner: Result = None, **geometry: Result,
) -> SlidingStress:  # fmt: skip
    """What friction adds, with a zone of stick up to the radius `inner` if there is one."""
    if inner is not None:
        shape, geometry = partial(_slipping, shape), {"c": inner, **geometry}
    others = {"phi": phi, "nu": nu, "E_star": E_star, "mu": mu}
    found, (phi, nu, E_star, mu) = _found(FRICTION, shape, r, z, given, geometry, **others)
    return SlidingStress(*plain(frictional_stress(found, phi, nu, mu * E_star / np.pi)))


def _slipping(shape: Shape, given: Array, c: Array, **geometry: Array) -> tuple[Array, Array, Sequence[Piece]]:
    """A contact without the punches of the zone of stick: their tractions are taken from each other."""
    (radius, edge, pieces), (stuck, *_) = (shape(x, **geometry) for x in (given, c))
    # not as a difference of fields, which is infinite at a tip within the zone and has lost its digits beside it
    own = [p._replace(low=np.maximum(p.low, stuck), sharp=p.sharp & (stuck <= p.low)) for p in pieces]
    return np.where((stuck >= 0.0) & (stuck <= radius), radius, np.nan), edge, own


def _found(
    of: Numbers, shape: Shape, r: Result, z: Result, given: Result, geometry: dict[str, Result], **others: Result
) -> tuple[Array, list[Array]]:
    """The numbers, and the other arguments, over the shape to which all broadcast."""
    fields = {"r": r, "z": z, _given(geometry): given}
    known = [numbers(name, x) for own in (fields, geometry, others) for name, x in own.items()]
    r, z, given, *own = np.broadcast_arrays(*known)
    geometry = dict(zip(geometry, own, strict=False))
    return summed(of, shape, r, z, given, geometry), own[len(geometry) :]


def _given(geometry: dict[str, Result]) -> str:
    """What is given of the contact: its depth where the radius is one of the geometry."""
    return "d" if "a" in geometry else "a"


def greatest_below(
    shape: Shape, measure: Callable[[Stress], Array], given: Result, E_star: Result, nu: Result, **geometry: Result
) -> Greatest:
    """The greatest value of a measure below each contact, and where."""
    known = {_given(geometry): given, "E_star": E_star, "nu": nu, **geometry}
    own = np.broadcast_arrays(*(numbers(name, x) for name, x in known.items()))
    rows = []
    for a, modulus, ratio, *others in zip(*(np.ravel(x).tolist() for x in own), strict=True):
        rows.append(_greatest_of(shape, measure, a, modulus, ratio, dict(zip(geometry, others, strict=True))))
    columns = np.array(rows, float).reshape(-1, 3).T
    return Greatest(*plain([column.reshape(np.shape(own[0])) for column in columns]))


def _greatest_of(
    shape: Shape, measure: Callable[[Stress], Array], given: float, modulus: float, nu: float, known: dict[str, float]
) -> Greatest:
    with np.errstate(all="ignore"):
        radius, edge, pieces = shape(np.array([given]), **{name: np.array([x]) for name, x in known.items()})
    a = float(np.ravel(radius)[0])
    if not a > 0.0:
        return Greatest(0.0 if a == 0.0 else np.nan, np.nan, np.nan)
    if np.ravel(edge)[0] != 0.0:
        return Greatest(np.inf, a, 0.0)
    inner = [(float(np.ravel(p.low)[0]), bool(np.ravel(p.sharp)[0])) for p in pieces]
    inside = [low for low, _ in inner if low < a]
    sharp = [low for low, infinite in inner if infinite and low < a]
    if sharp and nu < 0.5:
        return Greatest(np.inf, sharp[0], 0.0)

    def value(r: Array, z: Array) -> Array:
        found = summed(STRESS, shape, r, z, np.full(r.shape, given), {n: np.full(r.shape, x) for n, x in known.items()})
        return measure(Stress(*normal_stress(found, nu, modulus / np.pi)))

    found = greatest(value, a, [0.0, *inside, a])
    return found if found.value > 0.0 else Greatest(0.0, np.nan, np.nan)


def plain(values: Sequence[Array]) -> list[Result]:
    """Floats where the arguments are numbers."""
    return [value[()] if np.ndim(value) else float(value) for value in values]


def normal_stress(found: Sequence[Array], nu: Array, scale: Array) -> list[Array]:
    """rr, tt, zz, rz of a pressure whose numbers `STRESS` these are; `scale` is E_star/pi."""
    pressed, half, whole, less, sheared = found
    with np.errstate(invalid="ignore"):
        infinite = np.isinf(pressed)
        # S_2, D_0 and z S_1/r, which stay finite
        second, deeper, slope = (
            np.where(infinite, 0.0, x) for x in (2.0 * half - pressed, whole - pressed, pressed - less)
        )
        mean, apart = (0.5 + nu) * pressed, (0.5 - nu) * second
        return [scale * x for x in (deeper - slope - mean + apart, slope - mean - apart, -whole, -sheared)]


def normal_displacement(found: Sequence[Array], z: Array, nu: Array) -> list[Array]:
    """Away from the axis and into the half-space, of the numbers `DISPLACEMENT`."""
    with np.errstate(invalid="ignore"):  # at a tip on the surface, and infinitely far away
        sunk, sheared = (np.where(np.isfinite(z * x), z * x, 0.0) for x in found[:2])
    outward = (1.0 - 2.0 * nu) * found[2] - sheared
    return [-outward / (np.pi * (1.0 - nu)), (2.0 * found[3] + sunk / (1.0 - nu)) / np.pi]


def frictional_stress(found: Sequence[Array], phi: Array, nu: Array, scale: Array) -> list[Array]:
    """What a traction mu p adds, as `SlidingStress`, of the numbers `FRICTION`; `scale` is mu E_star/pi."""
    first, half, slope, sheared, bent, less = found
    cos, sin = np.cos(phi), np.sin(phi)
    around = slope + nu * half
    along = sheared - 2.0 * first - around, around - 2.0 * nu * first, -sheared
    down, across = -scale * cos * (less + bent), scale * sin
    return [*(scale * cos * x for x in along), across * (first - around), down, across * less]


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
    with np.errstate(invalid="ignore"):  # of two that are infinite
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
    with np.errstate(invalid="ignore"):  # of two that are infinite
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
