"""Concave power law."""

import sympy as sp

from ...notation import a, h, n, x
from ..profile import Limit, Piece, Profile, Rule, Sketch

PROFILE = Profile(
    name="concave_power",
    title="Concave power law",
    subtitle="Concave face of depth h; complete contact needs the line load P_min.",
    contact="complete",
    parameters=(a, h, n),
    pieces=(Piece(None, -h * (x / a) ** n),),
    validity="small slopes; complete contact only",
    sources=("Schubert 1942",),
    meanings=((h, "depth of the concave face"),),
    sketch=Sketch(((a, 1.0), (h, 0.15), (n, 3.0)), a=1.0, d=0.6),
    rules=(
        Rule(
            sp.S.One, n, True,
            "a concave wedge or a sharper notch never reaches complete contact at a finite load; use n > 1",
        ),
    ),
    limits=(Limit("concave_parabola", n, 2), Limit("concave_quartic", n, 4)),
)  # fmt: skip
