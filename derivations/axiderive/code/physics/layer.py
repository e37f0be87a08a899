"""Contact with a layer on a rigid base: that with the half-space, and what the equation of the springs adds."""

from __future__ import annotations

import sympy as sp

from ... import notation as nt
from ...letters import name_of
from ...physics.layer import BASES, EQUATION
from .. import docstring
from ..function import Function
from ..text import python
from ..writer import Writer

BASE = f'base: str = "{next(iter(BASES))}"'
NOTES = (
    "The springs below the surface are pressed in by q(t) = {}, which is zero {}. Valid for {}; {}. One linear "
    "system for each contact, a <= 20 thickness; K(t, s) is 2/(pi thickness) times the integral of (1 - L(u)) "
    "cos(u t/thickness) cos(u s/thickness) over u > 0, with the L of the layer. "
    "Negative or NaN field values give NaN."
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
    lines = _punch(writer) if writer.profile.complete else _curved(writer)
    for entry in writer.entries.values():
        quantity = entry.quantity
        elastic = ["E_star"] if quantity.elastic else []
        fields = list(map(name_of, entry.arguments))
        writer.rule(f"_{quantity.function}", fields, [*geometry, *elastic, *layer], lines[quantity.function])


def _contact(writer: Writer, geometry: list[str], shape: str) -> None:
    line, doc = f"return on_layer(a, thickness, nu, base{shape})", "What the layer changes of a contact of radius a."
    writer.rule("_contact", ["a"], [*geometry, "nu", "thickness", "base"], [line], doc, "State", "of_states")


def _punch(writer: Writer) -> dict[str, list[str]]:
    """By the function its lines; only the stiffness is another one."""
    _contact(writer, [], "")
    state, half = "found = _contact(a, nu, thickness, base)", writer.call("_pressure")
    return {
        "force": [state, 'return E_star * d * found.of("stiffness")'],
        "pressure": [state, f'return {half} * found.of("edge") + E_star * d * found.pressure(r)'],
        "depth_from_force": [state, 'return F / (E_star * found.of("stiffness"))'],
    }


def _curved(writer: Writer) -> dict[str, list[str]]:
    """By the function its lines; what depth or force give is searched for from the radius on the half-space."""
    profile, own = writer.profile, [*writer.geometry, "nu", "thickness", "base"]
    depth, breaks = writer.call("_depth", "t"), [python(b) for b in profile.breaks]
    if profile.truncated:
        depth = f"np.where(t > {breaks[0]}, {depth}, 0.0)"
    kinks = f", ({', '.join(breaks)},)" if breaks else ""
    _contact(writer, writer.geometry, f", lambda t: {depth}{kinks}")
    state = f"found = _contact({', '.join(['a', *own])})"
    last = profile.largest or (profile.chain[-1] if nt.a in profile.chain else None)
    end = "np.inf" if last is None else python(last)

    d, force = name_of(nt.d), name_of(nt.F)
    growth = 'E_star * found.of("stiffness") * found.of("rate")'
    curves = {
        "radius_from_depth": (d, f'{writer.call("_depth", "t")} - found.of("less")', 'found.of("rate")'),
        "radius_from_force": (force, f'{writer.call("_force", "t")} + E_star * found.of("more")', growth),
    }
    searched = {
        name: [
            "def curve(t: Array) -> tuple[Array, Array]:",
            f"    found = _contact({', '.join(['t', *own])})",
            f"    value = {curve}",
            f"    return value, t * {rate} / value",
            "",
            f"return radius_on_layer(curve, {load}, {writer.call(f'_{name}')}, thickness, {end}, {not breaks})",
        ]
        for name, (load, curve, rate) in curves.items()
    }
    elastic = ", ".join([*writer.geometry, "E_star", "nu", "thickness", "base"])
    by_depth, by_force = f"_radius_from_depth({', '.join([d, *own])})", f"_radius_from_force({force}, {elastic})"
    return {
        "depth": [state, f'return {writer.call("_depth")} - found.of("less")'],
        "force": [state, f'return {writer.call("_force")} + E_star * found.of("more")'],
        "pressure": [state, f"return {writer.call('_pressure')} + E_star * found.pressure(r)"],
        **searched,
        "force_from_depth": [f"return _force({by_depth}, {elastic})"],
        "depth_from_force": [f"return _depth({by_force}, {', '.join(own)})"],
    }
