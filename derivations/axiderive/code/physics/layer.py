"""Contact with a layer on a rigid base: that with the half-space, and what the equation of the springs adds."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial

import mpmath as mp
import sympy as sp

from ... import notation as nt
from ...entry import Entry
from ...letters import name_of
from ...oracle.layer import Layer, layer
from ...physics import DEPTH, FORCE
from ...physics.layer import BASES, MOMENTS, PHYSICS, order, thickness
from .. import docstring
from ..example import DIGITS, Example
from ..function import Function
from ..text import python
from ..writer import Writer

BASE = f'base: str = "{next(iter(BASES))}"'
NOTES = (
    "{}. Valid for {}; {}. One linear system for each contact, a <= 20 thickness. "
    "Negative or NaN field values give NaN."
)
THICK = 5
"""Thickness over a, where the error of an expansion is said."""
THIN = (
    "{}. What is left out is a share of the order of (a/thickness)^{}: {} at thickness = {} a on a bonded base for "
    "nu = 1/2, which is the stiffest, by the solution of the equation. Valid for {} and a << thickness; {}. "
    "Negative or NaN field values give NaN."
)


def interface(writer: Writer) -> None:
    """Adds a public function for every entry."""
    said = writer.profile.validity, writer.system.physics.assumed
    stiffest = cache(partial(_stiffest, writer.example))
    for entry in writer.entries.values():
        quantity, fields = entry.quantity, list(map(name_of, entry.arguments))
        names = [name_of(symbol) for symbol in entry.parameters]
        evaluated = writer.evaluated(f"_{quantity.function}", fields, names, words=("base",))
        reach = "a" in fields
        body = [*writer.checks(entry.parameters, reach=reach), "require_base(base)", f"return {evaluated}"]
        where = docstring.capital(entry.note)
        own = _measured(entry, stiffest()) if entry.status == "expansion" else ()
        notes = (THIN if own else NOTES).format(where, *own, *said)
        doc = docstring.of_entry(entry, entry.parameters, notes, writer.example.lines(entry.suffix), _base())
        writer.public.append(Function(quantity.function, fields, [*names, BASE], body, doc, "Result"))


def _measured(entry: Entry, found: Layer) -> tuple[int, str, int]:
    """The order of what an expansion leaves out, its share there, and the thickness over a."""
    with mp.workdps(2 * DIGITS):
        share = 100 * float(found.stated(entry) / found.value(entry.quantity.symbol) - 1)
    return order(entry.definition), f"{share:+.2g} %", THICK


def _stiffest(example: Example) -> Layer:
    """A contact with a layer on which an expansion is worst, for its thickness."""
    own = example.layered
    with mp.workdps(2 * DIGITS):
        values = {**own.here.values, nt.nu: sp.S.Half, thickness: THICK * own.here.values[nt.a]}
        return layer(replace(own.here, values=values), own.base)


def _base() -> list[str]:
    meaning, words = PHYSICS.choices["base"]
    choice = ", ".join(f'"{own}"' for own in words)
    return [f"base : {{{choice}}}", f"    {docstring.capital(meaning)}."]


def rules(writer: Writer) -> None:
    """Adds what the layer changes of one contact, and what follows from that."""
    geometry = writer.geometry
    lines = _punch(writer) if writer.profile.complete else _curved(writer)
    for entry in writer.entries.values():
        function, fields = entry.quantity.function, list(map(name_of, entry.arguments))
        names = [name_of(symbol) for symbol in entry.parameters if symbol not in writer.profile.parameters]
        writer.rule(f"_{function}", fields, [*geometry, *names, "base"], lines[function])


def _contact(writer: Writer, geometry: list[str], shape: str) -> None:
    line, doc = f"return on_layer(a, thickness, nu, base{shape})", "What the layer changes of a contact of radius a."
    writer.rule("_contact", ["a"], [*geometry, "nu", "thickness", "base"], [line], doc, "State", "of_states")


def _punch(writer: Writer) -> dict[str, list[str]]:
    """By the function its lines; only the stiffness is another one."""
    _contact(writer, [], "")
    state, half = "found = _contact(a, nu, thickness, base)", writer.call("_pressure")
    return {
        "force": [state, 'return E_star * d * number_of(found, "stiffness")'],
        "pressure": [state, f'return {half} * number_of(found, "edge") + E_star * d * added_pressure(found, r)'],
        "depth_from_force": [state, 'return F / (E_star * number_of(found, "stiffness"))'],
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
    growth = 'E_star * number_of(found, "stiffness") * number_of(found, "rate")'
    curves = {
        "radius_from_depth": (
            d,
            f'{writer.call("_depth", "t")} - number_of(found, "less")',
            'number_of(found, "rate")',
        ),
        "radius_from_force": (force, f'{writer.call("_force", "t")} + E_star * number_of(found, "more")', growth),
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
    opened = {
        entry.quantity.function: _opened(writer, entry)
        for entry in writer.entries.values()
        if entry.status == "expansion"
    }
    elastic = ", ".join([*writer.geometry, "E_star", "nu", "thickness", "base"])
    moved = "retraction_on_layer(a, E_star, nu, thickness, dgamma, base)"
    punch, drawn = "punch = below_punch(a, thickness, nu, base)", f"drawn = E_star * {moved}"
    by_depth, by_force = f"_radius_from_depth({', '.join([d, *own])})", f"_radius_from_force({force}, {elastic})"
    return {
        "depth": [state, f'return {writer.call("_depth")} - number_of(found, "less")'],
        "force": [state, f'return {writer.call("_force")} + E_star * number_of(found, "more")'],
        "pressure": [state, f"return {writer.call('_pressure')} + E_star * added_pressure(found, r)"],
        **searched,
        **opened,
        "adhesive_depth": [f"return _depth({', '.join(['a', *own])}) - {moved}"],
        "adhesive_force": [punch, drawn, f'return _force(a, {elastic}) - drawn * number_of(punch, "stiffness")'],
        "adhesive_pressure": [
            punch,
            drawn,
            "pulled = tension(r, a, E_star, dgamma) + drawn * added_pressure(punch, r)",
            f"return _pressure(r, a, {elastic}) - pulled",
        ],
        "force_from_depth": [f"return _force({by_depth}, {elastic})"],
        "depth_from_force": [f"return _depth({by_force}, {', '.join(own)})"],
    }


def _opened(writer: Writer, entry: Entry) -> list[str]:
    """The lines of an expansion, in a/thickness."""
    sunk, carried, ratio = sp.symbols("sunk carried ratio", positive=True)
    expr = entry.cases[0].expr.subs({DEPTH(nt.a): sunk, FORCE(nt.a): nt.E_star * carried})
    expr = expr.subs(nt.a, ratio * thickness)
    lines = [f"carried = {writer.call('_force', E_star='1.0')}"]
    lines += [f"{m} = wave_sum(nu, base, {_power(whole)})" for m, whole in MOMENTS.items() if expr.has(m)]
    lines += ["ratio = a / thickness"] if expr.has(ratio) else []
    if not expr.has(sunk):
        return [*lines, f"return {python(expr)}"]
    held, lost = sp.collect(expr.subs(carried, 0), sunk), -expr.subs(sunk, 0)
    return [f"sunk = {writer.call('_depth')}", *lines, f"lost = {python(lost)}", f"return {python(held)} - lost"]


def _power(moment: sp.Integral) -> sp.Expr:
    """That of the wave number in a sum over waves."""
    return sp.degree(moment.function, nt.u)
