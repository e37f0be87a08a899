"""A formula as a flat function of `math` for plain numbers, from the graph of a body.

A ufunc takes half a microsecond for one number and `math` a tenth of that, a call of a function as much
as a formula.  `np.where` becomes an if: nothing is evaluated outside its branch.  A rule is a loop over its nodes.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Mapping, Sequence

from .bounds import Bound, bounds
from .graph import Lengths, Node, Path, needed, places

SMALL, LARGE = 1e-30, 1e30
"""Plain numbers between these take the short way."""
LEAST, GREATEST = 1e-200, 1e200
"""A result between these is trusted where the bounds of a formula do not show that nothing left the range."""
TRUSTED = (f"if value > {LEAST} and value < {GREATEST} or {LEAST} < -value < {GREATEST}:", "    return value")
ORDINARY = "ordinary"
"""The function of the run time that says of arguments that they leave the range nowhere."""
OPERATORS = {
    "add": "+", "subtract": "-", "multiply": "*", "divide": "/", "less": "<", "less_equal": "<=", "greater": ">",
    "greater_equal": ">=", "equal": "==", "not_equal": "!=", "bitwise_and": "and", "bitwise_or": "or",
}  # fmt: skip
PREFIXES = {"negative": "-", "invert": "not "}
NAMES = {
    "power": "pow", "absolute": "abs", "arctan": "atan", "arctan2": "atan2", "arcsinh": "asinh", "arctanh": "atanh",
    "minimum": "{0} if {0} < {1} or {0} != {0} else {1}", "maximum": "{0} if {0} > {1} or {0} != {0} else {1}",
    "square": "{0} * {0}",
}  # fmt: skip
TWICE = ("minimum", "maximum", "square")
ENDS = (("r", "a"), ("x", "a"), ("t", "t_h"))
"""Arguments and what they are above where a result may be nothing; in a hold a force may be too small for a double."""
DEEPEST = 24
"""Operations inside one another on one line; Python refuses two hundred parentheses."""


def function(
    name: str,
    arguments: Mapping[str, tuple[float, float]],
    orders: Sequence[str],
    lines: list[str],
    unused: Sequence[str] = (),
    words: Sequence[str] = (),
) -> str:
    """The text of a function of plain numbers: None where one is no float or outside its range, or the result may err.

    `orders` are relations between the arguments that must hold beside; the lines return a value, and do not need those
    arguments that are `unused`, which come last and may be left out where they have been looked at before; `words` are
    arguments that are no numbers.
    """
    # a third faster than in a chain
    inside = [f"{own} > {low!r} and {own} < {high!r}" for own, (low, high) in arguments.items()]
    if arguments:
        inside.insert(0, f"{' is '.join(f'{own}.__class__' for own in arguments)} is float")
    # coefficients, of which some may be zero
    inside += [
        f"all([x.__class__ is float and (x == 0.0 or {SMALL} < x < {LARGE}) for x in {own}])"
        for own in words
        if own == "A"
    ]
    condition = " and ".join([*inside, *orders]) or "True"
    body = "\n".join(f"            {line}" for line in lines)
    signature = [f"{own}={min(1.0, 0.5 * arguments[own][1])!r}" if own in unused else own for own in arguments]
    signature += words
    text = (
        f"def {name}({', '.join(signature)}):\n    if {condition}:\n        try:\n{body}\n"
        "        except (ArithmeticError, ValueError):\n            pass\n    return None\n"
    )
    # without the brackets that the order of operations makes needless
    return ast.unparse(ast.parse(text))


def settled(arguments: Iterable[str], *, vanishing: bool = False) -> list[str]:
    """The lines for a result that is no number, or nothing beyond the contact, where no argument is far out.

    Of what may be `vanishing`, as the radius at which surfaces part, nothing is a result like any other.
    """
    known = [*arguments]
    outside = [f" or value == 0.0 and {own} > {end}" for own, end in ENDS if {own, end}.issubset(known)]
    outside += [" or value == 0.0"] * vanishing
    return [f"if ({''.join(['value != value', *outside])}) and {ORDINARY}({', '.join(known)}):", "    return value"]


class Lines:
    """Lines of one function: what occurs once is written where it is used, the rest has a name.

    `ranges` are those of the arguments; without them every value is returned as it is.  The numbered `rules` are asked
    for by the lengths for which they have nodes.
    """

    def __init__(
        self, result: Node, ranges: Mapping[str, tuple[float, float]] | None, rules: dict[Lengths, str]
    ) -> None:
        self.nodes, self.arguments = needed(result), tuple(ranges or ())
        self.loops = loops(self.nodes)
        self.paths = {node: self._outside(node, path) for node, path in places(self.nodes).items()}
        self.rules = rules
        self.named = self._named()
        self.split = {choice for node in self.named for choice, _ in self.paths[node]}
        self.written: set[Node] = set()
        self.proved = {*self.nodes} if ranges is None else _proved(self.nodes, bounds(self.nodes, ranges))

    def _outside(self, node: Node, path: Path) -> Path:
        """The choices that are made before the loop, for what does not change in it."""
        inner = [i for i, (choice, _) in enumerate(path) if choice in self.loops and node not in self.loops]
        return path[: inner[0]] if inner else path

    def _named(self) -> set[Node]:
        """What is written on a line of its own: all that occurs twice, and a branch with such lines."""
        uses, depth, found = dict.fromkeys(self.nodes, 0), dict.fromkeys(self.nodes, 0), set()
        for user in self.nodes:
            for x in user.operands:
                loop = self.loops.get(user) is not self.loops.get(x)
                uses[x] += 2 if loop or user.name in (*TWICE, "integral") or _is_square(user) else 1
        for node in self.nodes:
            if not node.operands:
                continue
            depth[node] = 1 + max(depth[x] for x in node.operands)
            if uses[node] > 1 or node in found or depth[node] > DEEPEST or node.name == "integral":
                found |= {node, *(choice for choice, _ in self.paths[node])}
                depth[node] = 0
        return {node for node in found if not self._is_first(node)}

    def text(self) -> list[str]:
        """The lines that return the value."""
        return self._returned(self.nodes[-1], (), certain=True)

    def _assigned(self, path: Path, last: Node, loop: Node | None = None) -> list[str]:
        """The lines for what is needed under these choices in this loop, but for the last one."""
        text = []
        for node in self.nodes:
            here = self.paths[node] == path and self.loops.get(node) is loop
            if here and node in self.named and node not in self.written and (node is not last or is_sum(node)):
                self.written.add(node)
                text += self._assignment(node, path)
        return text

    def _assignment(self, node: Node, path: Path) -> list[str]:
        if is_sum(node):
            return self._loop(node, path)
        if node not in self.split:
            return [f"v{node.order} = {self.expression(node)}"]
        condition, *branches = node.operands
        text = [f"if {self.of(condition)}:"]
        for branch, holds in zip(branches, (True, False), strict=True):
            inner = self._assigned((*path, (node, holds)), node, self.loops.get(node))
            inner.append(f"v{node.order} = {self.of(branch)}")
            text += [*(["else:"] if not holds else []), *(f"    {line}" for line in inner)]
        return text

    def _loop(self, node: Node, path: Path) -> list[str]:
        """The loop of a sum, and of those that have the same variable."""
        stop, width, variable, _ = node.operands
        name = self.rules.setdefault(node.value, f"RULE_{len(self.rules)}")
        sums = [x for x in self.nodes if is_sum(x) and x.operands[2] is variable and self.paths[x] == path]
        self.written.update(sums)
        inner = [f"v{variable.order} = node * {self.of(stop)}", *self._assigned(path, node, variable)]
        inner += [f"v{x.order}.append(weight * {self.of(x.operands[3])})" for x in sums]
        loop = [f"for node, weight in {name}({self.of(stop)} / {self.of(width)}):", *(f"    {line}" for line in inner)]
        if len(sums) > 1:
            # paths of no length are common among those of pairs
            loop = [f"if abs({self.of(stop)}) > 0.0:", *(f"    {line}" for line in loop)]
        # summed one by one the 64 nodes of a power lose 3 units, which a pressure next to its zero takes up
        return [
            *(f"v{x.order} = []" for x in sums),
            *loop,
            *(f"v{x.order} = fsum(v{x.order}) * {self.of(stop)}" for x in sums),
        ]

    def _returned(self, node: Node, path: Path, certain: bool) -> list[str]:
        if node.name == "unless":
            condition, node = node.operands
            text = [*self._assigned(path, node), f"if {self.of(condition)}:", "    return None"]
            return text + self._returned(node, path, certain and condition in self.proved)
        text = self._assigned(path, node if self.paths[node] == path else self.nodes[-1])
        if node.name == "where" and self.paths[node] == path:
            condition, x, y = node.operands
            certain = certain and condition in self.proved
            text.append(f"if {self.of(condition)}:")
            text += [f"    {line}" for line in self._returned(x, (*path, (node, True)), certain)]
            return text + self._returned(y, (*path, (node, False)), certain)
        value = self.expression(node) if self.paths[node] == path and not is_sum(node) else self.of(node)
        if certain and (node in self.proved or node.name == "number"):
            return [*text, f"return {value}"]
        # what has no rule takes the arrays no longer
        sure = settled(self.arguments) if any(map(is_sum, self.nodes)) else []
        return [*text, f"value = {value}", *TRUSTED, *sure, "return None"]

    def _is_first(self, node: Node) -> bool:
        """Whether this is minimum(x, y) where x < y has been decided."""
        chosen = [choice.operands[0] for choice, holds in self.paths[node] if holds]
        return node.name == "minimum" and any(x.name == "less" and x.operands == node.operands for x in chosen)

    def of(self, node: Node) -> str:
        """How a value is written where it is used."""
        if self._is_first(node):
            return self.of(node.operands[0])
        return f"v{node.order}" if node in self.named else self.expression(node)

    def expression(self, node: Node) -> str:
        """The operation of a node."""
        if node.name == "argument":
            return str(node.value)
        if node.name == "variable":
            return f"v{node.order}"
        if node.name == "number":
            return f"({node.value!r})" if float(node.value) < 0.0 else repr(node.value)
        operands = [self.of(x) for x in node.operands]
        if node.name == "pair":
            return f"({', '.join(operands)})"
        if node.name == "where":
            return f"({operands[1]} if {operands[0]} else {operands[2]})"
        if _is_square(node):
            return f"({operands[0]} * {operands[0]})"
        if node.name in OPERATORS:
            return f"({operands[0]} {OPERATORS[node.name]} {operands[1]})"
        if node.name in PREFIXES:
            return f"({PREFIXES[node.name]}{operands[0]})"
        if node.name in TWICE:
            return f"({NAMES[node.name].format(*operands)})"
        return f"{NAMES.get(node.name, node.name)}({', '.join(operands)})"


def _is_square(node: Node) -> bool:
    return node.name == "power" and node.operands[1].name == "number" and node.operands[1].value == 2.0


def _proved(nodes: list[Node], found: Mapping[Node, Bound | None]) -> set[Node]:
    """Nodes behind which nothing leaves the range of doubles."""
    proved: set[Node] = set()
    for node in nodes:
        inside = node.logical or found[node] is not None
        if inside and all(x in proved or (node.logical and x.name == "number") for x in node.operands):
            proved.add(node)
    return proved


def is_sum(node: Node) -> bool:
    """Whether a node is a rule, which is a loop."""
    return node.name == "integral"


def loops(nodes: list[Node]) -> dict[Node, Node]:
    """The variable of the integral inside which a node changes, for those that do."""
    found: dict[Node, Node] = {}
    variables = {node.operands[2] for node in nodes if is_sum(node)}
    for node in nodes:
        if node in variables:
            found[node] = node
        elif not is_sum(node) and (inside := [found[x] for x in node.operands if x in found]):
            found[node] = inside[0]
    return found
