"""What a printed formula means: nodes that are evaluated where names have values, and the functions it may name.

The functions are stated by their definitions, independent of the engine.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
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
    "2F_1": mp.hyp2f1, "1F_1": mp.hyp1f1, "J": _cap_moment, "max": max, "sgn": mp.sign,
}  # fmt: skip
STRUVE: dict[str, Callable[..., Value]] = {"H": mp.struveh, "L": mp.struvel}
"""Bold letters with the order as index."""


Environment = Mapping[str, Any]
"""Name -> number, sequence (for A_j), function, or definition that is evaluated where it is used.

`cuts` may name points at which the integral over a variable is split; they change its cost, not its value.
"""


@dataclass(frozen=True)
class Node:
    """Part of a formula that can be evaluated; `name` if it is nothing but a name."""

    value: Callable[[Environment], Value]
    name: str = ""

    def __call__(self, env: Environment) -> Value:
        return self.value(env)


@dataclass(frozen=True)
class Statement:
    """left = ... = right."""

    members: tuple[Node, ...]


def environment(statements: list[Statement], values: Mapping[str, Any]) -> dict[str, Any]:
    """The values with the definitions of a row, `s = ...`, added."""
    return {**values, **{s.members[0].name: s.members[-1] for s in statements if s.members[0].name}}


def symbol(name: str) -> Node:
    """A name, or the element of a sequence where its index is j."""
    if name.endswith("_j"):
        return Node(lambda env: _element(env, name), name)
    return Node(lambda env: _looked_up(env, name), name)


def power(base: Node, exponent: Node) -> Node:
    """The node of base**exponent."""
    return Node(lambda env: mp.power(base(env), exponent(env)))


def total(terms: list[tuple[int, Node]]) -> Node:
    """Terms with their signs."""
    if len(terms) == 1 and terms[0][0] == 1:
        return terms[0][1]
    return Node(lambda env: sum((sign * term(env) for sign, term in terms), mp.mpf(0)))


def product(factors: list[tuple[int, Node]]) -> Node:
    """Factors, those with -1 as divisors."""
    if len(factors) == 1:
        return factors[0][1]
    return Node(lambda env: mp.fprod(f(env) if e > 0 else 1 / f(env) for e, f in factors))


def integral(lower: Node, upper: Node, body: Node, variable: str) -> Node:
    """The node of a definite integral, evaluated by mpmath's quadrature and split at the cuts of its variable."""

    def value(env: Environment) -> Value:
        low, high = lower(env), upper(env)
        cuts = sorted(x for x in env.get("cuts", {}).get(variable, ()) if low < x < high)
        return mp.quad(lambda x: body({**env, variable: x}), [low, *cuts, high])

    return Node(value)


def series(lower: Node, upper: Node, body: Node, variable: str) -> Node:
    """Without an end the terms fall like those of an exponential."""

    def value(env: Environment) -> Value:
        total, last = mp.mpf(0), upper(env)
        for i in itertools.count(int(lower(env))):
            if i > last:
                break
            term = body({**env, variable: mp.mpf(i)})
            total += term
            if last == mp.inf and abs(term) < mp.eps**2 * abs(total):
                break
        return total

    return Node(value)


def _looked_up(env: Environment, name: str) -> Value:
    if name not in env:
        message = f"the row uses {name!r}, which nothing defines"
        raise KeyError(message)
    found = env[name]
    return found(env) if isinstance(found, Node) else found


def _element(env: Environment, name: str) -> Value:
    found = env[name]
    return found(env) if isinstance(found, Node) else found[int(env["j"]) - 1]
