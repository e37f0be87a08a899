"""The meaning of a printed formula: nodes that are evaluated where names have values."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from .functions import Value

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
    return Node(lambda env: mp.power(base(env), exponent(env)))


def factorial(of: Node) -> Node:
    return Node(lambda env: mp.factorial(of(env)))


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


def least(variable: str, body: Node) -> Node:
    """The least value over the terms of a sum whose coefficients are in the environment."""
    return Node(lambda env: min(body({**env, variable: mp.mpf(i + 1)}) for i in range(len(env[f"A_{variable}"]))))


def _looked_up(env: Environment, name: str) -> Value:
    if name not in env:
        message = f"the row uses {name!r}, which nothing defines"
        raise KeyError(message)
    found = env[name]
    return found(env) if isinstance(found, Node) else found


def _element(env: Environment, name: str) -> Value:
    found = env[name]
    return found(env) if isinstance(found, Node) else found[int(env["j"]) - 1]
