"""The generated rule with its number of nodes left open: Gauss-Legendre after the substitution of the catalogue.

In s = sqrt(t**2 - b**2) the depth g has no root, and s = c cosh(v) for r > b,
c sinh(v) for r < b, takes the kernel 1/sqrt(t**2 - r**2) into dv.
"""

from __future__ import annotations

from functools import cache

import numpy as np

from ..emit.nodes import gauss_legendre
from .subject import RADIUS, Array, Subject


@cache
def legendre(count: int) -> tuple[Array, Array]:
    """Nodes on (0, 1) and weights, rounded from certified enclosures."""
    nodes, weights = np.array(gauss_legendre(count)).T
    return nodes, weights


def pressure(subject: Subject, r: Array, count: int) -> Array:
    """(11.23) in v."""
    a, b = RADIUS, subject.edge
    within = r < b
    scale = np.sqrt(np.abs(r - b) * (r + b))
    reach = np.where(within, np.sqrt((a - b) * (a + b)), np.sqrt((a - r) * (a + r)))
    stop, total = np.arcsinh(reach / scale), 0.0
    for node, weight in zip(*legendre(count), strict=True):
        v = node * stop
        total = total + weight * subject.growth(scale * np.where(within, np.sinh(v), np.cosh(v)))
    return subject.modulus / np.pi * stop * total


def displacement(subject: Subject, r: Array, count: int) -> Array:
    """(11.26) in s = sqrt(r**2 - b**2) sin(v)."""
    a, b = RADIUS, subject.edge
    scale = np.sqrt((r - b) * (r + b))
    stop = np.arctan2(np.sqrt((a - b) * (a + b)), np.sqrt((r - a) * (r + a)))
    total = 0.0
    for node, weight in zip(*legendre(count), strict=True):
        v = node * stop
        s, beyond = scale * np.sin(v), scale * np.cos(v)
        total = total + weight * subject.growth(s) * np.arctan2(np.sqrt(b * b + s * s), beyond) * beyond
    return 2 / np.pi * stop * total
