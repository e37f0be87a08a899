"""Contact with a layer on a rigid base: that with the half-space, and what the equation of the springs adds."""

from __future__ import annotations

import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...letters import name_of
from ...physics.layer import BASES, EQUATION
from .. import docstring
from ..function import Function
from ..text import python
from ..writer import Writer

BASE = f'base: str = "{BASES[0]}"'
NOTES = (
    "The springs below the surface are pressed in by spring(t) = {}, which is zero {}. Valid for {}; {}. One linear "
    "system for each contact, a <= 20 thickness. Negative or NaN field values give NaN."
)


def interface(writer: Writer) -> None:
    """Adds a public function for every entry."""
    ends = "beyond t = a" if writer.profile.complete else "at t = a"
    notes = NOTES.format(sp.sstr(EQUATION), ends, writer.profile.validity, writer.system.physics.assumed)
    for entry in writer.entries.values():
        quantity, fields = entry.quantity, list(map(name_of, entry.arguments))
        names = [name_of(symbol) for symbol in entry.parameters]
        evaluated = writer.evaluated(f"_{quantity.function}", fields, names, words=("base",))
        reach = "a" in fields
        body = [*writer.checks(entry.parameters, reach=reach), "require_base(base)", f"return {evaluated}"]
        doc = docstring.of_entry(entry, entry.parameters, notes, writer.example.lines(entry.suffix), _base())
        writer.public.append(Function(quantity.function, fields, [*names, BASE], body, doc, "Result"))


def _base() -> list[str]:
    choice = ", ".join(f'"{own}"' for own in BASES)
    return [f"base : {{{choice}}}", "    How the layer lies on what is below it."]


def rules(writer: Writer) -> None:
    """Adds what the layer changes of one contact, and what follows from that."""
    geometry, layer = writer.geometry, ["nu", "thickness", "base"]
    for name, (fields, lines) in (_punch if writer.profile.complete else _curved)(writer).items():
        entry = _named(writer, name)
        elastic = ["E_star"] if entry.quantity.elastic else []
        writer.rule(f"_{name}", fields, [*geometry, *elastic, *layer], lines)


def _named(writer: Writer, function: str) -> Entry:
    return next(own for own in writer.entries.values() if own.quantity.function == function)


Lines = dict[str, tuple[list[str], list[str]]]


def _punch(writer: Writer) -> Lines:
    """By the function, its fields and lines; only the stiffness is another one."""
    _contact(writer, [], "")
    state = "found = _contact(a, nu, thickness, base)"
    pressure = f'{writer.call("_pressure", "r", "d")} * found.of("edge") + E_star * d * found.pressure(r)'
    return {
        "force": (["d"], [state, 'return E_star * d * found.of("stiffness")']),
        "pressure": (["r", "d"], [state, f"return {pressure}"]),
        "depth_from_force": (["F"], [state, 'return F / (E_star * found.of("stiffness"))']),
    }


def _contact(writer: Writer, geometry: list[str], shape: str) -> None:
    line, doc = f"return on_layer(a, thickness, nu, base{shape})", "What the layer changes of a contact of radius a."
    writer.rule("_contact", ["a"], [*geometry, "nu", "thickness", "base"], [line], doc, "State", "of_states")


def _curved(writer: Writer) -> Lines:
    profile, own = writer.profile, [*writer.geometry, "nu", "thickness", "base"]
    depth, breaks = writer.call("_depth", "t"), [python(b) for b in profile.breaks]
    if profile.truncated:
        depth = f"np.where(t > {breaks[0]}, {depth}, 0.0)"
    kinks = f", ({', '.join(breaks)},)" if breaks else ""
    _contact(writer, writer.geometry, f", lambda t: {depth}{kinks}")
    end = profile.largest or (profile.chain[-1] if nt.a in profile.chain else None)

    def state(place: str) -> str:
        return f"found = _contact({', '.join([place, *own])})"

    def searched(value: str) -> list[str]:
        """By a curve and its logarithmic slope, from the radius on the half-space."""
        elastic = value == "F"
        curve = f'{writer.call("_force", "t")} + E_star * found.of("more")'
        rate = 'E_star * found.of("stiffness") * found.of("rate")'
        if not elastic:
            curve, rate = f'{writer.call("_depth", "t")} - found.of("less")', 'found.of("rate")'
        start = writer.call("_radius_from_force" if elastic else "_radius_from_depth", value)
        return [
            "def curve(t: Array) -> tuple[Array, Array]:",
            f"    {state('t')}",
            f"    value = {curve}",
            f"    return value, t * {rate} / value",
            "",
            f"return radius_on_layer(curve, {value}, {start}, thickness, {'np.inf' if end is None else python(end)})",
        ]

    by_depth = f"_radius_from_depth({', '.join(['d', *own])})"
    elastic = ", ".join([*writer.geometry, "E_star", "nu", "thickness", "base"])
    return {
        "depth": (["a"], [state("a"), f'return {writer.call("_depth", "a")} - found.of("less")']),
        "force": (["a"], [state("a"), f'return {writer.call("_force", "a")} + E_star * found.of("more")']),
        "pressure": (
            ["r", "a"], [state("a"), f"return {writer.call('_pressure', 'r', 'a')} + E_star * found.pressure(r)"],
        ),
        "radius_from_depth": (["d"], searched("d")),
        "radius_from_force": (["F"], searched("F")),
        "force_from_depth": (["d"], [f"return _force({by_depth}, {elastic})"]),
        "depth_from_force": (["F"], [f"return _depth(_radius_from_force(F, {elastic}), {', '.join(own)})"]),
    }  # fmt: skip
