"""Concave quartic."""

from ...notation import a, h, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="concave_quartic",
    title="Concave quartic",
    subtitle="Concave face of fourth order: the pressure vanishes first at x = a/2.",
    contact="complete",
    parameters=(a, h),
    pieces=(Piece(None, -h * (x / a) ** 4),),
    validity="small slopes; complete contact only",
    sources=("Schubert 1942",),
    meanings=((h, "depth of the concave face"),),
    sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
    limits=(Limit("flat_punch", h, 0),),
)
