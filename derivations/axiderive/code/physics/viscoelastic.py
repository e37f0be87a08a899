"""Modules `axicontact.viscoelastic.<profile>`: the elastic contact of unit modulus by the rule of Lee and Radok."""

from __future__ import annotations

import sympy as sp

from ...entry import Quantity
from ...letters import name_of
from ...physics.viscoelastic import LAWS, QUANTITIES, Law, elastic_exponent, of_depth
from .. import docstring
from ..text import python
from ..writer import Writer


def interface(writer: Writer) -> None:
    """Adds the public functions; a ramp only where the force is a power of the depth."""
    profile = writer.profile
    for entry in writer.entries.values():
        held = entry.arguments[1:]
        notes = f"Valid for {profile.validity}, and while the contact grows. Negative or NaN times give NaN."
        if entry.note:
            notes += f" Here {entry.note}: {'; '.join(docstring.stated(writer.plain['ad']))}."
        writer.add(entry, notes, writer.checks([*held, *entry.parameters]), held=held)


def rules(writer: Writer) -> None:
    """Adds what the interface of any profile rests on, which the functions of its normal contact are enough for."""
    known = {"ramp": _exponent(writer) is not None, "load": "_radius_from_force" in writer.normal, "step": True}
    for quantity in QUANTITIES.values():
        if known[kind_and_law(quantity)[0]]:
            _rule(writer, quantity)


def kind_and_law(quantity: Quantity) -> tuple[str, Law]:
    """The loading and the material of a result."""
    kind, suffix = quantity.suffix.split("_")
    return kind, next(law for law in LAWS if law.suffix == suffix)


def _rule(writer: Writer, quantity: Quantity) -> None:
    kind, law = kind_and_law(quantity)
    material = [name_of(symbol) for symbol in law.parameters]
    name, needs, passed = f"_{quantity.function}", [*writer.geometry, *material], ", ".join(material)
    elastic = "_force_from_depth" if "_force_from_depth" in writer.normal else "_force"
    if kind == "step":
        lines = [f"return relaxation_{law.name}(t, {passed}) * {writer.call(elastic, 'd', E_star='1.0')}"]
        writer.rule(name, ["t"], ["d", *needs], lines)
    elif kind == "load":
        creeping = f"F * creep_{law.name}(t, {passed})"
        lines = [f"return {writer.call('_radius_from_force', creeping, E_star='1.0')}"]
        writer.rule(name, ["t"], ["F", *needs], lines)
    else:
        writer.rule(name, ["t"], ["v", *needs], _ramp(writer, law, elastic, passed))


def _exponent(writer: Writer) -> sp.Expr | None:
    return elastic_exponent(of_depth(writer.plain))


def _ramp(writer: Writer, law: Law, elastic: str, passed: str) -> list[str]:
    m = _exponent(writer)
    assert m is not None
    lines, power = ([], repr(float(m))) if m.is_number else ([f"m = {python(m)}"], "m")
    lines.append(f"force = {writer.call(elastic, 'v * t', E_star='1.0')} * ramp_{law.name}(t, {power}, {passed})")
    start = "0.0"
    if law.impulse != 0 and m == 1:
        lines.append("# the viscous part of a force that grows in proportion to the depth does not start from zero")
        start = f"{writer.call(elastic, 'v', E_star='1.0')} * {sp.sstr(law.impulse)}"
    return [*lines, f"return np.where(t == 0.0, {start}, force)"]
