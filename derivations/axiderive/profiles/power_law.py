"""Power law of any positive exponent."""

from ..notation import A, n, r
from .profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="power_law",
    title="Power law",
    subtitle="Every self-similar profile: F ~ d^(1 + 1/n). Cone, paraboloid and quartic are n = 1, 2, 4.",
    contact="compact",
    parameters=(A, n),
    pieces=(Piece(None, A * r**n),),
    validity="small slopes, n A a^(n-1) << 1",
    sources=("Galin 1946", "Sneddon 1965"),
    sketch=Sketch(((A, 0.45), (n, 1.5)), a=1.0),
    limits=(
        Limit("cone", n, 1),
        Limit("paraboloid", n, 2),
        Limit("quartic", n, 4),
        Limit("sextic", n, 6),
    ),
    note="the pressure at the centre is finite only for n > 1",
)
