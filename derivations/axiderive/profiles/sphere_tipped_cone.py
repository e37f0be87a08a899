"""Cone with a spherical tip."""

import sympy as sp

from ..notation import R, b, r, theta
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="sphere_tipped_cone",
    title="Cone with a spherical tip",
    subtitle="Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.",
    contact="compact",
    parameters=(R, theta),
    pieces=(
        Piece(b, R - sp.sqrt(R**2 - r**2)),
        Piece(None, R - sp.sqrt(R**2 - b**2) + b / sp.sqrt(R**2 - b**2) * (r - b)),
    ),
    abbreviations=((b, R * sp.sin(theta)),),
    validity="tan(theta) << 1",
    sources=(),
    meanings=((b, "radius of the inner part"),),
    sketch=Sketch(((R, 1.2), (theta, 0.45)), a=1.0),
    chain=(b, R),
    synonyms=("sphero-conical indenter",),
)
