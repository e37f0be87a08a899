"""Arguments that are more than numbers: a unit or a mask is never dropped in silence, what has neither goes on working.

Stand-ins have the attributes of the libraries, pint's `units` and `magnitude` and astropy's `unit` and `to_value`.
"""

from __future__ import annotations

import inspect
import itertools
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import axicontact
from axicontact.adhesive import paraboloid
from axicontact.graded.normal import cone as graded_cone
from axicontact.materials import effective_modulus
from axicontact.normal import cone, gaussian, polynomial

ROOT = Path(axicontact.__file__).parent
PUBLIC = [
    ".".join(path.relative_to(ROOT.parent).with_suffix("").parts)
    for path in sorted(ROOT.rglob("*.py"))
    if path.name != "expressions.py" and not any(part.startswith("_") for part in path.relative_to(ROOT).parts)
]


class Pint:
    """What NumPy sees of a quantity of pint."""

    def __init__(self, magnitude: Any, units: str = "millimeter") -> None:
        self.magnitude, self.units = magnitude, units

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(self.magnitude, dtype=dtype)

    def __float__(self) -> float:
        return float(self.magnitude)

    def __repr__(self) -> str:
        return f"<Quantity({self.magnitude}, '{self.units}')>"


class Astropy(np.ndarray):
    """A subclass of arrays, as the quantities of astropy and unyt are."""

    unit = "mm"

    def to_value(self, unit: str) -> Any:
        return np.asarray(self)


class Bare:
    """An array of another library, such as a column of a table."""

    def __init__(self, data: Any) -> None:
        self.data = data

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(self.data, dtype=dtype)


KNOWN = {"n": 2.0, "R": 3.0, "R1": 3.0, "R2": 2.0, "a": 1.0, "wavelength": 9.0, "e": 0.1, "C_13": 0.1}
"""Numbers that obey the rules between parameters; all others are 0.3."""
AROUND = {"c": 1.2}
"""A zone of attraction surrounds the contact, where one of stick is within."""


def functions() -> Iterator[tuple[str, Any]]:
    for name in PUBLIC:
        module = import_module(name)
        for own, function in vars(module).items():
            if callable(function) and getattr(function, "__module__", "") == name and not own.startswith("_"):
                yield f"{name}.{own}", function


def values(function: Any) -> tuple[dict[str, Any], list[str]]:
    """Some number for each argument, and the names of those that are numbers."""
    parameters = inspect.signature(function).parameters.values()
    numbers = [p.name for p in parameters if p.default is inspect.Parameter.empty]
    known = KNOWN | AROUND if "sigma_0" in numbers else KNOWN
    return {name: known.get(name, 0.3) for name in numbers}, numbers


def called(function: Any, given: dict[str, Any]) -> Any:
    fields = [
        given[p.name]
        for p in inspect.signature(function).parameters.values()
        if p.kind is inspect.Parameter.POSITIONAL_OR_KEYWORD and p.name in given
    ]
    keywords = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
    return function(*fields, **{name: given[name] for name in keywords if name in given})


@pytest.mark.parametrize("first", [0, *(pytest.param(first, marks=pytest.mark.slow) for first in (1, 2))])
def test_every_argument_of_every_function_refuses_a_unit_and_names_itself(first: int) -> None:
    """All are decorated alike; a third of them, of every module, in every run."""
    count = 0
    for key, function in itertools.islice(functions(), first, None, 3):
        given, names = values(function)
        for name in names:
            with pytest.raises(TypeError, match=rf"^{name} = .* carries a unit"):
                called(function, given | {name: Pint(0.3)})
            count += 1
        assert names or key.endswith("pull_off"), key
    assert count > 1600


def test_the_message_says_what_to_give() -> None:
    with pytest.raises(TypeError, match=r"a = <Quantity\(1.0, 'millimeter'\)> .* in m, a\.to\(\"m\"\)\.magnitude"):
        cone.force(Pint(1.0), theta=0.1, E_star=1.0)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"in Pa, E_star\.to_value\(\"Pa\"\)"):
        cone.force(1.0, theta=0.1, E_star=np.array(1.0).view(Astropy))
    with pytest.raises(TypeError, match=r"give its number alone, nu_1\.to\(\"\"\)\.magnitude"):
        effective_modulus(1.0, Pint(0.3), 1.0, 0.3)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match=r"give its number in Pa m\^\(-k\)$"):
        graded_cone.force(1.0, theta=0.1, H=Pint(1.0), k=0.2)  # type: ignore[arg-type]
    with pytest.raises(TypeError, match="^s = .* carries a unit.* in SI units$"):
        gaussian.depth(1.0, h=1.0, s=Pint(1.0))  # type: ignore[arg-type]


@pytest.mark.parametrize("wrap", [lambda q: [q, 1.0], lambda q: (1.0, q), lambda q: [[1.0], [q]], np.array])
def test_a_unit_inside_a_sequence_is_found(wrap: Any) -> None:
    with pytest.raises(TypeError, match="^r "):
        cone.pressure(wrap(Pint(0.1)) if wrap is not np.array else [Pint(0.1)], 1.0, theta=0.1, E_star=1.0)
    with pytest.raises(TypeError, match="^A = .* carries a unit"):
        polynomial.depth(1.0, A=(0.0, Pint(0.1)))  # type: ignore[arg-type]


@pytest.mark.parametrize("masked", [np.ma.masked_invalid([0.1, np.nan]), np.ma.array([0.1, 0.2]), np.ma.masked])
def test_masked_arrays_are_refused(masked: Any) -> None:
    """Also without a masked member: whoever has a mask means it to be kept."""
    with pytest.raises(TypeError, match=r"^r = .* carries a mask.* r\.filled\(np\.nan\)"):
        cone.pressure(masked, 1.0, theta=0.1, E_star=1.0)
    with pytest.raises(TypeError, match=r"^E_star = .* carries a mask"):
        cone.pressure(0.1, 1.0, theta=0.1, E_star=masked)


@pytest.mark.parametrize(
    "bare",
    [
        [0.1, 0.2], (0.1, 0.2), range(1, 3), np.array([0.1, 0.2]), np.array(0.1), np.float32(0.1), np.int64(1), 1,
        Bare([0.1, 0.2]), np.array([0.1, 0.2]).view(np.matrix), [np.float64(0.1), np.array(0.2)], [[1, 2], [3, 4]],
    ],
)  # fmt: skip
def test_what_has_no_unit_goes_on_working(bare: Any) -> None:
    wanted = cone.force(np.asarray(bare, dtype=float), theta=0.1, E_star=1.0)
    np.testing.assert_array_equal(cone.force(bare, theta=0.1, E_star=1.0), wanted)
    wanted = paraboloid.force(1.0, R=np.asarray(bare, dtype=float), E_star=1.0, dgamma=0.1)
    np.testing.assert_array_equal(paraboloid.force(1.0, R=bare, E_star=1.0, dgamma=0.1), wanted)


def test_a_remark_that_names_the_right_unit_is_none() -> None:
    """An array of xarray has its attributes as its own: `units="m"` agrees with what is wanted, "mm" does not."""
    column = Bare([0.1, 0.2])
    column.units = "m"  # type: ignore[attr-defined]
    np.testing.assert_array_equal(
        cone.force(column, theta=0.1, E_star=1.0),  # type: ignore[arg-type]
        cone.force([0.1, 0.2], theta=0.1, E_star=1.0),
    )
    column.units = "mm"  # type: ignore[attr-defined]
    with pytest.raises(TypeError, match="^a = .* carries a unit"):
        cone.force(column, theta=0.1, E_star=1.0)  # type: ignore[arg-type]


def test_pint_itself() -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    for length in (1.0 * unit.mm, np.array([1.0, 2.0]) * unit.mm, 1.0 * unit.dimensionless):
        with pytest.raises(TypeError, match=r"^a = .* a\.to\(\"m\"\)\.magnitude"):
            cone.force(length, theta=0.1, E_star=1.0)
        with pytest.raises(TypeError, match=r"^E_star = .* E_star\.to\(\"Pa\"\)\.magnitude"):
            cone.force(1.0, theta=0.1, E_star=length)
    given = (1.0 * unit.mm).to("m").magnitude
    assert cone.force(given, theta=0.1, E_star=1.0) == cone.force(1e-3, theta=0.1, E_star=1.0)
