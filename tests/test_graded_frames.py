"""The plots of a contact on the graded half-space fill both frames of their line."""

from __future__ import annotations

import pytest
from stored_book import stored

from axiderive.emit.graded.frames import BESIDE_FACE, EXPONENTS, frames
from axiderive.profiles import load


def _rows(text: str) -> list[tuple[float, float]]:
    pairs = [pair.strip("()").split(",") for pair in text.split()]
    return [(float(x), float(y)) for x, y in pairs]


@pytest.mark.parametrize("name", ["flat_punch", "concave_paraboloid", "cone"])
def test_two_frames_stand_side_by_side(name: str) -> None:
    assert len(frames(load(name), stored(name), stored(f"{name}.fgm"))) == 2


@pytest.mark.parametrize("name", ["flat_punch", "concave_paraboloid"])
def test_the_surface_goes_on_from_the_edge_of_the_face(name: str) -> None:
    """It is drawn over the depth of the edge itself, so a wrong face or displacement would leave a step."""
    _, surface = frames(load(name), stored(name), stored(f"{name}.fgm"))
    for curve, exponent in zip(surface.curves, EXPONENTS, strict=True):
        rows = _rows(curve.coordinates)
        assert (rows[0], rows[-1][0]) == ((BESIDE_FACE[0], 1.0), BESIDE_FACE[1])
        falls = [upper - lower for (_, upper), (_, lower) in zip(rows, rows[1:], strict=False)]
        assert all(fall > 0 for fall in falls)
        # near the edge it falls as the power (1 - k)/2 of the distance; 1.09 measured of k = 1/2
        assert falls[0] < 1.2 * (rows[1][0] - rows[0][0]) ** ((1 - float(exponent)) / 2)
