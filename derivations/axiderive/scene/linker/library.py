"""Generated modules as a library of definitions: what each one is, and what the names in it stand for.

A definition is known by its key, `module:name`. A line of comment is a statement of the trees, a text that begins with
`#`; annotations are left out, and what functions import is imported by their module.

A rule that is called in groups of points is a plain function here: it integrates all points with the nodes of the
widest interval, which costs time and no accuracy, and takes an integrand of its lengths alone. Nor does a scene need
the short way for many radii of one contact.
"""

from __future__ import annotations

import ast
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from ...abel.reduce import NotReducibleError, parse
from ...code.graded.families import family
from ...code.module import PLACE, RUNTIME
from ...code.python import NODE_COUNTS
from ...code.systems import alone, superposed
from ...code.tables import kernels_source, nodes_source
from ...entry import Entry
from ...physics.systems import BY_NAME, System
from ...profiles.profile import Profile
from ...store.index import NoCatalogueError, package
from ...store.records import read_entry
from ..interface import Kind

COMMENT = re.compile(r"^( *)(#.*)$", re.MULTILINE)
GROUPED, SHORT_WAYS = "in_groups", ("at_many_radii", "over_radii", "Kept")
WIDTH = ast.arg("width")
IN_STRIP = "_runtime.integrals:integral_in_strip"


def parsed(text: str) -> list[ast.stmt]:
    """The statements of a text, its lines of comment among them.

    The tree keeps how a number is written, and which operation in another one is in brackets.
    """
    text = COMMENT.sub(lambda line: line[1] + repr(line[2]), text)
    lines, tree = [line.encode() for line in text.splitlines()], ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, float):
            node.kind = lines[node.lineno - 1][node.col_offset : node.end_col_offset].decode()
        elif isinstance(node, ast.BinOp):
            vars(node.left)["bracketed"] = node.left.col_offset > node.col_offset
            vars(node.right)["bracketed"] = node.right.end_col_offset != node.end_col_offset
        elif isinstance(node, ast.UnaryOp):
            vars(node.operand)["bracketed"] = node.operand.end_col_offset != node.end_col_offset
    return tree.body


def expression(text: str) -> ast.expr:
    """The tree of an expression."""
    return ast.parse(text, mode="eval").body


def loaded(name: str) -> ast.Name:
    """The value of a name."""
    return ast.Name(name, ast.Load())


def source(node: ast.AST) -> str:
    """The text of a tree as Python writes it."""
    return ast.unparse(ast.fix_missing_locations(node))


def text_in(statement: ast.stmt) -> str:
    """What a statement that is a text says; empty for any other."""
    match statement:
        case ast.Expr(value=ast.Constant(value=str(text))):
            return text
    return ""


def is_comment(statement: ast.stmt) -> bool:
    """Whether a statement is a line of comment."""
    return text_in(statement).startswith("#")


def documentation(function: ast.FunctionDef) -> str:
    """The docstring as it is written, empty if there is none."""
    return "" if is_comment(function.body[0]) else text_in(function.body[0])


def parameters(node: ast.stmt) -> list[str]:
    """Names of the positional parameters of a function; none for anything else."""
    return [arg.arg for arg in node.args.args] if isinstance(node, ast.FunctionDef) else []


def arguments(call: ast.Call, names: Sequence[str]) -> dict[str, ast.expr]:
    """The argument expressions of a call by the name of their parameter."""
    given: dict[str, ast.expr] = dict(zip(names, call.args, strict=False))
    return given | {keyword.arg: keyword.value for keyword in call.keywords if keyword.arg}


def stored(node: ast.AST) -> set[str]:
    """Names that are given a value inside; a parameter among them is no longer what was passed."""
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)}


def bound(node: ast.AST) -> set[str]:
    """Names bound anywhere inside a function: they do not refer to the module."""
    inner = {n.name for n in ast.walk(node) if isinstance(n, ast.FunctionDef) and n is not node}
    return stored(node) | inner | {n.arg for n in ast.walk(node) if isinstance(n, ast.arg)}


def references(node: ast.AST) -> Iterator[ast.Name]:
    """The names that are keys of the library."""
    return (n for n in ast.walk(node) if isinstance(n, ast.Name) and ":" in n.id)


def calls(node: ast.AST) -> Iterator[tuple[ast.Call, str]]:
    """The calls of functions of the library, with their keys."""
    for n in ast.walk(node):
        if isinstance(n, ast.Call) and isinstance(n.func, ast.Name) and ":" in n.func.id:
            yield n, n.func.id


@dataclass(frozen=True, eq=False)
class Definition:
    """A function, class or constant at the top of a module."""

    module: Module
    name: str
    node: ast.stmt
    remarks: Sequence[str] = ()
    """What is said of a constant above and below it, as comments."""
    lengths: int = 0
    """How many the integrand of a rule takes that is called in groups."""

    @property
    def key(self) -> str:
        """Names of its module and of itself."""
        return f"{self.module.name}:{self.name}"

    @property
    def parameters(self) -> list[str]:
        """Names of the positional parameters of a function; none for anything else."""
        return parameters(self.node)

    @cached_property
    def bound(self) -> set[str]:
        """Names that mean nothing of the module."""
        return bound(self.node) if isinstance(self.node, ast.FunctionDef) else set()


class Module:
    """One module, parsed."""

    def __init__(self, name: str, text: str) -> None:
        self.name = name
        self.definitions: dict[str, Definition] = {}
        self.imported: dict[str, str] = {}
        self.aliases: dict[str, str] = {}
        remarks: list[str] = []
        last: list[str] | None = None
        for node in parsed(text):
            if is_comment(node):
                remarks.append(text_in(node))
            elif last is not None and (note := text_in(node)):
                first = note.splitlines()[0].rstrip(".")
                last.append(f"# {first[0].lower() if first[1:2].islower() else first[0]}{first[1:]}")
            else:
                last = remarks if isinstance(node, ast.Assign) else None
                self._define(node, remarks)
                remarks = []

    def _define(self, node: ast.stmt, remarks: Sequence[str]) -> None:
        match node:
            case ast.FunctionDef(name=name):
                lengths = _plain_rule(node)
                plain = _Plain(self)
                plain.visit(node)
                self.definitions[name] = Definition(self, name, node, remarks, lengths)
            case ast.ClassDef(name=name) | ast.Assign(targets=[ast.Name(id=name)]):
                self.definitions[name] = Definition(self, name, node, remarks)
            case ast.Assign(targets=[ast.Tuple(elts=elements)], value=ast.Tuple(elts=values)):
                for element, value in zip(elements, values, strict=True):
                    self._define(ast.Assign(targets=[element], value=value), ())
            case ast.ImportFrom():
                self.imports(node)

    def imports(self, node: ast.ImportFrom) -> None:
        """Notes what is imported from the package."""
        match node:
            case ast.ImportFrom(module="normal", level=level, names=[ast.alias(name=name, asname="normal")]):
                self.aliases["normal"] = self._below(level, f"normal.{name}")
            case ast.ImportFrom(module=source, level=level, names=names) if level and source:
                for alias in names:
                    self.imported[alias.asname or alias.name] = f"{self._below(level, source)}:{alias.name}"

    def _below(self, level: int, name: str) -> str:
        """A module named relative to this one, by its name in the package."""
        return ".".join([*self.name.split(".")[:-level], name])


class _Plain(ast.NodeTransformer):
    """A function without annotations, conditions of traced bodies, and without what it imports, as its module does."""

    def __init__(self, module: Module) -> None:
        self.module = module

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        """Goes to the module."""
        self.module.imports(node)

    def visit_arg(self, node: ast.arg) -> ast.arg:
        """The name alone."""
        return ast.arg(node.arg)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """Without the type of its result."""
        node.returns = None
        return self.generic_visit(node)

    def visit_If(self, node: ast.If) -> ast.AST | None:
        """What is asked of a body that is traced holds in no scene."""
        return None if ast.unparse(node.test).startswith("hasattr(") else self.generic_visit(node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        """A plain assignment."""
        assert node.value is not None
        return ast.copy_location(ast.Assign(targets=[node.target], value=node.value), node)


def _plain_rule(function: ast.FunctionDef) -> int:
    """Takes the marks off a function; a rule gets a width, and integrates what it returned: for it the lengths."""
    marks = [mark for mark in function.decorator_list if ast.unparse(mark).startswith((GROUPED, *SHORT_WAYS))]
    function.decorator_list = [mark for mark in function.decorator_list if mark not in marks]
    if GROUPED not in map(ast.unparse, marks):
        return 0
    slope, last = function.args.args[0].arg, function.body[-1]
    assert isinstance(last, ast.Return) and isinstance(last.value, ast.Tuple)
    integrand, stop, factor, holds, otherwise = last.value.elts
    value: ast.expr = ast.Call(loaded(IN_STRIP), [integrand, stop, loaded("width")], [])
    if ast.unparse(factor) != "1.0":
        value = ast.BinOp(factor, ast.Mult(), value)
    always = ast.unparse(holds) == "True"
    last.value = value if always else ast.Call(expression("np.where"), [holds, value, otherwise], [])
    function.args.args.append(WIDTH)
    function.args.defaults.append(ast.Constant(1.0))
    return next(len(n.args) for n in ast.walk(function) if isinstance(n, ast.Call) and ast.unparse(n.func) == slope)


def definition(modules: Mapping[str, Module], key: str) -> Definition:
    """The definition behind a key, followed through imports; KeyError if there is none."""
    module, _, name = key.partition(":")
    found = modules[module].definitions.get(name)
    return found or definition(modules, modules[module].imported[name])


class _Resolved(ast.NodeTransformer):
    def __init__(self, modules: Mapping[str, Module], own: Definition, kept: frozenset[str]) -> None:
        self.modules, self.own, self.kept = modules, own, kept

    def _name(self, key: str) -> ast.Name:
        return loaded(key if key in self.kept else definition(self.modules, key).key)

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """The key of what it means at the top of the module."""
        own = self.own.module
        if node.id in self.own.bound or isinstance(node.ctx, ast.Store):
            return node
        key = f"{own.name}:{node.id}" if node.id in own.definitions else own.imported.get(node.id, node.id)
        return self._name(key) if ":" in key else node

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        """The key of what another module has."""
        alias = self.own.module.aliases.get(node.value.id) if isinstance(node.value, ast.Name) else None
        return self._name(f"{alias}:{node.attr}") if alias else self.generic_visit(node)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> ast.AST:
        """A field of a class, whose type stays as it is."""
        if node.value is not None:
            node.value = self.visit(node.value)
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """`rule(_slope, (R, b), r, a)` becomes `rule(lambda t: _slope(t, R, b), r, a)`."""
        self.generic_visit(node)
        match node:
            case ast.Call(func=ast.Name(id=key), args=[slope, ast.Tuple(elts=given), *others]) if ":" in key:
                if key not in self.kept and (count := definition(self.modules, key).lengths):
                    fields = ["t", "root"][:count]
                    value = ast.Call(slope, [*map(loaded, fields), *given], [])
                    node.args = [ast.Lambda(_taking(fields), value), *others]
        return node


def _taking(names: Sequence[str]) -> ast.arguments:
    args = [ast.arg(name) for name in names]
    return ast.arguments(posonlyargs=[], args=args, kwonlyargs=[], kw_defaults=[], defaults=[])


FOR_SCENES = "over_profile"
"""A module of the run time that scenes alone have."""
SHORTER = {"functions": ("rational", "beside"), "special": ("dawson",), "shapes/arcs": ("arc_strips",)}
"""Functions of which it has a shorter equal, by their file."""


class _Runtime(dict[str, Module]):
    """The modules of the runtime by name, each parsed when it is asked for: a scene needs a third of them."""

    def __missing__(self, name: str) -> Module:
        file = name.removeprefix(f"{PLACE}.").replace(".", "/")
        match file:
            case "nodes":
                found = Module(name, nodes_source(NODE_COUNTS))
            case "kernels":
                found = Module(name, catalogue_text(f"{PLACE}/kernels.py") or kernels_source())
            case _:
                folder = Path(__file__).with_name("runtime") if file == FOR_SCENES else RUNTIME
                found = Module(name, (folder / f"{file}.py").read_text())
        for own in SHORTER.get(file, ()):
            found.definitions[own] = self[f"{PLACE}.{FOR_SCENES}"].definitions[own]
        return self.setdefault(name, found)


RUN_TIME = _Runtime()


def catalogue_text(path: str) -> str | None:
    """A file of the package in the catalogue, if there is one."""
    try:
        return (package() / path).read_text()
    except (NoCatalogueError, OSError):
        return None


def stored_entries(profile: Profile, kind: Kind) -> dict[str, Entry]:
    """The entries of a profile of the catalogue as they were verified, or derived anew where none are stored."""
    record = evidence(kind.plain.pool.id(profile.name))
    if record:
        return {suffix: read_entry(entry, profile) for suffix, entry in record["entries"].items()}
    return kind.plain.derive(profile)


def evidence(name: str) -> dict[str, Any] | None:
    """The stored record of a profile of the catalogue."""
    try:
        record: dict[str, Any] | None = json.loads(catalogue_text(f"../evidence/{name}.json") or "null")
    except ValueError:
        return None
    return record


def graded_refusal(profile: Profile) -> str:
    """Why no module of a profile is emitted for a graded half-space; empty if one is."""
    try:
        family(profile)
    except (NotReducibleError, AssertionError, ValueError):
        return (
            "on the graded half-space there are rules for sums of powers of r, with at most one break of "
            "straight or parabolic pieces, and not for these pieces"
        )
    return ""


def fields_refusal(profile: Profile) -> str:
    """Why no fields below an expression are emitted; empty if they are."""
    if profile.breaks:
        return "fields below the surface are emitted for an expression without breaks, or a profile of the catalogue"
    try:
        parse(profile.pieces)
    except NotReducibleError as error:
        return f"fields below the surface are sums over the rate of the depth, and {error}"
    return ""


class Library(dict[str, Module]):
    """All modules that the functions of a scene can reach, each made when it is asked for.

    Parameters
    ----------
    entries : mapping
        The entries of normal contact of a profile.
    normal : str
        The text of its module; empty for a profile of the catalogue.
    """

    def __init__(self, entries: Mapping[str, Entry], normal: str) -> None:
        super().__init__()
        self.entries, self.normal = entries, normal
        self.profile = next(iter(entries.values())).profile

    def __missing__(self, name: str) -> Module:
        if name.startswith(PLACE):
            return RUN_TIME[name]
        return self.setdefault(name, Module(name, self._text(BY_NAME[name.rpartition(".")[0]])))

    def sources(self, system: System) -> dict[str, str]:
        """The modules of a system and of those below it by their names, with all that they have for others."""
        own = {f"{system.name}.{self.profile.name}": self._text(system, interface=True)}
        return own | (self.sources(system.base) if system.base else {})

    def _text(self, system: System, *, interface: bool = False) -> str:
        """The module of a system as the catalogue has it, or written: by itself, or what it adds to the one below."""
        known, below, graded = not self.normal, system.base, system.medium.graded
        if known and (text := catalogue_text(f"{system.name.replace('.', '/')}/{self.profile.name}.py")):
            return text
        if below is None:
            return self.normal if self.normal and not graded else alone(system, self._entries(system)).source()
        plain, found = self._entries(below), self[f"{below.name}.{self.profile.name}"].definitions
        parameters = {name: own.parameters for name, own in found.items()}
        # a law takes from the normal contact what its functions say
        own = {} if system.physics.laws else system.derive(self.profile, plain)
        return superposed(system, own, plain, parameters, interface=interface).source()

    def _entries(self, system: System) -> Mapping[str, Entry]:
        """Those of normal contact on the half-space of a system."""
        return system.derive(self.profile) if system.medium.graded else self.entries


class Program:
    """The definitions that wanted ones reach: copies of their trees, in which a name of the library is its key."""

    def __init__(self, modules: Mapping[str, Module], wanted: Sequence[str], shared: frozenset[str]) -> None:
        self.wanted = list(dict.fromkeys(definition(modules, key).key for key in wanted))
        self.trees: dict[str, ast.stmt] = {}
        """By key, in the order in which they are reached."""
        self.remarks: dict[str, Sequence[str]] = {}
        self.shared = shared
        """Keys that are left to others."""
        self.modules = modules
        self.prune()

    def prune(self) -> None:
        """Leave out what is no longer reached."""
        found: dict[str, ast.stmt] = {}
        pending = [*self.wanted]
        while pending:
            key = pending.pop(0)
            if key not in found:
                found[key] = self.trees.get(key) or self._copied(key)
                pending += [name.id for name in references(found[key]) if name.id not in self.shared]
        self.trees = found

    def _copied(self, key: str) -> ast.stmt:
        own = definition(self.modules, key)
        self.remarks[key] = own.remarks
        tree: ast.stmt = _Resolved(self.modules, own, self.shared).visit(deepcopy(own.node))
        return tree

    @property
    def functions(self) -> dict[str, ast.FunctionDef]:
        """Those that are functions."""
        return {key: node for key, node in self.trees.items() if isinstance(node, ast.FunctionDef)}

    def without(self, gone: Mapping[str, frozenset[str]]) -> None:
        """Take parameters, by function, out of its head and out of all calls of it."""
        taken = {key: parameters(node) for key, node in self.trees.items()}
        for node in self.trees.values():
            for call, key in calls(node):
                if own := gone.get(key):
                    call.args = [value for name, value in zip(taken[key], call.args, strict=False) if name not in own]
                    call.keywords = [keyword for keyword in call.keywords if keyword.arg not in own]
        for key, own in gone.items():
            _narrow(self.functions[key].args, own)


def _narrow(head: ast.arguments, gone: frozenset[str]) -> None:
    required = len(head.args) - len(head.defaults)
    with_default = zip(head.args[required:], head.defaults, strict=True)
    head.defaults = [value for arg, value in with_default if arg.arg not in gone]
    head.args = [arg for arg in head.args if arg.arg not in gone]
