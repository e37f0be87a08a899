"""Functions written for a scene above private ones of the catalogue: numbers, pull-off, rules between parameters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ... import notation as nt
from ...code.text import python
from ...profiles.profile import Profile, Rule
from .. import interface
from .library import Module, definition
from .linking import OWN

NUMBER = """from .{module} import {private}

def {name}({parameters}):
    return {value}
"""
PULL_OFF = """from ._runtime.physics.adhesion import XI, PullOff
from .{module} import {radius}, {force}, {depth}

def pull_off({parameters}):
    if control not in XI:
        raise ValueError(f"control = {{control!r}} must be 'force' or 'depth'")
"""
IN_ARRAYS = """    a = np.ravel({radius_call})
    force = {force_call}
    depth = {depth_call}
    return PullOff(*(float(np.squeeze(x)) for x in (a, force, depth)))
"""
AT_NUMBERS = """    a = {radius_call}
    force = {force_call}
    depth = {depth_call}
    return PullOff(float(a), float(force), float(depth))
"""
"""The end of the same where the formulas take numbers as well as arrays."""
PEELING = """from ._runtime.physics.adhesion import PullOff
from .{module} import {force}, {depth}

def pull_off({parameters}):
    if control not in ("force", "depth"):
        raise ValueError(f"control = {{control!r}} must be 'force' or 'depth'")
    return PullOff(a, {force_value}, {depth_value})
"""
LEANING = """from .{module} import {private}

def {name}(x, P, a, e):
    # from the other side of the middle the load is seen at -e
    value = {private}(np.abs(x), P, a, np.copysign(1.0, x) * e)
    return np.where(P >= 0.0, value, np.nan)
"""
ORDER = """def _require_order({names}):
    if not {relation}:
        given = f"{given}"
        reason = "{reason}"
        raise ValueError(f"{{given}}: {shown} is violated; {{reason}}")
"""
WAVES = "from ._runtime.graded.waves import steepest_waves\n\n"
PLAIN = frozenset(["_runtime.physics.adhesion", "_runtime.interface"])
"""Modules of the runtime that have nothing but formulas for the state of pull-off."""
REQUIRE_ORDER = "_require_order"
SILENT = ('@np.errstate(all="ignore")',)


@dataclass(frozen=True)
class Assembled:
    """One function: its text above private ones, and how it is shown."""

    name: str
    text: str
    doc: str
    keywords: tuple[str, ...]
    leading: str = ""
    """Arguments in front of the keywords."""
    decorators: tuple[str, ...] = ()

    @property
    def key(self) -> str:
        """Its place in the module of the scene."""
        return f"{OWN}:{self.name}"


def module(texts: Iterable[str]) -> Module:
    """The module of these functions, to be linked like those they rest on."""
    imports, bodies = [], []
    for text in texts:
        lines = text.splitlines()
        imports += [line for line in lines if line.startswith("from ")]
        bodies += ["\n".join(line for line in lines if not line.startswith("from ")).strip("\n")]
    return Module(OWN, "\n".join(dict.fromkeys(imports)) + "\n\n\n" + "\n\n\n".join(bodies) + "\n")


def _float(value: str, *, array: bool) -> str:
    return f"float(np.squeeze({value}))" if array else f"float({value})"


def _call(modules: Mapping[str, Module], key: str) -> str:
    own = definition(modules, key)
    return f"{own.name}({', '.join(own.parameters)})"


def number(
    modules: Mapping[str, Module], key: str, name: str, doc: str, keywords: tuple[str, ...], *, array: bool
) -> Assembled:
    """A result without fields; `array` where its rules give an array of one."""
    own = definition(modules, key)
    text = NUMBER.format(
        module=own.module.name, private=own.name, name=name, parameters=", ".join(own.parameters),
        value=_float(_call(modules, key), array=array),
    )  # fmt: skip
    return Assembled(name, text, doc, keywords, decorators=SILENT if array else ())


def pull_off(
    modules: Mapping[str, Module],
    key: str,
    doc: str,
    parameters: Sequence[str],
    keywords: tuple[str, ...],
    *,
    array: bool,
) -> Assembled:
    """The state at which the contact breaks, which has no fields and three results."""
    defined = modules[key].definitions
    force, depth = (
        f"_pull_off_{name}" if f"_pull_off_{name}" in defined else f"_{name}" for name in ("force", "depth")
    )
    radius = "_pull_off_radius"
    plain = {source.partition(":")[0] for source in modules[key].imported.values()} <= PLAIN
    form = PULL_OFF + (AT_NUMBERS if plain else IN_ARRAYS) if radius in defined else PEELING
    text = form.format(
        module=key, radius=radius, force=force, depth=depth, parameters=", ".join(["control", *parameters]),
        radius_call=_call(modules, f"{key}:{radius}") if radius in defined else "",
        force_call=_call(modules, f"{key}:{force}"), depth_call=_call(modules, f"{key}:{depth}"),
        force_value=_float(_call(modules, f"{key}:{force}"), array=array),
        depth_value=_float(_call(modules, f"{key}:{depth}"), array=array),
    )  # fmt: skip
    decorators = SILENT if radius in defined or array else ()
    return Assembled(interface.PULL_OFF, text, doc, keywords, 'control="force"', decorators)


def leaning(key: str, name: str) -> str:
    """A field under a load on either side of the middle."""
    module, _, private = key.partition(":")
    return LEANING.format(module=module, private=private, name=name)


def order(
    profile: Profile, rules: Sequence[Rule], kind: interface.Kind, frozen: Iterable[str]
) -> tuple[str, tuple[str, ...]]:
    """The check of the rules between parameters of which some are free, and its arguments; nothing if none is."""
    left = {name: symbol for name, symbol in interface.parameters(profile).items() if name not in set(frozen)}
    found = []
    for rule in rules:
        symbols = rule.left.free_symbols | rule.right.free_symbols
        waves = kind.graded and nt.wavelength in symbols
        names = [name for name, symbol in interface.parameters(profile).items() if symbol in symbols]
        names += ["k"] if kind.graded and (waves or nt.k in symbols) else []
        if not ({*names} & ({*left} | ({"k"} - {*frozen}))):
            continue
        relation = f"{python(rule.left)} {'<' if rule.strict else '<='} {python(rule.right)}"
        relation = "steepest_waves(k) * R * h <= wavelength**2" if waves else relation
        given = ", ".join(f"{name} = {{{name}!r}}" for name in names)
        text = ORDER.format(
            names=", ".join(names), relation=relation, given=given,
            shown=relation.replace("np.", "").replace("{", "").replace("}", ""), reason=rule.reason,
        )  # fmt: skip
        found.append(((WAVES if waves else "") + text, tuple(names)))
    # profiles have one rule at most between their parameters
    return found[0] if found else ("", ())
