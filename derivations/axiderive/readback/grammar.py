r"""How a printed formula is read: its tokens, and recursive descent over the subset of LaTeX that the handbook uses.

Written without SymPy and without looking at the printer: it reads what the
reader reads.  A function without brackets takes exactly one factor, \frac binds
its arguments, juxtaposition is a product.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache

import mpmath as mp

from . import meaning
from .meaning import BRACKETED, FUNCTIONS, STRUVE, Environment, Node, Statement, Value

_LAYOUT = re.compile(
    r"\\begin\{aligned\}(?:\[t\])?|\\end\{aligned\}|\\[,;:! ]|\\(?:displaystyle|allowbreak)(?![A-Za-z])"
    r"|\\[bB]igg?[lrm]?(?=\s*(?:[()\[\]/]|\\[{}]|\\[lr]?vert(?![a-z])))"
    r"|\\\\(?:\[[^\]]*\])?|\\enspace|\{\}|~|&"
)
_TOKEN = re.compile(r"\\[A-Za-z]+|\\[{}]|\d+(?:\.\d+)?|\S")
SEPARATORS = (r"\quad", r"\qquad")
SHORT = 15
"""Digits below which a whole number is the same in every precision."""


class Tokens:
    """A place in the tokens of a formula."""

    def __init__(self, tex: str) -> None:
        # an empty group carries the first index of {}_1F_1, which is none of the letter before it
        self.tokens, self.at = _TOKEN.findall(_LAYOUT.sub(" ", tex.replace("{}_", r"\prescript _"))), 0

    def peek(self) -> str | None:
        """The next token, which stays in place; None at the end."""
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def comes(self, *wanted: str) -> bool:
        """Whether these tokens are the next ones."""
        return tuple(self.tokens[self.at : self.at + len(wanted)]) == wanted

    def message(self, wanted: str) -> str:
        """The text of an error: what was expected, at which token of the formula."""
        return f"expected {wanted} at token {self.at} ({self.peek()}) of {' '.join(self.tokens)}"

    def take(self, wanted: str | None = None) -> str:
        """The next token, which is passed over; SyntaxError at the end, or if it is not the wanted one."""
        token = self.peek()
        if token is None or (wanted is not None and token != wanted):
            raise SyntaxError(self.message(wanted or "more"))
        self.at += 1
        return token

    def separator(self) -> bool:
        """Skip `,` followed by a quad."""
        if self.peek() == "," and self.at + 1 < len(self.tokens) and self.tokens[self.at + 1] in SEPARATORS:
            self.at += 1
        found = False
        while self.peek() in SEPARATORS:
            self.at, found = self.at + 1, True
        return found

    def first_digit(self) -> None:
        """Of a number that is a TeX argument without braces only the first digit is taken."""
        token = self.peek() or ""
        if token[0:1].isdigit() and len(token) > 1:
            self.tokens[self.at : self.at + 1] = [token[0], token[1:]]

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


_CLOSING = {"(": ")", "[": "]", r"\{": r"\}"}
CALLABLE = (
    "f", "g", "P", "F_N", "p", "w", "w_1D", "F_adh", "d_adh", "p_adh", "w_adh", "F_coh", "d_coh", "p_coh", "w_coh",
    "tau", "F", "E", "I", "J", "Phi_m", "N_0", "q",
)  # fmt: skip
"""Names that are functions when a bracket follows; every other symbol before a bracket is a factor."""
_STOPS = {"+", "-", "/", "=", ",", ";", ")", "]", "}", r"\}", r"\rvert", "<", *SEPARATORS}
_DIFFERENTIAL = "differential"


@lru_cache(maxsize=4096)
def read(tex: str) -> list[Statement]:
    """The statements of a printed row, separated by `,` and a quad.

    Raises
    ------
    SyntaxError
        If the source is not of the printed subset.
    """
    return _parsed(tex)[0]


def _parsed(tex: str) -> tuple[list[Statement], _Parser]:
    parser = _Parser(tex)
    found = [parser.statement()]
    while parser.separator():
        found.append(parser.statement())
    if parser.peek() is not None:
        raise SyntaxError(parser.message("end of formula"))
    return found, parser


def names(tex: str) -> set[str]:
    """What a reader has to know to read a printed row: its symbols and functions that it does not define itself."""
    found, parser = _parsed(tex)
    defined = {one.members[0].name for one in found[1:]}
    return parser.used - parser.bound - defined


class _Parser(Tokens):
    def __init__(self, tex: str) -> None:
        super().__init__(tex)
        self.used: set[str] = set()
        self.bound: set[str] = set()
        """Variables of integration and summation."""
        self.differentials: list[list[str]] = []
        """Variables of integration met so far, in a list for every integral that is open."""

    def statement(self) -> Statement:
        """Reads sums with = between them."""
        members = [self.sum()]
        while self.peek() == "=":
            self.take()
            members.append(self.sum())
        return Statement(tuple(members))

    def sum(self) -> Node:
        """Reads products with + and - between them, up to the token that ends a sum."""
        terms: list[tuple[int, Node]] = []
        while True:
            sign = 1
            while self.peek() in ("+", "-"):
                sign = -sign if self.take() == "-" else sign
            terms.append((sign, self.product()))
            if self.peek() not in ("+", "-"):
                return meaning.total(terms)

    def product(self) -> Node:
        """Reads factors side by side or over slashes, each of which divides by one factor; ends at a differential."""
        factors = [(1, self.factor())]
        while factors[-1][1].name != _DIFFERENTIAL and (self.peek() == "/" or self.peek() not in {None, *_STOPS}):
            if self.peek() == "/":
                self.take()
                factors.append((-1, self.factor()))
            else:
                factors.append((1, self.factor()))
        return meaning.product(factors)

    def factor(self) -> Node:
        """Reads an atom with its powers."""
        base = self.atom()
        while self.peek() == "^":
            self.take()
            base = meaning.power(base, self.argument())
        return base

    def argument(self) -> Node:
        """A TeX argument: a group, or a single token (of a number only its first digit)."""
        if self.peek() == "{":
            return self.enclosed("}")
        self.first_digit()
        return self.atom()

    def enclosed(self, closing: str) -> Node:
        """A sum between two tokens, from the first of them on."""
        self.take()
        inner = self.sum()
        self.take(closing)
        return inner

    def atom(self) -> Node:
        """Reads a bracket, number, fraction, root, integral, sum, name or function."""
        token = self.peek() or ""
        if token in _CLOSING or token == "{":
            return Node(self.enclosed(_CLOSING.get(token, "}")).value)
        self.take()
        if token.isdigit() and len(token) < SHORT:
            whole = mp.mpf(token)
            return Node(lambda env: whole)
        if token[0].isdigit():
            return Node(lambda env: mp.mpf(token))
        if token in (r"\frac", r"\tfrac"):
            if not self.differentials and (derivative := self.derivative()):
                return derivative
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
            lower, upper, variable = self.limits()
            self.bound.add(variable)
            return meaning.series(lower, upper, self.product(), variable)
        return self.named(token)

    def derivative(self) -> Node | None:
        r"""A quotient of differentials, \frac{\mathrm{d}w}{\mathrm{d}x}, which is one name: dw/dx."""
        start, names = self.at, []
        for _ in range(2):
            if not (self.comes("{", r"\mathrm", "{", "d", "}") or self.comes("{", r"\mathrm", "d")):
                self.at = start
                return None
            self.take()
            self.named(self.take())
            names.append(self.sum().name)
            self.take("}")
        return meaning.symbol(f"d{names[0]}/d{names[1]}")

    def root(self) -> Node:
        """Reads a root from its index or argument on; the index is 2 where none is printed."""
        index = 2
        if self.peek() == "[":
            self.take()
            index = int(self.take())
            self.take("]")
        inside = self.argument()
        # ten times as quick as that of any index
        return Node(lambda env: mp.sqrt(inside(env)) if index == 2 else mp.root(inside(env), index))

    def limits(self) -> tuple[Node, Node, str]:
        """Reads lower and upper limit and the variable of a sum, empty for an integral; SyntaxError without both."""
        lower = upper = None
        variable = ""
        for _ in range(2):
            if self.take() == "^":
                upper = self.argument()
            elif self.tokens[self.at + 2 : self.at + 3] == ["="]:
                self.take("{")
                variable = self.take()
                lower = self.enclosed("}")
            else:
                lower = self.argument()
        if lower is None or upper is None:
            raise SyntaxError(self.message("two limits"))
        return lower, upper, variable

    def integral(self) -> Node:
        """The differential ends the integrand or stands above the line of a fraction of it."""
        lower, upper, _ = self.limits()
        self.differentials.append([])
        body = self.product()
        found = self.differentials.pop()
        if len(found) != 1:
            raise SyntaxError(self.message("one differential"))
        return meaning.integral(lower, upper, body, found[0])

    def differential(self) -> Node:
        """Reads the variable behind an upright d and notes it for the open integral; its value is 1."""
        self.differentials[-1].append(self.take().lstrip("\\"))
        self.bound.add(self.differentials[-1][-1])
        return Node(lambda env: mp.mpf(1), _DIFFERENTIAL)

    def named(self, token: str) -> Node:
        """A symbol, a sequence element or a function."""
        name = token.lstrip("\\")
        if name in ("mathrm", "mathbf", "operatorname", "bar"):
            name = ("bar " if name == "bar" else "") + self.text()
        elif not name[0].isalpha():
            raise SyntaxError(self.message("a symbol"))
        if token == r"\mathbf" and name in STRUVE:
            return self.struve(name)
        if token == r"\mathrm" and name == "d" and self.differentials:
            return self.differential()
        if token == r"\mathrm" and name == "e":
            return Node(lambda env: +mp.e)
        if name == "Delta":
            name += " " + self.take().lstrip("\\")
        if self.peek() == "_":
            self.take()
            name += f"_{self.text()}"
        if self.comes("^", "{", "*"):
            return self.starred(name)
        upright = token in (r"\mathrm", r"\mathbf", r"\operatorname", r"\chi")
        if upright and name in BRACKETED:
            return self.function(name)
        if name in FUNCTIONS and token.startswith("\\"):
            return self.call(FUNCTIONS[name])
        if name == "infty":
            return Node(lambda env: mp.inf)
        if name == "pi":
            return Node(lambda env: +mp.pi)
        primes = ""
        while self.peek() == "'":
            primes += self.take()
        self.used.add(name)
        if name in CALLABLE and self.peek() == "(":
            return self.called(name, f"{name}{primes}()")
        return meaning.symbol(name)

    def called(self, name: str, function: str) -> Node:
        """A function of the row; the letter of a traction is that of a relaxation time too, before a bracket."""
        arguments = self.arguments()

        def value(env: Environment) -> Value:
            if name == "tau" and function not in env:
                return env[name] * arguments[0](env)
            return env[function](*(argument(env) for argument in arguments))

        return Node(value)

    def hypergeometric(self) -> Node:
        """{}_2F_1(p, q; c; z) and {}_1F_1(p; c; z), from the subscript on."""
        self.take("_")
        name = self.text() + self.text()
        self.take("_")
        return self.function(f"{name}_{self.text()}")

    def struve(self, name: str) -> Node:
        """Reads order and argument of the Struve function H or L."""
        self.take("_")
        order = self.argument()
        (argument,) = self.arguments()
        return Node(lambda env: STRUVE[name](order(env), argument(env)))

    def function(self, name: str) -> Node:
        """Reads the arguments in brackets of a function that always has them."""
        arguments = self.arguments()
        return Node(lambda env: BRACKETED[name](*(x(env) for x in arguments)))

    def starred(self, name: str) -> Node:
        r"""E^{*}, and its powers E^{*2}."""
        self.take("^"), self.take("{"), self.take("*")
        base = meaning.symbol(name + "*")
        self.used.add(base.name)
        if self.peek() == "}":
            self.take("}")
            return base
        exponent = self.sum()
        self.take("}")
        return meaning.power(base, exponent)

    def call(self, function: Callable[..., Value]) -> Node:
        """Reads a function of exactly one factor, with a power behind its name as in sin^2 x."""
        exponent = None
        if self.peek() == "^":
            self.take()
            exponent = self.argument()
        inside = self.factor()
        plain = Node(lambda env: function(inside(env)))
        return plain if exponent is None else meaning.power(plain, exponent)

    def arguments(self) -> list[Node]:
        """Reads arguments in brackets, with commas or semicolons between; SyntaxError without an opening bracket."""
        opening = self.take()
        if opening not in _CLOSING:
            raise SyntaxError(self.message("an opening bracket"))
        found = [self.sum()]
        while self.peek() in (",", ";"):
            self.take()
            found.append(self.sum())
        self.take(_CLOSING[opening])
        return found
