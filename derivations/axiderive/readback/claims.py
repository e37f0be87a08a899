"""What a printed text has to say, found without its LaTeX, and the one comparison of the two."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import mpmath as mp

from .grammar import read
from .meaning import Environment, environment

WORKING = 60
"""Working digits; an integrand that is infinite like a root at its end leaves half of them."""
DIGITS = 30
"""Of the values that are compared with."""
CLOSE = mp.mpf(10) ** -20
"""A statement agrees with the engine to twenty digits or it does not agree."""


@dataclass(frozen=True)
class Line:
    """A formula, number or phrase in print, and whether any text in its place is wrong."""

    place: str
    tex: str
    wrong: Callable[[str], bool]


@dataclass(frozen=True)
class Claim:
    """What a formula has to say where names have these values."""

    env: Environment
    want: Any = None
    """The value of every member, or one for each; None of an equation, whose members are equal."""
    name: str = ""
    """What stands on the left as the grammar reads it, p(r); the members behind it must do without its value."""
    close: Any = CLOSE

    def residual(self, tex: str) -> Any:
        """The largest relative difference of a member.

        Raises
        ------
        SyntaxError, LookupError
            If the text cannot be read, uses what nothing defines, or has no left side where one is wanted.
        """
        first, *definitions = read(tex)
        env = environment(definitions, self.env)
        members = first.members
        if len(members) == 1 and (self.name or self.want is None):
            message = f"{tex} is not of the form {self.name or 'left'} = value"
            raise SyntaxError(message)
        if self.want is None:
            value = members[-1](env)
            return max(difference(member(env), value) for member in members[:-1])
        own = bound(self.name, self.want, env) if self.name else env
        wanted = self.want if isinstance(self.want, tuple) else (self.want,) * len(members)
        found = (member(env if i else own) for i, member in enumerate(members))
        return max(difference(value, want) for value, want in zip(found, wanted, strict=True))

    def wrong(self, tex: str) -> bool:
        """Whether a text says something else; a value that is no number is none of the right ones."""
        with mp.workdps(WORKING):
            return not self.residual(tex) <= self.close

    def line(self, place: str, tex: str) -> Line:
        """The text in print with its claim."""
        return Line(place, tex, self.wrong)


def difference(got: Any, want: Any) -> Any:
    """Relative difference of two values; absolute where the wanted one is zero."""
    return abs(got - want) / abs(want) if want else abs(got)


def bound(name: str, value: Any, env: Mapping[str, Any]) -> dict[str, Any]:
    """The names of a point with one of them, or a function at one argument, bound to a value."""
    function, _, argument = name.partition("(")
    if not argument:
        return {**env, name: value}
    return {**env, f"{function}()": _at(name, value, env[argument.rstrip(")")])}


def _at(name: str, value: Any, place: Any) -> Callable[[Any], Any]:
    """A function that is known at one place only."""

    def known(argument: Any) -> Any:
        if argument != place:
            message = f"the row states {name}, and not its value at {argument}"
            raise LookupError(message)
        return value

    return known
