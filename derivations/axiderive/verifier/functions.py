"""The reader of `functions.txt`, the table of derivatives and equations; at its head stands how it is read."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from .reading import SIGNS, Tree, tree


@dataclass(frozen=True)
class Condition:
    """What an equation asks of the sign of an argument less a number."""

    left: Tree
    verb: str
    right: Tree
    negated: bool

    @classmethod
    def of(cls, text: str) -> Condition:
        """A condition as it is written."""
        left, verb, right = text.removeprefix("not ").rsplit(" ", 2)
        return cls(tree(left), verb, tree(right), text.startswith("not "))

    def met(self, sign: int | None) -> bool:
        """Whether this sign meets it."""
        return (sign in SIGNS[self.verb]) != self.negated


@dataclass(frozen=True)
class Equation:
    """A function of arguments like these is this formula, or is said to be positive or unknown."""

    arguments: tuple[Tree, ...]
    value: Tree
    conditions: tuple[Condition, ...]


@dataclass
class Function:
    """What the table says of one function."""

    letters: tuple[str, ...]
    flags: set[str]
    slopes: dict[str, Tree] = field(default_factory=dict)
    margins: list[Tree] = field(default_factory=list)
    equations: list[Equation] = field(default_factory=list)

    def add(self, line: str) -> None:
        """Takes in a line of the table."""
        word, _, rest = line.partition(" ")
        if word == "slope":
            letter, formula = rest.split(" = ")
            self.slopes[letter] = tree(formula)
        elif word == "where":
            self.margins.append(tree(rest))
        else:
            line, *conditions = line.split(" if ")
            left, _, right = line.replace(" is ", " = ").partition(" = ")
            met = tuple(Condition.of(one) for text in conditions for one in text.split(", "))
            self.equations.append(Equation(tree(left)[1:], tree(right), met))


def functions(text: str) -> dict[str, Function]:
    """All functions of a table by name."""
    out: dict[str, Function] = {}
    opened = Function((), set())
    for row in text.splitlines():
        if row.startswith("  "):
            opened.add(row.strip())
        elif row and not row.startswith("#"):
            left, _, flags = row.partition(":")
            name, *letters = tree(left)
            out[name] = opened = Function(tuple(letters), {flag.strip() for flag in flags.split(",")})
    return out


FUNCTIONS = functions((Path(__file__).parent / "functions.txt").read_text(encoding="utf-8"))
