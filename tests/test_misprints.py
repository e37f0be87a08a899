"""No misprint of a formula of the handbook passes the comparison with its entry."""

from __future__ import annotations

import itertools
import random
import re
from collections import Counter

import mpmath as mp
import pytest
from misprints import KINDS, misprints
from stored_book import KEYS, changed, differs, front_readings, printed, readings_below, rows

from axiderive.physics.systems import PRINTED, problem
from axiderive.rows.row import Row

READ_BACK = mp.mpf(10) ** -20
NOT_A_NUMBER = (
    SyntaxError, LookupError, ValueError, TypeError, ArithmeticError, RecursionError, mp.libmp.NoConvergence,
)  # fmt: skip
"""What reading a misprint may end in: a name nothing defines, a root of a negative number in a range, a pole."""
QUICK = (
    "cone", "sphere", "power_law", "truncated_paraboloid", "concave_quartic", "capped_cylinder", "cone.adh", "cone.tan",
    "sphere.vis", "cone.fgm", "paraboloid.fgm.adh", "paraboloid.fgm.tan", "plane.parabola", "plane.rounded_wedge",
    "loads.uniform", "materials",
)  # fmt: skip


def _survives(key: str, row: int, region: int, tex: str, count: int, seed: int) -> bool:
    one = rows(key)[row]
    try:
        return not differs(key, changed(one, one.regions[region], tex), READ_BACK, count, seed)
    except NOT_A_NUMBER:
        return False


def _joined(key: str) -> list[Row]:
    return [one for one in printed(key) if one.parts]


@pytest.mark.parametrize("key", ["sphere", "rounded_punch", "cone.adh", "paraboloid.fgm.adh"])
def test_a_misprint_of_a_row_of_several_formulas_does_not_survive(key: str) -> None:
    rng = random.Random(f"several {key}")
    tried = 0
    for one in _joined(key):
        for _, tex in itertools.islice(misprints(one.regions[0].tex, rng), 5):
            tried += 1
            try:
                assert differs(key, changed(one, one.regions[0], tex), READ_BACK, 1, 29), tex
            except NOT_A_NUMBER:
                continue
    assert tried >= 8


def _tried(keys: list[str], wanted: int, rng: random.Random) -> list[tuple[str, int, int, str, str]]:
    """Misprints of random rows of these problems, each of the kind that came least often so far."""
    places = [(key, i, j) for key in keys for i, one in enumerate(rows(key)) for j in range(len(one.regions))]
    rng.shuffle(places)
    count = Counter(dict.fromkeys(KINDS, 0))
    found: list[tuple[str, int, int, str, str]] = []
    for key, i, j in itertools.cycle(places):
        own = list(misprints(rows(key)[i].regions[j].tex, rng))
        if own:
            kind, tex = min(own, key=lambda one: count[one[0]])
            count[kind] += 1
            found.append((key, i, j, kind, tex))
        if len(found) == wanted:
            return found
    raise AssertionError(keys)


def _survivors(tried: list[tuple[str, int, int, str, str]]) -> tuple[list[str], int]:
    """Misprints that passed at the point of the book; and how many of those say the same thing everywhere."""
    survivors, same = [], 0
    for key, i, j, _, tex in tried:
        if not _survives(key, i, j, tex, 1, 29):
            continue
        if _survives(key, i, j, tex, 4, 5):
            same += 1
        else:
            survivors.append(f"{rows(key)[i].key}: {tex}")
    return survivors, same


@pytest.mark.parametrize("key", QUICK)
def test_a_misprint_does_not_survive(key: str) -> None:
    survivors, same = _survivors(_tried([key], 4, random.Random(f"misprints {key}")))
    assert survivors == []
    assert same <= 1


def _chosen(name: str, rng: random.Random) -> list[str]:
    own = [key for key in KEYS if problem(key).system.name == name]
    return rng.sample(own, min(6, len(own)))


@pytest.mark.slow
@pytest.mark.parametrize("name", [system.name for system in PRINTED])
def test_no_misprint_of_any_physics_survives(name: str) -> None:
    rng = random.Random(f"misprints {name}")
    tried = _tried(_chosen(name, rng), 60, rng)
    survivors, same = _survivors(tried)
    assert survivors == []
    assert same <= len(tried) // 20
    assert len({kind for *_, kind, _ in tried}) >= 3


def _unsized(tex: str) -> str:
    return re.sub(r"\\big[lr]|\s", "", tex)


def test_a_misprint_in_front_does_not_survive() -> None:
    """Of definitions, special functions, laws and the table of profiles."""
    rng = random.Random("misprints in front")
    for reading in (*front_readings(), *readings_below()):
        for _, tex in itertools.islice(misprints(reading.tex, rng), 2):
            # only the size of a bracket has moved
            if _unsized(tex) == _unsized(reading.tex):
                continue
            try:
                assert reading.wrong(tex), f"{reading.place}: {tex}"
            except NOT_A_NUMBER:
                continue
