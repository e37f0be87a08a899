"""A row of the handbook: an entry with its label, range, formula in lines that fit and permanent key.

Rows stand in printing order, two narrow ones on one line.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from typing import Literal

import sympy as sp

from ..entry import Entry
from ..notation import a_c, c, r_peak
from ..physics import Rule, adhesive
from ..physics.consequences import CONSEQUENCES
from ..physics.systems import System, of
from ..print.box import brackets_around, size_around, width
from ..print.formula import Printer
from ..print.shorthand import LINE, Short, shortened, with_kappa
from ..print.terms import tidied
from .ranges import Pairs, chain_of, condition, regions

Kind = Literal["formula", "root", "composition", "rule", "definition", "joined"]
INDENT = r"\enspace\enspace "
EXPLICIT = 250.0
"""Points up to which an adhesive or tangential quantity is spelled out instead of given by its rule."""


ROOM, LETTER = 388.0, 4.2
"""Points from the label to the end of a line, and those of a letter of the key that ends the first line of a row."""


@dataclass(frozen=True)
class Region:
    """One formula of a row: the range in which it holds, and its lines of LaTeX."""

    condition: str
    lines: tuple[str, ...]
    remark: str = ""
    """Words that lead from this formula to that of the next range."""
    points: float = 0.0
    """Its width where it is several formulas."""

    @property
    def tex(self) -> str:
        """The formula as LaTeX, several lines aligned below each other."""
        if len(self.lines) == 1:
            return self.lines[0]
        return r"\begin{aligned}[t]&" + r"\\[1.5mm]&".join(self.lines) + r"\end{aligned}"

    @property
    def width(self) -> float:
        """Width in points: that given, or that of the widest line."""
        return self.points or max(map(width, self.lines))


@dataclass(frozen=True)
class Row:
    """What is printed for one entry."""

    entry: Entry
    kind: Kind
    regions: tuple[Region, ...]
    remark: str = ""
    """Words behind the formula, as `solved for a`."""
    uses: str = ""
    """Suffix of the row the remark refers to."""
    listed: bool = False
    """Whether the spread names the key only, because the rule stands in front of the book for all profiles."""
    also: tuple[Entry, ...] = ()
    """Further entries that the same row gives, one for every viscoelastic law, or one for every part."""
    parts: tuple[Row, ...] = ()
    """The rows whose formulas stand side by side in this one."""
    title: tuple[str, str] | None = None
    """Label and words of a row of several parts."""

    @property
    def key(self) -> str:
        """The permanent key of its entry, as `cone.p`."""
        return self.entry.key

    @property
    def suffix(self) -> str:
        """The key of its quantity, as `p`."""
        return self.entry.suffix

    @property
    def entries(self) -> tuple[Entry, ...]:
        """All entries that it gives."""
        return self.entry, *self.also

    @property
    def anchors(self) -> list[str]:
        """Their keys without the profile: adh.ac, adh.Fc, adh.dc."""
        start = len(of(self.entry).pool.id(self.entry.profile.name)) + 1
        return [entry.key[start:] for entry in self.entries]

    @property
    def ends(self) -> str:
        """The keys as they stand behind the formula: adh.ac, Fc, dc."""
        return ", ".join([self.anchors[0], *(one.suffix.partition("_")[2] or one.suffix for one in self.also)])

    @property
    def refers(self) -> str:
        """The end of the key of the row it refers to: of its problem, or of the normal contact under a law."""
        system = of(self.entry)
        group = system.base.group if system.physics.laws and system.base else system.group
        return self.uses and f"{group}.{self.uses}".lstrip(".")

    @property
    def label(self) -> tuple[str, str]:
        """Label and the grey words under it: Contact radius, from force."""
        return self.title or self.entry.quantity.heading

    @property
    def head(self) -> str:
        """The label in the book, with the words in whose place the range stands."""
        label, small = self.label
        said = self.regions[0].condition and small.startswith(("of first", "of greatest"))
        return f"{label} {small}" if said else label

    @property
    def narrow(self) -> bool:
        """Whether the row takes half a line only."""
        return len(self.regions) == 1 and len(self.regions[0].lines) == 1 and not self.regions[0].condition


@lru_cache(maxsize=4096)
def row(entry: Entry) -> Row:
    """The row of an entry."""
    system = of(entry)
    if not system.physics.printed:
        return _unbroken(entry)
    if system.physics.rules is None:
        return _defined(entry) or _root_or_formula(entry)
    if system.physics.over:
        return _superposed(entry, system) if entry.profile.compact and rule(system, entry.suffix) else _formula(entry)
    plain = _normal_row(entry)
    ruled = entry.profile.compact and rule(system, entry.suffix) and not _fits(plain)
    return _ruled(entry, system) if ruled else plain


def _normal_row(entry: Entry) -> Row:
    if entry.composed:
        outer, inner = entry.composed
        function = "g(a)" if outer == "d" else r"F_{\mathrm N}(a)"
        return Row(entry, "composition", (Region("", (f"{entry.quantity.left}={function}",)),), "with $a$ from", inner)
    return _root_or_formula(entry)


def _defined(entry: Entry) -> Row | None:
    """An elastic constant, where it is read better by the equation that defines a power of it, or H over h_N."""
    known, own = entry.definition, entry.quantity.symbol
    if not isinstance(known, sp.Equality) or known.lhs.as_base_exp()[0] != own:
        return None
    line = (Region("", (Printer()(known),)),)
    if known.lhs != own:
        return Row(entry, "definition", line)
    used = known.rhs.free_symbols - set(entry.parameters)
    return Row(entry, "definition", line, "with the factor", used.pop().name) if len(used) == 1 else None


def _root_or_formula(entry: Entry) -> Row:
    if entry.status == "root" and entry.quantity.solves:
        return Row(entry, "root", (Region("", (entry.quantity.solves,)),), "solved for $a$")
    return _formula(entry)


def _unbroken(entry: Entry) -> Row:
    """The formulas as they stand, each on one line: of an entry that no page shows."""
    found, left = [], entry.quantity.left.partition("=")[0]
    for pairs, expr in regions(entry):
        printer = Printer(chain := chain_of(entry, expr))
        formula = printer(expr) if isinstance(expr, sp.Equality) else f"{left}={printer(expr)}"
        found.append(Region(condition(entry, pairs, chain, printer), (formula,)))
    return Row(entry, "formula", tuple(found))


BETTER = {
    "cone.w": (r"w(r)=a \tan \theta \, \Bigl(\psi-\tan \frac{\psi}{2}\Bigr),\qquad \psi=\arcsin \frac{a}{r}",),
    "capped_paraboloid.ad": (
        r"a=\frac{\sqrt{2} D}{\sqrt{2 D-q^{2} b^{2}+q \sqrt{4 D^{2}-4 D b^{2}+q^{2} b^{4}}}},"
        r"\qquad D=d R_1,\quad q=\frac{R_1-R_2}{R_2}",
    ),
    "power_law.rp": (
        r"\mathrm{B}\bigl(z;\tfrac{1}{2},\tfrac{3-n}{2}\bigr)=\frac{2}{(n-2) \sqrt{z}} \, "
        r"\Bigl(\frac{a}{r_{\mathrm{max}}}\Bigr)^{n-3},\qquad z=1-\frac{r_{\mathrm{max}}^{2}}{a^{2}}",
    ),
    "rounded_punch.rp": (
        r"\bigl(2-k^{2}\bigr)\,\mathrm{F}(\varphi,k)-2 \,\mathrm{E}(\varphi,k)"
        r"+\frac{\ell}{a r_{\mathrm{max}}} \, \Bigl(\frac{2 b^{2}}{q}+b \arccos \frac{b}{a}\Bigr)"
        r"=\frac{r_{\mathrm{max}}}{a \ell} \, \Bigl(2 q-b \arccos \frac{b}{a}\Bigr),",
        r"\qquad k=\frac{b}{r_{\mathrm{max}}},\quad \varphi=\arcsin \frac{\ell}{q},"
        r"\quad q=\sqrt{a^{2}-b^{2}},\quad \ell=\sqrt{a^{2}-r_{\mathrm{max}}^{2}}",
    ),
}
"""Shorter or more accurate forms of the last case of an entry than its own, by lines, read back like any other."""


def _formula(entry: Entry) -> Row:
    left = entry.quantity.left
    found = []
    for pairs, expr in regions(entry):
        found.append(_region(entry, pairs, expr, left))
        left = left.partition("=")[0]
    if entry.key in BETTER:
        found[-1] = replace(found[-1], lines=BETTER[entry.key])
    if len(found) > 1 and isinstance(expr, sp.Equality):
        found[-2] = replace(found[-2], remark=f"and beyond, ${left}$ is the root of")
    return Row(entry, "formula", tuple(found))


MOST_LINES = 2
WIDEST = LINE + 15


def _fits(one: Row) -> bool:
    """Whether every region of the row is at most two lines that fit."""
    if any(case.expr.has(r_peak) for case in one.entry.cases):
        return one.entry.status == "root" or len(one.regions) == len(one.regions[0].lines) == 1
    return one.entry.suffix != "pm" and all(
        len(region.lines) <= MOST_LINES and region.width <= WIDEST and r"\int" not in region.tex
        for region in one.regions
    )


def rule(system: System, suffix: str) -> Rule | None:
    """The rule behind a quantity of a system; None if the quantity is a formula of the profile itself."""
    return _rules(system).get(suffix)


@cache
def _rules(system: System) -> dict[str, Rule]:
    rules = system.physics.rules
    return rules(system.medium, Printer) if rules else {}


def _ruled(entry: Entry, system: System, listed: bool = False) -> Row:
    found = rule(system, entry.suffix)
    if found is None:
        message = f"{entry.key} follows from no rule; add one to `rules` of its physics"
        raise LookupError(message)
    return Row(entry, "rule", (Region(found.where, (found.tex,)),), found.remark, listed=listed)


def _superposed(entry: Entry, system: System) -> Row:
    """An adhesive or tangential quantity: spelled out where that is short, else by its rule."""
    graded = system.medium.graded
    if entry.suffix == "Dl" and not graded:
        return _formula(entry)
    spelled = entry.status == "closed" and len(entry.cases) == 1 and not entry.quantity.place
    if (
        spelled
        and not _is_long(entry.cases[0].expr)
        and _is_power(entry.cases[0].expr, a_c)
        and not (graded and not entry.quantity.control)
    ):
        plain = _formula(entry)
        if len(plain.regions[0].lines) == 1 and plain.regions[0].width <= EXPLICIT:
            return replace(plain, regions=(replace(plain.regions[0], condition=""),))
    return _ruled(entry, system, listed=graded)


def _is_long(expr: sp.Expr) -> bool:
    """Whether the state of the stick radius has several terms of its own; the rule says it in two."""
    return any(len(total.args) > 2 for total in tidied(expr).atoms(sp.Add) if total.has(c))


def _is_power(expr: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether the symbol enters as one power at most; what is longer is read better from the rule."""
    return expr.as_independent(symbol, as_Add=False)[1].as_base_exp()[0] in (symbol, 1)


def names_of(entry: Entry) -> dict[sp.Symbol, str]:
    """Names in print that differ from those of the notation."""
    control = entry.quantity.control
    return {a_c: adhesive.QUANTITIES[adhesive.CONTROLS[control][0]].left} if control else {}


def _region(entry: Entry, pairs: Pairs, expr: sp.Expr, left: str) -> Region:
    chain = chain_of(entry, expr)
    own = names_of(entry)
    expr = tidied(expr.replace(_is_inverse_power, lambda e: sp.Pow(1 / e.base, -e.exp)))
    if isinstance(expr, sp.Equality):
        printer = Printer(chain, with_kappa(expr).names | own)
        return Region(condition(entry, pairs, chain, printer), (printer(expr),))
    left += "="
    short = shortened(expr, chain, width(left))
    printer = Printer(chain, short.names | own)
    lines = broken(left, short.expr, printer)
    key = LETTER * len(entry.key.partition(f"{entry.profile.name}.")[2])
    return Region(condition(entry, pairs, chain, printer), tuple(_with_definitions(lines, short, printer, key)))


def _is_inverse_power(expr: sp.Expr) -> bool:
    """(u/v)**(-2/(1 + k)), which is read as (v/u)**(2/(1 + k))."""
    return bool(expr.is_Pow and expr.base.is_Mul and expr.exp.free_symbols and expr.exp.could_extract_minus_sign())


def broken(left: str, expr: sp.Expr, printer: Printer) -> list[str]:
    """The formula in lines that fit, broken between terms."""
    whole = left + printer(expr)
    parts = printer.scaled_sum(expr)
    if width(whole) <= LINE or parts is None:
        return [whole]
    sign, scale, terms = parts
    start = left + ("-" if sign < 0 else "") + (scale + r"\," if scale else "")
    inside = "()".join(text for _, text in terms)
    (left_one, right_one), size = brackets_around(inside), size_around(rf"\Bigl({inside}")  # square ones at least
    opening, closing = (rf"\{size}l{left_one}", rf"\{size}r{right_one}") if scale or sign < 0 else ("", "")
    lines, current = [], start + opening
    for i, (sign_of, text) in enumerate(terms):
        piece = ("-" if sign_of < 0 else "+" if i else "") + text
        if i and width(current + piece) > LINE:
            lines.append(current)
            current = INDENT + "{}"
        current += piece
    return [*lines, current + closing]


def _with_definitions(lines: list[str], short: Short, printer: Printer, key: float) -> list[str]:
    """The definitions behind the formula, on its last line if they fit; on the first one stands the key too."""
    if not short.definitions:
        return lines
    texts = [f"{short.names[s]}={printer(d)}" for s, d in short.definitions.items() if not _is_kappa(s)]
    out = list(lines)
    for i, text in enumerate(texts):
        gap = r",\qquad " if i == 0 else r",\quad "
        if width(out[-1] + gap + text) <= ROOM - key * (len(out) == 1):
            out[-1] += gap + text
        else:
            out[-1] += ","
            out.append(r"\qquad " + text)
    return out


def _is_kappa(symbol: sp.Expr) -> bool:
    """kappa is explained once per profile, in the definition panel."""
    return str(symbol).startswith("kappa")


def kappa_row(entries: tuple[Entry, ...]) -> str:
    """The definition of kappa if a profile uses it, else an empty string."""
    for entry in entries:
        for case in entry.cases:
            short = with_kappa(case.expr)
            if short.definitions:
                ((symbol, definition),) = short.definitions.items()
                return f"{short.names[symbol]}={Printer()(definition)}"
    return ""


HALF = 122.0
"""Points for the formula of half a row, beside a key of two letters."""


_NAMED = (
    "Dl", "d", "ad", "P", "aP", "F", "Fd", "aF", "dF", "u", "c", "us", "k", "pm", "p", "pp", "rp", "tau", "s", "w",
    "ac", "Fc", "dc", "am", "Fm", "dm", "rz", "dmin", "Fmin", "xz", "Pmin", "phi", "cw",
    "E_star", "E_ti", "G_star", "H", "h_N", "R", "mu_T", "lambda_M",
)  # fmt: skip
ORDER = tuple(
    suffix for named in _NAMED
    for suffix in (named, *(own.suffix for own in CONSEQUENCES.values() if named == own.compact.after))
)  # fmt: skip
"""Suffixes as their rows follow one another."""


def lines(rows: list[Row]) -> list[tuple[Row, ...]]:
    """Rows in printing order: depth and force first, fields last, two narrow ones on one line."""
    narrow = [one for one in rows if one.narrow and fits_half(one)]
    if not {"d", "F"} <= {one.suffix for one in narrow}:
        narrow = [one for one in narrow if one.suffix not in ("d", "F")]
    wide = [one for one in rows if one not in narrow]
    out = [tuple(narrow[i : i + 2]) for i in range(0, len(narrow), 2)] + [(one,) for one in wide]
    return sorted(out, key=lambda line: min(_place(one, line in out[-len(wide) :]) for one in line))


def _place(one: Row, wide: bool) -> float:
    """The force follows the depth at once where they have lines of their own."""
    return ORDER.index("d") + 0.5 if wide and one.suffix == "F" else _index(one.suffix)


def _index(suffix: str) -> int:
    """Quantities that only one physics has come last, in its own order."""
    return ORDER.index(suffix) if suffix in ORDER else len(ORDER)


def fits_half(one: Row) -> bool:
    """Whether a formula takes half a line with the words and the key behind it."""
    parts = one.remark.split("$")
    remark = sum(0.84 * width(part) if i % 2 else 3.7 * len(part) for i, part in enumerate(parts))
    behind = 12 + remark + (12 if one.uses else 0) if one.remark else 0
    return one.regions[0].width + behind + LETTER * max(0, len(one.ends) - 2) <= HALF


def ordered(entries: Mapping[str, Entry]) -> list[Row]:
    """The rows of a problem, the short ones first, fields last."""
    found = (entries[suffix] for suffix in sorted(entries, key=_index))
    return [row(entry) for entry in found if entry.suffix in ORDER or of(entry).physics.printed]
