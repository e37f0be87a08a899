"""Which functions are written where they are called: used once, straight lines, the same names on both sides."""

from __future__ import annotations

import ast
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .library import Definition, Key
    from .linking import Linker

WIDTH = 112


def returned(definition: Definition) -> tuple[list[ast.stmt], ast.expr] | None:
    """Assignments and the returned expression of a function that is nothing else."""
    body = list(definition.function.body) if definition.function else []
    if body and isinstance(body[0], ast.Expr):
        body = body[1:]
    if not body or not isinstance(last := body[-1], ast.Return) or last.value is None:
        return None
    return (body[:-1], last.value) if all(isinstance(s, ast.Assign) for s in body[:-1]) else None


def inlined(linker: Linker) -> frozenset[Key]:
    """The keys of these functions."""
    uses: dict[Key, list[tuple[Definition, ast.expr]]] = {}
    for definition in linker.reached.values():
        for node, key in definition.references():
            uses.setdefault(key, []).append((definition, node))
    kept = {w.key for w in linker.wanted} | set(linker.roots)
    names: dict[Key, set[str]] = {key: set(d.bound) for key, d in linker.reached.items()}
    host: dict[Key, Key] = {}
    for key, found in uses.items():
        if key not in linker.reached or key in kept or len(found) != 1 or not linker.reached[key].function:
            continue
        caller, node = found[0]
        place = caller.key
        while place in host:
            place = host[place]
        if place != key and _fits(linker, key, caller, node, names[key], names[place]):
            host[key] = place
            names[place] |= names[key]
    return frozenset(host)


def _fits(linker: Linker, key: Key, caller: Definition, node: ast.expr, own: set[str], outer: set[str]) -> bool:
    """Whether the lines mean the same in the place of the call, and fit on a line."""
    callee = linker.reached[key]
    parts = returned(callee)
    call = next((c for c in ast.walk(caller.node) if isinstance(c, ast.Call) and c.func is node), None)
    if parts is None or call is None:
        return False
    assignments, value = parts
    if assignments and not _straight(caller, call):
        return False
    given = linker.given(call, callee)
    taken = [p for p in callee.parameters if p not in linker.dropped[key]]
    if not all(isinstance(v := given.get(p), ast.Name) and v.id == p for p in taken):
        return False
    free = {n.id for part in (*assignments, value) for n in ast.walk(part) if isinstance(n, ast.Name)} - own
    dropped = linker.dropped[key]
    clash = (own - set(callee.parameters)) & outer | ((free | dropped) & (outer - linker.frozen))
    length = len(callee.module.source(value)) + len(caller.module.lines[call.lineno - 1])
    return not clash and length <= WIDTH + len(caller.module.source(call))


def _straight(caller: Definition, call: ast.Call) -> bool:
    """Whether the call stands in a simple statement of the function itself, so that lines can go before it."""
    assert caller.function is not None
    for statement in caller.function.body:
        if any(node is call for node in ast.walk(statement)):
            simple = isinstance(statement, (ast.Assign, ast.Return))
            scopes = (s for s in ast.walk(statement) if isinstance(s, (ast.Lambda, ast.GeneratorExp, ast.IfExp)))
            return simple and not any(node is call for scope in scopes for node in ast.walk(scope))
    return False
