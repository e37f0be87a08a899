"""numpydoc docstrings of the public functions, read off the entries."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence

import sympy as sp

from .. import notation as nt
from ..abel.masters import MASTERS
from ..entry import COMPACT, Entry, Quantity
from ..letters import name_of
from ..profiles.profile import Profile
from .tables import LOADED, OPTIONAL
from .text import written

WIDTH, LONGEST = 106, 400
"""Characters of a line, and of a formula beyond which its definition says more."""
NUMBERS, SHAPE = "float or ndarray", "The shape to which the arguments broadcast."
SEVERAL = " Where it has several minima, or one at a corner of the profile, the lowest."
"""Of a load over the radius, behind the note of `pull_off`."""
USUAL = {"Hypergeometric": "2F1", "Kummer": "1F1"}
"""Functions that have a usual name in plain text."""


def document(
    summary: str,
    stated: Sequence[str],
    parameters: Sequence[str],
    returns: tuple[str, str],
    notes: str,
    sources: Iterable[str],
    example: Sequence[str],
    outside: str = "a keyword parameter",
) -> str:
    """The whole docstring.

    Parameters
    ----------
    summary : str
        Its first line.
    stated : sequence of str
        The lines of the formula.
    parameters : sequence of str
        Those of the parameters, by `parameter`.
    returns : tuple of str
        The type of the result, and what it is.
    notes : str
        Validity, evaluation and key.
    sources : iterable of str
        Equations and publications, each once.
    example : sequence of str
        The lines of the doctest.
    outside : str
        What raises where it is outside its domain.
    """
    kind, result = returns
    named = "; ".join(dict.fromkeys(sources))
    lines = [summary, "", *stated, "", *_section("Parameters", parameters)]
    lines += _section("Returns", [kind, *wrapped(result, 4)])
    lines += _section("Raises", ["ValueError", f"    If {outside} is outside its domain."])
    lines += _section("Notes", wrapped(notes))
    lines += _section("References", wrapped(f"{named}.")) if named else []
    lines += _section("Examples", example) if example else []
    return "\n".join(lines[:-1])


def _section(title: str, lines: Sequence[str]) -> list[str]:
    return [title, "-" * len(title), *lines, ""]


def parameter(name: str, meaning: str, domain: str = "", kind: str = "array_like") -> list[str]:
    """The rows of one parameter."""
    said = f"{meaning}, {domain}." if domain else f"{meaning}."
    return [f"{name} : {kind}", *wrapped(capital(said), 4)]


def measured(meaning: str, symbol: sp.Symbol | str) -> str:
    """What a number means, with its unit."""
    return f"{capital(meaning)} [{nt.describe(symbol).unit}]"


def in_words(symbol: sp.Symbol | sp.IndexedBase) -> str:
    """What a symbol means in every contact."""
    if isinstance(symbol, sp.IndexedBase):
        return "coefficients of r, r^2, ..., none negative and not all zero"
    return nt.describe(symbol).meaning


Meaning = Callable[[sp.Symbol | sp.IndexedBase], str]


def words_of(profile: Profile) -> Meaning:
    """What symbols mean in a profile."""
    return lambda symbol: profile.note if isinstance(symbol, sp.IndexedBase) else profile.meaning(symbol)


def parameters(fields: Iterable[sp.Symbol], keywords: Iterable[sp.Symbol], meaning: Meaning = in_words) -> list[str]:
    """The rows of fields and keywords, in the letters of the interface."""
    rows = [row for symbol in fields for row in parameter(name_of(symbol), measured(meaning(symbol), symbol))]
    for symbol in keywords:
        if isinstance(symbol, sp.IndexedBase):
            rows += parameter(name_of(symbol), meaning(symbol), kind="sequence of float")
        else:
            record = nt.describe(symbol)
            domain = LOADED.get(record.symbol, record.domain)
            kind = "array_like"
            if symbol in OPTIONAL:
                kind, domain = f"{kind}, optional", f"{domain}; {OPTIONAL[symbol]} if it is not given"
            rows += parameter(name_of(symbol), measured(meaning(symbol), symbol), domain, kind)
    return rows


def sources_of(entry: Entry) -> list[str]:
    """The equations of an entry, and the publications on its profile."""
    return [*(f"chapter 11, equation {reference}" for reference in entry.references), *entry.profile.sources]


def of_entry(
    entry: Entry, keywords: Sequence[sp.Symbol], notes: str, example: Sequence[str], words: Sequence[str] = ()
) -> str:
    """The docstring of a function that one entry backs; the arguments that are no keywords are its fields.

    `words` are the rows of arguments that are no numbers.
    """
    quantity = entry.quantity
    fields = [symbol for symbol in entry.arguments if symbol not in keywords]
    result = f"{measured(in_words(quantity.symbol), quantity.symbol)}. {SHAPE}"
    return document(
        quantity.summary, stated(entry), [*parameters(fields, keywords), *words],
        (NUMBERS, result), f"{notes} Handbook: {entry.key}.", sources_of(entry), example,
    )  # fmt: skip


def of_shape(profile: Profile, notes: str, example: Sequence[str]) -> str:
    """The docstring of the function of the shape of an indenter, which no medium changes."""
    quantity = COMPACT["f"]
    result = f"{measured(in_words(quantity.symbol), quantity.symbol)}. {SHAPE}"
    rows = parameters(quantity.arguments, profile.parameters, words_of(profile))
    lines = formula(profile, quantity, None)
    return document(quantity.summary, lines, rows, (NUMBERS, result), notes, profile.sources, example)


def of_state(
    summary: str, stated: Sequence[str], keywords: Iterable[sp.Symbol], ends: tuple[str, str], notes: str,
    sources: Iterable[str], example: Sequence[str],
) -> str:  # fmt: skip
    """The docstring of a function of the state of pull-off; `ends` of what is said of its control and its result."""
    control, result = ends
    held = ['control : {"force", "depth"}', f"    What is held while the contact is unloaded{control}."]
    returns = ("PullOff", f"Named tuple of radius [m], force [N] and depth [m]{result}.")
    return document(summary, stated, [*held, *parameters([], keywords)], returns, notes, sources, example)


def pull_off(
    stated: Sequence[str],
    keywords: Iterable[sp.Symbol],
    entries: Mapping[str, Entry],
    more: str,
    example: Sequence[str],
) -> str:
    """The docstring of the function of the state at which a contact that shrinks breaks, `more` behind its note."""
    radius, least = entries["ac"], entries["am"]
    notes = f"The least force, or depth, of a stable contact.{more} Handbook: {radius.key}, {least.key}."
    summary, ends = "State at which the contact breaks on unloading.", ("", "; NaN without a stable contact")
    return of_state(summary, stated, keywords, ends, notes, sources_of(radius), example)


def stated(entry: Entry) -> list[str]:
    """The formula with its symbols in the letters of the interface, its functions by their usual names."""
    return usual(formula(entry.profile, entry.quantity, entry))


def usual(lines: Sequence[str]) -> list[str]:
    """Lines in those letters and names."""
    text = "\n".join(lines)
    letters = {record.name: record.letter for record in nt.all_notation() if record.letter}
    for old, new in (letters | USUAL).items():
        text = re.sub(rf"\b{old}\b", new, text)
    return text.split("\n")


def formula(profile: Profile, quantity: Quantity, entry: Entry | None) -> list[str]:
    """The formula in plain text, one line per region."""
    name = written(quantity.symbol) if quantity.suffix != "k" else "dF/dd"
    if entry is None:
        (place,), rows, lower = quantity.arguments, [], "0"
        for piece in profile.pieces:
            upper = f" < {piece.upper}" if piece.upper is not None else ""
            where = f"{lower} < {place}{upper}" if len(profile.pieces) > 1 else ""
            rows.append((written(piece.expr), where))
            lower = str(piece.upper)
    elif entry.composed and entry.status == "root":
        outer, inner = (COMPACT[suffix] for suffix in entry.composed)
        (given,) = inner.arguments
        return wrapped(f"{name} = {outer.symbol}({inner.symbol}({given})), through the contact radius.")
    else:
        rows = _rows(entry)
    if entry is not None and any(len(text) > LONGEST for text, _ in rows):
        rows = _pieces(entry.definition)
    lines = []
    for text, where in rows:
        lines += wrapped(_equation(name, text) + (f"   for {where}" if where else ""))
    for symbol, expr in profile.abbreviations:
        if any(re.search(rf"\b{symbol}\b", text) for text, _ in rows):
            lines += wrapped(f"with {symbol} = {written(expr)}")
    for meaning in _functions("\n".join(lines)):
        lines += wrapped(meaning)
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
        (_text(expr), " and ".join(f"{written(low)} < {written(high)}" for low, high in comparisons))
        for comparisons, expr in entry.regions()
    ]


def _pieces(definition: sp.Expr) -> list[tuple[str, str]]:
    """A definition, by where each of its pieces holds."""
    if not isinstance(definition, sp.Piecewise):
        return [(_text(definition), "")]
    (first, where), (last, _) = definition.args
    ends = written(where.lts), written(where.gts)
    return [(_text(first), " < ".join(ends)), (_text(last), " < ".join(reversed(ends)))]


def _text(expr: sp.Expr) -> str:
    if isinstance(expr, sp.Eq):
        return f"{written(expr.lhs)} = {written(expr.rhs)}"
    return written(expr)


def wrapped(text: str, indent: int = 0) -> list[str]:
    """The text in lines of at most 106 characters, each indented by this many spaces."""
    space = " " * indent
    return textwrap.wrap(
        text, WIDTH, initial_indent=space, subsequent_indent=space, break_long_words=False, break_on_hyphens=False
    )


def capital(text: str) -> str:
    """The text with its first letter as a capital, the rest unchanged."""
    return text[:1].upper() + text[1:]
