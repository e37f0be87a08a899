"""Digests of the engine's own code: of whole files, or of only the statements that functions reach."""

from __future__ import annotations

import ast
import hashlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from .cache import Cache, digest

LEFT_OUT = ("axiderive.book.latex", *(f"axiderive.profiles.{name}" for name in ("compact", "complete", "plane")))
"""What an entry asks for only to show itself; and lists of profiles, whose records stand in the keys without texts."""
Place = tuple[str, str | None]
"""A module and a name in it; the empty name is all of the module, None what it does when it is imported."""


@cache
def source_digest(*modules: str) -> str:
    """SHA-256 over the source of modules and packages (with everything below them) of axiderive."""
    hasher = hashlib.sha256()
    for module in sorted(modules):
        for path in _files(module):
            hasher.update(f"{module}:{path.name}:".encode())
            hasher.update(path.read_bytes())
    return hasher.hexdigest()


@cache
def import_digest(*names: str, apart: frozenset[str] = frozenset()) -> str:
    """SHA-256 over what functions, or modules, compute: their statements and all these use of axiderive.

    Comments, docstrings, layout, the place of a definition and the version of Python do not count.  What is imported
    by a name made at run time does not either, nor what modules hold that are called as one of those `apart`.
    """
    pending: list[Place] = [_place(*name.rpartition(".")[::2]) for name in names]
    seen, found = set[Place](), set[str]()
    others = {module.rpartition(".")[2] for module in apart}
    while pending:
        place = pending.pop()
        module, name = place
        if place in seen or module in LEFT_OUT or module.rpartition(".")[2] in others or _source(module) is None:
            continue
        seen.add(place)
        own = _module(module)
        pending.append((module, None))
        for statement in own.statements:
            if name == "" or name in statement.binds or (name is None and not statement.binds):
                found.add(statement.code)
                pending += own.needs(statement)
        if name in own.imported:  # handed on from another module
            pending.append(_place(*own.imported[name]))
        if name is None:
            pending += [_place(*own.imported[local]) for local in own.for_effect]
    _KEPT.save()
    return hashlib.sha256("".join(sorted(found)).encode()).hexdigest()


def modules_of(package: str) -> list[str]:
    """The modules of a package, whose sections are imported by name."""
    return [f"{package}.{path.stem}" for path in _files(package) if path.suffix == ".py" and path.stem != "__init__"]


@contextmanager
def kept(cache: Cache) -> Iterator[None]:
    """In here what the files of the engine say is kept in a cache, by their contents: to read all takes two seconds."""
    global _KEPT
    outer, _KEPT = _KEPT, _Kept(cache)
    try:
        yield
    finally:
        _KEPT = outer


@dataclass
class _Kept:
    """What modules say by name, each with the digest of the file that says it."""

    cache: Cache | None = None
    records: dict[str, Any] = field(default_factory=dict)
    changed: bool = False

    def __post_init__(self) -> None:
        self.key = digest(["statements", hashlib.sha256(Path(__file__).read_bytes()).hexdigest()])
        self.records = (self.cache and self.cache.get(self.key)) or {}

    def record(self, name: str, source: Path) -> Any:
        """What a module says, from the cache or from its file."""
        content = source.read_bytes()
        made_of = hashlib.sha256(content).hexdigest()
        known = self.records.get(name)
        if known is None or known["file"] != made_of:
            known = self.records[name] = {"file": made_of, **_read(name, content, source.name == "__init__.py")}
            self.changed = True
        return known

    def save(self) -> None:
        """Into the cache, if there is one and something new to be kept."""
        if self.cache and self.changed:
            self.cache.put(self.key, self.records)
            self.changed = False


_KEPT = _Kept()


@dataclass(frozen=True)
class _Statement:
    code: str
    """SHA-256 of what the statement computes, without docstrings and own imports."""
    binds: frozenset[str]
    uses: frozenset[tuple[str, str]]
    """Names, each with the attribute that is taken of it, or an empty one."""


@dataclass(frozen=True)
class _Module:
    name: str
    statements: tuple[_Statement, ...]
    imported: dict[str, tuple[str, str]]
    """Where a name comes from: a module of the engine, and a name in it that may be a module too."""

    @property
    def for_effect(self) -> list[str]:
        """What is imported and nowhere used."""
        used = {name for statement in self.statements for name, _ in statement.uses}
        return [name for name in self.imported if name not in used]

    def needs(self, statement: _Statement) -> Iterator[Place]:
        """The places a statement uses: module and name, the name empty where all of a module is meant."""
        for name, attribute in statement.uses:
            if name not in self.imported:
                yield self.name, name
                continue
            module, own = _place(*self.imported[name])
            yield (module, attribute) if own == "" else (module, own)


def _place(module: str, name: str) -> Place:
    """All of a module where the name is one, else the name in the module."""
    return (f"{module}.{name}", "") if _source(f"{module}.{name}") else (module, name)


@cache
def _module(name: str) -> _Module:
    source = _source(name)
    assert source is not None
    record = _KEPT.record(name, source)
    statements = (
        _Statement(code, frozenset(binds), frozenset((used, attribute) for used, attribute in uses))
        for code, binds, uses in record["statements"]
    )
    imported = {local: (module, own) for local, (module, own) in record["imported"].items()}
    return _Module(name, tuple(statements), imported)


def _read(name: str, content: bytes, is_package: bool) -> dict[str, Any]:
    """The statements of a module and what it imports of the engine, as JSON holds them."""
    tree = ast.parse(content)
    package = name.split(".") if is_package else name.split(".")[:-1]
    body = [part for one in tree.body if not _silent(one) for part in _parts(one)]
    statements = [
        [hashlib.sha256(_code(one).encode()).hexdigest(), sorted(_binds(one)), sorted(set(_uses(one)))] for one in body
    ]
    return {"statements": statements, "imported": dict(_imported(tree, package))}


@cache
def _source(module: str) -> Path | None:
    root = Path(__file__).resolve().parents[2].joinpath(*module.split("."))
    return next((path for path in (root.with_suffix(".py"), root / "__init__.py") if path.is_file()), None)


def _imported(node: ast.AST, package: list[str]) -> Iterator[tuple[str, tuple[str, str]]]:
    """The names that a module imports of the engine when it runs, inside its functions too, and their origin."""
    if isinstance(node, ast.ImportFrom) and node.level:
        base = ".".join([*package[: len(package) - node.level + 1], *([node.module] if node.module else [])])
        yield from ((alias.asname or alias.name, (base, alias.name)) for alias in node.names)
    if not _for_types(node):
        for child in ast.iter_child_nodes(node):
            yield from _imported(child, package)


def _parts(node: ast.stmt) -> list[ast.stmt]:
    """An import of several names as one of each: how they are collected does not count."""
    if isinstance(node, ast.ImportFrom):
        return [ast.ImportFrom(node.module, [alias], node.level) for alias in node.names]
    return [node]


def _binds(node: ast.stmt) -> frozenset[str]:
    """The names that a statement defines; none where it does something else."""
    if isinstance(node, ast.FunctionDef | ast.ClassDef):
        return frozenset({node.name})
    if isinstance(node, ast.Import | ast.ImportFrom):
        return frozenset((alias.asname or alias.name).partition(".")[0] for alias in node.names)
    targets = node.targets if isinstance(node, ast.Assign) else [node.target] if isinstance(node, ast.AnnAssign) else []
    named = [one for target in targets for one in (target.elts if isinstance(target, ast.Tuple) else [target])]
    if not all(isinstance(one, ast.Name) for one in named):
        return frozenset()
    return frozenset(one.id for one in named if isinstance(one, ast.Name))


def _uses(node: ast.AST) -> Iterator[tuple[str, str]]:
    if isinstance(node, ast.Name):
        yield node.id, ""
    elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        yield node.value.id, node.attr
    else:
        for child in ast.iter_child_nodes(node):
            yield from _uses(child)


def _code(value: object) -> str:
    """A syntax tree in words that every version of Python finds: without empty fields, docstrings and own imports."""
    if isinstance(value, ast.AST):
        fields = ((name, part) for name, part in ast.iter_fields(value) if part not in (None, []) and name != "ctx")
        return f"{type(value).__name__}({','.join(f'{name}={_code(part)}' for name, part in fields)})"
    if isinstance(value, list):
        return f"[{','.join(_code(part) for part in value if not _silent(part))}]"
    return repr(value)


def _silent(node: object) -> bool:
    """Whether a part computes nothing: a string that stands alone, words, own imports, what a type checker reads."""
    words = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
    said = isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Wording"
    return words or said or (isinstance(node, ast.ImportFrom) and node.level > 0) or _for_types(node)


def _for_types(node: object) -> bool:
    return isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


def _files(module: str) -> list[Path]:
    spec = find_spec(module)
    if spec is None:
        return []
    if spec.submodule_search_locations is None:
        return [Path(spec.origin)] if spec.origin else []
    folder = Path(next(iter(spec.submodule_search_locations)))
    return sorted(path for path in folder.rglob("*") if path.is_file() and "__pycache__" not in path.parts)
