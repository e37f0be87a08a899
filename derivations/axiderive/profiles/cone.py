"""Cone."""

import sympy as sp

from ..notation import r, theta
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="cone",
    title="Cone",
    subtitle="Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.",
    contact="compact",
    parameters=(theta,),
    pieces=(Piece(None, r * sp.tan(theta)),),
    validity="tan(theta) << 1; a << size of the body",
    sources=("Love 1939", "Schubert 1942", "Sneddon 1965"),
    sketch=Sketch(((theta, 0.35),), a=1.0),
    synonyms=("conical indenter",),
    note="the pressure is singular at the tip, as ln(r)",
)
