"""Packages, and modules of contacts for which a physics holds no functions or only one: said, never silent."""

from __future__ import annotations

from collections.abc import Sequence

from ...profiles.profile import Profile
from . import text
from .text import Function

REASONS = {
    "tangential": (
        "{title} is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F,"
        " with F from axicontact.normal.{name}.force"
    ),
    "adhesive": (
        "{title} is a complete contact whose edge does not move: adhesion does not change its solution,"
        " use axicontact.normal.{name}; the pull-off of a flat face is axicontact.adhesive.flat_punch.pull_off"
    ),
}
REFUSAL = '''"""{title}: no {group} functions.

{wrapped}
"""

from __future__ import annotations

from typing import Any

_REASON = (
{literal}
)


def __getattr__(name: str) -> Any:
    if name.startswith("__"):
        raise AttributeError(name)
    message = f"{{name}} is not defined: {{_REASON}}"
    raise AttributeError(message)
'''
PACKAGE = '''"""{title}."""

from __future__ import annotations

from importlib import import_module
from typing import Any

__all__ = [
{names}
]


def __getattr__(name: str) -> Any:
    if name in __all__:
        return import_module(f".{{name}}", __name__)
    message = f"module {{__name__!r}} has no member {{name!r}}"
    raise AttributeError(message)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
'''


def package_source(title: str, names: Sequence[str]) -> str:
    return PACKAGE.format(title=title, names="\n".join(f'    "{name}",' for name in names))


def refusal_source(profile: Profile, group: str) -> str:
    """A module whose functions do not exist, and which says why."""
    reason = REASONS[group].format(title=profile.title, name=profile.name)
    lines = text.wrapped(reason)
    literal = "\n".join(f'    "{line}{" " if line is not lines[-1] else ""}"' for line in lines)
    return REFUSAL.format(title=profile.title, group=group, wrapped="\n".join(lines), literal=literal)


def punch_source(profile: Profile) -> str:
    """The flat punch: its edge does not move until all of it breaks, with the retraction at its depth."""
    keywords = ["a", "E_star", "dgamma"]
    document = [
        "d = -sqrt(2*pi*a*dgamma/E_star)", "F = 2*E_star*a*d", "", "Parameters", "----------",
        'control : {"force", "depth"}', "    What is held while the contact is unloaded; the state is the same.",
        *text.parameters(keywords, {}, False),
        "", "Returns", "-------", "PullOff", "    Named tuple of radius [m], force [N] and depth [m].",
        "", "Raises", "------", "ValueError", "    If a parameter is outside its domain.",
        "", "References", "----------", "chapter 11, equation (11.31); Kendall 1971.",
    ]  # fmt: skip
    passed = "E_star=E_star, dgamma=dgamma"
    body = [
        "require_control(control)", "require(a=a, E_star=E_star)", "require_physics(dgamma=dgamma)",
        f"force = elementwise(lambda a, E_star, dgamma: -pull(a, E_star, dgamma), a, {passed})",
        f"depth = elementwise(lambda a, E_star, dgamma: -hess_retraction(a, E_star, dgamma), a, {passed})",
        f"return PullOff(elementwise(lambda a, E_star, dgamma: a, a, {passed}), force, depth)",
    ]  # fmt: skip
    imports = (
        ".._adhesion: PullOff, hess_retraction, pull, require_control", ".._bounds: require_physics",
        ".._domain: require", ".._elementwise: elementwise",
    )  # fmt: skip
    function = Function(
        "pull_off", [], keywords, "State at which the punch breaks off.", document, body, "PullOff",
        'control: str = "force"',
    )  # fmt: skip
    return text.module(f"{profile.title} with adhesion", profile.subtitle, imports, [function], [])
