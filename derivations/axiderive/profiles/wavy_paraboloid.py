"""Paraboloid with axisymmetric waviness."""

import sympy as sp

from ..notation import R, h, r, wavelength
from .profile import Piece, Profile, Rule, Sketch

# k = 0: pi**3 times the depth of the lowest minimum of (H_0(z) + z (2/pi - H_1(z)))/z, rounded up
COMPACT_LIMIT = sp.Float("12.391420936291584", 17)

PROFILE = Profile(
    name="wavy_paraboloid",
    title="Wavy paraboloid",
    subtitle="A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too shallow to leave gaps.",
    contact="compact",
    parameters=(R, h, wavelength),
    pieces=(Piece(None, r**2 / (2 * R) + h * (1 - sp.cos(2 * sp.pi * r / wavelength))),),
    validity="a << R; waves so flat that g' >= 0 for every a",
    sources=("Guduru 2007",),
    note=(
        "the number 12.3914 of the homogeneous half-space is another on a graded one, where g' >= 0 asks for"
        " 15.5992 at k = -0.5 and for 10.1777 at k = 0.5"
    ),
    meanings=((h, "amplitude of the waves, half of their height from valley to peak"),),
    sketch=Sketch(((R, 1.6), (h, 0.01), (wavelength, 0.5)), a=1.0),
    rules=(
        Rule(
            COMPACT_LIMIT * h * R, wavelength**2, False,
            "steeper waves leave gaps and the contact is not compact; lower h or lengthen the wave",
        ),
    ),
)  # fmt: skip
