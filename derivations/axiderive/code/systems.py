"""The module of a system for one profile: by itself, or on that of the normal contact."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Protocol

from ..entry import Entry
from ..physics import loads as prescribed
from ..physics import materials as elastic
from ..physics import normal as pressed
from ..physics import plane as strips
from ..physics import subsurface as deep
from ..physics import tangential as slipping
from ..physics import viscoelastic as creeping
from ..physics.systems import System
from . import normal, subsurface
from .graded import adhesive as graded_adhesive
from .graded import compact, complete
from .module import Module
from .physics import adhesive, detachment, loads, materials, tangential, viscoelastic
from .plane import interface as plane
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
SUPERPOSED: dict[object, Parts] = {slipping.PHYSICS: tangential, creeping.PHYSICS: viscoelastic}


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
    if system.physics.code:
        system.physics.code(writer)
        return writer.module()
    parts = SUPERPOSED.get(system.physics) or _adhesive(writer)
    parts.rules(writer)
    if interface:
        parts.interface(writer)
    return writer.module()


def _adhesive(writer: Writer) -> Parts:
    if writer.profile.complete:
        return detachment
    return graded_adhesive if writer.system.medium.graded else adhesive
