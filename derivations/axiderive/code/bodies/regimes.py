"""Formulas that change their form: before and beyond a break, near and far of it.

The regimes of a compact contact, before and beyond its break, and the growth g' of each as a function.

One form of a function up to some multiple of the break of the profile, another one beyond.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import sympy as sp

from ...abel import masters
from ...entry import Case, Entry
from ...notation import a
from ...profiles.profile import Profile
from ...stable.forms import EvaluationForm, evaluation_form
from ...stable.opaque import Arctan2, Root
from ...stable.signs import Facts, facts_of
from ...stable.slopes import ROOT, slope_form
from ..function import Function
from ..private import PrivateFunctions, without_subtraction
from ..text import printable, python

SMOOTH = 32
"""Nodes of a rule without singularities near."""


@dataclass
class Regimes:
    """What the functions of one compact profile share."""

    entries: Mapping[str, Entry]
    functions: PrivateFunctions

    def __post_init__(self) -> None:
        self.profile = self.entries["d"].profile
        self.summed = self.entries["d"].cases[0].expr.has(sp.Sum)
        self.b = self.profile.breaks[0] if self.profile.breaks else None
        depth = self.regimes("d")
        self.slopes = {key: self._slope(key, case) for key, case in depth.items()} if not self.summed else {}
        if self.summed:
            self._summed_slope(depth["tip"].expr)

    def rules(self) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
        """Both sides of every rule left <= right between the parameters of the profile."""
        return tuple((rule.left, rule.right) for rule in self.profile.rules)

    def facts(self, case: Case) -> Facts:
        """What is known of signs in a case: the order of its lengths and the rules of the profile."""
        return facts_of(case.chain, *self.rules())

    def regimes(self, suffix: str) -> dict[str, Case]:
        """The case of each regime, `tip` for a < b, `beyond` for a > b; the whole contact is `tip` without a break."""
        found: dict[str, Case] = {}
        for case in self.entries[suffix].cases:
            key = "beyond" if self.b is not None and case.chain and case.below(self.b, a) else "tip"
            found.setdefault(key, case)
        return found

    def form(self, suffix: str, key: str) -> EvaluationForm:
        """The evaluation form of a quantity in the regime `tip` or `beyond`; KeyError where it has no such regime."""
        case = self.regimes(suffix)[key]
        return self.functions.form(self.entries[suffix], case.expr, self.facts(case))

    @property
    def rooted(self) -> bool:
        """Whether depth and force are written in a and a root that vanishes at one end of the domain."""
        return self.profile.truncated or (self.b is None and self.scale("tip")[0] == "tanh")

    def scale(self, key: str) -> tuple[str, sp.Expr | None]:
        """Which substitution regularises g' of a regime, and its length."""
        if key == "beyond":
            return "beyond", self.b
        if "tip" not in self.slopes:
            return "", None
        form = self.slopes["tip"][1]
        for _, expr in form.steps:
            if isinstance(expr, Root):
                return "tanh", expr.args[0]
            if isinstance(expr, Arctan2):
                return "sinh", expr.args[1]
        return ("waves", None) if form.value.has(masters.StruveH) else ("", None)

    def _slope(self, key: str, case: Case) -> tuple[Function, EvaluationForm]:
        """The function in its variant, and the form by all rules, which tells its singularities."""
        plain = slope_form(case.expr, self.facts(case))
        form = slope_form(case.expr, self.facts(case), self.functions.rate_variant(self.entries["d"]))
        form = form if printable(form) else plain
        rooted = any(str(name) == ROOT for name, _ in plain.steps)
        fields = ("t", "root") if rooted or key == "beyond" else ("t",)
        lines = self.functions.steps(form, fields)
        text = self.functions.value_lines(form.value, lines)
        lines.append(f"return {text}")
        name = "slope_beyond" if key == "beyond" else "slope"
        doc = "Rate g'(t) of the indentation depth g(t)" + (f" for t > {self.b}." if key == "beyond" else ".")
        return self.functions.add(name, fields, lines, doc), plain

    def _summed_slope(self, depth: sp.Expr) -> None:
        """Term by term for a polynomial."""
        slope = depth.replace(
            lambda e: isinstance(e, sp.Sum), lambda e: sp.Sum(sp.powsimp(sp.diff(e.function, a)), *e.limits)
        )
        form = evaluation_form(slope, facts_of((a,)))
        self.functions.add("slope", ("a",), [f"return {python(form.value)}"], "Rate g'(a) of the indentation depth.")

    def root_pair(self) -> tuple[str, str]:
        """The texts of x and y in sqrt(x**2 - y**2), the root that depth and force are written in."""
        return ("a", str(self.b)) if self.profile.truncated else (str(self.scale("tip")[1]), "a")

    def domain(self) -> str:
        """The condition on the contact radius, "" where there is none."""
        if self.profile.truncated:
            return f"a >= {self.b}"
        if self.profile.largest is not None:
            return f"a <= {python(self.profile.largest)}"
        kind, length = self.scale("tip")
        return f"a <= {length}" if kind == "tanh" and self.b is None else ""

    def _limited(self, name: str, lines: list[str]) -> Function:
        """NaN beyond the largest contact radius."""
        if self.profile.largest is not None:
            value = lines.pop().removeprefix("return ")
            lines.append(f"return np.where({self.domain()}, {value}, np.nan)")
        return self.functions.add(name, ("a",), lines)

    def _moved(self, form: EvaluationForm, radius: str) -> tuple[EvaluationForm, list[str]]:
        """The form of the tip for another name of its radius, and its steps.

        A root that vanishes at the end of an arc is taken from the angle of the break where the tip is whole.
        """
        symbol = sp.Symbol(radius, positive=True)
        moved = EvaluationForm(
            tuple((name, expr.subs(a, symbol)) for name, expr in form.steps), form.value.subs(a, symbol), False
        )
        steps = self.functions.steps(moved)
        for i, (name, expr) in enumerate(form.steps if self.b is not None else ()):
            whole = without_subtraction(expr.subs(a, self.b), self.profile.abbreviations)
            if isinstance(expr, Root) and not isinstance(whole, Root):
                steps[i] = f"{name} = np.where(a < {self.b}, {python(moved.steps[i][1])}, {python(whole)})"
        return moved, steps

    @property
    def strip(self) -> str:
        """The last argument of a rule beyond the break, if there is one."""
        return strip_width(self.profile)


def strip_width(profile: Profile) -> str:
    """The last argument of a rule beyond the break.

    Where b = R sin(theta), g' has a singularity at root = i R cos(theta), that is at pi/2 - theta.
    """
    sines = [expr.atoms(sp.sin) for symbol, expr in profile.abbreviations if symbol == profile.breaks[0]]
    angles = [python(sine.args[0]) for found in sines for sine in found]
    return f", width=1.0 - 2.0 * {angles[0]} / np.pi" if angles else ""


Bodies = Callable[[PrivateFunctions, Mapping[str, Entry]], object]


def split(functions: PrivateFunctions, entries: Mapping[str, Entry], bodies: Bodies) -> None:
    """Join the functions whose chosen form is that of one side of a split with those of the other side."""
    for entry in entries.values():
        variant = functions.own(entry)
        if variant.beyond:
            above = PrivateFunctions(functions.profile, common=variant.above)
            bodies(above, entries)
            _join(functions, above, entry.quantity.function, variant.beyond)


def _join(functions: PrivateFunctions, above: PrivateFunctions, name: str, beyond: float) -> None:
    """Split one function where a reaches so many times the break."""
    low, high = functions[name], above[name]
    known, b = functions.functions, functions.profile.breaks[0]
    sides = [replace(side, name=f"{low.name}_{end}") for side, end in ((low, "below"), (high, "above"))]
    del known[name]
    known |= {side.name.removeprefix("_"): side for side in sides}
    value = f"np.where(a < {beyond!r} * {b}, {sides[0].call()}, {sides[1].call()})"
    functions.add(name, low.fields, [f"return {value}"])
