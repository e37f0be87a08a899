"""Materials, loads and parameters of the worked examples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp


@dataclass(frozen=True)
class Material:
    """Two bodies as the example names them: Young's modulus in Pa of each that gives way, and how hard they are.

    The strength is a mean pressure in Pa beyond which the softer body yields or tears, a round number; the work of
    separation is in J/m^2.
    """

    words: str
    young: int
    poisson: str
    strength: float
    yielding: int = 1
    friction: str = "0.3"
    separation: float = 0.0

    @property
    def modulus(self) -> sp.Rational:
        """E_star in Pa."""
        return sp.Rational(self.young) / (self.yielding * (1 - sp.Rational(self.poisson) ** 2))

    @property
    def shear(self) -> sp.Rational:
        """G_star in Pa."""
        poisson = sp.Rational(self.poisson)
        return sp.Rational(self.young) * 2 / (self.yielding * (1 + poisson) * (2 - poisson))


STEEL = Material(r"steel on steel, $E=210$\,GPa, $\nu=0.3$", 210 * 10**9, "0.3", 2e9, 2)
PMMA = Material(r"diamond on PMMA, $E=3$\,GPa, $\nu=0.4$ (diamond rigid)", 3 * 10**9, "0.4", 0.3e9)
SILICONE = Material(
    r"rigid on silicone rubber, $E=2$\,MPa, $\nu=0.5$, $\Delta\gamma=50$\,mJ/m$^2$",
    2 * 10**6, "0.5", 0.5e6, friction="0.8", separation=0.05,
)  # fmt: skip
BLOCK = Material(r"steel, $E=210$\,GPa, $\nu=0.3$", 210 * 10**9, "0.3", 2e9)


@dataclass(frozen=True)
class Graded:
    """A half-space whose modulus is E_0 (z/c_0)^k, under a rigid body; SI units."""

    words: str
    E_0: str
    c_0: str
    k: str
    nu: str
    strength: float


CARTILAGE = Graded("articular cartilage", "6e6", "1e-3", "0.4", "0.45", 2e6)
CERAMIC = Graded("alumina with glass in its surface", "250e9", "1e-3", "0.15", "0.22", 5e9)
POLYMER = Graded("a polymer with a soft surface", "3e9", "1e-6", "0.2", "0.4", 0.3e9)


@dataclass(frozen=True)
class Relaxing:
    """A standard solid under a rigid body: effective moduli in Pa, relaxation time in s."""

    words: str
    E_inf: str
    E_1: str
    relaxation: str


ELASTOMER = Relaxing("damping rubber", "2e6", "1e6", "10")
POLYETHYLENE = Relaxing("polyethylene", "0.6e9", "0.6e9", "10")
ACRYLIC = Relaxing("PMMA", "2.9e9", "0.7e9", "100")


@dataclass(frozen=True)
class Case:
    """Material, load in N (plane contact: N/m), and the parameters in SI units."""

    material: Material
    load: float
    parameters: Mapping[str, str]
    remark: str = ""
    """What a reader has to know of the numbers; without one the mean pressure stays below the strength."""


BERKOVICH = r"half-angle $70.3^\circ$, tip radius 100\,nm; taken as elastic, PMMA yields earlier"

CASES = {
    "cone": Case(SILICONE, 0.05, {"theta": "0.14"}),
    "paraboloid": Case(SILICONE, 0.02, {"R": "5e-3"}),
    "quartic": Case(STEEL, 50.0, {"A": "2e6"}),
    "sextic": Case(STEEL, 50.0, {"A": "4e12"}),
    "power_law": Case(STEEL, 50.0, {"n": "3", "A": "1e4"}),
    "polynomial": Case(STEEL, 100.0, {"A_1": "0.01", "A_2": "20", "A_3": "2e4"}),
    "sphere": Case(SILICONE, 0.5, {"R": "5e-3"}),
    "ellipsoid": Case(SILICONE, 0.5, {"h": "4e-3", "b": "5e-3"}),
    "hyperboloid": Case(PMMA, 0.02, {"theta": "0.12", "b": "1e-6"}),
    "truncated_cone": Case(STEEL, 500.0, {"theta": "0.05", "b": "5e-4"}),
    "truncated_paraboloid": Case(STEEL, 500.0, {"R": "20e-3", "b": "5e-4"}),
    "rounded_cone": Case(PMMA, 0.006432, {"theta": "0.34383", "b": "3.58e-8"}, BERKOVICH),
    "capped_paraboloid": Case(STEEL, 200.0, {"R1": "50e-3", "R2": "20e-3", "b": "3e-4"}),
    "rounded_punch": Case(STEEL, 20e3, {"R": "2e-3", "b": "5e-3"}),
    "rounded_curved_punch": Case(STEEL, 60e3, {"R1": "1", "R2": "2e-3", "b": "5e-3"}),
    "wavy_paraboloid": Case(SILICONE, 0.02, {"R": "5e-3", "h": "1e-7", "wavelength": "2e-4"}),
    "gaussian": Case(SILICONE, 0.02, {"h": "2e-4", "s": "1e-3"}),
    "sphere_tipped_cone": Case(PMMA, 0.006429, {"R": "1e-7", "theta": "0.34383"}, BERKOVICH),
    "flat_punch": Case(STEEL, 1e3, {"a": "2e-3"}),
    "capped_cylinder": Case(STEEL, 5e3, {"a": "2e-3", "R": "0.5"}),
    "concave_power": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6", "n": "3"}),
    "concave_paraboloid": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6"}),
    "concave_quartic": Case(STEEL, 5e3, {"a": "2e-3", "h": "2e-6"}),
    "plane.wedge": Case(STEEL, 1e5, {"theta": "0.01"}),
    "plane.parabola": Case(STEEL, 1e5, {"R": "20e-3"}),
    "plane.quartic": Case(STEEL, 1e5, {"A": "5e6"}),
    "plane.sextic": Case(STEEL, 1e5, {"A": "2e13"}),
    "plane.power_law": Case(STEEL, 1e5, {"A": "1e4", "n": "3"}),
    "plane.truncated_wedge": Case(STEEL, 5e5, {"theta": "0.02", "b": "5e-4"}),
    "plane.rounded_wedge": Case(STEEL, 1e5, {"theta": "0.01", "b": "5e-5"}),
    "plane.rounded_punch": Case(STEEL, 1e6, {"R": "2e-3", "b": "5e-3"}),
    "plane.concave_power": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6", "n": "3"}),
    "plane.concave_parabola": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6"}),
    "plane.concave_quartic": Case(STEEL, 1e6, {"a": "2e-3", "h": "1e-6"}),
    "plane.flat_punch": Case(STEEL, 1e5, {"a": "1e-3"}),
}
