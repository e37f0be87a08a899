"""Rules for complete contact: the edge is fixed, w1D = d - g does not vanish there.

All integrals are taken over the radius with the face held fixed, -C r**n for
a concave one; C = h/a**n is put in afterwards.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ...abel.form import Chain, insert
from ...entry import Case, Entry
from ...notation import C, F, P, a, c, d, r, r_zero, x, x_zero
from ...physics.consequences import CONSEQUENCES, GAP, Consequence
from ...physics.medium import HOMOGENEOUS, Medium
from ...physics.normal import QUANTITIES, derive
from ...profiles.profile import Piece, Profile
from ..algebra.domain import Domain
from ..algebra.functions import canonical, normal, require_analytic
from ..algebra.identity import at
from ..statement import closed, require_regions, require_zero
from . import rings
from .compact import Compact

INSIDE, OUTSIDE = (r, a), (a, r)


class Complete:
    """The entries of one profile, and the same face as an unbounded profile in compact contact."""

    def __init__(
        self, profile: Profile, entries: dict[str, Entry], medium: Medium = HOMOGENEOUS, bounds: tuple[Chain, ...] = ()
    ) -> None:
        self.profile, self.entries, self.medium = profile, entries, medium
        (piece,) = profile.pieces
        self.concave = piece.expr.has(a)
        self.coefficient = -piece.expr.subs(r, 1) if self.concave else C
        face = C * r ** self._exponent(piece.expr) if self.concave else piece.expr
        geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
        self.unbounded = replace(profile, contact="compact", parameters=geometry, pieces=(Piece(None, face),))
        self.compact = Compact(self.unbounded, derive(self.unbounded, medium), medium, bounds)
        self.domain = self.compact.domain
        depth = self.compact.depth_of((a,))
        self.gap = d + depth if self.concave else d - depth
        self._face_steps: list[str] | None = None

    @staticmethod
    def _exponent(face: sp.Expr) -> sp.Expr:
        return normal(r * sp.diff(face, r) / face, Domain((r, a)))

    def face(self) -> list[str]:
        """The depth g of the unbounded face C r^n or f(r); a concave face has -g."""
        if self._face_steps is None:
            steps = self.compact.depth()
            if self.concave:
                (piece,), (fixed,) = self.profile.pieces, self.unbounded.pieces
                gap = fixed.expr.subs(C, self.coefficient) + piece.expr
                steps = [require_zero(gap, self.domain((r, a)), "the face is -C r^n"), *steps]
            self._face_steps = steps
        return self._face_steps

    def _fixed(self, suffix: str) -> tuple[sp.Expr, list[str]]:
        """The formula of complete contact for a fixed face, and that the entry gives it with C = h/a^n."""
        entry = closed(self.entries[suffix])
        (fixed,) = entry.fixed_face
        before, after = self.regions(suffix)
        require_regions(entry, before + after)
        steps, domain = self.face(), self.domain(self._region(suffix))
        require_analytic(fixed.expr, domain)
        for case in (case for case in entry.cases if case.chain in after):
            gap = fixed.expr.subs(C, self.coefficient) - case.expr
            steps = [*steps, require_zero(gap, domain, f"{suffix} is the formula of the fixed face")]
        return fixed.expr, steps + self._partial(suffix, [case for case in entry.cases if case.chain in before])

    def _region(self, suffix: str) -> Chain:
        """Where the formula of complete contact holds; what is none of its own quantities is of the whole contact."""
        own = QUANTITIES["complete"].get(suffix)
        place = own.place if own else ""
        return {"inside": INSIDE, "outside": OUTSIDE, "": (a,)}[place]

    def regions(self, suffix: str) -> tuple[tuple[Chain, ...], tuple[Chain, ...]]:
        """Before the edge is reached and after: its radius, or its force, is the smaller one; r may be anywhere."""
        own = self._region(suffix)
        if self.concave or self.profile.pieces[0].expr == 0:
            return (), (own,)
        if suffix == "dF":
            reached = self.compact.entry("F").cases[0].expr
            return ((F, reached),), ((reached, F),)
        radius = self.compact.entry("ad").cases[0].expr
        inner = (r,) if own == INSIDE else ()
        before, after = (*inner, radius, a), (*inner, a, radius)
        if own != OUTSIDE:
            return (before,), (after,)
        return tuple(insert(before, r, above=radius)), tuple(insert(after, r, above=a))

    # the quantities

    def force(self) -> list[str]:
        """With the face held fixed dF/da = 2 H a^k (d - g(a)), for k = 0 with E* for H, and F -> 0 as a -> 0."""
        expr, steps = self._fixed("F")
        domain, k = self.domain((a,)), self.medium.k
        slope = self.medium.force_scale * a**k * self.gap
        rule = "2 E*" if k == 0 else "2 H a^k"
        steps += [require_zero(sp.diff(expr, a) - slope, domain, f"dF/da = {rule} (d - g(a)) for a fixed face")]
        return [*steps, require_zero(at(expr, a, sp.S.Zero), domain.at(a, sp.S.Zero), "F -> 0 as a -> 0")]

    def pressure(self) -> list[str]:
        """p without its edge term grows with a by the pressure of a flat punch times g'(a), from zero at a = r."""
        expr, steps = self._fixed("p")
        domain, unit = self.domain((r, a)), self.medium.punch_pressure()
        rest = normal(canonical(expr - unit * self.gap, domain), domain)
        slope = unit * sp.diff(-self.gap, a)
        rule = "E*/(pi sqrt(a^2 - r^2))" if self.medium.k == 0 else "H/pi (a^2 - r^2)^((k-1)/2)"
        statement = f"d/da (p - edge term) = P g'(a), edge term = P (d - g(a)), P = {rule}"
        steps += [require_zero(sp.diff(rest, a) - slope, domain, statement)]
        return [*steps, require_zero(at(rest, a, r), domain.at(a, r), "p - edge term -> 0 as a -> r")]

    def displacement(self) -> list[str]:
        """With the face held fixed w grows with a in proportion to d - g(a), by (11.56), from zero at a = 0."""
        expr, steps = self._fixed("w")
        domain, k = self.domain((a, r)), self.medium.k
        slope = self.medium.displacement_scale * a**k * self.gap * (r**2 - a**2) ** (-(1 + k) / 2)
        rule = "2/pi (d - g(a))/sqrt(r^2 - a^2)" if k == 0 else "2 cos(k pi/2)/pi a^k (d - g(a)) (r^2 - a^2)^(-(1+k)/2)"
        steps += [require_zero(sp.diff(expr, a) - slope, domain, f"dw/da = {rule} for a fixed face")]
        return [*steps, require_zero(at(expr, a, sp.S.Zero), domain.at(a, sp.S.Zero), "w -> 0 as a -> 0")]

    def stiffness(self) -> list[str]:
        """k = dF/dd, in every region."""
        _, steps = self._fixed("k")
        forces = {case.chain: case.expr for case in self.entries["F"].cases}
        for case in self.entries["k"].cases:
            gap = case.expr - sp.diff(forces[case.chain], d)
            steps = [*steps, require_zero(gap, self.domain((a,)), "k = dF/dd")]
        return steps

    def depth_from_force(self) -> list[str]:
        """The depth put into the formula of the force gives the force back."""
        expr, steps = self._fixed("dF")
        (force,) = self.entries["F"].fixed_face
        return [*steps, require_zero(force.expr.subs(d, expr) - F, self.domain((a,)), "F(dF(F)) = F")]

    # before the edge is reached

    def _partial(self, suffix: str, before: list[Case]) -> list[str]:
        """Cases before the edge is reached are those of the unbounded profile, with its contact radius."""
        if not before:
            return []
        radius = self.compact.entry("ad").cases[0].expr
        depth, force = (self.compact.entry(name).cases[0].expr.subs(a, c) for name in ("d", "F"))
        steps = self.compact.composition("ad", d, "d", None) + self._unbounded(suffix)
        wanted = depth if suffix == "dF" else self.compact.entry(suffix).cases[0].expr.subs(a, c)
        statement = f"{suffix} is that of the unbounded profile until d = g(a)"
        for case in before:
            place = (c, a) if suffix == "dF" else tuple(c if member == radius else member for member in case.chain)
            # with the radius c of the contact in place of the depth, or the force, that belongs to it
            gap = case.expr.subs({d: depth, F: force}, simultaneous=True) - wanted
            steps.append(require_zero(gap, self.domain(place), statement))
        return steps

    def _unbounded(self, suffix: str) -> list[str]:
        rules = {
            "F": self.compact.force,
            "p": self.compact.pressure,
            "w": self.compact.displacement,
            "k": self.compact.stiffness,
            "dF": lambda: self.compact.composition("dF", F, "F", "d"),
        }
        further = CONSEQUENCES.get(suffix)
        return self.compact.force() + (self.compact.follows(further) if further else rules[suffix]())

    def follows(self, own: Consequence) -> list[str]:
        """With the face held fixed a consequence grows with a at its rate, from zero or from what it is at a = r."""
        expr, steps = self._fixed(own.suffix)
        region, rate = self._region(own.suffix), own.fixed_rate
        domain = self.domain(region)
        slope = sp.diff(expr, a) - rate.slope.subs(GAP, self.gap)
        steps = [*steps, require_zero(slope, domain, rate.statement)]
        end = region[-2] if len(region) > 1 else sp.S.Zero
        start = self.entries[rate.start].fixed_face[0].expr if rate.start else sp.S.Zero
        gap = at(sp.powsimp(sp.expand_mul(expr), combine="exp"), a, end) - at(start, a, end)
        return [*steps, require_zero(gap, domain.at(a, end), f"{own.suffix} -> {rate.start or 0} as a -> {end}")]

    # the least depth of complete contact

    def zero_radius(self) -> list[str]:
        """What is shown for the least depth, which says where the pressure vanishes."""
        return self.minimum_depth()

    def minimum_depth(self) -> list[str]:
        """p >= 0 everywhere at d_min, p = 0 at r_0, and p grows with d."""
        least = self._alone("dmin")
        if least.expr.has(r_zero):
            return self._minimum_at_root(least.expr)
        ring = self._alone("rz")
        (pressure,) = closed(self.entries["p"]).cases
        domain, steps = self.domain((r, a)), self.pressure()
        weighted = (a**2 - r**2) ** ((1 - self.medium.k) / 2) * pressure.expr.subs(d, least.expr)
        # p grows with d: its part with d is the punch
        steps.append("dp/dd > 0")
        return steps + rings.by_squares(weighted, r, ring.expr, domain, self.domain((a,)))

    def _alone(self, suffix: str) -> Case:
        """The only case of what is asked of complete contact as a whole."""
        entry = closed(self.entries[suffix])
        require_regions(entry, ((a,),))
        return entry.cases[0]

    def _minimum_at_root(self, least: sp.Expr) -> list[str]:
        """As for a concave strip, with r for x and d for P: the pressure of r^n has the degree n - 1 in both."""
        named = {r: x, d: P, r_zero: x_zero}
        (face,), (pressure,) = self.compact.entry("p").cases, closed(self.entries["p"]).cases
        ring = self.entries["rz"]
        place = replace(ring, cases=tuple(replace(case, expr=case.expr.xreplace(named)) for case in ring.cases))
        growth = self.medium.pressure_scale * a * sp.diff(self.compact.depth_of((a,)), a)
        exponent = self._exponent(self.unbounded.pieces[0].expr)
        # below n = 1 - k the pressure in the middle has no bound, and no depth makes the contact complete
        domain = Domain((x, a), (1 - self.medium.k, exponent), *self.compact.bounds)
        shown = rings.by_root(face.expr.xreplace(named), growth, place, exponent, domain, self.medium.k)
        found = pressure.expr.xreplace(named), least.xreplace(named)
        shown += rings.at_root(*found, place, exponent, domain, self.medium.k)
        return self.pressure() + self.compact.pressure() + [f"with x = r, P = d: {step}" for step in shown]

    def minimum_force(self) -> list[str]:
        """F_min = F(d_min), after what is shown for d_min and F."""
        steps = self.minimum_depth()
        least, (force,), case = self._alone("dmin"), closed(self.entries["F"]).cases, self._alone("Fmin")
        gap, domain = case.expr - force.expr.subs(d, least.expr), self.domain((a,))
        if gap.has(r_zero):
            k, exponent = self.medium.k, self._exponent(self.unbounded.pieces[0].expr)
            gap = rings.on_the_ring(gap, r_zero, exponent, k)
            domain = Domain((a,), (1 - k, exponent), (rings.SHARE, 1), *self.compact.bounds)
        return [*steps, *self.force(), require_zero(gap, domain, "F_min = F(d_min)")]
