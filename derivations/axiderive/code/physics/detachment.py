"""Modules `axicontact.adhesive.<complete contact>`: the edge stays until it peels off, and only pull-off is left."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import Entry
from ...letters import name_of
from ...notation import E_star, a, dgamma
from ...physics import complete
from ...stable.forms import evaluation_form
from ...stable.signs import facts_of
from .. import example
from ..layout import OFFERED
from ..text import python
from . import text
from .examples import Example
from .text import Function, NormalModule, evaluate, private

IMPORTS = (
    "physics.adhesion: PullOff, hess_retraction, require_control",
    "interface: Array, Result, elementwise, require",
    *OFFERED,
)
EDGE = [a, E_star, dgamma]
HESS = "hess_retraction(a, E_star, dgamma)"


def module_source(module: NormalModule, entries: Mapping[str, Entry]) -> str:
    """The contact without adhesion at the depth where its edge is short by the retraction."""
    return _Detachment(module, entries).source()


class _Detachment:
    def __init__(self, module: NormalModule, entries: Mapping[str, Entry]) -> None:
        self.module, self.entries, self.profile = module, entries, module.profile
        self.symbols = [*module.profile.parameters, E_star, dgamma]
        self.keywords = [name_of(symbol) for symbol in self.symbols]
        self.example = Example(self.profile, entries, "adhesive")

    def source(self) -> str:
        """The text of the whole module."""
        title = f"{self.profile.title} with adhesion"
        public = [self.retraction(), self.pull_off()]
        source = text.module(title, self.profile.subtitle, IMPORTS, public, self.rules())
        return source.replace(text.NORMAL, self.profile.name)

    def rules(self) -> list[str]:
        """The texts of the private functions: depth and force at which the edge peels off."""
        needs = self.keywords
        form = evaluation_form(complete.edge_depth(self.profile), facts_of((a,)))
        steps = [f"{name} = {python(expr)}" for name, expr in form.steps]
        level = "" if form.value == 0 else f"{python(form.value)} "
        # at a depth where the normal contact without adhesion is not complete, so that its force is not at hand
        force = evaluation_form(self.entries["Fc"].cases[0].expr, facts_of((a,)))
        own = [f"{name} = {python(expr)}" for name, expr in force.steps]
        return [
            private("_pull_off_depth", [], needs, [*steps, f"return {level}-{' ' if level else ''}{HESS}"]),
            private("_pull_off_force", [], needs, [*own, f"return {python(force.value)}"]),
        ]

    def retraction(self) -> Function:
        """The public function of the retraction of the edge."""
        keywords = [name_of(symbol) for symbol in EDGE]
        notes = f"Valid for {self.profile.validity}."
        entry = self.entries["Dl"]
        return Function(
            entry.quantity.function, [], keywords, entry.quantity.summary,
            text.document(entry, [], keywords, notes),
            [text.required(EDGE), f"return {evaluate('hess_retraction', [], keywords, False)}"],
            example=self.example.lines(entry.suffix),
        )  # fmt: skip

    def pull_off(self) -> Function:
        """The public function `pull_off`, whose state is the same under control of force and depth."""
        named = ", ".join(f"{name}={name}" for name in self.keywords)
        body = [
            *self.module.check(self.symbols),
            "require_control(control)",
            f"depth = elementwise(_pull_off_depth, {named})",
            f"force = elementwise(_pull_off_force, {named})",
            "return PullOff(depth * 0.0 + a, force, depth)",
        ]
        return Function(
            "pull_off", [], self.keywords, "State at which the edge peels off, and with it the whole face.",
            self._document(), body, "PullOff", 'control: str = "force"', self._example(),
        )  # fmt: skip

    def _document(self) -> list[str]:
        symbols = {name_of(symbol): symbol for symbol in self.symbols}
        force, depth = self.entries["Fc"], self.entries["dc"]
        note = "A smaller contact needs a greater depth and a greater force, so that the edge does not stop."
        sources = [*(f"chapter 11, equation {own}" for own in depth.references), *self.profile.sources, "Kendall 1971"]
        return [
            *text.formula(force), *text.formula(depth),
            "", "Parameters", "----------",
            'control : {"force", "depth"}', "    What is held while the contact is unloaded; the state is the same.",
            *text.parameters(self.keywords, symbols, False),
            "", "Returns", "-------", "PullOff", "    Named tuple of radius [m], force [N] and depth [m].",
            "", "Raises", "------", "ValueError", "    If a keyword parameter is outside its domain.",
            "", "Notes", "-----", *text.wrapped(f"{note} Handbook: {force.key}, {depth.key}."),
            "", "References", "----------", *text.wrapped("; ".join(dict.fromkeys(sources)) + "."),
        ]  # fmt: skip

    def _example(self) -> list[str]:
        shown, force = self.example, self.entries["Fc"]
        passed = ", ".join(shown.keyword(symbol, shown.known) for symbol in self.symbols)
        value = shown.number(force, shown.known)
        call = f">>> state = {self.profile.name}.pull_off({passed})"
        return [*shown.head(), call, ">>> round(state.force, 6)", example.result(value)]
