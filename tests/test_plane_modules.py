"""Emitted modules of the plane problem: interface, accuracy against the exact entries and the defining integrals."""

from __future__ import annotations

import doctest
import inspect
import math
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from plane_modules import ACCURACY, CONCAVE, SMOOTH, entries
from stored_book import CATALOGUE

from axiderive.code.plane import module as written
from axiderive.profiles import plane

EPS = 2.0**-52
BROKEN = [name for name in plane.COMPACT_NAMES if plane.load(name).breaks]


COMPACT = {
    "profile": ["x"], "load": ["a"], "pressure": ["x", "a"], "slope": ["x", "a"], "depth": ["L", "a"],
    "half_width_from_load": ["P"],
}  # fmt: skip
COMPLETE = {"profile": ["x"], "pressure": ["x", "P"], "slope": ["x", "P"], "depth": ["L", "P"]}
ECCENTRIC: dict[str, list[str]] = {"pressure": ["x", "P"], "tilt": ["P"], "contact_width": []}


def public(module: ModuleType) -> dict[str, inspect.Signature]:
    own = {key: value for key, value in vars(module).items() if inspect.isfunction(value) and key[0] != "_"}
    return {key: inspect.signature(value) for key, value in own.items() if value.__module__ == module.__name__}


def names_of(signature: inspect.Signature, kind: object) -> list[str]:
    return [p.name for p in signature.parameters.values() if p.kind is kind]


def expected(name: str) -> dict[str, list[str]]:
    if name in plane.COMPACT_NAMES:
        return COMPACT
    if name == "eccentric_punch":
        return ECCENTRIC
    return COMPLETE | ({"zero_distance": [], "minimum_load": []} if name in CONCAVE else {})


@pytest.mark.parametrize("name", plane.NAMES)
def test_exactly_the_functions_of_the_interface(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    found = public(plane_module(name))
    assert {key: names_of(s, inspect.Parameter.POSITIONAL_OR_KEYWORD) for key, s in found.items()} == expected(name)
    for entry in entries(name).values():
        keywords = names_of(found[entry.quantity.function], inspect.Parameter.KEYWORD_ONLY)
        assert keywords == [str(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", plane.NAMES)
def test_the_example_of_every_function_runs(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    """The expected number comes from the exact result through mpmath, not from the module."""
    module = plane_module(name)
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner(verbose=False)
    for test in finder.find(module, globs={name: module}):
        test.examples = [example for example in test.examples if "import" not in example.source]
        runner.run(test)
    assert runner.summarize(verbose=False) == (0, 2 * len(expected(name)))


def test_the_committed_text_is_what_the_entries_give() -> None:
    """Which is what all other tests import."""
    modules = [written(entries(name)) for name in plane.NAMES]
    made = {module.path: module.source() for module in modules}
    assert {path: (CATALOGUE / path).read_text() for path in made} == made
    assert {Path(path).stem for path in made} == {*plane.NAMES}


def test_text_is_linted_and_formatted() -> None:
    rules = Path(__file__).parents[1] / "pyproject.toml"
    for command in (["check", "-q"], ["format", "--check", "-q"]):
        call = [sys.executable, "-m", "ruff", *command, "--config", str(rules), str(CATALOGUE / "axicontact" / "plane")]
        done = subprocess.run(call, capture_output=True, text=True)
        if "No module named ruff" in done.stderr:
            pytest.skip("ruff is not installed")
        assert done.returncode == 0, done.stdout


def parameters_of(name: str) -> dict[str, float]:
    """The numbers of the sketch."""
    profile = plane.load(name)
    return {str(symbol): float(value) for symbol, value in profile.sketch.values if symbol in profile.parameters}


def contact_of(name: str) -> float:
    """The half-width as drawn, or a load of complete contact."""
    return float(plane.load(name).sketch.a) if name in plane.COMPACT_NAMES else 2.5


@pytest.mark.parametrize("name", SMOOTH)
def test_symmetry(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, given, contact = plane_module(name), parameters_of(name), contact_of(name)
    elastic = {"E_star": 2.5}
    x = np.array([0.05, 0.3, 0.8, 1.4, 2.5])
    pressure = module.pressure(x, contact, **given, **({} if name == "flat_punch" else elastic))
    mirrored = module.pressure(-x, contact, **given, **({} if name == "flat_punch" else elastic))
    assert np.array_equal(pressure, mirrored)
    material = elastic if name in plane.COMPLETE_NAMES else {}
    slope = module.slope(x, contact, **given, **material)
    assert np.array_equal(module.slope(-x, contact, **given, **material), -slope)
    assert slope[-1] < 0.0, "outside, the surface rises towards the contact on the side of positive x"
    assert np.array_equal(module.profile(-x, **given), module.profile(x, **given), equal_nan=True)


@pytest.mark.parametrize("name", plane.COMPACT_NAMES)
def test_the_surface_follows_the_indenter_in_the_contact(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    """dw/dx = -f' inside, and the slope goes over continuously at the edge; depth at L = a is the height there."""
    module, given, a = plane_module(name), parameters_of(name), contact_of(name)
    x, step = np.array([-0.9, -0.35, 0.2, 0.95]) * a, 1e-6
    difference = (module.profile(x + step, **given) - module.profile(x - step, **given)) / (2 * step)
    assert np.allclose(module.slope(x, a, **given), -difference, rtol=1e-7, atol=1e-9)
    edge = module.slope(np.array([a, a * (1 + 1e-14)]), a, **given)
    assert edge[0] == pytest.approx(edge[1], rel=1e-5)
    assert module.depth(a, a, **given) == pytest.approx(module.profile(a, **given), rel=ACCURACY, abs=0.0)


@pytest.mark.parametrize("name", ["rounded_wedge", "rounded_punch"])
def test_pressure_is_continuous_at_the_break(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, given, a = plane_module(name), parameters_of(name), contact_of(name)
    x = given["b"] * (1 + np.array([-1e-12, 0.0, 1e-12]))
    pressure = module.pressure(x, a, **given, E_star=2.5)
    assert np.ptp(pressure) < 1e-9 * pressure[1]


def test_true_singularities_are_infinite(plane_module: Callable[[str], ModuleType]) -> None:
    assert plane_module("wedge").pressure(0.0, 1.0, theta=0.2, E_star=1.0) == math.inf
    assert plane_module("truncated_wedge").pressure(-0.5, 1.0, theta=0.2, b=0.5, E_star=1.0) == math.inf
    assert plane_module("power_law").pressure(0.0, 1.0, A=0.5, n=0.9, E_star=1.0) == math.inf
    flat = plane_module("flat_punch")
    assert flat.pressure(-1.0, 1.0, a=1.0) == math.inf
    assert flat.slope(1.0, 1.0, a=1.0, E_star=1.0) == -math.inf
    assert flat.slope(-1.0, 1.0, a=1.0, E_star=1.0) == math.inf
    punch = plane_module("eccentric_punch")
    assert punch.pressure(1.0, 1.0, a=1.0, e=0.8) == math.inf
    assert punch.pressure(-1.0, 1.0, a=1.0, e=0.8) == 0.0
    assert punch.pressure(-1.0, 1.0, a=1.0, e=0.5) == 0.0


@pytest.mark.parametrize("name", plane.COMPACT_NAMES)
def test_edges_of_the_domain_of_fields(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, given, a = plane_module(name), parameters_of(name), contact_of(name)
    nan, elastic = math.nan, {"E_star": 1.0}
    pressure = module.pressure(np.array([nan, a, -a, 2 * a, 0.9 * a]), a, **given, **elastic)
    assert math.isnan(pressure[0])
    assert list(pressure[1:4]) == [0.0, 0.0, 0.0]
    assert pressure[4] > 0.0
    assert np.isnan(module.pressure(0.1, np.array([nan, -1.0, 2 * a]), **given, **elastic)).tolist() == [1, 1, 0]
    assert np.isnan(module.depth(np.array([nan, -1.0, 0.5 * a, a, 2 * a]), a, **given)).tolist() == [1, 1, 1, 0, 0]
    assert np.isnan(module.half_width_from_load(np.array([nan, -1.0]), **given, **elastic)).all()
    unloaded = module.half_width_from_load(0.0, **given, **elastic)
    assert unloaded == (given["b"] if plane.load(name).truncated else 0.0)
    assert module.load(unloaded, **given, **elastic) == 0.0
    assert module.depth(9.0, unloaded, **given) == 0.0
    assert module.slope(9.0, unloaded, **given) == 0.0


@pytest.mark.parametrize("name", [name for name in BROKEN if plane.load(name).truncated])
def test_a_contact_smaller_than_the_flat_face(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, given = plane_module(name), parameters_of(name)
    b = given["b"]
    for function, fields in (("load", []), ("pressure", [0.1]), ("slope", [9.0]), ("depth", [9.0])):
        material = {"E_star": 1.0} if function in ("load", "pressure") else {}
        with pytest.raises(ValueError, match=rf"a = .* is below b = {b}.*use plane\.flat_punch"):
            getattr(module, function)(*fields, b / 2, **given, **material)
        found = getattr(module, function)(*fields, np.array([b / 2, 2 * b]), **given, **material)
        assert np.isnan(found).tolist() == [True, False], function


@pytest.mark.parametrize("name", CONCAVE)
def test_a_load_below_the_least_one(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, given = plane_module(name), {**parameters_of(name), "E_star": 1.0}
    least = module.minimum_load(**given)
    loads = least * np.array([0.99, 1.0, 2.0])
    for function, place in (("pressure", 0.1), ("slope", 2.0), ("depth", 2.0)):
        assert np.isnan(getattr(module, function)(place, loads, **given)).tolist() == [True, False, False]
    shape = {key: value for key, value in given.items() if key != "E_star"}
    assert module.zero_distance(**{**shape, "a": np.array([0.5, 1.0])}).shape == (2,)
    assert np.isnan(module.profile(1.5 * given["a"], **shape))


@pytest.mark.parametrize(
    ("name", "function", "fields", "given", "message"),
    [
        ("wedge", "load", (1.0,), {"theta": 1.7, "E_star": 1.0}, r"theta = 1\.7 is outside 0 < theta < pi/2"),
        ("parabola", "slope", (1.0, 0.5), {"R": 0.0}, r"R = 0\.0 is outside R > 0"),
        ("rounded_punch", "load", (1.0,), {"R": 1.0, "b": -1.0, "E_star": 1.0}, r"b = -1\.0 is outside b > 0"),
        ("concave_power", "minimum_load", (), {"a": 1.0, "h": 0.1, "n": 1.0, "E_star": 1.0}, r"n = 1\.0: 1 < n.*n > 1"),
        ("eccentric_punch", "tilt", (1.0,), {"a": 1.0, "e": -1.5, "E_star": 1.0}, r"e = -1\.5, a = 1\.0: abs\(e\) < a"),
        ("eccentric_punch", "pressure", (0.0, 1.0), {"a": 1.0, "e": 1.0}, "overturns the punch, move it inside"),
        ("eccentric_punch", "contact_width", (), {"a": 1.0, "e": math.nan}, r"e = nan.*abs\(e\) < a"),
        ("eccentric_punch", "contact_width", (), {"a": 0.0, "e": 0.0}, r"a = 0\.0 is outside a > 0"),
    ],
)
def test_messages_name_value_rule_and_next_step(
    name: str,
    function: str,
    fields: tuple[float, ...],
    given: dict[str, float],
    message: str,
    plane_module: Callable[[str], ModuleType],
) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(plane_module(name), function)(*fields, **given)


def test_a_place_that_is_no_number_is_refused(plane_module: Callable[[str], ModuleType]) -> None:
    with pytest.raises(TypeError, match="x must be a real number"):
        plane_module("wedge").slope("0.3", 1.0, theta=0.2)


@pytest.mark.parametrize("name", plane.NAMES)
def test_arrays_broadcast_and_numbers_give_floats(name: str, plane_module: Callable[[str], ModuleType]) -> None:
    module, contact = plane_module(name), contact_of(name)
    for function, fields in expected(name).items():
        keywords = names_of(public(module)[function], inspect.Parameter.KEYWORD_ONLY)
        given = {**parameters_of(name), "E_star": 1.5}
        given = {key: given[key] for key in keywords}
        first = {"x": 0.3, "L": 2.0 * contact}
        values = [first.get(field, contact) for field in fields]
        call = getattr(module, function)
        single = call(*values, **given)
        assert type(single) is float
        if not fields:
            continue
        kept = np.array([[values[0]], [values[0]]])
        many = call(kept, *values[1:], **{**given, keywords[0]: np.full(3, given[keywords[0]])})
        assert many.shape == (2, 3) or (many.shape == (2, 1) and keywords[0] not in call.__doc__)
        assert np.allclose(many, single, rtol=1e-14, atol=0.0)
        assert (kept == values[0]).all()


@pytest.mark.parametrize(
    ("name", "function", "x", "given"),
    [
        ("rounded_wedge", "pressure", 0.3, {"a": 1.0, "theta": 0.3, "b": 0.5, "E_star": 2.0}),
        ("rounded_wedge", "slope", 2.3, {"a": 1.0, "theta": 0.3, "b": 0.5}),
        ("power_law", "pressure", 0.3, {"a": 1.0, "A": 0.2, "n": 2.7, "E_star": 2.0}),
        ("concave_power", "slope", 2.3, {"P": 1.0, "a": 1.0, "h": 0.1, "n": 2.7, "E_star": 2.0}),
        ("eccentric_punch", "pressure", 0.3, {"P": 1.0, "a": 1.0, "e": 0.7}),
    ],
)
def test_one_number_is_computed_without_arrays(
    name: str,
    function: str,
    x: float,
    given: dict[str, float],
    plane_module: Callable[[str], ModuleType],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """On both sides of the middle, but for a load that leans away: an array of one number takes ten times as long."""
    module = plane_module(name)
    call = getattr(module, function)
    blocks, over = import_module("axicontact._runtime.arrays.blocks"), []
    own = blocks.over_arrays
    monkeypatch.setattr(blocks, "over_arrays", lambda *given: over.append(given) or own(*given))
    field = next(iter(given.values()))
    keywords = dict(list(given.items())[1:])
    for place in (x, -x):
        values = call(np.array([place]), field, **keywords)
        over.clear()
        one = call(place, field, **keywords)
        assert (not over) == (place > 0.0 or "e" not in given)
        assert one == pytest.approx(values[0], rel=16 * EPS, abs=0.0)
        assert (call(np.float64(place), field, **keywords), call(int(place), field, **keywords)) == (
            values[0], call(np.array([int(place)]), field, **keywords)[0],
        )  # fmt: skip


@pytest.mark.parametrize("rule", ["load_beyond", "slope_beyond", "depth_beyond"])
def test_a_break_far_inside_costs_a_few_panels(rule: str, plane_module: Callable[[str], ModuleType]) -> None:
    """A hundred decades took 26 of them; the strips that are left out add nothing, as little far out as at the edge."""
    growth = plane_module("rounded_wedge")._growth_beyond
    integral = getattr(import_module("axicontact._runtime.physics.plane"), rule)
    calls = []

    def counted(t: np.ndarray, root: np.ndarray, *parameters: np.ndarray) -> np.ndarray:
        calls.append(t.size)
        return growth(t, root, *parameters)

    b, far = np.full(3, 1e-100), np.array([1.0 + 1e-9, 1.5, 1e6])
    lengths = (far, b) if rule == "load_beyond" else (far, np.ones(3), b)
    value = integral(counted, (0.3, b), *lengths)
    assert sum(calls) <= 8 * 64 * 3
    # up to 1e-50 of the contact the growth is tan(theta) to all digits, whatever the break
    same = integral(lambda t, root, theta, b: np.tan(theta) + 0.0 * t, (0.3, b), *lengths)
    np.testing.assert_allclose(value, same, rtol=16 * EPS)
    exact = {
        "load_beyond": far, "slope_beyond": np.arcsin(1.0 / far),
        "depth_beyond": np.arccosh(far) + far * np.arcsin(1.0 / far),
    }[rule]  # fmt: skip
    np.testing.assert_allclose(value, np.tan(0.3) * exact, rtol=1e-13)
