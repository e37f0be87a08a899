"""Numbers in print of what has no profile: prescribed pressures, and the punch that an eccentric load tilts."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import mpmath as mp
import sympy as sp

from ...profiles.loads import Load
from .grammar import read
from .numbers import (
    BESIDE,
    CHECKS,
    DIGITS,
    HEAD,
    LINE,
    SHOWN,
    WORKED,
    Contact,
    Entries,
    Printout,
    given_in,
    heading,
    number,
)

_COLUMNS = re.compile(r"\$([^$]+)\$\\enspace\\own\{(\w+)\}")


def given_numbers(text: str, entries: Entries) -> Iterator[Printout]:
    """The check values and the worked example of a spread, from its source."""
    table, example = CHECKS.search(text), WORKED.search(text)
    if table is None or example is None:
        return
    with mp.workdps(DIGITS):
        yield from _table(Contact(entries, given_in(table[1])), table[2], _COLUMNS.findall(table[2]))
        solid = heading(text)
        yield Printout("worked example E*", solid.stated, solid.given["E*"])
        yield from _example(Contact(entries, solid.given), SHOWN.findall(example[2]))


def _table(contact: Contact, table: str, columns: list[tuple[str, str]]) -> Iterator[Printout]:
    given = contact.given
    radius = given["a"]
    if contact.plane:
        mean = contact.mean(radius, given["P"])
        heads, scale, place = {"varphi": contact.at("phi"), "bar p": mean}, mean, "x"
    else:
        heads, place = {"F_N": _pressed(contact)}, "r"
        scale = given["p_0"] * radius / given["E*"]
    for name, tex in HEAD.findall(table):
        yield Printout(f"check value {name}", tex, heads[read(name)[0].members[0].name])
    for line in LINE.findall(table):
        for (_, suffix), where, value in zip(columns, line[::2], line[1::2], strict=True):
            want = contact.at(suffix, **{place: number(where).value * radius * (1 + mp.mpf(BESIDE))}) / scale
            yield Printout(f"check value {suffix} at {where}", value, want)


def _example(contact: Contact, shown: list[tuple[str, str]]) -> Iterator[Printout]:
    radius = contact.given["a"]
    whole = {r"\varphi": "phi", r"\ell": "cw"}
    for name, tex in shown:
        if name == "F":
            want = _pressed(contact)
        elif name in whole:
            want = contact.at(whole[name])
        else:
            suffix, place = name[0], name[2:-1]
            at = {"0": mp.mpf(BESIDE), "2a": 2, "10a": 10, "a/2": mp.mpf(1) / 2, "-a/2": -mp.mpf(1) / 2}[place]
            want = contact.at(suffix, **{"x" if contact.plane else "r": at * radius})
        yield Printout(f"worked example {name}", tex, want)


def _pressed(contact: Contact) -> Any:
    """The force of a prescribed pressure, as the integral of p_0 (1 - r**2/a**2)**s."""
    load = next(iter(contact.entries.values())).profile
    if not isinstance(load, Load):
        message = f"{load.name} prescribes no pressure; its table needs the columns p over its mean and w over d"
        raise TypeError(message)
    power = mp.mpf(str(sp.sympify(load.exponent).xreplace(contact.values)))
    inside = mp.quad(lambda u: (1 - u) ** power, [0, 1])
    return mp.pi * contact.given["a"] ** 2 * contact.given["p_0"] * inside
