"""Plane contact without adhesion: superposition of flat strips.

A strip of half-width t under the line load P has p = P/(pi sqrt(t^2 - x^2))
and, outside, dw/dx = -2 P/(pi E* sqrt(x^2 - t^2)); a contact grows by strips of
load P'(t) dt.  A half plane has no absolute depth: d is the depth of the middle
relative to the surface at a distance L.

Under an eccentric load a flat strip carries p = (alpha + beta x)/sqrt(c^2 - x^2) at any half-width c.  Load and moment
fix alpha and beta; since the strip itself stays level, the second term inclines it by beta times int 1/sqrt(c^2 - x^2)
dx.  The contact loses an edge where the pressure there vanishes, and then keeps the other.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from .. import notation as nt
from ..abel import plane_moments
from ..abel.atoms import PowerAtom
from ..abel.form import Chain, Form, Order, insert
from ..abel.moments import depth_moment
from ..abel.plane_moments import Inside, Kernel, Outside, complementary
from ..abel.reduce import NotReducibleError, Reduced, parse
from ..entry import Case, Entry, Primitive, Quantity, Status
from ..notation import E_star, L, P, a, e, f, r, r_zero, t, x, x_zero
from ..profiles.pools import STRIPS
from ..profiles.profile import Piece, Profile
from . import Physics, Wording, complete
from .medium import HOMOGENEOUS
from .normal import closed_inverse

PLANE = {
    q.suffix: q
    for q in (
        Quantity("P", "load", "Line load", nt.P, (nt.a,), summary="Line load at half-width a."),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.x, nt.a), written="p(x)", place="inside", parity="even",
                 summary="Contact pressure, positive in compression; zero outside the contact."),
        Quantity("s", "slope", "Slope outside", nt.slope, (nt.x, nt.a), written=r"\frac{\mathrm{d}w}{\mathrm{d}x}",
                 place="outside", parity="odd", summary="Slope dw/dx of the surface, inside and outside the contact."),
        Quantity("d", "depth", "Depth relative to a point at distance L", nt.d, (nt.L, nt.a),
                 summary="Indentation depth relative to the surface at the distance L."),
        Quantity("aP", "half_width_from_load", "Half-width of the contact from the load", nt.a, (nt.P,), inverts="P",
                 solves="P(a)=P", row="Half-width from load",
                 summary="Half-width of the contact under the line load P."),
    )
}  # fmt: skip

PLANE_COMPLETE = {
    q.suffix: q
    for q in (
        replace(PLANE["p"], arguments=(nt.x, nt.P)),
        replace(PLANE["s"], arguments=(nt.x, nt.P)),
        replace(
            PLANE["d"], label="Depth of the middle relative to a point at distance L", row=PLANE["d"].label,
            arguments=(nt.L, nt.P),
        ),
        Quantity("xz", "zero_distance", "Place of first zero pressure", nt.x_zero, (), threshold=True,
                 written="x_{0}", row="Zero pressure",
                 summary="Distance from the middle where the pressure first vanishes on unloading."),
        Quantity("Pmin", "minimum_load", "Least line load of complete contact", nt.P, (), threshold=True,
                 written=r"P_{\mathrm{min}}", summary="Least line load of complete contact."),
    )
}  # fmt: skip

PLANE_ECCENTRIC = {
    q.suffix: q
    for q in (
        PLANE_COMPLETE["p"],
        Quantity("phi", "tilt", "Inclination of the punch", nt.tilt, (nt.P,),
                 summary="Inclination of the punch under an eccentric load."),
        Quantity("cw", "contact_width", "Width of the contact", nt.width, (),
                 summary="Width of the contact, smaller than the punch once an edge has lifted off."),
    )
}  # fmt: skip

# factors of P/E* in the pressure over E*, and in slope and depth
PRESSURE, SURFACE = 1 / sp.pi, 2 / sp.pi


def definitions(profile: Profile) -> dict[str, sp.Expr]:
    """The defining integrals; P(t) is the load of an earlier contact of half-width t."""
    if e in profile.parameters:
        # equilibrium of moments, the slope under the strip, and the extent of positive pressure
        pressure, s = sp.Function(nt.p.name), sp.Symbol("s", real=True)
        return {
            "p": sp.Eq(sp.Integral(x * pressure(x), (x, -a, a)), P * e),
            "phi": sp.Eq(2 / (sp.pi * E_star) * sp.Integral(pressure(s) / (s - x), (s, -a, a)), nt.tilt),
            "cw": sp.Eq(pressure(a - nt.width), 0),
        }
    load = E_star * sp.Integral(x * sp.Derivative(sp.Function(f.name)(x), x) / sp.sqrt(a**2 - x**2), (x, 0, a))
    growth = sp.Derivative(sp.Function(P.name)(t), t)
    out = {
        "p": PRESSURE * sp.Integral(growth / sp.sqrt(t**2 - x**2), (t, x, a)),
        "s": -SURFACE / E_star * sp.Integral(growth / sp.sqrt(x**2 - t**2), (t, 0, a)),
        "d": SURFACE / E_star * sp.Integral(growth * sp.acosh(L / t), (t, 0, a)),
    }
    if profile.compact:
        return {"P": load, **out, "aP": sp.Eq(load, P)}
    edge = P - sp.Function(P.name)(a)
    return {
        "p": edge * PRESSURE / sp.sqrt(a**2 - x**2) + out["p"],
        "s": -SURFACE / E_star * edge / sp.sqrt(x**2 - a**2) + out["s"],
        "d": SURFACE / E_star * edge * sp.acosh(L / a) + out["d"],
        "xz": sp.Eq(sp.Derivative(sp.sqrt(a**2 - x**2) * sp.Function("p")(x), x), 0),
        "Pmin": sp.Eq(sp.Function("p")(x_zero), 0),
    }


def derive(profile: Profile) -> dict[str, Entry]:
    """All entries of a plane profile, keyed by suffix.

    Raises
    ------
    NotReducibleError
        If the profile is not a sum of powers of the distance from the middle.
    ValueError
        If the profile does not start at zero or has a jump.
    """
    if e in profile.parameters:
        return eccentric(profile)
    if profile.complete:
        return _Complete(profile).entries()
    return _Compact(profile).entries()


@dataclass(frozen=True)
class Superposition:
    """Load and fields of a face over E*, as sums over its atoms; the antiderivatives are those of the load itself."""

    atoms: tuple[PowerAtom, ...]

    @classmethod
    def of(cls, pieces: tuple[Piece, ...]) -> Superposition:
        """The atoms of f(x); `NotReducibleError` if one is no power of x."""
        reduced: Reduced = parse(tuple(_in_r(piece) for piece in pieces))
        powers = tuple(atom for atom in reduced.atoms if isinstance(atom, PowerAtom))
        if len(powers) < len(reduced.atoms):
            message = "a plane profile must be a sum of powers of x; no plane moments are known for other shapes"
            raise NotReducibleError(message)
        return cls(powers)

    def load(self, chain: Chain) -> Form:
        """P/E* of a contact of half-width a, on this order of the lengths."""
        return complementary(Form.total(plane_moments.load(atom, Order(chain)) for atom in self.atoms))

    def field(self, chain: Chain, kernel: Kernel) -> Form:
        """Integral of P'(t)/E* times the kernel over the half-widths t."""
        return complementary(Form.total(plane_moments.field(atom, Order(chain), kernel) for atom in self.atoms))

    def depth(self, chain: Chain) -> Form:
        """Integral of P'(t)/E* times acosh(L/t); the depth is `SURFACE` times it."""
        return complementary(Form.total(plane_moments.depth(atom, Order(chain)) for atom in self.atoms))

    def primitives(self, chain: Chain) -> tuple[Primitive, ...]:
        """Antiderivatives in x of the integrand of the load, with the factor E*."""
        parts = (part for atom in self.atoms for part in plane_moments.primitives(atom, Order(chain)))
        return tuple(replace(part, integrand=E_star * part.integrand, expr=E_star * part.expr) for part in parts)


def _in_r(piece: Piece) -> Piece:
    return Piece(piece.upper, sp.expand_power_base(piece.expr).subs(x, r))


def _entry(
    profile: Profile, quantity: Quantity, cases: tuple[Case, ...], status: Status = "closed", **more: Any
) -> Entry:
    taken = profile.parameters + ((E_star,) if any(case.expr.has(E_star) for case in cases) else ())
    key, definition = f"plane.{profile.name}.{quantity.suffix}", definitions(profile)[quantity.suffix]
    return Entry(key, profile, quantity, status, cases, definition, taken, **more)


@dataclass
class _Compact:
    """The derivation of one profile whose contact grows."""

    profile: Profile

    def __post_init__(self) -> None:
        self.strips = Superposition.of(self.profile.pieces)
        above = self.profile.breaks[0] if self.profile.truncated else None
        self.chains = tuple(insert(self.profile.breaks, a, above=above))

    def entries(self) -> dict[str, Entry]:
        """P, p, s, d and aP by suffix; aP is an equation where no inverse is known."""
        load = tuple(Case(chain, (self.strips.load(chain) * E_star).expr()) for chain in self.chains)
        primitives = {chain: self.strips.primitives(chain) for chain in self.chains}
        half_width = closed_inverse(load, P)
        equation = tuple(Case(case.chain, sp.Eq(case.expr, P)) for case in load)
        status: Status = "closed" if half_width else "root"
        return {
            "P": self._entry("P", load, primitives=primitives),
            "p": self._entry("p", self._pressure()),
            "s": self._entry("s", self._slope()),
            "d": self._entry("d", self._depth()),
            "aP": self._entry("aP", half_width or equation, status=status),
        }

    def _entry(self, suffix: str, cases: tuple[Case, ...], **more: Any) -> Entry:
        return _entry(self.profile, PLANE[suffix], cases, **more)

    def _pressure(self) -> tuple[Case, ...]:
        chains = [chain for regime in self.chains for chain in insert(regime, x, below=a)]
        fields = ((chain, self.strips.field(chain, Inside(Order(chain)))) for chain in chains)
        return tuple(Case(chain, (field * (PRESSURE * E_star)).expr()) for chain, field in fields)

    def _slope(self) -> tuple[Case, ...]:
        chains = [chain for regime in self.chains for chain in insert(regime, x, above=a)]
        fields = ((chain, self.strips.field(chain, Outside(x))) for chain in chains)
        return tuple(Case(chain, (field * -SURFACE).expr()) for chain, field in fields)

    def _depth(self) -> tuple[Case, ...]:
        chains = [chain for regime in self.chains for chain in insert(regime, L, above=a)]
        return tuple(Case(chain, (self.strips.depth(chain) * SURFACE).expr()) for chain in chains)


@dataclass
class _Complete:
    """A face between sharp edges: the strip over the whole width takes the rest of the load."""

    profile: Profile

    def __post_init__(self) -> None:
        self.strips = Superposition.of(self.profile.pieces)

    def entries(self) -> dict[str, Entry]:
        """p, s and d by suffix, and xz and Pmin where the face is not flat."""
        formulas = self._formulas()
        entries = {suffix: _entry(self.profile, PLANE_COMPLETE[suffix], (case,)) for suffix, case in formulas.items()}
        return entries | self._threshold() if self.strips.atoms else entries

    def _formulas(self) -> dict[str, Case]:
        inside, outside, far = (x, a), (a, x), (a, L)
        edge = Form.of(sp.S.One, P / E_star) + self.strips.load((a,)) * -1
        pressure = edge.times(1 / sp.sqrt(a**2 - x**2)) + self.strips.field(inside, Inside(Order(inside)))
        slope = edge.times(1 / sp.sqrt(x**2 - a**2)) + self.strips.field(outside, Outside(x))
        depth = edge.times(sp.acosh(L / a)) + self.strips.depth(far)
        return {
            "p": Case(inside, (pressure * (PRESSURE * E_star)).expr()),
            "s": Case(outside, (slope * -SURFACE).expr()),
            "d": Case(far, (depth * SURFACE).expr()),
        }

    def _threshold(self) -> dict[str, Entry]:
        """Where and at which load the pressure first vanishes on unloading.

        For one power of the distance p is int t^(n-1)/sqrt(t^2 - x^2) dt up to a factor, as under the round
        punch of the same face: the place is the same, and the least load is to the load of the unbounded face
        as the least depth of the round punch is to its depth.
        """
        round_punch = replace(self.profile, pieces=tuple(_in_r(piece) for piece in self.profile.pieces))
        counterpart = complete.derive(round_punch)
        ring, least_depth = counterpart["rz"], counterpart["dmin"].cases[0].expr
        (atom,) = self.strips.atoms
        load, depth = E_star * self.strips.load((a,)).expr(), atom.depth(Order((a,))).expr()
        least = sp.factor(least_depth * sp.powsimp(load / depth, combine="exp")).subs(r_zero, x_zero)
        place = tuple(Case(case.chain, case.expr.subs(r_zero, x_zero)) for case in ring.cases)
        return {
            "xz": _entry(self.profile, PLANE_COMPLETE["xz"], place, status=ring.status),
            "Pmin": _entry(self.profile, PLANE_COMPLETE["Pmin"], (Case((a,), least),)),
        }


LEVEL = 2 * depth_moment(sp.S.Zero).expr()
"""int 1/sqrt(a^2 - x^2) dx over the strip."""
MOMENT = 2 * depth_moment(sp.Integer(2)).expr()
"""int x^2/sqrt(a^2 - x^2) dx over the strip."""


def _strip(point: sp.Expr, half_width: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    """Numerator alpha + beta x of the pressure."""
    return P / LEVEL + P * eccentricity / MOMENT.subs(a, half_width) * point


def _inclination(half_width: sp.Expr, eccentricity: sp.Expr) -> sp.Expr:
    return 2 / (sp.pi * E_star) * LEVEL * P * eccentricity / MOMENT.subs(a, half_width)


def eccentric(profile: Profile) -> dict[str, Entry]:
    """Pressure, tilt and width of the contact on both sides of lift-off."""
    core = sp.cancel(MOMENT / (LEVEL * a))  # eccentricity at which the pressure of a strip vanishes at one edge
    share = core / a
    side, distance = sp.sign(e), sp.Abs(e)
    half = sp.factor((a - distance) / (1 - share))  # e = a - c + share c for the contact a - 2 c < x < a
    point = side * x - (a - half)
    # alpha (1 + point/c) / sqrt(c^2 - point^2)
    lifted = P / (LEVEL * half) * sp.sqrt(sp.Max(0, sp.expand(half + point))) / sp.sqrt(sp.expand(half - point))
    touching, apart = (distance, core), (core, distance)
    formulas = {
        "p": (sp.factor(_strip(x, a, e)) / sp.sqrt(a**2 - x**2), lifted),
        "phi": (sp.factor(_inclination(a, e)), side * sp.factor(_inclination(half, share * half))),
        "cw": (2 * a, 2 * half),
    }
    return {
        suffix: _entry(profile, PLANE_ECCENTRIC[suffix], (Case(touching, whole), Case(apart, part)))
        for suffix, (whole, part) in formulas.items()
    }


PHYSICS = Physics(
    "plane",
    {
        HOMOGENEOUS: Wording(
            place=8,
            title="Plane contact",
            note=r"load $P$ per length; $d$ relative to the surface at the distance $L$; formulas for $x\ge 0$",
            package="Plane contact without adhesion: rigid strips on an elastic half plane, per length of the strip",
            searched="two-dimensional line contact roller strip",
        )
    },
    lambda profile, *_: derive(profile),
    pool=STRIPS,
    contact="of a strip without adhesion, per length",
    shown={P: "1"},
    runtime=("physics.plane",),
    quantities={"plane": PLANE, "plane complete": PLANE_COMPLETE, "plane eccentric": PLANE_ECCENTRIC},
    wanted=("load", "pressure", "slope", "depth", "half_width_from_load"),
)
