"""Misprints: the LaTeX of a formula with one token changed that can still be read."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

from axiderive.readback.grammar import read

LAYOUT = re.compile(
    r"\\(?:begin|end)\{[^}]*\}(?:\[t\])?|\\\\\[[^\]]*\]|\\q?quad|\\enspace|\\displaystyle|\\[,;:! ]"
    r"|\\(?:mathrm|operatorname|mathbf|bar)(?:\{[^}]*\}| ?\w)|\{\}_\{\d\}|\\[dt]?frac|[{}^_]"
)
SYMBOL = re.compile(r"\\(?:kappa|psi|theta|lambda|mu|nu|eta|tau|varphi|beta)(?![a-z])|[A-Za-z]")
FUNCTIONS = (r"\sin", r"\cos", r"\tan", r"\arcsin", r"\arccos", r"\arctan", r"\ln", r"\exp")
AREA = (r"\operatorname{arcosh}", r"\operatorname{arsinh}", r"\operatorname{artanh}")
BRACKET = re.compile(r"(?:\\[bB]ig[r])?(?:[)\]]|\\\})")
TOKEN = re.compile(r"\\operatorname\{\w+\}|\\[A-Za-z]+|\d|[A-Za-z]|[-+=,;()\[\]/<]")
KINDS = ("digit", "sign", "function", "exponent", "variable", "bracket")


def misprints(tex: str, rng: random.Random) -> Iterator[tuple[str, str]]:
    """Kind and text of readable misprints of what stands behind the first equals sign, in random order."""
    start = tex.find("=") + 1
    found = [(kind, text) for kind in KINDS for text in _changed(kind, tex, start, rng)]
    rng.shuffle(found)
    for kind, text in found:
        if text != tex and _is_readable(text):
            yield kind, text


def _is_readable(tex: str) -> bool:
    try:
        read(tex)
    except (SyntaxError, ValueError, IndexError):
        return False
    return True


def _changed(kind: str, tex: str, start: int, rng: random.Random) -> Iterator[str]:
    hidden = [match.span() for match in LAYOUT.finditer(tex)]
    free = [m for m in TOKEN.finditer(tex, start) if not any(lo <= m.start() < hi for lo, hi in hidden)]
    if kind == "exponent":
        for match in re.finditer(r"\^\{(\d)\}|\^(\d)", tex[start:]):
            digit = str(int(match[1] or match[2]) % 9 + 1)
            yield tex[: start + match.start()] + f"^{{{digit}}}" + tex[start + match.end() :]
            yield tex[: start + match.start()] + tex[start + match.end() :]
        return
    if kind == "bracket":
        yield from _moved_brackets(tex, start)
        return
    names = sorted({m[0] for m in free if SYMBOL.fullmatch(m[0])} | {"a"})
    for match in free:
        for new in _others(kind, match[0], names, rng):
            glue = " " if new[-1:].isalpha() and tex[match.end() : match.end() + 1].isalpha() else ""
            yield tex[: match.start()] + new + glue + tex[match.end() :]
    if kind == "function":
        for match in re.finditer(r"\\operatorname\{ar\w+\}", tex):
            new = rng.choice([name for name in AREA if name != match[0]])
            yield tex[: match.start()] + new + tex[match.end() :]


def _others(kind: str, token: str, names: list[str], rng: random.Random) -> list[str]:
    if kind == "digit" and token.isdigit():
        return [str(int(token) % 9 + 1)]
    if kind == "sign" and token in "+-":
        return ["-" if token == "+" else "+"]
    if kind == "function" and token in FUNCTIONS:
        return [rng.choice([name for name in FUNCTIONS if name != token])]
    if kind == "variable" and token in names and len(names) > 1:
        return [rng.choice([name for name in names if name != token])]
    return []


UNIT = r"[-+]?\s*\\?\w+(?:_\{?\\?\w+\}?)?(?:\^\{\w+\})?"
"""A sign, a name and its power."""
ENDING = re.compile(UNIT + r"\s*$")
FOLLOWING = re.compile(r"\s*(?!\\(?:end|q?quad|Big|big))" + UNIT)
RADICAL = re.compile(r"(\\sqrt\{(?:[^{}]|\{[^{}]*\})*?)([-+](?:[^-+{}]|\{[^{}]*\})*)\}")


def _moved_brackets(tex: str, start: int) -> Iterator[str]:
    """A closing bracket one factor or term to the left or to the right, a root that ends one term earlier."""
    for match in BRACKET.finditer(tex, start):
        before, after = ENDING.search(tex[start : match.start()]), FOLLOWING.match(tex[match.end() :])
        if before:
            cut = start + before.start()
            yield tex[:cut] + match[0] + tex[cut : match.start()] + tex[match.end() :]
        if after:
            cut = match.end() + after.end()
            yield tex[: match.start()] + tex[match.end() : cut] + match[0] + tex[cut:]
    for match in RADICAL.finditer(tex, start):
        yield tex[: match.start()] + match[1] + "}" + match[2] + tex[match.end() :]


NAMES = ("a", "b", "c", "d", "g", "p", "r", "u", "w", "x", "F", "P", "R")
"""Letters that a name may be misprinted as."""
RELATIONS = {"<": ">", ">": "<", r"\le": r"\ge", r"\ge": r"\le"}
"""< and \\le are not told apart: on a border the value is that of either side."""
PART = re.compile(r"\\[A-Za-z]+|\d|[A-Za-z]|[-+<>]")


def left_misprints(tex: str) -> list[str]:
    """What stands before the first equals sign with one letter changed, subscripts too."""
    left, _, right = tex.partition("=")
    found = []
    for match in re.finditer(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])", left):
        upright = left[: match.start()].endswith((r"\mathrm ", r"\mathrm{")) and match[0] == "d" and "frac" in left
        others = [name for name in (*NAMES, "m", "N") if name != match[0]] if not upright else []
        found += [left[: match.start()] + name + left[match.end() :] for name in others]
    found += [text for text in (left.replace(r"\mu", r"\nu"), left.replace(r"\tau", "p")) if text != left]
    return [f"{text}={right}" for text in found if _is_readable(f"{text}={right}")]


def range_misprints(condition: str, names: tuple[str, ...] = ()) -> list[str]:
    """A printed range with one letter, digit, sign or relation changed, and those that can still be read."""
    hidden = [m.span() for m in LAYOUT.finditer(condition)] + [m.span() for m in re.finditer(r"\\[A-Za-z]+", condition)]
    letters = sorted({m[0] for m in re.finditer(r"(?<![A-Za-z\\])[A-Za-z](?![A-Za-z])", condition)} | {*names, "a"})
    found = []
    for match in PART.finditer(condition):
        token, inside = match[0], any(lo <= match.start() < hi for lo, hi in hidden)
        others: list[str] = []
        if token in RELATIONS:
            others = [RELATIONS[token]]
        elif not inside and token.isdigit():
            others = [str(int(token) % 9 + 1)]
        elif not inside and token in letters:
            others = [name for name in letters if name != token]
        elif not inside and token in "+-":
            others = ["-" if token == "+" else "+"]
        found += [condition[: match.start()] + other + condition[match.end() :] for other in others]
    return [text for text in found if _range_is_readable(text)]


def _range_is_readable(condition: str) -> bool:
    parts = [part for chain in condition.split(r",\; ") for part in re.split(r"<|>|\\[lg]e(?![a-z])", chain)]
    return all(part.strip() and _is_readable(part) for part in parts)
