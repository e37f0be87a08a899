"""One form of a function up to some multiple of the break of the profile, another one beyond."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from ..entry import Entry
from .private import Private, PrivateFunctions

Bodies = Callable[[PrivateFunctions, Mapping[str, Entry]], object]


def split(functions: PrivateFunctions, entries: Mapping[str, Entry], bodies: Bodies) -> None:
    """Join the functions whose chosen form is that of one side of a split with those of the other side."""
    for entry in entries.values():
        variant = functions.own(entry)
        if variant.beyond:
            above = PrivateFunctions(functions.profile, common=variant.above)
            bodies(above, entries)
            join(functions, above, entry.quantity.function, variant.beyond)


def join(functions: PrivateFunctions, above: PrivateFunctions, name: str, beyond: float) -> bool:
    """Split one function where a reaches so many times the break; whether there is anything to split."""
    low, high = functions.functions.get(name), above.functions.get(name)
    if not functions.profile.breaks or low is None or high is None or "a" not in low.fields:
        return False
    if low.lines == high.lines or any(high.uses(own) and own != high for own in _parts(above, name)):
        return False
    known, b = functions.functions, str(functions.profile.breaks[0])
    sides = [replace(side, name=f"{low.name}_{end}") for side, end in ((low, "below"), (high, "above"))]
    del known[name]
    known |= {side.name.removeprefix("_"): side for side in sides}
    value = f"np.where(a < {beyond!r} * {b}, {sides[0].call()}, {sides[1].call()})"
    functions.add(name, low.fields, [f"return {value}"], {*sides[0].needs, *sides[1].needs, b})
    return True


def _parts(functions: PrivateFunctions, name: str) -> list[Private]:
    return [own for key, own in functions.functions.items() if key.startswith(name)]
