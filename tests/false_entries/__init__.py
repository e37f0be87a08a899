"""Entries that are false, made of true ones: formulas, regions and definitions that nobody may certify.

Each differs from the true entry in what a reader of the handbook or a caller
of the module would get: another value at a point of its region, a formula that
is not real there, an unknown symbol, another region, or another definition.
`difference` says which.  Nothing here is drawn: the corpus is the same in every
run, and only its mutations use a generator, seeded by the names they belong to.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator
from dataclasses import replace
from zlib import crc32

import sympy as sp

from axiderive import notation as nt
from axiderive.entry import Entry

from .entries import PROBLEMS, FalseEntry, Found, below, changed, derived, record, stated, times, with_formula
from .formulas import (
    branches,
    cancelled_terms,
    circular_inverses,
    constants,
    equations,
    mutations,
    named_jumps,
    piecewise_constant,
    rounded_numbers,
    sums,
)
from .physics import eccentric, material_constants, mirrored
from .reader import difference
from .regions import (
    conditions,
    definitions,
    doctored_primitives,
    exchanged_regions,
    fixed_faces,
    foreign_symbols,
    idle_primitives,
    media,
    unused_cases,
)

__all__ = [
    "PROBLEMS",
    "FalseEntry",
    "below",
    "candidates",
    "derived",
    "difference",
    "false_entries",
    "of",
    "record",
    "with_formula",
]


FAMILIES: tuple[tuple[Callable[[str], Found], int], ...] = (
    (piecewise_constant, 5),
    (named_jumps, 1),
    (circular_inverses, 2),
    (unused_cases, 7),
    (conditions, 11),
    (eccentric, 1),
    (definitions, 7),
    (foreign_symbols, 3),
    (mutations, 7),
    (media, 5),
    (branches, 5),
    (constants, 3),
    (equations, 3),
    (doctored_primitives, 1),
    (fixed_faces, 1),
    (rounded_numbers, 5),
    (cancelled_terms, 31),
    (idle_primitives, 1),
    (exchanged_regions, 1),
    (sums, 5),
    (material_constants, 1),
    (mirrored, 1),
)
"""Each family and how many of its members there are to one of the corpus."""


def candidates(key: str, *, whole: bool = False) -> Iterator[FalseEntry]:
    """What the families make of the true entries of a problem, or, `whole`, everything that they could make."""
    seen: set[tuple[str, Entry]] = set()
    for number, (family, stride) in enumerate(FAMILIES):
        first = crc32(f"{key} {number}".encode())
        for index, (name, suffix, entry) in enumerate(family(key), start=first):
            if (whole or index % stride == 0) and (suffix, entry) not in seen:
                seen.add((suffix, entry))
                yield FalseEntry(name, key, suffix, {**derived(key), suffix: entry})
    yield from conspiracies(key)


def conspiracies(key: str) -> Iterator[FalseEntry]:
    """Several false entries that bear each other out."""
    entries = derived(key)
    if "rz" in entries and any(isinstance(case.expr, sp.Equality) for case in entries["rz"].cases):
        nothing = sp.asin(nt.r_zero / nt.a) + sp.acos(nt.r_zero / nt.a) - sp.pi / 2
        least = changed(entries["dmin"], lambda true: nothing * nt.h)
        for number in (sp.gamma(nt.n / 2 + 1), sp.gamma((nt.n + 1) / 2), sp.sqrt(sp.pi)):
            ring = changed(entries["rz"], lambda true: true)
            cases = (ring.cases[0], replace(ring.cases[1], expr=sp.Eq(number, 0, evaluate=False)))
            both = {**entries, "rz": replace(ring, cases=cases), "dmin": least}
            yield FalseEntry("conspiracy", key, "rz", both)
            yield FalseEntry("conspiracy", key, "dmin", both)
    for base, *others in (("d", "F", "p", "w", "k"), ("F", "k", "pm"), ("P", "p", "s"), ("Dl", "d", "F"), ("p", "rz")):
        if base in entries and all(stated(entries[suffix]) for suffix in (base, *others) if suffix in entries):
            doubled = {suffix: changed(entries[suffix], times(2)) for suffix in (base, *others) if suffix in entries}
            found = entries[base].primitives.items()
            twice = {c: tuple(replace(p, integrand=2 * p.integrand, expr=2 * p.expr) for p in own) for c, own in found}
            doubled[base] = replace(doubled[base], primitives=twice)
            for suffix in list(doubled)[:2]:
                if doubled[suffix] != entries[suffix]:
                    yield FalseEntry("conspiracy", key, suffix, {**entries, **doubled})


@functools.cache
def of(problem: str) -> tuple[FalseEntry, ...]:
    """The candidates that differ from the true entry at a point, or in what they say beside the formula."""
    told = ((found, difference(found)) for found in candidates(problem))
    return tuple(replace(found, told=text) for found, text in told if text)


@functools.cache
def false_entries() -> tuple[FalseEntry, ...]:
    """The whole corpus; `of` makes the part of one problem, for tests that share the problems among workers."""
    return tuple(found for problem in PROBLEMS for found in of(problem))
