"""What the functions of one module are written with: its system, its profile and the normal contact below it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import sympy as sp

from ..entry import Entry
from ..letters import name_of
from ..notation import coefficients
from ..physics.systems import System
from ..profiles.profile import Profile
from . import docstring
from .example import Example
from .function import Function, literal
from .module import Module
from .private import parameter_name
from .tables import OPTIONAL
from .text import python, written

GRADED = " on a power-law graded half-space"
"""What titles of modules say behind that of the profile."""


def required(symbols: Iterable[sp.Symbol | sp.IndexedBase], check: str = "require") -> str:
    """The check of these parameters."""
    return f"{check}({', '.join(f'{parameter_name(symbol)}={name_of(symbol)}' for symbol in symbols)})"


def unused(names: Iterable[str]) -> list[str]:
    """The argument of `elementwise` for parameters on which the value does not depend, if there are any."""
    given = "".join(f"{name}, " for name in names)
    return [f"unused=({given.strip() if given.count(',') == 1 else given.strip(', ')})"] if given else []


def ordered(condition: str, relation: str, reason: str, names: Iterable[str]) -> list[str]:
    """The check of a condition between parameters, the relation as a message shows it and what to use instead."""
    given = [f"    {name}={name}," for name in names]
    return ["require_order(", f"    {condition},", f'    "{relation}",', *literal(reason), *given, ")"]


def not_above(low: str, high: str, reason: str) -> list[str]:
    """The check that one length is not above another."""
    condition = f'np.all(~(numbers("{low}", {low}) > numbers("{high}", {high})))'
    return ordered(condition, f"{low} <= {high}", reason, (low, high))


def check(profile: Profile) -> Function:
    """The function `_check`, which checks the parameters and the rules between them."""
    names = [name_of(symbol) for symbol in profile.parameters]
    passed = ", ".join(f"{name}={name}" for name in names)
    lines = [f"require({passed}, **material)"]
    for rule in profile.rules:
        symbols = sorted((str(s) for s in (rule.left.free_symbols | rule.right.free_symbols)), key=names.index)
        relation = written(rule.relation())
        arrays = ", ".join(f"np.asarray({name})" for name in symbols)
        lines.append(f"{', '.join(symbols)} = {arrays}")
        sign, left, right = "<" if rule.strict else "<=", rule.left, rule.right
        if left.is_number:
            sign, left, right = sign.replace("<", ">"), right, left
        lines += ordered(f"{python(left)} {sign} {python(right)}", relation, rule.reason, symbols)
    typed = [f"{name}: ArrayLike" for name in names]
    return Function("_check", typed, ["**material: ArrayLike"], lines, returns="None")


@dataclass
class Writer:
    """The functions of one module, public and private.

    `plain` are the entries of the normal contact, and `normal` says what each private function of its module takes.
    """

    system: System
    entries: Mapping[str, Entry]
    plain: Mapping[str, Entry]
    normal: Mapping[str, Sequence[str]] = field(default_factory=dict)
    public: list[Function] = field(default_factory=list)
    private: list[Function] = field(default_factory=list)

    @cached_property
    def profile(self) -> Profile:
        """The profile of its entries."""
        return next(iter(self.plain.values())).profile

    @property
    def geometry(self) -> list[str]:
        """Names of the parameters of the profile, as the interface has them."""
        return [name_of(symbol) for symbol in self.profile.parameters]

    @property
    def summed(self) -> bool:
        """Whether the profile is a polynomial, whose coefficients are passed as one tuple A."""
        return coefficients in self.profile.parameters

    @cached_property
    def example(self) -> Example:
        """The doctests of this module."""
        return Example(self.profile, self.entries, self.system, self.plain)

    def call(self, function: str, *fields: str, **given: str) -> str:
        """The call of a private function of the normal contact, its leading arguments replaced by `fields`."""
        rest = self.normal[function][len(fields) :]
        return f"normal.{function}({', '.join([*fields, *(given.get(name, name) for name in rest)])})"

    def checks(self, symbols: Sequence[sp.Symbol], *, reach: bool = False) -> list[str]:
        """The lines that check parameters, those of the geometry with the rules between them."""
        lines = ["A = require_coefficients(A)"] if coefficients in symbols else []
        plain = [symbol for symbol in symbols if symbol != coefficients]
        ruled = bool(self.profile.rules) and set(self.profile.parameters) <= set(symbols)
        own = "normal._check" if self.system.base else "_check"
        lines += [required(plain, own if ruled else "require")] if plain else []
        return [*lines, *self.reach()] if reach else lines

    def reach(self) -> list[str]:
        """The check of a contact radius that is never smaller than the flat face, where there is one."""
        below = (self.system.base or self.system).name
        punch = "" if below == "normal" else f', "{below}.flat_punch"'
        return [f"require_reach(a, {self.profile.breaks[0]}{punch})"] if self.profile.truncated else []

    def evaluated(
        self,
        name: str,
        fields: Sequence[str],
        keywords: Sequence[str],
        wrapper: str = "elementwise",
        words: Sequence[str] = (),
        **given: str,
    ) -> str:
        """The evaluation of a private function, or of one of the run time, over arrays.

        Keywords that the function does not take have a say in the shape alone; for some of those it takes, or for
        fields that may be negative and go by name, other values are `given`.  Coefficients that are summed, and
        `words`, are no arrays.
        """
        private = next((own for own in self.private if own.name == name), None)
        taken = [*(word for word in given if word not in keywords), *keywords]
        used = [word for word in taken if private is None or word in private.parameters]
        summed = self.summed and "A" in used
        passed = [f"{word}={given.get(word, word)}" for word in used if not (summed and word == "A")]
        apart = [word for word in keywords if word not in used and not (self.summed and word == "A")]
        bound = [f"{word}={word}" for word in (*(["A"] if summed else []), *words)]
        called = f"partial({', '.join([name, *bound])})" if bound else name
        return f"{wrapper}({', '.join([called, *fields, *passed, *unused(apart)])})"

    def add(
        self,
        entry: Entry,
        notes: str,
        checks: Sequence[str],
        evaluated: str = "",
        held: Sequence[sp.Symbol] = (),
    ) -> None:
        """A public function that one entry backs; arguments that are `held` are keywords, as its parameters are."""
        quantity, symbols = entry.quantity, [*held, *entry.parameters]
        fields = [name_of(symbol) for symbol in entry.arguments if symbol not in held]
        names = [name_of(symbol) for symbol in symbols]
        doc = docstring.of_entry(entry, symbols, notes, self.example.lines(entry.suffix))
        body = [*checks, f"return {evaluated or self.evaluated(f'_{quantity.function}', fields, names)}"]
        needs = [name_of(symbol) + ": ArrayLike | None = None" * (symbol in OPTIONAL) for symbol in symbols]
        self.public.append(Function(quantity.function, fields, needs, body, doc, "Result"))

    def rule(
        self,
        name: str,
        fields: Sequence[str],
        needs: Sequence[str],
        lines: Sequence[str],
        doc: str = "",
        returns: str = "Array",
        decorator: str = "",
    ) -> None:
        """A private function; lengths that are no parameters are defined first."""
        function = Function(name, fields, needs, lines, doc, returns, summed=self.summed, decorator=decorator)
        own = [f"{s} = {python(expr)}" for s, expr in self.profile.abbreviations if str(s) in function.uses]
        self.private.append(replace(function, lines=[*own, *lines]))

    def module(self) -> Module:
        """The module of these functions."""
        system, profile = self.system, self.profile
        contact = f" {system.physics.contact}" if system.physics.over else ""
        title = f"{profile.title}{contact}{GRADED if system.medium.graded else ''}"
        return Module(system, profile.name, title, profile.subtitle, self.public, self.private)
