"""numpydoc docstrings of the public functions, read off the entries."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence

import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import COMPACT, Entry, Quantity
from ..profiles.profile import Profile
from .private import parameter_name

WIDTH, LONGEST = 106, 400
"""Characters of a line, and of a formula beyond which its definition says more."""


def docstring(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    notes: Sequence[str],
    example: Sequence[str],
    ring: Entry | None = None,
) -> list[str]:
    """Everything below the summary line, without indentation; with a `ring`, of a result that has it for a member."""
    fields = [str(argument) for argument in quantity.arguments]
    symbols = entry.parameters if entry is not None else profile.parameters
    stated = formula(profile, quantity, entry)
    if ring is not None:
        stated += [line for line in formula(profile, ring.quantity, ring) if line not in stated]
    lines = [*stated, "", "Parameters", "----------"]
    for name in fields:
        record = nt.describe(name)
        lines += [f"{name} : array_like", *_wrapped(f"{_capital(record.meaning)} [{record.unit}].", 4)]
    for symbol in symbols:
        name, record = parameter_name(symbol), nt.describe(symbol)
        kind = "sequence of float" if isinstance(symbol, sp.IndexedBase) else "array_like"
        text = f"{_capital(profile.meaning(symbol))} [{record.unit}], {record.domain}."
        if isinstance(symbol, sp.IndexedBase):
            text = f"{_capital(profile.note)}."
        lines += [f"{name} : {kind}", *_wrapped(text, 4)]
    result = nt.describe(quantity.symbol)
    said = f"{_capital(result.meaning)} [{result.unit}]."
    if ring is not None:
        said = f"Named tuple of pressure [{result.unit}] and radius [{nt.describe(ring.quantity.symbol).unit}]."
    shape = "The shape to which the arguments broadcast." if fields else "A number for numbers."
    lines += [
        "",
        "Returns",
        "-------",
        "float or ndarray" if ring is None else "PeakPressure",
        *_wrapped(f"{said} {shape}", 4),
    ]
    lines += ["", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain."]
    lines += ["", "Notes", "-----"]
    for note in notes:
        lines += _wrapped(note)
    sources = [
        *(f"chapter 11, equation {reference}" for reference in (entry.references if entry else ())),
        *profile.sources,
    ]
    if sources:
        lines += ["", "References", "----------", *_wrapped("; ".join(sources) + ".")]
    return [*lines, "", "Examples", "--------", *example]


def formula(profile: Profile, quantity: Quantity, entry: Entry | None) -> list[str]:
    """The formula in plain text, one line per region."""
    name = sp.sstr(quantity.symbol) if quantity.suffix != "k" else "dF/dd"
    if entry is None:
        rows, lower = [], "0"
        for piece in profile.pieces:
            upper = f" < {piece.upper}" if piece.upper is not None else ""
            where = f"{lower} < r{upper}" if len(profile.pieces) > 1 else ""
            rows.append((sp.sstr(piece.expr), where))
            lower = str(piece.upper)
    elif entry.composed and entry.status == "root":
        outer, inner = (COMPACT[suffix] for suffix in entry.composed)
        (given,) = inner.arguments
        return _wrapped(f"{name} = {outer.symbol}({inner.symbol}({given})), through the contact radius.")
    else:
        rows = _rows(entry)
    if entry is not None and any(len(text) > LONGEST for text, _ in rows):
        rows = [(_text(entry.definition), "")]
    lines = []
    for text, where in rows:
        lines += _wrapped(_equation(name, text) + (f"   for {where}" if where else ""))
    for symbol, expr in profile.abbreviations:
        if any(re.search(rf"\b{symbol}\b", text) for text, _ in rows):
            lines += _wrapped(f"with {symbol} = {sp.sstr(expr)}")
    for meaning in _functions("\n".join(lines)):
        lines += _wrapped(meaning)
    return lines


def _equation(name: str, text: str) -> str:
    """A value, or an equation for it, after the name."""
    return f"{name} from {text}" if "=" in text else f"{name} = {text}"


def _functions(text: str) -> list[str]:
    """What the special functions in a formula stand for, in the words of their own docstrings."""
    meanings = []
    for master in MASTERS:
        name, meaning = master.__name__, (master.__doc__ or "").partition("\n")[0].rstrip(".")
        if re.search(rf"\b{name}\(", text):
            meanings.append(f"with {meaning if meaning.startswith(name) else f'{name}: {meaning}'}")
    if "elliptic_" in text:
        meanings.append("with elliptic integrals of the parameter m = k**2, their last argument")
    return meanings


def _rows(entry: Entry) -> list[tuple[str, str]]:
    if len({case.expr for case in entry.cases}) == 1:
        return [(_text(entry.cases[0].expr), "")]
    chains = {case.chain for case in entry.cases}
    same = all(set(chain) == set(next(iter(chains))) for chain in chains)
    if not same:
        return [(_text(case.expr), entry.where(case)) for case in entry.cases]
    return [
        (_text(expr), " and ".join(f"{sp.sstr(low)} < {sp.sstr(high)}" for low, high in comparisons))
        for comparisons, expr in entry.regions()
    ]


def _text(expr: sp.Expr) -> str:
    if isinstance(expr, sp.Eq):
        return f"{sp.sstr(expr.lhs)} = {sp.sstr(expr.rhs)}"
    return sp.sstr(expr)


def _wrapped(text: str, indent: int = 0) -> list[str]:
    space = " " * indent
    return textwrap.wrap(
        text, WIDTH, initial_indent=space, subsequent_indent=space, break_long_words=False, break_on_hyphens=False
    )


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
