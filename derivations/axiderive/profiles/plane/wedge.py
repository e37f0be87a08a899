"""Wedge."""

import sympy as sp

from ...notation import theta, x
from ..profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="wedge",
    title="Wedge",
    subtitle="Rigid wedge of inclination theta; the mean pressure does not depend on the load.",
    contact="compact",
    parameters=(theta,),
    pieces=(Piece(None, x * sp.tan(theta)),),
    validity="tan(theta) << 1; a << size of the body",
    sources=("Schubert 1942", "Johnson 1985"),
    sketch=Sketch(((theta, 0.35),), a=1.0),
    note="the pressure is singular at the tip, as ln(x)",
)
