"""What the prover must refuse of strips, of the rings of zero pressure, of prescribed pressures and of materials."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from axiderive import notation as nt
from axiderive.entry import Case
from axiderive.notation import E_star, L, P, R, a, d, e, h, n, r, x
from axiderive.profiles.profile import Piece
from axiderive.proof.rules import materials, plane, rings

from .claims import (
    HALF,
    ONCE,
    STEP,
    Altered,
    Change,
    Claim,
    Refusals,
    U,
    beside,
    certified,
    derived,
    formula,
    only,
    plus,
    regions,
    set_to,
    shown,
    times,
)


def falling_load() -> Claim:
    """A hollow face: no load is positive, and the equation has no root."""
    true = derived("plane.parabola")
    piece = true["P"].profile.pieces[0]
    profile = replace(true["P"].profile, pieces=(replace(piece, expr=-piece.expr),))
    load = true["P"]
    negative = replace(
        load,
        profile=profile,
        cases=tuple(replace(case, expr=-case.expr) for case in load.cases),
        primitives={
            chain: tuple(replace(own, integrand=-own.integrand, expr=-own.expr) for own in found)
            for chain, found in load.primitives.items()
        },
    )
    cases = tuple(Case(case.chain, sp.Eq(case.expr, P, evaluate=False)) for case in negative.cases)
    width = replace(true["aP"], profile=profile, status="root", cases=cases, parameters=(*profile.parameters, E_star))
    return certified(profile, {"P": negative, "aP": width}, "aP")


def ring_elsewhere() -> Claim:
    """The pressure vanishes at a chosen ring, and is negative inside of it."""
    true = derived("concave_paraboloid")
    (pressure,) = true["p"].cases
    ring = a / 2
    (least,) = sp.solve(pressure.expr.subs(r, ring), d)
    entries = {
        **true,
        "rz": replace(true["rz"], cases=(replace(true["rz"].cases[0], expr=ring),)),
        "dmin": replace(true["dmin"], cases=(replace(true["dmin"].cases[0], expr=least),)),
    }
    return certified(true["p"].profile, entries, "dmin")


def bulging(key: str, place: sp.Expr) -> Claim:
    """The face curves the other way: the pressure is not positive, or vanishes outside of the contact."""
    true = derived(key)
    face = true["p"].profile
    profile = replace(face, pieces=(Piece(None, face.pieces[0].expr.subs(h, -h)),))
    entries = {}
    for suffix, entry in true.items():
        turned = (
            tuple(replace(case, expr=case.expr.subs(h, -h)) for case in found)
            for found in (entry.cases, entry.fixed_face)
        )
        cases, faces = turned
        entries[suffix] = replace(entry, profile=profile, cases=cases, fixed_face=faces)
    depth = sp.Dummy("depth")
    (least,) = sp.solve(entries["p"].cases[0].expr.subs({r: place, d: depth}), depth)
    for suffix, expr in (("rz", place), ("dmin", least)):
        entries[suffix] = replace(entries[suffix], cases=(Case((a,), expr),))
    return certified(profile, entries, "dmin")


def ring_of_another_equation() -> Claim:
    """The derivative of the weighted pressure has a further zero."""

    def ring() -> str:
        true = derived("plane.concave_power")
        own = plane.PlaneComplete(true["p"].profile, true)
        (face,) = own.face.entry("p").cases
        strip = a * sp.diff(own.face.depth_of((a,)), a) / sp.pi
        slope = ((n - 1) * a**2 - n * x**2) * face.expr - strip * sp.sqrt(a**2 - x**2)
        domain = own.domain((x, a))
        return rings._ring(true["xz"], slope * (x**2 - a**2 / 4), own.exponent, domain, sp.S.Zero)

    return shown(ring)


def turned_face() -> Claim:
    """Face and strip under tension: the place is one of least weighted pressure."""

    def by_root() -> list[str]:
        true = derived("plane.concave_power")
        own = plane.PlaneComplete(true["p"].profile, true)
        (face,) = own.face.entry("p").cases
        strip = a * sp.diff(own.face.depth_of((a,)), a) / sp.pi
        return rings.by_root(-face.expr, -strip, true["xz"], own.exponent, own.domain((x, a)))

    return shown(by_root)


def undefined_at_the_ring() -> Claim:
    place = nt.x_zero
    hole = (place**2 - a**2 / 4) / ((place - a / 2) * (place + a / 2))
    return times("plane.concave_power", "Pmin", hole)


def eccentric(suffix: str, change: Change, regime: int = 0) -> Claim:
    return formula("plane.eccentric_punch", suffix, change, regime)


def touching_beyond_the_core() -> Claim:
    """The formula of the punch that touches all over, for loads outside of its core."""
    inside, outside = plane.REGIONS
    wide = replace(plane.TOUCHING, eccentricity=a * (2 * plane.SHARE - 1))

    def pressure() -> list[str]:
        before = plane.REGIONS
        plane.REGIONS = {inside: wide, outside: plane.LIFTED}
        try:
            return plane.Tilted(derived("plane.eccentric_punch")).pressure()
        finally:
            plane.REGIONS = before

    return shown(pressure)


def undefined_where_lifted() -> Claim:
    """A factor 1 that is not defined at one place where the punch has lifted."""
    distance = 4 * a + x * sp.sign(e) - 5 * sp.Abs(e)
    return eccentric("p", lambda expr: expr * distance**2 / sp.expand(distance**2), 1)


def twice_the_graded_modulus() -> Claim:
    true = derived("materials")
    wrong = replace(true["H"], cases=(replace(true["H"].cases[0], expr=2 * true["H"].cases[0].expr),))
    return shown(materials.Materials({**true, "H": wrong}).graded)


def load_too_steep_at_the_edge() -> Claim:
    """(1 - r^2/a^2)^(-3/2) has no resultant, and the Beta function in front of its displacement is formally 0."""
    true = derived("loads.punch")["w"]
    load = replace(true.profile, exponent=-3 * HALF)
    cases = tuple(replace(case, expr=sp.S.Zero) for case in true.cases)
    return certified(load, {"w": replace(true, profile=load, cases=cases)}, "w")


NEEDED: Refusals = {
    # plane contact
    "plane.Plane.depth: require_regions(entry, tuple((chain for regime in self._regi": (
        lambda: only("plane.rounded_wedge", "d", 0, 1),
        ONCE,
    ),
    "plane.Plane.depth: require_analytic(case.expr, domain)": (
        lambda: plus("plane.parabola", "d", R * STEP.subs(U, L / (2 * a))),
        "the real range of Piecewise",
    ),
    "plane.Plane.half_width: require_regions(entry, self._regimes())": (
        lambda: only("plane.rounded_wedge", "aP", 0),
        ONCE,
    ),
    "plane.Plane.half_width: dP/da > 0 is not shown": (falling_load, "dP/da > 0 is not shown"),
    "plane.PlaneComplete._superposition: require_regions(self.entries[suffix], (chain,))": (
        lambda: regions("plane.flat_punch", "p", (a, x)),
        ONCE,
    ),
    "plane.PlaneComplete.minimum_load: require_regions(self.entries['Pmin'], ((a,),))": (
        lambda: regions("plane.concave_parabola", "Pmin", (a, h)),
        ONCE,
    ),
    "plane.PlaneComplete.minimum_load: require_regions(self.entries['xz'], ((a,),))": (
        lambda: regions("plane.concave_parabola", "xz", (a, h)),
        ONCE,
    ),
    "rings.by_squares: p >= 0 at the least load is not shown": (
        ring_elsewhere,
        "p >= 0 at the least load is not shown",
    ),
    "rings.by_squares: 0 <= ... < a is not shown": (
        lambda: times("concave_quartic", "rz", -1),
        "< a is not shown",
    ),
    "rings.by_root: ... > 0 is not shown": (turned_face, "> 0 is not shown"),
    "rings._case: require_regions(place, regions)": (
        lambda: beside("plane.concave_power", "xz", Case((sp.S.One, n), a / 3)),
        ONCE,
    ),
    "rings._ring: _require_no_zero(sp.diff(linear, level), n)": (
        ring_of_another_equation,
        "is not shown to have no zero at the ring",
    ),
    "rings._require_no_zero: ... is not shown to have no zero at the ring": (
        undefined_at_the_ring,
        "is not shown to have no zero at the ring",
    ),
    "rings._centre: ... is not the centre": (
        lambda: set_to("plane.concave_power", "xz", a / 2),
        "is not the centre",
    ),
    "rings.at_root: _require_no_zero(denominator, n)": (
        undefined_at_the_ring,
        "is not shown to have no zero at the ring",
    ),
    "plane.Tilted._expr: the sign of ... is not shown": (
        lambda: eccentric("p", lambda expr: expr + P / a * sp.sign(4 * e * x - a**2)),
        "the sign of",
    ),
    "plane.Tilted._mirrored: ... is not mirrored by x -> -x, e -> -e": (
        lambda: eccentric("p", lambda expr: expr.subs(sp.sign(e), 1), 1),
        "is not mirrored",
    ),
    "plane.Tilted.pressure: p > 0 at both edges for abs(e) < a/2 is not shown": (
        touching_beyond_the_core,
        "at both edges",
    ),
    "plane.Tilted.pressure: require_analytic(beyond, LIFTED.domain)": (
        undefined_where_lifted,
        "is not shown to be positive",
    ),
    # loads and materials
    "loads.Loads.displacement: require_regions(entry, ((r, a), (a, r)))": (lambda: only("loads.uniform", "w", 0), ONCE),
    "loads.Loads._case: require_analytic(expr, domain)": (
        lambda: plus("loads.uniform", "w", nt.p_0 / E_star * (a * (4 * r**2 - a**2) / ((2 * r - a) * (2 * r + a)) - a)),
        "is not shown to be positive",
    ),
    "loads.Loads._case: the pressure of exponent ... has no resultant": (
        load_too_steep_at_the_edge,
        "has no resultant",
    ),
    "materials.Materials._formula: require_regions(entry, ((),))": (
        lambda: regions("materials", "E_star", (nt.young_1, nt.young_2)),
        ONCE,
    ),
    "materials.Materials._equal: ...: not shown": (twice_the_graded_modulus, "H by its definition: not shown"),
}


WORDING: Refusals = {
    "materials.Materials.factor: h_N is compared with a solution of the equations of equilibr": (
        lambda: times("materials", "h_N", 2),
        "h_N is compared with a solution",
    ),
    "rings.by_squares: the weighted pressure is not a polynomial in ...": (
        lambda: times("concave_paraboloid", "dmin", sp.sqrt(2)),
        "the weighted pressure is not a polynomial in r",
    ),
    "plane.Tilted._expr: require_regions(self.entries[suffix], tuple(REGIONS))": (
        lambda: beside("plane.eccentric_punch", "cw", Case((a, sp.Abs(e)), 7 * a)),
        ONCE,
    ),
    "plane.Tilted._numerator: p sqrt(c^2 - xi^2) is not of first degree in xi": (
        lambda: eccentric("p", lambda expr: expr * (1 + x**2 / a**2)),
        "is not of first degree in xi",
    ),
}


ALTERED: dict[str, Altered] = {
    "pressure and not tension": (
        "rings",
        "by_squares",
        "unit < 0 or ",
        "",
        lambda: bulging("concave_quartic", a / 2),
        "p >= 0 at the least load is not shown",
    ),
    "the ring inside the contact": (
        "rings",
        "by_squares",
        "sign(a - place, edge) > 0 and ",
        "",
        lambda: bulging("concave_paraboloid", 2 * a),
        "< a is not shown",
    ),
}
