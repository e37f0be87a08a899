"""Calls, definitions and imports laid out over lines as the formatter of the project lays them out."""

from __future__ import annotations

from collections.abc import Sequence

LINE = 120


def call(head: str, parts: Sequence[str], tail: str = ")", indent: int = 4) -> list[str]:
    """`head(parts)tail` on one line, else its parts on a line of their own, else one part to a line.

    The lines come without the indentation of the block they stand in.
    """
    joined = ", ".join(parts)
    if indent + len(head) + 1 + len(joined) + len(tail) <= LINE:
        return [f"{head}({joined}{tail}"]
    if indent + 4 + len(joined) <= LINE:
        return [f"{head}(", f"    {joined}", tail]
    return [f"{head}(", *(f"    {part}," for part in parts), tail]


def from_import(source: str, names: Sequence[str]) -> list[str]:
    """An import, its names in the order constants, classes, functions."""
    ordered = sorted(set(names), key=_kind)
    line = f"from {source} import {', '.join(ordered)}"
    return [line] if len(line) <= LINE else [f"from {source} import (", *(f"    {name}," for name in ordered), ")"]


def _kind(name: str) -> tuple[int, str]:
    if name.isupper() and len(name) > 1:
        return 0, name
    return (1 if name[:1].isupper() else 2), name


def fit(line: str, indent: int = 4) -> list[str]:
    """A line, or its last bracket opened where it is too long for one."""
    if indent + len(line) <= LINE or ")" not in line:
        return [line]
    close = line.rindex(")")
    place = _opening(line, close)
    return call(line[:place], split(line[place + 1 : close]), line[close:], indent)


def split(text: str) -> list[str]:
    """The parts between the commas outside all brackets."""
    parts, depth = [""], 0
    for character in text:
        depth += (character in "([{") - (character in ")]}")
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part.strip() for part in parts]


def _opening(line: str, close: int) -> int:
    depth = 0
    for place in range(close, -1, -1):
        depth += (line[place] == ")") - (line[place] == "(")
        if depth == 0:
            return place
    message = f"unbalanced brackets in {line!r}"
    raise ValueError(message)
