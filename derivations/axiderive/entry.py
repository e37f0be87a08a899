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

Status = Literal["closed", "integral", "root", "equation", "expansion"]


@dataclass(frozen=True)
class Quantity:
    """One kind of result, and what code, print and checks have to know of it.

    What it computes tells two of them apart; the fields behind `member` say it in words and signs, and do not count.
    """

    suffix: str
    """The last part of its keys."""
    function: str
    label: str
    symbol: sp.Symbol
    arguments: tuple[sp.Symbol, ...]
    member: str = ""
    """Which of the results of a function that returns a named tuple."""
    summary: str = field(default="", compare=False, kw_only=True)
    """First line of the docstring of the function; empty where that function gives other quantities too."""
    written: str = field(default="", compare=False, kw_only=True)
    """What stands left of the formula in print, where it is not the symbol alone."""
    row: str = field(default="", compare=False, kw_only=True)
    """Label of the row in print, where it is shorter than `label`."""
    inverts: str = field(default="", compare=False, kw_only=True)
    """Suffix of the curve that is given: "d" for the contact radius, and for the force, from the depth."""
    composed: tuple[str, str] | None = field(default=None, compare=False, kw_only=True)
    """Suffixes (outer, inner) of what it is through a contact radius that grows: F(a(d)) is ("F", "ad")."""
    solves: str = field(default="", compare=False, kw_only=True)
    """The equation in print that is solved for it where it has no formula."""
    place: Literal["", "inside", "outside"] = field(default="", compare=False, kw_only=True)
    """Where a field is stated: in the contact, or beside it."""
    parity: Literal["", "even", "odd"] = field(default="", compare=False, kw_only=True)
    """Of a field of the plane problem, whose formula is that of x > 0."""
    control: str = field(default="", compare=False, kw_only=True)
    """What is given while the contact is pulled off, "force" or "depth"; it tells that state from every other."""
    after: str = field(default="", compare=False, kw_only=True)
    """Suffix of the quantity behind which it stands in print, where `ORDER` of `rows/row.py` does not name it."""
    threshold: bool = field(default=False, compare=False, kw_only=True)
    """Whether it says from where on a concave face is in contact as a whole."""

    @property
    def elastic(self) -> bool:
        """Whether the modulus is in it: a length that is given lengths needs none, but for that beside a pressure."""
        lengths = all(nt.describe(symbol).dimension == nt.LENGTH for symbol in (self.symbol, *self.arguments))
        return not lengths or bool(self.member)

    @property
    def left(self) -> str:
        """The left side of its row in print."""
        return self.written or nt.describe(self.symbol).latex

    @property
    def called(self) -> str:
        """What a statement about it calls it: g(a), where the row says d = g(a)."""
        return self.left.rpartition("=")[2]

    @property
    def heading(self) -> tuple[str, str]:
        """Label of its row in print and the grey words under it: Contact radius, from force."""
        text = self.row or self.label
        for word in (" from ", ": ", " relative to ", " of the "):
            if word in text:
                first, _, second = text.partition(word)
                return first, f"{word.strip(' :')} {second}".strip()
        return text, ""


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

    @property
    def arguments(self) -> tuple[sp.Symbol, ...]:
        """Fields of its function: those of the quantity, and the depth of a stiffness that depends on it."""
        depends = not self.quantity.arguments and any(case.expr.has(nt.d) for case in self.cases)
        return (nt.d,) if depends else self.quantity.arguments

    @property
    def borders(self) -> set[sp.Expr]:
        """Numbers at which an equation begins: it has no root there yet, so that the formula before it still holds."""
        equations = (own.chain for own in self.cases if own.chain and isinstance(own.expr, sp.Equality))
        return {first for first, *_ in equations if first.is_number}

    def where(self, case: Case) -> str:
        """The order of the members of one of its cases as text: 1 < n <= 2."""
        first, _, last = (text := " < ".join(map(sp.sstr, case.chain))).rpartition(" < ")
        return f"{first} <= {last}" if self.borders & {*case.chain[1:]} else text

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
            # the only formula of a quantity may hold for some exponents alone
            first, *_ = pairs = tuple(zip(own[0].chain, own[0].chain[1:], strict=False)) or ((sp.S.Zero, sp.S.Zero),)
            bound = pairs[:1] if not others and first[0].is_Number and first[1].is_Symbol else ()
            out.append((bound or _distinguish(own, others), expr))
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


FOUR = ("d", "F", "p", "w")
"""The quantities that are integrals over the profile, in their order; all others follow from them."""
COMPACT = {
    q.suffix: q
    for q in (
        Quantity("f", "profile", "Profile", nt.f, (nt.r,), summary="Profile f(r) of the indenter."),
        Quantity("d", "depth", "Indentation depth", nt.d, (nt.a,), written="d=g(a)",
                 summary="Indentation depth at contact radius a."),
        Quantity("F", "force", "Normal force", nt.F, (nt.a,), summary="Normal force."),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.r, nt.a), written="p(r)", place="inside",
                 summary="Contact pressure, positive in compression; zero outside the contact."),
        Quantity("w", "displacement", "Displacement outside", nt.w, (nt.r, nt.a), written="w(r)", place="outside",
                 row="Displacement",
                 summary="Displacement of the surface into the half-space, inside and outside the contact."),
        Quantity("k", "stiffness", "Contact stiffness", nt.stiffness, (nt.a,),
                 written=r"\frac{\mathrm{d}F_{\mathrm N}}{\mathrm{d}d}", summary="Contact stiffness dF/dd."),
        Quantity("pm", "mean_pressure", "Mean pressure", nt.p_mean, (nt.a,),
                 written=r"\bar p=\frac{F_{\mathrm N}}{\pi a^{2}}", summary="Mean pressure F/(pi a^2)."),
        Quantity("ad", "radius_from_depth", "Contact radius from depth", nt.a, (nt.d,), inverts="d",
                 solves="g(a)=d", summary="Contact radius at indentation depth d."),
        Quantity("aF", "radius_from_force", "Contact radius from force", nt.a, (nt.F,), inverts="F",
                 solves=r"F_{\mathrm N}(a)=F_{\mathrm N}", summary="Contact radius under the normal force F."),
        Quantity("Fd", "force_from_depth", "Force from depth", nt.F, (nt.d,), inverts="d", composed=("F", "ad"),
                 summary="Normal force at indentation depth d."),
        Quantity("dF", "depth_from_force", "Depth from force", nt.d, (nt.F,), inverts="F", composed=("d", "aF"),
                 summary="Indentation depth under the normal force F."),
        Quantity("rp", "peak_pressure", "Greatest pressure: its radius", nt.r_peak, (nt.a,), "radius",
                 row="Ring: of greatest pressure", summary="Radius of the greatest pressure."),
        Quantity("pp", "peak_pressure", "Greatest pressure", nt.p_peak, (nt.a,), "pressure",
                 summary="Greatest pressure, and the radius of the ring on which it is."),
    )
}  # fmt: skip

COMPLETE = {
    q.suffix: q
    for q in (
        COMPACT["f"],
        Quantity("F", "force", "Normal force", nt.F, (nt.d,), summary="Normal force."),
        Quantity("p", "pressure", "Pressure", nt.p, (nt.r, nt.d), written="p(r)", place="inside",
                 summary=COMPACT["p"].summary),
        Quantity("w", "displacement", "Displacement outside", nt.w, (nt.r, nt.d), written="w(r)", place="outside",
                 row="Displacement", summary=COMPACT["w"].summary),
        Quantity("k", "stiffness", "Contact stiffness", nt.stiffness, (), written=COMPACT["k"].written,
                 summary="Contact stiffness dF/dd."),
        COMPACT["dF"],
        Quantity("rz", "zero_radius", "Ring of first zero pressure", nt.r_zero, (), threshold=True,
                 written="r_{0}", row="Ring: of first zero pressure",
                 summary="Radius of the ring where the pressure first vanishes on unloading."),
        Quantity("dmin", "minimum_depth", "Least depth of complete contact", nt.d, (), threshold=True,
                 written=r"d_{\mathrm{min}}", summary="Least indentation depth of complete contact."),
        Quantity("Fmin", "minimum_force", "Least force of complete contact", nt.F, (), threshold=True,
                 written=r"F_{\mathrm{min}}", summary="Least normal force of complete contact."),
    )
}  # fmt: skip
