"""Programs over single numbers as JavaScript: the same statements, with the names of the package's own functions.

What is infinite or no number in Python as an error is so here as a value, as over arrays.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TypeVar

from .public import FORMULAS, PROGRAMS
from .reach import KEPT, PLAIN, PRODUCTS, Module, Name, NoProgramError, Package
from .searches import OWN, RADII, RELAXATION, SAMPLES, radii, springs

Part = TypeVar("Part")
HELPERS = Path(__file__).with_name("numbers.js")
"""What the language lacks: functions of Python's `math`, of NumPy for single numbers, and rules of integration."""
OF_MATH = {
    **{name: f"Math.{name}" for name in ("sqrt", "exp", "expm1", "log", "log1p", "sin", "cos", "tan", "atan", "atan2")},
    **{name: f"Math.{name}" for name in ("asinh", "atanh", "sinh", "cosh", "tanh", "cbrt", "floor", "ceil")},
    **{name: f"Math.{name}" for name in ("acos", "asin", "acosh", "abs")},
    **{"pow": "Math.pow", "inf": "Infinity", "nan": "NaN", "pi": "Math.PI", "e": "Math.E"},
    **{"isfinite": "Number.isFinite", "isnan": "Number.isNaN"},
    **{name: f"math.{name}" for name in ("fsum", "gamma", "lgamma", "ldexp", "frexp", "nextafter", "prod", "copysign")},
    "hypot": "math.hypot",
}
"""Names of Python's `math` here."""
OF_NUMPY = OF_MATH | {
    **{"arctan": "Math.atan", "arctan2": "Math.atan2", "arctanh": "Math.atanh", "arcsinh": "Math.asinh"},
    **{"any": "Boolean", "all": "Boolean", "count_nonzero": "Boolean", "power": "Math.pow", "max": "math.maximum"},
    **{name: f"math.{name}" for name in ("minimum", "maximum", "where", "logical_not", "clip", "exp2")},
    **{
        name: f"math.{name}" for name in ("asarray", "vectorize", "float64", "ones_like", "zeros_like", "zeros", "ndim")
    },
    **{"full_like": "math.full", "full": "math.full"},
}
"""Names of NumPy in a program over single numbers."""
OF_PYTHON = {
    **{"abs": "Math.abs", "min": "Math.min", "max": "Math.max", "float": "Number", "int": "Math.trunc"},
    **{"bool": "Boolean"},
    **{"len": "math.length", "list": "Array.from", "tuple": "Array.from", "sum": "math.sum"},
    **{name: f"math.{name}" for name in ("all", "zip", "enumerate", "range", "reversed")},
    **{"True": "true", "False": "false", "None": "null"},
}
"""Names of Python itself."""
RULED = re.compile(r"math\.(rule|in_groups|integral|products)")
"""What needs the nodes of the rules."""
WORDS = frozenset(("default", "function", "var", "const", "new", "this", "delete", "switch", "case", "void", "enum"))
"""Names that mean something else here."""
SIGNS = {
    ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Mod: "%", ast.BitAnd: "&", ast.BitOr: "|",
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "===", ast.NotEq: "!==", ast.Is: "==",
    ast.IsNot: "!=", ast.And: "&&", ast.Or: "||", ast.USub: "-", ast.UAdd: "+", ast.Not: "!",
}  # fmt: skip


class Script:
    """The functions of one file, and all that they need."""

    def __init__(self, package: Package) -> None:
        self.package = package
        self.names: dict[Name, str] = {}
        self.texts: dict[Name, str] = {}

    def add(self, module: str, function: str) -> str:
        """Take a public function along; the name it goes by.

        Raises
        ------
        NoProgramError
            If it, or something it calls, is evaluated over arrays only.
        """
        home, program = self.package.program(module, function)
        known = dict(self.texts)
        try:
            return self._take((home.name, function), home, program)
        except NoProgramError:
            self.texts = known
            raise

    def text(self) -> str:
        """The whole file; what is needed stands in front of what needs it."""
        nodes = self.package.module("_runtime.nodes")
        assert nodes is not None
        halves = Printer(self, nodes).bound("HALVES", nodes.bound["_LOWER_HALVES"])
        ruled = [halves] if RULED.search("".join(self.texts.values())) else []
        return "\n".join([HELPERS.read_text(), *ruled, *self.texts.values()])

    def _take(self, key: Name, module: Module, node: ast.stmt) -> str:
        if key not in self.names:
            self.names[key] = self._free(key)
        if key not in self.texts:
            self.texts[key] = ""
            try:
                text = Printer(self, module).bound(self.names[key], node)
            except NoProgramError:
                del self.texts[key]
                raise
            del self.texts[key]
            self.texts[key] = text
        return self.names[key]

    def _free(self, key: Name) -> str:
        plain = _word(key[1])
        taken = {*self.names.values(), *_reserved()}
        where = key[0].rpartition(".")[2]
        tried = [plain, f"{plain}_of_{where}", *(f"{plain}_{count}" for count in range(2, 100))]
        return next(name for name in tried if name not in taken)

    def named(self, module: Module, name: str, attribute: str = "") -> str:
        """What a name of a module, or an attribute of it, is called here; what it is bound to is taken along."""
        found = self.package.resolved(module.name, name)
        if name.startswith((PROGRAMS, FORMULAS)):
            of_it, node = self.package.formula(name, attribute)
            return self._take((of_it.name, node.name), of_it, node)
        if found is None:
            if name not in OF_PYTHON or attribute:
                raise _missing(module, name)
            return OF_PYTHON[name]
        home, own = found
        if attribute:
            if (home, own) in ((PLAIN, "MATH"), ("numpy", "")):
                return _known(OF_NUMPY, attribute, module)
            if own == "" and self.package.module(home):
                return self.named(self.package.read[home], attribute)
            if home == "math":
                return _known(OF_MATH, attribute, module)
            raise _missing(module, f"{name}.{attribute}")
        if home == "math":
            return _known(OF_MATH, own, module)
        if found == ("functools", "reduce"):
            return "math.reduce"
        there = self.package.module(home)
        if there is None:
            raise _missing(module, name)
        if found == PRODUCTS:
            return "math.products"
        if home == PLAIN and own in _helpers():
            return f"math.{own}"
        if (home, own) in OWN:
            return self._own(there, own)
        return self._take(found, there, self.package.bound(there, own))

    def _own(self, module: Module, name: str) -> str:
        """What goes over arrays in Python: a function of the helpers, over a table of the module."""
        if name in RADII:
            values = f"[{', '.join(map(repr, radii(module.text, name)))}]"
            text = f"(length = 1.0) => {values}.map((x) => x * length)"
        elif name == "springs":
            relaxation = self.package.module(RELAXATION)
            assert relaxation is not None
            pairs, under = springs(relaxation.text)
            values = ", ".join(f"[{x!r}, {weight!r}]" for x, weight in pairs)
            text = f"math.springs([{values}], {under!r})"
        elif name == "branches":
            text = f"math.branches({self.named(module, '_change')}, {self.named(module, 'FAR')})"
        else:
            return f"math.{name}"
        key = (module.name, name)
        if key not in self.texts:
            self.names[key] = self._free(key)
            self.texts[key] = f"const {self.names[key]} = {text};\n"
        return self.names[key]

    def signature(self, module: Module, function: ast.expr) -> ast.arguments | None:
        """The arguments of a function that a call names; None where it is a value."""
        name, attribute = function, ""
        if isinstance(function, ast.Attribute):
            name, attribute = function.value, function.attr
        if not isinstance(name, ast.Name):
            return None
        if name.id.startswith((PROGRAMS, FORMULAS)):
            return self.package.formula(name.id, attribute)[1].args
        found = self.package.resolved(module.name, name.id)
        if found and attribute and found[1] == "":
            found = self.package.resolved(found[0], attribute)
        home = self.package.module(found[0]) if found else None
        node = home.bound.get(found[1]) if found and home else None
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Name) and home:
            node = home.bound.get(node.value.id)
        if isinstance(node, ast.FunctionDef):
            grouped = any(ast.unparse(one) == "in_groups" for one in node.decorator_list)
            return ast.arguments([], [], ast.arg("given"), [], [], None, []) if grouped else node.args
        if isinstance(node, ast.ClassDef):
            fields = _fields(node)
            values = [value for value in fields.values() if value]
            return ast.arguments([], [ast.arg(name) for name in fields], None, [], [], None, values)
        return None


class Printer:
    """Prints what one module binds."""

    def __init__(self, script: Script, module: Module) -> None:
        self.script, self.module = script, module
        self.local: list[dict[str, ast.arguments | None]] = []

    def bound(self, name: str, node: ast.stmt) -> str:
        """A function, a class of named fields or a constant of the module under a name."""
        if isinstance(node, ast.FunctionDef):
            text = self._function(node)
            for decorator in map(ast.unparse, node.decorator_list):
                if decorator in _helpers():
                    text = f"math.{decorator}({text})"
                elif decorator in KEPT:
                    text = f"math.kept({text})"
                elif decorator.partition("(")[0] not in ("at_many_radii", "over_radii"):
                    raise _missing(self.module, decorator)
            return f"const {name} = {text};\n"
        if isinstance(node, ast.ClassDef):
            fields = _fields(node)
            given = [own + (f" = {self.expr(value)}" if value else "") for own, value in fields.items()]
            return f"const {name} = ({', '.join(given)}) => math.record({{ {', '.join(fields)} }});\n"
        assert isinstance(node, ast.Assign | ast.AnnAssign) and node.value
        return f"const {name} = {self.expr(node.value)};\n"

    def _function(self, node: ast.FunctionDef) -> str:
        own = dict.fromkeys(_arguments(node.args))
        inner = {one.name: one.args for one in _own(node, ast.FunctionDef)}
        each = {id(one) for loop in _own(node, ast.comprehension) for one in ast.walk(loop.target)}
        names = (one for one in _own(node, ast.Name) if isinstance(one.ctx, ast.Store) and id(one) not in each)
        stored = {one.id for one in names}
        self.local.append({**own, **dict.fromkeys(stored), **inner})
        declared = sorted({*stored, *inner} - own.keys())
        lines = [f"let {', '.join(map(_word, declared))};"] if declared else []
        lines += [line for statement in node.body for line in self.statement(statement)]
        text = "\n".join(f"  {line}" for line in lines)
        given = self._given(node.args)
        self.local.pop()
        return f"({given}) => {{\n{text}\n}}"

    def _given(self, arguments: ast.arguments) -> str:
        if arguments.vararg and arguments.kwonlyargs:
            raise _missing(self.module, "arguments behind any number")
        plain = [*arguments.posonlyargs, *arguments.args]
        values = [*[None] * (len(plain) - len(arguments.defaults)), *arguments.defaults, *arguments.kw_defaults]
        found = []
        for argument, value in zip([*plain, *arguments.kwonlyargs], values, strict=True):
            found.append(_word(argument.arg) + ("" if value is None else f" = {self.expr(value)}"))
        return ", ".join([*found, *([f"...{arguments.vararg.arg}"] if arguments.vararg else [])])

    def statement(self, node: ast.stmt) -> list[str]:
        """The lines of a statement."""
        match node:
            case ast.Expr(ast.Constant()):
                return []
            case ast.Expr(value):
                return [f"{self.expr(value)};"]
            case ast.Return(value):
                return [f"return {self.expr(value)};" if value else "return;"]
            case ast.Assign([target], value):
                text = f"{self.target(target)} = {self.expr(value)};"
                return [f"({text[:-1]});" if text.startswith("{") else text]
            case ast.Assign(targets, value):
                return [f"{' = '.join(map(self.target, targets))} = {self.expr(value)};"]
            case ast.AnnAssign(target, _, ast.expr() as value):
                return [f"{self.target(target)} = {self.expr(value)};"]
            case ast.AugAssign(target, ast.Add(), ast.List() | ast.ListComp() as value):
                return [f"{self.expr(target)}.push(...{self.expr(value)});"]
            case ast.AugAssign(target, operator, value):
                return [f"{self.expr(target)} {SIGNS[type(operator)]}= {self.expr(value)};"]
            case ast.If(test, body, orelse):
                return [
                    f"if ({self.expr(test)}) {{",
                    *self._block(body),
                    *(["} else {", *self._block(orelse)] if orelse else []),
                    "}",
                ]
            case ast.For(target, iterated, body):
                return [f"for ({self.target(target)} of {self.expr(iterated)}) {{", *self._block(body), "}"]
            case ast.While(test, body):
                return [f"while ({self.expr(test)}) {{", *self._block(body), "}"]
            case ast.FunctionDef():
                return [*f"{_word(node.name)} = {self._function(node)};".split("\n")]
            case ast.Break():
                return ["break;"]
            case ast.Continue():
                return ["continue;"]
            case ast.Pass() | ast.ImportFrom():
                return []
            case ast.Raise():
                return ["return NaN;"]
            case ast.Try(body, [handler]):
                known = dict(self.script.texts)
                try:
                    return [line for own in body for line in self.statement(own)]
                except NoProgramError:
                    self.script.texts = known
                    return [line for own in handler.body for line in self.statement(own)]
        raise _missing(self.module, ast.unparse(node))

    def _block(self, body: Iterable[ast.stmt]) -> list[str]:
        return [f"  {line}" for statement in body for line in self.statement(statement)]

    def target(self, node: ast.expr) -> str:
        """What is assigned to."""
        if isinstance(node, ast.Tuple | ast.List):
            return f"[{', '.join(map(self.target, node.elts))}]"
        if isinstance(node, ast.Starred):
            return f"...{self.target(node.value)}"
        return _word(node.id) if isinstance(node, ast.Name) else self.expr(node)

    def expr(self, node: ast.expr) -> str:
        """An expression, in parentheses wherever a sign stands."""
        match node:
            case ast.Constant(value):
                return _constant(value, self.module)
            case ast.Name(name):
                return _word(name) if any(name in own for own in self.local) else self.script.named(self.module, name)
            case ast.Attribute(ast.Name(name), attribute) if not any(name in own for own in self.local):
                return self.script.named(self.module, name, attribute)
            case ast.Attribute(value, attribute):
                return f"{self.expr(value)}.{attribute}"
            case ast.BinOp(ast.Tuple() as repeated, ast.Mult(), count):
                return f"math.repeated({self.expr(repeated)}, {self.expr(count)})"
            case ast.BinOp(left, ast.Add(), ast.Tuple() | ast.List() | ast.ListComp() as right):
                return f"[...{self.expr(left)}, ...{self.expr(right)}]"
            case ast.BinOp(left, ast.Pow(), ast.Constant(int(exponent))) if exponent > 2:
                return f"math.raised({self.expr(left)}, {exponent})"
            case ast.BinOp(left, ast.Pow(), right):
                return f"Math.pow({self.expr(left)}, {self.expr(right)})"
            case ast.BinOp(left, ast.FloorDiv(), right):
                return f"Math.floor({self.expr(left)} / {self.expr(right)})"
            case ast.BinOp(left, operator, right):
                return f"({self.expr(left)} {SIGNS[type(operator)]} {self.expr(right)})"
            case ast.UnaryOp(operator, operand):
                return f"({SIGNS[type(operator)]}{self.expr(operand)})"
            case ast.BoolOp(operator, values):
                return f"({f' {SIGNS[type(operator)]} '.join(map(self.expr, values))})"
            case ast.Compare(ast.Call(ast.Name("type")), [ast.Is()], _):
                return "true"
            case ast.Compare(left, operators, others):
                terms = [left, *others]
                compared = zip(terms[:-1], operators, terms[1:], strict=True)
                found = [f"{self.expr(a)} {SIGNS[type(o)]} {self.expr(b)}" for a, o, b in compared]
                return f"({' && '.join(found)})"
            case ast.IfExp(ast.Compare(ast.Call(ast.Name("type")), [ast.Is()], _), body, _):
                return self.expr(body)
            case ast.IfExp(ast.Name() as test, body, orelse):
                # a list without members is false in Python alone
                return f"(math.truth({self.expr(test)}) ? {self.expr(body)} : {self.expr(orelse)})"
            case ast.IfExp(test, body, orelse):
                return f"({self.expr(test)} ? {self.expr(body)} : {self.expr(orelse)})"
            case ast.Tuple(values) | ast.List(values):
                return f"[{', '.join(map(self.expr, values))}]"
            case ast.Starred(value):
                return f"...{self.expr(value)}"
            case ast.Lambda(arguments, body):
                self.local.append(dict.fromkeys(_arguments(arguments)))
                text = f"(({self._given(arguments)}) => {self.expr(body)})"
                self.local.pop()
                return text
            case ast.ListComp(element, [loop]) | ast.GeneratorExp(element, [loop]):
                return self._each(element, loop)
            case ast.Subscript(value, ast.Slice(None, None, ast.UnaryOp(ast.USub(), ast.Constant(1)))):
                return f"math.reversed({self.expr(value)})"
            case ast.Subscript(
                value, ast.Slice(ast.UnaryOp(ast.USub(), low), None, ast.UnaryOp(ast.USub(), ast.Constant(1)))
            ):
                return f"math.reversed({self.expr(value)}).slice({self.expr(low)} - 1)"
            case ast.Subscript(value, ast.Slice(low, high, None)):
                ends = ", ".join("0" if own is None else self.expr(own) for own in (low, *([high] if high else [])))
                return f"{self.expr(value)}.slice({ends})"
            case ast.Subscript(value, ast.UnaryOp(ast.USub(), place)):
                return f"{self.expr(value)}.at(-{self.expr(place)})"
            case ast.Subscript(value, place):
                return f"{self.expr(value)}[{self.expr(place)}]"
            case ast.Dict(keys, values):
                pairs = (f"{self.expr(k)}: {self.expr(v)}" for k, v in zip(keys, values, strict=True) if k)
                return f"{{{', '.join(pairs)}}}"
            case ast.Call():
                return self._call(node)
        raise _missing(self.module, ast.unparse(node))

    def _each(self, element: ast.expr, loop: ast.comprehension) -> str:
        names = [one.id for one in ast.walk(loop.target) if isinstance(one, ast.Name)]
        iterated = self.expr(loop.iter)
        self.local.append(dict.fromkeys(names))
        kept = "".join(f".filter(({self.target(loop.target)}) => {self.expr(test)})" for test in loop.ifs)
        text = f"[...{iterated}]{kept}.map(({self.target(loop.target)}) => {self.expr(element)})"
        self.local.pop()
        return text

    def _call(self, node: ast.Call) -> str:
        function = node.func
        if isinstance(function, ast.Name) and function.id == "hasattr":
            return "false"
        if isinstance(function, ast.Name) and function.id == "isinstance":
            return f'(typeof {self.expr(node.args[0])} === "number")'
        if isinstance(function, ast.Subscript) and ast.unparse(function.value) == "list":
            return "[]"
        if isinstance(function, ast.Name) and function.id == "getattr":
            return f"{self.expr(node.args[0])}[{self.expr(node.args[1])}]"
        if isinstance(function, ast.Name) and function.id == "partial":
            return self._partial(node)
        if isinstance(function, ast.Name) and function.id == SAMPLES:
            return f"({{ radii: {self.expr(node.args[0])}, end: {self.expr(node.args[2])} }})"
        if isinstance(function, ast.Attribute) and function.attr == "_replace":
            changes = ", ".join(f"{own.arg}: {self.expr(own.value)}" for own in node.keywords)
            return f"math.replaced({self.expr(function.value)}, {{ {changes} }})"
        if isinstance(function, ast.Attribute) and function.attr == "item":
            return self.expr(function.value)
        if isinstance(function, ast.Attribute) and function.attr == "append":
            return f"{self.expr(function.value)}.push({', '.join(map(self.expr, node.args))})"
        given = list(map(self.expr, node.args))
        if node.keywords:
            given = self._ordered(node, given)
        return f"{self.expr(function)}({', '.join(given)})"

    def _partial(self, node: ast.Call) -> str:
        """A function of what is left of the arguments of another."""
        (function,) = node.args
        signature = self.script.signature(self.module, function)
        if signature is None:
            raise _missing(self.module, ast.unparse(node))
        held = {str(keyword.arg): self.expr(keyword.value) for keyword in node.keywords}
        names = _arguments(signature)
        left = [_word(name) for name in names if name not in held]
        given = ", ".join(held.get(name, _word(name)) for name in names)
        return f"(({', '.join(left)}) => {self.expr(function)}({given}))"

    def _ordered(self, node: ast.Call, given: list[str]) -> list[str]:
        """Arguments by name at their places."""
        inner = next(
            (
                own[node.func.id]
                for own in reversed(self.local)
                if isinstance(node.func, ast.Name) and node.func.id in own
            ),
            None,
        )
        signature = inner or self.script.signature(self.module, node.func)
        named = {str(keyword.arg): self.expr(keyword.value) for keyword in node.keywords}
        if signature is None:
            if named.keys() <= {"dtype", "otypes", "initial", "strict"}:
                return given
            raise _missing(self.module, ast.unparse(node))
        if signature.vararg:
            return [*given, f"{{ {', '.join(f'{name}: {value}' for name, value in named.items())} }}"]
        names = [own.arg for own in (*signature.posonlyargs, *signature.args, *signature.kwonlyargs)]
        for name in names[len(given) :]:
            given.append(named.pop(name, "undefined"))
        if named:
            raise _missing(self.module, ast.unparse(node))
        while given and given[-1] == "undefined":
            given.pop()
        return given


def _own(node: ast.FunctionDef, kind: type[Part]) -> list[Part]:
    """The parts of a kind in a function that are in no function inside it."""
    found, pending = list[Part](), list[ast.AST](node.body)
    while pending:
        part = pending.pop()
        if isinstance(part, kind):
            found.append(part)
        if not isinstance(part, ast.FunctionDef | ast.Lambda):
            pending += ast.iter_child_nodes(part)
    return found


def _fields(node: ast.ClassDef) -> dict[str, ast.expr | None]:
    """The names of a named tuple, with the values they begin with."""
    found = (own for own in node.body if isinstance(own, ast.AnnAssign))
    return {own.target.id: own.value for own in found if isinstance(own.target, ast.Name)}


def _arguments(arguments: ast.arguments) -> list[str]:
    found = [own.arg for own in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]
    return [*found, *([arguments.vararg.arg] if arguments.vararg else [])]


def _word(name: str) -> str:
    return f"{name}_" if name in WORDS else name


def _known(names: dict[str, str], name: str, module: Module) -> str:
    if name not in names:
        raise _missing(module, name)
    return names[name]


def _missing(module: Module, what: str) -> NoProgramError:
    return NoProgramError(f"{module.name} uses {what}, which has no counterpart over single numbers in JavaScript")


def _constant(value: object, module: Module) -> str:
    if value is None or isinstance(value, bool):
        return OF_PYTHON[str(value)]
    if isinstance(value, int | float):
        return {"inf": "Infinity", "nan": "NaN"}.get(repr(value), repr(value))
    if isinstance(value, str):
        return repr(value)
    raise _missing(module, repr(value))


@cache
def _reserved() -> frozenset[str]:
    """The names that a file has besides."""
    return frozenset(
        ("HALVES", "functions", "formulas", "once", *re.findall(r"^const (\w+)", HELPERS.read_text(), re.MULTILINE))
    )


@cache
def _helpers() -> frozenset[str]:
    """The names that the helpers bind."""
    return frozenset(re.findall(r"^  (\w+): ", HELPERS.read_text(), re.MULTILINE))
