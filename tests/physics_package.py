"""The modules beyond the normal contact, and values to call them with."""

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
from axiderive.physics import systems
from axiderive.profiles.profile import Profile

SYSTEMS = ("normal", "adhesive", "tangential", "viscoelastic", "loads", "materials")
CLOSED = 2e-14
MATERIAL = {
    nt.E_star: 2.5, nt.dgamma: 0.0125, nt.mu: 0.3, nt.G_star: 0.8, nt.E: 2.5, nt.E_inf: 1.5, nt.E_1: 2.0,
    nt.relaxation: 0.7, nt.eta: 0.9, nt.alpha: 0.4, nt.t_0: 0.6, nt.v: 0.25, nt.v_2: 0.05, nt.t_m: 0.8,
    nt.t_h: 0.85,
    nt.p_0: 1.75, nt.sigma: 0.3,
}  # fmt: skip


@cache
def derived() -> dict[str, dict[str, dict[str, Entry]]]:
    """All entries these modules rest on, as the catalogue holds them, by system, profile and suffix."""
    out: dict[str, dict[str, dict[str, Entry]]] = {system: {} for system in SYSTEMS}
    for problem in systems.problems():
        if problem.system.name in SYSTEMS:
            out[problem.system.name][problem.name] = stored(problem.key)
    return out


def emitted(name: str) -> ModuleType:
    return import_module(f"axicontact.{name}")


def public(module: ModuleType) -> dict[str, inspect.Signature]:
    return {
        key: inspect.signature(value)
        for key, value in vars(module).items()
        if inspect.isfunction(value) and value.__module__ == module.__name__ and not key.startswith("_")
    }


def positional(signature: inspect.Signature) -> list[str]:
    return [p.name for p in signature.parameters.values() if p.kind is p.POSITIONAL_OR_KEYWORD]


def values(profile: Profile) -> dict[sp.Symbol, sp.Rational]:
    material = {symbol: sp.Rational(str(value)) for symbol, value in MATERIAL.items()}
    known = {**material, **example.numbers(profile)}
    return known | {symbol: expr.subs(known) for symbol, expr in profile.abbreviations}


def keywords(function: Any, profile: Profile, known: dict[sp.Symbol, Any]) -> dict[str, Any]:
    named = {
        name_of(symbol): float(value) for symbol, value in known.items() if name_of(symbol) != "A" or symbol == nt.A
    }
    named |= {"A": tuple(map(float, example.POLYNOMIAL))} if profile.name == "polynomial" else {}
    named |= {"s": float(known[nt.s])} if nt.s in profile.parameters else {}
    wanted = [p.name for p in inspect.signature(function).parameters.values() if p.kind is p.KEYWORD_ONLY]
    return {name: named[name] for name in wanted}


def exact(entry: Entry, known: dict[sp.Symbol, Any]) -> float:
    return float(example.value(entry, known))


def radius(profile: Profile) -> sp.Rational:
    return sp.Rational(str(profile.sketch.a))
