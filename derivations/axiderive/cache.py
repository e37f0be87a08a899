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
    """SHA-256 over what modules compute: the statements of their own files and of all they import of axiderive.

    Comments, docstrings, layout, the names of files and the order and place of definitions do not count, nor does the
    version of Python; modules that are imported by a name made at run time do not either.
    """
    pending, read = list(modules), set[str]()
    statements = set[str]()
    while pending:
        module = pending.pop()
        if module not in read and module not in VIEWS and _source(module) is not None:
            read.add(module)
            found, imported = _read_module(module)
            statements.update(found)
            pending += imported
    return digest(sorted(statements))


@remember
def _read_module(module: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Digests of the statements of a module, and what it imports."""
    source = _source(module)
    assert source is not None
    tree = ast.parse(source.read_bytes())
    package = module if source.name == "__init__.py" else module.rpartition(".")[0]
    imported = tuple(_imported(tree, package))
    return tuple(hashlib.sha256(_code(one).encode()).hexdigest() for one in tree.body if not _silent(one)), imported


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


def _code(value: object) -> str:
    """A syntax tree in words that every version of Python finds: without empty fields, docstrings and own imports."""
    if isinstance(value, ast.AST):
        fields = ((name, part) for name, part in ast.iter_fields(value) if part not in (None, []) and name != "ctx")
        return f"{type(value).__name__}({','.join(f'{name}={_code(part)}' for name, part in fields)})"
    if isinstance(value, list):
        return f"[{','.join(_code(part) for part in value if not _silent(part))}]"
    return repr(value)


def _silent(node: object) -> bool:
    """Whether a statement computes nothing: a string that stands alone, or an import from within the engine."""
    words = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
    return words or isinstance(node, ast.ImportFrom) and node.level > 0


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
