"""The text of a scene's module: docstring, constants, the wanted functions, and what they rest on."""

from __future__ import annotations

import ast
import json
import re
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from copy import deepcopy
from pathlib import Path
from typing import TYPE_CHECKING

from ... import __version__
from ... import notation as nt
from ...code.python import NODE_COUNTS
from ...code.text import python
from ...profiles.profile import Profile, Rule
from .. import interface
from ..contact import Contact, worked
from ..reading import Scene
from .library import Definition, Module, definition, parameters, references, source
from .linking import OWN, Linker, Wanted
from .written import documented, marks

if TYPE_CHECKING:
    from ...expression.answer import Answer


def head(request: Scene, profile: Profile, answer: Answer | None, contact: Contact) -> str:
    """Title, what the profile is, and the worked example."""
    law = request.kind.law
    kind = f"on {law.material}, while it grows" if law else request.kind.physics.contact
    if request.kind.graded:
        kind += " on a half-space whose modulus grows as a power of depth"
    title = _plain(request.title)
    what = f"{profile.title}: {_plain(profile.subtitle)}" if answer is None else _plain(
        profile.subtitle)  # fmt: skip
    lines = [
        f"{title}.",
        "",
        *_wrapped(f"{what}. Contact {kind}, SI units, angles in radians. Written by axicontact {__version__}."),
    ]
    if answer is not None:
        lines += _wrapped(f"Valid: {answer.validity.sentence}.")
    if request.at is not None:
        lines += _wrapped(worked(contact))
    return "\n".join(lines) + "\n"


def _plain(text: str) -> str:
    """Text that is safe within a docstring."""
    kept = "".join(c if c.isprintable() else " " for c in text).replace("\\", "/").replace('"', "'")
    return kept.rstrip(".").strip() or "Scene"


def _wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, 110)


TEMPLATES: dict[str, str] = dict(
    re.findall(r"^=== (\w+)\n(.*?)\n(?=\n===|\Z)", Path(__file__).with_name("templates.txt").read_text(), re.M | re.S)
)
"""Text of Python to be filled in, by name."""
POSITIONS = ("r", "x")


def module_text(
    head: str,
    modules: Mapping[str, Module],
    wanted: Sequence[Wanted],
    constants: Mapping[str, tuple[float | str, str]],
    domains: Mapping[str, tuple[str, str, str]],
    units: Mapping[str, str],
) -> str:
    """The module.

    Parameters
    ----------
    head : str
        Docstring of the module.
    modules : mapping
        The library by name of module, with that of what is written for the scene.
    wanted : sequence of Wanted
        The functions of the interface, in order; those without fields come last.
    constants : mapping
        Values of the frozen parameters and what they are; those that nothing needs are left out.
    domains : mapping
        Interval of each parameter that is left free: its ends, and which of them is in it.
    units : mapping
        Units of all fields and parameters.
    """
    wanted = sorted(wanted, key=lambda one: not one.fields)
    frozen = frozenset(constants)
    positive = frozenset(k for k, (value, _) in constants.items() if not isinstance(value, str) and value > 0.0)
    linker, fielded = Linker(modules, wanted, frozen, positive), [one for one in wanted if one.elementwise]
    counts = _counts(linker)  # numbers of the trees, which are texts once they are written
    hidden = {*linker.merged, *(one.key for one in wanted if not one.elementwise)}
    first = linker.decorators
    private = [linker.text(key) for key in linker.program.functions if key not in hidden and key not in first]
    constants_of, behind = _constants(linker)
    values, late = ([linker.text(key) for key in keys] for keys in (constants_of, behind))
    above = [linker.text(key) for key in first]
    body = "\n\n\n".join([*above, *(_public(linker, one) for one in wanted), *private])
    if "_integral(" in body:
        body += f"\n\n\n{TEMPLATES['integral']}"
    if "_NODES[" in body:
        values.append(_nodes(modules["_runtime.nodes"], counts))
    free = sorted({name for one in wanted for name in one.keywords})
    if free:
        ends = {name: _ends(*domains[name]) for name in free}
        values.append("\n".join(["_DOMAINS = {", *(f'    "{name}": ({both}),' for name, both in ends.items()), "}"]))
        body = f"{TEMPLATES['require']}\n\n\n{body}"
    given = dict.fromkeys([name for one in wanted for name in one.fields] + free)
    if given:
        values.append(f"_UNITS = {{{', '.join(f'{name!r}: {units[name]!r}' for name in given)}}}".replace("'", '"'))
    used = {k: own for k, own in constants.items() if re.search(rf"\b{re.escape(k)}\b", body + "\n".join(values))}
    for parity in ("odd", "even"):
        if any(one.parity == parity for one in wanted):
            body = f"{TEMPLATES[parity]}\n\n\n{body}"
    body = f"{_core(fielded)}\n\n\n{body}" if fielded else body
    body = f"{TEMPLATES['bare']}\n\n\n{body}" if given else body
    written = {k: json.dumps(value) if isinstance(value, str) else repr(value) for k, (value, _) in used.items()}
    shown = [f"{name} = {written[name]}  # {comment}" for name, (_, comment) in used.items()]
    parts = [f'"""{head}"""', _imports(body + "\n".join(values)), "\n".join([*shown, *values])]
    body = "\n\n\n".join([body, *(["\n".join(late)] if late else [])])
    return "\n\n".join(part for part in parts if part) + "\n\n\n" + body + "\n"


def _ends(low: str, high: str, closed: str) -> str:
    """The open interval of the numbers in a domain."""
    below = f"np.nextafter({high}, np.inf)" if closed == "high" else high.replace("inf", "np.inf")
    return f"{low.replace('inf', 'np.inf')}, {below}"


def _vanishes(one: Wanted) -> bool:
    """Whether it is a field of a position that is zero infinitely far away; the shape of the indenter is not."""
    return one.fields[0] in POSITIONS and one.name != "profile"


def _core(wanted: Sequence[Wanted]) -> str:
    signed, far = any(one.signed for one in wanted), any(_vanishes(one) for one in wanted)
    return TEMPLATES["core"].format(
        option=(", least=0.0" if signed else "") + (", vanishing=False" if far else ""),
        nan="" if signed else "; NaN where a field is negative",
        least="least" if signed else "0.0",
        parameters=", **parameters" if any(one.keywords for one in wanted) else "",
        axis=TEMPLATES["axis"].format(place="np.abs(fields[0])" if signed else "fields[0]") + "\n" if far else "",
        far=TEMPLATES["far"] + "\n" if far else "",
    )


def _public(linker: Linker, one: Wanted) -> str:
    """A function of the interface, by itself or in front of a private one that takes more than its fields."""
    options = ["least=-np.inf"] * one.signed + ["vanishing=True"] * bool(one.elementwise and _vanishes(one))
    above = [f"@_{one.parity}"] if one.parity else []
    above.append(f"@partial(_elementwise, {', '.join(options)})" if options else "@_elementwise")
    if one.key in linker.merged:
        return "\n".join([*above, linker.text(one.key, one.doc)])
    tree = linker.program.trees[one.key]
    given = [*one.fields, *filter(None, [one.leading]), *(["*", *one.keywords] if one.keywords else [])]
    head = [f"def {one.name}({', '.join(given)}):", *documented(one.doc), *_checks(linker, one)]
    if not one.elementwise:
        return linker.text(one.key, head=[*marks(tree, linker.names), *head])
    call = f"{linker.names[one.key]}({', '.join(parameters(tree))})"
    return "\n".join([*above, *head, f"    return {call}"])


def _checks(linker: Linker, one: Wanted) -> list[str]:
    """What a function asks of its keywords first: their domains, and the order of those that are left to them alone."""
    if not one.keywords:
        return []
    order = linker.program.trees.get(f"{OWN}:{REQUIRE_ORDER}")
    left = parameters(order) if order else []
    found = [f"    _require({', '.join(f'{k}={k}' for k in one.keywords)})"]
    return [*found, f"    {REQUIRE_ORDER}({', '.join(left)})"] if left and {*left} <= {*one.keywords} else found


def _constants(linker: Linker) -> tuple[list[str], list[str]]:
    """What is no function, each after those it is made of; and apart what names functions, which stands behind them."""
    found: dict[str, None] = {}
    trees, functions = linker.program.trees, linker.program.functions

    def add(key: str) -> None:
        if key in trees and key not in functions and key not in found:
            for name in references(trees[key]):
                add(name.id)
            found[key] = None

    for key in trees:
        add(key)
    late: list[str] = []
    for key in found:
        if any(name.id in functions or name.id in late for name in references(trees[key])):
            late.append(key)
    return [key for key in found if key not in late], late


def _counts(linker: Linker) -> list[int]:
    """The numbers of nodes that the linked text can ask for."""
    nodes = (node for tree in linker.program.trees.values() for node in ast.walk(tree))
    found = {node.value for node in nodes if isinstance(node, ast.Constant) and isinstance(node.value, int)}
    return [count for count in NODE_COUNTS if count in found]


def _nodes(module: Module, counts: Sequence[int]) -> str:
    """Nodes and weights of the rules that are used, as the generated package has them."""
    node = module.definitions["_LOWER_HALVES"].node
    assert isinstance(node, ast.Assign)
    table = ast.literal_eval(node.value)
    lines = ["# Gauss-Legendre rules on (0, 1): the lower half of the nodes, with their weights", "_NODES = {"]
    for count in counts:
        pairs = ", ".join(f"({x!r}, {w!r})" for x, w in table[count])
        lines += [
            f"    {count}: [",
            *textwrap.wrap(pairs + ",", 112, initial_indent=" " * 8, subsequent_indent=" " * 8),
        ]
        lines.append("    ],")
    return "\n".join([*lines, "}"])


def _imports(text: str) -> str:
    functools = [
        name
        for name in ("cache", "lru_cache", "partial", "reduce", "wraps")
        if re.search(rf"\b{name}\(|@{name}\b", text)
    ]
    lines = [f"from functools import {', '.join(functools)}"] if functools else []
    lines = ["from collections import namedtuple", *lines] if "namedtuple(" in text else lines
    lines = [*(["import math"] if re.search(r"\bmath\.", text) else []), *lines]
    return "\n".join([*lines, *([""] if lines else []), "import numpy as np"])


SILENT = '@np.errstate(all="ignore")\n'
WAVES = "from ._runtime.graded.waves import steepest_waves\n\n"
PLAIN = frozenset(["_runtime.physics.adhesion", "_runtime.interface"])
"""Modules of the runtime that have nothing but formulas for the state of pull-off."""
ZONE = "_pull_off_zone"
"""What loads take of a state of pull-off beside its radius, where that has a cohesive zone."""
REQUIRE_ORDER = "_require_order"


def _call(modules: Mapping[str, Module], key: str) -> str:
    own = definition(modules, key)
    return f"{own.name}({', '.join(own.parameters)})"


def _float(value: str, *, array: bool) -> str:
    return f"float(np.squeeze({value}))" if array else f"float({value})"


def number(modules: Mapping[str, Module], key: str, name: str, *, array: bool) -> str:
    """A result without fields; `array` where its rules give an array of one."""
    own = definition(modules, key)
    return TEMPLATES["number"].format(
        module=own.module.name, private=own.name, name=name, parameters=", ".join(own.parameters),
        value=_float(_call(modules, key), array=array), silent=SILENT if array else "",
    )  # fmt: skip


def pull_off(modules: Mapping[str, Module], key: str, parameters: Sequence[str], *, array: bool) -> str:
    """The state at which the contact breaks, which has no fields and three results."""
    found, three = modules[key], ("radius", "force", "depth")
    names = {name: own if (own := f"_pull_off_{name}") in found.definitions else f"_{name}" for name in three}
    growing, zoned = names["radius"] in found.definitions, ZONE in found.definitions
    if zoned:
        names["force"] = "_force_of"
    called = {
        f"{name}_of": _call(modules, f"{key}:{own}") for name, own in names.items() if growing or name != "radius"
    }
    if not growing:
        called = {name: _float(value, array=array) for name, value in called.items()}
    elif {source.partition(":")[0] for source in found.imported.values()} <= PLAIN:
        called["state"] = "float(a), float(force), float(depth)"
    else:
        called["radius_of"] = f"np.ravel({called['radius_of']})"
        called["state"] = "*(float(np.squeeze(x)) for x in (a, force, depth))"
    called["zone_of"] = f"\n    q = {_call(modules, f'{key}:{ZONE}')}" if zoned else ""
    return TEMPLATES["growing" if growing else "peeling"].format(
        module=key, parameters=", ".join(parameters), silent=SILENT if growing or array else "",
        zone=f", {ZONE}" if zoned else "", **names, **called,
    )  # fmt: skip


STRESSES = "_runtime.subsurface.stresses"


def taken(own: Definition) -> str:
    """The arguments in the head of a function."""
    assert isinstance(own.node, ast.FunctionDef)
    return source(own.node.args)


def whole(home: Module, function: interface.Function) -> tuple[str, list[str]]:
    """A function of several results as its module has it, without what asks about its arguments, and its keywords."""
    node = deepcopy(home.definitions[function.name].node)
    assert isinstance(node, ast.FunctionDef)
    last, head = node.body[-1], node.args
    assert isinstance(last, ast.Return) and last.value is not None
    needs = [arg.arg for arg, value in zip(head.kwonlyargs, head.kw_defaults, strict=True) if value is None]
    for call in (n for n in ast.walk(last) if isinstance(n, ast.Call)):
        call.keywords = [keyword for keyword in call.keywords if keyword.arg]
    given = [*function.fields, *needs]
    names = {n.id for n in ast.walk(last.value) if isinstance(n, ast.Name)} - {*given}
    text = TEMPLATES["whole"].format(
        module=home.name, names=", ".join(sorted(names)), name=function.name,
        parameters=", ".join(given), value=source(last.value),
    )  # fmt: skip
    return text, needs


def leaning(key: str, name: str) -> str:
    """A field under a load on either side of the middle."""
    module, _, private = key.partition(":")
    return TEMPLATES["leaning"].format(module=module, private=private, name=name)


def held(modules: Mapping[str, Module], key: str, name: str) -> str:
    """A function of a depth that is held, which must not end before it begins."""
    own = definition(modules, key)
    return TEMPLATES["held"].format(
        module=own.module.name, private=own.name, name=name, parameters=", ".join(own.parameters)
    )


def order(profile: Profile, rules: Sequence[Rule], kind: interface.Kind, frozen: Iterable[str]) -> str:
    """The check of the rules between parameters of which some are free; empty if none is."""
    left = {name: symbol for name, symbol in interface.parameters(profile).items() if name not in set(frozen)}
    for rule in rules:
        symbols = rule.left.free_symbols | rule.right.free_symbols
        waves = kind.graded and nt.wavelength in symbols
        names = [name for name, symbol in interface.parameters(profile).items() if symbol in symbols]
        names += ["k"] if kind.graded and (waves or nt.k in symbols) else []
        if not ({*names} & ({*left} | ({"k"} - {*frozen}))):
            continue
        relation = f"{python(rule.left)} {'<' if rule.strict else '<='} {python(rule.right)}"
        relation = "steepest_waves(k) * R * h <= wavelength**2" if waves else relation
        given = ", ".join(f"{name} = {{{name}!r}}" for name in names)
        text = TEMPLATES["order"].format(
            names=", ".join(names), relation=relation, given=given,
            shown=relation.replace("np.", "").replace("{", "").replace("}", ""), reason=rule.reason,
        )  # fmt: skip
        # profiles have one rule at most between their parameters
        return (WAVES if waves else "") + text
    return ""
