"""Sphere, exact shape."""

import sympy as sp

from ..notation import R, a, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="sphere",
    title="Sphere",
    subtitle="The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.",
    contact="compact",
    parameters=(R,),
    pieces=(Piece(None, R - sp.sqrt(R**2 - r**2)),),
    validity="a < R; the theory of small slopes asks for a << R",
    sources=("Segedin 1957", "Sneddon 1965"),
    sketch=Sketch(((R, 1.5),), a=1.0),
    chain=(a, R),
)
