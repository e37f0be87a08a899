"""The kind of contact a scene asks for, and the combinations that are at hand."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .. import profiles
from ..profiles import loads as prescribed
from ..profiles import plane as strips
from ..profiles.profile import Profile
from . import interface
from .freezing import inline
from .sources import graded_refusal
from .text import SceneText, near

if TYPE_CHECKING:
    from .reading import Scene

PHYSICS = ("normal", "adhesive", "tangential", "viscoelastic", "plane", "loads")
# the load of the eccentric punch acts on either side of the middle, which no scene can say
STRIPS = tuple(name for name in strips.NAMES if name != "eccentric_punch")
# the free exponent shares its letter s with a length of the notation
PRESSURES = tuple(load.name for load in prescribed.LOADS if load.name != "power")
Pool = tuple[str, tuple[str, ...], Callable[[str], Profile]]
"""What its members are called, their names, and how they are loaded."""
POOLS: dict[str, Pool] = {
    "plane": ("plane profile", STRIPS, strips.load),
    "loads": ("prescribed pressure", PRESSURES, prescribed.load),
}
"""Kinds of contact with profiles of their own."""


def alone(text: SceneText, name: str) -> bool:
    """Whether a scene names this kind of contact and no other one."""
    table = text.values.get("physics")
    asked = [key for key in PHYSICS[1:] if table.get(key) not in (None, False)] if isinstance(table, dict) else []
    return asked == [name]


def pool(text: SceneText) -> Pool:
    """The profiles that a scene can name."""
    own = next((pool for name, pool in POOLS.items() if alone(text, name)), None)
    return own or ("profile", profiles.NAMES, profiles.load)


def physics(text: SceneText, scene: Scene) -> None:
    table = text.table("physics", PHYSICS)
    chosen = [name for name in PHYSICS[1:] if table.get(name) not in (None, False)]
    if len(chosen) > 1:
        count = {2: "two", 3: "three", 4: "four", 5: "five"}[len(chosen)]
        message = f"{' and '.join(chosen)} together are not derived; emit {count} scenes, one with each"
        text.problem("physics", chosen[-1], message)
    medium = text.values.get("medium")
    graded = isinstance(medium, dict) and medium.get("kind") == "power_law"
    profile = scene.profile
    scene.physics = chosen[0] if chosen else "normal"
    if graded and scene.physics == "viscoelastic":
        message = (
            "viscoelastic on a graded half space is not derived; the nearest is tangential = true or normal = true"
        )
        text.problem("physics", "viscoelastic", message)
        scene.physics = "graded"
    elif graded and scene.physics in POOLS:
        message = f'{scene.physics} on a graded half space is not derived; the nearest is kind = "homogeneous"'
        text.problem("physics", scene.physics, message)
    elif graded:
        scene.physics = ".".join(["graded", *chosen[:1]])
    elif scene.physics == "viscoelastic":
        scene.physics = _viscoelastic(text, scene, table["viscoelastic"], profile)
    if graded and profile is not None and profile.contact != "compact" and scene.physics not in POOLS:
        what = f"{profile.name}, a complete contact, on a graded half space"
        text.problem("medium", "kind", f'{what} cannot be emitted; the nearest is kind = "homogeneous"')
    elif graded and profile is not None and scene.own and (reason := graded_refusal(profile)):
        text.problem("medium", "kind", f'{reason}; or kind = "homogeneous"')
    if scene.physics in POOLS and scene.own:
        message = f"{scene.physics} is emitted for what the catalogue holds; the nearest here is normal = true"
        text.problem("physics", scene.physics, message)
    if profile is not None and profile.contact != "compact" and chosen and chosen[0] not in POOLS:
        message = f"{chosen[0]} is not at hand for {profile.name}, a complete contact; the nearest is normal = true"
        text.problem("physics", chosen[0], message)
    for name in chosen:
        _table(text, scene, name, table[name])


def _table(text: SceneText, scene: Scene, name: str, raw: Any) -> None:
    """The values of one kind of contact."""
    if name == "viscoelastic":
        if not scene.physics.startswith(name):
            return
        raw = {key: value for key, value in raw.items() if key != "model"}
    own = interface.kind_of(scene.physics) == name
    names = [n for n in interface.MATERIAL[scene.physics if own else name] if n not in ("E_star", "H", "k")]
    if raw is True:
        return
    if name in POOLS:
        text.problem("physics", name, f"{name} takes no values of its own; write {name} = true")
        return
    if not isinstance(raw, dict):
        text.problem("physics", name, f"{name} must be true or a table such as {{ {names[0]} = ... }}")
        return
    for key, value in raw.items():
        if key in names:
            inline(text, scene.values, name, key, value)
        else:
            text.problem("physics", name, f"unknown key {key[:40]!r} of {name}{near(key, names)}")


def _viscoelastic(text: SceneText, scene: Scene, raw: Any, profile: Profile | None) -> str:
    """The kind of contact with its material law; `normal` where something is wrong."""
    laws = ", ".join(interface.LAWS)
    form = 'write viscoelastic = { model = "standard_solid", E_inf = "1 MPa", E_1 = "2 MPa", tau = "3 s" }'
    model = raw.get("model") if isinstance(raw, dict) else None
    if not isinstance(model, str):
        text.problem("physics", "viscoelastic", f"viscoelastic needs a model out of {laws}; {form}")
        return "normal"
    if model not in interface.LAWS:
        text.problem("physics", "viscoelastic", f"unknown model {model[:40]!r}{near(model, interface.LAWS)}")
        return "normal"
    if text.table("medium"):
        message = "a viscoelastic half space has its moduli in the table of viscoelastic; leave [medium] out"
        text.problem("medium", "", message)
    if profile is not None and scene.own:
        message = "viscoelastic is emitted for profiles of the catalogue; the nearest here is normal = true"
        text.problem("physics", "viscoelastic", message)
    return f"viscoelastic.{model}"
