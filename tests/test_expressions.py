"""The formulas over other array libraries: the same values, gradients without NaN, a word where there is none."""

from __future__ import annotations

import doctest
import math
import pickle

import numpy as np
import pytest
from test_quantities import called, functions, values

from axicontact import expressions
from axicontact.expressions import expression
from axicontact.normal import (
    capped_paraboloid,
    cone,
    gaussian,
    hyperboloid,
    paraboloid,
    power_law,
    rounded_cone,
    rounded_punch,
    sphere,
    truncated_cone,
    wavy_paraboloid,
)

a, E_star = 2.0, 1.5
CASES = {
    "cone.pressure": (cone.pressure, (0.3, 1.9, 2.5), (a,), {"theta": 0.35, "E_star": E_star}),
    "cone.displacement": (cone.displacement, (0.3, 1.9, 2.5), (a,), {"theta": 0.35}),
    "paraboloid.pressure": (paraboloid.pressure, (0.3, 1.9, 2.5), (a,), {"R": 3.0, "E_star": E_star}),
    "paraboloid.displacement": (paraboloid.displacement, (0.3, 1.9, 2.5), (a,), {"R": 3.0}),
    "sphere.force": (sphere.force, (0.1, 1.0, 2.9), (), {"R": 3.0, "E_star": E_star}),
    "truncated_cone.depth": (truncated_cone.depth, (1.1, 1.5, 8.0), (), {"theta": 0.35, "b": 1.0}),
    "rounded_punch.force": (rounded_punch.force, (1.01, 1.5, 8.0), (), {"R": 3.0, "b": 1.0, "E_star": E_star}),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_an_expression_has_the_values_of_its_function(name):
    function, x, rest, keywords = CASES[name]
    got = expression(function, np)(np.array(x), *rest, **keywords)
    np.testing.assert_allclose(got, function(np.array(x), *rest, **keywords), rtol=4e-16)
    assert math.isclose(expression(function, np)(x[0], *rest, **keywords), got[0], rel_tol=4e-16)


ROOTS = {
    "capped_paraboloid": (capped_paraboloid, {"R1": 3.0, "R2": 2.0, "b": 1.0}),
    "hyperboloid": (hyperboloid, {"theta": 0.35, "b": 1.0}),
    "rounded_cone": (rounded_cone, {"theta": 0.35, "b": 1.0}),
    "rounded_punch": (rounded_punch, {"R": 3.0, "b": 1.0}),
    "truncated_cone": (truncated_cone, {"theta": 0.35, "b": 1.0}),
}


@pytest.mark.parametrize("name", ROOTS)
def test_roots_are_a_few_steps_of_newton(name):
    """Over 24 decades, as near to the function as rounding allows."""
    module, geometry = ROOTS[name]
    x = 10.0 ** np.linspace(-12.0, 12.0, 200)
    for own, keywords in (
        ("radius_from_depth", geometry),
        ("radius_from_force", geometry | {"E_star": E_star}),
        ("force_from_depth", geometry | {"E_star": E_star}),
        ("depth_from_force", geometry | {"E_star": E_star}),
    ):
        function = getattr(module, own)
        np.testing.assert_allclose(expression(function, np)(x, **keywords), function(x, **keywords), rtol=1e-15)


RULES = {
    "gaussian.pressure": (gaussian.pressure, {"h": 2.0, "s": 9.0, "E_star": E_star}),
    "hyperboloid.pressure": (hyperboloid.pressure, {"theta": 0.35, "b": 1.0, "E_star": E_star}),
    "power_law.displacement": (power_law.displacement, {"A": 0.2, "n": 2.7}),
    "rounded_punch.displacement": (rounded_punch.displacement, {"R": 3.0, "b": 1.0}),
}


@pytest.mark.parametrize("name", RULES)
def test_rules_are_sums_over_fixed_nodes(name):
    """From next to the axis to far away, for any shapes of radius and contact."""
    function, keywords = RULES[name]
    r, radii = 10.0 ** np.linspace(-3.0, 2.0, 60), np.array([[1.01], [2.0], [5.0]])
    np.testing.assert_allclose(
        expression(function, np)(r, radii, **keywords), function(r, radii, **keywords), rtol=2e-14
    )


@pytest.mark.parametrize("name", RULES)
def test_gradients_of_rules_in_jax(name):
    jax = pytest.importorskip("jax", reason="gradients are tested where JAX is installed: pip install jax")
    jax.config.update("jax_enable_x64", True)
    function, keywords = RULES[name]
    slope = jax.jit(jax.vmap(jax.grad(lambda r: expression(function, jax.numpy)(r, a, **keywords))))
    r, step = np.array([0.3, 1.3, 2.5, 9.0]), 1e-6
    wanted = (function(r + step, a, **keywords) - function(r - step, a, **keywords)) / (2.0 * step)
    np.testing.assert_allclose(slope(r), wanted, rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("name", ROOTS)
def test_the_slope_of_a_force_curve_in_jax(name):
    """dF/dd = 2 E* a: through the steps of the root."""
    jax = pytest.importorskip("jax", reason="gradients are tested where JAX is installed: pip install jax")
    jax.config.update("jax_enable_x64", True)
    module, geometry = ROOTS[name]
    force = expression(module.force_from_depth, jax.numpy)
    slope = jax.vmap(jax.grad(lambda d: force(d, **geometry, E_star=E_star)))
    d = np.array([0.01, 0.3, 2.0, 40.0])
    wanted = 2.0 * E_star * module.radius_from_depth(d, **geometry)
    np.testing.assert_allclose(jax.jit(slope)(d), wanted, rtol=1e-12)


@pytest.mark.parametrize("name", CASES)
def test_no_branch_is_evaluated_where_it_does_not_apply(name):
    """A root of a negative number in the other branch is what makes a gradient NaN."""
    function, x, rest, keywords = CASES[name]
    with np.errstate(all="raise"):
        expression(function, np)(np.array(x), *rest, **keywords)


def test_the_example_is_right():
    assert doctest.testmod(expressions).failed == 0


def test_a_single_where_would_be_noticed():
    def single(r):
        return np.where(r < a, np.sqrt((a - r) * (a + r)), 0.0)

    with np.errstate(all="raise"), pytest.raises(FloatingPointError):
        single(np.array([0.3, 2.5]))


def test_what_is_no_expression_says_so():
    with pytest.raises(TypeError, match=r"wavy_paraboloid\.radius_from_force needs more than sums and a few steps"):
        expression(wavy_paraboloid.radius_from_force, np)
    with pytest.raises(TypeError, match="no function with a formula of its own"):
        expression(np.sin, np)
    with pytest.raises(TypeError, match="has no function"):
        expression(paraboloid.pressure, object())(0.3, a, R=3.0, E_star=E_star)


def test_every_function_is_refused_at_once_or_works() -> None:
    """114 were accepted and failed when called: sums of rules, and graphs that hold for all but a rare branch."""
    works = 0
    for key, function in functions():
        try:
            found = expression(function, np)
        except TypeError as error:
            assert "take one" in str(error), key
            continue
        numbers, _ = values(function)
        given = {name: np.asarray(number) for name, number in numbers.items()}
        with np.errstate(all="ignore"):
            got = called(found, given)
        np.testing.assert_allclose(got, called(function, given), rtol=1e-12, err_msg=key)
        works += 1
    assert works > 450


def test_a_library_without_a_function_is_refused_at_once() -> None:
    with pytest.raises(TypeError, match="has no function .*; take a library with"):
        expression(paraboloid.pressure, object())


@pytest.mark.parametrize("name", CASES)
def test_expressions_are_pickled(name):
    """As a pool of processes asks for."""
    function, x, rest, keywords = CASES[name]
    found = expression(function, np)
    again = pickle.loads(pickle.dumps(found))
    np.testing.assert_array_equal(again(np.array(x), *rest, **keywords), found(np.array(x), *rest, **keywords))
    assert again.__doc__ == function.__doc__


@pytest.mark.parametrize("name", CASES)
def test_gradients_in_jax(name):
    """Against a central difference of the function itself, in double precision; outside the contact they are finite."""
    jax = pytest.importorskip("jax", reason="gradients are tested where JAX is installed: pip install jax")
    jax.config.update("jax_enable_x64", True)
    function, x, rest, keywords = CASES[name]
    formula = expression(function, jax.numpy)
    for point in map(float, x):
        slope = float(jax.grad(lambda at: formula(at, *rest, **keywords))(point))
        step = 1e-5 * point
        high, low = (function(point + side * step, *rest, **keywords) for side in (1.0, -1.0))
        assert math.isclose(slope, (high - low) / (2 * step), rel_tol=1e-6, abs_tol=1e-12)
    many = np.array(x)
    compiled = jax.jit(lambda at: formula(at, *rest, **keywords))(many)
    np.testing.assert_allclose(compiled, function(many, *rest, **keywords), rtol=1e-14)
