"""The table of the notation and the index of symbols.

The table of the notation: the records of the symbols by subject, and the names that only print has.

The index of symbols: in which sections of the book a symbol occurs.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

import sympy as sp

from .. import notation as nt
from ..print.words import domain, prose
from ..profiles.pools import POOLS

Row = dict[str, str]
IN_PRINT: dict[str, tuple[str, str, str]] = {
    ":foundation": (r"w_{\mathrm{1D}}", "m", "displacement of the one-dimensional foundation"),
    ":least_depth": (r"d_{\mathrm{min}}", "m", "least depth of a complete contact"),
    ":least_force": (r"F_{\mathrm{min}}", "N", "least normal force of a complete contact"),
    ":least_load": (r"P_{\mathrm{min}}", "N/m", "least line load of a complete contact"),
    ":kappa": (r"\kappa,\;\kappa_j", "1", "factor of a power of the radius, stated in the panel of its profile"),
    ":coefficients": ("A_j", "m^(1-j)", "coefficients of a polynomial profile"),
    ":modulus": ("k", "1", "modulus of the elliptic integrals"),
    ":last": ("c", "1", "last parameter of a hypergeometric function"),
    ":shorthands": (r"s,\;\psi,\;\varphi_0", "", "in many rows: the shorthands of the conventions"),
    ":roots": ("q", "", "a root, said behind its formula"),
    ":place": ("x", "m", "coordinate of the one-dimensional foundation, and lower limit of an integral over it"),
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
    ":section": ("z", "m", "depth below the surface"),
    ":pressed": (r"S_0,\;S_1,\;S_2,\;S_3", "1", "what is left of the pressure at a depth"),
    ":deeper": (r"D_0,\;D_1,\;D_2,\;D_3", "1", "what they lose with the depth, times the depth"),
    ":potential": ("W", "m", "potential of the displacement"),
    ":stresses": (r"\sigma_{rr},\;\sigma_{tt},\;\sigma_{zz}", "Pa", "normal stresses, tension positive"),
    ":shears": (r"\tau_{rt},\;\tau_{rz},\;\tau_{tz}", "Pa", "shear stresses"),
    ":moved": (r"u_{r},\;u_{z}", "m", "displacement away from the axis and into the half-space"),
    ":direction": (r"\varphi", "rad", "angle from the direction of the traction"),
    ":history": (r"F_{\mathrm N}(t)", "N", "normal force over the time"),
    ":relaxation": ("E(t)", "Pa", "effective modulus after a step of the strain"),
    ":creep": ("J(t)", "1/Pa", "compliance after a step of the stress"),
    ":ramp": (r"\Phi_m(t)", "Pa", "effective modulus that a ramp of the depth meets"),
    ":power": ("m", "1", "power of the depth with which the elastic force grows"),
}  # fmt: skip
"""LaTeX, unit and meaning of what has a name in print, and no record or one of several."""
SUBJECTS: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("Contact", (
        "r", "a", "d", "F", "p", "p_mean", "p_peak", "r_peak", "w", "f", "g", "t", ":foundation", ":place", "r_zero",
        ":least_depth", ":least_force",
    )),
    ("Profile", (
        "theta", "R", "R1", "R2", "b", "n", "A", ":kappa", ":coefficients", ":index", "N", "h", "s", "wavelength", "C",
    )),
    ("Half-space", (
        "E_star", "G_star", "young_1", "young_2", "nu_1", "nu_2", "k", "H", "H_x", "E_0", "c_0", "nu", "beta", "h_N",
        ":modulus", ":last", ":shorthands", ":roots",
    )),
    ("Adhesion", (
        "dgamma", "retraction", ":adhesive_depth", ":adhesive_force", ":adhesive_pressure",
        ":pull_off_radius", ":pull_off_force", ":pull_off_depth",
    )),
    ("Friction", ("mu", "c", "F_x", "tau", ":sliding")),
    ("Below the surface", (
        ":section", ":pressed", ":deeper", ":potential", ":stresses", ":shears", ":moved", ":direction",
    )),
    ("Viscoelastic half-space", (
        "time", "v", ":history", ":relaxation", ":creep", ":ramp", ":power",
        "E", "E_inf", "E_1", "eta", "relaxation", "alpha", "t_0",
    )),
    ("Plane contact", ("P", ":least_load", "L", "x", "x_zero", "slope", "tilt", "width", "e")),
    ("Prescribed pressure", ("p_0", "sigma")),
)  # fmt: skip
"""Names of records in the order of the table; those with a colon are of `IN_PRINT`."""
SAID = {"x": "distance from the middle of a plane contact"}
"""Meanings in print that are shorter than those of the records, which speak of derivations too."""
INSTEAD = {
    "a_c": ":pull_off_radius", "u_0": ":sliding", "j": ":index", "z": ":section", "W": ":potential",
    **{f"S_{m}": ":pressed" for m in range(4)}, **{f"D_{m}": ":deeper" for m in range(4)},
}  # fmt: skip
"""Records whose symbol stands in the row of a name in print."""


ROOTS = ("m", "v", r"\ell")
"""Letters of roots that mean something else in other rows; s has a row of its own."""


def by_subject(used: AbstractSet[str], entries: Sequence[Mapping[str, Any]]) -> list[tuple[str, list[Row]]]:
    """The rows of the table by subject, for a book whose formulas use the symbols of these names.

    The entries are summaries: a letter that means different things in them has a row for each.
    """
    known = used | {"N", *IN_PRINT}
    meanings = _by_meaning({m["name"]: m["number"] for m in entries})
    meanings["width"] = [
        _row("width") | {"meaning": _within("width of the contact", [m for m in entries if "width" in m["symbols"]])}
    ]
    meanings[":roots"] = [
        _row(":roots") | {"name": f"print-root-{i}", "latex": letter, "meaning": _within(IN_PRINT[":roots"][2], own)}
        for i, letter in enumerate(ROOTS)
        if (own := [m for m in entries if letter in m["roots"]])
    ]
    return [
        (title, [row for name in names if name in known for row in meanings.get(name) or [_row(name)]])
        for title, names in SUBJECTS
    ]


def _within(meaning: str, entries: Sequence[Mapping[str, Any]]) -> str:
    """The words with the entries that they hold in."""
    places = dict.fromkeys(rf"\hyperref[sec:{m['name']}]{{{m['number']}}}" for m in entries if not m["host"])
    return f"{prose(meaning)} ({', '.join(places)})"


def _by_meaning(numbers: Mapping[str, str]) -> dict[str, list[Row]]:
    """Of the symbols that profiles have words of their own for: a row for every meaning, with its entries."""
    found: dict[sp.Symbol, dict[str, dict[str, str]]] = {}
    for pool in POOLS:
        for profile_id in (own for own in map(pool.id, pool.names) if own in numbers):
            for symbol, meaning in pool.load(profile_id.rpartition(".")[2]).meanings:
                places = found.setdefault(symbol, {}).setdefault(meaning, {})
                places.setdefault(numbers[profile_id], rf"\hyperref[sec:{profile_id}]{{{numbers[profile_id]}}}")
    return {symbol.name: _rows_by_meaning(symbol.name, meanings) for symbol, meanings in found.items()}


def _rows_by_meaning(name: str, meanings: Mapping[str, Mapping[str, str]]) -> list[Row]:
    plain = _row(name)
    return [
        plain | {"name": f"{name}-{i}" if i else name, "meaning": f"{prose(meaning)} ({', '.join(entries.values())})"}
        for i, (meaning, entries) in enumerate(meanings.items())
    ]


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


NAMES = {"u_0": "u"}
"""Symbols that the rows print under another name than that of their record."""


def symbol_index(summaries: Sequence[Mapping[str, Any]]) -> list[tuple[str, list[tuple[str, str]]]]:
    """The symbols with the runs of sections whose formulas hold them: the name of the first, 1.1--1.5."""
    found = []
    for symbol in nt.all_notation():
        places = [(m["name"], m["number"]) for m in summaries if symbol.name in m["symbols"]]
        if places and symbol.name not in ("j", "N", "stiffness") and 2 * len(places) <= len(summaries):
            found.append((NAMES.get(symbol.name, symbol.latex), _runs(places)))
    return sorted(found, key=lambda one: _alphabetical(one[0]))


GREEK = ("alpha", "beta", "gamma", "Delta", "eta", "theta", "lambda", "mu", "nu", "sigma", "tau", "varphi", "psi")


def _alphabetical(latex: str) -> tuple[int, str, str]:
    """Latin letters before Greek ones, small letters before their capitals, a bar and a type for nothing."""
    first = re.match(r"\\([A-Za-z]+)", latex)
    greek = GREEK.index(first[1]) + 1 if first and first[1] in GREEK else 0
    letters = re.sub(r"\\(?:bar|frac|mathrm)(?![a-z])|[^\w*]|_", "", latex)
    return greek, letters.lower(), letters.swapcase()


def _runs(places: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Sections that follow each other in a chapter as one range, with the name of the first."""
    found: list[tuple[str, str, str]] = []
    for name, number in places:
        chapter, _, section = number.partition(".")
        if found and found[-1][2] == f"{chapter}.{int(section) - 1}":
            found[-1] = (*found[-1][:2], number)
        else:
            found.append((name, number, number))
    return [(name, first if first == last else f"{first}--{last}") for name, first, last in found]
