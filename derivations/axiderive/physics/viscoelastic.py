"""Viscoelastic half-space with a constant Poisson ratio: a contact that grows (Lee, Radok) and then shrinks (Ting).

The elastic solution with unit modulus is convolved with the relaxation function: F(t) = int_0^t E(t - s) d[F_el(s)/E*].
A contact that shrinks after its only maximum is as large as it was at a time t_1 before.  The pressure that went with
all later contacts has left nothing, int_{t_1}^t E(t - s) d'(s) ds = 0, and the force is that of the contacts up to t_1.
For a way back at constant speed, with I(x) = int_0^x E ds, this is I(t - t_1) = (1 + v_2/v) I(t - t_m) for any profile.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..abel.masters import IncompleteBeta, Kummer
from ..entry import Case, Entry, Quantity, Status
from ..notation import E_1, E, E_inf, E_star, F, a, alpha, d, eta, relaxation, t_0, t_1, t_c, t_m, time, v, v_2
from ..profiles.profile import Profile
from . import Physics, Wording, normal
from .medium import HOMOGENEOUS

GROUP = "vis"
REFERENCES = ("(11.16)", "(11.20)")
RETURNED = ("(11.16)",)
_s = sp.Symbol("s", positive=True)  # Laplace variable
_m = sp.Symbol("m", positive=True)  # F_el ~ d**m


@dataclass(frozen=True)
class Law:
    """A material law: relaxation E(t) for t > 0, creep J(t), ramp factor int_0^1 m x**(m-1) E(t (1 - x)) dx.

    The relaxation of a Kelvin-Voigt solid also holds an impulse eta at t = 0, which ramp factor and memory carry.
    """

    name: str
    suffix: str
    material: str
    """What it describes, in words."""
    parameters: tuple[sp.Symbol, ...]
    relaxation: sp.Expr
    creep: sp.Expr
    ramp: sp.Expr
    memory: sp.Expr
    """I(t) = int_0^t E(s) ds."""
    kept: sp.Expr
    """Of a ramp that counts up to t_1 alone: int_0^1 m x**(m-1) E(t - t_1 x) dx."""
    earlier: sp.Expr | None
    """t_1 by I(t - t_1) = (1 + v_2/v) I(t - t_m), where that can be solved."""
    end: sp.Expr | None
    """t_c by I(t_c) = (1 + v_2/v) I(t_c - t_m), where that can be solved."""
    impulse: sp.Expr = sp.S.Zero


_fading = time / relaxation
_glassy = E_inf + E_1
_slowed = v_2 / v
_since, _faded = (time - t_m) / relaxation, sp.exp(-(time - t_1) / relaxation) * Kummer(1, 1 + _m, -t_1 / relaxation)
_power = E * t_0**alpha / (sp.gamma(1 + alpha) * sp.gamma(1 - alpha))
_root = (1 + _slowed) ** (1 / (1 - alpha))

LAWS = (
    Law(
        "maxwell", "mx", "a Maxwell fluid", (E, relaxation),
        E * sp.exp(-_fading), (1 + _fading) / E, E * Kummer(1, 1 + _m, -_fading),
        E * relaxation * (1 - sp.exp(-_fading)), E * _faded,
        t_m + relaxation * sp.log(1 - _slowed * (sp.exp(_since) - 1)),
        t_m + relaxation * sp.log(1 + (1 - sp.exp(-t_m / relaxation)) / _slowed),
    ),
    Law(
        "kelvin_voigt", "kv", "a Kelvin-Voigt solid", (E, eta),
        E, (1 - sp.exp(-E * time / eta)) / E, E + eta * _m / time,
        E * time + eta, E, t_m - _slowed * (time - t_m + eta / E), t_m + t_m / _slowed - eta / E, eta,
    ),
    Law(
        "standard_solid", "sls", "a standard solid", (E_inf, E_1, relaxation),
        E_inf + E_1 * sp.exp(-_fading),
        (1 - E_1 / _glassy * sp.exp(-_fading * E_inf / _glassy)) / E_inf,
        E_inf + E_1 * Kummer(1, 1 + _m, -_fading),
        E_inf * time + E_1 * relaxation * (1 - sp.exp(-_fading)), E_inf + E_1 * _faded, None, None,
    ),
    Law(
        "power_creep", "pc", "a material of power-law creep", (E, alpha, t_0),
        E * (t_0 / time) ** alpha / (sp.gamma(1 + alpha) * sp.gamma(1 - alpha)),
        (time / t_0) ** alpha / E,
        E * (t_0 / time) ** alpha * sp.gamma(1 + _m) / (sp.gamma(1 + alpha) * sp.gamma(1 + _m - alpha)),
        _power * time ** (1 - alpha) / (1 - alpha),
        _power * _m * time ** (_m - alpha) * t_1**-_m * IncompleteBeta(t_1 / time, _m, 1 - alpha),
        time - _root * (time - t_m), t_m + t_m / (_root - 1),
    ),
)  # fmt: skip


QUANTITIES = {
    q.suffix: q
    for law in LAWS
    for q in (
        Quantity(f"ramp_{law.suffix}", f"ramp_force_{law.name}", f"Force, depth ramp, {law.name}", F, (time,),
                 row="Force: ramp of the depth",
                 summary=f"Normal force at time t on {law.material}, indented at the constant speed v."),
        Quantity(f"step_{law.suffix}", f"step_force_{law.name}", f"Force, depth step, {law.name}", F, (time, d),
                 row="Force: step of the depth",
                 summary=f"Normal force at time t on {law.material}, held at the indentation depth d from t = 0 on."),
        Quantity(f"load_{law.suffix}", f"step_load_radius_{law.name}", f"Contact radius, load step, {law.name}",
                 a, (time, F), row="Contact radius: step of the force",
                 summary=f"Contact radius at time t on {law.material}, under the constant normal force F"
                 " from t = 0 on."),
        Quantity(f"earlier_{law.suffix}", f"earlier_time_{law.name}", f"Earlier time, retraction, {law.name}", t_1,
                 (time,), row="Earlier time: of the same contact",
                 summary=f"Time before t at which the contact was as large on {law.material}; zero after its end."),
        Quantity(f"radius_{law.suffix}", f"retract_radius_{law.name}", f"Contact radius, retraction, {law.name}", a,
                 (time,), row="Contact radius: ramp and retraction",
                 summary=f"Contact radius at time t on {law.material}, pressed in at v until t_m, then back at v_2."),
        Quantity(f"retract_{law.suffix}", f"retract_force_{law.name}", f"Force, retraction, {law.name}", F, (time,),
                 row="Force: ramp and retraction",
                 summary=f"Normal force at time t on {law.material}, pressed in at v until t_m, then back at v_2."),
        Quantity(f"end_{law.suffix}", f"contact_time_{law.name}", f"Contact time, {law.name}", t_c, (),
                 row="Contact time: of ramp and retraction",
                 summary=f"Time at which the contact with {law.material} ends on the way back."),
    )
}  # fmt: skip
TURNED = (v, v_2, t_m)
"""What the functions of the way back take besides."""


def of_depth(plain: Mapping[str, Entry]) -> Entry:
    """The elastic force as a function of the depth, which a complete contact has at once."""
    return plain.get("Fd", plain["F"])


def derive(profile: Profile) -> dict[str, Entry]:
    """Force after a step of depth, radius after one of load; of power laws and the flat punch also a ramp, and back."""
    plain = normal.derive(profile)
    out: dict[str, Entry] = {}
    depth_route = of_depth(plain)
    exponent = elastic_exponent(depth_route)
    for law in LAWS:
        if exponent is not None:
            elastic = depth_route.cases[0].expr.subs(E_star, law.ramp.subs(_m, exponent)).subs(d, v * time)
            quantity = QUANTITIES[f"ramp_{law.suffix}"]
            out[quantity.suffix] = _entry(profile, quantity, "closed", (Case((), elastic),), (v, *law.parameters))
            out |= _turned(profile, plain, law, exponent)
        quantity, note = QUANTITIES[f"step_{law.suffix}"], ""
        step = tuple(Case(case.chain, _scaled(case.expr, law.relaxation)) for case in depth_route.cases)
        if depth_route.status == "root":
            relaxing = (Case(case.chain, sp.Eq(F, _scaled(case.expr, law.relaxation))) for case in plain["F"].cases)
            step, note = tuple(relaxing), "a is the contact radius of the elastic contact at the depth d"
        out[quantity.suffix] = _entry(profile, quantity, depth_route.status, step, law.parameters, note)
        if "aF" in plain:
            radius = plain["aF"]
            load = tuple(Case(case.chain, _scaled(case.expr, 1 / law.creep)) for case in radius.cases)
            quantity = QUANTITIES[f"load_{law.suffix}"]
            out[quantity.suffix] = _entry(profile, quantity, radius.status, load, law.parameters)
    return out


def _turned(profile: Profile, plain: Mapping[str, Entry], law: Law, exponent: sp.Expr) -> dict[str, Entry]:
    """The way back: what follows from t_1, of the force up to it and of the radius at it, and t_1 itself."""
    taken, definitions = (*TURNED, *law.parameters), turned_definitions()
    force = of_depth(plain).cases[0].expr.subs(E_star, law.kept.subs(_m, exponent)).subs(d, v * t_1)
    shown = {
        "earlier": ((t_m, time), law.earlier or turned(law, t_1, time), ()),
        "end": ((t_m, t_c), law.end or turned(law, sp.S.Zero, t_c), ()),
        "retract": ((t_1, t_m, time), force, profile.parameters),
    }
    if "ad" in plain:
        shown["radius"] = ((t_1, t_m, time), plain["ad"].cases[0].expr.subs(d, v * t_1), profile.parameters)
    out = {}
    for kind, (chain, expr, lengths) in shown.items():
        quantity = QUANTITIES[f"{kind}_{law.suffix}"]
        status: Status = "root" if isinstance(expr, sp.Eq) else "closed"
        out[quantity.suffix] = HOMOGENEOUS.entry(
            profile, GROUP, quantity, status, (Case(chain, expr),), definitions[kind], (*lengths, *taken), RETURNED
        )
    return out


def turned(law: Law, before: sp.Expr, now: sp.Expr) -> sp.Eq:
    """The equation of a contact that is as large as it was before."""
    return sp.Eq(law.memory.subs(time, now - before), (1 + v_2 / v) * law.memory.subs(time, now - t_m))


def turned_definitions() -> dict[str, sp.Expr]:
    """What the quantities of the way back are, by the first part of their keys."""
    relaxed, moved = sp.Function("E"), sp.Derivative(sp.Function("d")(_s), _s)
    gained = sp.Derivative(sp.Function("F")(_s), _s) / E_star
    return {
        "earlier": sp.Eq(sp.Integral(relaxed(time - _s) * moved, (_s, t_1, time)), 0),
        "end": sp.Eq(sp.Integral(relaxed(t_c - _s) * moved, (_s, 0, t_c)), 0),
        "retract": sp.Integral(relaxed(time - _s) * gained, (_s, 0, t_1)),
        "radius": sp.Eq(sp.Function("g")(a), v * t_1),
    }


def _scaled(expr: sp.Expr, modulus: sp.Expr) -> sp.Expr:
    return expr.subs(E_star, modulus)


def elastic_exponent(entry: Entry) -> sp.Expr | None:
    """The power m of F_el ~ d**m, or None."""
    if entry.status != "closed" or len(entry.cases) != 1:
        return None
    power = entry.cases[0].expr.as_independent(d, as_Add=False)[1]
    base, exponent = power.as_base_exp()
    if base != d and not (base.is_Mul and base.as_independent(d, as_Add=False)[1] == d):
        return None
    return exponent


def _entry(
    profile: Profile,
    quantity: Quantity,
    status: Status,
    cases: tuple[Case, ...],
    extra: tuple[sp.Symbol, ...],
    note: str = "",
) -> Entry:
    kernel = sp.Function("E")(time - _s) * sp.Derivative(sp.Function("F")(_s), _s) / E_star
    definition, parameters = sp.Integral(kernel, (_s, 0, time)), (*profile.parameters, *extra)
    return HOMOGENEOUS.entry(profile, GROUP, quantity, status, cases, definition, parameters, REFERENCES, note=note)


PHYSICS = Physics(
    "viscoelastic",
    {
        HOMOGENEOUS: Wording(
            place=7,
            title="Growing contact, viscoelastic half-space",
            heading="Viscoelastic half-space",
            note=r"while the contact grows; $E(t)$, $J(t)$, $\Phi_m(t)$ of the four laws on page \pageref{part:laws}",
            package="Contact with a viscoelastic half-space, while it grows and on the way back",
            searched="creep relaxation Lee Radok rheology Ting retraction approach retract",
            button="viscoelastic",
            subject="sphere.vis",
        )
    },
    lambda profile, *_: derive(profile),
    group=GROUP,
    over=normal.PHYSICS,
    laws=LAWS,
    contact="on a viscoelastic half-space",
    shown={
        E: "1",
        E_inf: "2/5",
        E_1: "3/5",
        relaxation: "2",
        eta: "3/2",
        alpha: "1/4",
        t_0: "1",
        v: "1/5",
        time: "1",
        v_2: "1/20",
        t_m: "9/10",
        t_1: "1/2",
        t_c: "3/2",
    },
    runtime=("physics.relaxation", "physics.retraction"),
    quantities={"viscoelastic": QUANTITIES},
    wanted=("ramp_force", "step_force", "step_load_radius"),
)
