"""The half-space without an indenter: what its constants come to in a contact, as data."""

import sympy as sp

from ..notation import beta, k, nu
from .profile import Profile, Sketch

PROFILE = Profile(
    name="materials",
    title="Elastic constants",
    subtitle="Effective modulus and radius of two bodies, moduli of transversely isotropic and of graded half-spaces, "
    "numbers of adhesion.",
    contact="none",
    parameters=(),
    pieces=(),
    validity="linear elasticity",
    sources=("Elliott 1949", "Maugis 1992", "Tabor 1977"),
    sketch=Sketch((), a=1.0),
    abbreviations=((beta, sp.sqrt((1 + k) * (1 - k * nu / (1 - nu)))),),
)
