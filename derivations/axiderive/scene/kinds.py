"""The kinds of contact a scene can ask for.

The kind of contact a scene asks for, and the combinations that are at hand.

Which kinds of contact are at hand on which medium for which profile, and the nearest one where one is not.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .. import profiles
from ..physics import detachment, tangential
from ..physics.medium import GRADED, HOMOGENEOUS
from ..profiles import loads as prescribed
from ..profiles import plane as strips
from ..profiles.profile import Profile
from . import interface
from .linker.sources import graded_refusal
from .medium import inline
from .text import SceneText, near

if TYPE_CHECKING:
    from .reading import Scene


ALONE = ("plane", "loads")
"""Kinds of contact with profiles of their own."""


def refusal(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """Why nothing is emitted for a kind of contact; empty if something is, else a sentence that names the nearest."""
    reason = _reason(kind, profile, graded=graded, own=own)
    if not reason:
        return ""
    elsewhere = 'normal = true with kind = "homogeneous"' if graded else "normal = true"
    forms = {("normal", False): elsewhere, ("normal", True): "normal = true"}
    forms = {(kind, False): 'kind = "homogeneous"', **({} if kind == "normal" else dict(reversed(forms.items())))}
    nearest = next(
        (form for (other, medium), form in forms.items()
         if (graded or not medium) and (other, medium) != (kind, graded)
         and not _reason(other, profile, graded=medium, own=own)), "another profile",
    )  # fmt: skip
    return f"{reason}; the nearest is {nearest}"


def _reason(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """What stands against it."""
    if kind in ALONE:
        if own:
            return f"{kind} is emitted for what the catalogue holds"
        return f"{kind} on a graded half-space is not derived" if graded else ""
    if kind == "viscoelastic":
        return "viscoelastic on a graded half-space is not derived" if graded else ""
    if kind == "adhesive" and (found := detachment.refusal(profile, GRADED if graded else HOMOGENEOUS)):
        return found.partition(": use")[0]
    if kind == "tangential" and (found := tangential.refusal(profile)):
        return found
    return graded_refusal(profile) if graded and own else ""


PHYSICS = ("normal", "adhesive", "tangential", "viscoelastic", "plane", "loads")
Pool = tuple[str, tuple[str, ...], Callable[[str], Profile]]
"""What its members are called, their names, and how they are loaded."""
POOLS: dict[str, Pool] = {
    "plane": ("plane profile", strips.NAMES, strips.load),
    "loads": ("prescribed pressure", tuple(load.name for load in prescribed.LOADS), prescribed.load),
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


def elsewhere(text: SceneText, name: str) -> str:
    """What to do about a profile of another kind of contact; empty if no kind has it."""
    asked = [key for key, value in text.table("physics").items() if value not in (None, False) and key in PHYSICS[1:]]
    instead = f" in place of {' and '.join(asked)}" if asked else ""
    for kind, (what, names, _) in POOLS.items():
        if name in names and kind not in asked:
            return f"{name} is a {what}; write [physics] {kind} = true{instead}"
    if name in profiles.NAMES:
        kind = next(kind for kind in POOLS if alone(text, kind))
        others = ", ".join(POOLS[kind][1])
        return f"{name} is a round profile; write normal = true in place of {kind}, or take one out of {others}"
    return ""


def physics(text: SceneText, scene: Scene) -> None:
    """The kind of contact on its medium."""
    table = text.table("physics", PHYSICS)
    chosen = [name for name in PHYSICS[1:] if table.get(name) not in (None, False)]
    plain = table.get("normal", True)
    if plain is not True and (plain is not False or not chosen):
        text.problem(
            "physics", "normal", "normal is true or left out; write normal = true, or name another kind of contact"
        )
    if len(chosen) > 1:
        count = {2: "two", 3: "three", 4: "four", 5: "five"}[len(chosen)]
        message = f"{' and '.join(chosen)} together are not derived; emit {count} scenes, one with each"
        text.problem("physics", chosen[-1], message)
    medium = text.values.get("medium")
    graded = isinstance(medium, dict) and medium.get("kind") == "power_law"
    kind = chosen[0] if chosen else "normal"
    if kind == "viscoelastic":
        model = _model(text, table[kind])
        scene.physics = f"{kind}.{model or next(iter(interface.LAWS))}"
        moduli = [key for key in text.table("medium") if key != "kind"]
        if model and not graded and moduli:
            message = "a viscoelastic half-space has its moduli in the table of viscoelastic; leave [medium] out"
            text.problem("medium", moduli[0], message)
    else:
        model = ""
        scene.physics = ".".join(["graded", *chosen[:1]]) if graded and kind not in POOLS else kind
    if scene.profile is not None and len(chosen) < 2:
        reason = refusal(kind, scene.profile, graded=graded, own=scene.own is not None)
        if reason:
            text.problem("physics" if chosen else "medium", kind if chosen else "kind", reason)
    for name in chosen:
        if name != "viscoelastic" or model:
            _table(text, scene, name, table[name])


def _table(text: SceneText, scene: Scene, name: str, raw: Any) -> None:
    """The values of one kind of contact."""
    if name == "viscoelastic":
        raw = {key: value for key, value in raw.items() if key != "model"}
    own = interface.kind_of(scene.physics) == name
    names = [n for n in interface.MATERIAL[scene.physics if own else name] if n not in ("E_star", "H", "k")]
    if raw is True:
        return
    if name in POOLS:
        text.problem("physics", name, f"{name} takes no values of its own; write {name} = true")
        return
    if not isinstance(raw, dict):
        text.problem(
            "physics", name, f"{name} = {raw!r:.40} is neither true nor a table; write {name} = {{ {names[0]} = ... }}"
        )
        return
    for key, value in raw.items():
        if key in names:
            inline(text, scene.values, name, key, value)
        else:
            text.problem("physics", name, f"unknown key {key[:40]!r} of {name}{near(key, names)}")


def _model(text: SceneText, raw: Any) -> str:
    """The material law; empty where it is missing or wrong."""
    form = 'write viscoelastic = { model = "standard_solid", E_inf = "1 MPa", E_1 = "2 MPa", tau = "3 s" }'
    model = raw.get("model") if isinstance(raw, dict) else None
    if not isinstance(model, str):
        laws = ", ".join(interface.LAWS)
        text.problem("physics", "viscoelastic", f"viscoelastic needs a model out of {laws}; {form}")
        return ""
    if model not in interface.LAWS:
        text.problem("physics", "viscoelastic", f"unknown model {model[:40]!r}{near(model, interface.LAWS)}")
        return ""
    return model
