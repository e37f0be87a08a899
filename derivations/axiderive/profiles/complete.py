"""Indenters whose edge bounds the contact, in the order of lists."""

from __future__ import annotations

import sympy as sp

from ..notation import R, a, h, n, r
from .profile import Piece, Profile, Rule, Sketch

PROFILES = (
    Profile(
        name="flat_punch",
        title="Flat punch",
        subtitle="The elementary building block: every other contact is a superposition of flat punches.",
        contact="complete",
        parameters=(a,),
        pieces=(Piece(None, sp.S.Zero),),
        validity="sharp edge, frictionless",
        sources=("Boussinesq 1885", "Schubert 1942"),
        sketch=Sketch(((a, 1.0),), a=1.0, d=0.25),
        note="the pressure is infinite at the edge",
    ),
    Profile(
        name="capped_cylinder",
        title="Cylinder with a parabolic cap",
        subtitle="A paraboloid until the depth a^2/R brings the sharp edge into contact, a curved punch from then on.",
        contact="complete",
        parameters=(a, R),
        pieces=(Piece(None, r**2 / (2 * R)),),
        validity="a << R",
        sources=("Schubert 1942",),
        sketch=Sketch(((a, 1.0), (R, 2.2)), a=1.0, d=0.6),
    ),
    Profile(
        name="concave_power",
        title="Concave power law",
        subtitle="Concave face of depth h; complete contact needs the force F_min.",
        contact="complete",
        parameters=(a, h, n),
        pieces=(Piece(None, -h * (r / a) ** n),),
        validity="small slopes; complete contact only",
        sources=("Barber 1976", "Schubert 1942"),
        meanings=((h, "depth of the concave face"),),
        sketch=Sketch(((a, 1.0), (h, 0.15), (n, 3.0)), a=1.0, d=0.6),
        rules=(
            Rule(
                sp.S.One, n, True,
                "a concave cone or a sharper dimple never reaches complete contact at a finite load; use n > 1",
            ),
        ),
        note="the depth is measured at the centre of the face; the rim is at d + h",
    ),
    Profile(
        name="concave_paraboloid",
        title="Concave paraboloid",
        subtitle="Concave parabolic face of depth h: the pressure vanishes first at the centre.",
        contact="complete",
        parameters=(a, h),
        pieces=(Piece(None, -h * (r / a) ** 2),),
        validity="small slopes; complete contact only",
        sources=("Barber 1976", "Schubert 1942"),
        meanings=((h, "depth of the concave face"),),
        sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
        note="the depth is measured at the centre of the face; the rim is at d + h",
    ),
    Profile(
        name="concave_quartic",
        title="Concave quartic",
        subtitle="Concave face of fourth order: the pressure vanishes first on the ring r = a/2.",
        contact="complete",
        parameters=(a, h),
        pieces=(Piece(None, -h * (r / a) ** 4),),
        validity="small slopes; complete contact only",
        sources=("Schubert 1942",),
        meanings=((h, "depth of the concave face"),),
        sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
        note="the depth is measured at the centre of the face; the rim is at d + h",
    ),
)  # fmt: skip
