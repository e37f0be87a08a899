"""Reader of the compact index: standard library only, so that `list` and `show` are instant."""

from __future__ import annotations

import ast
import difflib
import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from .exits import ENVIRONMENT, USAGE, CommandError

Row = dict[str, Any]
FIRST = ("key", "problem", "profile", "physics", "quantity")


def dumps(record: Mapping[str, Any]) -> str:
    """The index as JSON, an entry to a line and without the fields that the rest of the record tells."""
    told = _told(record)
    rows = []
    for row in record["entries"]:
        known = told(row)
        rows.append({name: value for name, value in row.items() if name not in known or known[name] != value})
    parts = [f"{_line(name)}: {_lines(value)}" for name, value in {**record, "entries": rows}.items()]
    return "{\n" + ",\n".join(parts) + "\n}\n"


def loads(text: str | bytes) -> dict[str, Any]:
    """The index with all fields of its entries.

    Raises
    ------
    ValueError
        If the text is not that of an index.
    """
    record: dict[str, Any] = json.loads(text)
    try:
        told, rows = _told(record), []
        for row in record["entries"]:
            whole = told(row) | row
            rows.append({name: whole[name] for name in dict.fromkeys((*FIRST, *row, *whole))})
    except (KeyError, TypeError) as error:
        message = f"not an index: {type(error).__name__} {error}"
        raise ValueError(message) from error
    return {**record, "entries": rows}


def _told(record: Mapping[str, Any]) -> Callable[[Row], Row]:
    """Fields of an entry from its key, its symbol and its call."""
    places = {key: (row["name"], own["physics"]) for row in record["profiles"] for key, own in row["problems"].items()}
    units = {row["name"]: row["unit"] for row in record["units"]}

    def told(row: Row) -> Row:
        problem, _, quantity = row["key"].rpartition(".")
        profile, physics = places[problem]
        found = {"problem": problem, "profile": profile, "physics": physics, "quantity": quantity}
        function = row["python"].partition("(")[0].rpartition(".")[2]
        return {**found, "function": function, "composed": [], "note": "", "unit": units.get(row["symbol"], "")}

    return told


def _lines(value: Any) -> str:
    """A list with an item to a line, anything else on one line."""
    return "[\n" + ",\n".join(map(_line, value)) + "\n]" if isinstance(value, list) else _line(value)


def _line(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


class UnknownNameError(CommandError):
    """A profile, key or topic that does not exist; the message has the nearest one."""

    code = USAGE


class NoCatalogueError(CommandError):
    """There is no catalogue to read."""

    code = ENVIRONMENT


def nearest(name: str, kind: str, known: Iterable[str]) -> UnknownNameError:
    near = difflib.get_close_matches(name, list(known), n=1, cutoff=0.5)
    hint = f"; did you mean {near[0]!r}?" if near else "; see axicontact list"
    return UnknownNameError(f"unknown {kind} {name!r}{hint}")


@dataclass(frozen=True)
class Index:
    """The index of one generated package."""

    folder: Path
    data: dict[str, Any]

    @property
    def profiles(self) -> list[Row]:
        rows: list[Row] = self.data["profiles"]
        return rows

    @property
    def entries(self) -> list[Row]:
        rows: list[Row] = self.data["entries"]
        return rows

    def profile(self, name: str) -> Row:
        for row in self.profiles:
            if row["name"] == name:
                return row
        raise nearest(name, "profile", [row["name"] for row in self.profiles])

    def select(self, key: str) -> list[Row]:
        """The entry of that key, or all entries of the problem of that key: cone, cone.adh, plane.wedge."""
        found = [row for row in self.entries if key in (row["key"], row["problem"])]
        if found:
            return found
        raise nearest(key, "key" if "." in key else "profile or key", self._candidates(key))

    def _candidates(self, key: str) -> list[str]:
        """Known keys that an unknown one may stand for, the profile mended before the quantity."""
        known = {row[name] for row in self.entries for name in ("key", "problem")}
        profiles = [row["name"] for row in self.profiles]
        own = [name for name in profiles if key.startswith(f"{name}.")]
        if own:
            return sorted(name for name in known if name.startswith(f"{max(own, key=len)}."))
        name, dot, rest = key.partition(".")
        near = difflib.get_close_matches(name, profiles, n=1, cutoff=0.5)
        if dot and near:
            return [candidate for candidate in (f"{near[0]}.{rest}", near[0]) if candidate in known]
        return profiles

    def source(self, entry: Row) -> str:
        """Text of the generated function behind an entry."""
        _, *parts, _ = entry["python"].partition("(")[0].split(".")
        path = self.folder.joinpath(*parts).with_suffix(".py")
        text = path.read_text()
        for node in ast.parse(text).body:
            if isinstance(node, ast.FunctionDef) and node.name == entry["function"]:
                first = min([node.lineno, *(decorator.lineno for decorator in node.decorator_list)])
                return "\n".join(text.splitlines()[first - 1 : node.end_lineno]) + "\n"
        message = f"{path} has no function {entry['function']}; run axicontact build"
        raise NoCatalogueError(message)


def package() -> Path:
    """Folder of the installed package that has an index, or of that of the checkout this engine lives in."""
    spec = find_spec("axicontact")
    folders = [Path(place) for place in (spec.submodule_search_locations or ())] if spec else []
    folders.append(Path(__file__).parents[2] / "catalogue" / "axicontact")
    for folder in folders:
        if (folder / "index.json").is_file():
            return folder
    message = "there is no catalogue yet; run axicontact build"
    raise NoCatalogueError(message)


def load() -> Index:
    """The index of this package."""
    folder = package()
    path = folder / "index.json"
    try:
        return Index(folder, loads(path.read_bytes()))
    except ValueError as error:
        message = f"{path} is damaged ({error}); run axicontact build"
        raise NoCatalogueError(message) from error
