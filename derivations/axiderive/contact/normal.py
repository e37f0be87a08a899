"""Normal contact without adhesion: every quantity of every profile as an entry.

Prefactors and definitions are those of chapter 11: depth (11.29), force
(11.20), pressure (11.23), displacement (11.26) with r > a, stiffness (11.18);
on the power-law graded half-space (11.61), (11.51), (11.53), (11.56), (11.46).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..abel.form import Form
from ..abel.order import Chain, Order, insert
from ..abel.reduce import Reduced, parse
from ..entry import COMPACT, Case, Entry, Primitive, Status
from ..notation import F, N, a, coefficients, d, f, g, j, p, psi, r, r_peak, t, u
from ..profiles.profile import Piece, Profile
from . import complete, peak
from .inverse import closed_inverse
from .medium import HOMOGENEOUS, Medium

REFERENCES = {
    "d": (("(11.29)",), ("(11.61)",)),
    "F": (("(11.20)",), ("(11.51)",)),
    "p": (("(11.23)",), ("(11.53)",)),
    "w": (("(11.26)",), ("(11.56)",)),
    "k": (("(11.18)",), ("(11.46)",)),
    "pm": ((), ()),
    "ad": (("(11.16)",), ("(11.48)",)),
    "aF": (("(11.20)",), ("(11.51)",)),
    "Fd": (("(11.16)", "(11.20)"), ("(11.48)", "(11.51)")),
    "dF": (("(11.16)", "(11.20)"), ("(11.48)", "(11.51)")),
    "rp": (("(11.23)",), ()),
    "pp": (("(11.23)",), ()),
}


def definitions(medium: Medium = HOMOGENEOUS) -> dict[str, sp.Expr]:
    """The defining integrals, with f(r) the profile and g(t) the depth of an earlier contact of radius t."""
    f_, g_, p_, k = sp.Function(f.name), sp.Function(g.name), sp.Function(p.name), medium.k
    slope = sp.Derivative(g_(t), t)
    depth = a ** (1 - k) * sp.Integral(sp.Derivative(f_(r), r) * (a**2 - r**2) ** ((k - 1) / 2), (r, 0, a))
    force = medium.force_scale * sp.Integral(t**k * (g_(a) - g_(t)), (t, 0, a))
    if k == 0:
        displacement = 2 / sp.pi * sp.Integral(slope * sp.asin(t / r), (t, 0, a))
    else:
        kernel = t**k * (g_(a) - g_(t)) * (r**2 - t**2) ** (-(1 + k) / 2)
        displacement = medium.displacement_scale * sp.Integral(kernel, (t, 0, a))
    return {
        "d": depth,
        "F": force,
        "p": medium.pressure_scale * sp.Integral(slope * (t**2 - r**2) ** ((k - 1) / 2), (t, r, a)),
        "w": displacement,
        "k": sp.Derivative(F, d),
        "pm": F / (sp.pi * a**2),
        "ad": sp.Eq(g_(a), d),
        "aF": sp.Eq(force, F),
        "Fd": force,
        "dF": g_(a),
        "rp": sp.Eq(sp.Derivative(p_(r), r), 0),
        "pp": p_(r_peak),
    }


def derive(profile: Profile, medium: Medium = HOMOGENEOUS) -> dict[str, Entry]:
    """All entries of a profile, keyed by suffix.

    Raises
    ------
    NotReducibleError
        If the profile is not a sum of known atoms.
    ValueError
        If the profile does not start at zero or has a jump.
    """
    if profile.contact == "complete":
        return complete.derive(profile, medium)
    return _Compact(profile, medium).entries()


@dataclass
class _Compact:
    """The derivation of one compact profile."""

    profile: Profile
    medium: Medium

    def __post_init__(self) -> None:
        self.pieces, self.summed = _summand(self.profile.pieces)
        self.reduced: Reduced = parse(self.pieces, self.medium.k)
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
        force = self._force(self.medium.force_scale)
        mean = self._force(self.medium.force_scale / (sp.pi * a**2))
        pressure_status, pressure = self._pressure(depth)
        outside_status, outside = self._displacement(depth)
        entries = {
            "d": self._entry("d", "closed", depth, primitives=primitives),
            "F": self._entry("F", "closed", force),
            "p": self._entry("p", pressure_status, pressure),
            "w": self._entry("w", outside_status, outside),
            "k": self._entry("k", "closed", (Case((a,), self.medium.stiffness()),)),
            "pm": self._entry("pm", "closed", mean),
        }
        return entries | self._greatest(depth, pressure) | self._inverses(depth, force)

    def _force(self, scale: sp.Expr) -> tuple[Case, ...]:
        return tuple(Case(c, self._close(self.reduced.force(Order(c)) * scale)) for c in self.chains)

    def _entry(
        self,
        suffix: str,
        status: Status,
        cases: tuple[Case, ...],
        primitives: dict[Chain, tuple[Primitive, ...]] | None = None,
        composed: tuple[str, str] | None = None,
    ) -> Entry:
        exponent = (self.medium.k,) if self.medium.k != 0 else ()
        material = exponent if suffix in ("d", "w", "ad") else (self.medium.modulus, *exponent)
        return Entry(
            key=self.medium.key(self.profile.name, self.medium.group, suffix),
            profile=self.profile,
            quantity=COMPACT[suffix],
            status=status,
            cases=cases,
            definition=definitions(self.medium)[suffix],
            parameters=self.profile.parameters + material,
            references=REFERENCES[suffix][self.medium.k != 0],
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
                    cases.append(Case(chain, self._close(form * self.medium.pressure_scale)))
                else:
                    status = "integral"
                    cases.append(Case(chain, self._pressure_integral(chain, regime, cases)))
        return status, tuple(cases)

    def _pressure_integral(self, chain: Chain, regime: Case, earlier: list[Case]) -> sp.Expr:
        """(11.23), (11.53) in u = (t^2 - r^2)^((1 + k)/2), which removes the singularity at t = r.

        What lies below a break is known already.
        """
        k = self.medium.k
        crossed = [b for b in self.profile.breaks if chain.index(r) < chain.index(b) < chain.index(a)]
        lower, known = sp.S.Zero, sp.S.Zero
        if crossed:
            b = crossed[-1]
            lower = (b**2 - r**2) ** ((1 + k) / 2)
            inner = [case.expr for case in earlier if case.chain.index(r) < case.chain.index(a) < case.chain.index(b)]
            known = inner[0].subs(a, b) if inner else sp.S.Zero  # nothing presses below the first break of a flat face
        radius = sp.sqrt(r**2 + u ** (2 / (1 + k)))
        slope = sp.diff(regime.expr, a).subs(a, radius)
        integral = sp.Integral(slope / radius, (u, lower, (a**2 - r**2) ** ((1 + k) / 2)))
        return known + self.medium.pressure_scale / (1 + k) * integral

    def _displacement(self, depth: tuple[Case, ...]) -> tuple[Status, tuple[Case, ...]]:
        status: Status = "closed"
        cases = []
        for regime in depth:
            for chain in insert(regime.chain, r, above=a):
                form = self.reduced.displacement(Order(chain))
                if form is not None:
                    cases.append(Case(chain, self._close(form * self.medium.displacement_scale)))
                else:
                    status = "integral"
                    cases.append(Case(chain, self._displacement_integral(chain, regime, cases)))
        return status, tuple(cases)

    def _displacement_integral(self, chain: Chain, regime: Case, earlier: list[Case]) -> sp.Expr:
        """(11.26) resp. (11.56) in t = r sin(psi); what lies below a break is known already."""
        k, scale, radius = self.medium.k, self.medium.displacement_scale, r * sp.sin(psi)
        if k == 0:
            kernel = sp.diff(regime.expr, a).subs(a, radius) * r * sp.cos(psi) * psi
        else:
            kernel = sp.tan(psi) ** k * (regime.expr - regime.expr.subs(a, radius))
        crossed = [b for b in self.profile.breaks if chain.index(b) < chain.index(a)]
        if not crossed:
            return scale * sp.Integral(kernel, (psi, 0, sp.asin(a / r)))
        b = crossed[-1]
        inner = [case.expr for case in earlier if case.below(a, b) and case.below(b, r)]
        known = inner[0].subs(a, b) if inner else sp.S.Zero
        if k != 0:  # the flat punch of radius b takes part in the growth from b to a
            growth = regime.expr - regime.expr.subs(a, b)
            known = known + growth * self.medium.punch_displacement().expr().subs(a, b)
        return known + scale * sp.Integral(kernel, (psi, sp.asin(b / r), sp.asin(a / r)))

    def _greatest(self, depth: tuple[Case, ...], pressure: tuple[Case, ...]) -> dict[str, Entry]:
        found = peak.derive(self.profile, depth, pressure) if self.medium.k == 0 else None
        if found is None:
            return {}
        status, radius, greatest = found
        return {"rp": self._entry("rp", status, radius), "pp": self._entry("pp", "closed", greatest)}

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
            value = equation[0].expr.rhs
            cases = tuple(
                Case(inverse.chain, _compose(case.expr, inverse.expr, value))
                for inverse, case in zip(radius, outer, strict=True)
            )
            short = all(_is_monomial(inverse.expr, value) for inverse in radius)
            entries[suffix] = self._entry(suffix, "closed", cases, composed=None if short else route)
        return entries


def _is_monomial(expr: sp.Expr, value: sp.Symbol) -> bool:
    power = expr.as_independent(value, as_Add=False)[1]
    base = power.as_base_exp()[0]
    return bool(base == value or (base.is_Mul and base.as_independent(value, as_Add=False)[1] == value))


def _compose(outer: sp.Expr, inner: sp.Expr, value: sp.Symbol) -> sp.Expr:
    """outer(a = inner); the powers of a monomial are merged: (d/k)**(1/n) raised to n + 1."""
    # every radicand here is positive; SymPy 1.12 leaves sqrt(x**2) where later ones say |x|
    expr = outer.subs(a, inner).replace(sp.Abs, lambda inside: inside)
    expr = expr.replace(_is_root_of_square, lambda root: root.base.base)
    if not _is_monomial(inner, value):
        return expr
    return sp.powdenest(sp.powsimp(expr, combine="exp"), force=True)


def _is_root_of_square(expr: sp.Expr) -> bool:
    return bool(expr.is_Pow and expr.exp == sp.S.Half and expr.base.is_Pow and expr.base.exp == 2)


def _summand(pieces: tuple[Piece, ...]) -> tuple[tuple[Piece, ...], bool]:
    """A sum over powers is derived through its summand, with the coefficient set to one."""
    if len(pieces) == 1 and isinstance(pieces[0].expr, sp.Sum):
        term = pieces[0].expr.function
        return (Piece(None, term / coefficients[j]),), True
    return pieces, False
