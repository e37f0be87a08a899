"""Content-addressed store of finished derivations and verifications: JSON files with their own checksum."""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache as remember
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from .writing import write_atomic


def canonical(value: object) -> str:
    """JSON text that depends on the value alone."""
    return json.dumps(value, sort_keys=True, ensure_ascii=False, separators=(",", ":"))


def digest(value: object) -> str:
    return hashlib.sha256(canonical(value).encode()).hexdigest()


@remember
def source_digest(*modules: str) -> str:
    """SHA-256 over the source of modules and packages (with everything below them) of axiderive."""
    hasher = hashlib.sha256()
    for module in sorted(modules):
        for path in _sources(module):
            hasher.update(f"{module}:{path.name}:".encode())
            hasher.update(path.read_bytes())
    return hasher.hexdigest()


VIEWS = ("axiderive.notebook",)
"""Modules that an entry asks for only to show itself."""


@remember
def import_digest(*modules: str) -> str:
    """SHA-256 over what modules compute: their own code and that of all they import of axiderive.

    Comments, docstrings, layout and the names of files do not count; modules that are imported by a name made at run
    time do not either.
    """
    pending, found = list(modules), dict[str, str]()
    while pending:
        module = pending.pop()
        if module not in found and module not in VIEWS and _source(module) is not None:
            found[module], imported = _read_module(module)
            pending += imported
    return digest(sorted(found.values()))


@remember
def _read_module(module: str) -> tuple[str, tuple[str, ...]]:
    """Digest of the code of a module, and what it imports."""
    source = _source(module)
    assert source is not None
    tree = ast.parse(source.read_bytes())
    package = module if source.name == "__init__.py" else module.rpartition(".")[0]
    imported = tuple(_imported(tree, package))
    return hashlib.sha256(ast.dump(_bare(tree)).encode()).hexdigest(), imported


def _source(module: str) -> Path | None:
    root = Path(__file__).resolve().parents[1].joinpath(*module.split("."))
    return next((path for path in (root.with_suffix(".py"), root / "__init__.py") if path.is_file()), None)


def _imported(tree: ast.Module, package: str) -> Iterator[str]:
    """Modules of the engine that a module imports when it runs, and names that may be modules."""
    parts = package.split(".")
    for node in _running(tree):
        if isinstance(node, ast.ImportFrom) and node.level:
            base = ".".join([*parts[: len(parts) - node.level + 1], *([node.module] if node.module else [])])
            yield base
            yield from (f"{base}.{alias.name}" for alias in node.names)


def _running(node: ast.AST) -> Iterator[ast.AST]:
    """All nodes but those that only a type checker reads."""
    yield node
    if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
        return
    for child in ast.iter_child_nodes(node):
        yield from _running(child)


def _bare(tree: ast.Module) -> ast.Module:
    """The tree without strings that stand alone."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            node.body = [one for one in node.body if not _words(one)]
    return tree


def _words(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


def _sources(module: str) -> list[Path]:
    spec = find_spec(module)
    if spec is None or spec.origin is None:
        return []
    origin = Path(spec.origin)
    if spec.submodule_search_locations is None:
        return [origin]
    return sorted(p for p in origin.parent.rglob("*") if p.is_file() and "__pycache__" not in p.parts)


@dataclass(frozen=True)
class Cache:
    """Folder of values by key; `fresh` ignores what is stored, and still stores."""

    folder: Path
    fresh: bool = False

    def path(self, key: str) -> Path:
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

    def put(self, key: str, value: object) -> None:
        record = {"key": key, "sha256": digest(value), "value": value}
        write_atomic(self.path(key), (json.dumps(record, ensure_ascii=False, indent=1) + "\n").encode())
