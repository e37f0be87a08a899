"""The names of parameters and fields in the emitted functions."""

from __future__ import annotations

import sympy as sp

from . import notation as nt

LETTERS = {
    nt.time: "t", nt.relaxation: "tau", nt.sigma: "s", nt.young_1: "E_1", nt.young_2: "E_2",
}  # fmt: skip
"""Symbols whose letter in the interface is also that of another one."""


def name_of(symbol: sp.Symbol | sp.IndexedBase) -> str:
    """The name in the interface."""
    if symbol in LETTERS:
        return LETTERS[symbol]
    name = str(getattr(symbol, "label", symbol))
    return (nt.known(name) and nt.describe(name).letter) or name
