"""Modules `axicontact.graded.tangential.<profile>`: mu times the difference of two normal contacts."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ...letters import name_of
from ..physics.tangential import ORDER
from .families import Family, family
from .module import Writer

RULES = {
    "hyperboloid": "smooth", "gaussian": "smooth", "sphere": "below", "flank": "beyond", "rim": "beyond",
    "rounding": "beyond", "rounded": "rounded", "tipped": "tipped", "waves": "waves",
}  # fmt: skip
"""Which rule of the runtime follows the growth of a shape."""


def module_source(entries: Mapping[str, Entry], plain: Mapping[str, Entry]) -> str:
    """The module of one profile; `plain` are the entries of its normal contact."""
    profile = plain["d"].profile
    writer = Writer(profile, entries, plain)
    for entry in entries.values():
        fields = [str(argument) for argument in entry.quantity.arguments]
        keywords = [name_of(symbol) for symbol in entry.parameters]
        body = writer.checks(entry.parameters, reach=profile.truncated)
        body += ORDER if "c" in fields else []
        body.append(f"return {writer.evaluated(f'_{entry.quantity.function}', fields, keywords)}")
        notes = f"Valid for {profile.validity}; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN."
        if profile.truncated:
            notes += " The stick zone is never smaller than the flat face: NaN for c < b."
        writer.add(entry, notes, body)
    _rules(writer)
    return writer.source(f"{profile.title} under a tangential load on a power-law graded half-space")


def _rules(writer: Writer) -> None:
    own = family(writer.profile)
    geometry, material = [*writer.geometry, "k"], [*writer.geometry, "H", "k"]

    def normal(name: str, *fields: str) -> str:
        passed = geometry if name == "depth" else material
        return f"normal._{name}({', '.join([*fields, *passed])})"

    limit = _domain(writer, own, f"normal._rate({', '.join(['a', *geometry])}) >= 0.0")

    def limited(value: str) -> str:
        return f"np.where({limit}, {value}, np.nan)" if limit else value

    needs = [*writer.geometry, "H", "k", "mu"]
    sliding = [*writer.geometry, "H", "H_x", "k", "mu"]
    writer.rule(
        "_tangential_force", ["a", "c"], needs,
        [*_gains(own, "force"), f"return {limited('mu * (2.0 * H / (1.0 + k)) * gain')}"],
    )  # fmt: skip
    traction = limited(f"mu * np.where(r < c, H / np.pi * gain, {normal('pressure', 'r', 'a')})")
    inside = ["inside = np.minimum(r, c)", *_gains(own, "pressure", "inside"), f"return {traction}"]
    writer.rule("_traction", ["r", "a", "c"], needs, inside)
    writer.rule(
        "_tangential_displacement", ["a", "c"], sliding,
        [*_gains(own, "depth"), f"return {limited('mu * (H / H_x) * gain')}"],
    )  # fmt: skip
    writer.rule(
        "_stick_radius", ["F_x", "a"], needs,
        [
            f"F = stick_force({normal('force', 'a')}, F_x, mu)",
            f"return np.where((F_x == 0.0) & (a >= 0.0), a, normal._radius_from_force({', '.join(['F', *material])}))",
        ],
    )  # fmt: skip
    writer.rule("_full_slip_displacement", ["a"], sliding, [f"return mu * (H / H_x) * {normal('depth', 'a')}"])


def _gains(own: Family, quantity: str, r: str = "0.0") -> list[str]:
    """The lines of `gain`: the sum of what the terms of a profile gain from c to a."""
    parts = {}
    for term in own.terms:
        if term.shape == "power":
            (n,) = term.texts
            call = f'power_gain("{quantity}", {r}, c, a, {n}, k)'
        else:
            lengths = ", ".join(term.texts) + ("," if len(term.texts) == 1 else "")
            shape = f"{term.shape}_{quantity}, {term.shape}_rate, ({lengths})"
            call = f'{RULES[term.shape]}_gain("{quantity}", {shape}, {r}, c, a, k)'
        parts[term.shape] = term.times(call)
    if len(parts) > 1:
        return [*(f"{shape} = {part}" for shape, part in parts.items()), f"gain = {' + '.join(parts)}"]
    (text,) = parts.values()
    return [f"gain = sum({text} for j, A_j in enumerate(A, 1))" if own.summed else f"gain = {text}"]


def _domain(writer: Writer, own: Family, growing: str) -> str:
    """The condition on the radii, "" where there is none."""
    if writer.profile.truncated:
        return f"c >= {writer.profile.breaks[0]}"
    if own.has("sphere"):
        return f"a <= {writer.profile.chain[-1]}"
    return growing if own.has("gaussian") else ""
