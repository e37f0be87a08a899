"""What the prover must refuse of compact and of complete contact, and of the ring of the greatest pressure."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from axiderive import notation as nt
from axiderive.entry import Case
from axiderive.notation import E_star, R, a, b, d, h, r, x
from axiderive.profiles.profile import Piece

from .claims import (
    JUMP,
    ONCE,
    STEP,
    Altered,
    Change,
    Claim,
    Leap,
    Refusals,
    U,
    beside,
    certified,
    derived,
    formula,
    hole,
    only,
    plus,
    regions,
    stated,
    times,
)


def whole_sphere_over_a_cone() -> Claim:
    """The depth of the sphere goes on where the sphere has become a cone, without an antiderivative."""
    entry = derived("sphere_tipped_cone.fgm")["d"]
    sphere, cone, *others = entry.cases
    cases = (sphere, replace(cone, expr=sphere.expr), *others)
    primitives = {chain: found for chain, found in entry.primitives.items() if chain != cone.chain}
    return stated("sphere_tipped_cone.fgm", "d", cases=cases, primitives=primitives)


def hollowed(key: str) -> Claim:
    """The place of a profile with its sign changed, where the pressure is least."""
    true = derived(key)
    profile = true["rp"].profile
    hollow = replace(profile, pieces=tuple(replace(piece, expr=-piece.expr) for piece in profile.pieces))
    rings = true["rp"].cases
    if profile.breaks:
        rings = tuple(replace(one, expr=sp.Eq(-one.expr.lhs, -one.expr.rhs, evaluate=False)) for one in rings)
    entries = {"rp": replace(true["rp"], profile=hollow, cases=rings)}
    for suffix in ("d", "p"):
        cases = tuple(replace(case, expr=-case.expr) for case in true[suffix].cases)
        primitives = {
            chain: tuple(replace(one, integrand=-one.integrand, expr=-one.expr) for one in found)
            for chain, found in true[suffix].primitives.items()
        }
        entries[suffix] = replace(true[suffix], profile=hollow, cases=cases, primitives=primitives)
    return certified(hollow, entries, "rp")


def balance(change: Callable[[sp.Expr, sp.Expr], tuple[sp.Expr, sp.Expr]]) -> Claim:
    """Another equation for the ring under a rounded edge."""
    return formula("rounded_punch", "rp", lambda equation: sp.Eq(*change(*equation.args), evaluate=False))


def depth_with(key: str, change: Change, **chosen: Change) -> Claim:
    """A depth with another formula and another first antiderivative."""
    entry = derived(key)["d"]
    case = entry.cases[0]
    (first,) = entry.primitives[case.chain]
    fields = {name: own(getattr(first, name)) for name, own in chosen.items()}
    cases = (replace(case, expr=change(case.expr)),)
    return stated(key, "d", cases=cases, primitives={case.chain: (replace(first, **fields),)})


def antiderivative_beyond_the_contact() -> Claim:
    """A part of the integrand is integrated up to R, outside of the contact."""
    entry = derived("sphere")["d"]
    case = entry.cases[0]
    (first,) = entry.primitives[case.chain]
    lent = x**2 / R
    own = replace(first, integrand=first.integrand - sp.diff(lent, x), expr=first.expr - lent)
    beyond = replace(first, hi=R, integrand=sp.diff(lent, x), expr=lent)
    cases = (replace(case, expr=case.expr + R - a**2 / R),)
    return stated("sphere", "d", cases=cases, primitives={case.chain: (own, beyond)})


def antiderivative_from_beyond_the_contact() -> Claim:
    """An increment that belongs to no interval."""
    entry = derived("sphere")["d"]
    case = entry.cases[0]
    (first,) = entry.primitives[case.chain]
    lent = x**2 / R
    beyond = replace(first, lo=R, integrand=sp.diff(lent, x), expr=lent)
    cases = (replace(case, expr=case.expr + a**2 / R - R),)
    return stated("sphere", "d", cases=cases, primitives={case.chain: (first, beyond)})


def antiderivative_with_a_jump() -> Claim:
    jump = R * JUMP.subs(U, 2 * x / a)
    return depth_with(
        "paraboloid",
        lambda depth: depth + sp.pi * R,
        integrand=lambda own: own + sp.diff(jump, x),
        expr=lambda own: own + jump,
    )


def depth_of(face: sp.Expr, expr: sp.Expr, **fields: Any) -> Claim:
    """The depth of another face, as an entry of the paraboloid."""
    true = derived("paraboloid")["d"]
    profile = replace(true.profile, pieces=(Piece(None, face),), parameters=(R, b))
    case = replace(true.cases[0], expr=expr)
    entry = replace(true, profile=profile, cases=(case,), parameters=(R, b), **fields)
    return certified(profile, {"d": entry}, "d")


def face_with_a_jump() -> Claim:
    own = derived("paraboloid")["d"]
    return depth_of(r**2 / (2 * R) * 2 / 2 + R * JUMP.subs(U, r / R), own.cases[0].expr)


def force_without_its_depth() -> Claim:
    true = derived("rounded_cone")
    entries = {**true, "d": replace(true["d"], cases=true["d"].cases[:1])}
    return certified(true["d"].profile, entries, "F")


NEEDED: Refusals = {
    # compact contact
    "compact.Compact._by_definition: the antiderivatives at hand leave ...": (
        whole_sphere_over_a_cone,
        "the antiderivatives at hand leave",
    ),
    "compact.Compact._by_antiderivatives: require_regions(entry, self._regimes())": (
        lambda: only("rounded_cone", "d", 0),
        ONCE,
    ),
    "compact.Compact._by_antiderivatives: require_analytic(expr, domain)": (
        lambda: stated(
            "sphere.fgm",
            "d",
            cases=(
                replace(
                    derived("sphere.fgm")["d"].cases[0],
                    expr=derived("sphere.fgm")["d"].cases[0].expr + a * hole(2 * a) - a,
                ),
            ),
            primitives={},
        ),
        "is not shown to be positive",
    ),
    "compact.Compact._increment: the antiderivative from ... to ... does not end at breaks of": (
        antiderivative_beyond_the_contact,
        "does not end at breaks of the profile",
    ),
    "compact.Compact._without_antiderivative: require_analytic(face, domain)": (
        face_with_a_jump,
        "is not shown to be positive",
    ),
    "compact.Compact._without_antiderivative: require_analytic(primitive.expr, domain)": (
        antiderivative_with_a_jump,
        "is not shown to be positive",
    ),
    "compact.Compact._without_antiderivative: require_zero(sp.diff(primitive.expr, x) - primitive.integran": (
        lambda: depth_with("paraboloid", lambda depth: 2 * depth, expr=lambda own: 2 * own),
        "does not hold",
    ),
    "compact.Compact._integral: require_regions(entry, tuple((chain for regime in self._regi": (
        lambda: only("rounded_cone", "F", 0),
        ONCE,
    ),
    "compact.Compact._integral: require_analytic(expr, domain)": (
        lambda: plus("paraboloid", "F", E_star * R**2 * STEP.subs(U, a / R)),
        "the real range of Piecewise",
    ),
    "compact.Compact.follows: require_regions(entry, tuple(places))": (lambda: only("capped_paraboloid", "U", 0), ONCE),
    "compact.Compact.follows: require_analytic(expr, domain)": (
        lambda: plus("paraboloid", "U", E_star * R**3 * STEP.subs(U, a / R)),
        "the real range of Piecewise",
    ),
    "compact.Compact.stiffness: require_regions(entry, ((a,),))": (lambda: regions("paraboloid", "k", (a, R)), ONCE),
    "compact.Compact.mean_pressure: require_regions(entry, self._regimes())": (
        lambda: only("rounded_cone", "pm", 0),
        ONCE,
    ),
    "compact.Compact._range: ... is no range of ...": (
        lambda: regions("paraboloid", "ad", (R, sp.S.Zero, d)),
        "is no range of d",
    ),
    "compact.Compact._range: the region of the inverse does not end where that of ...(a)": (
        lambda: regions("paraboloid", "ad", (d, R)),
        "does not end where that of",
    ),
    # the greatest pressure
    "rings.greatest: require_regions(entry, regimes)": (lambda: regions("quartic", "rp", (a, h)), ONCE),
    "rings._on_axis: f'(r) > 0 is not shown: ...": (lambda: hollowed("paraboloid"), "> 0 is not shown"),
    "rings._on_axis: (f'(r)/r)' <= 0 is not shown: ...": (
        lambda: formula("quartic", "rp", lambda radius: sp.S.Zero),
        "<= 0 is not shown",
    ),
    "rings._formula: one change of the sign of dp/dr, from positive to negative,": (
        lambda: hollowed("quartic"),
        "one change of the sign of dp/dr",
    ),
    "rings._formula: ... > 0 is not shown": (lambda: times("quartic", "rp", -1), "> 0 is not shown"),
    "rings._of_power: require_regions(entry, ((one, n, two), (two, n)))": (
        lambda: beside("power_law", "rp", Case((a, h), sp.Integer(7))),
        ONCE,
    ),
    "rings._of_power: one change of the sign of dp/dr for n > 2, and none for n <=": (
        lambda: hollowed("power_law"),
        "one change of the sign of dp/dr for n > 2",
    ),
    "rings._of_arc: require_regions(entry, ((level, one), (one, level)))": (
        lambda: beside("ellipsoid", "rp", Case((a, h), sp.Integer(7))),
        ONCE,
    ),
    "rings._of_arc: dp/dr that is negative up to level = 1, and changes its sign": (
        lambda: hollowed("ellipsoid"),
        "changes its sign once beyond",
    ),
    "rings._pressure_of_power: require_regions(entry, ((sp.Integer(1), n),))": (
        lambda: regions("power_law", "pp", (a, h)),
        ONCE,
    ),
    "rings._balance: require_analytic(left, outside)": (
        lambda: balance(lambda left, right: (left + Leap(a - nt.r_peak), right)),
        "the real range of Leap",
    ),
    "rings._balance: (g'(a)/a)' > 0, over a falling with a and beyond all bounds": (
        lambda: hollowed("rounded_punch"),
        "beyond all bounds as a -> b",
    ),
    "rings._factor: ... is no positive factor that does not depend on a": (
        lambda: balance(lambda left, right: (left * (nt.r_peak - 2 * b), right * (nt.r_peak - 2 * b))),
        "is no positive factor",
    ),
    "rings.greatest_pressure: require_regions(entry, tuple((case.chain for case in proof.e": (
        lambda: regions("quartic", "pp", (a, h)),
        ONCE,
    ),
    "rings.greatest_pressure: ... > 0 is not shown": (lambda: times("quartic", "pp", -1), "> 0 is not shown"),
    # complete contact
    "complete.Complete._fixed: require_regions(entry, before + after)": (
        lambda: regions("flat_punch", "p", (a, r)),
        ONCE,
    ),
    "complete.Complete._fixed: require_analytic(fixed.expr, domain)": (
        lambda: plus("flat_punch", "F", E_star * d**2 * STEP.subs(U, a / d)),
        "the real range of Piecewise",
    ),
    "complete.Complete._alone: require_regions(entry, ((a,),))": (
        lambda: regions("concave_paraboloid", "dmin", (a, h)),
        ONCE,
    ),
}


WORDING: Refusals = {
    "compact.Compact.depth_of: no ... is given for ...": (force_without_its_depth, "no d is given for b < a"),
}


ALTERED: dict[str, Altered] = {
    "the value at an end": (
        "compact",
        "Compact._integral",
        "steps.append(self._end_value(entry, case, expr))",
        "pass",
        lambda: plus("paraboloid", "F", E_star * R**2),
        "F -> 0 as a -> 0 does not hold",
    ),
    "antiderivatives from breaks": (
        "compact",
        "Compact._increment",
        "(primitive.lo, primitive.hi) not in itertools.combinations(ends, 2)",
        "primitive.hi not in ends",
        antiderivative_from_beyond_the_contact,
        "does not end at breaks of the profile",
    ),
    "the range of an inverse below": (
        "compact",
        "Compact._range",
        "steps = [require_zero(gap, domain.at(a, lower), statement)]",
        "steps = []",
        lambda: regions("paraboloid", "ad", (R, d)),
        "d = R at a = 0 does not hold",
    ),
}
