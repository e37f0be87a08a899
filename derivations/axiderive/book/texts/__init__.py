"""What of the book is written by hand, a file each, and how it is read: headings behind a #, cells between bars."""

from __future__ import annotations

import re
from pathlib import Path


def text(name: str) -> str:
    """The text of this name: chart, functions, guide, notation, references or words."""
    return Path(__file__).with_name(f"{name}.txt").read_text(encoding="utf-8")


def rows(table: str) -> list[list[str]]:
    """The cells of every line."""
    return [line.split(" | ") for line in table.splitlines()]


def sections(name: str) -> dict[str, str]:
    """What stands below each heading of a text."""
    return {head: body.strip() for head, body in re.findall(r"^# (.*)\n((?:(?!# ).*\n)*)", text(name), re.MULTILINE)}
