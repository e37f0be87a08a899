"""Profile of fourth order."""

from ..notation import A, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="quartic",
    title="Quartic profile",
    subtitle="Vanishing curvature at the tip: the pressure has a dip at the centre and its largest value on a ring.",
    contact="compact",
    parameters=(A,),
    pieces=(Piece(None, A * r**4),),
    validity="small slopes, 4 A a^3 << 1",
    sources=("Steuermann 1939", "Schubert 1942"),
    sketch=Sketch(((A, 0.4),), a=1.0),
    synonyms=("power law of order four",),
)
