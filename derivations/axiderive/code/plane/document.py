"""What docstrings of plane modules say: meanings, formulas for x >= 0, and notes."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp

from ... import notation as nt
from ...entry import Entry, Quantity
from ...profiles.profile import Profile
from .. import docstring
from ..docstring import capital

MEANING = {
    nt.a: "half-width of the contact",
    nt.d: "depth of the middle of the contact relative to the surface at the distance L",
    nt.f: "height of the profile above its lowest point in the middle",
    nt.x: "place across the contact, zero in the middle; of either sign",
    nt.slope: "slope of the surface, negative where the displacement into the half-space falls with x",
}
OF_PUNCH = {nt.a: "half-width of the punch", nt.f: "height of the face"}
BEYOND = ("depth_beyond", "load_beyond", "slope_beyond")
"""Rules of the run time over the strips beyond a break."""
NAMES = {"slope = ": "dw/dx = ", "tilt = ": "phi = ", "width = ": "l = ", "Abs(": "abs(", "Max(": "max("}


def text(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    symbols: Sequence[sp.Symbol],
    notes: str,
    example: Sequence[str],
) -> str:
    """The docstring of the function of a quantity."""
    stated = formula(profile, quantity, entry)
    rows = docstring.parameters(quantity.arguments, symbols, lambda symbol: meaning(profile, symbol))
    result = f"{docstring.measured(meaning(profile, quantity.symbol), quantity.symbol)}. {docstring.SHAPE}"
    returns = (docstring.NUMBERS, result)
    return docstring.document(quantity.summary, stated, rows, returns, notes, profile.sources, example)


def meaning(profile: Profile, symbol: sp.Symbol) -> str:
    """What a symbol means in a plane contact, in words; a punch has its own for half-width and face."""
    own = MEANING | (OF_PUNCH if profile.complete else {})
    return own.get(symbol) or profile.meaning(symbol)


def formula(profile: Profile, quantity: Quantity, entry: Entry | None) -> list[str]:
    """The formula in plain text, for x >= 0 where the field is even or odd."""
    lines = "\n".join(docstring.formula(profile, quantity, entry))
    for old, new in NAMES.items():
        lines = lines.replace(old, new)
    inside = ["and dw/dx = -f'(x) in the contact."] if quantity.suffix == "s" else []
    return [*lines.split("\n"), *inside]


def notes(profile: Profile, quantity: Quantity, used: Collection[str]) -> str:
    """Validity, what gives NaN, parity, evaluation, singularities and the key."""
    fields = [str(argument) for argument in quantity.arguments if argument != nt.x]
    out = [f"Valid for {profile.validity}."]
    if quantity.parity and nt.e not in profile.parameters:
        out.append(f"The formula is for x >= 0; the function is {quantity.parity}.")
    out += [_outside(profile, quantity, fields)]
    if any("_integral" in name or name in BEYOND or name.startswith("power_") for name in used):
        out.append("Evaluated as an integral over the growing contact by a Gauss-Legendre rule.")
    if {"ring_of_zero_pressure", "outside_zero_pressure"}.intersection(used):
        out.append("The place of first zero pressure is found by Newton's method.")
    if "inverse" in used:
        out.append("Evaluated by a safeguarded Newton iteration.")
    if profile.note and quantity.suffix in ("p", "cw"):
        out.append(f"{capital(profile.note)}.")
    defined = ", the definition of the profile" if quantity.suffix == "f" else ""
    return " ".join([*filter(None, out), f"Handbook: plane.{profile.name}.{quantity.suffix}{defined}."])


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
