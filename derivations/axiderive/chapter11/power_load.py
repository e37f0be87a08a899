"""Pressures p0 (1 - r**2/a**2)**s, Föppl's three among them, with the closed displacement of their chords."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp

from .draw import Draw

HALF = mp.mpf(1) / 2


def power_load(p0: Any, a: Any, exponent: Any) -> Callable[[Any], Any]:
    """p0 (1 - r**2/a**2)**exponent; Föppl took -1/2, 1/2 and 0."""
    return lambda r: p0 * ((1 - r / a) * (1 + r / a)) ** exponent


class PowerLoadChord:
    """Closed w1D of a power load: p0 a/E* B(s + 1, 1/2) (1 - xi**2/a**2)**(s + 1/2)."""

    def __init__(self, p0: Any, a: Any, exponent: Any, E_star: Any) -> None:
        self.a, self.power = a, exponent + HALF
        self.at_centre = p0 * a / E_star * mp.beta(exponent + 1, HALF)

    def __call__(self, xi: Any) -> Any:
        return self.at_centre * ((1 - xi / self.a) * (1 + xi / self.a)) ** self.power

    def slope(self, xi: Any) -> Any:
        factor = -2 * self.power * xi / self.a**2
        return self.at_centre * factor * ((1 - xi / self.a) * (1 + xi / self.a)) ** (self.power - 1)


def a_load(draw: Draw, lo: float = -0.5) -> tuple[Any, Any, Any, Any]:
    """a, p0, E*, and an exponent above -1."""
    return draw.length(), draw.stress(), draw.stress(5, 50), draw.number(lo, 1.5)
