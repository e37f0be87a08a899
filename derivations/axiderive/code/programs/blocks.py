"""A formula for blocks of arrays: NumPy's functions one after another into a few arrays that stay in cache.

What depends on plain numbers alone is computed once per call.  `np.where` becomes a decision for every block:
a branch that holds nowhere in it is not evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from .graph import Graph, Node, Path, needed, places, used_at

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
        else:
            made[node] = graph.remade(node, operands)
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
        made[node] = graph.remade(node, [made[x] for x in node.operands])
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
    if node.name in ("divide", "arctan2", "power"):
        return known[0] if known[1] == 1 else None
    if node.name == "subtract":
        return known[0] if known[1] == 0 else None
    return known[0] if node.name in ODD else None


EXTREMES = ("minimum", "maximum")
SIGNS = {"add": "+", "subtract": "-", "multiply": "*", "divide": "/"}


class Blocks:
    """Text of a program; arrays of scratch are freed where their value is used for the last time.

    `names` are the arguments, `given` those that are arrays, `fields` those whose range is asked for.
    The `constants` are those of a whole module: what stands for a number as an array without dimensions.
    """

    def __init__(
        self, result: Node, names: Sequence[str], given: Sequence[str], fields: Sequence[str], constants: dict[str, str]
    ) -> None:
        result = numbers_first(result, set(given))
        simpler = without_choice(result, set(given))
        self.positive = simpler is not result
        result = simpler
        self.given = given
        self.checked = given if self.positive else [name for name in given if name in fields]
        self.numbers = [name for name in names if name not in given]
        self.nodes = needed(result)
        self.paths = places(self.nodes)
        self.arrays = depending(self.nodes, set(given))
        self.last = self._last_uses()
        self.text: list[str] = []
        self.where: dict[Node, str] = {}
        self.constants = constants
        self.filled: dict[float, str] = {}
        self.free: list[str] = []
        self.idle: list[str] = []
        self.count = self.mask_count = 0
        self.refused: Node | None = None

    def written(self, name: str) -> str:
        """The functions `prepare_<name>` and `block_<name>`."""
        result = self.nodes[-1]
        if result.name == "unless":
            self.refused, result = result.operands
            if self.refused not in self.arrays:
                self._line(1, f"if {self.of(self.refused)}:")
                self._line(2, "raise FloatingPointError")
        self._region((), result, "out", 1)
        numbers = [x for x in self.nodes if x not in self.arrays and x.name not in ("number", "unless")]
        lines = [
            f"    {self.of(x)} = {_of_numbers(x, [self._of_number(o) for o in x.operands])}"
            for x in numbers
            if x.operands
        ]
        reaching = {x for user in self.arrays for x in user.operands} | {result, self.refused}
        results = [self.of(x) for x in numbers if x in reaching]
        lines.append(f"    return ({', '.join(results)}{',' if len(results) == 1 else ''})")
        scratch = [f"t{i}" for i in range(self.count)] + [f"m{i}" for i in range(self.mask_count)]
        scratch += self.filled.values()
        arguments = ", ".join(["out", *self.given, *results, *scratch])
        text = self._with_checks()
        if any(" != size" in line for line in text):
            text.insert(0, "    size = out.size")
        return "\n".join(
            [
                *(f"def prepare_{name}({', '.join(self.numbers)}):", *lines, "", ""),
                *(f"def block_{name}({arguments}):", *text, ""),
            ]
        )

    def record(self, name: str) -> str:
        """The program as the run time knows it."""
        said = self.count, self.mask_count, tuple(self.filled), self.positive
        return f"({tuple(self.given)!r}, prepare_{name}, block_{name}, {', '.join(map(repr, said))})"

    def of(self, node: Node) -> str:
        """The name of a value, or of the array it stands in."""
        if node.name == "argument":
            return str(node.value)
        if node.name == "number":
            # as an array without dimensions: half of what a call with a float costs
            return self.constants.setdefault(literal(float(node.value)), f"C{len(self.constants)}")
        return self.where[node] if node in self.arrays else f"v{node.order}"

    def _extreme(self, node: Node) -> str:
        if node.name != "number":
            return self.of(node)
        return self.filled.setdefault(float(node.value or 0.0), f"f{len(self.filled)}")

    def _of_number(self, node: Node) -> str:
        return f"({literal(float(node.value))})" if node.name == "number" else self.of(node)

    def _with_checks(self) -> list[str]:
        """The lines and, behind the first, which brings the arrays to cache, what asks for their range."""
        checks = []
        for array in self.checked:
            name = _largest(array)
            checks += [
                f"    {name} = largest({array})",
                f"    if {name} == np.inf:",
                "        raise FloatingPointError",
            ]
        first = int(not self.text[0].lstrip().startswith("if "))
        return [*self.text[:first], *checks, *self.text[first:]]

    def _last_uses(self) -> dict[Node, Node]:
        """For every array the last step among those under the same choices that needs it."""
        last: dict[Node, Node] = {}
        for user in self.nodes:
            for position, x in enumerate(user.operands):
                path, depth = used_at(user, position, self.paths), len(self.paths[x])
                step = path[depth][0] if len(path) > depth else user
                if x not in last or step.order > last[x].order:
                    last[x] = step
        return last

    def _region(self, path: Path, target: Node, place: str, depth: int) -> None:
        """The steps under these choices; the last of them leaves the target in `place`."""
        steps = [
            x for x in self.nodes if self.paths[x] == path and x in self.arrays and x.operands and x.name != "unless"
        ]
        inside = target in steps
        lend = inside and target is steps[-1] and target.name != "where"
        if lend:
            self.free.append(place)
        for node in steps:
            self._step(node, place if node is target else None, depth)
            if node is self.refused:
                self._line(depth, f"if np.count_nonzero({self.of(node)}):")
                self._line(depth + 1, "raise FloatingPointError")
        if lend and place in self.free:
            self.free.remove(place)
        if not inside:
            self._line(depth, f"np.copyto({place}, {self.of(target)})")

    def _step(self, node: Node, place: str | None, depth: int) -> None:
        dying = {x: self.where[x] for x in node.operands if x in self.where and self.last[x] is node}
        if node.name == "where":
            dying |= {x: p for x, p in self.where.items() if self.last.get(x) is node}
            place = place or self._new()
            self._choice(node, place, depth)
            self._release(dying)
        else:
            operands = [self._extreme(x) if node.name in EXTREMES else self.of(x) for x in node.operands]
            self._release(dying)
            place = place or (self._new_mask() if node.logical else self._new())
            # a third argument by position is deprecated for these two alone
            out = f"out={place}" if node.name in EXTREMES else place
            inside = self._inside(node) if operands[0] == place else ""
            if inside:
                self._line(depth, inside)
            self._line(depth + bool(inside), f"{_ufunc(node, operands)}, {out})")
        self.where[node] = place

    def _inside(self, node: Node) -> str:
        """What decides for a whole block whether `maximum(a - r, 0)` differs from a - r in it."""
        if not self.positive or node.name != "maximum" or node.operands[0].name != "subtract":
            return ""
        a, r = node.operands[0].operands
        return f"if {_largest(str(r.value))} > {self.of(a)}:" if r.value in self.checked else ""

    def _choice(self, node: Node, place: str, depth: int) -> None:
        path, (condition, x, y) = self.paths[node], node.operands
        if condition not in self.arrays:
            for branch, holds, line in ((x, True, f"if {self.of(condition)}:"), (y, False, "else:")):
                self._line(depth, line)
                self._region((*path, (node, holds)), branch, place, depth + 1)
            return
        mask, some = self.of(condition), f"some{node.order}"
        self._line(depth, f"{some} = np.count_nonzero({mask})")
        self._line(depth, f"if {some}:")
        self._region((*path, (node, True)), x, place, depth + 1)
        self._line(depth, f"if {some} != size:")
        inner = (*path, (node, False))
        if y in self.arrays and y.operands and self.paths[y] == inner:
            other = self._new()
            name = f"other{node.order}"
            self._line(depth + 1, f"{name} = {other} if {some} else {place}")
            self._region(inner, y, name, depth + 1)
            self._line(depth + 1, f"if {some}:")
            self._line(depth + 2, f"np.copyto({place}, {name}, where=~{mask})")
            self.free.append(other)
        else:
            self._line(depth + 1, f"np.copyto({place}, {self.of(y)}, where=~{mask})")

    def _new(self) -> str:
        if self.free:
            return self.free.pop()
        self.count += 1
        return f"t{self.count - 1}"

    def _new_mask(self) -> str:
        if self.idle:
            return self.idle.pop()
        self.mask_count += 1
        return f"m{self.mask_count - 1}"

    def _release(self, dying: dict[Node, str]) -> None:
        for node, place in dying.items():
            (self.idle if node.logical else self.free).append(place)
            del self.where[node]

    def _line(self, depth: int, line: str) -> None:
        self.text.append("    " * depth + line)


def literal(value: float) -> str:
    """A number as NumPy's users write it."""
    return repr(value) if math.isfinite(value) else f"np.{value!r}".replace("np.-", "-np.")


def _largest(name: str) -> str:
    return f"largest_{name}"


def _ufunc(node: Node, operands: list[str]) -> str:
    """The beginning of a call; x**2 and x**0.5 are what NumPy makes of them."""
    if node.name == "power" and node.operands[1].name == "number":
        special = {2.0: "square", 0.5: "sqrt"}.get(float(node.operands[1].value or 0.0))
        if special:
            return f"np.{special}({operands[0]}"
    return f"np.{node.name}({', '.join(operands)}"


def _of_numbers(node: Node, operands: list[str]) -> str:
    if node.name == "where":
        return f"{operands[1]} if {operands[0]} else {operands[2]}"
    if node.name in SIGNS:
        return f"{operands[0]} {SIGNS[node.name]} {operands[1]}"
    return f"{_ufunc(node, operands)})"
