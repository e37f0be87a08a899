"""Every refusal of the prover is needed: a false entry that only this one refuses, and that is certified without it.

A new refusal without a false entry makes `test_every_guard_has_a_false_entry` fail.
"""

from __future__ import annotations

import functools
import re

import guards
import pytest
from false_claims import algebra, compact, plane, superposed
from false_claims.claims import Altered, Refusals, stated

NEEDED: Refusals = algebra.NEEDED | compact.NEEDED | superposed.NEEDED | plane.NEEDED
"""The false entry that only this refusal refuses, and what it says."""
WORDING: Refusals = algebra.WORDING | compact.WORDING | plane.WORDING
"""Refusals that give a better reason than the one that would come after; the entry stays refused."""
EFFORT = {
    "tower.Tower._repeated: a power with exponent ... is not expanded": "the exact power takes long",
    "tower.Tower.mul: the expressions of the proof grow beyond all bounds": "the exact product takes long",
    "tower.Tower.factors: a polynomial with ... terms is not factored": "the exact factors take long",
}
"""Refusals that only bound the time of a proof, and what they spare."""
BUILT = {
    "loads._by_antiderivative: require_zero(sp.diff(factor * total, t) - wanted, domain)": (
        "sp.Rational(2 * i - 1, 2 * i)",
        "sp.Rational(1, 3 * i)",
        "d/dt of the antiderivative",
    ),
}
"""Refusals of what the prover itself builds: a misprint in it, by which a true entry is refused."""
ALTERED: dict[str, Altered] = algebra.ALTERED | compact.ALTERED | superposed.ALTERED | plane.ALTERED
"""Conclusions of the same weight that are no refusals: a text of the prover, and what it would be without."""


@functools.cache
def known() -> dict[str, guards.Guard]:
    return {guard.name: guard for guard in guards.found()}


def test_every_guard_has_a_false_entry() -> None:
    tables = [*NEEDED, *WORDING, *EFFORT, *BUILT]
    names = [guard.name for guard in guards.found()]
    assert len(names) == len(set(names))
    assert sorted(tables) == sorted(names)


@pytest.mark.parametrize("name", NEEDED)
def test_the_false_entry_is_refused(name: str) -> None:
    """For the reason of its guard, and so one that refuses less is seen."""
    build, message = NEEDED[name]
    assert re.search(message, build()())


@pytest.mark.slow
@pytest.mark.parametrize("name", NEEDED)
def test_the_false_entry_is_certified_without_its_guard(name: str) -> None:
    """So that a refusal for the same words that stands elsewhere does not pass for the guard."""
    build, _ = NEEDED[name]
    claim = build()
    with guards.without(known()[name]):
        assert claim() == ""


@pytest.mark.parametrize("name", WORDING)
def test_the_false_entry_is_refused_for_another_reason_without_its_guard(name: str) -> None:
    build, message = WORDING[name]
    claim = build()
    assert re.search(message, claim())
    with guards.without(known()[name]):
        other = claim()
    assert other
    assert not re.search(message, other)


@pytest.mark.parametrize("name", ALTERED)
def test_the_false_entry_is_certified_by_the_altered_prover(name: str) -> None:
    module, function, old, new, build, message = ALTERED[name]
    claim = build()
    assert re.search(message, claim())
    with guards.altered(module, function, old, new):
        assert claim() == ""


@pytest.mark.parametrize("name", BUILT)
def test_a_misprint_in_the_prover_is_refused(name: str) -> None:
    old, new, message = BUILT[name]
    guard = known()[name]
    claim = stated("loads.hertzian", "w")
    assert claim() == ""
    with guards.altered(guard.module, guard.function, old, new):
        assert re.search(message, claim())
