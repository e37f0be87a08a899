"""How something is claimed falsely of the prover: an entry with another formula, region or word, or a statement."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy as sp

from axiderive.entry import Case, Entry
from axiderive.notation import R
from axiderive.physics import systems
from axiderive.profiles.profile import Profile
from axiderive.proof import certificate
from axiderive.proof.algebra.domain import NotProvedError

Claim = Callable[[], str]
"""What is claimed falsely: the reason why it is refused, empty if it is certified."""
Refusals = dict[str, tuple[Callable[[], Claim], str]]
"""By the name of a refusal of the prover: a claim that is refused by it, and what it says."""
Altered = tuple[str, str, str, str, Callable[[], Claim], str]
"""Module and function of the prover, a text of it and what it would be without; a claim, and why it is refused."""
Change = Callable[[sp.Expr], sp.Expr]
Entries = dict[str, Entry]
HALF = sp.S.Half
ONCE = "do not cover its regions once"
U = sp.Symbol("u", positive=True)
JUMP = sp.atan(U - 1) + sp.atan(1 / (U - 1)) + sp.pi / 2
"""0 below u = 1 and pi above, with the derivative 0."""
STEP = sp.Piecewise((0, U < 1), (1, True))
ARCS = 2 * (sp.asin(U) + sp.acos(U)) / sp.pi
"""1 below u = 1, not real above."""


class Leap(sp.Function):  # type: ignore[misc]
    """0 below 1, and 1 above."""

    @classmethod
    def eval(cls, place: sp.Expr) -> sp.Expr | None:
        return sp.S.Zero if place == 0 else None

    def fdiff(self, argindex: int = 1) -> sp.Expr:
        return sp.S.Zero


def hole(length: sp.Expr) -> sp.Expr:
    """1, but not defined where the length is R."""
    return (length**2 - R**2) / ((length - R) * (length + R))


# claims


@functools.cache
def derived(key: str) -> Entries:
    return systems.problem(key).derive()


def certified(profile: Profile, entries: Entries, suffix: str) -> Claim:
    return lambda: certificate.certify(profile, entries, suffix).reason


def stated(key: str, suffix: str, /, **fields: Any) -> Claim:
    """An entry with other fields among the true ones."""
    entries = derived(key)
    changed = {**entries, suffix: replace(entries[suffix], **fields)}
    return certified(entries[suffix].profile, changed, suffix)


def formula(key: str, suffix: str, change: Change, index: int = 0) -> Claim:
    """An entry with another formula in one case, and for a fixed face."""
    entry = derived(key)[suffix]
    cases = list(entry.cases)
    cases[index] = replace(cases[index], expr=change(cases[index].expr))
    faces = tuple(replace(face, expr=change(face.expr)) for face in entry.fixed_face)
    return stated(key, suffix, cases=tuple(cases), fixed_face=faces)


def plus(key: str, suffix: str, term: sp.Expr) -> Claim:
    return formula(key, suffix, lambda expr: expr + term)


def times(key: str, suffix: str, factor: Any) -> Claim:
    return formula(key, suffix, lambda expr: expr * factor)


def set_to(key: str, suffix: str, value: sp.Expr) -> Claim:
    return formula(key, suffix, lambda _: value)


def regions(key: str, suffix: str, *chains: tuple[sp.Expr, ...]) -> Claim:
    """The true formulas on other regions."""
    cases = derived(key)[suffix].cases
    return stated(
        key, suffix, cases=tuple(replace(case, chain=chain) for case, chain in zip(cases, chains, strict=True))
    )


def only(key: str, suffix: str, *kept: int) -> Claim:
    """The true formulas of some regions alone."""
    cases = derived(key)[suffix].cases
    return stated(key, suffix, cases=tuple(cases[i] for i in kept))


def beside(key: str, suffix: str, case: Case) -> Claim:
    """A case more than the true ones."""
    return stated(key, suffix, cases=(*derived(key)[suffix].cases, case))


def shown(statement: Callable[[], Any]) -> Claim:
    """A statement of the prover itself."""

    def claim() -> str:
        try:
            return "" if statement() else "not shown"
        except NotProvedError as error:
            return str(error)
        except Exception as error:
            return f"the proof stopped: {type(error).__name__}: {error}"

    return claim
