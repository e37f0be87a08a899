"""Evaluation of a formula: plain numbers by `math`, anything else over arrays; float in and float out."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeAlias

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
    from ._arrays import over_arrays

    return over_arrays(function, fields, unused, parameters)


def _compiled_formula(function: Callable[..., Array]) -> Callable[..., float | None] | None:
    """The function over plain numbers."""
    from ._plain import plain

    formula = plain(function)
    if formula is not None:
        _formulas[function] = formula
    return formula
