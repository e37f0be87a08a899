"""What the prover must refuse of any entry: its words, its statements, its identities and its signs."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from axiderive import notation as nt
from axiderive.abel.masters import Hypergeometric, IncompleteBeta
from axiderive.entry import Case
from axiderive.notation import E_star, F, R, a, a_c, b, dgamma, r
from axiderive.profiles.profile import Piece
from axiderive.proof import certificate, statement
from axiderive.proof.algebra import functions, identity
from axiderive.proof.algebra.domain import Domain
from axiderive.proof.rules import graded

from .claims import (
    ARCS,
    HALF,
    JUMP,
    ONCE,
    STEP,
    Altered,
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
    set_to,
    shown,
    stated,
    times,
)
from .compact import depth_of
from .superposed import imaginary_radius


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


def square_of_a_sum() -> Claim:
    """(sum of A[j] t[j]/j)^2 in place of the sum of A[j] t[j]."""
    return formula(
        "polynomial", "F", lambda expr: expr.replace(sp.Sum, lambda term, over: sp.Sum(term / nt.j, over) ** 2)
    )


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


def unfounded_force() -> Claim:
    """Depth and force of another paraboloid: the force is right for the depth."""
    true = derived("paraboloid")
    entries = {
        suffix: replace(true[suffix], cases=tuple(replace(case, expr=2 * case.expr) for case in true[suffix].cases))
        for suffix in ("d", "F")
    }
    return certified(true["d"].profile, {**true, **entries}, "F")


NEEDED: Refusals = {
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


WORDING: Refusals = {
    "functions.margins: the real range of ... is not known": (
        lambda: plus("paraboloid", "F", E_star * R**2 * STEP.subs(U, a / R)),
        "the real range of Piecewise",
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


ALTERED: dict[str, Altered] = {
    "what a formula rests on": (
        "certificate",
        "Prover._attempt",
        "map(self.certify, needed)",
        "()",
        unfounded_force,
        "rests on paraboloid.d",
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
}
