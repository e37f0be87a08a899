"""The numbers of an example in print, with a prefix and a unit of the SI, and the same example in Python."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath as mp

from .. import notation as nt
from ..entry import Entry
from ..letters import name_of
from ..profiles.profile import Profile
from .cases import Case, Material

PREFIXES = {-12: "p", -9: "n", -6: r"\textmu{}", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
DIGITS = 20


def given_text(name: str, text: str, degree: int = 0) -> str:
    """A given value with its unit; that of an amplitude A of r**degree is a power of the metre."""
    notation = nt.describe(name) if nt.known(name) else None
    if notation and notation.unit in ("m", "Pa", "N", "N/m"):
        return stated_text(mp.mpf(text), notation.unit)
    mantissa, _, power = text.partition("e")
    digits = (rf"{mantissa}\times" if mantissa != "1" else "") + f"10^{{{int(power)}}}" if power else mantissa
    return digits + (rf"\,\text{{m}}^{{{1 - degree}}}" if degree > 1 else "")


def stated_text(value: Any, unit: str) -> str:
    """A value that is given, without the zeros that say how far a result was computed: 50 mN."""
    return quantity_text(value, unit, strip=True)


def quantity_text(value: Any, unit: str, strip: bool = False) -> str:
    """Four significant digits with a prefix of the unit."""
    if value == 0:
        return rf"0\,\text{{{unit}}}"
    with mp.workdps(DIGITS):
        value = mp.mpf(mp.nstr(value, 4))
        power = int(mp.floor(mp.log10(abs(value)) / 3 + mp.mpf(10) ** -9)) * 3
        power = max(min(power, 9), -12)
        text = mp.nstr(value / mp.mpf(10) ** power, 4, strip_zeros=strip, min_fixed=-5, max_fixed=7)
    return rf"{text.removesuffix('.0') if strip else text.rstrip('.')}\,\text{{{PREFIXES[power]}{unit}}}"


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
