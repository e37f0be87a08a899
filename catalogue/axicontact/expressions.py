"""The formulas over another array library, JAX say, as expressions that its gradients and compilers can follow.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  Here the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import wraps
from typing import Any

from ._trace import Node, trace

STANDARD = {
    "absolute": "abs", "arctan": "atan", "arctan2": "atan2", "arcsinh": "asinh", "power": "pow",
    "bitwise_and": "logical_and", "bitwise_or": "logical_or", "invert": "logical_not",
}  # fmt: skip
"""Names of the array API standard that differ from NumPy's."""
ASIDE = {"less": (0.5, 2.0), "less_equal": (0.5, 2.0), "greater": (2.0, 0.5), "greater_equal": (2.0, 0.5)}
"""x over y where the relation holds, and where it does not."""


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
        It takes the same arguments.  Arguments outside their domains are not noticed.  The precision is that
        of the arrays; lengths far from one may leave its range, unlike those of the function itself.

    Raises
    ------
    TypeError
        If `function` is none of the catalogue's, or evaluates a rule or an iteration and is no expression.

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
    names = private.__code__.co_varnames[: private.__code__.co_argcount]
    result = trace(private, names, ())
    if result is None:
        message = f"{public.__module__}.{name} is evaluated by a rule or an iteration; it is no expression for {xp!r}"
        raise TypeError(message)
    given = public.__code__.co_varnames[: public.__code__.co_argcount]

    @wraps(function)
    def call(*fields: Any, **keywords: Any) -> Any:
        arguments = dict(zip(given, fields, strict=False)) | keywords
        return _Branch(xp, arguments).value(result)

    return call


class _Branch:
    """The values of nodes for some arguments; a branch of a `where` has arguments of its own."""

    def __init__(self, xp: Any, arguments: Mapping[str, Any]) -> None:
        self.xp, self.arguments = xp, arguments
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
            return _function(self.xp, node.name)(*(self.value(x) for x in node.operands))
        condition = self.value(node.operands[0])
        branches = (self._moved(node.operands[0], condition, holds) for holds in (True, False))
        values = (branch.value(x) for branch, x in zip(branches, node.operands[1:], strict=True))
        return self.xp.where(condition, *values)

    def _moved(self, relation: Node, condition: Any, holds: bool) -> _Branch:
        """The branch, with an argument that is compared with another moved to where the branch applies."""
        if relation.name not in ASIDE or any(x.name != "argument" for x in relation.operands):
            return self
        x, y = (self.arguments[operand.value] for operand in relation.operands)
        aside = ASIDE[relation.name][0 if holds else 1] * y
        moved = self.xp.where(condition, x, aside) if holds else self.xp.where(condition, aside, x)
        return _Branch(self.xp, {**self.arguments, relation.operands[0].value: moved})


def _function(xp: Any, name: str) -> Callable[..., Any]:
    found: Callable[..., Any] | None = getattr(xp, name, None) or getattr(xp, STANDARD.get(name, name), None)
    if found is None:
        message = f"{xp!r} has no function {name}; the formula needs it"
        raise TypeError(message)
    return found
