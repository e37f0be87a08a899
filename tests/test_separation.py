"""The work of separation of a pull-off force: the inverse of `pull_off`, which searches in another way."""

from __future__ import annotations

import math
from importlib import import_module
from types import ModuleType
from typing import Any

import graded_modules as graded
import numpy as np
import physics_package as homogeneous
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.code import example
from axiderive.physics import adhesive
from axiderive.physics.medium import GRADED, HOMOGENEOUS, Medium
from axiderive.profiles import NAMES, load

POWERS = ("cone", "paraboloid", "quartic", "sextic", "power_law")
CONCAVE = ("concave_paraboloid", "concave_power", "concave_quartic")
WITH = tuple(name for name in NAMES if not adhesive.refusal(load(name)))
DECADES = 10.0 ** np.linspace(-14.0, 6.0, 41)
"""Works of separation, between those whose contact is next to the axis or the edge and those far beyond any break."""


def of(name: str, medium: Medium, k: str = "0.3") -> tuple[ModuleType, dict[str, Any]]:
    """A module and the arguments of its functions without the work of separation."""
    profile = load(name)
    if medium.graded:
        module = import_module(f"axicontact.graded.adhesive.{name}")
        given = graded.keywords(module.pull_off, profile, graded.values(profile, k))
    else:
        module = import_module(f"axicontact.adhesive.{name}")
        given = homogeneous.keywords(module.pull_off, profile, homogeneous.values(profile))
    return module, {key: value for key, value in given.items() if key != "dgamma"}


@pytest.mark.parametrize("medium", [HOMOGENEOUS, GRADED])
@pytest.mark.parametrize("name", POWERS)
def test_the_closed_work_gives_the_closed_pull_off_force_back(name: str, medium: Medium) -> None:
    """Of what the docstrings say, with no function of the package."""
    profile = load(name)
    known = graded.values(profile, "0.3") | {nt.E_star: sp.Rational(5, 2)}
    plain = graded.derived("normal", name) if medium.graded else homogeneous.derived()["normal"][name]
    entries = graded.derived("adhesive", name) if medium.graded else homogeneous.derived()["adhesive"][name]
    work = adhesive.work_from_pull_off(plain["F"], medium)
    assert work is not None
    given = known | {nt.dgamma: example.number(work, known | {adhesive.TENSION: sp.Rational(7, 1000)})}
    at = given | {nt.a_c: example.number(entries["ac"].cases[0].expr, given)}
    assert float(example.number(entries["Fc"].cases[0].expr, at)) == pytest.approx(-0.007, rel=1e-14, abs=0.0)


@pytest.mark.parametrize("name", WITH)
@pytest.mark.parametrize("k", ["", "0.3", pytest.param("-0.5", marks=pytest.mark.slow)])
def test_it_is_the_inverse_of_pull_off(name: str, k: str) -> None:
    module, given = of(name, GRADED if k else HOMOGENEOUS, k)
    works = DECADES
    force = module.pull_off(dgamma=works, **given).force
    stable = ~np.isnan(force)
    assert stable.sum() > 20
    found = module.work_of_adhesion_from_pull_off(force, **given)
    # the force of a concave face without adhesion is taken away from that with it
    rest = module.pull_off(dgamma=0.0, **given).force if name in CONCAVE else 0.0
    sharp = 2e-14 * np.abs(force / (force - rest))
    assert np.all(np.abs(found / works - 1.0)[stable] <= sharp[stable])
    assert np.all(np.isnan(found) == ~stable)
    last = int(np.flatnonzero(stable)[-1])
    assert module.work_of_adhesion_from_pull_off(float(force[last]), **given) == pytest.approx(found[last], rel=1e-14)


def test_the_corner_and_the_flank_compete() -> None:
    """Below a truncated cone the least of several minima is meant, as `pull_off` means it, at the edge and beyond."""
    module, given = of("truncated_cone", HOMOGENEOUS)
    radii = module.pull_off(dgamma=DECADES, **given).radius
    assert 5 < np.sum(radii == given["b"]) < 36
    # next to where the lowest minimum changes
    first = int(np.flatnonzero(radii > given["b"])[0])
    works = np.geomspace(DECADES[first - 1], DECADES[first], 200)
    force = module.pull_off(dgamma=works, **given).force
    np.testing.assert_allclose(module.work_of_adhesion_from_pull_off(force, **given), works, rtol=2e-14)


@pytest.mark.parametrize("k", ["", "0.4"])
def test_pull_off_over_many_waves_is_the_least_force_of_all(k: str) -> None:
    """A hundred waves fit in the contact: each has a minimum, and the least one is far beyond the first."""
    module, given = of("wavy_paraboloid", GRADED if k else HOMOGENEOUS, k)
    works = 10.0 ** np.arange(2.0, 7.0)
    state = module.pull_off(dgamma=works, **given)
    assert state.radius[-1] > 100.0 * given["wavelength"]
    radii = state.radius[:, None] * np.linspace(0.5, 2.0, 20_001)
    assert np.all(np.min(module.force(radii, dgamma=works[:, None], **given), axis=1) >= state.force * (1.0 + 1e-13))


def test_johnson_kendall_roberts_and_kendall() -> None:
    paraboloid, punch = (import_module(f"axicontact.adhesive.{name}") for name in ("paraboloid", "flat_punch"))
    work = paraboloid.work_of_adhesion_from_pull_off(-3.0, R=2.0, E_star=1e3)
    assert work == pytest.approx(1.0 / math.pi, rel=1e-15, abs=0.0)
    work = punch.work_of_adhesion_from_pull_off(-3.0, a=2.0, E_star=5.0)
    assert work == pytest.approx(9.0 / (8.0 * math.pi * 5.0 * 8.0), rel=1e-15, abs=0.0)
    gradual = import_module("axicontact.graded.adhesive.paraboloid")
    work = gradual.work_of_adhesion_from_pull_off(-3.0, R=2.0, H=1e3, k=0.5)
    assert work == pytest.approx(3.0 / (1.75 * math.pi * 2.0), rel=1e-14, abs=0.0)


@pytest.mark.parametrize("medium", [HOMOGENEOUS, GRADED])
@pytest.mark.parametrize("name", ["cone", "truncated_cone", "polynomial", "flat_punch", "concave_paraboloid"])
def test_no_force_and_pressure(name: str, medium: Medium) -> None:
    """A hollow face comes off under a tension without any adhesion: a smaller one tells of no work of separation."""
    module, given = of(name, medium)
    own = module.work_of_adhesion_from_pull_off
    nothing = math.nan if name in CONCAVE else 0.0
    np.testing.assert_array_equal(own([0.0, 1.0, math.nan], **given), [nothing, math.nan, math.nan])
    for force, expected in ((0.0, nothing), (1.0, math.nan)):
        np.testing.assert_array_equal(own(force, **given), expected)
    if name in CONCAVE:
        assert own(module.pull_off(dgamma=0.0, **given).force, **given) == 0.0


def test_a_profile_too_sharp_is_refused() -> None:
    own = import_module("axicontact.adhesive.power_law").work_of_adhesion_from_pull_off
    with pytest.raises(ValueError, match=r"n = 0\.5: n > 1/2 is violated"):
        own(-1.0, A=1.0, n=0.5, E_star=1.0)
    own = import_module("axicontact.graded.adhesive.power_law").work_of_adhesion_from_pull_off
    with pytest.raises(ValueError, match=r"n > \(1 - k\)/2"):
        own(-1.0, A=1.0, n=0.3, H=1.0, k=0.2)
