"""The written way of a formula over arrays: programs over blocks, and what a caller sees of them."""

from __future__ import annotations

import inspect
import math
import pickle
import re
import subprocess
import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from private_bodies import EPS, MODULES, Products, bodies, body
from written import plain, program

from axicontact._programs.normal import cone as cone_programs
from axicontact._programs.normal import paraboloid as paraboloid_programs
from axicontact._runtime import interface
from axicontact._runtime.arrays.blocks import Program
from axicontact._runtime.interface import BLOCK, elementwise
from axicontact.normal import (
    cone,
    ellipsoid,
    paraboloid,
    rounded_punch,
    sphere,
)
from axiderive.code.programs.graph import trace

EXTREMES = np.array([0.0, 1e-300, 1e-30, 0.3, 0.5, 1.0, 1.0, 1.4, 2.0, 1e150, np.inf, np.nan])
RARE = (sphere._pressure, ellipsoid._pressure, sphere._peak_pressure, ellipsoid._peak_pressure)
"""Bodies with a branch that is left to them."""


def run(function: Callable[..., Any], arrays: list[bool], values: list[np.ndarray]) -> np.ndarray | None:
    found = program(function, len(values), arrays)
    if found is None:
        return None
    out = np.empty(values[0].shape)
    numbers = [value[0] for value, more in zip(values, arrays, strict=True) if not more]
    places = [np.empty_like(out) for _ in range(found.scratch)]
    places += [np.empty(out.shape, bool) for _ in range(found.masks)]
    places += [np.full(out.shape, value) for value in found.filled]
    given, prepared = [value for value, more in zip(values, arrays, strict=True) if more], found.prepare(*numbers)
    if found.positive and not all(0.0 < x < np.inf for x in prepared):
        return body(function, *values)
    try:
        found.block(out, *given, *prepared, *places)
    except FloatingPointError:
        assert function in RARE or not all(np.all((x >= 0.0) & (x < np.inf)) for x in given)
        return body(function, *values)
    return out


@pytest.mark.parametrize("name", MODULES)
def test_programs_do_what_the_bodies_say(name: str) -> None:
    """To the last bit, with some arguments as numbers, in blocks where branches mix, at zero, infinity and NaN."""
    dice, count = np.random.default_rng(len(name)), 0
    for function in bodies(name):
        arguments = function.__code__.co_argcount
        for trial in range(4):
            arrays = [trial < 2 or bool(dice.integers(2)) for _ in range(arguments)]
            draw = (lambda: 10 ** dice.uniform(-3, 3, 120)) if trial % 2 else (lambda: dice.choice(EXTREMES, 120))
            values = [draw() if more else np.full(120, draw()[0]) for more in arrays]
            before = [value.copy() for value in values]
            with np.errstate(all="ignore"):
                got = run(function, arrays, values)
                if got is None:
                    break
                wanted = function(*(value.view(Products) for value in values))
                np.testing.assert_array_equal(got, np.broadcast_to(wanted, 120), function.__name__)
            np.testing.assert_array_equal(values, before)
            count += 1
    assert count >= 4


def scaled(x: Any, p: Any) -> Any:
    return (x / p) * 4.0 + (p * x) / 8.0 + (x * p) / -2.0 + (p / x) / 0.5 - x / 3.0 + (x / p) / 16.0


def test_powers_of_two_change_places_exactly() -> None:
    x, p = 10 ** np.random.default_rng(3).uniform(-3, 3, (2, 500))
    for arrays in ([True, False], [False, True], [True, True]):
        values = [value if more else np.full(500, value[0]) for value, more in zip((x, p), arrays, strict=True)]
        np.testing.assert_array_equal(run(scaled, arrays, values), scaled(*values))


class Counting:
    """NumPy, of which one function notes its calls."""

    def __init__(self, name: str) -> None:
        self.name, self.calls = name, 0

    def __getattr__(self, name: str) -> Any:
        self.calls += name == self.name
        return getattr(np, name)


def test_a_branch_that_holds_nowhere_is_not_evaluated(monkeypatch: pytest.MonkeyPatch) -> None:
    for radii, calls in (([1.2, 1.9], 1), ([0.2, 1.1], 1), ([0.3, 1.0], 0)):
        counting = Counting("sqrt")
        monkeypatch.setattr(cone_programs, "np", counting)
        cone.displacement(np.array(radii), 1.0, theta=0.3)
        assert counting.calls == calls


def rising(r: Any, a: Any, n: Any) -> Any:
    return np.where(r < a, n * np.log1p((a - r) / r) * np.sqrt((a - r) * (a + r)) ** 3, 0.0)


def falling(r: Any, a: Any, n: Any) -> Any:
    """Not zero where a - r is replaced by zero."""
    return np.where(r < a, n * np.log1p((a - r + r) / r), 0.0)


def below(r: Any, a: Any, n: Any) -> Any:
    """Zero over zero at r = a."""
    return np.where(r < a, n * (a - r) / (a - r), 0.0)


def test_zero_beyond_the_edge_needs_no_choice() -> None:
    """Exactly where what is inside vanishes there, for one contact radius and ordinary numbers."""
    simple = [rising, cone._pressure, paraboloid._pressure]
    for function in (*simple, falling, below, cone._displacement):
        count = function.__code__.co_argcount
        text = program(function, count, (True, *[False] * (count - 1)))
        assert text is not None
        assert text.positive == (function in simple)
        several = program(function, count, (True,) * count)
        assert several is not None
        assert not several.positive
    r = np.array([0.0, 1e-300, 0.3, np.nextafter(1.0, 0.0), 1.0, np.nextafter(1.0, 2.0), 3.0, 1e300])
    for odd in ([], [np.inf], [np.nan], [-1.0], [-0.0]):
        radii = np.array([*r, *odd])
        for a in (0.0, 1.0, np.inf):
            got = cone.pressure(radii, a, theta=0.3, E_star=2.0)
            expected = body(cone._pressure, radii, a, 0.3, 2.0)
            np.testing.assert_array_equal(got, np.where(radii >= 0.0, expected, np.nan))


def test_a_block_inside_the_contact_needs_no_maximum(monkeypatch: pytest.MonkeyPatch) -> None:
    for last, calls in ((1.0, 0), (np.nextafter(1.0, 2.0), 1)):
        counting = Counting("maximum")
        monkeypatch.setattr(paraboloid_programs, "np", counting)
        p = paraboloid.pressure(np.array([0.2, last]), 1.0, R=3.0, E_star=2.0)
        assert p[1] == 0.0
        assert counting.calls == calls


@pytest.mark.parametrize("size", [0, 1, 2, BLOCK - 1, BLOCK, BLOCK + 1, 2 * BLOCK + 7])
def test_borders_of_blocks(size: int) -> None:
    r = np.linspace(0.1, 1.2, size)
    np.testing.assert_array_equal(cone.pressure(r, 1.0, theta=0.3, E_star=2.0), body(cone._pressure, r, 1.0, 0.3, 2.0))
    r[size // 2 :] *= -1.0
    got = cone.pressure(r, 1.0, theta=0.3, E_star=2.0)
    assert np.isnan(got[size // 2 :]).all()
    assert np.isfinite(got[: size // 2]).all()


def test_shapes_and_strides() -> None:
    wide = np.random.default_rng(0).uniform(0.1, 1.5, (210, 330))
    column, row, theta = wide[:, :1], wide[:1], np.linspace(0.1, 1.5, 330)
    for r, a, angle in (
        (wide[::2, ::3], 1.0, 0.3), (wide.T, 1.0, 0.3), (column, row, 0.3), (wide, column, theta),
        (wide[::-1], 1.0, 0.3),
        (np.asfortranarray(wide), wide, 0.3), (0.4, wide, theta), (0.4, 1.0, theta), (wide, np.array([[1.0]]), [0.3]),
    ):  # fmt: skip
        got = cone.pressure(r, a, theta=angle, E_star=2.0)
        np.testing.assert_array_equal(got, body(cone._pressure, r, a, angle, 2.0))
    assert cone.pressure([[0.3]], 1.0, theta=0.3, E_star=2.0).shape == (1, 1)
    assert cone.pressure(np.empty((0, 4)), np.ones(4), theta=0.3, E_star=2.0).shape == (0, 4)
    assert type(cone.pressure(np.float64(0.3), 1.0, theta=0.3, E_star=2.0)) is float
    assert math.isnan(cone.pressure(wide, -1.0, theta=0.3, E_star=2.0).max())


def test_a_block_out_of_range_is_evaluated_again_alone() -> None:
    """R*a of the middle block has 340 decades; its neighbours keep their bits."""
    assert not Program(*paraboloid_programs.BLOCKS["_force", 1, "a", "R", "E_star"][("a",)]).scratch
    a, size = np.linspace(0.5, 1.0, 6 * BLOCK), 2 * BLOCK
    wanted = paraboloid.force(a, R=2.0, E_star=3.0)
    a[size + 5] = 1e-150
    got = paraboloid.force(a, R=2.0, E_star=3.0)
    np.testing.assert_array_equal(np.delete(got, np.s_[size : 2 * size]), np.delete(wanted, np.s_[size : 2 * size]))
    np.testing.assert_allclose(got[size : size + 5], wanted[size : size + 5], rtol=4 * EPS)
    assert paraboloid.force(np.array([1e-90, 1.0]), R=1e-100, E_star=1e-60)[0] == pytest.approx(
        4e-230 / 3, rel=4 * EPS, abs=0.0
    )
    assert paraboloid.force(1e-90, R=1e-100, E_star=1e-60) == pytest.approx(4e-230 / 3, rel=4 * EPS, abs=0.0)
    many = np.array([1e-200, 1.0])
    assert cone.force(many, theta=0.3, E_star=1e200)[0] == pytest.approx(
        1e-200 * cone.force(1.0, theta=0.3, E_star=1.0)
    )


def test_threads_share_nothing() -> None:
    radii = [np.random.default_rng(i).uniform(0.1, 1.5, 3 * BLOCK) for i in range(8)]
    wanted = [body(rounded_punch._depth, a + 0.5, 2.0, 0.5) for a in radii]
    with ThreadPoolExecutor(8) as threads:
        for got, right in zip(
            threads.map(lambda a: rounded_punch.depth(a + 0.5, R=2.0, b=0.5), radii * 3), wanted * 3, strict=True
        ):
            np.testing.assert_array_equal(got, right)


def test_what_has_no_graph_runs_as_it_is() -> None:
    assert trace(rounded_punch._contact_from_depth, ("d", "R", "b"), ()) is None
    assert program(rounded_punch._pressure, 5, (True,) * 5) is None
    assert trace(lambda x: x if x > 0.0 else -x, ("x",), ()) is None
    assert trace(lambda x: np.asarray(x, dtype=float), ("x",), ()) is None
    assert trace(lambda x: x > 0.0, ("x",), ()) is None

    # one inside another function has no programs, whatever its name
    def _force(x: Any) -> Any:
        return 3.0 * x

    _force.__module__ = cone.__name__
    assert elementwise(_force, 2.0) == 6.0
    np.testing.assert_array_equal(elementwise(lambda x: 2.0 * x, [1.0, -1.0]), [2.0, np.nan])


def test_a_rare_branch_is_left_to_the_body() -> None:
    """The strips of a sphere have a kernel up to 0.7 of a quarter circle and a rule beyond it, in the same call."""
    r, a, R = np.linspace(0.01, 0.98, 97), np.where(np.arange(97) % 2, 0.99, 0.3), np.ones(97)
    wanted = body(sphere._pressure, r, a, R, 2.0 * R)
    assert program(sphere._pressure, 2, (True, True, False, False)) is not None
    np.testing.assert_allclose(sphere.pressure(r, a, R=1.0, E_star=2.0), wanted, rtol=16 * EPS)
    np.testing.assert_allclose(sphere.pressure(r, 0.99, R=R, E_star=2.0)[1::2], wanted[1::2], rtol=16 * EPS)
    assert sphere.pressure(r[1], 0.99, R=1.0, E_star=2.0) == pytest.approx(wanted[1], rel=16 * EPS, abs=0.0)
    assert sphere.pressure(float(r[0]), 0.3, R=1.0, E_star=2.0) == pytest.approx(wanted[0], rel=16 * EPS, abs=0.0)
    formula = plain(sphere._pressure)
    assert formula is not None
    assert formula(0.1, 0.99, 1.0, 2.0) is None
    assert formula(0.1, 0.3, 1.0, 2.0) is not None

    def asking_twice(x: Any) -> Any:
        return x if not np.any(x > 1.0) else 2.0 if not np.any(x > 2.0) else x

    assert trace(asking_twice, ("x",), ()) is not None, "the second question is never asked"
    assert trace(lambda x: asking_twice(x) + asking_twice(2.0 * x), ("x",), ()) is None


def test_programs_wait_for_the_first_call() -> None:
    code = "import sys, axicontact.normal.cone; print(any('_programs' in name for name in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "False"


def test_nothing_is_compiled_or_traced_at_run_time() -> None:
    """What runs is source that can be read."""
    root = Path(interface.__file__).parents[1]
    for path in sorted(root.rglob("*.py")):
        text = path.read_text()
        assert not re.search(r"\b(exec|eval|compile)\(|import dis\b|from dis\b|CodeType", text), path


def test_a_program_stands_in_the_traceback_under_its_name(monkeypatch: pytest.MonkeyPatch) -> None:
    """A profiler and a debugger see the function and the file it stands in."""
    code = cone_programs.pressure.__code__
    assert code.co_name == "pressure"
    assert Path(code.co_filename).read_text().splitlines()[code.co_firstlineno - 1].startswith("def pressure(")


def test_functions_keep_name_signature_and_pickle() -> None:
    for _ in range(2):
        assert cone.pressure.__name__ == "pressure"
        assert list(inspect.signature(cone.pressure).parameters) == ["r", "a", "theta", "E_star"]
        assert (cone.pressure.__doc__ or "").startswith("Contact pressure")
        assert pickle.loads(pickle.dumps(cone.pressure)) is cone.pressure
        cone.pressure(0.3, 1.0, theta=0.3, E_star=1.0)
    assert interface.BLOCK == BLOCK
