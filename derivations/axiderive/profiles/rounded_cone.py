"""Cone with a parabolic tip."""

import sympy as sp

from ..notation import b, r, theta
from .profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="rounded_cone",
    title="Cone with a rounded tip",
    subtitle="Parabolic tip running tangentially into a cone at r = b.",
    contact="compact",
    parameters=(theta, b),
    pieces=(Piece(b, r**2 * sp.tan(theta) / (2 * b)), Piece(None, sp.tan(theta) * (r - b / 2))),
    validity="tan(theta) << 1",
    sources=("Ciavarella 1999", "Maugis & Barquins 1983"),
    meanings=((b, "radius of the inner part"),),
    sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
    limits=(Limit("cone", b, 0),),
)
