"""Profile of fourth order."""

from ...notation import A, x
from ..profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="quartic",
    title="Quartic profile",
    subtitle="Vanishing curvature at the tip: the pressure has a dip in the middle.",
    contact="compact",
    parameters=(A,),
    pieces=(Piece(None, A * x**4),),
    validity="small slopes, 4 A a^3 << 1",
    sources=("Schubert 1942",),
    sketch=Sketch(((A, 0.4),), a=1.0),
    synonyms=("power law of order four",),
)
