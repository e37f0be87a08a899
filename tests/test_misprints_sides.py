"""No misprint of what stands beside a formula passes: the quantity on its left, the range it holds in."""

from __future__ import annotations

import dataclasses
import random

import pytest
from misprints import left_misprints, range_misprints
from stored_book import KEYS, changed, differs, range_faults, ranged, rows
from test_misprints import NOT_A_NUMBER, READ_BACK

from axiderive.physics.systems import PRINTED, problem

QUICK = (
    "cone", "rounded_cone", "capped_cylinder", "concave_power", "sphere.adh", "paraboloid.tan", "cone.vis",
    "capped_paraboloid.fgm", "plane.rounded_punch", "loads.hertzian",
)  # fmt: skip
LONG_ROWS = ("w", "p", "tau")
"""Rows whose value may take a quadrature; their left sides are tried on the rows of closed form of other problems."""


def _left_tried(key: str, wanted: int) -> list[tuple[int, str]]:
    rng = random.Random(f"left sides {key}")
    found = [
        (i, text)
        for i, one in enumerate(rows(key))
        if "=" in one.regions[0].tex and r"\int" not in one.regions[0].tex
        for text in left_misprints(one.regions[0].tex)
    ]
    rng.shuffle(found)
    return found[:wanted]


def _left_survives(key: str, index: int, text: str) -> bool:
    one = rows(key)[index]
    try:
        return not differs(key, changed(one, one.regions[0], text), READ_BACK)
    except NOT_A_NUMBER:
        return False


def _left_survivors(key: str, wanted: int) -> tuple[list[str], int]:
    tried = _left_tried(key, wanted)
    return [f"{rows(key)[i].key}: {text}" for i, text in tried if _left_survives(key, i, text)], len(tried)


def _range_tried(key: str, wanted: int) -> list[tuple[int, int, str]]:
    rng = random.Random(f"ranges {key}")
    found = [
        (i, j, text)
        for i, one in enumerate(ranged(key))
        for j, region in enumerate(one.regions)
        for text in range_misprints(region.condition, ("r", "a"))
    ]
    rng.shuffle(found)
    return found[:wanted]


def _range_survives(key: str, index: int, region: int, text: str) -> bool:
    """Whether the cases are told apart as well, and each formula holds where its own range says."""
    one = ranged(key)[index]
    conditions = [text if j == region else own.condition for j, own in enumerate(one.regions)]
    try:
        if range_faults(key, index, conditions):
            return False
        own = tuple(dataclasses.replace(r, condition=c) for r, c in zip(one.regions, conditions, strict=True))
        return not differs(key, dataclasses.replace(one, regions=own), READ_BACK)
    except NOT_A_NUMBER:
        return False


def _range_survivors(key: str, wanted: int) -> tuple[list[str], int]:
    tried = _range_tried(key, wanted)
    survivors = [f"{ranged(key)[i].key}: {text}" for i, j, text in tried if _range_survives(key, i, j, text)]
    return survivors, len(tried)


@pytest.mark.parametrize("key", QUICK)
def test_printed_ranges_tell_the_cases_apart(key: str) -> None:
    for index, one in enumerate(ranged(key)):
        assert range_faults(key, index, [region.condition for region in one.regions]) == []


@pytest.mark.parametrize("key", ["power_law", "concave_power", "concave_power.fgm", "plane.concave_power"])
def test_the_exponent_at_which_a_ring_leaves_the_axis_belongs_to_the_axis(key: str) -> None:
    """The paraboloid, n = 2: once it stood in neither of the ranges n < 2 and n > 2."""
    index, one = next((i, one) for i, one in enumerate(ranged(key)) if one.suffix in ("rp", "rz", "xz"))
    inner, beyond = (region.condition for region in one.regions)
    assert range_faults(key, index, [inner, beyond]) == []
    neither, both = [inner.replace(r"\le", "<"), beyond], [inner, beyond.replace(">", r"\ge")]
    the_other = [neither[0], both[1]]
    for wrong in (neither, both, the_other):
        assert wrong != [inner, beyond]
        assert range_faults(key, index, wrong) != [], wrong


@pytest.mark.parametrize("key", QUICK)
def test_a_misprint_of_a_side_does_not_survive(key: str) -> None:
    survivors, tried = _left_survivors(key, 4)
    assert survivors == []
    assert tried == 4
    if ranged(key):
        survivors, tried = _range_survivors(key, 4)
        assert survivors == []
        assert tried == 4


@pytest.mark.slow
@pytest.mark.parametrize("name", [system.name for system in PRINTED])
def test_no_misprint_of_a_side_survives_in_any_physics(name: str) -> None:
    """Every printed range of the book holds where it should; of its misprints, and of those of left sides, none."""
    keys = [key for key in KEYS if problem(key).system.name == name]
    left = ranges = 0
    for key in keys:
        for index, one in enumerate(ranged(key)):
            assert range_faults(key, index, [region.condition for region in one.regions]) == [], one.key
        survivors, tried = _left_survivors(key, 3)
        assert survivors == []
        left += tried
        survivors, tried = _range_survivors(key, 6)
        assert survivors == []
        ranges += tried
    assert left >= 3
    assert ranges == 0 or ranges >= 3
