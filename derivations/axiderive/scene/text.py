"""The text of a scene with its lines: where a key stands, and all problems collected with line, rule and next step."""

from __future__ import annotations

import difflib
import re
import tomllib
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..exits import USAGE, CommandError

LARGEST = 100_000
SECTION = re.compile(r"\s*\[+\s*([\w.\"'-]+)\s*\]+")
KEY = re.compile(r"\s*[\"']?([\w.-]+)[\"']?\s*=")


class SceneError(CommandError):
    """All problems of a scene."""

    code = USAGE


def load(path: Path) -> SceneText:
    """The scene of a file.

    Raises
    ------
    SceneError
        If it cannot be read, is no UTF-8 or no TOML.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        message = f"{path}: {error.strerror or error}; give the path of a scene, see examples/"
        raise SceneError(message) from error
    return parse(str(path), data)


def parse(name: str, data: bytes) -> SceneText:
    """The scene of these bytes."""
    if len(data) > LARGEST:
        message = f"{name}: {len(data)} bytes are no scene, at most {LARGEST} are read"
        raise SceneError(message)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        message = f"{name}:{line}: byte {data[error.start]:#04x} is no UTF-8; save the scene as UTF-8"
        raise SceneError(message) from error
    try:
        values = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        where = re.search(r"line (\d+)", str(error))
        line = int(where[1]) if where else text.count("\n") + 1
        reason = str(error).split(" (at")[0][:120] if not isinstance(error, RecursionError) else "nested too deeply"
        lines = text.splitlines()
        advice = _advice(reason, lines[line - 1] if 0 < line <= len(lines) else "")
        raise SceneError(SceneText(name, text, {}).at(line, f"no TOML: {reason}; {advice}")) from error
    return SceneText(name, text, values)


def _advice(reason: str, line: str) -> str:
    """What to do about a line that is no TOML."""
    if "overwrite" in reason or "twice" in reason:
        return "each section and each key stands once, leave one of them out"
    if re.search(r"=\s*\d+,\d", line):
        return "decimals have a point, as 2.0"
    return "is a quote or a bracket missing?"


@dataclass
class SceneText:
    """A scene as read, and what is wrong with it."""

    name: str
    text: str
    values: dict[str, Any]
    problems: list[tuple[int, str]] = field(default_factory=list)

    def line_of(self, section: str, key: str = "") -> int:
        """Line of a key, of its section, or 0."""
        current, found = "", 0
        for number, line in enumerate(self.text.splitlines(), 1):
            if match := SECTION.match(line):
                current = match[1]
                found = number if current == section and not found else found
            elif current == section and key and (match := KEY.match(line)) and match[1] == key:
                return number
            elif not current and section and (match := KEY.match(line)):
                if key and match[1] == f"{section}.{key}":
                    return number
                found = number if match[1].split(".")[0] == section else found
        return found

    def problem(self, section: str, key: str, message: str) -> None:
        """Collects a problem with the line of its key."""
        line = self.line_of(section, key)
        self.problems.append((line, self.at(line, message)))

    def at(self, line: int, message: str) -> str:
        """A message with file, line number and the line itself."""
        lines = self.text.splitlines()
        where = f"{self.name}:{line}" if line else self.name
        source = f"\n  {line:4} | {_shown(lines[line - 1])}" if 0 < line <= len(lines) else ""
        return f"{where}: {message}{source}"

    def table(self, section: str, known: Iterable[str] | None = None) -> dict[str, Any]:
        """A section, empty if there is none; its unknown keys are problems."""
        table = self.values.get(section, {})
        if not isinstance(table, dict):
            what = f"{section} must be a section, not {type(table).__name__}"
            self.problem(section, "", f"{what}; write [{section}] and its keys below it")
            return {}
        if known is not None:
            for key in table:
                if key not in known:
                    self.problem(section, key, f"unknown key in [{section}] {key[:40]!r}{near(key, known)}")
        return table

    def finish(self) -> None:
        """Raise what was found, in order of lines."""
        if not self.problems:
            return
        count = len(self.problems)
        rows = [text for _, text in sorted(self.problems, key=lambda row: row[0])]
        rows.append(f"{count} problem{'s' if count > 1 else ''} in the scene; nothing was written")
        raise SceneError("\n".join(rows))


def near(word: str, known: Iterable[str]) -> str:
    """The end of a message: the known word most like this one, else the known ones."""
    options = list(known)
    found = difflib.get_close_matches(word, options, n=1, cutoff=0.5)
    return f"; did you mean {found[0]!r}?" if found else f"; there are {', '.join(options[:30])}"


def _shown(line: str) -> str:
    return "".join(c if c.isprintable() else " " for c in line[:100]).rstrip()
