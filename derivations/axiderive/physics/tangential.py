"""Tangential contact in the Cattaneo-Mindlin approximation, (11.67)-(11.80).

Partial slip is the difference of two normal contacts, of radii a and c, times
mu; the rule is stated once and every profile and medium follows.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ..abel.form import insert
from ..entry import Case, Entry, Quantity, Status
from ..notation import F, F_x, G_star, H_x, a, c, mu, r, tau, u_0
from ..profiles.profile import Profile
from . import DEPTH, FORCE, OWN, PRESSURE, Physics, Printing, Proof, Rule, Shown, Wording, normal
from .medium import GRADED, HOMOGENEOUS, Medium

GROUP = "tan"

QUANTITIES = {
    q.suffix: q
    for q in (
        Quantity("F", "tangential_force", "Tangential force", F_x, (a, c),
                 summary="Tangential force with a stick zone of radius c."),
        Quantity("tau", "traction", "Tangential traction", tau, (r, a, c), written=r"\tau(r)", place="inside",
                 row="Traction", summary="Tangential traction; zero outside the contact."),
        Quantity("u", "tangential_displacement", "Tangential displacement", u_0, (a, c), written="u",
                 row="Displacement", summary="Tangential displacement of the indenter with a stick zone of radius c."),
        Quantity("c", "stick_radius", "Stick radius", c, (F_x, a), inverts="F",
                 summary="Radius of the stick zone under a tangential force; NaN beyond full slip."),
        Quantity("us", "full_slip_displacement", "Displacement at the onset of full slip", u_0, (a,),
                 written=r"u_{\mathrm s}", row="Full slip: displacement",
                 summary="Tangential displacement at the onset of full slip."),
    )
}  # fmt: skip

REFERENCES = {"F": ("(11.78)",), "tau": ("(11.79)",), "u": ("(11.80)",), "c": ("(11.78)",), "us": ("(11.80)",)}


def definitions(profile: Profile, medium: Medium) -> dict[str, sp.Expr]:
    """(11.78) to (11.80): mu times the difference of two normal contacts; g and u with the ratio of the moduli."""
    ratio = mu * medium.modulus / medium.shear
    force = mu * (FORCE(a) - FORCE(c))
    return {
        "F": force,
        "tau": mu * (PRESSURE(r, a) - PRESSURE(r, c)),
        "u": ratio * (DEPTH(a) - DEPTH(c)),
        "c": sp.Eq(force, F_x),
        "us": ratio * (DEPTH(a) - DEPTH(_floor(profile))),
    }


def proofs(profile: Profile, medium: Medium) -> dict[str, Proof]:
    """The differences in every region, the inverse put in, and where full slip begins."""
    ratio = mu * medium.modulus / medium.shear
    g, F_, p = DEPTH, FORCE, PRESSURE
    lost = mu * (F_(a) - F_(c))
    sliding, stuck = (c, r), (r, c)
    return {
        "F": Proof("F", (Shown(f"F = {mu} (F(a) - F(c))", OWN - lost),), c),
        "u": Proof("d", (Shown(f"u = {ratio} (d(a) - d(c))", OWN - ratio * (g(a) - g(c))),), c),
        "tau": Proof(
            "p",
            (
                Shown("tau = mu p(r; a) for c < r < a", OWN - mu * p(r, a), sliding),
                Shown("tau = mu (p(r; a) - p(r; c)) for r < c", OWN - mu * (p(r, a) - p(r, c)), stuck),
                Shown("tau is continuous at r = c", OWN - mu * p(r, a), at=(c, r)),
            ),
            c,
        ),
        "c": Proof("F", (Shown("c(F(a), F_x = mu (F(a) - F(c))) = c", OWN - c, given={F_x: lost}),), c),
        "us": Proof(
            "d",
            (
                Shown(f"u at full slip = {ratio} g(a)", OWN - ratio * g(a)),
                Shown("g -> 0 where the contact begins", g(a), at=(a, _floor(profile))),
            ),
        ),
    }


def rules(medium: Medium, printing: Printing) -> dict[str, Rule]:
    """The rules in print."""
    ratio = printing()(mu * medium.modulus / medium.shear)
    return {
        "F": Rule(r"F_x=\mu\,\bigl[F_{\mathrm N}(a)-F_{\mathrm N}(c)\bigr]"),
        "tau": Rule(r"\tau(r)=\mu\,\bigl[p(r;a)-p(r;c)\bigr]", "with $p(r;c)=0$ for $r>c$"),
        "u": Rule(rf"u={ratio}\,\bigl[g(a)-g(c)\bigr]"),
        "c": Rule(r"F_{\mathrm N}(c)=F_{\mathrm N}(a)-\frac{F_x}{\mu}", "solved for $c$"),
        "us": Rule(rf"u_{{\mathrm s}}={ratio}\,g(a)"),
    }


def _floor(profile: Profile) -> sp.Expr:
    """The least radius of the contact and of the zone of stick."""
    return profile.breaks[0] if profile.truncated else sp.S.Zero


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no tangential entries; empty if it has."""
    if profile.compact:
        return ""
    return f"{profile.name} is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F"


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """All tangential entries of a profile with a compact contact, keyed by suffix.

    They rest on the normal contact `plain` where it is known already.

    Raises
    ------
    ValueError
        If the contact is complete: the stick zone then covers it until it slips as a whole.
    """
    if message := refusal(profile):
        raise ValueError(message)
    plain = plain or normal.derive(profile, medium)
    ratio = mu * medium.modulus / medium.shear
    force, depth, pressure = plain["F"], plain["d"], plain["p"]
    partial = _pairs(force)
    slip = tuple(Case(chain, mu * (outer - inner)) for chain, outer, inner in partial)
    sliding = tuple(Case(chain, ratio * (outer - inner)) for chain, outer, inner in _pairs(depth))
    onset = tuple(Case(case.chain, ratio * case.expr) for case in depth.cases)
    equations = tuple(Case(case.chain, sp.Eq(case.expr, F_x)) for case in slip)
    inverse = _closed_stick_radius(plain["aF"], force)
    out: dict[str, tuple[Status, tuple[Case, ...]]] = {
        "F": (force.status, slip),
        "tau": (pressure.status, _traction(pressure)),
        "u": (depth.status, sliding),
        "c": ("closed" if inverse else "root", inverse or equations),
        "us": (depth.status, onset),
    }
    defined = definitions(profile, medium)
    return {
        suffix: medium.entry(
            profile, GROUP, QUANTITIES[suffix], status, cases, defined[suffix],
            (*profile.parameters, *PHYSICS.taken(defined[suffix], medium)), REFERENCES[suffix],
        )
        for suffix, (status, cases) in out.items()
    }  # fmt: skip


def _pairs(entry: Entry) -> list[tuple[tuple[sp.Expr, ...], sp.Expr, sp.Expr]]:
    """(chain, value at a, value at c) for every place of c below a."""
    truncated = entry.profile.truncated
    out = []
    for case in entry.cases:
        above = entry.profile.breaks[0] if truncated else None
        for chain in insert(case.chain, c, above=above, below=a):
            own = next(other for other in entry.cases if _same_order(other.chain, chain))
            out.append((chain, case.expr, own.expr.subs(a, c)))
    return out


def _same_order(chain: tuple[sp.Expr, ...], both: tuple[sp.Expr, ...]) -> bool:
    """Whether c stands among the other lengths of `both` as a stands in `chain`."""
    without = tuple(length for length in both if length != a)
    return chain == tuple(a if length == c else length for length in without)


def _traction(pressure: Entry) -> tuple[Case, ...]:
    """(11.79): mu p(r; a) in the slip annulus, less mu p(r; c) in the stick zone."""
    out = []
    truncated = pressure.profile.truncated
    for case in pressure.cases:
        above = pressure.profile.breaks[0] if truncated else None
        for chain in insert(case.chain, c, above=above, below=a):
            if chain.index(c) < chain.index(r):
                out.append(Case(chain, mu * case.expr))
                continue
            own = next(other for other in pressure.cases if _same_order(other.chain, chain))
            out.append(Case(chain, mu * (case.expr - own.expr.subs(a, c))))
    return tuple(out)


def _closed_stick_radius(radius: Entry, force: Entry) -> tuple[Case, ...] | None:
    """c = a(F(a) - F_x/mu) where the radius is a closed function of the force and has a single regime."""
    if radius.status != "closed" or len(radius.cases) != 1:
        return None
    (own,), (whole,) = radius.cases, force.cases
    floor = radius.profile.breaks[:1] if radius.profile.truncated else ()
    power = own.expr.as_independent(F, as_Add=False)[1]
    base, exponent = power.as_base_exp()
    if not (base / F).has(F) and not exponent.has(F):
        expr = a * (1 - F_x / (mu * whole.expr)) ** exponent
    else:
        expr = own.expr.subs(F, whole.expr - F_x / mu)
    return (Case((*floor, c, a), expr),)


SPREAD = (("F",), ("c",), ("tau",), ("u", "us"))
PHYSICS = Physics(
    "tangential",
    {
        HOMOGENEOUS: Wording(
            place=3,
            title="Tangential contact with partial slip",
            heading="Tangential contact",
            note=r"Cattaneo--Mindlin approximation, coefficient of friction $\mu$, stick for $r<c$, constant "
            r"$F_{\mathrm N}$",
            package="Tangential contact with friction, with a zone of stick",
            searched="friction partial slip Cattaneo Mindlin Ciavarella Jäger traction",
            button="friction",
            by_rule=("F", "u", "us", "tau"),
            subject="truncated_paraboloid.tan",
            spread=SPREAD,
        ),
        GRADED: Wording(
            place=6,
            title="Tangential contact, graded half-space",
            note=r"$c_{\mathrm T}(x)=H_x|x|^k$",
            package="Tangential contact with friction on a power-law graded half-space",
            searched="FGM functionally graded gradient friction partial slip Cattaneo Mindlin",
            by_rule=("F", "u", "us", "tau", "c"),
            subject="paraboloid.fgm.tan",
            spread=SPREAD,
        ),
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    beside=True,
    refusal=refusal,
    shear=True,
    material=(mu,),
    contact="under a tangential load",
    shown={mu: "3/10", G_star: "4/5", H_x: "4/5"},
    runtime=("physics.slip",),
    assumed="Cattaneo-Mindlin approximation",
    ordered=(
        ("c", "a", "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load"),
    ),
    quantities={"tangential": QUANTITIES},
    wanted=("depth", "force", "tangential_force", "traction", "stick_radius"),
    definitions=definitions,
    slipped={"F": ("plain.F", "mu F"), "u": ("us", "displacement at full slip")},
    compared="mu times the difference of two normal contacts by mpmath quadrature, (11.78) to (11.80)",
    proofs=proofs,
    rules=rules,
    noted=r"constant $F_{\mathrm N}$; the contact sticks for $r<c$ and slips outside",
)
