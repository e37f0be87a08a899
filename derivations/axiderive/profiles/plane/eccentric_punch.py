"""Flat punch under an eccentric load."""

import sympy as sp

from ...notation import a, e
from ..profile import Limit, Piece, Profile, Rule, Sketch

PROFILE = Profile(
    name="eccentric_punch",
    title="Flat punch under an eccentric load",
    subtitle="The load acts at x = e: the punch tilts, and beyond abs(e) = a/2 one edge lifts off.",
    contact="complete",
    parameters=(a, e),
    pieces=(Piece(None, sp.S.Zero),),
    validity="sharp edges, frictionless, free to tilt",
    sources=("Schubert 1942",),
    sketch=Sketch(((a, 1.0), (e, 0.3)), a=1.0, d=0.25),
    rules=(Rule(sp.Abs(e), a, True, "a load beyond the edge overturns the punch; move it inside, abs(e) < a"),),
    limits=(Limit("flat_punch", e, 0),),
    note="after lift-off the pressure is zero on the side of the lifted edge, at distances beyond 4 abs(e) - 3 a",
)
