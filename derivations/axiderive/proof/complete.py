"""Rules for complete contact: the edge is fixed, w1D = d - g does not vanish there.

All integrals are taken over the radius with the face held fixed, -C r**n for
a concave one; C = h/a**n is put in afterwards.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ..abel.order import Chain
from ..contact.medium import HOMOGENEOUS, Medium
from ..contact.normal import derive
from ..entry import Case, Entry
from ..notation import C, F, P, a, d, r, r_zero, x, x_zero
from ..profiles.profile import Piece, Profile
from . import plane_threshold
from .compact import Compact
from .domain import Domain, NotProvedError
from .functions import canonical, normal, require_analytic, sign, tower
from .identity import at
from .statement import require_zero


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
        entry = self._closed(suffix)
        (fixed,) = entry.fixed_face
        if fixed.chain not in ((a,), (r, a), (a, r)):
            message = f"{' < '.join(map(str, fixed.chain))} is not the region of complete contact"
            raise NotProvedError(message)
        steps, domain = self.face(), self.domain(fixed.chain)
        require_analytic(fixed.expr, domain)
        after = [case for case in entry.cases if not self._before(case)]
        if not after:
            message = f"{entry.key} has no case of complete contact"
            raise NotProvedError(message)
        for case in after:
            gap = fixed.expr.subs(C, self.coefficient) - case.expr
            steps = [*steps, require_zero(gap, domain, f"{suffix} is the formula of the fixed face")]
        return fixed.expr, steps + self._partial(suffix, entry)

    def _closed(self, suffix: str) -> Entry:
        entry = self.entries[suffix]
        if entry.status != "closed":
            message = f"{entry.key} is the root of an equation"
            raise NotProvedError(message)
        return entry

    # the quantities

    def force(self) -> list[str]:
        expr, steps = self._fixed("F")
        domain, k = self.domain((a,)), self.medium.k
        slope = self.medium.force_scale * a**k * self.gap
        rule = "2 E*" if k == 0 else "2 H a^k"
        steps += [require_zero(sp.diff(expr, a) - slope, domain, f"dF/da = {rule} (d - g(a)) for a fixed face")]
        return [*steps, require_zero(at(expr, a, sp.S.Zero), domain.at(a, sp.S.Zero), "F -> 0 as a -> 0")]

    def pressure(self) -> list[str]:
        expr, steps = self._fixed("p")
        domain, unit = self.domain((r, a)), self.medium.punch_pressure()
        rest = normal(canonical(expr - unit * self.gap, domain), domain)
        slope = unit * sp.diff(-self.gap, a)
        rule = "E*/(pi sqrt(a^2 - r^2))" if self.medium.k == 0 else "H/pi (a^2 - r^2)^((k-1)/2)"
        statement = f"d/da (p - edge term) = P g'(a), edge term = P (d - g(a)), P = {rule}"
        steps += [require_zero(sp.diff(rest, a) - slope, domain, statement)]
        return [*steps, require_zero(at(rest, a, r), domain.at(a, r), "p - edge term -> 0 as a -> r")]

    def displacement(self) -> list[str]:
        expr, steps = self._fixed("w")
        domain, k = self.domain((a, r)), self.medium.k
        slope = self.medium.displacement_scale * a**k * self.gap * (r**2 - a**2) ** (-(1 + k) / 2)
        rule = "2/pi (d - g(a))/sqrt(r^2 - a^2)" if k == 0 else "2 cos(k pi/2)/pi a^k (d - g(a)) (r^2 - a^2)^(-(1+k)/2)"
        steps += [require_zero(sp.diff(expr, a) - slope, domain, f"dw/da = {rule} for a fixed face")]
        return [*steps, require_zero(at(expr, a, sp.S.Zero), domain.at(a, sp.S.Zero), "w -> 0 as a -> 0")]

    def stiffness(self) -> list[str]:
        _, steps = self._fixed("k")
        for case, force in zip(self.entries["k"].cases, self.entries["F"].cases, strict=True):
            if case.chain != force.chain:
                message = "the cases of the stiffness are not those of the force"
                raise NotProvedError(message)
            steps = [*steps, require_zero(case.expr - sp.diff(force.expr, d), self.domain((a,)), "k = dF/dd")]
        return steps

    def depth_from_force(self) -> list[str]:
        expr, steps = self._fixed("dF")
        (force,) = self.entries["F"].fixed_face
        return [*steps, require_zero(force.expr.subs(d, expr) - F, self.domain((a,)), "F(dF(F)) = F")]

    # before the edge is reached

    def _before(self, case: Case) -> bool:
        """Whether the contact has not reached the edge: its radius, or its force, is the smaller one."""
        inner = [member for member in case.chain if member not in (r, a)]
        if not inner:
            return False
        return case.chain[0] == F if F in case.chain else case.below(inner[0], a)

    def _partial(self, suffix: str, entry: Entry) -> list[str]:
        """Cases before the edge is reached are those of the unbounded profile, with its contact radius."""
        before = [case for case in entry.cases if self._before(case)]
        if len(entry.cases) == 1 and not before:
            return []
        radius = self.compact.entry("ad").cases[0].expr
        reached = self.compact.entry("F").cases[0].expr
        steps = self.compact.composition("ad", d, "d", None) + self._unbounded(suffix)
        source = self.compact.entry(suffix).cases[0]
        wanted = source.expr if suffix == "dF" else source.expr.subs(a, radius)
        switch = {reached if suffix == "dF" else radius}
        for case in entry.cases:
            if set(case.chain) - {r, a, F} != switch or not before:
                message = f"the cases of {entry.key} do not change where d = g(a)"
                raise NotProvedError(message)
        statement = f"{suffix} is that of the unbounded profile until d = g(a)"
        # equal as they stand: r, a and the current radius are not compared here
        return steps + [require_zero(case.expr - wanted, self.domain(()), statement) for case in before]

    def _unbounded(self, suffix: str) -> list[str]:
        rules = {
            "F": self.compact.force,
            "p": self.compact.pressure,
            "w": self.compact.displacement,
            "k": self.compact.stiffness,
            "dF": lambda: self.compact.composition("dF", F, "F", "d"),
        }
        return self.compact.force() + rules[suffix]()

    # the least depth of complete contact

    def zero_radius(self) -> list[str]:
        return self.minimum_depth()

    def minimum_depth(self) -> list[str]:
        """p >= 0 everywhere at d_min, p = 0 at r_0, and p grows with d."""
        (least,) = self._closed("dmin").cases
        if least.expr.has(r_zero):
            return self._minimum_at_root(least.expr)
        (ring,) = self._closed("rz").cases
        (pressure,) = self._closed("p").cases
        domain, steps = self.domain((r, a)), self.pressure()
        if sign(sp.diff(pressure.expr, d), domain) <= 0:
            message = "p is not shown to grow with d"
            raise NotProvedError(message)
        weighted = (a**2 - r**2) ** ((1 - self.medium.k) / 2) * pressure.expr.subs(d, least.expr)
        arithmetic = tower(domain, weighted)
        element = arithmetic.collect(arithmetic.convert(weighted))
        if len(element) != 1:
            message = "(a^2 - r^2)^((1-k)/2) p is not a polynomial in r"
            raise NotProvedError(message)
        ((_, polynomial),) = element.items()
        unit, factors = arithmetic.factors(polynomial)
        if unit < 0 or any(arithmetic.polynomial_sign(f) <= 0 and power % 2 for f, power in factors.items()):
            message = "p >= 0 at d_min is not shown"
            raise NotProvedError(message)
        if not (
            sign(a - ring.expr, self.domain((a,))) > 0 and (ring.expr == 0 or sign(ring.expr, self.domain((a,))) > 0)
        ):
            message = "0 <= r_0 < a is not shown"
            raise NotProvedError(message)
        steps += ["dp/dd > 0", "(a^2 - r^2)^((1-k)/2) p >= 0 at d = d_min: positive factors and squares"]
        return [*steps, require_zero(at(weighted, r, ring.expr), self.domain((a,)), "p = 0 at d = d_min, r = r_0")]

    def _minimum_at_root(self, least: sp.Expr) -> list[str]:
        """As for a concave strip, with r for x and d for P: the pressure of r^n has the degree n - 1 in both."""
        named = {r: x, d: P, r_zero: x_zero}
        (face,), (pressure,) = self.compact.entry("p").cases, self._closed("p").cases
        ring = self.entries["rz"]
        place = replace(ring, cases=tuple(replace(case, expr=case.expr.xreplace(named)) for case in ring.cases))
        growth = self.medium.pressure_scale * a * sp.diff(self.compact.depth_of((a,)), a)
        exponent = self._exponent(self.unbounded.pieces[0].expr)
        # below n = 1 - k the pressure in the middle has no bound, and no depth makes the contact complete
        domain = Domain((x, a), (1 - self.medium.k, exponent), *self.compact.bounds)
        shown = plane_threshold.by_root(face.expr.xreplace(named), growth, place, exponent, domain, self.medium.k)
        shown += plane_threshold.at_root(pressure.expr.xreplace(named), least.xreplace(named), place, domain)
        return self.pressure() + self.compact.pressure() + [f"with x = r, P = d: {step}" for step in shown]

    def minimum_force(self) -> list[str]:
        steps = self.minimum_depth()
        (least,), (force,) = self._closed("dmin").cases, self._closed("F").cases
        (case,) = self._closed("Fmin").cases
        gap = case.expr - force.expr.subs(d, least.expr)
        return [*steps, *self.force(), require_zero(gap, self.domain((a,)), "F_min = F(d_min)")]
