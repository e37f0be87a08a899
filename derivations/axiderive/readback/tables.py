"""The tables of check values and the line on the evidence in the compiled source, with what they have to be."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

import mpmath as mp
import sympy as sp

from .claims import DIGITS, Line
from .numbers import BESIDE, Columns, Contact, Entries, Wanted, given_in, number, rounded, without_profile
from .printed import name_in_print

_CHECKS = re.compile(r"\\sect\[([^\]]*?); last digit rounded\]\{Check values\}(.*?)\\bottomrule", re.DOTALL)
_COLUMNS = re.compile(r"\$([^$]+)\$\\enspace\\own\{(\w+)\}")
_HEAD = re.compile(r"\$([^$=]+)=([^$]+)\$")
_RATIO = re.compile(r"^\$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$\\\\$", re.MULTILINE)
_LINE = re.compile(r"^\$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$\\\\$", re.MULTILINE)
_PROVED = re.compile(
    r"\\textcolor\{note\}\{Evidence:\}\\enspace(\d+) of (\d+) formulas? proved; [\w ]+ to at least (\d+) digits"
    r"(?:; (\d+) (?:is the root of an equation|are roots of equations))?(?:; (\d+) (?:is an integral|are integrals))?"
    r"\. All of it: \\href\{html/([\w.]+)\.html\}"
)


class Proved(NamedTuple):
    """What the line on the evidence of a spread states, and the page it names."""

    proved: int
    formulas: int
    digits: int
    roots: int
    integrals: int
    page: str


def proved(text: str) -> Proved:
    """The line on the evidence of a spread, from its source.

    Raises
    ------
    LookupError
        If the spread has none.
    """
    match = _PROVED.search(text)
    if match is None:
        message = "no line on the evidence"
        raise LookupError(message)
    *counts, page = match.groups(default="0")
    certified, formulas, digits, roots, integrals = map(int, counts)
    return Proved(certified, formulas, digits, roots, integrals, page)


def check_values(text: str, entries: Entries) -> Iterator[Line]:
    """The table of check values of a spread, from its source."""
    match = _CHECKS.search(text)
    if match is None:
        return
    with mp.workdps(DIGITS):
        given, ratios = given_in(match[1]), _RATIO.findall(match[2])
        for share, *values in ratios:
            yield from _over_breaks(entries, given, share, values)
        if ratios:
            return
        contact = Contact(entries, given)
        wanted, columns = without_profile(contact) or _pressed(contact)
        for name, tex in _HEAD.findall(match[2]):
            yield rounded(f"check value {name}", tex, wanted[name]())
        keys = [key for _, key in _COLUMNS.findall(match[2])]
        for line in _LINE.findall(match[2]):
            for key, place, value in zip(keys, line[::2], line[1::2], strict=True):
                at = number(place).value * contact.given["a"] * (1 + mp.mpf(BESIDE))
                yield rounded(f"check value {key} at {place}", value, columns[key](at))


def _over_breaks(entries: Entries, given: dict[str, Any], share: str, values: list[str]) -> Iterator[Line]:
    """One line of the table of a profile that breaks, at b over a."""
    profile, radius = next(iter(entries.values())).profile, given["a"]
    length = number(share).value * radius
    own = {name_in_print(profile.breaks[0]): length}
    for _, expr in profile.abbreviations:
        unknown = profile.parameters[0]
        known = {s: sp.Float(str(given[name_in_print(s)]), DIGITS) for s in expr.free_symbols - {unknown}}
        (value,) = sp.solve(expr.xreplace(known) - sp.Float(str(length), DIGITS), unknown)
        own = {name_in_print(unknown): mp.mpf(str(value))}
    contact = Contact(entries, given | own)
    _, columns = _pressed(contact)
    wants = (
        contact.depth(),
        contact.load(),
        columns["p"](radius / 2),
        contact.displacement(2 * radius) / contact.depth(),
    )
    for name, tex, want in zip(("d", "F", "p", "w"), values, wants, strict=True):
        yield rounded(f"check value {name} at b/a={share}", tex, want)


def _pressed(contact: Contact) -> tuple[Wanted, Columns]:
    """Of a contact at the radius that is given."""
    depth, mean = contact.depth(), contact.mean()
    wanted: Wanted = {"d": lambda: depth, r"F_{\mathrm N}": contact.load, "P": contact.load, r"\bar p": lambda: mean}
    return wanted, {
        "p": lambda place: contact.pressure(place) / mean,
        "d" if contact.plane else "w": lambda place: contact.displacement(place) / depth,
    }
