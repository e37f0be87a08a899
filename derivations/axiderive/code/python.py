"""The generated package: every module as text, a pure function of the derived entries."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import PurePosixPath
from typing import TYPE_CHECKING

import sympy as sp

from ..entry import COMPACT, COMPLETE, Entry
from ..notation import coefficients, e, r
from ..physics import systems
from ..profiles.profile import Profile
from ..stable.forms import evaluation_form
from ..stable.signs import facts_of
from . import example, graded, physics, plane
from .bodies import peak
from .bodies.compact import Compact
from .bodies.complete import Complete
from .bodies.inverses import Inverses
from .bodies.regimes import split
from .imports import PLACE, ModuleText, imports, is_used, runtime_sources
from .private import Private, PrivateFunctions, parameter_name
from .programs import program_sources
from .public import PACKAGE, check, public, shown_example
from .tables import kernels_source, nodes_source, symbols_sources
from .text import python

if TYPE_CHECKING:
    import jinja2


NODE_COUNTS = (8, 16, 24, 32, 64, 128)


def module_sources(derived: Mapping[str, Mapping[str, Entry]], kernels: str | None = None) -> dict[str, str]:
    """What all packages share and `axicontact.normal`, as `{path: text}` for entries by profile name and suffix.

    `kernels` is the text of `kernels.py` where it is known; to fit them takes six seconds.
    """
    names = sorted(derived)
    files = {f"{PACKAGE}/{path}": text for path, text in runtime_sources().items()}
    files[f"{PACKAGE}/py.typed"] = ""
    files[f"{PACKAGE}/{PLACE}/nodes.py"] = nodes_source(NODE_COUNTS)
    files[f"{PACKAGE}/{PLACE}/kernels.py"] = kernels_source() if kernels is None else kernels
    files[f"{PACKAGE}/normal/__init__.py"] = _environment().get_template("physics.py.j2").render(names=names)
    for name in names:
        files[f"{PACKAGE}/normal/{name}.py"] = module_source(derived[name])
    return files


def package_source(names: Sequence[str]) -> str:
    """The text of `axicontact/__init__.py` for its packages and modules."""
    return _environment().get_template("package.py.j2").render(names=names)


def module_source(entries: Mapping[str, Entry]) -> str:
    """The module of one profile."""
    return _environment().get_template("module.py.j2").render(module=_module(entries))


def _module(entries: Mapping[str, Entry]) -> ModuleText:
    profile = next(iter(entries.values())).profile
    functions = _private_functions(profile, entries)
    quantities = COMPACT if profile.compact else COMPLETE
    module = ModuleText(profile.title, _module_text(profile))
    fields = example.field_values(profile, entries)
    for suffix, quantity in quantities.items():
        if suffix == "rp":
            # with the pressure, of one function
            continue
        if suffix == "f" or suffix in entries:
            entry = entries.get(suffix)
            own = replace(quantity, arguments=entry.arguments) if entry else quantity
            shown = shown_example(profile, own, entry, fields, entries)
            ring = entries["rp"] if suffix == "pp" else None
            module.public.append(public(profile, own, entry, functions, shown, ring))
    if profile.rules:
        module.private.append(check(profile))
    used = [private for private in functions.functions.values() if is_used(private, module, functions)]
    module.private += [_private(private, profile) for private in used]
    module.imports = imports(module)
    return module


def _private_functions(profile: Profile, entries: Mapping[str, Entry]) -> PrivateFunctions:
    functions = PrivateFunctions(profile)
    compact = bodies(functions, entries)
    split(functions, entries, bodies)
    if compact is not None:
        Inverses(compact).add_all()
    return functions


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> Compact | None:
    """Add the private functions but for the inverses of a compact contact, which follow its curves."""
    _profile_function(functions)
    if functions.profile.complete:
        Complete(entries, functions).add_all()
        return None
    compact = Compact(entries, functions)
    compact.depth_like("d", "depth")
    compact.depth_like("F", "force")
    compact.pressure()
    compact.displacement()
    form = functions.form(entries["k"], entries["k"].cases[0].expr, facts_of(()))
    compact.stiffness(form)
    compact.depth_like("pm", "mean_pressure")
    peak.bodies(compact, functions, entries)
    return compact


def bodies_source(functions: PrivateFunctions, title: str) -> str:
    """A module of private functions alone: to be measured, not to be published."""
    module = ModuleText(functions.profile.title, title)
    module.private += [_private(private, functions.profile) for private in functions.functions.values()]
    module.imports = imports(module)
    return _environment().get_template("module.py.j2").render(module=module)


def _profile_function(functions: PrivateFunctions) -> None:
    profile = functions.profile
    lines, needs, values = [], set(), []
    lower: sp.Expr = sp.S.Zero
    for piece in profile.pieces:
        form = evaluation_form(piece.expr, facts_of((lower, r) if lower != 0 else (r,)))
        lines += [line for line in functions.steps(form) if line not in lines]
        needs |= functions.needs(form, ("r",))
        values.append((piece.upper, python(form.value)))
        lower = piece.upper
    text = values[-1][1]
    for upper, value in reversed(values[:-1]):
        text, needs = f"np.where(r < {upper}, {value}, {text})", needs | {str(upper)}
    if profile.complete:
        text, needs = f"np.where(r <= a, {text}, np.nan)", needs | {"a"}
    if text == "0":
        text = "np.zeros_like(r)"
    functions.add("profile", ("r",), [*lines, f"return {text}"], needs)


def _private(private: Private, profile: Profile) -> dict[str, object]:
    typed = [f"{name}: Array" for name in private.fields]
    for name in private.needs:
        kind = "tuple[float, ...]" if name == "A" and coefficients in profile.parameters else "Array"
        typed.append(f"{name}: {kind}")
    pair = private.name.startswith("_contact_from")
    return {
        "name": private.name,
        "signature": ", ".join(typed),
        "lines": list(private.lines),
        "returns": " -> tuple[Array, Array]" if pair else " -> Array",
        "doc": private.doc,
    }


def _module_text(profile: Profile) -> str:
    return "\n".join(textwrap.wrap(profile.subtitle, 110))


@cache
def _environment() -> jinja2.Environment:
    import jinja2

    return jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.code", "templates"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


Derived = Mapping[str, Mapping[str, Entry]]
"""Entries by key of the problem and suffix."""


def package_sources(derived: Derived, kernels: str | None = None) -> dict[str, str]:
    """The files of the package as `{path below catalogue/: text}`; with `kernels` as `module_sources` takes it."""
    families: dict[str, dict[str, Mapping[str, Entry]]] = {system.name: {} for system in systems.SYSTEMS}
    for key, entries in derived.items():
        problem = systems.problem(key)
        families[problem.system.name][problem.name] = entries
    files = module_sources(families["normal"], kernels)
    normal_texts = {name: files[f"{PACKAGE}/normal/{name}.py"] for name in families["normal"]}
    files |= physics.module_sources(families, normal_texts)
    files |= graded.module_sources(families["graded.normal"], families)
    files |= plane.module_sources(families["plane"])
    tables = symbols_sources(parameter_names(derived), _arguments(derived))
    files |= {f"{PACKAGE}/{PLACE}/{name}": text for name, text in tables.items()}
    files[f"{PACKAGE}/__init__.py"] = package_source(_packages(files))
    return files | program_sources(files)


def parameter_names(derived: Derived) -> set[str]:
    """The keyword parameters with a domain of their own, by their names in the notation."""
    unbound = {coefficients, e}  # a sequence, and a place between the edges of the strip
    found = set()
    for key, entries in derived.items():
        loaded = systems.problem(key).system.physics.laws
        for entry in entries.values():
            # a depth or a load that is held is a keyword beside the time
            held = entry.quantity.arguments[1:] if loaded else ()
            found |= {parameter_name(symbol) for symbol in (*entry.parameters, *held) if symbol not in unbound}
    return found


def _arguments(derived: Derived) -> set[sp.Symbol | sp.IndexedBase]:
    """The symbols of all fields and parameters."""
    every = [entry for entries in derived.values() for entry in entries.values()]
    return {symbol for entry in every for symbol in (*entry.quantity.arguments, *entry.parameters)}


def _packages(paths: Iterable[str]) -> list[str]:
    """The public names directly below the package: folders with modules, and modules."""
    below = {PurePosixPath(path).parts[1] for path in paths if path.startswith(f"{PACKAGE}/")}
    return sorted(name.removesuffix(".py") for name in below if not name.startswith("_") and name != "py.typed")
