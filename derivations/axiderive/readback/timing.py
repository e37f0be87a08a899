"""What a page of the web edition says of error against run time, read back against the rows that were measured."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import mpmath as mp

from .claims import Line
from .numbers import rounded

Row = Mapping[str, Any]
_SENTENCE = re.compile(
    r"(?P<graded>Graded half-space, )?\$(?P<left>p\([rx]\)|w\(r\)|F_\{\\mathrm N\}\(d\))\$: "
    r"worst error \$(?P<error>[^$]+)\$ at (?P<points>\d+) points"
    r"(?:; (?P<nodes>\d+) nodes of the rule reach \$(?P<reached>[^$]+)\$)?\. "
    r"(?:No other way shown reaches \$(?P<none>[^$]+)\$"
    r"|The fastest other way to \$(?P<goal>[^$]+)\$, (?P<name>[^$]+), "
    r"takes \$(?P<times>[^$]+)\$ (?P<words>times as long|of the time))\."
)
_LETTER = re.compile(r"\\textbf\{(\w)\}~\\textcolor\{note\}\{([^}]+)\}")
SUFFIX = {"p(r)": "p", "p(x)": "p", "w(r)": "w", r"F_{\mathrm N}(d)": "Fd"}
GOAL, REACHED = "1e-12", "1e-14"
METHODS = {
    "emitted": r"the function of the catalogue",
    "lambdify": r"the printed formula through NumPy",
    "generated rule": r"its rule at every point, (.+) nodes",
    "Gauss-Jacobi": r"(?:the )?Gauss--Jacobi rule (?:for the integral, |of )(.+) nodes",
    "quad": r"adaptive quadrature",
    "mpmath": r"adaptive quadrature in (.+) digits",
    "quad and root": r"adaptive quadrature (?:and|with) root finding",
    "trapezoid MDR": r"(?:the )?trapezoidal rule(?:,| on) (.+) intervals",
}
"""The words for a method in the key and in a sentence, with the sizes they give."""
OWN = ("emitted", "generated rule")


def sentences(text: str, profile: str, record: Mapping[str, Any]) -> Iterator[Line]:
    """Every number and every name of a method in the sentences of a spread."""
    for match in _SENTENCE.finditer(text):
        own_key = _key(match, profile)
        rows = _shown(own_key, record)
        own = next(row for row in rows if row["method"] == "emitted")
        place = f"timing of {own_key}"
        yield rounded(f"{place} error", match["error"], mp.mpf(str(own["worst"])))
        yield rounded(f"{place} points", match["points"], own["points"])
        if match["nodes"]:
            enough = [_size(row) for row in _right(rows, REACHED) if row["method"] == "generated rule"]
            yield rounded(f"{place} nodes", match["nodes"], min(enough))
            yield rounded(f"{place} reached", match["reached"], mp.mpf(REACHED))
        others = [row for row in _right(rows, GOAL) if row["method"] not in OWN]
        yield rounded(f"{place} goal", match["goal"] or match["none"], mp.mpf(GOAL))
        if match["none"]:
            yield Line(place, f"no other way in {place}", lambda tex, others=others: bool(others))  # type: ignore[misc]
            continue
        best = min(others, key=lambda row: float(row["ratio"]))
        yield rounded(f"{place} times", match["times"], mp.mpf(str(best["ratio"])))
        faster = float(best["ratio"]) < 1
        yield Line(place, match["words"], lambda tex, faster=faster: (tex == "of the time") != faster)  # type: ignore[misc]
        sizes = [_size(best)] if best["setting"] else []
        yield Line(place, match["name"], lambda tex, want=(best["method"], sizes): _named(tex) != want)  # type: ignore[misc]


def key(text: str, profile: str, record: Mapping[str, Any]) -> Iterator[Line]:
    """What each letter means and the sizes in its words."""
    drawn = list(dict.fromkeys(row["method"] for row in record["rows"] if row["worst"] is not None))
    keys = {_key(match, profile) for match in _SENTENCE.finditer(text)}
    rows = [row for own in keys for row in _shown(own, record)]
    for letter, words in _LETTER.findall(text):
        method = drawn[ord(letter) - ord("a")]
        want = method, sorted({_size(row) for row in rows if row["method"] == method and row["setting"]})
        yield Line(f"letter {letter}", words, lambda tex, want=want: _named(tex) != want)  # type: ignore[misc]


def _key(match: re.Match[str], profile: str) -> str:
    return f"{profile}.{'fgm.' if match['graded'] else ''}{SUFFIX[match['left']]}"


def _shown(key: str, record: Mapping[str, Any]) -> list[Row]:
    """The rows of the methods that a page shows: many digits only if the front shows nothing of the contact."""
    contact = key.rpartition(".")[0]
    alone = {row["method"] for row in record["rows"] if row["key"].rpartition(".")[0] == contact} <= set(METHODS)
    hidden = () if alone else ("mpmath",)
    return [
        row for row in record["rows"] if row["key"] == key and row["method"] in METHODS and row["method"] not in hidden
    ]


def _named(words: str) -> tuple[str, list[int]]:
    """The method that the words mean, and the sizes in them."""
    for method, pattern in METHODS.items():
        if match := re.fullmatch(pattern, words):
            sizes = re.split(r", | and ", match[1]) if match.groups() else []
            return method, [int(size.replace(r"\,", "")) for size in sizes]
    return "", []


def _right(rows: Sequence[Row], goal: str) -> list[Row]:
    """Those that lost no value and whose worst error is at most the goal."""
    return [row for row in rows if row["worst"] is not None and row["worst"] <= float(goal) and not row["lost"]]


def _size(row: Row) -> int:
    sizes = re.findall(r"\d+", str(row["setting"]))
    return int(sizes[0])
