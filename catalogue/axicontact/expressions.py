"""The formulas over another array library, JAX say, as expressions that its gradients and compilers can follow.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  Here the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import update_wrapper
from importlib import import_module
from types import ModuleType
from typing import Any

from ._runtime.programs.trace import Node, needed, trace

__all__ = ["expression"]

STANDARD = {
    "absolute": "abs", "arctan": "atan", "arctan2": "atan2", "arcsinh": "asinh", "power": "pow",
    "bitwise_and": "logical_and", "bitwise_or": "logical_or", "invert": "logical_not",
}  # fmt: skip
"""Names of the array API standard that differ from NumPy's."""
RULES = frozenset(("integral", "unless"))
"""Operations of a graph that are loops of the package, or hold in the branch that is mostly met alone."""
ASIDE = {"less": (0.5, 2.0), "less_equal": (0.5, 2.0), "greater": (2.0, 0.5), "greater_equal": (2.0, 0.5)}
"""x over y where the relation holds, and where it does not."""


def __dir__() -> list[str]:
    return __all__


def expression(function: Callable[..., Any], xp: Any) -> Callable[..., Any]:
    """A function of the catalogue over the arrays of `xp`, without checks, loops and results in place.

    Parameters
    ----------
    function : callable
        A public function of one of the modules, as `axicontact.normal.cone.pressure`.
    xp : module
        The array library: `jax.numpy`, or another with NumPy's names or those of the array API standard.

    Returns
    -------
    callable
        It takes the same arguments, and can be pickled.  Arguments outside their domains are not noticed.  The
        precision is that of the arrays; lengths far from one may leave its range, unlike those of the function itself.

    Raises
    ------
    TypeError
        If `function` is none of the catalogue's, evaluates a rule or an iteration and is no expression, or needs
        a function that `xp` lacks.

    Examples
    --------
    >>> import numpy as np
    >>> from axicontact.expressions import expression
    >>> from axicontact.normal import cone
    >>> pressure = expression(cone.pressure, np)
    >>> pressure(np.array([0.3, 1.5]), 1.0, theta=0.35, E_star=2.0).round(6).tolist()
    [0.683998, 0.0]
    """
    name = getattr(function, "__name__", repr(function))
    public = getattr(function, "__wrapped__", function)
    private = getattr(public, "__globals__", {}).get(f"_{name}")
    if private is None:
        message = f"{name} is no function with a formula of its own; take one of axicontact.normal, as cone.pressure"
        raise TypeError(message)
    if public.__annotations__.get("return") != "Result":
        message = f"{public.__module__}.{name} gives several numbers; take one that gives one, as cone.pressure"
        raise TypeError(message)
    names = private.__code__.co_varnames[: private.__code__.co_argcount]
    result = trace(private, names, ())
    if result is None or any(node.name in RULES for node in needed(result)):
        message = (
            f"{public.__module__}.{name} is evaluated by a rule or an iteration; it is no expression for "
            f"{getattr(xp, '__name__', xp)}, call the function itself or take one in closed form, as cone.pressure"
        )
        raise TypeError(message)
    return _Expression(function, xp, result, public.__code__.co_varnames[: public.__code__.co_argcount])


class _Expression:
    """A graph over the arrays of a library, called as the function it is that of."""

    def __init__(self, function: Callable[..., Any], xp: Any, result: Node, fields: tuple[str, ...]) -> None:
        self.function, self.xp, self.result, self.fields = function, xp, result, fields
        names = {node.name for node in needed(result) if node.operands}
        self.functions = {name: _function(xp, name) for name in sorted(names)}
        update_wrapper(self, function)

    def __call__(self, *fields: Any, **keywords: Any) -> Any:
        arguments = dict(zip(self.fields, fields, strict=False)) | keywords
        return _Branch(self.functions, arguments).value(self.result)

    def __reduce__(self) -> Any:
        # neither a module nor a graph with its functions is pickled, but the name of the one makes the other
        if isinstance(self.xp, ModuleType):
            return _over, (self.function, self.xp.__name__)
        return expression, (self.function, self.xp)


def _over(function: Callable[..., Any], name: str) -> Callable[..., Any]:
    return expression(function, import_module(name))


class _Branch:
    """The values of nodes for some arguments; a branch of a `where` has arguments of its own."""

    def __init__(self, functions: Mapping[str, Callable[..., Any]], arguments: Mapping[str, Any]) -> None:
        self.functions, self.arguments = functions, arguments
        self._known: dict[int, Any] = {}

    def value(self, node: Node) -> Any:
        if node.order not in self._known:
            self._known[node.order] = self._evaluated(node)
        return self._known[node.order]

    def _evaluated(self, node: Node) -> Any:
        if node.name == "number":
            return node.value
        if node.name == "argument":
            return self.arguments[node.value]
        if node.name != "where":
            return self.functions[node.name](*(self.value(x) for x in node.operands))
        condition = self.value(node.operands[0])
        branches = (self._moved(node.operands[0], condition, holds) for holds in (True, False))
        values = (branch.value(x) for branch, x in zip(branches, node.operands[1:], strict=True))
        return self.functions["where"](condition, *values)

    def _moved(self, relation: Node, condition: Any, holds: bool) -> _Branch:
        """The branch, with an argument that is compared with another moved to where the branch applies."""
        if relation.name not in ASIDE or any(x.name != "argument" for x in relation.operands):
            return self
        x, y = (self.arguments[operand.value] for operand in relation.operands)
        aside = ASIDE[relation.name][0 if holds else 1] * y
        where = self.functions["where"]
        moved = where(condition, x, aside) if holds else where(condition, aside, x)
        return _Branch(self.functions, {**self.arguments, relation.operands[0].value: moved})


def _function(xp: Any, name: str) -> Callable[..., Any]:
    found: Callable[..., Any] | None = getattr(xp, name, None) or getattr(xp, STANDARD.get(name, name), None)
    if found is None:
        library = getattr(xp, "__name__", repr(xp))
        message = f"{library} has no function {name}, which the formula needs; take a library with NumPy's names"
        raise TypeError(message)
    return found
