"""The text of modules that rest on those of the normal contact: signatures, checks, docstrings."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from ... import notation as nt
from ...contact import normal
from ...entry import Entry
from ...notation import coefficients
from ...profiles import load
from ...profiles.profile import Profile
from .. import docstring
from ..private import parameter_name
from ..python import module_source

RENAMED = {nt.relaxation: "tau", nt.sigma: "s"}
MATERIAL = {"E_star", "dgamma", "mu", "G_star", "E", "E_inf", "E_1", "tau", "eta", "alpha", "t_0", "v", "p_0"}
SIGNATURE = re.compile(r"^def (_\w+)\((.*?)\) ->", re.MULTILINE)


def name_of(symbol: sp.Symbol | sp.IndexedBase) -> str:
    """The name of a parameter in the interface."""
    return RENAMED.get(symbol, parameter_name(symbol))


@dataclass
class NormalModule:
    """The private functions of one module of the normal contact, with the arguments each one takes."""

    profile: Profile
    entries: Mapping[str, Entry]
    functions: dict[str, list[str]] = field(default_factory=dict)

    @classmethod
    def of(cls, name: str) -> NormalModule:
        profile = load(name)
        entries = normal.derive(profile)
        found = SIGNATURE.findall(module_source(entries))
        functions = {own: [part.split(":")[0] for part in re.split(r", (?=\w+:)", args)] for own, args in found}
        return cls(profile, entries, functions)

    @property
    def geometry(self) -> list[str]:
        return [name_of(symbol) for symbol in self.profile.parameters]

    @property
    def summed(self) -> bool:
        """A polynomial: its coefficients are a tuple, and no array to be broadcast."""
        return coefficients in self.profile.parameters

    def call(self, function: str, *fields: str, **given: str) -> str:
        """The call of a private function, its leading arguments replaced by `fields`."""
        rest = self.functions[function][len(fields) :]
        return f"normal.{function}({', '.join([*fields, *(given.get(name, name) for name in rest)])})"

    def check(self, keywords: Sequence[str]) -> list[str]:
        """The lines that check the geometry and then the material."""
        plain = [name for name in keywords if name in self.geometry or name == "E_star"]
        physics = [name for name in keywords if name not in plain]
        lines = []
        if self.summed and "A" in keywords:
            lines.append("A = require_coefficients(A)")
            plain = [name for name in plain if name != "A"]
        if plain:
            owner = "normal._check" if self.profile.rules and set(self.geometry) & set(plain) else "require"
            lines.append(f"{owner}({', '.join(f'{name}={name}' for name in plain)})")
        if physics:
            lines.append(f"require_physics({', '.join(f'{name}={name}' for name in physics)})")
        return lines


@dataclass
class Function:
    """A public function and its formula."""

    name: str
    fields: list[str]
    keywords: list[str]
    summary: str
    doc: list[str]
    body: list[str]
    returns: str = "Result"
    leading: str = ""
    """A first parameter that is neither field nor number, with its annotation and default."""

    def text(self) -> str:
        typed = [*([self.leading] if self.leading else []), *(f"{name}: ArrayLike" for name in self.fields)]
        typed += ["*", *(f"{name}: ArrayLike" for name in self.keywords)]
        line = f"def {self.name}({', '.join(typed)}) -> {self.returns}:"
        if len(line) > 120:
            line = f"def {self.name}(\n    {', '.join(typed)}\n) -> {self.returns}:"
        doc = "\n".join(("    " + text).rstrip() for text in self.doc)
        body = "\n".join("    " + text for text in self.body)
        return f'{line}\n    """{self.summary}\n\n{doc}\n    """\n{body}\n'


def parameters(names: Sequence[str], symbols: Mapping[str, sp.Symbol], fields: bool) -> list[str]:
    """The rows of a numpydoc section of parameters."""
    lines = []
    for name in names:
        symbol = symbols.get(name, name)
        record = nt.describe(symbol)
        kind = "sequence of float" if isinstance(symbol, sp.IndexedBase) else "array_like"
        domain = "" if fields or not record.domain else f", {record.domain}"
        lines += [f"{name} : {kind}", *wrapped(f"{capital(record.meaning)} [{record.unit}]{domain}.", 4)]
    return lines


def formula(entry: Entry) -> list[str]:
    """The formula of an entry in plain text, in the names of the interface."""
    lines = docstring.formula(entry.profile, entry.quantity, entry)
    text = "\n".join(lines)
    for symbol, name in RENAMED.items():
        text = re.sub(rf"\b{symbol.name}\b", name, text)
    return text.split("\n")


def document(entry: Entry, fields: Sequence[str], keywords: Sequence[str], notes: str) -> list[str]:
    """Everything below the summary of a function that one entry backs."""
    symbols = {name_of(symbol): symbol for symbol in (*entry.parameters, *entry.quantity.arguments)}
    record = nt.describe(entry.quantity.symbol)
    lines = [*formula(entry), "", "Parameters", "----------"]
    lines += [*parameters(fields, symbols, True), *parameters(keywords, symbols, False)]
    lines += ["", "Returns", "-------", "float or ndarray"]
    lines += wrapped(f"{capital(record.meaning)} [{record.unit}]. The shape to which the arguments broadcast.", 4)
    lines += ["", "Raises", "------", "ValueError", "    If a parameter is outside its domain."]
    lines += ["", "Notes", "-----", *wrapped(f"{notes} Handbook: {entry.key}.")]
    sources = [*(f"chapter 11, equation {reference}" for reference in entry.references), *entry.profile.sources]
    return [*lines, "", "References", "----------", *wrapped("; ".join(sources) + ".")]


def module(title: str, text: str, imports: Sequence[str], public: Sequence[Function], private: Sequence[str]) -> str:
    """The text of a module."""
    head = f'"""{title}.\n\n{chr(10).join(textwrap.wrap(text, 110))}\n"""\n\nfrom __future__ import annotations\n\n'
    body = "\n\n".join([*(function.text() for function in public), *private])
    lines = _needed(imports, body)
    tail = "\n\nif TYPE_CHECKING:\n    from numpy.typing import ArrayLike\n\n\n"
    return head + "\n".join(lines) + tail + body


def _needed(imports: Sequence[str], body: str) -> list[str]:
    """The imports whose names the body holds; `module: a, b` stands for a from-import."""
    lines = ["from functools import partial"] if "partial(" in body else []
    lines += ["from typing import TYPE_CHECKING", ""]
    if "np." in body:
        lines += ["import numpy as np", ""]
    for line in imports:
        source, _, names = line.partition(": ")
        used = [name for name in names.split(", ") if re.search(rf"\b{name}\b", body)]
        if used:
            text = f"from {source} import {', '.join(used)}"
            lines += [text] if len(text) <= 120 else [f"from {source} import (", *(f"    {u}," for u in used), ")"]
    if "normal." in body:
        lines.append(f"from ..normal import {NORMAL} as normal")
    return lines


NORMAL = "{profile}"


def private(name: str, fields: Sequence[str], needs: Sequence[str], lines: Sequence[str], doc: str = "") -> str:
    """The text of a private function."""
    typed = [f"{own}: {'str' if own == 'control' else 'Array'}" for own in (*fields, *needs)]
    line = f"def {name}({', '.join(typed)}) -> Array:"
    if len(line) > 120:
        line = f"def {name}(\n    {', '.join(typed)}\n) -> Array:"
    text = f'    """{doc}"""\n' if doc else ""
    return f"{line}\n{text}" + "\n".join("    " + own for own in lines) + "\n"


def evaluate(function: str, fields: Sequence[str], keywords: Sequence[str], summed: bool, **signed: str) -> str:
    """The evaluation of a private function over arrays; fields that may be negative are passed by name."""
    passed = [f"{name}={name}" for name in keywords if not (summed and name == "A")]
    if summed:
        function = f"partial({function}, A=A)"
    return f"elementwise({', '.join([function, *fields, *(f'{k}={v}' for k, v in signed.items()), *passed])})"


def wrapped(text: str, indent: int = 0) -> list[str]:
    space = " " * indent
    return textwrap.wrap(
        text, 106, initial_indent=space, subsequent_indent=space, break_long_words=False, break_on_hyphens=False
    )


def capital(text: str) -> str:
    return text[:1].upper() + text[1:]
