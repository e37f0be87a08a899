"""Sketches and plots against the results they draw: surface of the tilted punch, infinite peaks, ends of curves."""

from __future__ import annotations

import itertools
import math
from typing import Any

import pytest
from stored_book import stored

from axiderive.figures import plots
from axiderive.figures.axes import HIGHEST, SCREEN, printed
from axiderive.figures.axes import drawn as framed
from axiderive.figures.curves import WIDEST, curves
from axiderive.figures.drawing import Drawing, Rows
from axiderive.figures.given import HALF, load_sketch, tilted_sketch
from axiderive.figures.sketch import ARROW, LONG
from axiderive.figures.sketch import sketch as outline
from axiderive.figures.svg import svg
from axiderive.figures.tikz import thinned
from axiderive.figures.values import Numbers, StripNumbers, sketch_values
from axiderive.notation import R1, R2, R, b, describe, h, s, theta, wavelength
from axiderive.physics.systems import pool_of
from axiderive.profiles import NAMES


def profile_of(key: str) -> Any:
    return pool_of(key).load(key.rpartition(".")[2])


def drawn(name: str) -> Numbers:
    return Numbers(profile_of(name), stored(name), sketch_values(profile_of(name)), 16)


@pytest.fixture(scope="module")
def tilted() -> Drawing:
    return tilted_sketch(profile_of("plane.eccentric_punch"), stored("plane.eccentric_punch"), "P")


def surfaces(figure: Drawing) -> list[Rows]:
    """The free surface right and left of a contact."""
    return [list(line.points) for line in figure.lines if line.look == "surface"]


def lengths(figure: Drawing) -> dict[str, tuple[float, float]]:
    """The ends of a dimension line by the name that stands in its middle, across or up."""
    found = {}
    for line in (line for line in figure.lines if line.look == "dimension"):
        (x0, y0), (x1, y1) = line.points
        middle = (x0 + x1) / 2, (y0 + y1) / 2
        name = min(figure.words, key=lambda words: math.dist(words.place, middle)).text.strip("$")
        found[name] = (x0, x1) if y0 == y1 else (y0, y1)
    return found


def test_the_surface_beside_a_tilted_punch_is_the_closed_one(tilted: Drawing) -> None:
    """2P/(pi E*) (arcosh L - arcosh x) of the strip, and phi (x - sqrt(x^2 - 1)) of the inclination, both for a = 1."""
    (left, low), (right, lower) = tilted.of("contact")
    assert (right, left) == (HALF, -HALF)
    tilt = (low - lower) / (right - left)
    ((middle, _), _) = tilted.of("arrow")
    load = math.pi * tilt / (4 * middle / HALF)
    sunk = 2 * load / math.pi * math.acosh(2.7)
    assert -(low + lower) / 2 / HALF == pytest.approx(sunk, rel=1e-3)
    # the inclination is drawn at the lifted edge, as an arc that ends on the face
    *_, (x, y) = tilted.of("direction")
    assert math.atan2(low - y, x - left) == pytest.approx(math.atan(tilt), rel=1e-6)
    for points in surfaces(tilted):
        for x, y in points:
            u = abs(x) / HALF
            beside = tilt * math.copysign(u - math.sqrt(u * u - 1), x)
            expected = sunk - 2 * load / math.pi * math.acosh(u) + beside
            assert y == pytest.approx(-HALF * expected, abs=0.02)


def test_pressures_and_the_tilted_punch_are_drawn_inside_the_frame(tilted: Drawing) -> None:
    load = load_sketch(profile_of("loads.hertzian"), stored("loads.hertzian"))
    for drawing, look in ((load, "pressure"), (tilted, "body")):
        assert [line.look for line in drawing.lines].count(look) == 1
        shown = svg(drawing, 84.0)
        for _, _, attributes in shown.below:
            for x, y in (map(float, pair.split(",")) for pair in attributes["points"].split()):
                assert 0 <= x <= shown.width
                assert 0 <= y <= shown.height + 0.1
        assert all(0 <= label.left <= 100 and 0 <= label.top <= 100 for label in shown.labels)


@pytest.mark.parametrize("name", ["cone", "plane.quartic", "plane.flat_punch"])
def test_the_arrow_of_the_displacement_shows_how_far_the_surface_has_sunk(name: str) -> None:
    """Beside a plane punch the surface may have risen, and the arrow crossed its own name there."""
    made = StripNumbers if name.startswith("plane.") else Numbers
    numbers = made(profile_of(name), stored(name), sketch_values(profile_of(name)), 16)
    picture = outline(profile_of(name), numbers, "P", "x")
    surface = surfaces(picture)[0]
    (arrow, top), (_, end) = [line.points for line in picture.lines if line.look == "pointer"][-1]
    (x0, y0), (x1, y1) = next((a, b) for a, b in itertools.pairwise(surface) if a[0] <= arrow <= b[0])
    assert top == 0
    assert end == pytest.approx(y0 + (y1 - y0) * (arrow - x0) / (x1 - x0), abs=0.02)
    assert end < -0.9 * LONG
    assert max(x for x, _ in picture.of("body")) < arrow <= ARROW


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
    rows = force.curves[0].rows
    tip, flank = (curve.rows for curve in force.references)
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
    rows = force.curves[0].rows
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
    far = depth.curves[0].rows[-1]
    # (2P/(pi E*)) (ln(2L/a) + 1/2) of a cylinder
    assert far == pytest.approx((100.0, math.log(200) + 0.5), rel=1e-3)


def test_sketches_carry_the_lengths_of_the_profile() -> None:
    """Each radius, height and length that is a parameter stands in the picture once, to scale where it is a length."""
    for name in NAMES:
        profile = profile_of(name)
        picture = outline(profile, drawn(name), "P", "r")
        shown = [words.text.strip("$") for words in picture.words]
        for one in (R, R1, R2, b, h, s, wavelength):
            known = one in {*profile.parameters, *profile.breaks} and not (name == "wavy_paraboloid" and one == h)
            assert shown.count(describe(one).latex) == int(known), (name, one)
        assert shown.count("a") == 1
        assert shown.count(r"\theta") == int(theta in profile.parameters and name != "hyperboloid"), name
    found = lengths(outline(profile_of("ellipsoid"), drawn("ellipsoid"), "P", "r"))
    assert (found["h"][1] - found["h"][0]) / found["b"][1] == pytest.approx(0.9 / 1.5, rel=1e-3)


def test_a_curve_in_print_keeps_within_the_tolerance_of_its_points() -> None:
    """With fewer points, both ends kept; and a straight line keeps its ends alone."""
    points = [(i / 50, math.sin(i / 10)) for i in range(200)]
    found = thinned(points, 0.01)
    assert 10 < len(found) < 60
    assert (found[0], found[-1]) == (points[0], points[-1])
    for x, y in points:
        (x0, y0), (x1, y1) = next((p, q) for p, q in itertools.pairwise(found) if p[0] <= x <= q[0])
        assert abs(y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y) < 0.05
    assert thinned([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], 0.01) == [(0.0, 0.0), (2.0, 2.0)]
    assert len(thinned([(0.0, 0.0), (1.0, 0.0), (0.0, 0.0)], 0.01)) == 3


def test_the_book_and_the_web_edition_draw_a_plot_at_the_same_places() -> None:
    """Every point of a curve lies between the ticks as its values between their numbers, on axes of either kind."""
    profile, numbers = profile_of("rounded_cone"), drawn("rounded_cone")
    frames = *plots.plots(profile, numbers), curves(profile, numbers)[0]
    assert [frame.logarithmic[1] for frame in frames] == [False, True, False]
    assert frames[-1].y[0] < 0
    for frame, layout in itertools.product(frames, (None, SCREEN)):
        size = layout or printed(frame, 27.0)
        figure = framed(frame, size)
        assert figure.window is not None
        corners = zip(figure.window.x, figure.window.y, strict=True)
        assert [figure.window.place(corner) for corner in corners] == [(0.0, 0.0), (size.width, size.height)]
        ticks = [line.points for line in figure.lines if line.look == "tick"]
        own = [math.log10 if logarithmic else float for logarithmic in frame.logarithmic]
        places = [[start[i] for start, end in ticks if start[1 - i] == 0 > end[1 - i]] for i in (0, 1)]
        for trace, curve in zip(figure.window.traces, (*frame.references, *frame.curves), strict=True):
            for place, point in zip(map(figure.window.place, trace.points), curve.rows, strict=True):
                for i in (0, 1):
                    low, *_, high = (own[i](value) for value in frame.ticks[i])
                    first, *_, last = places[i]
                    share = (own[i](point[i]) - low) / (high - low)
                    assert place[i] == pytest.approx(first + (last - first) * share, abs=1e-9)


@pytest.mark.parametrize("name", ["cone", "hyperboloid"])
def test_the_curve_with_adhesion_runs_to_the_edge_of_its_frame(name: str) -> None:
    x, y = curves(profile_of(name), drawn(name))[0].curves[0].rows[-1]
    assert x >= WIDEST or y >= HIGHEST
