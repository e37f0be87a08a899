"""Integrals of a wave on the graded half-space against the Struve function, and their cost far out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from axicontact._runtime.graded import waves

UNITS = 8.0
"""Of 2**-52 and of the envelope; 4 measured on either side of FAR."""


def exact(phase: float, k: float, derivative: int) -> Any:
    """The integral of sin(x cos(y)) sin(y)**k over a quarter turn, or its derivatives by x."""
    order = mp.mpf(k) / 2

    def turn(x: Any) -> Any:
        return mp.sqrt(mp.pi) / 2 * mp.gamma(order + mp.mpf(1) / 2) * (2 / x) ** order * mp.struveh(order, x)

    return mp.diff(turn, mp.mpf(phase), derivative)


@pytest.mark.parametrize("k", [-1.0 + 1e-10, -0.3, 0.3, 1.0 - 1e-12])
@pytest.mark.parametrize("phase", [3.0, 15.9, 16.1, 29.0, 75.3, 2000.0])
def test_waves_near_and_far(phase: float, k: float) -> None:
    with mp.workdps(30):
        value, first, second = (exact(phase, k, derivative) for derivative in range(3))
        unit = 2.0**-52 * mp.hypot(value, first)
        at: dict[Callable[..., Any], Any] = {waves.waves_depth: value, waves.waves_rate: value + phase * first}
        at[waves.waves_force] = -second
        for function, wanted in at.items():
            got = mp.mpf(float(function(np.ones(1), np.array([phase]), np.array([k]))[0]))
            scale = phase if function is waves.waves_rate else 1
            assert abs(got / phase - wanted) <= UNITS * unit * scale, (function, got / phase, wanted)


def test_radii_far_out_cost_no_panels() -> None:
    """A grid of radii over a hundred decades took four thousand panels for every one of them."""
    calls = []

    def watched(x: np.ndarray, _: np.ndarray) -> np.ndarray:
        calls.append(x)
        return np.sin(x)

    waves._waves(10.0 ** np.arange(-3.0, 99.0), np.array(1.0), np.array(0.3), watched, lambda c, _: np.ones_like(c))
    assert len(calls) <= 12
    assert max(np.max(x) for x in calls) <= waves.FAR
