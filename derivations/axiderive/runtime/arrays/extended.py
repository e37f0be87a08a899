"""Numbers whose exponent has no bounds: what the formulas are evaluated with where a double would over- or underflow.

`elementwise` repeats a block with these when an intermediate left the range of
double precision.  The formulas do not notice: NumPy's functions are looked up
in a table by the protocols `__array_ufunc__` and `__array_function__`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

ZERO = -(1 << 40)
"""The exponent of zero, below that of any other number."""
TINY = -60
"""Odd functions with slope 1 are their argument below 2**TINY; an asymptote holds above 2**-TINY."""
LN2_HIGH, LN2_LOW = 0.6931471803691238, 1.9082149292705877e-10
"""ln 2, the first part with trailing zeros so that whole multiples are exact (Cody and Waite)."""


class Extended(NDArrayOperatorsMixin):
    """mantissa * 2**exponent, elementwise."""

    def __init__(self, mantissa: Any, exponent: Any = 0) -> None:
        mantissa, shift = np.frexp(np.asarray(mantissa, dtype=np.float64))
        self.mantissa = mantissa
        self.exponent = np.where(mantissa == 0.0, ZERO, exponent + shift.astype(np.int64))

    @property
    def shape(self) -> tuple[int, ...]:
        return np.broadcast(self.mantissa, self.exponent).shape

    @property
    def ndim(self) -> int:
        return len(self.shape)

    @property
    def size(self) -> int:
        return int(np.prod(self.shape))

    def __getitem__(self, place: Any) -> Extended:
        whole = np.broadcast_arrays(self.mantissa, self.exponent)
        return Extended(*(part[place] for part in whole))

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(np.ldexp(self.mantissa, np.clip(self.exponent, -5000, 5000).astype(np.int32)))

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        rule = RULES.get(ufunc)
        if method != "__call__" or options or rule is None:
            return NotImplemented
        return rule(*(extended(x) for x in inputs))

    def __array_function__(self, function: Any, types: Any, args: Any, options: Any) -> Any:
        rule = SHAPED.get(function)
        return NotImplemented if rule is None else rule(*args, **options)


def extended(value: Any) -> Extended:
    return value if isinstance(value, Extended) else Extended(value)


def _add(x: Extended, y: Extended) -> Extended:
    top = np.maximum(x.exponent, y.exponent)
    shifted = (np.ldexp(z.mantissa, np.maximum(z.exponent - top, -2000).astype(np.int32)) for z in (x, y))
    return Extended(sum(shifted), top)


def _negative(x: Extended) -> Extended:
    return Extended(-x.mantissa, x.exponent)


def _multiply(x: Extended, y: Extended) -> Extended:
    return Extended(x.mantissa * y.mantissa, x.exponent + y.exponent)


def _divide(x: Extended, y: Extended) -> Extended:
    return Extended(x.mantissa / y.mantissa, x.exponent - y.exponent)


def _root(degree: int, function: Callable[[Any], Any]) -> Callable[[Extended], Extended]:
    def rule(x: Extended) -> Extended:
        whole, rest = np.divmod(x.exponent, degree)
        return Extended(function(np.ldexp(x.mantissa, rest.astype(np.int32))), whole)

    return rule


def _power(x: Extended, y: Extended) -> Extended:
    """The whole part of exponent*y goes to the exponent of the result, exactly, its fraction to the mantissa."""
    n = np.asarray(y)
    high = n.astype(np.float32).astype(np.float64)
    exponent = np.where(x.mantissa == 0.0, 0, x.exponent)
    whole = np.rint(exponent * high)
    fraction = (exponent * high - whole) + exponent * (n - high)
    return Extended(x.mantissa**n * np.exp2(fraction), whole.astype(np.int64))


def _exp(x: Extended) -> Extended:
    value = np.asarray(x)
    whole = np.rint(np.clip(value, -1e9, 1e9) / np.log(2.0))
    rest = (value - whole * LN2_HIGH) - whole * LN2_LOW
    moderate = np.abs(value) < 700.0
    whole = np.where(moderate | ~np.isfinite(value), 0.0, whole)
    return Extended(np.exp(np.where(moderate | ~np.isfinite(value), value, rest)), whole.astype(np.int64))


def _log(x: Extended) -> Extended:
    large = np.abs(x.exponent) > 1000
    split = np.log(x.mantissa) + np.where(large & (x.mantissa != 0.0), x.exponent, 0) * np.log(2.0)
    return Extended(np.where(large, split, np.log(np.asarray(x))))


def _odd(function: Any, far: Callable[[Extended], Extended] | None = None) -> Callable[[Extended], Extended]:
    """A function f(x) = x + ... near zero, and `far` where its argument or value is large."""

    def rule(x: Extended) -> Extended:
        value = _where(x.exponent < TINY, x, Extended(function(np.asarray(x))))
        return value if far is None else _where(x.exponent > (9 if far is _exp_half else -TINY), far(x), value)

    return rule


def _exp_half(x: Extended) -> Extended:
    return _divide(_exp(x), Extended(2.0))


def _cosh(x: Extended) -> Extended:
    return _where(x.exponent > 9, _exp_half(x), Extended(np.cosh(np.asarray(x))))


def _expm1(x: Extended) -> Extended:
    return _where(np.asarray(x) > 500.0, _exp(x), _odd(np.expm1)(x))


def _arctan2(y: Extended, x: Extended) -> Extended:
    """The angle of sides that are not negative; that of (0, 0) is 0, as everywhere."""
    return _where(y.mantissa == 0.0, y, _odd(np.arctan)(_divide(y, x)))


def _plain(function: Any) -> Callable[[Extended], Extended]:
    return lambda x: Extended(function(np.asarray(x)))


def _compared(relation: Any) -> Callable[[Extended, Extended], Any]:
    def rule(x: Extended, y: Extended) -> Any:
        infinite = np.isinf(x.mantissa) & np.isinf(y.mantissa)
        difference = np.sign(x.mantissa) - np.sign(y.mantissa)
        return relation(np.where(infinite, difference, _add(x, _negative(y)).mantissa), 0.0)

    return rule


_less = _compared(np.less)


def _where(condition: Any, x: Any, y: Any) -> Extended:
    x, y = extended(x), extended(y)
    return Extended(np.where(condition, x.mantissa, y.mantissa), np.where(condition, x.exponent, y.exponent))


def _least(x: Extended, y: Extended) -> Extended:
    return _where(_compared(np.less)(y, x), y, x)


def _greatest(x: Extended, y: Extended) -> Extended:
    return _where(_compared(np.greater)(y, x), y, x)


def _sum(x: Extended, axis: int = 0) -> Extended:
    top = np.max(x.exponent, axis=axis, initial=ZERO)
    shift = np.maximum(x.exponent - np.expand_dims(top, axis), -2000).astype(np.int32)
    return Extended(np.sum(np.ldexp(x.mantissa, shift), axis=axis), top)


RULES: dict[Any, Callable[..., Any]] = {
    np.add: _add,
    np.subtract: lambda x, y: _add(x, _negative(y)),
    np.multiply: _multiply,
    np.true_divide: _divide,
    np.negative: _negative,
    np.absolute: lambda x: Extended(np.abs(x.mantissa), x.exponent),
    np.copysign: lambda x, y: Extended(np.copysign(x.mantissa, y.mantissa), x.exponent),
    np.power: _power,
    np.square: lambda x: _multiply(x, x),
    np.sqrt: _root(2, np.sqrt),
    np.hypot: lambda x, y: RULES[np.sqrt](_add(_multiply(x, x), _multiply(y, y))),
    np.cbrt: _root(3, np.cbrt),
    np.exp: _exp,
    np.expm1: _expm1,
    np.log: _log,
    np.log1p: _odd(np.log1p, _log),
    np.sin: _odd(np.sin),
    np.tan: _odd(np.tan),
    np.cos: _plain(np.cos),
    np.sinh: _odd(np.sinh, _exp_half),
    np.cosh: _cosh,
    np.tanh: _odd(np.tanh),
    np.arctan: _odd(np.arctan),
    np.arctanh: _odd(np.arctanh),
    np.arcsinh: _odd(np.arcsinh, lambda x: _log(_multiply(x, Extended(2.0)))),
    np.arctan2: _arctan2,
    np.minimum: _least,
    np.maximum: _greatest,
    np.floor: _plain(np.floor),
    np.ceil: _plain(np.ceil),
    np.isfinite: lambda x: np.isfinite(x.mantissa),
    np.nextafter: lambda x, y: Extended(np.nextafter(x.mantissa, np.where(_less(x, y), np.inf, -np.inf)), x.exponent),
    np.less: _compared(np.less),
    np.less_equal: _compared(np.less_equal),
    np.greater: _compared(np.greater),
    np.greater_equal: _compared(np.greater_equal),
    np.equal: _compared(np.equal),
}
SHAPED: dict[Any, Callable[..., Any]] = {
    np.where: _where,
    np.sum: _sum,
    np.max: lambda x, initial: max(float(np.max(np.asarray(x), initial=initial)), initial),
    np.ndim: lambda x: x.ndim,
    np.shape: lambda x: x.shape,
    np.size: lambda x: x.size,
    np.zeros_like: lambda x: Extended(np.zeros(x.shape)),
    np.ones_like: lambda x: Extended(np.ones(x.shape)),
    np.full_like: lambda x, value: _where(np.ones(x.shape, dtype=bool), value, value),
}
