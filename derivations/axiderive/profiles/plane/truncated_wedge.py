"""Truncated wedge: flat face, straight flanks."""

import sympy as sp

from ...notation import b, theta, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="truncated_wedge",
    title="Truncated wedge",
    subtitle="Flat face of half-width b with straight flanks. The half-width of the contact starts at b.",
    contact="compact",
    parameters=(theta, b),
    pieces=(Piece(b, sp.S.Zero), Piece(None, sp.tan(theta) * (x - b))),
    validity="tan(theta) << 1",
    sources=("Schubert 1942",),
    meanings=((b, "half-width of the flat face"),),
    sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
    limits=(Limit("wedge", b, 0),),
    note="the pressure is logarithmically infinite at the corner x = b; from the general solution of Schubert",
)
