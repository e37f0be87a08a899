"""Any profile with piecewise smooth f and f(0) = 0: every quantity as a regular integral over the profile.

With s = a sin(psi) the integrals (11.29), (11.20) and (11.26) over f' are
regular; the order of integration is exchanged where two were iterated.  The
pressure (11.23) is one integral over g'(t), which is one over (s f')'.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ..abel.form import Chain, insert
from ..entry import COMPACT, Case, Entry, Status
from ..notation import E_star, a, psi, r, t, u
from ..profiles.profile import Profile
from .medium import HOMOGENEOUS
from .normal import REFERENCES, definitions

excess = sp.Symbol("excess", positive=True)
"""r - b beyond a break b."""


@dataclass(frozen=True)
class Layer:
    """What a break adds to the profile: f changes by `shape` beyond `start` (0 for the tip)."""

    start: sp.Expr
    shape: sp.Expr

    @property
    def slope(self) -> sp.Expr:
        """df/dr of the shape."""
        return steepness(self.shape)

    @property
    def bend(self) -> sp.Expr:
        """(s f')'."""
        return self.slope + r * steepness(self.slope)

    @property
    def kink(self) -> sp.Expr:
        """Jump of f' at the break."""
        return sp.S.Zero if self.start == 0 else sp.expand(beyond(self.slope, self.start).subs(excess, 0))


def steepness(expr: sp.Expr) -> sp.Expr:
    """df/dr with tanh for sinh/cosh, whose parts overflow."""
    slope = sp.diff(expr, r)
    return slope.replace(sp.sinh, lambda x: sp.tanh(x) * sp.cosh(x)) if slope.has(sp.cosh) else slope


def beyond(expr: sp.Expr, start: sp.Expr) -> sp.Expr:
    """An expression in r as one in the excess over a break, in whose powers it keeps its digits next to the break."""
    moved = expr.subs(r, start + excess)
    if moved.is_polynomial(excess):
        return sp.Add(*(sp.factor(c) * excess**power for (power,), c in sp.Poly(moved, excess).terms()))
    return min((moved, sp.expand_mul(moved)), key=lambda form: (sp.count_ops(form), sp.sstr(form)))


def layers(profile: Profile) -> tuple[Layer, ...]:
    """The profile as a sum of what begins at the tip and at every break."""
    found, below = [], sp.S.Zero
    for start, piece in zip((sp.S.Zero, *profile.breaks), profile.pieces, strict=True):
        shape = sp.expand(piece.expr - below)
        if shape != 0:
            found.append(Layer(start, shape))
        below = piece.expr
    return tuple(found)


def rate(layer: Layer) -> sp.Expr:
    """g'(t) of a layer for t beyond its start."""
    b = layer.start
    whole = sp.Integral(layer.bend.subs(r, t * sp.cos(psi)), (psi, 0, sp.pi / 2 if b == 0 else sp.acos(b / t)))
    return whole if b == 0 else whole + b * layer.kink / sp.sqrt(t**2 - b**2)


def derive(profile: Profile) -> dict[str, Entry]:
    """All entries of a compact profile, none of them closed but the stiffness."""
    return _General(profile).entries()


class _General:
    def __init__(self, profile: Profile) -> None:
        self.profile = profile
        above = profile.breaks[0] if profile.truncated else None
        self.chains = tuple(insert(profile.breaks, a, above=above))

    def entries(self) -> dict[str, Entry]:
        """All entries by suffix: integrals, inverses as equations, and the stiffness, which is closed."""
        depth = self._over_pieces(sp.S.One, a)
        force = self._over_pieces(sp.sin(psi) ** 2, HOMOGENEOUS.force_scale * a**2)
        mean = self._over_pieces(sp.sin(psi) ** 2, HOMOGENEOUS.force_scale / sp.pi)
        entries = {
            "d": self._entry("d", "integral", depth),
            "F": self._entry("F", "integral", force),
            "p": self._entry("p", "integral", self._pressure()),
            "w": self._entry("w", "integral", self._displacement()),
            "k": self._entry("k", "closed", (Case((a,), HOMOGENEOUS.stiffness()),)),
            "pm": self._entry("pm", "integral", mean),
        }
        for quantity in (q for q in COMPACT.values() if q.inverts):
            (value,) = quantity.arguments
            cases = tuple(Case(case.chain, sp.Eq(case.expr, value)) for case in entries[quantity.inverts].cases)
            entries[quantity.suffix] = self._entry(quantity.suffix, "root", cases, quantity.composed)
        return entries

    def _entry(
        self, suffix: str, status: Status, cases: tuple[Case, ...], composed: tuple[str, str] | None = None
    ) -> Entry:
        material = (E_star,) if COMPACT[suffix].elastic else ()
        return Entry(
            key=f"{self.profile.name}.{suffix}",
            profile=self.profile,
            quantity=COMPACT[suffix],
            status=status,
            cases=cases,
            definition=definitions()[suffix],
            parameters=self.profile.parameters + material,
            references=REFERENCES[suffix][0],
            composed=composed,
        )

    def _over_pieces(self, weight: sp.Expr, scale: sp.Expr) -> tuple[Case, ...]:
        return tuple(Case(chain, scale * self._integral(chain, weight)) for chain in self.chains)

    def _integral(self, chain: Chain, weight: sp.Expr) -> sp.Expr:
        """int f'(a sin psi) weight dpsi over the pieces below a."""
        total, lower = sp.S.Zero, sp.S.Zero
        for piece in self.profile.pieces:
            last = piece.upper is None or chain.index(a) < chain.index(piece.upper)
            upper = sp.pi / 2 if last else sp.asin(piece.upper / a)
            slope = steepness(piece.expr).subs(r, a * sp.sin(psi))
            if slope != 0:
                total += sp.Integral(slope * weight, (psi, lower, upper))
            if last:
                break
            lower = upper
        return total

    def _displacement(self) -> tuple[Case, ...]:
        root = sp.sqrt(r**2 - a**2)
        weight = a * sp.asin(a / r) - a * sp.cos(psi) * sp.atan(a * sp.cos(psi) / root)
        cases = []
        for own in self.chains:
            inner = self._integral(own, weight)
            cases += [Case(chain, HOMOGENEOUS.displacement_scale * inner) for chain in insert(own, r, above=a)]
        return tuple(cases)

    def _pressure(self) -> tuple[Case, ...]:
        cases = []
        radius = sp.sqrt(r**2 + u**2)
        for own in self.chains:
            for chain in insert(own, r, below=a):
                total = sp.S.Zero
                for layer in layers(self.profile):
                    b = layer.start
                    if b != 0 and chain.index(a) < chain.index(b):
                        continue
                    inside = b != 0 and chain.index(r) < chain.index(b)
                    lower = sp.sqrt(b**2 - r**2) if inside else sp.S.Zero
                    growth = rate(layer).subs(t, radius) / radius
                    total += sp.Integral(growth, (u, lower, sp.sqrt(a**2 - r**2)))
                cases.append(Case(chain, HOMOGENEOUS.pressure_scale * total))
        return tuple(cases)
