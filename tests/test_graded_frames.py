"""The plots of a contact on the graded half-space: the surface goes on from the edge of the contact."""

from __future__ import annotations

import pytest
from stored_book import stored

from axiderive.figures.plots import BESIDE, EXPONENTS, SHOWN, frames
from axiderive.profiles import load


@pytest.mark.parametrize("name", SHOWN)
def test_the_surface_goes_on_from_the_edge_of_the_contact(name: str) -> None:
    """It is drawn over the depth of the edge itself, so a wrong displacement would leave a step."""
    _, surface = frames(load(name), stored(name), stored(f"{name}.fgm"))
    at_the_end = []
    for curve in surface.curves:
        rows = curve.rows
        assert (rows[0], rows[-1][0]) == ((BESIDE[0], 1.0), BESIDE[1])
        falls = [upper - lower for (_, upper), (_, lower) in zip(rows, rows[1:], strict=False)]
        assert all(fall > 0 for fall in falls)
        assert falls[0] < 0.02
        at_the_end.append(rows[-1][1])
    # what the caption says: level sooner where the depth is stiffer, in the order of the exponents
    assert [curve.label for curve in surface.curves] == list(EXPONENTS)
    assert at_the_end == sorted(at_the_end, reverse=True)


@pytest.mark.parametrize("name", SHOWN)
def test_the_middle_carries_more_where_the_depth_is_stiffer(name: str) -> None:
    pressure, _ = frames(load(name), stored(name), stored(f"{name}.fgm"))
    halfway = [dict(curve.rows)[0.25] for curve in pressure.curves]
    assert halfway == sorted(halfway)
