"""The two other kinds of numbers the formulas run on: plain ones through `math`, and those without a range."""

from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable, Iterator

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from written import needs_arrays

from axicontact._programs.bodies.normal import rounded_punch as bodies
from axicontact._runtime import integrals
from axicontact._runtime.arrays.extended import Extended, extended
from axicontact._runtime.functions import difference_of_products, lower_power, nth_root, without_root
from axicontact._runtime.plain import MATH
from axicontact.layer import sphere as on_layer
from axicontact.normal import cone, paraboloid, rounded_punch, sphere, truncated_cone
from axiderive.notation import LENGTH, describe
from axiderive.profiles import load

EPS = np.finfo(float).eps
TWO_ULP, FOUR_ULP = 2 * EPS, 4 * EPS
pytestmark = pytest.mark.usefixtures("silence")
EXPONENTS = st.integers(-3000, 3000)
MANTISSAS = st.floats(0.5, 0.999999)


@pytest.fixture(scope="module")
def silence() -> Iterator[None]:
    """As `elementwise` sees to."""
    with np.errstate(all="ignore"):
        yield


def exact(x: Extended) -> mp.mpf:
    return mp.ldexp(mp.mpf(float(x.mantissa)), int(x.exponent))


def close(got: Extended, wanted: mp.mpf, tolerance: float) -> bool:
    return bool(abs(exact(got) - wanted) <= tolerance * abs(wanted))


@given(MANTISSAS, EXPONENTS, MANTISSAS, st.integers(-60, 60))
@settings(max_examples=200)
def test_arithmetic_without_a_range(x: float, e: int, y: float, shift: int) -> None:
    a, b = Extended(x, e), Extended(y, e + shift)
    with mp.workdps(60):
        p, q = exact(a), exact(b)
        assert close(a + b, p + q, EPS)
        assert close(a * b, p * q, EPS)
        assert close(a / b, p / q, EPS)
        assert close(np.sqrt(a), mp.sqrt(p), EPS)
        assert close(np.cbrt(a), mp.cbrt(p), TWO_ULP)
        assert close(a - b, p - q, EPS) or p == q
        assert bool(a < b) == (p < q)
        assert bool(np.maximum(a, b) >= np.minimum(a, b))
        assert abs(float(np.asarray(np.log(a)))) == pytest.approx(float(abs(mp.log(p))), rel=FOUR_ULP, abs=EPS)


@given(MANTISSAS, st.integers(-3000, 3000), st.floats(0.001, 12.0))
@settings(max_examples=200)
def test_powers_without_a_range(x: float, e: int, n: float) -> None:
    a = Extended(x, e)
    with mp.workdps(60):
        assert close(a**n, exact(a) ** mp.mpf(n), FOUR_ULP)
        assert close(nth_root(a, 5), mp.root(exact(a), 5), FOUR_ULP)


@pytest.mark.parametrize("name", ["arcsinh", "arctan", "log1p", "tanh", "sin", "expm1", "sinh", "cosh", "exp"])
def test_functions_without_a_range(name: str) -> None:
    names = {"arcsinh": "asinh", "arctan": "atan"}
    for value in (mp.mpf("1e-700"), mp.mpf("1e-20"), mp.mpf("0.3"), mp.mpf(7), mp.mpf(900), mp.mpf("1e600")):
        if name in ("sin", "expm1", "sinh", "cosh", "exp") and value > 1000:
            continue
        mantissa, exponent = mp.frexp(value)
        x = Extended(float(mantissa), int(exponent))
        with mp.workdps(700):
            wanted = getattr(mp, names.get(name, name))(exact(x))
            assert close(getattr(np, name)(x), wanted, FOUR_ULP), (name, value)


def test_order_of_infinities() -> None:
    huge, infinite = Extended(0.5, 5000), extended(np.inf)
    assert bool(huge < infinite)
    assert not bool(infinite < infinite)
    assert bool(infinite >= infinite)


def test_a_difference_of_products_keeps_what_both_lose() -> None:
    x = 1.0 + 2.0**-30
    assert difference_of_products(x, x, 1.0 + 2.0**-29, 1.0) == 2.0**-60


@given(st.floats(1e-300, 1e300), st.sampled_from((3, 5, 7)))
def test_roots_are_not_those_of_a_rounded_exponent(x: float, n: int) -> None:
    with mp.workdps(40):
        root = mp.root(mp.mpf(x), n)
        assert abs(mp.mpf(float(nth_root(x, n))) / root - 1) < TWO_ULP
        assert abs(mp.mpf(float(without_root(x, n))) / (x / root) - 1) < TWO_ULP


def test_zero_and_infinity_of_roots_and_powers() -> None:
    ends = np.array([0.0, np.inf])
    with np.errstate(all="ignore"):
        np.testing.assert_array_equal(nth_root(ends, 5), ends)
        np.testing.assert_array_equal(without_root(ends, 5), ends)
        np.testing.assert_array_equal(lower_power(np.zeros(2), np.array([0.5, 1.0])), [np.inf, 1.0])


def test_plain_numbers_take_the_body_with_math() -> None:
    assert needs_arrays(on_layer._force)
    assert not needs_arrays(rounded_punch._force_from_depth)
    # a local variable may have the name of a function of NumPy: angle
    assert not needs_arrays(sphere._depth_at)
    assert integrals.np is np
    assert bodies.np is MATH
    assert type(bodies._force_from_depth(0.3, 2.0, 0.5, 2.0)) is float


def test_plain_numbers_pass_by_the_array_machinery(monkeypatch: pytest.MonkeyPatch) -> None:
    expected = cone.pressure(np.array([0.3]), 1.0, theta=0.4, E_star=2.0)
    cone.stiffness(1.0, theta=0.4, E_star=2.0)  # programs are imported with the first call
    monkeypatch.setattr(cone, "elementwise", None)
    value = cone.pressure(0.3, 1.0, theta=0.4, E_star=2.0)
    assert type(value) is float
    assert value == pytest.approx(expected[0], rel=4 * EPS, abs=0.0)
    assert cone.stiffness(1.0, theta=0.4, E_star=2.0) == 4.0, "an argument that the formula does not need"
    assert cone.pressure(1.5, 1.0, theta=0.4, E_star=2.0) == 0.0, "outside the contact nothing has underflowed"
    for r, a in ((0.0, 1.0), (1e-200, 1.0), (math.nan, 1.0), (np.float32(0.3), 1.0), (0.3, [1.0])):
        with pytest.raises(TypeError, match="NoneType"):
            cone.pressure(r, a, theta=0.4, E_star=2.0)


@pytest.mark.parametrize(
    ("call", "kind", "says"),
    [
        (lambda: cone.pressure(0.3, 1.0, theta=2.0, E_star=2.0), ValueError, "theta = 2.0 is outside"),
        (lambda: cone.pressure(0.3, 1.0, theta=0.4, E_star=-2.0), ValueError, "E_star = -2.0 is outside"),
        (lambda: cone.pressure(0.3, 1.0, theta=math.nan, E_star=2.0), ValueError, "theta = nan is outside"),
        (lambda: cone.pressure("0.3", 1.0, theta=0.4, E_star=2.0), TypeError, "a real number"),
        (lambda: cone.pressure(0.3, 1.0, theta=0.4), TypeError, "missing 1 required keyword-only argument: 'E_star'"),
        (lambda: rounded_punch.depth(0.4, R=2.0, b=0.5), ValueError, "a = 0.4 is below b = 0.5"),
    ],
)
def test_plain_numbers_are_refused_as_arrays_are(call: Callable[[], object], kind: type[Exception], says: str) -> None:
    with pytest.raises(kind, match=re.escape(says)):
        call()


def test_plain_numbers_and_arrays_agree() -> None:
    for x in np.linspace(0.51, 3.0, 40):
        for function, parameters in (
            (truncated_cone.force, {"theta": 0.3, "b": 0.5, "E_star": 2.0}),
            (rounded_punch.force_from_depth, {"R": 2.0, "b": 0.5, "E_star": 2.0}),
            (paraboloid.depth_from_force, {"R": 2.0, "E_star": 2.0}),
        ):
            single, (entry,) = function(float(x), **parameters), function(np.array([x]), **parameters)
            assert single == pytest.approx(entry, rel=8 * EPS, abs=0.0)


@given(st.floats(0.6, 0.999), st.floats(1.01, 50.0), st.integers(-18, 18))
def test_lengths_scaled_by_a_power_of_two(share: float, a: float, power: int) -> None:
    """Depth is a length and pressure is none, to the last bit."""
    scale = 2.0**power
    for module, parameters in (
        (cone, {"theta": 0.3}),
        (truncated_cone, {"theta": 0.3, "b": 1.0}),
        (rounded_punch, {"R": 3.0, "b": 1.0}),
        (sphere, {"R": 60.0}),
    ):
        profile = load(module.__name__.rpartition(".")[2])
        lengths = {str(s) for s in profile.parameters if describe(s).dimension == LENGTH}
        scaled = {name: value * scale if name in lengths else value for name, value in parameters.items()}
        assert module.depth(a * scale, **scaled) == scale * module.depth(a, **parameters)
        r = np.array([share * a])
        before = module.pressure(r, a, **parameters, E_star=1.0)
        np.testing.assert_array_equal(module.pressure(r * scale, a * scale, **scaled, E_star=1.0), before)


def test_the_ends_of_the_range_raise_no_warning() -> None:
    ends = np.array([0.0, 5e-324, 1e-308, 1e-200, 1.0, 1e200, 1e308, np.inf, np.nan])
    r, a = np.meshgrid(ends, ends)
    with warnings.catch_warnings(), np.errstate(all="warn"):
        warnings.simplefilter("error")
        for module, parameters in ((cone, {"theta": 1e-200}), (sphere, {"R": 1e308}), (paraboloid, {"R": 1e-300})):
            module.pressure(r, a, **parameters, E_star=1e10)
            module.displacement(r, a, **parameters)
            module.force_from_depth(ends, **parameters, E_star=1e-300)
    assert cone.depth(1e-300, theta=0.3) == pytest.approx(1e-300 * cone.depth(1.0, theta=0.3), rel=FOUR_ULP, abs=0.0)
    assert paraboloid.depth(1e-170, R=1e-100) == pytest.approx(1e-240, rel=FOUR_ULP, abs=0.0)
    assert paraboloid.depth(np.array([1e-170]), R=1e-100)[0] == pytest.approx(1e-240, rel=FOUR_ULP, abs=0.0)
