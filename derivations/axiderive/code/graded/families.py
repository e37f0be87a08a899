"""A profile as a sum of the shapes whose graded integrals the runtime holds, read off its atoms."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from ...abel.atoms import CosineAtom, GaussianAtom, HyperboloidAtom, PowerAtom, SphereAtom
from ...abel.reduce import NotReducibleError, parse
from ...notation import coefficients, j
from ...profiles.profile import Profile
from ..physics.branches import root_beyond
from ..text import python

ROOTED = ("flank", "rim", "rounding", "rounded", "tipped")
"""Shapes whose growth is written in a and sqrt(a**2 - b**2)."""


@dataclass(frozen=True)
class Term:
    """coefficient times a shape of the runtime, with the lengths or the exponent that shape takes."""

    coefficient: sp.Expr
    shape: str
    lengths: tuple[sp.Expr, ...]

    def call(self, quantity: str, *fields: str) -> str:
        """The coefficient times `shape_quantity(fields, lengths, k)`."""
        lengths = [] if self.shape == "sphere" and quantity in GROWTH else self.texts
        return self.times(f"{self.shape}_{quantity}({', '.join([*fields, *lengths, 'k'])})")

    @property
    def texts(self) -> list[str]:
        """The lengths or the exponent in the interface."""
        return [_text(length) for length in self.lengths]

    def times(self, value: str) -> str:
        """The coefficient times a value."""
        return python(sp.factor(self.coefficient) * VALUE).replace(VALUE.name, value)


GROWTH = ("depth", "rate", "force")
VALUE = sp.Symbol("value", positive=True)


@dataclass(frozen=True)
class Family:
    """The terms of a profile and how its contact radius is reached."""

    profile: Profile
    terms: tuple[Term, ...]
    summed: bool
    root: str
    """Text of the second argument of the growth, "" where it takes the radius alone."""

    @property
    def power(self) -> Term | None:
        """The term of a profile that is one power of r."""
        return self.terms[0] if len(self.terms) == 1 and self.terms[0].shape == "power" and not self.summed else None

    def has(self, *shapes: str) -> bool:
        """Whether any term has one of these shapes."""
        return any(term.shape in shapes for term in self.terms)

    def total(self, quantity: str, *fields: str) -> str:
        """The sum over the terms."""
        parts = []
        for term in self.terms:
            own = fields if term.shape in (*ROOTED, "sphere") or quantity not in GROWTH else fields[:1]
            parts.append(term.call(quantity, *own))
        text = " + ".join(parts)
        # a pressure may be infinite on the axis, also one that no coefficient asks for
        asked = " if A_j" if quantity == "pressure" else ""
        return f"sum({text} for j, A_j in enumerate(A, 1){asked})" if self.summed else text


def _text(length: sp.Expr) -> str:
    text = python(sp.sympify(length))
    return f"{text}.0" if text.isdigit() else text


def family(profile: Profile) -> Family:
    """The terms of a profile with a compact contact.

    Raises
    ------
    NotReducibleError
        If an atom has no shape in the runtime.
    """
    pieces = profile.pieces
    if profile.parameters == (coefficients,):
        own = Term(sp.Symbol("A_j", positive=True), "power", (j,))
        return Family(profile, (own,), True, "")
    atoms = parse(pieces).atoms
    terms = _tipped(profile, atoms) or (*_smooth(atoms), *_broken(atoms))
    terms = _rounded(terms)
    root = ""
    if any(term.shape in ROOTED for term in terms):
        root = root_beyond(profile)
    elif any(term.shape == "sphere" for term in terms):
        root = f"difference_root({profile.chain[-1]}, a)"
    return Family(profile, tuple(terms), False, root)


def _smooth(atoms: tuple[object, ...]) -> list[Term]:
    terms = []
    for atom in atoms:
        match atom:
            case PowerAtom(c=c, n=n, b=sp.S.Zero):
                terms.append(Term(c, "power", (n,)))
            case SphereAtom(c=c, R=R, cap=sp.S.Zero):
                terms.append(Term(c, "sphere", (R,)))
            case HyperboloidAtom(c=c, b=b):
                terms.append(Term(c, "hyperboloid", (b,)))
            case GaussianAtom(h=h, s=s):
                terms.append(Term(h, "gaussian", (s,)))
            case CosineAtom(h=h, q=q):
                terms.append(Term(h, "waves", (q,)))
            case PowerAtom():
                pass
            case _:
                message = f"{atom} has no graded integrals in the runtime; add its depth, rate, force, pressure and sag"
                raise NotReducibleError(message)
    return terms


def _broken(atoms: tuple[object, ...]) -> list[Term]:
    """f' = c_1 + 2 c_2 r beyond b as flank, rim or, where it starts from zero, rounding."""
    own = [atom for atom in atoms if isinstance(atom, PowerAtom) and atom.b != 0]
    if not own:
        return []
    b = own[0].b
    slopes = {n: sp.Add(*(atom.c * n for atom in own if atom.n == n)) for n in (1, 2)}
    if any(atom.n not in (1, 2) or atom.b != b for atom in own):
        message = f"{own} are no straight or parabolic pieces beyond one break; add their graded integrals"
        raise NotReducibleError(message)
    flank, rim = slopes[1], slopes[2]
    if sp.cancel(flank + rim * b) == 0:
        return [Term(rim, "rounding", (b,))]
    return [Term(c, name, (b,)) for c, name in ((flank, "flank"), (rim, "rim")) if c != 0]


def _rounded(terms: tuple[Term, ...]) -> tuple[Term, ...]:
    """A parabola less its rounding is a cone beyond b: one shape of positive terms."""
    if len(terms) == 2 and terms[0].shape == "power" and terms[1].shape == "rounding":
        tip, rounding = terms
        if tip.lengths == (2,) and sp.cancel(2 * tip.coefficient + rounding.coefficient) == 0:
            (b,) = rounding.lengths
            return (Term(sp.cancel(-rounding.coefficient * b), "rounded", (b,)),)
    return terms


def _tipped(profile: Profile, atoms: tuple[object, ...]) -> tuple[Term, ...]:
    caps = [atom for atom in atoms if isinstance(atom, SphereAtom) and atom.cap != 0]
    if not caps:
        return ()
    (cap,) = caps
    (flank,) = (atom for atom in atoms if atom is not cap)
    tangent = cap.c * cap.cap / sp.sqrt(cap.R**2 - cap.cap**2)
    if not (isinstance(flank, PowerAtom) and flank.n == 1 and sp.cancel(flank.c / tangent) == 1):
        message = f"{profile.name}: a spherical tip needs its tangent cone; add the graded integrals of {flank}"
        raise NotReducibleError(message)
    # sqrt(R**2 - b**2), of which b = R sin(theta) has too few digits left close to a needle
    end = dict(profile.abbreviations)[cap.cap].replace(sp.sin, sp.cos)
    return (Term(cap.c, "tipped", (cap.R, cap.cap, end)),)
