"""Truncated cone: flat face, conical flank."""

import sympy as sp

from ..notation import b, r, theta
from .profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="truncated_cone",
    title="Truncated cone",
    subtitle="Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.",
    contact="compact",
    parameters=(theta, b),
    pieces=(Piece(b, sp.S.Zero), Piece(None, sp.tan(theta) * (r - b))),
    validity="tan(theta) << 1",
    sources=("Ejike 1981",),
    meanings=((b, "radius of the flat face"),),
    sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
    limits=(Limit("cone", b, 0),),
    note="the pressure is logarithmically infinite at the corner r = b",
)
