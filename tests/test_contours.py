"""Pictures of the stress below a contact beside the functions of the package, their areas beside known ones."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np
import pytest

from axicontact import subsurface
from axiderive.figures import contours
from axiderive.figures.values import Numbers, sketch_values
from axiderive.physics import normal
from axiderive.profiles.pools import ROUND

NAMES = ("paraboloid", "sphere", "rounded_punch", "sphere_tipped_cone", "capped_cylinder", "concave_paraboloid")


def numbers(name: str) -> Numbers:
    profile = ROUND.load(name)
    return Numbers(profile, normal.derive(profile), sketch_values(profile), 16)


def known(own: Numbers) -> tuple[Any, float, dict[str, float]]:
    """The module of the package, what it is given, and its keywords."""
    keywords = {s.name: float(own.values[s]) for s in own.profile.parameters}
    given = float(own["a"] if own.profile.compact else own.depth)
    module = import_module(f"axicontact.subsurface.{own.profile.name}")
    return module, given, keywords | {"E_star": 1.0, "nu": contours.NU}


@pytest.mark.parametrize("name", NAMES)
def test_the_stress_is_that_of_the_package(name):
    """Punches summed by another rule, in complex numbers: a wrong weight, sign or slope shows in the first digits."""
    own = numbers(name)
    field, (module, given, keywords) = contours.Field(own), known(own)
    x = np.linspace(-contours.WIDE, contours.WIDE, 31)
    for z in (0.03, 0.4, 1.3):
        r, phi, deep = abs(x) * field.radius, np.where(x < 0.0, math.pi, 0.0), z * field.radius
        state = module.stress(r, deep, given, **keywords)
        added = module.sliding_stress(r, phi, deep, given, mu=contours.MU, **keywords)
        wanted = [subsurface.von_mises(one) / field.mean for one in (state, subsurface.add(state, added))]
        np.testing.assert_allclose(field.mises(x, z, 0.0, contours.MU), wanted, rtol=0.0, atol=1e-8)


@pytest.mark.parametrize("name", NAMES)
def test_the_greatest_stress_is_that_of_the_package(name):
    own = numbers(name)
    field, (module, given, keywords) = contours.Field(own), known(own)
    wanted = module.greatest_von_mises(given, **keywords)
    found = field.greatest(0.0, (float(wanted.r) / field.radius + 0.03, float(wanted.z) / field.radius + 0.02))
    if math.isinf(wanted.value):
        assert (found.value, found.x, found.z) == (math.inf, wanted.r / field.radius, 0.0)
        return
    assert found.value == pytest.approx(wanted.value / field.mean, abs=1e-6)
    assert found.x == pytest.approx(wanted.r / field.radius, abs=2e-3)
    assert found.z == pytest.approx(wanted.z / field.radius, abs=2e-3)


def test_the_edge_behind_a_sliding_contact_is_found():
    """Under a quartic it bears more than the inside: a search from the greatest value of a grid alone ends below it."""
    field = contours.Field(numbers("quartic"))
    top = field.greatest(contours.MU, (-1.0, 0.0))
    grid = field.mises(np.linspace(-0.99, 0.99, 67), 0.05, contours.MU)
    assert top.value > grid.max() + 0.1
    assert top.words.endswith("the surface")


def test_areas_are_those_above_a_level():
    """Of a ring, a disc in it, and a corner that the frame cuts: outer borders run one way, inner ones the other."""
    x, z = np.linspace(-2.0, 2.0, 201), np.linspace(0.0, 2.0, 101)
    distance = np.hypot(x[None, :], z[:, None] - 1.0)
    areas = [contours.area(loop) for loop in contours.loops(x, z, 0.01 - (distance - 0.6) ** 2)]
    outer, inner = sorted(areas, reverse=True)
    assert outer == pytest.approx(math.pi * 0.7**2, rel=2e-3)
    assert inner == pytest.approx(-math.pi * 0.5**2, rel=2e-3)
    (cut,) = (contours.area(loop) for loop in contours.loops(x, z, 1.0 - np.hypot(x[None, :] - 2.0, z[:, None])))
    assert cut == pytest.approx(math.pi / 4.0, rel=2e-3)


def test_tones_lie_over_one_another_as_the_stress_does():
    """A hole has the tone below; what is painted last at a point is the tone of its value."""
    x, z = np.linspace(-1.5, 1.5, 61), np.linspace(0.0, 1.5, 31)
    values = 1.0 - np.abs(np.hypot(x[None, :], z[:, None] - 0.7) - 0.4)
    painted = contours.shaded(x, z, values)
    for i, j in [(14, 30), (14, 38), (2, 3), (20, 22)]:
        tone = -1
        for shade, loop in painted:
            if inside(loop, float(x[j]) + 1e-4, float(z[i]) + 1e-4):
                tone = shade
        assert tone == sum(values[i, j] > level for level in contours.SHADES) - 1


def inside(loop: list[tuple[float, float]], x: float, y: float) -> bool:
    """Whether a ray to the right crosses the border an odd number of times."""
    ends = zip(loop, [*loop[1:], loop[0]], strict=True)
    return (
        sum((y0 > y) != (y1 > y) and x < x0 + (y - y0) / (y1 - y0) * (x1 - x0) for (x0, y0), (x1, y1) in ends) % 2 == 1
    )
