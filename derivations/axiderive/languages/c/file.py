"""A file of C: public functions of the package, and all that they need.

A program of the package is run once with its arguments as names.  Numbers that depend on none are folded, as Python has
them; a loop over something of a known length is written out; a function that is given a function is written where it is
called, so that the file needs no pointers to functions, no allocation and no library but that of C.  What the package
keeps for the parameters of the last calls, the file keeps for those of the last one.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ..reach import KEPT, Module, NoProgramError, Package
from .lines import like
from .natives import NODES
from .statements import Writer
from .values import Closure, Kind, Number, Scope, SeveralValuesError, Text, Value, bound_value, names_of, shape

DEFINED = re.compile(r"^(?:struct|#define|static inline (?:double|int|void|struct pairs)) (\w+)", re.MULTILINE)
"""What a helper is called."""
HELPERS = Path(__file__).with_name("numbers.h")
"""What C lacks: comparisons that keep what is no number, exact sums, the places of a rule."""


LISTS = "physics.cohesive_states"
"""The module that keeps what it has found on its way."""


class File:
    """The functions of one file of C, and all that they need."""

    def __init__(self, package: Package) -> None:
        self.package = package
        self.public: list[str] = []
        self.written: dict[str, Text] = {}
        self.variables: set[str] = set()
        self._names: dict[object, str] = {}
        """Of what is known of its arguments the name of a function of C; empty if there is none."""
        self._constants: dict[tuple[str, str], Value] = {}

    def add(
        self,
        module: str,
        function: str,
        name: str,
        known: Mapping[str, Value] | None = None,
        part: str = "",
        doc: str = "",
    ) -> None:
        """Take a public function along under a name, with its arguments in their order.

        Those `known` are none: a number is written into the file.  What is a sequence of numbers, as the coefficients
        of a polynomial are, has to be known, or is as many arguments as there are numbers of C in it.  Of several
        numbers that it gives, one `part` is taken.

        Raises
        ------
        NoProgramError
            If it, or something it calls, is evaluated over arrays only, or gives more than one number.
        """
        home, node = self.package.program(module, function)
        given = [(known or {}).get(own, Number(own)) for own in names_of(node.args)]
        self.written[name] = Text("", frozenset(), ())
        try:
            text = Writer(self).whole(Closure(node, home), given, name, "double", part)
        except SeveralValuesError:
            message = f"{module}.{function} gives no single number"
            raise NoProgramError(message) from None
        finally:
            # behind what it needs
            del self.written[name]
        self.written[name] = replace(text, text=f"/* {doc} */\n{text.text}") if doc else text
        self.public.append(name)

    def text(self) -> str:
        """The whole file; what is needed stands in front of what needs it."""
        needed, pending = set[str](), list(self.public)
        while pending:
            name = pending.pop()
            if name not in needed:
                needed.add(name)
                pending += self.written[name].needs if name in self.written else ()
        nodes = self.package.module("_runtime.nodes")
        assert nodes is not None
        halves = ast.literal_eval(bound_value(nodes.bound["_LOWER_HALVES"]))
        tables = [table(name, half) for size, half in halves.items() if (name := NODES.format(size)) in needed]
        functions = [own.text for name, own in self.written.items() if name in needed]
        return "\n".join([*helpers("".join(functions)), *tables, *functions])

    def function(self, closure: Closure, given: Sequence[Value]) -> tuple[str, list[Number]]:
        """The name of the function of C for what is known of the arguments, and those that are left."""
        left: list[Number] = []
        known = tuple(shape(value, left) for value in given)
        assert isinstance(closure.node, ast.FunctionDef)
        key = (closure.module.name, closure.node.name, known)
        name = self._names.get(key)
        if name == "":
            raise SeveralValuesError
        if name is None:
            home = closure.module.name.rpartition(".")[2].lstrip("_")
            plain = f"{home}_{closure.node.name.lstrip('_')}"
            name = next(one for one in like(plain) if one not in self.written and one not in self.variables)
            self._names[key], self.written[name] = name, Text("", frozenset(), ())
            try:
                text = Writer(self).whole(closure, given, name, "static double")
            except (NoProgramError, SeveralValuesError):
                self._names[key] = ""
                raise
            # behind what it needs
            del self.written[name]
            kept = KEPT.intersection(map(ast.unparse, closure.node.decorator_list)) and left
            self.written[name] = remembered(name, text) if kept else text
        return name, left

    def constant(self, module: Module, name: str) -> Value:
        """What a module binds to a name."""
        key = (module.name, name)
        if module.name.endswith(LISTS):
            message = "a cohesive zone is looked for in lists of states, for which C has no place"
            raise NoProgramError(message)
        if key not in self._constants:
            node = self.package.bound(module, name)
            if isinstance(node, ast.FunctionDef):
                made: Value = Closure(node, module)
                for decorator in node.decorator_list:
                    if isinstance(decorator, ast.Name) and decorator.id == "in_groups":
                        writer = Writer(self)
                        scope = Scope(module)
                        made = writer.call(writer.named(scope, "in_groups"), [made], {})
            elif isinstance(node, ast.ClassDef):
                made = Kind(node, module)
            else:
                made = Writer(self).expr(bound_value(node), Scope(module))
            self._constants[key] = made
        return self._constants[key]


def remembered(name: str, text: Text) -> Text:
    """A function that keeps what it gave last, of each thread by itself."""
    own = [argument.split()[-1] for argument in text.arguments]
    lines = [
        f"static double {name}({', '.join(text.arguments)})", "{",
        f"  KEPT double of[{len(own)}] = {{0}}, made = 0;", "  KEPT int there = 0;",
        f"  if (!there || {' || '.join(f'of[{place}] != {one}' for place, one in enumerate(own))}) {{",
        f"    made = {name}_made({', '.join(own)});",
        *(f"    of[{place}] = {one};" for place, one in enumerate(own)),
        "    there = 1;", "  }", "  return made;", "}", "",
    ]  # fmt: skip
    made = text.text.replace(f" {name}(", f" {name}_made(", 1)
    return replace(text, text="\n".join([made, *lines]))


def helpers(text: str) -> list[str]:
    """The head of a file, and of the helpers those that a text needs.

    Each part of their file is a comment and what it is about.
    """
    first, *parts = HELPERS.read_text(encoding="utf-8").split("\n\n/*")
    needed = [part for part in parts if any(re.search(rf"\b{name}\b", text) for name in DEFINED.findall(part))]
    return [first, *(f"\n/*{part.rstrip()}" for part in needed), ""]


def table(name: str, half: Sequence[tuple[float, float]]) -> str:
    """Nodes and weights as C has them."""
    rows = ",\n".join(f"  {{{node!r}, {weight!r}}}" for node, weight in half)
    return f"static const double {name}[{len(half)}][2] = {{\n{rows}\n}};\n"
