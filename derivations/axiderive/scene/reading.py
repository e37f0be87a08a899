"""A scene: which profile, medium, physics, functions, frozen values and formats; checked as a whole."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from .. import notation as nt
from .. import profiles
from ..expression import ExpressionError, own_profile
from ..expression.profile import OwnProfile
from ..profiles.profile import Profile
from . import interface, wishes
from .medium import medium_values
from .sources import graded_refusal
from .text import SceneText, near
from .units import UnitError, kind_of, value_of

SECTIONS = ("name", "title", "profile", "parameters", "medium", "physics", "want", "output")
PHYSICS = ("normal", "adhesive", "tangential")
LATER = ("viscoelastic", "plane", "loads")


@dataclass
class Scene:
    """What a scene asks for; `values` are the frozen parameters in SI units."""

    name: str
    title: str
    profile: Profile | None = None
    own: OwnProfile | None = None
    physics: str = "normal"
    quantities: list[str] = field(default_factory=list)
    values: dict[str, float] = field(default_factory=dict)
    folder: str = ""
    module: str = ""
    formats: list[str] = field(default_factory=list)
    at: tuple[str, float] | None = None
    """What the worked example is given at: a, d or F."""

    @property
    def notation(self) -> tuple[nt.Notation, ...]:
        return self.own.notation if self.own else ()


def read(text: SceneText) -> Scene:
    """The scene of a text.

    Raises
    ------
    SceneError
        With all problems at once.
    """
    for key in text.values:
        if key not in SECTIONS:
            kind = "section" if isinstance(text.values[key], dict) else "key"
            text.problem(key, "", f"unknown {kind} {key[:40]!r}{near(key, SECTIONS)}")
    scene = Scene(_string(text, "name", "scene"), _string(text, "title", ""))
    _profile(text, scene)
    with nt.extended(scene.notation):
        _parameters(text, scene)
        scene.values |= medium_values(text)
        _physics(text, scene)
        wishes.want(text, scene)
        _rules(text, scene)
    wishes.output(text, scene)
    scene.title = scene.title or (scene.profile.title if scene.profile else "")
    text.finish()
    return scene


def _string(text: SceneText, key: str, default: str) -> str:
    value = text.values.get(key, default)
    if not isinstance(value, str) or len(value) > 120:
        text.problem(key, "", f"{key} must be a text of at most 120 characters")
        return default
    return value


def _profile(text: SceneText, scene: Scene) -> None:
    given = text.values.get("profile")
    example = 'write profile = "cone", or profile = "r**2/(2*R)"'
    if isinstance(given, dict):
        kinds = [key for key in ("kind", "expression") if key in given]
        if len(kinds) != 1:
            text.problem("profile", "", f"[profile] needs either kind or expression; {example}")
            return
        given = given[kinds[0]]
    if given is None:
        text.problem("", "", f"the scene names no profile; {example}")
        return
    if not isinstance(given, str):
        text.problem("profile", "kind", f"the profile must be a text, not {type(given).__name__}; {example}")
        return
    if re.fullmatch(r"[A-Za-z_]\w*", given.strip()) and given.strip() != "r":
        _catalogue(text, scene, given.strip())
        return
    try:
        scene.own = own_profile(given)
        scene.profile = scene.own.profile
    except ExpressionError as error:
        text.problem("profile", "expression", str(error))


def _catalogue(text: SceneText, scene: Scene, name: str) -> None:
    if name not in profiles.NAMES:
        text.problem("profile", "kind", f"unknown profile {name[:40]!r}{near(name, profiles.NAMES)}")
        return
    profile = profiles.load(name)
    if nt.coefficients in profile.parameters:
        reason = "takes a sequence of coefficients"
        text.problem("profile", "kind", f'{name} {reason}; write it as an expression, profile = "c*r**2 + q*r**4"')
        return
    scene.profile = profile


def _parameters(text: SceneText, scene: Scene) -> None:
    if scene.profile is None:
        return
    names = [parameter.name for parameter in scene.profile.parameters]
    tables = [("parameters", text.table("parameters"))]
    if isinstance(text.values.get("profile"), dict):
        own = {k: v for k, v in text.values["profile"].items() if k not in ("kind", "expression")}
        tables.append(("profile", own))
    for section, table in tables:
        for key, raw in table.items():
            if key not in names:
                what = f"parameter of {scene.profile.name}"
                text.problem(section, key, f"unknown {what} {key[:40]!r}{near(key, names) if names else ''}")
            else:
                frozen(text, scene.values, section, key, raw)


def frozen(text: SceneText, values: dict[str, float], section: str, key: str, raw: Any) -> None:
    """Read, check and keep one value; `key` names a symbol of the notation."""
    record = nt.describe(key)
    try:
        value = value_of(raw, kind_of(record))
    except UnitError as error:
        text.problem(section, key, f"{key} {error}" if str(error).startswith("must") else f"{key}: {error}")
        return
    low, high = _bounds(record)
    if not low < value < high:
        hint = f'; degrees need a unit: {key} = "{value:g} deg"' if record.unit == "rad" and high < value < 90 else ""
        text.problem(section, key, f"{key} = {value:g} is outside {record.domain}{hint or '; change the value'}")
        return
    values[key] = value


def _bounds(record: nt.Notation) -> tuple[float, float]:
    if record.unit == "rad":
        return 0.0, math.pi / 2
    return (-1.0, 1.0) if record.name == "k" else (0.0, math.inf)


def _physics(text: SceneText, scene: Scene) -> None:
    table = text.table("physics", (*PHYSICS, *LATER))
    asked = [name for name in (*PHYSICS, *LATER) if table.get(name) not in (None, False)]
    for name in asked:
        if name in LATER:
            nearest = 'adhesive = { dgamma = "50 mJ/m^2" } or normal = true'
            text.problem("physics", name, f"{name} is not emitted for scenes yet; the nearest is {nearest}")
    chosen = [name for name in asked if name in ("adhesive", "tangential")]
    if len(chosen) == 2:
        message = "adhesive and tangential together are not derived; emit two scenes, one with each"
        text.problem("physics", "tangential", message)
    medium = text.values.get("medium")
    graded = isinstance(medium, dict) and medium.get("kind") == "power_law"
    if graded and chosen:
        message = f"{chosen[0]} on a graded half space cannot be emitted for a scene yet; the nearest is normal = true"
        text.problem("physics", chosen[0], message)
    scene.physics = "graded" if graded else chosen[0] if chosen else "normal"
    profile = scene.profile
    if graded and profile is not None and profile.contact != "compact":
        what = f"{profile.name}, a complete contact, on a graded half space"
        text.problem("medium", "kind", f'{what} cannot be emitted; the nearest is kind = "homogeneous"')
    elif graded and profile is not None and scene.own and (reason := graded_refusal(profile)):
        text.problem("medium", "kind", f'{reason}; or kind = "homogeneous"')
    if profile is not None and profile.contact != "compact" and chosen:
        message = f"{chosen[0]} is not at hand for {profile.name}, a complete contact; the nearest is normal = true"
        text.problem("physics", chosen[0], message)
    for name in chosen:
        raw = table[name]
        names = [n for n in interface.MATERIAL[name] if n != "E_star"]
        if raw is True:
            continue
        if not isinstance(raw, dict):
            text.problem("physics", name, f"{name} must be true or a table such as {{ {names[0]} = ... }}")
            continue
        for key, value in raw.items():
            if key in names:
                _inline(text, scene, name, key, value)
            else:
                text.problem("physics", name, f"unknown key {key[:40]!r} of {name}{near(key, names)}")


def _inline(text: SceneText, scene: Scene, name: str, key: str, value: Any) -> None:
    """A value of an inline table: its line is that of the table."""
    before = len(text.problems)
    frozen(text, scene.values, "physics", key, value)
    line = text.line_of("physics", name)
    for i in range(before, len(text.problems)):
        message = text.problems[i][1].split(": ", 1)[1].split("\n  ")[0]
        text.problems[i] = (line, text.at(line, message))


def _rules(text: SceneText, scene: Scene) -> None:
    if scene.profile is None:
        return
    known = {sp.Symbol(name, positive=True): sp.Float(value, 17) for name, value in scene.values.items()}
    for rule in scene.profile.rules:
        relation = rule.relation().xreplace(known)
        if relation == sp.false:
            key = next((s.name for s in sorted(rule.right.free_symbols, key=str)), "")
            given = ", ".join(f"{s.name} = {scene.values[s.name]:g}" for s in sorted(
                rule.left.free_symbols | rule.right.free_symbols, key=str))  # fmt: skip
            section = "profile" if isinstance(text.values.get("profile"), dict) else "parameters"
            text.problem(section, key, f"{given}: {sp.sstr(rule.relation())} is violated; {rule.reason}")
