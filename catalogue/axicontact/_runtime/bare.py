"""Arguments that are more than numbers: quantities and masked arrays, of which `np.asarray` takes the data alone.

A quantity of 1 mm would count as 1 m.  What says that it has a unit is refused, whatever library it comes from.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from .symbols import UNITS

BARE = frozenset((float, int, bool, np.ndarray, np.float64, np.float32, np.int64, np.int32, np.bool_))
"""Types that have neither; of others the attributes are asked."""
SIGNS = ("units", "unit", "magnitude", "dimensionality", "dimensions")
"""Attributes of quantities: those of pint, astropy, unyt, quantities and brian2 have one of them at least."""


def require_bare(name: str, value: Any) -> None:
    """Raise TypeError if a value, or a member of a sequence, carries a unit or a mask.

    A text in the place of the unit is no more than a remark, as in the attributes of xarray: it may be the right one.
    """
    if type(value) in BARE:
        return
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
        if not BARE.issuperset(map(type, value)):
            for member in value:
                require_bare(name, member)
        return
    unit = UNITS.get(name)
    found = [sign for sign in (getattr(value, own, None) for own in SIGNS) if sign is not None]
    if found and not all(isinstance(sign, str) and sign == unit for sign in found):
        message = f"{name} = {_short(value)} carries a unit, which would be lost; {_in_unit(name, value, unit)}"
        raise TypeError(message)
    if hasattr(value, "filled") and hasattr(value, "mask"):
        message = (
            f"{name} = {_short(value)} carries a mask, which would be lost; "
            f"give {name}.filled(np.nan), or {name}.compressed() without what is masked"
        )
        raise TypeError(message)


def _in_unit(name: str, value: Any, unit: str | None) -> str:
    """What to give instead; pint and astropy are told by the names of their attributes."""
    if unit is None:
        return "give its number in SI units"
    if "^" in unit:
        return f"give its number in {unit}"
    text = "" if unit == "1" else unit
    number = f'to_value("{text}")' if hasattr(value, "to_value") else f'to("{text}").magnitude'
    return f"give its number {f'in {unit}' if text else 'alone'}, {name}.{number}"


def _short(value: Any) -> str:
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else f"{text[:77]}..."
