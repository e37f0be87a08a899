"""A scene: profile, medium, physics, functions, frozen values and formats, checked as a whole; what is composed."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field

import sympy as sp

from .. import notation as nt
from ..expression import ExpressionError, own_profile
from ..expression.profile import OwnProfile
from ..profiles.profile import Profile
from . import interface, wishes
from .kinds import PHYSICS, elsewhere, physics, pool
from .medium import KEYS as MEDIUM
from .medium import frozen, medium_values
from .text import SceneText, near

SECTIONS = ("name", "title", "profile", "parameters", "medium", "physics", "want", "output")


MEANT = {"material": "medium", "half_space": "medium", "contact": "physics", "load": "physics"}
"""Other names of sections."""


@dataclass
class Scene:
    """What is asked for; `values` are the frozen parameters in SI units."""

    name: str
    title: str
    text: str = ""
    """Copied into the folder; empty for an expression alone."""
    profile: Profile | None = None
    own: OwnProfile | None = None
    kind: interface.Kind = interface.NORMAL
    quantities: list[str] = field(default_factory=list)
    values: dict[str, float] = field(default_factory=dict)
    folder: str = ""
    module: str = ""
    formats: Sequence[str] = ("python", "json")
    at: tuple[str, float] | None = None
    """Name and value of what the worked example is given at: a, d or F."""

    @property
    def subject(self) -> Profile:
        """The profile, which a scene that was read without a problem has."""
        profile = self.profile or (self.own.profile if self.own else None)
        assert profile is not None
        return profile

    @property
    def keywords(self) -> list[str]:
        """Names of all parameters of its functions, in order: those of the profile, then the material."""
        return [*interface.parameters(self.subject), *self.kind.material]

    @property
    def frozen(self) -> dict[str, float]:
        """Those that have a value."""
        return {name: self.values[name] for name in self.keywords if name in self.values}

    @property
    def free(self) -> list[str]:
        """Those that have none."""
        return [name for name in self.keywords if name not in self.values]

    @property
    def notation(self) -> tuple[nt.Notation, ...]:
        """The notation of the parameters of an expression; empty for a profile of the catalogue."""
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
            below = kind == "key" and bool(_home(key))
            hint = f"; write it below [{_home(key)}]" if below else near(MEANT.get(key, key), SECTIONS)
            text.problem(key, "", f"unknown {kind} {key[:40]!r}{hint}")
    scene = Scene(_string(text, "name", "scene"), _string(text, "title", ""), text.text)
    _profile(text, scene)
    with nt.extended(scene.notation):
        _parameters(text, scene)
        scene.values |= medium_values(text)
        physics(text, scene)
        wishes.want(text, scene)
        _rules(text, scene)
    wishes.output(text, scene)
    scene.title = scene.title or (scene.profile.title if scene.profile else "")
    text.finish()
    return scene


def _home(key: str) -> str:
    """The section a key belongs to, empty where there is none."""
    homes = ((("kind", "expression"), "profile"), (MEDIUM, "medium"), (PHYSICS, "physics"),
             (("quantities", "at"), "want"), (("folder", "module", "formats"), "output"))  # fmt: skip
    found = next((home for keys, home in homes if key in keys), "")
    return found or ("parameters" if nt.known(key) else "")


def _string(text: SceneText, key: str, default: str) -> str:
    value = text.values.get(key, default)
    if not isinstance(value, str) or len(value) > 120:
        text.problem(key, "", f"{key} must be a text of at most 120 characters, not {value!r:.40}")
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
    if given is None and "profile" in map(str.lower, text.values):
        return  # written large, which is a problem already
    if given is None:
        text.problem("", "", f"the scene names no profile; {example}")
        return
    if not isinstance(given, str):
        text.problem("profile", "kind", f"the profile must be a text, not {type(given).__name__}; {example}")
        return
    if re.fullmatch(r"[A-Za-z_]\w*", given.strip(), re.ASCII) and given.strip() != "r":
        _catalogue(text, scene, given.strip())
        return
    try:
        scene.own = own_profile(given)
        scene.profile = scene.own.profile
    except ExpressionError as error:
        text.problem("profile", "expression", str(error))


def _catalogue(text: SceneText, scene: Scene, name: str) -> None:
    what, own = pool(text)
    if name not in own.names:
        reason = elsewhere(text, name) or f"unknown {what} {name[:40]!r}{near(name, own.names)}"
        text.problem("profile", "kind", reason)
        return
    profile = own.load(name)
    if nt.coefficients in profile.parameters:
        reason = "takes a sequence of coefficients"
        text.problem("profile", "kind", f'{name} {reason}; write it as an expression, profile = "c*r**2 + q*r**4"')
        return
    scene.profile = profile


def _parameters(text: SceneText, scene: Scene) -> None:
    if scene.profile is None:
        return
    names = list(interface.parameters(scene.profile))
    tables = [("parameters", text.table("parameters"))]
    if isinstance(text.values.get("profile"), dict):
        own = {k: v for k, v in text.values["profile"].items() if k not in ("kind", "expression")}
        tables.append(("profile", own))
    for section, table in tables:
        for key, raw in table.items():
            if key not in names:
                what = "parameter of the expression" if scene.own else f"parameter of {scene.profile.name}"
                text.problem(section, key, f"unknown {what} {key[:40]!r}{near(key, names) if names else ''}")
            else:
                frozen(text, scene.values, section, key, raw, scene.profile)


def _rules(text: SceneText, scene: Scene) -> None:
    """The rules between frozen parameters."""
    profile = scene.profile
    if profile is None:
        return
    symbols = {**interface.parameters(profile), "k": nt.k}
    known = {symbol: sp.Float(scene.values[n], 17) for n, symbol in symbols.items() if n in scene.values}
    if interface.depend_on_waves(profile, scene.kind):
        _waves(text, scene, profile)
        return
    found = interface.between(profile, scene.kind)
    found += interface.of_pull_off(profile, scene.kind) if interface.NEEDS_PULL_OFF & set(scene.quantities) else []
    for rule in found:
        if rule.relation().xreplace(known) == sp.false:
            shown = sorted(rule.left.free_symbols | rule.right.free_symbols, key=str)
            given = ", ".join(f"{s.name} = {float(known[s]):g}" for s in shown)
            relation = sp.sstr(rule.relation()).replace("Abs(", "abs(")
            what = f"{given}: {relation} is violated; {rule.reason}"
            text.problem(*_place(text, shown), what)


def _waves(text: SceneText, scene: Scene, profile: Profile) -> None:
    """On the graded half-space the rule of the waves is another one for every k: it is asked of g' itself."""
    names = [*interface.parameters(profile), "k"]
    if not set(names) <= set(scene.values):
        return
    place = interface.open_between_waves(profile, scene.values)
    if place is not None:
        given = ", ".join(f"{name} = {scene.values[name]:g}" for name in names)
        (rule,) = profile.rules
        text.problem(*_place(text, [nt.h]), f"{given}: g' < 0 at a = {place:.3g} m; {rule.reason}")


def _place(text: SceneText, symbols: Sequence[sp.Symbol]) -> tuple[str, str]:
    """Section and key of the last of these parameters that the text names."""
    sections = ("parameters", "profile", "medium")
    named = [(s, symbol.name) for s in sections for symbol in symbols if symbol.name in _keys(text, s)]
    return named[-1] if named else ("profile", "")


def _keys(text: SceneText, section: str) -> Collection[str]:
    table = text.values.get(section)
    return table if isinstance(table, dict) else ()
