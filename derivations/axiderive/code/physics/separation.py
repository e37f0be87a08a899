"""The work of separation whose pull-off is under a force that was measured, on either half-space.

For each force it is the least over the radius of what holds a contact there.  The minima lie where the force that can
be held grows with the radius: between the same radii as the stable branches, since both derivatives have the sign of
that of a**((1 + k)/2) g'(a).
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from ...letters import name_of
from ...notation import F, dgamma
from ...physics import adhesive
from .. import docstring
from ..function import Function
from ..graded.complete import required_face
from ..text import python, written
from ..writer import Writer
from .branches import own_units, radii, search

NAME, FIELD = "work_of_adhesion_from_pull_off", name_of(F)
PULL = sp.Symbol("pull", positive=True)
REACH = {
    False: "(12.0 * R * pull / E_star) ** (1.0 / 3.0)",
    True: "(8.0 * (1.0 + k) * (3.0 + k) * R * pull / punch_stiffness(1.0, H, k)) ** (1.0 / (3.0 + k))",
}
"""Up to where waves are looked at, on a homogeneous and on a graded half-space: a paraboloid bears sixteen times the
tension there."""
TENSION = "pull = np.where(F < 0.0, -F, np.nan)"
SAMPLED = "The force that can be held, over the modulus, at radii that separate the minima of the work of separation."
SIGNS = "0 without a force, NaN under pressure, which breaks no contact, and where no stable contact bears the tension"
EDGE = "NaN above the force at which the edge is without tension, as under pressure"


def interface(writer: Writer, order: Sequence[str] = ()) -> None:
    """Adds the public function; `order` are the lines that check a free exponent."""
    medium, profile = writer.system.medium, writer.profile
    symbols = [*profile.parameters, *medium.moduli]
    names = [name_of(symbol) for symbol in symbols]
    doc = docstring.document(
        "Work of separation at which a contact breaks under the normal force F: the inverse of the force of pull_off.",
        docstring.usual(docstring.wrapped(_stated(writer))),
        docstring.parameters([F], symbols),
        (docstring.NUMBERS, f"{docstring.measured(docstring.in_words(dgamma), dgamma)}. {docstring.SHAPE}"),
        f"Valid for {profile.validity}. The force is a tension, F < 0: {EDGE if profile.complete else SIGNS}.",
        docstring.sources_of(next(iter(writer.entries.values()))),
        writer.example.separation(NAME),
    )
    checks = required_face(symbols) if medium.graded and profile.complete else writer.checks(symbols)
    body = [*checks, *order, f"return {writer.evaluated(f'_{NAME}', [], names, **{FIELD: FIELD})}"]
    writer.public.append(Function(NAME, [FIELD], names, body, doc, "Result"))


def _stated(writer: Writer) -> str:
    """The formula, or what is the least over the radius."""
    medium = writer.system.medium
    if writer.profile.complete:
        return f"dgamma = {written(adhesive.work_of_peeling(writer.entries))}"
    closed = adhesive.work_from_pull_off(writer.plain[FIELD], medium)
    if closed is not None:
        return f"dgamma = {written(closed)}"
    least = written(adhesive.separation(medium))
    return f"dgamma = {least} at the radius a at which it is least, F_N the force without adhesion there"


def rules(writer: Writer) -> None:
    """Adds the private functions that it rests on."""
    medium, profile = writer.system.medium, writer.profile
    names = [name_of(symbol) for symbol in (*profile.parameters, *medium.moduli)]
    if profile.complete:
        given = ", ".join([*names, "0.0"])
        lines = [
            f"least = _pull_off_force({given})",
            f"return np.where(least >= F, {_separation(writer, 'least - F')}, np.nan)",
        ]
    else:
        order = adhesive.order_of(writer.plain[FIELD])
        lines = _searched(writer, names) if order is None else [TENSION, *_closed(writer, order)]
    writer.rule(f"_{NAME}", [FIELD], names, lines)


def _separation(writer: Writer, load: str) -> str:
    moduli = ", ".join(name_of(symbol) for symbol in writer.system.medium.moduli)
    return f"separation({load}, a, {moduli})"


def _closed(writer: Writer, order: sp.Expr) -> list[str]:
    lasting = python(adhesive.lasting_share(order, writer.system.medium) * PULL)
    return [
        f"lasting = {lasting}",
        f"a = {writer.call('_radius_from_force', 'lasting')}",
        f"return np.where(F == 0.0, 0.0, {_separation(writer, 'pull + lasting')})",
    ]


def _searched(writer: Writer, names: Sequence[str]) -> list[str]:
    graded, profile = writer.system.medium.graded, writer.profile
    modulus = name_of(writer.system.medium.modulus)
    geometry = [name for name in names if name != modulus]
    force = writer.call("_force", "a", **{modulus: "1.0"})
    held = (
        f"held(a, {writer.call('_rate', 'a')}, {force}, k)"
        if graded
        else f"held(a, _rate({', '.join(['a', *geometry])}), {force})"
    )
    grid = radii(profile, REACH[graded], graded=graded)
    level = f"pull / {modulus}"
    own, samples, (found,) = search(profile, geometry, [*names, "pull"], grid, held, level, "_held_samples")
    writer.rule("_held_samples", [], own, samples, SAMPLED, returns="Samples", decorator="Kept")
    work = _separation(writer, f"pull + {writer.call('_force', 'a')}")
    units = own_units(profile, geometry, modulus, FIELD)
    value = "np.ldexp(work, stress + unit)" if units else "work"
    return [
        *units,
        TENSION,
        found.replace("return", "found ="),
        f"a = lowest(found, lambda a: {work})",
        f"work = {work}",
        f"return np.where(F == 0.0, 0.0, {value})",
    ]
