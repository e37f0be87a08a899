"""Concave parabola."""

from ...notation import a, h, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="concave_parabola",
    title="Concave parabola",
    subtitle="Concave parabolic face of depth h: the pressure vanishes first in the middle.",
    contact="complete",
    parameters=(a, h),
    pieces=(Piece(None, -h * (x / a) ** 2),),
    validity="small slopes; complete contact only",
    sources=("Schubert 1942",),
    meanings=((h, "depth of the concave face"),),
    sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
    limits=(Limit("flat_punch", h, 0),),
)
