"""The module of a scene in another language than Python, from the programs of the package, and the test beside it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from ..code.module import PACKAGE
from ..exits import USAGE, CommandError
from ..languages.reach import NoProgramError, Package
from ..languages.standalone import LANGUAGES, Asked, Call, Standalone
from ..store.index import package
from . import interface
from .contact import Contact
from .evidence import Run, tolerance


def translated(contact: Contact, head: str, run: Run) -> dict[str, str]:
    """Module and test of a scene by the names of their files; `head` is what the module says of itself.

    Raises
    ------
    CommandError
        If a function has no program in the language; it names those that have.
    """
    request = contact.request
    language = LANGUAGES[request.language](_catalogue())
    missing: dict[str, str] = {}
    for name in request.quantities:
        try:
            language.add(_asked(contact, name))
        except NoProgramError as error:
            missing[name] = str(error)
    if missing:
        others = f", or ask for {', '.join(language.functions)}" if language.functions else ""
        reasons = "; ".join(dict.fromkeys(missing.values()))
        message = (
            f'{", ".join(missing)}: no program in {request.language} ({reasons}); write language = "python"{others}'
        )
        raise CommandError(message, USAGE)
    stem, suffix = request.module.rpartition(".")[0], language.suffix
    calls = [Call(value.function, _given(contact, language, value.function, value.fields, dict(value.keywords)),
                  value.wanted) for value in run.values]  # fmt: skip
    return {request.module: language.text(head), f"test_{stem}.{suffix}": language.test(stem, calls, tolerance(run))}


@cache
def _catalogue() -> Package:
    """The package as it is installed, read once."""
    root = package()
    paths = {f"{PACKAGE}/{path.relative_to(root).as_posix()}": path for path in root.rglob("*.py")}
    return Package({name: path.read_text(encoding="utf-8") for name, path in paths.items()})


def _asked(contact: Contact, name: str) -> Asked:
    request, profile = contact.request, contact.profile
    if name == interface.PULL_OFF:
        message = "pull_off gives three numbers"
        raise NoProgramError(message)
    if request.own is not None:
        message = "the programs are those of the catalogue, and this is an expression"
        raise NoProgramError(message)
    function = interface.function(request.kind, profile, name)
    if function.whole:
        message = "fields below the surface are sums of numbers, which go over arrays"
        raise NoProgramError(message)
    home = f"{function.module}.{profile.name}"
    return Asked(name, home, function.quantity.function, request.frozen, function.doc(profile.name), function.parity)


def _given(
    contact: Contact, language: Standalone, name: str, fields: tuple[float, ...], keywords: Mapping[str, float]
) -> dict[str, float]:
    """The arguments of a call by name."""
    function = interface.function(contact.request.kind, contact.profile, name)
    names = interface.arguments(function, contact.entries)
    return {**dict(zip(names, fields, strict=True)), **{free: contact.all[free] for free in contact.request.free},
            **keywords}  # fmt: skip
