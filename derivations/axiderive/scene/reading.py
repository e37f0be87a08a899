"""A scene: profile, medium, physics, functions, frozen values and formats, checked as a whole; what is composed."""

from __future__ import annotations

import keyword
import re
import sys
import unicodedata
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from .. import notation as nt
from ..expression import ExpressionError, own_profile
from ..expression.profile import OwnProfile
from ..languages.standalone import LANGUAGES
from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.systems import SYSTEMS, on
from ..physics.viscoelastic import LAWS, Law
from ..profiles.pools import PRESSURES, ROUND, STRIPS
from ..profiles.profile import Profile
from . import interface
from .linker.library import fields_refusal, graded_refusal
from .medium import KEYS as MEDIUM
from .medium import frozen, given, kind_of, medium_values
from .text import SceneText, near

SECTIONS = ("name", "title", "profile", "parameters", "medium", "physics", "want", "output")
MEANT = {"material": "medium", "half_space": "medium", "contact": "physics", "load": "physics"}
"""Other names of sections."""

PHYSICS = {own.physics.name: own.physics for own in SYSTEMS if own.physics.wanted}
"""Kinds of contact by the keys of a scene."""
PLAIN, *CHOICES = PHYSICS
"""What is meant where none is named, and the others."""
POOLS = {"plane": ("plane profile", STRIPS), "loads": ("prescribed pressure", PRESSURES)}
"""Kinds of contact with profiles of their own, and what these are called."""


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
    choices: dict[str, str] = field(default_factory=dict)
    """Words that its functions take, which are always frozen."""
    folder: str = ""
    module: str = ""
    language: str = "python"
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
        scene.values = medium_values(text) | scene.values
        _physics(text, scene)
        _want(text, scene)
        _rules(text, scene)
    _output(text, scene)
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
    asked = _asked(text)
    what, own = POOLS.get(asked[0], ("profile", ROUND)) if len(asked) == 1 else ("profile", ROUND)
    if name not in own.names:
        reason = _elsewhere(asked, name) or f"unknown {what} {name[:40]!r}{near(name, own.names)}"
        text.problem("profile", "kind", reason)
        return
    profile = own.load(name)
    if nt.coefficients in profile.parameters:
        reason = "takes a sequence of coefficients"
        text.problem("profile", "kind", f'{name} {reason}; write it as an expression, profile = "c*r**2 + q*r**4"')
        return
    scene.profile = profile


def _asked(text: SceneText) -> list[str]:
    """The kinds of contact that a scene names."""
    table = text.values.get("physics")
    return [key for key in CHOICES if table.get(key) not in (None, False)] if isinstance(table, dict) else []


def _elsewhere(asked: Sequence[str], name: str) -> str:
    """What to do about a profile of another kind of contact; empty if no kind has it."""
    instead = f" in place of {' and '.join(asked)}" if asked else ""
    for kind, (what, pool) in POOLS.items():
        if name in pool.names and kind not in asked:
            return f"{name} is a {what}; write [physics] {kind} = true{instead}"
    if name in ROUND.names:
        others = ", ".join(POOLS[asked[0]][1].names)
        return f"{name} is a round profile; write normal = true in place of {asked[0]}, or take one out of {others}"
    return ""


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
    tables = {
        name: own for name in ("parameters", "profile", "medium") if isinstance(own := text.values.get(name), dict)
    }
    named = [(name, symbol.name) for name, own in tables.items() for symbol in symbols if symbol.name in own]
    return named[-1] if named else ("profile", "")


def _physics(text: SceneText, scene: Scene) -> None:
    """The kind of contact on its medium."""
    table, chosen = text.table("physics", PHYSICS), _asked(text)
    plain = table.get(PLAIN, True)
    if plain is not True and (plain is not False or not chosen):
        message = "normal is true or left out; write normal = true, or name another kind of contact"
        text.problem("physics", PLAIN, message)
    if len(chosen) > 1:
        count = ("two", "three", "four", "five", "six", "seven")[len(chosen) - 2]
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
    scene.choices = {key: words[0] for key, (_, words) in physics.choices.items()}
    if scene.profile is not None and len(chosen) < 2:
        reason = _refusal(kind, scene.profile, graded=graded, own=scene.own is not None)
        if reason:
            text.problem("physics" if chosen else "medium", kind if chosen else "kind", reason)
    for name in chosen:
        if model or not PHYSICS[name].laws:
            _table(text, scene, name, table[name])


def _refusal(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """Why nothing is emitted for a kind of contact; empty if something is, else a sentence that names the nearest."""
    reason = _reason(kind, profile, graded=graded, own=own)
    if not reason:
        return ""
    homogeneous = 'kind = "homogeneous"'
    forms = [(kind, False, homogeneous), (PLAIN, True, "normal = true")] if graded else []
    forms.append((PLAIN, False, f"normal = true with {homogeneous}" if graded else "normal = true"))
    nearest = (
        form for other, medium, form in forms
        if (other, medium) != (kind, graded) and not _reason(other, profile, graded=medium, own=own)
    )  # fmt: skip
    return f"{reason}; the nearest is {next(nearest, 'another profile')}"


def _reason(kind: str, profile: Profile, *, graded: bool, own: bool) -> str:
    """What stands against it."""
    system = on(PHYSICS[kind], GRADED if graded else HOMOGENEOUS)
    if own and (kind in POOLS or PHYSICS[kind].solved is not None):
        return f"{kind} is emitted for what the catalogue holds"
    if system is None:
        return f"{kind} on a graded half-space is not derived"
    if found := system.refusal(profile):
        return found.partition(": use ")[0]
    if not own:
        return ""
    return fields_refusal(profile) if PHYSICS[kind] in interface.WHOLE else graded_refusal(profile) if graded else ""


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
        message = f"{name} = {raw!r:.40} is neither true nor a table; write {name} = {{ {names[0]} = ... }}"
        text.problem("physics", name, message)
        return
    for key, value in raw.items():
        if key in names and key in text.table("medium"):
            message = f"{key} stands below [medium] already; leave it out of {name}"
            text.problem("physics", name, message)
        elif key in names:
            frozen(text, scene.values, "physics", key, value, inside=name)
        elif key in physics.choices:
            meaning, words = physics.choices[key]
            scene.choices[key] = value
            if value not in words:
                message = f"{key} = {value!r:.40} must be {' or '.join(map(repr, words))}: {meaning}"
                text.problem("physics", name, message)
        else:
            text.problem("physics", name, f"unknown key {key[:40]!r} of {name}{near(key, [*names, *physics.choices])}")


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


ENDINGS = {"python": "py", **{name: language.suffix for name, language in LANGUAGES.items()}}
"""Languages in which a module can be written, and how the names of their files end."""
FORMATS = ("tex", "pdf", "json")
"""Beside the module itself, which goes by the name of its language."""
OF_COMPLETE = ("retraction", "minimum_depth", "minimum_force", "minimum_load", "tilt", "contact_width")
SYMBOLS = {"d": "depth", "g": "depth", "F": "force", "p": "pressure", "w": "displacement", "f": "profile",
           "a": "radius_from_force", "u": "displacement", "F_N": "force", "P": "load"}  # fmt: skip
"""Letters by which a quantity may be asked for."""
HIDDEN = sys.stdlib_module_names | {"axiderive", "axicontact", "numpy"}
"""Names of modules that the written one, its test or a program beside them may import."""
FILE = r"[A-Za-z]\w{{0,60}}\.{ending}"


def _want(text: SceneText, scene: Scene) -> None:
    """Reads the section [want] into the scene: functions and worked example; problems go to the text."""
    table = text.table("want", ("quantities", "at"))
    contact = interface.contact_of(scene.profile) if scene.profile else "compact"
    known = _available(scene.kind, contact)
    if scene.kind.law and scene.profile and not interface.ramps(scene.profile):
        own = interface.functions(scene.kind, contact)
        known = [name for name in known if nt.v.name not in own[name].fields]
    physics, medium = scene.kind.physics, scene.kind.system.medium
    if scene.profile and physics.definitions and not scene.kind.system.refusal(scene.profile):
        stated = physics.definitions(scene.profile, medium)
        lacking = {own.function for suffix, own in physics.table(scene.profile).items() if suffix not in stated}
        known = [name for name in known if name not in lacking]
    default = [name for name in physics.wanted if name in known]
    # a complete contact has its own names; those that say how far it is complete come with them
    default += [name for name in OF_COMPLETE if name in known and contact != "compact"]
    default.sort(key=known.index)
    raw = table.get("quantities", default)
    if not isinstance(raw, list) or not all(isinstance(name, str) for name in raw) or not raw:
        text.problem("want", "quantities", 'quantities must be a list of names, as ["depth", "force"]')
        return
    if scene.kind == interface.NORMAL and not set(raw) <= set(known):
        known += interface.peaks(scene.profile)
    for name in raw:
        if name not in known:
            text.problem("want", "quantities", _unknown(scene, name, contact, known))
    scene.quantities = list(dict.fromkeys(name for name in raw if name in known))
    if "at" in table:
        _example(text, scene, table["at"])


def _unknown(scene: Scene, name: str, contact: str, known: Collection[str]) -> str:
    """Another kind of contact that has the function, or the nearest name."""
    compact = contact == "compact" and scene.kind.system.pool is ROUND and not scene.kind.law
    for other in interface.KINDS.values() if compact else ():
        above = other.system.base and other.graded == scene.kind.graded and not other.law
        if above and other != scene.kind and name in _available(other, contact):
            kind = other.physics.name
            return f"{name} is a function of {kind} contact; write [physics] {kind} = true"
    meant = SYMBOLS.get(name, "")
    return f"unknown quantity {name[:40]!r} of {scene.kind.name}{near(meant if meant in known else name, known)}"


def _example(text: SceneText, scene: Scene, raw: object) -> None:
    """The place of the worked example: one radius, depth or force of a contact whose values are all frozen."""
    form = 'at = { F = "50 mN" }, or a depth d, or a contact radius a'
    if not isinstance(raw, dict) or len(raw) != 1 or not set(raw) <= {"a", "d", "F"}:
        text.problem("want", "at", f"at names one field of the contact; write {form}")
        return
    ((key, at),) = raw.items()
    value = given(text, "want", "at", at, kind_of(nt.describe(key)), key)
    if value is None:
        return
    if not value > 0.0 and (key == "a" or not scene.kind.physics.tension):
        text.problem("want", "at", f"{key} = {value:g} is outside {key} > 0; change the value")
        return
    profile = scene.profile
    if profile is None:  # which is a problem of its own
        return
    if scene.kind.graded or scene.kind.law or scene.kind.system.pool is not ROUND or not profile.compact:
        message = "a worked example is given for a compact contact on a homogeneous half-space; leave at out"
        text.problem("want", "at", message)
        return
    physics = scene.kind.physics
    if physics.over and nt.d.name in physics.table(profile) and not physics.tension:
        message = f"a worked example is not given for contact {physics.contact}; leave at out"
        text.problem("want", "at", message)
        return
    free = scene.free
    if free and not text.problems:
        text.problem("want", "at", f"a worked example needs values of all parameters; freeze {', '.join(free)} too")
        return
    scene.at = (key, value)


def _available(kind: interface.Kind, contact: str) -> list[str]:
    """Names of the functions of a kind of contact; those of the normal contact come with tangential ones."""
    own = [name for one in (kind, kind.below) if one for name in interface.functions(one, contact)]
    return [*own, interface.PULL_OFF] if kind.physics.tension or kind.physics.searched else own


def _output(text: SceneText, scene: Scene) -> None:
    """Reads the section [output] into the scene: folder, module, language and formats; problems go to the text."""
    table = text.table("output", ("folder", "module", "language", "formats"))
    language = table.get("language", "python")
    if not isinstance(language, str) or language not in ENDINGS:
        known = f"language must be one of {', '.join(ENDINGS)}, not {language!r:.40}"
        text.problem("output", "language", known)
        language = "python"
    scene.language, ending = language, ENDINGS[language]
    stem = _stem(scene.name)
    scene.module = table.get("module", f"{stem[:60]}.{ending}")
    own = str(scene.module).removesuffix(f".{ending}")
    place = ("output", "module") if "module" in table else ("name", "")
    if not isinstance(scene.module, str) or not re.fullmatch(FILE.format(ending=ending), scene.module):
        message = f"module must be the name of a file, as 'needle.{ending}', not {table['module']!r:.60}"
        text.problem("output", "module", message)
    elif language == "python" and keyword.iskeyword(own):
        message = f"module {scene.module!r} cannot be imported, {own} is a word of Python; choose another name"
        text.problem(*place, message)
    elif language == "python" and own.lower() in HIDDEN:
        # in lower case: on some file systems Numpy.py is numpy.py
        text.problem(*place, f"module {scene.module!r} would hide the {own.lower()} of others; choose another name")
    scene.folder = table.get("folder", stem[:60])
    if not isinstance(scene.folder, str) or not scene.folder.strip() or "\0" in scene.folder or len(scene.folder) > 200:
        text.problem("output", "folder", "folder must be the name of a folder, as 'needle'")
    elif scene.folder.startswith(("/", "~")) or ".." in scene.folder.split("/") or "\\" in scene.folder:
        message = f"folder {scene.folder[:60]!r} leaves the place of the scene; use a name below it, or --out DIR"
        text.problem("output", "folder", message)
    formats = (language, *FORMATS)
    scene.formats = table.get("formats", list(formats))
    if not isinstance(scene.formats, list) or not scene.formats:
        text.problem("output", "formats", f'formats must be a list out of {", ".join(formats)}, as ["{language}"]')
        return
    for name in scene.formats:
        if name not in formats:
            text.problem("output", "formats", f"unknown format {str(name)[:40]!r}{near(str(name).lower(), formats)}")


def _stem(name: str) -> str:
    """The name of a scene as that of a module: letters lose their accents, a name without any is `scene`."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    stem = re.sub(r"\W+", "_", plain).strip("_") or "scene"
    return stem if stem[0].isalpha() else f"scene_{stem}"
