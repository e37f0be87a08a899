"""The formulas over another array library, JAX say, as expressions that its gradients and compilers can follow.

A gradient through `where(r < a, f(r), 0)` is NaN outside the contact wherever that of f is, because both
branches are evaluated.  In `_programs/expressions` the arguments are moved into the branch before it is evaluated.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial, update_wrapper
from importlib import import_module
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from ._runtime.interface import programs
from ._runtime.symbols import SYMBOLS

__all__ = ["expression"]

PACKAGE = __name__.removesuffix("expressions")
STANDARD = {
    "absolute": "abs", "arctan": "atan", "arctan2": "atan2", "arcsinh": "asinh", "power": "pow",
}  # fmt: skip
"""Names of the array API standard that differ from NumPy's."""


def __dir__() -> list[str]:
    return __all__


def expression(function: Callable[..., Any], xp: Any) -> Callable[..., Any]:
    """A function of the catalogue over the arrays of `xp`, without checks, branches and results in place.

    An integral is a sum over 64 nodes, along an axis before the others, and of waves over four times as many; a root
    takes six steps of Newton where the bounds of its slope are known, else 26, and a stable radius 50.

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
        If `function` is none of the catalogue's or no expression, or needs a function that `xp` lacks.

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
    if not isinstance(function, FunctionType) or not function.__module__.startswith(PACKAGE):
        message = f"{name} is no function with a formula of its own; take one of axicontact.normal, as cone.pressure"
        raise TypeError(message)
    if function.__annotations__.get("return") != "Result":
        message = f"{function.__module__}.{name} gives several numbers; take one that gives one, as cone.pressure"
        raise TypeError(message)
    written = getattr(programs(function.__module__, "expressions."), name, None)
    if written is None:
        message = (
            f"{function.__module__}.{name} needs more than sums and steps to a root; it is no expression for "
            f"{getattr(xp, '__name__', xp)}, call the function itself or take another one, as cone.pressure"
        )
        raise TypeError(message)
    return _Expression(function, xp, written)


class _Expression:
    """A formula over the arrays of a library, called as the function it is that of."""

    def __init__(self, function: Callable[..., Any], xp: Any, written: Callable[..., Any]) -> None:
        self.function, self.xp = function, xp
        self.fields = function.__code__.co_varnames[: function.__code__.co_argcount]
        self.arguments = frozenset(written.__code__.co_varnames[1 : written.__code__.co_argcount])
        self.formula = partial(written, _Library(xp, sorted(_names(written))))
        update_wrapper(self, function)

    def __call__(self, *fields: Any, **keywords: Any) -> Any:
        arguments = dict(zip(self.fields, fields, strict=False)) | keywords
        left_out = [name for name in self.function.__kwdefaults__ or () if arguments.get(name) is None]
        arguments |= {name: arguments.get(SYMBOLS[name].otherwise) for name in left_out}
        return self.formula(**{name: value for name, value in arguments.items() if name in self.arguments})

    def __reduce__(self) -> Any:
        # neither a module nor its functions are pickled, but the name of the one makes the other
        if isinstance(self.xp, ModuleType):
            return _over, (self.function, self.xp.__name__)
        return expression, (self.function, self.xp)


def _over(function: Callable[..., Any], name: str) -> Callable[..., Any]:
    return expression(function, import_module(name))


@cache
def _names(written: FunctionType) -> frozenset[str]:
    """The functions of a library that a formula needs, and all it calls."""
    space, found, pending = written.__globals__, set[str](), [written.__code__]
    while pending:
        code = pending.pop()
        pending += [inner for inner in code.co_consts if hasattr(inner, "co_names")]
        found |= set(code.co_names)
    others = [space[name] for name in found if isinstance(space.get(name), FunctionType)]
    needed = {name for name in found if name not in space and hasattr(np, name)}
    return frozenset(needed).union({"asarray"}, *map(_names, others))


class _Library:
    """The functions of a library under NumPy's names."""

    def __init__(self, xp: Any, names: list[str]) -> None:
        for name in names:
            found = getattr(xp, name, None)
            found = getattr(xp, STANDARD.get(name, name), None) if found is None else found
            if found is None:
                library = getattr(xp, "__name__", repr(xp))
                message = (
                    f"{library} has no function {name}, which the formula needs; take a library with NumPy's names"
                )
                raise TypeError(message)
            setattr(self, name, found)
