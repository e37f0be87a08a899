"""Torsion: a flat punch that turns without slip, and a contact whose outer ring slips (Reissner, Sagoci; Lubkin).

Under a normal load that is held the ring c < r < a slips, with the traction mu p; the disc r < c turns as a whole by
the angle beta.  The traction on the disc that goes with that of the ring, and leaves no displacement but a rotation, is
one integral over the pressure of the ring.  Unlike under a tangential force it is no difference of two pressures.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..entry import Case, Entry, Quantity, Status
from ..notation import LENGTH, NUMBER, STRESS, Dimension, E_star, a, c, define, mu, r, tau, z
from ..profiles.profile import Profile
from . import DEPTH, OWN, PRESSURE, Physics, Proof, Shown, Wording, normal
from .medium import HOMOGENEOUS, Medium

GROUP = "tor"
G = define("G", "G", STRESS, "Pa", "G > 0", "shear modulus of the half-space")
twist = define("twist", r"\beta", NUMBER, "rad", "twist >= 0", "angle by which the punch turns", letter="beta")
torque = define("torque", "M", Dimension.of(1, 1), "N m", "", "torque about the axis")
full_torque = define("full_torque", r"M_{\mathrm s}", Dimension.of(1, 1), "N m", "", "torque at full slip")
around = define("around", "u_t", LENGTH, "m", "", "circumferential displacement")
tau_tz = define("shear_tz", r"\tau_{tz}", STRESS, "Pa", "", "circumferential shear stress on planes z")
tau_rt = define("shear_rt", r"\tau_{rt}", STRESS, "Pa", "", "circumferential shear stress on cylinders r")
s = define("ring", "s", LENGTH, "m", "", "radius of a ring")
turn = define("turn", r"\vartheta", NUMBER, "rad", "", "angle of integration over the ring that slips")

SLIPPING = {
    q.suffix: q
    for q in (
        Quantity("M", "torque", "Torque", torque, (a, c), summary="Torque with a stick zone of radius c."),
        Quantity("b", "slip_angle", "Angle of rotation", twist, (a, c),
                 summary="Angle by which the indenter has turned when slip has come to the radius c."),
        Quantity("tau", "traction", "Circumferential traction", tau, (r, a, c), written=r"\tau(r)", place="inside",
                 row="Traction", summary="Circumferential traction; zero outside the contact."),
        Quantity("Ms", "full_slip_torque", "Torque at full slip", full_torque, (a,),
                 row="Full slip: torque", summary="Torque under which the whole contact slips."),
    )
}  # fmt: skip
STICKING = {
    q.suffix: q
    for q in (
        Quantity("M", "torque", "Torque", torque, (twist,), summary="Torque that turns the punch by the angle beta."),
        Quantity("ut", "displacement", "Circumferential displacement", around, (r, z),
                 row="Displacement", summary="Circumferential displacement, below the surface too."),
        Quantity("tz", "stress", "Shear stress on planes z", tau_tz, (r, z), "tz",
                 summary="Shear stresses on planes z and on cylinders r, below the surface too."),
        Quantity("rt", "stress", "Shear stress on cylinders r", tau_rt, (r, z), "rt"),
    )
}  # fmt: skip


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no entries in torsion; empty if it has."""
    (face, *others) = (piece.expr for piece in profile.pieces)
    if face == 0 and profile.complete:
        return ""
    if profile.complete:
        return f"{profile.name} turns without slip as a flat punch does while its face is in contact: use flat_punch"
    if not others and not (face / r**2).has(r):
        return ""
    return f"{profile.name} has no torque that is one integral of known functions; a paraboloid has one, use paraboloid"


def definitions(profile: Profile, medium: Medium) -> dict[str, sp.Expr]:
    """By the pressure of the normal contact; under the punch by sources at the complex depths z + it below its face."""
    if profile.complete:
        return _below_the_face()
    # in the angle with s**2 = a**2 sin**2 + c**2 cos**2 nothing is singular at the ends
    sine, length, place, step = _ring(c)
    pressed = PRESSURE(place, a)
    turned = mu / (2 * G) * sp.Integral(PRESSURE(c * sp.cosh(turn), a), (turn, 0, sp.acosh(a / c)))
    # with s**2 = c**2 + (c**2 - r**2) sinh**2
    near = sp.sqrt(c**2 - r**2)
    beside = sp.sqrt(c**2 + near**2 * sp.sinh(turn) ** 2)
    held = sp.Integral(PRESSURE(beside, a) / (beside * sp.cosh(turn)), (turn, 0, sp.asinh(length / near)))
    arm = place**2 / 2 * sp.acos(c / place) + c / 2 * length * sine
    moment = PRESSURE(a * sine, a) * sine**2 * sp.cos(turn)
    return {
        "M": sp.Rational(16, 3) * G * c**3 * turned + 8 * mu * sp.Integral(pressed * arm * step, (turn, 0, sp.pi / 2)),
        "b": turned,
        "tau": sp.Piecewise((2 * mu / sp.pi * r * held, r < c), (mu * PRESSURE(r, a), True)),
        "Ms": 2 * sp.pi * mu * a**3 * sp.Integral(moment, (turn, 0, sp.pi / 2)),
    }


def _below_the_face() -> dict[str, sp.Expr]:
    """Of sources X_1 = r/(q rho), rho**2 = r**2 + (z + i t)**2, q = rho + z + i t, and of their slopes."""
    t = sp.Symbol("t", positive=True)
    depth, middle = z + sp.I * t, sp.Min(r, a)
    root = sp.sqrt(r**2 + depth**2)
    q = root + depth
    # near the surface the source at t = r is singular
    turned, along, across = (
        sp.im(sp.Integral(own, (t, 0, middle)) + sp.Integral(own, (t, middle, a)))
        for own in (t / (q * root), t / root**3, t * (root + q) / (q**2 * root**3))
    )
    unit = 4 * twist / sp.pi
    return {
        "M": 2 * sp.pi * sp.Integral(s**2 * _face_traction(), (s, 0, a)),
        "ut": -unit * r * turned,
        "tz": unit * G * r * along,
        "rt": unit * G * r**2 * across,
    }


def _face_traction() -> sp.Expr:
    """Of the face of a punch on the half-space at the radius s, against which it turns."""
    return 4 * G * twist * s / (sp.pi * sp.sqrt(a**2 - s**2))


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
    found = _sticking() if profile.complete else _slipping((plain or normal.derive(profile, medium))["p"])
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
    turned = sp.asin(sp.sqrt(2) * a / sp.sqrt(whole)) - sp.sqrt(2) * a * sp.sqrt(outer) / whole
    formulas = {
        "M": sp.Rational(16, 3) * G * a**3 * twist,
        "ut": 2 * twist * r / sp.pi * turned,
        "tz": unit * a**2 * r * sp.sqrt(inner) / (whole * root),
        "rt": 2 * unit * a**3 * r**2 * sp.sqrt(outer) / (whole**2 * root),
    }
    return {suffix: (Case((a,), expr),) for suffix, expr in formulas.items()}


def _slipping(pressure: Entry) -> dict[str, tuple[Case, ...]]:
    """Under a paraboloid, whose pressure is a multiple of sqrt(a**2 - r**2)."""
    (case,) = pressure.cases
    unit, m = case.expr / sp.sqrt(a**2 - r**2), 1 - c**2 / a**2
    turned = mu * unit / (2 * G) * a * (sp.elliptic_k(m) - sp.elliptic_e(m))
    # the pressure of the ring integrated by parts: the integrand is the slope of a (K - E) with c
    held = sp.Integral(a * sp.elliptic_e(1 - s**2 / a**2) / (s * sp.sqrt(s**2 - r**2)), (s, c, a))
    sine, length, radius, _ = _ring(c)
    arm = radius / 2 * sp.atan(length * sine / c) + c * length * sine / (2 * radius)
    ring = 8 * mu * unit * length**3 * sp.Integral((1 - sine**2) * sine * arm, (turn, 0, sp.pi / 2))
    return {
        "M": (Case((c, a), sp.Rational(16, 3) * G * c**3 * turned + ring),),
        "b": (Case((c, a), turned),),
        "tau": (Case((r, c, a), 2 * mu * unit * r / sp.pi * held), Case((c, r, a), mu * case.expr)),
        "Ms": (Case((a,), sp.pi**2 / 8 * mu * unit * a**4),),
    }


def proofs(profile: Profile, medium: Medium) -> dict[str, Proof]:
    """By what a contact gains with its radius and how it begins: rings of slip, or sources below a punch."""
    if profile.complete:
        return _proofs_of_punch()
    growth, pressure = sp.Derivative(DEPTH(a), a), medium.modulus / sp.pi
    turned = mu / (2 * G) * pressure * growth * sp.elliptic_k(1 - c**2 / a**2) / a
    full = sp.pi**2 / 2 * mu * pressure * growth * a**2
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
                Shown("dM/da = pi mu E* g'(a) a^2/2", sp.Derivative(OWN, a) - full),
                Shown("M = 0 at a = 0", OWN, at=(a, sp.S.Zero)),
            ),
        ),
    }


def _proofs_of_punch() -> dict[str, Proof]:
    """Sources below the face, their stresses by Hooke's law, and what is known on the surface."""
    x, y = sp.Symbol("xi", positive=True), sp.Symbol("share", positive=True)
    size, wide, side = x**2 + a**2 * y**2, sp.sqrt(x**2 + a**2), sp.sqrt(1 - y**2)
    # the point at which sqrt(r**2 + (z + i a)**2) = xi + i a share; on the disc xi = 0, beside it share = 0
    point, disc, beside = {r: wide * side, z: x * y}, {r: a * side, z: sp.S.Zero}, {r: wide, z: sp.S.Zero}

    def held(own: sp.Expr) -> sp.Expr:
        """The rate with a where the point stands still."""
        moved = y * sp.Derivative(own, y) - x * sp.Derivative(own, x)
        return sp.Derivative(own, a) + a * (1 - y**2) / size * moved

    def sinking(own: sp.Expr) -> sp.Expr:
        """The rate with z."""
        return (y * wide**2 * sp.Derivative(own, x) + x * side**2 * sp.Derivative(own, y)) / size

    def receding(own: sp.Expr) -> sp.Expr:
        """The rate with r."""
        return point[r] / size * (x * sp.Derivative(own, x) - y * sp.Derivative(own, y))

    source = 4 * twist / sp.pi * a**2 * x * side / (wide * size)
    gained = {
        "ut": (source, "4 beta/pi a (-Im X_1)"),
        "tz": (G * sinking(source), "G d/dz of that of u_t"),
        "rt": (G * (receding(source) - source / point[r]), "G r d/dr of 1/r times that of u_t"),
    }
    inside = ((y, 1),)
    stands = [
        Shown(f"{name} stands still", held(place), known=inside) for name, place in (("r", point[r]), ("z", point[z]))
    ]
    traction, ratio = _face_traction(), a / wide
    found = 2 * twist / sp.pi * point[r] * (sp.asin(ratio) - ratio * x / wide)
    surface = {
        "ut": [
            Shown("u_t = 2 beta r/pi (asin(a/w) - a xi/w^2), w^2 = a^2 + xi^2", OWN - found, given=point, known=inside),
            Shown("u_t = beta r on the disc", found.subs(x, 0) - twist * disc[r], known=inside),
        ],
        "tz": [
            Shown("tau = 4 G beta r/(pi sqrt(a^2 - r^2))", OWN + traction.subs(s, disc[r]), given=disc, known=inside),
            Shown("no traction beside the disc", OWN, given=beside, known=((x,),)),
        ],
        "rt": [],
    }
    carried = -8 * G * twist * (a**2 * sp.sqrt(a**2 - s**2) - sp.sqrt(a**2 - s**2) ** 3 / 3)
    moment = sp.diff(carried, s) - 2 * sp.pi * s**2 * traction
    shown = {
        suffix: Proof(
            "F",
            (
                *stands,
                Shown(f"d{suffix}/da = {words}", held(OWN) - rate, given=point, known=inside),
                Shown(f"{suffix} -> 0 as a -> 0", OWN, at=(a, sp.S.Zero), given=point, known=inside),
                *surface[suffix],
            ),
        )
        for suffix, (rate, words) in gained.items()
    }
    total = Shown("M = its increment from 0 to a", OWN - carried.subs(s, a) + carried.subs(s, 0))
    slope = Shown("d/ds of the antiderivative = 2 pi s^2 tau(s)", moment, known=((s, a),))
    return {**shown, "M": Proof("F", (slope, total))}


def code(profile: Profile) -> dict[str, str]:
    """What the functions return, by quantity."""
    if profile.complete:
        return {
            "M": "16.0 / 3.0 * G * a**3 * beta",
            "ut": "beta * turned_below(r, z, a)",
            "tz": "G * beta * on_planes(r, z, a)",
            "rt": "G * beta * on_cylinders(r, z, a)",
        }
    (face,) = (piece.expr for piece in profile.pieces)
    above, below = (part.as_ordered_factors() for part in (mu * E_star * 2 * face / r**2).as_numer_denom())
    unit = " / ".join([" * ".join(map(str, above)), *map(str, below)])
    return {
        "M": f"{unit} * slipping_torque(a, c)",
        "b": f"{unit} / (np.pi * G) * turned(a, c)",
        "tau": f"{unit} * slipping_traction(r, a, c)",
        "Ms": f"np.pi / 4.0 * {unit} * a**4",
    }


PHYSICS = Physics(
    "torsion",
    {
        HOMOGENEOUS: Wording(
            place=11,
            title="Torsion",
            note=r"angle of rotation $\beta$, shear modulus $G$; stick for $r<c$, constant $F_{\mathrm N}$",
            package="Torsion of a punch that sticks, and of a contact whose outer ring slips",
            searched="torsion torque twist rotation spin Reissner Sagoci Lubkin",
        )
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    refusal=refusal,
    material=(G, mu, twist),
    contact="in torsion",
    wanted=("torque", "slip_angle", "traction", "displacement"),
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
