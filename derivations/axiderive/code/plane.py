"""Modules `axicontact.plane.<profile>`: strips on the elastic half plane, and what their docstrings say."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import sympy as sp

from .. import notation as nt
from ..entry import Entry, Quantity
from ..letters import name_of
from ..physics.plane import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ..physics.systems import BY_NAME
from ..profiles.profile import Profile
from . import docstring
from .bodies import strips
from .bodies.regimes import split
from .function import Function, reached
from .module import Module
from .private import PrivateFunctions
from .writer import Writer, check, required

SYSTEM = BY_NAME["plane"]
SHAPE = Quantity("f", "profile", "Profile", nt.f, (nt.x,), parity="even", summary="Profile f(x) of the indenter.")
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


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of one profile."""
    writer = Writer(SYSTEM, entries, entries)
    profile, functions = writer.profile, PrivateFunctions(writer.profile)
    bodies(functions, entries)
    split(functions, entries, bodies)
    known = writer.private = list(functions.functions.values())
    writer.public += [_public(writer, quantity) for quantity in _quantities(profile, entries)]
    checked = [check(profile)] if profile.rules and not _eccentric(profile) else []
    writer.private = [*checked, *reached(known, writer.public)]
    return writer.module()


def _eccentric(profile: Profile) -> bool:
    return nt.e in profile.parameters


def _quantities(profile: Profile, entries: Mapping[str, Entry]) -> list[Quantity]:
    if _eccentric(profile):
        return list(PLANE_ECCENTRIC.values())
    known = PLANE_COMPLETE if profile.complete else PLANE
    return [SHAPE, *(quantity for suffix, quantity in known.items() if suffix in entries)]


def _public(writer: Writer, quantity: Quantity) -> Function:
    """The public function of one quantity; without an entry that of the shape f(x)."""
    profile, entry = writer.profile, writer.entries.get(quantity.suffix)
    symbols = entry.parameters if entry else profile.parameters
    fields, keywords = ([name_of(symbol) for symbol in own] for own in (quantity.arguments, symbols))
    if _eccentric(profile):
        checks = [required(symbol for symbol in symbols if symbol != nt.e), "require_eccentricity(a, e)"]
    else:
        checks = writer.checks(symbols, reach="a" in fields)
    private = next(own for own in writer.private if own.name == f"_{quantity.function}")
    used = private.uses.union(*(own.uses for own in reached(writer.private, [private])))
    shown = writer.example.lines(quantity.suffix) if entry else writer.example.shape()
    rows = docstring.parameters(quantity.arguments, symbols, lambda symbol: meaning(profile, symbol))
    result = f"{docstring.measured(meaning(profile, quantity.symbol), quantity.symbol)}. {docstring.SHAPE}"
    doc = docstring.document(
        quantity.summary, _formula(profile, quantity, entry), rows, (docstring.NUMBERS, result),
        _notes(profile, quantity, used), profile.sources, shown,
    )  # fmt: skip
    # from the other side of the middle the load is seen at -e
    given = {"e": "turned(x, e)"} if _eccentric(profile) and nt.x in quantity.arguments else {}
    evaluated = writer.evaluated(private.name, fields, keywords, quantity.parity or "elementwise", **given)
    return Function(quantity.function, fields, keywords, [*checks, f"return {evaluated}"], doc, "Result")


def meaning(profile: Profile, symbol: sp.Symbol) -> str:
    """What a symbol means in a plane contact, in words; a punch has its own for half-width and face."""
    own = MEANING | (OF_PUNCH if profile.complete else {})
    return own.get(symbol) or profile.meaning(symbol)


def _formula(profile: Profile, quantity: Quantity, entry: Entry | None) -> list[str]:
    """The formula in plain text, for x >= 0 where the field is even or odd."""
    lines = "\n".join(docstring.formula(profile, quantity, entry))
    for old, new in NAMES.items():
        lines = lines.replace(old, new)
    inside = ["and dw/dx = -f'(x) in the contact."] if quantity.suffix == "s" else []
    return [*lines.split("\n"), *inside]


def _notes(profile: Profile, quantity: Quantity, used: Collection[str]) -> str:
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
        out.append(f"{docstring.capital(profile.note)}.")
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


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> None:
    """Add the private functions."""
    if _eccentric(functions.profile):
        strips.add_all(entries, functions)
    else:
        (strips.Complete if functions.profile.complete else strips.Compact)(entries, functions).add_all()
