"""Normal contact without adhesion: every quantity of every profile as an entry.

Prefactors and definitions are those of chapter 11: depth (11.29), force
(11.20), pressure (11.23), displacement (11.26) with r > a, stiffness (11.18).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..abel.form import Form
from ..abel.order import Chain, Order, insert
from ..abel.reduce import Reduced, parse
from ..entry import COMPACT, Case, Entry, Primitive, Status
from ..notation import E_star, F, N, a, coefficients, d, f, g, j, psi, r, t, u
from ..profiles.profile import Piece, Profile
from . import complete
from .inverse import closed_inverse

REFERENCES = {
    "d": ("(11.29)",),
    "F": ("(11.20)",),
    "p": ("(11.23)",),
    "w": ("(11.26)",),
    "k": ("(11.18)",),
    "pm": (),
    "ad": ("(11.16)",),
    "aF": ("(11.20)",),
    "Fd": ("(11.16)", "(11.20)"),
    "dF": ("(11.16)", "(11.20)"),
}


def definitions() -> dict[str, sp.Expr]:
    """The defining integrals, with f(r) the profile and g(t) the depth of an earlier contact of radius t."""
    f_, g_ = sp.Function(f.name), sp.Function(g.name)
    slope = sp.Derivative(g_(t), t)
    depth = a * sp.Integral(sp.Derivative(f_(r), r) / sp.sqrt(a**2 - r**2), (r, 0, a))
    force = 2 * E_star * sp.Integral(g_(a) - g_(t), (t, 0, a))
    return {
        "d": depth,
        "F": force,
        "p": E_star / sp.pi * sp.Integral(slope / sp.sqrt(t**2 - r**2), (t, r, a)),
        "w": 2 / sp.pi * sp.Integral(slope * sp.asin(t / r), (t, 0, a)),
        "k": sp.Derivative(F, d),
        "pm": F / (sp.pi * a**2),
        "ad": sp.Eq(g_(a), d),
        "aF": sp.Eq(force, F),
        "Fd": force,
        "dF": g_(a),
    }


def derive(profile: Profile) -> dict[str, Entry]:
    """All entries of a profile, keyed by suffix.

    Raises
    ------
    NotReducibleError
        If the profile is not a sum of known atoms.
    ValueError
        If the profile does not start at zero or has a jump.
    """
    if profile.contact == "complete":
        return complete.derive(profile)
    return _Compact(profile).entries()


@dataclass
class _Compact:
    """The derivation of one compact profile."""

    profile: Profile

    def __post_init__(self) -> None:
        self.pieces, self.summed = _summand(self.profile.pieces)
        self.reduced: Reduced = parse(self.pieces)
        self.chains = self._contact_chains()

    def _contact_chains(self) -> tuple[Chain, ...]:
        """Every place of the contact radius among the breaks; a truncated profile starts at its first break."""
        fixed = self.profile.chain or self.profile.breaks
        if a in fixed:
            return (fixed,)
        above = self.profile.breaks[0] if self.profile.truncated else None
        return tuple(insert(fixed, a, above=above))

    def _close(self, form: Form) -> sp.Expr:
        expr = form.expr()
        if not self.summed:
            return expr
        outside, inside = expr.as_independent(j)
        return outside * sp.Sum(coefficients[j] * inside, (j, 1, N))

    def entries(self) -> dict[str, Entry]:
        depth, primitives = self._depth()
        force = tuple(Case(c, self._close(self.reduced.force(Order(c)) * (2 * E_star))) for c in self.chains)
        mean = tuple(Case(c, self._close(self.reduced.force(Order(c)) * (2 * E_star / (sp.pi * a**2)))) for c in self.chains)
        pressure_status, pressure = self._pressure(depth)
        outside_status, outside = self._displacement(depth)
        entries = {
            "d": self._entry("d", "closed", depth, primitives=primitives),
            "F": self._entry("F", "closed", force),
            "p": self._entry("p", pressure_status, pressure),
            "w": self._entry("w", outside_status, outside),
            "k": self._entry("k", "closed", (Case((a,), 2 * E_star * a),)),
            "pm": self._entry("pm", "closed", mean),
        }
        return entries | self._inverses(depth, force)

    def _entry(
        self,
        suffix: str,
        status: Status,
        cases: tuple[Case, ...],
        primitives: dict[Chain, tuple[Primitive, ...]] | None = None,
        composed: tuple[str, str] | None = None,
    ) -> Entry:
        material = () if suffix in ("d", "w", "ad") else (E_star,)
        return Entry(
            key=f"{self.profile.name}.{suffix}",
            profile=self.profile,
            quantity=COMPACT[suffix],
            status=status,
            cases=cases,
            definition=definitions()[suffix],
            parameters=self.profile.parameters + material,
            references=REFERENCES[suffix],
            primitives=primitives or {},
            composed=composed,
        )

    def _depth(self) -> tuple[tuple[Case, ...], dict[Chain, tuple[Primitive, ...]]]:
        cases, primitives = [], {}
        for chain in self.chains:
            form = self.reduced.depth(Order(chain))
            cases.append(Case(chain, self._close(form)))
            primitives[chain] = self.reduced.primitives(Order(chain))
        return tuple(cases), primitives

    def _pressure(self, depth: tuple[Case, ...]) -> tuple[Status, tuple[Case, ...]]:
        status: Status = "closed"
        cases: list[Case] = []
        for regime in depth:
            for chain in insert(regime.chain, r, below=a):
                form = self.reduced.pressure(Order(chain))
                if form is not None:
                    cases.append(Case(chain, self._close(form * (E_star / sp.pi))))
                else:
                    status = "integral"
                    cases.append(Case(chain, self._pressure_integral(chain, regime, cases)))
        return status, tuple(cases)

    def _pressure_integral(self, chain: Chain, regime: Case, earlier: list[Case]) -> sp.Expr:
        """(11.23) in u = sqrt(t^2 - r^2), which removes the root at t = r; what lies below a break is known already."""
        crossed = [b for b in self.profile.breaks if chain.index(r) < chain.index(b) < chain.index(a)]
        lower, known = sp.S.Zero, sp.S.Zero
        if crossed:
            b = crossed[-1]
            inner = next(case for case in earlier if case.chain.index(r) < case.chain.index(a) < case.chain.index(b))
            lower, known = sp.sqrt(b**2 - r**2), inner.expr.subs(a, b)
        radius = sp.sqrt(r**2 + u**2)
        slope = sp.diff(regime.expr, a).subs(a, radius)
        integral = sp.Integral(slope / radius, (u, lower, sp.sqrt(a**2 - r**2)))
        return known + E_star / sp.pi * integral

    def _displacement(self, depth: tuple[Case, ...]) -> tuple[Status, tuple[Case, ...]]:
        status: Status = "closed"
        cases = []
        for regime in depth:
            for chain in insert(regime.chain, r, above=a):
                form = self.reduced.displacement(Order(chain))
                if form is not None:
                    cases.append(Case(chain, self._close(form * (2 / sp.pi))))
                else:  # (11.26) in t = r sin(psi)
                    status = "integral"
                    slope = sp.diff(regime.expr, a).subs(a, r * sp.sin(psi))
                    integral = sp.Integral(slope * r * sp.cos(psi) * psi, (psi, 0, sp.asin(a / r)))
                    cases.append(Case(chain, 2 / sp.pi * integral))
        return status, tuple(cases)

    def _inverses(self, depth: tuple[Case, ...], force: tuple[Case, ...]) -> dict[str, Entry]:
        radius_d, radius_F = closed_inverse(depth, d), closed_inverse(force, F)
        equation_d = tuple(Case(case.chain, sp.Eq(case.expr, d)) for case in depth)
        equation_F = tuple(Case(case.chain, sp.Eq(case.expr, F)) for case in force)
        entries = {
            "ad": self._entry("ad", "closed" if radius_d else "root", radius_d or equation_d),
            "aF": self._entry("aF", "closed" if radius_F else "root", radius_F or equation_F),
        }
        routes = (("Fd", ("F", "ad"), radius_d, force, equation_d), ("dF", ("d", "aF"), radius_F, depth, equation_F))
        for suffix, route, radius, outer, equation in routes:
            if not radius:
                entries[suffix] = self._entry(suffix, "root", equation, composed=route)
                continue
            cases = tuple(
                Case(inverse.chain, _tidy(case.expr.subs(a, inverse.expr)))
                for inverse, case in zip(radius, outer, strict=True)
            )
            short = all(len(case.expr.atoms(sp.Add)) <= len(own.expr.atoms(sp.Add)) for case, own in zip(cases, outer, strict=True))
            entries[suffix] = self._entry(suffix, "closed", cases, composed=None if short else route)
        return entries


def _tidy(expr: sp.Expr) -> sp.Expr:
    """Merge the powers of a composed monomial, (d/k)**(1/n) raised to n + 1; every radicand here is positive."""
    expr = expr.replace(sp.Abs, lambda inside: inside)
    if expr.has(sp.Add) and not expr.has(sp.gamma):
        return expr
    return sp.powdenest(sp.powsimp(expr, combine="exp"), force=True)


def _summand(pieces: tuple[Piece, ...]) -> tuple[tuple[Piece, ...], bool]:
    """A sum over powers is derived through its summand, with the coefficient set to one."""
    if len(pieces) == 1 and isinstance(pieces[0].expr, sp.Sum):
        term = pieces[0].expr.function
        return (Piece(None, term / coefficients[j]),), True
    return pieces, False
