"""Where the label of a curve sits: beside, above or on it, in the frame of the pressures."""

from __future__ import annotations

from dataclasses import dataclass

Rows = list[tuple[float, float]]

HIGHEST = 3.2
"""Upper end of the pressure axis; curves are cut a little above it."""


@dataclass(frozen=True)
class Curve:
    """Coordinates, the label, where it sits, and which side of it, or its center, lies on the curve."""

    coordinates: str
    label: str
    x: float
    y: float
    anchor: str = "south"


def coordinates(rows: Rows) -> str:
    return " ".join(f"({x:.5g},{y:.5g})" for x, y in rows)


TALL = 0.24
"""Height of a label in units of the vertical axis, in the frame of the pressure."""


def labelled(family: list[Rows], index: int, label: str, taken: list[tuple[float, float]], tall: float = TALL) -> Curve:
    """The label sits where it has most room above, below or on its curve, away from other curves and labels."""
    own = family[index]
    others = [rows for i, rows in enumerate(family) if i != index and not _same(rows, own)]
    half = 0.01 + 0.009 * len(label)
    best = (-9.0, 0.5, 0.0, "south")
    for step in range(3, 48):
        x = step / 50
        near = [x + half * shift / 4 for shift in range(-4, 5)]
        top, bottom = max(_height(own, t) for t in near), min(_height(own, t) for t in near)
        crowded = any(abs(x - x1) < half + 0.1 and min(abs(top - y1), abs(bottom - y1)) < 2 * tall for x1, y1 in taken)
        if x - half < 0.01 or x + half > 1.0 or not own[0][0] <= x <= own[-1][0] or top > HIGHEST - 0.3 or crowded:
            continue
        spans = [(min(heights), max(heights)) for heights in ([_height(rows, t) for t in near] for rows in others)]
        apart = min([0.3] + [abs(_height(rows, x) - _height(own, x)) for rows in others])
        above = min([_clear(span, top, top + tall) for span in spans] + [HIGHEST - top - tall])
        below = min([_clear(span, bottom - tall, bottom) for span in spans] + [bottom - tall])
        base = 2 * apart - (top - bottom) - (0.3 if apart < 0.05 else 0.0)  # which curve is meant must show
        middle = _height(own, x)
        on = min([_clear(span, middle - tall / 2, middle + tall / 2) for span in spans] + [middle - tall / 2])
        best = max(
            best,
            (_room(above) + base, x, top, "south"),
            (_room(below) + base - 0.05, x, bottom, "north"),
            (_room(on) + base - 0.1, x, middle, "center"),
            *(
                (_beside(own, others, (x, middle), sign * half, tall) + 2 * apart - 0.1, x, middle, anchor)
                for sign, anchor in ((-1, "east"), (1, "west"))
            ),
        )
    _, x, y, anchor = best
    return Curve(coordinates(own), label, x, round(y, 3), anchor)


def _room(clear: float) -> float:
    """What a distance is worth: beyond 0.2 no more, and a label that is touched hardly anything makes good."""
    return min(clear, 0.2) if clear > 0 else 3 * clear


def _beside(own: Rows, others: list[Rows], place: tuple[float, float], half: float, tall: float) -> float:
    """Room of a label left or right of a steep curve, which has left the height of the label by its first half."""
    x, y = place
    near = [x + half * shift / 2 for shift in range(5)]
    left = abs(_height(own, x + half / 2) - y) - tall / 2
    if left < 0 or not 0.01 < near[-1] < 1.0:
        return -9.0
    spans = [(min(heights), max(heights)) for heights in ([_height(rows, t) for t in near] for rows in others)]
    clear = [_clear(span, y - tall / 2, y + tall / 2) for span in spans]
    return _room(min([*clear, left, y - tall / 2]))


def _same(rows: Rows, others: Rows) -> bool:
    """Whether two curves cannot be told apart in print."""
    return all(abs(_height(others, x) - y) < 0.05 for x, y in rows)


def _clear(span: tuple[float, float], low: float, high: float) -> float:
    """Distance between the heights of a curve beside a label and those of the label; negative where they overlap."""
    return max(span[0] - high, low - span[1])


def _height(rows: Rows, x: float) -> float:
    """Linear interpolation; beyond the ends the end value."""
    for (x0, y0), (x1, y1) in zip(rows, rows[1:], strict=False):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return rows[0][1] if x < rows[0][0] else rows[-1][1]
