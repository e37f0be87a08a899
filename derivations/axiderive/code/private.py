"""The private functions of a module: formulas as lines of code, with the parameters each one needs."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import sympy as sp

from ..entry import Entry
from ..letters import name_of
from ..notation import coefficients
from ..profiles.profile import Profile
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.opaque import Root, SineRoot, named
from ..stable.signs import Facts
from ..stable.slopes import rate_key
from ..stable.variants import FULL, Variant, chosen
from .function import Function
from .text import printable, python

LINE = 116
"""What fits on a line of a function."""
WIDTH = 100
"""The same of a value, beside the word in front of it."""


@dataclass
class PrivateFunctions:
    """Functions of one module in the order they were added."""

    profile: Profile
    functions: dict[str, Function] = field(default_factory=dict)
    common: Variant | None = None
    """The variant of all entries; where there is none each has the chosen one."""

    def __getitem__(self, name: str) -> Function:
        """The function `_name`."""
        return self.functions[name]

    def own(self, entry: Entry) -> Variant:
        """The variant an entry is evaluated in: the common one, or that which measurements chose for its key."""
        return self.common or chosen(entry.key)

    def variant(self, entry: Entry) -> Variant:
        """How the body is written before it is split."""
        return self.own(entry).below

    def rate_variant(self, entry: Entry) -> Variant:
        """That of the rate of growth of the problem with this entry."""
        return self.common or chosen(rate_key(entry))

    def form(self, entry: Entry, expr: sp.Expr, facts: Facts) -> EvaluationForm:
        """The form of a case of an entry in its variant; by all rules where NumPy lacks a function of that."""
        form = evaluation_form(expr, facts, self.variant(entry))
        return form if printable(form) else evaluation_form(expr, facts, FULL)

    @property
    def order(self) -> tuple[str, ...]:
        """Names of the parameters in the order in which functions take them, E_star last."""
        return (*(name_of(symbol) for symbol in self.profile.parameters), "E_star")

    def add(
        self, name: str, fields: Sequence[str], lines: Iterable[str], doc: str = "", returns: str = "Array"
    ) -> Function:
        """Adds and returns `_name`; it takes the parameters that its lines name, and defines abbreviations first."""
        lines = list(lines)
        wanted = set(Function(f"_{name}", fields, [], lines).uses)
        for symbol, definition in self.profile.abbreviations:
            if str(symbol) in wanted:
                lines[:0] = [f"{symbol} = {python(definition)}", *([""] if lines[0].startswith("def ") else [])]
                wanted |= {str(s) for s in definition.free_symbols}
        ordered = tuple(parameter for parameter in self.order if parameter in wanted and parameter not in fields)
        summed = coefficients in self.profile.parameters
        self.functions[name] = Function(f"_{name}", fields, ordered, lines, doc, returns, summed=summed)
        return self.functions[name]

    def of_entry(self, entry: Entry, lines: Iterable[str], doc: str = "") -> Function:
        """Adds and returns the function of an entry."""
        return self.add(entry.quantity.function, [str(own) for own in entry.quantity.arguments], lines, doc)

    def steps(self, form: EvaluationForm, given: Sequence[str] = ()) -> list[str]:
        """The assignments of the intermediates of a form, without those whose names are given."""
        return [f"{name} = {self.definition(expr)}" for name, expr in form.steps if str(name) not in given]

    def returned(self, form: EvaluationForm) -> list[str]:
        """All lines of a function that returns this form."""
        steps = form.steps
        value = form.value
        if steps and value == steps[-1][0]:
            steps, value = steps[:-1], steps[-1][1]
        lines = self.steps(EvaluationForm(steps, value, form.cancels))
        text = self.value_lines(value, lines)
        return [*lines, f"return {text}"]

    @staticmethod
    def value_lines(expr: sp.Expr, lines: list[str]) -> str:
        """The text of a value; what would not fit on a line is named first."""
        text = python(expr)
        if len(text) <= WIDTH:
            return text
        outside, inside = expr.as_independent(sp.Add, sp.Sum, as_Add=False)
        if isinstance(inside, sp.Sum) and outside != 1:
            total = python(inside)
            lines.append(f"terms = ({total.removeprefix('sum(')}")
            return python(outside * named("total")).replace("total", "sum(terms)")
        if inside.is_Add:
            plus = sp.Add(*(term for term in inside.args if not term.could_extract_minus_sign()))
            lines.append(f"plus = {python(plus)}")
            if plus == inside:
                return python(outside * named("plus"))
            lines.append(f"minus = {python(plus - inside)}")
            return python(outside * (named("plus") - named("minus")))
        return text

    def definition(self, expr: sp.Expr) -> str:
        """The text of an intermediate; a root of the difference from an abbreviated b without its rounding."""
        expr = without_subtraction(expr, self.profile.abbreviations)
        return python(through_sine(expr, self.profile.abbreviations))


def without_subtraction(expr: sp.Expr, abbreviations: Sequence[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """The root of R**2 - b**2 as R cos(theta) where b is short for R sin(theta), else the expression itself."""
    if isinstance(expr, Root):
        length, short = expr.args
        for symbol, definition in abbreviations:
            sine = definition / length
            if short == symbol and isinstance(sine, sp.sin):
                return length * sp.cos(sine.args[0])
    return expr


def through_sine(expr: sp.Expr, abbreviations: Sequence[tuple[sp.Symbol, sp.Expr]]) -> sp.Expr:
    """The root of x**2 - b**2 through R and theta where b is short for R sin(theta), else the expression itself."""
    if isinstance(expr, Root):
        length, short = expr.args
        for symbol, definition in abbreviations:
            sines = definition.atoms(sp.sin)
            if short == symbol and len(sines) == 1:
                sine = sines.pop()
                return SineRoot(length, definition / sine, sine.args[0])
    return expr


def parameter_name(symbol: sp.Symbol | sp.IndexedBase) -> str:
    """The name of a parameter in code: that of a symbol, or the letter of indexed coefficients."""
    return str(getattr(symbol, "label", symbol))
