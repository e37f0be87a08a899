"""The order of the letters in code, the functions of the runtime, and which letters are fields."""

from __future__ import annotations

import sympy as sp

from ..abel import masters
from ..stable import opaque

# material and load first, then lengths from the contact to the profile, intermediates and functions last
ORDER = (
    "E_star", "F", "P", "d", "n", "A", "h", "a", "r", "x", "L", "t", "u", "b", "R", "R1", "R2", "s", "wavelength",
    "theta", "r_zero",
)  # fmt: skip
FUNCTIONS = {
    sp.Abs: "np.abs",
    sp.tan: "np.tan", sp.sin: "np.sin", sp.cos: "np.cos", sp.asinh: "np.arcsinh", sp.sinh: "np.sinh",
    sp.cosh: "np.cosh", sp.tanh: "np.tanh", sp.exp: "np.exp", sp.log: "np.log", sp.atan: "np.arctan",
    sp.acos: "np.arccos", sp.asin: "np.arcsin", sp.acosh: "np.arccosh", sp.atanh: "np.arctanh",
    opaque.Log1p: "np.log1p", opaque.Expm1: "np.expm1", opaque.Arctan2: "np.arctan2",
    opaque.RootGap: "root_gap", opaque.ArctanGap: "arctan_gap", opaque.TanhGap: "tanh_gap",
    opaque.GammaRatio: "gamma_ratio",
    masters.Dawson: "dawson", opaque.ArcStrips: "arc_strips", opaque.PowerPressure: "power_pressure",
    opaque.PowerDisplacement: "power_displacement", opaque.PowerPunches: "power_punches",
    opaque.PowerStrips: "power_strips", opaque.SineRoot: "sine_root",
    opaque.DepthOverHeight: "depth_over_height",
}  # fmt: skip
HELPERS_OF = {
    "_functions": (
        "beside", "beside_cone", "depth_over_height", "difference_of_products", "lower_power", "nth_root", "sine_root",
        "without_root",
    ),
    "_special": ("arctan_gap", "dawson", "gamma_ratio", "root_gap", "struve_h0", "struve_h1", "tanh_gap"),
}  # fmt: skip
HELPERS = tuple(sorted(name for names in HELPERS_OF.values() for name in names))
OFFERED = tuple(f"..{module}: {', '.join(names)}" for module, names in HELPERS_OF.items())
"""What a module may import of them."""
VARYING = frozenset(("F", "P", "d", "a", "r", "x", "L", "t", "u", "c", "r_zero", "inner", "rho"))
"""Arguments of the functions and radii made from them: all else is one number where the parameters are numbers."""
