"""Viscoelastic half-space with a constant Poisson ratio, while the contact grows (Lee and Radok).

The elastic solution with unit modulus is convolved with the relaxation
function: F(t) = int_0^t E(t - t') d/dt'[F_el(t')/E*] dt'.  A shrinking contact
does not obey this rule and is refused.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from ..abel.masters import Kummer
from ..entry import Case, Entry, Quantity, Status
from ..notation import E_1, E, E_inf, E_star, F, a, alpha, d, eta, relaxation, t_0, time, v
from ..profiles.profile import Profile
from . import Physics, Wording, normal
from .medium import HOMOGENEOUS

GROUP = "vis"
REFERENCES = ("(11.16)", "(11.20)")
_s = sp.Symbol("s", positive=True)  # Laplace variable
_m = sp.Symbol("m", positive=True)  # F_el ~ d**m


@dataclass(frozen=True)
class Law:
    """A material law: relaxation E(t) for t > 0, creep J(t), ramp factor int_0^1 m x**(m-1) E(t (1 - x)) dx.

    The relaxation of a Kelvin-Voigt solid also holds an impulse eta at t = 0, which only the ramp factor carries.
    """

    name: str
    suffix: str
    material: str
    """What it describes, in words."""
    parameters: tuple[sp.Symbol, ...]
    relaxation: sp.Expr
    creep: sp.Expr
    ramp: sp.Expr
    impulse: sp.Expr = sp.S.Zero


_fading = time / relaxation
_glassy = E_inf + E_1

LAWS = (
    Law(
        "maxwell", "mx", "a Maxwell fluid", (E, relaxation),
        E * sp.exp(-_fading), (1 + _fading) / E, E * Kummer(1, 1 + _m, -_fading),
    ),
    Law(
        "kelvin_voigt", "kv", "a Kelvin-Voigt solid", (E, eta),
        E, (1 - sp.exp(-E * time / eta)) / E, E + eta * _m / time, eta,
    ),
    Law(
        "standard_solid", "sls", "a standard solid", (E_inf, E_1, relaxation),
        E_inf + E_1 * sp.exp(-_fading),
        (1 - E_1 / _glassy * sp.exp(-_fading * E_inf / _glassy)) / E_inf,
        E_inf + E_1 * Kummer(1, 1 + _m, -_fading),
    ),
    Law(
        "power_creep", "pc", "a material of power-law creep", (E, alpha, t_0),
        E * (t_0 / time) ** alpha / (sp.gamma(1 + alpha) * sp.gamma(1 - alpha)),
        (time / t_0) ** alpha / E,
        E * (t_0 / time) ** alpha * sp.gamma(1 + _m) / (sp.gamma(1 + alpha) * sp.gamma(1 + _m - alpha)),
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
    )
}  # fmt: skip


def of_depth(plain: Mapping[str, Entry]) -> Entry:
    """The elastic force as a function of the depth, which a complete contact has at once."""
    return plain.get("Fd", plain["F"])


def derive(profile: Profile) -> dict[str, Entry]:
    """Force after a ramp (power laws and the flat punch), force after a step of depth, radius after a step of load."""
    plain = normal.derive(profile)
    out: dict[str, Entry] = {}
    depth_route = of_depth(plain)
    exponent = elastic_exponent(depth_route)
    for law in LAWS:
        if exponent is not None:
            elastic = depth_route.cases[0].expr.subs(E_star, law.ramp.subs(_m, exponent)).subs(d, v * time)
            quantity = QUANTITIES[f"ramp_{law.suffix}"]
            out[quantity.suffix] = _entry(profile, quantity, "closed", (Case((), elastic),), (v, *law.parameters))
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
            package="Contact with a viscoelastic half-space, while it grows",
            searched="creep relaxation Lee Radok rheology",
            button="viscoelastic",
            subject="sphere.vis",
        )
    },
    lambda profile, *_: derive(profile),
    group=GROUP,
    over=normal.PHYSICS,
    laws=LAWS,
    contact="on a viscoelastic half-space",
    shown={E: "1", E_inf: "2/5", E_1: "3/5", relaxation: "2", eta: "3/2", alpha: "1/4", t_0: "1", v: "1/5", time: "1"},
    runtime=("physics.relaxation",),
    quantities={"viscoelastic": QUANTITIES},
    wanted=("ramp_force", "step_force", "step_load_radius"),
)
