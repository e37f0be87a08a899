"""The module of a scene in another language than Python, from the programs of the package, and the test beside it."""

from __future__ import annotations

from contextlib import suppress
from functools import cache
from typing import TYPE_CHECKING

from ..code.module import PACKAGE
from ..exits import USAGE, CommandError
from ..languages.reach import NoProgramError, Package
from ..languages.standalone import LANGUAGES, Asked, Call, Standalone
from ..store.index import package
from . import interface
from .contact import Contact
from .evidence import Run, tolerance
from .linker import library

if TYPE_CHECKING:
    from ..expression.answer import Answer

CONTROLS = ("force", "depth")
"""What is held while a contact breaks."""
UNITS = {"radius": "m", "force": "N", "depth": "m"}
"""Of the state of pull-off."""


def programs(contact: Contact, answer: Answer | None) -> Standalone:
    """Those of a scene, of the catalogue or of the answer where the profile is an expression.

    Raises
    ------
    CommandError
        If a function has no program in the language; it names the nearest that has one.
    """
    request = contact.request
    language = LANGUAGES[request.language](_with(contact, answer) if answer else _catalogue())
    missing: dict[str, str] = {}
    for name in request.quantities:
        try:
            for asked in _asked(contact, name):
                language.add(asked)
        except NoProgramError as error:
            missing[name] = str(error)
    if missing:
        nearest = ", ".join(filter(None, dict.fromkeys(_nearest(contact, language, name) for name in missing)))
        others = f", or ask for the nearest that has one: {nearest}" if nearest else ""
        reasons = "; ".join(dict.fromkeys(missing.values()))
        told = f'no program in {request.language} ({reasons}); write language = "python"{others}'
        message = f"{', '.join(missing)}: {told}"
        raise CommandError(message, USAGE)
    return language


def translated(contact: Contact, language: Standalone, head: str, run: Run) -> dict[str, str]:
    """Module and test of a scene by the names of their files; `head` is what the module says of itself."""
    request = contact.request
    stem, suffix = request.module.rpartition(".")[0], language.suffix
    free = {own: contact.all[own] for own in request.free}
    calls = [Call(value.function, {**_given(contact, value.function, value.fields), **free, **dict(value.keywords)},
                  value.wanted) for value in run.values]  # fmt: skip
    for control, state in run.detached.items():
        # a depth of zero has no digits
        calls += [Call(_state(control, part), free, own) for part, own in zip(UNITS, state, strict=True) if own]
    return {request.module: language.text(head), f"test_{stem}.{suffix}": language.test(stem, calls, tolerance(run))}


@cache
def _catalogue() -> Package:
    """The package as it is installed, read once."""
    root = package()
    paths = {f"{PACKAGE}/{path.relative_to(root).as_posix()}": path for path in root.rglob("*.py")}
    return Package({name: path.read_text(encoding="utf-8") for name, path in paths.items()})


def _with(contact: Contact, answer: Answer) -> Package:
    """The package with the modules of a profile that is an expression, and the domains of its letters."""
    sources = library.Library(contact.entries, answer.module).sources(contact.request.kind.system)
    texts = {f"{PACKAGE}/{name.replace('.', '/')}.py": text for name, text in sources.items()}
    records = {name: interface.record(name, contact.profile) for name in interface.parameters(contact.profile)}
    ends = {name: interface.interval(record) for name, record in records.items()}
    domains = {name: (float(low), float(high), closed) for name, (low, high, closed) in ends.items()}
    return Package({**_catalogue().texts, **texts}, domains)


def _asked(contact: Contact, name: str) -> list[Asked]:
    """The functions of the file for one of the scene: that of pull-off gives three numbers for what may be held."""
    request, profile = contact.request, contact.profile
    if name == interface.PULL_OFF:
        home = f"{request.kind.system.name}.{profile.name}"
        return [
            Asked(_state(control, part), home, name, request.frozen,
                  f"{part.capitalize()} [{unit}] at which the contact breaks, under control of the {control}.",
                  part, {"control": control})
            for control in CONTROLS for part, unit in UNITS.items()
        ]  # fmt: skip
    function = interface.function(request.kind, profile, name)
    if function.whole:
        message = "fields below the surface are sums of numbers, which go over arrays"
        raise NoProgramError(message)
    quantity, home = function.quantity, f"{function.module}.{profile.name}"
    public = "peak_pressure" if quantity.member else quantity.function
    return [Asked(name, home, public, request.frozen, function.doc(profile.name), quantity.member)]


def _nearest(contact: Contact, language: Standalone, name: str) -> str:
    """The function with a program that is next to one without, of its kind or else of the plain contact of its body.

    That is the one of its name, the curve it is the inverse of, one of the same letter, or of the most of its fields.
    """
    kind, profile = contact.request.kind, contact.profile
    lacking = interface.functions(kind, interface.contact_of(profile)).get(name)

    def distance(one: interface.Function) -> tuple[bool | int, ...]:
        if lacking is None:
            return (one.name != name,)
        own, known = lacking.quantity, one.quantity
        shared = {*lacking.fields} & {*one.fields}
        return one.name != name, known.suffix != own.inverts, known.symbol != own.symbol, -len(shared)

    for own in dict.fromkeys((kind, kind.below or kind, interface.Kind(kind.plain))):
        known = interface.functions(own, interface.contact_of(profile)).values()
        for function in sorted((one for one in known if not one.whole), key=distance):
            home, quantity = f"{function.module}.{profile.name}", function.quantity
            with suppress(NoProgramError):
                language.add(Asked(function.name, home, quantity.function, contact.request.frozen, ""))
                return function.name if own is kind else f"{function.name} of {own.name} contact"
    return ""


def _state(control: str, part: str) -> str:
    """What a number of the state of pull-off is called."""
    return f"pull_off_{part}" if control == CONTROLS[0] else f"pull_off_{part}_by_{control}"


def _given(contact: Contact, name: str, fields: tuple[float, ...]) -> dict[str, float]:
    """The fields of a call by name."""
    function = interface.function(contact.request.kind, contact.profile, name)
    return dict(zip(interface.arguments(function, contact.entries), fields, strict=True))
