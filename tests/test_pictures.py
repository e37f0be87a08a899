"""Sketches and plots against the results they draw: surface of the tilted punch, infinite peaks, ends of curves."""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest
from stored_book import stored

from axiderive.figures import plots
from axiderive.figures.curves import WIDEST, curves
from axiderive.figures.labels import HIGHEST
from axiderive.figures.sketch import ARROW, LONG
from axiderive.figures.sketch import sketch as outline
from axiderive.figures.sketch_given import load_sketch
from axiderive.figures.sketch_tilted import RADIUS, TiltedSketch, tilted_sketch
from axiderive.notation import R1, R2, R, b, describe, h, s, wavelength
from axiderive.oracle.values import Numbers, StripNumbers, sketch_values
from axiderive.physics.systems import pool_of
from axiderive.profiles import NAMES
from axiderive.web.figures import pairs, sketch

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


@pytest.mark.parametrize("name", ["rounded_cone", "truncated_paraboloid", "capped_paraboloid", "hyperboloid"])
def test_force_over_depth_runs_from_one_law_to_the_other(name: str) -> None:
    """At both ends of the frame the curve has the slope of the line in grey, and it lies closer to that line."""
    _, force = plots.plots(profile_of(name), drawn(name))
    rows = pairs(force.curves[0].coordinates)
    tip, flank = (pairs(curve.coordinates) for curve in force.references)
    assert slope(rows[:2]) == pytest.approx(slope(tip[:2]), abs=0.12)
    assert slope(rows[-2:]) == pytest.approx(slope(flank[-2:]), abs=0.12)
    assert tip[0][0] == pytest.approx(rows[0][0], rel=1e-3)
    assert rows[0][1] == pytest.approx(tip[0][1], rel=0.25)


def slope(ends: list[tuple[float, float]]) -> float:
    """Of a line between two points whose axes are logarithmic."""
    (x0, y0), (x1, y1) = ends
    return math.log(y1 / y0) / math.log(x1 / x0)


@pytest.mark.parametrize("name", ["cone", "paraboloid", "quartic", "sextic", "power_law"])
def test_a_force_that_is_one_power_of_the_depth_is_not_drawn(name: str) -> None:
    assert len(plots.plots(profile_of(name), drawn(name))) == 1


@pytest.mark.parametrize("name", ["concave_power", "concave_paraboloid", "concave_quartic", "capped_cylinder"])
def test_the_force_of_a_face_begins_where_the_whole_of_it_is_in_contact(name: str) -> None:
    """It once began below the least depth; there the closed formula is that of no contact."""
    _, force = plots.plots(profile_of(name), drawn(name))
    (mark,) = force.marks
    rows = pairs(force.curves[0].coordinates)
    straight = [
        slope for slope in itertools.starmap(lambda p, q: (q[1] - p[1]) / (q[0] - p[0]), itertools.pairwise(rows))
    ]
    assert straight[-1] == pytest.approx(2.0, rel=1e-3)  # 2 E* a of a complete contact
    if name == "capped_cylinder":
        assert rows[0][0] < mark.x == 1.0
        assert straight[0] < 1.0
    else:
        assert (mark.x, mark.y) == pytest.approx(rows[0], rel=1e-3)
        numbers = drawn(name)
        inside = [numbers.at(d=mark.x * 0.15 * factor) for factor in (0.98, 1.02)]
        lifted, pressed = (min(one("p", i / 50) for i in range(1, 40)) for one in inside)
        assert lifted < 0 < pressed


def test_the_depth_of_a_plane_contact_is_drawn_over_the_distance_it_is_measured_from() -> None:
    numbers = StripNumbers(
        profile_of("plane.parabola"), stored("plane.parabola"), sketch_values(profile_of("plane.parabola")), 16
    )
    _, depth = plots.plots(profile_of("plane.parabola"), numbers)
    far = pairs(depth.curves[0].coordinates)[-1]
    # (2P/(pi E*)) (ln(2L/a) + 1/2) of a cylinder
    assert far == pytest.approx((100.0, math.log(200) + 0.5), rel=1e-3)


def test_sketches_carry_the_lengths_of_the_profile() -> None:
    """Each radius, height and length that is a parameter stands in the picture once, to scale where it is a length."""
    for name in NAMES:
        profile = profile_of(name)
        picture = outline(profile, drawn(name))
        named = [one.name for one in (*picture.dimensions, *picture.heights, *picture.radii)]
        wanted = {
            describe(s).latex for s in (R, R1, R2, b, h, s, wavelength) if s in {*profile.parameters, *profile.breaks}
        }
        assert sorted(named) == sorted({"a", *wanted} - ({"h"} if name == "wavy_paraboloid" else set())), name
    picture = outline(profile_of("ellipsoid"), drawn("ellipsoid"))
    (height,) = picture.heights
    across = next(one for one in picture.dimensions if one.name == "b")
    assert (height.high - height.low) / across.at == pytest.approx(0.9 / 1.5, rel=1e-3)


@pytest.mark.parametrize("name", ["cone", "hyperboloid"])
def test_the_curve_with_adhesion_runs_to_the_edge_of_its_frame(name: str) -> None:
    x, y = pairs(curves(profile_of(name), drawn(name)).adhesion.stable)[-1]
    assert x >= WIDEST or y >= HIGHEST
