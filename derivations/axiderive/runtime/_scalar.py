"""Plain numbers in bodies without a graph, those that iterate: the same code with `math` in the place of NumPy."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dis import get_instructions
from operator import not_
from types import CodeType, FunctionType, ModuleType, SimpleNamespace
from typing import Any

import numpy as np

PACKAGE = __name__.rpartition(".")[0]
NEEDS_ARRAYS = frozenset(
    (
        "integral",
        "integral_by_panels",
        "in_groups",
        "pressure_integral",
        "gauss_legendre",
        "enumerate",
    )
)
"""Names that a body may not refer to: rules with nodes along an axis, and sums over coefficients."""


def _sqrt(x: float) -> float:
    return math.sqrt(x) if x >= 0.0 else math.nan


MATH = SimpleNamespace(
    pi=math.pi, e=math.e, inf=math.inf, nan=math.nan, float64=float,
    sqrt=_sqrt, cbrt=math.cbrt, exp=math.exp, expm1=math.expm1, log=math.log, log1p=math.log1p,
    sin=math.sin, cos=math.cos, tan=math.tan, arctan=math.atan, arctan2=math.atan2, arctanh=math.atanh,
    sinh=math.sinh, cosh=math.cosh, tanh=math.tanh, arcsinh=math.asinh,
    abs=abs, minimum=min, maximum=max, isfinite=math.isfinite, any=bool, all=bool, count_nonzero=bool,
    # bodies write it out: ~True is -2, and an error from Python 3.16 on
    logical_not=not_,
    where=lambda condition, x, y: x if condition else y,
    asarray=lambda x, dtype=None: x, full_like=lambda x, value: value,
    ones_like=lambda x: 1.0, zeros_like=lambda x: 0.0,
)  # fmt: skip
_namespaces: dict[int, dict[str, Any]] = {}


def scalar(function: FunctionType) -> Callable[..., float] | None:
    """The function of a module over plain numbers, or None if it needs arrays."""
    if _needs_arrays(function, set()):
        return None
    twin: Callable[..., float] = _namespace(function.__globals__)[function.__name__]
    return twin


def _needs_arrays(function: FunctionType, seen: set[FunctionType]) -> bool:
    seen.add(function)
    names = _names(function.__code__)
    if names & NEEDS_ARRAYS or any(_of_arrays(*attribute) for attribute in _attributes(function.__code__)):
        return True
    if any(step.opname == "IMPORT_NAME" for step in get_instructions(function.__code__)):
        return True  # what it imports has NumPy for `np`
    spaces = [function.__globals__, *(vars(m) for n in names if _own(m := function.__globals__.get(n), ModuleType))]
    called: list[Any] = [space.get(name) for space in spaces for name in names]
    return any(_needs_arrays(f, seen) for f in called if _own(f, FunctionType) and f not in seen)


def _names(code: CodeType) -> set[str]:
    inner = (_names(constant) for constant in code.co_consts if isinstance(constant, CodeType))
    return set(code.co_names).union(*inner)


def _attributes(code: CodeType) -> Iterator[tuple[str, str]]:
    """What attributes are looked up, each behind the global name it is one of, or behind none."""
    owner = ""
    for step in get_instructions(code):
        if step.opname in ("LOAD_ATTR", "LOAD_METHOD"):
            yield owner, step.argval
        owner = step.argval if step.opname == "LOAD_GLOBAL" else ""
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _attributes(constant)


def _of_arrays(owner: str, name: str) -> bool:
    """Whether plain numbers have nothing of that name: `sum` is one of NumPy, and of Python without `np` before it."""
    if owner == "np":
        return not hasattr(MATH, name)
    return hasattr(np.ndarray, name) and not any(hasattr(kind, name) for kind in (float, list, tuple))


def _own(value: Any, kind: type) -> bool:
    name = getattr(value, "__module__" if kind is FunctionType else "__name__", None)
    return isinstance(value, kind) and str(name).startswith(PACKAGE)


def _namespace(names: dict[str, Any]) -> dict[str, Any]:
    """The global names of a module with `math` for `np` and every function of the package bound to such names."""
    known = _namespaces.get(id(names))
    if known is not None:
        return known
    twin = _namespaces[id(names)] = {**names, "np": MATH}
    for name, value in names.items():
        if _own(value, FunctionType) and value.__closure__ is None:
            space = twin if value.__globals__ is names else _namespace(value.__globals__)
            twin[name] = FunctionType(value.__code__, space, value.__name__, value.__defaults__)
        elif _own(value, ModuleType):
            twin[name] = SimpleNamespace(**_namespace(vars(value)))
    return twin
