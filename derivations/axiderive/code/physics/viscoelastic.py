"""Modules `axicontact.viscoelastic.<profile>`: the elastic contact of unit modulus by the rule of Lee and Radok."""

from __future__ import annotations

from itertools import pairwise

import sympy as sp

from ...entry import Quantity
from ...letters import name_of
from ...notation import t_1, t_h, t_m, v_2
from ...physics.viscoelastic import LAWS, QUANTITIES, Law, elastic_exponent, of_depth, ramped
from .. import docstring
from ..text import python, written
from ..writer import Writer


def interface(writer: Writer) -> None:
    """Adds the public functions; a ramp, and the way back, where the contact grows from a point or a flat face."""
    profile = writer.profile
    for entry in writer.entries.values():
        held, back = entry.arguments[1:], v_2 in entry.parameters
        when = RETURNED if back else "and while the contact grows."
        notes = f"Valid for {profile.validity}, {when}" + " Negative or NaN times give NaN." * bool(entry.arguments)
        if entry.quantity.symbol == t_1:
            notes += " Here t_1 is t up to t_m, and t_m while the depth is held."
        elif back and entry.arguments:
            law = kind_and_law(entry.quantity)[1]
            notes += f" Here t_1 is earlier_time_{law.name}; up to t_m it is t, and the force that of the ramp."
        if entry.note:
            notes += f" Here {entry.note}: {'; '.join(docstring.stated(writer.plain['ad']))}."
        hold = [f"{t_h} = require_hold({t_m}, {t_h})"] if back else []
        writer.add(entry, notes, [*hold, *writer.checks([*held, *entry.parameters])], held=held)


def rules(writer: Writer) -> None:
    """Adds what the interface of any profile rests on, which the functions of its normal contact are enough for."""
    known = dict.fromkeys(("ramp", "earlier", "end", "retract"), ramped(writer.plain)) | {
        "step": True, "load": "_radius_from_force" in writer.normal, "radius": writer.profile.compact,
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
        if _exponent(writer) is None and law.impulse == 0:
            _springs(writer, law, needs, passed)
        writer.rule(name, ["t"], ["v", *needs], _ramp(writer, law, elastic, passed))
    else:
        _way_back(writer, name, kind, law)


def _way_back(writer: Writer, name: str, kind: str, law: Law) -> None:
    """In t_1; a force on the way in is that of the ramp."""
    material = [name_of(symbol) for symbol in law.parameters]
    passed, back = ", ".join(material), ["v", "v_2", "t_m", "t_h"]
    own = [*back, *(writer.geometry if kind in ("radius", "retract") else ()), *material]
    lag = f"lag_{law.name}(t, t_m, t_h, v_2 / v, {passed})"
    if kind == "end":
        writer.rule(name, [], own, [f"return end_{law.name}(v_2 / v, t_m, t_h, {passed})"])
    elif kind == "earlier":
        writer.rule(name, ["t"], own, [f"return earlier(t, t_m, {lag})"])
    elif kind == "radius":
        radius = writer.call("_radius_from_depth", "v * t_1")
        lines = [f"t_1 = earlier(t, t_m, {lag})", f"return np.where(t_1 <= 0.0, 0.0, {radius})"]
        writer.rule(name, ["t"], own, lines)
    else:
        lines = [f"lag = {lag}", "t_1 = earlier(t, t_m, lag)", *_force_back(writer, law, material)]
        writer.rule(name, ["t"], own, lines)


def _force_back(writer: Writer, law: Law, material: list[str]) -> list[str]:
    elastic = "_force_from_depth" if "_force_from_depth" in writer.normal else "_force"
    since, passed, own = "passed(t, t_m, lag)", ", ".join(material), ", ".join(["v", *writer.geometry, *material])
    force, power = writer.call(elastic, "v * t_1", E_star="1.0"), _exponent(writer)
    if power is None and law.impulse == 0:
        return [
            f"since = np.where(t > t_m, {since}, 0.0)",
            f"return np.where(t_1 > 0.0, _pressed_{law.name}(t_1, since, {own}), 0.0)",
        ]
    if power is None:
        lines, kept = list[str](), python(law.relaxation)
    else:
        lines, degree = _degree(power)
        lines, kept = [*lines, f"kept = kept_{law.name}(t, t_1, {since}, {degree}, {passed})"], "kept"
    ramp = f"_ramp_force_{law.name}(t, {own})"
    back = f"back = np.where((t > t_m) & (t_1 > 0.0), {force} * {kept}, 0.0)"
    return [*lines, back, f"return np.where(t > t_m, back, {ramp})"]


RETURNED = (
    "a ramp up to t_m, a depth that is held up to t_h and then a constant speed back, so that the contact has one "
    "maximum, and no adhesion."
)


def _exponent(writer: Writer) -> sp.Expr | None:
    return elastic_exponent(of_depth(writer.plain))


def _degree(m: sp.Expr) -> tuple[list[str], str]:
    """The exponent of the depth in the force, and the lines that it needs."""
    return ([], repr(float(m))) if m.is_number else ([f"m = {python(m)}"], "m")


def _springs(writer: Writer, law: Law, needs: list[str], passed: str) -> None:
    """Adds what springs bear that were pressed in up to t_1, in stretches that end at the breaks of the profile."""
    profile, left = writer.profile, f"left_{law.name}"
    terms, depth = list[str](), writer.call("_depth", "x")
    if writer.summed:
        # what does not change with x stands in front
        terms = ["terms = [(j, depth_over_height(j) * A_j) for j, A_j in enumerate(A, 1)]"]
        depth = "sum(A_j * x**j for j, A_j in terms)"
    lines = [
        f"a = {writer.call('_radius_from_depth', 'v * t_1')}", *terms, "", "def left(x: Array) -> Array:",
        f"    pressed = t_1 - {depth} / v",
        f"    return {left}(np.maximum(pressed, 0.0), since, {passed})", "",
    ]  # fmt: skip
    ends = ["0.0 * a", *(f"np.minimum(a, {b})" for b in profile.breaks), "a"]
    parts = [f"springs(left, {low}, {high})" for low, high in pairwise(ends)]
    if profile.truncated:
        parts[0] = f"{profile.breaks[0]} * {left}(t_1, since, {passed})"
    total = parts[0] if len(parts) == 1 else f"({' + '.join(parts)})"
    writer.rule(f"_pressed_{law.name}", ["t_1", "since"], ["v", *needs], [*lines, f"return 2.0 * v * {total}"])


def _ramp(writer: Writer, law: Law, elastic: str, passed: str) -> list[str]:
    power, force = _exponent(writer), writer.call(elastic, "v * t", E_star="1.0")
    if power is None and law.impulse == 0:
        return [f"return _pressed_{law.name}({', '.join(['t', '0.0 * t', 'v', *writer.geometry, passed])})"]
    if power is None:
        radius = writer.call("_radius_from_depth", "v * t")
        return [f"return {python(law.relaxation)} * {force} + 2.0 * v * {python(law.impulse)} * {radius}"]
    lines, degree = _degree(power)
    lines.append(f"force = {force} * ramp_{law.name}(t, {degree}, {passed})")
    start = "0.0"
    if law.impulse != 0 and power == 1:
        lines.append("# the viscous part of a force that grows in proportion to the depth does not start from zero")
        start = f"{writer.call(elastic, 'v', E_star='1.0')} * {written(law.impulse)}"
    return [*lines, f"return np.where(t == 0.0, {start}, force)"]
