"""What every function begins with: its arguments are checked, and its formula is evaluated over them.

A message says what is wrong, what is allowed, and what to do.  Plain numbers are evaluated by `math`, anything else
over arrays; float in and float out.  Checks in a loop and the way through `elementwise` take eight times as long as
the formula of the pressure under a cone; where a function first asks `Plain`, which has conditions and formula in one
function, it takes one and a half times as long.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, lru_cache, partial
from importlib import import_module
from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeGuard

import numpy as np

from .intervals import INSIDE

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Array: TypeAlias = Any
"""A float64 array, or a number that broadcasts with one; NumPy's stubs do not follow the mixture."""
Result: TypeAlias = Any
"""A float where every argument is a number, an array otherwise."""

KEPT = 64
"""Results that are kept of one function."""
BLOCK = 32768
"""Some arrays of this many numbers stay in the cache of a core."""
PROGRAMS = f"{__name__.split('._runtime')[0]}._programs"
"""What the build wrote for plain numbers and for blocks of arrays, in modules named as those it belongs to."""
INFINITE = np.array(np.inf).view(np.uint64)[()]
_plain: dict[Callable[..., Array], Callable[..., float | None]] = {}


def elementwise(function: Callable[..., Array], *fields: ArrayLike, unused: Any = (), **parameters: Any) -> Result:
    """Values of `function(*fields, **parameters)`; NaN where a field is negative or NaN, zero infinitely far away.

    They do not depend on the several that are `unused`, but broadcast with them.
    Divisions and roots outside a branch are silent.  A block in which a number leaves the range of doubles
    is evaluated again with numbers that have no such range.
    """
    formula = _plain.get(function) or _plain_formula(function)
    value = formula(*fields, **parameters)
    if value is not None and all([type(number) is float for number in unused]):
        return value
    # not imported with the package: it comes with the first call that needs it
    from .arrays.blocks import over_arrays

    return over_arrays(function, fields, unused, parameters)


def _plain_formula(function: Callable[..., Array]) -> Callable[..., float | None]:
    """The function over plain numbers, which gives None where it has no value to trust."""
    if isinstance(function, partial):
        formula = _plain.get(function.func) or _plain_formula(function.func)
        return formula if formula is nothing else partial(formula, **function.keywords)
    if not of_a_module(function):
        return nothing
    _plain[function] = getattr(programs(function.__module__), function.__name__.removeprefix("_"), nothing)
    return _plain[function]


class Kept:
    """A function that is asked again and again for the same numbers: of these, not of arrays, its results are kept."""

    def __init__(self, function: Callable[..., Any]) -> None:
        self.function, self.kept = function, lru_cache(KEPT)(self._of)

    def __call__(self, *given: Any) -> Any:
        numbers = all([isinstance(own, (float, int, tuple)) for own in given])
        return self.kept(*given) if numbers else self.function(*given)

    def _of(self, *given: Any) -> Any:
        # a power of Python's zero is an error where one of NumPy's is infinite
        known = [np.float64(own) if isinstance(own, float) else own for own in given]
        with np.errstate(all="ignore"):
            result = self.function(*known)
        if type(result) is tuple:
            return tuple([float(own) if isinstance(own, float) else own for own in result])
        return result if isinstance(result, tuple) else float(result)


NEAR, WIDE = 1e-12, 1e12


def ordinary(*given: float) -> bool:
    """Whether arguments leave the range nowhere: where a body over plain numbers has no value, there is none."""
    return all([NEAR < abs(own) < WIDE or own == 0.0 for own in given])


def largest(block: Array) -> float:
    """The largest value, infinity if one is not finite or has its sign set: the bits of doubles have their order."""
    bits = np.maximum.reduce(block.view(np.uint64))
    return float(bits.view(np.float64)) if bits < INFINITE else np.inf


def either(condition: Array, x: Callable[[], Array], y: Callable[[], Array]) -> Array:
    """x() where the condition holds and y() elsewhere; what is chosen nowhere is not asked for."""
    if np.all(condition):
        return x()
    return np.where(condition, x(), y()) if np.any(condition) else y()


def of_a_module(function: Callable[..., Any]) -> TypeGuard[FunctionType]:
    """Whether it is one that the build saw: what is bound to arguments or made in a call is another one every time."""
    return isinstance(function, FunctionType) and function.__qualname__ == function.__name__


@cache
def programs(module: str, kind: str = "") -> ModuleType | None:
    """What the build wrote for the functions of a module; None if nothing."""
    path = module.removeprefix(f"{PROGRAMS.removesuffix('._programs')}.")
    try:
        return import_module(f"{PROGRAMS}.{kind}{path}")
    except ModuleNotFoundError as error:
        if error.name is None or not error.name.startswith(PROGRAMS):
            raise
        return None


def nothing(*fields: Any, **parameters: Any) -> None:
    """In the place of a formula for plain numbers where there is none."""


class Plain:
    """The functions of a module over plain numbers: each gives None where the function itself has to see to it.

    They are imported with the first call of one, not with the module.  Until then there is in the place of each what
    imports them: looking for a missing attribute would cost every call as much as the formula of a force.
    """

    if TYPE_CHECKING:

        def __getattr__(self, name: str) -> Callable[..., float | None]: ...

    def __init__(self, module: str, names: Sequence[str]) -> None:
        self._module = module
        for name in names:
            setattr(self, name, partial(self._first, name))

    def _first(self, name: str, *arguments: Any) -> float | None:
        for own in [own for own in vars(self) if own != "_module"]:
            setattr(self, own, getattr(programs(self._module), own, nothing))
        value: float | None = getattr(self, name)(*arguments)
        return value


def require(**parameters: ArrayLike) -> None:
    """Check parameters against the domains of the notation.

    Raises
    ------
    ValueError
        With the parameter, its value, the rule and what to use instead, if a value is outside its domain or not finite.
    TypeError
        If a value is not a real number or an array of real numbers.
    """
    for name, value in parameters.items():
        low, high = INSIDE[name]
        if type(value) is float and low < value < high:
            continue
        from .symbols import SYMBOLS

        domain = SYMBOLS[name]
        letter = domain.letter or name
        array = numbers(letter, value)
        above = (low <= array) if domain.closed == "low" else (low < array)
        below = (array <= high) if domain.closed == "high" else (array < high)
        inside = np.isfinite(array) & above & below
        if not inside.all():
            wrong = float(array[~inside].flat[0])
            message = f"{letter} = {wrong!r} is outside {domain.rule}; {letter} is the {domain.meaning}"
            raise ValueError(f"{message}; {domain.instead}" if domain.instead else message)


def require_order(holds: ArrayLike, relation: str, reason: str, **values: ArrayLike) -> None:
    """Raise ValueError with the values and the reason if a relation between parameters is violated."""
    if not np.all(holds):
        given = ", ".join(f"{name} = {_shown(value)}" for name, value in values.items())
        message = f"{given}: {relation} is violated; {reason}"
        raise ValueError(message)


def _shown(value: ArrayLike) -> str:
    """The numbers in a message: all of a few, the first ones of many."""
    array = np.asarray(value)
    if array.size <= 8:
        return repr(array.tolist())
    return f"[{', '.join(map(repr, array.ravel()[:3].tolist()))}, ...], {array.size} numbers"


def require_reach(a: ArrayLike, b: ArrayLike, instead: str = "normal.flat_punch") -> None:
    """Raise ValueError if not one contact radius reaches beyond the flat face of radius b, where the contact starts.

    Where some do, the others give NaN like every field value outside its range.
    """
    if type(a) is float and type(b) is float and a >= b:
        return
    radius, face = numbers("a", a), numbers("b", b)
    if radius.size and face.size and radius.flat[0] >= face.flat[0]:
        return
    radius, face = np.broadcast_arrays(radius, face)
    if radius.size and np.all((radius >= 0.0) & (radius < face)):
        message = (
            f"a = {float(radius.flat[0])!r} is below b = {float(face.flat[0])!r}: the contact starts at a = b, "
            f"the edge of the flat face; use {instead} for a smaller face"
        )
        raise ValueError(message)


def require_coefficients(values: ArrayLike) -> tuple[float, ...]:
    """The coefficients A_1, A_2, ... of a polynomial: none negative, not all zero."""
    array = np.atleast_1d(numbers("A", values))
    if array.ndim != 1 or not np.isfinite(array).all() or (array < 0.0).any() or not (array > 0.0).any():
        message = f"A = {values!r} must be a sequence of coefficients of r, r^2, ..., none negative and not all zero"
        raise ValueError(message)
    return tuple(array.tolist())


def numbers(name: str, value: ArrayLike, kinds: str = "iuf") -> Array:
    """The value of an argument as an array of doubles.

    Raises
    ------
    TypeError
        If it is not a real number or an array of real numbers, or carries a unit or a mask.
    """
    if type(value) is not np.ndarray:
        # np.asarray takes the number of a quantity and drops its unit
        from .bare import require_bare

        require_bare(name, value)
    array = np.asarray(value)
    if array.dtype.kind not in kinds:
        message = f"{name} must be a real number or an array of real numbers, not {value!r}"
        raise TypeError(message)
    return array.astype(np.float64, copy=False)
