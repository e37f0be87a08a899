"""Fields below the surface: at a point that stands still they grow with the radius by g'(a) times a flat punch's.

A flat punch of radius a has X_m = (r/q)**m/rho with rho**2 = r**2 + (z + i a)**2 and q = rho + z + i a.  With
rho = xi + i a y it is q = (1 + y) (xi + i a), r**2 = (xi**2 + a**2) (1 - y**2) and z = xi y, so that everything is a
rational function of xi, a, 0 < y < 1 and of three roots with positive radicands; xi and y move with a by what the two
equations demand.  As a -> 0 they tend to the distance from the middle and to the cosine of the angle to the axis; of
these every value is taken at some point.
"""

from __future__ import annotations

import sympy as sp

from ...abel.form import Chain
from ...abel.masters import Eta, Xi
from ...entry import Entry
from ...notation import C, a, d, r, z
from ...physics.subsurface import derive
from ..algebra.domain import Domain, NotProvedError, require
from ..algebra.functions import canonical, normal, require_analytic
from ..algebra.identity import at
from ..statement import Rule, closed, require_regions, require_zero
from .compact import Compact
from .complete import Complete

x, y = sp.Symbol("xi", positive=True), sp.Symbol("cosine", positive=True)
SIZE = x**2 + a**2 * y**2
PLACE = {r: sp.sqrt(x**2 + a**2) * sp.sqrt(1 - y**2), z: x * y}
"""The point by xi and y."""
GROWS = {x: -a * x * (1 - y**2) / SIZE, y: a * y * (1 - y**2) / SIZE, a: sp.S.One}
"""Rates with the radius where the point stands still."""
SINKS = {x: y * (x**2 + a**2) / SIZE, y: x * (1 - y**2) / SIZE}
"""Rates with the depth of the point."""


def placed(expr: sp.Expr) -> sp.Expr:
    """A formula in xi, y and a."""
    found = expr.xreplace({Xi(r, z, a): x, Eta(r, z, a): a * y})
    require(not found.has(Xi, Eta), "{} has coordinates about another radius than a", expr)
    return found.subs(PLACE)


def rate(expr: sp.Expr, moved: dict[sp.Symbol, sp.Expr]) -> sp.Expr:
    """What a formula in xi, y and a changes by as these move."""
    return sp.Add(*(sp.diff(expr, symbol) * speed for symbol, speed in moved.items()))


def punch(suffix: str) -> sp.Expr:
    """-Im X_m and arg q of a flat punch of radius a that is pressed in by one."""
    if suffix == "W":
        return sp.atan(a / x)
    m = int(suffix[1])
    turned = sp.expand((x - sp.I * a) ** m * (x - sp.I * a * y)).as_real_imag()[1]
    return -turned * (sp.sqrt(1 - y**2) / ((1 + y) * sp.sqrt(x**2 + a**2))) ** m / SIZE


class Subsurface:
    """The numbers below the contact of one profile."""

    def __init__(self, below: Compact | Complete, entries: dict[str, Entry]) -> None:
        self.below, self.entries = below, entries
        self._coordinates: list[str] | None = None

    def domain(self, chain: Chain) -> Domain:
        """That of the contact, with a point anywhere below the surface and off the axis."""
        return Domain((y, 1), *self.below.domain(chain).chains())

    def coordinates(self) -> list[str]:
        """xi and y belong to the point, which stands still, or goes deeper."""
        if self._coordinates is None:
            domain, (place, depth) = Domain((y, 1)), PLACE.values()
            shown = {
                "rho^2 = r^2 + (z + i a)^2, real part": x**2 - a**2 * y**2 - place**2 - depth**2 + a**2,
                "rho^2 = r^2 + (z + i a)^2, imaginary part": x * a * y - depth * a,
                "r stands still": rate(place, GROWS), "z stands still": rate(depth, GROWS),
                "dr/dz = 0": rate(place, SINKS), "dz/dz = 1": rate(depth, SINKS) - 1,
            }  # fmt: skip
            self._coordinates = [require_zero(gap, domain, statement) for statement, gap in shown.items()]
        return self._coordinates

    def grown(self, suffix: str) -> list[str]:
        """S_m and W: their growth with the radius, and zero without a contact."""
        if isinstance(self.below, Complete):
            return self.fixed(suffix, self.below)
        entry, depth = closed(self.entries[suffix]), self.below.entry(Compact.base)
        require_regions(entry, tuple(case.chain for case in depth.cases))
        (case,), (regime,) = entry.cases, depth.cases
        return [*self.coordinates(), *self._growth(suffix, case.expr, sp.diff(regime.expr, a))]

    def _growth(self, suffix: str, expr: sp.Expr, slope: sp.Expr) -> list[str]:
        domain, found = self.domain((a,)), placed(expr)
        require_analytic(found, domain)
        gap = rate(found, GROWS) - slope * punch(suffix)
        start = normal(canonical(found, domain), domain)
        return [
            require_zero(gap, domain, f"{suffix} grows with a by g'(a) times that of a flat punch"),
            require_zero(at(start, a, sp.S.Zero), domain.at(a, sp.S.Zero), f"{suffix} -> 0 as a -> 0"),
        ]

    def fixed(self, suffix: str, face: Complete) -> list[str]:
        """The same of a fixed face, after d - g(a) times a flat punch of the radius of the edge."""
        expr = self._fixed_face(suffix, face)
        domain = self.domain((a,))
        rest = normal(canonical(placed(expr) - face.gap * punch(suffix), domain), domain)
        steps = [*face.face(), *self.coordinates(), *self._growth(suffix, rest, -sp.diff(face.gap, a))]
        return [*steps, *self._cases(suffix, expr, face)]

    def _fixed_face(self, suffix: str, face: Complete) -> sp.Expr:
        (case,) = self.entries[suffix].fixed_face
        require_analytic(placed(case.expr), self.domain((a,)))
        return case.expr

    def _cases(self, suffix: str, expr: sp.Expr, face: Complete) -> list[str]:
        """The formula with C put in, and before the edge is reached that of the unbounded profile."""
        entry, (before, after) = closed(self.entries[suffix]), face.regions(suffix)
        require_regions(entry, before + after)
        domain, steps = self.domain((a,)), list[str]()
        for case in entry.cases:
            if case.chain in after:
                wanted, found, words = expr.subs(C, face.coefficient), case.expr, "the formula of the fixed face"
            else:
                if case.expr.has(a):
                    message = f"{suffix} names the edge {a}, which this contact has not reached: it is a formula in {d}"
                    raise NotProvedError(message)
                wanted = derive(face.unbounded)[suffix].cases[0].expr
                found, words = case.expr.subs(d, face.compact.depth_of((a,))), "that of the unbounded profile at first"
                steps += Subsurface(face.compact, derive(face.unbounded)).shown(suffix)
            steps.append(require_zero(placed(found - wanted), domain, f"{suffix} is {words}"))
        return steps

    def lost(self, suffix: str) -> list[str]:
        """D_m: what S_m loses with the depth."""
        source = f"S{suffix[1]}"
        face = self.below if isinstance(self.below, Complete) else None
        deep, flat = (self.entries[s].fixed_face if face else closed(self.entries[s]).cases for s in (suffix, source))
        require_regions(closed(self.entries[suffix]), tuple(case.chain for case in closed(self.entries[source]).cases))
        domain, steps = self.domain((a,)), self.coordinates()
        for own, above in zip(deep, flat, strict=True):
            require_analytic(placed(own.expr), domain)
            gap = placed(own.expr) + PLACE[z] * rate(placed(above.expr), SINKS)
            steps = [*steps, require_zero(gap, domain, f"{suffix} = -z d{source}/dz")]
        return [*steps, *(self._cases(suffix, deep[0].expr, face) if face else [])]

    def shown(self, suffix: str) -> list[str]:
        """What is shown for one of the numbers."""
        return self.lost(suffix) if suffix.startswith("D") else self.grown(suffix)


def rules(grows: bool) -> dict[str, Rule]:
    """What each number rests on, and what is shown for it, of a contact that grows or has a fixed edge."""
    below = (f"plain.{Compact.base}",) if grows else ()
    found: dict[str, Rule] = {"W": (below, Subsurface.grown, "W")}
    for m in range(4):
        found |= {f"S{m}": (below, Subsurface.grown, f"S{m}"), f"D{m}": ((f"S{m}",), Subsurface.lost, f"D{m}")}
    return found
