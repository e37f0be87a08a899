"""Rules for plane contact: load by antiderivatives, fields by their growth with the half-width, depth by the slope.

What is taken as known is the flat strip: p = P/(pi sqrt(a^2 - x^2)), level
inside, dw/dx = -2 P/(pi E* sqrt(x^2 - a^2)) outside.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from ...abel.form import insert
from ...entry import Case, Entry
from ...notation import C, E_star, L, P, a, e, r, x
from ...physics.plane import derive
from ...profiles.profile import Piece, Profile
from .. import frame
from ..algebra.domain import Domain, NotProvedError
from ..algebra.functions import normal, require_analytic, sign
from ..algebra.identity import at
from ..certificate import Certificate, Prover
from ..statement import Rule, require_regions, require_zero
from . import plane_threshold as threshold
from .compact import Compact
from .tilted import Tilted


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
            if sign(sp.diff(load, a), domain) <= 0:
                message = "dP/da > 0 is not shown"
                raise NotProvedError(message)
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
            steps += threshold.by_root(face.expr, strip, self.entries["xz"], self.exponent, domain)
            return steps + threshold.at_root(case.expr, least.expr, self.entries["xz"], self.exponent, domain)
        require_regions(self.entries["xz"], ((a,),))
        (place,) = self.entries["xz"].cases
        weighted = sp.sqrt(a**2 - x**2) * case.expr.subs(P, least.expr)
        return steps + threshold.by_squares(weighted, x, place.expr, domain, self.domain((a,)))


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


def _prover(profile: Profile, entries: dict[str, Entry]) -> Prover:
    frames = frame.strip(profile, entries)
    if e in profile.parameters:
        return Prover(entries, frames, ECCENTRIC, lambda: Tilted(entries))
    if profile.complete:
        return Prover(entries, frames, COMPLETE, lambda: PlaneComplete(profile, entries))
    return Prover(entries, frames, COMPACT, lambda: Plane(profile, entries))


def certify(profile: Profile, entries: dict[str, Entry], suffix: str) -> Certificate:
    """The certificate of one entry; `entries` are all entries of the plane profile by suffix."""
    return _prover(profile, entries).certify(suffix)


def certify_profile(profile: Profile, entries: dict[str, Entry]) -> dict[str, Certificate]:
    """The certificates of all entries of a plane profile, keyed by suffix."""
    prover = _prover(profile, entries)
    return {suffix: prover.certify(suffix) for suffix in entries}
