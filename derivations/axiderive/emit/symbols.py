"""The tables of parameters and their domains behind `require`, read off the notation."""

from __future__ import annotations

import re
from collections.abc import Iterable

import sympy as sp

from .. import notation as nt
from ..letters import LETTERS, name_of
from . import layout

INSTEAD = {
    nt.dgamma: "use dgamma = 0 for a contact without adhesion",
    nt.mu: "give the coefficient as a positive number, or mu = 0 for a contact without friction",
    nt.sigma: "a steeper edge carries an infinite force, use s > -1",
    nt.v: "a shrinking contact does not obey the rule of Lee and Radok, use v > 0",
    nt.alpha: "use the Maxwell law for a fluid (alpha = 1) and the elastic contact for alpha = 0",
    nt.k: "use a modulus that grows less than linearly with depth, or k = 0 for a homogeneous half-space",
}
"""What an error message offers in place of a value outside the domain."""
LOADED = {nt.d: "d >= 0", nt.F: "F >= 0"}
"""A field elsewhere, and where it is a parameter it may be zero."""

HEAD = '''"""Domains of the keyword parameters in words, and the units of all arguments: what messages need."""

from __future__ import annotations

from typing import NamedTuple


class Domain(NamedTuple):
    """Where a parameter may lie, and what it is."""

    rule: str
    meaning: str
    closed: str = ""
    """The end that belongs to the domain, "low" or "high"."""
    instead: str = ""
    """What to use for a value outside."""
    letter: str = ""
    """How the interface writes the parameter, where it shares its letter with another one."""


SYMBOLS = {
'''
INTERVALS = '''"""Domains of the keyword parameters in numbers."""

from __future__ import annotations

from math import inf

INSIDE = {
'''


def bounds(domain: str) -> tuple[str, str, str]:
    """The interval a domain such as `0 < theta < pi/2` or `dgamma >= 0` stands for: its ends, and which is closed."""
    two_sided = re.fullmatch(r"(\S+) < \w+ (<=?) (\S+)", domain)
    if two_sided:
        return _number(two_sided[1]), _number(two_sided[3]), "high" if two_sided[2] == "<=" else ""
    above = re.fullmatch(r"\w+ (>=?) (\S+)", domain)
    if above:
        return _number(above[2]), "inf", "low" if above[1] == ">=" else ""
    message = f"the domain {domain!r} is not an interval; write it as 'low < x < high', 'x > low' or 'x >= low'"
    raise ValueError(message)


def _number(text: str) -> str:
    return repr(float(sp.sympify(text, locals={"pi": sp.pi})))


def key_of(symbol: sp.Symbol, name: str) -> str:
    """The keyword of `require` for a parameter `name`: the symbol itself where its letter is taken."""
    return f"{symbol}={name}" if symbol in LETTERS else f"{name}={name}"


def symbols_sources(names: Iterable[str], arguments: Iterable[sp.Symbol | sp.IndexedBase] = ()) -> dict[str, str]:
    """The texts of `_symbols.py` and `_intervals.py` for the parameters of these names in the notation.

    They are apart because every import needs the numbers, and the words are for messages.
    """
    wanted = set(names)
    records = [record for record in nt.all_notation() if record.name in wanted]
    words = [line for record in records for line in _row(record)]
    intervals = [f'    "{record.name}": ({", ".join(bounds(_domain(record))[:2])}),' for record in records]
    return {
        "_symbols.py": HEAD + "\n".join([*words, "}", *_units(set(arguments)), ""]),
        "_intervals.py": INTERVALS + "\n".join([*intervals, "}", ""]),
    }


def _units(arguments: set[sp.Symbol | sp.IndexedBase]) -> list[str]:
    """Of a letter with two meanings, a length and an exponent, there is no unit to be told."""
    units: dict[str, set[str]] = {}
    for record in nt.all_notation():
        if record.symbol in arguments:
            units.setdefault(name_of(record.symbol), set()).add(record.unit)
    rows = [f'    "{letter}": "{unit}",' for letter, (unit, *others) in units.items() if not others]
    return ["UNITS = {", *rows, "}", '"""Units of the arguments, by their letters in the interface."""']


def _row(record: nt.Notation) -> list[str]:
    domain = _domain(record)
    closed = bounds(domain)[2]
    unit = "" if record.unit == "1" else f", in {record.unit}"
    parts = [f'"{domain}"', f'"{record.meaning}{unit}"']
    instead, letter = INSTEAD.get(record.symbol, ""), LETTERS.get(record.symbol, "")
    named = {"closed": closed, "instead": instead, "letter": letter}
    parts += [f'{name}="{text}"' for name, text in named.items() if text]
    lines = layout.call(f'"{record.name}": Domain', parts, "),")
    return ["    " + line for line in lines]


def _domain(record: nt.Notation) -> str:
    return LOADED.get(record.symbol, record.domain)
