"""Power law of any positive exponent."""

import sympy as sp

from ...notation import A, R, n, theta, x
from ..profile import Limit, Piece, Profile, Sketch

PROFILE = Profile(
    name="power_law",
    title="Power law",
    subtitle="Every self-similar profile: P ~ a^n. Wedge, parabola and quartic are n = 1, 2, 4.",
    contact="compact",
    parameters=(A, n),
    pieces=(Piece(None, A * x**n),),
    validity="small slopes, n A a^(n-1) << 1",
    sources=("Schubert 1942",),
    sketch=Sketch(((A, 0.45), (n, 1.5)), a=1.0),
    limits=(
        Limit("wedge", n, 1, ((theta, sp.atan(A)),)),
        Limit("parabola", n, 2, ((R, 1 / (2 * A)),)),
        Limit("quartic", n, 4),
        Limit("sextic", n, 6),
    ),
    note="the pressure in the middle is finite only for n > 1; n = 1, 2, 4 and 6 are solutions of Schubert",
)
