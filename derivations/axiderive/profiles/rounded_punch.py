"""Flat punch with a rounded edge."""

import sympy as sp

from ..notation import R, b, r
from .profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="rounded_punch",
    title="Flat punch with a rounded edge",
    subtitle="Flat face of radius b running tangentially into a rounding of radius R: between flat punch and sphere.",
    contact="compact",
    parameters=(R, b),
    pieces=(Piece(b, sp.S.Zero), Piece(None, (r - b) ** 2 / (2 * R))),
    validity="a - b << R (parabolic rounding)",
    sources=("Schubert 1942", "Ciavarella 1999"),
    meanings=((b, "radius of the flat face"),),
    sketch=Sketch(((R, 1.45), (b, 1.15)), a=1.62),
    limits=(Limit("paraboloid", b, 0),),
    note="the pressure is bounded",
)
