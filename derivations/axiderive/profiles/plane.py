"""Profiles of the plane problem, in the order of lists: even functions of x, except for the eccentric punch."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from ..notation import R, a, b, e, h, n, r, x
from . import load as body
from .profile import Limit, Piece, Profile, Rule, Sketch, named


def _strip(like: str, /, **own: Any) -> Profile:
    """The section of a body of revolution, with what is its own in the plane."""
    known = body(like)
    pieces = tuple(Piece(piece.upper, piece.expr.subs(r, x)) for piece in known.pieces)
    return replace(known, **{"pieces": pieces, "sources": ("Schubert 1942",), **own})


PROFILES = (
    _strip(
        "cone",
        name="wedge",
        title="Wedge",
        subtitle="Rigid wedge of inclination theta; the mean pressure does not depend on the load.",
        sources=("Schubert 1942", "Johnson 1985"),
        synonyms=(),
        note="the pressure is singular at the tip, as ln(x)",
    ),
    _strip(
        "paraboloid",
        name="parabola",
        title="Parabola",
        subtitle="Cylinder of radius R in line contact, a << R.",
        sources=("Schubert 1942", "Johnson 1985"),
        sketch=Sketch(((R, 1.45),), a=1.0),
        synonyms=("cylinder", "line contact"),
    ),
    _strip("quartic", subtitle="Vanishing curvature at the tip: the pressure has a dip in the middle."),
    _strip("sextic", subtitle="Flatter tip than the quartic, and a deeper dip of the pressure in the middle."),
    _strip(
        "power_law",
        subtitle="Every self-similar profile: P ~ a^n. Wedge, parabola and quartic are n = 1, 2, 4.",
        limits=(Limit("wedge", n, 1), Limit("parabola", n, 2), Limit("quartic", n, 4), Limit("sextic", n, 6)),
        note="the pressure in the middle is finite only for n > 1; n = 1, 2, 4 and 6 are solutions of Schubert",
    ),
    _strip(
        "truncated_cone",
        name="truncated_wedge",
        title="Truncated wedge",
        subtitle="Flat face of half-width b with straight flanks. The half-width of the contact starts at b.",
        meanings=((b, "half-width of the flat face"),),
        limits=(Limit("wedge", b, 0),),
        note="the pressure is logarithmically infinite at the corner x = b; from the general solution of Schubert",
    ),
    _strip(
        "rounded_cone",
        name="rounded_wedge",
        title="Wedge with a rounded tip",
        subtitle="Parabolic tip running tangentially into straight flanks at x = b.",
        meanings=((b, "half-width of the rounded tip"),),
        limits=(Limit("wedge", b, 0),),
    ),
    _strip(
        "rounded_punch",
        title="Flat punch with rounded edges",
        subtitle="Flat face of half-width b running tangentially into roundings of radius R.",
        sources=("Schubert 1942", "Ciavarella, Hills & Monno 1998"),
        meanings=((b, "half-width of the flat face"),),
        limits=(Limit("parabola", b, 0),),
    ),
    _strip(
        "flat_punch",
        subtitle="The flat strip: every other plane contact is a superposition of flat strips.",
        validity="sharp edges, frictionless, load in the middle",
        sources=("Sadowsky 1928", "Schubert 1942"),
        note="the pressure is infinite at the edges",
    ),
    _strip(
        "flat_punch",
        name="eccentric_punch",
        title="Flat punch under an eccentric load",
        subtitle="The load acts at x = e: the punch tilts, and beyond abs(e) = a/2 one edge lifts off.",
        parameters=(a, e),
        validity="sharp edges, frictionless, free to tilt",
        sketch=Sketch(((a, 1.0), (e, 0.3)), a=1.0, d=0.25),
        rules=(Rule(sp.Abs(e), a, True, "a load beyond the edge overturns the punch; move it inside, abs(e) < a"),),
        limits=(Limit("flat_punch", e, 0),),
        note="after lift-off the pressure is zero on the side of the lifted edge, at distances beyond 4 abs(e) - 3 a",
    ),
    _strip(
        "concave_power",
        subtitle="Concave face of depth h; complete contact needs the line load P_min.",
        rules=(
            Rule(
                sp.S.One, n, True,
                "a concave wedge or a sharper notch never reaches complete contact at a finite load; use n > 1",
            ),
        ),
        limits=(Limit("concave_parabola", n, 2), Limit("concave_quartic", n, 4)),
        note="",
    ),
    _strip(
        "concave_paraboloid",
        name="concave_parabola",
        title="Concave parabola",
        subtitle="Concave parabolic face of depth h: the pressure vanishes first in the middle.",
        limits=(Limit("flat_punch", h, 0),),
        note="",
    ),
    _strip(
        "concave_quartic",
        subtitle="Concave face of fourth order: the pressure vanishes first at x = a/2.",
        limits=(Limit("flat_punch", h, 0),),
        note="",
    ),
)  # fmt: skip
COMPACT_NAMES = tuple(own.name for own in PROFILES if own.compact)
COMPLETE_NAMES = tuple(own.name for own in PROFILES if own.complete)
NAMES = COMPACT_NAMES + COMPLETE_NAMES


def load(name: str) -> Profile:
    """The plane profile of that name; `KeyError` with the nearest name if there is none."""
    return named(name, PROFILES, "unknown plane profile")
