"""Complete contact: the edge is fixed, the depth is free.

With w1D = d - g the edge term of (11.107), E* w1D(a)/(pi sqrt(a^2 - r^2)),
remains; a concave face needs a least depth and force.  A face -h (r/a)^n is
reduced with its coefficient C = h/a^n held fixed, because the Abel integrals
are taken over the radius.
"""

from __future__ import annotations

import sympy as sp

from ..abel.atoms import PowerAtom
from ..abel.form import Form, Order
from ..abel.masters import Master
from ..abel.reduce import NotReducibleError, Reduced, parse
from ..entry import COMPLETE, Case, Entry, Quantity, Status
from ..notation import C, F, a, d, r, r_zero, t
from ..profiles.profile import Piece, Profile
from .consequences import CONSEQUENCES
from .medium import HOMOGENEOUS, Medium

REFERENCES = {
    "F": (("(11.13)", "(11.20)"), ("(11.45)", "(11.51)")),
    "p": (("(11.15)", "(11.107)"), ("(11.47)", "(11.53)")),
    "w": (("(11.12)", "(11.105)"), ("(11.44)", "(11.56)")),
    "k": (("(11.14)",), ("(11.46)",)),
    "dF": (("(11.14)", "(11.20)"), ("(11.46)", "(11.51)")),
    "rz": ((), ()),
    "dmin": ((), ()),
    "Fmin": ((), ()),
}


def derive(profile: Profile, medium: Medium = HOMOGENEOUS) -> dict[str, Entry]:
    """All entries of a profile in complete contact, keyed by suffix."""
    face, coefficient = fixed_face(profile)
    reduced = parse(face, medium.k)
    fixed = _fixed_formulas(reduced, medium)
    cases = {name: Case(case.chain, _merged(case.expr.subs(C, coefficient))) for name, case in fixed.items()}
    concave = coefficient != 0
    if not concave and reduced.atoms:
        return _with_partial(profile, medium, cases, fixed)
    entries = {name: _entry(profile, medium, name, (case,), fixed_face=(fixed[name],)) for name, case in cases.items()}
    if concave:
        entries |= _threshold(profile, medium, reduced, coefficient, cases)
    return entries


def place_of(quantity: Quantity) -> tuple[sp.Expr, ...]:
    """The lengths of its region in ascending order: of a field the place, inside or outside, and the edge."""
    return {"inside": (r, a), "outside": (a, r), "": (a,)}[quantity.place]


def edge_depth(profile: Profile, medium: Medium = HOMOGENEOUS) -> sp.Expr:
    """g(a), the depth at which the pressure has no singularity at the edge."""
    face, coefficient = fixed_face(profile)
    depth = parse(face, medium.k).depth(Order((a,))).expr()
    return _merged(depth.subs(C, coefficient))


def _entry(
    profile: Profile,
    medium: Medium,
    suffix: str,
    cases: tuple[Case, ...],
    status: Status = "closed",
    fixed_face: tuple[Case, ...] = (),
    partial: Entry | None = None,
) -> Entry:
    quantity = COMPLETE.get(suffix) or CONSEQUENCES[suffix].complete
    material = medium.moduli if quantity.elastic else medium.moduli[1:]
    return Entry(
        key=medium.key(profile.name, medium.group, suffix),
        profile=profile,
        quantity=quantity,
        status=status,
        cases=cases,
        definition=definitions(medium)[suffix],
        parameters=profile.parameters + material,
        references=REFERENCES.get(suffix, ((), ()))[medium.k != 0],
        fixed_face=fixed_face,
        partial=partial,
    )


def definitions(medium: Medium) -> dict[str, sp.Expr]:
    """The defining integrals of complete contact, with w1D(t) = d - g(t)."""
    w1D, k = sp.Function("w1D"), medium.k
    edge = w1D(a) * (a**2 - r**2) ** ((k - 1) / 2)
    sunk = sp.Integral(sp.Derivative(w1D(t), t) * (t**2 - r**2) ** ((k - 1) / 2), (t, r, a))
    force = medium.force_scale * sp.Integral(t**k * w1D(t), (t, 0, a))
    return {
        "F": force,
        "p": medium.pressure_scale * (edge - sunk),
        "w": medium.displacement_scale * sp.Integral(t**k * w1D(t) * (r**2 - t**2) ** (-(1 + k) / 2), (t, 0, a)),
        "k": sp.Derivative(F, d),
        "dF": sp.Eq(force, F),
        "rz": sp.Eq(sp.Derivative((a**2 - r**2) ** ((1 - k) / 2) * sp.Function("p")(r), r), 0),
        "dmin": sp.Eq(sp.Function("p")(r_zero), 0),
        "Fmin": force,
        **{suffix: own.fixed_definition for suffix, own in CONSEQUENCES.items()},
    }


def fixed_face(profile: Profile) -> tuple[tuple[Piece, ...], sp.Expr]:
    """The face with C for its coefficient where that depends on a, and what C stands for."""
    (piece,) = profile.pieces
    if not piece.expr.has(a):
        return profile.pieces, sp.S.Zero
    factor, power = sp.expand_power_base(piece.expr).as_independent(r, as_Add=False)
    return (Piece(None, -C * power),), -factor


def _fixed_formulas(reduced: Reduced, medium: Medium) -> dict[str, Case]:
    """Force, pressure, displacement, stiffness and depth(F) with the coefficient of the face independent of a."""
    inside, outside, edge = (r, a), (a, r), (a,)
    g, force = reduced.depth(Order(edge)), reduced.force(Order(edge))
    pressure, displacement = reduced.pressure(Order(inside)), reduced.displacement(Order(outside))
    if pressure is None or displacement is None:
        message = f"the face {reduced.atoms} has no closed pressure; use a sum of powers of r"
        raise NotReducibleError(message)
    stiffness = medium.stiffness()
    gap = Form.of(d) + g * -1
    depth = Form.of(F, 1 / stiffness) + g + force * (-medium.force_scale / stiffness)
    further = {} if medium.graded else CONSEQUENCES
    return {
        **{suffix: Case(place_of(own.complete), own.fixed(reduced, medium)) for suffix, own in further.items()},
        "F": Case(edge, (gap * stiffness + force * medium.force_scale).expr()),
        "p": Case(inside, (gap.times(medium.punch_pressure()) + pressure * medium.pressure_scale).expr()),
        "w": Case(outside, (gap.times(medium.punch_displacement()) + displacement * medium.displacement_scale).expr()),
        "k": Case(edge, stiffness),
        "dF": Case(edge, depth.expr()),
    }


def _with_partial(profile: Profile, medium: Medium, cases: dict[str, Case], fixed: dict[str, Case]) -> dict[str, Entry]:
    """A convex face touches first like the unbounded profile, with contact radius rho = a(d) < a."""
    from dataclasses import replace

    from .normal import derive as derive_compact

    geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
    unbounded = derive_compact(replace(profile, contact="compact", parameters=geometry), medium)
    rho = unbounded["ad"].cases[0].expr
    full_force = unbounded["F"].cases[0].expr
    entries = {}
    for suffix, case in cases.items():
        if suffix == "dF":
            partial = Case((F, full_force), unbounded["dF"].cases[0].expr)
            both: tuple[Case, ...] = (partial, Case((full_force, F), case.expr))
        else:
            source = unbounded[suffix].cases[0]
            moved, place = source.expr.subs(a, rho), unbounded[suffix].quantity.place
            before = {"inside": ((r, rho, a),), "outside": ((rho, r, a), (rho, a, r))}.get(place, ((rho, a),))
            after = {"inside": ((r, a, rho),), "outside": ((a, r, rho), (a, rho, r))}.get(place, ((a, rho),))
            both = tuple(Case(chain, moved) for chain in before) + tuple(Case(chain, case.expr) for chain in after)
        entries[suffix] = _entry(profile, medium, suffix, both, fixed_face=(fixed[suffix],), partial=unbounded[suffix])
    return entries


def _threshold(
    profile: Profile, medium: Medium, reduced: Reduced, coefficient: sp.Expr, cases: dict[str, Case]
) -> dict[str, Entry]:
    """Where and at which depth the pressure first vanishes on unloading.

    sqrt(a^2 - r^2) p = E*/pi [d - g(a) + sqrt(a^2 - r^2) P^(r)] has its minimum over r at the centre for n <= 2
    and on a ring for n > 2; there d is the least depth of complete contact.
    """
    k, (exponent,) = medium.k, [atom.n for atom in reduced.atoms if isinstance(atom, PowerAtom)]
    form = reduced.pressure(Order((r, a))) or Form()
    depth = reduced.depth(Order((a,))).expr()
    z, q = sp.symbols("z q", positive=True)  # z = 1 - r^2/a^2 and q = r^2/a^2, kept apart so that powers merge

    def scaled(expr: sp.Expr) -> sp.Expr:
        return sp.powsimp(sp.expand(expr.subs(a**2 - r**2, a**2 * z).subs(1 - r**2 / a**2, z).subs(r, a * sp.sqrt(q))))

    weighted = scaled(a ** (1 - k) * z ** ((1 - k) / 2) * form.expr())
    slope = (sp.diff(weighted, z) - sp.diff(weighted, q)).subs(1 - z, q)
    masters = weighted.atoms(Master)
    if masters:
        (master,) = masters
        level = sp.Symbol("level")
        linear = sp.expand(slope.subs(master, level))
        solved = sp.factor(sp.powsimp(sp.cancel(-linear.coeff(level, 0) / linear.coeff(level, 1))))
        at_ring = sp.cancel(sp.powsimp(sp.expand(weighted.subs(master, solved))))
        ring = sp.Eq(master, _in_ratio(solved, q)).subs({z: 1 - r_zero**2 / a**2, q: r_zero**2 / a**2})
        status: Status = "root"
        two = sp.Integer(2)
        ring_cases: tuple[Case, ...] = (Case((1 - k, exponent, two), sp.S.Zero), Case((two, exponent), ring))
        radius: sp.Expr = r_zero
    else:
        stationary = sp.Poly(sp.expand(slope).subs(z, 1 - q), q)
        found = sp.solve(stationary.as_expr(), q) if stationary.degree() > 0 else []
        radius = a * sp.sqrt(sp.factor(found[0])) if found else sp.S.Zero
        at_ring, status = weighted, "closed"
        ring_cases = (Case((a,), radius),)
    least = (depth - at_ring).subs(C, coefficient).subs(z, 1 - q).subs(q, radius**2 / a**2)
    least = sp.powsimp(sp.factor(sp.powsimp(sp.expand(least))), combine="exp")
    force = _merged(sp.factor(cases["F"].expr.subs(d, least)))
    return {
        "rz": _entry(profile, medium, "rz", ring_cases, status),
        "dmin": _entry(profile, medium, "dmin", (Case((a,), least),), "closed"),
        "Fmin": _entry(profile, medium, "Fmin", (Case((a,), force),), "closed"),
    }


def _merged(expr: sp.Expr) -> sp.Expr:
    """With C = h/a^n put in: the powers of a as one, outside the sum."""
    if not any(power.exp.free_symbols for power in expr.atoms(sp.Pow)):
        return expr
    return sp.factor_terms(sp.powsimp(expr, combine="exp"))


def _in_ratio(expr: sp.Expr, q: sp.Symbol) -> sp.Expr:
    """Powers of q = (r_zero/a)**2 as one power of r_zero/a, which every SymPy would merge in its own way."""
    ratio = sp.Symbol("ratio", positive=True)
    return sp.powsimp(expr.subs(q, ratio**2), combine="exp").subs(ratio, r_zero / a)
