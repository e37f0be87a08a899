"""The search for stable branches: over arrays and with plain numbers, by few steps, also where g' jumps."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from test_interface import PARAMETERS

from axicontact._runtime.interface import KEPT
from axicontact._runtime.physics import branches as arrays
from axicontact._runtime.physics import single

NAMES = ("capped_paraboloid", "rounded_cone", "rounded_punch", "sphere", "sphere_tipped_cone", "truncated_cone")
ADHESION = (1e-12, 1e-3, 0.02, 0.4)
FEW = 21
"""Evaluations of the steepness for each change of its sign: as many at a jump, 5 to 17 elsewhere, 64 by halving."""


@pytest.mark.parametrize("control", ["force", "depth"])
@pytest.mark.parametrize("name", NAMES)
def test_plain_numbers_find_the_branches_of_arrays(name: str, control: str) -> None:
    module = import_module(f"axicontact.adhesive.{name}")
    body = import_module(f"axicontact._programs.bodies.adhesive.{name}")
    geometry = list(PARAMETERS[name].values())
    with np.errstate(all="ignore"):
        found = module._branches(*geometry, 1.3, np.array(ADHESION), control)
    for i, dgamma in enumerate(ADHESION):
        one = body._branches(*geometry, 1.3, dgamma, control)
        known = ~np.isnan(found.first[:, i])
        np.testing.assert_allclose(one.first, found.first[known, i], rtol=4e-15)
        np.testing.assert_allclose(one.last, found.last[known, i], rtol=4e-15)


def sampled(steepness: Any, radii: np.ndarray) -> arrays.Samples:
    with np.errstate(all="ignore"):
        return arrays.Samples(radii[:, None], steepness(radii)[:, None], np.inf, {})


RADII = 10.0 ** np.linspace(-8.0, 8.0, 40)
CORNER = float(RADII[17])
CURVES: dict[str, tuple[Any, float, list[float], list[float]]] = {
    "a power": (lambda a: 3.0 * a**1.5, 0.7, [(0.7 / 3.0) ** (2.0 / 3.0)], [math.inf]),
    "a jump of the grid": (lambda a: np.where(a < CORNER, 0.1, 5.0) + 0.0 * a, 1.0, [CORNER], [math.inf]),
    "from the least radius on": (lambda a: 2.0 + a, 1.0, [1e-8], [math.inf]),
    "a maximum": (lambda a: a / (1.0 + a * a), 0.4, [0.5], [2.0]),
    "never": (lambda a: 1.0 / (1.0 + a), 2.0, [], []),
}


def test_the_branches_of_a_geometry_are_searched_for_once() -> None:
    steepness, level, *_ = CURVES["a maximum"]
    known, calls = sampled(steepness, RADII), [0]

    def counted(a: Any) -> Any:
        calls[0] += 1
        return steepness(a)

    found = single.branches(counted, known, level)
    first = calls[0]
    assert first > 0
    assert single.branches(counted, known, level) == found
    assert calls[0] == first
    assert single.branches(counted, known, 0.9 * level) != found
    assert calls[0] > first
    for dgamma in range(2 * KEPT):
        single.branches(counted, known, 0.01 * (1.0 + dgamma))
    assert len(known.found) <= KEPT


@pytest.mark.parametrize("name", CURVES)
def test_known_changes_are_found_in_few_steps(name: str) -> None:
    steepness, level, first, last = CURVES[name]
    calls = [0]

    def counted(a: Any) -> Any:
        calls[0] += 1
        return steepness(a)

    samples = sampled(steepness, RADII)
    one = single.branches(counted, samples, level)
    np.testing.assert_allclose(one.first, first, rtol=1e-15)
    np.testing.assert_allclose(one.last, last, rtol=1e-15)
    assert calls[0] <= FEW * max(1, len(first) + len(last))
    calls[0] = 0
    with np.errstate(all="ignore"):
        many = arrays.branches(counted, samples, np.array([level]))
    np.testing.assert_allclose(many.first[:, 0], first, rtol=1e-15)
    np.testing.assert_allclose(many.last[:, 0], last, rtol=1e-15)
    assert calls[0] <= 2 * FEW
    assert single.lowest(one, lambda a: -a) == (first[-1] if first else pytest.approx(math.nan, nan_ok=True))


def test_the_lowest_of_several_branches_is_pull_off() -> None:
    """Not the first nor the highest, and none whose load is no number."""
    first, loads = [1.0, 2.0, 3.0], {1.0: -0.2, 2.0: -0.7, 3.0: math.nan}
    assert single.lowest(arrays.Branches(first, [1.5, 2.5, math.inf]), loads.__getitem__) == 2.0
    columns = np.array(first)[:, None]
    assert arrays.lowest(arrays.Branches(columns, columns), lambda a: np.array([loads[float(a[0])]])).tolist() == [2.0]
