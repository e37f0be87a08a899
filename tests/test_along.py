"""Integrals at many radii of one contact: polynomials through few values of the rule, as good as the rule itself."""

from __future__ import annotations

from importlib import import_module

import numpy as np
import pytest

from axicontact._runtime import integrals

EPS = np.finfo(float).eps
CASES = [
    ("rounded_punch", {"R": 3.0, "b": 1.0}),
    ("capped_paraboloid", {"R1": 3.0, "R2": 2.0, "b": 1.0}),
    ("sphere", {"R": 30.0}),
    ("power_law", {"A": 0.5, "n": 2.7}),
    ("power_law", {"A": 0.5, "n": 0.6}),
    ("gaussian", {"h": 0.5, "s": 14.0}),
]
MOST = 12.0
"""Units of the last place: 10.7 is the most of 6e5 values at seven radii of contact, rule and polynomials together."""


@pytest.mark.parametrize("a", [1.05, 2.0, 20.0])
@pytest.mark.parametrize(("name", "parameters"), CASES)
def test_polynomials_are_as_good_as_the_rule(name: str, parameters: dict[str, float], a: float) -> None:
    """The rule is called where the contact radius varies, if only at one point."""
    module, rng = import_module(f"axicontact.normal.{name}"), np.random.default_rng(3)
    inside, outside = a * rng.uniform(0.0, 1.0, 3000), a * (1.0 + 10.0 ** rng.uniform(-4.0, 3.0, 3000))
    inside[:3], same, varying = (0.0, 1e-3, a), np.full(3000, a), np.full(3000, a)
    varying[-1] = np.nextafter(a, 0.0)
    for function, r, more in ((module.pressure, inside, {"E_star": 1.0}), (module.displacement, outside, {})):
        got, wanted = function(r, same, **parameters, **more), function(r, varying, **parameters, **more)
        np.testing.assert_allclose(got[:-1], wanted[:-1], rtol=MOST * EPS, atol=0.0)


@pytest.mark.parametrize("n", [1.2, 2.7, 40.0])
def test_polynomials_beside_a_hollow_face(n: float) -> None:
    module, rng = import_module("axicontact.normal.concave_power"), np.random.default_rng(3)
    r, same = 2.0 * (1.0 + 10.0 ** rng.uniform(-4.0, 3.0, 3000)), np.full(3000, 2.0)
    varying, depth = same.copy(), module.minimum_depth(a=2.0, h=1.0, n=n)
    varying[-1] = np.nextafter(2.0, 0.0)
    got, wanted = (module.displacement(r, depth, a=radii, h=1.0, n=n) for radii in (same, varying))
    np.testing.assert_allclose(got[:-1], wanted[:-1], rtol=MOST * EPS, atol=0.0)
    assert (got[:-1] != wanted[:-1]).any()


@pytest.mark.parametrize("k", [-1.0 + 1e-9, -0.3, 0.4, 1.0 - 1e-9])
@pytest.mark.parametrize("n", [0.1, 2.0, 40.0])
def test_polynomials_beside_a_graded_contact(n: float, k: float) -> None:
    """From an eighth as many radii on; the face of a punch and its hollow have different powers far out."""
    a, rng = 2.0, np.random.default_rng(3)
    r, same = a * (1.0 + 10.0 ** rng.uniform(-4.0, 3.0, 400)), np.full(400, a)
    varying = same.copy()
    varying[-1] = np.nextafter(a, 0.0)
    for name in ("power_law", "concave_power"):
        module = import_module(f"axicontact.graded.normal.{name}")
        if name == "power_law":
            got, wanted = (module.displacement(r, radii, A=1.0, n=n, k=k) for radii in (same, varying))
        elif n > 1.0 - k:
            depth = module.minimum_depth(a=a, h=1.0, n=n, k=k)
            got, wanted = (module.displacement(r, depth, a=radii, h=1.0, n=n, k=k) for radii in (same, varying))
        np.testing.assert_allclose(got[:-1], wanted[:-1], rtol=MOST * EPS, atol=0.0)
        assert (got[:-1] != wanted[:-1]).any()


def test_crowds_at_the_ends_of_the_panels() -> None:
    """On the axis r**2 - b**2 is a whole unit, next to the break it has no panel: the rule itself decides."""
    module, few = import_module("axicontact.normal.rounded_punch"), np.arange(1.0, 101.0)
    r = np.concatenate([np.linspace(0.01, 1.99, 3000), 1e-12 * few, 1.0 - 1e-9 * few, 1.0 + 1e-9 * few])
    radii = np.full(r.size, 2.0)
    varying = radii.copy()
    varying[0] = np.nextafter(2.0, 0.0)
    got, wanted = (module.pressure(r, a, R=3.0, b=1.0, E_star=1.0)[1:] for a in (radii, varying))
    np.testing.assert_allclose(got, wanted, rtol=MOST * EPS, atol=0.0)


def test_the_rule_is_called_at_few_radii() -> None:
    """And the root at the edge, which no polynomial is, has to be taken out."""
    called, r = [], np.linspace(1.0, 9.99, 5000)
    wanted = np.sqrt((10.0 - r) * (10.0 + r)) / r

    def exact(r: np.ndarray) -> np.ndarray:
        called.append(r.size)
        return np.sqrt((10.0 - r) * (10.0 + r)) / r

    def error(edge: float | None) -> float:
        with np.errstate(all="ignore"):
            got = integrals.along(exact, r, integrals.Course(0.0, 100.0, True, edge), 0.0, 10.0)
        return float(np.max(np.abs(got / wanted - 1.0)))

    assert error(10.0) <= MOST * EPS
    assert sum(called) < 100
    assert error(None) > 1e-4


def test_a_radius_that_varies_is_no_constant() -> None:
    assert integrals.same(np.ones(4), 2.0) == (1.0, 2.0)
    assert integrals.same(np.array([1.0, 1.0, 1.0 + EPS]), 2.0) is None
    assert integrals.same(np.array([np.nan, np.nan])) is None
