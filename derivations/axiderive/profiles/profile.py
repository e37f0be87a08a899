"""What a profile is: the shape f(r) and what the handbook says about it - data, no algebra."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, TypeVar

import sympy as sp

from .. import notation


def unknown(name: str, known: Iterable[str], words: str) -> KeyError:
    """What a name that is none is refused with: the nearest one there is."""
    near = difflib.get_close_matches(name, tuple(known), n=1)
    return KeyError(f"{words} {name!r}" + (f"; did you mean {near[0]!r}?" if near else ""))


@dataclass(frozen=True)
class Piece:
    """f(r) = expr for r up to `upper` (None: to the end)."""

    upper: sp.Expr | None
    expr: sp.Expr


@dataclass(frozen=True)
class Rule:
    """A condition between parameters, checked by the generated functions: `left <= right` or `left < right`.

    `reason` completes the sentence "... because" of the error message, with the next step.
    """

    left: sp.Expr
    right: sp.Expr
    strict: bool
    reason: str

    def relation(self) -> sp.Expr:
        """The condition as an inequality of SymPy."""
        return (sp.StrictLessThan if self.strict else sp.LessThan)(self.left, self.right)


@dataclass(frozen=True)
class Limit:
    """`target` is reached from this profile when `symbol` tends to `value`."""

    target: str
    symbol: sp.Symbol
    value: sp.Expr


@dataclass(frozen=True)
class Sketch:
    """Numbers the picture is drawn with, and the names of the dimensions to show."""

    values: tuple[tuple[sp.Symbol, float], ...]
    a: float
    d: float | None = None


@dataclass(frozen=True)
class Profile:
    """One indenter profile."""

    name: str
    title: str
    subtitle: str
    contact: Literal["compact", "complete", "prescribed", "none"]
    parameters: tuple[sp.Symbol, ...]
    pieces: tuple[Piece, ...]
    validity: str
    sources: tuple[str, ...]
    sketch: Sketch
    abbreviations: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    rules: tuple[Rule, ...] = ()
    chain: tuple[sp.Expr, ...] = ()
    """Ordering that always holds, e.g. (a, R) for the sphere: a < R."""
    largest: sp.Expr | None = None
    """Largest contact radius, where it is not the end of `chain`: beyond it the contact is not compact."""
    limits: tuple[Limit, ...] = ()
    synonyms: tuple[str, ...] = ()
    note: str = ""
    meanings: tuple[tuple[sp.Symbol, str], ...] = ()
    """What a letter means in this profile, where the notation says less."""

    @property
    def compact(self) -> bool:
        """Whether the contact grows with the load: its radius is asked for."""
        return self.contact == "compact"

    @property
    def complete(self) -> bool:
        """Whether the edge of the body bounds the contact: its radius is given, and depth and force are free."""
        return self.contact == "complete"

    @property
    def free_depth(self) -> tuple[sp.Symbol, ...]:
        """The depth, where the contact radius does not fix it."""
        return (notation.d,) if self.complete else ()

    def meaning(self, symbol: sp.Symbol | str) -> str:
        """What a letter means in this profile; `KeyError` if neither it nor the notation knows."""
        own = {known.name: text for known, text in self.meanings}
        return own.get(str(symbol)) or notation.describe(symbol).meaning

    @property
    def breaks(self) -> tuple[sp.Expr, ...]:
        """The upper ends of the pieces that have one, ascending."""
        return tuple(piece.upper for piece in self.pieces if piece.upper is not None)

    @property
    def truncated(self) -> bool:
        """The tip is flat up to the first break: the contact radius never is smaller."""
        return bool(self.breaks) and self.pieces[0].expr == 0


Found = TypeVar("Found", bound=Profile)


def named(name: str, profiles: Iterable[Found], words: str) -> Found:
    """The one of these profiles that has the name; `KeyError` with the nearest name if there is none."""
    known = {own.name: own for own in profiles}
    if name not in known:
        raise unknown(name, known, words)
    return known[name]
