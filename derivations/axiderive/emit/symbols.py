"""The table of parameters and their domains behind `require`, read off the notation."""

from __future__ import annotations

import re
from collections.abc import Iterable

import sympy as sp

from .. import notation as nt


def bounds(domain: str) -> tuple[str, str]:
    """The open interval a domain such as `0 < theta < pi/2` or `R > 0` stands for, as Python text."""
    two_sided = re.fullmatch(r"(\S+) < \w+ < (\S+)", domain)
    if two_sided:
        return _number(two_sided[1]), _number(two_sided[2])
    above = re.fullmatch(r"\w+ > (\S+)", domain)
    if above:
        return _number(above[1]), "inf"
    message = f"the domain {domain!r} is not an open interval; write it as 'low < x < high' or 'x > low'"
    raise ValueError(message)


def _number(text: str) -> str:
    return repr(float(sp.sympify(text, locals={"pi": sp.pi})))


def symbols_source(names: Iterable[str]) -> str:
    """The text of `_symbols.py` for the parameters of these names."""
    lines = [
        '"""Domains and meanings of the keyword parameters."""',
        "",
        "from __future__ import annotations",
        "",
        "from math import inf",
        "",
        "SYMBOLS = {",
    ]
    for record in nt.all_notation():
        if record.name in set(names):
            low, high = bounds(record.domain)
            unit = "" if record.unit == "1" else f", in {record.unit}"
            lines.append(f'    "{record.name}": ({low}, {high}, "{record.domain}", "{record.meaning}{unit}"),')
    return "\n".join([*lines, "}", ""])
