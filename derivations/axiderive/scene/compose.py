"""From a scene, or an expression alone, to files: module, test, page, evidence, manifest - a pure function."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import sympy as sp

from .. import notation as nt
from ..code.plane import document
from ..exits import USAGE, CommandError
from . import evidence, interface
from .contact import Contact, values_of
from .evidence import Run, measured, test_text
from .linker import assembled, sources
from .linker.assembled import Assembled
from .linker.library import Module, definition
from .linker.linking import OWN, Wanted
from .linker.module import head, module_text
from .page import page_sources
from .reading import Scene
from .references import check_values

if TYPE_CHECKING:
    from ..expression.answer import Answer
    from ..expression.profile import OwnProfile

Typesetter = Callable[[Mapping[str, bytes]], None]
OF_RUNTIME = {
    "adhesive": {"retraction": "_runtime.physics.adhesion:hess_retraction"},
    "graded.adhesive": {"retraction": "_runtime.graded.punch:graded_retraction"},
}
"""What is the same for all profiles."""
PULL_OFF_DOC = 'Radius, force and depth [m, N, m] at which the contact breaks, control of "force" or "depth".'


@dataclass(frozen=True)
class Result:
    """The files by name, and what there is to tell."""

    files: dict[str, bytes]
    lines: tuple[str, ...]


def composed(request: Scene, answer: Answer | None = None, typeset: Typesetter = lambda page: None) -> Result:
    """The files of a request.

    Parameters
    ----------
    request : Scene
        What is to be composed.
    answer : Answer, optional
        The answer to its expression, if it is known already.
    typeset : callable, optional
        Takes the sources of the page as soon as they are known, for LaTeX to work beside the rest.
    """
    with nt.extended(request.own.notation if request.own else ()):
        return _Composition(request, answer).result(typeset)


def _derived(own: OwnProfile, values: Mapping[sp.Symbol, sp.Rational]) -> Answer:
    # what a scene of the catalogue does not need is not imported for it
    from ..expression.answer import answered

    return answered(own, values)


class _Composition:
    def __init__(self, request: Scene, answer: Answer | None) -> None:
        self.request, self.answer = request, answer
        if request.own is not None:
            fields = {name for own in interface.functions(request.kind).values() for name in own.fields}
            if nt.c.name in fields & {p.name for p in request.own.profile.parameters}:
                message = "c is the radius of stick in a tangential contact; give the parameter c another letter"
                raise CommandError(message, USAGE)
            given = {p: request.values.get(p.name) for p in request.own.profile.parameters}
            exact = {p: sp.Rational(v) for p, v in given.items() if v is not None}
            self.answer = answer or _derived(request.own, exact)
            self.profile, self.entries = self.answer.profile, self.answer.entries
            self.normal = self.answer.module
        else:
            assert request.profile is not None
            self.profile = request.profile
            self.entries = sources.stored_entries(self.profile, request.kind)
            self.normal = sources.stored_module(self.profile.name, self.entries, request.kind)
        self.parameters = list(interface.parameters(self.profile))
        self._require_reach()
        self.contact = Contact(self.profile, self.entries, self.request)

    def _require_reach(self) -> None:
        """Inverses of a contact that is compact up to some radius need that radius, and it needs all values."""
        free = [p for p in self.parameters if p not in self.request.values]
        # all that a viscoelastic contact has is an inverse of the elastic one
        kind, inverses = self.request.kind, set(self.request.quantities)
        wanted = sorted(inverses if kind.law else inverses & interface.INVERSES)
        if self.answer and self.answer.bounded and free and wanted and (kind.law or not kind.physics.over):
            message = (
                f"{', '.join(wanted)}: how far the contact is compact depends on {', '.join(free)}; "
                f"freeze the parameters{'' if kind.law else ', or leave these functions out'}"
            )
            raise CommandError(message, USAGE)

    def result(self, typeset: Typesetter) -> Result:
        """All files of the request and what is told of them; `typeset` gets the page before the rest is computed."""
        page: dict[str, bytes] = {}
        if {"tex", "pdf"} & set(self.request.formats):
            page = page_sources(
                self.request, self.profile, self.entries, evidence.stored(self.request, self.profile, self.answer)
            )
            typeset(page)
        text = self._module()
        stem = self.request.module.removesuffix(".py")
        values = check_values(self.contact, self._keywords)
        run = measured(text, values, self.request, self._free(), self.contact)
        values, errors = run.values, run.errors
        files: dict[str, bytes] = {}
        if "python" in self.request.formats:
            files[self.request.module] = text.encode()
            files[f"test_{stem}.py"] = test_text(stem, run, self._free(), self._origin()).encode()
        if "tex" in self.request.formats:
            files |= page
        if "json" in self.request.formats:
            files["evidence.json"] = _json(
                evidence.record(
                    self.request, self.profile, self.answer, self._ordered(self.request.values), values, errors
                )
            )
        if self.request.text:
            files["scene.toml"] = self.request.text.encode()
        return Result(files, tuple(self._lines(run)))

    def _free(self) -> dict[str, float]:
        """Values for the parameters that stay free, in the order of the interface."""
        names = self._keywords([*self.parameters, *self.request.kind.material])
        known, _ = values_of(self.profile, self.request)
        return {name: known[name] for name in names}

    # the module

    def _comment(self, name: str) -> str:
        record = interface.record(name, self.profile)
        meaning = record.meaning
        if self.request.kind.system.pool.strip:
            meaning = document.meaning(self.profile, record.symbol)
        return f"{meaning} [{record.unit}]"

    def _keywords(self, names: Sequence[str]) -> tuple[str, ...]:
        return tuple(name for name in names if name not in self.request.values)

    def _module(self) -> str:
        request, kind = self.request, self.request.kind
        modules = sources.library(self.profile, self.entries, self.normal, kind)
        written, order = assembled.order(self.profile, interface.between(self.profile, kind), kind, request.values)
        texts = [written] if written else []
        wanted: list[Wanted] = []
        above: list[Assembled] = []
        for quantity in request.quantities:
            one = self._pull_off(modules) if quantity == interface.PULL_OFF else self._wanted(modules, quantity, texts)
            if isinstance(one, Wanted):
                wanted.append(one)
            else:
                above.append(one)
        texts += [one.text for one in above]
        modules = modules | ({OWN: assembled.module(texts)} if texts else {})
        constants = {k: (value, self._comment(k)) for k, value in self._ordered(request.values).items()}
        free = [p for p in (*self.parameters, *self.request.kind.material) if p not in request.values]
        ends = {p: interface.interval(interface.record(p, self.profile)) for p in free}
        domains = {
            p: (low.replace("-inf", "-np.inf"), high.replace("inf", "np.inf")) for p, (low, high) in ends.items()
        }
        fields = {name for one in wanted for name in one.fields}
        units = {name: interface.record(name, self.profile).unit for name in {*fields, *free}}
        title = head(request, self.profile, self.answer, self.contact)
        return module_text(title, modules, wanted, constants, domains, units, above, order)

    def _wanted(self, modules: Mapping[str, Module], quantity: str, texts: list[str]) -> Wanted | Assembled:
        """One function of the interface; the text of a new one below it is added to `texts`."""
        kind, name = self.request.kind, self.profile.name
        function = interface.function(kind, self.profile, quantity)
        module, private = f"{function.module}.{name}", f"_{function.quantity.function}"
        key = f"{module}:{private}"
        if private not in modules[module].definitions:
            # the shape is that of any medium
            key = OF_RUNTIME.get(kind.name, {}).get(quantity, f"normal.{name}:_{quantity}")
        fields = interface.arguments(function, self.entries)
        needs = [p for p in definition(modules, key).parameters if p not in fields]
        doc, keywords = function.doc(name), self._keywords(needs)
        if not fields:
            return assembled.number(modules, key, quantity, doc, keywords, array=self._bisected(function.name))
        if function.leaning:
            texts.append(assembled.leaning(key, quantity))
            key = f"{OWN}:{quantity}"
        return Wanted(key, quantity, fields, keywords, doc, function.signed, function.parity)

    def _pull_off(self, modules: Mapping[str, Module]) -> Assembled:
        parameters = (*self.parameters, *self.request.kind.material)
        key = f"{self.request.kind.name}.{self.profile.name}"
        return assembled.pull_off(
            modules, key, PULL_OFF_DOC, parameters, self._keywords(parameters), array=self._bisected(interface.PULL_OFF)
        )

    def _bisected(self, name: str) -> bool:
        """Whether the rules of a number run in arrays, as that of the ring of zero pressure does."""
        concave = interface.contact_of(self.profile) == interface.CONCAVE
        general = "n" in self.parameters or self.request.kind.graded
        return concave and general and name != "stiffness"

    def _ordered(self, values: Mapping[str, float]) -> dict[str, float]:
        order = [*self.parameters, *self.request.kind.material]
        return {name: values[name] for name in order if name in values}

    def _origin(self) -> str:
        """Where the check values come from."""
        tilted = interface.contact_of(self.profile) == interface.TILTED
        return "the proved formulas" if tilted else "the integrals that define them"

    def _lines(self, run: Run) -> list[str]:
        errors = run.errors
        worst = max(errors.items(), key=lambda row: row[1], default=("", 0.0))
        lines, count = [], len(run.values) + 3 * len(run.detached)
        if self.answer is not None and (told := self.answer.told):
            lines.append(f"form      {told}")
        if count:
            lines.append(f"module    {count} values agree with the definition, worst {worst[1]:.1e} ({worst[0]})")
        return lines


def manifest(files: Mapping[str, bytes]) -> bytes:
    """SHA-256 of every file."""
    return _json({path: hashlib.sha256(files[path]).hexdigest() for path in sorted(files)})


def _json(record: Any) -> bytes:
    return (json.dumps(record, indent=1, ensure_ascii=False) + "\n").encode()
