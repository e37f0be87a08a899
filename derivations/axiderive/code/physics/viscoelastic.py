"""Modules `axicontact.viscoelastic.<profile>`: the elastic contact of unit modulus by the rule of Lee and Radok."""

from __future__ import annotations

import sympy as sp

from ...entry import Quantity
from ...letters import name_of
from ...notation import t_1, v_2
from ...physics.viscoelastic import LAWS, QUANTITIES, Law, elastic_exponent, of_depth
from .. import docstring
from ..text import python
from ..writer import Writer


def interface(writer: Writer) -> None:
    """Adds the public functions; a ramp, and the way back, only where the force is a power of the depth."""
    profile = writer.profile
    for entry in writer.entries.values():
        held = entry.arguments[1:]
        when = RETURNED if v_2 in entry.parameters else "and while the contact grows."
        notes = f"Valid for {profile.validity}, {when}" + " Negative or NaN times give NaN." * bool(entry.arguments)
        if any(case.expr.has(t_1) for case in entry.cases) and entry.quantity.symbol != t_1:
            law = kind_and_law(entry.quantity)[1]
            notes += f" Here t_1 is earlier_time_{law.name}; up to t_m it is t, and the force that of the ramp."
        if entry.note:
            notes += f" Here {entry.note}: {'; '.join(docstring.stated(writer.plain['ad']))}."
        writer.add(entry, notes, writer.checks([*held, *entry.parameters]), held=held)


def rules(writer: Writer) -> None:
    """Adds what the interface of any profile rests on, which the functions of its normal contact are enough for."""
    power = _exponent(writer) is not None
    known = {
        "ramp": power, "load": "_radius_from_force" in writer.normal, "step": True,
        "earlier": power, "end": power, "retract": power, "radius": power and writer.profile.compact,
    }  # fmt: skip
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
    elif kind == "ramp":
        writer.rule(name, ["t"], ["v", *needs], _ramp(writer, law, elastic, passed))
    else:
        _way_back(writer, name, kind, law)


def _way_back(writer: Writer, name: str, kind: str, law: Law) -> None:
    """In t_1; a force on the way in is that of the ramp."""
    material = [name_of(symbol) for symbol in law.parameters]
    passed, back = ", ".join(material), ["v", "v_2", "t_m"]
    own = [*back, *(writer.geometry if kind in ("radius", "retract") else ()), *material]
    lag = f"lag_{law.name}(t, t_m, v_2 / v, {passed})"
    if kind == "end":
        writer.rule(name, [], own, [f"return end_{law.name}(v_2 / v, t_m, {passed})"])
    elif kind == "earlier":
        writer.rule(name, ["t"], own, [f"return earlier(t, t_m, {lag})"])
    elif kind == "radius":
        radius = writer.call("_radius_from_depth", "v * t_1")
        lines = [f"t_1 = earlier(t, t_m, {lag})", f"return np.where(t_1 <= 0.0, 0.0, {radius})"]
        writer.rule(name, ["t"], own, lines)
    else:
        lines, power = _degree(writer)
        elastic = "_force_from_depth" if "_force_from_depth" in writer.normal else "_force"
        ramp = f"_ramp_force_{law.name}({', '.join(['t', 'v', *writer.geometry, *material])})"
        lines += [
            f"lag = {lag}",
            "t_1 = earlier(t, t_m, lag)",
            f"kept = kept_{law.name}(t, t_1, passed(t, t_m, lag), {power}, {passed})",
            f"back = {writer.call(elastic, 'v * t_1', E_star='1.0')} * kept",
            f"return np.where(t > t_m, np.where(t_1 > 0.0, back, 0.0), {ramp})",
        ]
        writer.rule(name, ["t"], own, lines)


RETURNED = "a ramp up to t_m and then a constant speed back, so that the contact has one maximum, and no adhesion."


def _exponent(writer: Writer) -> sp.Expr | None:
    return elastic_exponent(of_depth(writer.plain))


def _degree(writer: Writer) -> tuple[list[str], str]:
    """The exponent of the depth in the force, and the lines that it needs."""
    m = _exponent(writer)
    assert m is not None
    return ([], repr(float(m))) if m.is_number else ([f"m = {python(m)}"], "m")


def _ramp(writer: Writer, law: Law, elastic: str, passed: str) -> list[str]:
    lines, power = _degree(writer)
    lines.append(f"force = {writer.call(elastic, 'v * t', E_star='1.0')} * ramp_{law.name}(t, {power}, {passed})")
    start = "0.0"
    if law.impulse != 0 and _exponent(writer) == 1:
        lines.append("# the viscous part of a force that grows in proportion to the depth does not start from zero")
        start = f"{writer.call(elastic, 'v', E_star='1.0')} * {sp.sstr(law.impulse)}"
    return [*lines, f"return np.where(t == 0.0, {start}, force)"]
