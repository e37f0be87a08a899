"""Modules of adhesive contact, and the one curve of all power laws.

Modules `axicontact.adhesive.<profile>`: the normal contact less the retracted punch.

Pull-off and stable branch of a power law: one universal curve for all of them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from ...entry import Entry
from ...letters import name_of
from ...notation import E_star, a, a_c, dgamma, n, r
from ...physics.adhesive import CONTROLS, pull_off_rule
from ...profiles.profile import Profile
from ...stable.forms import EvaluationForm, evaluation_form
from ...stable.signs import facts_of
from .. import docstring
from ..function import Function
from ..text import python, written
from ..writer import Writer, ordered
from . import separation
from .branches import branch_functions


def power_law_functions(module: Writer, entries: Mapping[str, Entry], power: sp.Expr) -> list[Function]:
    """The private functions of pull-off and of the stable radii."""
    needs = [*module.geometry, "E_star", "dgamma"]
    radius = Function("_pull_off_radius", [], [*needs, "control"], _radius(entries, power))
    own = [_pair(module, needs, "depth", "d", power, "0.5"), _pair(module, needs, "force", "F", power + 1, "1.5")]
    return [radius, *(function for pair in own for function in pair)]


def _form(entry: Entry) -> EvaluationForm:
    return evaluation_form(entry.cases[0].expr, facts_of(()))


def _radius(entries: Mapping[str, Entry], power: sp.Expr) -> list[str]:
    forms = {control: _form(entries[suffixes[0]]) for control, suffixes in CONTROLS.items()}
    shared = [step for step in forms["force"].steps if step in forms["depth"].steps]
    lines = [f"{name} = {python(expr)}" for name, expr in shared]
    for head, form in zip(('if control == "force":', "else:"), forms.values(), strict=True):
        own = [f"    {name} = {python(expr)}" for name, expr in form.steps if (name, expr) not in shared]
        lines += [head, *own, f"    radius = {python(form.value)}"]
    value = "np.where(dgamma > 0.0, radius, 0.0)"
    return [*lines, f"return np.where(n > 0.5, {value}, np.nan)" if power == n else f"return {value}"]


def _pair(module: Writer, needs: list[str], quantity: str, field: str, order: sp.Expr, q: str) -> list[Function]:
    """The load at pull-off and the inverse of a load A a**order - B a**q."""
    passed = ", ".join(needs)
    lost = number(2 * order) if order.is_Integer else f"2 * {f'({python(order)})' if order.is_Add else order}"
    load = Function(
        f"_pull_off_{quantity}",
        ["a"],
        [*needs, "control"],
        [f"return {module.call(f'_{quantity}', 'a')} * (1.0 - {lost} / XI[control])"],
        "With the retraction 2 a g'(a)/xi of pull-off, free of cancellation.",
    )
    plain = module.call(f"_radius_from_{quantity}", f"np.maximum({field}, 0.0)")
    inverse = Function(
        f"_radius_from_{quantity}",
        [field],
        needs,
        [
            f'a_c = _pull_off_radius({passed}, control="{quantity}")',
            f'least = _pull_off_{quantity}(a_c, {passed}, control="{quantity}")',
            f"plain = {plain}",
            f"return power_law_radius({field}, a_c, least, {number(order)}, {q}, plain)",
        ],
    )
    return [load, inverse]


def number(expr: sp.Expr) -> str:
    """An exponent, as a float where it is an integer."""
    return repr(float(expr)) if expr.is_Integer else python(expr)


def interface(writer: Writer) -> None:
    """Adds the public functions of a compact contact."""
    own = _Adhesive(writer)
    own.interface()
    separation.interface(writer, own.order())


def rules(writer: Writer) -> None:
    """Adds what they rest on."""
    writer.private += [replace(own, summed=writer.summed) for own in _Adhesive(writer).rules()]
    separation.rules(writer)


def stated(entries: Mapping[str, Entry]) -> list[Entry]:
    """The entries that have a function of their own; the state at pull-off is the result of one."""
    return [entry for entry in entries.values() if not entry.quantity.control]


def exponent(profile: Profile) -> sp.Expr | None:
    """n of a profile that is one power of r, else None."""
    if len(profile.pieces) != 1 or profile.pieces[0].expr.is_Add:
        return None
    power = profile.pieces[0].expr.as_independent(r, as_Add=False)[1]
    base, own = power.as_base_exp()
    return own if base == r else None


class _Adhesive:
    def __init__(self, writer: Writer) -> None:
        self.module, self.entries, self.profile = writer, writer.entries, writer.profile
        self.symbols = [*self.profile.parameters, E_star, dgamma]
        self.keywords = [name_of(symbol) for symbol in self.symbols]
        self.power = exponent(self.profile)

    def interface(self) -> None:
        """Adds the public functions."""
        for entry in stated(self.entries):
            self.public(entry)
        self.pull_off()

    def public(self, entry: Entry) -> None:
        """Adds the public function of one quantity, with its checks."""
        fields = [str(argument) for argument in entry.quantity.arguments]
        keywords = [name_of(symbol) for symbol in entry.parameters]
        body = self.module.checks(entry.parameters)
        # the retraction is the same for every profile
        own = set(self.profile.parameters) <= set(entry.parameters)
        name = f"_{entry.quantity.function}" if own else "hess_retraction"
        notes = f"Valid for {self.profile.validity}. Negative or NaN radii give NaN."
        if entry.quantity.inverts:
            body += self.order()
            signed = dict.fromkeys(fields, fields[0])
            evaluated = self.module.evaluated(name, [], keywords, **signed)
            notes = self.notes_of_inverse()
        else:
            body += self.module.reach() if own else []
            evaluated = self.module.evaluated(name, fields, keywords)
        self.module.add(entry, notes, body, evaluated)

    def order(self) -> list[str]:
        """The check of the exponent, without which there is no stable contact."""
        rule = pull_off_rule(self.profile)
        if rule is None:
            return []
        condition = f"np.asarray({rule.right}) > {float(rule.left)!r}"
        return ordered(condition, f"{rule.right} > {written(rule.left)}", rule.reason, [str(rule.right)])

    def notes_of_inverse(self) -> str:
        """The sentences below an inverse: its validity, and which radius is meant where several are stable."""
        notes = f"Valid for {self.profile.validity}. NaN below pull-off."
        if self.power == n:
            notes += f" {docstring.capital(self.entries['ad'].note)}."
        if self.power is None:
            notes += " Where several radii are stable, the largest, which is reached on unloading."
        return notes

    def rules(self) -> list[Function]:
        """The rule of Hess for each quantity, and the functions of pull-off and of the stable radii."""
        if self.power is None:
            return [*self.hess(), *branch_functions(self.module)]
        return [*self.hess(), *power_law_functions(self.module, self.entries, self.power)]

    def hess(self) -> list[Function]:
        """The rule of Hess for each quantity."""
        call, needs = self.module.call, self.keywords
        normal = {
            "_depth": (["a"], "hess_retraction(a, E_star, dgamma)"),
            "_force": (["a"], "pull(a, E_star, dgamma)"),
            "_pressure": (["r", "a"], "tension(r, a, E_star, dgamma)"),
            "_displacement": (["r", "a"], "lift(r, a, E_star, dgamma)"),
        }
        return [
            Function(name, fields, needs, [f"return {call(name, *fields)} - {loss}"])
            for name, (fields, loss) in normal.items()
        ]

    def pull_off(self) -> None:
        """Adds the public function `pull_off` under control of force or depth."""
        named = ", ".join(f"{name}={name}" for name in self.keywords if not (self.module.summed and name == "A"))
        fixed = "A=A, " if self.module.summed else ""
        body = [*self.module.checks(self.symbols), "require_control(control)"]
        body += self.order()
        body.append(f"radius = elementwise(partial(_pull_off_radius, {fixed}control=control), {named})")
        for name in ("force", "depth"):
            function = f"partial(_{name}, A=A)" if self.module.summed else f"_{name}"
            if self.power is not None:
                function = f"partial(_pull_off_{name}, control=control)"
            body.append(f"{name} = elementwise({function}, radius, {named})")
        body.append("return PullOff(radius, force, depth)")
        doc, control = self.pull_off_document(), 'control: str = "force"'
        self.module.public.append(Function("pull_off", [], self.keywords, body, doc, "PullOff", control))

    def pull_off_document(self) -> str:
        """The docstring of `pull_off`, with the formulas under either control."""
        lines = ["Under control of the force:", "", *self.pull_off_formulas(CONTROLS["force"])]
        lines += ["", "Under control of the depth:", "", *self.pull_off_formulas(CONTROLS["depth"])]
        note = f" {docstring.capital(self.entries['ac'].note)}." if self.power == n else ""
        note += "" if self.power is not None else docstring.SEVERAL
        return docstring.pull_off(lines, self.symbols, self.entries, note, self.module.example.state())

    def pull_off_formulas(self, names: tuple[str, str, str]) -> list[str]:
        """Radius, force and depth at pull-off as indented lines: closed, or the equation of the radius."""
        radius = self.entries[names[0]]
        if radius.status == "closed":
            return [f"    {line}" for suffix in names for line in docstring.stated(self.entries[suffix])]
        level = written(radius.definition.rhs.subs(a, a_c))
        lines = (f"g'(a_c) = {level}", "F = F(a_c)", "d = d(a_c)", "with the depth g(a) without adhesion")
        return [f"    {line}" for line in lines]
