"""Which kinds of contact are at hand on which medium for which profile, and the nearest one where one is not."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.systems import SYSTEMS, on
from ..physics.viscoelastic import LAWS, Law
from ..profiles.pools import BODIES, PRESSURES, ROUND, STRIPS, Pool
from ..profiles.profile import Profile
from . import interface
from .linker.sources import graded_refusal
from .medium import inline
from .text import SceneText, near

if TYPE_CHECKING:
    from .reading import Scene


def refusal(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """Why nothing is emitted for a kind of contact; empty if something is, else a sentence that names the nearest."""
    reason = _reason(kind, profile, graded=graded, own=own)
    if not reason:
        return ""
    elsewhere = 'normal = true with kind = "homogeneous"' if graded else "normal = true"
    own_kind, forms = (kind, False), {("normal", True): "normal = true", ("normal", False): elsewhere}
    forms = {own_kind: 'kind = "homogeneous"'} | {form: text for form, text in forms.items() if form != own_kind}
    nearest = next(
        (form for (other, medium), form in forms.items()
         if (graded or not medium) and (other, medium) != (kind, graded)
         and not _reason(other, profile, graded=medium, own=own)), "another profile",
    )  # fmt: skip
    return f"{reason}; the nearest is {nearest}"


def _reason(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """What stands against it."""
    system = on(PHYSICS[kind], GRADED if graded else HOMOGENEOUS)
    if own and kind in POOLS:
        return f"{kind} is emitted for what the catalogue holds"
    if system is None:
        return f"{kind} on a graded half-space is not derived"
    if found := system.refusal(profile):
        return found.partition(": use ")[0]
    return graded_refusal(profile) if graded and own else ""


PHYSICS = {own.physics.name: own.physics for own in SYSTEMS if own.pool is not BODIES}
"""Kinds of contact by the keys of a scene."""
PLAIN, *CHOICES = PHYSICS
"""What is meant where none is named, and the others."""
POOLS = {"plane": ("plane profile", STRIPS), "loads": ("prescribed pressure", PRESSURES)}
"""Kinds of contact with profiles of their own, and what these are called."""


def alone(text: SceneText, name: str) -> bool:
    """Whether a scene names this kind of contact and no other one."""
    table = text.values.get("physics")
    asked = [key for key in CHOICES if table.get(key) not in (None, False)] if isinstance(table, dict) else []
    return asked == [name]


def pool(text: SceneText) -> tuple[str, Pool]:
    """The profiles that a scene can name, and what they are called."""
    return next((pool for name, pool in POOLS.items() if alone(text, name)), ("profile", ROUND))


def elsewhere(text: SceneText, name: str) -> str:
    """What to do about a profile of another kind of contact; empty if no kind has it."""
    asked = [key for key, value in text.table("physics").items() if value not in (None, False) and key in CHOICES]
    instead = f" in place of {' and '.join(asked)}" if asked else ""
    for kind, (what, pool) in POOLS.items():
        if name in pool.names and kind not in asked:
            return f"{name} is a {what}; write [physics] {kind} = true{instead}"
    if name in ROUND.names:
        kind = next(kind for kind in POOLS if alone(text, kind))
        others = ", ".join(POOLS[kind][1].names)
        return f"{name} is a round profile; write normal = true in place of {kind}, or take one out of {others}"
    return ""


def physics(text: SceneText, scene: Scene) -> None:
    """The kind of contact on its medium."""
    table = text.table("physics", PHYSICS)
    chosen = [name for name in CHOICES if table.get(name) not in (None, False)]
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
    kind = chosen[0] if chosen else PLAIN
    physics, model = PHYSICS[kind], None
    if physics.laws:
        model = _model(text, table[kind])
        moduli = [key for key in text.table("medium") if key != "kind"]
        if model and not graded and moduli:
            message = "a viscoelastic half-space has its moduli in the table of viscoelastic; leave [medium] out"
            text.problem("medium", moduli[0], message)
    system = (on(physics, GRADED) if graded else None) or on(physics, HOMOGENEOUS)
    assert system is not None
    scene.kind = interface.Kind(system, model or next(iter(physics.laws), None))
    if scene.profile is not None and len(chosen) < 2:
        reason = refusal(kind, scene.profile, graded=graded, own=scene.own is not None)
        if reason:
            text.problem("physics" if chosen else "medium", kind if chosen else "kind", reason)
    for name in chosen:
        if model or not PHYSICS[name].laws:
            _table(text, scene, name, table[name])


def _table(text: SceneText, scene: Scene, name: str, raw: Any) -> None:
    """The values of one kind of contact."""
    physics = PHYSICS[name]
    if physics.laws:
        raw = {key: value for key, value in raw.items() if key != "model"}
    own = scene.kind.material if scene.kind.physics is physics else interface.KINDS[name].material
    names = [n for n in own if n not in ("E_star", "H", "k")]
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


def _model(text: SceneText, raw: Any) -> Law | None:
    """The material law; None where it is missing or wrong."""
    form = 'write viscoelastic = { model = "standard_solid", E_inf = "1 MPa", E_1 = "2 MPa", tau = "3 s" }'
    model, known = raw.get("model") if isinstance(raw, dict) else None, {law.name: law for law in LAWS}
    if not isinstance(model, str):
        text.problem("physics", "viscoelastic", f"viscoelastic needs a model out of {', '.join(known)}; {form}")
        return None
    if model not in known:
        text.problem("physics", "viscoelastic", f"unknown model {model[:40]!r}{near(model, known)}")
    return known.get(model)
