"""Wedge with a parabolic tip."""

import sympy as sp

from ...notation import b, theta, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="rounded_wedge",
    title="Wedge with a rounded tip",
    subtitle="Parabolic tip running tangentially into straight flanks at x = b.",
    contact="compact",
    parameters=(theta, b),
    pieces=(Piece(b, x**2 * sp.tan(theta) / (2 * b)), Piece(None, sp.tan(theta) * (x - b / 2))),
    validity="tan(theta) << 1",
    sources=("Schubert 1942",),
    meanings=((b, "half-width of the rounded tip"),),
    sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
    limits=(Limit("wedge", b, 0),),
)
