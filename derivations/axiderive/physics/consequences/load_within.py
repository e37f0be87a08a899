"""The part of the load that a contact carries within a radius r, 2 pi int_0^r p s ds.

While a contact grows by da a flat punch of depth g'(a) da is added, which carries 2 E* (a - sqrt(a^2 - r^2)) g'(a) da
within r.  With u = sqrt(t^2 - r^2)

    F_r = F(r) + 2 E* int_r^a g'(t) r^2/(t + u) dt,

whose terms are positive where g' is: next to r = 0 it keeps its digits, which the load less that outside would lose.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...abel.atoms import Atom, HyperboloidAtom, PowerAtom, SphereAtom
from ...abel.form import Chain, Form, Order, insert
from ...abel.reduce import NotReducibleError, Reduced
from ...entry import Case, Entry, Quantity, Status
from ...notation import FORCE, a, d, define, r, t, u
from .. import PRESSURE
from ..medium import HOMOGENEOUS, Medium
from . import GAP, GROWTH, SHORT, Consequence, Contact, Rate, Rules

SUMMARY = "Part of the normal force that is carried within the radius r; all of it beyond the contact."

F_r = define("F_r", "F_r", FORCE, "N", "", "part of the normal force that is carried within the radius r")
OUTSIDE = sp.sqrt(a**2 - r**2)


def derive(contact: Contact, entries: Mapping[str, Entry]) -> tuple[Status, tuple[Case, ...]]:
    """Closed where the pressure is; else one regular integral in u, and what lies below a break is known already."""
    status: Status = "closed"
    cases: list[Case] = []
    for regime in entries["F"].cases:
        for chain in insert(regime.chain, r, below=a):
            form = _within(contact.reduced, Order(chain))
            if form is not None:
                cases.append(Case(chain, contact.close(form * contact.medium.force_scale)))
                continue
            status = "integral"
            cases.append(Case(chain, _integral(chain, regime, entries["d"], cases)))
    return status, tuple(cases)


def _within(reduced: Reduced, order: Order) -> Form | None:
    """int_0^a t g'(t) dt - int_r^a g'(t) sqrt(t^2 - r^2) dt, or None where no closed form is known."""
    forms = [_of_atom(atom, order) for atom in reduced.atoms]
    known = [form for form in forms if form is not None]
    return Form.total(known) if len(known) == len(forms) else None


def _of_atom(atom: Atom, order: Order) -> Form | None:
    pressure, k = atom.pressure(order, sp.S.Zero), sp.S.Zero
    if not pressure:  # nothing presses before the break, or no closed form is known
        return pressure
    sunk, force = atom.depth(order, k) or Form(), atom.force(order, k) or Form()
    if isinstance(atom, PowerAtom) and atom.b != 0:
        return force + atom.rate_moment(2, order.below(r, atom.b)) * -1 + pressure * r**2
    if isinstance(atom, PowerAtom):  # g' is a power of t
        sunk = sunk * atom.n
        return (sunk * a + sunk.times(OUTSIDE) * -1 + pressure * r**2) * (1 / (atom.n + 1))
    return force + _arc(atom, sunk) * -1 + pressure * (r**2 / 2)


def _arc(atom: Atom, sunk: Form) -> Form:
    """The integral of g' u and half of r^2 P^, by parts with 2 u = d(t u)/dt - r^2/u, u = sqrt(t^2 - r^2)."""
    if isinstance(atom, SphereAtom):
        length, sign, root = atom.R, -1, sp.sqrt(atom.R**2 - r**2)
        angle = sp.atanh(OUTSIDE / root)
    elif isinstance(atom, HyperboloidAtom):
        length, sign, root = atom.b, 1, sp.sqrt(atom.b**2 + r**2)
        angle = sp.atan(OUTSIDE / root)
    else:
        message = f"the load within a radius is not known for {atom}; state it beside the others"
        raise NotReducibleError(message)
    half = atom.c * length / 2
    ends = Form.of(OUTSIDE, sign * half) + Form.of(root * angle, -sign * half) + Form.of(angle / root, half * r**2)
    return sunk.times(OUTSIDE) * sp.S.Half + ends


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
    face = _within(reduced, Order((r, a)))
    if face is None:
        message = f"the face {reduced.atoms} has no closed load within a radius; use a sum of powers of r"
        raise NotReducibleError(message)
    gap = Form.of(sp.S.One, d) + reduced.depth(Order((a,))) * -1
    whole = face + gap * a + gap.times(OUTSIDE) * -1
    factor = sp.powsimp(sp.cancel(whole.pop(sp.S.One) / a), combine="exp")
    rest = whole + Form.of(OUTSIDE, factor)
    return sp.factor_terms(medium.force_scale * (factor * (a - OUTSIDE) + rest.expr()))


# a contact carries within r what its springs carry, less those of t = sqrt(r^2 + u^2) over u
CARRIED_BY_SPRINGS = sp.Integral(SHORT(t), (t, 0, a)) - sp.Integral(SHORT(sp.sqrt(r**2 + u**2)), (u, 0, OUTSIDE))
CARRIED = 2 * sp.pi * sp.Integral(t * PRESSURE(t), (t, 0, r))
WITHIN = "dF_r/da = 2 E* (a - sqrt(a^2 - r^2)) g'(a)"
FIXED = "dF_r/da = 2 E* (d - g(a)) (1 - a/sqrt(a^2 - r^2)) for a fixed face"
CONSEQUENCE = Consequence(
    compact=Quantity("Fr", "load_within", "Load carried within a radius", F_r, (r, a), written="F_r", place="inside",
                     row="Load within r", after="w", summary=SUMMARY),
    complete=Quantity("Fr", "load_within", "Load carried within a radius", F_r, (r, d), written="F_r", place="inside",
                      row="Load within r", after="w", summary=SUMMARY),
    definition=CARRIED,
    fixed_definition=CARRIED,
    springs=HOMOGENEOUS.force_scale * CARRIED_BY_SPRINGS,
    derive=derive,
    fixed=fixed,
    grown=Rate(HOMOGENEOUS.force_scale * (a - OUTSIDE) * GROWTH, WITHIN, ("F", "d"), start="F"),
    fixed_rate=Rate(HOMOGENEOUS.force_scale * (1 - a / OUTSIDE) * GAP, FIXED, ("F",), start="F"),
    # by parts, with the depth in the place of its rate
    rules=Rules("slope", "{force}", "{force}", HOMOGENEOUS.force_scale,
                anywhere=("inner = np.minimum(r, a)", "sunk, near = {of_a}, {of_inner}",
                          "outer = difference_root(a, inner)"),
                weight="({of_x} - near) / across(x, from_inner, inner)",
                whole="{force} + 2 * E_star * inner**2 * ((sunk - near) / (a + outer) + whole)"),
    printed=r"F_r=F_{\mathrm N}(r)+2 E^{*} r^{2} \int_{0}^{y} \frac{g'(t)\,u}{t\,(t+u)}\,\mathrm{d}u,"
    r"\qquad t=\sqrt{r^{2}+u^{2}},\quad y=\sqrt{a^{2}-r^{2}}",
)  # fmt: skip
