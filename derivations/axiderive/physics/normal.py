"""Normal contact of a profile that touches in a growing circle.

Normal contact without adhesion: every quantity of every profile as an entry.

Prefactors and definitions are those of chapter 11: depth (11.29), force
(11.20), pressure (11.23), displacement (11.26) with r > a, stiffness (11.18);
on the power-law graded half-space (11.61), (11.51), (11.53), (11.56), (11.46).

Closed inverses a(d) and a(F), where the forward formula allows one.

Four shapes are recognised: a monomial in a; a multiple of S = sqrt(a^2 - b^2);
alpha a^2 + beta a S, a quadratic for a^2; and a depressed cubic in S with positive
coefficients, which has one real root in sinh form.  The right root is chosen by
the certificate's witness, never by trying.  With adhesion the forward formula is
alpha y^2 - beta y in a power y of a for the paraboloid's force and the cone's depth.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..abel.form import Chain, Form, Order, insert
from ..abel.reduce import Reduced, parse
from ..entry import COMPACT, COMPLETE, Case, Entry, Primitive, Status
from ..notation import F, N, a, coefficients, d, f, g, j, p, psi, r, r_peak, t, u
from ..profiles.profile import Piece, Profile
from . import Physics, Printing, Rule, Wording, complete, peak
from .consequences import CONSEQUENCES
from .medium import GRADED, HOMOGENEOUS, Medium

_S = sp.Symbol("S", positive=True)


def closed_inverse(cases: tuple[Case, ...], value: sp.Symbol) -> tuple[Case, ...] | None:
    """Cases of a as a function of `value`, in the order of the forward cases, or None."""
    out = []
    for case in cases:
        inverse = _invert(case.expr, value)
        if inverse is None:
            return None
        out.append(Case(_chain(case, value, len(cases)), inverse))
    return tuple(out)


def _chain(case: Case, value: sp.Symbol, total: int) -> tuple[sp.Expr, ...]:
    """The regime in terms of the value: a < b becomes value < formula at a = b."""
    if total == 1:
        return ()
    i = case.chain.index(a)
    if i + 1 < len(case.chain):
        return (value, case.expr.subs(a, case.chain[i + 1]))
    return (case.expr.subs(a, case.chain[i - 1]), value)


def _invert(expr: sp.Expr, value: sp.Symbol) -> sp.Expr | None:
    if expr.has(sp.Sum):
        return None
    factor, power = expr.as_independent(a, as_Add=False)
    base, exponent = power.as_base_exp()
    if base == a and not exponent.has(a):
        return (value / factor) ** (1 / exponent)
    roots = [e for e in expr.atoms(sp.Pow) if e.exp == sp.S.Half and e.has(a)]
    if len(roots) != 1 or any(fn.has(a) for fn in expr.atoms(sp.Function)):
        return None
    square = sp.expand(a**2 - roots[0].base)
    if square.has(a):
        return None
    b = sp.sqrt(square)
    polynomial = sp.Poly(sp.expand(expr.subs(roots[0], _S)), a, _S)
    terms = dict(polynomial.terms())
    if set(terms) <= {(2, 0), (1, 1)}:
        return _quadratic(terms.get((2, 0), sp.S.Zero), terms[1, 1], b, value)
    if any(power % 2 for power, _ in terms):
        return None
    in_S = sp.Poly(sp.expand(polynomial.as_expr().subs(a, sp.sqrt(_S**2 + b**2))), _S)
    if in_S.monoms() == [(1,)]:
        return sp.sqrt(b**2 + sp.factor(value / in_S.LC()) ** 2)
    if {m for (m,) in in_S.monoms()} == {1, 3}:
        return _cubic(in_S.coeff_monomial(_S**3), in_S.coeff_monomial(_S), b, value)
    return None


def stable_inverse(forward: sp.Expr, value: sp.Symbol) -> sp.Expr | None:
    """The larger root a of alpha y^2 - beta y = value with y = a^e, or None if the formula has another shape.

    The larger root is the branch on which the value grows with a.
    """
    terms = [term.as_independent(a, as_Add=False) for term in sp.Add.make_args(sp.expand_mul(forward))]
    powers = {sp.expand(power.as_base_exp()[1]): factor for factor, power in terms if power.as_base_exp()[0] == a}
    if len(terms) != 2 or len(powers) != 2:
        return None
    exponent = next((e for e in powers if sp.expand(2 * e) in powers), None)
    if exponent is None:
        return None
    alpha, beta = powers[sp.expand(2 * exponent)], -powers[exponent]
    half = sp.factor(beta / (2 * alpha))
    return (half + sp.sqrt(half**2 + sp.factor(value / alpha))) ** sp.cancel(1 / exponent)


def _quadratic(alpha: sp.Expr, beta: sp.Expr, b: sp.Expr, value: sp.Symbol) -> sp.Expr:
    """alpha a^2 + beta a S = value: squared, (alpha^2 - beta^2) a^4 + (beta^2 b^2 - 2 alpha value) a^2 + value^2 = 0.

    The root with alpha a^2 < value is 2 value^2 / (2 alpha value - beta^2 b^2 + beta W); written this way
    it neither cancels nor needs the sign of alpha - beta.
    """
    W = sp.sqrt(sp.factor(beta**2 * b**4 - 4 * alpha * value * b**2 + 4 * value**2))
    if alpha == 0:  # conjugate: W^2 - (beta b^2)^2 = 4 value^2
        return sp.sqrt((beta * b**2 + W) / (2 * beta))
    return value * sp.sqrt(2) / sp.sqrt(2 * alpha * value - beta**2 * b**2 + beta * W)


def _cubic(third: sp.Expr, first: sp.Expr, b: sp.Expr, value: sp.Symbol) -> sp.Expr:
    """third S^3 + first S = value through sinh(3 y) = 4 sinh(y)^3 + 3 sinh(y)."""
    scale = 2 * sp.sqrt(sp.cancel(first / (3 * third)))
    S = scale * sp.sinh(sp.asinh(sp.cancel(4 * value / (third * scale**3))) / 3)
    return sp.sqrt(b**2 + S**2)


QUANTITIES = {
    "compact": COMPACT | {suffix: own.compact for suffix, own in CONSEQUENCES.items()},
    "complete": COMPLETE | {suffix: own.complete for suffix, own in CONSEQUENCES.items()},
}
"""By the kind of contact."""
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
NOWHERE: tuple[tuple[str, ...], ...] = ((), ())
"""References of what chapter 11 does not state."""


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
        **{suffix: own.definition for suffix, own in CONSEQUENCES.items()},
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
    if profile.complete:
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

    def close(self, form: Form) -> sp.Expr:
        """A reduced quantity as an expression, summed over the powers of a polynomial."""
        expr = form.expr()
        if not self.summed:
            return expr
        outside, inside = expr.as_independent(j)
        return outside * sp.Sum(coefficients[j] * inside, (j, 1, N))

    def entries(self) -> dict[str, Entry]:
        """All entries by suffix: forward quantities, the greatest pressure where it is known, and inverses."""
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
        if not self.medium.graded:
            found = {suffix: own.derive(self, entries) for suffix, own in CONSEQUENCES.items()}
            entries |= {suffix: self._entry(suffix, *stated) for suffix, stated in found.items()}
        return entries | self._greatest(depth, pressure_status, pressure) | self._inverses(depth, force)

    def _force(self, scale: sp.Expr) -> tuple[Case, ...]:
        return tuple(Case(c, self.close(self.reduced.force(Order(c)) * scale)) for c in self.chains)

    def _entry(
        self,
        suffix: str,
        status: Status,
        cases: tuple[Case, ...],
        primitives: dict[Chain, tuple[Primitive, ...]] | None = None,
        composed: tuple[str, str] | None = None,
    ) -> Entry:
        quantity = QUANTITIES["compact"][suffix]
        material = self.medium.moduli if quantity.elastic else self.medium.moduli[1:]
        return Entry(
            key=self.medium.key(self.profile.name, self.medium.group, suffix),
            profile=self.profile,
            quantity=quantity,
            status=status,
            cases=cases,
            definition=definitions(self.medium)[suffix],
            parameters=self.profile.parameters + material,
            references=REFERENCES.get(suffix, NOWHERE)[self.medium.k != 0],
            primitives=primitives or {},
            composed=composed,
        )

    def _depth(self) -> tuple[tuple[Case, ...], dict[Chain, tuple[Primitive, ...]]]:
        cases, primitives = [], {}
        for chain in self.chains:
            form = self.reduced.depth(Order(chain))
            cases.append(Case(chain, self.close(form)))
            primitives[chain] = self.reduced.primitives(Order(chain))
        return tuple(cases), primitives

    def _pressure(self, depth: tuple[Case, ...]) -> tuple[Status, tuple[Case, ...]]:
        status: Status = "closed"
        cases: list[Case] = []
        for regime in depth:
            for chain in insert(regime.chain, r, below=a):
                form = self.reduced.pressure(Order(chain))
                if form is not None:
                    cases.append(Case(chain, self.close(form * self.medium.pressure_scale)))
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
                    cases.append(Case(chain, self.close(form * self.medium.displacement_scale)))
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

    def _greatest(self, depth: tuple[Case, ...], status: Status, pressure: tuple[Case, ...]) -> dict[str, Entry]:
        known = self.medium.k == 0 and (status == "closed" or peak.has_falling_curvature(self.profile))
        found = peak.derive(self.profile, depth, pressure) if known else None
        if found is None:
            return {}
        placed, radius, greatest = found
        return {"rp": self._entry("rp", placed, radius), "pp": self._entry("pp", status, greatest)}

    def _inverses(self, depth: tuple[Case, ...], force: tuple[Case, ...]) -> dict[str, Entry]:
        radius_d, radius_F = closed_inverse(depth, d), closed_inverse(force, F)
        equation_d = tuple(Case(case.chain, sp.Eq(case.expr, d)) for case in depth)
        equation_F = tuple(Case(case.chain, sp.Eq(case.expr, F)) for case in force)
        entries = {
            "ad": self._entry("ad", "closed" if radius_d else "root", radius_d or equation_d),
            "aF": self._entry("aF", "closed" if radius_F else "root", radius_F or equation_F),
        }
        for suffix, radius, outer, equation in (
            ("Fd", radius_d, force, equation_d), ("dF", radius_F, depth, equation_F),
        ):  # fmt: skip
            route = COMPACT[suffix].composed
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


def rules(medium: Medium, printing: Printing) -> dict[str, Rule]:
    """The fields as one regular integral each, and the mean pressure, on the graded half-space only; p at its peak."""
    if not medium.graded:
        where = {"": "", "inside": r"r\le a", "outside": r"r\ge a"}
        further = {key: Rule(own.printed, where=where[own.compact.place]) for key, own in CONSEQUENCES.items()}
        return {"pp": Rule(r"p_{\mathrm{max}}=p(r_{\mathrm{max}})"), **further}
    k, printer = medium.k, printing((r, a))
    scale = printer(medium.pressure_scale / (1 + k))
    span = printer((a**2 - r**2) ** ((1 + k) / 2))
    radius = printer(sp.sqrt(r**2 + u ** (2 / (1 + k))))
    outside = printer(medium.displacement_scale)
    return {
        "pm": Rule(r"\bar p=\frac{F_{\mathrm N}(a)}{\pi a^{2}}"),
        "p": Rule(
            rf"p(r)={scale}\int_{{0}}^{{y}} \frac{{g'(t)}}{{t}}\,\mathrm{{d}}u,\qquad t={radius},\quad y={span}",
            where=r"r\le a",
        ),
        "w": Rule(
            rf"w(r)={outside}\int_{{0}}^{{y}} \bigl[g(a)-g(r\sin\psi)\bigr]\tan^{{{printer(k)}}}\psi"
            rf"\,\mathrm{{d}}\psi,\qquad y={printer(sp.asin(a / r))}",
            where=r"r\ge a",
        ),
    }


PHYSICS = Physics(
    "normal",
    {
        HOMOGENEOUS: Wording(
            place=1,
            title="Normal contact without adhesion",
            heading="Normal contact",
            package="Normal contact without adhesion of a rigid indenter on an elastic half-space",
            searched="indentation",
            by_rule=("k",),
            subject="rounded_punch",
        ),
        GRADED: Wording(
            place=4,
            title="Normal contact, graded half-space",
            heading="Power-law graded half-space",
            note=r"$c_{\mathrm N}(x)=H|x|^k$, $-1<k<1$",
            package="Normal contact of a rigid indenter with a power-law graded half-space",
            searched="FGM functionally graded gradient",
            button="graded",
            by_rule=("k", "pm", "aF", "dF"),
            by_rule_complete=("k", "dF"),
            subject="quartic.fgm",
        ),
    },
    derive,
    contact="without adhesion",
    runtime=("physics.unknowns",),
    quantities=QUANTITIES,
    wanted=("depth", "force", "pressure", "displacement"),
    compared="mpmath quadrature of the definition",
    rules=rules,
)
