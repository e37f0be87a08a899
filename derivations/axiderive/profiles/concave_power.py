"""Concave power law."""

import sympy as sp

from ..notation import a, h, n, r
from .profile import Piece, Profile, Rule, Sketch

PROFILE = Profile(
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
)  # fmt: skip
