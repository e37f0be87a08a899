"""The text of modules that rest on those of the normal contact: signatures, checks, docstrings."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...letters import LETTERS, name_of
from ...notation import coefficients
from ...profiles.profile import Profile
from .. import docstring
from ..imports import PLACE, interface
from ..layout import fit, from_import
from ..private import parameter_name
from ..public import unused
from ..tables import LOADED

PACKAGE = "axicontact"
NORMAL = "{profile}"
SIGNATURE = re.compile(r"^def (_\w+)\((.*?)\) ->", re.MULTILINE | re.DOTALL)
MASTERS = {"Hypergeometric": "2F1", "Kummer": "1F1"}


def required(symbols: Sequence[sp.Symbol | sp.IndexedBase]) -> str:
    """The check of these parameters."""
    return f"require({', '.join(f'{parameter_name(symbol)}={name_of(symbol)}' for symbol in symbols)})"


@dataclass
class NormalModule:
    """The private functions of one module of the normal contact, with the arguments each one takes."""

    profile: Profile
    entries: Mapping[str, Entry]
    functions: dict[str, list[str]] = field(default_factory=dict)

    @classmethod
    def read(cls, entries: Mapping[str, Entry], text: str) -> NormalModule:
        """The module behind these entries, from its text."""
        found = SIGNATURE.findall(text)
        functions = {own: [part.strip().split(":")[0] for part in re.split(r",(?=\s*\w+:)", a)] for own, a in found}
        return cls(next(iter(entries.values())).profile, entries, functions)

    @property
    def geometry(self) -> list[str]:
        """Names of the parameters of the profile, as the interface has them."""
        return [name_of(symbol) for symbol in self.profile.parameters]

    @property
    def summed(self) -> bool:
        """A polynomial: its coefficients are a tuple, and no array to be broadcast."""
        return coefficients in self.profile.parameters

    def call(self, function: str, *fields: str, **given: str) -> str:
        """The call of a private function, its leading arguments replaced by `fields`."""
        rest = self.functions[function][len(fields) :]
        return f"normal.{function}({', '.join([*fields, *(given.get(name, name) for name in rest)])})"

    def check(self, symbols: Sequence[sp.Symbol | sp.IndexedBase]) -> list[str]:
        """The lines that check parameters, those of the geometry with the rules between them."""
        lines = ["A = require_coefficients(A)"] if coefficients in symbols else []
        plain = [symbol for symbol in symbols if symbol != coefficients]
        ruled = bool(self.profile.rules) and set(self.profile.parameters) <= set(symbols)
        if plain:
            lines.append(("normal._check" if ruled else "require") + required(plain).removeprefix("require"))
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
    example: list[str] = field(default_factory=list)

    def text(self) -> str:
        """The function as Python code, with signature, docstring and body."""
        typed = [*([self.leading] if self.leading else []), *(f"{name}: ArrayLike" for name in self.fields)]
        typed += ["*", *(f"{name}: ArrayLike" for name in self.keywords)] if self.keywords else []
        head = fit(f"def {self.name}({', '.join(typed)}) -> {self.returns}:", 0)
        shown = ["", "Examples", "--------", *self.example] if self.example else []
        doc = [f'    """{self.summary}', "", *(f"    {line}".rstrip() for line in (*self.doc, *shown)), '    """']
        return "\n".join([*head, *doc, *(f"    {line}".rstrip() for own in self.body for line in fit(own))]) + "\n"


def parameters(names: Sequence[str], symbols: Mapping[str, sp.Symbol], fields: bool) -> list[str]:
    """The rows of a numpydoc section of parameters."""
    lines = []
    for name in names:
        symbol = symbols.get(name, name)
        record = nt.describe(symbol)
        kind = "sequence of float" if isinstance(symbol, sp.IndexedBase) else "array_like"
        own = LOADED.get(record.symbol, record.domain)
        domain = "" if fields or not own else f", {own}"
        text = f"{capital(record.meaning)} [{record.unit}]{domain}."
        if isinstance(symbol, sp.IndexedBase):
            text = "Coefficients of r, r^2, ..., none negative and not all zero."
        lines += [f"{name} : {kind}", *wrapped(text, 4)]
    return lines


def formula(entry: Entry) -> list[str]:
    """The formula of an entry in plain text, in the names of the interface."""
    return renamed(docstring.formula(entry.profile, entry.quantity, entry))


def renamed(lines: Sequence[str]) -> list[str]:
    """Symbols in the letters of the interface, functions by their usual names."""
    text = "\n".join(lines)
    names = {symbol.name: name for symbol, name in LETTERS.items()} | MASTERS
    for old, new in names.items():
        text = re.sub(rf"\b{old}\b", new, text)
    return text.split("\n")


def document(entry: Entry, fields: Sequence[str], keywords: Sequence[str], notes: str) -> list[str]:
    """Everything below the summary of a function that one entry backs."""
    symbols = {name_of(symbol): symbol for symbol in (*entry.parameters, *entry.quantity.arguments)}
    record = nt.describe(entry.quantity.symbol)
    shape = "The shape to which the arguments broadcast."
    lines = [*formula(entry), "", "Parameters", "----------"]
    lines += [*parameters(fields, symbols, True), *parameters(keywords, symbols, False)]
    lines += ["", "Returns", "-------", "float or ndarray"]
    lines += wrapped(f"{capital(record.meaning)} [{record.unit}]. {shape}", 4)
    lines += ["", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain."]
    lines += ["", "Notes", "-----", *wrapped(f"{notes} Handbook: {entry.key}.")]
    sources = [*(f"chapter 11, equation {reference}" for reference in entry.references), *entry.profile.sources]
    return [*lines, "", "References", "----------", *wrapped("; ".join(sources) + ".")]


SEVERAL = " Where it has several minima, or one at a corner of the profile, the lowest."


def pull_off(
    formulas: Sequence[str], keywords: Sequence[str], used: Iterable[sp.Symbol], entries: Mapping[str, Entry], more: str
) -> list[str]:
    """Everything below the summary of the function of pull-off, `more` behind its note."""
    radius = entries["ac"]
    lines = [*formulas, "", "Parameters", "----------", 'control : {"force", "depth"}']
    lines += ["    What is held while the contact is unloaded."]
    lines += parameters(keywords, {name_of(symbol): symbol for symbol in used}, False)
    lines += ["", "Returns", "-------", "PullOff"]
    lines += ["    Named tuple of radius [m], force [N] and depth [m]; NaN without a stable contact."]
    lines += ["", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain."]
    note = f"The least force, or depth, of a stable contact.{more} Handbook: {radius.key}, {entries['am'].key}."
    lines += ["", "Notes", "-----", *wrapped(note)]
    sources = [*(f"chapter 11, equation {own}" for own in radius.references), *radius.profile.sources]
    return [*lines, "", "References", "----------", *wrapped("; ".join(sources) + ".")]


def module(
    title: str, text: str, imports: Sequence[str], public: Sequence[Function], private: Sequence[str], up: str = ".."
) -> str:
    """The text of a module, from which the root of the package is `up`."""
    head = f'"""{title}.\n\n{chr(10).join(textwrap.wrap(text, 110))}\n"""\n\nfrom __future__ import annotations\n\n'
    body = "\n\n".join([*(function.text() for function in public), *private])
    lines = _needed(imports, body, up)
    names = "\n".join(interface([function.name for function in public]))
    tail = f"\n\nif TYPE_CHECKING:\n    from numpy.typing import ArrayLike\n\n{names}\n\n\n"
    return head + "\n".join(lines) + tail + body


def _needed(imports: Sequence[str], body: str, up: str) -> list[str]:
    """The imports whose names the code holds."""
    code = re.sub(r'""".*?"""', "", body, flags=re.DOTALL)
    # the file of an import inside a function may be called like a function of another file
    code = re.sub(r"^ +from \S+ import", "", code, flags=re.MULTILINE)
    lines = ["from functools import partial"] if "partial(" in code else []
    lines += ["from typing import TYPE_CHECKING", ""]
    if "np." in code:
        lines += ["import numpy as np", ""]
    lines += imported(imports, code, up)
    if "normal." in code:
        lines.append(f"from ..normal import {NORMAL} as normal")
    return lines


def imported(imports: Sequence[str], code: str, up: str = "..") -> list[str]:
    """The imports of the names that the code holds; `file: a, b` offers those of a file of the run time."""
    used: dict[str, list[str]] = {}
    for line in imports:
        source, _, names = line.partition(": ")
        found = [name for name in names.split(", ") if re.search(rf"\b{name}\b", code)]
        if found:
            used.setdefault(source, []).extend(found)
    return [line for source in sorted(used) for line in from_import(f"{up}{PLACE}.{source}", used[source])]


def private(
    name: str, fields: Sequence[str], needs: Sequence[str], lines: Sequence[str], doc: str = "", returns: str = "Array"
) -> str:
    """The text of a private function."""
    typed = [f"{own}: {'str' if own == 'control' else 'Array'}" for own in (*fields, *needs)]
    head = fit(f"def {name}({', '.join(typed)}) -> {returns}:", 0)
    shown = [f'    """{doc}"""'] if doc else []
    body = (f"    {line}".rstrip() for own in lines for line in fit(own))
    return "\n".join([*head, *shown, *body]) + "\n"


def evaluate(
    function: str,
    fields: Sequence[str],
    keywords: Sequence[str],
    summed: bool,
    apart: Sequence[str] = (),
    **signed: str,
) -> str:
    """The evaluation of a private function over arrays; fields that may be negative are passed by name.

    Parameters that stand `apart` only have a say in the shape.
    """
    passed = [f"{name}={name}" for name in keywords if not (summed and name == "A")]
    if summed:
        function = f"partial({function}, A=A)"
    passed += unused(apart)
    return f"elementwise({', '.join([function, *fields, *(f'{k}={v}' for k, v in signed.items()), *passed])})"


def wrapped(text: str, indent: int = 0) -> list[str]:
    """The text in lines of at most 106 characters, each indented by this many spaces."""
    space = " " * indent
    return textwrap.wrap(
        text, 106, initial_indent=space, subsequent_indent=space, break_long_words=False, break_on_hyphens=False
    )


def capital(text: str) -> str:
    """The text with its first letter as a capital, the rest unchanged."""
    return text[:1].upper() + text[1:]
