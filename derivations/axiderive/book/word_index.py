"""The index of words: what a reader may look for, and where the book speaks of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from typing import Any

WORDS: Mapping[str, str] = {
    "Abel integral": "part:definitions",
    "adhesion": "part:rules part:validity cone.adh.Fc paraboloid.adh.Fc",
    "adhesion map": "part:validity",
    "AFM tip": "paraboloid hyperboloid sphere_tipped_cone",
    "angle of a tip": "part:conventions cone",
    "approach of two bodies": "part:conventions",
    "area function": "hyperboloid part:conventions",
    "asperity": "gaussian paraboloid",
    "aspherical lens": "polynomial",
    "asymmetric load": "plane.eccentric_punch",
    "ball": "paraboloid sphere",
    "ball, flattened": "ellipsoid",
    "ball, worn": "truncated_paraboloid capped_paraboloid",
    "Barber": "concave_power",
    "bearing": "paraboloid plane.parabola",
    "Berkovich indenter": "cone part:conventions",
    "Berkovich indenter, blunted": "sphere_tipped_cone rounded_cone hyperboloid",
    "Beta function, incomplete": "part:functions",
    "blunt tip": "rounded_cone sphere_tipped_cone hyperboloid",
    "Boussinesq": "flat_punch part:definitions",
    "bump": "gaussian",
    "cap of a cylinder": "capped_cylinder",
    "Cattaneo": "paraboloid.tan.F part:rules",
    "certificate": "part:matrix",
    "check values": "part:howto",
    "colloidal probe": "sphere paraboloid",
    "complete contact": "flat_punch concave_power part:definitions",
    "complete elliptic integral": "part:functions",
    "compliance": "part:laws",
    "concave face": "concave_power concave_paraboloid concave_quartic",
    "cone": "cone",
    "cone, blunted": "rounded_cone sphere_tipped_cone",
    "cone, cut off": "truncated_cone",
    "contact modulus": "materials part:conventions",
    "contact radius from depth or force": "part:rules",
    "contact stiffness": "part:rules",
    "coupling of friction and pressure": "part:validity",
    "creep": "part:laws",
    "crowned roller": "plane.power_law plane.quartic",
    "cube corner": "part:conventions",
    "cup": "concave_paraboloid",
    "curved punch": "rounded_curved_punch capped_cylinder",
    "cylinder on its end": "flat_punch capped_cylinder",
    "cylinder on its side": "plane.parabola",
    "Dawson function": "part:functions gaussian",
    "depth": "part:conventions part:definitions part:master",
    "depth control": "part:rules",
    "Derjaguin, Muller and Toporov": "part:validity",
    "detachment": "part:rules",
    "diamond tip": "cone sphere_tipped_cone",
    "dimensionality reduction": "part:definitions part:study",
    "displacement of the surface": "part:definitions part:rules",
    "Dugdale model": "part:validity",
    "Dundurs' constant": "part:validity",
    "eccentric load": "plane.eccentric_punch",
    "edge, rounded": "rounded_punch rounded_curved_punch plane.rounded_punch",
    "edge, sharp": "flat_punch part:validity",
    "effective modulus": "materials part:conventions",
    "elastic constants": "materials part:conventions",
    "elastomer": "part:laws part:validity",
    "ellipsoid": "ellipsoid",
    "elliptic integrals": "part:functions part:conventions",
    "errata of chapter 11": "part:errata",
    "error of floating point": "part:study",
    "exponent of a profile": "power_law plane.power_law",
    "flat punch": "flat_punch plane.flat_punch",
    "flat punch with rounded edge": "rounded_punch plane.rounded_punch",
    "fluid, Maxwell": "part:laws",
    "force at a given depth": "part:rules",
    "force control": "part:rules",
    "foundation": "flat_punch plane.flat_punch",
    "fretting": "plane.rounded_punch part:rules",
    "friction": "part:rules part:validity",
    "full slip": "part:rules",
    "functionally graded material": "part:gradedrules",
    "Gaussian bump": "gaussian",
    "graded half-space": "part:gradedrules",
    "half-angle": "part:conventions",
    "half-space": "part:conventions part:validity",
    "Hertz": "paraboloid plane.parabola loads.hertzian",
    "Heß, rule of": "part:rules",
    "hyperboloid": "hyperboloid",
    "hypergeometric functions": "part:functions",
    "inclination of a flank": "part:conventions",
    "incompressible": "part:validity",
    "inverse relations": "part:rules",
    "JKR theory": "paraboloid.adh.Fc part:rules part:validity",
    "Kelvin--Voigt solid": "part:laws",
    "knife edge": "plane.wedge plane.rounded_wedge",
    "Kummer function": "part:functions",
    "layer": "part:validity",
    "Lee and Radok": "part:laws",
    "Legendre's chi function": "part:functions",
    "lens": "paraboloid sphere polynomial",
    "lift-off": "plane.eccentric_punch",
    "limits of validity": "part:validity",
    "line contact": "plane.parabola plane.wedge",
    "line load": "plane.parabola part:master",
    "Love": "cone loads.uniform",
    "Maugis": "part:validity",
    "Maxwell fluid": "part:laws",
    "mean pressure": "part:rules",
    "Mindlin": "paraboloid.tan.F part:rules",
    "modulus of an elliptic integral": "part:conventions",
    "modulus, reduced": "part:conventions",
    "nanoindentation": "cone sphere_tipped_cone part:conventions",
    "normal force": "part:definitions part:master",
    "O-ring": "plane.parabola",
    "paraboloid": "paraboloid",
    "paraboloid, cut off": "truncated_paraboloid",
    "paraboloid, flatter cap": "capped_paraboloid",
    "parameter $m=k^2$": "part:conventions",
    "partial slip": "paraboloid.tan.F part:rules",
    "peak pressure": "rounded_punch.pp power_law.pp rounded_curved_punch part:validity",
    "pin, worn": "rounded_punch rounded_curved_punch",
    "plane contact": "plane.wedge plane.parabola",
    "plastic yield": "part:validity part:stress",
    "Poisson ratio": "part:conventions",
    "polynomial": "polynomial",
    "power law": "power_law plane.power_law concave_power",
    "power-law creep": "part:laws",
    "power-law grading": "part:gradedrules",
    "prescribed pressure": "loads.uniform loads.hertzian",
    "pressure": "part:definitions part:rules",
    "proof": "part:matrix",
    "pull-off force": "paraboloid.adh.Fc cone.adh.Fc part:rules",
    "punch, rigid": "flat_punch rounded_punch",
    "pyramid": "part:conventions cone",
    "quartic profile": "quartic plane.quartic",
    "rail": "plane.rounded_punch plane.parabola",
    "ramp of the depth": "part:laws part:rules",
    "reduced modulus": "part:conventions",
    "relaxation": "part:laws",
    "retraction": "part:rules",
    "rigid body": "part:conventions",
    "ripples": "wavy_paraboloid",
    "roller": "plane.parabola plane.power_law",
    "rounded tip": "rounded_cone plane.rounded_wedge",
    "rubber": "part:laws part:validity",
    "run time": "part:study",
    "scratch tip": "sphere_tipped_cone cone",
    "seal": "plane.flat_punch plane.rounded_punch",
    "sextic profile": "sextic plane.sextic",
    "shear modulus, effective": "part:conventions",
    "shorthands": "part:conventions",
    "sign of the force": "part:conventions",
    "sliding": "part:rules",
    "slope, small": "part:validity",
    "Sneddon": "cone paraboloid part:definitions",
    "soft layer": "part:validity",
    "soil": "flat_punch part:gradedrules",
    "sphere": "sphere",
    "sphere and paraboloid compared": "part:validity",
    "sphero-conical tip": "sphere_tipped_cone",
    "standard solid": "part:laws",
    "steps of depth or force": "part:laws part:rules",
    "stick": "part:rules",
    "strip": "plane.flat_punch",
    "Struve functions": "part:functions",
    "superposition": "part:rules",
    "Tabor's number": "part:validity",
    "tangential force": "part:rules",
    "thickness of a layer": "part:validity",
    "tilt": "plane.eccentric_punch",
    "traction": "part:rules",
    "units": "part:notation part:conventions",
    "Vickers indenter": "cone part:conventions",
    "viscoelastic half-space": "part:laws part:rules",
    "von Mises stress": "part:stress",
    "wavy surface": "wavy_paraboloid",
    "wear": "rounded_punch truncated_cone truncated_paraboloid",
    "wedge": "plane.wedge plane.rounded_wedge plane.truncated_wedge",
    "wheel": "plane.parabola paraboloid",
    "work of adhesion": "part:rules",
    "yield": "part:validity",
    "Young's modulus": "part:conventions",
}
"""Words, each with parts, profiles and keys by their names; the search of the web edition shows them in this order."""


def word_index(
    summaries: Sequence[Mapping[str, Any]], contents: Mapping[str, Any], within: Mapping[str, str]
) -> list[tuple[str, list[str]]]:
    """Words in alphabetical order with the labels of their places, those that this edition has, by page.

    Parameters
    ----------
    summaries : sequence of mapping
        The profiles in their order.
    contents : mapping
        The parts before and behind them.
    within : mapping
        Labels of sections, and the part they stand in.
    """
    pages = {label: (0, i) for i, (_, _, label) in enumerate(contents["front"])}
    pages |= {label: (2, i) for i, (_, _, label) in enumerate(contents["back"])}
    pages |= {label: pages[part] for label, part in within.items()}
    for i, m in enumerate(summaries):
        pages |= {f"sec:{m['name']}": (1, i)} | {f"eq:{key}": (1, i) for key in m["keys"]}
    keys = {key for m in summaries for key in m["keys"]}
    found = []
    for word, names in WORDS.items():
        labels = [label for label in (_label(name, keys) for name in names.split()) if label in pages]
        if labels:
            found.append((word, sorted(labels, key=pages.__getitem__)))
    return sorted(found, key=lambda one: one[0].replace("ß", "ss").lower())


def _label(name: str, keys: AbstractSet[str]) -> str:
    if name.startswith("part:"):
        return name
    return f"eq:{name}" if name in keys else f"sec:{name}"
