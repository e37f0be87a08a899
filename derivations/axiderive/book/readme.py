"""The tables of the README: how well each formula is known, and error against run time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from ..physics import systems
from ..profiles import pools
from .evidence import LEFT_OUT

MARKS = "<!-- {}: written by axicontact build -->", "<!-- end of the {} -->"
TIMED = "rounded_punch.p"
"""The formula of the table: no closed form, and a peak that the methods have to resolve."""
METHODS = {
    "emitted": "the function of this catalogue",
    "lambdify": "the printed formula through `lambdify`",
    "Gauss-Jacobi": "Gauss–Jacobi rule for the defining integral",
    "FFT MDR": "dimensionality reduction on a grid by FFT",
    "trapezoid MDR": "dimensionality reduction by the trapezoidal rule",
    "BEM": "boundary elements (tamaas)",
    "quad": "`scipy.integrate.quad`",
    "mpmath": "`mpmath.quad` at 15 digits",
}
SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def with_tables(text: str, found: Mapping[str, Any], measured: Mapping[str, Any] | None) -> str:
    """A README with its tables anew; a table without its two marks or without its record is left as it is.

    Parameters
    ----------
    text : str
        The README.
    found : mapping
        The matrix profile x physics of the index.
    measured : mapping, optional
        The record of the study error against run time.
    """
    text = _between(text, "matrix", lambda: matrix_tables(found))
    return _between(text, "measurement", lambda: timing_table(measured)) if measured else text


def _between(text: str, name: str, content: Callable[[], str]) -> str:
    begin, end = (mark.format(name) for mark in MARKS)
    head, begun, rest = text.partition(begin)
    _, ended, tail = rest.partition(end)
    return f"{head}{begin}\n\n{content()}\n\n{end}{tail}" if begun and ended else text


def matrix_tables(found: Mapping[str, Any]) -> str:
    """Two tables: the profiles of revolution by physics, and the others."""
    names = [system.name for system in systems.SYSTEMS if system.pool is pools.ROUND]
    rows = [["profile", *names]]
    for profile, cells in found["profiles"].items():
        if names[0] in cells:
            rows.append([f"`{profile}`", *(cells.get(name, LEFT_OUT) for name in names)])
    others = [["profile", "formulas"]]
    others += [[f"`{p}`", *cells.values()] for p, cells in found["profiles"].items() if names[0] not in cells]
    legend = "; ".join(f"{sign} {text}" for sign, text in found["legend"].items())
    sentences = [f"{found['twice']}."] if found.get("twice") else []
    return "\n\n".join([f"{legend}.", _table(rows), _table(others), *sentences])


def timing_table(measured: Mapping[str, Any]) -> str:
    """Time over that of the emitted function and worst relative error, each method at its most accurate setting."""
    rows = [["method", "run time", "worst relative error"]]
    for method, words in METHODS.items():
        found = [row for row in measured["rows"] if (row["key"], row["method"]) == (TIMED, method)]
        if method == "mpmath":
            found = [row for row in found if row["setting"] == "15 digits"]
        if found:
            rows.append(_row(words, min(found, key=lambda row: row["worst"])))
    return _table(rows)


def _row(words: str, best: Mapping[str, Any]) -> list[str]:
    # the function beside itself differs from 1 by the noise of the clock
    ratio = "1" if best["method"] == "emitted" else _short(best["ratio"])
    setting = best["setting"].replace(" x ", " × ") if best["method"] != "mpmath" else ""
    return [f"{words}, {setting}" if setting else words, ratio, _power(best["worst"])]


def _short(ratio: float) -> str:
    """Two digits: 0.6, 14, 2800, 1.2·10⁵."""
    return f"{ratio:.2g}" if ratio < 100 else f"{ratio:.0f}" if ratio < 1e5 else _power(ratio)


def _power(value: float) -> str:
    digits, _, exponent = f"{value:.1e}".partition("e")
    return f"{digits}·10{str(int(exponent)).translate(SUPERSCRIPT)}"


def _table(rows: list[list[str]]) -> str:
    head, *body = [f"| {' | '.join(row)} |" for row in rows]
    return "\n".join([head, "|---" * len(rows[0]) + "|", *body])
