"""A self-contained module out of generated ones: what the wanted functions reach, frozen parameters as constants.

A frozen parameter is dropped from every signature through which only itself is
passed; the constant of the same name takes its place.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from .calls import arguments
from .inlining import inlined
from .library import Definition, Key, Module
from .rewriting import rewritten

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
                group = key[0].rpartition(".")[0].replace(".", "_") or key[0].lstrip("_")
                name = stem if stem[0].isupper() and stem not in taken else f"_{stem}"
                if name in taken:
                    name = f"_{group}_{stem}"
                taken.add(name)
            self.names[key] = name
        self.names |= SHARED

    @staticmethod
    def given(call: ast.Call, callee: Definition) -> dict[str, ast.expr]:
        """The arguments of a call by parameter."""
        return arguments(call, callee.parameters)

    def text(self, key: Key, doc: str = "") -> str:
        return rewritten(self, self.reached[key], doc)


SHARED: dict[Key, str] = {
    ("_integrals", "integral"): "_integral", ("_nodes", "_LOWER_HALVES"): "_NODES",
    ("_elementwise", "Array"): "", ("_elementwise", "Result"): "", ("_branches", "Load"): "",
}  # fmt: skip
"""Names of what is written anew for a scene, in fewer lines; empty for what is read by the type checker only."""
WRITTEN = frozenset(name for name in SHARED.values() if name) | {
    "_bare",
    "_elementwise",
    "_require",
    "_DOMAINS",
    "_UNITS",
}
