"""Indenters whose contact grows with the load, in the order of lists."""

from __future__ import annotations

import sympy as sp

from ..notation import R1, R2, A, N, R, a, b, coefficients, h, j, n, r, s, theta, wavelength
from .profile import Limit, Piece, Profile, Rule, Sketch

# k = 0: pi**3 times the depth of the lowest minimum of (H_0(z) + z (2/pi - H_1(z)))/z, rounded up
WAVY_LIMIT = sp.Float("12.391420936291584", 17)
# k = 0: where z D(z), D Dawson's function, has its maximum, rounded down: beyond it the depth falls
GAUSSIAN_LIMIT = sp.Float("1.5019752682686114", 17)

PROFILES = (
    Profile(
        name="cone",
        title="Cone",
        subtitle="Rigid cone of inclination theta. Self-similar: the mean pressure does not depend on the load.",
        contact="compact",
        parameters=(theta,),
        pieces=(Piece(None, r * sp.tan(theta)),),
        validity="tan(theta) << 1; a << size of the body",
        sources=("Love 1939", "Schubert 1942", "Sneddon 1965"),
        sketch=Sketch(((theta, 0.35),), a=1.0),
        synonyms=("conical indenter",),
        note="the pressure is singular at the tip, as ln(r)",
    ),
    Profile(
        name="sphere_tipped_cone",
        title="Cone with a spherical tip",
        subtitle="Sphere of radius R up to b = R sin(theta), then its tangent cone: the exact sphero-conical tip.",
        contact="compact",
        parameters=(R, theta),
        pieces=(
            Piece(b, R - sp.sqrt(R**2 - r**2)),
            Piece(None, R - sp.sqrt(R**2 - b**2) + b / sp.sqrt(R**2 - b**2) * (r - b)),
        ),
        abbreviations=((b, R * sp.sin(theta)),),
        validity="tan(theta) << 1",
        sources=(),
        meanings=((b, "radius of the inner part"),),
        sketch=Sketch(((R, 1.2), (theta, 0.45)), a=1.0),
        chain=(b, R),
        synonyms=("sphero-conical indenter",),
    ),
    Profile(
        name="rounded_cone",
        title="Cone with a rounded tip",
        subtitle="Parabolic tip running tangentially into a cone at r = b.",
        contact="compact",
        parameters=(theta, b),
        pieces=(Piece(b, r**2 * sp.tan(theta) / (2 * b)), Piece(None, sp.tan(theta) * (r - b / 2))),
        validity="tan(theta) << 1",
        sources=("Ciavarella 1999", "Maugis & Barquins 1983"),
        meanings=((b, "radius of the inner part"),),
        sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
        limits=(Limit("cone", b, 0),),
    ),
    Profile(
        name="paraboloid",
        title="Paraboloid",
        subtitle="The tip of every smooth indenter and the parabolic approximation of the sphere: Hertz's contact.",
        contact="compact",
        parameters=(R,),
        pieces=(Piece(None, r**2 / (2 * R)),),
        validity="a << R",
        sources=("Hertz 1882", "Schubert 1942"),
        sketch=Sketch(((R, 1.6),), a=1.0),
        synonyms=("Hertzian contact", "parabolic approximation of the sphere"),
    ),
    Profile(
        name="quartic",
        title="Quartic profile",
        subtitle=(
            "Vanishing curvature at the tip: the pressure has a dip at the centre and its largest "
            "value on a ring."
        ),
        contact="compact",
        parameters=(A,),
        pieces=(Piece(None, A * r**4),),
        validity="small slopes, 4 A a^3 << 1",
        sources=("Steuermann 1939", "Schubert 1942"),
        sketch=Sketch(((A, 0.4),), a=1.0),
        synonyms=("power law of order four",),
    ),
    Profile(
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
    ),
    Profile(
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
    ),
    Profile(
        name="polynomial",
        title="Polynomial",
        subtitle=(
            "Any sum of integer powers with coefficients A_1 ... A_N >= 0: superposition at a "
            "fixed contact radius."
        ),
        contact="compact",
        parameters=(coefficients,),
        pieces=(Piece(None, sp.Sum(coefficients[j] * r**j, (j, 1, N))),),
        validity="small slopes",
        sources=("Schubert 1942", "Sneddon 1965"),
        sketch=Sketch((), a=1.0),
        note="A is the sequence A_1, A_2, ... of coefficients of r, r^2, ..., none negative and not all zero",
    ),
    Profile(
        name="sphere",
        title="Sphere",
        subtitle="The exact spherical shape; differs from the paraboloid by terms of order a^2/R^2.",
        contact="compact",
        parameters=(R,),
        pieces=(Piece(None, R - sp.sqrt(R**2 - r**2)),),
        validity="a < R; the theory of small slopes asks for a << R",
        sources=("Segedin 1957", "Sneddon 1965"),
        sketch=Sketch(((R, 1.5),), a=1.0),
        chain=(a, R),
    ),
    Profile(
        name="ellipsoid",
        title="Ellipsoid of revolution",
        subtitle="Semi-axis h along the axis, b across: the sphere stretched by h/b.",
        contact="compact",
        parameters=(h, b),
        pieces=(Piece(None, h * (1 - sp.sqrt(1 - r**2 / b**2))),),
        validity="a < b; small slopes",
        sources=("Sneddon 1965",),
        meanings=(
            (h, "semi-axis along the axis of revolution"),
            (b, "semi-axis across, the largest radius of the body"),
        ),
        sketch=Sketch(((h, 0.9), (b, 1.5)), a=1.0),
        chain=(a, b),
        synonyms=("spheroid",),
    ),
    Profile(
        name="hyperboloid",
        title="Hyperboloid of revolution",
        subtitle="A cone with a smoothly rounded tip: tip radius b/tan(theta), asymptotic inclination theta.",
        contact="compact",
        parameters=(theta, b),
        pieces=(Piece(None, sp.tan(theta) * (sp.sqrt(r**2 + b**2) - b)),),
        validity="tan(theta) << 1",
        sources=("Sneddon 1965",),
        meanings=((b, "length of the rounded tip, whose radius of curvature is b/tan(theta)"),),
        sketch=Sketch(((theta, 0.42), (b, 0.4)), a=1.0),
    ),
    Profile(
        name="truncated_cone",
        title="Truncated cone",
        subtitle="Flat face of radius b with a conical flank: a worn or blunted cone. The contact radius starts at b.",
        contact="compact",
        parameters=(theta, b),
        pieces=(Piece(b, sp.S.Zero), Piece(None, sp.tan(theta) * (r - b))),
        validity="tan(theta) << 1",
        sources=("Ejike 1981",),
        meanings=((b, "radius of the flat face"),),
        sketch=Sketch(((theta, 0.42), (b, 0.5)), a=1.0),
        limits=(Limit("cone", b, 0),),
        note="the pressure is logarithmically infinite at the corner r = b",
    ),
    Profile(
        name="truncated_paraboloid",
        title="Truncated paraboloid",
        subtitle="Flat face of radius b with a parabolic flank: a worn sphere.",
        contact="compact",
        parameters=(R, b),
        pieces=(Piece(b, sp.S.Zero), Piece(None, (r**2 - b**2) / (2 * R))),
        validity="a << R",
        sources=("Ejike 1981",),
        meanings=((b, "radius of the flat face"),),
        sketch=Sketch(((R, 1.2), (b, 0.5)), a=1.0),
        limits=(Limit("paraboloid", b, 0),),
        note="the pressure is logarithmically infinite at the corner r = b",
    ),
    Profile(
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
                "a slope that falls at b would open a gap there and the contact would not be compact; "
                "exchange R1 and R2",
            ),
        ),
        limits=(Limit("paraboloid", b, 0),),
        note="the pressure is logarithmically infinite at the edge r = b of the cap, unless R1 = R2",
    ),
    Profile(
        name="wavy_paraboloid",
        title="Wavy paraboloid",
        subtitle=(
            "A paraboloid with concentric waves of amplitude h, 2h from valley to peak, too "
            "shallow to leave gaps."
        ),
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
                WAVY_LIMIT * h * R, wavelength**2, False,
                "steeper waves leave gaps and the contact is not compact; lower h or lengthen the wave",
            ),
        ),
    ),
    Profile(
        name="gaussian",
        title="Gaussian bump",
        subtitle="A smooth asperity of height h and width s; compact up to the radius of largest depth.",
        contact="compact",
        parameters=(h, s),
        pieces=(Piece(None, h * (1 - sp.exp(-(r**2) / s**2))),),
        validity="h << s",
        sources=("Popov, Heß & Willert 2019",),
        meanings=(
            (h, "height of the bump"),
            (s, "width of the bump, the radius at which its height is down to 37 per cent"),
        ),
        sketch=Sketch(((h, 0.7), (s, 1.0)), a=1.0),
        largest=GAUSSIAN_LIMIT * s,
        note=(
            "the largest radius is 1.50198 s on the homogeneous half-space; graded it is where g' = 0,"
            " at 1.2286 s for k = -0.5 and at 1.8788 s for k = 0.5"
        ),
    ),
    Profile(
        name="rounded_curved_punch",
        title="Curved punch with a rounded edge",
        subtitle="A paraboloid of radius R1 whose edge is rounded off from r = b on with the radius R2.",
        contact="compact",
        parameters=(R1, R2, b),
        pieces=(Piece(b, r**2 / (2 * R1)), Piece(None, r**2 / (2 * R1) + (r - b) ** 2 / (2 * R2))),
        validity="a << R1, a - b << R2",
        sources=(),
        meanings=((b, "radius of the inner part"),),
        sketch=Sketch(((R1, 6.0), (R2, 1.2), (b, 1.0)), a=1.5),
    ),
    Profile(
        name="rounded_punch",
        title="Flat punch with a rounded edge",
        subtitle=(
            "Flat face of radius b running tangentially into a rounding of radius R: between flat "
            "punch and sphere."
        ),
        contact="compact",
        parameters=(R, b),
        pieces=(Piece(b, sp.S.Zero), Piece(None, (r - b) ** 2 / (2 * R))),
        validity="a - b << R (parabolic rounding)",
        sources=("Schubert 1942", "Ciavarella 1999"),
        meanings=((b, "radius of the flat face"),),
        sketch=Sketch(((R, 1.45), (b, 1.15)), a=1.62),
        limits=(Limit("paraboloid", b, 0),),
        note="the pressure is bounded",
    ),
)  # fmt: skip
