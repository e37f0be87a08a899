"""Functions that a printed formula may name, by their definitions; independent of the engine."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp

Value = Any


def _dawson(x: Value) -> Value:
    return mp.sqrt(mp.pi) / 2 * mp.exp(-x * x) * mp.erfi(x)


def _chi2(x: Value) -> Value:
    return mp.re(mp.polylog(2, x) - mp.polylog(2, -x)) / 2


def _ti2(x: Value) -> Value:
    if x > 1:  # the dilogarithm of mpmath is slow there
        return _ti2(1 / x) + mp.pi / 2 * mp.log(x)
    return mp.im(mp.polylog(2, mp.mpc(0, x)))


def _c0(b: Value, r: Value, a: Value) -> Value:
    """int_max(b,r)^a acos(b/t)/sqrt(t^2 - r^2) dt with t^2 = r^2 + y^2."""
    low = mp.sqrt(max(b * b - r * r, 0))
    high = mp.sqrt(a * a - r * r)
    # both ends of the integrand behave like square roots at worst: y = low + (high - low) v^2
    return mp.quad(
        lambda v: mp.acos(min(b / mp.sqrt(r * r + (low + (high - low) * v * v) ** 2), mp.mpf(1)))
        / mp.sqrt(r * r + (low + (high - low) * v * v) ** 2) * 2 * v * (high - low),
        _panels(low, high, r, b),
    )  # fmt: skip


def _panels(low: Value, high: Value, r: Value, b: Value) -> list[Value]:
    """Cuts where the integrand changes its scale."""
    marks = sorted({x for x in (r, b, mp.sqrt(abs(b * b - r * r))) if low < x < high})
    return [mp.mpf(0), *(mp.sqrt((x - low) / (high - low)) for x in marks), mp.mpf(1)]


def _cap_moment(k: Value, b: Value, R: Value, a: Value) -> Value:
    """int_0^b s (R^2 - s^2)^(-1/2) (a^2 - s^2)^((k - 1)/2) ds, with v^2 = a^2 - s^2 an incomplete power of v.

    As the difference of two Gauss functions, because a quadrature inside of the integrals of the rules takes minutes.
    """
    gap = R * R - a * a

    def antiderivative(v: Value) -> Value:
        if gap > 0:
            return v ** (k + 1) / ((k + 1) * mp.sqrt(gap)) * mp.hyp2f1(0.5, (k + 1) / 2, (k + 3) / 2, -v * v / gap)
        return v**k / k * mp.hyp2f1(0.5, -k / 2, 1 - k / 2, -gap / v**2)

    return antiderivative(a) - antiderivative(mp.sqrt((a - b) * (a + b)))


FUNCTIONS: dict[str, Callable[..., Value]] = {
    "sin": mp.sin, "cos": mp.cos, "tan": mp.tan, "arcsin": mp.asin, "arccos": mp.acos, "arctan": mp.atan, "ln": mp.log,
    "exp": mp.exp, "sinh": mp.sinh, "cosh": mp.cosh, "tanh": mp.tanh, "arcosh": mp.acosh, "arsinh": mp.asinh,
    "artanh": mp.atanh, "Gamma": mp.gamma,
}  # fmt: skip
BRACKETED: dict[str, Callable[..., Value]] = {
    "C_0": _c0, "chi_2": _chi2, "Ti_2": _ti2, "D": _dawson,
    "F": lambda phi, k: mp.ellipf(phi, k * k),
    "E": lambda phi, k=None: mp.ellipe(phi * phi) if k is None else mp.ellipe(phi, k * k),
    "K": lambda k: mp.ellipk(k * k),
    "B": lambda *x: mp.beta(*x) if len(x) == 2 else mp.re(mp.betainc(x[1], x[2], 0, x[0])),
    "2F_1": mp.hyp2f1, "1F_1": mp.hyp1f1, "J": _cap_moment, "max": max, "min": min, "sgn": mp.sign,
}  # fmt: skip
STRUVE: dict[str, Callable[..., Value]] = {"H": mp.struveh, "L": mp.struvel}
"""Bold letters with the order as index."""
