"""Parabola: a cylinder in line contact."""

from ...notation import R, x
from ..profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="parabola",
    title="Parabola",
    subtitle="Cylinder of radius R in line contact, a << R.",
    contact="compact",
    parameters=(R,),
    pieces=(Piece(None, x**2 / (2 * R)),),
    validity="a << R",
    sources=("Schubert 1942", "Johnson 1985"),
    sketch=Sketch(((R, 1.45),), a=1.0),
    synonyms=("cylinder", "line contact"),
)
