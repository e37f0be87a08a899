"""The rational kernels of the runtime as literals: fitted to functions that cancel near zero."""

from __future__ import annotations

from collections.abc import Callable

import mpmath as mp

from ..stable.kernels import fit

KERNELS: dict[str, tuple[str, Callable[[mp.mpf], mp.mpf], float]] = {
    "ARCTAN_GAP": ("(x - atan x)/x**3, x**2 <= 1", lambda v: (mp.sqrt(v) - mp.atan(mp.sqrt(v))) / v**1.5, 1.0),
    "TANH_GAP": ("(y - tanh y)/y**3, y**2 <= 1", lambda v: (mp.sqrt(v) - mp.tanh(mp.sqrt(v))) / v**1.5, 1.0),
    "DAWSON": ("exp(x**2) D(x)/x, x**2 <= 4", lambda v: mp.erfi(mp.sqrt(v)) * mp.sqrt(mp.pi / v) / 2, 4.0),
}
"""By name: what is fitted as a function of the square v of its argument, in words and in mpmath, and up to which v."""


def kernels_source() -> str:
    """The text of `_kernels.py`."""
    lines = [
        '"""Rational kernels P(v)/Q(v) as coefficients in ascending order, near-minimax to half a unit of a double."""',
        "",
        "from __future__ import annotations",
    ]
    for name, (words, function, end) in KERNELS.items():
        kernel = fit(function, end)
        lines += ["", f"# {words}", f"{name} = ("]
        for numbers in (kernel.top, kernel.bottom):
            lines += _column(numbers)
        lines.append(")")
    return "\n".join([*lines, ""])


def _column(numbers: tuple[float, ...]) -> list[str]:
    if len(numbers) == 1:
        return [f"    ({numbers[0]!r},),"]
    return ["    (", *(f"        {number!r}," for number in numbers), "    ),"]


