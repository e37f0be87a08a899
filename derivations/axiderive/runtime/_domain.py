"""Checks of the keyword parameters: what is wrong, what is allowed, what to do."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._elementwise import Array
from ._intervals import INSIDE

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


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
        from ._symbols import SYMBOLS

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
        from ._bare import require_bare

        require_bare(name, value)
    array = np.asarray(value)
    if array.dtype.kind not in kinds:
        message = f"{name} must be a real number or an array of real numbers, not {value!r}"
        raise TypeError(message)
    return array.astype(np.float64, copy=False)
