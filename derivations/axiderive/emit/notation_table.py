"""The table of the notation: the records of the symbols by subject, and the names that only print has."""

from __future__ import annotations

import re
from collections.abc import Set as AbstractSet

from .. import notation as nt
from .prose import domain, prose

Row = dict[str, str]
IN_PRINT: dict[str, tuple[str, str, str]] = {
    ":foundation": (r"w_{\mathrm{1D}}", "m", "displacement of the one-dimensional foundation"),
    ":least_depth": (r"d_{\mathrm{min}}", "m", "least depth of a complete contact"),
    ":least_force": (r"F_{\mathrm{min}}", "N", "least normal force of a complete contact"),
    ":least_load": (r"P_{\mathrm{min}}", "N/m", "least line load of a complete contact"),
    ":kappa": (r"\kappa,\;\kappa_j", "1", "factor of a power of the radius, stated in the panel of its profile"),
    ":coefficients": ("A_j", "m^(1-j)", "coefficients of a polynomial profile"),
    ":index": ("j", "1", "index of a sum"),
    ":adhesive_depth": (r"d_{\mathrm{adh}},\;w_{\mathrm{adh}}", "m", "depth and displacement with adhesion"),
    ":adhesive_force": (r"F_{\mathrm{adh}}", "N", "normal force with adhesion at a given contact radius"),
    ":adhesive_pressure": (r"p_{\mathrm{adh}}", "Pa", "pressure with adhesion, tensile at the edge"),
    ":pull_off_radius": (
        r"a_{\mathrm c},\;a_{\mathrm m}", "m", "contact radius at pull-off, under force and under depth control"
    ),
    ":pull_off_force": (
        r"F_{\mathrm c},\;F_{\mathrm m}", "N", "normal force at pull-off, under force and under depth control"
    ),
    ":pull_off_depth": (
        r"d_{\mathrm c},\;d_{\mathrm m}", "m", "depth at pull-off, under force and under depth control"
    ),
    ":sliding": (r"u,\;u_{\mathrm s}", "m", "tangential displacement of the rigid body, and the one at full slip"),
    ":history": ("F(t)", "N", "normal force over the time"),
    ":relaxation": ("E(t)", "Pa", "effective modulus after a step of the strain"),
    ":creep": ("J(t)", "1/Pa", "compliance after a step of the stress"),
    ":ramp": (r"\Phi_m(t)", "Pa", "effective modulus that a ramp of the depth meets"),
    ":power": ("m", "1", "power of the depth with which the elastic force grows"),
}  # fmt: skip
"""LaTeX, unit and meaning of what has a name in print, and no record or one of several."""
SUBJECTS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("Contact", (
        "r", "a", "d", "F", "p", "p_mean", "w", "f", "g", "t", ":foundation", "r_zero", ":least_depth", ":least_force",
    )),
    ("Profile", (
        "theta", "R", "R1", "R2", "b", "n", "A", ":kappa", ":coefficients", ":index", "N", "h", "s", "wavelength", "C",
    )),
    ("Half-space", (
        "E_star", "G_star", "young_1", "young_2", "nu_1", "nu_2", "k", "H", "H_x", "E_0", "c_0", "nu", "beta", "h_N",
    )),
    ("Adhesion", (
        "dgamma", "retraction", ":adhesive_depth", ":adhesive_force", ":adhesive_pressure",
        ":pull_off_radius", ":pull_off_force", ":pull_off_depth",
    )),
    ("Friction", ("mu", "c", "F_x", "tau", ":sliding")),
    ("Viscoelastic half-space", (
        "time", "v", ":history", ":relaxation", ":creep", ":ramp", ":power",
        "E", "E_inf", "E_1", "eta", "relaxation", "alpha", "t_0",
    )),
    ("Plane contact", ("P", ":least_load", "L", "x", "x_zero", "slope", "tilt", "width", "e")),
    ("Prescribed pressure", ("p_0", "sigma")),
)  # fmt: skip
"""Names of records in the order of the table; those with a colon are of `IN_PRINT`."""
FURTHER: tuple[tuple[str, str, str], ...] = (
    ("b", "m", r"\hyperref[sec:ellipsoid]{ellipsoid}: half an axis, across; "
     r"\hyperref[sec:hyperboloid]{hyperboloid}: radius at the tip times $\tan\theta$"),
    ("c", "1", r"in ${}_{2}\mathrm{F}_{1}$ and ${}_{1}\mathrm{F}_{1}$: the last parameter"),
    ("h", "m", r"\hyperref[sec:ellipsoid]{ellipsoid}: half an axis, along the load; "
     r"\hyperref[sec:wavy_paraboloid]{wavy paraboloid}: amplitude, half of the height from valley to peak; "
     r"\hyperref[sec:concave_power]{concave faces}: depth of the face"),
    ("k", "1", "in elliptic integrals: the modulus"),
    (r"s,\;\psi,\;\varphi_0", "", "in many rows: the shorthands of the conventions"),
)  # fmt: skip
"""LaTeX, unit and meaning of letters that stand for something else in some places."""
SAID = {"x": "distance from the middle of a plane contact"}
"""Meanings in print that are shorter than those of the records, which speak of derivations too."""
INSTEAD = {"a_c": ":pull_off_radius", "u_0": ":sliding", "j": ":index"}
"""Records whose symbol stands in the row of a name in print."""


def by_subject(used: AbstractSet[str]) -> list[tuple[str, list[Row]]]:
    """The rows of the table by subject, for a book whose formulas use the symbols of these names."""
    known = used | {"N", *IN_PRINT}
    found = [(title, [_row(name) for name in names if name in known]) for title, names in SUBJECTS]
    further = [
        {"name": f"further-{i}", "latex": latex, "unit": unit, "meaning": meaning, "domain": ""}
        for i, (latex, unit, meaning) in enumerate(FURTHER)
    ]
    return [*found, ("The same letters elsewhere", further)]


def recorded(used: AbstractSet[str]) -> list[Row]:
    """The symbols of these names, in the order of the notation."""
    left_out = {"j", "N", "stiffness"}
    return [_row(record.name) for record in nt.all_notation() if record.name in used - left_out]


def _row(name: str) -> Row:
    if name in IN_PRINT:
        latex, unit, meaning = IN_PRINT[name]
        limits = ""
    else:
        n = nt.describe(name)
        latex, unit, meaning, limits = n.latex, n.unit, SAID.get(name, n.meaning), domain(n)
    anchor = name.replace(":", "print-")
    return {"name": anchor, "latex": latex, "unit": _unit(unit), "meaning": prose(meaning), "domain": limits}


def _unit(unit: str) -> str:
    text = re.sub(r"\^\(([^()]*)\)", lambda m: f"$^{{{m[1]}}}$", unit)
    return re.sub(r"\^(\d+)", lambda m: f"$^{{{m[1]}}}$", text)
