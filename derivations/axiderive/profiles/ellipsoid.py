"""Ellipsoid of revolution."""

import sympy as sp

from ..notation import a, b, h, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="ellipsoid",
    title="Ellipsoid of revolution",
    subtitle="Semi-axis h along the axis, b across: the sphere stretched by h/b.",
    contact="compact",
    parameters=(h, b),
    pieces=(Piece(None, h * (1 - sp.sqrt(1 - r**2 / b**2))),),
    validity="a < b; small slopes",
    sources=("Sneddon 1965",),
    meanings=(
        (h, "semi-axis along the axis of revolution"),
        (b, "semi-axis across, the largest radius of the body"),
    ),
    sketch=Sketch(((h, 0.9), (b, 1.5)), a=1.0),
    chain=(a, b),
    synonyms=("spheroid",),
)
