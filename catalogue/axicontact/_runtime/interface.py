"""What every function begins with: its arguments are checked, and its formula is evaluated over them.

A message says what is wrong, what is allowed, and what to do.  Plain numbers are evaluated by `math`, anything else
over arrays; float in and float out.  Checks in a loop and the way through `elementwise` take eight times as long as
the formula of the pressure under a cone; with condition and formula compiled into one function by `with_math` it takes
one and a half times as long.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import update_wrapper
from types import FunctionType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar, cast

import numpy as np

from .intervals import INSIDE

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Array: TypeAlias = Any
"""A float64 array, or a number that broadcasts with one; NumPy's stubs do not follow the mixture."""
Result: TypeAlias = Any
"""A float where every argument is a number, an array otherwise."""

SMALL, LARGE = 1e-30, 1e30
"""Plain numbers between these take the short way."""
BLOCK = 32768
"""Some arrays of this many numbers stay in the cache of a core."""
_formulas: dict[Callable[..., Array], Callable[..., float | None]] = {}


def elementwise(function: Callable[..., Array], *fields: ArrayLike, unused: Any = (), **parameters: Any) -> Result:
    """Values of `function(*fields, **parameters)`; NaN where a field is negative or NaN, zero infinitely far away.

    They do not depend on the several that are `unused`, but broadcast with them.
    Divisions and roots outside a branch are silent.  A block in which a number leaves the range of doubles
    is evaluated again with numbers that have no such range.
    """
    for number in (*fields, *parameters.values(), *unused):
        if type(number) is not float or not SMALL < number < LARGE:
            break
    else:
        formula = _formulas.get(function) or _compiled_formula(function)
        if formula is not None:
            value = formula(*fields, **parameters)
            if value is not None:
                return value
    # not imported with the package, nor is what compiles: each comes with the first call that needs it
    from .programs.arrays import over_arrays

    return over_arrays(function, fields, unused, parameters)


def _compiled_formula(function: Callable[..., Array]) -> Callable[..., float | None] | None:
    """The function over plain numbers."""
    from .programs.plain import plain

    formula = plain(function)
    if formula is not None:
        _formulas[function] = formula
    return formula


Function = TypeVar("Function", bound=Callable[..., Any])


def with_math(function: Function) -> Function:
    """The function, with a short way for floats of ordinary size inside their domains.

    The formula is the private function of the same name.  Whatever is wrong, not a float or far out is left
    to the function itself: so are results that may have left the range of doubles on the way.
    """

    def begin() -> None:
        # compiled when first called: a millisecond for each function is much for an import
        from .programs.plain import call_text

        text, names = call_text(function.__code__, function.__globals__[f"_{function.__name__}"])
        space.update(names)
        exec(text, space)  # names of our own functions, no text of anyone else
        call.__code__ = space["call"].__code__

    space: dict[str, Any] = {"function": function, "begin": begin}
    call = FunctionType(_first_call.__code__, space)
    return cast("Function", update_wrapper(call, function))


def _first_call(*fields: Any, **keywords: Any) -> Any:
    begin()  # type: ignore[name-defined]  # noqa: F821 - runs among the names of `with_math`
    return function(*fields, **keywords)  # noqa: F821


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
