"""The generated package: every module as text, a pure function of the derived entries."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

import jinja2
import sympy as sp

from .. import notation as nt
from ..entry import COMPACT, COMPLETE, Entry, Quantity
from ..notation import a, coefficients, d, r
from ..profiles.profile import Profile
from ..stable.forms import evaluation_form
from ..stable.signs import facts_of
from . import example
from .code import HELPERS, python
from .compact import Compact
from .complete import Complete
from .docstring import SUMMARY, docstring
from .inverses import Inverses
from .nodes import nodes_source
from .private import Private, PrivateFunctions, parameter_name
from .symbols import symbols_source

PACKAGE = "axicontact"
NODE_COUNTS = (16, 32, 64, 128)
RUNTIME = Path(__file__).with_name("runtime")


@dataclass
class Public:
    """One public function as the template prints it."""

    signature: str
    summary: str
    doc: list[str]
    body: list[str]


@dataclass
class ModuleText:
    """One module as the template prints it."""

    title: str
    text: str
    imports: list[str] = field(default_factory=list)
    public: list[Public] = field(default_factory=list)
    private: list[dict[str, object]] = field(default_factory=list)


def module_sources(derived: Mapping[str, Mapping[str, Entry]]) -> dict[str, str]:
    """The package as `{path below catalogue/: text}`, for entries by profile name and suffix."""
    names = sorted(derived)
    files = {f"{PACKAGE}/{path.name}": path.read_text() for path in sorted(RUNTIME.glob("*.py"))}
    files[f"{PACKAGE}/__init__.py"] = _environment().get_template("package.py.j2").render()
    files[f"{PACKAGE}/py.typed"] = ""
    files[f"{PACKAGE}/_nodes.py"] = nodes_source(NODE_COUNTS)
    files[f"{PACKAGE}/_symbols.py"] = symbols_source(_parameters(derived))
    files[f"{PACKAGE}/normal/__init__.py"] = _environment().get_template("physics.py.j2").render(names=names)
    for name in names:
        files[f"{PACKAGE}/normal/{name}.py"] = module_source(derived[name])
    return files


def module_source(entries: Mapping[str, Entry]) -> str:
    """The module of one profile."""
    return _environment().get_template("module.py.j2").render(module=_module(entries))


def source_of(entry: Entry, entries: Mapping[str, Entry] | None = None) -> str:
    """The text of the public function of one entry, with the private functions it rests on."""
    if entries is None:
        from ..contact.normal import derive

        entries = derive(entry.profile)
    module = _module(entries)
    name = entry.quantity.function
    public = [p for p in module.public if p.signature.startswith(f"def {name}(")]
    text = "\n".join(p for function in public for p in function.body)
    private: list[dict[str, object]] = []
    for function in reversed(module.private):
        if f"{function['name']}" in text:
            private.insert(0, function)
            text += "\n" + "\n".join(str(line) for line in function["lines"])  # type: ignore[attr-defined]
    part = ModuleText(module.title, module.text, [], public, private)
    whole = _environment().get_template("module.py.j2").render(module=part)
    return whole[whole.index("def ") :]


def _parameters(derived: Mapping[str, Mapping[str, Entry]]) -> set[str]:
    return {
        parameter_name(symbol)
        for entries in derived.values()
        for entry in entries.values()
        for symbol in entry.parameters
        if symbol != coefficients
    }


def _module(entries: Mapping[str, Entry]) -> ModuleText:
    profile = next(iter(entries.values())).profile
    functions = _private_functions(profile, entries)
    quantities = COMPACT if profile.contact == "compact" else COMPLETE
    module = ModuleText(profile.title, _module_text(profile))
    fields = example.field_values(profile, entries)
    for suffix, quantity in quantities.items():
        if suffix == "f" or suffix in entries:
            entry = entries.get(suffix)
            if suffix == "k" and entry is not None and any(case.expr.has(d) for case in entry.cases):
                quantity = replace(quantity, arguments=(d,))  # noqa: PLW2901 - two branches, told apart by the depth
            module.public.append(
                _public(profile, quantity, entry, functions, _example(profile, quantity, entry, fields, entries))
            )
    if profile.rules:
        module.private.append(_check(profile))
    used = [private for private in functions.functions.values() if _used(private, module, functions)]
    module.private += [_private(private, profile) for private in used]
    module.imports = _imports(module)
    return module


def _private_functions(profile: Profile, entries: Mapping[str, Entry]) -> PrivateFunctions:
    functions = PrivateFunctions(profile)
    _profile_function(functions)
    if profile.contact == "complete":
        Complete(entries, functions).add_all()
        return functions
    compact = Compact(entries, functions)
    compact.depth_like("d", "depth")
    compact.depth_like("F", "force")
    compact.pressure()
    compact.displacement()
    form = evaluation_form(entries["k"].cases[0].expr, facts_of(()))
    compact.stiffness(form)
    compact.depth_like("pm", "mean_pressure")
    Inverses(compact).add_all()
    return functions


def _profile_function(functions: PrivateFunctions) -> None:
    profile = functions.profile
    lines, needs, values = [], set(), []
    lower: sp.Expr = sp.S.Zero
    for piece in profile.pieces:
        form = evaluation_form(piece.expr, facts_of((lower, r) if lower != 0 else (r,)))
        lines += [line for line in functions.steps(form) if line not in lines]
        needs |= functions.needs(form, ("r",))
        values.append((piece.upper, python(form.value)))
        lower = piece.upper
    text = values[-1][1]
    for upper, value in reversed(values[:-1]):
        text, needs = f"np.where(r < {upper}, {value}, {text})", needs | {str(upper)}
    if profile.contact == "complete":
        text, needs = f"np.where(r <= a, {text}, np.nan)", needs | {"a"}
    if text == "0":
        text = "np.zeros_like(r)"
    functions.add("profile", ("r",), [*lines, f"return {text}"], needs)


def _public(
    profile: Profile, quantity: Quantity, entry: Entry | None, functions: PrivateFunctions, shown: list[str]
) -> Public:
    fields = [str(argument) for argument in quantity.arguments]
    keywords = [parameter_name(s) for s in (entry.parameters if entry else profile.parameters)]
    typed = [f"{name}: ArrayLike" for name in fields] + ["*"] + [f"{name}: ArrayLike" for name in keywords]
    private = functions.functions[quantity.function]
    check = "_check" if profile.rules else "require"
    summed = "A" in keywords and coefficients in profile.parameters
    required = [name for name in keywords if not (summed and name == "A")]
    body = [f"{check}({', '.join(f'{name}={name}' for name in required)})"] if required else []
    function, passed = private.name, [f"{name}={name}" for name in private.needs]
    if summed:
        body.insert(0, "A = require_coefficients(A)" if "A" in private.needs else "require_coefficients(A)")
        if "A" in private.needs:
            function, passed = f"partial({private.name}, A=A)", [p for p in passed if p != "A=A"]
    body.append(f"return elementwise({', '.join([function, *fields, *passed])})")
    doc = docstring(profile, quantity, entry, _notes(profile, quantity, private, functions), shown)
    signature = f"def {quantity.function}({', '.join(typed)}) -> Result:"
    if len(signature) > 120:
        signature = f"def {quantity.function}(\n    {', '.join(typed)}\n) -> Result:"
    return Public(signature, SUMMARY[quantity.suffix], doc, body)


def _notes(profile: Profile, quantity: Quantity, private: Private, functions: PrivateFunctions) -> list[str]:
    notes = [f"Valid for {profile.validity}. Negative or NaN field values give NaN."]
    text = "\n".join(private.lines)
    for other in functions.functions.values():
        if other.name in text:
            text += "\n" + "\n".join(other.lines)
    if "_integral" in text or "power_pressure" in text or "power_displacement" in text or "power_punches" in text:
        notes.append("Evaluated as an integral over the growing contact by a Gauss-Legendre rule.")
    if "inverse(" in text:
        notes.append("Evaluated by a safeguarded Newton iteration.")
    if profile.note and quantity.suffix in ("p", "F", "d") and coefficients not in profile.parameters:
        notes.append(f"{profile.note[:1].upper()}{profile.note[1:]}.")
    key = "f" if quantity.suffix == "f" else quantity.suffix
    notes.append(f"Handbook: {profile.name}.{key}" + ("." if key != "f" else ", the definition of the profile."))
    return [" ".join(notes)]


def _example(
    profile: Profile,
    quantity: Quantity,
    entry: Entry | None,
    fields: Mapping[sp.Symbol, sp.Rational],
    entries: Mapping[str, Entry],
) -> list[str]:
    known = example.environment(profile)
    place = dict(fields)
    if quantity.suffix == "w":
        place[r] = 2 * (known[a] if profile.contact == "complete" else fields[a])
    symbols = entry.parameters if entry else profile.parameters
    arguments = [example.literal(place[argument]) for argument in quantity.arguments]
    for symbol in symbols:
        if symbol == coefficients:
            arguments.append(f"A=({', '.join(example.literal(c) for c in example.POLYNOMIAL)})")
        else:
            arguments.append(f"{symbol}={example.literal(known[symbol])}")
    call = f"{profile.name}.{quantity.function}({', '.join(arguments)})"
    at = known | {argument: place[argument] for argument in quantity.arguments}
    if quantity.suffix in ("Fd", "dF") and entry is not None and entry.status == "root" and entry.composed:
        outer, inner = entry.composed
        at = at | {a: example.value(profile, entries[inner], at)}
        number = example.value(profile, entries[outer], at)
    elif entry is None:
        number = example.shape_value(profile, at)
    else:
        at = _with_ring(profile, entries, at)
        number = example.value(profile, entry, at)
    lines = [f">>> from {PACKAGE}.normal import {profile.name}", f">>> value = {call}", ">>> round(value, 6)"]
    return [*lines, example.result(number)]


def _with_ring(
    profile: Profile, entries: Mapping[str, Entry], at: dict[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    ring = entries.get("rz")
    if ring is None or ring.status != "root":
        return at
    return at | {nt.r_zero: example.value(profile, ring, at)}


def _check(profile: Profile) -> dict[str, object]:
    names = [parameter_name(s) for s in profile.parameters]
    passed = ", ".join(f"{name}={name}" for name in names)
    lines = [f"require({passed}, **material)"]
    for rule in profile.rules:
        symbols = sorted((str(s) for s in (rule.left.free_symbols | rule.right.free_symbols)), key=names.index)
        relation = sp.sstr(rule.relation())
        arrays = ", ".join(f"np.asarray({name})" for name in symbols)
        lines.append(f"{', '.join(symbols)} = {arrays}")
        sign, left, right = "<" if rule.strict else "<=", rule.left, rule.right
        if left.is_number:
            sign, left, right = sign.replace("<", ">"), right, left
        given = ", ".join(f"{name}={name}" for name in symbols)
        lines += [
            "require_order(",
            f"    {python(left)} {sign} {python(right)},",
            f'    "{relation}",',
            *_literal(rule.reason),
            *(f"    {part}," for part in given.split(", ")),
            ")",
        ]
    signature = ", ".join([*(f"{name}: ArrayLike" for name in names), "**material: ArrayLike"])
    return {"name": "_check", "signature": signature, "lines": lines, "returns": " -> None", "doc": ""}


def _literal(text: str) -> list[str]:
    """A message as adjacent string literals that fit on their lines."""
    parts = [text] if len(text) <= 109 else textwrap.wrap(text, 100, drop_whitespace=False)
    return [f'    "{part}"' for part in parts[:-1]] + [f'    "{parts[-1]}",']


def _private(private: Private, profile: Profile) -> dict[str, object]:
    typed = [f"{name}: Array" for name in private.fields]
    for name in private.needs:
        kind = "tuple[float, ...]" if name == "A" and coefficients in profile.parameters else "Array"
        typed.append(f"{name}: {kind}")
    pair = private.name.startswith("_contact_from")
    return {
        "name": private.name,
        "signature": ", ".join(typed),
        "lines": list(private.lines),
        "returns": " -> tuple[Array, Array]" if pair else " -> Array",
        "doc": private.doc,
    }


def _used(private: Private, module: ModuleText, functions: PrivateFunctions) -> bool:
    """Whether a public function calls it, directly or through others."""
    reached, pending = set(), _names("\n".join(line for function in module.public for line in function.body))
    while pending:
        name = pending.pop()
        if name not in reached:
            reached.add(name)
            pending |= set().union(
                *(_names("\n".join(p.lines)) for p in functions.functions.values() if p.name == name)
            )
    return private.name in reached


def _names(text: str) -> set[str]:
    return set(re.findall(r"\b_\w+", text))


def _imports(module: ModuleText) -> list[str]:
    text = "\n".join([*(str(line) for function in module.private for line in function["lines"])])  # type: ignore[attr-defined]
    text += "\n".join(line for function in module.public for line in function.body)
    blocks = ["from functools import partial"] if "partial(" in text else []
    blocks += ["from typing import TYPE_CHECKING", ""]
    if "np." in text:
        blocks.append("import numpy as np")
    blocks.append("")
    domain = [name for name in ("require", "require_coefficients", "require_order") if f"{name}(" in text]
    blocks.append(f"from .._domain import {', '.join(domain)}")
    blocks.append("from .._elementwise import Array, Result, elementwise")
    helpers = [name for name in HELPERS if f"{name}(" in text]
    if helpers:
        blocks.append(f"from .._functions import {', '.join(helpers)}")
    rules = sorted({name for name in _rule_names() if f"{name}(" in text})
    if rules:
        line = f"from .._integrals import {', '.join(rules)}"
        split = ["from .._integrals import (", *(f"    {rule}," for rule in rules), ")"]
        blocks += [line] if len(line) <= 120 else split
    if "inverse(" in text:
        blocks.append("from .._inverse import inverse")
    powers = [
        n for n in ("power_displacement", "power_pressure", "power_punches", "ring_of_zero_pressure") if f"{n}(" in text
    ]
    if powers:
        blocks.append(f"from .._powers import {', '.join(powers)}")
    return [*blocks, "", "if TYPE_CHECKING:", "    from numpy.typing import ArrayLike"]


@cache
def _rule_names() -> tuple[str, ...]:
    text = (RUNTIME / "_integrals.py").read_text()
    return tuple(
        line[4 : line.index("(")] for line in text.splitlines() if line.startswith("def ") and "_integral" in line
    )


def _module_text(profile: Profile) -> str:
    return "\n".join(textwrap.wrap(profile.subtitle, 110))


@cache
def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.emit", "templates"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
