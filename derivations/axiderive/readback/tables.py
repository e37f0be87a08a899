"""Check values, worked examples and the line on the evidence in the compiled source, with what they have to be."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..profiles.loads import Load
from ..rows.row import row
from ..worked.contact import largest
from .grammar import read
from .numbers import (
    BESIDE,
    DIGITS,
    Columns,
    Contact,
    Entries,
    Printout,
    Wanted,
    eccentric,
    given_in,
    number,
    prescribed,
)
from .printed import Printed, name_in_print

_CHECKS = re.compile(r"\\sect\[([^\]]*?); last digit rounded\]\{Check values\}(.*?)\\bottomrule", re.DOTALL)
_COLUMNS = re.compile(r"\$([^$]+)\$\\enspace\\own\{(\w+)\}")
_HEAD = re.compile(r"\$([^$=]+)=([^$]+)\$")
_RATIO = re.compile(r"^\$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$\\\\$", re.MULTILINE)
_LINE = re.compile(r"^\$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$ & \$([^$]+)\$\\\\$", re.MULTILINE)
WORKED = re.compile(r"\\sect\[([^\]]*)\]\{Worked example\}(.*?)\\par\}", re.DOTALL)
SHOWN = re.compile(r"\\parbox\[t\]\{[\d.]+mm\}\{\$([^$]+)\$\\\\\$([^$]+)\$")
_MATERIAL = re.compile(r"\$E=([\d.]+)\$\\,(GPa|MPa), \$\\nu=([\d.]+)\$(?:, \$\\Delta\\gamma=([\d.]+)\$\\,mJ)?")


_PROVED = re.compile(
    r"\\textcolor\{note\}\{Evidence:\}\\enspace(\d+) of (\d+) formulas? proved; [\w ]+ to at least (\d+) digits"
    r"(?:; (\d+) (?:is the root of an equation|are roots of equations))?(?:; (\d+) (?:is an integral|are integrals))?"
    r"\. All of it: \\href\{html/([\w.]+)\.html\}"
)


@dataclass(frozen=True)
class Proved:
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


@dataclass(frozen=True)
class Heading:
    """What the heading of a worked example states: Young's modulus and Poisson's ratio of so many equal bodies."""

    young: Any
    poisson: Any
    bodies: int
    separation: str
    stated: str
    """E* as it is printed."""
    given: dict[str, Any]
    """E* as it follows from the constants, the parameters and the load by their names."""


def heading(text: str) -> Heading:
    """The heading of the worked example of a spread.

    Raises
    ------
    LookupError
        If the spread has none, or it does not name a material.
    """
    match = WORKED.search(text)
    words = match[1] if match else ""
    material, stated = _MATERIAL.search(words), re.search(r"\$E\^\{\*\}=([^$]+)\$", words)
    if not material or not stated:
        message = f"no material and E* in {words!r}; a worked example starts with them"
        raise LookupError(message)
    bodies = 2 if words.startswith("steel on steel") else 1
    young, poisson = number(rf"{material[1]}\text{{{material[2]}}}").value, mp.mpf(material[3])
    modulus = young / (bodies * (1 - poisson**2))
    given = given_in(words[stated.end() :]) | {"E*": modulus}
    return Heading(young, poisson, bodies, material[4], stated[1], given)


def check_values(text: str, entries: Entries) -> Iterator[Printout]:
    """The table of check values of a spread, from its source."""
    match = _CHECKS.search(text)
    if match is None:
        return
    with mp.workdps(DIGITS):
        ratios = _RATIO.findall(match[2])
        for share, *values in ratios:
            yield from _over_breaks(entries, given_in(match[1]), share, values)
        if ratios:
            return
        contact = Contact(entries, given_in(match[1]))
        wanted, columns = _known(contact) or _pressed(contact)
        for name, tex in _HEAD.findall(match[2]):
            yield Printout(f"check value {name}", tex, wanted[name]())
        keys = [key for _, key in _COLUMNS.findall(match[2])]
        for line in _LINE.findall(match[2]):
            for key, place, value in zip(keys, line[::2], line[1::2], strict=True):
                at = number(place).value * contact.given["a"] * (1 + mp.mpf(BESIDE))
                yield Printout(f"check value {key} at {place}", value, columns[key](at))


def _over_breaks(entries: Entries, given: dict[str, Any], share: str, values: list[str]) -> Iterator[Printout]:
    """One line of the table of a profile that breaks, at b over a."""
    profile = next(iter(entries.values())).profile
    length = number(share).value * given["a"]
    own = {name_in_print(profile.breaks[0]): length}
    for _, expr in profile.abbreviations:
        unknown = profile.parameters[0]
        known = {s: sp.Float(str(given[name_in_print(s)]), DIGITS) for s in expr.free_symbols - {unknown}}
        (value,) = sp.solve(expr.xreplace(known) - sp.Float(str(length), DIGITS), unknown)
        own = {name_in_print(unknown): mp.mpf(str(value))}
    contact = Contact(entries, given | own)
    radius, depth = given["a"], contact.depth()
    wants = (
        depth,
        contact.load(),
        contact.pressure(radius / 2) / contact.mean(),
        contact.displacement(2 * radius) / depth,
    )
    for name, tex, want in zip(("d", "F", "p", "w"), values, wants, strict=True):
        yield Printout(f"check value {name} at b/a={share}", tex, want)


def worked_example(text: str, entries: Entries, adhesive: Entries | None = None) -> Iterator[Printout]:
    """The numbers of the worked example of a spread, from its source: the modulus, then those of the load."""
    match = WORKED.search(text)
    if match is None:
        return
    with mp.workdps(DIGITS):
        solid = heading(text)
        yield Printout("worked example E*", solid.stated, solid.given["E*"])
        contact, shown = Contact(entries, solid.given), SHOWN.findall(match[2])
        known = _known(contact)
        wanted = known[0] if known else _loaded(contact, shown, solid.separation, adhesive or {})
        for name, tex in shown:
            if tex == r"\infty":
                _require_infinite(contact, name, wanted["a"](), wanted["d"])
                continue
            yield Printout(f"worked example {name}", tex, wanted[name]())


def _known(contact: Contact) -> tuple[Wanted, Columns] | None:
    """Of what has no profile."""
    profile = next(iter(contact.entries.values())).profile
    if isinstance(profile, Load):
        return prescribed(contact)
    return eccentric(contact) if nt.e in profile.parameters else None


def _pressed(contact: Contact) -> tuple[Wanted, Columns]:
    """Of a contact at the radius that is given."""
    depth, mean = contact.depth(), contact.mean()
    wanted: Wanted = {"d": lambda: depth, r"F_{\mathrm N}": contact.load, "P": contact.load, r"\bar p": lambda: mean}
    return wanted, {
        "p": lambda place: contact.pressure(place) / mean,
        "d" if contact.plane else "w": lambda place: contact.displacement(place) / depth,
    }


def _loaded(contact: Contact, shown: list[tuple[str, str]], separation: str, adhesive: Entries) -> Wanted:
    """Of a contact under the load that is given."""
    radius = _radius(contact, shown)
    depth = _depth(contact, radius)
    known = {"a": radius} | ({"d": depth} if "dF" in contact.entries and "d" not in contact.entries else {})
    load = contact.given["P" if contact.plane else "F_N"]
    breaks = next(iter(contact.entries.values())).profile.breaks
    ends = [mp.mpf(0), *(mp.mpf(str(contact.values[b])) for b in breaks), radius]
    return {
        "a": lambda: radius,
        "d": lambda: depth,
        r"\bar p": lambda: contact.mean(radius, load),
        r"p_{\mathrm{max}}": lambda: largest(lambda place: mp.re(contact.pressure(place, **known)), ends),
        "w(2a)": lambda: contact.displacement(2 * radius, **known),
        r"F_{\mathrm c}": lambda: _pull_off(contact, adhesive, separation, radius),
    }


def _require_infinite(contact: Contact, name: str, radius: Any, depth: Callable[[], Any]) -> None:
    """That the printed pressure does not come to an end where it is said to be infinite.

    Raises
    ------
    ValueError
        If it grows by less over the last five decades towards that place than over the five before them.
    """
    known = {"a": radius} | ({"d": depth()} if "dF" in contact.entries and "d" not in contact.entries else {})
    places = {"0": mp.mpf(0), "a": radius}
    at = places[name[2:-1]] if name[2:-1] in places else mp.mpf(str(contact.values[nt.b]))
    # from the side where the face is in contact, and from above its tip
    side = -1 if at else 1
    beside = (at + side * radius * mp.mpf(10) ** -power for power in (3, 8, 13))
    near, nearer, nearest = (mp.re(contact.pressure(place, **known)) for place in beside)
    if not nearest - nearer > 0.9 * (nearer - near) > 0:
        message = f"{name} is printed as infinite and comes to {nearest}"
        raise ValueError(message)


def _radius(contact: Contact, shown: list[tuple[str, str]]) -> Any:
    """The contact radius at which the printed force carries the load, near the printed one."""
    if "a" in contact.given:
        return contact.given["a"]
    load = contact.given["P" if contact.plane else "F_N"]
    start = number(dict(shown)["a"]).value
    return mp.findroot(lambda a: contact.load(a=a) / load - 1, (start, start * mp.mpf("1.001")), solver="secant")


def _depth(contact: Contact, radius: Any) -> Any:
    """The depth of the compact contact; that of a complete one from its load."""
    if "d" in contact.entries:
        return contact.at("d", a=radius)
    load = contact.given["F_N"]
    start = load / (2 * contact.given["E*"] * radius)
    return mp.findroot(lambda d: contact.load(d=d) / load - 1, (start, start * mp.mpf("1.1")), solver="secant")


def _pull_off(contact: Contact, adhesive: Entries, separation: str, radius: Any) -> Any:
    """The printed force of pull-off at the radius that its printed formula or equation gives, below the loaded one."""
    printed = Printed(adhesive, contact.entries)
    values = contact.values | {nt.dgamma: sp.Float(separation, DIGITS) / 1000}
    env = printed.environment(values) | contact.given
    first = read(row(adhesive["ac"]).regions[0].tex)[0].members
    if adhesive["ac"].status == "closed":
        env["a_c"] = first[-1](env)
    else:
        start = radius / 3
        env["a_c"] = mp.findroot(
            lambda a: first[0](env | {"a_c": a}) / first[-1](env | {"a_c": a}) - 1, (start, start / 2), solver="secant"
        )
    return printed.at("Fc", env, adhesive)
