"""The private functions of a module: formulas as lines of code, with the parameters each one needs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..profiles.profile import Profile
from ..stable.forms import EvaluationForm
from ..stable.opaque import Root
from .code import python


@dataclass(frozen=True)
class Private:
    """`_name(fields, needs)` with its lines; `doc` where the name does not say it all."""

    name: str
    fields: tuple[str, ...]
    needs: tuple[str, ...]
    lines: tuple[str, ...]
    doc: str = ""

    def call(self, *fields: str) -> str:
        return f"{self.name}({', '.join([*(fields or self.fields), *self.needs])})"

    def growth(self, *fields: str) -> str:
        """The function of its fields alone, to be integrated."""
        return f"lambda {', '.join(fields)}: {self.call(*fields)}"


@dataclass
class PrivateFunctions:
    """Functions of one module in the order they were added."""

    profile: Profile
    functions: dict[str, Private] = field(default_factory=dict)

    @property
    def order(self) -> tuple[str, ...]:
        return tuple(parameter_name(p) for p in self.profile.parameters) + ("E_star",)

    def add(
        self, name: str, fields: Sequence[str], lines: Iterable[str], needs: Iterable[str], doc: str = ""
    ) -> Private:
        lines, wanted = list(lines), set(needs)
        for symbol, definition in self.profile.abbreviations:
            if str(symbol) in wanted:
                lines.insert(0, f"{symbol} = {python(definition)}")
                wanted = (wanted - {str(symbol)}) | {str(s) for s in definition.free_symbols}
        ordered = tuple(parameter for parameter in self.order if parameter in wanted and parameter not in fields)
        private = Private(f"_{name}", tuple(fields), ordered, tuple(lines), doc)
        self.functions[name] = private
        return private

    def steps(self, form: EvaluationForm, given: Sequence[str] = ()) -> list[str]:
        return [f"{name} = {self.definition(expr)}" for name, expr in form.steps if str(name) not in given]

    def definition(self, expr: sp.Expr) -> str:
        """The text of an intermediate; sqrt(R**2 - b**2) of an abbreviated b without the subtraction."""
        if isinstance(expr, Root):
            length, short = expr.args
            for symbol, definition in self.profile.abbreviations:
                sine = definition / length
                if short == symbol and isinstance(sine, sp.sin):
                    return python(length * sp.cos(sine.args[0]))
        return python(expr)

    def needs(self, form: EvaluationForm, given: Sequence[str]) -> set[str]:
        """Parameters a form needs beyond what is given, with those behind an abbreviated root."""
        used = {parameter_name(symbol) for symbol in form.needs()}
        for name, expr in form.steps:
            text = self.definition(expr)
            if str(name) not in given and text != python(expr):
                used |= {str(s) for _, d in self.profile.abbreviations for s in d.free_symbols}
        return used - set(given)


def parameter_name(symbol: sp.Symbol | sp.IndexedBase) -> str:
    return str(getattr(symbol, "label", symbol))
