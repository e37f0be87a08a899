"""The functions of a normal contact in every variant of their evaluation forms, as modules to be measured."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

from ..entry import Entry
from ..stable.chosen import chosen
from ..stable.cost import cost
from ..stable.variants import VARIANTS
from ..stable.written import Written
from .private import Private, PrivateFunctions
from .python import bodies, bodies_source

PARTS = ("", "_at", "_beyond")
"""What the names of the functions of one quantity end on."""


def written(entries: Mapping[str, Entry], suffixes: Collection[str] | None = None) -> dict[str, tuple[Written, ...]]:
    """The distinct ways of these functions, all if none are named, that are no iterations along others.

    The one that the published module has comes first.
    """
    wanted = {suffix: entry for suffix, entry in entries.items() if suffixes is None or suffix in suffixes}
    profile = next(iter(entries.values())).profile
    base = PrivateFunctions(profile)
    bodies(base, entries)
    found: dict[str, dict[tuple[str, ...], Written]] = {suffix: {} for suffix in wanted}
    for suffix, entry in wanted.items():
        _add(found[suffix], chosen(entry.key).name, base, base, entry)
    for variant in VARIANTS:
        functions = PrivateFunctions(profile, common=variant)
        bodies(functions, entries)
        for suffix, entry in wanted.items():
            _add(found[suffix], variant.name, base, functions, entry)
    return {suffix: tuple(own.values()) for suffix, own in found.items() if own}


def _add(
    found: dict[tuple[str, ...], Written],
    name: str,
    base: PrivateFunctions,
    functions: PrivateFunctions,
    entry: Entry,
) -> None:
    function = entry.quantity.function
    own = _own(functions, function)
    lines = tuple(line for private in own.values() for line in private.lines)
    if lines and lines not in found:
        rest = {key: private for key, private in base.functions.items() if key not in _own(base, function)}
        source = bodies_source(replace(base, functions=rest | own), name)
        fields = [str(argument) for argument in entry.quantity.arguments]
        found[lines] = Written(
            name, source, f"_{function}", _formula(own, function), cost(source, f"_{function}", fields)
        )


def _formula(own: Mapping[str, Private], function: str) -> str:
    """The lines of a body, and those of the bodies of the same quantity that it calls."""
    main = "; ".join(map(str.strip, own[function].lines))
    called = [private for name, private in own.items() if name != function and f"{private.name}(" in main]
    return " | ".join([main, *(f"{private.name}: {'; '.join(map(str.strip, private.lines))}" for private in called)])


def _own(functions: PrivateFunctions, function: str) -> dict[str, Private]:
    names = [f"{function}{part}" for part in PARTS]
    return {name: functions.functions[name] for name in names if name in functions.functions}
