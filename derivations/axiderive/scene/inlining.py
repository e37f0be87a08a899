"""Which functions are written where they are called: used once, straight lines, plain names as arguments."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .library import Definition, Key
    from .linking import Linker

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
