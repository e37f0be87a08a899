"""The module of a system for one profile: by itself, on that of the normal contact, or saying why it is empty."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from importlib import import_module
from typing import Protocol, cast

from ..entry import Entry
from ..physics import loads as prescribed
from ..physics import materials as elastic
from ..physics import normal as pressed
from ..physics import plane as strips
from ..physics import subsurface as deep
from ..physics.systems import System
from ..profiles.profile import Profile
from . import normal, plane, subsurface
from .docstring import wrapped
from .function import LINE
from .graded import adhesive as graded_adhesive
from .graded import compact, complete
from .module import Module
from .physics import adhesive, detachment, loads, materials, stated
from .writer import Writer

Entries = Mapping[str, Entry]


class Parts(Protocol):
    """How the modules of a physics on another contact are written."""

    def interface(self, writer: Writer) -> None:
        """Adds the public functions."""

    def rules(self, writer: Writer) -> None:
        """Adds the private functions, which they rest on."""


ALONE: dict[object, Callable[[Entries], Module]] = {
    pressed.PHYSICS: normal.module,
    strips.PHYSICS: plane.module,
    prescribed.PHYSICS: loads.module,
    elastic.PHYSICS: materials.module,
}


def alone(system: System, entries: Entries) -> Module:
    """The module of a contact that rests on no other."""
    if not system.medium.graded:
        return ALONE[system.physics](entries)
    grows = next(iter(entries.values())).profile.compact
    return (compact if grows else complete).module(system, entries)


def superposed(
    system: System, entries: Entries, plain: Entries, normal: Mapping[str, Sequence[str]], *, interface: bool = True
) -> Module:
    """The module of a contact on the normal one, whose entries are `plain` and whose functions take what `normal` says.

    Without its `interface` it holds what that rests on.
    """
    if system.physics is deep.PHYSICS:
        return subsurface.module(entries, plain, normal)
    writer = Writer(system, entries, plain, normal)
    parts = _parts(writer)
    parts.rules(writer)
    if interface:
        parts.interface(writer)
    return writer.module()


def _parts(writer: Writer) -> Parts:
    """What writes them: the file of `code/physics` with the name of the physics, where it states no code itself."""
    physics = writer.system.physics
    if physics.code:
        return stated
    if not physics.tension:
        return cast(Parts, import_module(f".physics.{physics.name}", __package__))
    if writer.profile.complete:
        return detachment
    return graded_adhesive if writer.system.medium.graded else adhesive


REFUSAL = '''"""{title}: no {group} functions.

{wrapped}
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = {literal}


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{{name}} is not defined: {{_REASON}}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return __all__
'''


def refusal_source(system: System, profile: Profile) -> str:
    """A module whose functions do not exist, and which says why."""
    reason = system.refusal(profile).replace(profile.name, profile.title, 1)
    if system.physics.beside and system.base:
        reason += f", with F from {system.base.package}.{profile.name}.force"
    lines = wrapped(reason)
    return REFUSAL.format(
        title=profile.title, group=system.physics.name, wrapped="\n".join(lines) + ".", literal=_literal(reason, lines)
    )


def _literal(reason: str, lines: list[str]) -> str:
    """A string as the formatter has it: on the line of its name, on a line of its own, or in parts."""
    if len(f'_REASON = "{reason}"') <= LINE:
        return f'"{reason}"'
    if len(f'    "{reason}"') <= LINE:
        lines = [reason]
    parts = (f'    "{line}{" " if line is not lines[-1] else ""}"' for line in lines)
    return "\n".join(["(", *parts, ")"])
