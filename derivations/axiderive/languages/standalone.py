"""One file in another language with a few functions of the package, whose parameters may be numbers, and its test."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from .c.file import File
from .javascript import Script
from .reach import Package


@dataclass(frozen=True)
class Asked:
    """A function of the file."""

    name: str
    """What it is called there."""
    module: str
    """The module of the package it comes from, and its name in it."""
    function: str
    known: Mapping[str, Any]
    """Parameters that are no arguments of it."""
    doc: str
    part: str = ""
    """Which of several numbers that the function gives."""
    held: Mapping[str, str] = field(default_factory=dict)
    """Words among its parameters."""

    def arguments(self, package: Package) -> list[str]:
        """Names of its arguments, in their order."""
        names = package.arguments(self.module, self.function)
        return [own for own in names if own not in self.known and own not in self.held]


@dataclass(frozen=True)
class Call:
    """A function with the values of its arguments by name, and what it gives."""

    name: str
    given: Mapping[str, float]
    wanted: float


class Standalone(ABC):
    """A file in some language."""

    suffix: str

    def __init__(self, package: Package) -> None:
        self.package = package
        self.functions: dict[str, Asked] = {}

    @abstractmethod
    def add(self, asked: Asked) -> None:
        """Take a function along.

        Raises
        ------
        NoProgramError
            If it has no program over single numbers, or none in this language.
        """

    @abstractmethod
    def text(self, head: str) -> str:
        """The file, with a comment at its head."""

    @abstractmethod
    def test(self, stem: str, calls: Sequence[Call], tolerance: float) -> str:
        """A program that compares the values of the file of that name with those wanted."""

    def written(self, call: Call) -> str:
        """A call as both languages have it."""
        arguments = self.functions[call.name].arguments(self.package)
        return f"{call.name}({', '.join(repr(float(call.given[own])) for own in arguments)})"


C_TEST = """/* cc -std=c99 {name} -lm && ./a.out */
#include <stdio.h>
#include "{stem}.c"

static int differs(const char *call, double got, double wanted)
{{
  if (fabs(got - wanted) <= {tolerance!r} * fabs(wanted))
    return 0;
  printf("%s gives %.17g in place of %.17g\\n", call, got, wanted);
  return 1;
}}

int main(void)
{{
  int wrong = 0;
{rows}
  if (!wrong)
    printf("{count} values agree\\n");
  return wrong != 0;
}}
"""


class CFile(Standalone):
    """C99 without allocation."""

    suffix = "c"

    def __init__(self, package: Package) -> None:
        super().__init__(package)
        self.file = File(package)

    def add(self, asked: Asked) -> None:
        """See `Standalone`."""
        known = {**asked.known, **asked.held}
        self.file.add(asked.module, asked.function, asked.name, known, asked.part, asked.doc)
        self.functions[asked.name] = asked

    def text(self, head: str) -> str:
        """See `Standalone`."""
        comment = "\n   ".join(head.replace("*/", "* /").split("\n")).replace("   \n", "\n")
        return f"/* {comment} */\n{self.file.text()}"

    def test(self, stem: str, calls: Sequence[Call], tolerance: float) -> str:
        """See `Standalone`."""
        made = [(self.written(call), call.wanted) for call in calls]
        rows = "\n".join(f'  wrong += differs("{text}", {text}, {wanted!r});' for text, wanted in made)
        name = f"test_{stem}.c"
        return C_TEST.format(name=name, stem=stem, tolerance=tolerance, rows=rows, count=len(made))


JS_TEST = """// node {name}
const module_ = require("./{stem}.js");
const VALUES = [
{rows}
];
for (const [call, got, wanted] of VALUES) {{
  if (!(Math.abs(got - wanted) <= {tolerance!r} * Math.abs(wanted))) {{
    throw new Error(`${{call}} gives ${{got}} in place of ${{wanted}}`);
  }}
}}
console.log(`${{VALUES.length}} values agree`);
"""


class JavaScriptFile(Standalone):
    """A script for browsers and for node."""

    suffix = "js"

    def __init__(self, package: Package) -> None:
        super().__init__(package)
        self.script = Script(package)
        self.rows: list[str] = []

    def add(self, asked: Asked) -> None:
        """See `Standalone`."""
        program = self.script.add(asked.module, asked.function)
        order = self.package.arguments(asked.module, asked.function)
        left = asked.arguments(self.package)
        known = {**{own: repr(float(value)) for own, value in asked.known.items()},
                 **{own: repr(word) for own, word in asked.held.items()}}  # fmt: skip
        called = f"{program}({', '.join(known.get(own, own) for own in order)})"
        called = f"({called}).{asked.part} ?? NaN" if asked.part else called
        self.rows += [f"  // {asked.doc}", f"  {asked.name}: ({', '.join(left)}) => {called},"]
        self.functions[asked.name] = asked

    def text(self, head: str) -> str:
        """See `Standalone`."""
        comment = "\n".join(f"// {line}".rstrip() for line in head.split("\n"))
        end = 'if (typeof module !== "undefined") module.exports = functions;'
        return "\n".join([comment, self.script.text(), "const functions = {", *self.rows, "};", end, ""])

    def test(self, stem: str, calls: Sequence[Call], tolerance: float) -> str:
        """See `Standalone`."""
        made = [(self.written(call), call.wanted) for call in calls]
        rows = "\n".join(f'  ["{text}", module_.{text}, {wanted!r}],' for text, wanted in made)
        return JS_TEST.format(name=f"test_{stem}.js", stem=stem, tolerance=tolerance, rows=rows)


LANGUAGES: dict[str, type[Standalone]] = {"c": CFile, "javascript": JavaScriptFile}
"""Beside Python."""
