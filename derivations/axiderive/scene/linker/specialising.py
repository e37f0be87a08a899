"""Constants and common parameters worked into the text of functions.

The text of a function in which parameters have become constants: what they decide is decided.

Parameters for which all calls of a scene have one value go, with what that decides.

`def f(x, width=1.0)` whose calls never say another width becomes `def f(x)`, and in it `x / width` becomes `x`;
where every call says a width, it is `def f(x, width)`.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import textwrap
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping, MutableMapping, Sequence
from typing import Any

from .linking import Definition, Key, Module
from .source import Edit, arguments

WIDTH = 110
UNKNOWN = object()
RELATIONS: Mapping[type[ast.cmpop], Callable[[Any, Any], bool]] = {
    ast.Is: operator.is_, ast.IsNot: operator.is_not, ast.Eq: operator.eq, ast.NotEq: operator.ne,
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
}  # fmt: skip
RIGHT = {(ast.Mult, 1.0), (ast.Div, 1.0), (ast.Add, 0.0), (ast.Sub, 0.0)}
"""Operations that leave their left side as it is."""
LEFT = {(ast.Mult, 1.0), (ast.Add, 0.0)}
OPERATIONS = (ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Compare, ast.BoolOp)
ENDS = {"np.minimum": math.inf, "np.maximum": -math.inf}


def shortened(spans: Sequence[tuple[int, int]], gone: Sequence[bool]) -> list[Edit]:
    """The edits that take parts out of a list between commas."""
    kept, edits = False, list[Edit]()
    for i, (span, out) in enumerate(zip(spans, gone, strict=True)):
        if not out:
            kept = True
        elif kept:
            edits.append((spans[i - 1][1], span[1], ""))
        else:
            edits.append((span[0], spans[i + 1][0] if i + 1 < len(spans) else span[1], ""))
    return edits


class Folding:
    """A function without parameters that are `fixed` to the text of a constant."""

    def __init__(self, definition: Definition, fixed: Mapping[str, str]) -> None:
        assert definition.function is not None
        self.function, self.module, self.fixed = definition.function, definition.module, fixed
        self.parents = {id(child): node for node in ast.walk(self.function) for child in ast.iter_child_nodes(node)}

    def edits(self) -> list[Edit]:
        """All of them, also those inside others."""
        found = [*self._header(), *self._doc()]
        for node in ast.walk(self.function):
            if isinstance(node, ast.Name) and node.id in self.fixed:
                found += self._use(node)
        return found

    def _header(self) -> list[Edit]:
        args = self.function.args
        defaults = [None] * (len(args.args) - len(args.defaults)) + list(args.defaults)
        spans = [
            (self.module.span(arg)[0], self.module.span(arg if value is None else value)[1])
            for arg, value in zip(args.args, defaults, strict=True)
        ]
        return shortened(spans, [arg.arg in self.fixed for arg in args.args])

    def _doc(self) -> list[Edit]:
        """Sentences after the first that speak of a parameter go with it."""
        doc = ast.get_docstring(self.function)
        if doc is None or not any(f"`{name}`" in doc for name in self.fixed):
            return []
        first, *rest = (self._sentences(paragraph) for paragraph in doc.split("\n\n"))
        kept = [first[:1] + self._silent(first[1:]), *(self._silent(sentences) for sentences in rest)]
        text = "\n\n".join(textwrap.fill(" ".join(part), WIDTH) for part in kept if part)
        own = textwrap.indent(text, "    ").strip() + ("\n    " if "\n" in text else "")
        return [(*self.module.span(self.function.body[0]), f'"""{own}"""')]

    @staticmethod
    def _sentences(paragraph: str) -> list[str]:
        return re.split(r"(?<=\.)\s+(?=[A-Z`])", " ".join(paragraph.split()))

    def _silent(self, sentences: Sequence[str]) -> list[str]:
        return [text for text in sentences if not any(f"`{name}`" in text for name in self.fixed)]

    def _use(self, name: ast.Name) -> list[Edit]:
        """The largest expression around the name that it decides, and what becomes of the one around that."""
        node: ast.expr = name
        while isinstance(above := self.parents[id(node)], ast.expr) and self._value(above) is not UNKNOWN:
            node = above
        value = self._value(node)
        if isinstance(above, ast.If) and node is above.test and value is not UNKNOWN:
            return self._chain(above)
        if isinstance(above, ast.IfExp) and node is above.test and value is not UNKNOWN:
            return self._only(above, above.body if value else above.orelse)
        if isinstance(above, ast.BoolOp) and len(above.values) == 2:
            return self._only(above, next(part for part in above.values if part is not node))
        if isinstance(above, ast.BinOp) and self._neutral(above, node, value):
            return self._only(above, above.left if node is above.right else above.right)
        if isinstance(above, ast.Call) and ENDS.get(ast.unparse(above.func)) == value:
            return self._only(above, next(part for part in above.args if part is not node))
        return [(*self.module.span(node), self._written(node, value))]

    def _value(self, node: ast.expr) -> Any:
        """The value of an expression that the constants decide."""
        match node:
            case ast.Name(id=name) if name in self.fixed:
                return self._value(ast.parse(self.fixed[name], mode="eval").body)
            case ast.Constant(value=value):
                return value
            case ast.UnaryOp(op=ast.Not(), operand=part):
                return UNKNOWN if (value := self._value(part)) is UNKNOWN else not value
            case ast.UnaryOp(op=ast.USub(), operand=part):
                return UNKNOWN if (value := self._value(part)) is UNKNOWN else -value
            case ast.Compare(left=left, ops=[relation], comparators=[right]) if type(relation) in RELATIONS:
                values = self._value(left), self._value(right)
                return UNKNOWN if UNKNOWN in values else RELATIONS[type(relation)](*values)
            case ast.BoolOp(op=connective, values=parts):
                decides = isinstance(connective, ast.Or)
                values = tuple(self._value(part) for part in parts)
                if any(value is not UNKNOWN and bool(value) == decides for value in values):
                    return decides
                return UNKNOWN if UNKNOWN in values else not decides
            case ast.Call(args=[part]) if ast.unparse(node.func) == "np.log":
                return math.inf if self._value(part) == math.inf else UNKNOWN
        return math.inf if ast.unparse(node) == "np.inf" else UNKNOWN

    @staticmethod
    def _neutral(above: ast.BinOp, node: ast.expr, value: Any) -> bool:
        """Whether an operation with it changes nothing but the sign of a zero."""
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            return False
        return (type(above.op), float(value)) in (RIGHT if node is above.right else LEFT)

    def _written(self, node: ast.expr, value: Any) -> str:
        if isinstance(node, ast.Name):
            return self.fixed[node.id]
        return "np.inf" if value == math.inf else repr(value)

    def _only(self, whole: ast.expr, part: ast.expr) -> list[Edit]:
        """An expression of which one part is left, in brackets where it stands in another operation."""
        (start, end), (first, last) = self.module.span(whole), self.module.span(part)
        compound = isinstance(part, OPERATIONS) and isinstance(self.parents[id(whole)], OPERATIONS)
        compound = compound and self.module.bytes[start - 1 : start] != b"("
        return [(start, first, "(" if compound else ""), (last, end, ")" if compound else "")]

    def _chain(self, statement: ast.If) -> list[Edit]:
        """The edits that leave of a chain of conditions what is not decided, and of decided parts the one that holds.

        What follows a return that is left alone goes too.
        """
        while self._is_elif(statement):
            above = self.parents[id(statement)]
            assert isinstance(above, ast.If)
            statement = above
        starts, place, edits = self.module.starts, statement.lineno - 1, list[Edit]()
        indent, end = " " * statement.col_offset, statement.end_lineno or statement.lineno
        first = True
        for test, body, word in self._parts(statement):
            holds = True if test is None else self._value(test)
            begin, stop = self._commented(body[0].lineno - 1), body[-1].end_lineno or place
            if holds is not UNKNOWN and not holds:
                more = not first or stop < end
                edits.append((starts[place if more else self._commented(place)], starts[stop], ""))
            elif holds is UNKNOWN:
                if first and word:
                    edits.append((starts[place], word + len("elif"), f"{indent}if"))
                first = False
            else:
                if first:
                    edits += [(starts[line], starts[line] + 4, "") for line in range(begin, stop)]
                    leaves = isinstance(body[-1], (ast.Return, ast.Break, ast.Continue, ast.Raise))
                    end = self._last_beside(statement) if leaves else end
                if first or test is not None:
                    edits.append((starts[place], starts[begin], "" if first else f"{indent}else:\n"))
                return [*edits, (starts[stop], starts[end], "")]
            place = stop
        return edits

    def _parts(self, statement: ast.If) -> Iterator[tuple[ast.expr | None, list[ast.stmt], int]]:
        """Test, body and place of the word `elif` of each part of a chain; no test for its `else`."""
        word = 0
        while True:
            yield statement.test, statement.body, word
            rest = statement.orelse
            if not rest or not self._is_elif(rest[0]):
                break
            statement = rest[0]  # type: ignore[assignment]
            word = self.module.span(statement)[0]
        if rest:
            yield None, rest, 0

    def _commented(self, line: int) -> int:
        """The first of the lines of comment in front of a line."""
        while self.module.lines[line - 1].strip().startswith("#"):
            line -= 1
        return line

    def _is_elif(self, statement: ast.stmt) -> bool:
        """Whether a statement begins with this word; its tree is that of an `if` within the `else`."""
        return isinstance(statement, ast.If) and self.module.bytes[self.module.span(statement)[0] :].startswith(b"elif")

    def _last_beside(self, statement: ast.stmt) -> int:
        above = self.parents[id(statement)]
        for name in ("body", "orelse"):
            beside = getattr(above, name, [])
            if statement in beside:
                return int(beside[-1].end_lineno)
        return int(statement.end_lineno or statement.lineno)


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
        changed = {module: Module(module.name, module.edited(own)) for module, own in edits.items() if own}
        names = {module.name for module in changed}
        modules = ChainMap({name: _joined(modules[name], changed) for name in names}, modules)


def _joined(module: Module, changed: Mapping[Module, Module]) -> Module:
    """A module with its changed definitions, some of which may come from a text of their own."""
    found = changed.get(module) or Module(module.name, module.text)
    for name, definition in module.definitions.items():
        if definition.module is not module:
            found.definitions[name] = changed.get(definition.module, definition.module).definitions[name]
    return found


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
