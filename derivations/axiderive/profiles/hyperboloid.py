"""Hyperboloid of revolution."""

import sympy as sp

from ..notation import b, r, theta
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="hyperboloid",
    title="Hyperboloid of revolution",
    subtitle="A cone with a smoothly rounded tip: tip radius b/tan(theta), asymptotic inclination theta.",
    contact="compact",
    parameters=(theta, b),
    pieces=(Piece(None, sp.tan(theta) * (sp.sqrt(r**2 + b**2) - b)),),
    validity="tan(theta) << 1",
    sources=("Sneddon 1965",),
    meanings=((b, "length of the rounded tip, whose radius of curvature is b/tan(theta)"),),
    sketch=Sketch(((theta, 0.42), (b, 0.4)), a=1.0),
)
