"""Concave paraboloid."""

from ..notation import a, h, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="concave_paraboloid",
    title="Concave paraboloid",
    subtitle="Concave parabolic face of depth h: the pressure vanishes first at the centre.",
    contact="complete",
    parameters=(a, h),
    pieces=(Piece(None, -h * (r / a) ** 2),),
    validity="small slopes; complete contact only",
    sources=("Barber 1976", "Schubert 1942"),
    meanings=((h, "depth of the concave face"),),
    sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
    note="the depth is measured at the centre of the face; the rim is at d + h",
)
