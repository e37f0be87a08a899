"""Exact rewriting of a graph before it becomes a program: powers of two leave the arrays, a zero its choice."""

from __future__ import annotations

import math

from ._trace import Graph, Node, needed

ODD = frozenset(("sqrt", "arcsinh", "arctan", "log1p", "tanh", "square"))
"""Functions that are zero at zero and positive beyond."""


def depending(nodes: list[Node], given: set[str]) -> set[Node]:
    """The nodes that depend on an array."""
    found: set[Node] = set()
    for node in nodes:
        if (node.name == "argument" and node.value in given) or any(x in found for x in node.operands):
            found.add(node)
    return found


def numbers_first(result: Node, given: set[str]) -> Node:
    """The same with powers of two moved from arrays to the numbers before them, which no rounding notices."""
    graph, made = Graph(), dict[Node, Node]()
    nodes = needed(result)
    arrays = depending(nodes, given)
    numbers: set[Node] = set()
    for node in nodes:
        operands = [made[x] for x in node.operands]
        factor = _power_of_two(node) if node in arrays else None
        if factor is not None:
            made[node] = _times(graph, operands[0], graph.number(factor), numbers)
        elif node.name in ("argument", "number"):
            made[node] = graph.copied(node)
        elif node.name == "where":
            made[node] = graph.choice(*operands)
        elif node.name == "unless":
            made[node] = graph.unless(*operands)
        else:
            made[node] = graph.operation(node.name, *operands)
        if node not in arrays:
            numbers.add(made[node])
    return made[result]


def _power_of_two(node: Node) -> float | None:
    """k where the node is x*k or x/(1/k)."""
    if node.name not in ("multiply", "divide") or node.operands[1].name != "number":
        return None
    value = float(node.operands[1].value or 0.0)
    if value == 0.0 or not math.isfinite(value) or abs(math.frexp(value)[0]) != 0.5 or abs(math.frexp(value)[1]) > 64:
        return None
    return value if node.name == "multiply" else 1.0 / value


def _times(graph: Graph, x: Node, factor: Node, numbers: set[Node]) -> Node:
    if x.name in ("multiply", "divide"):
        y, z = x.operands
        if y in numbers:
            return graph.operation(x.name, graph.operation("multiply", y, factor), z)
        if z in numbers:
            return graph.operation(x.name, y, graph.operation(x.name, z, factor))
    return graph.operation("multiply", x, factor)


def without_choice(result: Node, given: set[str]) -> Node:
    """`where(r < a, f(a - r), 0)` as f(maximum(a - r, 0)), where that is zero for all r >= a; as it is otherwise.

    All arguments and what is computed from numbers alone are positive and finite, and `a` is a number.
    """
    if result.name != "where" or result.operands[0].name != "less" or result.operands[2].value != 0.0:
        return result
    condition, inside, _ = result.operands
    r, a = condition.operands
    if r.value not in given or a.name != "argument" or a.value in given:
        return result
    graph, made = Graph(), dict[Node, Node]()
    signs: dict[Node, int | None] = {}
    nodes = needed(inside)
    arrays = depending(nodes, given)
    for node in nodes:
        operands = [made[x] for x in node.operands]
        if node.name in ("argument", "number"):
            made[node] = graph.copied(node)
        elif node.name == "where":
            made[node] = graph.choice(*operands)
        else:
            made[node] = graph.operation(node.name, *operands)
        known = [signs[x] for x in node.operands]
        if node.name == "subtract" and node.operands == (a, r):
            made[node], known = graph.operation("maximum", made[node], graph.number(0.0)), []
        signs[node] = _sign(node, known) if node in arrays or node.name == "number" else 1
    return made[inside] if signs[inside] == 0 else result


def _sign(node: Node, known: list[int | None]) -> int | None:
    """0 for zero, 1 for a positive and finite number, None for what is not known to be either."""
    if node.name == "argument":
        return 1
    if node.name == "number":
        value = float(node.value or 0.0)
        return 0 if value == 0.0 else 1 if 0.0 < value < math.inf else None
    if not known:
        return 0
    ordered = [x for x in known if x is not None]
    if len(ordered) != len(known):
        return None
    if node.name == "add":
        return max(ordered)
    if node.name == "multiply":
        return min(ordered)
    if node.name in ("divide", "arctan2"):
        return known[0] if known[1] == 1 else None
    if node.name == "subtract":
        return known[0] if known[1] == 0 else None
    if node.name == "power":
        return known[0] if known[1] == 1 else None
    return known[0] if node.name in ODD else None
