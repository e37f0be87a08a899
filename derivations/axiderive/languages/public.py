"""Public functions as other languages have them: what is outside a domain is no number, where Python has an error.

A public function checks its parameters and hands the formula to `elementwise`, which evaluates the program for plain
numbers where they are ordinary and the body of the formula elsewhere: at the ends of domains, on the axis.  Here it
says both itself.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Mapping, Sequence

Domain = tuple[float, float, str]
"""The ends of an interval, and which of them belongs to it."""
Resolved = Callable[[str, str], tuple[str, str] | None]
"""Where a name of a module is bound."""
FIELDS = ("elementwise", "even", "odd")
POSITIONS = ("r", "x")
"""First arguments of fields, which vanish at infinity, but for those of the body itself, its profile."""
UNASKED = ("require_coefficients", "require_control")
"""Checks of what is known when a file is written."""
PROGRAMS, FORMULAS = "programs:", "formulas:"
"""What stands before the module of a formula: with the program for plain numbers, and its body alone."""
NOTHING = ast.Return(ast.Constant(math.nan))


class Public(ast.NodeTransformer):
    """Rewrites public functions of a module."""

    def __init__(
        self,
        module: str,
        resolved: Resolved,
        functions: Callable[[str, str], ast.stmt | None],
        domains: Mapping[str, Domain],
    ) -> None:
        self.module, self.resolved, self.functions, self.domains = module, resolved, functions, domains

    def function(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """The function without what asks its program first: `elementwise` does."""
        body = [own for statement in node.body if not _asks(statement) for own in self._statement(statement)]
        return ast.FunctionDef(node.name, node.args, body, [], None, None)

    def _statement(self, node: ast.stmt) -> list[ast.stmt]:
        if isinstance(node, ast.Expr | ast.Assign) and isinstance(node.value, ast.Call) and _checks(node):
            tests = self._tests(node.value, self.module)
            return [ast.If(ast.UnaryOp(ast.Not(), _all(tests)), [NOTHING], [])] if tests else []
        return [self.visit(node)]

    def _tests(self, call: ast.Call, module: str) -> list[ast.expr]:
        """What has to hold where a check of a module passes."""
        match _called(call):
            case name if name in UNASKED:
                return []
            case "require":
                return [self._inside(str(one.arg), self.visit(one.value)) for one in call.keywords]
            case "require_order":
                # its names are those of the module that checks
                return [Public(module, self.resolved, self.functions, self.domains).visit(call.args[0])]
            case "require_reach":
                return [ast.Compare(call.args[0], [ast.GtE()], [call.args[1]])]
            case "require_hold":
                return [ast.Compare(call.args[0], [ast.LtE()], [call.args[1]])]
            case "require_eccentricity":
                a, e = call.args
                return [ast.Compare(ast.Call(ast.Name("abs", ast.Load()), [e], []), [ast.Lt()], [a])]
        # a check of the module, whose arguments go by their own names
        home, name = self._home(call.func, module)
        node = self.functions(home, name)
        assert isinstance(node, ast.FunctionDef)
        own = {one.arg for one in (*node.args.args, *node.args.kwonlyargs)}
        more = [one for one in call.keywords if one.arg not in own]
        found: list[ast.expr] = []
        for inner in [one.value for one in node.body if isinstance(one, ast.Expr) and isinstance(one.value, ast.Call)]:
            named = [given for one in inner.keywords for given in ([one] if one.arg else more)]
            found += self._tests(ast.Call(inner.func, inner.args, named), home)
        return found

    def _inside(self, name: str, value: ast.expr) -> ast.expr:
        low, high, closed = self.domains[name]
        signs: list[ast.cmpop] = [ast.LtE() if closed == end else ast.Lt() for end in ("low", "high")]
        return ast.Compare(ast.Constant(low), signs, [value, ast.Constant(high)])

    def _home(self, node: ast.expr, module: str) -> tuple[str, str]:
        """The module of a function, and its name there."""
        whole = node.value if isinstance(node, ast.Attribute) else node
        assert isinstance(whole, ast.Name)
        found = self.resolved(module, whole.id)
        assert found is not None
        return (found[0], node.attr) if isinstance(node, ast.Attribute) else found

    def visit_Call(self, node: ast.Call) -> ast.expr:
        """The formula where its fields are numbers of its range; of what checks kinds, the number."""
        name = _called(node)
        if name == "numbers":
            return node.args[1]
        if name == "all" and ast.unparse(node.func) == "np.all":
            return self.visit(node.args[0])
        self.generic_visit(node)
        return self._evaluated(name, node) if name in FIELDS else node

    def visit_UnaryOp(self, node: ast.UnaryOp) -> ast.expr:
        """Of arrays of truths the inverse is no negation."""
        self.generic_visit(node)
        return ast.UnaryOp(ast.Not(), node.operand) if isinstance(node.op, ast.Invert) else node

    def _evaluated(self, kind: str, node: ast.Call) -> ast.expr:
        formula, *fields = node.args
        named = [one for one in node.keywords if one.arg != "unused"]
        if isinstance(formula, ast.Call):
            named = [*formula.keywords, *named]
            formula = formula.args[0]
        home, name = self._home(formula, self.module)
        first = fields[0] if fields else None
        if kind != "elementwise" and first is not None:
            fields[0] = ast.Call(ast.Name("abs", ast.Load()), [first], [])
        value: ast.expr = ast.Call(_named(PROGRAMS + home, name), fields, named)
        body = self.functions(home, name)
        assert isinstance(body, ast.FunctionDef)
        if fields and body.args.args[0].arg in POSITIONS and "profile" not in name:
            value = ast.IfExp(ast.Compare(fields[0], [ast.Lt()], [ast.Constant(math.inf)]), value, ast.Constant(0.0))
        if fields:
            held = _all([ast.Compare(one, [ast.GtE()], [ast.Constant(0.0)]) for one in fields])
            value = ast.IfExp(held, value, ast.Constant(math.nan))
        if kind == "odd" and first is not None:
            negative = ast.Compare(first, [ast.Lt()], [ast.Constant(0.0)])
            sign = ast.IfExp(negative, ast.Constant(-1.0), ast.Constant(1.0))
            # no negative zeros
            value = ast.BinOp(ast.BinOp(value, ast.Mult(), sign), ast.Add(), ast.Constant(0.0))
        return value


def _called(node: ast.expr) -> str:
    """The last name of a function that is called."""
    if not isinstance(node, ast.Call):
        return ""
    return node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")


def _checks(node: ast.Expr | ast.Assign) -> bool:
    """Whether a call is a check, which may give what it has checked."""
    return isinstance(node, ast.Expr) or _called(node.value).startswith("require_")


def _asks(node: ast.stmt) -> bool:
    """Whether a statement asks the program of the function first, or returns what it said; or is its docstring."""
    text = ast.unparse(node)
    docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return docstring or text.startswith(("value = plain.", "if value is not None:"))


def _all(tests: Sequence[ast.expr]) -> ast.expr:
    return tests[0] if len(tests) == 1 else ast.BoolOp(ast.And(), list(tests))


def evaluated(program: ast.FunctionDef, body: ast.FunctionDef, home: str) -> ast.FunctionDef | None:
    """The program of a formula where the arguments are ordinary, its body elsewhere; None where both are the same.

    Where the body has no counterpart there is no number.
    """
    given: list[ast.expr] = [ast.Name(own.arg, ast.Load()) for own in body.args.args]
    call = ast.Call(_named(FORMULAS + home, body.name), given, [])
    handler = ast.ExceptHandler(None, None, [NOTHING])
    otherwise = ast.Try([ast.Return(call)], [handler], [], [])
    (guard,) = (node for node in program.body if isinstance(node, ast.If))
    (tried,) = (node for node in guard.body if isinstance(node, ast.Try))
    tests = _Ranges().visit(guard.test).values
    flat = _unasked(tried.body)
    called = ast.unparse(ast.Return(ast.Call(_named("bodies", body.name), given, [])))
    if _text(flat) in (called, _text(body.body)):
        return None
    # what a program leaves to the arrays is left to its body
    flat = [_Otherwise(otherwise).visit(statement) for statement in flat]
    return ast.FunctionDef(body.name, program.args, [ast.If(_all(tests), flat, []), otherwise], [], None, None)


def _unasked(body: list[ast.stmt]) -> list[ast.stmt]:
    """Statements that return a value at once, where they ask whether it is in its range."""
    found: list[ast.stmt] = []
    for statement in body:
        match statement:
            case ast.If(_, [ast.Return(ast.Name("value"))], []):
                (*found, last) = found
                assert isinstance(last, ast.Assign)
                return [*found, ast.Return(last.value)]
            case ast.If(test, inner, other):
                found.append(ast.If(test, _unasked(inner), _unasked(other)))
            case _:
                found.append(statement)
    return found


def _named(module: str, name: str) -> ast.expr:
    return ast.Attribute(ast.Name(module, ast.Load()), name, ast.Load())


def _text(body: Sequence[ast.stmt]) -> str:
    return "\n".join(ast.unparse(one) for one in body if not isinstance(one, ast.Expr))


class _Ranges(ast.NodeTransformer):
    """Leaves of tests those of ranges: what is no number of the language is never asked."""

    def visit_BoolOp(self, node: ast.BoolOp) -> ast.expr:
        """The test without those of classes."""
        self.generic_visit(node)
        kept = [one for one in node.values if not (isinstance(one, ast.Compare) and isinstance(one.ops[0], ast.Is))]
        return ast.BoolOp(node.op, kept)


class _Otherwise(ast.NodeTransformer):
    """Calls a body where a program gives nothing."""

    def __init__(self, otherwise: ast.stmt) -> None:
        self.otherwise = otherwise

    def visit_Return(self, node: ast.Return) -> ast.stmt:
        """The statement, with the call for None."""
        nothing = isinstance(node.value, ast.Constant) and node.value.value is None
        return self.otherwise if nothing else node


def domains(intervals: ast.expr, symbols: ast.expr) -> dict[str, Domain]:
    """The ends of the domains of parameters, and which end belongs to it, from the tables of the run time."""
    assert isinstance(intervals, ast.Dict) and isinstance(symbols, ast.Dict)
    closed = {
        ast.literal_eval(key): next((ast.literal_eval(one.value) for one in call.keywords if one.arg == "closed"), "")
        for key, call in zip(symbols.keys, symbols.values, strict=True) if key and isinstance(call, ast.Call)
    }  # fmt: skip
    found = {}
    for key, pair in zip(intervals.keys, intervals.values, strict=True):
        assert key and isinstance(pair, ast.Tuple)
        low, high = (float(ast.unparse(end)) for end in pair.elts)
        name = ast.literal_eval(key)
        found[name] = low, high, closed.get(name, "")
    return found
