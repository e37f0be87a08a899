"""Truncated paraboloid: flat face, parabolic flank."""

import sympy as sp

from ..notation import R, b, r
from .profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="truncated_paraboloid",
    title="Truncated paraboloid",
    subtitle="Flat face of radius b with a parabolic flank: a worn sphere.",
    contact="compact",
    parameters=(R, b),
    pieces=(Piece(b, sp.S.Zero), Piece(None, (r**2 - b**2) / (2 * R))),
    validity="a << R",
    sources=("Ejike 1981",),
    meanings=((b, "radius of the flat face"),),
    sketch=Sketch(((R, 1.2), (b, 0.5)), a=1.0),
    limits=(Limit("paraboloid", b, 0),),
    note="the pressure is logarithmically infinite at the corner r = b",
)
