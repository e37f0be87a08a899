"""Viscoelastic half-space with a constant Poisson ratio: a contact that grows (Lee, Radok) and then shrinks (Ting).

The elastic solution with unit modulus is convolved with the relaxation function: F(t) = int_0^t E(t - s) d[F_el(s)/E*].
A contact that shrinks after its only maximum is as large as it was at a time t_1 before.  The pressure that went with
all later contacts has left nothing, int_{t_1}^t E(t - s) d'(s) ds = 0, and the force is that of the contacts up to t_1.
For a depth that is held from t_m to t_h and a way back at constant speed, with I(x) = int_0^x E ds, this is
I(t - t_1) = I(t - t_m) + v_2/v I(t - t_h) for any profile.

Integrated by parts the force is that of springs, as dF_el = 2 E* x dg: each is touched at g(x)/v and pressed at v from
then on, F = 2 v int_0^a [I(t - g(x)/v) - I(t - t_1)] dx with g(a) = v t_1.  A power of the depth leaves a factor of it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..abel.form import Chain
from ..abel.masters import IncompleteBeta, Kummer
from ..entry import Case, Entry, Quantity, Status
from ..notation import E_1, E, E_inf, E_star, F, a, alpha, d, eta, relaxation, t_0, t_1, t_c, t_h, t_m, time, v, v_2, x
from ..profiles.profile import Profile
from . import Physics, Wording, normal
from .consequences.energy import pieces
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
    """t_1 by I(t - t_1) = I(t - t_m) + v_2/v I(t - t_h), where that can be solved."""
    end: sp.Expr | None
    """t_c by I(t_c) = I(t_c - t_m) + v_2/v I(t_c - t_h), where that can be solved for any t_h."""
    impulse: sp.Expr = sp.S.Zero


_fading = time / relaxation
_glassy = E_inf + E_1
_slowed = v_2 / v
_faded = sp.exp(-(time - t_1) / relaxation) * Kummer(1, 1 + _m, -t_1 / relaxation)
_grown = sp.exp((time - t_m) / relaxation) - sp.exp((t_h - t_m) / relaxation)
_power = E * t_0**alpha / (sp.gamma(1 + alpha) * sp.gamma(1 - alpha))
_longer = (1 + _slowed * ((time - t_m) / (time - t_h)) ** (alpha - 1)) ** (1 / (1 - alpha))

LAWS = (
    Law(
        "maxwell", "mx", "a Maxwell fluid", (E, relaxation),
        E * sp.exp(-_fading), (1 + _fading) / E, E * Kummer(1, 1 + _m, -_fading),
        E * relaxation * (1 - sp.exp(-_fading)), E * _faded,
        t_m + relaxation * sp.log(1 - _slowed * _grown),
        t_h + relaxation * sp.log(1 + (sp.exp(t_m / relaxation) - 1) * sp.exp(-t_h / relaxation) / _slowed),
    ),
    Law(
        "kelvin_voigt", "kv", "a Kelvin-Voigt solid", (E, eta),
        E, (1 - sp.exp(-E * time / eta)) / E, E + eta * _m / time,
        E * time + eta, E, t_m - _slowed * (time - t_h + eta / E), t_h + t_m / _slowed - eta / E, eta,
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
        time - _longer * (time - t_m), None,
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
                 summary=f"Contact radius at time t on {law.material}, pressed in at v until t_m, from t_h on"
                 " back at v_2."),
        Quantity(f"retract_{law.suffix}", f"retract_force_{law.name}", f"Force, retraction, {law.name}", F, (time,),
                 row="Force: ramp and retraction",
                 summary=f"Normal force at time t on {law.material}, pressed in at v until t_m, from t_h on"
                 " back at v_2."),
        Quantity(f"end_{law.suffix}", f"contact_time_{law.name}", f"Contact time, {law.name}", t_c, (),
                 row="Contact time: of ramp and retraction",
                 summary=f"Time at which the contact with {law.material} ends on the way back."),
    )
}  # fmt: skip
TURNED = (v, v_2, t_m, t_h)
"""What the functions of the way back take besides."""
AT_DEPTH = "a is the contact radius of the elastic contact at the depth v {}"


def of_depth(plain: Mapping[str, Entry]) -> Entry:
    """The elastic force as a function of the depth, which a complete contact has at once."""
    return plain.get("Fd", plain["F"])


def of_radius(plain: Mapping[str, Entry]) -> tuple[Entry, Entry]:
    """The elastic depth and force as functions of the radius."""
    return plain["d"], plain["F"]


def derive(profile: Profile) -> dict[str, Entry]:
    """Force after a step of depth, radius after one of load; if the contact grows from a point or a flat face, a ramp
    and the way back.
    """
    plain = normal.derive(profile)
    out: dict[str, Entry] = {}
    depth_route = of_depth(plain)
    for law in LAWS:
        if ramped(plain):
            out |= _ramped(profile, plain, law)
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


def ramped(plain: Mapping[str, Entry]) -> bool:
    """Whether the force of a ramp is known: that of a power of the depth, or of springs."""
    return "ad" in plain or elastic_exponent(of_depth(plain)) is not None


def _ramped(profile: Profile, plain: Mapping[str, Entry], law: Law) -> dict[str, Entry]:
    """The way in, and the way back: what follows from t_1, of the force up to it and of the radius at it, and t_1."""
    taken, definitions, past = (*TURNED, *law.parameters), turned_definitions(), (t_1, t_m, t_h, time)
    exponent = elastic_exponent(of_depth(plain))
    if exponent is None:
        grown, kept = _of_springs(plain, law, time), _of_springs(plain, law, t_1)
    else:
        force = of_depth(plain).cases[0].expr
        grown = (Case((), force.subs(E_star, law.ramp.subs(_m, exponent)).subs(d, v * time)),)
        kept = (Case(past, force.subs(E_star, law.kept.subs(_m, exponent)).subs(d, v * t_1)),)
    quantity, there = QUANTITIES[f"ramp_{law.suffix}"], "" if exponent is not None else AT_DEPTH
    entry = _entry(profile, quantity, _status(grown), grown, (v, *law.parameters), there.format("t"))
    shown = {
        "earlier": ((Case((t_m, t_h, time), law.earlier or turned(law, t_1, time)),), (), ""),
        "end": ((Case((t_m, t_h, t_c), law.end or turned(law, sp.S.Zero, t_c)),), (), ""),
        "retract": (kept, profile.parameters, there.format("t_1")),
    }
    if "ad" in plain:
        radii = tuple(Case(_in_time(case.chain), case.expr.subs(d, v * t_1)) for case in plain["ad"].cases)
        shown["radius"] = (radii, profile.parameters, "")
    out = {quantity.suffix: entry}
    for kind, (cases, lengths, note) in shown.items():
        quantity = QUANTITIES[f"{kind}_{law.suffix}"]
        out[quantity.suffix] = HOMOGENEOUS.entry(
            profile, GROUP, quantity, _status(cases), cases, definitions[kind], (*lengths, *taken), RETURNED, note=note
        )
    return out


def _in_time(chain: Chain) -> Chain:
    """An order of depths as one of the times at which a ramp comes to them."""
    return tuple(sp.sympify(depth).subs(d, v * t_1) / v for depth in chain) if d in chain else chain


def _status(cases: tuple[Case, ...]) -> Status:
    if any(isinstance(case.expr, sp.Eq) for case in cases):
        return "root"
    return "integral" if any(case.expr.has(sp.Integral) for case in cases) else "closed"


def _of_springs(plain: Mapping[str, Entry], law: Law, until: sp.Symbol) -> tuple[Case, ...]:
    """2 v int_0^a [I(t - g(x)/v) - I(t - t_1)] dx, whose last term is the impulse, and counts, at the present alone.

    A dashpot beside a spring leaves no integral but that of the elastic force.
    """
    now = until == time
    if law.impulse != 0:
        pulled = 2 * v * a * law.impulse if now else sp.S.Zero
        return tuple(
            Case(case.chain, _scaled(case.expr, law.relaxation) + pulled) for case in of_radius(plain)[1].cases
        )
    depth = {case.chain: case.expr for case in of_radius(plain)[0].cases}
    gone = sp.S.Zero if now else law.memory.subs(time, time - until)
    cases = []
    for chain in depth:
        total = sp.S.Zero
        for low, high, sunk in pieces(depth, chain):
            left = law.memory.subs(time, time - sunk.subs(a, x) / v) - gone
            total += (high - low) * left if sunk == 0 else sp.Integral(left, (x, low, high))
        cases.append(Case(chain, 2 * v * total))
    return tuple(cases)


def in_radius(entry: Entry) -> bool:
    """Whether its formula is one in the radius of the contact, which another one gives."""
    free = set().union(*(case.expr.free_symbols for case in entry.cases))
    return a in free - {entry.quantity.symbol, *entry.arguments, *entry.parameters}


def turned(law: Law, before: sp.Expr, now: sp.Expr) -> sp.Eq:
    """The equation of a contact that is as large as it was before."""
    left, stopped, back = (law.memory.subs(time, now - start) for start in (before, t_m, t_h))
    return sp.Eq(left, stopped + v_2 / v * back)


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
            package="Contact with a viscoelastic half-space, while it grows, is held and on the way back",
            searched="creep relaxation Lee Radok rheology Ting retraction approach hold dwell retract",
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
        t_m: "4/5",
        t_h: "9/10",
        t_1: "1/2",
        t_c: "3/2",
    },
    runtime=("physics.relaxation", "physics.retraction"),
    quantities={"viscoelastic": QUANTITIES},
    wanted=("ramp_force", "step_force", "step_load_radius"),
)
