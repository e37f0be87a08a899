"""Paraboloid: Hertz's contact."""

from ..notation import R, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="paraboloid",
    title="Paraboloid",
    subtitle="The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.",
    contact="compact",
    parameters=(R,),
    pieces=(Piece(None, r**2 / (2 * R)),),
    validity="a << R",
    sources=("Hertz 1882", "Schubert 1942"),
    sketch=Sketch(((R, 1.6),), a=1.0),
    synonyms=("Hertzian contact", "parabolic approximation of the sphere"),
)
