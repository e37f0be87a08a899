"""Modules `axicontact.tangential.<profile>`: mu times the difference of two normal contacts."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from . import text
from .examples import Example
from .text import Function, NormalModule, evaluate, private

IMPORTS = (
    ".._domain: numbers, require, require_coefficients, require_order, require_reach",
    ".._elementwise: Array, Result, elementwise",
    ".._slip: depth_gain, difference, force_gain, pressure_gain, stick_force",
)
SUMMARY = {
    "F": "Tangential force with a stick zone of radius c.",
    "tau": "Tangential traction; zero outside the contact.",
    "u": "Tangential displacement of the indenter with a stick zone of radius c.",
    "c": "Radius of the stick zone under a tangential force; NaN beyond full slip.",
    "us": "Tangential displacement at the onset of full slip.",
}
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
    public = [_public(module, entries[suffix], example) for suffix in SUMMARY] if interface else []
    title = f"{module.profile.title} under a tangential load"
    source = text.module(title, module.profile.subtitle, IMPORTS, public, _private(module))
    return source.replace(text.NORMAL, module.profile.name)


def _public(module: NormalModule, entry: Entry, example: Example) -> Function:
    profile = module.profile
    fields = [str(argument) for argument in entry.quantity.arguments]
    keywords = [text.name_of(symbol) for symbol in entry.parameters]
    body = module.check(entry.parameters) + (ORDER if "c" in fields else [])
    if profile.truncated:
        body.append(f"require_reach(a, {profile.breaks[0]})")
    body.append(f"return {evaluate(f'_{entry.quantity.function}', fields, keywords, module.summed)}")
    notes = f"Valid for {profile.validity}; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN."
    if profile.truncated:
        notes += " The stick zone is never smaller than the flat face: NaN for c < b."
    document = text.document(entry, fields, keywords, notes)
    shown = example.lines(entry.suffix)
    return Function(entry.quantity.function, fields, keywords, SUMMARY[entry.suffix], document, body, example=shown)


def _private(module: NormalModule) -> list[str]:
    needs = [*module.geometry, "E_star", "mu"]
    both = [*module.geometry, "E_star", "G_star", "mu"]
    force, depth, pressure = (
        module.call(name, *fields) for name, fields in (("_force", "a"), ("_depth", "a"), ("_pressure", ("r", "a")))
    )
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


GAIN = {"_force": "2.0 * E_star * force_gain({slope}, c, a)", "_depth": "depth_gain({slope}, c, a)"}


def _loss(module: NormalModule, function: str, scale: str) -> list[str]:
    """scale * (value at a - value at c), as an integral from c to a where they are close."""
    whole, sticking = module.call(function, "a"), module.call(function, "c")
    slope = _slope(module)
    if not slope:
        return [f"return {scale} * ({whole} - {sticking})"]
    return [
        f"whole = {whole}",
        f"sticking = {sticking}",
        f"gain = {GAIN[function].format(slope=slope)}",
        f"return {scale} * difference(whole, sticking, gain, c, a)",
    ]


def _traction(module: NormalModule) -> list[str]:
    slope = _slope(module)
    lines = [f"sliding = {module.call('_pressure', 'r', 'a')}", f"stuck = {module.call('_pressure', 'r', 'c')}"]
    sticking = "sliding - stuck"
    if slope:
        lines.append(f"gain = E_star / np.pi * pressure_gain({slope}, r, c, a)")
        sticking = "difference(sliding, stuck, gain, c, a)"
    return [
        *lines,
        "# the pressure of the stick zone is zero in the ring of slip, also where that of the contact is infinite",
        f"return mu * np.where(r < c, {sticking}, sliding + 0.0 * c)",
    ]


def _slope(module: NormalModule) -> str:
    """g'(t) as a function, where it is smooth and bounded between c and a."""
    own = module.functions.get("_slope", [])
    if not own or "root" in own[:2] or "_slope_beyond" in module.functions or "wavelength" in module.geometry:
        return ""
    return f"lambda t: {module.call('_slope', 't')}"
