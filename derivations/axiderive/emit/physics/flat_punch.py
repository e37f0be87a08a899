"""`axicontact.adhesive.flat_punch`: the edge does not move until all of it breaks, so that only pull-off is left."""

from __future__ import annotations

import sympy as sp

from ...contact.adhesive import hess_rule
from ...contact.medium import HOMOGENEOUS
from ...notation import E_star, a, d, dgamma
from .. import example
from . import text
from .examples import Example
from .text import Function, NormalModule, private

IMPORTS = (
    ".._adhesion: PullOff, hess_retraction, require_control",
    ".._domain: require",
    ".._elementwise: Array, elementwise",
)


def module_source(module: NormalModule) -> str:
    """The punch of the normal contact, raised by the retraction of its edge."""
    symbols = [a, E_star, dgamma]
    keywords = [text.name_of(symbol) for symbol in symbols]
    named = ", ".join(f"{name}={name}" for name in keywords)
    body = [
        *module.check(symbols),
        "require_control(control)",
        f"depth = elementwise(_depth, {named})",
        f"force = elementwise(_force, {named})",
        "return PullOff(depth * 0.0 + a, force, depth)",
    ]
    own = Function(
        "pull_off", [], keywords, "State at which the punch breaks off.", _document(module, keywords), body,
        "PullOff", 'control: str = "force"', _example(module, symbols),
    )  # fmt: skip
    functions = [
        private("_depth", [], keywords, ["return -hess_retraction(a, E_star, dgamma)"]),
        private("_force", [], keywords, [f"return {module.call('_force', '_depth(a, E_star, dgamma)')}"]),
    ]
    title = f"{module.profile.title} with adhesion"
    source = text.module(title, module.profile.subtitle, IMPORTS, [own], functions)
    return source.replace(text.NORMAL, module.profile.name)


def _document(module: NormalModule, keywords: list[str]) -> list[str]:
    force, shift = module.entries["F"], hess_rule(HOMOGENEOUS)
    return [
        f"d = {sp.sstr(-shift)}",
        f"F = {sp.sstr(force.cases[0].expr.subs(d, -shift))}",
        "", "Parameters", "----------",
        'control : {"force", "depth"}', "    What is held while the contact is unloaded; the state is the same.",
        *text.parameters(keywords, {}, False),
        "", "Returns", "-------", "PullOff", "    Named tuple of radius [m], force [N] and depth [m].",
        "", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain.",
        "", "Notes", "-----",
        *text.wrapped(f"The force {force.key} at the depth of the retraction, which does not depend on the profile."),
        "", "References", "----------", "chapter 11, equation (11.31).",
    ]  # fmt: skip


def _example(module: NormalModule, symbols: list[sp.Symbol]) -> list[str]:
    shown = Example(module.profile, module.entries, "adhesive")
    call = f"flat_punch.pull_off({', '.join(shown.keyword(symbol, shown.known) for symbol in symbols)})"
    force = module.entries["F"].cases[0].expr.subs(d, -hess_rule(HOMOGENEOUS))
    value = example.result(example.number(force, shown.known))
    return [*shown.head(), f">>> state = {call}", ">>> round(state.force, 6)", value]
