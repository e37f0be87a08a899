"""Modules `axicontact.viscoelastic.<profile>`: the elastic contact of unit modulus by the rule of Lee and Radok."""

from __future__ import annotations

from ...contact import viscoelastic
from ...contact.viscoelastic import LAWS
from ...entry import Entry
from ..code import python
from . import text
from .text import Function, NormalModule, evaluate, private

_NAMES = ", ".join(f"{kind}_{law.name}" for kind in ("creep", "ramp", "relaxation") for law in LAWS)
IMPORTS = (
    ".._bounds: require_physics",
    ".._domain: require, require_coefficients, require_order",
    ".._elementwise: Array, Result, elementwise",
    f".._relaxation: {_NAMES}",
)
LAW = {
    "maxwell": "a Maxwell fluid", "kelvin_voigt": "a Kelvin-Voigt solid", "standard_solid": "a standard solid",
    "power_creep": "a material of power-law creep",
}  # fmt: skip
SUMMARY = {
    "ramp": "Normal force at time t on {}, indented at the constant speed v.",
    "step": "Normal force at time t on {}, held at the indentation depth d from t = 0 on.",
    "load": "Contact radius at time t on {}, under the constant normal force F from t = 0 on.",
}


def module_source(module: NormalModule) -> str:
    """The module of one profile; a ramp only where the force is a power of the depth."""
    entries = viscoelastic.derive(module.profile)
    public, formulas = [], []
    for suffix, entry in entries.items():
        kind, law = suffix.split("_")[0], next(law for law in LAWS if suffix.endswith(f"_{law.suffix}"))
        loads = [str(argument) for argument in entry.quantity.arguments[1:]]
        keywords = [*loads, *(text.name_of(symbol) for symbol in entry.parameters)]
        name = entry.quantity.function
        body = module.check(keywords)
        body.append(f"return {evaluate(f'_{name}', ['t'], keywords, module.summed)}")
        notes = f"Valid for {module.profile.validity}; growing contact only. Negative or NaN times give NaN."
        document = _document(entry, keywords, notes)
        public.append(Function(name, ["t"], keywords, SUMMARY[kind].format(LAW[law.name]), document, body))
        material = [text.name_of(symbol) for symbol in law.parameters]
        formulas.append(_formula(module, entry, kind, law.name, material))
    title = f"{module.profile.title} on a viscoelastic half space"
    source = text.module(title, module.profile.subtitle, IMPORTS, public, formulas)
    return source.replace(text.NORMAL, module.profile.name)


def _document(entry: Entry, keywords: list[str], notes: str) -> list[str]:
    return [
        line if line != "time : array_like" else "t : array_like"
        for line in text.document(entry, ["t"], keywords, notes)
    ]


def _formula(module: NormalModule, entry: Entry, kind: str, law: str, material: list[str]) -> str:
    name, geometry, passed = f"_{entry.quantity.function}", module.geometry, ", ".join(material)
    elastic = "_force_from_depth" if "_force_from_depth" in module.functions else "_force"
    if kind == "step":
        lines = [f"return relaxation_{law}(t, {passed}) * {module.call(elastic, 'd', E_star='1.0')}"]
        return private(name, ["t"], ["d", *geometry, *material], lines)
    if kind == "load":
        lines = [f"return {module.call('_radius_from_force', f'F * creep_{law}(t, {passed})', E_star='1.0')}"]
        return private(name, ["t"], ["F", *geometry, *material], lines)
    plain = module.entries["Fd"] if "Fd" in module.entries else module.entries["F"]
    exponent = viscoelastic._exponent(plain)
    m = f"({python(exponent)} + 0.0 * t)"
    lines = [f"m = {m}", f"force = {module.call(elastic, 'v * t', E_star='1.0')} * ramp_{law}(t, m, {passed})"]
    start = "0.0"
    if law == "kelvin_voigt":
        # the viscous part of a force that grows in proportion to the depth does not start from zero
        start = f"np.where(m == 1.0, {module.call(elastic, 'v', E_star='1.0')} * eta, 0.0)"
    lines.append(f"return np.where(t == 0.0, {start}, force)")
    return private(name, ["t"], ["v", *geometry, *material], lines)
