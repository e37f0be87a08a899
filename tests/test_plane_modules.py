"""Emitted modules of the plane problem: interface, accuracy against the exact entries and the defining integrals."""

from __future__ import annotations

import doctest
import inspect
import math
import random
import subprocess
import sys
import zlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType

import mpmath as mp
import numpy as np
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.contact.plane import derive
from axiderive.emit.imports import RUNTIME
from axiderive.emit.kernels import kernels_source
from axiderive.emit.nodes import nodes_source
from axiderive.emit.plane import module_source, module_sources
from axiderive.emit.python import NODE_COUNTS
from axiderive.emit.symbols import symbols_source
from axiderive.entry import Case, Entry
from axiderive.profiles import plane
from axiderive.proof import plane_quadrature
from axiderive.proof.evaluate import case_at, evaluate

PACKAGE = "emitted_plane"
ACCURACY = 5e-15
"""Measured over 1200 states of each profile: 2.5e-15 (power law, rounded punch), else 1.4e-15."""
BROKEN = [name for name in plane.COMPACT_NAMES if plane.load(name).breaks]
CONCAVE = [name for name in plane.COMPLETE_NAMES if name.startswith("concave")]
COMPACT = {
    "profile": ["x"], "load": ["a"], "pressure": ["x", "a"], "slope": ["x", "a"], "depth": ["L", "a"],
    "half_width_from_load": ["P"],
}  # fmt: skip
COMPLETE = {"profile": ["x"], "pressure": ["x", "P"], "slope": ["x", "P"], "depth": ["L", "P"]}
ECCENTRIC: dict[str, list[str]] = {"pressure": ["x", "P"], "tilt": ["P"], "contact_width": []}
Values = dict[sp.Symbol, float]


@cache
def entries(name: str) -> dict[str, Entry]:
    return derive(plane.load(name))


def written(folder: Path, package: str, sources: dict[str, str]) -> None:
    """The runtime and these modules as a package."""
    base = folder / package
    (base / "plane").mkdir(parents=True)
    for path in RUNTIME.glob("*.py"):
        (base / path.name).write_text(path.read_text())
    (base / "_nodes.py").write_text(nodes_source(NODE_COUNTS))
    (base / "_kernels.py").write_text(kernels_source())
    (base / "__init__.py").write_text("")
    (base / "_symbols.py").write_text(symbols_source({"theta", "R", "A", "b", "h", "n", "a", "E_star"}))
    for path_, text in sources.items():
        (base / Path(path_).relative_to("axicontact")).write_text(text)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Path]:
    folder = tmp_path_factory.mktemp("plane")
    written(folder, PACKAGE, module_sources({name: entries(name) for name in plane.NAMES}))
    sys.path.insert(0, str(folder))
    yield folder
    sys.path.remove(str(folder))
    for name in [name for name in sys.modules if name.startswith(PACKAGE)]:
        del sys.modules[name]


@pytest.fixture
def emitted(folder: Path) -> Callable[[str], ModuleType]:
    return lambda name: import_module(f"{PACKAGE}.plane.{name}")


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
def test_exactly_the_functions_of_the_interface(name: str, emitted: Callable[[str], ModuleType]) -> None:
    found = public(emitted(name))
    assert {key: names_of(s, inspect.Parameter.POSITIONAL_OR_KEYWORD) for key, s in found.items()} == expected(name)
    for entry in entries(name).values():
        keywords = names_of(found[entry.quantity.function], inspect.Parameter.KEYWORD_ONLY)
        assert keywords == [str(symbol) for symbol in entry.parameters], entry.key


@pytest.mark.parametrize("name", plane.NAMES)
def test_the_example_of_every_function_runs(name: str, emitted: Callable[[str], ModuleType]) -> None:
    """The expected number comes from the exact result through mpmath, not from the module."""
    module = emitted(name)
    finder, runner = doctest.DocTestFinder(), doctest.DocTestRunner(verbose=False)
    for test in finder.find(module, globs={name: module}):
        test.examples = [example for example in test.examples if "import" not in example.source]
        runner.run(test)
    assert runner.summarize(verbose=False) == (0, 2 * len(expected(name)))


def test_text_is_linted_and_formatted(folder: Path) -> None:
    rules = Path(__file__).parents[1] / "pyproject.toml"
    for command in (["check", "-q"], ["format", "--check", "-q"]):
        call = [sys.executable, "-m", "ruff", *command, "--config", str(rules), str(folder / PACKAGE / "plane")]
        done = subprocess.run(call, capture_output=True, text=True)
        if "No module named ruff" in done.stderr:
            pytest.skip("ruff is not installed")
        assert done.returncode == 0, done.stdout


def ratio(draw: random.Random) -> float:
    """Between 0 and 1, down to 1e-6 of either end."""
    share = float(10 ** draw.uniform(-6, 0))
    return share if draw.random() < 0.5 else 1 - share


def state(name: str, draw: random.Random) -> Values:
    """Lengths of 1e-9 to 10 m; x inside the contact, L outside, the break on either side of the edge and near x."""
    profile, a = plane.load(name), 10 ** draw.uniform(-9, 1)
    values = {
        nt.a: a, nt.E_star: 10 ** draw.uniform(3, 11), nt.theta: 10 ** draw.uniform(-4, -0.2),
        nt.R: 10 ** draw.uniform(-6, 2), nt.A: 10 ** draw.uniform(-3, 3), nt.h: a * 10 ** draw.uniform(-5, -1),
        nt.n: 10 ** draw.uniform(-1, 1.2) if profile.contact == "compact" else 1 + 10 ** draw.uniform(-2, 1.2),
        nt.x: a * ratio(draw), nt.L: a / ratio(draw),
    }  # fmt: skip
    if profile.breaks:
        share = ratio(draw)
        values[nt.b] = a * share if profile.truncated or draw.random() < 0.6 else a / share
        if values[nt.b] < a and draw.random() < 0.3:
            near = values[nt.b] * (1 + draw.choice((-1, 1)) * 10 ** draw.uniform(-6, -1))
            values[nt.x] = min(near, a * (1 - 1e-7))
    return values


def exact_numbers(values: Values) -> dict[sp.Symbol, sp.Expr]:
    return {symbol: sp.Rational(value) for symbol, value in values.items()}


def called(module: ModuleType, entry: Entry, values: Values) -> float:
    fields = [values[symbol] for symbol in entry.quantity.arguments]
    parameters = {str(symbol): values[symbol] for symbol in entry.parameters}
    return float(getattr(module, entry.quantity.function)(*fields, **parameters))


def ready(module: ModuleType, name: str, values: Values, suffix: str, draw: random.Random) -> Values:
    """The state for one function: x outside for the slope, a load of complete contact, the load of a half-width."""
    values = dict(values)
    if suffix == "s":
        values[nt.x] = values[nt.a] / ratio(draw)
    if name in plane.COMPLETE_NAMES:
        least = called(module, entries(name)["Pmin"], values) if name in CONCAVE else 1.0
        values[nt.P] = least * (1 + 10 ** draw.uniform(-3, 3))
    elif suffix == "aP":
        forward = case_at(entries(name)["P"], exact_numbers(values)).expr
        values[nt.P] = float(evaluate(forward, exact_numbers(values), 40))
    return values


def error(module: ModuleType, name: str, values: Values, suffix: str) -> float:
    """Relative; of the half-width through the load it gives; over the term of the load where a zero is crossed."""
    entry, numbers = entries(name)[suffix], exact_numbers(values)
    found = called(module, entry, values)
    if suffix == "aP":
        at = exact_numbers({**values, nt.a: found})
        load = case_at(entries(name)["P"], at).expr
        growth = evaluate(nt.a * sp.diff(load, nt.a) / load, at, 20)
        # a load of small exponent fixes its half-width to 1/n of its own accuracy only
        return float(abs(evaluate(load, at, 40) / numbers[nt.P] - 1) / max(growth, 1))
    case = case_at(entry, numbers)
    value = evaluate(case.expr, numbers, 40)
    scale = abs(value)
    if name in CONCAVE and suffix in ("p", "d"):
        scale = max(scale, abs(evaluate(sp.expand(case.expr).coeff(nt.P) * nt.P, numbers, 20)))
    return float(abs(found - value) / scale)


SMOOTH = [name for name in plane.NAMES if name != "eccentric_punch"]


@pytest.mark.parametrize("name", SMOOTH)
def test_accuracy_against_the_exact_entries(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, draw = emitted(name), random.Random(zlib.crc32(name.encode()))
    with mp.workdps(100):
        for _ in range(40):
            start = state(name, draw)
            for suffix in set(entries(name)) - {"xz", "Pmin"}:
                values = ready(module, name, start, suffix, draw)
                if values[nt.x] in (values[nt.a], values.get(nt.b)) or values[nt.L] == values[nt.a]:
                    continue
                assert error(module, name, values, suffix) < ACCURACY, (suffix, values)


@pytest.mark.parametrize("name", [name for name in SMOOTH if name != "flat_punch"])
def test_accuracy_against_the_defining_integrals(name: str, emitted: Callable[[str], ModuleType]) -> None:
    """Not through the closed forms: a wrong entry would not pass, whatever the emission does."""
    module, draw, profile = emitted(name), random.Random(7), plane.load(name)
    suffixes = [suffix for suffix in ("P", "p", "s", "d") if suffix in entries(name)]
    with mp.workdps(20 + plane_quadrature.integrals.GUARD):
        for suffix in suffixes:
            # the substitution of the quadrature is for whole powers: near t = 0 it is slow for small ones
            values = ready(module, name, state(name, draw) | {nt.n: 2.75}, suffix, draw)
            if name in CONCAVE:  # away from the zero of the pressure
                values[nt.P] += called(module, entries(name)["Pmin"], values)
            values[nt.x] = values[nt.a] * (1.75 if suffix == "s" else 0.375)
            values[nt.L] = values[nt.a] * 2.25
            value = plane_quadrature.defined(profile, suffix, exact_numbers(values), 20)
            found = called(module, entries(name)[suffix], values)
            assert abs(found - value) < 2 * ACCURACY * abs(value), (suffix, values)


@pytest.mark.parametrize("n", [1.01, 1.5, 2.0, 2.3, 4.0, 12.0])
def test_least_load_of_a_concave_power(n: float, emitted: Callable[[str], ModuleType]) -> None:
    """At the least load the pressure is zero at the place that is named, and positive elsewhere."""
    module, given = emitted("concave_power"), {"a": 0.75, "h": 0.01, "n": n}
    place = module.zero_distance(**given)
    least = module.minimum_load(**given, E_star=3.0)
    scale = least / given["a"]
    assert abs(module.pressure(place, least, **given, E_star=3.0)) < 1e-14 * scale / min(n - 1, 1)
    around = module.pressure(np.linspace(0.0, 0.7499, 900), least, **given, E_star=3.0)
    assert (around > -1e-14 * scale / min(n - 1, 1)).all()
    assert (place == 0.0) == (n <= 2.0)


def test_special_powers_are_those_of_the_law(emitted: Callable[[str], ModuleType]) -> None:
    law, quartic = emitted("concave_power"), emitted("concave_quartic")
    given = {"a": 0.75, "h": 0.01, "E_star": 3.0}
    assert law.minimum_load(**given, n=4.0) == pytest.approx(quartic.minimum_load(**given), rel=ACCURACY)
    assert law.zero_distance(a=0.75, h=0.01, n=4.0) == pytest.approx(quartic.zero_distance(a=0.75, h=0.01), rel=1e-14)


ECCENTRICITIES = (0.0, 0.2, 0.375, 0.375 * (1 - 1e-7), 0.375 * (1 + 1e-7), 0.5, 0.7, 0.75 * (1 - 1e-6))


@pytest.mark.parametrize("sign", [1.0, -1.0])
@pytest.mark.parametrize("e", ECCENTRICITIES)
def test_pressure_of_the_eccentric_punch_carries_load_and_moment(
    e: float, sign: float, emitted: Callable[[str], ModuleType]
) -> None:
    """Gauss rules for the weight of either pressure, with nodes in the contact that the width names."""
    module, a, P, e = emitted("eccentric_punch"), 0.75, 2.5, sign * e
    width = module.contact_width(a=a, e=e)
    side = math.copysign(1.0, e)
    angle = (np.arange(400) + 0.5) * np.pi / 400
    x = side * (a - width / 2 * (1 - np.cos(angle)))
    pressure = module.pressure(x, P, a=a, e=e)
    weight = np.pi / 400 * width / 2 * np.sin(angle)
    assert np.sum(pressure * weight) == pytest.approx(P, rel=1e-8)
    assert np.sum(pressure * weight * x) == pytest.approx(P * e, rel=1e-8, abs=1e-12)
    lifted = -side * (a - (2 * a - width) / 2)
    assert module.pressure(lifted, P, a=a, e=e) == 0.0 or width == 2 * a


def test_accuracy_of_the_eccentric_punch(emitted: Callable[[str], ModuleType]) -> None:
    """Near lift-off, near overturning, and near either end of the contact."""
    module, own, draw = emitted("eccentric_punch"), entries("eccentric_punch"), random.Random(3)
    order = (nt.x, nt.P, nt.a, nt.e, nt.E_star)
    curves = {(s, i): sp.lambdify(order, c.expr, "mpmath") for s, e in own.items() for i, c in enumerate(e.cases)}
    for _ in range(600):
        a = 10 ** draw.uniform(-9, 1)
        near = a / 2 * (1 + draw.choice((-1, 1)) * 10 ** draw.uniform(-6, -1))
        e = draw.choice((-1, 1)) * (near if draw.random() < 0.4 else a * ratio(draw))
        x = draw.choice((-1, 1)) * a * ratio(draw)
        if abs(e) > a / 2 and draw.random() < 0.3:
            x = -math.copysign(min(a, abs(4 * abs(e) - 3 * a)) * (1 - 10 ** draw.uniform(-6, -1)), e)
        values = {nt.x: x, nt.P: 10 ** draw.uniform(-3, 6), nt.a: a, nt.e: e, nt.E_star: 10 ** draw.uniform(3, 11)}
        if abs(x) >= a or abs(e) >= a:
            continue
        for suffix, entry in own.items():
            with mp.workdps(50):
                exact = curves[suffix, int(abs(e) > a / 2)](*(mp.mpf(values[symbol]) for symbol in order))
                assert abs(called(module, entry, values) - exact) <= ACCURACY * abs(exact), (suffix, values)


def parameters_of(name: str) -> dict[str, float]:
    """The numbers of the sketch."""
    profile = plane.load(name)
    return {str(symbol): float(value) for symbol, value in profile.sketch.values if symbol in profile.parameters}


def contact_of(name: str) -> float:
    """The half-width as drawn, or a load of complete contact."""
    return float(plane.load(name).sketch.a) if name in plane.COMPACT_NAMES else 2.5


@pytest.mark.parametrize("name", SMOOTH)
def test_symmetry(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, given, contact = emitted(name), parameters_of(name), contact_of(name)
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
def test_the_surface_follows_the_indenter_in_the_contact(name: str, emitted: Callable[[str], ModuleType]) -> None:
    """dw/dx = -f' inside, and the slope goes over continuously at the edge; depth at L = a is the height there."""
    module, given, a = emitted(name), parameters_of(name), contact_of(name)
    x, step = np.array([-0.9, -0.35, 0.2, 0.95]) * a, 1e-6
    difference = (module.profile(x + step, **given) - module.profile(x - step, **given)) / (2 * step)
    assert np.allclose(module.slope(x, a, **given), -difference, rtol=1e-7, atol=1e-9)
    edge = module.slope(np.array([a, a * (1 + 1e-14)]), a, **given)
    assert edge[0] == pytest.approx(edge[1], rel=1e-5)
    assert module.depth(a, a, **given) == pytest.approx(module.profile(a, **given), rel=ACCURACY)


@pytest.mark.parametrize("name", ["rounded_wedge", "rounded_punch"])
def test_pressure_is_continuous_at_the_break(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, given, a = emitted(name), parameters_of(name), contact_of(name)
    x = given["b"] * (1 + np.array([-1e-12, 0.0, 1e-12]))
    pressure = module.pressure(x, a, **given, E_star=2.5)
    assert np.ptp(pressure) < 1e-9 * pressure[1]


def test_true_singularities_are_infinite(emitted: Callable[[str], ModuleType]) -> None:
    assert emitted("wedge").pressure(0.0, 1.0, theta=0.2, E_star=1.0) == math.inf
    assert emitted("truncated_wedge").pressure(-0.5, 1.0, theta=0.2, b=0.5, E_star=1.0) == math.inf
    assert emitted("power_law").pressure(0.0, 1.0, A=0.5, n=0.9, E_star=1.0) == math.inf
    flat = emitted("flat_punch")
    assert flat.pressure(-1.0, 1.0, a=1.0) == math.inf
    assert flat.slope(1.0, 1.0, a=1.0, E_star=1.0) == -math.inf
    assert flat.slope(-1.0, 1.0, a=1.0, E_star=1.0) == math.inf
    punch = emitted("eccentric_punch")
    assert punch.pressure(1.0, 1.0, a=1.0, e=0.8) == math.inf
    assert punch.pressure(-1.0, 1.0, a=1.0, e=0.8) == 0.0
    assert punch.pressure(-1.0, 1.0, a=1.0, e=0.5) == 0.0


@pytest.mark.parametrize("name", plane.COMPACT_NAMES)
def test_edges_of_the_domain_of_fields(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, given, a = emitted(name), parameters_of(name), contact_of(name)
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
def test_a_contact_smaller_than_the_flat_face(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, given = emitted(name), parameters_of(name)
    b = given["b"]
    for function, fields in (("load", []), ("pressure", [0.1]), ("slope", [9.0]), ("depth", [9.0])):
        material = {"E_star": 1.0} if function in ("load", "pressure") else {}
        with pytest.raises(ValueError, match=rf"a = .* is below b = {b}.*use plane\.flat_punch"):
            getattr(module, function)(*fields, b / 2, **given, **material)
        found = getattr(module, function)(*fields, np.array([b / 2, 2 * b]), **given, **material)
        assert np.isnan(found).tolist() == [True, False], function


@pytest.mark.parametrize("name", CONCAVE)
def test_a_load_below_the_least_one(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, given = emitted(name), {**parameters_of(name), "E_star": 1.0}
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
    emitted: Callable[[str], ModuleType],
) -> None:
    with pytest.raises(ValueError, match=message):
        getattr(emitted(name), function)(*fields, **given)


def test_a_place_that_is_no_number_is_refused(emitted: Callable[[str], ModuleType]) -> None:
    with pytest.raises(TypeError, match="x must be a real number"):
        emitted("wedge").slope("0.3", 1.0, theta=0.2)


@pytest.mark.parametrize("name", plane.NAMES)
def test_arrays_broadcast_and_numbers_give_floats(name: str, emitted: Callable[[str], ModuleType]) -> None:
    module, contact = emitted(name), contact_of(name)
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


def mutant(entry: Entry, change: Callable[[sp.Expr], sp.Expr]) -> Entry:
    return replace(entry, cases=tuple(Case(case.chain, change(case.expr)) for case in entry.cases))


@pytest.mark.parametrize(
    ("name", "suffix", "change"),
    [
        ("quartic", "s", lambda expr: expr.subs(sp.sqrt(nt.x**2 - nt.a**2), nt.x)),
        ("rounded_punch", "P", lambda expr: expr.subs(sp.acos(nt.b / nt.a), sp.asin(nt.b / nt.a))),
        ("truncated_wedge", "p", lambda expr: expr.replace(sp.atanh, sp.asinh)),
    ],
)
def test_a_wrong_formula_is_seen(
    name: str, suffix: str, change: Callable[[sp.Expr], sp.Expr], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The comparison is made with the entries of the engine, the module from a corrupted one."""
    wrong = entries(name) | {suffix: mutant(entries(name)[suffix], change)}
    written(tmp_path, "mutated_plane", {f"axicontact/plane/{name}.py": module_source(wrong)})
    (tmp_path / "mutated_plane" / "plane" / "__init__.py").write_text("")
    monkeypatch.syspath_prepend(str(tmp_path))
    for found in [found for found in sys.modules if found.startswith("mutated_plane")]:
        monkeypatch.delitem(sys.modules, found)
    module, draw = import_module(f"mutated_plane.plane.{name}"), random.Random(5)
    with mp.workdps(60):
        values = ready(module, name, state(name, draw), suffix, draw)
        assert not error(module, name, values, suffix) < 1e3 * ACCURACY
