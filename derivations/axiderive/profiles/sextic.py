"""Profile of sixth order."""

from ..notation import A, r
from .profile import Piece, Profile, Sketch

PROFILE = Profile(
    name="sextic",
    title="Sextic profile",
    subtitle="Flatter at the tip than the quartic: most of the load is carried near the rim of the contact.",
    contact="compact",
    parameters=(A,),
    pieces=(Piece(None, A * r**6),),
    validity="small slopes, 6 A a^5 << 1",
    sources=("Schubert 1942",),
    sketch=Sketch(((A, 0.4),), a=1.0),
    synonyms=("power law of order six",),
)
