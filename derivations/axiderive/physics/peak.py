"""Greatest pressure of a normal contact where it is finite: on the axis or on which ring, and how large.

It is on the axis where f'(r)/r is continuous, positive and never rises, up to the edge of the contact. Such a face is
a paraboloid and a sum, with positive factors, of faces f = min(r, c)^2/2 with c < a, of which the pressure is

    E*/pi [2 sqrt(a^2 - r^2) - int_c^a (t^2 + s^2)/(s sqrt(t^2 - r^2)) dt],    s^2 = t^2 - c^2,

for r < c, which falls, from a positive value on the axis; beyond c it is negative, as 2 < s/t + t/s. A closed pressure
is not needed: the one under a Gaussian bump is an integral, on the axis too.

Four kinds of contact have a ring that is proved to be the only one: a pressure that is a polynomial of r^2 times
sqrt(a^2 - r^2), any power of r, the sphere, and the flat face with a rounded edge, whose pressure rises up to the
rounding and falls in it.
In t = sqrt(r^2 + u^2) the pressure (11.23) has a slope of its own,

    dp/dr = E* r/pi [int_r^a (g'(t)/t)'/sqrt(t^2 - r^2) dt - g'(a)/(a sqrt(a^2 - r^2))],

for r beyond the edge of the face; the ring is where the bracket is zero.

For f = A r^n and q = (r/a)^2 it is a multiple of r^(n - 3), positive for n > 2, times

    B(1 - q; 1/2, (3 - n)/2) - 2 q^((3 - n)/2)/[(n - 2) sqrt(1 - q)],

which falls. Where it vanishes p is the pressure p(0) = E* g'(a)/[pi (n - 1)] of a ring that has shrunk to the axis,
as it has for n <= 2, over sqrt(1 - q).

Under the sphere it leaves the axis at a = 0.93761 R. With R = 1, u^2 = (a^2 - r^2)/(1 - r^2) and Psi(z) = (1 - z^2)
(z artanh z - 1), (1 - a^2) r^2 sqrt(a^2 - r^2) times the bracket is Psi(u) - Psi(a), and u falls from a to zero as r
grows. Psi'(z) = 3 z - (3 z^2 - 1) artanh z, over z artanh z, falls from infinity to -2: Psi rises from -1 up to
z = 0.93761 and falls to zero beyond. Hence the bracket has no zero below that radius, and one beyond. The ellipsoid is
that sphere stretched along its axis.

Some have a greatest pressure that is no entry. Under the curved punch with a rounded edge dp/dr has no bound at b:
beyond it there always is a ring, and with R2/R1 above a level the pressure of the axis is a second maximum, the
greater one above a higher level. For b/a = 0.2, 0.5, 0.8, 0.95 the levels are 2.0238, 0.37503, 0.055341, 0.0056172 and
3.2692, 0.76662, 0.17568, 0.034274. The first is closed, the second no equation of its own but a ring of equal pressure,
at 0.21826, 0.53665, 0.83075, 0.96137 of a; the place of the greatest pressure leaps there from the axis to that ring.
A sum of powers may have more than one place: of r^2 and r^6, where the latter brings 0.7 of g'(a), the axis and a ring.
"""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

from ..abel.form import Form
from ..abel.masters import IncompleteBeta
from ..abel.moments import arccos_moment, elliptic_moment
from ..entry import Case, Status
from ..notation import a, r, r_peak
from ..profiles.profile import Profile
from .medium import HOMOGENEOUS

Found = tuple[Status, tuple[Case, ...], tuple[Case, ...]]
"""Status and cases of the radius, and the cases of the pressure there."""


def derive(profile: Profile, depth: tuple[Case, ...], pressure: tuple[Case, ...]) -> Found | None:
    """Where the pressure is greatest and the pressure there; None where no rule gives them, as for most integrals."""
    if has_falling_curvature(profile):
        return _on_axis(depth, pressure)
    if has_rounded_edge(profile):
        (regime,), (b,) = depth, profile.breaks
        own = next(case for case in pressure if case.chain.index(b) < case.chain.index(r))
        at_ring = Case(regime.chain, own.expr.subs(r, r_peak))
        return "root", (Case(regime.chain, _balance(regime.expr, b)),), (at_ring,)
    if len(pressure) != 1:
        return None
    if (power := free_power(pressure[0].expr)) is not None:
        return _of_power(depth[0].expr, power)
    if stretch_of_arc(profile) is not None:
        return _of_arc(profile.chain[-1], depth[0].chain, pressure[0].expr)
    radius = _ring(pressure[0].expr) if pressure[0].chain == (r, a) else None
    if radius is None:
        return None
    at_ring = Case((a,), sp.factor(sp.expand(pressure[0].expr.subs(r, radius))))
    return "closed", (Case((a,), radius),), (at_ring,)


def has_falling_curvature(profile: Profile) -> bool:
    """Whether f'(r) is zero on the axis and shown to be positive and without a jump, and f'(r)/r to fall or to stay."""
    positive = {tangent: sp.Dummy(positive=True) for piece in profile.pieces for tangent in piece.expr.atoms(sp.tan)}
    slopes = [sp.expand(sp.diff(piece.expr, r).subs(positive)) for piece in profile.pieces]
    joints = zip(slopes, slopes[1:], profile.breaks, strict=False)
    smooth = all(sp.cancel((inner - outer).subs(r, b)) == 0 for inner, outer, b in joints)
    falls = all(slope.is_positive and sp.diff(sp.expand(slope / r), r).is_nonpositive for slope in slopes)
    return smooth and falls and slopes[0].subs(r, 0) == 0


def _on_axis(depth: tuple[Case, ...], pressure: tuple[Case, ...]) -> Found | None:
    inner = [next(one for one in pressure if one.chain == (r, *regime.chain)) for regime in depth]
    middle = tuple(Case(regime.chain, one.expr.subs(r, 0)) for regime, one in zip(depth, inner, strict=True))
    if any(one.expr == 0 or one.expr.has(sp.nan, sp.zoo, sp.oo) for one in middle):
        return None  # not continuous at r = 0 as it is written
    return "closed", tuple(Case(regime.chain, sp.S.Zero) for regime in depth), middle


def has_rounded_edge(profile: Profile) -> bool:
    """Whether the profile is a flat face with a parabolic rounding: then b/a alone says where the peak is."""
    if not profile.truncated or len(profile.breaks) != 1:
        return False
    return not sp.cancel(profile.pieces[-1].expr / (r - profile.breaks[0]) ** 2).has(r)


def free_power(pressure: sp.Expr) -> sp.Symbol | None:
    """The exponent n of the profile r^n whose pressure is a multiple of r^(n - 1) B(1 - r^2/a^2; 1/2, (1 - n)/2)."""
    exponents = {sp.expand(1 - 2 * master.args[2]) for master in pressure.atoms(IncompleteBeta)}
    (n,) = exponents if len(exponents) == 1 else (None,)
    return n if n is not None and n.is_Symbol and not pressure.has(sp.Sum) else None


def _of_power(depth: sp.Expr, n: sp.Symbol) -> Found:
    """The axis up to n = 2 and the ring beyond; below n = 1 the pressure on the axis has no bound."""
    outside, one, two = 1 - r_peak**2 / a**2, sp.Integer(1), sp.Integer(2)
    level = 2 * (a / r_peak) ** (n - 3) / ((n - 2) * sp.sqrt(outside))
    ring = sp.Eq(IncompleteBeta(outside, sp.S.Half, (3 - n) / 2), level)
    middle = sp.powsimp(sp.diff(depth, a), combine="exp") * HOMOGENEOUS.pressure_scale / (n - 1)
    cases = Case((one, n, two), sp.S.Zero), Case((two, n), ring)
    return "root", cases, (Case((one, n), middle / sp.sqrt(outside)),)


def stretch_of_arc(profile: Profile) -> sp.Expr | None:
    """What f'(r) of a sphere or an ellipsoid, which ends at R, is to r/sqrt(R^2 - r^2); None for another profile."""
    if len(profile.pieces) > 1 or not profile.chain or (end := profile.chain[-1]) == a:
        return None
    stretch = sp.sqrt(sp.cancel(sp.diff(profile.pieces[0].expr, r) ** 2 * (end**2 - r**2) / r**2))
    return None if stretch.has(r) else stretch


def _of_arc(end: sp.Expr, regime: tuple[sp.Expr, ...], pressure: sp.Expr) -> Found:
    """The axis where the level is below one, the ring beyond: equal values of Psi, over (1 - a^2) of above."""
    z, u = a / end, sp.sqrt(a**2 - r_peak**2) / sp.sqrt(end**2 - r_peak**2)
    level = (z - 1 / (3 * z)) * sp.atanh(z)
    ring = sp.Eq(1 - z * sp.atanh(z), (1 - u * sp.atanh(u)) / (1 - r_peak**2 / end**2), evaluate=False)
    cases = Case((level, sp.S.One), sp.S.Zero), Case((sp.S.One, level), ring)
    return "root", cases, (Case(regime, pressure.subs(r, r_peak)),)


def _balance(depth: sp.Expr, b: sp.Expr) -> sp.Equality:
    """The bracket above, times r and the curvature of the rounding, as an equation for r_peak."""
    scale = abs(sp.factor(depth).as_independent(a, b, as_Add=False)[0])
    rate = sp.diff(sp.expand(depth / scale), a)
    angle, root = _parts(sp.diff(rate / a, a), b)
    total = Form()
    for moment, coefficient in ((arccos_moment, angle), (elliptic_moment, root * (a**2 - b**2))):
        for (power,), factor in sp.Poly(sp.cancel(coefficient * a**2), a).terms():
            total = total + moment(power - 2, b, False) * factor
    edge = Form.of(sp.acos(b / a), _parts(rate, b)[0]) + Form.of(sp.sqrt(a**2 - b**2), _parts(rate, b)[1])
    edge = edge.times(Form.of(1 / sp.sqrt(a**2 - r**2), r / a))
    return sp.Eq((total * r).expr().subs(r, r_peak), edge.expr().subs(r, r_peak), evaluate=False)


def _parts(expr: sp.Expr, b: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The factors of acos(b/a) and of sqrt(a^2 - b^2)."""
    angle, root = sp.Symbol("angle"), sp.sqrt(a**2 - b**2)
    linear = sp.expand(expr).subs(sp.acos(b / a), angle)
    share = sp.cancel(sp.diff(linear, angle))
    return share, sp.cancel(sp.expand((linear - share * angle) * root) / root**2)


def _ring(pressure: sp.Expr) -> sp.Expr | None:
    """Where p = sqrt(a^2 - r^2) P(r^2) is greatest: the only zero of 2 (a^2 - r^2) P' - P, if that has one."""
    q = sp.Symbol("q", positive=True)
    polynomial = sp.cancel(pressure.subs(r, a * sp.sqrt(q)) / sp.sqrt(a**2 - a**2 * q))
    if not polynomial.is_polynomial(q):
        return None
    slope = sp.Poly(2 * (1 - q) * sp.diff(polynomial, q) - polynomial, q)
    _, shape = slope.primitive()
    if not all(c.is_Rational for c in shape.all_coeffs()):
        return None
    signs = [sp.sign(c) for c in slope.all_coeffs() if c != 0]
    if [x * y for x, y in pairwise(signs)].count(-1) != 1 or signs[0] > 0:
        return None
    (found,) = (x for x in sp.solve(shape.as_expr(), q) if x.is_positive)
    return a * sp.sqrt(sp.factor(found))
