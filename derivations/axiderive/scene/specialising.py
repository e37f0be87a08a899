"""Parameters for which all calls of a scene have one value go, with what that decides.

`def f(x, width=1.0)` whose calls never say another width becomes `def f(x)`, and in it `x / width` becomes `x`;
where every call says a width, it is `def f(x, width)`.
"""

from __future__ import annotations

import ast
from collections import ChainMap
from collections.abc import Iterator, Mapping, MutableMapping, Sequence

from .calls import arguments
from .folding import Edit, Folding, shortened
from .library import Definition, Key, Module

Modules = MutableMapping[str, Module]


def specialised(modules: Modules, roots: Sequence[Key], shared: frozenset[Key]) -> Modules:
    """The modules without these parameters; nothing changes in the `roots` and in what is `shared`."""
    while True:
        reached = _reach(modules, roots, shared)
        said, left = _said(modules, reached, frozenset(roots))
        found = {key: own for key, own in _fixed(said).items() if own}
        needless = {key: _without_default(reached[key], own, left[key]) for key, own in said.items() if own}
        if not found and not any(needless.values()):
            return modules
        edits: dict[Module, list[Edit]] = {}
        for definition in reached.values():
            own = edits.setdefault(definition.module, [])
            own += needless.get(definition.key, ()) if not found else ()
            if definition.key in found:
                own += Folding(definition, found[definition.key]).edits()
            for call, key in _calls(modules, definition):
                if key in found:
                    own += _without(definition.module, call, reached[key].parameters, found[key])
        changed = {module: Module(module.name, _edited(module, own)) for module, own in edits.items() if own}
        names = {module.name for module in changed}
        modules = ChainMap({name: _joined(modules[name], changed) for name in names}, modules)


def _joined(module: Module, changed: Mapping[Module, Module]) -> Module:
    """A module with its changed definitions, some of which may come from a text of their own."""
    found = changed.get(module) or Module(module.name, module.text)
    for name, definition in module.definitions.items():
        if definition.module is not module:
            found.definitions[name] = changed.get(definition.module, definition.module).definitions[name]
    return found


def _edited(module: Module, edits: Sequence[Edit]) -> str:
    """The text of a module; of edits one inside the other the outer counts."""
    out, place = [], 0
    for first, last, new in sorted(edits, key=lambda edit: (edit[0], -edit[1])):
        if first >= place:
            out += [module.bytes[place:first].decode(), new]
            place = last
    return "".join([*out, module.bytes[place:].decode()])


def _reach(modules: Modules, roots: Sequence[Key], shared: frozenset[Key]) -> dict[Key, Definition]:
    found: dict[Key, Definition] = {}
    pending = list(roots)
    while pending:
        definition = _definition(modules, pending.pop())
        if definition is not None and definition.key not in found:
            found[definition.key] = definition
            pending += [key for _, key in definition.references() if key not in shared]
    return found


def _definition(modules: Modules, key: Key) -> Definition | None:
    """What is behind a name, through the modules that only pass it on."""
    module, name = key
    try:
        found = modules[module].definitions.get(name)
    except KeyError:
        return None
    following = modules[module].imported.get(name)
    return found if found is not None or following is None else _definition(modules, following)


def _references(modules: Modules, definition: Definition) -> Iterator[tuple[ast.expr, Key]]:
    for node, key in definition.references():
        found = _definition(modules, key)
        if found is not None:
            yield node, found.key


def _calls(modules: Modules, definition: Definition) -> Iterator[tuple[ast.Call, Key]]:
    references = {id(node): key for node, key in _references(modules, definition)}
    for node in ast.walk(definition.node):
        if isinstance(node, ast.Call) and id(node.func) in references:
            yield node, references[id(node.func)]


def _fixed(said: Mapping[Key, Mapping[str, Sequence[str]]]) -> dict[Key, dict[str, str]]:
    """The parameters by function, each with the text of its value."""
    return {
        key: {p: texts[0] for p, texts in own.items() if texts and texts[0] and set(texts) == {texts[0]}}
        for key, own in said.items()
    }


def _said(
    modules: Modules, reached: Mapping[Key, Definition], roots: frozenset[Key]
) -> tuple[dict[Key, dict[str, list[str]]], dict[Key, set[str]]]:
    """By function and parameter with a default the texts of its values, and the parameters that some call leaves out.

    Not of a function that is also handed on.
    """
    defaults = {key: _defaults(d) for key, d in reached.items() if key not in roots}
    values: dict[Key, dict[str, list[str]]] = {key: {p: [] for p in own} for key, own in defaults.items()}
    left: dict[Key, set[str]] = {key: set() for key in defaults}
    for definition in reached.values():
        calls = {id(call.func): call for call, _ in _calls(modules, definition)}
        for node, key in _references(modules, definition):
            call = calls.get(id(node))
            known = call is not None and not any(isinstance(part, ast.Starred) for part in call.args)
            if call is None or not known or not all(keyword.arg for keyword in call.keywords):
                values.pop(key, None)
                continue
            given = arguments(call, reached[key].parameters) if key in values else {}
            for parameter in values.get(key, ()):
                value = given.get(parameter)
                if value is None:
                    left[key].add(parameter)
                text = defaults[key][parameter] if value is None else _text(definition, value)
                # a name means something in its own module alone
                foreign = isinstance(value, ast.Name) and definition.module.name != reached[key].module.name
                values[key][parameter].append("" if foreign else text)
    return values, left


def _without_default(definition: Definition, values: Mapping[str, Sequence[str]], left: set[str]) -> list[Edit]:
    """The edits that take the defaults which no call leaves to stand; those after one that stays have to stay."""
    function = definition.function
    assert function is not None
    edits: list[Edit] = []
    last = function.args.args[len(function.args.args) - len(function.args.defaults) :]
    for arg, value in zip(last, function.args.defaults, strict=True):
        if not values.get(arg.arg) or arg.arg in left:
            break
        edits.append((definition.module.span(arg)[1], definition.module.span(value)[1], ""))
    return edits


def _defaults(definition: Definition) -> dict[str, str]:
    """Parameters with a default that keep what is passed, and the text of the default."""
    function = definition.function
    if function is None or function.args.vararg or function.args.kwarg or function.args.kwonlyargs:
        return {}
    inner = [node.arg for node in ast.walk(function) if isinstance(node, ast.arg)]
    last = function.args.args[len(function.args.args) - len(function.args.defaults) :]
    return {
        arg.arg: _text(definition, value)
        for arg, value in zip(last, function.args.defaults, strict=True)
        if arg.arg not in definition.stored and inner.count(arg.arg) == 1
    }


def _text(definition: Definition, value: ast.expr) -> str:
    """A number, or a constant of the module, as it is written; empty for anything else."""
    part = value.operand if isinstance(value, ast.UnaryOp) else value
    if isinstance(part, ast.Constant) or ast.unparse(part) == "np.inf":
        return ast.unparse(value)
    if isinstance(value, ast.Name) and value.id not in definition.bound:
        own = definition.module.definitions.get(value.id)
        return value.id if own is not None and own.function is None else ""
    return ""


def _without(module: Module, call: ast.Call, parameters: Sequence[str], gone: Mapping[str, str]) -> list[Edit]:
    """The edits that leave these arguments out of a call."""
    parts: list[ast.expr | ast.keyword] = [*call.args, *call.keywords]
    names = [*parameters[: len(call.args)], *(keyword.arg for keyword in call.keywords)]
    return shortened([module.span(part) for part in parts], [name in gone for name in names])
