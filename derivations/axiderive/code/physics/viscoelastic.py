"""Modules `axicontact.viscoelastic.<profile>`: the elastic contact of unit modulus by the rule of Lee and Radok."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...entry import Entry, Quantity
from ...letters import name_of
from ...physics.viscoelastic import LAWS, QUANTITIES, Law, elastic_exponent, of_depth
from ..text import python
from . import text
from .examples import Example
from .text import Function, NormalModule, evaluate, private

_NAMES = ", ".join(f"{kind}_{law.name}" for kind in ("creep", "ramp", "relaxation") for law in LAWS)
IMPORTS = (
    "interface: Array, Result, elementwise, require, require_coefficients, require_order",
    f"physics.relaxation: {_NAMES}",
)


def module_source(module: NormalModule, entries: Mapping[str, Entry]) -> str:
    """The module of one profile; a ramp only where the force is a power of the depth."""
    example = Example(module.profile, entries, "viscoelastic", module.entries)
    public = [_public(module, entry, example) for entry in entries.values()]
    formulas = [_formula(module, entry.quantity) for entry in entries.values()]
    title = f"{module.profile.title} on a viscoelastic half-space"
    source = text.module(title, module.profile.subtitle, IMPORTS, public, formulas)
    return source.replace(text.NORMAL, module.profile.name)


def formulas_source(module: NormalModule) -> str:
    """What the interface of any profile rests on, which the functions of its normal contact are enough for."""
    ramp = _exponent(module) is not None
    wanted = [quantity for quantity in QUANTITIES.values() if ramp or not quantity.suffix.startswith("ramp")]
    formulas = [_formula(module, quantity) for quantity in wanted]
    source = text.module(module.profile.title, module.profile.subtitle, IMPORTS, [], formulas)
    return source.replace(text.NORMAL, module.profile.name)


def kind_and_law(quantity: Quantity) -> tuple[str, Law]:
    """The loading and the material of a result."""
    kind, suffix = quantity.suffix.split("_")
    return kind, next(law for law in LAWS if law.suffix == suffix)


def _public(module: NormalModule, entry: Entry, example: Example) -> Function:
    symbols = [*entry.quantity.arguments[1:], *entry.parameters]
    keywords, name = [name_of(symbol) for symbol in symbols], entry.quantity.function
    body = [*module.check(symbols), f"return {evaluate(f'_{name}', ['t'], keywords, module.summed)}"]
    notes = f"Valid for {module.profile.validity}, and while the contact grows. Negative or NaN times give NaN."
    if entry.note:
        notes += f" Here {entry.note}: {'; '.join(text.formula(module.entries['ad']))}."
    document = text.document(entry, ["t"], keywords, notes)
    return Function(name, ["t"], keywords, entry.quantity.summary, document, body, example=example.lines(entry.suffix))


def _formula(module: NormalModule, quantity: Quantity) -> str:
    kind, law = kind_and_law(quantity)
    material = [name_of(symbol) for symbol in law.parameters]
    name, needs, passed = f"_{quantity.function}", [*module.geometry, *material], ", ".join(material)
    elastic = "_force_from_depth" if "_force_from_depth" in module.functions else "_force"
    if kind == "step":
        lines = [f"return relaxation_{law.name}(t, {passed}) * {module.call(elastic, 'd', E_star='1.0')}"]
        return private(name, ["t"], ["d", *needs], lines)
    if kind == "load":
        creeping = f"F * creep_{law.name}(t, {passed})"
        lines = [f"return {module.call('_radius_from_force', creeping, E_star='1.0')}"]
        return private(name, ["t"], ["F", *needs], lines)
    return private(name, ["t"], ["v", *needs], _ramp(module, law, elastic, passed))


def _exponent(module: NormalModule) -> sp.Expr | None:
    return elastic_exponent(of_depth(module.entries))


def _ramp(module: NormalModule, law: Law, elastic: str, passed: str) -> list[str]:
    m = _exponent(module)
    assert m is not None
    lines, power = ([], repr(float(m))) if m.is_number else ([f"m = {python(m)}"], "m")
    lines.append(f"force = {module.call(elastic, 'v * t', E_star='1.0')} * ramp_{law.name}(t, {power}, {passed})")
    start = "0.0"
    if law.impulse != 0 and m == 1:
        lines.append("# the viscous part of a force that grows in proportion to the depth does not start from zero")
        start = f"{module.call(elastic, 'v', E_star='1.0')} * {sp.sstr(law.impulse)}"
    return [*lines, f"return np.where(t == 0.0, {start}, force)"]
