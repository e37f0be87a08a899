"""The worked example in Python: the numbers of its heading in, the first of its results out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..entry import Entry
from ..letters import name_of
from ..profiles.profile import Profile
from .cases import Case, Material

Lines = list[tuple[str, str]]
"""A line of Python, and what it shows: nothing after an assignment."""
Entries = Mapping[str, Entry]


def modulus(material: Material) -> str:
    """E_star from Young's modulus and Poisson's ratio of the bodies that give way."""
    unit = "e9" if material.young >= 10**9 else "e6"
    halved = "/2" if material.yielding == 2 else ""
    return f"E_star = {material.young / float('1' + unit):g}{unit}{halved}/(1 - {material.poisson}**2)"


def called(module: str, entry: Entry, given: Mapping[str, str], *fields: str) -> str:
    """The call of the function of an entry, with its fields by place and its parameters by name."""
    names = (name_of(symbol) for symbol in entry.parameters)
    keywords = (f"{name}={given.get(name, name)}" for name in names)
    return f"{module}.{entry.quantity.function}({', '.join([*fields, *keywords])})"


def in_python(profile_id: str, profile: Profile, entries: Entries, case: Case, results: Sequence[Any]) -> Lines:
    """The contact that carries the load of an example, and its two first results, which the formulas gave."""
    package, _, name = profile_id.rpartition(".")
    given = dict(case.parameters)
    if "A_1" in given:
        given = {"A": f"[{', '.join(given.values())}]"}
    load, distance = f"{case.load:g}".replace("e+0", "e"), "0.05"
    start: Lines = [(f"from axicontact.{package or 'normal'} import {name}", ""), (modulus(case.material), "")]

    def call(suffix: str, *fields: str) -> str:
        return called(name, entries[suffix], given, *fields)

    if package and profile.complete:
        return [*start, (call("d", distance, load), shown(*results))]
    if profile.complete:
        sunk = call("w", f"2*{given['a']}", "d")
        return [*start, (f"d = {call('dF', load)}", ""), (f"d, {sunk}", shown(*results))]
    radius, depth = (call("aP", load), call("d", distance, "a")) if package else (call("aF", load), call("d", "a"))
    return [*start, (f"a = {radius}", ""), (f"a, {depth}", shown(*results))]


def shown(*values: Any) -> str:
    """The values as Python writes them, with four digits."""
    texts = [repr(float(f"{float(value):.4g}")) for value in values]
    return texts[0] if len(texts) == 1 else f"({', '.join(texts)})"
