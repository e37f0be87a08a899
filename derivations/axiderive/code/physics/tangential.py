"""Tangential contact, on either half-space: mu times the difference of two normal contacts."""

from __future__ import annotations

from collections.abc import Sequence

from ..bodies.regimes import strip_width
from ..graded.families import Family, family
from ..text import python
from ..writer import Writer
from . import stated
from .adhesive import exponent, number

interface = stated.interface


def rules(writer: Writer) -> None:
    """Adds what the contact gains from the zone of stick to its edge, as a force, a traction and a displacement."""
    medium = writer.system.medium
    needs = [*writer.geometry, *map(str, medium.moduli), "mu"]
    sliding = [*writer.geometry, str(medium.modulus), str(medium.shear), *map(str, medium.moduli[1:]), "mu"]
    scale = f"mu * ({medium.modulus} / {medium.shear})"
    force, traction, displacement = _graded_gains(writer) if medium.graded else _gains(writer, scale)
    writer.rule("_tangential_force", ["a", "c"], needs, force)
    writer.rule("_traction", ["r", "a", "c"], needs, traction)
    writer.rule("_tangential_displacement", ["a", "c"], sliding, displacement)
    stuck = f"np.where((F_x == 0.0) & (a >= 0.0), a, {writer.call('_radius_from_force', 'F')})"
    whole = f"F = stick_force({writer.call('_force', 'a')}, F_x, mu)"
    writer.rule("_stick_radius", ["F_x", "a"], needs, [whole, f"return {stuck}"])
    writer.rule("_full_slip_displacement", ["a"], sliding, [f"return {scale} * {writer.call('_depth', 'a')}"])


def _gains(writer: Writer, scale: str) -> tuple[list[str], list[str], list[str]]:
    """The lines of the force, the traction and the displacement."""
    return _loss(writer, "_force", "mu"), _traction(writer), _loss(writer, "_depth", scale)


ORDERS = {"_depth": 1, "_force": 2}
SCALES = {"_depth": "", "_force": "2.0 * E_star * "}


def _loss(writer: Writer, function: str, scale: str) -> list[str]:
    """scale * (value at a - value at c), as what the contact gains from c to a where they are close."""
    whole, sticking = writer.call(function, "a"), writer.call(function, "c")
    power, order = exponent(writer.profile), ORDERS[function]
    if power is not None:
        return [f"return {scale} * {whole} * gained_share(c, a, {number(power + order - 1)})"]
    if writer.summed:
        share = f"gained_share(c, a, {'j' if order == 1 else 'j + 1'})"
        return [*_by_terms(writer, function, share), f"return {scale} * sum(gains)"]
    if not _has_slopes(writer):
        return [f"return {scale} * ({whole} - {sticking})"]
    return [
        f"whole, sticking = {whole}, {sticking}",
        "close = sticking >= CLOSE * whole",
        *_gain(writer, SCALES[function], str(order), "0.0"),
        f"return {scale} * np.where(close, gain, whole - sticking)",
    ]


def _by_terms(writer: Writer, function: str, factor: str) -> list[str]:
    """The lines of `gains`: the terms of a polynomial one by one, each a power law."""
    term = writer.call(function, "a", A="(0.0,) * (j - 1) + (A_j,)")
    return [f"gains = ({term} * {factor} for j, A_j in enumerate(A, 1))"]


def _traction(writer: Writer) -> list[str]:
    sliding, power = writer.call("_pressure", "r", "a"), exponent(writer.profile)
    if writer.summed:
        gains = _by_terms(writer, "_slope", "power_gain(r, c, a, j)")
        return [f"sliding = {sliding}", *gains, "return mu * np.where(r < c, E_star / np.pi * sum(gains), sliding)"]
    if not _has_slopes(writer):
        stuck = writer.call("_pressure", "r", "c")
        return [f"return mu * np.where(r < c, {sliding} - {stuck}, {sliding})"]
    if power is not None:
        rule, at = {1: ("arc_gain(r, c, a)", "1.0"), 2: ("root_gain(r, c, a)", "1.0")}.get(power, ("", "a"))
        if not rule and power.is_Integer and power % 2 == 0:
            rule, at = f"even_gain(r, c, a, {power})", "1.0"
        gain = f"E_star / np.pi * {writer.call('_slope', at)} * {rule or f'power_gain(r, c, a, {power})'}"
        return [f"sliding = {sliding}", f"gain = {gain}", "return mu * np.where(r < c, gain, sliding)"]
    return [
        f"sliding = {sliding}",
        f"stuck = {writer.call('_pressure', 'r', 'c')}",
        "# both are infinite at a tip, and where the slope of the profile jumps",
        "close = (r < c) & (stuck >= CLOSE * sliding)",
        *_gain(writer, "E_star / np.pi * ", "0", "r"),
        "return mu * np.where(close, gain, sliding - stuck)",
    ]


def _has_slopes(writer: Writer) -> bool:
    """Whether g' is at hand; a profile outside the normal form has it piece by piece only, and keeps the difference."""
    return not {"_slope", "_slope_beyond"}.isdisjoint(writer.normal)


def _gain(writer: Writer, scale: str, order: str, r: str) -> list[str]:
    """The lines of `gain`: scale * the integral from c to a of g'(t) t**order/sqrt(t**2 - r**2)."""
    profile, slopes = writer.profile, writer.normal
    lines = [f"{symbol} = {python(expr)}" for symbol, expr in profile.abbreviations]
    b = str(profile.breaks[0]) if "_slope_beyond" in slopes else ""
    parts = []
    if "_slope" in slopes:
        end = f"np.minimum(a, {b})" if b else "a"
        rule, own = "growth", slopes["_slope"][1:]
        more = ["close"]
        if "wavelength" in writer.geometry:
            rule, more = "growth_waves", ["wavelength", "close"]
        elif own[:1] == ["root"]:
            rule, own, more = "growth_below", own[1:], [str(profile.chain[-1]), "close"]
        parts.append(f"{rule}(normal._slope, {_tuple(own)}, {', '.join([order, r, 'c', end, *more])})")
    if b:
        slope = f"normal._slope_beyond, {_tuple(slopes['_slope_beyond'][2:])}"
        parts.append(f"growth_beyond({slope}, {order}, {r}, c, a, {b}, close{strip_width(profile)})")
    if len(parts) == 1:
        return [*lines, f"gain = {scale}{parts[0]}"]
    total = f"{scale}(tip + beyond)" if scale else "tip + beyond"
    return [*lines, f"tip = {parts[0]}", f"beyond = {parts[1]}", f"gain = {total}"]


def _tuple(names: Sequence[str]) -> str:
    return f"({names[0]},)" if len(names) == 1 else f"({', '.join(names)})"


RULES = {
    "hyperboloid": "smooth", "gaussian": "smooth", "sphere": "below", "flank": "beyond", "rim": "beyond",
    "rounding": "beyond", "rounded": "rounded", "tipped": "tipped", "waves": "waves",
}  # fmt: skip
"""Which rule of the runtime follows the growth of a shape."""


def _graded_gains(writer: Writer) -> tuple[list[str], list[str], list[str]]:
    """The same by the rule of each shape of the profile."""
    own = family(writer.profile)
    limit = _domain(writer, own)

    def limited(value: str) -> str:
        return f"return np.where({limit}, {value}, np.nan)" if limit else f"return {value}"

    traction = f"mu * either(r < c, lambda: H / np.pi * gain(), lambda: {writer.call('_pressure', 'r', 'a')})"
    lines = ["inside = np.minimum(r, c)", *_of_terms(own, "pressure", "inside", "return")]
    inside = ["def gain() -> Array:", *(f"    {line}" for line in lines)]
    return (
        [*_of_terms(own, "force"), limited("mu * (2.0 * H / (1.0 + k)) * gain")],
        [*([""] if writer.profile.abbreviations else []), *inside, "", limited(traction)],
        [*_of_terms(own, "depth"), limited("mu * (H / H_x) * gain")],
    )


def _of_terms(own: Family, quantity: str, r: str = "0.0", result: str = "gain =") -> list[str]:
    """The lines of `gain`, or that return it: the sum of what the terms of a profile gain from c to a."""
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
        return [*(f"{shape} = {part}" for shape, part in parts.items()), f"{result} {' + '.join(parts)}"]
    (text,) = parts.values()
    return [f"{result} sum({text} for j, A_j in enumerate(A, 1))" if own.summed else f"{result} {text}"]


def _domain(writer: Writer, own: Family) -> str:
    """The condition on the radii, "" where there is none."""
    if writer.profile.truncated:
        return f"c >= {writer.profile.breaks[0]}"
    if own.has("sphere"):
        return f"a <= {writer.profile.chain[-1]}"
    return f"{writer.call('_rate', 'a')} >= 0.0" if own.has("gaussian") else ""
