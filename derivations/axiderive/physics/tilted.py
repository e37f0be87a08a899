"""The flat strip under an eccentric load: tilt, and lift-off of the unloaded edge.

The strip carries p = (alpha + beta x)/sqrt(c^2 - x^2) at any half-width c.  Load
and moment fix alpha and beta; since the strip itself stays level, the second
term inclines it by beta times int 1/sqrt(c^2 - x^2) dx.  The contact loses an
edge where the pressure there vanishes, and then keeps the other.
"""

from __future__ import annotations

import sympy as sp

from ..abel.moments import depth_moment
from ..entry import Case, Entry
from ..notation import E_star, P, a, e, p, tilt, width, x
from ..profiles.profile import Profile
from .plane_quantities import PLANE_ECCENTRIC

LEVEL = 2 * depth_moment(sp.S.Zero).expr()
"""int 1/sqrt(a^2 - x^2) dx over the strip."""
MOMENT = 2 * depth_moment(sp.Integer(2)).expr()
"""int x^2/sqrt(a^2 - x^2) dx over the strip."""


def _strip(point: sp.Expr, half_width: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    """Numerator alpha + beta x of the pressure."""
    return P / LEVEL + P * eccentricity / MOMENT.subs(a, half_width) * point


def _inclination(half_width: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    return 2 / (sp.pi * E_star) * LEVEL * P * eccentricity / MOMENT.subs(a, half_width)


def derive(profile: Profile) -> dict[str, Entry]:
    """Pressure, tilt and width of the contact on both sides of lift-off."""
    core = sp.cancel(MOMENT / (LEVEL * a))  # eccentricity at which the pressure of a strip vanishes at one edge
    share = core / a
    side, distance = sp.sign(e), sp.Abs(e)
    half = sp.factor((a - distance) / (1 - share))  # e = a - c + share c for the contact a - 2 c < x < a
    point = side * x - (a - half)
    # alpha (1 + point/c) / sqrt(c^2 - point^2)
    lifted = P / (LEVEL * half) * sp.sqrt(sp.Max(0, sp.expand(half + point))) / sp.sqrt(sp.expand(half - point))
    touching, apart = (distance, core), (core, distance)
    return {
        "p": _entry(
            profile,
            "p",
            Case(touching, sp.factor(_strip(x, a, e)) / sp.sqrt(a**2 - x**2)),
            Case(apart, lifted),
        ),
        "phi": _entry(
            profile,
            "phi",
            Case(touching, sp.factor(_inclination(a, e))),
            Case(apart, side * sp.factor(_inclination(half, share * half))),
        ),
        "cw": _entry(profile, "cw", Case(touching, 2 * a), Case(apart, 2 * half)),
    }


def definitions() -> dict[str, sp.Expr]:
    """Equilibrium of moments, the slope under the strip, and the extent of positive pressure."""
    pressure = sp.Function(p.name)
    s = sp.Symbol("s", real=True)
    return {
        "p": sp.Eq(sp.Integral(x * pressure(x), (x, -a, a)), P * e),
        "phi": sp.Eq(2 / (sp.pi * E_star) * sp.Integral(pressure(s) / (s - x), (s, -a, a)), tilt),
        "cw": sp.Eq(pressure(a - width), 0),
    }


def _entry(profile: Profile, suffix: str, *cases: Case) -> Entry:
    material = (E_star,) if any(case.expr.has(E_star) for case in cases) else ()
    return Entry(
        key=f"plane.{profile.name}.{suffix}",
        profile=profile,
        quantity=PLANE_ECCENTRIC[suffix],
        status="closed",
        cases=cases,
        definition=definitions()[suffix],
        parameters=profile.parameters + material,
    )
