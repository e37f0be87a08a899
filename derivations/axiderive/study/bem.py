"""Pressures by the boundary element method, where tamaas is installed: prescribed force, a square three radii wide."""

from __future__ import annotations

from importlib import import_module
from importlib.util import find_spec

import numpy as np

from .problems import RADIUS
from .subject import Array, Subject

WIDTH = 3.0
"""Side of the square in contact radii."""
TOLERANCE = 1e-9
ITERATIONS = 2000


def missing() -> str:
    """Why there is nothing to run; empty if there is."""
    return "" if find_spec("tamaas") else "tamaas is not installed (pip install tamaas)"


def pressure(subject: Subject, force: float, count: int) -> tuple[Array, Array]:
    """Radii and pressures of the cells whose centres are in contact."""
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
