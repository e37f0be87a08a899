"""Functions that a rival is given in closed form, one expression between two breaks after the other."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp
import numpy as np
import sympy as sp

from ..abel.masters import MASTERS
from .special_functions import FUNCTIONS, Array

Function = Callable[..., Any]


@dataclass(frozen=True)
class Piece:
    """The expression that holds from `low` to `high`."""

    low: float
    high: float
    expr: sp.Expr


@dataclass(frozen=True)
class Given:
    """A function of one variable at numbers for its parameters, zero below its first piece."""

    pieces: tuple[Piece, ...]
    variable: sp.Symbol
    values: Mapping[Any, float]

    @property
    def rate(self) -> Given:
        """The derivative."""
        pieces = tuple(Piece(one.low, one.high, sp.diff(one.expr, self.variable)) for one in self.pieces)
        return Given(pieces, self.variable, self.values)

    def numpy(self) -> Function:
        """Of an array; each expression sees its own range only."""
        functions = [self._bound(one.expr, [FUNCTIONS, "numpy"]) for one in self.pieces]
        if len(functions) == 1 and not self.pieces[0].low:
            return lambda x: functions[0](x) + 0.0 * x  # a constant broadcasts

        def chosen(x: Array) -> Array:
            value = 0.0 * x
            with np.errstate(divide="ignore", invalid="ignore"):  # at a break, whose value is not taken
                for one, function in zip(self.pieces, functions, strict=True):
                    value = np.where(x > one.low, function(np.clip(x, one.low, one.high)), value)
            return value

        return chosen

    def math(self) -> Function:
        """Of a float above the first break."""
        return self._scalar([FUNCTIONS, "math"], float)

    def mpmath(self) -> Function:
        """Of a number of mpmath above the first break."""
        return self._scalar([{master.__name__: master.numeric for master in MASTERS}, "mpmath"], mp.mpf)

    def _scalar(self, modules: Any, number: Callable[[float], Any]) -> Function:
        functions = [self._bound(one.expr, modules, number) for one in self.pieces]
        if len(functions) == 1:
            return functions[0]
        ends = [one.high for one in self.pieces]

        def chosen(x: Any) -> Any:
            for end, function in zip(ends, functions, strict=True):
                if x <= end:
                    return function(x)
            return math.nan

        return chosen

    def _bound(self, expr: sp.Expr, modules: Any, number: Callable[[float], Any] = float) -> Function:
        parameters = sorted(expr.free_symbols - {self.variable}, key=str)
        function = sp.lambdify((self.variable, *parameters), expr, modules)
        values = [self.values[symbol] for symbol in parameters]
        if number is float:
            return lambda x: function(x, *values)
        return lambda x: function(x, *map(number, values))  # at the digits in force


def joined(pieces: list[Piece]) -> tuple[Piece, ...]:
    """In ascending order, neighbours of one expression as one, empty ones left out."""
    found: list[Piece] = []
    for one in sorted((one for one in pieces if one.low < one.high), key=lambda one: one.low):
        if found and found[-1].expr == one.expr:
            found[-1] = Piece(found[-1].low, one.high, one.expr)
        else:
            found.append(one)
    return tuple(found)
