"""Modules `axicontact.tangential.<profile>`: mu times the difference of two normal contacts."""

from __future__ import annotations

from ...contact import tangential
from . import text
from .text import Function, NormalModule, evaluate, private

IMPORTS = (
    ".._bounds: require_physics",
    ".._domain: numbers, require, require_coefficients, require_order",
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


def module_source(module: NormalModule) -> str:
    """The module of one profile with a compact contact."""
    entries = tangential.derive(module.profile)
    profile, public = module.profile, []
    for suffix, summary in SUMMARY.items():
        entry = entries[suffix]
        fields = [str(argument) for argument in entry.quantity.arguments]
        keywords = [text.name_of(symbol) for symbol in entry.parameters]
        body = module.check(keywords) + (ORDER if "c" in fields else [])
        name = f"_{entry.quantity.function}"
        body.append(f"return {evaluate(name, fields, keywords, module.summed)}")
        notes = f"Valid for {profile.validity}; Cattaneo-Mindlin approximation. Negative or NaN field values give NaN."
        if profile.truncated:
            notes += " The stick zone is never smaller than the flat face: NaN for c < b."
        document = text.document(entry, fields, keywords, notes)
        public.append(Function(entry.quantity.function, fields, keywords, summary, document, body))
    title = f"{profile.title} under a tangential load"
    return text.module(title, profile.subtitle, IMPORTS, public, _private(module)).replace(text.NORMAL, profile.name)


def _private(module: NormalModule) -> list[str]:
    geometry = module.geometry
    force, depth, pressure = ("_force", "a"), ("_depth", "a"), ("_pressure", "r", "a")
    outer = {own[0]: module.call(*own) for own in (force, depth, pressure)}
    inner = {"_force": module.call("_force", "c"), "_depth": module.call("_depth", "c")}
    inner["_pressure"] = module.call("_pressure", "r", "c")
    smooth = module.functions.get("_slope", [])[:2]
    broken = "_slope_beyond" in module.functions or "wavelength" in geometry
    plain = bool(smooth) and "root" not in smooth and not broken

    def gained(function: str, gain: str) -> str:
        if not plain:
            return f"{outer[function]} - {inner[function]}"
        return f"difference({outer[function]}, {inner[function]}, {gain}, c, a)"

    slope = f"lambda t: {module.call('_slope', 't')}" if plain else ""
    sticking = gained("_pressure", f"E_star / np.pi * pressure_gain({slope}, r, c, a)")
    return [
        private(
            "_tangential_force", ["a", "c"], [*geometry, "E_star", "mu"],
            [f"return mu * ({gained('_force', f'2.0 * E_star * force_gain({slope}, c, a)')})"],
        ),
        private(
            "_traction", ["r", "a", "c"], [*geometry, "E_star", "mu"],
            # in the ring of slip the pressure of the stick zone is zero, also where that of the contact is infinite
            [f"sliding = {outer['_pressure']}", f"sticking = {sticking}",
             "return mu * np.where(r < c, sticking, sliding + 0.0 * c)"],
        ),
        private(
            "_tangential_displacement", ["a", "c"], [*geometry, "E_star", "G_star", "mu"],
            [f"return mu * (E_star / G_star) * ({gained('_depth', f'depth_gain({slope}, c, a)')})"],
        ),
        private(
            "_stick_radius", ["F_x", "a"], [*geometry, "E_star", "mu"],
            [
                f"F = stick_force({outer['_force']}, F_x, mu)",
                f"return np.where((F_x == 0.0) & (a >= 0.0), a, {module.call('_radius_from_force', 'F')})",
            ],
        ),
        private(
            "_full_slip_displacement", ["a"], [*geometry, "E_star", "G_star", "mu"],
            [f"return mu * (E_star / G_star) * {outer['_depth']}"],
        ),
    ]  # fmt: skip
