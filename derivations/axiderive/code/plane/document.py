"""Docstrings of plane modules, with a number for each function.

numpydoc docstrings of plane modules.

Numbers of the doctests of plane modules, from the exact results.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp

from ... import notation as nt
from ...entry import Case, Entry, Quantity
from ...profiles.profile import Profile
from .. import docstring, example
from ..physics.text import capital, wrapped

MEANING = {
    nt.a: "half-width of the contact",
    nt.d: "depth of the middle of the contact relative to the surface at the distance L",
    nt.f: "height of the profile above its lowest point in the middle",
    nt.x: "place across the contact, zero in the middle; of either sign",
    nt.slope: "slope of the surface, negative where the displacement into the half-space falls with x",
}
OF_PUNCH = {nt.a: "half-width of the punch", nt.f: "height of the face"}
NAMES = {"slope = ": "dw/dx = ", "tilt = ": "phi = ", "width = ": "l = ", "Abs(": "abs(", "Max(": "max("}


def text(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    symbols: Sequence[sp.Symbol],
    notes: Sequence[str],
    example: Sequence[str],
) -> list[str]:
    """Everything below the summary line."""
    lines = [*formula(profile, quantity, entry), "", "Parameters", "----------"]
    for symbol in (*quantity.arguments, *symbols):
        record = nt.describe(symbol)
        domain = f", {record.domain}" if symbol in symbols else ""
        what = f"{capital(meaning(profile, symbol))} [{record.unit}]{domain}."
        lines += [f"{symbol} : array_like", *wrapped(what, 4)]
    unit = nt.describe(quantity.symbol).unit
    shape = "The shape to which the arguments broadcast."
    lines += ["", "Returns", "-------", "float or ndarray"]
    lines += wrapped(f"{capital(meaning(profile, quantity.symbol))} [{unit}]. {shape}", 4)
    lines += ["", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain."]
    lines += ["", "Notes", "-----", *wrapped(" ".join(notes))]
    if profile.sources:
        lines += ["", "References", "----------", *wrapped("; ".join(profile.sources) + ".")]
    return [*lines, "", "Examples", "--------", *example]


def meaning(profile: Profile, symbol: sp.Symbol) -> str:
    """What a symbol means in a plane contact, in words; a punch has its own for half-width and face."""
    own = MEANING | (OF_PUNCH if profile.complete else {})
    return own.get(symbol) or profile.meaning(symbol)


def formula(profile: Profile, quantity: Quantity, entry: Entry | None) -> list[str]:
    """The formula in plain text, for x >= 0 where the field is even or odd."""
    if entry is None:
        return _pieces(profile)
    lines = "\n".join(docstring.formula(profile, quantity, entry))
    for old, new in NAMES.items():
        lines = lines.replace(old, new)
    inside = ["and dw/dx = -f'(x) in the contact."] if quantity.suffix == "s" else []
    return [*lines.split("\n"), *inside]


def _pieces(profile: Profile) -> list[str]:
    lines, lower = [], "0"
    for piece in profile.pieces:
        upper = f" < {piece.upper}" if piece.upper else ""
        where = f"   for {lower} < x{upper}" if len(profile.pieces) > 1 else ""
        lines += wrapped(f"f = {sp.sstr(piece.expr)}{where}")
        lower = str(piece.upper)
    return lines


def notes(profile: Profile, quantity: Quantity, body: str) -> list[str]:
    """Validity, what gives NaN, parity, evaluation, singularities and the key."""
    fields = [str(argument) for argument in quantity.arguments if argument != nt.x]
    out = [f"Valid for {profile.validity}."]
    if quantity.parity and nt.e not in profile.parameters:
        out.append(f"The formula is for x >= 0; the function is {quantity.parity}.")
    out += [_outside(profile, quantity, fields)]
    if "_integral" in body or "_beyond(_growth" in body or "power_" in body:
        out.append("Evaluated as an integral over the growing contact by a Gauss-Legendre rule.")
    if "zero_pressure(" in body:
        out.append("The place of first zero pressure is found by Newton's method.")
    if "inverse(" in body:
        out.append("Evaluated by a safeguarded Newton iteration.")
    if profile.note and quantity.suffix in ("p", "cw"):
        out.append(f"{capital(profile.note)}.")
    defined = ", the definition of the profile" if quantity.suffix == "f" else ""
    return [*(line for line in out if line), f"Handbook: plane.{profile.name}.{quantity.suffix}{defined}."]


def _outside(profile: Profile, quantity: Quantity, fields: Sequence[str]) -> str:
    if not fields:
        return "NaN gives NaN." if quantity.arguments else ""
    text = "Negative or NaN field values" if nt.x not in quantity.arguments else f"Negative {fields[-1]} and NaN"
    more = []
    if nt.L in quantity.arguments:
        more.append("points in the contact, L < a")
    if profile.truncated and nt.a in quantity.arguments:
        more.append(f"half-widths below {profile.breaks[0]} among larger ones")
    if "P" in fields and any(rule for rule in profile.pieces if rule.expr != 0) and profile.complete:
        more.append("loads below minimum_load()")
    return f"{text}{''.join(f', and {one}' for one in more)}{',' if more else ''} give NaN."


def lines(
    profile: Profile, entries: Mapping[str, Entry], quantity: Quantity, symbols: tuple[sp.Symbol, ...]
) -> list[str]:
    """The call with the numbers of the sketch, and its result."""
    suffix = quantity.suffix
    known = environment(profile, entries, suffix)
    arguments = [example.literal(known[symbol]) for symbol in quantity.arguments]
    arguments += [f"{symbol}={example.literal(known[symbol])}" for symbol in symbols]
    result = shape(profile, known) if suffix == "f" else value(profile, entries, suffix, known)
    call = f"{profile.name}.{quantity.function}({', '.join(arguments)})"
    start = [f">>> from axicontact.plane import {profile.name}", f">>> value = {call}"]
    return [*start, ">>> round(value, 6)", example.result(result)]


def environment(profile: Profile, entries: Mapping[str, Entry], suffix: str) -> dict[sp.Symbol, sp.Expr]:
    """The sketch: its parameters and contact, a point inside or twice as far as the edge, and the load to it."""
    known = example.environment(profile)
    known.setdefault(nt.a, sp.Rational(str(profile.sketch.a)))
    known[nt.x] = known[nt.a] * (2 if suffix == "s" else sp.Rational(3, 10))
    known[nt.L] = 10 * known[nt.a]
    if "P" in entries:
        known[nt.P] = example.rounded(example.value(profile, entries["P"], known))
    else:
        known[nt.P] = sp.S.One
    return known


def value(profile: Profile, entries: Mapping[str, Entry], suffix: str, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """The exact result; the place of first zero pressure from its equation where the result needs it."""
    entry = entries[suffix]
    if suffix == "xz" and entry.status == "root":
        cases = tuple(Case(case.chain, case.expr.subs(nt.x_zero, nt.r_zero)) for case in entry.cases)
        return example.value(profile, replace(entry, cases=cases), known)
    if entry.cases[0].expr.has(nt.x_zero):
        known = {**known, nt.x_zero: value(profile, entries, "xz", known)}
    return example.value(profile, entry, known)


def shape(profile: Profile, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Float:
    """f(x) at these numbers."""
    piece = next(piece for piece in profile.pieces if piece.upper is None or known[nt.x] < piece.upper.subs(known))
    return example.number(piece.expr, known)
