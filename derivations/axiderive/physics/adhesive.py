"""Adhesive contact by the rule of Hess: the contact without adhesion plus a retraction of its flat punch.

Every quantity is that of the normal contact minus the punch of radius a moved
by Delta l(a) = sqrt(2 pi a dgamma / c_N(a)), (11.31), (11.64); c_N(a) =
modulus * a**k.  Pull-off is where the force or the depth is stationary:
both conditions read a**((1 + k)/2) g'(a) = xi/2 sqrt(2 pi dgamma/modulus), with
xi = 3 + k under force control and 1 - k under depth control.

Under a face with a fixed edge the contact holds until its edge peels off; till
then the solution is that of the contact without adhesion, in tension too.  The
edge term of the pressure, modulus * w1D(a) * (a^2 - r^2)^((k-1)/2)/pi, is that of
a flat punch moved by w1D(a) = d - g(a); the edge peels where it reaches the
retraction of Hess, w1D(a) = -Dl(a) (Kendall 1971 for the flat punch).  Under a
flat or concave face g and -Dl fall with the radius, so that a smaller contact
needs a greater depth and a greater force: what begins at the edge runs through,
under force control and depth control alike.  Under a convex face it does not: the
contact goes on as that of the unbounded profile, whose radius it reaches or
leaves at the edge.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..entry import COMPACT, FOUR, Case, Entry, Quantity, Status
from ..notation import F, a, a_c, d, dgamma, n, p, r, retraction, w
from ..profiles import profile as bodies
from ..profiles.profile import Profile
from . import Physics, Printing, Rule, Wording, complete, normal
from .medium import GRADED, HOMOGENEOUS, Medium
from .normal import stable_inverse

GROUP = "adh"
REFERENCES = ("(11.31)",), ("(11.64)", "(11.66)")
"""Of the homogeneous and of the graded half-space."""

QUANTITIES = {
    q.suffix: q
    for q in (
        Quantity("Dl", "retraction", "Retraction", retraction, (a,),
                 summary="Retraction of the indenter from the state without adhesion, at constant contact radius."),
        Quantity("d", "depth", "Indentation depth", d, (a,), written=r"d_{\mathrm{adh}}(a)",
                 summary="Indentation depth at contact radius a; negative where adhesion pulls the surface up."),
        Quantity("F", "force", "Normal force", F, (a,), written=r"F_{\mathrm{adh}}(a)",
                 summary="Normal force at contact radius a, negative in tension."),
        Quantity("p", "pressure", "Pressure", p, (r, a), written=r"p_{\mathrm{adh}}(r)", place="inside",
                 summary="Contact pressure, positive in compression, infinite tension at the edge;"
                 " zero outside the contact."),
        Quantity("w", "displacement", "Displacement outside", w, (r, a), written=r"w_{\mathrm{adh}}(r)",
                 place="outside", row="Displacement", summary=COMPACT["w"].summary),
        Quantity("ad", "radius_from_depth", "Contact radius from depth, stable branch", a, (d,), inverts="d",
                 row="Contact radius from depth",
                 summary="Contact radius at indentation depth d, on the branch that is stable under a given depth."),
        Quantity("aF", "radius_from_force", "Contact radius from force, stable branch", a, (F,), inverts="F",
                 row="Contact radius from force",
                 summary="Contact radius under the normal force F, on the branch that is stable under a given force."),
    )
}  # fmt: skip
CONTROLS = {"force": ("ac", "Fc", "dc"), "depth": ("am", "Fm", "dm")}
"""Radius, force and depth at pull-off, by what is given meanwhile."""
QUANTITIES |= {
    suffix: Quantity(
        suffix, "pull_off", f"Pull-off under {control} control: {name}", symbol, (), control=control,
        written=rf"{suffix[0]}_{{\mathrm {suffix[1]}}}", row=f"Pull-off {name}: {control} control",
    )
    for control, suffixes in CONTROLS.items()
    for suffix, name, symbol in zip(suffixes, ("radius", "force", "depth"), (a_c, F, d), strict=True)
}  # fmt: skip
PEELING = {
    q.suffix: q
    for q in (
        Quantity("Dl", "retraction", "Retraction", retraction, (),
                 summary="Retraction of the edge at which it peels off."),
        Quantity("Fc", "pull_off", "Pull-off force", F, (), control="force",
                 written=r"F_{\mathrm c}", row="Pull-off force: force control"),
        Quantity("dc", "pull_off", "Pull-off depth", d, (), control="force",
                 written=r"d_{\mathrm c}", row="Pull-off depth: force control"),
    )
}  # fmt: skip


def pull_off_number(medium: Medium) -> dict[str, sp.Expr]:
    """The number xi of the condition of stationarity, under force and under depth control."""
    return {"force": 3 + medium.k, "depth": 1 - medium.k}


FORCE, TENSION = sp.Symbol("F_N", positive=True), sp.Symbol("abs(F)", positive=True)
"""Force without adhesion at the same radius, and that of pull-off, which is a tension."""


def separation(medium: Medium) -> sp.Expr:
    """The work of separation of a contact of radius a under a tension: F_N + abs(F) is what the retraction takes away.

    For each force that of pull-off is the least over a: a greater work of separation gives every radius a force that is
    less, so that the first force of all to be reached is the least of all radii.
    """
    taken = medium.stiffness() * medium.retraction()
    return sp.powsimp(dgamma * (FORCE + TENSION) ** 2 / sp.powdenest(sp.expand_power_base(taken**2), force=True))


def lasting_share(order: sp.Expr, medium: Medium) -> sp.Expr:
    """F_N over the tension at pull-off where F_N goes with this power of a: where d log F_N/d log a balances."""
    xi = pull_off_number(medium)["force"]
    return xi / (2 * order - xi)


def order_of(force: Entry) -> sp.Expr | None:
    """The exponent of a force that is one power of a; else None."""
    first, *others = (case.expr for case in force.cases)
    base, order = first.as_independent(a, as_Add=False)[1].as_base_exp()
    return None if others or base != a else order


def work_from_pull_off(force: Entry, medium: Medium) -> sp.Expr | None:
    """The work of separation whose pull-off is under that tension, where the force is one power of a; else None."""
    order = order_of(force)
    if order is None:
        return None
    at = lasting_share(order, medium) * TENSION
    radius = (at / force.cases[0].expr.subs(a, 1)) ** (1 / order)
    work = separation(medium).subs(FORCE + TENSION, sp.factor(at + TENSION)).subs(a, radius)
    return sp.powsimp(sp.powdenest(work, force=True), force=True)


def work_of_peeling(entries: Mapping[str, Entry]) -> sp.Expr:
    """The work of separation at which an edge peels off under a tension."""
    (case,) = entries["Fc"].cases
    still = case.expr.subs(dgamma, 0)
    return sp.factor((TENSION + still) ** 2 * dgamma / sp.expand((case.expr - still) ** 2))


def pull_off_rule(profile: Profile, medium: Medium = HOMOGENEOUS) -> bodies.Rule | None:
    """What the exponent of a power law must be for a stable contact to exist; None where none is a parameter.

    At n = (1 - k)/2 the depth is one power of the radius, and below it both loads grow on unloading.
    """
    if n not in profile.parameters:
        return None
    reason = (
        "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; "
        f"use n > {_least_exponent(medium)}, or force(a) and depth(a) for the states of equilibrium"
    )
    return bodies.Rule((1 - medium.k) / 2, n, True, reason)


def _least_exponent(medium: Medium) -> str:
    return sp.sstr(sp.together((1 - medium.k) / 2))


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """All adhesive entries of a profile with a compact contact, keyed by suffix.

    They rest on the normal contact `plain` where it is known already.

    Raises
    ------
    ValueError
        If the contact is complete: its edge is fixed, and only the pull-off depth is a question.
    """
    if not profile.compact:
        message = f"{profile.name} is a complete contact: its edge is fixed, and only the retraction Dl is a question"
        raise ValueError(message)
    plain = plain or normal.derive(profile, medium)
    punch = {
        "d": sp.S.One,
        "F": medium.stiffness(),
        "p": medium.punch_pressure(),
        "w": medium.punch_displacement().expr(),
    }
    shift = medium.retraction()
    build = _Builder(profile, medium, plain)
    balance = sp.Eq(2 * sp.pi * a * dgamma, medium.modulus * a**medium.k * retraction**2)
    entries = {"Dl": build.entry("Dl", "closed", (Case((a,), shift),), balance)}
    for suffix, unit in punch.items():
        own = plain[suffix]
        cases = tuple(Case(case.chain, _minus(case.expr, unit * shift)) for case in own.cases)
        entries[suffix] = build.entry(suffix, own.status, cases, own.definition - unit * retraction)
    return entries | build.branches(entries) | build.pull_off()


def _minus(expr: sp.Expr, loss: sp.Expr) -> sp.Expr:
    return expr - sp.powsimp(sp.expand_power_base(loss), combine="exp")


class _Builder:
    """Entries of one profile on one medium."""

    def __init__(self, profile: Profile, medium: Medium, plain: Mapping[str, Entry]) -> None:
        self.profile, self.medium, self.plain = profile, medium, plain

    def entry(self, suffix: str, status: Status, cases: tuple[Case, ...], definition: sp.Expr) -> Entry:
        """The entry of a suffix with its key, quantity, parameters, references and note filled in."""
        parameters = (() if suffix == "Dl" else self.profile.parameters) + (*self.medium.moduli, dgamma)
        references = REFERENCES[self.medium.graded]
        return self.medium.entry(
            self.profile, GROUP, QUANTITIES[suffix], status, cases, definition, parameters, references,
            note=self._note(suffix),
        )  # fmt: skip

    def _note(self, suffix: str) -> str:
        quantity = QUANTITIES[suffix]
        if not (quantity.inverts or quantity.control) or pull_off_rule(self.profile, self.medium) is None:
            return ""
        return f"exists only for n > {_least_exponent(self.medium)}"

    def branches(self, entries: dict[str, Entry]) -> dict[str, Entry]:
        """Inverses on the branch that is stable under control of the given quantity, a >= its pull-off radius."""
        out = {}
        for quantity in (q for q in QUANTITIES.values() if q.inverts):
            suffix, source, (value,) = quantity.suffix, quantity.inverts, quantity.arguments
            forward, equation = entries[source].cases, sp.Eq(value, entries[source].definition)
            closed = stable_inverse(forward[0].expr, value) if len(forward) == 1 else None
            if closed is not None:
                out[suffix] = self.entry(suffix, "closed", (Case((), closed),), equation)
            else:
                cases = tuple(Case(case.chain, sp.Eq(case.expr, value)) for case in forward)
                out[suffix] = self.entry(suffix, "root", cases, equation)
        return out

    def pull_off(self) -> dict[str, Entry]:
        """Radius, force and depth; at pull-off the retraction is 2 a g'(a)/xi, which leaves no root in F and d."""
        out = {}
        slopes = tuple(Case(case.chain, sp.diff(case.expr, a)) for case in self.plain["d"].cases)
        for control, (radius_name, force_name, depth_name) in CONTROLS.items():
            xi = pull_off_number(self.medium)[control]
            level = xi * sp.sqrt(sp.pi * dgamma / (2 * self.medium.modulus)) * a ** (-(1 + self.medium.k) / 2)
            condition = sp.Eq(sp.Derivative(sp.Function("g")(a), a), level)
            radius = _monomial_root(slopes[0].expr, level) if len(slopes) == 1 else None
            if radius is None:
                roots = tuple(Case(_moved(case.chain), sp.Eq(case.expr, level).subs(a, a_c)) for case in slopes)
                out[radius_name] = self.entry(radius_name, "root", roots, condition)
            else:
                out[radius_name] = self.entry(radius_name, "closed", (Case((), radius),), condition)
            for name, source, unit in ((force_name, "F", self.medium.stiffness()), (depth_name, "d", sp.S.One)):
                cases = tuple(
                    self._at_pull_off(case, slope.expr, unit / xi, radius)
                    for case, slope in zip(self.plain[source].cases, slopes, strict=True)
                )
                out[name] = self.entry(name, self.plain[source].status, cases, condition)
        return out

    def _at_pull_off(self, case: Case, slope: sp.Expr, unit: sp.Expr, radius: sp.Expr | None) -> Case:
        expr = case.expr - sp.powsimp(2 * a * slope * unit)
        if radius is None:
            return Case(_moved(case.chain), expr.subs(a, a_c))
        expr = sp.powsimp(sp.factor_terms(sp.powsimp(expr)))
        if not (expr.has(n) or self.medium.k != 0 or expr.has(sp.gamma)):
            return Case(
                (), sp.powsimp(sp.powdenest(sp.expand_power_base(expr.subs(a, radius), force=True), force=True))
            )
        return Case(_moved(case.chain), sp.factor_terms(sp.factor(expr)).subs(a, a_c))


def _moved(chain: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    return tuple(length.subs(a, a_c) for length in chain)


def _monomial_root(slope: sp.Expr, level: sp.Expr) -> sp.Expr | None:
    """The root of slope = level when both are powers of a."""
    factor, power = sp.powsimp(slope / level).as_independent(a, as_Add=False)
    base, exponent = power.as_base_exp()
    if base != a or exponent.has(a):
        return None
    return sp.powdenest(factor ** (-1 / exponent), force=True)


CONVEX = (
    "{name} is the adhesive paraboloid until the contact reaches the edge; from that depth on the edge holds, the force"
    " grows with the stiffness of the flat punch, and on unloading the edge comes loose at the same depth: use"
    " {package}.paraboloid for radii below a; its depth and force at the radius a are those at which the edge comes"
    " loose, and where its pull_off has a larger radius the contact ends there"
)
"""Why a convex face has no entries of its own; the paraboloid is the only one of the catalogue."""


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no adhesive entries; empty if it has."""
    (*_, face) = profile.pieces
    if profile.compact or face.expr == 0 or face.expr.has(a):
        return ""
    return CONVEX.format(name=profile.name, package=medium.key("axicontact", medium.name, "adhesive"))


def detachment(profile: Profile, medium: Medium = HOMOGENEOUS) -> dict[str, Entry]:
    """Retraction at the edge, force and depth at which it peels off, keyed by suffix."""
    shift = medium.retraction()
    level = complete.edge_depth(profile, medium) - shift
    (force,) = complete.derive(profile, medium)["F"].cases
    w1D = sp.Function("w1D")
    balance = sp.Eq(2 * sp.pi * a * dgamma, medium.modulus * a**medium.k * retraction**2)
    return {
        "Dl": _at_edge(profile, medium, "Dl", shift, balance),
        "Fc": _at_edge(profile, medium, "Fc", _tidy(force.expr, level), sp.Eq(sp.Function("F")(w1D(a)), F)),
        "dc": _at_edge(profile, medium, "dc", level, sp.Eq(w1D(a), -retraction)),
    }


def _tidy(force: sp.Expr, level: sp.Expr) -> sp.Expr:
    """The force is linear in the depth: its constant part and its slope put together again."""
    slope = sp.diff(force, d)
    constant = sp.powsimp(sp.factor(sp.expand(force - slope * d) + sp.expand(slope * _without_root(level))))
    return constant + sp.powsimp(slope * (level - _without_root(level)))


def _without_root(level: sp.Expr) -> sp.Expr:
    return level.subs(dgamma, 0)


def _at_edge(profile: Profile, medium: Medium, suffix: str, expr: sp.Expr, definition: sp.Expr) -> Entry:
    parameters = ((a,) if suffix == "Dl" else profile.parameters) + (*medium.moduli, dgamma)
    cases, references = (Case((a,), expr),), REFERENCES[medium.graded]
    return medium.entry(profile, GROUP, PEELING[suffix], "closed", cases, definition, parameters, references)


def _derive(profile: Profile, medium: Medium, plain: Mapping[str, Entry] | None = None) -> dict[str, Entry]:
    """Of a contact that grows, or of one with a fixed edge."""
    return derive(profile, medium, plain) if profile.compact else detachment(profile, medium)


ADH = r"_{\mathrm{adh}}"


def rules(medium: Medium, printing: Printing) -> dict[str, Rule]:
    """The rules in print."""
    printer = printing((r, a))
    force = printer(medium.stiffness() * retraction)
    pressure = printer(medium.punch_pressure() * retraction)
    surface = printer(medium.punch_displacement().expr() * retraction)
    found = {
        "Dl": Rule(rf"\Delta\ell={printer(medium.retraction())}"),
        "d": Rule(rf"d{ADH}(a)=g(a)-\Delta\ell"),
        "F": Rule(rf"F{ADH}(a)=F_{{\mathrm N}}(a)-{force}"),
        "p": Rule(rf"p{ADH}(r)=p(r)-{pressure}", where="r<a"),
        "w": Rule(rf"w{ADH}(r)=w(r)-{surface}", where=r"r\ge a"),
        "ad": Rule(rf"d{ADH}(a)=d", r"for $a\ge a_{\mathrm m}$"),
        "aF": Rule(rf"F{ADH}(a)=F_{{\mathrm N}}", r"for $a\ge a_{\mathrm c}$"),
    }
    for control, xi in pull_off_number(medium).items():
        radius, force_then, depth_then = (QUANTITIES[suffix] for suffix in CONTROLS[control])
        level = sp.sqrt(sp.pi * dgamma / (2 * medium.modulus)) * a_c ** (-(1 + medium.k) / 2)
        at = radius.left
        named = printing((), {a_c: at})
        # the number stays in front of the root
        text = named(xi * level) if xi.free_symbols else (named(xi) if xi != 1 else "") + named(level)
        found |= {
            radius.suffix: Rule(f"g'({at})={text}"),
            force_then.suffix: Rule(f"{force_then.left}=F{ADH}({at})"),
            depth_then.suffix: Rule(f"{depth_then.left}=d{ADH}({at})"),
        }
    return found


FIELDS, PULLED = (("Dl", "d"), ("F",), ("p",), ("w",), ("ad", "aF")), (("Fc", "Fm"), ("dc", "dm"))
PHYSICS = Physics(
    "adhesive",
    {
        HOMOGENEOUS: Wording(
            place=2,
            title="Adhesive contact",
            note=r"Johnson--Kendall--Roberts limit, work of separation $\Delta\gamma$",
            package="Adhesive contact of a rigid indenter with an elastic half-space",
            searched="adhesion JKR Johnson Kendall Roberts Hess pull-off",
            button="adhesion",
            by_rule=("Dl", *FOUR),
            subject="truncated_paraboloid.adh",
            spread=(*FIELDS, ("ac", "am"), *PULLED),
        ),
        GRADED: Wording(
            place=5,
            title="Adhesive contact, graded half-space",
            note=r"$g$, $F_{\mathrm N}$, $p$, $w$ of the graded half-space",
            package="Adhesive contact of a rigid indenter with a power-law graded half-space",
            searched="FGM functionally graded gradient adhesion JKR pull-off",
            by_rule=("Dl", *FOUR),
            subject="paraboloid.fgm.adh",
            spread=(*FIELDS, ("ac",), ("am",), *PULLED),
        ),
    },
    _derive,
    group=GROUP,
    over=normal.PHYSICS,
    refusal=refusal,
    tension=True,
    material=(dgamma,),
    contact="with adhesion",
    shown={dgamma: "1/100"},
    runtime=("physics.adhesion", "physics.branches", "physics.stable", "physics.unknowns"),
    quantities={"adhesive": QUANTITIES, "detachment": PEELING},
    wanted=("depth", "force", "pressure", "displacement", "pull_off"),
    rules=rules,
    compared="mpmath quadrature of the contact that is short of its depth by Dl, (11.63)",
    noted=r"short-ranged (JKR); pull-off under given force at $a_{\mathrm c}$, under given depth at $a_{\mathrm m}$",
)
