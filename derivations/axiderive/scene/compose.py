"""From a scene, or an expression alone, to files: module, test, page, evidence, manifest - a pure function."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import sympy as sp

from .. import notation as nt
from ..code import plane as strips
from ..exits import USAGE, CommandError
from ..physics import layer
from . import evidence, interface
from .contact import Contact
from .evidence import Run, measured, test_text
from .interface import Function
from .linker import library, module
from .linker.library import Module, definition
from .linker.linking import OWN, Wanted
from .page import page_sources
from .reading import Scene
from .references import check_values
from .translation import programs, translated

if TYPE_CHECKING:
    from ..expression.answer import Answer

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
    with nt.extended(request.notation):
        return _Composition(request, answer).result(typeset)


class _Composition:
    def __init__(self, request: Scene, answer: Answer | None) -> None:
        self.request, self.answer = request, answer
        if request.own is not None:
            # what a scene of the catalogue does not need is not imported for it
            from ..expression.answer import answered

            own = request.own
            fields = {name for one in interface.functions(request.kind).values() for name in one.fields}
            if nt.c.name in fields & {p.name for p in own.profile.parameters}:
                message = "c is the radius of stick in a tangential contact; give the parameter c another letter"
                raise CommandError(message, USAGE)
            exact = {p: sp.Rational(v) for p in own.profile.parameters if (v := request.values.get(p.name)) is not None}
            self.answer = answer or answered(own, exact)
            self.profile, self.entries = self.answer.profile, self.answer.entries
        else:
            self.profile = request.subject
            self.entries = library.stored_entries(self.profile, request.kind)
        self._require_reach()
        self.contact = Contact(self.profile, self.entries, self.request)

    def _require_reach(self) -> None:
        """Inverses of a contact that is compact up to some radius need that radius, and it needs all values."""
        free = [p for p in interface.parameters(self.profile) if p not in self.request.values]
        # all that a viscoelastic contact has is an inverse of the elastic one
        kind, inverses = self.request.kind, set(self.request.quantities)
        wanted = sorted(inverses if kind.law else inverses & interface.INVERSES)
        if self.answer and self.answer.bounded and wanted and kind.physics is layer.PHYSICS:
            message = (
                f"{', '.join(wanted)}: the expression is that of a contact up to some radius, "
                "which no function on a layer knows; leave these functions out"
            )
            raise CommandError(message, USAGE)
        if self.answer and self.answer.bounded and free and wanted and (kind.law or not kind.physics.over):
            message = (
                f"{', '.join(wanted)}: how far the contact is compact depends on {', '.join(free)}; "
                f"freeze the parameters{'' if kind.law else ', or leave these functions out'}"
            )
            raise CommandError(message, USAGE)

    def result(self, typeset: Typesetter) -> Result:
        """All files of the request and what is told of them; `typeset` gets the page before the rest is computed."""
        request, page = self.request, dict[str, bytes]()
        if {"tex", "pdf"} & set(request.formats):
            known = evidence.stored(request, self.profile, self.answer)
            page = page_sources(request, self.profile, self.entries, known)
            typeset(page)
        # what has no program is refused before anything is integrated
        language = programs(self.contact, self.answer) if request.language in {*request.formats} - {"python"} else None
        (text, wanted), stem = self._module(), request.module.removesuffix(".py")
        free = {name: self.contact.all[name] for name in request.free}
        values = check_values(self.contact, {one.name: one.keywords for one in wanted})
        run = measured(text, values, free, self.contact)
        files: dict[str, bytes] = {}
        if request.language in request.formats:
            head = module.head(request, self.profile, self.answer, self.contact)
            own = {request.module: text, f"test_{stem}.py": test_text(stem, run, free, self._origin())}
            written = own if language is None else translated(self.contact, language, head.strip(), run)
            files |= {name: content.encode() for name, content in written.items()}
        if "tex" in request.formats:
            files |= page
        if "json" in request.formats:
            files["evidence.json"] = _json(evidence.record(request, self.profile, self.answer, run))
        if request.text:
            files["scene.toml"] = request.text.encode()
        return Result(files, tuple(self._lines(run)))

    # the module

    def _comment(self, name: str) -> str:
        record = interface.record(name, self.profile)
        meaning = record.meaning
        if self.request.kind.system.pool.strip:
            meaning = strips.meaning(self.profile, record.symbol)
        return f"{meaning} [{record.unit}]"

    def _module(self) -> tuple[str, list[Wanted]]:
        """The text of the module, and what it has for others."""
        request, kind = self.request, self.request.kind
        modules: dict[str, Module] = library.Library(self.entries, self.answer.module if self.answer else "")
        texts = [module.order(self.profile, interface.between(self.profile, kind), kind, request.values)]
        wanted = [self._wanted(modules, quantity, texts) for quantity in request.quantities]
        modules[OWN] = Module(OWN, "\n\n".join(texts))
        constants: dict[str, tuple[float | str, str]] = {
            name: (value, self._comment(name)) for name, value in request.frozen.items()
        }
        meanings = kind.physics.choices
        constants |= {name: (word, meanings[name][0]) for name, word in request.choices.items()}
        domains = {p: interface.interval(interface.record(p, self.profile)) for p in request.free}
        fields = {name for one in wanted for name in one.fields}
        units = {name: interface.unit(name, self.profile) for name in {*fields, *request.free}}
        title = module.head(request, self.profile, self.answer, self.contact)
        return module.module_text(title, modules, wanted, constants, domains, units), wanted

    def _wanted(self, modules: Mapping[str, Module], quantity: str, texts: list[str]) -> Wanted:
        """One function of the interface; what is written for it is added to `texts`."""
        kind, name, free = self.request.kind, self.profile.name, self.request.free
        concave = interface.contact_of(self.profile) == interface.CONCAVE
        # whether the rules of a number run in arrays, as that of the ring of zero pressure does
        array = concave and ("n" in interface.parameters(self.profile) or kind.graded) and quantity != "stiffness"
        if quantity == interface.PULL_OFF:
            texts.append(module.pull_off(modules, f"{kind.name}.{name}", self.request.keywords, array=array))
            return Wanted(f"{OWN}:{quantity}", quantity, PULL_OFF_DOC, tuple(free), leading='control="force"')
        function = interface.function(kind, self.profile, quantity)
        if function.whole:
            return self._whole(modules, function, texts)
        package, private = f"{function.module}.{name}", f"_{function.quantity.function}"
        key = f"{package}:{private}"
        if private not in modules[package].definitions:
            # the shape is that of any medium
            key = OF_RUNTIME.get(kind.name, {}).get(quantity, f"normal.{name}:_{quantity}")
        fields, needs = interface.arguments(function, self.entries), definition(modules, key).parameters
        if nt.t_h.name in fields:
            if module.TEMPLATES["hold"] not in texts:
                texts.append(module.TEMPLATES["hold"])
            texts.append(module.held(modules, key, quantity))
            key = f"{OWN}:{quantity}"
        elif not fields or function.leaning:
            write = module.leaning(key, quantity) if fields else module.number(modules, key, quantity, array=array)
            texts.append(write)
            key = f"{OWN}:{quantity}"
        keywords = tuple(p for p in needs if p in free and p not in fields)
        return Wanted(
            key, quantity, function.doc(name), keywords, fields, signed=function.signed, parity=function.parity
        )

    def _whole(self, modules: Mapping[str, Module], function: Function, texts: list[str]) -> Wanted:
        """A function of several results, as the package has it; what is asked of a stress takes nothing else."""
        if not function.fields:
            own = definition(modules, f"{module.STRESSES}:{function.name}")
            return Wanted(own.key, function.name, "", (), leading=module.taken(own))
        text, needs = module.whole(modules[f"{function.module}.{self.profile.name}"], function)
        texts.append(text)
        keywords = tuple(name for name in needs if name in self.request.free)
        doc = function.doc(self.profile.name)
        return Wanted(f"{OWN}:{function.name}", function.name, doc, keywords, function.fields, whole=True)

    def _origin(self) -> str:
        """Where the check values come from."""
        tilted = interface.contact_of(self.profile) == interface.TILTED
        return "the proved formulas" if tilted else "the integrals that define them"

    def _lines(self, run: Run) -> list[str]:
        worst = max(run.errors.items(), key=lambda row: row[1], default=("", 0.0))
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
