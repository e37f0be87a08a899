"""A plot as data: axes, curves, what they are compared with, and where the labels stand; and as a drawing.

The label of a curve sits above, below or beside it, and on it only where nothing else is free.  For that a frame is one
wide and HIGHEST high; distances are weighed in heights of a label.
"""

from __future__ import annotations

import math
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

from .drawing import Drawing, Point, Rows, Trace, Window

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


def short(x: float, y: float) -> tuple[float, float]:
    """A point to four significant digits."""
    return float(f"{x:.4g}"), float(f"{y:.4g}")


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


LOW_TALL = TALL * 40 / 27
"""Height of a label in a frame of 27 mm instead of 40 mm."""
Span = tuple[float, float]
Shown = tuple[Rows, str]
"""A curve and its label."""


@dataclass(frozen=True)
class Mark:
    """A point on a curve that has a name, and the side of the name that lies at the point."""

    x: float
    y: float
    label: str
    anchor: str = "north west"
    look: str = "ink"


@dataclass(frozen=True)
class Axes:
    """One frame: names, ends and ticks of its axes, the curves and what stands below it."""

    names: tuple[str, str]
    x: Span
    y: Span
    ticks: tuple[tuple[float, ...], tuple[float, ...]]
    curves: tuple[Curve, ...]
    title: str
    words: str
    references: tuple[Curve, ...] = ()
    """What the curves are compared with; their labels are words."""
    marks: tuple[Mark, ...] = ()
    logarithmic: tuple[bool, bool] = (False, False)


def axes(
    names: tuple[str, str],
    x: Span,
    y: Span,
    family: Sequence[Shown],
    words: tuple[str, str],
    references: Sequence[Shown] = (),
    marks: tuple[Mark, ...] = (),
    logarithmic: tuple[bool, bool] = (False, False),
) -> Axes:
    """A frame with its labels where the curves leave most room."""
    across, up = _scale(x, logarithmic[0]), _scale(y, logarithmic[1])
    drawn = [*family, *references]
    scaled = [[(across(u), HIGHEST * up(v)) for u, v in rows] for rows, _ in drawn]
    placed = [_beside(mark, across(mark.x), HIGHEST * up(mark.y)) for mark in marks]
    for i, (rows, label) in enumerate(drawn):
        at = labelled(scaled, i, label, placed, LOW_TALL) if label else Curve([], "", 0.0, 0.0)
        placed.append(replace(at, rows=rounded(rows)))
    back = (_inverse(x, logarithmic[0]), _inverse(y, logarithmic[1]))
    placed = placed[len(marks) :]
    shown = [replace(c, x=back[0](c.x), y=back[1](c.y / HIGHEST)) if c.label else c for c in placed]
    ticks = (_ticks(x, logarithmic[0], 4), _ticks(y, logarithmic[1], 3.5))
    return Axes(
        names, x, y, ticks, tuple(shown[: len(family)]), *words, tuple(shown[len(family) :]), marks, logarithmic
    )


def _beside(mark: Mark, x: float, y: float) -> Curve:
    """The name of a mark, as one of the labels that others give way to."""
    name = "mark" if "_" in mark.label else mark.label
    return Curve([], name, x + 0.01 * len(name), y - LOW_TALL / 2, "center")


def _scale(ends: Span, logarithmic: bool) -> Callable[[float], float]:
    """From a value to the share of the axis below it."""
    low, high = map(math.log10, ends) if logarithmic else ends
    return lambda value: ((math.log10(value) if logarithmic else value) - low) / (high - low)


def _inverse(ends: Span, logarithmic: bool) -> Callable[[float], float]:
    low, high = map(math.log10, ends) if logarithmic else ends

    def value(share: float) -> float:
        at = low + share * (high - low)
        return float(f"{10**at if logarithmic else at:.4g}")

    return value


def _ticks(ends: Span, logarithmic: bool, most: float) -> tuple[float, ...]:
    """Round numbers from one end to the other: at most so many steps."""
    if logarithmic:
        low, high = math.ceil(math.log10(ends[0]) - 1e-9), math.floor(math.log10(ends[1]) + 1e-9)
        step = math.ceil((high - low) / most) or 1
        return tuple(float(f"1e{power}") for power in range(low, high + 1, step))
    wide = next(s for s in (0.25, 0.5, 1.0, 2.0, 4.0, 5.0, 10.0) if (ends[1] - ends[0]) / s <= most + 1e-9)
    first = math.ceil(ends[0] / wide - 1e-9)
    return tuple(wide * i for i in range(first, math.floor(ends[1] / wide + 1e-9) + 1))


@dataclass(frozen=True)
class Layout:
    """Where the parts of a plot stand around its frame, in units of the drawing."""

    width: float
    height: float
    left: float
    right: float
    below: float
    above: float
    tick: float
    """Length of a tick, beyond which its number stands."""
    across: tuple[Point, str]
    """Place of the name of the horizontal axis from the lower right corner, and the side of it that lies there."""
    up: tuple[Point, str] | None
    """That of the vertical axis from the upper left corner; without one it reads upwards beside its numbers."""


def printed(axes: Axes, height: float) -> Layout:
    """In millimetres: all frames of the book end at the same distance from the right."""
    width = 64.0 if axes.logarithmic[1] else 67.0
    return Layout(width, height, 79.9 - width, 0.1, 11.2, 1.0, 0.78, ((-width / 2, -4.9), "north"), None)


SCREEN = Layout(346.0, 200.0, 46.0, 8.0, 40.0, 28.0, 4.0, ((0.0, -40.0), "south east"), ((-38.0, 26.0), "north west"))
"""Of the web edition, in units of SVG."""
TONES = 4
"""Shades from the first curve of a family to its last."""
LETTER = {".": 0.75, "-": 2.1}
"""Widths of the letters of a number in print, in millimetres; a digit has 1.4."""


def drawn(axes: Axes, layout: Layout) -> Drawing:
    """The plot with its frame in the lower left corner at (0, 0)."""
    low, high = (-layout.left, -layout.below), (layout.width + layout.right, layout.height + layout.above)
    figure = Drawing("plot", low, high, (axes.title, axes.words), f"Plot of {axes.names[1]} over {axes.names[0]}")
    figure.anchor = f"plot.{axes.title.lower().replace(' ', '-')}"
    unit = tuple(math.log10 if logarithmic else float for logarithmic in axes.logarithmic)
    ends = [(own(low), own(high)) for own, (low, high) in zip(unit, (axes.x, axes.y), strict=True)]
    window = Window(0.0, 0.0, layout.width, layout.height, ends[0], ends[1], axes.names, axes.logarithmic)

    def at(x: float, y: float) -> Point:
        return window.place((unit[0](x), unit[1](y)))

    figure.line("axis", (layout.width, 0.0), (0.0, 0.0), (0.0, layout.height))
    _numbered(figure, axes, layout, at)
    curves = [("reference", curve) for curve in axes.references]
    curves += [(curve.look or _shade(i, len(axes.curves)), curve) for i, curve in enumerate(axes.curves)]
    traces = []
    for look, curve in curves:
        text = curve.label if look == "reference" else f"${curve.label}$"
        if curve.label:
            tone = "note" if look == "reference" else look.replace("curve", "accent")
            figure.label(text, at(curve.x, curve.y), curve.anchor, f"on {tone}")
        points = tuple((unit[0](x), unit[1](y)) for x, y in curve.rows)
        traces.append(Trace(look, curve.name or (text if curve.label else axes.names[1]), points))
    for mark in axes.marks:
        figure.dot(f"dot {mark.look}", at(mark.x, mark.y))
        figure.label(f"${mark.label}$", at(mark.x, mark.y), mark.anchor, f"beside {mark.look}")
    figure.window = replace(window, traces=tuple(traces))
    named = ", ".join(dict.fromkeys(trace.name for trace in traces))
    figure.seen += f"; curves: {named}" if len(traces) > 1 else ""
    return figure


def _numbered(figure: Drawing, axes: Axes, layout: Layout, at: Callable[[float, float], Point]) -> None:
    """The ticks with their numbers, and the names of the axes."""
    (dx, dy), side = layout.across
    widest = 0.0
    for value in axes.ticks[0]:
        x, _ = at(value, axes.y[0])
        figure.line("tick", (x, 0.0), (x, -layout.tick))
        if x < layout.width or layout.up is None:  # the name of the axis stands in the corner
            figure.label(_number(value), (x, -layout.tick), "north", "tick")
    for value in axes.ticks[1]:
        _, y = at(axes.x[0], value)
        figure.line("tick", (0.0, y), (-layout.tick, y))
        figure.label(_number(value), (-layout.tick, y), "east", "tick")
        widest = max(widest, 3.6 if "^" in _number(value) else sum(LETTER.get(c, 1.4) for c in f"{value:g}"))
    figure.label(axes.names[0], (layout.width + dx, dy), side, "name")
    if layout.up is None:
        figure.label(axes.names[1], (-layout.tick - widest - 1.0, layout.height / 2), "south", "name", turned=True)
    else:
        (dx, dy), side = layout.up
        figure.label(axes.names[1], (dx, layout.height + dy), side, "name")


def _number(value: float) -> str:
    """A number at a tick; a power of ten as one."""
    power = round(math.log10(value)) if value > 0 else 0
    if abs(power) > 1 and value == float(f"1e{power}"):
        return f"$10^{{{power}}}$"
    return f"{value:g}".replace("-", "\N{MINUS SIGN}")


def _shade(index: int, count: int) -> str:
    """From light to dark over the curves of a family."""
    return f"curve tone{round(index * (TONES - 1) / (count - 1))}" if count > 1 else "curve"
