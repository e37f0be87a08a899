"""Cylinder with a parabolic cap."""

from ..notation import R, a, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="capped_cylinder",
    title="Cylinder with a parabolic cap",
    subtitle="A paraboloid until the depth a^2/R brings the sharp edge into contact, a curved punch from then on.",
    contact="complete",
    parameters=(a, R),
    pieces=(Piece(None, r**2 / (2 * R)),),
    validity="a << R",
    sources=("Schubert 1942",),
    sketch=Sketch(((a, 1.0), (R, 2.2)), a=1.0, d=0.6),
)
