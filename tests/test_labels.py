"""Labels of curves: they stand free of everything else that is drawn, and on their curve only where nothing is free."""

from __future__ import annotations

import itertools

import pytest
from stored_book import stored
from test_pictures import profile_of

from axiderive.figures.axes import Axes, Curve, Rows, labelled
from axiderive.figures.given import axes_of

WIDE, TALL = 67.0, 27.0
"""Millimetres of a frame."""
LETTER, LINE = 1.2, 2.0
"""Millimetres of a letter and of a line of 7.6 point, without the room around a label."""

Box = tuple[float, float, float, float]


def box_of(label: Curve, axes: Axes) -> Box:
    """Ends of the letters of a label in millimetres, by the side of it that lies at its place."""
    wide = LETTER * len(label.label)
    x = WIDE * (label.x - axes.x[0]) / (axes.x[1] - axes.x[0])
    y = TALL * label.y / axes.y[1]
    left = {"west": x, "east": x - wide}.get(label.anchor, x - wide / 2)
    low = {"south": y, "north": y - LINE}.get(label.anchor, y - LINE / 2)
    return left, left + wide, low, low + LINE


def crossed(box: Box, curve: Curve, axes: Axes) -> bool:
    """Whether a curve, drawn as dots, comes into a box."""
    points = [(WIDE * (x - axes.x[0]) / (axes.x[1] - axes.x[0]), TALL * y / axes.y[1]) for x, y in curve.rows]
    for (x0, y0), (x1, y1) in itertools.pairwise(points):
        for i in range(50):
            x, y = x0 + (x1 - x0) * i / 50, y0 + (y1 - y0) * i / 50
            if box[0] < x < box[1] and box[2] < y < box[3]:
                return True
    return False


def test_labels_of_a_prescribed_pressure_stand_free() -> None:
    """The label of one exponent once interrupted its curve, though there was room between it and the next."""
    for axes in axes_of(profile_of("loads.power"), stored("loads.power")):
        boxes = [box_of(curve, axes) for curve in axes.curves]
        assert [curve.label for curve in axes.curves] == ["-0.5", "0", "0.5", "2"]
        for box, label in zip(boxes, axes.curves, strict=True):
            assert box[0] > 0, label
            assert box[1] < WIDE, label
            assert 0 < box[2] < box[3] < TALL, label
            assert not [other.label for other in axes.curves if crossed(box, other, axes)], label
        for one, other in itertools.combinations(boxes, 2):
            assert one[1] < other[0] or other[1] < one[0] or one[3] < other[2] or other[3] < one[2]


def level(height: float) -> Rows:
    return [(i / 20, height) for i in range(21)]


def test_a_label_without_room_lies_on_its_curve() -> None:
    """Between curves that are closer than a label is high, it would name its neighbour; at the border it has room."""
    family = [level(1.0), level(1.1), level(1.2)]
    anchors = [labelled(family, i, "0.5", []).anchor for i in range(3)]
    assert anchors == ["north", "center", "south"]


@pytest.mark.parametrize("taken", [False, True])
def test_a_label_gives_way_to_one_that_stands_already(taken: bool) -> None:
    """Over one half of the gap stands another label: the own one comes to the other half, and else to the middle."""
    family = [level(1.0), [(0.0, 2.2), (1.0, 1.2)]]
    free = labelled(family, 0, "one label", [])
    others = [Curve([], "another label", free.x, free.y + 0.1)] if taken else []
    place = labelled(family, 0, "one label", others)
    assert (place == free) is not taken
    assert not taken or abs(place.x - free.x) > 0.1 or place.anchor != free.anchor


def test_the_label_of_a_peak_stands_beside_it() -> None:
    """A peak that leaves the frame has no room above, and below it other curves pass."""
    peak = [(0.0, 0.3), (0.495, 0.5), (0.5, 3.4), (0.505, 0.5), (1.0, 0.3)]
    family = [level(0.2), peak, level(0.45)]
    place = labelled(family, 1, "0.5", [])
    assert place.anchor in ("east", "west")
    assert 0.49 < place.x < 0.51
    assert place.y > 0.6
