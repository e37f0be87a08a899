"""Fields below the surface of a normal contact: S_m, D_m and W, of which all stresses and displacements are sums.

With pi/E_star times the Hankel transform of the pressure, P(k) = int_0^a (d - g(t)) cos(k t) dt,

    S_m = int k P exp(-k z) J_m(k r) dk,   D_m = -z dS_m/dz,   W = int P exp(-k z) J_0(k r) dk

over all k > 0.  A flat punch of radius t that is pressed in by one has -Im X_m and W = arg q; a contact grows by
g'(t) dt of them, and its edge adds those of its own radius times d - g(a).  Where g' is a polynomial the integrals are
elementary (`abel.field_moments`); elsewhere they are one integral over t.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from .. import notation as nt
from ..abel.field_moments import Moments, angle, kernel, sharper
from ..abel.form import Form, Order
from ..abel.reduce import parse
from ..entry import Case, Entry, Quantity
from ..notation import C, a, d, r, t, z
from ..profiles.profile import Profile
from . import Physics, Wording, complete, normal
from .medium import HOMOGENEOUS, Medium

GROUP = "sub"
SURFACE = (nt.S_0, nt.S_1, nt.S_2, nt.S_3)
DEEPER = (nt.D_0, nt.D_1, nt.D_2, nt.D_3)
_wave = sp.Symbol("wave_number", positive=True)
_moment = Moments()


@dataclass(frozen=True)
class Number:
    """One of the nine numbers, for a flat punch and for polynomial slopes."""

    symbol: sp.Symbol
    m: int
    function: str
    label: str
    unit: Callable[[sp.Expr], Form]
    """Of a flat punch of a radius, pressed in by one."""
    of_slope: Callable[[list[sp.Expr]], Form]
    """Of a slope with these coefficients, up to the radius a."""
    defined: Callable[[sp.Expr], sp.Expr]
    """What stands under the integral over the wave number."""

    @property
    def suffix(self) -> str:
        """The end of its keys."""
        return self.symbol.name.replace("_", "")


def _pressed(m: int) -> Number:
    """S_m."""
    turned = {0: "", 1: ", first order", 2: ", second order", 3: ", third order"}[m]
    return Number(
        SURFACE[m], m, "stress", f"Pressure below the surface{turned}",
        lambda length: kernel(m, length).imaginary * sp.S.NegativeOne,
        lambda slope: Form.total(_moment(j, m).imaginary * -c for j, c in enumerate(slope)),
        lambda transform: _wave * transform,
    )  # fmt: skip


def _deeper(m: int) -> Number:
    """D_m."""

    def of_slope(slope: list[sp.Expr]) -> Form:
        # by parts: the slope of the slope, and what is left at both ends
        bent = Form.total(_moment(j - 1, m).real * (j * c) for j, c in enumerate(slope) if j)
        ends = kernel(m, a).real * -_value(slope) + kernel(m, sp.S.Zero).real * slope[0]
        return (bent + ends) * z

    turned = {0: "", 1: ", first order", 2: ", second order", 3: ", third order"}[m]
    return Number(
        DEEPER[m], m, "stress", f"Its loss with the depth{turned}",
        lambda length: sharper(m, length).imaginary * -z, of_slope, lambda transform: z * _wave**2 * transform,
    )  # fmt: skip


def _value(slope: list[sp.Expr]) -> sp.Expr:
    return sp.Add(*(c * a**j for j, c in enumerate(slope)))


def _sunk() -> Number:
    """W."""

    def of_slope(slope: list[sp.Expr]) -> Form:
        risen = [sp.S.Zero, *(c / (j + 1) for j, c in enumerate(slope))]
        earlier = Form.total(_moment(j, 0).real * -c for j, c in enumerate(risen))
        return Form.of(angle(a), _value(risen)) + earlier

    return Number(
        nt.W, 0, "displacement", "Potential of the displacement", lambda length: Form.of(angle(length)), of_slope,
        lambda transform: transform,
    )  # fmt: skip


NUMBERS = {n.suffix: n for n in (*map(_pressed, range(4)), *map(_deeper, range(4)), _sunk())}


def _table(given: sp.Symbol) -> dict[str, Quantity]:
    return {s: Quantity(s, n.function, n.label, n.symbol, (r, z, given)) for s, n in NUMBERS.items()}


QUANTITIES, QUANTITIES_COMPLETE = _table(a), _table(d)


def definition(number: Number, grows: bool) -> sp.Expr:
    """The integral over the wave number, with g(a) for the depth of a contact that grows."""
    g = sp.Function(nt.g.name)
    pressed = g(a) - g(t) if grows else sp.Function("w1D")(t)
    transform = sp.Integral(pressed * sp.cos(_wave * t), (t, 0, a))
    wave = number.defined(transform) * sp.exp(-_wave * z) * sp.besselj(number.m, _wave * r)
    return sp.Integral(wave, (_wave, 0, sp.oo))


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """S_m, D_m and W of a profile by suffix; they rest on the normal contact `plain` where it is known already."""
    if profile.compact:
        depth = (plain or normal.derive(profile, medium))["d"]
        return {s: _entry(profile, s, QUANTITIES[s], _grown(n, depth.cases)) for s, n in NUMBERS.items()}
    face, coefficient = complete.fixed_face(profile)
    depth_there = parse(face).depth(Order((a,))).expr() if face[0].expr != 0 else sp.S.Zero
    fixed = {s: Case((a,), _with_edge(n, depth_there)) for s, n in NUMBERS.items()}
    whole: dict[str, tuple[Case, ...]] = {s: (Case((a,), case.expr.subs(C, coefficient)),) for s, case in fixed.items()}
    if coefficient == 0 and face[0].expr != 0:
        # it touches first like the unbounded profile, with a contact radius below that of the edge
        geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
        unbounded = replace(profile, contact="compact", parameters=geometry)
        radius, first = normal.derive(unbounded)["ad"].cases[0].expr, derive(unbounded)
        whole = {
            s: (Case((radius, a), first[s].cases[0].expr.subs(a, radius)), Case((a, radius), after[0].expr))
            for s, after in whole.items()
        }
    return {s: _entry(profile, s, q, whole[s], (fixed[s],)) for s, q in QUANTITIES_COMPLETE.items()}


def _grown(number: Number, depth: tuple[Case, ...]) -> tuple[Case, ...]:
    """The sum over punches of all radii, regime by regime; up to a break it is that of the contact that ends there."""
    found: list[Case] = []
    for regime in depth:
        place = regime.chain.index(a)
        lower = regime.chain[place - 1] if place else sp.S.Zero
        known = next((c.expr.subs(a, lower) for c in found if c.chain[: place + 1] == _swapped(regime.chain, place)), 0)
        found.append(Case(regime.chain, known + _summed(number, sp.diff(regime.expr, a), lower)))
    return tuple(found)


def _swapped(chain: tuple[sp.Expr, ...], place: int) -> tuple[sp.Expr, ...]:
    return (*chain[: place - 1], a, chain[place - 1]) if place else ()


def _summed(number: Number, slope: sp.Expr, lower: sp.Expr) -> sp.Expr:
    """The sum over punches from a radius on: elementary for polynomials from zero on."""
    if lower == 0 and slope.is_polynomial(a) and not slope.has(sp.Sum):
        return number.of_slope(_coefficients(slope)).expr()
    return sp.Integral(slope.subs(a, t) * number.unit(t).expr(), (t, lower, a))


def _coefficients(slope: sp.Expr) -> list[sp.Expr]:
    return list(reversed(sp.Poly(slope, a).all_coeffs()))


def _with_edge(number: Number, depth: sp.Expr) -> sp.Expr:
    """Of a contact with a fixed edge, whose face is held fixed while the radius varies."""
    edge, slope = number.unit(a) * (d - depth), sp.diff(depth, a)
    if slope == 0:
        return edge.expr()
    if slope.is_polynomial(a):
        return (edge + number.of_slope(_coefficients(slope))).expr()
    return edge.expr() + _summed(number, slope, sp.S.Zero)


def _entry(
    profile: Profile, suffix: str, quantity: Quantity, cases: tuple[Case, ...], fixed: tuple[Case, ...] = ()
) -> Entry:
    return Entry(
        key=HOMOGENEOUS.key(profile.name, GROUP, suffix),
        profile=profile,
        quantity=quantity,
        status="integral" if any(case.expr.has(sp.Integral) for case in cases) else "closed",
        cases=cases,
        definition=definition(NUMBERS[suffix], profile.compact),
        parameters=profile.parameters,
        fixed_face=fixed,
    )


_scale, _turned = nt.E_star / sp.pi, nt.mu * nt.E_star / sp.pi
ANGLE = sp.Symbol("phi", real=True)
"""From the direction of the traction on the half-space."""
_along = _turned * sp.cos(ANGLE)
_across = _turned * sp.sin(ANGLE)
_mixed = (nt.nu - 2) * nt.S_1 + nt.D_1 / 2
STRESS = {
    "zz": -_scale * (nt.S_0 + nt.D_0),
    "rz": -_scale * nt.D_1,
    "rr + tt": _scale * (nt.D_0 - (1 + 2 * nt.nu) * nt.S_0),
    "rr - tt": _scale * (nt.S_2 - 2 * nt.nu * nt.S_2 - nt.D_2),
}
"""Of the normal load, tension positive; rr is away from the axis, tt around it, zz into the half-space."""
DISPLACEMENT = {
    "z": (2 * nt.W + z * nt.S_0 / (1 - nt.nu)) / sp.pi,
    "r": -r * (nt.S_0 + nt.S_2 - 2 * nt.nu * (nt.S_0 + nt.S_2) - nt.D_0 - nt.D_2) / (2 * sp.pi * (1 - nt.nu)),
}
FRICTION = {
    "rr + tt": _along * (nt.D_1 - 2 * (1 + nt.nu) * nt.S_1),
    "rr - tt": _along * (_mixed - nt.nu * nt.S_3 - nt.D_3 / 2),
    "zz": -_along * nt.D_1,
    "rt": -_across * (_mixed + nt.nu * nt.S_3 + nt.D_3 / 2) / 2,
    "rz": -_along * (nt.S_0 - nt.D_0 / 2 + nt.D_2 / 2),
    "tz": _across * (nt.S_0 - nt.D_0 / 2 - nt.D_2 / 2),
}
"""What a traction mu p in one direction adds, which does not change the pressure."""

TITLE = "Stresses and displacements below a rigid indenter on an elastic half-space, under normal load and friction"
PHYSICS = Physics(
    "subsurface",
    {
        HOMOGENEOUS: Wording(
            place=12,
            title="Fields below the surface",
            package=TITLE,
            searched="stress displacement von Mises Tresca shear yield Hamilton Goodman Sneddon Love Boussinesq",
        ),
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    beside=True,
    material=(nt.nu, nt.mu),
    contact="below the surface",
    wanted=("stress", "displacement"),
    runtime=("subsurface.punches", "subsurface.stresses"),
    quantities={"subsurface": QUANTITIES, "subsurface complete": QUANTITIES_COMPLETE},
    shown={nt.nu: "3/10"},
    printed=False,
)
