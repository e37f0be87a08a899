"""Sketches and plots against the results they draw: surface of the tilted punch, infinite peaks, ends of curves."""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest
from stored_book import stored

from axiderive.emit import plots
from axiderive.emit.curves import WIDEST, curves
from axiderive.emit.html.drawing import pairs
from axiderive.emit.html.sketch import sketch
from axiderive.emit.labels import HIGHEST
from axiderive.emit.sketch import ARROW, LONG
from axiderive.emit.sketch import sketch as outline
from axiderive.emit.sketch_given import load_sketch
from axiderive.emit.sketch_tilted import RADIUS, TiltedSketch, tilted_sketch
from axiderive.emit.spread import pool_of
from axiderive.emit.strips import StripNumbers
from axiderive.emit.values import Numbers, sketch_values

NOTHING: dict[str, Any] = {"picture": None, "load_picture": None, "tilted_picture": None, "load": "P", "place": "x"}


def profile_of(key: str) -> Any:
    return pool_of(key).load(key.rpartition(".")[2])


def drawn(name: str) -> Numbers:
    return Numbers(profile_of(name), stored(name), sketch_values(profile_of(name)), 16)


@pytest.fixture(scope="module")
def tilted() -> TiltedSketch:
    return tilted_sketch(profile_of("plane.eccentric_punch"), stored("plane.eccentric_punch"))


def test_the_surface_beside_a_tilted_punch_is_the_closed_one(tilted: TiltedSketch) -> None:
    """2P/(pi E*) (arcosh L - arcosh x) of the strip, and phi (x - sqrt(x^2 - 1)) of the inclination, both for a = 1."""
    tilt = math.tan(math.radians(tilted.degrees))
    (left, low), (right, lower) = pairs(tilted.contact)
    assert (right, left) == (RADIUS, -RADIUS)
    assert (low - lower) / (right - left) == pytest.approx(tilt, rel=1e-3)
    load = math.pi * tilt / (4 * tilted.load / RADIUS)
    sunk = 2 * load / math.pi * math.acosh(2.7)
    assert -(low + lower) / 2 / RADIUS == pytest.approx(sunk, rel=1e-3)
    for points in (tilted.surface, tilted.surface_left):
        for x, y in pairs(points):
            u = abs(x) / RADIUS
            beside = tilt * math.copysign(u - math.sqrt(u * u - 1), x)
            expected = sunk - 2 * load / math.pi * math.acosh(u) + beside
            assert y == pytest.approx(-RADIUS * expected, abs=0.02)


def test_the_web_draws_pressures_and_the_tilted_punch_inside_the_frame(tilted: TiltedSketch) -> None:
    load = load_sketch(profile_of("loads.hertzian"), stored("loads.hertzian"))
    assert sketch(NOTHING) is None
    for own, look in (({"load_picture": load}, "pressure"), ({"tilted_picture": tilted}, "body")):
        figure = sketch(NOTHING | own)
        assert figure is not None
        assert [shape[1] for shape in figure.shapes].count(look) == 1
        for element, _, attributes in figure.shapes:
            if element != "line":
                for x, y in (map(float, pair.split(",")) for pair in attributes["points"].split()):
                    assert 0 <= x <= figure.width
                    assert 0 <= y <= figure.height + 0.1
        assert all(0 <= label.left <= 100 and 0 <= label.top <= 100 for label in figure.labels)


@pytest.mark.parametrize("name", ["cone", "plane.quartic", "plane.flat_punch"])
def test_the_arrow_of_the_displacement_shows_how_far_the_surface_has_sunk(name: str) -> None:
    """Beside a plane punch the surface may have risen, and the arrow crossed its own name there."""
    made = StripNumbers if name.startswith("plane.") else Numbers
    numbers = made(profile_of(name), stored(name), sketch_values(profile_of(name)), 16)
    picture = outline(profile_of(name), numbers)
    surface = pairs(picture.surface)
    (x0, y0), (x1, y1) = next((a, b) for a, b in itertools.pairwise(surface) if a[0] <= picture.arrow <= b[0])
    assert picture.arrow_end == pytest.approx(y0 + (y1 - y0) * (picture.arrow - x0) / (x1 - x0), abs=0.02)
    assert picture.arrow_end < -0.9 * LONG
    assert max(x for x, _ in pairs(picture.body)) < picture.arrow <= ARROW


@pytest.mark.parametrize(
    ("towards", "infinite"), [([2.0, 2.3, 2.6], True), ([2.0, 2.1, 2.13], False), ([1.0, 1.0, 1.0], False)]
)
def test_a_peak_that_grows_by_as_much_in_every_decade_is_infinite(towards: list[float], infinite: bool) -> None:
    assert plots._grows(towards) is infinite


@pytest.mark.parametrize(("name", "infinite"), [("truncated_paraboloid", True), ("rounded_punch", False)])
def test_an_infinite_pressure_at_a_break_is_drawn_to_the_top(name: str, infinite: bool) -> None:
    numbers = drawn(name)
    at = float(numbers["b"] / numbers["a"])
    found = [y for x, y in plots._pressure(numbers) if abs(x - at) < 1e-9]
    assert found == ([plots.TOP] if infinite else [])


@pytest.mark.parametrize("name", ["cone", "hyperboloid"])
def test_the_curve_with_adhesion_runs_to_the_edge_of_its_frame(name: str) -> None:
    x, y = pairs(curves(profile_of(name), drawn(name)).adhesion.stable)[-1]
    assert x >= WIDEST or y >= HIGHEST
