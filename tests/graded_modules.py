"""Emitted graded modules with drawn parameters, and their exact entries."""

from __future__ import annotations

import inspect
from functools import cache
from importlib import import_module
from types import ModuleType
from typing import Any

import sympy as sp
from stored_book import stored

from axiderive import notation as nt
from axiderive.code import example
from axiderive.entry import Entry
from axiderive.letters import name_of
from axiderive.physics.systems import problems
from axiderive.profiles.profile import Profile

GROUPS = ("normal", "adhesive", "tangential")
MATERIAL = {nt.H: "2.5", nt.H_x: "0.8", nt.dgamma: "0.0125", nt.mu: "0.3"}


EXPONENTS = ("-0.9", "-0.5", "-0.1", "0.3", "0.7", "0.95")
POWERS = ("cone", "paraboloid", "quartic", "sextic", "power_law", "polynomial")


@cache
def derived(group: str, name: str) -> dict[str, Entry]:
    """The entries of a graded package for one profile, as the catalogue holds them; none where it says why."""
    found = [p for p in problems([name]) if p.system.name == f"graded.{group}"]
    return stored(found[0].key) if found else {}


def emitted(name: str) -> ModuleType:
    return import_module(f"axicontact.graded.{name}")


def values(profile: Profile, k: str) -> dict[sp.Symbol, Any]:
    known = {symbol: sp.Rational(text) for symbol, text in MATERIAL.items()}
    known |= {nt.k: sp.Rational(k), **example.numbers(profile)}
    if profile.name == "concave_power":
        known[nt.n] = sp.Rational("2.75")
    if profile.name == "wavy_paraboloid":
        known[nt.wavelength] = sp.Rational("0.6")  # compact for every grading
    known |= {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}
    radius = known.get(nt.a, sp.Rational(str(profile.sketch.a)))
    depth = sp.Rational(str(profile.sketch.d or "0.6"))
    if profile.name.startswith("concave"):
        depth = sp.Integer(2 if known[nt.k] > -0.6 else 60)  # beyond the least of complete contact
    return {nt.a: radius, nt.d: depth} | known


def keywords(function: Any, profile: Profile, known: dict[sp.Symbol, Any]) -> dict[str, Any]:
    named = {name_of(symbol): value for symbol, value in known.items()}
    named |= {"A": tuple(map(float, example.POLYNOMIAL))} if profile.name == "polynomial" else {}
    wanted = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
    return {name: named[name] if isinstance(named[name], tuple) else float(named[name]) for name in wanted}


SLOW = ("wavy_paraboloid", "sphere_tipped_cone")
"""Struve functions and the moment of a cap take seconds each."""


def public(module: ModuleType) -> dict[str, list[str]]:
    functions = {
        key: inspect.signature(value)
        for key, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_")
    }
    return {
        key: [p.name for p in own.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]
        for key, own in functions.items()
    }
