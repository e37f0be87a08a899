"""The rational kernels of the runtime as literals: fitted to functions that cancel near zero."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import mpmath as mp

from ..stable.kernels import fit

EXPONENTS = (1, 2, 4, 6)
"""Of r**n, for which the displacement beside the contact has a kernel."""


def outside(n: int, v: mp.mpf) -> mp.mpf:
    """pi/2 w/g(a) over s = a/r for f ~ r**n: (asin(s) - int_0^s t**n/sqrt(1 - t**2) dt/s**n)/s, s = sin(sqrt(v))."""
    angle = mp.sqrt(v)
    sine, cosine = mp.sin(angle), mp.cos(angle)
    punches = [angle, 1 - cosine]
    for k in range(2, n + 1):
        punches.append(((k - 1) * punches[k - 2] - sine ** (k - 1) * cosine) / k)
    return (angle - punches[n] / sine**n) / sine


KERNELS: dict[str, tuple[str, Callable[[mp.mpf], mp.mpf], float]] = {
    "ARCTAN_GAP": ("(x - atan x)/x**3, x**2 <= 1", lambda v: (mp.sqrt(v) - mp.atan(mp.sqrt(v))) / v**1.5, 1.0),
    "TANH_GAP": ("(y - tanh y)/y**3, y**2 <= 1", lambda v: (mp.sqrt(v) - mp.tanh(mp.sqrt(v))) / v**1.5, 1.0),
    "DAWSON": ("exp(x**2) D(x)/x, x**2 <= 4", lambda v: mp.erfi(mp.sqrt(v)) * mp.sqrt(mp.pi / v) / 2, 4.0),
} | {
    f"OUTSIDE_{n}": (f"displacement beside a contact with r**{n}, angle**2 <= (pi/2)**2", partial(outside, n), 2.4675)
    for n in EXPONENTS
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
