"""Formulas for plain numbers: flat functions of `math`, and the bodies themselves where they iterate."""

from __future__ import annotations

import ast
import inspect
import math
from pathlib import Path
from typing import Any
from zlib import crc32

import numpy as np
import pytest
from private_bodies import EPS, MODULES, bodies, body
from written import needs_arrays, plain

import axicontact
from axicontact._programs.graded.normal import gaussian as bump
from axicontact._runtime.integrals import STRIPS
from axicontact._runtime.plain import PANELS, rule
from axicontact.normal import capped_cylinder, power_law, rounded_punch, truncated_cone
from axiderive.code.programs.plain import settled


def test_plain_functions_agree_with_the_bodies() -> None:
    count = 0
    for name in MODULES:
        for function in bodies(name):
            # of its own, so that a new function leaves the points of the others as they are
            dice = np.random.default_rng([5, crc32(f"{name}.{function.__name__}".encode())])
            arguments = function.__code__.co_argcount
            formula = plain(function)
            if formula is None:
                continue
            for _ in range(4):
                values = [float(10 ** dice.uniform(-1, 1)) for _ in range(arguments)]
                got = formula(*values)
                if got is not None:
                    np.testing.assert_allclose(got, body(function, *values), rtol=64 * EPS, err_msg=function.__name__)
                    count += 1
    assert count > 250


@pytest.mark.parametrize("module", [truncated_cone, rounded_punch])
def test_rules_are_loops_over_plain_numbers(module: Any) -> None:
    """Next to the edges too, where the rule has panels; farther out the body takes over."""
    dice, sizes = np.random.default_rng(6), dict(zip(("theta", "R", "b"), (0.4, 3.0, 1.0), strict=True))
    for function in (module._pressure, module._displacement):
        names = inspect.signature(function).parameters
        rest = [sizes.get(name, 1.0) for name in list(names)[2:]]
        formula = plain(function)
        assert formula is not None
        for _ in range(60):
            a = 1.0 + 10 ** dice.uniform(-12, 5)
            near = 10 ** dice.uniform(-12, -0.01)
            r = a * (1.0 - near) if function is module._pressure else a * (1.0 + near)
            got = formula(r, a, *rest)
            assert got is not None
            np.testing.assert_allclose(got, body(function, [r], a, *rest), rtol=16 * EPS)
    assert rule(STRIPS)(PANELS * STRIPS[-1][0] * 0.99)
    for length in (PANELS * STRIPS[-1][0] * 1.01, math.inf, math.nan):
        with pytest.raises((ArithmeticError, ValueError)):
            rule(STRIPS)(length)


def test_a_minimum_keeps_what_is_no_number() -> None:
    found = plain(least_or_nan)
    assert found is not None
    assert found(2.0, 3.0) == 2.0
    assert found(0.5, 3.0) is None


def test_what_no_contact_carries_is_said_without_the_arrays() -> None:
    """A load beyond the largest of a bump has no radius; next to the ends of the range the arrays have to say so."""
    assert bump.radius_from_depth(0.3, 0.7, 1.0, 0.3) is not None
    assert math.isnan(bump.radius_from_depth(1.3, 0.7, 1.0, 0.3))
    assert bump.radius_from_depth(1.3e13, 0.7, 1.0, 0.3) is None


def test_nothing_outside_the_contact_is_a_result() -> None:
    """Within, nothing would be what was rounded away, and the arrays have to say so."""
    space: dict[str, Any] = {"ordinary": lambda *lengths: True}
    lines = ["def kept(value, r, a):", *(f"    {line}" for line in settled(["r", "a"]))]
    exec("\n".join(lines), space)
    assert space["kept"](0.0, 2.0, 1.0) == 0.0
    assert space["kept"](0.0, 0.5, 1.0) is None
    assert math.isnan(space["kept"](math.nan, 0.5, 1.0))


def least_or_nan(x: Any, y: Any) -> Any:
    return np.minimum(np.where(x < 1.0, np.nan, x), y)


def test_results_are_trusted_where_the_bounds_allow_it() -> None:
    """A formula with any exponent is not; its result outside the range of trust is left to the slower way."""
    assert plain(capped_cylinder._stiffness)(1e-25, 1e25, 1e-25, 1e-29) == pytest.approx(2e-54, abs=0.0)  # type: ignore[misc]
    assert plain(power_law._profile)(1e-5, 1.0, 2.0) == pytest.approx(1e-10)  # type: ignore[misc]
    assert plain(power_law._profile)(1e-5, 1.0, 41.0) is None  # type: ignore[misc]
    assert plain(power_law._profile)(1e-5, 1.0, 70.0) is None  # type: ignore[misc]


def summed_by_python(x: Any) -> Any:
    found = []
    for n in (1.0, 2.0):
        found.append(np.sqrt(n * n) * x)  # noqa: PERF401
    return sum(found)


def summed_by_numpy(x: Any) -> Any:
    return np.sum(x)


def largest_of_an_array(x: Any) -> Any:
    return x.max()


def test_a_name_of_numpy_needs_arrays_only_where_it_is_numpys() -> None:
    """`sum` and `append` are names of Python too."""
    assert not needs_arrays(summed_by_python)
    assert needs_arrays(summed_by_numpy)
    assert needs_arrays(largest_of_an_array)


BODIES = Path(axicontact.__file__).parent / "_programs" / "bodies"


def test_bodies_over_plain_numbers_do_not_invert() -> None:
    """`~True` is -2, which Python 3.12 warns of and 3.16 refuses; a body that iterates gets Python's own bool."""
    files = [path for path in BODIES.rglob("*.py") if path.name != "__init__.py"]
    assert len(files) > 20
    for path in files:
        assert not [node for node in ast.walk(ast.parse(path.read_bytes())) if isinstance(node, ast.Invert)], path
