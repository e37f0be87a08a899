"""Profiles and entries as JSON-able records and back: what the cache, the evidence and `check` read and write.

An expression is `{"=": srepr}`, an object `{"@is": class, field: value, ...}`;
the catalogue's own profiles and quantities are referred to by name.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

import sympy as sp

from .contact import adhesive, detachment, loads, materials, plane_quantities, tangential, viscoelastic
from .entry import COMPACT, COMPLETE, Case, Entry, Primitive, Quantity
from .profiles.loads import Load
from .profiles.profile import Limit, Piece, Profile, Rule, Sketch
from .srepr import from_text, to_text

Record = Any
_CLASSES: dict[str, type] = {
    cls.__name__: cls for cls in (Case, Entry, Limit, Load, Piece, Primitive, Profile, Quantity, Rule, Sketch)
}
_KINDS = {
    "compact": COMPACT,
    "complete": COMPLETE,
    "adhesive": adhesive.QUANTITIES,
    "detachment": detachment.QUANTITIES,
    "tangential": tangential.QUANTITIES,
    "viscoelastic": viscoelastic.QUANTITIES,
    "plane": plane_quantities.PLANE,
    "plane complete": plane_quantities.PLANE_COMPLETE,
    "plane eccentric": plane_quantities.PLANE_ECCENTRIC,
    "loads": loads.QUANTITIES,
    "materials": materials.QUANTITIES,
}
_QUANTITIES = {f"{name}.{q.suffix}": q for name, kind in _KINDS.items() for q in kind.values()}


class RecordError(ValueError):
    """A record that does not describe one of our objects."""


def profile_record(profile: Profile) -> Record:
    """All that a derivation or a verification can depend on."""
    return _encode(profile, {})


def entry_record(entry: Entry) -> Record:
    return _encode(entry, {entry.profile.name: entry.profile})


def read_entry(record: Record, profile: Profile) -> Entry:
    """The entry of `profile` that `entry_record` wrote."""
    try:
        entry = _decode(record, {profile.name: profile})
    except (TypeError, KeyError, AttributeError) as error:
        message = f"{profile.name}: a stored entry cannot be read ({error}); run axicontact build --fresh"
        raise RecordError(message) from error
    if not isinstance(entry, Entry):
        message = f"{profile.name}: a stored entry is a {type(entry).__name__}; run axicontact build --fresh"
        raise RecordError(message)
    return entry


def _encode(value: Any, profiles: Mapping[str, Profile]) -> Record:
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, sp.Basic):
        return {"=": to_text(value)}
    if isinstance(value, (tuple, list)):
        return [_encode(item, profiles) for item in value]
    if isinstance(value, dict):
        return {"@items": [[_encode(key, profiles), _encode(item, profiles)] for key, item in value.items()]}
    if isinstance(value, Profile) and profiles.get(value.name) == value:
        return {"@profile": value.name}
    if isinstance(value, Quantity):
        return {"@quantity": next(name for name, quantity in _QUANTITIES.items() if quantity == value)}
    if type(value).__name__ in _CLASSES:
        fields = {f.name: _encode(getattr(value, f.name), profiles) for f in dataclasses.fields(value)}
        return {"@is": type(value).__name__, **fields}
    message = f"{type(value).__name__} {value!r} has no record"
    raise RecordError(message)


def _decode(record: Record, profiles: Mapping[str, Profile]) -> Any:
    if isinstance(record, list):
        return tuple(_decode(item, profiles) for item in record)
    if not isinstance(record, dict):
        return record
    if "=" in record:
        return from_text(record["="])
    if "@items" in record:
        return {_decode(key, profiles): _decode(value, profiles) for key, value in record["@items"]}
    if "@profile" in record:
        return profiles[record["@profile"]]
    if "@quantity" in record:
        return _QUANTITIES[record["@quantity"]]
    fields = {name: _decode(value, profiles) for name, value in record.items() if name != "@is"}
    return _CLASSES[record["@is"]](**fields)
