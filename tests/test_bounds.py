"""Bounds on the exponents of a formula: no value leaves them, and a wrong rule shows."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import pytest

from axiderive.code.programs import bounds as ranges
from axiderive.code.programs.bounds import Bound, bounds
from axiderive.code.programs.graph import Node, needed, trace

EPS = np.finfo(float).eps
CASES: list[tuple[Callable[..., Any], tuple[str, ...]]] = [
    (lambda x, y: x + y, ("x", "y")),
    (lambda x, y: x - y, ("x", "y")),
    (lambda x, y: (x - y) * (x + y) / y, ("x", "y")),
    (lambda x, y: np.sqrt(np.abs(x * x - y * y)) - x, ("x", "y")),
    (lambda x, y: np.arcsinh((x - y) / y) + np.arctan(x) - np.tanh(y), ("x", "y")),
    (lambda x, y: np.arctan2(x, y) * np.arctan2(x - y, x + y), ("x", "y")),
    (lambda x, y: np.log1p(x) * np.log(y), ("x", "y")),
    (
        lambda x, y: np.where(x < y, np.arctan(x), np.cbrt(y)) - np.minimum(x, y) ** 3 + np.maximum(x, y) ** 0.5,
        ("x", "y"),
    ),
    (lambda x, y: -np.square(x - y), ("x", "y")),
    (lambda small: np.tan(small) * np.sin(small) / np.cos(small / 2), ("small",)),
    (lambda small: np.expm1(-small) + np.sinh(small) - np.exp(small) * np.cosh(small - 1.0), ("small",)),
]
RANGES = {"x": (1e-30, 1e30), "y": (1e-30, 1e30), "small": (1e-30, math.pi / 2)}


def draws(count: int) -> dict[str, np.ndarray]:
    """Log-uniform, and close to one another."""
    dice = np.random.default_rng(7)
    x = 10 ** dice.uniform(-30, 30, count)
    y = np.where(
        dice.random(count) < 0.5, x * (1.0 + dice.integers(-3, 4, count) * EPS), 10 ** dice.uniform(-30, 30, count)
    )
    near_the_pole = np.nextafter(math.pi / 2, 0.0) - dice.integers(0, 3, count) * EPS
    small = np.where(dice.random(count) < 0.2, near_the_pole, 10 ** dice.uniform(-30, 0.19, count))
    return {"x": x, "y": y, "small": small}


def outside(nodes: list[Node], found: Mapping[Node, Bound | None], given: Mapping[str, np.ndarray]) -> list[str]:
    """The operations whose value is not where the bounds have it."""
    values: dict[Node, Any] = {}
    wrong = []
    with np.errstate(all="ignore"):
        for node in nodes:
            if node.operands:
                values[node] = getattr(np, node.name)(*(values[x] for x in node.operands))
            else:
                values[node] = given[node.value] if node.name == "argument" else node.value
            bound = found[node]
            if bound is None or node.logical:
                continue
            value = np.asarray(values[node], dtype=float)
            size = np.abs(value[value != 0.0] if value.ndim else value)
            good = np.all((np.ldexp(1.0, bound.low) <= size) & (size <= np.ldexp(1.0, bound.high)))
            signs = np.all(np.sign(value) * bound.sign >= 0.0) and (bound.zero or np.all(value != 0.0))
            if not (good and signs):
                wrong.append(node.name)
    return wrong


def results() -> list[Node]:
    found = [trace(function, names, ()) for function, names in CASES]
    assert None not in found
    return found  # type: ignore[return-value]


def test_no_value_leaves_its_bounds() -> None:
    reached = set()
    for result in results():
        nodes = needed(result)
        found = bounds(nodes, RANGES)
        assert outside(nodes, found, draws(20_000)) == []
        reached |= {node.name for node in nodes if found[node] is not None}
    assert reached >= set(ranges.RULES) - {"unless"} | {"power"}


@pytest.mark.parametrize(
    ("name", "rule"),
    [
        ("subtract", lambda x, y: Bound(min(x.low, y.low) - 40, max(x.high, y.high) + 1, 0, True)),
        ("subtract", lambda x, y: ranges._add(x, y)),
        ("add", lambda x, y: ranges._add(x, y)._replace(high=max(x.high, y.high))),
        ("multiply", lambda x, y: ranges._multiply(x, y)._replace(zero=False)),
        ("divide", lambda x, y: Bound(x.low - y.low, x.high - y.high, x.sign * y.sign, x.zero)),
        ("tan", lambda x: Bound(x.low, x.high + 1)),
        ("arcsinh", lambda x: Bound(x.low, min(x.high, 4), x.sign, x.zero)),
        ("where", lambda x, y: x),
    ],
)
def test_a_wrong_rule_is_noticed(name: str, rule: Callable[..., Bound], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(ranges.RULES, name, rule)
    assert any(outside(nodes := needed(r), bounds(nodes, RANGES), draws(20_000)) for r in results())


def test_an_argument_of_either_sign_has_no_bound() -> None:
    """It may come next to zero: from the ends of its range alone it would be large."""
    result = trace(lambda load: -load, ("load",), ())
    assert result is not None
    (load,) = (node for node in needed(result) if node.name == "argument")
    assert bounds([load], {"load": (-1e30, 1e30)}) == {load: None}
    assert bounds([load], {"load": (1e-30, 1e30)})[load] is not None
