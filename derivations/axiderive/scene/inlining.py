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
        # lines cannot leave a lambda, also not one further out
        if carries[key] and not (plain and all(straight[inner] for inner in chain[:-1])):
            continue
        place = chain[-1]
        if _fits(linker, key, caller, call, names[key], names[place]):
            host[key], straight[key] = caller.key, plain
            names[place] |= names[key]
            if carries[key]:
                carries |= dict.fromkeys(chain, True)
    return frozenset(host)


def _fits(linker: Linker, key: Key, caller: Definition, call: ast.Call, own: set[str], outer: set[str]) -> bool:
    """Whether the lines mean the same in the place of the call, and fit on a line."""
    callee = linker.reached[key]
    assignments, value = returned(callee) or ([], ast.Constant(None))
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
