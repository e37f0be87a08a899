"""Calls that are written out, and rules without groups.

Rules that are called in groups of points, as plain functions: a module of a scene needs no groups.

`in_groups` takes what the integrand needs apart, to select it point by point.
Here the rule integrates all points with the nodes of the widest interval, which
costs time and no accuracy, and takes an integrand of its lengths alone.  Nor does it
need the short way for many radii of one contact.

Which functions are written where they are called: used once, straight lines, plain names as arguments.
"""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

from .source import Edit, Source

if TYPE_CHECKING:
    from .linking import Definition, Key, Linker


MARK, SHORT_WAYS = "in_groups", ("at_many_radii", "over_radii", "Kept")


def rules(text: str) -> dict[str, int]:
    """The rules of a module by name, with the number of lengths their integrand takes."""
    return {n.name: _arity(n) for n in ast.parse(text).body if isinstance(n, ast.FunctionDef) and _marked(n)}


def ungrouped(text: str, known: dict[str, int]) -> str:
    """The module with these rules, and calls of them, written plainly."""
    if not any(name in text for name in (*known, *SHORT_WAYS)):
        return text
    own, edits = Source(text), []
    for node in ast.walk(own.tree):
        if isinstance(node, ast.FunctionDef) and _marked(node):
            edits += _plain_rule(own, node)
        elif isinstance(node, ast.FunctionDef) and _has_short_way(node):
            edits.append((own.span(node.decorator_list[0])[0] - 1, own.starts[node.lineno - 1], ""))
        elif isinstance(node, ast.ImportFrom):
            edits += _integrating(own, node)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in known:
            edits += _plain_call(own, node, known[node.func.id])
    return own.edited(edits)


def _marked(node: ast.FunctionDef) -> bool:
    return any(isinstance(d, ast.Name) and d.id == MARK for d in node.decorator_list)


def _has_short_way(node: ast.FunctionDef) -> bool:
    return any(ast.unparse(d).startswith(SHORT_WAYS) for d in node.decorator_list)


def _arity(rule: ast.FunctionDef) -> int:
    slope = rule.args.args[0].arg
    calls = (n for n in ast.walk(rule) if isinstance(n, ast.Call))
    return next(len(c.args) for c in calls if isinstance(c.func, ast.Name) and c.func.id == slope)


def _plain_rule(own: Source, rule: ast.FunctionDef) -> list[Edit]:
    """Without the mark, with a width, and integrating what it returned."""
    last = rule.body[-1]
    assert isinstance(last, ast.Return) and isinstance(last.value, ast.Tuple)
    integrand, stop, factor, holds, otherwise = (own.source(part) for part in last.value.elts)
    value = f"integral_in_strip({integrand}, {stop}, width)"
    value = value if factor == "1.0" else f"{factor} * {value}"
    value = value if holds == "True" else f"np.where({holds}, {value}, {otherwise})"
    mark, end = own.span(rule.decorator_list[0])[0] - 1, own.span(rule.args.args[-1])[1]
    return [(mark, own.starts[rule.lineno - 1], ""), (end, end, ", width: Array = 1.0"), (*own.span(last.value), value)]


def _integrating(own: Source, imported: ast.ImportFrom) -> list[Edit]:
    """What integrates a plain rule, beside the mark that it replaces."""
    names = {alias.name: alias for alias in imported.names}
    if MARK not in names or "integral_in_strip" in names:
        return []
    return [(*own.span(names[MARK]), "integral_in_strip")]


def _plain_call(own: Source, call: ast.Call, arity: int) -> list[Edit]:
    """`rule(_slope, (R, b), r, a)` becomes `rule(lambda t: _slope(t, R, b), r, a)`."""
    slope, given = call.args[0], call.args[1]
    if not isinstance(given, ast.Tuple):
        return []
    fields = ["t", "root"][:arity]
    passed = ", ".join([*fields, *(own.source(value) for value in given.elts)])
    text = f"lambda {', '.join(fields)}: {own.source(slope)}({passed})"
    return [(own.span(slope)[0], own.span(given)[1], text)]


WIDTH = 112


def returned(definition: Definition) -> tuple[list[ast.stmt], ast.expr] | None:
    """Assignments, also under conditions, and the returned expression of a function that is nothing else."""
    body = list(definition.function.body) if definition.function else []
    if body and isinstance(body[0], ast.Expr):
        body = body[1:]
    if not body or not isinstance(last := body[-1], ast.Return) or last.value is None:
        return None
    return (body[:-1], last.value) if all(_assigns(s) for s in body[:-1]) else None


def _assigns(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.If):
        return all(isinstance(s, ast.Assign) for s in (*statement.body, *statement.orelse))
    return isinstance(statement, ast.Assign)


def inlined(linker: Linker) -> dict[Key, str]:
    """The keys of these functions, each with the name its value gets first where it would not fit on the line."""
    uses: dict[Key, list[tuple[Definition, ast.expr]]] = {}
    for definition in linker.reached.values():
        for node, key in definition.references():
            uses.setdefault(key, []).append((definition, node))
    kept = {w.key for w in linker.wanted} | set(linker.roots)
    names: dict[Key, set[str]] = {key: set(d.bound) for key, d in linker.reached.items()}
    host: dict[Key, Key] = {}
    short: dict[Key, str] = {}
    parts = {key: returned(d) for key, d in linker.reached.items()}
    carries = {key: bool(own and own[0]) for key, own in parts.items()}
    straight: dict[Key, bool] = {}
    for key, found in uses.items():
        if key not in linker.reached or key in kept or len(found) != 1 or not linker.reached[key].function:
            continue
        caller, node = found[0]
        chain = [caller.key]
        while chain[-1] in host:
            chain.append(host[chain[-1]])
        call = next((c for c in ast.walk(caller.node) if isinstance(c, ast.Call) and c.func is node), None)
        if call is None or parts[key] is None or key in chain:
            continue
        plain = _straight(caller, call)
        free = plain and all(straight[inner] for inner in chain[:-1])
        # lines cannot leave a lambda, also not one further out
        if carries[key] and not free:
            continue
        place = chain[-1]
        if not _means_the_same(linker, key, call, names[key], names[place]):
            continue
        name = "" if _fits(linker, key, caller, call) else f"plain_{key[1].lstrip('_')}"
        if name and (not free or name in names[place]):
            continue
        host[key], straight[key], short[key] = caller.key, plain, name
        own = names[key] - set(linker.reached[key].parameters)
        names[place] |= own | ({name} if name else set())
        if carries[key] or name:
            carries |= dict.fromkeys(chain, True)
    return short


def _means_the_same(linker: Linker, key: Key, call: ast.Call, own: set[str], outer: set[str]) -> bool:
    """Whether the lines mean the same in the place of the call, with its arguments for the parameters."""
    callee = linker.reached[key]
    assignments, value = returned(callee) or ([], ast.Constant(None))
    given = linker.given(call, callee)
    taken = [p for p in callee.parameters if p not in linker.dropped[key]]
    if not all(isinstance(given.get(p), ast.Name) for p in taken):
        return False
    nodes = [n for part in (*assignments, value) for n in ast.walk(part) if isinstance(n, ast.Name)]
    if {n.id for n in nodes if isinstance(n.ctx, ast.Store)} & set(callee.parameters):
        return False
    free = {n.id for n in nodes} - own
    dropped = linker.dropped[key]
    return not (own - set(callee.parameters)) & outer and not (free | dropped) & (outer - linker.frozen)


def _fits(linker: Linker, key: Key, caller: Definition, call: ast.Call) -> bool:
    callee = linker.reached[key]
    _, value = returned(callee) or ([], ast.Constant(None))
    length = len(callee.module.source(value)) + len(caller.module.lines[call.lineno - 1])
    return length <= WIDTH + len(caller.module.source(call))


def _straight(caller: Definition, call: ast.Call) -> bool:
    """Whether the call stands in a simple statement of the function itself, so that lines can go before it."""
    assert caller.function is not None
    for statement in caller.function.body:
        if any(node is call for node in ast.walk(statement)):
            simple = isinstance(statement, (ast.Assign, ast.Return))
            scopes = (s for s in ast.walk(statement) if isinstance(s, (ast.Lambda, ast.GeneratorExp, ast.IfExp)))
            return simple and not any(node is call for scope in scopes for node in ast.walk(scope))
    return False
