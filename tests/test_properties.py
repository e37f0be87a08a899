"""What holds for every physics whatever the numbers: units, round trips, growth, and that nothing in contact pulls."""

from __future__ import annotations

import inspect
import re
import warnings
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from test_shapes import by_name, example, modules, public

EPS = np.finfo(float).eps
ROUND_TRIP = 32 * EPS
LENGTH = 2.0**12
"""A unit of length whose square, cube and fourth roots are powers of two too: examples are graded with k = 1/4."""
Unit = tuple[float, float, float]
UNITS: dict[str, Unit] = {
    "m": (1, 0, 0), "Pa": (0, 1, 0), "N": (2, 1, 0), "N/m": (1, 1, 0), "rad": (0, 0, 0), "1": (0, 0, 0),
    "s": (0, 0, 1), "m/s": (1, 0, -1), "Pa s": (0, 1, 1),
}  # fmt: skip
"""Powers of a length, a modulus and a time."""
DEGREE = {"quartic": 4.0, "sextic": 6.0}
ROUNDED = 4 * EPS
"""Of inverses, by iterations in the logarithm of a length or by roots; 1.0 EPS measured."""
ROUNDED_POWER = 64 * EPS
"""Of inverses by a power 1/(1 + n + k), whose rounding counts as often as the load's logarithm; 16 EPS measured."""
Units = tuple[dict[str, Unit], Unit]
PLANE = ("wedge", "parabola", "rounded_wedge", "rounded_punch", "truncated_wedge")


def units(function: Callable[..., Any], n: float, k: float) -> Units | None:
    """Those of the arguments by name and of the result, by the docstring; None where one is no such power."""
    of = UNITS | {"m^(1-n)": (1 - n, 0, 0), "Pa m^(-k)": (-k, 1, 0)}
    text = inspect.getdoc(function) or ""
    before, _, after = text.partition("Returns\n")
    found = re.findall(r"^(\w+) : array_like(?:, optional)?\n((?: {4}.*\n)+)", before, re.MULTILINE)
    known = {name: re.search(r"\[([^\]]*)\][.,]", " ".join(meaning.split())) for name, meaning in found}
    name = getattr(function, "result", None)
    result = re.search(
        rf"{name} \[([^\]]*)\]" if name else r"\[([^\]]*)\]\.", " ".join(after.split("Raises")[0].split())
    )
    read = {name: of.get(unit[1]) for name, unit in known.items() if unit}
    if result is None or None in read.values() or len(read) != len(known) or result[1] not in of:
        return None
    return {name: unit for name, unit in read.items() if unit}, of[result[1]]


@cache
def scalable(package: str) -> tuple[tuple[str, Callable[..., Any], dict[str, float], float, Units], ...]:
    """The functions of numbers with units that are powers of a length, a modulus and a time, and their examples."""
    found = []
    for name in modules(package):
        for function, call in public(name, at_a_point=False):
            given = by_name(function, call)
            # of a graded adhesive contact an inverse takes as long as a hundred of the others
            wanted = not re.match("radius|pull" if package == "graded.adhesive" else "pull", function.__name__)
            if wanted and all(isinstance(value, float) for value in given.values()):
                degree = given.get("n", DEGREE.get(name.rpartition(".")[2], 1.0))
                known = units(function, degree, given.get("k", 0.0))
                if known is not None:
                    found.append((name, function, given, function(**given), known))
    return tuple(found)


@pytest.mark.parametrize(
    "package",
    ["normal", "adhesive", "tangential", "plane", "loads", "viscoelastic", "materials"]
    + ["graded.normal", "graded.adhesive", "graded.tangential"],
)
@given(length=st.sampled_from((-1, 1)), modulus=st.integers(3, 30), time=st.integers(3, 30))
@settings(max_examples=1)
def test_powers_of_two_change_no_digit(package: str, length: int, modulus: int, time: int) -> None:
    """Lengths in units of LENGTH**length, moduli of 2**modulus, times of 2**time; without a warning.

    A wrong power of one of them is a wrong power of two.  A power a**k, a**n or t**alpha may round anew.
    """

    def scale(unit: Unit) -> float:
        return LENGTH ** (length * unit[0]) * 2.0 ** (modulus * unit[1]) * 2.0 ** (time * unit[2])

    assert len(scalable(package)) > 3
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, function, numbers, value, (known, own) in scalable(package):
            found = function(**{key: x * scale(known[key]) for key, x in numbers.items()})
            powers = not {"k", "n", "A", "alpha"}.isdisjoint(numbers)
            inverse = re.search("_from_|_radius", function.__name__)
            rounded = (ROUNDED_POWER if powers else ROUNDED) if inverse else ROUNDED if powers else 0.0
            assert found == pytest.approx(value * scale(own), rel=rounded, abs=0.0), (name, function.__name__)


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


@pytest.mark.parametrize("package", ["normal", "adhesive", "graded.normal", "graded.adhesive"])
def test_a_term_of_zero_adds_nothing_on_the_axis(package: str) -> None:
    """Where the pressure of the cone is infinite, of which a coefficient of zero is no part: NaN is zero times it."""
    parabola, polynomial = (import_module(f"axicontact.{package}.{name}") for name in ("paraboloid", "polynomial"))
    known = keywords_of(polynomial.pressure) | ({"k": -0.4} if "graded" in package else {})
    others = {name: value for name, value in known.items() if name != "A"}
    alone = parabola.pressure([0.0, 0.3], 1.1, **others, R=2.0)
    assert np.all(np.isfinite(alone))
    assert polynomial.pressure([0.0, 0.3], 1.1, **others, A=(0.0, 0.25, 0.0)) == pytest.approx(
        alone, rel=1e-14, abs=0.0
    )
    assert polynomial.pressure(0.0, 1.1, **others, A=(1e-3, 0.25)) == np.inf


@pytest.mark.parametrize("n", [1.5, 2.5, 3.0])
def test_the_edge_of_a_concave_face_is_infinite(n: float) -> None:
    """At the edge itself as next to it, and without a warning: the part of the face has no path left there."""
    for package, load in (("normal", 0.6), ("plane", 1.5)):
        pressure = import_module(f"axicontact.{package}.concave_power").pressure
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            found = pressure([1.0 - 2.0**-52, 1.0, 1.5], load, a=1.0, h=0.15, n=n, E_star=1.0)
        assert found[0] > 1e6
        assert found[1:].tolist() == [np.inf, 0.0]
