"""The elastic half-space, and the flat punch on it: the building block of every contact.

Homogeneous and power-law graded media differ in a modulus and an exponent only,
c_N(x) = modulus * |x|^k (11.65), so that every rule is stated once.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..abel.form import Form
from ..abel.moments import outside_kernel
from ..entry import Case, Entry, Quantity, Status
from ..notation import E_star, G_star, H, H_x, a, dgamma, k, r
from ..profiles.profile import Profile


@dataclass(frozen=True)
class Medium:
    """A half-space; the formulas are those of a flat punch of radius a pressed in by a unit depth."""

    modulus: sp.Symbol
    k: sp.Expr
    shear: sp.Symbol
    """The modulus along the surface."""
    name: str
    """Package below axicontact that holds the contacts on it; empty for the homogeneous half-space."""
    group: str
    """Prefix of the keys: cone.d on the homogeneous, cone.fgm.d on the graded half-space."""

    @property
    def graded(self) -> bool:
        """Whether the modulus depends on the depth."""
        return self.k != 0

    @property
    def moduli(self) -> tuple[sp.Symbol, ...]:
        """What the normal contact takes: the modulus, and the exponent if it is none but 0."""
        return (self.modulus, self.k) if self.graded else (self.modulus,)

    @property
    def force_scale(self) -> sp.Expr:
        """F = force_scale * F^."""
        return 2 * self.modulus

    @property
    def pressure_scale(self) -> sp.Expr:
        """p = pressure_scale * P^."""
        return self.modulus / sp.pi

    @property
    def displacement_scale(self) -> sp.Expr:
        """w = displacement_scale * W^."""
        return 2 * sp.cos(sp.pi * self.k / 2) / sp.pi

    def stiffness(self) -> sp.Expr:
        """dF/dd of a contact of radius a, (11.14), (11.46)."""
        return self.force_scale * a ** (1 + self.k) / (1 + self.k)

    def punch_pressure(self) -> sp.Expr:
        """(11.15), (11.47)."""
        return self.pressure_scale * (a**2 - r**2) ** ((self.k - 1) / 2)

    def punch_displacement(self) -> Form:
        """(11.12), (11.44), for r > a."""
        return outside_kernel(self.k) * self.displacement_scale

    def retraction(self) -> sp.Expr:
        """By which adhesion moves the punch, (11.31), and (11.66) corrected: without the factor a under the root."""
        return sp.sqrt(2 * sp.pi * dgamma * a ** (1 - self.k) / self.modulus)

    def key(self, *parts: str) -> str:
        """The parts with dots between them, empty ones left out: "cone.fgm.d"."""
        return ".".join(part for part in parts if part)

    def entry(
        self,
        profile: Profile,
        group: str,
        quantity: Quantity,
        status: Status,
        cases: tuple[Case, ...],
        definition: sp.Expr,
        parameters: tuple[sp.Symbol, ...],
        references: tuple[str, ...],
        note: str = "",
    ) -> Entry:
        """An entry of a contact on it, whose key has this group behind that of the medium."""
        key = self.key(profile.name, self.group, group, quantity.suffix)
        return Entry(key, profile, quantity, status, cases, definition, parameters, references, note=note)


HOMOGENEOUS = Medium(E_star, sp.S.Zero, G_star, "", "")
GRADED = Medium(H, k, H_x, "graded", "fgm")
