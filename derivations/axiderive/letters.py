"""The names of parameters and fields in the emitted functions."""

from __future__ import annotations

import sympy as sp

from . import notation as nt


def name_of(symbol: sp.Symbol | sp.IndexedBase) -> str:
    """The name in the interface: the letter that its record says, where that is another than its own name."""
    name = str(getattr(symbol, "label", symbol))
    return (nt.known(name) and nt.describe(name).letter) or name
