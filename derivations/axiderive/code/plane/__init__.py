"""The package `axicontact.plane`: one module for each profile of the plane problem."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ... import notation as nt
from ...entry import Entry, Quantity
from ...physics.plane_quantities import PLANE, PLANE_COMPLETE, PLANE_ECCENTRIC
from ...profiles.profile import Profile
from ..bodies.regimes import split
from ..layout import OFFERED
from ..physics import text
from ..physics.refusals import package_source
from ..private import Private, PrivateFunctions
from ..public import PACKAGE, check, unused
from . import complete, document
from .compact import Compact
from .complete import Complete

TITLE = "Plane contact without adhesion: rigid strips on an elastic half plane, per length of the strip"
SHAPE = Quantity("f", "profile", "Profile", nt.f, (nt.x,), parity="even", summary="Profile f(x) of the indenter.")
IMPORTS = (
    "interface: Array, Result, elementwise, require, require_order, require_reach",
    *OFFERED,
    "inverse: inverse",
    "physics.plane: depth_beyond, even, load_beyond, odd, require_eccentricity, slope_beyond, turned",
    "shapes.powers: power_pressure, power_strips",
    "shapes.ring: outside_zero_pressure, ring_of_zero_pressure",
    "rules: pressure_integral_beyond",
)


def module_sources(derived: Mapping[str, Mapping[str, Entry]]) -> dict[str, str]:
    """The package as `{path below catalogue/: text}`, for entries by profile name and suffix."""
    files = {f"{PACKAGE}/plane/{name}.py": module_source(derived[name]) for name in sorted(derived)}
    return files | {f"{PACKAGE}/plane/__init__.py": package_source(TITLE, sorted(derived))}


def module_source(entries: Mapping[str, Entry]) -> str:
    """The module of one profile."""
    module = _Module(entries)
    public = [module.public(quantity) for quantity in module.quantities]
    reached = [own for own in module.functions.functions.values() if module.reached(own, public)]
    private = [*module.check(), *(text.private(own.name, own.fields, own.needs, own.lines, own.doc) for own in reached)]
    profile = module.profile
    whole = text.module(profile.title, profile.subtitle, IMPORTS, public, private)
    return "\n".join(line.rstrip() for line in whole.split("\n"))


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> Compact | None:
    """Add the private functions."""
    if nt.e in functions.profile.parameters:
        complete.add_all(entries, functions)
        return None
    if functions.profile.complete:
        Complete(entries, functions).add_all()
        return None
    compact = Compact(entries, functions)
    compact.add_all()
    return compact


def bodies_source(functions: PrivateFunctions, title: str) -> str:
    """A module of private functions alone: to be measured, not to be published."""
    private = (
        text.private(own.name, own.fields, own.needs, own.lines, own.doc) for own in functions.functions.values()
    )
    return text.module(functions.profile.title, title, IMPORTS, [], list(private))


@dataclass
class _Module:
    """The functions of one profile."""

    entries: Mapping[str, Entry]

    def __post_init__(self) -> None:
        self.profile: Profile = next(iter(self.entries.values())).profile
        self.functions = PrivateFunctions(self.profile)
        self.eccentric = nt.e in self.profile.parameters
        known = PLANE
        if self.eccentric:
            known = PLANE_ECCENTRIC
        elif self.profile.complete:
            known = PLANE_COMPLETE
        bodies(self.functions, self.entries)
        split(self.functions, self.entries, bodies)
        shape = [] if self.eccentric else [SHAPE]
        self.quantities = shape + [quantity for suffix, quantity in known.items() if suffix in self.entries]

    def public(self, quantity: Quantity) -> text.Function:
        """The public function of one quantity; without an entry that of the shape f(x)."""
        entry = self.entries.get(quantity.suffix)
        symbols = entry.parameters if entry else self.profile.parameters
        fields, keywords = [str(field) for field in quantity.arguments], [str(symbol) for symbol in symbols]
        private = self.functions.functions[quantity.function]
        body = [*self._checks(keywords, fields), f"return {self._evaluation(quantity, private, fields, keywords)}"]
        whole = "\n".join(line for own in self._used(private) for line in own.lines)
        example = document.lines(self.profile, self.entries, quantity, symbols)
        doc = document.text(
            self.profile, quantity, entry, symbols, document.notes(self.profile, quantity, whole), example
        )
        return text.Function(quantity.function, fields, keywords, quantity.summary, doc, body)

    def _checks(self, keywords: list[str], fields: list[str]) -> list[str]:
        if self.eccentric:
            plain = ", ".join(f"{name}={name}" for name in keywords if name != "e")
            return [f"require({plain})", "require_eccentricity(a, e)"]
        owner = "_check" if self.profile.rules else "require"
        lines = [f"{owner}({', '.join(f'{name}={name}' for name in keywords)})"]
        if self.profile.truncated and "a" in fields:
            lines.append(f'require_reach(a, {self.profile.breaks[0]}, "plane.flat_punch")')
        return lines

    def _evaluation(self, quantity: Quantity, private: Private, fields: list[str], keywords: list[str]) -> str:
        given = {"e": "turned(x, e)"} if quantity.suffix == "p" else {}
        passed = [f"{name}={given.get(name, name)}" for name in private.needs]
        wrapper = quantity.parity or "elementwise"
        spread = unused(name for name in keywords if name not in private.needs)
        return f"{wrapper}({', '.join([private.name, *fields, *passed, *spread])})"

    def _used(self, private: Private) -> list[Private]:
        """The function and those it calls or hands to a rule."""
        used, pending = [], [private]
        while pending:
            own = pending.pop()
            used.append(own)
            known = self.functions.functions.values()
            pending += [other for other in known if own.uses(other) and other not in used]
        return used

    def reached(self, own: Private, public: list[text.Function]) -> bool:
        """Whether a public function calls this private one, directly or through others."""
        called = [
            other
            for other in self.functions.functions.values()
            if any(f"({other.name}" in line for function in public for line in function.body)
        ]
        return any(own in self._used(other) for other in called)

    def check(self) -> list[str]:
        """The check of the rules between the parameters."""
        if self.eccentric or not self.profile.rules:
            return []
        own = check(self.profile)
        lines = "\n".join(f"    {line}" for line in own["lines"])  # type: ignore[attr-defined]
        return [f"def {own['name']}({own['signature']}){own['returns']}:\n{lines}\n"]
