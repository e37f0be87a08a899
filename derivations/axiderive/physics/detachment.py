"""Adhesion under a face with a fixed edge: the contact holds until its edge peels off.

With the edge in contact the solution is that of the contact without adhesion,
in tension too.  The edge term of the pressure, modulus * w1D(a) * (a^2 -
r^2)^((k-1)/2)/pi, is that of a flat punch moved by w1D(a) = d - g(a); the edge
peels where it reaches the retraction of Hess, w1D(a) = -Dl(a) (Kendall 1971
for the flat punch).  Under a flat or concave face g and -Dl fall with the
radius, so that a smaller contact needs a greater depth and a greater force:
what begins at the edge runs through, under force control and depth control alike.
Under a convex face it does not: the contact goes on as that of the unbounded
profile, whose radius it reaches or leaves at the edge.
"""

from __future__ import annotations

import sympy as sp

from ..entry import Case, Entry, Quantity
from ..notation import F, a, d, dgamma, retraction
from ..profiles.profile import Profile
from . import complete
from .medium import HOMOGENEOUS, Medium

GROUP = "adh"
REFERENCES = ("(11.31)",), ("(11.64)", "(11.66)")
"""Of the homogeneous and of the graded half-space."""
QUANTITIES = {
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


def derive(profile: Profile, medium: Medium = HOMOGENEOUS) -> dict[str, Entry]:
    """Retraction at the edge, force and depth at which it peels off, keyed by suffix."""
    shift = medium.retraction()
    level = complete.edge_depth(profile, medium) - shift
    (force,) = complete.derive(profile, medium)["F"].cases
    w1D = sp.Function("w1D")
    balance = sp.Eq(2 * sp.pi * a * dgamma, medium.modulus * a**medium.k * retraction**2)
    return {
        "Dl": _entry(profile, medium, "Dl", shift, balance),
        "Fc": _entry(profile, medium, "Fc", _tidy(force.expr, level), sp.Eq(sp.Function("F")(w1D(a)), F)),
        "dc": _entry(profile, medium, "dc", level, sp.Eq(w1D(a), -retraction)),
    }


def _tidy(force: sp.Expr, level: sp.Expr) -> sp.Expr:
    """The force is linear in the depth: its constant part and its slope put together again."""
    slope = sp.diff(force, d)
    constant = sp.powsimp(sp.factor(sp.expand(force - slope * d) + sp.expand(slope * _without_root(level))))
    return constant + sp.powsimp(slope * (level - _without_root(level)))


def _without_root(level: sp.Expr) -> sp.Expr:
    return level.subs(dgamma, 0)


def _entry(profile: Profile, medium: Medium, suffix: str, expr: sp.Expr, definition: sp.Expr) -> Entry:
    parameters = ((a,) if suffix == "Dl" else profile.parameters) + (*medium.moduli, dgamma)
    cases, references = (Case((a,), expr),), REFERENCES[medium.graded]
    return medium.entry(profile, GROUP, QUANTITIES[suffix], "closed", cases, definition, parameters, references)
