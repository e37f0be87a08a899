"""The compact index of the catalogue: read, searched and written by the standard library only."""

from __future__ import annotations

import difflib
import json
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from ..exits import ENVIRONMENT, USAGE, CommandError

Row = dict[str, Any]
PREFIX = "axicontact."
ALIKE = ("label", "symbol", "status", "definition")
"""What most entries of a quantity of a physics say alike, which stands once in the file."""
FIRST = (
    *("key", "problem", "profile", "physics", "quantity", "label", "symbol", "status"),
    *("cases", "latex", "composed", "definition"),
)
"""Fields as every entry has them in order, whether or not they are told once for all."""


def dumps(record: Mapping[str, Any]) -> str:
    """The index as JSON, an entry to a line and without the fields that the rest of the record tells."""
    whole: list[Row] = record["entries"]
    record = {name: value for name, value in record.items() if name != "entries"} | {"quantities": _alike(whole)}
    told = _told(record)
    rows = []
    for row in whole:
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
            rows.append({name: whole[name] for name in dict.fromkeys((*FIRST, *row, *whole)) if name in whole})
    except (KeyError, TypeError) as error:
        message = f"not an index: {type(error).__name__} {error}"
        raise ValueError(message) from error
    record.pop("quantities", None)
    return {**record, "entries": rows}


def _alike(rows: Sequence[Row]) -> list[Row]:
    """What stands once, by physics and quantity."""
    found: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        found.setdefault((row["physics"], row["quantity"]), []).append(row)
    return [
        {"physics": physics, "quantity": quantity}
        | {name: Counter(row[name] for row in own).most_common(1)[0][0] for name in ALIKE}
        for (physics, quantity), own in found.items()
    ]


def _told(record: Mapping[str, Any]) -> Callable[[Row], Row]:
    """Fields of an entry from its key, its symbol and its call, and what is said alike of its quantity."""
    places = {key: (row["name"], own["physics"]) for row in record["profiles"] for key, own in row["problems"].items()}
    units = {row["name"]: row["unit"] for row in record["units"]}
    alike = {(row["physics"], row["quantity"]): row for row in record.get("quantities", ())}

    def told(row: Row) -> Row:
        problem, _, quantity = row["key"].rpartition(".")
        profile, physics = places[problem]
        found = {"problem": problem, "profile": profile, "physics": physics, "quantity": quantity}
        found |= alike.get((physics, quantity), {})
        function = row["python"].partition("(")[0].rpartition(".")[2]
        unit = units.get(row.get("symbol", found.get("symbol")), "")
        return {**found, "function": function, "composed": [], "note": "", "unit": unit}

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
    """The error for an unknown name, with the known one most like it; it is returned, not raised."""
    near = difflib.get_close_matches(name, list(known), n=1, cutoff=0.5)
    return _unknown(kind, name, near)


def _unknown(kind: str, name: str, near: Iterable[str], see: str = "list") -> UnknownNameError:
    meant = " or ".join(map(repr, near))
    hint = f"did you mean {meant}?" if meant else f"see axicontact {see}"
    return UnknownNameError(f"unknown {kind} {name!r}; {hint}")


MOST_NAMED = 3
"""Profiles that are named together; a word that more of them have says too little."""
LEAST_LIKE = 0.5


def _likeness(stem: str, name: str) -> float:
    """1 for the name itself, less for its beginning and for what shares letters with it."""
    ratio = difflib.SequenceMatcher(None, stem.casefold(), name).ratio()
    return max(ratio, 0.9) if stem and name.startswith(stem.casefold()) and stem != name else ratio


def module_of(row: Row) -> str:
    """The module of a formula, below the package."""
    return str(row["python"]).partition("(")[0].removeprefix(PREFIX).rpartition(".")[0]


def _places(row: Row) -> tuple[str, str, str]:
    """The module of a formula, its function there, and the module with the end of its key."""
    module = module_of(row)
    return module, f"{module}.{row['function']}", f"{module}.{row['quantity']}"


def _words(profile: Row) -> str:
    """What a profile is called and whose work it is."""
    return " ".join((profile["name"], profile["title"], *profile["synonyms"], *profile["sources"])).casefold()


@dataclass(frozen=True)
class Index:
    """The index of one generated package."""

    folder: Path
    data: dict[str, Any]

    @property
    def profiles(self) -> list[Row]:
        """The rows of all profiles."""
        rows: list[Row] = self.data["profiles"]
        return rows

    @property
    def entries(self) -> list[Row]:
        """The rows of all formulas."""
        rows: list[Row] = self.data["entries"]
        return rows

    def profile(self, name: str) -> Row:
        """The row of a profile by its name; UnknownNameError with the nearest name if there is none."""
        for row in self.profiles:
            if row["name"] == name:
                return row
        raise nearest(name, "profile", [row["name"] for row in self.profiles])

    def select(self, key: str) -> list[Row]:
        """The entry of that key, or all entries of the problem of that key: cone, cone.adh, plane.wedge.

        A module or function of the package is such a key too, as `adhesive.cone` or `axicontact.normal.cone.force`.
        """
        found = [row for row in self.entries if key in (row["key"], row["problem"])]
        found = found or [row for row in self.entries if key.removeprefix(PREFIX) in _places(row)]
        if found:
            return found
        raise self._not_known(key)

    def wanted(self, keys: Sequence[str]) -> dict[str, set[str]]:
        """The keys of entries by problem, all without any; the name of a profile stands for all of its problems."""
        whole = {row["name"]: list(row["problems"]) for row in self.profiles}
        found: dict[str, set[str]] = {}
        for own in (own for key in keys or whole for own in whole.get(key, [key])):
            for entry in self.select(own):
                found.setdefault(entry["problem"], set()).add(entry["key"])
        return found

    def _not_known(self, key: str) -> UnknownNameError:
        """The error that leads to what an unknown key may stand for, the profile mended before the quantity."""
        asked = ".".join(key.split())
        kind = "key" if "." in asked else "profile or key"
        named = [row["name"] for row in self.profiles if row["name"] == asked.casefold()]
        named = named or [row["name"] for row in self.profiles if asked.casefold() in _words(row)]
        if named:
            return _unknown(kind, key, named if len(named) <= MOST_NAMED else [])
        parts = asked.split(".")
        # plane.wedge is a profile of two words, cone one of one
        stems = ((".".join(parts[:n]), ".".join(parts[n:]), row["name"]) for n in (1, 2) for row in self.profiles)
        likeness, rest, profile = max((_likeness(stem, name), rest, name) for stem, rest, name in stems)
        if likeness < LEAST_LIKE:
            return _unknown(kind, key, [])
        if not rest:
            return _unknown(kind, key, [profile])
        quantities = self._quantities(profile)
        name = rest if rest in quantities else rest.casefold()
        near = [quantities[one] for one in difflib.get_close_matches(name, quantities, n=1, cutoff=LEAST_LIKE)]
        return _unknown(kind, key, near or ([profile] if likeness < 1.0 else []), f"show {profile}")

    def _quantities(self, profile: str) -> dict[str, str]:
        """Keys of a profile by what follows its name: p, adh, adh.p, and the functions pressure, adh.pressure."""
        found: dict[str, str] = {}
        for row in (row for row in self.entries if row["profile"] == profile):
            part = row["problem"].removeprefix(profile).removeprefix(".")
            names = {row["quantity"]: row["key"], row["function"]: row["key"]}
            own = {f"{part}.{name}".lstrip("."): key for name, key in names.items()}
            found = {**own, **(dict.fromkeys((part, row["physics"]), row["problem"]) if part else {}), **found}
        return {name.casefold(): key for name, key in found.items()} | found


def package() -> Path:
    """Folder of the installed package that has an index, or of that of the checkout this engine lives in."""
    spec = find_spec("axicontact")
    folders = [Path(place) for place in (spec.submodule_search_locations or ())] if spec else []
    folders.append(Path(__file__).parents[3] / "catalogue" / "axicontact")
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


def evidence(folder: Path, key: str) -> dict[str, Any]:
    """What the evidence in a folder holds of a problem."""
    path = folder / f"{key}.json"
    try:
        record: dict[str, Any] = json.loads(path.read_bytes())
    except FileNotFoundError as error:
        message = f"{path} does not exist; run axicontact build in a checkout of the project"
        raise NoCatalogueError(message) from error
    except ValueError as error:
        message = f"{path} is damaged ({error}); run axicontact build"
        raise NoCatalogueError(message) from error
    return record


def table(rows: Sequence[Sequence[str]]) -> str:
    """Rows as columns; the last column is not padded."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]
    return "\n".join(
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows
    )
