r"""What a printed formula says, evaluated from its LaTeX source with mpmath.

Recursive descent over the subset that the handbook prints, written without
SymPy and without looking at the printer: it reads what the reader reads.  A
function without brackets takes exactly one factor, \frac binds its arguments,
juxtaposition is a product.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import mpmath as mp

from .special import BRACKETED, FUNCTIONS, STRUVE, Value

Environment = Mapping[str, Any]
"""Name -> number, sequence (for A_j), function, or definition that is evaluated where it is used.

`cuts` may name points at which the integral over a variable is split; they change its cost, not its value.
"""

_LAYOUT = re.compile(
    r"\\begin\{aligned\}(?:\[t\])?|\\end\{aligned\}|\\[,;:! ]|\\(?:[bB]igg?[lrm]?|displaystyle)(?![A-Za-z])"
    r"|\\\\(?:\[[^\]]*\])?|\\enspace|\{\}|~|&"
)
_TOKEN = re.compile(r"\\[A-Za-z]+|\\[{}]|\d+(?:\.\d+)?|\S")
_SEPARATORS = (r"\quad", r"\qquad")
_CLOSING = {"(": ")", "[": "]", r"\{": r"\}"}
CALLABLE = ("f", "g", "P", "F_N", "p", "w", "F_adh", "d_adh", "E", "J", "Phi_m")
"""Names that are functions when a bracket follows; every other symbol before a bracket is a factor."""
_STOPS = {"+", "-", "/", "=", ",", ";", ")", "]", "}", r"\}", r"\rvert", "<", *_SEPARATORS}


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


@lru_cache(maxsize=4096)
def read(tex: str) -> list[Statement]:
    """The statements of a printed row, separated by `,` and a quad.

    Raises
    ------
    SyntaxError
        If the source is not of the printed subset.
    """
    parser = _Parser(tex)
    found = [parser.statement()]
    while parser.separator():
        found.append(parser.statement())
    if parser.peek() is not None:
        raise SyntaxError(parser.message("end of formula"))
    return found


def environment(statements: list[Statement], values: Mapping[str, Any]) -> dict[str, Any]:
    """The values with the definitions of a row, `s = ...`, added."""
    return {**values, **{s.members[0].name: s.members[-1] for s in statements if s.members[0].name}}


class _Parser:
    def __init__(self, tex: str) -> None:
        # an empty group carries the first index of {}_1F_1, which is none of the letter before it
        self.tokens, self.at = _TOKEN.findall(_LAYOUT.sub(" ", tex.replace("{}_", r"\prescript _"))), 0

    def peek(self) -> str | None:
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def message(self, wanted: str) -> str:
        return f"expected {wanted} at token {self.at} ({self.peek()}) of {' '.join(self.tokens)}"

    def take(self, wanted: str | None = None) -> str:
        token = self.peek()
        if token is None or (wanted is not None and token != wanted):
            raise SyntaxError(self.message(wanted or "more"))
        self.at += 1
        return token

    def separator(self) -> bool:
        """Skip `,` followed by a quad."""
        if self.peek() == "," and self.at + 1 < len(self.tokens) and self.tokens[self.at + 1] in _SEPARATORS:
            self.at += 1
        found = False
        while self.peek() in _SEPARATORS:
            self.at, found = self.at + 1, True
        return found

    def statement(self) -> Statement:
        members = [self.sum()]
        while self.peek() == "=":
            self.take()
            members.append(self.sum())
        return Statement(tuple(members))

    def sum(self) -> Node:
        terms: list[tuple[int, Node]] = []
        while True:
            sign = 1
            while self.peek() in ("+", "-"):
                sign = -sign if self.take() == "-" else sign
            terms.append((sign, self.product()))
            if self.peek() not in ("+", "-"):
                break
        if terms[0][0] == 1 and len(terms) == 1:
            return terms[0][1]
        return Node(lambda env: sum((s * term(env) for s, term in terms), mp.mpf(0)))

    def product(self) -> Node:
        factors = [(1, self.factor())]
        while self.peek() is not None and (self.peek() == "/" or self.peek() not in _STOPS):
            if self.peek() == r"\mathrm" and self.tokens[self.at + 1 : self.at + 4] == ["{", "d", "}"]:
                break
            if self.peek() == "/":
                self.take()
                factors.append((-1, self.factor()))
            else:
                factors.append((1, self.factor()))
        if len(factors) == 1:
            return factors[0][1]
        return Node(lambda env: mp.fprod(f(env) if e > 0 else 1 / f(env) for e, f in factors))

    def factor(self) -> Node:
        base = self.atom()
        while self.peek() == "^":
            self.take()
            base = _power(base, self.argument())
        return base

    def argument(self) -> Node:
        """A TeX argument: a group, or a single token (of a number only its first digit)."""
        if self.peek() == "{":
            self.take()
            inner = self.sum()
            self.take("}")
            return inner
        token = self.peek() or ""
        if token[0:1].isdigit() and len(token) > 1:
            self.tokens[self.at : self.at + 1] = [token[0], token[1:]]
        return self.atom()

    def text(self) -> str:
        """A TeX argument as letters, without its font."""
        if self.peek() != "{":
            token = self.take()
            return self.text() if token in (r"\mathrm", r"\mathbf") else token.lstrip("\\")
        self.take("{")
        out = ""
        while self.peek() != "}":
            out += self.text() if self.peek() in ("{", r"\mathrm", r"\mathbf") else self.take().lstrip("\\")
        self.take("}")
        return out

    def atom(self) -> Node:
        token = self.take()
        if token in _CLOSING:
            inner = self.sum()
            self.take(_CLOSING[token])
            return Node(inner.value)
        if token == "{":
            inner = self.sum()
            self.take("}")
            return Node(inner.value)
        if token[0].isdigit():
            return Node(lambda env: mp.mpf(token))
        if token in (r"\frac", r"\tfrac"):
            above, below = self.argument(), self.argument()
            return Node(lambda env: above(env) / below(env))
        if token == r"\lvert":
            inner = self.sum()
            self.take(r"\rvert")
            return Node(lambda env: abs(inner(env)))
        if token == r"\prescript":
            return self.hypergeometric()
        if token == r"\max":
            return self.function("max")
        if token == r"\sqrt":
            return self.root()
        if token == r"\int":
            return self.integral()
        if token == r"\sum":
            return self.series()
        return self.named(token)

    def root(self) -> Node:
        index = 2
        if self.peek() == "[":
            self.take()
            index = int(self.take())
            self.take("]")
        inside = self.argument()
        return Node(lambda env: mp.root(inside(env), index))

    def limits(self) -> tuple[Node, Node, str]:
        lower = upper = None
        variable = ""
        for _ in range(2):
            if self.take() == "_":
                if self.tokens[self.at + 2 : self.at + 3] == ["="]:
                    self.take("{")
                    variable = self.take()
                    self.take("=")
                    lower = self.sum()
                    self.take("}")
                else:
                    lower = self.argument()
            else:
                upper = self.argument()
        if lower is None or upper is None:
            raise SyntaxError(self.message("two limits"))
        return lower, upper, variable

    def integral(self) -> Node:
        lower, upper, _ = self.limits()
        body = self.product()
        self.take(r"\mathrm"), self.take("{"), self.take("d"), self.take("}")
        variable = self.take().lstrip("\\")

        def value(env: Environment) -> Value:
            low, high = lower(env), upper(env)
            cuts = sorted(x for x in env.get("cuts", {}).get(variable, ()) if low < x < high)
            return mp.quad(lambda x: body({**env, variable: x}), [low, *cuts, high])

        return Node(value)

    def series(self) -> Node:
        lower, upper, variable = self.limits()
        body = self.product()

        def value(env: Environment) -> Value:
            steps = range(int(lower(env)), int(upper(env)) + 1)
            return mp.fsum(body({**env, variable: mp.mpf(i)}) for i in steps)

        return Node(value)

    def named(self, token: str) -> Node:
        """A symbol, a sequence element or a function."""
        name = token.lstrip("\\")
        if name in ("mathrm", "mathbf", "operatorname", "bar"):
            name = ("bar " if name == "bar" else "") + self.text()
        elif not name[0].isalpha():
            raise SyntaxError(self.message("a symbol"))
        if token == r"\mathbf" and name in STRUVE:
            return self.struve(name)
        if name == "Delta":
            name += " " + self.take().lstrip("\\")
        subscript = ""
        if self.peek() == "_":
            self.take()
            subscript = self.text()
            name += f"_{subscript}"
        if self.peek() == "^" and self.tokens[self.at + 1 : self.at + 3] == ["{", "*"]:
            return self.starred(name)
        upright = token in (r"\mathrm", r"\mathbf", r"\operatorname", r"\chi")
        if upright and name in BRACKETED:
            return self.function(name)
        if name in FUNCTIONS and token.startswith("\\"):
            return self.call(FUNCTIONS[name])
        if name == "pi":
            return Node(lambda env: +mp.pi)
        primes = ""
        while self.peek() == "'":
            primes += self.take()
        if name in CALLABLE and self.peek() == "(":
            arguments = self.arguments()
            return Node(lambda env: env[f"{name}{primes}()"](*(argument(env) for argument in arguments)))
        if subscript == "j":
            return Node(lambda env: _element(env, name, subscript), name)
        return Node(lambda env: _looked_up(env, name), name)

    def hypergeometric(self) -> Node:
        """{}_2F_1(p, q; c; z) and {}_1F_1(p; c; z), from the subscript on."""
        self.take("_")
        name = self.text() + self.text()
        self.take("_")
        return self.function(f"{name}_{self.text()}")

    def struve(self, name: str) -> Node:
        self.take("_")
        order = self.argument()
        (argument,) = self.arguments()
        return Node(lambda env: STRUVE[name](order(env), argument(env)))

    def function(self, name: str) -> Node:
        arguments = self.arguments()
        return Node(lambda env: BRACKETED[name](*(x(env) for x in arguments)))

    def starred(self, name: str) -> Node:
        r"""E^{*}, and its powers E^{*2}."""
        self.take("^"), self.take("{"), self.take("*")
        base = Node(lambda env: _looked_up(env, name + "*"), name + "*")
        if self.peek() == "}":
            self.take("}")
            return base
        power = self.sum()
        self.take("}")
        return _power(base, power)

    def call(self, function: Callable[..., Value]) -> Node:
        power = None
        if self.peek() == "^":
            self.take()
            power = self.argument()
        inside = self.factor()
        plain = Node(lambda env: function(inside(env)))
        return plain if power is None else _power(plain, power)

    def arguments(self) -> list[Node]:
        opening = self.take()
        if opening not in _CLOSING:
            raise SyntaxError(self.message("an opening bracket"))
        found = [self.sum()]
        while self.peek() in (",", ";"):
            self.take()
            found.append(self.sum())
        self.take(_CLOSING[opening])
        return found


def _power(base: Node, exponent: Node) -> Node:
    return Node(lambda env: mp.power(base(env), exponent(env)))


def _looked_up(env: Environment, name: str) -> Value:
    if name not in env:
        message = f"the row uses {name!r}, which nothing defines"
        raise KeyError(message)
    found = env[name]
    return found(env) if isinstance(found, Node) else found


def _element(env: Environment, name: str, subscript: str) -> Value:
    found = env[name]
    return found(env) if isinstance(found, Node) else found[int(env[subscript]) - 1]
