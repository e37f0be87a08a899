"""Modules `axicontact.plane.<profile>`: strips on the elastic half plane."""

from __future__ import annotations

from collections.abc import Mapping

from ... import notation as nt
from ...entry import Entry, Quantity
from ...letters import name_of
from ...physics.plane import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ...physics.systems import BY_NAME
from ...profiles.profile import Profile
from ..bodies.regimes import split
from ..function import Function, reached
from ..module import Module
from ..private import PrivateFunctions
from ..writer import Writer, check, required
from . import complete, document
from .compact import Compact
from .complete import Complete

SYSTEM = BY_NAME["plane"]
SHAPE = Quantity("f", "profile", "Profile", nt.f, (nt.x,), parity="even", summary="Profile f(x) of the indenter.")


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
    doc = document.text(profile, quantity, entry, symbols, document.notes(profile, quantity, used), shown)
    # from the other side of the middle the load is seen at -e
    given = {"e": "turned(x, e)"} if _eccentric(profile) and nt.x in quantity.arguments else {}
    evaluated = writer.evaluated(private.name, fields, keywords, quantity.parity or "elementwise", **given)
    return Function(quantity.function, fields, keywords, [*checks, f"return {evaluated}"], doc, "Result")


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> Compact | None:
    """Add the private functions."""
    if nt.e in functions.profile.parameters:
        complete.add_all(entries, functions)
        return None
    if functions.profile.complete:
        Complete(entries, functions).add_all()
        return None
    compact = Compact(entries, functions)
    compact.add_all()
    return compact
