"""Flat punch."""

import sympy as sp

from ..notation import a
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="flat_punch",
    title="Flat punch",
    subtitle="The elementary building block: every other contact is a superposition of flat punches.",
    contact="complete",
    parameters=(a,),
    pieces=(Piece(None, sp.S.Zero),),
    validity="sharp edge, frictionless",
    sources=("Boussinesq 1885", "Schubert 1942"),
    sketch=Sketch(((a, 1.0),), a=1.0, d=0.25),
    note="the pressure is infinite at the edge",
)
