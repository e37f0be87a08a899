"""What a scene wants and where it goes: functions, the worked example, folder, module and formats."""

from __future__ import annotations

import keyword
import re
import sys
import unicodedata
from collections.abc import Collection
from typing import TYPE_CHECKING

from .. import notation as nt
from ..profiles.pools import ROUND
from . import interface
from .medium import given, kind_of
from .text import SceneText, near

if TYPE_CHECKING:
    from .reading import Scene

FORMATS = ("python", "tex", "pdf", "json")
OF_COMPLETE = ("retraction", "minimum_depth", "minimum_force", "minimum_load", "tilt", "contact_width")
SYMBOLS = {"d": "depth", "g": "depth", "F": "force", "p": "pressure", "w": "displacement", "f": "profile",
           "a": "radius_from_force", "u": "displacement", "F_N": "force", "P": "load"}  # fmt: skip
"""Letters by which a quantity may be asked for."""
HIDDEN = sys.stdlib_module_names | {"axiderive", "axicontact", "numpy"}
"""Names of modules that the written one, its test or a program beside them may import."""
FILE = re.compile(r"[A-Za-z]\w{0,60}\.py")


def want(text: SceneText, scene: Scene) -> None:
    """Reads the section [want] into the scene: functions and worked example; problems go to the text."""
    table = text.table("want", ("quantities", "at"))
    contact = interface.contact_of(scene.profile) if scene.profile else "compact"
    known = available(scene.kind, contact)
    if scene.kind.law and not (scene.profile and interface.ramps(scene.profile)):
        known.remove("ramp_force")
    default = [name for name in scene.kind.physics.wanted if name in known]
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
        if above and name in available(other, contact):
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
    value = given(text, "want", "at", at, kind_of(nt.describe(key)), name=key)
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
    free = scene.free
    if free and not text.problems:
        text.problem("want", "at", f"a worked example needs values of all parameters; freeze {', '.join(free)} too")
        return
    scene.at = (key, value)


def available(kind: interface.Kind, contact: str) -> list[str]:
    """Names of the functions of a kind of contact; those of the normal contact come with tangential ones."""
    own = [name for one in (kind, kind.below) if one for name in interface.functions(one, contact)]
    return [*own, interface.PULL_OFF] if kind.physics.tension else own


def output(text: SceneText, scene: Scene) -> None:
    """Reads the section [output] into the scene: folder, module and formats; problems go to the text."""
    table = text.table("output", ("folder", "module", "formats"))
    stem = _stem(scene.name)
    scene.module = table.get("module", f"{stem[:60]}.py")
    own = str(scene.module).removesuffix(".py")
    place = ("output", "module") if "module" in table else ("name", "")
    if not isinstance(scene.module, str) or not FILE.fullmatch(scene.module):
        text.problem(
            "output", "module", f"module must be the name of a file, as 'needle.py', not {table['module']!r:.60}"
        )
    elif keyword.iskeyword(own):
        text.problem(
            *place, f"module {scene.module!r} cannot be imported, {own} is a word of Python; choose another name"
        )
    elif own.lower() in HIDDEN:
        # in lower case: on some file systems Numpy.py is numpy.py
        text.problem(*place, f"module {scene.module!r} would hide the {own.lower()} of others; choose another name")
    scene.folder = table.get("folder", stem[:60])
    if not isinstance(scene.folder, str) or not scene.folder.strip() or "\0" in scene.folder or len(scene.folder) > 200:
        text.problem("output", "folder", "folder must be the name of a folder, as 'needle'")
    elif scene.folder.startswith(("/", "~")) or ".." in scene.folder.split("/") or "\\" in scene.folder:
        message = f"folder {scene.folder[:60]!r} leaves the place of the scene; use a name below it, or --out DIR"
        text.problem("output", "folder", message)
    scene.formats = table.get("formats", list(FORMATS))
    if not isinstance(scene.formats, list) or not scene.formats:
        text.problem("output", "formats", f'formats must be a list out of {", ".join(FORMATS)}, as ["python"]')
        return
    for name in scene.formats:
        if name not in FORMATS:
            text.problem("output", "formats", f"unknown format {str(name)[:40]!r}{near(str(name).lower(), FORMATS)}")


def _stem(name: str) -> str:
    """The name of a scene as that of a module: letters lose their accents, a name without any is `scene`."""
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode()
    stem = re.sub(r"\W+", "_", plain).strip("_") or "scene"
    return stem if stem[0].isalpha() else f"scene_{stem}"
