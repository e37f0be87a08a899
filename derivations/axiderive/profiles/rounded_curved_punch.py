"""Curved punch with a rounded edge."""

from ..notation import R1, R2, b, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="rounded_curved_punch",
    title="Curved punch with a rounded edge",
    subtitle="A paraboloid of radius R1 whose edge is rounded off from r = b on with the radius R2.",
    contact="compact",
    parameters=(R1, R2, b),
    pieces=(Piece(b, r**2 / (2 * R1)), Piece(None, r**2 / (2 * R1) + (r - b) ** 2 / (2 * R2))),
    validity="a << R1, a - b << R2",
    sources=(),
    meanings=((b, "radius of the inner part"),),
    sketch=Sketch(((R1, 6.0), (R2, 1.2), (b, 1.0)), a=1.5),
)
