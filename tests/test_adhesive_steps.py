"""How often an adhesive inverse asks for the load: arrays over decades of size, adhesion and distance to pull-off."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from importlib import import_module
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from test_inverse_steps import EPS, GRADED, STEPS, Draw

from axicontact._runtime import inverse as roots
from axicontact._runtime.physics import stable

POINTS = {"adhesive": 300, "graded.adhesive": 40}
SLOW = ("sphere_tipped_cone",)
"""Its force is an integral."""
MISSED = 8.0
"""What the load at the radius misses, over the rounding of its two parts and of the radius; 7.0 measured."""
MORE = {"adhesive": 0, "graded.adhesive": 1}
"""Evaluations beyond those of a normal contact: seven of one draw with 1 - k = 7e-13, whose first is all rounding."""
SHARPEST = -0.99
"""Below, an edge is told from a radius beyond it by less than the rounding of the radius."""
Arrays = dict[str, Any]


def drawn(name: str, points: int, seed: int) -> tuple[Arrays, Any, Draw]:
    draw, rows, radii = Draw(seed), [], []
    for _ in range(points):
        known, radius = draw.bodies(name)
        grading = max(draw.grading(), SHARPEST)
        rows.append(known | {"E_star": draw.decades(-3, 3), "H": draw.decades(-3, 3), "k": grading})
        radii.append(radius)
    return {key: np.array([row[key] for row in rows]) for key in rows[0]}, np.array(radii), draw


def arguments(function: Callable[..., Any], known: Arrays, first: int = 1) -> list[Any]:
    return [known[name] for name in list(inspect.signature(function).parameters)[first:] if name != "control"]


def evaluations(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    calls = [0]

    def counting(curve: Callable[..., Any], *given: Any, **named: Any) -> Any:
        def watched(t: Any) -> Any:
            calls[0] += 1
            return curve(t)

        return roots.inverse(watched, *given, **named)

    monkeypatch.setattr(stable, "inverse", counting)
    return calls


def check(module: ModuleType, group: str, name: str, quantity: str, calls: list[int]) -> None:
    points = POINTS[group] // (4 if name in SLOW else 1)
    known, radius, draw = drawn(name, points, 5)
    scale = known["E_star"] * radius if group == "adhesive" else known["H"] * radius ** (1.0 + known["k"])
    known["dgamma"] = scale * 10.0 ** draw.rng.uniform(-10, 2, points)
    load, inverse = getattr(module, f"_{quantity}"), getattr(module, f"_radius_from_{quantity}")
    with np.errstate(all="ignore"):
        a_c = module._pull_off_radius(*arguments(module._pull_off_radius, known, 0), control=quantity)
        far, beside = 10.0 ** draw.rng.uniform(-13, 4, points), 10.0 ** draw.rng.uniform(-2, 0.5, points)
        a = np.where(draw.rng.random(points) < 0.6, a_c * (1.0 + far), a_c * (1.0 + beside))
        value = load(np.where(draw.rng.random(points) < 0.3, np.maximum(radius, a_c), a), *arguments(load, known))
        use = np.isfinite(value) & (np.abs(value) > 1e-250) & (np.abs(value) < 1e250)
        assert use.sum() > points // 3
        known, value = {key: number[use] for key, number in known.items()}, value[use]
        calls[0] = 0
        found = inverse(value, *arguments(inverse, known))
        below, here, above = (load(found * (1.0 + i * EPS), *arguments(load, known)) for i in (-1, 0, 1))
        plain = load(found, *arguments(load, known | {"dgamma": 0.0 * value}))
    assert calls[0] <= STEPS + MORE[group]
    unit = np.fmax(np.abs(above - here), np.abs(here - below))
    missed = np.abs(here - value) / (EPS * (np.abs(value) + 2.0 * np.abs(plain)) + unit)
    # a load between two branches has no stable radius where the upper branch ends below it
    assert np.isnan(found).mean() < 0.1
    assert np.nanmax(missed) <= MISSED


@pytest.mark.parametrize("quantity", ["depth", "force"])
@pytest.mark.parametrize("name", GRADED)
def test_adhesive_contact(name: str, quantity: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if name in SLOW and quantity == "force":
        pytest.skip("as its depth, and each load is an integral")
    check(import_module(f"axicontact.adhesive.{name}"), "adhesive", name, quantity, evaluations(monkeypatch))


@pytest.mark.parametrize("quantity", ["depth", "force"])
@pytest.mark.parametrize("name", [name for name in GRADED if name not in SLOW])
def test_graded_adhesive_contact(name: str, quantity: str, monkeypatch: pytest.MonkeyPatch) -> None:
    module = import_module(f"axicontact.graded.adhesive.{name}")
    check(module, "graded.adhesive", name, quantity, evaluations(monkeypatch))
