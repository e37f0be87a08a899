"""What a body costs per value of an array: its operations, counted in multiplications.  Nothing is timed."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator

from ..stable.emitted import ITERATIONS, is_rule

WEIGHTS = {
    "sqrt": 3, "cbrt": 4, "where": 3, "abs": 1, "minimum": 1, "maximum": 1, "ones_like": 1, "zeros_like": 1,
    "log": 3, "log1p": 3, "exp": 3, "expm1": 4, "arctan": 4, "arcsin": 4, "arccos": 5, "arctan2": 7, "sinh": 4,
    "cosh": 4, "tanh": 6, "arcsinh": 7, "arccosh": 7, "arctanh": 5, "sin": 20, "cos": 20, "tan": 5, "arctan_gap": 38,
    "root_gap": 40, "tanh_gap": 28, "difference_root": 5, "lower_power": 14, "nth_root": 30, "without_root": 32,
}  # fmt: skip
"""As measured with NumPy 2 on blocks in the cache of one machine with AVX-512; a quotient is worth a product.

The root inside `root_gap` is one that the formula holds too, and is found once.
"""
POWER, KERNEL = 11, 40
"""A power that is not written as products, and any other function of the runtime."""
WHOLE: dict[object, int] = {2: 1, 3: 2, 4: 2}
"""Products of a whole power, by squares: what `_trace` makes of it."""
STEADY = 2
"""What `arctan2` costs more where one of its arguments is a number: its fast loop wants two arrays."""
NODES, STEPS = 24, 4
"""Values of an integrand where its rule does not state them, and of a curve under an iteration."""


def cost(source: str, function: str, fields: Collection[str]) -> int:
    """Of one value of a private function of a module; what depends on no field is found once per call, for nothing."""
    bodies = {node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)}
    return _Counter(bodies).function(bodies[function], frozenset(fields))[0]


class _Counter:
    """Cost of a piece of code, and whether it depends on a field."""

    def __init__(self, bodies: dict[str, ast.FunctionDef]) -> None:
        self.bodies = bodies

    def function(self, node: ast.FunctionDef, varying: frozenset[str]) -> tuple[int, bool]:
        total, names, own = 0, set(varying), dict(self.bodies)
        inner = _Counter(own)
        for line in node.body:
            if isinstance(line, ast.FunctionDef):
                own[line.name] = line
            for value, targets in _values(line):
                spent, depends = inner.value(value, names)
                total += spent
                names |= targets if depends else set()
        return total, True

    def value(self, node: ast.AST, names: Collection[str]) -> tuple[int, bool]:
        if isinstance(node, ast.Name):
            return 0, node.id in names
        if isinstance(node, ast.Call):
            return self._call(node, names)
        parts = [self.value(child, names) for child in ast.iter_child_nodes(node)]
        spent, depends = sum(part for part, _ in parts), any(own for _, own in parts)
        return spent + (_operation(node) if depends else 0), depends

    def _call(self, node: ast.Call, names: Collection[str]) -> tuple[int, bool]:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        parts = [self.value(arg, names) for arg in [*node.args, *(word.value for word in node.keywords)]]
        spent, depends = sum(part for part, _ in parts), any(own for _, own in parts)
        if name in self.bodies:
            body = self.bodies[name]
            given = zip((arg.arg for arg in body.args.args), parts, strict=False)
            varying = frozenset(arg for arg, (_, own) in given if own)
            return spent + (self.function(body, varying)[0] if varying else 0), depends
        repeated = _repetitions(node, name)
        if repeated:
            return spent + repeated * sum(self._integrand(arg) for arg in node.args), True
        steady = STEADY if name == "arctan2" and not all(own for _, own in parts) else 0
        return spent + (WEIGHTS.get(name, KERNEL) + steady if depends else 0), depends

    def _integrand(self, node: ast.AST) -> int:
        """A function that is passed to a rule or an iteration, at one of its points."""
        if isinstance(node, ast.Lambda):
            return self.value(node.body, {arg.arg for arg in node.args.args})[0]
        if isinstance(node, ast.Name) and node.id in self.bodies:
            body = self.bodies[node.id]
            return self.function(body, frozenset(arg.arg for arg in body.args.args[:2]))[0]
        return 0


def _values(line: ast.stmt) -> Iterator[tuple[ast.AST, set[str]]]:
    """What is computed on a line, and the names it is given to."""
    if isinstance(line, ast.Assign):
        targets = {node.id for target in line.targets for node in ast.walk(target) if isinstance(node, ast.Name)}
        yield line.value, targets
    elif isinstance(line, (ast.Return, ast.Expr)) and line.value is not None:
        yield line.value, set()


def _operation(node: ast.AST) -> int:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        return WHOLE.get(node.right.value, POWER) if isinstance(node.right, ast.Constant) else POWER
    return int(isinstance(node, (ast.BinOp, ast.UnaryOp, ast.Compare)))


def _repetitions(node: ast.Call, name: str) -> int:
    if name in ITERATIONS:
        return STEPS
    if not is_rule(name):
        return 0
    last = node.args[-1] if node.args else None
    return last.value if isinstance(last, ast.Constant) and isinstance(last.value, int) else NODES
