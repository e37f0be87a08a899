"""Evaluation over arrays: broadcasting, blocks that stay in cache, float in and float out."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

from ._scalar import PLAIN, scalar

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Array: TypeAlias = Any
"""A float64 array, or a number that broadcasts with one; NumPy's stubs do not follow the mixture."""
Result: TypeAlias = Any
"""A float where every argument is a number, an array otherwise."""

BLOCK = 16384
SMALL, LARGE = 1e-30, 1e30
"""Plain numbers between these keep every product of a formula in range, unless the result itself is far out."""
LEAST, GREATEST = 1e-200, 1e200


def elementwise(function: Callable[..., Array], *fields: ArrayLike, **parameters: ArrayLike) -> Result:
    """Values of `function(*fields, **parameters)`; NaN where a field is negative or NaN.

    Formulas are evaluated everywhere and the branch that applies is chosen
    afterwards, hence the silence about divisions and roots outside a branch.
    A block in which a number leaves the range of doubles is evaluated again
    with numbers that have no such range.
    """
    for number in (*fields, *parameters.values()):
        if type(number) is not float or not SMALL < number < LARGE:
            break
    else:
        plain = PLAIN.get(function) or scalar(function)
        if plain is not None:
            try:
                value = plain(*fields, **parameters)
            except (ArithmeticError, ValueError):
                value = 0.0
            if LEAST < value < GREATEST or LEAST < -value < GREATEST:
                return value
    arguments = [_real(value) for value in fields]
    names = [name for name, value in parameters.items() if np.ndim(value) > 0]
    fixed = {name: np.float64(value) for name, value in parameters.items() if name not in names}  # type: ignore[arg-type]
    arguments += [_real(parameters[name]) for name in names]
    # a product of two floats of Python overflows in silence, hence np.float64
    block = partial(_block, function, len(fields), names, fixed)
    if all(value.ndim == 0 for value in arguments):
        return float(block(*(value.reshape(1) for value in arguments)).flat[0])
    whole = np.broadcast(*arguments)
    if whole.size <= BLOCK:
        return block(*(np.broadcast_to(value, whole.shape).ravel() for value in arguments)).reshape(whole.shape)
    return _by_blocks(block, arguments)


def _block(
    function: Callable[..., Array], count: int, names: list[str], fixed: dict[str, np.float64], *values: Array
) -> Array:
    fields, given = values[:count], dict(zip(names, values[count:], strict=True))
    try:
        with np.errstate(over="raise", under="raise", divide="ignore", invalid="ignore"):
            result = function(*fields, **fixed, **given)
    except FloatingPointError:
        with np.errstate(all="ignore"):
            result = _unbounded(function, fields, fixed | given)
    if values and np.shape(result) != values[0].shape:
        result = np.broadcast_to(result, values[0].shape)
    for value in fields:
        # min() is NaN where a field is, and the comparison then fails too
        if not value.size or not value.min() >= 0.0:
            result = np.where(value >= 0.0, result, np.nan)
    return np.asarray(result, dtype=np.float64)


def _unbounded(function: Callable[..., Array], fields: tuple[Array, ...], parameters: dict[str, Any]) -> Array:
    from ._extended import extended

    try:
        everything = {name: extended(value) for name, value in parameters.items()}
        return np.asarray(function(*(extended(value) for value in fields), **everything))
    except (TypeError, AttributeError):
        # a body that needs more of NumPy than such numbers know
        return function(*fields, **parameters)


def _by_blocks(block: Callable[..., Array], arguments: list[Array]) -> Array:
    flags: list[Any] = [["readonly"]] * len(arguments) + [["writeonly", "allocate"]]
    with np.nditer(
        [*arguments, None], ["external_loop", "buffered"], flags, op_dtypes=[np.float64] * len(flags), buffersize=BLOCK
    ) as steps:
        for *values, out in steps:
            out[...] = block(*values)
        result: Array = steps.operands[-1]
        return result


def _real(value: ArrayLike) -> Array:
    array = np.asarray(value)
    if array.dtype.kind not in "biuf":
        message = f"a real number or an array of real numbers is needed, not {value!r}"
        raise TypeError(message)
    return array.astype(np.float64, copy=False)
