"""The printed rows of a problem as functions: g, F_N, p and w as a reader of the book would evaluate them."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..proof.shape import coefficient, number, numeric_symbols
from .readback import environment, read
from .rows import Region, Row, kappa_row, row

Values = dict[Any, Any]


class Printed:
    """The rows of a problem, and of the normal contact on the same medium that its rules refer to."""

    def __init__(self, entries: Mapping[str, Entry], base: Mapping[str, Entry]) -> None:
        self.entries, self.base = entries, base
        self.profile = next(iter(base.values())).profile

    def environment(self, values: Values) -> dict[str, Any]:
        """Every name that a row may use: symbols, kappa, and the functions of other rows."""
        env = named(values)
        if text := kappa_row(tuple(self.base.values())):
            env |= environment(read(text), {})
        env |= {
            "g()": self._of_radius("d", values),
            "F_N()": self._of_radius("F", values),
            "P()": self._of_radius("P", values),
            "p()": self._field("p", values),
            "w()": self._field("w", values),
        }
        env["g'()"] = lambda radius: mp.diff(env["g()"], radius)
        if "Dl" in self.entries:
            env |= {
                "d_adh()": self._of_radius("d", values, self.entries),
                "F_adh()": self._of_radius("F", values, self.entries),
                "Delta ell": self.at("Dl", values, self.entries) if nt.a in values else None,
            }
        env["cuts"] = self._cuts(values)
        return env

    def at(self, suffix: str, values: Values, entries: Mapping[str, Entry] | None = None) -> Any:
        """A printed row of the normal contact, or of other entries, at these values."""
        entries = self.base if entries is None else entries
        env = self.environment(values) if entries is self.entries and suffix != "Dl" else named(values) | self._kappa()
        one = row(entries[suffix])
        statements = read((holding(one, env) if one.kind == "formula" else one.regions[0]).tex)
        if r"\int" in one.regions[0].tex and one.kind == "rule":
            env = self.environment(values)
        return statements[0].members[-1](environment(statements[1:], env))

    def _kappa(self) -> dict[str, Any]:
        text = kappa_row(tuple(self.base.values()))
        return environment(read(text), {}) if text else {}

    def _of_radius(
        self, suffix: str, values: Values, entries: Mapping[str, Entry] | None = None
    ) -> Callable[[Any], Any]:
        def value(radius: Any) -> Any:
            if self._untouched(radius, values):
                return mp.mpf(0)
            return self.at(suffix, values | {nt.a: radius}, entries)

        return value

    def _untouched(self, radius: Any, values: Values) -> bool:
        """Whether the contact would lie within the flat tip, which carries nothing while it is not pressed in."""
        return self.profile.truncated and radius <= number(values[self.profile.breaks[0]])

    def _field(self, suffix: str, values: Values) -> Callable[..., Any]:
        def value(place: Any, radius: Any = None) -> Any:
            inside = values if radius is None else values | {nt.a: radius}
            if suffix == "p" and place > number(inside[nt.a]):
                return mp.mpf(0)
            return self.at(suffix, inside | {nt.r: place})

        return value

    def _cuts(self, values: Values) -> dict[str, list[Any]]:
        """Where the integrals of the rules cross a break of the profile."""
        if nt.r not in values or nt.k not in values or not self.profile.breaks:
            return {}
        radius, power = number(values[nt.r]), (1 + number(values[nt.k])) / 2
        breaks = [number(values[b]) for b in self.profile.breaks]
        return {
            "u": [(b * b - radius * radius) ** power for b in breaks if b > radius],
            "psi": [mp.asin(b / radius) for b in breaks if b < radius],
        }


def holding(one: Row, env: Mapping[str, Any]) -> Region:
    """The one region whose printed range contains the point."""
    found = [region for region in one.regions if holds(region.condition, env)]
    if len(found) != 1:
        message = f"{one.key}: {len(found)} printed ranges hold at one point: {[region.condition for region in found]}"
        raise LookupError(message)
    return found[0]


def holds(condition: str, env: Mapping[str, Any]) -> bool:
    """Whether a printed range, chains of < and <= separated by commas, contains the point."""
    for chain in filter(None, condition.split(r",\; ")):
        if re.search(r">|\\ge(?![a-z])", chain):
            chain = "<".join(reversed(re.split(r">|\\ge(?![a-z])", chain)))
        members = [read(part)[0].members[0](env) for part in re.split(r"<|\\le(?![a-z])", chain)]
        if any(lo >= hi for lo, hi in zip(members, members[1:], strict=False)):
            return False
    return True


def named(values: Values) -> dict[str, Any]:
    """The values under the names their symbols have in print."""
    env: dict[str, Any] = {name_in_print(s): number(values[s]) for s in numeric_symbols(values) if nt.known(s.name)}
    if nt.N in values:
        env["A_j"] = [number(values[coefficient(i)]) for i in range(1, int(values[nt.N]) + 1)]
    if nt.a_c in values:
        env |= {"a_c": number(values[nt.a_c]), "a_m": number(values[nt.a_c])}
    return env


def name_in_print(symbol: sp.Symbol) -> str:
    return read(nt.describe(symbol).latex)[0].members[0].name
