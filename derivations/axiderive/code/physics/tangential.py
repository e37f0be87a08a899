"""Modules `axicontact.tangential.<profile>`: mu times the difference of two normal contacts."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ...letters import name_of
from ..bodies.regimes import strip_width
from ..text import python
from . import text
from .adhesive import exponent, number
from .examples import Example
from .text import Function, NormalModule, evaluate, private

IMPORTS = (
    "interface: Array, Result, elementwise, numbers, require, require_coefficients, require_order, require_reach",
    "physics.slip: CLOSE, arc_gain, even_gain, gained_share, power_gain, root_gain, stick_force",
    "physics.slip: growth, growth_below, growth_beyond, growth_waves",
)
ORDER = [
    "require_order(",
    '    np.all(~(numbers("c", c) > numbers("a", a))),',
    '    "c <= a",',
    '    "the stick zone lies inside the contact; exchange a and c, or use c = a for no tangential load",',
    "    c=c,",
    "    a=a,",
    ")",
]


def module_source(module: NormalModule, entries: Mapping[str, Entry], *, interface: bool = True) -> str:
    """The module of one profile with a compact contact; without its interface, what that rests on."""
    example = Example(module.profile, entries, "tangential", module.entries)
    public = [_public(module, entry, example) for entry in entries.values()] if interface else []
    title = f"{module.profile.title} under a tangential load"
    source = text.module(title, module.profile.subtitle, IMPORTS, public, _private(module))
    return source.replace(text.NORMAL, module.profile.name)


def _public(module: NormalModule, entry: Entry, example: Example) -> Function:
    profile = module.profile
    fields = [str(argument) for argument in entry.quantity.arguments]
    keywords = [name_of(symbol) for symbol in entry.parameters]
    body = module.check(entry.parameters) + (ORDER if "c" in fields else [])
    if profile.truncated:
        body.append(f"require_reach(a, {profile.breaks[0]})")
    body.append(f"return {evaluate(f'_{entry.quantity.function}', fields, keywords, module.summed)}")
    notes = f"Valid for {profile.validity}; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN."
    if profile.truncated:
        notes += " The stick zone is never smaller than the flat face: NaN for c < b."
    document = text.document(entry, fields, keywords, notes)
    shown = example.lines(entry.suffix)
    return Function(entry.quantity.function, fields, keywords, entry.quantity.summary, document, body, example=shown)


def _private(module: NormalModule) -> list[str]:
    needs = [*module.geometry, "E_star", "mu"]
    both = [*module.geometry, "E_star", "G_star", "mu"]
    force, depth = (module.call(name, "a") for name in ("_force", "_depth"))
    stuck = module.call("_radius_from_force", "F")
    return [
        private("_tangential_force", ["a", "c"], needs, _loss(module, "_force", "mu")),
        private("_traction", ["r", "a", "c"], needs, _traction(module)),
        private("_tangential_displacement", ["a", "c"], both, _loss(module, "_depth", "mu * (E_star / G_star)")),
        private(
            "_stick_radius",
            ["F_x", "a"],
            needs,
            [f"F = stick_force({force}, F_x, mu)", f"return np.where((F_x == 0.0) & (a >= 0.0), a, {stuck})"],
        ),
        private("_full_slip_displacement", ["a"], both, [f"return mu * (E_star / G_star) * {depth}"]),
    ]


ORDERS = {"_depth": 1, "_force": 2}
SCALES = {"_depth": "", "_force": "2.0 * E_star * "}


def _loss(module: NormalModule, function: str, scale: str) -> list[str]:
    """scale * (value at a - value at c), as what the contact gains from c to a where they are close."""
    whole, sticking = module.call(function, "a"), module.call(function, "c")
    power, order = exponent(module.profile), ORDERS[function]
    if power is not None:
        return [f"return {scale} * {whole} * gained_share(c, a, {number(power + order - 1)})"]
    if module.summed:
        share = f"gained_share(c, a, {'j' if order == 1 else 'j + 1'})"
        return [*_by_terms(module, function, share), f"return {scale} * sum(gains)"]
    if not _has_slopes(module):
        return [f"return {scale} * ({whole} - {sticking})"]
    return [
        f"whole, sticking = {whole}, {sticking}",
        "close = sticking >= CLOSE * whole",
        *_gain(module, SCALES[function], str(order), "0.0"),
        f"return {scale} * np.where(close, gain, whole - sticking)",
    ]


def _by_terms(module: NormalModule, function: str, factor: str) -> list[str]:
    """The lines of `gains`: the terms of a polynomial one by one, each a power law."""
    term = module.call(function, "a", A="(0.0,) * (j - 1) + (A_j,)")
    return [f"gains = ({term} * {factor} for j, A_j in enumerate(A, 1))"]


def _traction(module: NormalModule) -> list[str]:
    sliding, power = module.call("_pressure", "r", "a"), exponent(module.profile)
    if module.summed:
        gains = _by_terms(module, "_slope", "power_gain(r, c, a, j)")
        return [f"sliding = {sliding}", *gains, "return mu * np.where(r < c, E_star / np.pi * sum(gains), sliding)"]
    if not _has_slopes(module):
        stuck = module.call("_pressure", "r", "c")
        return [f"return mu * np.where(r < c, {sliding} - {stuck}, {sliding})"]
    if power is not None:
        rule, at = {1: ("arc_gain(r, c, a)", "1.0"), 2: ("root_gain(r, c, a)", "1.0")}.get(power, ("", "a"))
        if not rule and power.is_Integer and power % 2 == 0:
            rule, at = f"even_gain(r, c, a, {power})", "1.0"
        gain = f"E_star / np.pi * {module.call('_slope', at)} * {rule or f'power_gain(r, c, a, {power})'}"
        return [f"sliding = {sliding}", f"gain = {gain}", "return mu * np.where(r < c, gain, sliding)"]
    return [
        f"sliding = {sliding}",
        f"stuck = {module.call('_pressure', 'r', 'c')}",
        "# both are infinite at a tip, and where the slope of the profile jumps",
        "close = (r < c) & (stuck >= CLOSE * sliding)",
        *_gain(module, "E_star / np.pi * ", "0", "r"),
        "return mu * np.where(close, gain, sliding - stuck)",
    ]


def _has_slopes(module: NormalModule) -> bool:
    """Whether g' is at hand; a profile outside the normal form has it piece by piece only, and keeps the difference."""
    return not {"_slope", "_slope_beyond"}.isdisjoint(module.functions)


def _gain(module: NormalModule, scale: str, order: str, r: str) -> list[str]:
    """The lines of `gain`: scale * the integral from c to a of g'(t) t**order/sqrt(t**2 - r**2)."""
    profile, slopes = module.profile, module.functions
    lines = [f"{symbol} = {python(expr)}" for symbol, expr in profile.abbreviations]
    b = str(profile.breaks[0]) if "_slope_beyond" in slopes else ""
    parts = []
    if "_slope" in slopes:
        end = f"np.minimum(a, {b})" if b else "a"
        rule, own = "growth", slopes["_slope"][1:]
        more = ["close"]
        if "wavelength" in module.geometry:
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


def _tuple(names: list[str]) -> str:
    return f"({names[0]},)" if len(names) == 1 else f"({', '.join(names)})"
