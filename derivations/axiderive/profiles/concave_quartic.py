"""Concave quartic."""

from ..notation import a, h, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="concave_quartic",
    title="Concave quartic",
    subtitle="Concave face of fourth order: the pressure vanishes first on the ring r = a/2.",
    contact="complete",
    parameters=(a, h),
    pieces=(Piece(None, -h * (r / a) ** 4),),
    validity="small slopes; complete contact only",
    sources=("Schubert 1942",),
    meanings=((h, "depth of the concave face"),),
    sketch=Sketch(((a, 1.0), (h, 0.15)), a=1.0, d=0.6),
    note="the depth is measured at the centre of the face; the rim is at d + h",
)
