"""What the prover must refuse of what rests on normal contact: adhesive, tangential and viscoelastic."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from axiderive import notation as nt
from axiderive.entry import Case
from axiderive.notation import E_star, F, R, a, a_c, b, d, dgamma, n, r, time
from axiderive.physics import viscoelastic
from axiderive.profiles.profile import Piece, Rule
from axiderive.proof import certificate
from axiderive.proof.rules import viscoelastic as relaxing

from .claims import (
    HALF,
    ONCE,
    Altered,
    Change,
    Claim,
    Refusals,
    certified,
    derived,
    formula,
    only,
    regions,
    set_to,
    shown,
    stated,
    times,
)

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


def ramp_without_fading() -> Claim:
    """The force of a ramp on a fluid, as if all of the depth had come at the present rate of its relaxation."""
    cases = derived("sphere")["F"].cases
    faded = tuple(replace(case, expr=case.expr.subs(E_star, MAXWELL.relaxation)) for case in cases)
    return stated("sphere.vis", "ramp_mx", status="closed", cases=faded)


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


NEEDED: Refusals = {
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
    "adhesive.Detachment._expr: require_regions(self.entries[suffix], ((a,),))": (
        lambda: regions("flat_punch.adh", "dc", (a, R)),
        ONCE,
    ),
    "adhesive.Detachment.depth: the depth of a smaller contact is not shown to be greater": (
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
    "viscoelastic.Viscoelastic.radius: require_regions(entry, tuple((_in_time(case.chain) for case": (
        lambda: regions("truncated_paraboloid.vis", "radius_mx", (nt.t_1, nt.relaxation)),
        ONCE,
    ),
    "viscoelastic.Viscoelastic._of_springs: ... fades": (ramp_without_fading, "fades"),
    "viscoelastic.Viscoelastic._of_power: ... is not shown to be a power of d": (
        rushing_ramp,
        "is not shown to be a power of d",
    ),
    "viscoelastic.Viscoelastic.load: require_analytic(wanted, self.domain(case))": (
        negative_law,
        "is not shown to be positive",
    ),
}


ALTERED: dict[str, Altered] = {
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
}
