"""A self-contained module out of generated ones.

Generated modules as a library of definitions: what each one is, and what the names in it refer to.

A self-contained module out of generated ones: what the wanted functions reach, frozen parameters as constants.

A frozen parameter is dropped from every signature through which only itself is
passed; the constant of the same name takes its place.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from ...code.module import PLACE
from .inlining import inlined
from .rewriting import rewritten
from .source import Source, arguments

Key = tuple[str, str]
"""Module and name."""


@dataclass(frozen=True, eq=False)
class Definition:
    """A function, class or constant at the top of a module, with its text."""

    module: Module
    name: str
    node: ast.stmt

    @property
    def key(self) -> Key:
        """Names of its module and of itself."""
        return self.module.name, self.name

    @property
    def function(self) -> ast.FunctionDef | None:
        """The syntax tree if this is a function, else None."""
        return self.node if isinstance(self.node, ast.FunctionDef) else None

    @property
    def parameters(self) -> list[str]:
        """Names of the positional parameters of a function; none for anything else."""
        return [arg.arg for arg in self.function.args.args] if self.function else []

    @cached_property
    def bound(self) -> frozenset[str]:
        """Names bound anywhere inside: they do not refer to the module."""
        if self.function is None:
            return frozenset()
        found = {node.arg for node in ast.walk(self.node) if isinstance(node, ast.arg)} | self.stored
        return frozenset(found | {n.name for n in ast.walk(self.node) if isinstance(n, ast.FunctionDef)} - {self.name})

    @cached_property
    def stored(self) -> frozenset[str]:
        """Names that are given a value inside; a parameter among them is no longer what was passed."""
        names = (node for node in ast.walk(self.node) if isinstance(node, ast.Name))
        return frozenset(node.id for node in names if isinstance(node.ctx, ast.Store))

    def references(self) -> Iterator[tuple[ast.expr, Key]]:
        """Names inside that refer to definitions, annotations left out."""
        skipped = _annotations(self.node)
        for node in ast.walk(self.node):
            if id(node) in skipped:
                continue
            if isinstance(node, ast.Name) and node.id not in self.bound:
                key = self.module.resolve(node.id)
                if key is not None:
                    yield node, key
            elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
                alias = self.module.aliases.get(node.value.id)
                if alias is not None:
                    yield node, (alias, node.attr)


class Module(Source):
    """One module, parsed."""

    def __init__(self, name: str, text: str) -> None:
        super().__init__(_with_imports_outside(text))
        self.name = name
        self.definitions: dict[str, Definition] = {}
        self.imported: dict[str, Key] = {}
        self.aliases: dict[str, str] = {}
        self.notes: dict[str, str] = {}
        """What the text under a constant says of it."""
        body = self.tree.body
        for node, below in zip(body, [*body[1:], None], strict=True):
            self._define(node)
            match node, below:
                case ast.Assign(targets=[ast.Name(id=name)]), ast.Expr(value=ast.Constant(value=str(note))):
                    self.notes[name] = note.splitlines()[0].rstrip(".")

    def _define(self, node: ast.stmt) -> None:
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
                self.definitions[name] = Definition(self, name, node)
            case ast.Assign(targets=[ast.Name(id=name)]):
                self.definitions[name] = Definition(self, name, node)
            case ast.Assign(targets=[ast.Tuple(elts=elements)], value=ast.Tuple(elts=values)):
                for element, value in zip(elements, values, strict=True):
                    if isinstance(element, ast.Name):
                        single = ast.copy_location(ast.Assign(targets=[element], value=value), node)
                        self.definitions[element.id] = Definition(self, element.id, single)
            case ast.ImportFrom(module="normal", level=level, names=[ast.alias(name=name, asname="normal")]):
                self.aliases["normal"] = self._below(level, f"normal.{name}")
            case ast.ImportFrom(module=source, level=level, names=names) if level and source:
                for alias in names:
                    self.imported[alias.asname or alias.name] = (self._below(level, source), alias.name)

    def _below(self, level: int, name: str) -> str:
        """A module named relative to this one, by its name in the package."""
        return ".".join([*self.name.split(".")[:-level], name])

    def resolve(self, name: str) -> Key | None:
        """The key of what a name means at the top of the module, defined or imported; None for any other name."""
        if name in self.definitions:
            return self.name, name
        return self.imported.get(name)


def _with_imports_outside(text: str) -> str:
    """The text with what functions import from the package behind it, where it is read as an import of the module."""
    lines, moved = text.splitlines(keepends=True), []
    for function in (node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)):
        for node in ast.walk(function):
            if isinstance(node, ast.ImportFrom) and node.level and node.end_lineno:
                moved.append(ast.unparse(node) + "\n")
                blank = node.end_lineno < len(lines) and not lines[node.end_lineno].strip()
                lines[node.lineno - 1 : node.end_lineno + blank] = [""] * (node.end_lineno + blank - node.lineno + 1)
    return "".join([*lines, *moved])


def _annotations(node: ast.AST) -> set[int]:
    """Nodes that only the type checker reads."""
    found: set[int] = set()
    for inner in ast.walk(node):
        for name in ("annotation", "returns"):
            part = getattr(inner, name, None)
            if part is not None:
                found |= {id(n) for n in ast.walk(part)}
    return found


def _group(module: str) -> str:
    """What tells functions of one name apart: their file of the run time, or the package of a module."""
    file = module.removeprefix(f"{PLACE}.").removeprefix("physics.").removeprefix("shapes.")
    group = module.rpartition(".")[0] if file == module != OWN else file
    return group.replace(".", "_")


OWN = "scene"
"""Module of functions that are written for the scene: they keep their names."""


@dataclass(frozen=True)
class Wanted:
    """A function of the interface: the private function behind it, its name, fields, keywords and docstring."""

    key: Key
    name: str
    fields: tuple[str, ...]
    keywords: tuple[str, ...]
    doc: str
    signed: bool = False
    """Whether a field may be negative."""
    parity: str = ""
    """Whether it is even or odd in its first field."""


@dataclass
class Linker:
    """The reachable definitions with the parameters each one no longer takes, and the names they get."""

    modules: Mapping[str, Module]
    wanted: Sequence[Wanted]
    frozen: frozenset[str]
    positive: frozenset[str] = frozenset()
    """The frozen ones above zero, of which no line needs to ask it."""
    roots: Sequence[Key] = ()
    reached: dict[Key, Definition] = field(default_factory=dict)
    dropped: dict[Key, frozenset[str]] = field(default_factory=dict)
    names: dict[Key, str] = field(default_factory=dict)
    inlined: Mapping[Key, str] = field(default_factory=dict)

    def __post_init__(self) -> None:
        pending = [*(w.key for w in self.wanted), *self.roots]
        while pending:
            key = pending.pop(0)
            if key in self.reached:
                continue
            definition = self.definition(key)
            self.reached[key] = definition
            pending += [target for _, target in definition.references() if target not in SHARED]
        self._drop()
        self.inlined = inlined(self)
        self._name()

    def definition(self, key: Key) -> Definition:
        """The definition behind a key, followed through imports; KeyError if there is none."""
        module, name = key
        found = self.modules[module].definitions.get(name)
        if found is None:
            return self.definition(self.modules[module].imported[name])
        return found

    # which parameters go

    def _drop(self) -> None:
        self.dropped = {
            key: frozenset(p for p in d.parameters if p in self.frozen and p not in d.stored)
            for key, d in self.reached.items()
            if d.function
        }
        for key in self._escaping():
            self.dropped[key] = frozenset()
        while self._undropped():
            pass

    def _escaping(self) -> set[Key]:
        """Functions that are also handed on as values, whose callers are not known."""
        found: set[Key] = set()
        for definition in self.reached.values():
            called = {id(node.func) for node in ast.walk(definition.node) if isinstance(node, ast.Call)}
            found |= {key for node, key in definition.references() if id(node) not in called and key in self.dropped}
        return found

    def _undropped(self) -> bool:
        """Give a parameter back where a caller passes something else; says whether any was."""
        changed = False
        for caller, definition in self.reached.items():
            own = self.dropped.get(caller, frozenset())
            references = {id(node): key for node, key in definition.references()}
            for call in (node for node in ast.walk(definition.node) if isinstance(node, ast.Call)):
                key = references.get(id(call.func))
                if key is None or not self.dropped.get(key):
                    continue
                given = arguments(call, self.reached[key].parameters)
                for parameter in sorted(self.dropped[key]):
                    value = given.get(parameter)
                    same = isinstance(value, ast.Name) and value.id == parameter
                    if not same or (parameter in definition.bound and parameter not in own):
                        self.dropped[key] -= {parameter}
                        changed = True
        return changed

    # what they are called

    def merged(self, wanted: Wanted) -> bool:
        """Whether the private function itself can be the public one: it takes the fields and nothing else."""
        left = [p for p in self.reached[wanted.key].parameters if p not in self.dropped[wanted.key]]
        shadowed = any(
            wanted.name in d.bound and any(key == wanted.key for _, key in d.references())
            for d in self.reached.values()
        )
        plain = left == list(wanted.fields) and wanted.key not in self._escaping()
        return plain and not shadowed and wanted.key not in self.roots

    def _name(self) -> None:
        public = {w.key: w.name for w in self.wanted if self.merged(w)}
        public |= {key: key[1] for key in self.roots if key[0] == OWN}
        taken = {w.name for w in self.wanted} | self.frozen | WRITTEN
        for key in self.reached:
            name = public.get(key)
            if name is None:
                stem = key[1].lstrip("_")
                name = stem if stem[0].isupper() and stem not in taken else f"_{stem}"
                if name in taken:
                    name = f"_{_group(key[0])}_{stem}"
                taken.add(name)
            self.names[key] = name
        self.names |= SHARED

    @staticmethod
    def given(call: ast.Call, callee: Definition) -> dict[str, ast.expr]:
        """The arguments of a call by parameter."""
        return arguments(call, callee.parameters)

    def text(self, key: Key, doc: str = "") -> str:
        """The text of a reached definition with its new names and fewer parameters; `doc` replaces its docstring."""
        return rewritten(self, self.reached[key], doc)


SHARED: dict[Key, str] = {
    ("_runtime.integrals", "integral"): "_integral",
    ("_runtime.nodes", "_LOWER_HALVES"): "_NODES",
    ("_runtime.interface", "Array"): "",
    ("_runtime.interface", "Result"): "",
    ("_runtime.physics.adhesion", "Load"): "",
}
"""Names of what is written anew for a scene, in fewer lines; empty for what is read by the type checker only."""
WRITTEN = frozenset(name for name in SHARED.values() if name) | {
    "_bare",
    "_elementwise",
    "_require",
    "_DOMAINS",
    "_UNITS",
}
