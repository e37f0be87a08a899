"""The text of a scene's module: constants, the wanted functions, and what they rest on."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from ..emit.python import NODE_COUNTS
from .library import Key, Module
from .linking import OWN, Linker, Wanted
from .rewriting import documented

CORE = '''def _elementwise(function{option}):
    """Numbers or arrays in, a float or an array out{nan}."""

    @wraps(function)
    def evaluate(*fields{parameters}):
        fields = np.broadcast_arrays(*(np.asarray(x, dtype=float) for x in fields))
        with np.errstate(all="ignore"):
            result = function(*(x.ravel() for x in fields){parameters}) + np.zeros(fields[0].size)
        result = np.where(np.min(fields, axis=0) >= {least}, result.reshape(fields[0].shape), np.nan)
        return result if result.ndim else float(result)

    return evaluate'''
EVEN = """def _even(function):
    \"\"\"The same on both sides of the middle.\"\"\"

    @wraps(function)
    def evaluate(x, *fields, **parameters):
        return function(np.abs(x), *fields, **parameters)

    return evaluate"""
ODD = """def _odd(function):
    \"\"\"Of the other sign on the other side of the middle.\"\"\"

    @wraps(function)
    def evaluate(x, *fields, **parameters):
        return np.copysign(1.0, x) * function(np.abs(x), *fields, **parameters) + 0.0

    return evaluate"""
REQUIRE = """def _require(**parameters):
    for name, value in parameters.items():
        low, high = _DOMAINS[name]
        if not low < value < high:
            raise ValueError(f"{name} = {value!r} is outside {low} < {name} < {high}")"""
INTEGRAL = '''def _integral(integrand, stop, count):
    """Integral of `integrand` from 0 to `stop`."""
    rule = _NODES[count]
    return stop * sum(w * (integrand(x * stop) + integrand((1.0 - x) * stop)) for x, w in rule)'''
PULL_OFF = """from ._adhesion import XI, PullOff
from .{module} import {radius}, {force}, {depth}

def pull_off({parameters}):
    if control not in XI:
        raise ValueError(f"control = {{control!r}} must be 'force' or 'depth'")
    a = np.ravel({radius_call})
    force = {force_call}
    depth = {depth_call}
    return PullOff(*(float(np.squeeze(x)) for x in (a, force, depth)))
"""


@dataclass(frozen=True)
class Constant:
    """A frozen parameter: its value and what it is."""

    name: str
    value: float
    comment: str


@dataclass(frozen=True)
class PullOff:
    """The private functions behind `pull_off`, which has no fields and three results."""

    radius: Key
    force: Key
    depth: Key
    doc: str
    parameters: tuple[str, ...]
    keywords: tuple[str, ...]

    def module(self, modules: Mapping[str, Module]) -> Module:
        """The function, to be linked like those it rests on."""

        def call(key: Key) -> str:
            return f"{key[1]}({', '.join(modules[key[0]].definitions[key[1]].parameters)})"

        text = PULL_OFF.format(
            module=self.radius[0], radius=self.radius[1], force=self.force[1], depth=self.depth[1],
            parameters=", ".join(["control", *self.parameters]),
            radius_call=call(self.radius), force_call=call(self.force), depth_call=call(self.depth),
        )  # fmt: skip
        return Module(OWN, text)


def module_text(
    head: str,
    modules: Mapping[str, Module],
    wanted: Sequence[Wanted],
    constants: Sequence[Constant],
    domains: Mapping[str, tuple[str, str]],
    pull_off: PullOff | None = None,
) -> str:
    """The module.

    Parameters
    ----------
    head : str
        Docstring of the module.
    modules : mapping
        The library by name of module.
    wanted : sequence of Wanted
        The functions of the interface, in order.
    constants : sequence of Constant
        The frozen parameters; those that nothing needs are left out.
    domains : mapping
        Open interval of each parameter that is left free.
    pull_off : PullOff, optional
        If it is wanted.
    """
    roots = ((OWN, "pull_off"),) if pull_off else ()
    if pull_off:
        modules = {**modules, OWN: pull_off.module(modules)}
    positive = frozenset(c.name for c in constants if c.value > 0.0)
    linker = Linker(modules, wanted, frozenset(c.name for c in constants), positive, roots)
    public, merged = [], set()
    for one in wanted:
        signed = "@partial(_elementwise, least=-np.inf)" if one.signed else "@_elementwise"
        if linker.merged(one):
            merged.add(one.key)
            text = linker.text(one.key, one.doc)
        else:
            text = _wrapper(linker, one)
        mirrored = f"@_{one.parity}\n" if one.parity else ""
        public.append(f"{mirrored}{signed}\n{text}")
    if pull_off:
        public.append(_pull_off(linker, pull_off))
    hidden = {*merged, *linker.inlined, *roots}
    private = [linker.text(key) for key, d in linker.reached.items() if key not in hidden and d.function]
    values = [linker.text(key) for key, d in linker.reached.items() if not d.function]
    body = "\n\n\n".join([*public, *private])
    if "_integral(" in body:
        body += f"\n\n\n{INTEGRAL}"
    if "_NODES[" in body:
        values.append(_nodes(modules["_nodes"], _counts(linker)))
    free = sorted({k for one in wanted for k in one.keywords} | set(pull_off.keywords if pull_off else ()))
    if free:
        rows = "".join(f'    "{name}": ({domains[name][0]}, {domains[name][1]}),\n' for name in free)
        values.append("_DOMAINS = {\n" + rows + "}")
        body = f"{REQUIRE}\n\n\n{body}"
    used = [c for c in constants if re.search(rf"\b{re.escape(c.name)}\b", body + "\n".join(values))]
    for parity, text in (("odd", ODD), ("even", EVEN)):
        if any(one.parity == parity for one in wanted):
            body = f"{text}\n\n\n{body}"
    body = f"{_core(wanted)}\n\n\n{body}" if wanted else body
    shown = [f"{c.name} = {c.value!r}  # {c.comment}" for c in used]
    parts = [f'"""{head}"""', _imports(body + "\n".join(values)), "\n".join([*shown, *values])]
    return "\n\n".join(part for part in parts if part) + "\n\n\n" + body + "\n"


def _core(wanted: Sequence[Wanted]) -> str:
    signed = any(one.signed for one in wanted)
    return CORE.format(
        option=", least=0.0" if signed else "",
        nan="" if signed else "; NaN where a field is negative",
        least="least" if signed else "0.0",
        parameters=", **parameters" if any(one.keywords for one in wanted) else "",
    )


def _wrapper(linker: Linker, one: Wanted) -> str:
    """A public function in front of a private one that takes more than the fields."""
    passed = [p for p in linker.reached[one.key].parameters if p not in linker.dropped[one.key]]
    signature = ", ".join([*one.fields, *(["*", *one.keywords] if one.keywords else [])])
    check = f"    _require({', '.join(f'{k}={k}' for k in one.keywords)})\n" if one.keywords else ""
    call = f"{linker.names[one.key]}({', '.join(passed)})"
    return "\n".join([f"def {one.name}({signature}):", *documented(one.doc), f"{check}    return {call}"])


def _pull_off(linker: Linker, own: PullOff) -> str:
    """The linked function with its default, its docstring and the check of what stays free."""
    _, *body = linker.text((OWN, "pull_off")).splitlines()
    signature = ", ".join(['control="force"', *(["*", *own.keywords] if own.keywords else [])])
    check = [f"    _require({', '.join(f'{k}={k}' for k in own.keywords)})"] if own.keywords else []
    head = ['@np.errstate(all="ignore")', f"def pull_off({signature}):", *documented(own.doc)]
    return "\n".join([*head, *check, *body])


def _counts(linker: Linker) -> list[int]:
    """The numbers of nodes that the linked text can ask for."""
    found = {
        node.value
        for definition in linker.reached.values()
        for node in ast.walk(definition.node)
        if isinstance(node, ast.Constant) and isinstance(node.value, int)
    }
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
    functools = [name for name in ("cache", "partial", "reduce", "wraps") if re.search(rf"\b{name}\(|@{name}\b", text)]
    lines = [f"from functools import {', '.join(functools)}"] if functools else []
    lines = ["from collections import namedtuple", *lines] if "namedtuple(" in text else lines
    lines = [*(["import math"] if re.search(r"\bmath\.", text) else []), *lines]
    return "\n".join([*lines, *([""] if lines else []), "import numpy as np"])
