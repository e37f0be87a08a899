"""The readers of both tables; at the head of each stands how it is read.

`theory.txt` is the one of what must be shown of every quantity, `functions.txt` that of derivatives and equations.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

from .reading import SIGNS, Chain, Tree, UnknownError, ordered, tree

OWN = ("material", "defined", "graded", "profile", "composed", "beside", "root", "needs")
WORDS = (*OWN, "as", "let", "order", "either", "level", "given", "case")


@dataclass(frozen=True)
class Line:
    """One line of the table: a word and what follows it, or a statement, and where it holds."""

    conditions: tuple[str, ...]
    word: str
    text: str

    @classmethod
    def of(cls, text: str) -> Line:
        """A line as it is written."""
        found = re.fullmatch(r"if (.+?): (.+)", text)
        conditions, rest = (tuple(found[1].split(", ")), found[2]) if found else ((), text)
        word, _, after = rest.partition(" ")
        return cls(conditions, word, after) if word in WORDS else cls(conditions, "show", rest)

    @cached_property
    def named(self) -> tuple[str, tuple[str, ...], Tree]:
        """Name, letters and formula of "let x[a] = y" or "level x = y"."""
        left, right = self.text.split(" = ")
        return (*lettered(left), tree(right))

    def formulas(self) -> list[Tree]:
        """All formulas in a let, a level or a statement."""
        if self.word != "show":
            return [self.named[2]]
        return [x for one in statements(self.text) for x in (*one.sides, *(value for _, value in one.values))]


@dataclass(frozen=True)
class Statement:
    """What a line asks for: signs of differences of which one must be shown, or that a formula is an integral."""

    verb: str
    sides: tuple[Tree, ...]
    name: str
    values: tuple[tuple[str, Tree], ...]
    given: tuple[tuple[Tree, Tree], ...]


class Section:
    """What the table says of one quantity of one kind of problem."""

    def __init__(self, kind: str, suffix: str, letters: tuple[str, ...]) -> None:
        self.kind, self.suffix, self.letters = kind, suffix, letters
        self.lines: list[Line] = []

    def all(self, word: str) -> list[str]:
        """The texts of the lines that begin with a word."""
        return [line.text for line in self.lines if line.word == word]

    def first(self, word: str) -> list[str]:
        """The names that the first line with a word lists."""
        return names(next(iter(self.all(word)), ""))


class Theory:
    """The whole table."""

    def __init__(self, text: str) -> None:
        self.kinds: list[tuple[str, list[str]]] = []
        self.constants: dict[str, list[str]] = {}
        self.lets: list[Line] = []
        self.sections: dict[tuple[str, str], Section] = {}
        opened: list[tuple[Section, str]] = []
        for row in text.splitlines():
            line = row.strip()
            if not line or line.startswith("#"):
                continue
            if row.startswith(" "):
                for section, law in opened:
                    self._add(section, Line.of(line.replace("{law}", law)))
            elif line.startswith("kind "):
                kind, *needs = re.split(r"  +", line.removeprefix("kind "))
                self.kinds.append((kind, needs[0].split()))
            elif line.startswith("constants "):
                _, law, listed = line.split(" ", 2)
                self.constants[law] = names(listed)
            elif Line.of(line).word == "let":
                self.lets.append(Line.of(line))
            else:
                opened = list(self._sections(line))

    def _sections(self, line: str) -> Iterator[tuple[Section, str]]:
        head, bracket, letters = line.partition("[")
        kind, _, suffix = re.sub(r"\{.*\}", "{law}", head).rpartition(" ")
        laws = names(re.sub(r".*\{|\}.*", "", head)) if "{" in head else [""]
        for law in laws:
            section = Section(kind, suffix.replace("{law}", law), lettered("x" + bracket + letters)[1])
            self.sections[kind, section.suffix] = section
            yield section, law

    def _add(self, section: Section, line: Line) -> None:
        if line.word == "as":
            kind, _, suffix = line.text.rpartition(" ")
            section.lines += [other for other in self.sections[kind, suffix].lines if other.word not in OWN]
        else:
            section.lines.append(line)

    def material(self, section: Section, *, graded: bool) -> list[str]:
        """The constants of the material of a quantity."""
        texts = [*"".join(section.all("material")[:1]).split("|"), ""]
        return [one for name in names(texts[graded]) for one in self.constants.get(name, [name])]


def names(text: str) -> list[str]:
    """The names of a list with commas."""
    return [name.strip() for name in text.split(",") if name.strip()]


def lettered(text: str) -> tuple[str, tuple[str, ...]]:
    """Name and letters of text like F[a, c]."""
    name, _, letters = text.rstrip("]").partition("[")
    return name, tuple(names(letters))


def chain(text: str) -> Chain:
    """The members of "x < y < z"."""
    return tuple(ordered(tree(member)) for member in text.split(" < ") if member != "none")


def pairs(chained: Chain) -> tuple[tuple[Tree, Tree], ...]:
    """Every member of an order with every later one."""
    return tuple((low, high) for i, low in enumerate(chained) for high in chained[i + 1 :])


@cache
def statements(text: str) -> list[Statement]:
    """What a line asks for; of several one has to be shown."""
    text, *given = text.split(" given ")
    text, *put = text.split(" with ")
    values = tuple((name, tree(value)) for one in put for name, value in [one.split(" = ")])
    known = tuple(pair for one in given for pair in pairs(chain(one)))
    return [Statement(*_asked(part), values, known) for part in text.split(" or ")]


def _asked(text: str) -> tuple[str, tuple[Tree, ...], str]:
    for verb, pattern in {
        "grows": r"(.+) grows in (\w+) by (.+) from (.+)", "integral": r"(.+) is the integral of (.+)",
        "analytic": r"(.+) is analytic", "nonnegative": r"(.+) is nowhere negative",
    }.items():  # fmt: skip
        if found := re.fullmatch(pattern, text):
            parts = list(found.groups())
            name = parts.pop(1) if verb == "grows" else ""
            return verb, tuple(map(tree, parts)), name
    for verb in SIGNS:
        left, sign, right = text.partition(f" {verb} ")
        if sign:
            return verb, (tree(left), tree(right)), ""
    message = f"{text} is no statement"
    raise UnknownError(message)


THEORY = Theory((Path(__file__).parent / "theory.txt").read_text(encoding="utf-8"))


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
