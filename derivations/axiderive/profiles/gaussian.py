"""Gaussian bump."""

import sympy as sp

from ..notation import h, r, s
from .profile import Piece, Profile, Sketch

# k = 0: where z D(z), D Dawson's function, has its maximum, rounded down: beyond it the depth falls
COMPACT_LIMIT = sp.Float("1.5019752682686114", 17)

PROFILE = Profile(
    name="gaussian",
    title="Gaussian bump",
    subtitle="A smooth asperity of height h and width s; compact up to the radius of largest depth.",
    contact="compact",
    parameters=(h, s),
    pieces=(Piece(None, h * (1 - sp.exp(-(r**2) / s**2))),),
    validity="h << s",
    sources=("Popov, Heß & Willert 2019",),
    meanings=(
        (h, "height of the bump"),
        (s, "width of the bump, the radius at which its height is down to 37 per cent"),
    ),
    sketch=Sketch(((h, 0.7), (s, 1.0)), a=1.0),
    largest=COMPACT_LIMIT * s,
    note=(
        "the largest radius is 1.50198 s on the homogeneous half-space; graded it is where g' = 0,"
        " at 1.2286 s for k = -0.5 and at 1.8788 s for k = 0.5"
    ),
)
