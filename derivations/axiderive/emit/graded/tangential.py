"""Modules `axicontact.graded.tangential.<profile>`: mu times the difference of two normal contacts."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ..physics.tangential import ORDER, SUMMARY
from ..physics.text import name_of
from .families import family
from .module import Writer

PLAIN = ("power", "hyperboloid", "gaussian")
"""Shapes whose growth has no singularity between two radii that are close."""


def module_source(entries: Mapping[str, Entry], plain: Mapping[str, Entry]) -> str:
    """The module of one profile; `plain` are the entries of its normal contact."""
    profile = plain["d"].profile
    writer = Writer(profile, entries, "tangential", plain)
    for suffix, summary in SUMMARY.items():
        entry = entries[suffix]
        fields = [str(argument) for argument in entry.quantity.arguments]
        keywords = [name_of(symbol) for symbol in entry.parameters]
        body = writer.checks(entry.parameters, reach=profile.truncated)
        body += ORDER if "c" in fields else []
        body.append(f"return {writer.evaluated(f'_{entry.quantity.function}', fields, keywords)}")
        notes = f"Valid for {profile.validity}; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN."
        if profile.truncated:
            notes += " The stick zone is never smaller than the flat face: NaN for c < b."
        writer.add(entry, summary, notes, body)
    _rules(writer)
    return writer.source(f"{profile.title} under a tangential load on a power-law graded half space")


def _rules(writer: Writer) -> None:
    geometry, material = [*writer.geometry, "k"], [*writer.geometry, "H", "k"]
    own = family(writer.profile)
    close = all(term.shape in PLAIN for term in own.terms)

    def normal(name: str, *fields: str) -> str:
        passed = geometry if name == "depth" else material
        return f"normal._{name}({', '.join([*fields, *passed])})"

    rate = f"normal._rate, ({', '.join(geometry)})"

    def gained(name: str, radius: str, *fields: str) -> list[str]:
        both = f"{normal(name, *fields, 'a')}, {normal(name, *fields, 'c')}"
        if not close:
            return [f"outer, inner = {both}", "gain = outer - inner"]
        return [
            f"outer, inner = {both}",
            f"gain = {name}_gain(outer, inner, {rate}, {', '.join([*fields, 'c', 'a', *radius.split()])})",
        ]

    needs = [*writer.geometry, "H", "k", "mu"]
    sliding = [*writer.geometry, "H", "H_x", "k", "mu"]
    writer.rule("_tangential_force", ["a", "c"], needs, [*gained("force", "H k"), "return mu * gain"])
    writer.rule(
        "_traction", ["r", "a", "c"], needs,
        [*gained("pressure", "H k", "r"), "return mu * np.where(r < c, gain, outer + 0.0 * c)"],
    )  # fmt: skip
    writer.rule("_tangential_displacement", ["a", "c"], sliding, [*gained("depth", ""), "return mu * (H / H_x) * gain"])
    writer.rule(
        "_stick_radius", ["F_x", "a"], needs,
        [
            f"F = stick_force({normal('force', 'a')}, F_x, mu)",
            f"return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force({', '.join(['F', *material])}))",
        ],
    )  # fmt: skip
    writer.rule("_full_slip_displacement", ["a"], sliding, [f"return mu * (H / H_x) * {normal('depth', 'a')}"])
