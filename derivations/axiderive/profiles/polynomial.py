"""Sum of integer powers."""

import sympy as sp

from ..notation import N, coefficients, j, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="polynomial",
    title="Polynomial",
    subtitle="Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a fixed contact radius.",
    contact="compact",
    parameters=(coefficients,),
    pieces=(Piece(None, sp.Sum(coefficients[j] * r**j, (j, 1, N))),),
    validity="small slopes",
    sources=("Schubert 1942", "Sneddon 1965"),
    sketch=Sketch((), a=1.0),
    note="A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero",
)
