"""A formula as a graph: the body of a private function, run once by the build with objects that record what is done.

NumPy's functions find the objects by its protocols `__array_ufunc__` and `__array_function__`.  A body that
decides by its data or asks for shapes has no such graph; where it asks once whether a rare branch is needed at
all, the graph is that without this branch, and says when it holds.  A rule is one operation, `integral`, on the
length of the interval, its unit, a variable and what is summed over that; the search for a root is one, `root`.
With `roots` there is more that only expressions know: calls, integrals of a power, sums over coefficients.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

RELATIONS = frozenset(("less", "less_equal", "greater", "greater_equal", "equal", "not_equal", "isfinite", "isnan"))
CONNECTIVES = frozenset(("bitwise_and", "bitwise_or", "invert"))
FUNCTIONS = frozenset(
    (
        "add", "subtract", "multiply", "divide", "negative", "absolute", "power", "square", "minimum", "maximum",
        "sqrt", "cbrt", "exp", "expm1", "log", "log1p", "sin", "cos", "tan", "arctan", "arctan2", "hypot",
        "sinh", "cosh", "tanh", "arcsinh", "nextafter", "copysign", "arctanh", "floor",
    )
)  # fmt: skip
WHOLE = frozenset((3.0, 4.0))
"""Exponents of powers that become products; the seventh power as products took the force under r**6 to 5.4 units."""
EPS = float(np.finfo(float).eps)
LONGEST = 2000
"""Operations beyond which a body stays as it is: its text would be longer than anyone reads."""


class Node:
    """One operation on earlier ones; the value of an argument is its name."""

    __slots__ = ("order", "name", "operands", "value")

    def __init__(self, order: int, name: str, operands: tuple[Node, ...], value: Any) -> None:
        self.order, self.name, self.operands, self.value = order, name, operands, value

    @property
    def logical(self) -> bool:
        """Whether it is true or false, and no number."""
        if self.name == "number":
            return isinstance(self.value, bool)
        return self.name in RELATIONS or self.name in CONNECTIVES


Lengths: TypeAlias = tuple[tuple[float, int], ...]
"""Lengths of an interval and how many nodes a rule has up to there."""
Path: TypeAlias = tuple[tuple[Node, bool], ...]
"""The choices under which something is needed, from the outside: (a node `where`, which of its branches)."""


class UntraceableError(TypeError):
    """The body needs more than operations on its arguments."""


class Graph:
    """Operations in the order of the body; what occurs twice is one node."""

    def __init__(self, roots: bool = False) -> None:
        self._known: dict[Any, Node] = {}
        self.roots = roots
        self.refused: Node | None = None
        self.coefficients: Node | None = None
        self.summing = False

    def argument(self, name: str) -> Node:
        """An argument of the body."""
        return self._node("argument", (), name)

    def number(self, value: float | bool) -> Node:
        """A number that stands in the body."""
        return self._node("number", (), value if isinstance(value, bool) else float(value))

    def remade(self, node: Node, operands: Sequence[Node]) -> Node:
        """An argument, a number, or an operation of another graph on operands of this one."""
        if node.name in ("argument", "number"):
            return self._node(node.name, (), node.value)
        if node.name == "where":
            return self.choice(*operands)
        return self.unless(*operands) if node.name == "unless" else self.operation(node.name, *operands)

    def operation(self, name: str, *operands: Node) -> Node:
        """One of NumPy's functions of earlier nodes; of numbers alone its value."""
        if self.roots and name in ("add", "subtract", "multiply"):
            one, zero = self.number(1.0), self.number(0.0)
            operands = tuple(self.choice(x, one, zero) if x.logical else x for x in operands)
        if len(self._known) > LONGEST or any(x.logical for x in operands) != (name in CONNECTIVES):
            raise UntraceableError
        if all(x.name == "number" for x in operands):
            with np.errstate(all="ignore"):
                value = getattr(np, name)(*(x.value for x in operands))
            return self.number(value.item())
        if name in ("multiply", "divide") and operands[1].value == 1.0:
            return operands[0]
        if name == "multiply" and operands[0].value == 1.0:
            return operands[1]
        if self.roots and name == "sqrt" and any(map(self._ends, (*operands, *operands[0].operands))):
            # at its zero a root has no gradient
            zero = self.number(0.0)
            return self.choice(self._node("greater", (*operands, zero)), self._node(name, operands), zero)
        if self.roots and name == "nextafter":
            return self._node("multiply", (operands[0], self.number(1.0 + np.copysign(EPS, operands[1].value - 0.5))))
        if name == "power" and operands[1].name == "number" and operands[1].value in WHOLE:
            return self._products(operands[0], float(operands[1].value))
        return self._node(name, operands)

    @staticmethod
    def _ends(x: Node) -> bool:
        """Whether it is cut off at zero."""
        return x.name == "maximum" and x.operands[1].value == 0.0

    def _products(self, x: Node, exponent: float) -> Node:
        """Neither the square nor what follows leaves the range of doubles before the power does."""
        two = self.number(2.0)
        square = self._node("power", (x, two))
        return self._node("multiply", (x, square)) if exponent == 3.0 else self._node("power", (square, two))

    def choice(self, condition: Node, x: Node, y: Node) -> Node:
        """x where the condition holds, else y."""
        if not condition.logical or x.logical or y.logical:
            raise UntraceableError
        if condition.name == "number":
            return x if condition.value else y
        return x if x is y else self._node("where", (condition, x, y))

    def ask(self, condition: Node) -> bool:
        """Whether a condition holds anywhere: supposed not to, once; a body that asks on iterates."""
        if not condition.logical or self.summing or self.refused not in (None, condition):
            raise UntraceableError
        self.refused = condition
        return False

    def integrals(
        self, stop: Node, width: Node, summands: Callable[[Node], Iterable[Node]], lengths: Lengths
    ) -> list[Node]:
        """The integrals of functions of one variable from 0 to `stop`, by the nodes that `stop/width` asks for."""
        if self.summing and not self.roots:
            raise UntraceableError
        variable = self.variable()
        self.summing = True
        found = [*summands(variable)]
        self.summing = False
        return [self._node("integral", (stop, width, variable, own), lengths) for own in found]

    def other(self, name: str, operands: Sequence[Node], value: Any = None) -> Node:
        """What expressions alone have: a `call` of a function by its module and name, a `weighted` integral, terms."""
        return self._node(name, tuple(operands), value)

    def variable(self, name: str = "") -> Node:
        """What an integral or a search runs over."""
        return self._node("variable", (), name or len(self._known))

    def root(self, curve: Callable[[Node], tuple[Node, Node]], *given: Node) -> Node:
        """The root of an increasing curve, which gives its value and its logarithmic slope.

        The value, a first guess, the largest and the bounds of that slope are `given`.
        """
        if self.summing or not self.roots:
            raise UntraceableError
        variable = self.variable()
        found = curve(variable)
        return self._node("root", (*given, variable, *found))

    def of(self, x: Any) -> Node:
        """The node behind an object or a number."""
        if isinstance(x, Traced):
            return x.node
        if self.roots and isinstance(x, np.ndarray) and x.size == 1:
            return self.number(float(x.item()))
        if not isinstance(x, (bool, int, float, np.bool_, np.number)):
            raise UntraceableError
        return self.number(bool(x) if isinstance(x, (bool, np.bool_)) else float(x))

    def unless(self, condition: Node, result: Node) -> Node:
        """The result, which is another one where the condition holds anywhere."""
        return self._node("unless", (condition, result))

    def _node(self, name: str, operands: tuple[Node, ...], value: Any = None) -> Node:
        # repr tells the zeros apart
        key = (name, *(x.order for x in operands), repr(value))
        if key not in self._known:
            self._known[key] = Node(len(self._known), name, operands, value)
        return self._known[key]


FOR_ALL = {np.any: True, np.count_nonzero: True, np.all: False, np.max: np.inf}
"""What an expression takes for true of its data: choices tell where, and rules serve intervals of any length."""


class Traced(NDArrayOperatorsMixin):
    """Stands for an array while a body is run."""

    def __init__(self, graph: Graph, node: Node) -> None:
        self.graph, self.node = graph, node

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        name = ufunc.__name__
        if self.graph.roots and name == "ldexp" and inputs[1] == 0:
            return inputs[0]
        if method != "__call__" or options or not (name in FUNCTIONS or name in RELATIONS or name in CONNECTIVES):
            return NotImplemented
        return Traced(self.graph, self.graph.operation(name, *map(self.graph.of, inputs)))

    def __array_function__(self, function: Any, types: Any, args: Any, options: Any) -> Any:
        if self.graph.roots and function in FOR_ALL:
            return FOR_ALL[function]
        if options:
            return NotImplemented
        if function is np.where and len(args) == 3:
            return Traced(self.graph, self.graph.choice(*map(self.graph.of, args)))
        if function is np.any and len(args) == 1:
            return self.graph.ask(self.graph.of(args[0]))
        if function is np.clip and self.graph.roots:
            return np.minimum(np.maximum(args[0], args[1]), args[2])
        if function is np.zeros_like:
            return Traced(self.graph, self.graph.number(0.0))
        if function is np.ones_like:
            return Traced(self.graph, self.graph.number(1.0))
        if function is np.full_like:
            return Traced(self.graph, self.graph.of(args[1]))
        return NotImplemented

    def __getitem__(self, place: int) -> Traced:
        """The end of a grid of radii: only what looks for branches needs it, and expressions do not."""
        if not self.graph.roots:
            raise UntraceableError
        return self

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        raise UntraceableError

    def __bool__(self) -> bool:
        raise UntraceableError

    def integral(self, integrand: Callable[[Any], Any], width: Any, lengths: Lengths) -> Traced:
        """What the rules call in the place of their loop over nodes."""
        return self.integrals(lambda x: (integrand(x),), width, lengths)[0]

    def integrals(self, integrand: Callable[[Any], Iterable[Any]], width: Any, lengths: Lengths) -> list[Traced]:
        """The same of several at the same nodes."""
        graph = self.graph
        found = graph.integrals(
            self.node, graph.of(width), lambda variable: map(graph.of, integrand(Traced(graph, variable))), lengths
        )
        return [Traced(graph, node) for node in found]

    def weighted(self, smooth: Callable[[Any], Any], above: Any) -> Traced:
        """What stands for the rule of a weight."""
        graph, variable = self.graph, self.graph.variable()
        summand = graph.of(smooth(Traced(graph, variable)))
        return Traced(graph, graph.other("weighted", (self.node, graph.of(above), variable, summand)))

    def root(
        self, curve: Callable[[Any], tuple[Any, Any]], value: Any, largest: Any, exponents: tuple[Any, Any]
    ) -> Traced:
        """What the search for a root calls in the place of its iteration; this is the first guess."""
        graph = self.graph

        def traced(variable: Node) -> tuple[Node, Node]:
            y, slope = curve(Traced(graph, variable))
            return graph.of(y), graph.of(slope)

        given = (graph.of(value), self.node, graph.of(largest), *map(graph.of, exponents))
        return Traced(graph, graph.root(traced, *given))


def trace(
    function: Callable[..., Any], fields: Iterable[str], keywords: Iterable[str], graph: Graph | None = None
) -> Node | None:
    """What `function` returns for fields and keywords of these names, or None if it has no graph.

    In a graph with `roots` the search for a root is an operation, and rare branches are taken; in another one what
    iterates has none.
    """
    graph = graph or Graph()
    try:
        result = function(
            *(Traced(graph, graph.argument(name)) for name in fields),
            **{name: Traced(graph, graph.argument(name)) for name in keywords},
        )
        if isinstance(result, tuple) and not graph.roots:
            node = graph.other("pair", [*map(graph.of, result)])
        else:
            node = result.node if isinstance(result, Traced) else graph.number(float(result))
    except (TypeError, ValueError, AttributeError):
        return None
    if node.logical:
        return None
    return node if graph.refused is None else graph.unless(graph.refused, node)


def needed(result: Node) -> list[Node]:
    """The nodes behind a result, in order."""
    found, pending = {result.order: result}, [result]
    while pending:
        for x in pending.pop().operands:
            if x.order not in found:
                found[x.order] = x
                pending.append(x)
    return [found[order] for order in sorted(found)]


def places(nodes: list[Node]) -> dict[Node, Path]:
    """For every node the choices under which alone it is needed; the last one is the result."""
    paths: dict[Node, Path] = {nodes[-1]: ()}
    for user in reversed(nodes):
        for position, x in enumerate(user.operands):
            path = used_at(user, position, paths)
            paths[x] = _common(paths[x], path) if x in paths else path
    return paths


def used_at(user: Node, position: int, paths: dict[Node, Path]) -> Path:
    """The choices under which an operand is used."""
    path = paths[user]
    return (*path, (user, position == 1)) if user.name == "where" and position else path


def _common(x: Path, y: Path) -> Path:
    length = 0
    while length < min(len(x), len(y)) and x[length][0] is y[length][0] and x[length][1] == y[length][1]:
        length += 1
    return x[:length]
