"""Content-addressed store of finished derivations and verifications: JSON files with their own checksum."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from .writing import write_atomic


def canonical(value: object) -> str:
    """JSON text that depends on the value alone."""
    return json.dumps(value, sort_keys=True, ensure_ascii=False, separators=(",", ":"))


def digest(value: object) -> str:
    """SHA-256 of a value that JSON can hold, in hexadecimal."""
    return hashlib.sha256(canonical(value).encode()).hexdigest()


@dataclass(frozen=True)
class Cache:
    """Folder of values by key; `fresh` ignores what is stored, and still stores."""

    folder: Path
    fresh: bool = False

    def path(self, key: str) -> Path:
        """Where the value of a key is stored: a folder by its first two characters."""
        return self.folder / key[:2] / f"{key}.json"

    def get(self, key: str) -> Any | None:
        """The stored value, or None where there is none or the file is damaged."""
        if self.fresh:
            return None
        try:
            record = json.loads(self.path(key).read_bytes())
            value = record["value"]
            intact = record["key"] == key and record["sha256"] == digest(value)
        except (OSError, ValueError, KeyError, TypeError):
            return None
        return value if intact else None

    def made(self, key: str, make: Callable[[], Any]) -> Any:
        """The stored value of a key, or the one that is made now and stored."""
        value = self.get(key)
        if value is None:
            value = make()
            self.put(key, value)
        return value

    def put(self, key: str, value: object) -> None:
        """Stores a value under a key, with its checksum; the file is replaced as a whole."""
        record = {"key": key, "sha256": digest(value), "value": value}
        write_atomic(self.path(key), (json.dumps(record, ensure_ascii=False, indent=1) + "\n").encode())


@dataclass(frozen=True)
class Lent(Cache):
    """A store that is only read; what is made is handed to the one process that writes it."""

    made_here: dict[str, Any] = field(default_factory=dict)

    def put(self, key: str, value: object) -> None:
        """Keeps a value for the one who writes."""
        self.made_here[key] = value
