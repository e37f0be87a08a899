"""Modules of a contact above another one: a public function for each entry, and what its physics states of it.

What the functions evaluate is either written by rules of their own (`tangential.py`), or named by the physics in
functions of the run time.
"""

from __future__ import annotations

from itertools import groupby

from ...entry import Entry
from ...letters import name_of
from .. import docstring
from ..function import Function
from ..writer import Writer, not_above


def interface(writer: Writer) -> None:
    """Adds the public functions; entries that are members of one result share one."""
    physics, profile = writer.system.physics, writer.profile
    taken = f"; {physics.assumed}" if physics.assumed else ""
    notes = f"Valid for {profile.validity}{taken}. Negative or NaN field values give NaN."
    for low, _, _ in physics.ordered:
        if profile.truncated:
            notes += f" The stick zone is never smaller than the flat face: NaN for {low} < b."
    for _, group in groupby(writer.entries.values(), key=lambda entry: entry.quantity.function):
        first, *others = group
        checks = writer.checks(first.parameters, reach=True)
        for low, high, reason in physics.ordered:
            if low in map(name_of, first.arguments):
                checks += not_above(low, high, reason)
        if first.quantity.member:
            _several(writer, [first, *others], notes, checks)
        else:
            writer.add(first, notes, checks)


def rules(writer: Writer) -> None:
    """Adds what the physics names for every entry."""
    assert writer.system.physics.code is not None
    for suffix, line in writer.system.physics.code(writer.profile).items():
        entry = writer.entries[suffix]
        fields, needs = (list(map(name_of, own)) for own in (entry.arguments, entry.parameters))
        writer.rule(_private(entry), fields, needs, [f"return {line}"])


def _private(entry: Entry) -> str:
    return f"_{entry.quantity.function}" + (f"_{entry.quantity.member}" if entry.quantity.member else "")


def _several(writer: Writer, entries: list[Entry], notes: str, checks: list[str]) -> None:
    """A public function whose result is a named tuple of the run time, by one entry for each member."""
    first, quantity = entries[0], entries[0].quantity
    result = writer.system.physics.results[quantity.function]
    fields, names = (list(map(name_of, own)) for own in (first.arguments, first.parameters))
    members = [docstring.measured(docstring.in_words(own.quantity.symbol), own.quantity.symbol) for own in entries]
    said = ", ".join(
        f"{own.quantity.member} is the {text[0].lower()}{text[1:]}" for own, text in zip(entries, members, strict=True)
    )
    doc = docstring.document(
        quantity.summary,
        [line for own in entries for line in docstring.stated(own)],
        docstring.parameters(first.arguments, first.parameters),
        (result, f"Named tuple: {said}. {docstring.SHAPE}"),
        f"{notes} Handbook: {', '.join(own.key for own in entries)}.",
        docstring.sources_of(first),
        writer.example.lines(first.suffix),
    )
    found = ", ".join(writer.evaluated(_private(own), fields, names) for own in entries)
    writer.public.append(
        Function(quantity.function, fields, names, [*checks, f"return {result}({found})"], doc, result)
    )
