"""Modules of contacts for which a physics holds no functions: said, never silent."""

from __future__ import annotations

from ..physics.systems import System
from ..profiles.profile import Profile
from .docstring import wrapped

REFUSAL = '''"""{title}: no {group} functions.

{wrapped}
"""

from __future__ import annotations

from typing import Any

__all__: list[str] = []

_REASON = (
{literal}
)


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
    literal = "\n".join(f'    "{line}{" " if line is not lines[-1] else ""}"' for line in lines)
    group = system.physics.name
    return REFUSAL.format(title=profile.title, group=group, wrapped="\n".join(lines) + ".", literal=literal)
