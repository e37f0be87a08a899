"""Rows in printing order, two narrow ones on one line."""

from __future__ import annotations

from collections.abc import Mapping

from ..entry import Entry
from .rows import LETTER, Row, row
from .width import width

HALF = 122.0
"""Points for the formula of half a row, beside a key of two letters."""


ORDER = (
    "Dl", "d", "ad", "P", "aP", "F", "Fd", "aF", "dF", "u", "c", "us", "k", "pm", "p", "pp", "rp", "tau", "s", "w",
    "ac", "Fc", "dc", "am", "Fm", "dm", "rz", "dmin", "Fmin", "xz", "Pmin", "phi", "cw",
    "E_star", "G_star", "H", "h_N",
)  # fmt: skip


def lines(rows: list[Row]) -> list[tuple[Row, ...]]:
    """Rows in printing order: depth and force first, fields last, two narrow ones on one line."""
    narrow = [one for one in rows if one.narrow and fits_half(one)]
    if not {"d", "F"} <= {one.suffix for one in narrow}:
        narrow = [one for one in narrow if one.suffix not in ("d", "F")]
    wide = [one for one in rows if one not in narrow]
    out = [tuple(narrow[i : i + 2]) for i in range(0, len(narrow), 2)] + [(one,) for one in wide]
    return sorted(out, key=lambda line: min(_place(one, line in out[-len(wide) :]) for one in line))


def _place(one: Row, wide: bool) -> float:
    """The force follows the depth at once where they have lines of their own."""
    return ORDER.index("d") + 0.5 if wide and one.suffix == "F" else ORDER.index(one.suffix)


def fits_half(one: Row) -> bool:
    """Whether a formula takes half a line with the words and the key behind it."""
    parts = one.remark.split("$")
    remark = sum(0.84 * width(part) if i % 2 else 3.7 * len(part) for i, part in enumerate(parts))
    behind = 12 + remark + (12 if one.uses else 0) if one.remark else 0
    return one.regions[0].width + behind + LETTER * max(0, len(one.ends) - 2) <= HALF


def ordered(entries: Mapping[str, Entry]) -> list[Row]:
    """The rows of a problem, the short ones first, fields last."""
    return [row(entries[suffix]) for suffix in ORDER if suffix in entries]
