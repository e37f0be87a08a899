"""Every refusal of the prover is needed: a false entry that only this one refuses, and that is certified without it.

A new refusal without a false entry makes `test_every_guard_has_a_false_entry` fail.
"""

from __future__ import annotations

import functools
import re
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import guards
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.abel.masters import Hypergeometric, IncompleteBeta
from axiderive.entry import Case, Entry
from axiderive.notation import E_star, F, L, P, R, a, a_c, b, d, dgamma, e, h, n, r, time, x
from axiderive.physics import systems, viscoelastic
from axiderive.profiles.profile import Piece, Profile, Rule
from axiderive.proof import certificate, statement
from axiderive.proof.algebra import functions, identity
from axiderive.proof.algebra.domain import Domain, NotProvedError
from axiderive.proof.rules import graded, materials, plane, rings
from axiderive.proof.rules import viscoelastic as relaxing

Claim = Callable[[], str]
"""What is claimed falsely: the reason why it is refused, empty if it is certified."""
Change = Callable[[sp.Expr], sp.Expr]
Entries = dict[str, Entry]

HALF = sp.S.Half
ONCE = "do not cover its regions once"
U = sp.Symbol("u", positive=True)
JUMP = sp.atan(U - 1) + sp.atan(1 / (U - 1)) + sp.pi / 2
"""0 below u = 1 and pi above, with the derivative 0."""
STEP = sp.Piecewise((0, U < 1), (1, True))
ARCS = 2 * (sp.asin(U) + sp.acos(U)) / sp.pi
"""1 below u = 1, not real above."""


class Leap(sp.Function):  # type: ignore[misc]
    """0 below 1, and 1 above."""

    @classmethod
    def eval(cls, place: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if place == 0 else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return sp.S.Zero


def hole(length: sp.Expr) -> sp.Expr:
    """1, but not defined where the length is R."""
    return (length**2 - R**2) / ((length - R) * (length + R))


# claims


@functools.cache
def derived(key: str) -> Entries:
    return systems.problem(key).derive()


def certified(profile: Profile, entries: Entries, suffix: str) -> Claim:
    return lambda: certificate.certify(profile, entries, suffix).reason


def stated(key: str, suffix: str, /, **fields: Any) -> Claim:
    """An entry with other fields among the true ones."""
    entries = derived(key)
    changed = {**entries, suffix: replace(entries[suffix], **fields)}
    return certified(entries[suffix].profile, changed, suffix)


def formula(key: str, suffix: str, change: Change, index: int = 0) -> Claim:
    """An entry with another formula in one case, and for a fixed face."""
    entry = derived(key)[suffix]
    cases = list(entry.cases)
    cases[index] = replace(cases[index], expr=change(cases[index].expr))
    faces = tuple(replace(face, expr=change(face.expr)) for face in entry.fixed_face)
    return stated(key, suffix, cases=tuple(cases), fixed_face=faces)


def plus(key: str, suffix: str, term: sp.Expr) -> Claim:
    return formula(key, suffix, lambda expr: expr + term)


def times(key: str, suffix: str, factor: Any) -> Claim:
    return formula(key, suffix, lambda expr: expr * factor)


def set_to(key: str, suffix: str, value: sp.Expr) -> Claim:
    return formula(key, suffix, lambda _: value)


def regions(key: str, suffix: str, *chains: tuple[sp.Expr, ...]) -> Claim:
    """The true formulas on other regions."""
    cases = derived(key)[suffix].cases
    return stated(
        key, suffix, cases=tuple(replace(case, chain=chain) for case, chain in zip(cases, chains, strict=True))
    )


def only(key: str, suffix: str, *kept: int) -> Claim:
    """The true formulas of some regions alone."""
    cases = derived(key)[suffix].cases
    return stated(key, suffix, cases=tuple(cases[i] for i in kept))


def beside(key: str, suffix: str, case: Case) -> Claim:
    """A case more than the true ones."""
    return stated(key, suffix, cases=(*derived(key)[suffix].cases, case))


def shown(statement: Callable[[], Any]) -> Claim:
    """A statement of the prover itself."""

    def claim() -> str:
        try:
            return "" if statement() else "not shown"
        except NotProvedError as error:
            return str(error)
        except Exception as error:
            return f"the proof stopped: {type(error).__name__}: {error}"

    return claim


# false entries that take more than a line


def whole_sphere_over_a_cone() -> Claim:
    """The depth of the sphere goes on where the sphere has become a cone, without an antiderivative."""
    entry = derived("sphere_tipped_cone.fgm")["d"]
    sphere, cone, *others = entry.cases
    cases = (sphere, replace(cone, expr=sphere.expr), *others)
    primitives = {chain: found for chain, found in entry.primitives.items() if chain != cone.chain}
    return stated("sphere_tipped_cone.fgm", "d", cases=cases, primitives=primitives)


def hollowed(key: str) -> Claim:
    """The ring of a profile with its sign changed, where the pressure is least."""
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


def root_of_a_square() -> Claim:
    """The root of (a - b)^2 is taken for a - b, even where a < b."""
    root = sp.sqrt(a**2 - 2 * a * b + b**2)
    return shown(lambda: identity.is_zero(root - (a - b), Domain((a,), (b,))))


def face_with_an_absolute_value() -> Claim:
    return depth_of(r**2 / (2 * R) * sp.Abs(b - R) / R, sp.S.Zero, primitives={})


def endless_integral() -> Claim:
    """A face without a tip: Euler's integral for its depth does not exist."""
    z = a**2 / R**2
    root = sp.sqrt(1 - r**2 / R**2)
    parts = Hypergeometric(-HALF, -HALF / 2, HALF / 2, z), Hypergeometric(HALF, 3 * HALF / 2, 5 * HALF / 2, z)
    first = sp.gamma(3 * HALF / 2) * sp.sqrt(sp.pi) / sp.gamma(HALF / 2) * parts[0]
    second = -z * sp.gamma(3 * HALF / 2) * sp.sqrt(sp.pi) / (2 * sp.gamma(5 * HALF / 2)) * parts[1]
    true = derived("sphere")["d"]
    face = R ** (3 * HALF) * r**-HALF * root
    profile = replace(true.profile, pieces=(Piece(None, face),))
    depth = R ** (3 * HALF) * a**-HALF * (first + second)
    entry = replace(true, profile=profile, cases=(replace(true.cases[0], expr=depth),), primitives={})
    return certified(profile, {"d": entry}, "d")


HOLLOW = R**2 / (R - b)
"""A radius that is negative, because R < b."""


def hollow(suffix: str, change: Change) -> Claim:
    """An entry under a face that curves the other way, which never holds on."""
    true = derived("paraboloid.adh")
    rule = Rule(R, b, True, "the face is hollow")
    piece = Piece(None, r**2 / (2 * HOLLOW))
    profile = replace(true["F"].profile, pieces=(piece,), parameters=(R, b), rules=(rule,))
    entries = {}
    for own in ("Dl", "d", "F", suffix):
        entry, turned = true[own], change if own == suffix else lambda expr: expr.subs(R, HOLLOW)
        cases = tuple(replace(case, expr=turned(case.expr)) for case in entry.cases)
        parameters = entry.parameters if own == "Dl" else (R, b, E_star, dgamma)
        entries[own] = replace(entry, profile=profile, parameters=parameters, cases=cases)
    return certified(profile, entries, suffix)


def unstable_radius() -> Claim:
    radius = R**2 / (b - R)
    energy = 9 * sp.pi * radius**2 * dgamma / (8 * E_star)
    found = (sp.sqrt(energy - 3 * F * radius / (4 * E_star)) - sp.sqrt(energy)) ** sp.Rational(2, 3)
    return hollow("aF", lambda _: found)


def sharp_tip() -> Claim:
    """Under a face r^(1/4) the force has no minimum."""
    true = derived("power_law.adh")
    face, sharp = true["F"].profile, sp.Rational(1, 4)
    piece = Piece(None, face.pieces[0].expr.subs(n, sharp))
    profile = replace(face, pieces=(piece,), parameters=(nt.A,), rules=())
    entries = {}
    for suffix in ("Dl", "F", "ac"):
        entry = true[suffix]
        parameters = tuple(symbol for symbol in entry.parameters if symbol != n)
        cases = tuple(replace(case, expr=case.expr.subs(n, sharp)) for case in entry.cases)
        entries[suffix] = replace(entry, profile=profile, parameters=parameters, cases=cases)
    return certified(profile, entries, "ac")


def convex_edge() -> Claim:
    """An edge that peels from a paraboloid stops."""
    true, face = derived("flat_punch.adh"), derived("capped_cylinder")["F"].profile
    names = (*face.parameters, E_star, dgamma)
    entries = {}
    for suffix, entry in true.items():
        expr = entry.cases[0].expr + (a**2 / R if suffix == "dc" else 0)
        parameters = entry.parameters if suffix == "Dl" else names
        key = entry.key.replace("flat_punch", face.name)
        entries[suffix] = replace(entry, key=key, profile=face, cases=(Case((a,), expr),), parameters=parameters)
    return certified(face, entries, "dc")


MAXWELL, VOIGT, _, POWER_CREEP = viscoelastic.LAWS


def law_with_a_changing_rate() -> Claim:
    rate = time / nt.relaxation**2
    law = replace(VOIGT, creep=(1 - sp.exp(-rate * time)) / nt.E, impulse=nt.E / rate)
    return shown(lambda: relaxing.duality(law))


def law_too_steep_at_the_start() -> Claim:
    power = 3 * HALF
    law = replace(
        POWER_CREEP,
        relaxation=nt.E * (nt.t_0 / time) ** power / (sp.gamma(1 + power) * sp.gamma(1 - power)),
        creep=(time / nt.t_0) ** power / nt.E,
    )
    return shown(lambda: relaxing.duality(law))


def with_law(law: viscoelastic.Law) -> Claim:
    """The radius under a constant load for another law in place of that of the same name."""
    suffix = f"load_{law.suffix}"
    radius = derived("cone")["aF"].cases[0].expr.subs(E_star, 1 / law.creep)
    true = derived("cone.vis")[suffix]
    entries = {**derived("cone.vis"), suffix: replace(true, cases=(replace(true.cases[0], expr=radius),))}

    def claim() -> str:
        before = relaxing.LAWS
        relaxing.LAWS = tuple(law if own.name == law.name else own for own in before)
        try:
            return certificate.certify(true.profile, entries, suffix).reason
        finally:
            relaxing.LAWS = before

    return claim


def negative_law() -> Claim:
    """A material with a negative modulus: its radius under a load is not real."""
    sign = nt.alpha - 1
    law = replace(POWER_CREEP, relaxation=sign * POWER_CREEP.relaxation, creep=POWER_CREEP.creep / sign)
    return with_law(law)


def imaginary_radius() -> Claim:
    """The same with a sign that is seen at once."""
    return with_law(replace(MAXWELL, relaxation=-MAXWELL.relaxation, creep=-MAXWELL.creep))


def rushing_ramp() -> Claim:
    """The force is no power of the depth; its exponent names d, which the face allows as one of its parameters."""
    true = derived("cone.vis")["ramp_kv"]
    face = derived("concave_paraboloid")["F"]
    profile = replace(face.profile, parameters=(*face.profile.parameters, d))
    elastic = face.cases[0].expr
    exponent = sp.cancel(d * sp.diff(elastic, d) / elastic)
    factor = VOIGT.ramp.subs(relaxing.POWER, exponent) / E_star
    entry = replace(
        true,
        key=true.key.replace("cone", profile.name),
        profile=profile,
        parameters=(*profile.parameters, nt.v, *VOIGT.parameters),
        cases=(Case((), elastic.subs(d, nt.v * time) * factor),),
    )
    return certified(profile, {"ramp_kv": entry}, "ramp_kv")


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


def square_of_a_sum() -> Claim:
    """(sum of A[j] t[j]/j)^2 in place of the sum of A[j] t[j]."""
    return formula(
        "polynomial", "F", lambda expr: expr.replace(sp.Sum, lambda term, over: sp.Sum(term / nt.j, over) ** 2)
    )


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


def infinite_at_the_edge() -> Claim:
    """A constant that seems to vanish at the edge: B(z; p, -1/2) is infinite at z = 1."""
    z, p = r**2 / a**2, sp.Rational(1, 3)
    function = IncompleteBeta(z, p, -HALF) + (2 * p - 1) * IncompleteBeta(z, p, HALF)
    constant = sp.sqrt(1 - z) * function - 2 * z**p + 2
    return plus("paraboloid", "p", E_star * constant)


def end_below_a_break() -> Claim:
    """a b vanishes as a tends to 0, but a is above b."""
    domain = Domain((b, a))
    return shown(
        lambda: statement.require_zero(identity.at(a * b, a, sp.S.Zero), domain.at(a, sp.S.Zero), "a b -> 0 at the end")
    )


def graded_limit(suffix: str, **fields: Any) -> Claim:
    profile = derived("paraboloid")["F"].profile
    kind = "adh" if suffix in ("Fc",) else ""
    plain, soft = (derived(".".join(filter(None, (profile.name, group, kind)))) for group in ("", "fgm"))
    found = {**soft, suffix: replace(soft[suffix], **fields)}
    normal = certificate.homogeneous_statements(profile)
    return shown(lambda: graded.homogeneous_limit(suffix, found, plain, normal))


def pull_off_twice() -> Claim:
    """The graded force at pull-off with a second formula."""
    entry = derived("paraboloid.fgm.adh")["Fc"]
    return graded_limit("Fc", cases=(*entry.cases, Case((a_c, b), 2 * entry.cases[0].expr)))


def force_without_its_depth() -> Claim:
    true = derived("rounded_cone")
    entries = {**true, "d": replace(true["d"], cases=true["d"].cases[:1])}
    return certified(true["d"].profile, entries, "F")


def unfounded_force() -> Claim:
    """Depth and force of another paraboloid: the force is right for the depth."""
    true = derived("paraboloid")
    entries = {
        suffix: replace(true[suffix], cases=tuple(replace(case, expr=2 * case.expr) for case in true[suffix].cases))
        for suffix in ("d", "F")
    }
    return certified(true["d"].profile, {**true, **entries}, "F")


NEEDED: dict[str, tuple[Callable[[], Claim], str]] = {
    # what an entry says beside its formulas
    "certificate.Prover._attempt: self.frames[suffix].require(self.entries[suffix])": (
        lambda: stated("paraboloid", "F", key="sphere.F"),
        "sphere.F is not force",
    ),
    "frame.Frame.require: ... is not ... of ...": (
        lambda: stated("paraboloid", "F", key="sphere.F"),
        "sphere.F is not force",
    ),
    "frame.Frame.require: the formulas of ... are not ...": (
        lambda: stated("flat_punch.adh", "Dl", status="root"),
        "are not root",
    ),
    "frame.Frame.require: ... is defined as ..., not as ...": (
        lambda: stated("paraboloid", "F", definition=sp.Eq(F, 0)),
        "is defined as",
    ),
    "frame.Frame.require: ... is no composition of ...": (
        lambda: stated("paraboloid", "F", composed=("p", "w")),
        "is no composition of",
    ),
    "frame.Frame.require: ... is not the contact of the unbounded profile before the e": (
        lambda: stated("paraboloid", "F", partial=derived("sphere")["F"]),
        "unbounded profile",
    ),
    "frame.Frame.require: the parameters of ... are not ...": (
        lambda: stated("paraboloid", "F", parameters=(R, b, E_star)),
        "the parameters of",
    ),
    "frame.Frame.require: self._require_symbols(entry)": (
        lambda: set_to("paraboloid", "ad", a),
        "a is neither argument nor parameter",
    ),
    "frame.Frame._require_symbols: ... holds a rounded number": (
        # 1 + 10^-20, rounded
        lambda: formula("paraboloid.adh", "d", lambda expr: expr - a**2 / R + sp.Float(1 + 10**-20) * a**2 / R),
        "holds a rounded number",
    ),
    "frame.Frame._require_symbols: ... is neither argument nor parameter of ...": (
        lambda: set_to("paraboloid", "ad", a),
        "a is neither argument nor parameter",
    ),
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
    "rings.greatest_pressure: require_regions(entry, (ring.chain,))": (
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
    # adhesive contact
    "statement.retraction: require_regions(own.entries['Dl'], ((a,),))": (
        lambda: regions("paraboloid.adh", "Dl", (a, R)),
        ONCE,
    ),
    "statement.retraction: the retraction is not shown to be positive": (
        lambda: times("paraboloid.adh", "Dl", -1),
        "is not shown to be positive",
    ),
    "adhesive.Adhesive.stable_radius: require_regions(closed(self.entries[suffix]), ((),))": (
        lambda: regions("paraboloid.adh", "aF", (F, R)),
        ONCE,
    ),
    "adhesive.Adhesive.stable_radius: ... is not shown to be the stable branch": (
        unstable_radius,
        "is not shown to be the stable branch",
    ),
    "adhesive.Adhesive.radius: require_regions(entry, ((),))": (
        lambda: regions("paraboloid.adh", "ac", (a_c, R)),
        ONCE,
    ),
    "adhesive.Adhesive.radius: require_regions(entry, tuple(own))": (lambda: only("rounded_cone.adh", "ac", 0), ONCE),
    "adhesive.Adhesive.radius: require_analytic(sides.lhs, domain)": (
        lambda: formula(
            "truncated_paraboloid.adh", "ac", lambda equal: equal.func(*(side + R / (a_c - R) for side in equal.args))
        ),
        "is not shown to be positive",
    ),
    "adhesive.Adhesive._closed_radius: the ... is not shown to have a minimum": (
        lambda: hollow("ac", lambda expr: expr.subs(R, -HOLLOW)),
        "is not shown to have a minimum",
    ),
    "adhesive.Adhesive._closed_radius: ... is not shown to be positive": (
        lambda: set_to("paraboloid.adh", "ac", sp.S.Zero),
        "0 is not shown to be positive",
    ),
    "adhesive.Adhesive.at_pull_off: the cases of ... are not the regimes of the contact": (
        lambda: regions("truncated_paraboloid.adh", "Fc", (a_c, b)),
        "are not the regimes of the contact",
    ),
    "detachment.Detachment._expr: require_regions(self.entries[suffix], ((a,),))": (
        lambda: regions("flat_punch.adh", "dc", (a, R)),
        ONCE,
    ),
    "detachment.Detachment.depth: the depth of a smaller contact is not shown to be greater": (
        convex_edge,
        "the depth of a smaller contact is not shown to be greater",
    ),
    # tangential contact
    "superposed.Superposed.show: require_regions(entry, tuple(wanted))": (
        lambda: only("rounded_cone.tan", "F", 0),
        ONCE,
    ),
    # viscoelastic contact
    "viscoelastic.terms: ... is not c t^p exp(-q t)": (law_with_a_changing_rate, r"is not c t\^p exp\(-q t\)"),
    "viscoelastic.transform: t^(...) has no Laplace transform": (
        law_too_steep_at_the_start,
        "has no Laplace transform",
    ),
    "viscoelastic.Viscoelastic._case: require_regions(self.entries[suffix], (chain,))": (
        lambda: regions("cone.vis", "ramp_mx", (time, nt.relaxation)),
        ONCE,
    ),
    "viscoelastic.Viscoelastic._of_power: ... is not shown to be a power of d": (
        rushing_ramp,
        "is not shown to be a power of d",
    ),
    "viscoelastic.Viscoelastic.load: require_analytic(wanted, self.domain(case))": (
        negative_law,
        "is not shown to be positive",
    ),
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
    # statements
    "statement.require_regions: the cases of ... do not cover its regions once": (
        lambda: only("rounded_cone", "F", 0),
        ONCE,
    ),
    "statement.require_zero: require_analytic(part, domain)": (
        lambda: times("paraboloid", "k", hole(a)),
        "is not shown to be positive",
    ),
    "statement.require_zero: ... does not hold": (lambda: times("paraboloid", "F", 2), "does not hold"),
    "statement.require_integral: the integral that defines ... is not shown to exist": (
        endless_integral,
        "is not shown to exist",
    ),
    "statement.require_integral: ... is not a combination of functions whose integrals are st": (
        lambda: stated(
            "sphere.fgm",
            "d",
            primitives={},
            cases=(replace(derived("sphere.fgm")["d"].cases[0], expr=derived("sphere.fgm")["d"].cases[0].expr + a),),
        ),
        "is not a combination of functions whose integrals are stated",
    ),
    "statement.summand: ... is not a multiple of one sum over j = 1 ... N of A[j]": (
        lambda: formula(
            "polynomial", "F", lambda expr: expr.replace(sp.Sum, lambda term, _: sp.Sum(term, (nt.j, 2, nt.N)))
        ),
        "is not a multiple of one sum",
    ),
    "statement.by_power: require_analytic(linear, domain)": (
        lambda: times("polynomial", "k", 1 + STEP.subs(U, derived("polynomial")["d"].cases[0].expr / a)),
        "the real range of Piecewise",
    ),
    "statement.paired: the cases of ... are not those of ...": (
        lambda: regions("rounded_cone.adh", "d", (b, a), (a, b)),
        "are not those of",
    ),
    "identity.analytic: require_analytic(expr, domain)": (
        lambda: shown(lambda: identity.is_zero(JUMP.subs(U, a / b), Domain((a,), (b,)))),
        "not shown",
    ),
    "identity.at: _require_finite(node.subs(symbol, value), node)": (infinite_at_the_edge, "is not shown to be finite"),
    "identity._require_finite: ... is not shown to be finite as ... tends to ...": (
        infinite_at_the_edge,
        "is not shown to be finite",
    ),
    "functions.require_analytic: ... is no formula of real numbers": (
        imaginary_radius,
        "is no formula of real numbers",
    ),
    "functions.require_analytic: ... is not shown to be positive": (
        lambda: plus("paraboloid", "F", E_star * R**2 * JUMP.subs(U, a / R)),
        "is not shown to be positive",
    ),
    "functions.require_analytic: _require_range(node, domain)": (
        lambda: times("paraboloid", "F", ARCS.subs(U, a / R)),
        "needed for",
    ),
    "functions._require_range: ... > 0, needed for ..., is not shown": (
        lambda: times("paraboloid", "F", ARCS.subs(U, a / R)),
        "needed for",
    ),
    "tower.Tower._single_power: the radicand ... is not shown to be positive": (root_of_a_square, "the radicand"),
    "tower.Tower._absolute: the sign of ... is not known": (face_with_an_absolute_value, "the sign of"),
    "domain.Domain.at: ... cannot tend to 0 above ...": (end_below_a_break, "a cannot tend to 0 above b"),
    "graded.homogeneous_limit: ... is ..., ... is ...: no pair of formulas or equations": (
        lambda: graded_limit("F", status="root"),
        "no pair of formulas or equations",
    ),
    "graded._counterpart: no case of the graded half-space is that of ...": (
        pull_off_twice,
        "no case of the graded half-space",
    ),
}
"""The false entry that only this refusal refuses, and what it says."""


WORDING: dict[str, tuple[Callable[[], Claim], str]] = {
    "compact.Compact.depth_of: no ... is given for ...": (force_without_its_depth, "no d is given for b < a"),
    "functions.margins: the real range of ... is not known": (
        lambda: plus("paraboloid", "F", E_star * R**2 * STEP.subs(U, a / R)),
        "the real range of Piecewise",
    ),
    "materials.Materials.factor: h_N is compared with a solution of the equations of equilibr": (
        lambda: times("materials", "h_N", 2),
        "h_N is compared with a solution",
    ),
    "tower.Tower.power: a power with exponent ... of a sum of radicals cannot be tak": (
        lambda: times("paraboloid", "k", (1 + sp.sqrt(a / R)) ** sp.Rational(1, 3)),
        "with exponent 1/3 of a sum",
    ),
    "tower.Tower._inverse: ... cannot be inverted exactly": (
        lambda: times("paraboloid", "k", 1 / (1 + (a / R) ** sp.Rational(1, 3))),
        "cannot be inverted exactly",
    ),
    "tower.Tower._denested_root: the root of ... does not denest, or its sign is not known": (
        lambda: times("paraboloid", "k", sp.sqrt(1 + sp.sqrt(a / R))),
        "does not denest",
    ),
    "tower.Tower.convert: ... is not an algebraic expression in lengths and functions": (
        lambda: shown(lambda: identity.is_zero(sp.I * a, Domain((a,)))),
        "is not an algebraic expression",
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
    "statement.closed: ... is ...": (
        lambda: stated(
            "paraboloid",
            "F",
            status="root",
            cases=(Case((a,), sp.Eq(derived("paraboloid")["F"].cases[0].expr, E_star * a * R)),),
        ),
        "is the root of an equation",
    ),
    "identity._log_of_sum: ... is not shown to be positive": (
        lambda: plus("sphere", "F", E_star * R * a * sp.log((a - R) * (a - 2 * R) / R**2)),
        "is not shown to be positive",
    ),
    "tower.Tower.power: division by zero, or a root of zero": (
        lambda: times("paraboloid", "F", sp.sqrt(1 + 1 / ((a + R) ** 2 - a**2 - 2 * a * R - R**2))),
        "division by zero",
    ),
    "tower.Tower.primitive: the factors of ... are not shown to be positive": (
        lambda: plus("paraboloid", "F", E_star * (a - R) ** 2 * sp.log((a**3 + R**3) * (1 + sp.sqrt(a / R)))),
        "the factors of",
    ),
    "domain.Domain._largest_lower_bound: ... would be less than itself": (
        lambda: shown(lambda: functions.sign(a - b, Domain((a, b), (b, a)))),
        "would be less than itself",
    ),
    "domain.Domain._largest_lower_bound: the order of the lower bounds ... of ... is not known": (
        lambda: shown(lambda: functions.sign(b - r, Domain((r, a), (b, a)))),
        "the order of the lower bounds",
    ),
}
"""Refusals that give a better reason than the one that would come after; the entry stays refused."""


EFFORT = {
    "tower.Tower._repeated: a power with exponent ... is not expanded": "the exact power takes long",
    "tower.Tower.mul: the expressions of the proof grow beyond all bounds": "the exact product takes long",
    "tower.Tower.factors: a polynomial with ... terms is not factored": "the exact factors take long",
}
"""Refusals that only bound the time of a proof, and what they spare."""


BUILT = {
    "loads._by_antiderivative: require_zero(sp.diff(factor * total, t) - wanted, domain)": (
        "sp.Rational(2 * i - 1, 2 * i)",
        "sp.Rational(1, 3 * i)",
        "d/dt of the antiderivative",
    ),
}
"""Refusals of what the prover itself builds: a misprint in it, by which a true entry is refused."""


Altered = tuple[str, str, str, str, Callable[[], Claim], str]
ALTERED: dict[str, Altered] = {
    "what a formula rests on": (
        "certificate",
        "Prover._attempt",
        "map(self.certify, needed)",
        "()",
        unfounded_force,
        "rests on paraboloid.d",
    ),
    "the value at an end": (
        "compact",
        "Compact._integral",
        "steps.append(self._end_value(entry, case, expr))",
        "pass",
        lambda: plus("paraboloid", "F", E_star * R**2),
        "F -> 0 as a -> 0 does not hold",
    ),
    "the end of an identity": (
        "identity",
        "is_zero",
        "if _zero_at_an_end(quotient, variable, domain, depth - 1):",
        "if True:",
        lambda: times("paraboloid", "k", 1 + sp.atan(a / R) + sp.atan(R / a) - sp.pi / 3),
        "does not hold",
    ),
    "the derivative of an identity": (
        "identity",
        "is_zero",
        "if not is_zero(sp.diff(quotient, variable), domain, depth - 1):",
        "if False:",
        lambda: times("paraboloid", "k", 1 + sp.atan(a / R)),
        "does not hold",
    ),
    "the range of an unknown function": (
        "functions",
        "margins",
        "raise NotProvedError(message)",
        "return ()",
        lambda: plus("paraboloid", "F", E_star * R**2 * Leap(a / R)),
        "the real range of Leap",
    ),
    "the range of a positive function": (
        "functions",
        "positive",
        "all(sign(margin, domain) > 0 for margin in margins(function))",
        "True",
        lambda: shown(lambda: functions.sign(sp.acosh(a / b), Domain((a,), (b,))) > 0),
        "not shown",
    ),
    "the argument of an odd function": (
        "functions",
        "positive",
        "(isinstance(function, POSITIVE) or sign(function.args[0], domain) > 0)",
        "True",
        lambda: shown(lambda: functions.sign(sp.atan(a - b), Domain((a,), (b,))) > 0),
        "not shown",
    ),
    "symbols that may be negative": (
        "tower",
        "Tower.polynomial_sign",
        "all(s.is_positive for s in plain)",
        "True",
        lambda: shown(lambda: functions.sign(1 + nt.nu, Domain((a,))) > 0),
        "not shown",
    ),
    "the sign of a denested root": (
        "tower",
        "Tower._denested_root",
        "and self.sign(root) > 0",
        "",
        lambda: shown(
            lambda: identity.is_zero(sp.sqrt(a + b - 2 * sp.sqrt(a * b)) - sp.sqrt(a) + sp.sqrt(b), Domain((a,), (b,)))
        ),
        "does not denest, or its sign is not known",
    ),
    "antiderivatives from breaks": (
        "compact",
        "Compact._increment",
        "(primitive.lo, primitive.hi) not in itertools.combinations(ends, 2)",
        "primitive.hi not in ends",
        antiderivative_from_beyond_the_contact,
        "does not end at breaks of the profile",
    ),
    "the retraction of the least force": (
        "adhesive",
        "Adhesive._closed_radius",
        "sign(level, domain) > 0 and ",
        "",
        lambda: hollow("ac", lambda expr: expr.subs(R, -HOLLOW)),
        "is not shown to have a minimum",
    ),
    "the least force": (
        "adhesive",
        "Adhesive._closed_radius",
        " and sign(rise, domain) > 0",
        "",
        sharp_tip,
        "is not shown to have a minimum",
    ),
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
    "a region once": (
        "statement",
        "require_regions",
        "len(found) != len(wanted) or ",
        "",
        lambda: beside("flat_punch.adh", "Dl", Case((a,), sp.sqrt(a * dgamma / E_star))),
        ONCE,
    ),
    "a multiple of a sum": (
        "statement",
        "summand",
        "factor.has(j) or ",
        "",
        square_of_a_sum,
        "is not a multiple of one sum",
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
"""Conclusions of the same weight that are no refusals: a text of the prover, and what it would be without."""


@functools.cache
def known() -> dict[str, guards.Guard]:
    return {guard.name: guard for guard in guards.found()}


def test_every_guard_has_a_false_entry() -> None:
    tables = [*NEEDED, *WORDING, *EFFORT, *BUILT]
    names = [guard.name for guard in guards.found()]
    assert len(names) == len(set(names))
    assert sorted(tables) == sorted(names)


@pytest.mark.parametrize("name", NEEDED)
def test_the_false_entry_is_certified_without_its_guard(name: str) -> None:
    build, message = NEEDED[name]
    claim = build()
    assert re.search(message, claim())
    with guards.without(known()[name]):
        assert claim() == ""


@pytest.mark.parametrize("name", WORDING)
def test_the_false_entry_is_refused_for_another_reason_without_its_guard(name: str) -> None:
    build, message = WORDING[name]
    claim = build()
    assert re.search(message, claim())
    with guards.without(known()[name]):
        other = claim()
    assert other
    assert not re.search(message, other)


@pytest.mark.parametrize("name", ALTERED)
def test_the_false_entry_is_certified_by_the_altered_prover(name: str) -> None:
    module, function, old, new, build, message = ALTERED[name]
    claim = build()
    assert re.search(message, claim())
    with guards.altered(module, function, old, new):
        assert claim() == ""


@pytest.mark.parametrize("name", BUILT)
def test_a_misprint_in_the_prover_is_refused(name: str) -> None:
    old, new, message = BUILT[name]
    guard = known()[name]
    claim = stated("loads.hertzian", "w")
    assert claim() == ""
    with guards.altered(guard.module, guard.function, old, new):
        assert re.search(message, claim())
