"""The text of a scene's module: docstring, constants, the wanted functions, and what they rest on."""

from __future__ import annotations

import ast
import re
import textwrap
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from ... import __version__
from ...code.python import NODE_COUNTS
from ...profiles.profile import Profile
from ..contact import Contact, worked
from ..reading import Scene
from .assembled import REQUIRE_ORDER, Assembled
from .library import Module, parameters, references
from .linking import OWN, Linker, Wanted
from .written import documented

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


BARE = '''def _bare(name, value):
    """The value as an array; a quantity would lose its unit there, and a masked array its mask."""
    if isinstance(value, (list, tuple)):
        value = [_bare(name, member) for member in value]
    elif any(getattr(value, sign, None) is not None for sign in ("units", "unit", "magnitude", "filled")):
        raise TypeError(f"{name} = {value!r} is no bare number; give {name}.to({_UNITS[name]!r}).magnitude or filled()")
    return np.asarray(value, dtype=float)'''
CORE = '''def _elementwise(function{option}):
    """Numbers or arrays in, a float or an array out{nan}."""

    @wraps(function)
    def evaluate(*fields{parameters}):
        fields = [*np.broadcast_arrays(*map(_bare, function.__code__.co_varnames, fields))]
{axis}        with np.errstate(all="ignore"):
            result = function(*(x.ravel() for x in fields){parameters}) + np.zeros(fields[0].size)
        result = np.where(np.min(fields, axis=0) >= {least}, result.reshape(fields[0].shape), np.nan)
{far}        return result if result.ndim else float(result)

    return evaluate'''
AXIS = """        infinite = vanishing & ({place} == np.inf)
        fields[0] = np.where(infinite, 0.0, fields[0])  # there is a value on the axis, not at infinity
"""
FAR = """        result = np.where(infinite & ~np.isnan(result), 0.0, result)
"""
EVEN = """def _even(function):
    \"\"\"The same on both sides of the middle.\"\"\"

    @wraps(function)
    def evaluate(x, *fields, **parameters):
        return function(np.abs(_bare("x", x)), *fields, **parameters)

    return evaluate"""
ODD = """def _odd(function):
    \"\"\"Of the other sign on the other side of the middle.\"\"\"

    @wraps(function)
    def evaluate(x, *fields, **parameters):
        x = _bare("x", x)
        return np.copysign(1.0, x) * function(np.abs(x), *fields, **parameters) + 0.0

    return evaluate"""
REQUIRE = """def _require(**parameters):
    for name, value in parameters.items():
        low, high = _DOMAINS[name]
        if not low < _bare(name, value) < high:
            raise ValueError(f"{name} = {value!r} is outside {low} < {name} < {high}")"""
POSITIONS = ("r", "x")
INTEGRAL = '''def _integral(integrand, stop, count):
    """Integral of `integrand` from 0 to `stop`."""
    rule = _NODES[count]
    return stop * sum(w * (integrand(x * stop) + integrand((1.0 - x) * stop)) for x, w in rule)'''


def module_text(
    head: str,
    modules: Mapping[str, Module],
    wanted: Sequence[Wanted],
    constants: Mapping[str, tuple[float, str]],
    domains: Mapping[str, tuple[str, str]],
    units: Mapping[str, str],
    above: Sequence[Assembled] = (),
    order: tuple[str, ...] = (),
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
    constants : mapping
        Values of the frozen parameters and what they are; those that nothing needs are left out.
    domains : mapping
        Open interval of each parameter that is left free.
    units : mapping
        Units of all fields and parameters.
    above : sequence of Assembled
        The functions of the interface that are written for the scene.
    order : sequence of str
        Arguments of the check of the rules between parameters, empty if there is none.
    """
    frozen, positive = frozenset(constants), frozenset(name for name, (value, _) in constants.items() if value > 0.0)
    roots = (*(one.key for one in above), *([f"{OWN}:{REQUIRE_ORDER}"] if order else []))
    linker = Linker(modules, wanted, frozen, positive, roots)
    left, counts = [name for name in order if name not in frozen], _counts(linker)
    public = []
    for one in wanted:
        options = [*(["least=-np.inf"] if one.signed else []), *(["vanishing=True"] if _vanishes(one) else [])]
        decorator = f"@partial(_elementwise, {', '.join(options)})" if options else "@_elementwise"
        if one.key in linker.merged:
            text = linker.text(one.key, one.doc)
        else:
            text = _wrapper(linker, one, left)
        mirrored = f"@_{one.parity}\n" if one.parity else ""
        public.append(f"{mirrored}{decorator}\n{text}")
    public += [_assembled(linker, one, left) for one in above]
    hidden = {*linker.merged, *(one.key for one in above)}
    private = [linker.text(key) for key in linker.program.functions if key not in hidden]
    values = [linker.text(key) for key in _constants(linker)]
    body = "\n\n\n".join([*public, *private])
    if "_integral(" in body:
        body += f"\n\n\n{INTEGRAL}"
    if "_NODES[" in body:
        values.append(_nodes(modules["_runtime.nodes"], counts))
    free = sorted({k for taken in (*(w.keywords for w in wanted), *(a.keywords for a in above)) for k in taken})
    if free:
        rows = "".join(f'    "{name}": ({domains[name][0]}, {domains[name][1]}),\n' for name in free)
        values.append("_DOMAINS = {\n" + rows + "}")
        body = f"{REQUIRE}\n\n\n{body}"
    given = dict.fromkeys([name for one in wanted for name in one.fields] + free)
    if given:
        values.append(f"_UNITS = {{{', '.join(f'{name!r}: {units[name]!r}' for name in given)}}}".replace("'", '"'))
    used = {k: own for k, own in constants.items() if re.search(rf"\b{re.escape(k)}\b", body + "\n".join(values))}
    for parity, text in (("odd", ODD), ("even", EVEN)):
        if any(one.parity == parity for one in wanted):
            body = f"{text}\n\n\n{body}"
    body = f"{_core(wanted)}\n\n\n{body}" if wanted else body
    body = f"{BARE}\n\n\n{body}" if given else body
    shown = [f"{name} = {value!r}  # {comment}" for name, (value, comment) in used.items()]
    parts = [f'"""{head}"""', _imports(body + "\n".join(values)), "\n".join([*shown, *values])]
    return "\n\n".join(part for part in parts if part) + "\n\n\n" + body + "\n"


def _vanishes(one: Wanted) -> bool:
    """Whether it is a field of a position that is zero infinitely far away; the shape of the indenter is not."""
    return one.fields[0] in POSITIONS and one.name != "profile"


def _core(wanted: Sequence[Wanted]) -> str:
    signed, far = any(one.signed for one in wanted), any(_vanishes(one) for one in wanted)
    return CORE.format(
        option=(", least=0.0" if signed else "") + (", vanishing=False" if far else ""),
        nan="" if signed else "; NaN where a field is negative",
        least="least" if signed else "0.0",
        parameters=", **parameters" if any(one.keywords for one in wanted) else "",
        axis=AXIS.format(place="np.abs(fields[0])" if signed else "fields[0]") if far else "",
        far=FAR if far else "",
    )


def _checks(keywords: Sequence[str], left: Sequence[str]) -> list[str]:
    """What a public function asks of its keywords first: their domains, and the order of those `left` to them alone."""
    if not keywords:
        return []
    found = [f"    _require({', '.join(f'{k}={k}' for k in keywords)})"]
    return [*found, f"    {REQUIRE_ORDER}({', '.join(left)})"] if left and {*left} <= {*keywords} else found


def _wrapper(linker: Linker, one: Wanted, left: Sequence[str]) -> str:
    """A public function in front of a private one that takes more than the fields."""
    passed = parameters(linker.program.trees[one.key])
    signature = ", ".join([*one.fields, *(["*", *one.keywords] if one.keywords else [])])
    call = f"{linker.names[one.key]}({', '.join(passed)})"
    head = f"def {one.name}({signature}):"
    return "\n".join([head, *documented(one.doc), *_checks(one.keywords, left), f"    return {call}"])


def _assembled(linker: Linker, own: Assembled, left: Sequence[str]) -> str:
    """The linked function with its docstring and the check of what stays free."""
    signature = ", ".join(part for part in (own.leading, *(["*", *own.keywords] if own.keywords else [])) if part)
    head = [*own.decorators, f"def {own.name}({signature}):", *documented(own.doc), *_checks(own.keywords, left)]
    return linker.text(own.key, head=head)


def _constants(linker: Linker) -> list[str]:
    """What is no function, each after those it is made of."""
    found: dict[str, None] = {}
    trees, functions = linker.program.trees, linker.program.functions

    def add(key: str) -> None:
        if key in trees and key not in functions and key not in found:
            for name in references(trees[key]):
                add(name.id)
            found[key] = None

    for key in trees:
        add(key)
    return list(found)


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
    functools = [name for name in ("cache", "partial", "reduce", "wraps") if re.search(rf"\b{name}\(|@{name}\b", text)]
    lines = [f"from functools import {', '.join(functools)}"] if functools else []
    lines = ["from collections import namedtuple", *lines] if "namedtuple(" in text else lines
    lines = [*(["import math"] if re.search(r"\bmath\.", text) else []), *lines]
    return "\n".join([*lines, *([""] if lines else []), "import numpy as np"])
