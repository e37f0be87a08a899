"""Paraboloid with a cap of smaller curvature."""

from ..notation import R1, R2, b, r
from .profile import Limit, Piece, Profile, Rule, Sketch

PROFILE = Profile(
    name="capped_paraboloid",
    title="Paraboloid with a flatter cap",
    subtitle="Radius of curvature R1 up to r = b, the smaller R2 beyond: a worn sphere of finite cap curvature.",
    contact="compact",
    parameters=(R1, R2, b),
    pieces=(Piece(b, r**2 / (2 * R1)), Piece(None, b**2 / (2 * R1) + (r**2 - b**2) / (2 * R2))),
    validity="a << R2",
    sources=("Maugis & Barquins 1983",),
    meanings=((b, "radius of the inner part"),),
    sketch=Sketch(((R1, 4.0), (R2, 1.0), (b, 0.5)), a=1.0),
    rules=(
        Rule(
            R2, R1, False,
            "a slope that falls at b would open a gap there and the contact would not be compact; exchange R1 and R2",
        ),
    ),
    limits=(Limit("paraboloid", b, 0, ((R1, R2),)),),
    note="the pressure is logarithmically infinite at the edge r = b of the cap, unless R1 = R2",
)  # fmt: skip
