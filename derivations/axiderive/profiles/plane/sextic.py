"""Profile of sixth order."""

from ...notation import A, x
from ..profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="sextic",
    title="Sextic profile",
    subtitle="Flatter tip than the quartic, and a deeper dip of the pressure in the middle.",
    contact="compact",
    parameters=(A,),
    pieces=(Piece(None, A * x**6),),
    validity="small slopes, 6 A a^5 << 1",
    sources=("Schubert 1942",),
    sketch=Sketch(((A, 0.4),), a=1.0),
    synonyms=("power law of order six",),
)
