"""Arrays of any shape: a value for every element, the same as that of the element alone, in every physics."""

from __future__ import annotations

import ast
import doctest
from collections.abc import Callable, Iterator
from importlib import import_module
from inspect import getmembers, isfunction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from axicontact import _rules
from axicontact.normal import hyperboloid, rounded_punch

MODULES = (
    "normal.cone", "normal.sphere", "normal.rounded_punch", "normal.flat_punch", "adhesive.cone", "adhesive.flat_punch",
    "adhesive.rounded_punch", "tangential.cone", "tangential.rounded_punch", "viscoelastic.cone", "plane.rounded_punch",
    "plane.flat_punch", "loads.hertzian", "loads.uniform", "graded.normal.cone", "graded.normal.flat_punch",
    "graded.adhesive.cone", "graded.tangential.cone",
)  # fmt: skip
ROUNDED, ABSOLUTE = 4e-15, 1e-16
"""Measured 1.1e-15, and 1.4e-17 next to a zero of a pressure: blocks have exponentials of their own."""
Call = tuple[list[float], dict[str, Any]]


def example(function: Callable[..., Any]) -> Call:
    """The call of the example in a docstring."""
    for shown in doctest.DocTestParser().get_examples(function.__doc__ or ""):
        for node in ast.walk(ast.parse(shown.source)):
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == function.__name__:
                return (
                    [ast.literal_eval(x) for x in node.args],
                    {x.arg: ast.literal_eval(x.value) for x in node.keywords if x.arg},
                )
    raise LookupError(function.__name__)


def public(name: str, at_a_point: bool = True) -> Iterator[tuple[Callable[..., Any], Call]]:
    """The public functions of a module with their examples; with fields alone, if not told otherwise."""
    module = import_module(f"axicontact.{name}")
    for key, function in getmembers(module, isfunction):
        if function.__module__ == module.__name__ and not key.startswith("_"):
            own = example(function)
            if own[0] or not at_a_point:
                yield function, own


def varied(value: float, shape: tuple[int, ...]) -> Any:
    return value * (1 + np.arange(np.prod(shape)).reshape(shape) / 64)


@pytest.mark.parametrize("name", MODULES)
def test_results_have_the_shape_of_the_fields(name: str) -> None:
    for function, (fields, keywords) in public(name):
        assert np.shape(function(*map(np.array, fields), **keywords)) == ()
        assert function(*[[x, x] for x in fields], **keywords).shape == (2,)
        for shape in ((0,), (3,), (2, 0), (1, 1, 2)):
            assert function(*[varied(x, shape) for x in fields], **keywords).shape == shape
        sides = [varied(x, (2, 1) if i % 2 == 0 else (3,)) for i, x in enumerate(fields)]
        whole = np.broadcast_arrays(*sides, np.empty((2, 3) if len(fields) > 1 else (2, 1)))[:-1]
        many = function(*sides, **keywords)
        alone = [function(*map(float, points), **keywords) for points in zip(*(x.flat for x in whole), strict=True)]
        assert many.shape == whole[0].shape
        assert many.ravel() == pytest.approx(alone, rel=ROUNDED, abs=ABSOLUTE, nan_ok=True), function
        turned = function(*[np.asfortranarray(x) for x in whole], **keywords)
        assert turned == pytest.approx(many, rel=ROUNDED, abs=ABSOLUTE, nan_ok=True), function


@pytest.mark.parametrize(
    "package",
    ["normal", "adhesive", "tangential", "viscoelastic", "plane", "loads"]
    + [pytest.param(f"graded.{name}", marks=pytest.mark.slow) for name in ("normal", "adhesive", "tangential")],
)
def test_results_have_the_shape_to_which_all_arguments_broadcast(package: str) -> None:
    """Each argument of every function along an axis of its own, also one on which the value does not depend."""
    tried = 0
    for path in sorted(Path(_rules.__file__).parent.joinpath(*package.split(".")).glob("[!_]*.py")):
        for function, (fields, keywords) in public(f"{package}.{path.stem}", at_a_point=False):
            own = {**dict(enumerate(fields)), **keywords}
            several = [key for key, value in own.items() if isinstance(value, float)]
            axes = {key: [2 if key == other else 1 for other in several] for key in several}
            given = {key: np.full(axes[key], value) if key in axes else value for key, value in own.items()}
            found = function(*[given.pop(i) for i in range(len(fields))], **given)
            for part in found if isinstance(found, tuple) else (found,):
                assert part.shape == (2,) * len(several), (path.stem, function.__name__)
            tried += 1
    assert tried > 3


def test_an_integral_in_groups_takes_a_grid_of_radii() -> None:
    """What no public function asks for: they hand their blocks over in one dimension."""
    slope, count = hyperboloid._slope, 40
    r, b = np.geomspace(1e-6, 0.99, count * count).reshape(count, count), np.geomspace(1e-8, 1.0, count)
    own = (0.42 * np.ones((count, 1)), b)
    found = _rules.pressure_integral_sinh(slope, own, r, np.ones_like(r), b)
    flat = [np.broadcast_to(x, r.shape).ravel() for x in (*own, r, np.ones_like(r), b)]
    assert found.shape == r.shape
    assert (found.ravel() == _rules.pressure_integral_sinh(slope, tuple(flat[:2]), *flat[2:])).all()
    grid = rounded_punch.displacement(1.2 + r, 1.1, R=1.45, b=0.5)
    assert (grid.ravel() == rounded_punch.displacement(1.2 + r.ravel(), 1.1, R=1.45, b=0.5)).all()
