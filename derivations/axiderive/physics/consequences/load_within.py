"""The part of the load that a contact carries within a radius r, 2 pi int_0^r p s ds.

While a contact grows by da a flat punch of depth g'(a) da is added, which carries 2 E* (a - sqrt(a^2 - r^2)) g'(a) da
within r.  With u = sqrt(t^2 - r^2)

    F_r = F(r) + 2 E* int_r^a g'(t) r^2/(t + u) dt,

whose terms are positive where g' is: next to r = 0 it keeps its digits, which the load less that outside would lose.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...abel.form import Chain, Form, Order, insert
from ...abel.reduce import NotReducibleError, Reduced
from ...entry import Case, Entry, Quantity, Status
from ...notation import F_r, a, d, p, r, t, u
from ..medium import HOMOGENEOUS, Medium
from . import GAP, GROWTH, Consequence, Contact, Rate, Rules

SUMMARY = "Part of the normal force that is carried within the radius r; all of it beyond the contact."

OUTSIDE = sp.sqrt(a**2 - r**2)


def derive(contact: Contact, entries: Mapping[str, Entry]) -> tuple[Status, tuple[Case, ...]]:
    """Closed where the pressure is; else one regular integral in u, and what lies below a break is known already."""
    status: Status = "closed"
    cases: list[Case] = []
    for regime in entries["F"].cases:
        for chain in insert(regime.chain, r, below=a):
            form = contact.reduced.within(Order(chain))
            if form is not None:
                cases.append(Case(chain, contact.close(form * contact.medium.force_scale)))
                continue
            status = "integral"
            cases.append(Case(chain, _integral(chain, regime, entries["d"], cases)))
    return status, tuple(cases)


def _integral(chain: Chain, regime: Case, sunk: Entry, earlier: list[Case]) -> sp.Expr:
    crossed = [b for b in sunk.profile.breaks if chain.index(r) < chain.index(b) < chain.index(a)]
    lower, known = sp.S.Zero, regime.expr.subs(a, r)
    if crossed:
        b = crossed[-1]
        lower = sp.sqrt(b**2 - r**2)
        inner = [case.expr for case in earlier if case.chain.index(r) < case.chain.index(a) < case.chain.index(b)]
        known = inner[0].subs(a, b) if inner else sp.S.Zero  # nothing presses within a flat face alone
    radius = sp.sqrt(r**2 + u**2)
    depth = next(case.expr for case in sunk.cases if case.chain == regime.chain)
    slope = sp.diff(depth, a).subs(a, radius)
    integral = sp.Integral(slope * u / (radius * (radius + u)), (u, lower, OUTSIDE))
    return known + HOMOGENEOUS.force_scale * r**2 * integral


def fixed(reduced: Reduced, medium: Medium) -> sp.Expr:
    """The punch of depth d - g(a) and the face, with a - sqrt(a^2 - r^2) as one factor, as it vanishes on the axis."""
    face = reduced.within(Order((r, a)))
    if face is None:
        message = f"the face {reduced.atoms} has no closed load within a radius; use a sum of powers of r"
        raise NotReducibleError(message)
    gap = Form.of(sp.S.One, d) + reduced.depth(Order((a,))) * -1
    whole = face + gap * a + gap.times(OUTSIDE) * -1
    factor = sp.powsimp(sp.cancel(whole.pop(sp.S.One) / a), combine="exp")
    rest = whole + Form.of(OUTSIDE, factor)
    return sp.factor_terms(medium.force_scale * (factor * (a - OUTSIDE) + rest.expr()))


CARRIED = 2 * sp.pi * sp.Integral(t * sp.Function(p.name)(t), (t, 0, r))
WITHIN = "dF_r/da = 2 E* (a - sqrt(a^2 - r^2)) g'(a)"
FIXED = "dF_r/da = 2 E* (d - g(a)) (1 - a/sqrt(a^2 - r^2)) for a fixed face"
CONSEQUENCE = Consequence(
    compact=Quantity("Fr", "load_within", "Load carried within a radius", F_r, (r, a), written="F_r", place="inside",
                     row="Load within r", after="w", summary=SUMMARY),
    complete=Quantity("Fr", "load_within", "Load carried within a radius", F_r, (r, d), written="F_r", place="inside",
                      row="Load within r", after="w", summary=SUMMARY),
    definition=CARRIED,
    fixed_definition=CARRIED,
    derive=derive,
    fixed=fixed,
    grown=Rate(HOMOGENEOUS.force_scale * (a - OUTSIDE) * GROWTH, WITHIN, ("F", "d"), start="F"),
    fixed_rate=Rate(HOMOGENEOUS.force_scale * (1 - a / OUTSIDE) * GAP, FIXED, ("F",), start="F"),
    rules=Rules("slope", "{force}", "{force}", HOMOGENEOUS.force_scale),
    printed=r"F_r=F_{\mathrm N}(r)+2 E^{*} r^{2} \int_{0}^{y} \frac{g'(t)\,u}{t\,(t+u)}\,\mathrm{d}u,"
    r"\qquad t=\sqrt{r^{2}+u^{2}},\quad y=\sqrt{a^{2}-r^{2}}",
)  # fmt: skip
