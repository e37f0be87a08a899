"""Torsion: a flat punch that turns without slip, and a contact whose outer ring slips (Reissner, Sagoci; Lubkin).

Under a normal load that is held the ring c < r < a slips, with the traction mu p; the disc r < c turns as a whole by
the angle beta.  The traction on the disc that goes with that of the ring, and leaves no displacement but a rotation, is
one integral over the pressure of the ring.  Unlike under a tangential force it is no difference of two pressures.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..entry import Case, Entry, Quantity, Status
from ..notation import LENGTH, NUMBER, STRESS, Dimension, E_star, R, a, c, define, mu, r, z
from ..profiles.profile import Profile
from . import DEPTH, OWN, PRESSURE, Physics, Proof, Shown, Wording, normal
from .medium import HOMOGENEOUS, Medium

GROUP = "tor"
G = define("G", "G", STRESS, "Pa", "G > 0", "shear modulus of the half-space")
twist = define("twist", r"\beta", NUMBER, "rad", "twist >= 0", "angle by which the punch turns", letter="beta")
torque = define("torque", "M", Dimension.of(1, 1), "N m", "", "torque about the axis")
full_torque = define("full_torque", r"M_{\mathrm s}", Dimension.of(1, 1), "N m", "", "torque at full slip")
shear = define("shear", r"\tau", STRESS, "Pa", "", "circumferential traction, in the direction of the rotation")
around = define("around", r"u_\varphi", LENGTH, "m", "", "circumferential displacement")
tau_tz = define("tau_tz", r"\tau_{\varphi z}", STRESS, "Pa", "", "circumferential shear stress on planes z")
tau_rt = define("tau_rt", r"\tau_{r\varphi}", STRESS, "Pa", "", "circumferential shear stress on cylinders r")
s = define("ring", "s", LENGTH, "m", "", "radius of a ring that slips")
turn = define("turn", r"\vartheta", NUMBER, "rad", "", "angle of integration over the ring that slips")

SLIPPING = {
    q.suffix: q
    for q in (
        Quantity("M", "torque", "Torque", torque, (a, c), written="M",
                 summary="Torque with a stick zone of radius c."),
        Quantity("b", "slip_angle", "Angle of rotation", twist, (a, c),
                 summary="Angle by which the indenter has turned when slip has come to the radius c."),
        Quantity("tau", "traction", "Circumferential traction", shear, (r, a, c), written=r"\tau(r)", place="inside",
                 row="Traction", summary="Circumferential traction; zero outside the contact."),
        Quantity("Ms", "full_slip_torque", "Torque at full slip", full_torque, (a,),
                 row="Full slip: torque", summary="Torque under which the whole contact slips."),
    )
}  # fmt: skip
STICKING = {
    q.suffix: q
    for q in (
        Quantity("M", "torque", "Torque", torque, (twist,), written="M",
                 summary="Torque that turns the punch by the angle beta."),
        Quantity("u", "displacement", "Circumferential displacement", around, (r, z), written="u(r)",
                 row="Displacement", summary="Circumferential displacement, below the surface too."),
        Quantity("tz", "stress", "Shear stress on planes z", tau_tz, (r, z), "tz", written=r"\tau_{\varphi z}(r)",
                 summary="Shear stresses on planes z and on cylinders r, below the surface too."),
        Quantity("rt", "stress", "Shear stress on cylinders r", tau_rt, (r, z), "rt", written=r"\tau_{r\varphi}(r)"),
    )
}  # fmt: skip
CLOSED = ("paraboloid",)


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no entries in torsion; empty if it has."""
    if profile.name in ("flat_punch", *CLOSED):
        return ""
    if profile.complete:
        return f"{profile.name} turns without slip as a flat punch does while its face is in contact: use flat_punch"
    return f"{profile.name} has no slip angle in closed form; that of a paraboloid has one"


def definitions(profile: Profile, medium: Medium) -> dict[str, sp.Expr]:
    """By the pressure of the normal contact; under the punch by sources at the complex depths z + it below its face."""
    if profile.complete:
        t = sp.Symbol("t", positive=True)
        depth = z + sp.I * t
        root = sp.sqrt(r**2 + depth**2)
        source, middle = t / ((root + depth) * root), sp.Min(r, a)
        # near the surface the source at t = r is singular
        turned, along, across = (
            sp.im(sp.Integral(own, (t, 0, middle)) + sp.Integral(own, (t, middle, a)))
            for own in (source, sp.diff(source, z), sp.diff(source, r))
        )
        unit = -4 * G * twist / sp.pi
        return {
            "M": 2 * sp.pi * sp.Integral(s**2 * 4 * G * twist * s / (sp.pi * sp.sqrt(a**2 - s**2)), (s, 0, a)),
            "u": unit / G * r * turned,
            "tz": unit * r * along,
            "rt": unit * r * across,
        }
    # in the angle with s**2 = a**2 sin**2 + c**2 cos**2 nothing is singular at the ends
    sine, length, place, step = _ring(c)
    pressed = PRESSURE(place, a)
    turned = mu / (2 * G) * sp.Integral(PRESSURE(c * sp.cosh(turn), a), (turn, 0, sp.acosh(a / c)))
    # with s**2 = c**2 + (c**2 - r**2) sinh**2
    near = sp.sqrt(c**2 - r**2)
    beside = sp.sqrt(c**2 + near**2 * sp.sinh(turn) ** 2)
    held = sp.Integral(PRESSURE(beside, a) / (beside * sp.cosh(turn)), (turn, 0, sp.asinh(length / near)))
    arm = place**2 / 2 * sp.acos(c / place) + c / 2 * length * sine
    _, _, inner, whole = _ring(sp.S.Zero)
    return {
        "M": sp.Rational(16, 3) * G * c**3 * turned + 8 * mu * sp.Integral(pressed * arm * step, (turn, 0, sp.pi / 2)),
        "b": turned,
        "tau": sp.Piecewise((2 * mu / sp.pi * r * held, r < c), (mu * PRESSURE(r, a), True)),
        "Ms": 2 * sp.pi * mu * sp.Integral(PRESSURE(inner, a) * inner**2 * whole, (turn, 0, sp.pi / 2)),
    }


def _ring(start: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
    """Sine of the angle, sqrt(a**2 - c**2), and the radius in the ring from c = `start` to a with its rate."""
    sine, length = sp.sin(turn), sp.sqrt(a**2 - start**2)
    place = sp.sqrt(start**2 + length**2 * sine**2)
    return sine, length, place, length**2 * sine * sp.cos(turn) / place


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """All entries of a profile in torsion, keyed by suffix.

    Raises
    ------
    ValueError
        If the profile has none.
    """
    if message := refusal(profile):
        raise ValueError(message)
    found = _sticking() if profile.complete else _slipping()
    defined, quantities = definitions(profile, medium), PHYSICS.table(profile)
    return {
        suffix: Entry(
            key=medium.key(profile.name, medium.group, GROUP, suffix),
            profile=profile,
            quantity=quantities[suffix],
            status=_status(cases),
            cases=cases,
            definition=defined[suffix],
            parameters=(*profile.parameters, *PHYSICS.taken(defined[suffix], medium, quantities[suffix].arguments)),
        )
        for suffix, cases in found.items()
    }


def _status(cases: tuple[Case, ...]) -> Status:
    return "integral" if any(case.expr.has(sp.Integral) for case in cases) else "closed"


def _sticking() -> dict[str, tuple[Case, ...]]:
    """In the oblate coordinates xi and eta of the circle, r**2 + z**2 - a**2 = xi**2 - eta**2 and z a = xi eta."""
    excess = r**2 + z**2 - a**2
    root = sp.sqrt(excess**2 + 4 * a**2 * z**2)
    # 2 xi**2, 2 eta**2, and 2 (a**2 + xi**2)
    outer, inner, whole = root + excess, root - excess, root + r**2 + z**2 + a**2
    unit = -4 * sp.sqrt(2) * G * twist / sp.pi
    formulas = {
        "M": sp.Rational(16, 3) * G * a**3 * twist,
        "u": 2
        * twist
        * r
        / sp.pi
        * (sp.pi / 2 - sp.atan(sp.sqrt(outer) / (sp.sqrt(2) * a)) - sp.sqrt(2) * a * sp.sqrt(outer) / whole),
        "tz": unit * a**2 * r * sp.sqrt(inner) / (whole * root),
        "rt": 2 * unit * a**3 * r**2 * sp.sqrt(outer) / (whole**2 * root),
    }
    return {suffix: (Case((), expr),) for suffix, expr in formulas.items()}


def _slipping() -> dict[str, tuple[Case, ...]]:
    """Under a paraboloid, p = 2 E* sqrt(a**2 - r**2)/(pi R)."""
    unit, m = 2 * E_star / (sp.pi * R), 1 - c**2 / a**2
    turned = mu * unit / (2 * G) * a * (sp.elliptic_k(m) - sp.elliptic_e(m))
    # the pressure of the ring integrated by parts: the integrand is the slope of a (K - E) with c
    held = sp.Integral(a * sp.elliptic_e(1 - s**2 / a**2) / (s * sp.sqrt(s**2 - r**2)), (s, c, a))
    sine, length, radius, _ = _ring(c)
    arm = radius / 2 * sp.atan(length * sine / c) + c * length * sine / (2 * radius)
    ring = 8 * mu * unit * length**3 * sp.Integral((1 - sine**2) * sine * arm, (turn, 0, sp.pi / 2))
    return {
        "M": (Case((c, a), sp.Rational(16, 3) * G * c**3 * turned + ring),),
        "b": (Case((c, a), turned),),
        "tau": (
            Case((r, c, a), 2 * mu * unit * r / sp.pi * held),
            Case((c, r, a), mu * unit * sp.sqrt(a**2 - r**2)),
        ),
        "Ms": (Case((a,), sp.pi * mu * E_star * a**4 / (4 * R)),),
    }


def proofs(profile: Profile, medium: Medium) -> dict[str, Proof]:
    """By what a contact gains that grows under the pressure E*/pi g'(a)/sqrt(a**2 - r**2), and how it begins."""
    if profile.complete:
        return {}
    growth, pressure = sp.Derivative(DEPTH(a), a), medium.modulus / sp.pi
    quarter = sp.elliptic_k(1 - c**2 / a**2) / a
    turned = mu / (2 * G) * pressure * growth * quarter
    return {
        "b": Proof(
            "d",
            (
                Shown("dbeta/da = mu E*/(2 pi G) g'(a) K(1 - c^2/a^2)/a", sp.Derivative(OWN, a) - turned),
                Shown("beta = 0 at c = a", OWN, at=(a, c)),
            ),
            c,
        ),
        "Ms": Proof(
            "d",
            (
                Shown(
                    "dM/da = pi mu E* g'(a) a^2/2", sp.Derivative(OWN, a) - sp.pi**2 / 2 * mu * pressure * growth * a**2
                ),
                Shown("M = 0 at a = 0", OWN, at=(a, sp.S.Zero)),
            ),
        ),
    }


def code(profile: Profile) -> dict[str, str]:
    """What the functions return, by quantity."""
    if profile.complete:
        return {
            "M": "16.0 / 3.0 * G * a**3 * beta",
            "u": "beta * turned_below(r, z, a)",
            "tz": "G * beta * on_planes(r, z, a)",
            "rt": "G * beta * on_cylinders(r, z, a)",
        }
    return {
        "M": "mu * E_star / R * slipping_torque(a, c)",
        "b": "mu * E_star / (np.pi * G * R) * turned(a, c)",
        "tau": "mu * E_star / R * slipping_traction(r, a, c)",
        "Ms": "np.pi / 4.0 * mu * E_star / R * a**4",
    }


PHYSICS = Physics(
    "torsion",
    {
        HOMOGENEOUS: Wording(
            place=11,
            title="Torsion",
            note=r"angle of rotation $\beta$, shear modulus $G$; stick for $r<c$, constant $F_{\mathrm N}$",
            package="Torsion of a punch that sticks, and of contacts whose outer ring slips",
            searched="torsion torque twist rotation spin Reissner Sagoci Lubkin",
        )
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    refusal=refusal,
    material=(G, mu, twist),
    contact="in torsion",
    runtime=("physics.torsion",),
    quantities={"torsion": SLIPPING, "torsion of a punch": STICKING},
    definitions=definitions,
    compared="mpmath quadrature of the pressure of the ring that slips, or of sources below the punch",
    proofs=proofs,
    code=code,
    results={"stress": "TorsionStress"},
    assumed="the normal load is held while the angle grows",
    ordered=(("c", "a", "the stick zone lies inside the contact; exchange a and c"),),
    slipped={"M": ("Ms", "torque at full slip")},
    shown={mu: "3/10", G: "2/5", twist: "1/10", z: "1/2"},
)
