"""Evaluation over arrays: broadcasting, blocks that stay in cache, numbers without a range where doubles end."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np

from ..interface import BLOCK, Array, Result, elementwise, of_a_module, programs
from ..interface import numbers as doubles

POSITIONS = ("r", "x")
"""First arguments of fields, which vanish at infinity, but for those of the body itself, its profile."""
REAL = "biuf"
"""Kinds of NumPy's types that a field may have."""
_programs: dict[Any, Program | None] = {}


class Program(NamedTuple):
    """A formula for blocks of arrays, as the build wrote it: NumPy's functions into a few arrays that stay in cache.

    `prepare(*numbers)` gives what `block(out, *arrays, *prepared, *scratch, *masks, *filled)` needs.
    A FloatingPointError says that the block needs the body itself, as it does for fields that are not positive
    and finite; a program for `positive` arguments asks this of all its arrays, and its caller of the numbers.
    """

    arrays: tuple[str, ...]
    """The arguments that are arrays; the others are numbers."""
    prepare: Callable[..., tuple[Any, ...]]
    block: Callable[..., None]
    scratch: int = 0
    masks: int = 0
    filled: tuple[float, ...] = ()
    """Arrays of these numbers: NumPy's maximum of two arrays costs half of that with a number."""
    positive: bool = False


def over_arrays(
    function: Callable[..., Array], fields: tuple[Any, ...], unused: tuple[Any, ...], parameters: dict[str, Any]
) -> Result:
    """What `elementwise` returns where not all arguments are plain numbers, or one is far out."""
    if unused:
        result = elementwise(function, *fields, **parameters)
        shape = np.broadcast_shapes(*(np.shape(value) for value in (result, *unused)))
        return result if shape == np.shape(result) else np.broadcast_to(result, shape).copy()
    names = (*_arguments(function)[: len(fields)], *parameters)
    given = zip(names, (*fields, *parameters.values()), strict=True)
    values: list[Array] = [value if type(value) is float else doubles(name, value, REAL) for name, value in given]
    several = tuple([type(value) is not float and value.size != 1 for value in values])
    if any(several):
        return _evaluated(function, names, len(fields), values, several)
    # one point: its fields as arrays
    count = len(fields)
    points = [np.array([_number(value)]) for value in values[:count]] + [_number(value) for value in values[count:]]
    result = _evaluated(function, names, count, points, (True,) * count + (False,) * len(parameters))
    dimensions = max([0 if type(value) is float else value.ndim for value in values], default=0)
    return result.reshape((1,) * dimensions) if dimensions else float(result[0])


def _evaluated(
    function: Callable[..., Array],
    names: tuple[str, ...],
    count: int,
    values: list[Array],
    several: tuple[bool, ...],
) -> Array:
    """The values for arrays, of one size when broadcast, and for numbers where it is not `several`."""
    arrays = [value for value, more in zip(values, several, strict=True) if more]
    # as np.float64: a product of two floats of Python overflows in silence
    numbers = [np.float64(_number(value)) for value, more in zip(values, several, strict=True) if not more]
    found, out = _program(function, count, names, several), np.empty(_shape(values))
    if not all(number >= 0.0 for number in numbers[: count - sum(several[:count])]):
        out.fill(np.nan)
        return out
    with np.errstate(over="raise", under="raise", divide="ignore", invalid="ignore"):
        # without scratch a step costs less than its call, and a rule at many radii is one polynomial for all of them
        size = BLOCK if found is not None and found.scratch else 2 * BLOCK
        far = not several[0] and numbers[0] == np.inf
        fill = None if found is None or far else _filling(found, several, numbers, min(out.size, size))
        fields = sum(several[:count])
        for part, *blocks in _blocks(out, arrays, size):
            if fill is not None and fill(part, *blocks):
                continue
            rest, more = iter(numbers), iter(blocks)
            _by_body(function, count, names[count:], [next(more if is_array else rest) for is_array in several], part)
            for block in blocks[:fields]:
                part[~(block >= 0.0)] = np.nan
    return out


def _program(
    function: Callable[..., Array], count: int, names: tuple[str, ...], several: tuple[bool, ...]
) -> Program | None:
    """What was written for these arrays, or for arrays alone, where there is either."""
    if not of_a_module(function):
        return None
    key = (function, count, names, several)
    if key not in _programs:
        written = getattr(programs(function.__module__), "BLOCKS", {}).get((function.__name__, count, *names), {})
        arrays = tuple([name for name, more in zip(names, several, strict=True) if more])
        found = written.get(arrays) or written.get(names)
        _programs[key] = found and Program(*found)
    return _programs[key]


def _vanishes(function: Callable[..., Array]) -> bool:
    """Whether it is a field of a position that is zero infinitely far away."""
    return _arguments(function)[0] in POSITIONS and "profile" not in _behind(function).__name__


def _arguments(function: Callable[..., Array]) -> tuple[str, ...]:
    names: tuple[str, ...] = _behind(function).__code__.co_varnames
    return names


def _behind(function: Any) -> Any:
    """The function itself, of which a polynomial's is given with its coefficients."""
    return getattr(function, "func", function)


def _number(value: Array) -> float:
    return value if type(value) is float else value.item()


def _shape(values: list[Array]) -> tuple[int, ...]:
    arrays = [value for value in values if type(value) is not float]
    if not arrays:
        return (1,)
    return arrays[0].shape if len(arrays) == 1 else np.broadcast(*arrays).shape


def _by_body(
    function: Callable[..., Array], count: int, keywords: tuple[str, ...], given: list[Array], part: Array
) -> None:
    """A block by the function itself."""
    infinite = given[0] == np.inf if _vanishes(function) else np.False_
    if np.any(infinite):
        # bodies have a value on the axis, not at infinity
        given = [np.where(infinite, 0.0, given[0]), *given[1:]]
    # np.broadcast_to would leave strides of zero, which NumPy's loops are slower for
    fields = [value if np.ndim(value) else np.full(part.shape, value) for value in given[:count]]
    parameters = dict(zip(keywords, given[count:], strict=True))
    try:
        part[...] = function(*fields, **parameters)
    except FloatingPointError:
        with np.errstate(all="ignore"):
            part[...] = _unbounded(function, fields, parameters)
    part[infinite & ~np.isnan(part)] = 0.0


def _filling(found: Program, several: tuple[bool, ...], numbers: list[Any], size: int) -> Callable[..., bool] | None:
    """The program with its numbers, which says whether a block stayed in the range of doubles; None if they do not."""
    # allocated for every call: threads share nothing
    spread: list[Array | None] = []
    if len(found.arrays) > sum(several):
        known = iter(numbers)
        spread = [None if more else np.full(size, next(known)) for more in several]
    try:
        results = found.prepare(*([] if spread else numbers))
    except FloatingPointError:
        return None
    if found.positive and not all([0.0 < value < np.inf for value in results]):
        return None
    prepared = [np.asarray(value) for value in results]
    work = [np.empty(size) for _ in range(found.scratch)] + [np.empty(size, dtype=bool) for _ in range(found.masks)]
    work += [np.full(size, value) for value in found.filled]

    def fill(out: Array, *arrays: Array) -> bool:
        whole = out.size == size
        places = work if whole else [place[: out.size] for place in work]
        if spread:
            blocks = iter(arrays)
            arrays = tuple([next(blocks) if own is None else own if whole else own[: out.size] for own in spread])
        try:
            found.block(out, *arrays, *prepared, *places)
        except FloatingPointError:
            return False
        return True

    return fill


def _blocks(out: Array, arrays: list[Array], size: int) -> Iterator[tuple[Array, ...]]:
    """Parts of the result with the same parts of the arrays, one-dimensional."""
    if all(value.shape == out.shape and value.flags.c_contiguous for value in arrays):
        if out.ndim == 1 and 0 < out.size <= size:
            yield (out, *arrays)
            return
        flat = [value.reshape(-1) for value in (out, *arrays)]
        for first in range(0, out.size, size):
            yield tuple([value[first : first + size] for value in flat])
        return
    flags: list[Any] = [["writeonly"], *([["readonly"]] * len(arrays))]
    with np.nditer([out, *arrays], ["external_loop", "buffered", "zerosize_ok"], flags, buffersize=size) as steps:
        if out.size:
            yield from steps


def _unbounded(function: Callable[..., Array], fields: list[Array], parameters: dict[str, Any]) -> Array:
    from .extended import extended

    try:
        everything = {name: extended(value) for name, value in parameters.items()}
        return np.asarray(function(*(extended(value) for value in fields), **everything))
    except (TypeError, AttributeError):
        # a body that needs more of NumPy than such numbers know
        return function(*fields, **parameters)
