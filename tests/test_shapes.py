"""Arrays of any shape: a value for every element, the same as that of the element alone, in every physics."""

from __future__ import annotations

import ast
import doctest
import re
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from inspect import getmembers, isfunction, signature
from math import ceil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from selected import each_result

import axicontact
from axicontact._runtime import rules
from axicontact.normal import hyperboloid, rounded_punch

MODULES = (
    "normal.cone", "normal.sphere", "normal.rounded_punch", "normal.flat_punch", "adhesive.cone", "adhesive.flat_punch",
    "adhesive.rounded_punch", "tangential.cone", "tangential.rounded_punch", "viscoelastic.cone", "plane.rounded_punch",
    "plane.flat_punch", "loads.hertzian", "loads.uniform", "graded.normal.cone", "graded.normal.flat_punch",
    "graded.adhesive.cone", "graded.tangential.cone",
)  # fmt: skip
ROUNDED, ABSOLUTE = 4e-15, 1e-16
"""Measured 1.1e-15, and 1.4e-17 next to a zero of a pressure: blocks have exponentials of their own."""
SOLVED = 4e-14
"""Of inverses too, and where the terms of a force cancel: 1.0e-14 measured."""
Call = tuple[list[float], dict[str, Any]]


@cache
def example(function: Callable[..., Any]) -> Call:
    """The call of the example in a docstring, read once: properties ask for it at every number they draw."""
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
                yield from ((one, own) for one in each_result(function))


def modules(package: str) -> Iterator[str]:
    """Those of a package, or the one of this name."""
    folder = Path(axicontact.__file__).parent.joinpath(*package.split("."))
    yield from [f"{package}.{path.stem}" for path in sorted(folder.glob("[!_]*.py"))] or [package]


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
    ["normal", "adhesive", "tangential", "plane", "loads", "graded.normal", "graded.adhesive", "graded.tangential"],
)
def test_fields_vanish_infinitely_far_away(package: str) -> None:
    """Next to other radii too, and for several contacts at once; the body itself goes on."""
    seen = set()
    for name in modules(package):
        for function, (fields, keywords) in public(name):
            if next(iter(signature(function).parameters)) not in ("r", "x"):
                continue
            far = np.inf
            assert (function(far, *fields[1:], **keywords) == 0.0) is ("profile" not in function.__name__), function
            if "profile" in function.__name__:
                continue
            seen.add(function.__name__)
            mixed = function([fields[0], far], *fields[1:], **keywords)
            assert mixed[0] == pytest.approx(function(*fields, **keywords), rel=ROUNDED, abs=ABSOLUTE)
            assert mixed[1] == 0.0
            assert np.all(function(far, *[[x, x] for x in fields[1:]], **keywords) == 0.0), function
    assert seen & {"pressure", "displacement", "traction"}


def frozen(values: Any) -> np.ndarray[Any, Any]:
    """An array that raises an error where a function writes to its argument."""
    array = np.array(values)
    array.flags.writeable = False
    return array


def by_name(function: Callable[..., Any], call: Call) -> dict[str, Any]:
    """All arguments of an example, the fields among them."""
    return dict(zip(signature(function).parameters, call[0], strict=False)) | call[1]


def results(found: Any) -> tuple[Any, ...]:
    return found if isinstance(found, tuple) else (found,)


@pytest.mark.parametrize(
    ("package", "every"),
    [(package, 1) for package in ("normal", "tangential", "plane", "loads", "materials")]
    + [("adhesive", 3), ("viscoelastic", 5)]
    + [
        pytest.param(package, 1, marks=pytest.mark.slow)
        for package in ("adhesive", "viscoelastic", "graded.normal", "graded.adhesive", "graded.tangential")
    ],
)
def test_results_have_the_shape_to_which_all_arguments_broadcast(package: str, every: int) -> None:
    """Each argument of every function along an axis of its own, also one on which the value does not depend."""
    tried = 0
    for name in list(modules(package))[::every]:
        for function, call in public(name, at_a_point=False):
            own = by_name(function, call)
            several = [key for key, value in own.items() if isinstance(value, float)]
            # at the far corner every other argument is a little smaller
            sizes = {key: (own[key], own[key] * (1.0 - (2.0**-10 if i % 2 else 0.0))) for i, key in enumerate(several)}
            axes = {key: [2 if key == other else 1 for other in several] for key in several}
            given = {key: frozen(np.reshape(sizes[key], axes[key])) for key in several}
            found = results(function(**own | given))
            for corner in (0, -1):
                alone = results(function(**own | {key: sizes[key][corner] for key in several}))
                for part, single in zip(found, alone, strict=True):
                    assert part.shape == (2,) * len(several), (name, function.__name__)
                    near = pytest.approx(single, rel=SOLVED, abs=ABSOLUTE, nan_ok=True)
                    assert part.ravel()[corner] == near, (name, function.__name__)
            tried += 1
    assert tried > 3


WHOLE = {"k": 0.0, "alpha": 0.25, "nu": 0.0, "nu_1": 0.0, "nu_2": 0.0, "e": 0.0, "wavelength": 9.0}
"""Where the next whole number is none of the domain."""


@pytest.mark.parametrize(
    "package",
    ["normal", "adhesive", "tangential", "viscoelastic", "plane", "loads", "materials"]
    + [f"graded.{name}" for name in ("normal", "adhesive", "tangential")],
)
def test_arguments_are_only_read(package: str) -> None:
    """Arrays that may not be written to; of bytes without a sign too, whose differences would wrap around."""
    for name in modules(package):
        for function, call in public(name, at_a_point=False):
            if package == "graded.adhesive" and re.match("radius_from|pull_off", function.__name__):
                continue  # of loads that the others give; they take nine tenths of the time
            own = by_name(function, call)
            numbers = {key: WHOLE.get(key, ceil(x)) for key, x in own.items() if isinstance(x, float)}
            floats = {key: frozen([float(x)] * 3) for key, x in numbers.items()}
            bytes_ = {key: x.astype(np.uint8) if x[0].is_integer() and x[0] > 0.0 else x for key, x in floats.items()}
            found, again = function(**own | floats), function(**own | bytes_)
            np.testing.assert_array_equal(found, again, err_msg=f"{name}.{function.__name__}")


def test_an_integral_in_groups_takes_a_grid_of_radii() -> None:
    """What no public function asks for: they hand their blocks over in one dimension."""
    slope, count = hyperboloid._slope, 40
    r, b = np.geomspace(1e-6, 0.99, count * count).reshape(count, count), np.geomspace(1e-8, 1.0, count)
    own = (0.42 * np.ones((count, 1)), b)
    found = rules.pressure_integral_sinh(slope, own, r, np.ones_like(r), b)
    flat = [np.broadcast_to(x, r.shape).ravel() for x in (*own, r, np.ones_like(r), b)]
    assert found.shape == r.shape
    assert (found.ravel() == rules.pressure_integral_sinh(slope, tuple(flat[:2]), *flat[2:])).all()
    grid = rounded_punch.displacement(1.2 + r, 1.1, R=1.45, b=0.5)
    assert (grid.ravel() == rounded_punch.displacement(1.2 + r.ravel(), 1.1, R=1.45, b=0.5)).all()


FACED = ("truncated_cone", "truncated_paraboloid", "rounded_punch")
AGREED = {"normal": 6.0, "graded.normal": 7.0}
"""Units of the last place: 5 and 7 were the most, as numbers take the functions of `math`, and 3 of 1800 graded values
were beyond 4; 9 and 13 before the sums of arrays went by neighbours."""
CONDITIONED = 4.0
"""Units by which a field that moves by one unit moves the value count so often: an energy, of squares of a small rest
of the depth, has five, and 18 units between numbers and arrays; next to a zero they are many."""


def drawn(name: str, own: dict[str, Any], fields: list[str], count: int, rng: np.random.Generator) -> dict[str, Any]:
    """Fields over decades, one contact in three next to its end or its break, one radius in two next to the edge."""
    found = own | {key: own[key] * 10.0 ** rng.uniform(-3.0, 1.0, count) for key in fields}
    beside = 10.0 ** rng.uniform(-9.0, 0.0, count)
    if "a" in fields and (ends := {"b", "R"} & set(own)):
        end = own["b" if "b" in ends else "R"] * np.ones(count)
        sign = -1.0 if name.endswith(("sphere", "ellipsoid")) else rng.choice([-1.0, 1.0], count)
        found["a"] = np.where(rng.random(count) < 1 / 3, end * (1.0 + sign * beside), found["a"])
    if "r" in fields and "a" in found:
        edge = found["a"] * (1.0 + rng.choice([-1.0, 1.0], count) * beside)
        found["r"] = np.where(rng.random(count) < 0.5, edge, found["r"])
    return found


@pytest.mark.parametrize("package", AGREED)
def test_arrays_and_their_elements_agree(package: str) -> None:
    """To the last places, away from zeros: both sum one rule, of which an order of terms is 8 units."""
    rng, tried = np.random.default_rng(7), 0
    for name in modules(package):
        for function, call in public(name):
            own = by_name(function, call)
            fields = list(own)[: len(call[0])]
            given = drawn(name, own, fields, 8, rng)
            if "a" in fields and name.endswith(FACED):
                given["a"] = np.maximum(given["a"], own["b"])
            for i, value in enumerate(function(**given)):
                point = given | {key: float(given[key][i]) for key in fields}
                alone = function(**point)
                tried += bool(0.0 < abs(alone) < np.inf)
                if alone == value or np.isnan(alone) and np.isnan(value):
                    continue
                apart = abs(value - alone) / np.spacing(abs(alone))
                if apart > AGREED[package]:
                    moved = [function(**point | {key: point[key] * (1.0 - 2.0**-26)}) for key in fields]
                    changes = [abs(other - alone) * 2.0**26 / abs(alone) for other in moved]
                    assert apart < CONDITIONED * max(changes), (name, function.__name__, point, alone, value)
    assert tried > 1200
