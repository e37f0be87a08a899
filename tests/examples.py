"""The worked examples in the source of the book, and what the functions of the package give at their numbers.

The key behind a number says which function it is from, and its name where a field is asked for.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from inspect import signature
from typing import Any

import numpy as np
from stored_book import stored

from axiderive import notation as nt
from axiderive.letters import name_of
from axiderive.physics.systems import pool_of, problem

EXTENT = {"": 1.0, "G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, r"\textmu{}": 1e-6, "n": 1e-9, "p": 1e-12}
NUMBER = re.compile(
    r"(?P<digits>-?\d[\d.]*)?(?:\\times)?(?:10\^\{(?P<power>-?\d+)\})?"
    r"(?:\\text\{(?P<prefix>G|M|k|m(?=\w)|\\textmu\{\}|n|p|)(?:m|Pa|N|N/m|rad|s|Pam\}\^\{-k|\(SI\))\}"
    r"(?:\^\{(?P<degree>-?\d+)\})?)?"
)


def number(tex: str) -> tuple[float, float]:
    r"""The value of 1.5, 0.288\,785, 2\times10^{13} or 20\,\text{m}^{-1} in the SI, and half its last digit."""
    match = NUMBER.fullmatch(tex.replace(r"\,", ""))
    assert match, f"{tex} is not a number"
    assert match["digits"] or match["power"], f"{tex} is not a number"
    digits = match["digits"] or "1"
    scale = EXTENT[match["prefix"] or ""] ** int(match["degree"] or 1) * 10.0 ** int(match["power"] or 0)
    return float(digits) * scale, scale * 10.0 ** -len(digits.partition(".")[2]) / 2


@dataclass(frozen=True)
class Shown:
    """A number in print: the example it is of, its name and LaTeX, and what the functions give."""

    example: str
    name: str
    tex: str
    value: float

    def wrong(self, tex: str) -> bool:
        """Whether a text in its place is another number, in its last digit too."""
        value, half = number(tex)
        return abs(value - self.value) > half * (1 + 1e-6)


NAMES = {nt.describe(one.symbol).latex: name_of(one.symbol) for one in reversed(nt.all_notation())} | {
    "E": "E", r"\Delta\gamma": "dgamma", r"\tau": "tau", r"E_\infty": "E_inf",
}  # fmt: skip
"""What the functions call a letter of a heading: of two records with one letter, the first."""
WORKED = re.compile(r"\\sect(?:\[([^\]]*)\])?\{Worked example\}(.*?)\\par\}", re.DOTALL)
BESIDE = re.compile(r"\\textcolor\{note\}\{(.*?)\}\\par")
"""The words of the example of a plane entry, which stands beside its plot."""
FURTHER = re.compile(r"\\textcolor\{ink\}\{([A-Z][a-z -]+)\}\\enspace\\textcolor\{note\}\{(.*?):\}\\hspace")
NUMBERS = re.compile(
    r"\\parbox\[t\]\{[\d.]+mm\}\{\$([^$]+)\$\\\\\$([^$]+)\$\\\\(?:\\own\{([\w.]+)\})?\}"
    r"|\\mbox\{\$([^$=]+)=([^$]+)\$(?:~\\own\{([\w.]+)\})?\}"
)


def given_in(words: str) -> dict[str, Any]:
    """The assignments of a heading by the names of the functions, coefficients as one list."""
    found: dict[str, Any] = {}
    for tex, unit in re.findall(r"\$([^$]+)\$(?:\\,(GPa|MPa|mJ))?", words):
        name, equals, right = tex.partition("=")
        if equals and name.startswith("A_"):
            found.setdefault("A", []).append(number(right)[0])
        elif equals:
            found[NAMES[name]] = number(right)[0] * {"GPa": 1e9, "MPa": 1e6, "mJ": 1e-3}.get(unit, 1.0)
    return found


def called(key: str, known: Mapping[str, Any]) -> Any:
    """What the function of a formula gives of the names that it takes."""
    group, _, suffix = key.rpartition(".")
    module = import_module(problem(group).module.removesuffix(".py").replace("/", "."))
    function = getattr(module, stored(group)[suffix].quantity.function)
    found = function(**{name: known[name] for name in signature(function).parameters})
    return getattr(found, {"Fc": "force", "pp": "pressure"}.get(suffix, ""), found)


def examples(name: str, text: str) -> Iterator[Shown]:
    """Every number of the worked examples of a spread, with what the functions of the package give for it."""
    match = WORKED.search(text)
    if not match:
        return
    words = match[1] or BESIDE.findall(match[2])[0]
    known = given_in(words) | {"control": "force"}
    if "E" in known:
        bodies = 2 if words.startswith("steel on steel") else 1
        known |= {"bodies": bodies, "E_star": known["E"] / (bodies * (1 - known["nu"] ** 2))}
        yield Shown("", "E*", re.findall(r"\$E\^\{\*\}=([^$]+)\$", words)[0], known["E_star"])
    first, *others = FURTHER.split(match[2])
    yield from _numbers("", name, first, known)
    for title, own, numbers in zip(others[::3], others[1::3], others[2::3], strict=True):
        stated = known | given_in(own)
        for symbol, wanted in MODULI.get(title, {}).items():
            stated[NAMES[symbol]] = wanted(stated)
            yield Shown(title, symbol, re.findall(rf"\${re.escape(symbol)}=([^$]+)\$", own)[0], stated[NAMES[symbol]])
        yield from _numbers(title, name, numbers, stated)


def _shear(known: Mapping[str, Any]) -> float:
    nu = known["nu"]
    return 2 * known["E"] / (known["bodies"] * (1 + nu) * (2 - nu))


MODULI: dict[str, dict[str, Callable[[Mapping[str, Any]], float]]] = {
    "Partial slip": {"G^{*}": _shear},
    "Graded half-space": {"H": lambda known: called("materials.H", known)},
}
"""What an example states that follows from its other constants."""


def _numbers(title: str, name: str, text: str, known: dict[str, Any]) -> Iterator[Shown]:
    """The numbers one after the other; each is known to those behind it."""
    for groups in NUMBERS.findall(text):
        symbol, tex, key = groups[:3] if groups[0] else groups[3:]
        if tex == r"\infty":
            assert _is_infinite(f"{name}.{key}", symbol[2:-1], known), symbol
            continue
        value = float(_value(name, symbol, key, known))
        if symbol in NAMES:
            known[NAMES[symbol]] = value
        elif symbol == r"F_{\mathrm N}(0)":
            known["F"] = value
        yield Shown(title, symbol, tex, value)


def _value(name: str, symbol: str, key: str, known: Mapping[str, Any]) -> Any:
    if symbol == r"p_{\mathrm{max}}" and key == "p":
        places = known["a"] * np.linspace(0, 0.9999, 10001)
        return np.max(called(f"{name}.p", {**known, "r": places, "x": places}))
    place = symbol.partition("(")[2].rstrip(")")
    if key:
        return called(f"{name}.{key}", {**known, **_at(place, known)} if place else known)
    if symbol == r"\bar p":
        return known["P"] / (2 * known["a"]) if "P" in known else known["F"] / (np.pi * known["a"] ** 2)
    if symbol == "F":  # of a prescribed pressure, summed over rings; v^2 is 1 - r^2/a^2
        v = (np.arange(10000) + 0.5) / 10000
        exponent = float(known.get("s", pool_of(name).load(name.rpartition(".")[2]).exponent))
        return np.pi * known["a"] ** 2 * known["p_0"] * np.mean(2 * v ** (2 * exponent + 1))
    return called("cone.Fd", known)  # sharp, at the same depth


def _at(place: str, known: Mapping[str, Any], moved: float = 0.0) -> dict[str, float]:
    r"""A place as 10a, -a/2, b or 0, or a time as 10\tau."""
    factor, letter, half = re.fullmatch(r"(-?\d*)(\\tau|[ab])?(/2)?", place).groups()  # type: ignore[union-attr]
    unit = known[NAMES[letter]] if letter else 1.0
    value = float(f"{factor}1" if factor in ("", "-") else factor) * unit / (2 if half else 1) + moved
    return {"t": value, "r": value, "x": value}


def _is_infinite(key: str, place: str, known: Mapping[str, Any]) -> bool:
    """Whether a pressure grows as much over five decades towards a place, from within, as over the five before."""
    side = known["a"] if place == "0" else -known["a"]
    first, second, third = (called(key, {**known, **_at(place, known, side * 10.0**-n)}) for n in (3, 8, 13))
    return third - second > 0.9 * (second - first) > 0
