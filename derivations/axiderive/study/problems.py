"""What the study measures and at which parameters."""

from __future__ import annotations

from typing import Any

from .. import notation as nt
from ..profiles import COMPACT_NAMES

NAMES = ("cone", "paraboloid", "rounded_punch", "truncated_cone", "sphere", "power_law")
"""Normal contacts that are measured beside every other way, whether a rule evaluates them or not."""
QUANTITIES = ("p", "Fd", "w")
GRADED, ADHESIVE = "power_law.fgm", ("paraboloid.adh", "cone.adh")
OTHERS = {GRADED: QUANTITIES, **dict.fromkeys(ADHESIVE, ("ad",))}
"""On a graded half-space, and with adhesion: the quantities of their own."""
NORMAL = {
    **dict.fromkeys(("power_law", "polynomial", "hyperboloid", "truncated_cone", "truncated_paraboloid"), ("p", "w")),
    **dict.fromkeys(("rounded_cone", "capped_paraboloid", "rounded_punch", "rounded_curved_punch"), ("p", "w")),
    **dict.fromkeys(("sphere", "ellipsoid"), ("w",)),
    **dict.fromkeys(("sphere_tipped_cone", "gaussian"), ("p", "w", "Fd")),
    **dict.fromkeys(("wavy_paraboloid", "concave_power"), ("p", "w")),
}
"""Normal contacts and their quantities that the catalogue evaluates by a rule, in the order of the handbook."""
RULED = {
    **NORMAL,
    **{f"{name}.fgm": ("p", "w") for name in (*COMPACT_NAMES, "capped_cylinder", "concave_power")},
    **{f"{name}.fgm": ("w",) for name in ("concave_paraboloid", "concave_quartic")},
    **{f"plane.{name}": ("p",) for name in ("power_law", "rounded_wedge", "rounded_punch", "concave_power")},
}
"""The same with the graded and the plane contacts."""
EVERY = dict.fromkeys(NAMES, QUANTITIES) | {name: RULED[name] for name in NORMAL if name not in NAMES} | OTHERS
EVERY |= {name: RULED[name] for name in RULED if name not in EVERY}
"""The quantities of each problem whose error is measured against run time."""
RADIUS = 2.0
PARAMETERS = {
    nt.theta: 0.35, nt.b: 1.0, nt.R: 3.0, nt.A: 0.5, nt.n: 2.7, nt.E_star: 1.0, nt.H: 1.0, nt.k: 0.4, nt.dgamma: 0.01,
    nt.P: 0.5,
}  # fmt: skip
FURTHER: dict[str, dict[Any, Any]] = {
    "capped_cylinder": {nt.d: 1.5},
    "capped_paraboloid": {nt.R1: 6.0, nt.R2: 3.0},
    **dict.fromkeys(("concave_power", "concave_paraboloid", "concave_quartic"), {nt.h: 0.1, nt.d: 0.5}),
    "ellipsoid": {nt.h: 2.0, nt.b: 3.0},
    "gaussian": {nt.h: 0.5, nt.s: 2.0},
    "polynomial": {nt.coefficients: (0.02, 0.1, 0.03)},
    "rounded_curved_punch": {nt.R1: 6.0, nt.R2: 3.0},
    "wavy_paraboloid": {nt.h: 0.01, nt.wavelength: 1.0},
}
"""What single profiles have beside these."""
