"""The half-space of modulus E_0 (z/c_0)**k at random constants."""

from __future__ import annotations

from typing import Any, NamedTuple

import mpmath as mp

from .draw import Draw


class Medium(NamedTuple):
    """E_0, c_0, k, nu and the number h_N(k, nu) of chapter 9, which chapter 11 leaves open and so is random here."""

    E0: Any
    c0: Any
    k: Any
    nu: Any
    h_N: Any

    @property
    def H(self) -> Any:
        """h_N E_0 / ((1 - nu**2) c_0**k), which takes the place of E*."""
        return self.h_N * self.E0 / ((1 - self.nu**2) * self.c0**self.k)

    @property
    def E_star(self) -> Any:
        """Effective modulus of the depth c_0 under a rigid indenter."""
        return self.E0 / (1 - self.nu**2)

    def foundation(self, x: Any) -> Any:
        """Stiffness per length of the Winkler foundation, (9.4)."""
        return self.h_N * self.E0 / (1 - self.nu**2) * (abs(x) / self.c0) ** self.k

    def homogeneous(self) -> Medium:
        return self._replace(k=mp.mpf(0))


def exponent(draw: Draw) -> Any:
    """k of either sign, away from the ends of -1 < k < 1 where the quadratures slow down."""
    return draw.sign() * draw.number(0.05, 0.5)


def medium(draw: Draw) -> Medium:
    return Medium(draw.stress(5, 50), draw.length(), exponent(draw), draw.number(0, 0.5), draw.number(0.5, 1.5))
