"""Emitted tangential modules, prescribed pressures and materials against the exact entries at 30 digits."""

from __future__ import annotations

import math

import pytest
import sympy as sp
from physics_package import CLOSED, derived, emitted, exact, keywords, positional, public, radius, values

from axiderive import notation as nt
from axiderive.profiles import COMPACT_NAMES, load
from axiderive.profiles.loads import LOADS


@pytest.mark.parametrize("name", COMPACT_NAMES)
def test_tangential_entries(name: str) -> None:
    profile, module = load(name), emitted(f"tangential.{name}")
    a = radius(profile)
    for entry in derived()["tangential"][profile.name].values():
        function = getattr(module, entry.quantity.function)
        for part in ("0.7", "0.99"):
            known = values(profile) | {nt.a: a, nt.r: a * sp.Rational(3, 10)}
            least = known[profile.breaks[0]] if profile.truncated else sp.S.Zero
            known[nt.c] = least + (a - least) * sp.Rational(part)
            given = keywords(function, profile, known)
            if entry.suffix == "c":
                force = module.tangential_force(float(a), float(known[nt.c]), **given)
                assert function(force, float(a), **given) == pytest.approx(float(known[nt.c]), rel=1e-13)
                continue
            found = function(*(float(known[argument]) for argument in entry.quantity.arguments), **given)
            assert found == pytest.approx(exact(entry, known), rel=2e-13), (entry.key, part)


def test_beyond_full_slip_and_without_load() -> None:
    cone, given = emitted("tangential.cone"), {"theta": 0.3, "E_star": 2.0, "mu": 0.4}
    full = cone.tangential_force(0.9, 0.0, **given)
    assert cone.stick_radius(0.0, 0.9, **given) == 0.9
    assert cone.stick_radius(full, 0.9, **given) == 0.0
    assert math.isnan(cone.stick_radius(1.0001 * full, 0.9, **given))
    assert cone.traction(1.0, 0.9, 0.5, **given) == 0.0


@pytest.mark.parametrize("index", range(len(LOADS)))
def test_loads(index: int) -> None:
    profile = LOADS[index]
    module, (entry,) = emitted(f"loads.{profile.name}"), derived()["loads"][profile.name].values()
    assert {key: positional(signature) for key, signature in public(module).items()} == {"displacement": ["r"]}
    for ratio in ("0.01", "0.5", "0.999", "1.001", "1.5", "3", "1000"):
        for s in ("-0.9", "-0.5", "0", "0.3", "2.5", "40") if nt.sigma in profile.parameters else ("0",):
            known = values(profile) | {nt.a: sp.Rational("1.25"), nt.sigma: sp.Rational(s)}
            known[nt.r] = known[nt.a] * sp.Rational(ratio)
            found = module.displacement(float(known[nt.r]), **keywords(module.displacement, profile, known))
            assert found == pytest.approx(exact(entry, known), rel=CLOSED), (ratio, s)


@pytest.mark.parametrize("ratio", [1e-9, 0.3, 0.9, 1.0 - 1e-12])
def test_traction_on_the_axis_of_a_cone(ratio: float) -> None:
    """Both pressures are infinite there, and their difference is mu E* tan(theta)/2 ln(a/c)."""
    given = {"theta": 0.3, "E_star": 2.0, "mu": 0.4}
    found = emitted("tangential.cone").traction(0.0, 1.0, ratio, **given)
    assert found == pytest.approx(0.4 * math.tan(0.3) * -math.log(ratio), rel=1e-15)
    assert emitted("tangential.cone").traction(0.0, 1.0, 0.0, **given) == math.inf
