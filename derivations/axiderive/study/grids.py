"""Other ways on a grid, after their descriptions and not their authors' programs.

By parts with central differences and trapezoids (Benad 2018), convolution over
r**2 by FFT (Willert 2021); the boundary element method where tamaas is installed.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec

import numpy as np
from scipy import integrate

from .rivals import punch_pressure
from .subject import RADIUS, Array, Subject

a = RADIUS
WIDTH = 3.0
"""Side of the square in contact radii."""
TOLERANCE = 1e-9
ITERATIONS = 2000


def trapezoid_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """By parts, central differences and trapezoids on a uniform grid: radii and pressures."""
    x = np.linspace(0.0, a, count + 1)
    first = np.gradient(subject.depth(x), x, edge_order=2)
    second = np.gradient(first, x, edge_order=2)
    r = x[1:-1]
    kernel = np.arccosh(np.maximum(x / r[:, None], 1.0))
    kernel[:, -1] /= 2
    smooth = subject.modulus / np.pi * (first[-1] * np.arccosh(a / r) - x[1] * (kernel @ second))
    return r, smooth + punch_pressure(subject, r)


def trapezoid_displacement(subject: Subject, r: Array, count: int) -> Array:
    """Trapezoids over w_1D/sqrt(r**2 - x**2) on the same grid."""
    x = np.linspace(0.0, a, count + 1)
    sunk = subject.excess + subject.depth(np.float64(a)) - subject.depth(x)
    return 2 / np.pi * integrate.trapezoid(sunk / np.sqrt((r[:, None] - x) * (r[:, None] + x)), x, axis=1)


def trapezoid_force(subject: Subject, d: Array, count: int) -> Array:
    """A table of g on the grid, the radius by interpolation, the force by trapezoids."""
    x = np.linspace(0.0, a, count + 1)
    depth = subject.depth(x)
    below = np.concatenate([[0.0], np.cumsum((depth[1:] + depth[:-1]) / 2) * x[1]])
    first = int(np.searchsorted(x, subject.edge))
    reached = np.interp(d, depth[first:], x[first:])
    return 2 * subject.modulus * (d * reached - np.interp(reached, x, below))


def fft_pressure(subject: Subject, count: int) -> tuple[Array, Array]:
    """Convolution over r**2 with exact weights in each cell: radii and pressures.

    The density g'/(2x) is linear in a cell, or constant where it is infinite at a break.
    """
    squares = np.linspace(0.0, a * a, count + 1)
    x = np.sqrt(squares)
    rise = np.diff(subject.depth(x)) / squares[1]
    if subject.edge and not np.isfinite(_silent(subject.rate_math, subject.edge)):
        total = _convolution_of_steps(rise[::-1], squares[1])[::-1]
    else:
        density = np.append(rise[0], subject.rate(x[1:]) / (2 * x[1:]))
        total = _convolution(density[::-1], squares[1], count + 1)[::-1]
    return x[1:-1], subject.modulus / np.pi * total[1:-1]


def fft_displacement(subject: Subject, count: int) -> tuple[Array, Array]:
    """The same for w = 2/pi (d asin(a/r) - int g/sqrt(r**2 - x**2) dx), a < r < 2a."""
    squares = np.linspace(0.0, 4 * a * a, 4 * count + 1)
    x = np.sqrt(squares)
    near = x[: count + 1].copy()
    near[0] = 1e-8 * a
    total = _convolution(subject.depth(near) / (2 * near), squares[1], len(squares))
    w = 2 / np.pi * (subject.depth(np.float64(a)) * np.arcsin(np.minimum(a / x[1:], 1.0)) - total[1:])
    return x[count + 1 :], w[count:]


def _convolution(density: Array, cell: float, size: int) -> Array:
    """int density(y) (x - y)**(-1/2) dy from 0 to x at x = 0, cell, ..., the density linear between its nodes."""
    lag = np.arange(size, dtype=np.float64)
    zeroth, first = np.diff(2 * np.sqrt(lag)), np.diff(2 / 3 * lag**1.5)
    far, near = first - lag[:-1] * zeroth, lag[1:] * zeroth - first
    total = np.zeros(size)
    total[1:] += _convolved(density[:-1], far)[: size - 1]
    inner = density.copy()
    inner[0] = 0.0
    total[: size - 1] += _convolved(inner, near)[: size - 1]
    return math.sqrt(cell) * total


def _convolution_of_steps(density: Array, cell: float) -> Array:
    """The same for a density that is constant in each cell."""
    weights = np.diff(2 * np.sqrt(np.arange(len(density) + 1, dtype=np.float64)))
    total = _convolved(density, weights)[: len(density)]
    return math.sqrt(cell) * np.append(0.0, total)


def _convolved(one: Array, other: Array) -> Array:
    from scipy import signal  # which brings scipy.stats along: half a second that no other method needs

    return np.asarray(signal.fftconvolve(one, other))


def _silent(function: Callable[[float], float], x: float) -> float:
    try:
        return function(x)
    except ZeroDivisionError:
        return math.inf


def no_boundary_elements() -> str:
    """Why there are none to run; empty if there are."""
    return "" if find_spec("tamaas") else "tamaas is not installed (pip install tamaas)"


def boundary_elements(subject: Subject, force: float, count: int) -> tuple[Array, Array]:
    """By tamaas, under a prescribed force: radii and pressures of the cells in contact."""
    tamaas = import_module("tamaas")
    tamaas.set_log_level(tamaas.LogLevel.error)
    side = WIDTH * RADIUS
    centres = (np.arange(count) - count // 2 + 0.5) * side / count
    r = np.hypot(*np.meshgrid(centres, centres, indexing="ij"))
    model = tamaas.Model(tamaas.model_type.basic_2d, [side, side], [count, count])
    model.E, model.nu = subject.modulus, 0.0
    tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    # a sphere ends at its equator, the square beyond it is far from contact
    solver = tamaas.PolonskyKeerRey(model, -subject.height(np.minimum(r, subject.largest)), TOLERANCE)
    solver.setIntegralOperator("dcfft")
    solver.max_iter = ITERATIONS
    solver.solve(force / side**2)
    traction = np.array(model.traction).reshape(count, count)
    inside = r < RADIUS
    return r[inside], traction[inside]
