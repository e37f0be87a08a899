"""The public functions: signature, docstring, checks and the call of the formula."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from .. import notation as nt
from ..entry import COMPACT, Entry, Quantity
from ..notation import a, coefficients, r
from ..profiles.profile import Profile
from . import example
from .bodies.peak import RADIUS, RESULT
from .docstring import docstring
from .imports import Public
from .private import Private, PrivateFunctions, parameter_name
from .text import python

PACKAGE = "axicontact"
MEMBERS = [quantity.suffix for quantity in COMPACT.values() if quantity.member]
"""The entries whose results one function returns together."""


def public(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    functions: PrivateFunctions,
    shown: list[str],
    ring: Entry | None = None,
) -> Public:
    """The function of a quantity; with a `ring`, of the greatest pressure and of that radius."""
    fields = [str(argument) for argument in quantity.arguments]
    keywords = [parameter_name(s) for s in (entry.parameters if entry else profile.parameters)]
    typed = (
        [f"{name}: ArrayLike" for name in fields] + ["*"] * bool(keywords) + [f"{name}: ArrayLike" for name in keywords]
    )
    private = functions.functions[quantity.function]
    check = "_check" if profile.rules else "require"
    summed = "A" in keywords and coefficients in profile.parameters
    required = [name for name in keywords if not (summed and name == "A")]
    body = [f"{check}({', '.join(f'{name}={name}' for name in required)})"] if required else []
    if profile.truncated and a in quantity.arguments:
        body.append(f"require_reach(a, {profile.breaks[0]})")
    function, passed = private.name, [f"{name}={name}" for name in private.needs]
    if summed:
        body.insert(0, "A = require_coefficients(A)" if "A" in private.needs else "require_coefficients(A)")
        if "A" in private.needs:
            function, passed = f"partial({private.name}, A=A)", [p for p in passed if p != "A=A"]
    further = [name for name in required if name not in private.needs]
    spread = unused(further)
    evaluated = f"elementwise({', '.join([function, *fields, *passed, *spread])})"
    body += _results(evaluated, functions, required) if ring else [f"return {evaluated}"]
    notes = _notes(profile, quantity, private, functions)
    doc = docstring(profile, quantity, entry, notes, shown, ring)
    returns = RESULT if ring else "Result"
    signature = f"def {quantity.function}({', '.join(typed)}) -> {returns}:"
    if len(signature) > 120:
        signature = f"def {quantity.function}(\n    {', '.join(typed)}\n) -> {returns}:"
    # a rule between parameters and a sequence of coefficients are checked by the function itself; a pair is no number
    plain = not (summed or profile.rules or ring)
    if plain:
        given = ", ".join([*private.fields, *private.needs, *further])
        body = [f"value = plain.{quantity.function}({given})", "if value is not None:", "    return value", *body]
    return Public(signature, quantity.summary, doc, body, plain)


def unused(names: Iterable[str]) -> list[str]:
    """The argument of `elementwise` for parameters on which the value does not depend, if there are any."""
    given = "".join(f"{name}, " for name in names)
    return [f"unused=({given.strip() if given.count(',') == 1 else given.strip(', ')})"] if given else []


def _results(pressure: str, functions: PrivateFunctions, keywords: Sequence[str]) -> list[str]:
    """The last lines of the public function: what gives the pressure, and the same for the radius."""
    radius = functions.functions[RADIUS]
    given = [radius.name, *radius.fields, *(f"{need}={need}" for need in radius.needs)]
    given += unused(name for name in keywords if name not in radius.needs)
    return [f"pressure = {pressure}", f"radius = elementwise({', '.join(given)})", f"return {RESULT}(pressure, radius)"]


def _notes(profile: Profile, quantity: Quantity, private: Private, functions: PrivateFunctions) -> list[str]:
    outside = "Negative or NaN field values"
    if profile.truncated and a in quantity.arguments:
        outside += f", and radii below {profile.breaks[0]} among larger ones,"
    notes = [f"Valid for {profile.validity}. {outside} give NaN."]
    text = "\n".join(private.lines)
    for other in functions.functions.values():
        if other.name in text:
            text += "\n" + "\n".join(other.lines)
    if "_integral" in text or "power_pressure" in text or "power_displacement" in text or "power_punches" in text:
        notes.append("Evaluated as an integral over the growing contact by a Gauss-Legendre rule.")
    if re.search(r"\binverse(_across|_below|_beyond|_over_waves)?\(", text):
        notes.append("Evaluated by a safeguarded Newton iteration.")
    if profile.note and quantity.suffix in ("p", "F", "d") and coefficients not in profile.parameters:
        notes.append(f"{profile.note[:1].upper()}{profile.note[1:]}.")
    keys = [quantity.suffix] if not quantity.member else MEMBERS
    shown = ", ".join(f"{profile.name}.{key}" for key in keys)
    notes.append(f"Handbook: {shown}" + ("." if keys != ["f"] else ", the definition of the profile."))
    return [" ".join(notes)]


def shown_example(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    fields: Mapping[sp.Symbol, sp.Rational],
    entries: Mapping[str, Entry],
) -> list[str]:
    """The lines of the doctest of a function: import, call and the value rounded to six decimals."""
    known = example.environment(profile)
    place = dict(fields)
    if quantity.suffix == "w":
        place[r] = 2 * (known[a] if profile.complete else fields[a])
    symbols = entry.parameters if entry else profile.parameters
    arguments = [example.literal(place[argument]) for argument in quantity.arguments]
    for symbol in symbols:
        if symbol == coefficients:
            arguments.append(f"A=({', '.join(example.literal(c) for c in example.POLYNOMIAL)})")
        else:
            arguments.append(f"{symbol}={example.literal(known[symbol])}")
    call = f"{profile.name}.{quantity.function}({', '.join(arguments)})"
    at = known | {argument: place[argument] for argument in quantity.arguments}
    if entry is not None and entry.status == "root" and entry.composed:
        outer, inner = entry.composed
        at = at | {a: example.value(profile, entries[inner], at)}
        number = example.value(profile, entries[outer], at)
    elif entry is None:
        number = example.shape_value(profile, at)
    else:
        at = _with_ring(profile, entries, entry, at)
        number = example.value(profile, entry, at)
    shown = f"value.{quantity.member}" if quantity.member else "value"
    lines = [f">>> from {PACKAGE}.normal import {profile.name}", f">>> value = {call}", f">>> round({shown}, 6)"]
    return [*lines, example.result(number)]


def _with_ring(
    profile: Profile, entries: Mapping[str, Entry], entry: Entry, at: dict[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    for ring in entries.values():
        place = ring.quantity.symbol
        if place in (nt.r_zero, nt.r_peak) and any(case.expr.has(place) for case in entry.cases):
            at = at | {place: example.value(profile, ring, at)}
    return at


def check(profile: Profile) -> dict[str, object]:
    """Name, signature and lines of `_check`, which checks the parameters and the rules between them."""
    names = [parameter_name(s) for s in profile.parameters]
    passed = ", ".join(f"{name}={name}" for name in names)
    lines = [f"require({passed}, **material)"]
    for rule in profile.rules:
        symbols = sorted((str(s) for s in (rule.left.free_symbols | rule.right.free_symbols)), key=names.index)
        relation = sp.sstr(rule.relation())
        arrays = ", ".join(f"np.asarray({name})" for name in symbols)
        lines.append(f"{', '.join(symbols)} = {arrays}")
        sign, left, right = "<" if rule.strict else "<=", rule.left, rule.right
        if left.is_number:
            sign, left, right = sign.replace("<", ">"), right, left
        given = ", ".join(f"{name}={name}" for name in symbols)
        lines += [
            "require_order(",
            f"    {python(left)} {sign} {python(right)},",
            f'    "{relation}",',
            *literal(rule.reason),
            *(f"    {part}," for part in given.split(", ")),
            ")",
        ]
    signature = ", ".join([*(f"{name}: ArrayLike" for name in names), "**material: ArrayLike"])
    return {"name": "_check", "signature": signature, "lines": lines, "returns": " -> None", "doc": ""}


def literal(text: str) -> list[str]:
    """A message as adjacent string literals that fit on their lines."""
    parts = [text] if len(text) <= 109 else textwrap.wrap(text, 100, drop_whitespace=False)
    return [f'    "{part}"' for part in parts[:-1]] + [f'    "{parts[-1]}",']
