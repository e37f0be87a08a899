"""Flat punch with rounded edges."""

import sympy as sp

from ...notation import R, b, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="rounded_punch",
    title="Flat punch with rounded edges",
    subtitle="Flat face of half-width b running tangentially into roundings of radius R.",
    contact="compact",
    parameters=(R, b),
    pieces=(Piece(b, sp.S.Zero), Piece(None, (x - b) ** 2 / (2 * R))),
    validity="a - b << R (parabolic rounding)",
    sources=("Schubert 1942", "Ciavarella, Hills & Monno 1998"),
    meanings=((b, "half-width of the flat face"),),
    sketch=Sketch(((R, 1.45), (b, 1.15)), a=1.62),
    limits=(Limit("parabola", b, 0),),
    note="the pressure is bounded",
)
