"""What the catalogue is made of: quantities, cases and entries.

An entry is frozen data.  Its key (`cone.p`) is the equation number in the
handbook, the id in the evidence and, through its quantity, the name of a
function.  Python, LaTeX and tests are views of the same entries.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

import sympy as sp

from . import notation as nt

if TYPE_CHECKING:
    from .profiles.profile import Profile

Status = Literal["closed", "integral", "root"]


@dataclass(frozen=True)
class Quantity:
    """One kind of result: its key suffix, function name, label, symbol and field arguments."""

    suffix: str
    function: str
    label: str
    symbol: sp.Symbol
    arguments: tuple[sp.Symbol, ...]
    member: str = ""
    """Which of the results of a function that returns a named tuple."""


@dataclass(frozen=True)
class Case:
    """One formula and the open region on which it holds.

    `chain` lists lengths in ascending order: (r, b, a) says 0 < r < b < a.
    Lengths that are not in the chain are only positive.
    """

    chain: tuple[sp.Expr, ...]
    expr: sp.Expr

    def below(self, low: sp.Expr, high: sp.Expr) -> bool:
        """Whether the chain says low < high (both must be in it)."""
        return self.chain.index(low) < self.chain.index(high)


@dataclass(frozen=True)
class Primitive:
    """Antiderivative in x of the integrand of (11.29) over one piece lo < x < hi of the profile.

    The depth is the sum of its increments, so that `diff(expr, x)` proves it.
    """

    lo: sp.Expr
    hi: sp.Expr
    integrand: sp.Expr
    expr: sp.Expr


@dataclass(frozen=True)
class Entry:
    """One quantity of one profile: definition, result and everything needed to prove and print it."""

    key: str
    profile: Profile
    quantity: Quantity
    status: Status
    cases: tuple[Case, ...]
    definition: sp.Expr
    parameters: tuple[sp.Symbol, ...]
    references: tuple[str, ...] = ()
    fixed_face: tuple[Case, ...] = ()
    """Complete contact: the cases with the coefficient of the face written as C, independent of a."""
    composed: tuple[str, str] | None = None
    """Suffixes (outer, inner) when the result is best read and computed as outer(inner), as F(a(d))."""
    partial: Entry | None = None
    """Complete contact before the edge is reached: the compact entry whose a is the current contact radius."""
    primitives: dict[tuple[sp.Expr, ...], tuple[Primitive, ...]] = field(default_factory=dict, hash=False)
    note: str = ""

    @property
    def suffix(self) -> str:
        """The last part of the key, "p" of "cone.p"."""
        return self.quantity.suffix

    def regions(self) -> tuple[tuple[tuple[tuple[sp.Expr, sp.Expr], ...], sp.Expr], ...]:
        """The distinct formulas with the fewest comparisons (low, high) that tell them apart, for print and code.

        Cases that differ only in comparisons without influence fall together:
        the displacement of a rounded cone needs a < b or b < a, not where r is.
        """
        groups: dict[sp.Expr, list[Case]] = {}
        for case in self.cases:
            groups.setdefault(case.expr, []).append(case)
        out = []
        for expr, own in groups.items():
            others = [case for case in self.cases if case.expr != expr]
            out.append((_distinguish(own, others), expr))
        return tuple(out)

    def text(self) -> str:
        """The result as canonical text: what must not change with hash seed or SymPy version."""
        rows = [f"{' < '.join(map(sp.sstr, c.chain)) or 'always'}: {sp.sstr(c.expr)}" for c in self.cases]
        return f"{self.key} [{self.status}]\n  " + "\n  ".join(rows)

    def _repr_markdown_(self) -> str:
        """What Jupyter shows: key, label and formula as the handbook prints them."""
        # late: print knows entries, an entry knows nothing of print until it is shown
        from .book.latex import markdown

        return markdown(self)


def _distinguish(own: list[Case], others: list[Case]) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """The smallest set of comparisons that all of `own` fulfil and each of `others` violates somewhere."""
    first = own[0].chain
    shared = [pair for pair in itertools.combinations(first, 2) if all(case.below(*pair) for case in own)]
    for size in range(len(shared) + 1):
        for chosen in itertools.combinations(shared, size):
            if all(any(not other.below(*pair) for pair in chosen) for other in others):
                return chosen
    return tuple(shared)


COMPACT = {
    q.suffix: q
    for q in (
        Quantity("f", "profile", "Profile", nt.f, (nt.r,)),
        Quantity("d", "depth", "Indentation depth", nt.d, (nt.a,)),
        Quantity("F", "force", "Normal force", nt.F, (nt.a,)),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.r, nt.a)),
        Quantity("w", "displacement", "Displacement outside", nt.w, (nt.r, nt.a)),
        Quantity("k", "stiffness", "Contact stiffness", nt.stiffness, (nt.a,)),
        Quantity("pm", "mean_pressure", "Mean pressure", nt.p_mean, (nt.a,)),
        Quantity("ad", "radius_from_depth", "Contact radius from depth", nt.a, (nt.d,)),
        Quantity("aF", "radius_from_force", "Contact radius from force", nt.a, (nt.F,)),
        Quantity("Fd", "force_from_depth", "Force from depth", nt.F, (nt.d,)),
        Quantity("dF", "depth_from_force", "Depth from force", nt.d, (nt.F,)),
        Quantity("rp", "peak_pressure", "Greatest pressure: its radius", nt.r_peak, (nt.a,), "radius"),
        Quantity("pp", "peak_pressure", "Greatest pressure", nt.p_peak, (nt.a,), "pressure"),
    )
}

COMPLETE = {
    q.suffix: q
    for q in (
        Quantity("f", "profile", "Profile", nt.f, (nt.r,)),
        Quantity("F", "force", "Normal force", nt.F, (nt.d,)),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.r, nt.d)),
        Quantity("w", "displacement", "Displacement outside", nt.w, (nt.r, nt.d)),
        Quantity("k", "stiffness", "Contact stiffness", nt.stiffness, ()),
        Quantity("dF", "depth_from_force", "Depth from force", nt.d, (nt.F,)),
        Quantity("rz", "zero_radius", "Ring of first zero pressure", nt.r_zero, ()),
        Quantity("dmin", "minimum_depth", "Least depth of complete contact", nt.d, ()),
        Quantity("Fmin", "minimum_force", "Least force of complete contact", nt.F, ()),
    )
}
