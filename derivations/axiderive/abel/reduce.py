"""From f(r) to atoms, and from atoms to the four reduced quantities.

`parse` reads the pieces of a profile; it always verifies that the atoms add up
to f again, because a wrong split would give a correctly proved answer for the
wrong profile.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from ..entry import Primitive
from ..notation import r
from ..profiles.profile import Piece
from .atoms import Atom, CosineAtom, ExponentialAtom, GaussianAtom, HyperboloidAtom, PowerAtom, SphereAtom
from .form import Form, Order
from .moments import ZERO


class NotReducibleError(ValueError):
    """The profile is not a sum of known atoms."""


@dataclass(frozen=True)
class Reduced:
    """A profile as a sum of atoms, with the exponent of grading k; all quantities without prefactors."""

    atoms: tuple[Atom, ...]
    k: sp.Expr = ZERO

    def _total(self, name: str, order: Order) -> Form | None:
        forms = [getattr(atom, name)(order, self.k) for atom in self.atoms]
        return None if any(form is None for form in forms) else Form.total(forms)

    def _known(self, name: str, order: Order) -> Form:
        form = self._total(name, order)
        if form is None:
            message = f"no closed {name} is known for the sum of {self.atoms} with k = {self.k}; use k = 0"
            raise NotReducibleError(message)
        return form

    def depth(self, order: Order) -> Form:
        """g(a); `NotReducibleError` if it is not known for one of the atoms."""
        return self._known("depth", order)

    def force(self, order: Order) -> Form:
        """F^(a); `NotReducibleError` if it is not known for one of the atoms."""
        return self._known("force", order)

    def pressure(self, order: Order) -> Form | None:
        """P^(r) for r < a, or None if it is not known for one of the atoms."""
        return self._total("pressure", order)

    def displacement(self, order: Order) -> Form | None:
        """W^(r) for r > a, or None if it is not known for one of the atoms."""
        return self._total("displacement", order)

    def primitives(self, order: Order) -> tuple[Primitive, ...]:
        """The antiderivatives of all atoms, one after the other."""
        return tuple(primitive for atom in self.atoms for primitive in atom.primitives(order, self.k))

    def shape(self, order: Order) -> sp.Expr:
        """f(r) as the sum over the atoms, on this order of the lengths."""
        return sp.Add(*(atom.shape(order) for atom in self.atoms))


def _power(term: sp.Expr, lower: sp.Expr) -> Atom | None:
    factor, rest = term.as_independent(r, as_Add=False)
    # multiplying out writes r**(n + 1) as r*r**n
    base, exponent = sp.powsimp(rest, combine="exp").as_base_exp()
    return PowerAtom(factor, exponent, lower) if base == r and not exponent.has(r) else None


def _radical(term: sp.Expr) -> Atom | None:
    """-c sqrt(R^2 - r^2) or c sqrt(r^2 + b^2), with any positive scale inside the root."""
    factor, rest = term.as_independent(r, as_Add=False)
    if not (rest.is_Pow and rest.exp == sp.S.Half):
        return None
    inside = sp.Poly(sp.expand(rest.base), r)
    if inside.degree() != 2 or inside.coeff_monomial(r) != 0:
        return None
    curvature, constant = inside.coeff_monomial(r**2), inside.coeff_monomial(1)
    length = sp.sqrt(sp.cancel(constant / abs(curvature)))
    scale = factor * sp.sqrt(abs(curvature))
    if curvature.is_negative:
        return SphereAtom(-scale, length)
    return HyperboloidAtom(scale, length)


def _transcendental(term: sp.Expr) -> Atom | None:
    factor, rest = term.as_independent(r, as_Add=False)
    argument = rest.args[0] if rest.is_Function or isinstance(rest, sp.exp) else ZERO
    if isinstance(rest, sp.cos) and not (argument / r).has(r):
        return CosineAtom(-factor, argument / r)
    if isinstance(rest, sp.exp):
        for kind, power in ((GaussianAtom, 2), (ExponentialAtom, 1)):
            rate = -argument / r**power
            if not rate.has(r) and rate.is_positive:
                return kind(-factor, rate ** (-sp.Rational(1, power)))
    return None


def _atom(term: sp.Expr, lower: sp.Expr) -> Atom:
    atom = _power(term, lower)
    if atom is None and lower == 0:
        atom = _radical(term) or _transcendental(term)
    if atom is None:
        message = f"{term} is not a power of r, a sphere, a hyperboloid, 1 - cos or 1 - exp: no atom is known for it"
        raise NotReducibleError(message)
    return atom


def parse(pieces: Sequence[Piece], k: sp.Expr = ZERO) -> Reduced:
    """The atoms of a continuous profile with f(0) = 0, given by ascending pieces.

    Raises
    ------
    NotReducibleError
        If a term has no atom.
    ValueError
        If the pieces do not start at 0 or are not continuous.
    """
    atoms: list[Atom] = []
    breaks: list[sp.Expr] = []
    lower, previous = ZERO, ZERO
    for piece in pieces:
        jump = sp.expand(piece.expr - previous)
        step = sp.expand(jump.subs(r, lower))
        if step != 0:
            message = f"the profile must start at 0 and be continuous, but it jumps by {step} at r = {lower}"
            raise ValueError(message)
        for term in sp.Add.make_args(jump):
            if not term.has(r):
                continue
            cancelled = _cap(atoms, term, lower)
            if cancelled is not None:
                atoms = cancelled
            else:
                atoms.append(_atom(term, lower))
        _verify(atoms, piece, breaks)
        breaks.append(piece.upper)
        lower, previous = piece.upper, piece.expr
    return Reduced(tuple(atoms), k)


def _cap(atoms: list[Atom], term: sp.Expr, lower: sp.Expr) -> list[Atom] | None:
    """End a spherical tip at `lower` if `term` takes its root away."""
    if lower == 0:
        return None
    for i, atom in enumerate(atoms):
        if isinstance(atom, SphereAtom) and atom.cap == 0 and term == atom.c * sp.sqrt(atom.R**2 - r**2):
            return [*atoms[:i], SphereAtom(atom.c, atom.R, lower), *atoms[i + 1 :]]
    return None


def _split_roots(expr: sp.Expr) -> sp.Expr:
    """sqrt(1 - r^2/b^2) as sqrt(b^2 - r^2)/b, so that equal radicals look equal."""

    def split(power: sp.Expr) -> sp.Expr:
        top, bottom = sp.fraction(sp.together(power.base))
        return top**power.exp / bottom**power.exp

    return expr.replace(lambda e: e.is_Pow and e.exp == sp.S.Half, split)


def _verify(atoms: Sequence[Atom], piece: Piece, breaks: Sequence[sp.Expr]) -> None:
    """`breaks` are those below the piece."""
    chain = (*breaks, r) if piece.upper is None else (*breaks, r, piece.upper)
    rebuilt = sp.Add(*(atom.shape(Order(chain)) for atom in atoms))
    if sp.expand(_split_roots(rebuilt) - _split_roots(piece.expr)) != 0:
        message = f"the atoms add up to {rebuilt}, not to {piece.expr}, where {' < '.join(map(str, chain))}"
        raise AssertionError(message)
