"""Adhesion with a cohesive zone: a constant attraction sigma_0 in a ring around the contact (Maugis, Dugdale).

The ring a < r < c carries the line load -2 sigma_0 sqrt(c**2 - x**2), and continuity at x = a lowers the depth by
2 sigma_0 sqrt(c**2 - a**2)/E_star: the pressure is finite at the edge.  The attraction ends where the gap has reached
dgamma/sigma_0, so that the work against it is the work of separation; that equation has one c for every a, since the
gap grows with c.  For a large sigma_0 the contact is that of `adhesive` (JKR), for a small one the normal contact
under an attraction of constant sum (DMT).
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping

import sympy as sp

from ..abel.form import Chain, insert
from ..entry import COMPACT, Case, Entry, Quantity, Status
from ..notation import LENGTH, E_star, F, a, d, define, dgamma, p, r, sigma_0, t, w, wavelength
from ..profiles.profile import Profile
from . import (
    DEPTH,
    DISPLACEMENT,
    FORCE,
    OWN,
    PRESSURE,
    SHAPE,
    Physics,
    Printing,
    Proof,
    Rule,
    Shown,
    Wording,
    adhesive,
    normal,
)
from .medium import HOMOGENEOUS, Medium
from .torsion import turn

GROUP = "coh"
cohesive = define("cohesive", "c", LENGTH, "m", "c >= 0", "outer radius of the cohesive zone", letter="c")

QUANTITIES = {
    q.suffix: q
    for q in (
        Quantity("work", "work_of_separation", "Work of separation", dgamma, (a, cohesive),
                 summary="Work of separation with which the cohesive zone of a contact of radius a ends at c."),
        Quantity("c", "cohesive_radius", "Radius of the cohesive zone", cohesive, (a,), inverts="work",
                 summary="Outer radius c of the cohesive zone around a contact of radius a."),
        Quantity("d", "depth", "Indentation depth", d, (a,), written=r"d_{\mathrm{coh}}(a)",
                 summary="Indentation depth at contact radius a; negative where adhesion pulls the surface up."),
        Quantity("F", "force", "Normal force", F, (a,), written=r"F_{\mathrm{coh}}(a)",
                 summary="Normal force at contact radius a, negative in tension."),
        Quantity("p", "pressure", "Pressure", p, (r, a), written=r"p_{\mathrm{coh}}(r)", place="inside",
                 summary="Pressure, positive in compression: -sigma_0 in the cohesive zone, zero beyond."),
        Quantity("w", "displacement", "Displacement outside", w, (r, a), written=r"w_{\mathrm{coh}}(r)",
                 place="outside", row="Displacement", summary=COMPACT["w"].summary),
    )
}  # fmt: skip
ROOT, ANGLE = sp.sqrt(cohesive**2 - a**2), sp.acos(a / cohesive)
"""sqrt(c**2 - a**2), and the angle whose cosine is a/c."""
SUNK = 2 * sigma_0 / E_star * ROOT
PULLED = 2 * sigma_0 * (cohesive**2 * ANGLE + a * ROOT)
DRAWN = 2 * sigma_0 / sp.pi * sp.atan(ROOT / sp.sqrt(a**2 - r**2))
OPENED = 4 * sigma_0 / (sp.pi * E_star) * (ROOT * ANGLE - cohesive + a)
"""What the ring takes of depth, force and pressure, and what it adds to the gap at its end."""


def lifted(within: bool) -> sp.Expr:
    """What the ring takes of the displacement, at r < c or beyond."""
    inner = 4 * sigma_0 / (sp.pi * E_star) * ROOT * sp.asin(a / r)
    if within:
        m = r**2 / cohesive**2
        ring = cohesive * (sp.elliptic_e(m) - sp.elliptic_e(sp.asin(a / r), m))
    else:
        m, start = cohesive**2 / r**2, sp.asin(a / cohesive)
        first, second = sp.elliptic_k(m) - sp.elliptic_f(start, m), sp.elliptic_e(m) - sp.elliptic_e(start, m)
        ring = r * (second - (1 - m) * first)
    return inner + 4 * sigma_0 / (sp.pi * E_star) * ring


def definitions(profile: Profile, medium: Medium) -> dict[str, sp.Expr]:
    """By the load on the springs of the surface: E_star (g(a) - g(x)) and more inside, that of the ring outside."""
    unit, within = 2 * sigma_0 / E_star, sp.asin(a / r)
    gap = 2 / sp.pi * sp.Integral(DEPTH(cohesive * sp.sin(turn)) - DEPTH(a), (turn, sp.asin(a / cohesive), sp.pi / 2))
    work = sigma_0 * (gap + OPENED)
    share = sp.Symbol("share", positive=True)
    drawn = sp.Integral(ROOT / sp.sqrt(a**2 - r**2 + ROOT**2 * (1 - share**2)), (share, 0, 1))
    pressed = sp.Integral(DEPTH(a) - DEPTH(r * sp.sin(turn)), (turn, 0, within)) - unit * ROOT * within
    # x = r sin(turn), and beyond the ring x = c sin(turn)
    sine, cosine = sp.sin(turn), sp.cos(turn)
    below = sp.Integral(sp.sqrt(cohesive**2 - r**2 * sine**2), (turn, within, sp.pi / 2))
    rate = cohesive**2 * cosine**2 / sp.sqrt(r**2 - cohesive**2 * sine**2)
    beyond = sp.Integral(rate, (turn, sp.asin(a / cohesive), sp.pi / 2))
    return {
        "work": work,
        "c": sp.Eq(work, dgamma),
        "d": DEPTH(a) - SUNK,
        "F": FORCE(a) - 4 * sigma_0 * (a * ROOT + sp.Integral(sp.sqrt(cohesive**2 - t**2), (t, a, cohesive))),
        "p": PRESSURE(r, a) - 2 * sigma_0 / sp.pi * drawn,
        "w": sp.Piecewise(
            *((2 / sp.pi * (pressed - unit * ring), where) for ring, where in ((below, r < cohesive), (beyond, True)))
        ),
    }


def refusal(profile: Profile, medium: Medium = HOMOGENEOUS) -> str:
    """Why a profile has no entries with a cohesive zone; empty if it has."""
    if wavelength in profile.parameters:
        return (
            f"{profile.name} has waves, over which the definition of the gap is not compared in a minute; use adhesive"
        )
    if profile.compact:
        return ""
    return f"{profile.name} is a complete contact, at whose edge no zone of attraction ends freely; use adhesive"


def derive(
    profile: Profile, medium: Medium = HOMOGENEOUS, plain: Mapping[str, Entry] | None = None
) -> dict[str, Entry]:
    """All entries of a profile with a cohesive zone, keyed by suffix.

    Raises
    ------
    ValueError
        If there are none.
    """
    if message := refusal(profile):
        raise ValueError(message)
    plain = plain or normal.derive(profile, medium)
    work = tuple(_separated(profile, plain))
    losses = {"d": lambda _: SUNK, "F": lambda _: PULLED, "p": lambda _: DRAWN, "w": lambda x: lifted(_below(x, r))}
    found: dict[str, tuple[Status, tuple[Case, ...]]] = {
        "work": (plain["w"].status, work),
        "c": ("root", tuple(Case(case.chain, sp.Eq(case.expr, dgamma)) for case in work)),
    }
    for suffix, loss in losses.items():
        cases = (
            Case(chain, own.expr - loss(chain)) for own in plain[suffix].cases for chain in _around(profile, own.chain)
        )
        found[suffix] = plain[suffix].status, tuple(cases)
    defined = definitions(profile, medium)
    return {
        suffix: medium.entry(
            profile, GROUP, QUANTITIES[suffix], status, cases, defined[suffix],
            (*profile.parameters, *PHYSICS.taken(defined[suffix], medium, QUANTITIES[suffix].arguments)), (),
        )
        for suffix, (status, cases) in found.items()
    }  # fmt: skip


def _below(chain: Chain, place: sp.Symbol) -> bool:
    return chain.index(place) < chain.index(cohesive)


def _around(profile: Profile, chain: Chain) -> list[Chain]:
    """The orders in which the zone ends around a contact, and before the profile does."""
    end = next((high for low, high in itertools.pairwise(profile.chain) if low == a), None)
    return [*insert(chain, cohesive, above=a, below=end)]


def _separated(profile: Profile, plain: Mapping[str, Entry]) -> list[Case]:
    """sigma_0 times the gap at c, that of the normal contact and what the ring adds."""
    found = []
    for depth in plain["d"].cases:
        for chain in _around(profile, depth.chain):
            (beside,) = (
                own.expr.subs(r, cohesive)
                for own in plain["w"].cases
                if tuple(x.subs(r, cohesive) for x in own.chain) == chain
            )
            height = profile.height(chain, cohesive)
            found.append(Case(chain, sigma_0 * (height - depth.expr + beside + OPENED)))
    return found


def proofs(profile: Profile, medium: Medium) -> dict[str, Proof]:
    """The contact without adhesion less what the ring takes, and that by what it gains with c or loses with a."""
    gap = sigma_0 * (SHAPE(cohesive) - DEPTH(a) + DISPLACEMENT(cohesive, a) + OPENED)
    closes, begins = (cohesive, a), (r, a)
    rate = 4 * sigma_0 * a / (sp.pi * E_star * ROOT) * sp.asin(a / r)
    shown = Shown("work = sigma_0 times the gap at c", OWN - gap)
    # that the gap of the contact below falls with a by 2/pi arccos(a/c) g'(a) is what the law of its displacement says
    opened = 2 / sp.pi * ANGLE * sp.Derivative(SUNK, a)
    taken = 4 * sigma_0 * cohesive * (ANGLE + a / ROOT)
    drawn = 2 * sigma_0 / sp.pi * cohesive * sp.sqrt(a**2 - r**2) / (ROOT * (cohesive**2 - r**2))
    return {
        "work": Proof(
            "d",
            (
                shown,
                Shown("what the ring opens grows with a by 2/pi arccos(a/c) of what it takes of d'(a)",
                      sp.Derivative(OPENED, a) - opened),
                Shown("the ring opens nothing at c = a", OPENED, at=closes),
            ),
            beyond=cohesive,
        ),
        "c": Proof("d", (Shown("the equation of c: work = dgamma", OWN - gap),), beyond=cohesive),
        "d": Proof("d", (Shown("d = g(a) - 2 sigma_0 q/E*", OWN - DEPTH(a) + SUNK),), beyond=cohesive),
        "F": Proof(
            "F",
            (
                Shown("F = F(a) - 2 sigma_0 (c^2 phi + a q)", OWN - FORCE(a) + PULLED),
                Shown("the pull grows with c by 4 sigma_0 c (phi + a/q)", sp.Derivative(PULLED, cohesive) - taken),
                Shown("no pull at c = a", PULLED, at=closes),
            ),
            beyond=cohesive,
        ),
        "p": Proof(
            "p",
            (
                Shown("p = p(r) - 2 sigma_0/pi arctan(q/sqrt(a^2 - r^2))", OWN - PRESSURE(r, a) + DRAWN),
                Shown("the pull of a ring of radius c", sp.Derivative(DRAWN, cohesive) - drawn),
                Shown("no pull at c = a", DRAWN, at=closes),
            ),
            beyond=cohesive,
        ),
        "w": Proof(
            "w",
            (
                *(
                    Shown(f"w = w(r) - what the ring lifts, {words}", OWN - DISPLACEMENT(r, a) + lifted(inner), where)
                    for words, inner, where in (("r < c", True, (r, cohesive)), ("c < r", False, (cohesive, r)))
                ),
                Shown("the lift falls with a by 4 sigma_0 a/(pi E* q) arcsin(a/r)",
                      sp.Derivative(OWN - DISPLACEMENT(r, a), a) - rate),
                Shown("the lift at r = a is that of the depth", lifted(True) - SUNK, at=begins),
                Shown("no lift at c = a", lifted(False), at=closes),
            ),
            beyond=cohesive,
        ),
    }  # fmt: skip


def rules(medium: Medium, printing: Printing) -> dict[str, Rule]:
    """The rules in print."""
    printer = printing((r, a, cohesive))
    gap = r"\frac{2}{\pi}\int_{a}^{c}\frac{g(t)-g(a)}{\sqrt{c^{2}-t^{2}}}\,\mathrm{d}t"
    return {
        "c": Rule(rf"{gap}+{printer(OPENED)}={printer(dgamma / sigma_0)}", "solved for $c$"),
        "d": Rule(rf"{QUANTITIES['d'].left}=g(a)-{printer(SUNK)}"),
        "F": Rule(rf"{QUANTITIES['F'].left}=F_{{\mathrm N}}(a)-{printer(PULLED)}"),
        "p": Rule(rf"{QUANTITIES['p'].left}=p(r)-{printer(DRAWN)}", r"and $-\sigma_0$ for $a<r<c$", where="r<a"),
    }


PHYSICS = Physics(
    "cohesive",
    {
        HOMOGENEOUS: Wording(
            place=12,
            title="Adhesive contact with a cohesive zone",
            heading="Cohesive zone",
            package="Adhesive contact with a cohesive zone of constant attraction",
            searched="Maugis Dugdale cohesive zone adhesion JKR DMT transition",
            subject="truncated_paraboloid.coh",
            spread=(("c",), ("d",), ("F",), ("p",)),
        )
    },
    derive,
    group=GROUP,
    over=normal.PHYSICS,
    refusal=refusal,
    material=(dgamma, sigma_0),
    solved=cohesive,
    searched=tuple(own for own in adhesive.QUANTITIES.values() if own.inverts),
    contact="with a cohesive zone",
    runtime=("physics.cohesive", "physics.cohesive_states", "physics.adhesion"),
    quantities={"cohesive": QUANTITIES},
    definitions=definitions,
    compared="mpmath quadrature of the springs under contact and ring",
    proofs=proofs,
    rules=rules,
    shown={dgamma: "1/100", sigma_0: "1/10"},
    wanted=("cohesive_radius", "depth", "force", "pressure", "displacement"),
    noted=r"constant attraction $\sigma_0$ in $a<r<c$ (Maugis, Dugdale)",
    printed=False,
)
