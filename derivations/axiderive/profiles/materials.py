"""The half-space without an indenter: what its elastic constants come to in a contact, as data."""

import sympy as sp

from ..notation import beta, k, nu
from .profile import Profile, Sketch

PROFILE = Profile(
    name="materials",
    title="Elastic constants",
    subtitle="Effective moduli of two elastic bodies, and of a half-space graded by a power of the depth.",
    contact="none",
    parameters=(),
    pieces=(),
    validity="isotropic linear elasticity",
    sources=(),
    sketch=Sketch((), a=1.0),
    abbreviations=((beta, sp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))),),
)
