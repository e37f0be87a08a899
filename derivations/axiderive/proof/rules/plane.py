"""Rules for plane contact: load by antiderivatives, fields by their growth with the half-width, depth by the slope.

What is taken as known is the flat strip: p = P/(pi sqrt(a^2 - x^2)), level inside, dw/dx = -2 P/(pi E* sqrt(x^2 - a^2))
outside.  The punch under an eccentric load is shown by itself: equilibrium by antiderivatives, level base by Plemelj's
formula.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from ...abel.form import insert
from ...entry import Case, Entry
from ...notation import C, E_star, L, P, a, e, r, x
from ...notation import c as half
from ...physics.plane import derive
from ...profiles.profile import Piece, Profile
from ..algebra.domain import Domain, NotProvedError, require
from ..algebra.functions import normal, require_analytic, sign, tower
from ..algebra.identity import at
from ..statement import Rule, require_regions, require_zero
from . import rings
from .compact import Compact


class Plane(Compact):
    """The entries of one profile whose contact grows with the load."""

    base = "P"
    points = (x, L)

    def __init__(self, profile: Profile, entries: dict[str, Entry]) -> None:
        in_r = tuple(Piece(piece.upper, piece.expr.subs(x, r)) for piece in profile.pieces)
        super().__init__(replace(profile, pieces=in_r), entries)

    def integrand(self, slope: sp.Expr) -> sp.Expr:
        """What the load integrates over x, with `slope` for f'(x)."""
        return E_star * x * slope / sp.sqrt(a**2 - x**2)

    def load(self) -> list[str]:
        """P is the sum of the increments of antiderivatives."""
        return self._by_antiderivatives("E* x f'(x)/sqrt(a^2 - x^2)")

    def pressure(self) -> list[str]:
        """p grows with a by the pressure of a flat strip times P'(a), from zero at a = x."""
        return self._integral(
            "p",
            lambda growth: growth / (sp.pi * sp.sqrt(a**2 - x**2)),
            "dp/da = P'(a)/(pi sqrt(a^2 - x^2))",
            lambda chain: list(insert(chain, x, below=a)),
        )

    def slope(self) -> list[str]:
        """s grows with a by the slope beside a flat strip times P'(a), from zero where the contact begins."""
        return self._integral(
            "s",
            lambda growth: -2 / (sp.pi * E_star) * growth / sp.sqrt(x**2 - a**2),
            "ds/da = -2 P'(a)/(pi E* sqrt(x^2 - a^2))",
            lambda chain: list(insert(chain, x, above=a)),
        )

    def depth(self) -> list[str]:
        """The depth is f at the edge and the descent of the surface from there to L."""
        entry, steps = self.entry("d"), []
        require_regions(entry, tuple(chain for regime in self._regimes() for chain in insert(regime, L, above=a)))
        slopes = {_moved(case): case.expr.subs(x, L) for case in self.entry("s").cases}
        for case in entry.cases:
            domain = self.domain(case.chain)
            require_analytic(case.expr, domain)
            steps.append(require_zero(sp.diff(case.expr, L) + slopes[case.chain], domain, "dd/dL = -s(L)"))
            growth = 2 / (sp.pi * E_star) * sp.diff(self.depth_of(case.chain), a) * sp.acosh(L / a)
            steps.append(require_zero(sp.diff(case.expr, a) - growth, domain, "dd/da = 2 P'(a) acosh(L/a)/(pi E*)"))
            steps.append(self._at_the_edge(entry, case))
        return steps

    def half_width(self) -> list[str]:
        """A closed inverse by composition; the root of an equation by the growth of the load."""
        entry, steps = self.entries["aP"], []
        if entry.status == "closed":
            return self.composition("aP", P, "P", None)
        require_regions(entry, self._regimes())
        loads = {load.chain: load.expr for load in self.entry("P").cases}
        for case in entry.cases:
            domain, load = self.domain(case.chain), loads[case.chain]
            steps.append(require_zero(case.expr.lhs - load, domain, "the equation is P(a) = P"))
            steps.append(require_zero(case.expr.rhs - P, domain, "the equation is P(a) = P"))
            require(sign(sp.diff(load, a), domain) > 0, "dP/da > 0 is not shown")
        return [*steps, "dP/da > 0: the equation has one root"]

    def _at_the_edge(self, entry: Entry, case: Case) -> str:
        place = case.chain.index(L)
        lower = case.chain[place - 1]
        if lower == a:
            inner = [b for b in self.profile.breaks if b in case.chain and case.below(b, a)]
            wanted, statement = self.profile.pieces[len(inner)].expr.subs(r, a), "d -> f(a) as L -> a"
        else:
            swapped = (*case.chain[: place - 1], L, lower, *case.chain[place + 1 :])
            below = next(other.expr for other in entry.cases if other.chain == swapped)
            wanted, statement = at(below, L, lower), f"d is continuous at L = {lower}"
        return require_zero(at(case.expr, L, lower) - wanted, self.domain(case.chain).at(L, lower), statement)


def _moved(case: Case) -> tuple[sp.Expr, ...]:
    return tuple(L if length == x else length for length in case.chain)


class PlaneComplete:
    """Complete contact: the strip carries what the face, as an unbounded profile, leaves of the load."""

    def __init__(self, profile: Profile, entries: dict[str, Entry]) -> None:
        self.entries = entries
        (piece,) = profile.pieces
        self.flat = piece.expr == 0
        geometry = tuple(symbol for symbol in profile.parameters if symbol != a)
        unbounded = replace(profile, contact="compact", parameters=geometry)
        if not self.flat:
            self.exponent = normal(x * sp.diff(piece.expr, x) / piece.expr, Domain((x, a)))
            self.coefficient = -piece.expr.subs(x, 1)
            unbounded = replace(unbounded, pieces=(Piece(None, C * x**self.exponent),))
        self.face = Plane(unbounded, derive(unbounded))
        self.domain = self.face.domain

    def _superposition(self, suffix: str, chain: tuple[sp.Symbol, ...], strip: sp.Expr) -> list[str]:
        require_regions(self.entries[suffix], (chain,))
        (case,), domain = self.entries[suffix].cases, self.domain(chain)
        if self.flat:
            return [require_zero(case.expr - P * strip, domain, f"{suffix} = {suffix} of the strip")]
        # the face is -C x^n: its load and fields are those of C x^n with the other sign
        (own,) = self.face.entry(suffix).cases
        whole = ((P + self.face.depth_of((a,))) * strip - own.expr).subs(C, self.coefficient)
        statement = f"{suffix} = {suffix} of the strip under P - P_f(a), plus {suffix} of the face under P_f(a)"
        return self._face_rules(suffix) + [require_zero(case.expr - whole, domain, statement)]

    def _face_rules(self, suffix: str) -> list[str]:
        rules = {"p": self.face.pressure, "s": self.face.slope, "d": lambda: self.face.slope() + self.face.depth()}
        return self.face.load() + rules[suffix]()

    def pressure(self) -> list[str]:
        """p is that of the face under its own load P_f(a) and that of a flat strip under the rest, P - P_f(a)."""
        return self._superposition("p", (x, a), 1 / (sp.pi * sp.sqrt(a**2 - x**2)))

    def slope(self) -> list[str]:
        """s is that of the face under its own load P_f(a) and that of a flat strip under the rest, P - P_f(a)."""
        return self._superposition("s", (a, x), -2 / (sp.pi * E_star * sp.sqrt(x**2 - a**2)))

    def depth(self) -> list[str]:
        """d is that of the face under its own load P_f(a) and that of a flat strip under the rest, P - P_f(a)."""
        return self._superposition("d", (a, L), 2 / (sp.pi * E_star) * sp.acosh(L / a))

    def minimum_load(self) -> list[str]:
        """The largest of the loads at which p vanishes at some x."""
        require_regions(self.entries["Pmin"], ((a,),))
        (case,), (least,) = self.entries["p"].cases, self.entries["Pmin"].cases
        steps, domain = self.pressure(), self.domain((x, a))
        if self.entries["xz"].status == "root":
            (face,) = self.face.entry("p").cases
            strip = a * sp.diff(self.face.depth_of((a,)), a) / sp.pi
            steps += rings.by_root(face.expr, strip, self.entries["xz"], self.exponent, domain)
            return steps + rings.at_root(case.expr, least.expr, self.entries["xz"], self.exponent, domain)
        require_regions(self.entries["xz"], ((a,),))
        (place,) = self.entries["xz"].cases
        weighted = sp.sqrt(a**2 - x**2) * case.expr.subs(P, least.expr)
        return steps + rings.by_squares(weighted, x, place.expr, domain, self.domain((a,)))


PLACE, SHARE = sp.symbols("place share", positive=True)
"""Where x and e are between their bounds, from 0 to 1."""
NOTHING = sp.Symbol("nothing", positive=True)
"""Stands for a greater of zero and a negative number until what is made of it is shown to be finite."""


@dataclass(frozen=True)
class Regime:
    """An eccentricity, and the contact that belongs to it: its middle and half-width."""

    eccentricity: sp.Expr
    middle: sp.Expr
    width: sp.Expr
    domain: Domain

    @property
    def xi(self) -> sp.Expr:
        """The distance from the middle, from one edge to the other."""
        return self.width * (2 * PLACE - 1)


TOUCHING = Regime(a * (SHARE - sp.S.Half), sp.S.Zero, a, Domain((PLACE, 1), (SHARE, 1)))
LIFTED = Regime(a - half / 2, a - half, half, Domain((PLACE, 1), (half, a)))
DISTANCE = sp.Abs(e)
REGIONS = {(DISTANCE, a / 2): TOUCHING, (a / 2, DISTANCE): LIFTED}


class Tilted:
    """The punch under an eccentric load in two regimes: touching all over, and one edge lifted.

    In the coordinate xi from the middle of the contact, of half-width c, the
    pressure is p = (alpha + beta xi)/sqrt(c^2 - xi^2).  The function

        Phi(z) = pi [(alpha + beta z)/sqrt(z^2 - c^2) - beta]

    jumps by -2 pi i p across the contact and vanishes at infinity, so it is
    int p(s)/(z - s) ds; the mean of its boundary values is the principal value
    -pi beta, the same all over the contact.  While both edges touch, e and x may
    have either sign and stand in one formula; with one edge lifted the formulas are
    odd or even under x -> -x, e -> -e, so that e > 0 is enough.
    """

    def __init__(self, entries: dict[str, Entry]) -> None:
        self.entries = entries

    def _expr(self, suffix: str, regime: Regime, place: sp.Expr | None = None) -> sp.Expr:
        """The formula at a place, which is one of the contact if nothing else is said."""
        require_regions(self.entries[suffix], tuple(REGIONS))
        (expr,) = (case.expr for case in self.entries[suffix].cases if REGIONS[case.chain] is regime)
        place = regime.middle + regime.xi if place is None else place

        def signed(inside: sp.Expr) -> int:
            found = sign(sp.expand(inside), regime.domain)
            require(found != 0, "the sign of {} is not shown", inside)
            return found

        def greater(*terms: sp.Expr) -> sp.Expr:
            """Of zero and a term."""
            (term,) = (term for term in terms if term != 0)
            return term if signed(term) > 0 else NOTHING

        moved = expr.subs({e: regime.eccentricity, x: place}, simultaneous=True)
        moved = moved.replace(sp.Abs, lambda inside: signed(inside) * inside).replace(sp.sign, signed)
        return moved.replace(sp.Max, greater)

    def _mirrored(self, suffix: str, parity: int) -> str:
        """With an edge lifted the contact for e < 0 is the mirror image of that for e > 0."""
        for case in self.entries[suffix].cases:
            mirrored = case.expr.subs({x: -x, e: -e}, simultaneous=True)
            require(sp.expand(mirrored - parity * case.expr) == 0, "{} is not mirrored by x -> -x, e -> -e", suffix)
        return f"{suffix} for e < 0 is the mirror image"

    def _numerator(self, regime: Regime) -> tuple[sp.Expr, sp.Expr]:
        """alpha and beta: p sqrt(c^2 - xi^2) is a polynomial of first degree."""
        domain = regime.domain
        weighted = self._expr("p", regime) * sp.sqrt(regime.width**2 - regime.xi**2)
        arithmetic = tower(domain, weighted)
        plain = sp.expand(arithmetic.expr(arithmetic.collect(arithmetic.convert(weighted))))
        beta = sp.expand(sp.diff(plain, PLACE) / (2 * regime.width))
        require(not beta.has(PLACE), "p sqrt(c^2 - xi^2) is not of first degree in xi")
        return plain.subs(PLACE, sp.S.Half), beta

    def pressure(self) -> list[str]:
        """p carries P with the moment P e; it is positive at both edges, or vanishes at a lifted one and beyond."""
        steps = [self._mirrored("p", 1)]
        for regime in REGIONS.values():
            alpha, beta = self._numerator(regime)
            domain, width, xi = regime.domain, regime.width, regime.xi
            root, arc = sp.sqrt(width**2 - xi**2), sp.asin(xi / width)
            pressure = self._expr("p", regime)
            load = alpha * arc - beta * root
            moment = -alpha * root + beta * (width**2 * arc - xi * root) / 2
            for power, primitive in enumerate((load, moment)):
                gap = sp.diff(primitive, PLACE) - 2 * width * xi**power * pressure
                steps.append(require_zero(gap, domain, f"d/dxi of the antiderivative = xi^{power} p"))
            ends = [at(primitive, PLACE, sp.S.One) - at(primitive, PLACE, sp.S.Zero) for primitive in (load, moment)]
            steps.append(require_zero(ends[0] - P, domain, "int p dx = P"))
            balance = ends[1] + regime.middle * P - regime.eccentricity * P
            steps.append(require_zero(balance, domain, "int x p dx = P e"))
            edges = [alpha - beta * width, alpha + beta * width]
            if regime is LIFTED:
                steps.append(require_zero(edges[0], domain, "p = 0 at the lifted edge"))
            elif any(sign(edge, domain) <= 0 for edge in edges):
                message = "p > 0 at both edges for abs(e) < a/2 is not shown"
                raise NotProvedError(message)
        beyond = self._expr("p", LIFTED, -a + 2 * (a - half) * PLACE)
        require_analytic(beyond, LIFTED.domain)
        nothing = at(beyond, NOTHING, sp.S.Zero)
        return [*steps, require_zero(nothing, LIFTED.domain, "p = 0 where the punch has lifted")]

    def inclination(self) -> list[str]:
        """phi belongs to the pressure by Plemelj's formula, and changes its sign with e."""
        steps = [self._mirrored("phi", -1)]
        for regime in REGIONS.values():
            alpha, beta = self._numerator(regime)
            domain = regime.domain
            jump = self._expr("p", regime) - (alpha + beta * regime.xi) / sp.sqrt(regime.width**2 - regime.xi**2)
            steps.append(require_zero(jump, domain, "Phi jumps by -2 pi i p across the contact"))
            gap = self._expr("phi", regime) - 2 / (sp.pi * E_star) * sp.pi * beta
            steps.append(require_zero(gap, domain, "phi = 2/(pi E*) pi beta, with -pi beta the principal value"))
        return steps

    def width(self) -> list[str]:
        """The contact width is twice the half-width c, touching all over and with an edge lifted."""
        steps = [self._mirrored("cw", 1)]
        for regime in REGIONS.values():
            gap = self._expr("cw", regime) - 2 * regime.width
            steps.append(require_zero(gap, regime.domain, "contact width = 2 c"))
        return steps


COMPACT: dict[str, Rule] = {
    "P": ((), Plane.load),
    "p": (("P",), Plane.pressure),
    "s": (("P",), Plane.slope),
    "d": (("P", "s"), Plane.depth),
    "aP": (("P",), Plane.half_width),
}
COMPLETE: dict[str, Rule] = {
    "p": ((), PlaneComplete.pressure),
    "s": ((), PlaneComplete.slope),
    "d": ((), PlaneComplete.depth),
    "xz": (("p",), PlaneComplete.minimum_load),
    "Pmin": (("p",), PlaneComplete.minimum_load),
}
ECCENTRIC: dict[str, Rule] = {
    "p": ((), Tilted.pressure),
    "phi": (("p",), Tilted.inclination),
    "cw": (("p",), Tilted.width),
}


def statements(profile: Profile, entries: dict[str, Entry]) -> tuple[dict[str, Rule], Callable[[], Any]]:
    """What is shown of a plane profile, and what makes the object that shows it."""
    if e in profile.parameters:
        return ECCENTRIC, lambda: Tilted(entries)
    if profile.complete:
        return COMPLETE, lambda: PlaneComplete(profile, entries)
    return COMPACT, lambda: Plane(profile, entries)
