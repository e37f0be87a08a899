"""What a caller relies on: broadcasting, types, NaN and infinities, messages - over all modules by introspection."""

from __future__ import annotations

import math
import warnings
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from axicontact._runtime.special import PeakPressure
from axiderive.profiles import COMPACT_NAMES, COMPLETE_NAMES, NAMES

PARAMETERS: dict[str, dict[str, Any]] = {
    "cone": {"theta": 0.35},
    "paraboloid": {"R": 1.6},
    "quartic": {"A": 0.4},
    "sextic": {"A": 0.4},
    "power_law": {"A": 0.45, "n": 1.5},
    "polynomial": {"A": (0.1, 0.25, 0.0, 0.05)},
    "sphere": {"R": 1.5},
    "ellipsoid": {"h": 0.9, "b": 1.5},
    "hyperboloid": {"theta": 0.42, "b": 0.4},
    "truncated_cone": {"theta": 0.42, "b": 0.5},
    "truncated_paraboloid": {"R": 1.2, "b": 0.5},
    "rounded_cone": {"theta": 0.42, "b": 0.5},
    "capped_paraboloid": {"R1": 4.0, "R2": 1.0, "b": 0.5},
    "rounded_punch": {"R": 1.45, "b": 0.5},
    "rounded_curved_punch": {"R1": 6.0, "R2": 1.2, "b": 0.6},
    "sphere_tipped_cone": {"R": 1.2, "theta": 0.45},
    "wavy_paraboloid": {"R": 1.6, "h": 0.01, "wavelength": 0.5},
    "gaussian": {"h": 0.7, "s": 1.0},
    "flat_punch": {"a": 1.0},
    "capped_cylinder": {"a": 1.0, "R": 2.2},
    "concave_power": {"a": 1.0, "h": 0.15, "n": 3.0},
    "concave_paraboloid": {"a": 1.0, "h": 0.15},
    "concave_quartic": {"a": 1.0, "h": 0.15},
}
SMALLEST = {"truncated_cone": 0.5, "truncated_paraboloid": 0.5, "rounded_punch": 0.5}
GEOMETRY_ONLY = ("profile", "depth", "displacement", "radius_from_depth", "zero_radius", "minimum_depth")
FIELD = {"a": 0.9, "r": 0.4, "d": 0.6, "F": 0.8}
ROUND_TRIP = 32 * np.finfo(float).eps


def keywords(name: str, function: str) -> dict[str, Any]:
    material = {} if function in GEOMETRY_ONLY else {"E_star": 1.0}
    return PARAMETERS[name] | material


def functions(name: str) -> list[tuple[str, Any, list[str]]]:
    from test_modules import positional, public

    module = import_module(f"axicontact.normal.{name}")
    found = []
    for key, signature in public(name).items():
        several = PeakPressure._fields if signature.return_annotation == "PeakPressure" else ("",)
        found += [(key, result(getattr(module, key), member), positional(signature)) for member in several]
    return found


def result(function: Any, member: str) -> Any:
    """The function, or one of its several results as a function of its own."""
    return (lambda *fields, **given: getattr(function(*fields, **given), member)) if member else function


def call(name: str, function: str, *fields: Any) -> Any:
    return getattr(import_module(f"axicontact.normal.{name}"), function)(*fields, **keywords(name, function))


def test_every_profile_has_parameters_here() -> None:
    assert set(PARAMETERS) == set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_float_in_float_out_array_in_array_out(name: str) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for key, function, fields in functions(name):
            values = [FIELD[field] for field in fields]
            single = function(*values, **keywords(name, key))
            assert type(single) is float, key
            if not fields:
                continue
            columns = [np.full((3, 1), values[0]), *(np.full(2, value) for value in values[1:])]
            before = [column.copy() for column in columns]
            result = function(*columns, **keywords(name, key))
            assert result.shape == ((3, 2) if len(fields) > 1 else (3, 1)), key
            assert result.dtype == np.float64
            np.testing.assert_allclose(result, single, rtol=8 * np.finfo(float).eps)
            for column, copy in zip(columns, before, strict=True):
                np.testing.assert_array_equal(column, copy)


@pytest.mark.parametrize("name", NAMES)
def test_lists_integers_and_long_arrays(name: str) -> None:
    long = np.linspace(0.51, 0.95, 40_001)
    for key, function, fields in functions(name):
        if not fields:
            continue
        rest = [FIELD[field] for field in fields[1:]]
        result = function(long, *rest, **keywords(name, key))
        few = function(list(long[::8000]), *rest, **keywords(name, key))
        np.testing.assert_allclose(result[::8000], few, rtol=16 * np.finfo(float).eps)
        assert function(np.array([], dtype=float), *rest, **keywords(name, key)).shape == (0,)
        assert type(function(1, *rest, **keywords(name, key))) is float


@pytest.mark.parametrize("name", NAMES)
def test_nan_for_fields_outside(name: str) -> None:
    for key, function, fields in functions(name):
        for position in range(len(fields)):
            for wrong in (-1.0, math.nan, -1e-300):
                values = [FIELD[field] for field in fields]
                values[position] = wrong
                assert math.isnan(function(*values, **keywords(name, key))), (key, wrong)


@pytest.mark.parametrize("name", [n for n in COMPACT_NAMES if n not in SMALLEST])
def test_zero_is_exact(name: str) -> None:
    for function in ("depth", "force", "stiffness", "radius_from_depth", "radius_from_force", "force_from_depth"):
        assert call(name, function, 0.0) == 0.0, function
    assert call(name, "depth_from_force", 0.0) == 0.0
    assert call(name, "pressure", 0.3, 0.0) == 0.0
    assert call(name, "displacement", 0.3, 0.0) == 0.0
    assert call(name, "displacement", 0.0, 0.0) == 0.0
    assert math.isfinite(call(name, "mean_pressure", 0.0))


@pytest.mark.parametrize("name", SMALLEST)
def test_truncated_profiles_start_at_the_face(name: str) -> None:
    b = SMALLEST[name]
    assert call(name, "depth", b) == 0.0
    assert call(name, "force", b) == 0.0
    assert call(name, "pressure", 0.3, b) == 0.0
    assert call(name, "radius_from_depth", 0.0) == b
    assert call(name, "radius_from_force", 0.0) == b
    assert call(name, "force_from_depth", 0.0) == 0.0
    for function in ("depth", "force", "mean_pressure"):
        with pytest.raises(ValueError, match=r"a = 0\.4 is below b = 0\.5: .* use normal\.flat_punch"):
            call(name, function, 0.4)
        few = call(name, function, np.array([0.4, 0.9]))
        assert math.isnan(few[0]), function
        assert few[1] == call(name, function, 0.9)
    for function in ("pressure", "displacement"):
        with pytest.raises(ValueError, match="below b"):
            call(name, function, 0.7, 0.4)
        assert np.isnan(call(name, function, 0.7, np.array([0.4, 0.9]))).tolist() == [True, False]


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_pressure_ends_at_the_edge(name: str) -> None:
    assert call(name, "pressure", 0.9, 0.9) == 0.0
    assert call(name, "pressure", 1.3, 0.9) == 0.0


def test_true_singularities_are_infinite() -> None:
    assert call("cone", "pressure", 0.0, 0.9) == math.inf
    assert call("flat_punch", "pressure", 1.0, 0.5) == math.inf
    assert call("truncated_cone", "pressure", 0.5, 0.9) == math.inf
    assert call("truncated_paraboloid", "pressure", 0.5, 0.9) == math.inf
    assert call("capped_paraboloid", "pressure", 0.5, 0.9) == math.inf
    assert math.isfinite(call("rounded_punch", "pressure", 0.5, 0.9))
    assert math.isfinite(call("rounded_cone", "pressure", 0.5, 0.9))


def test_sphere_at_the_equator_and_beyond() -> None:
    for function in ("depth", "force", "mean_pressure"):
        assert call("sphere", function, 1.5) == math.inf, function
        assert math.isnan(call("sphere", function, 1.6))
    assert call("sphere", "pressure", 0.4, 1.5) == math.inf
    assert math.isnan(call("sphere", "pressure", 0.4, 1.6))
    assert call("sphere", "radius_from_depth", math.inf) == 1.5


def test_gaussian_beyond_its_largest_contact() -> None:
    largest = 1.5019752682682
    assert math.isnan(call("gaussian", "depth", 1.51))
    assert math.isnan(call("gaussian", "pressure", 0.4, 1.51))
    top = call("gaussian", "depth", largest)
    assert math.isnan(call("gaussian", "radius_from_depth", top * 1.001))
    assert call("gaussian", "radius_from_depth", top * 0.999) < largest


def test_gaussian_next_to_its_largest_contact() -> None:
    """There depth and force no longer grow, and their rounding hides which of two radii gave the larger one."""
    module, dice = import_module("axicontact.normal.gaussian"), np.random.default_rng(3)
    for _ in range(60):
        h, s = 10 ** dice.uniform(-3.0, 3.0, 2)
        a = 1.5019752682686 * s * (1.0 - 10 ** dice.uniform(-15.9, -6.0, 20))
        for load, radius in (("depth", "radius_from_depth"), ("force", "radius_from_force")):
            modulus = {"E_star": 1.0} if load == "force" else {}
            value = getattr(module, load)(a, h=h, s=s, **modulus)
            found = getattr(module, radius)(value, h=h, s=s, **modulus)
            assert np.isfinite(found).all(), (h, s, load)
            np.testing.assert_allclose(getattr(module, load)(found, h=h, s=s, **modulus), value, rtol=2.0**-48)


def test_capped_cylinder_joins_its_branches() -> None:
    edge = 1.0 / 2.2
    below, above = edge * (1 - 1e-13), edge * (1 + 1e-13)
    for function in ("force", "stiffness"):
        assert call("capped_cylinder", function, below) == pytest.approx(
            call("capped_cylinder", function, above), rel=1e-12
        )
    assert call("capped_cylinder", "pressure", 1.0, 2 * edge) == math.inf
    assert call("capped_cylinder", "pressure", 0.9, edge / 2) == 0.0
    assert call("capped_cylinder", "displacement", 0.9, edge / 2) > edge / 2 - 0.81 / 4.4


@pytest.mark.parametrize("name", ["concave_power", "concave_paraboloid", "concave_quartic"])
def test_concave_faces_start_at_the_threshold(name: str) -> None:
    least, force = call(name, "minimum_depth"), call(name, "minimum_force")
    assert call(name, "force", least) == pytest.approx(force, rel=1e-14, abs=0.0)
    assert math.isnan(call(name, "force", least * (1 - 1e-9)))
    assert math.isnan(call(name, "depth_from_force", force * (1 - 1e-9)))
    ring = call(name, "zero_radius")
    radii = np.linspace(0.0, 0.999, 2001)
    pressures = call(name, "pressure", radii, least)
    scale = call(name, "pressure", 0.9, least)
    assert abs(call(name, "pressure", ring, least)) < 1e-12 * scale
    assert pressures.min() > -1e-12 * scale
    assert abs(radii[pressures.argmin()] - ring) < 1e-3


@pytest.mark.parametrize("name", COMPLETE_NAMES)
@given(d=st.floats(0.3, 1e3))
@settings(max_examples=20)
def test_complete_contact_round_trip(name: str, d: float) -> None:
    force = call(name, "force", d)
    if not math.isnan(force):
        assert call(name, "depth_from_force", force) == pytest.approx(d, rel=ROUND_TRIP, abs=0.0)


@pytest.mark.parametrize("name", COMPACT_NAMES)
@given(x=st.floats(1e-4, 0.9999))
@settings(max_examples=25)
def test_round_trips(name: str, x: float) -> None:
    b = SMALLEST.get(name)
    a = (1.0 + x) * b if b else 1.45 * x
    d, force = call(name, "depth", a), call(name, "force", a)
    assert call(name, "force_from_depth", d) == pytest.approx(force, rel=ROUND_TRIP, abs=0.0)
    assert call(name, "depth_from_force", force) == pytest.approx(d, rel=ROUND_TRIP, abs=0.0)
    # near its largest contact the depth of the bump is flat, and so is what the radius can be
    loose = 1e-6 if name == "gaussian" else ROUND_TRIP
    assert call(name, "radius_from_depth", d) == pytest.approx(a, rel=loose, abs=0.0)
    assert call(name, "radius_from_force", force) == pytest.approx(a, rel=loose, abs=0.0)


@pytest.mark.parametrize("name", COMPACT_NAMES)
@given(x=st.floats(1e-3, 0.99), y=st.floats(0.0, 0.999))
@settings(max_examples=25)
def test_depth_grows_and_nothing_pulls(name: str, x: float, y: float) -> None:
    b = SMALLEST.get(name)
    a = (1.0 + x) * b if b else 1.45 * x
    assert call(name, "depth", a * 1.001) > call(name, "depth", a)
    assert call(name, "pressure", y * a, a) >= 0.0
    assert call(name, "displacement", a * 1.001, a) < call(name, "displacement", a * 0.999, a)


@pytest.mark.parametrize("name", NAMES)
def test_surface_is_continuous_at_the_edge(name: str) -> None:
    field, edge = (0.9, 0.9) if name in COMPACT_NAMES else (0.6, 1.0)
    inside, outside = (call(name, "displacement", edge * (1 + side * 1e-12), field) for side in (-1, 1))
    assert inside == pytest.approx(outside, abs=2e-6)


BAD = [
    ("cone", {"theta": 0.0}, r"theta = 0\.0 is outside 0 < theta < pi/2; theta is the inclination"),
    ("cone", {"theta": 1.6}, "outside 0 < theta < pi/2"),
    ("cone", {"theta": math.nan}, "theta = nan"),
    ("sphere", {"R": -1.0}, r"R = -1\.0 is outside R > 0"),
    ("power_law", {"n": 0.0}, r"n = 0\.0 is outside n > 0"),
    ("polynomial", {"A": (0.0, 0.0)}, "none negative and not all zero"),
    ("polynomial", {"A": (1.0, -1.0)}, "none negative"),
    ("capped_paraboloid", {"R1": 1.0, "R2": 2.0}, r"^R1 = 1\.0, R2 = 2\.0: R2 <= R1 is violated; .*exchange R1 and R2"),
    ("wavy_paraboloid", {"h": 1.0}, "lower h or lengthen the wave"),
    ("concave_power", {"n": 1.0}, "use n > 1"),
    ("flat_punch", {"a": 0.0}, r"a = 0\.0 is outside a > 0"),
]


@pytest.mark.parametrize(("name", "wrong", "message"), BAD)
def test_bad_parameters_name_value_rule_and_next_step(name: str, wrong: dict[str, Any], message: str) -> None:
    function = getattr(import_module(f"axicontact.normal.{name}"), "pressure")  # noqa: B009
    with pytest.raises(ValueError, match=message):
        function(0.4, 0.9, **(keywords(name, "pressure") | wrong))


def test_bad_modulus_and_bad_types() -> None:
    from axicontact.normal import cone

    with pytest.raises(ValueError, match=r"E_star = 0\.0 is outside E_star > 0"):
        cone.force(0.9, theta=0.3, E_star=0.0)
    with pytest.raises(TypeError, match="theta must be a real number"):
        cone.depth(0.9, theta="0.3")
    with pytest.raises(TypeError, match="real number"):
        cone.depth("0.9", theta=0.3)


def test_arrays_of_parameters_broadcast() -> None:
    from axicontact.normal import rounded_punch

    R = np.array([1.0, 2.0, 3.0])
    together = rounded_punch.pressure(0.4, np.full((2, 1), 0.9), R=R, b=0.5, E_star=1.0)
    apart = [rounded_punch.pressure(0.4, 0.9, R=value, b=0.5, E_star=1.0) for value in R]
    np.testing.assert_allclose(together, [apart, apart], rtol=1e-14)


def test_a_message_about_many_numbers_is_short() -> None:
    from axicontact.tangential import cone

    with pytest.raises(
        ValueError, match=r"a = \[0\.5, 0\.5, 0\.5, \.\.\.\], 5000 numbers: c <= a is violated"
    ) as caught:
        cone.tangential_force(np.full(5000, 0.5), 0.7, theta=0.3, E_star=1.0, mu=0.3)
    assert len(str(caught.value)) < 250
    with pytest.raises(ValueError, match=r"c = 0\.7, a = \[0\.5, 0\.9\]: c <= a is violated"):
        cone.tangential_force([0.5, 0.9], 0.7, theta=0.3, E_star=1.0, mu=0.3)
