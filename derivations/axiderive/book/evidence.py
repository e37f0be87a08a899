"""How well the formulas are known, counted: the matrix of profile and physics, the coverage of a page, the README.

The cells of the matrix say what is certified and what was compared; no cell is silent. The README has them as tables,
and that of error against run time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

from ..physics import systems
from ..profiles import pools

LEGEND = {
    "✓": "certified: an exact proof of the formula, or of the equation and its one root",
    "○": "closed form without a certificate, compared with its definition to the digits behind it",
    "∫": "one integral without a closed form, compared with its definition to the digits behind it",
    "=": "by an integral equation, solved in numbers and compared with its definition to the digits behind it",
    "≈": "begins the solution of an integral equation, compared with it where what is left out is below those digits",
    "√": "root of an equation, solved by iteration and compared with its definition to the digits behind it",
    "–": "not meaningful; the module says why",
}
LEFT_OUT = "left out"
NOT_VERIFIED = "not verified"
SIGNS = {"closed": "○", "integral": "∫", "root": "√", "equation": "=", "expansion": "≈"}


def matrix(derived: Iterable[str], evidence: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """The cells by profile and system.

    Parameters
    ----------
    derived : iterable of str
        Keys of the problems.
    evidence : mapping
        What was found about them, by key.
    """
    profiles: dict[str, dict[str, str]] = {}
    for key in derived:
        problem = systems.problem(key)
        profiles.setdefault(problem.profile_id, {})[problem.system.name] = _known(evidence[key]["entries"])
    for pool in pools.POOLS:
        for system in (system for system in systems.SYSTEMS if system.pool is pool):
            for name in pool.names:
                if pool.id(name) in profiles and system.refusal(pool.load(name)):
                    profiles[pool.id(name)][system.name] = "–"
    ordered = {
        name: {s.name: cells[s.name] for s in systems.SYSTEMS if s.name in cells} for name, cells in profiles.items()
    }
    found = [entry for record in evidence.values() for entry in record.get("entries", {}).values()]
    return {"legend": LEGEND, "profiles": ordered, "twice": twice(found)}


def twice(found: Iterable[Mapping[str, Any]]) -> str:
    """How many certified formulas were proved by both provers; a formula of several cases counts as many."""
    proofs = [entry["twice"] for entry in found if entry["certified"] and "twice" in entry]
    shown, certified = (sum(proof["cases"] for proof in own) for own in ([p for p in proofs if p["shown"]], proofs))
    return (
        f"{shown} of {certified} certified formulas were proved again by a second program, which shares no code with"
        " the first and reads only what is stored"
    )


NONE = {"formulas": 0, "certified": 0, "twice": 0, **dict.fromkeys(SIGNS, 0)}
"""How the formulas of nothing are known."""


def coverage(found: Sequence[Mapping[str, Any]]) -> dict[str, int]:
    """How formulas are known by what was found of each: counts, and the least digits of their comparisons.

    `least` counts every check of every formula, and is zero where one agreed with nothing.
    """
    left = [one for one in found if not one["certified"]]
    agreed = [[c["digits"] for c in one["checks"] if c["outcome"] == "passed" and c.get("digits")] for one in found]
    return {
        "formulas": len(found),
        "certified": len(found) - len(left),
        "twice": sum(bool(one.get("twice", {}).get("shown")) for one in found if one["certified"]),
        **{status: sum(one["status"] == status for one in left) for status in SIGNS},
        "digits": min((digits for one in found if (digits := _digits(one["checks"]))), default=0),
        "least": min((min(digits, default=0) for digits in agreed), default=0),
    }


def _known(entries: Mapping[str, Mapping[str, Any]]) -> str:
    certified, others = 0, dict[str, list[int]]()
    for found in entries.values():
        if found["certified"]:
            certified += 1
        else:
            others.setdefault(SIGNS[found["status"]], []).append(_digits(found["checks"]))
    parts = [f"{certified} ✓"] if certified else []
    parts += [f"{len(digits)} {sign}{min(digits)}" for sign, digits in others.items()]
    return ", ".join(parts) or NOT_VERIFIED


def _digits(checks: Iterable[Mapping[str, Any]]) -> int:
    """Digits of the best comparison that passed."""
    return max((check["digits"] for check in checks if check["outcome"] == "passed" and check["worst"]), default=0)


def power_of_ten(text: str) -> str:
    """2.7e-51 as 2.7 x 10^-51."""
    mantissa, _, exponent = text.partition("e")
    if exponent and float(mantissa) == 0:
        return "0"
    return f"{mantissa}\\times10^{{{int(exponent)}}}" if exponent else text


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
