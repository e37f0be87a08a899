"""The formulas over other array libraries: the same values, gradients without NaN, a word where there is none."""

from __future__ import annotations

import ast
import doctest
import itertools
import math
import pickle
from collections import Counter
from inspect import signature
from pathlib import Path

import numpy as np
import pytest
from selected import few, in_turn
from test_quantities import called, functions, values

from axicontact import adhesive, expressions, graded, normal, tangential
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


CURVES = {
    "polynomial": (normal.polynomial, {"A": (0.1, 0.0, 0.3, 0.02)}),
    "sphere_tipped_cone": (normal.sphere_tipped_cone, {"R": 3.0, "theta": 0.35}),
    "wavy_paraboloid": (normal.wavy_paraboloid, {"R": 3.0, "h": 0.01, "wavelength": 1.0}),
    "graded cone": (graded.normal.cone, {"theta": 0.35, "k": -0.6}),
    "graded capped_paraboloid": (graded.normal.capped_paraboloid, {"R1": 3.0, "R2": 2.0, "b": 1.0, "k": 0.3}),
    "graded polynomial": (graded.normal.polynomial, {"A": (0.1, 0.0, 0.3, 0.02), "k": 0.3}),
    "graded rounded_punch": (graded.normal.rounded_punch, {"R": 3.0, "b": 1.0, "k": -0.6}),
    "graded wavy_paraboloid": (graded.normal.wavy_paraboloid, {"R": 3.0, "h": 0.01, "wavelength": 1.0, "k": 0.3}),
}
"""Curves with breaks, waves or several powers, and those whose numbers are sums themselves."""


@pytest.mark.parametrize("name", CURVES)
def test_roots_without_known_slopes_halve_brackets(name):
    module, geometry = CURVES[name]
    x = 10.0 ** np.linspace(-6.0, 3.0, 70)
    for own in ("radius_from_depth", "radius_from_force", "force_from_depth", "depth_from_force"):
        function = getattr(module, own)
        keywords = geometry | {own: E_star for own in ("E_star", "H") if own in signature(function).parameters}
        with np.errstate(all="ignore"):
            got = expression(function, np)(x, **keywords)
        np.testing.assert_allclose(got, function(x, **keywords), rtol=1e-12, err_msg=own)
        assert math.isclose(expression(function, np)(float(x[40]), **keywords), got[40], rel_tol=1e-13)


STABLE = {
    "capped_paraboloid": {"R1": 3.0, "R2": 0.7, "b": 1.0},
    "gaussian": {"h": 2.0, "s": 9.0},
    "hyperboloid": {"theta": 0.35, "b": 1.0},
    "paraboloid": {"R": 3.0},
    "polynomial": {"A": (0.1, 0.0, 0.3, 0.02)},
    "rounded_punch": {"R": 3.0, "b": 1.0},
    "sphere": {"R": 3.0},
    "sphere_tipped_cone": {"R": 3.0, "theta": 0.35},
    "wavy_paraboloid": {"R": 3.0, "h": 0.01, "wavelength": 1.0},
}


MATERIALS = list(itertools.product([1e-4, 0.3], [None, -0.6, 0.3]))


@pytest.mark.parametrize(
    ("name", "dgamma", "k"),
    few(
        [(name, *material) for name in STABLE for material in MATERIALS],
        [(name, *material) for name, material in in_turn(2 * list(STABLE), MATERIALS)],
        pytest.mark.slow,
    ),
)
def test_stable_radii_end_where_the_function_ends(name, dgamma, k):
    """On either side of pull-off, where there are two branches too; there is no radius below the least load."""
    physics, material = (adhesive, {"E_star": E_star}) if k is None else (graded.adhesive, {"H": E_star, "k": k})
    module, x = getattr(physics, name), 10.0 ** np.linspace(-5.0, 2.0, 40)
    loads, keywords = np.concatenate([-x[::-1], x]), STABLE[name] | material | {"dgamma": dgamma}
    for own in ("radius_from_depth", "radius_from_force"):
        function = getattr(module, own)
        with np.errstate(all="ignore"):
            got = expression(function, np)(loads, **keywords)
        wanted = function(loads, **keywords)
        assert np.isnan(wanted).any() or name in ("gaussian", "sphere"), own
        np.testing.assert_allclose(got, wanted, rtol=1e-11, err_msg=own)


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


SLOPES = {
    "polynomial": (normal.polynomial.force_from_depth, CURVES["polynomial"][1], 0.4),
    "sphere_tipped_cone": (normal.sphere_tipped_cone.radius_from_force, CURVES["sphere_tipped_cone"][1], 0.01),
    "a tip below its break": (
        graded.normal.capped_paraboloid.radius_from_depth,
        CURVES["graded capped_paraboloid"][1],
        0.1,
    ),
    "a tip beyond it": (graded.normal.capped_paraboloid.depth_from_force, CURVES["graded capped_paraboloid"][1], 9.0),
    "waves": (normal.wavy_paraboloid.radius_from_depth, CURVES["wavy_paraboloid"][1], 0.4),
    "stable": (adhesive.hyperboloid.radius_from_force, STABLE["hyperboloid"] | {"dgamma": 0.3}, -0.5),
    "stable and graded": (graded.adhesive.cone.radius_from_depth, {"theta": 0.35, "k": 0.3, "dgamma": 0.3}, 0.1),
}


@pytest.mark.parametrize("name", SLOPES)
def test_slopes_of_roots_in_jax(name):
    """By the load, twice, and by all parameters at once."""
    jax = pytest.importorskip("jax", reason="gradients are tested where JAX is installed: pip install jax")
    jax.config.update("jax_enable_x64", True)
    function, geometry, x = SLOPES[name]
    material = {"H" if "k" in geometry else "E_star": E_star}
    keywords = (
        geometry if function.__name__ == "radius_from_depth" and "dgamma" not in geometry else geometry | material
    )
    formula = expression(function, jax.numpy)
    step = 1e-3 * abs(x)
    low, middle, high = (function(x + side * step, **keywords) for side in (-1.0, 0.0, 1.0))
    slope = jax.grad(lambda at: formula(at, **keywords))
    assert math.isclose(jax.jit(slope)(x), (high - low) / (2.0 * step), rel_tol=1e-5)
    assert math.isclose(jax.jit(jax.grad(slope))(x), (high - 2.0 * middle + low) / step**2, rel_tol=1e-3)
    numbers = {own: value for own, value in keywords.items() if isinstance(value, float)}
    for own, got in jax.jit(jax.grad(lambda given: formula(x, **(keywords | given))))(numbers).items():
        high, low = (function(x, **keywords | {own: numbers[own] * (1.0 + side)}) for side in (1e-5, -1e-5))
        assert math.isclose(got, (high - low) / (2e-5 * numbers[own]), rel_tol=1e-5, abs_tol=1e-8), own


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
    with pytest.raises(TypeError, match=r"polynomial\.traction needs more than sums and steps"):
        expression(tangential.polynomial.traction, np)
    with pytest.raises(TypeError, match=r"paraboloid\.pull_off gives several numbers"):
        expression(adhesive.paraboloid.pull_off, np)
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
            assert "take " in str(error), key
            continue
        numbers, _ = values(function)
        given = {name: np.asarray(number) for name, number in numbers.items()}
        with np.errstate(all="ignore"):
            got = called(found, given)
        np.testing.assert_allclose(got, called(function, given), rtol=1e-12, err_msg=key)
        works += 1
    assert works > 1170


def test_no_name_of_a_module_is_that_of_two_functions_or_of_an_argument() -> None:
    """Names come from all modules of the run time: another one in their place would be called in silence."""
    for path in (Path(expressions.__file__).parent / "_programs" / "expressions").rglob("*.py"):
        tree = ast.parse(path.read_text())
        imported = [own for node in tree.body if isinstance(node, ast.ImportFrom) for own in node.names]
        functions = [node.name for node in tree.body if isinstance(node, ast.FunctionDef)]
        names = Counter([own.asname or own.name for own in imported] + functions)
        assert not [name for name, count in names.items() if count > 1], path
        assert not names.keys() & {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}, path


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
