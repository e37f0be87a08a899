"""Flat punch."""

import sympy as sp

from ...notation import a
from ..profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="flat_punch",
    title="Flat punch",
    subtitle="The flat strip: every other plane contact is a superposition of flat strips.",
    contact="complete",
    parameters=(a,),
    pieces=(Piece(None, sp.S.Zero),),
    validity="sharp edges, frictionless, load in the middle",
    sources=("Sadowsky 1928", "Schubert 1942"),
    sketch=Sketch(((a, 1.0),), a=1.0, d=0.25),
    note="the pressure is infinite at the edges",
)
