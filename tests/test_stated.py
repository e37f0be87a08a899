"""What a physics can state in its own file: functions of the run time, named tuples, definitions with cases."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import mpmath as mp
import pytest
import sympy as sp

from axiderive import notation as nt
from axiderive.code.systems import alone, superposed
from axiderive.entry import Entry
from axiderive.oracle.half_space import HalfSpace
from axiderive.physics import FORCE, PRESSURE, normal, tangential
from axiderive.physics.medium import HOMOGENEOUS
from axiderive.physics.systems import BY_NAME, System
from axiderive.profiles import load

PROFILE = load("paraboloid")
KNOWN = {nt.a: mp.mpf(2), nt.c: mp.mpf("0.7"), nt.r: mp.mpf("1.3"), nt.R: mp.mpf(5), nt.E_star: mp.mpf(3)}
STATED = {"F": "mu * carried(a, c)", "u": "mu * moved(a, c)"}
"""Of functions that a file of the run time might have."""


@cache
def pressed() -> dict[str, Entry]:
    return normal.derive(PROFILE)


def emitted(entries: dict[str, Entry]):
    """The module of a physics like tangential contact that states what its functions return."""
    physics = replace(tangential.PHYSICS, code=lambda profile: STATED, results={"both": "Both"})
    base = alone(BY_NAME["normal"], pressed())
    return superposed(System(physics, HOMOGENEOUS), entries, pressed(), base.parameters)


def test_a_function_returns_what_its_physics_states() -> None:
    entries = tangential.derive(PROFILE)
    module = emitted({suffix: entries[suffix] for suffix in STATED})
    private = {own.name: own for own in module.private}
    for suffix, line in STATED.items():
        name = entries[suffix].quantity.function
        assert private[f"_{name}"].lines == [f"return {line}"]
        (public,) = (own for own in module.public if own.name == name)
        assert public.lines[-1].startswith(f"return elementwise(_{name}, a, c, ")
        # the order of c and a, which tangential contact states
        assert any("require_order" in own for own in public.lines)


def test_members_of_one_result_share_a_function() -> None:
    entries = tangential.derive(PROFILE)
    joined = {
        suffix: replace(entries[suffix], quantity=replace(entries[suffix].quantity, function="both", member=name))
        for suffix, name in (("F", "force"), ("u", "shift"))
    }
    module = emitted(joined)
    (public,) = module.public
    assert {own.name for own in module.private} == {"_both_force", "_both_shift"}
    assert (public.name, public.returns) == ("both", "Both")
    assert public.lines[-1].startswith("return Both(elementwise(_both_force, a, c, ")
    assert "elementwise(_both_shift, a, c, " in public.lines[-1]
    assert "force is the tangential force" in " ".join(public.doc.split())


def test_a_definition_sums_pressures() -> None:
    """The pressures of all rings are the force; the definition is met by no formula of an entry."""
    s = sp.Symbol("s", positive=True)
    with mp.workdps(20):
        here = HalfSpace(PROFILE, KNOWN, 14, graded=False)
        summed = here.defined(2 * sp.pi * sp.Integral(PRESSURE(s, nt.a) * s, (s, 0, nt.a)))
        assert abs(summed / here.defined(FORCE(nt.a)) - 1) < 1e-10


@pytest.mark.parametrize(("place", "sticks"), [("0.3", True), ("1.3", False)])
def test_a_definition_has_cases(place: str, sticks: bool) -> None:
    with mp.workdps(20):
        here = HalfSpace(PROFILE, {**KNOWN, nt.r: mp.mpf(place)}, 14, graded=False)
        found = here.defined(sp.Piecewise((FORCE(nt.c), nt.r < nt.c), (FORCE(nt.a), True)))
        assert found == here.defined(FORCE(nt.c if sticks else nt.a))
