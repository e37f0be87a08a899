"""What holds for every physics whatever the numbers: units, round trips, growth, and that nothing in contact pulls."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from inspect import signature
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_shapes import example, public

from axicontact import _rules

EPS = np.finfo(float).eps
ROUND_TRIP = 32 * EPS
UNITS = {"m": (1, 0), "Pa": (0, 1), "N": (2, 1), "N/m": (1, 1), "rad": (0, 0), "1": (0, 0), "s": (0, 0)}
"""Powers of a length and of a modulus."""
ROUNDED = 4 * EPS
"""Of inverses, by iterations in the logarithm of a length or by roots; 1.0 EPS measured."""
Units = tuple[dict[str, tuple[int, int]], tuple[int, int]]
PLANE = ("wedge", "parabola", "rounded_wedge", "rounded_punch", "truncated_wedge")


def modules(package: str) -> Iterator[str]:
    folder = Path(_rules.__file__).parent.joinpath(*package.split("."))
    yield from (f"{package}.{path.stem}" for path in sorted(folder.glob("[!_]*.py")))


def units(function: Callable[..., Any]) -> Units | None:
    """Those of the arguments by name and of the result, by the docstring; None where one is no such power."""
    text = function.__doc__ or ""
    before, _, after = text.partition("Returns\n")
    found = re.findall(r"^ +(\w+) : array_like\n((?: {8}.*\n)+)", before, re.MULTILINE)
    known = {name: re.search(r"\[([^\]]*)\][.,]", " ".join(meaning.split())) for name, meaning in found}
    result = re.search(r"\[([^\]]*)\]\.", " ".join(after.split("Raises")[0].split()))
    read = {name: UNITS.get(unit[1]) for name, unit in known.items() if unit}
    if result is None or None in read.values() or len(read) != len(known) or result[1] not in UNITS:
        return None
    return {name: unit for name, unit in read.items() if unit}, UNITS[result[1]]


@cache
def scalable(package: str) -> tuple[tuple[str, Callable[..., Any], list[float], dict[str, float], Units], ...]:
    """The functions of numbers with units that are whole powers of a length and a modulus, and their examples."""
    found = []
    for name in modules(package):
        for function, (fields, keywords) in public(name, at_a_point=False):
            known = units(function)
            numbers = all(isinstance(value, float) for value in (*fields, *keywords.values()))
            if known is not None and numbers and function.__name__ != "pull_off":
                found.append((name, function, fields, keywords, known))
    return tuple(found)


@pytest.mark.parametrize("package", ["normal", "adhesive", "tangential", "plane", "loads"])
@given(length=st.sampled_from((-3, -1, 2)), modulus=st.integers(3, 30))
@settings(max_examples=2)
def test_powers_of_two_change_no_digit(package: str, length: int, modulus: int) -> None:
    """Lengths in units of 64**length, also a square and a cube, moduli of 2**modulus; without a warning.

    A wrong power of either is a wrong power of two.
    """

    def scale(unit: tuple[int, int]) -> float:
        return 64.0 ** (length * unit[0]) * 2.0 ** (modulus * unit[1])

    assert len(scalable(package)) > 3
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, function, fields, keywords, (known, own) in scalable(package):
            given_fields = zip(signature(function).parameters, fields, strict=False)
            found = function(
                *(x * scale(known[key]) for key, x in given_fields),
                **{key: x * scale(known[key]) for key, x in keywords.items()},
            )
            wanted = function(*fields, **keywords) * scale(own)
            rounded = "_from_" in function.__name__ or function.__name__ == "stick_radius"
            assert found == pytest.approx(wanted, rel=ROUNDED if rounded else 0.0, abs=0.0), (name, function.__name__)


def keywords_of(function: Callable[..., Any]) -> dict[str, Any]:
    return example(function)[1]


@pytest.mark.parametrize("name", PLANE)
@given(x=st.floats(1e-3, 0.99), y=st.floats(0.0, 0.999))
@settings(max_examples=20)
def test_a_strip_contact_grows_and_does_not_pull(name: str, x: float, y: float) -> None:
    module = import_module(f"axicontact.plane.{name}")
    known = keywords_of(module.load)
    a = known.get("b", 1.0) * (1.0 + x)
    load = module.load(a, **known)
    assert module.load(a * 1.001, **known) > load
    assert module.half_width_from_load(load, **known) == pytest.approx(a, rel=ROUND_TRIP, abs=0.0)
    pressure = module.pressure(np.array([-y * a, y * a]), a, **known)
    assert pressure[0] == pressure[1] >= 0.0
    assert module.pressure(a * 1.001, a, **known) == 0.0


@pytest.mark.parametrize("name", ["cone", "paraboloid", "rounded_punch", "truncated_cone", "hyperboloid"])
@given(over=st.floats(1.01, 30.0))
@settings(max_examples=10)
def test_an_adhesive_contact_is_found_again(name: str, over: float) -> None:
    """On its stable branch, where depth and force grow with the radius."""
    module = import_module(f"axicontact.adhesive.{name}")
    known = keywords_of(module.force)
    for control, load in (("force", module.force), ("depth", module.depth)):
        a = over * module.pull_off(control, **known).radius
        value = load(a, **keywords_of(load))
        assert load(1.001 * a, **keywords_of(load)) > value
        found = getattr(module, f"radius_from_{control}")(value, **keywords_of(load))
        assert found == pytest.approx(a, rel=1e-12, abs=0.0)


@pytest.mark.parametrize("name", ["cone", "paraboloid", "sphere", "rounded_punch", "hyperboloid"])
@given(share=st.floats(1e-3, 0.999))
@settings(max_examples=10)
def test_slip_grows_from_the_edge(name: str, share: float) -> None:
    module = import_module(f"axicontact.tangential.{name}")
    known = keywords_of(module.tangential_force)
    a = known.get("b", 0.5) * (1.2 if name == "rounded_punch" else 1.0)
    low = known["b"] if name == "rounded_punch" else 0.0
    c = low + share * (a - low)
    force, step = module.tangential_force(a, c, **known), 1e-3 * (c - low)
    more = module.tangential_force(a, c - step, **known)
    assert 0.0 < force < more
    found = module.stick_radius(force, a, **known)
    # a unit in the last place of c changes a force from a narrow ring of slip by many of its own
    unit = EPS * c * (more - force) / step
    assert module.tangential_force(a, found, **known) == pytest.approx(force, rel=ROUND_TRIP, abs=2 * unit)
    traction = module.traction(np.linspace(0.0, 1.1 * a, 12), a, c, **keywords_of(module.traction))
    assert np.all(traction >= 0.0)
