"""The stored results of the catalogue and the rows that the handbook prints of them, without deriving anything."""

from __future__ import annotations

import dataclasses
import itertools
import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from axiderive import notation as nt
from axiderive.build.work import read_entries
from axiderive.entry import Entry
from axiderive.physics.systems import Problem, pool_of, problem, problems
from axiderive.physics.viscoelastic import in_radius
from axiderive.readback import fields, front, layer
from axiderive.readback.claims import Line, residuals, worst_residual
from axiderive.readback.ranges import Place, misplaced, places_of
from axiderive.rows import blocks
from axiderive.rows.blocks import rows_of
from axiderive.rows.row import Region, Row
from axiderive.rows.special import HOSTS

CATALOGUE = Path(__file__).resolve().parents[1] / "catalogue"
HANDBOOK = CATALOGUE / "handbook"
KEYS = tuple(p.key for p in problems())
PROFILES = tuple(dict.fromkeys(p.profile_id for p in problems()))
PRINTED = tuple(name for name in PROFILES if name not in HOSTS)
"""Profiles with an entry of their own in print."""
SEED = 29


@cache
def record(key: str) -> dict[str, Any]:
    """What the catalogue holds of a problem, as plain data."""
    found: dict[str, Any] = json.loads((CATALOGUE / "evidence" / f"{key}.json").read_bytes())
    return found


@cache
def receipts() -> dict[str, dict[str, str]]:
    """By problem and kind of result, of which inputs a build has made it."""
    found: dict[str, dict[str, str]] = json.loads((CATALOGUE / "evidence" / "receipts.json").read_bytes())
    return found


@cache
def stored(key: str) -> dict[str, Entry]:
    return read_entries(problem(key), record(key)["entries"])


def on_pages(entries: Mapping[str, Entry]) -> list[Entry]:
    """Those with a row on the page of their profile; springs and a way back stand with the laws, before all pages."""
    return [e for e in entries.values() if nt.t_m not in e.parameters and not (nt.v in e.parameters and in_radius(e))]


def suffixes(key: str) -> tuple[str, ...]:
    """The quantities of a problem, without reading their formulas."""
    return tuple(record(key)["entries"])


@cache
def kernels() -> str:
    """The fitted kernels of the run time as the catalogue holds them."""
    return (CATALOGUE / "axicontact" / "_runtime" / "kernels.py").read_text()


def evidence(key: str) -> dict[str, Any]:
    """What the catalogue holds of the checks and measurements of a problem."""
    found: dict[str, Any] = record(key)["evidence"]
    return found


def base_of(own: Problem) -> str:
    """Key of the problem whose rows the rules of this one refer to."""
    return own.base.key if own.base else own.key


@cache
def rows(key: str) -> list[Row]:
    """All rows of a problem, as the web edition shows them."""
    own = problem(key)
    return rows_of(own.system, stored(key), {k: stored(k) for k in (base_of(own), key)}, own.name)


@cache
def printed(key: str) -> list[Row]:
    """The rows of a problem that stand in the book, those that are said by a rule marked as listed."""
    return blocks.printed(problem(key).system, rows(key))


def residual(key: str, one: Row, count: int = 1, seed: int = SEED) -> Any:
    """How far a row is from its entry."""
    return worst_residual(one, stored(key), count, seed, stored(base_of(problem(key))))


def differs(key: str, one: Row, limit: Any, count: int = 1, seed: int = SEED) -> bool:
    """Whether a row differs from its entry by more than the limit at one of the points."""
    return any(found >= limit for found in residuals(one, stored(key), count, seed, stored(base_of(problem(key)))))


def changed(one: Row, region: Region, tex: str) -> Row:
    """The row with other LaTeX in one of its regions."""
    own = tuple(dataclasses.replace(r, lines=(tex,)) if r is region else r for r in one.regions)
    return dataclasses.replace(one, regions=own)


@cache
def ranged(key: str) -> tuple[Row, ...]:
    """The rows of a problem that are printed with a range."""
    return tuple(one for one in rows(key) if any(region.condition for region in one.regions))


@cache
def _places(key: str, index: int) -> list[Place]:
    one = ranged(key)[index]
    return places_of(one.entry, one.kind, stored(key))


def range_faults(key: str, index: int, conditions: list[str]) -> list[str]:
    """Where ranges in place of those of a row do not tell the cases of its entry apart."""
    return list(itertools.islice(misplaced(ranged(key)[index].entry, conditions, _places(key, index)), 1))


@cache
def front_readings() -> list[Line]:
    """The formulas that stand in front of the book, but for the numbers below the surface."""
    return [
        *front.definitions(stored("rounded_punch"), stored("concave_quartic")),
        *front.functions(),
        *front.stresses(),
        *front.rules(stored),
        *front.laws_of_materials(),
        *layer.rules(),
        *(reading for name in PROFILES if name in KEYS for reading in front.master_table(name, stored(name))),
    ]


@cache
def readings_below() -> list[Line]:
    """The numbers below the surface: letters, formulas of every slope, profiles that are made of them."""
    return fields.numbers(stored)


def panel_readings(name: str) -> list[Line]:
    """The formulas of the definition panel of a profile and of the words on its derivation."""
    return front.panel(name, pool_of(name).load(name.rpartition(".")[2]), stored(name) if name in KEYS else {})
