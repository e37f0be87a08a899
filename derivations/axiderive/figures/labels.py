"""Where the label of a curve sits: above, below or beside it, and on it only where nothing else is free.

A frame is one wide and HIGHEST high; distances are weighed in heights of a label.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

from .drawing import Rows

HIGHEST = 3.2
"""Upper end of the pressure axis; curves are cut a little above it."""


@dataclass(frozen=True)
class Curve:
    """Points, the label, where it sits, and which side of it, or its center, lies on the curve."""

    rows: Rows
    label: str
    x: float
    y: float
    anchor: str = "south"
    name: str = ""
    """What it is, for a reader who takes its points; the label where there is one."""
    look: str = ""
    """How it is drawn, if it is no member of a family."""


def rounded(rows: Rows) -> Rows:
    """The points to five significant digits."""
    return [(float(f"{x:.5g}"), float(f"{y:.5g}")) for x, y in rows]


TALL = 0.24
"""Height of a label in units of the vertical axis, in the frame of the pressure."""
WIDE = 0.045
"""That length in widths of the frame."""
STEP = 0.02
"""Distance along a curve of the places that are tried, in widths of the frame."""
ASPECT = 40 / 67
"""Height of the frame over its width."""
ROUND, BESIDE = 0.02, 0.0105
"""Width that is kept free left and right of a label, and that between a place and the label beside it."""
BEGIN, END = 0.01, 1.0
"""Ends of the frame for a label: it leaves the vertical axis free."""
AXIS, CLEAR, APART, FAR = 0.15, 0.1, 0.35, 1.25
"""In heights of a label: room above the horizontal axis; distance of other curves and labels from a label, and of other
curves from its place, where it is free; and that beyond which they do not matter."""


@dataclass(frozen=True)
class Box:
    """Ends of a label, across and up."""

    left: float
    right: float
    low: float
    high: float


def labelled(family: list[Rows], index: int, label: str, taken: Sequence[Curve], tall: float = TALL) -> Curve:
    """The label sits where it has most room above, below or beside its curve, away from other curves and labels."""
    own, *rest = (sorted(rows) for rows in (family[index], *family[:index], *family[index + 1 :]))
    others = [rows for rows in rest if not _same(rows, own)]
    boxes = [_box(curve, tall) for curve in taken if curve.label]
    best = max(_places(own, label, others, boxes, tall), default=(False, 0.0, 0.5, 0.0, "south"))
    _, _, x, y, anchor = best
    return Curve(rounded(family[index]), label, round(x, 3), round(y, 3), anchor)


Place = tuple[bool, float, float, float, str]
"""Whether it is free, what it is worth, where it is, and the side of the label that lies there."""


def _places(own: Rows, label: str, others: list[Rows], boxes: list[Box], tall: float) -> Iterator[Place]:
    for x, middle in _along(own):
        apart = min([FAR, *(_apart(rows, x, middle, tall) for rows in others)])
        for anchor, handicap in (("south", 0.0), ("north", 0.2), ("east", 0.4), ("west", 0.4), ("center", 0.4)):
            half = _half(label)
            low, high = _span(own, x - half, x + half) or (middle, middle)
            y = {"south": high, "north": low}.get(anchor, middle)
            box = _box(Curve([], label, x, y, anchor), tall)
            if box.left < BEGIN or box.right > END or box.low < AXIS * tall or box.high > HIGHEST:
                continue
            clear = min(_clearances(box, others, boxes, tall))
            if anchor in ("east", "west"):
                clear = min(clear, _left(own, box, x) / tall)
            slant = 0.0 if anchor in ("east", "west") else (high - low) / tall
            free = anchor != "center" and clear >= CLEAR and apart >= APART
            room = min(clear, 1.0) if clear > 0 else 3 * clear
            unclear = 6 * max(0.0, 0.2 - apart)  # which curve is meant must show
            # rounded, so that the last bit of a logarithm or a root of another machine moves no label
            yield free, round(room + 2 * apart - slant / 2 - unclear - handicap, 6), x, y, anchor


def _along(rows: Rows) -> Iterator[tuple[float, float]]:
    """Places on a curve, evenly spaced in print, as far as it lies in the frame."""
    ahead = 0.0
    for (x0, y0), (x1, y1) in zip(rows, rows[1:], strict=False):
        length = math.hypot(x1 - x0, (y1 - y0) * ASPECT / HIGHEST)
        while ahead <= length and length > 0:
            share = ahead / length
            x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
            if 0 <= x <= 1 and 0 <= y <= HIGHEST:
                yield x, y
            ahead += STEP
        ahead -= length


def _half(label: str) -> float:
    """Half of the width of a label."""
    return 0.01 + 0.009 * len(label)


def _box(curve: Curve, tall: float) -> Box:
    """The place of a label."""
    half = _half(curve.label)
    across = {"east": -half, "west": half}.get(curve.anchor, 0.0)
    up = {"south": tall / 2, "north": -tall / 2}.get(curve.anchor, 0.0)
    x, y = curve.x + across, curve.y + up
    return Box(x - half, x + half, y - tall / 2, y + tall / 2)


def _clearances(box: Box, others: Iterable[Rows], boxes: Iterable[Box], tall: float) -> Iterator[float]:
    """Distances of a label from the curves and labels beside it and from the ends of the frame, in its heights."""
    yield (HIGHEST - box.high) / tall
    yield box.low / tall
    for rows in others:
        span = _span(rows, box.left - ROUND, box.right + ROUND)
        if span:
            yield max(span[0] - box.high, box.low - span[1]) / tall
    for one in boxes:
        if one.left < box.right + ROUND and box.left < one.right + ROUND:
            yield max(one.low - box.high, box.low - one.high) / tall


def _left(own: Rows, box: Box, x: float) -> float:
    """How far a steep curve has left the label beside it, from where the label begins."""
    span = _span(own, box.left, x - BESIDE) if box.left < x - BESIDE else _span(own, x + BESIDE, box.right)
    return max(span[0] - box.high, box.low - span[1]) if span else math.inf


def _apart(rows: Rows, x: float, y: float, tall: float) -> float:
    """Distance of a curve from a place, to whichever side."""
    spans = ((reach, _span(rows, x - reach * WIDE, x + reach * WIDE)) for reach in (0.0, 0.25, 0.5, 0.75, 1.0))
    return min((math.hypot(r, max(s[0] - y, y - s[1], 0.0) / tall) for r, s in spans if s), default=math.inf)


def _span(rows: Rows, left: float, right: float) -> tuple[float, float] | None:
    """Least and greatest height of a curve between two places; none where it does not come."""
    if right < rows[0][0] or left > rows[-1][0]:
        return None
    first, last = bisect_left(rows, (left, -math.inf)), bisect_right(rows, (right, math.inf))
    heights = [y for _, y in rows[first:last]]
    heights += [_height(rows, x) for x in (left, right) if rows[0][0] <= x <= rows[-1][0]]
    return min(heights), max(heights)


def _same(rows: Rows, others: Rows) -> bool:
    """Whether two curves cannot be told apart in print, as far as both of them come."""
    first, last = others[0][0], others[-1][0]
    return all(abs(_height(others, x) - y) < 0.05 for x, y in rows if first <= x <= last)


def _height(rows: Rows, x: float) -> float:
    """Linear interpolation; beyond the ends the end value."""
    index = bisect_left(rows, (x, -math.inf))
    if index == 0 or index == len(rows):
        return rows[min(index, len(rows) - 1)][1]
    (x0, y0), (x1, y1) = rows[index - 1], rows[index]
    return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
