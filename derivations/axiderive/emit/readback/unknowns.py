"""Rows on the iterations behind an inverse: unknown, equation and start, and what the rounding of its radius costs."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import mpmath as mp

from ... import notation as nt
from ...proof.evaluate import at_precision, case_at, evaluate
from ..evaluated_inverses import solved
from ..unknowns_graded import graded_unknowns
from .compare import DIGITS, balance, difference
from .evaluations import Stated
from .exact import Entries, Stored, base_of, functions
from .grammar import read
from .nodes import Node, Statement, environment
from .points import points_of
from .printed import holds, named
from .solved import chosen, equations_differ
from .statements import CLOSE

WORKING = 4 * DIGITS
LOADS = {"ad": ("d", "d", "m"), "aF": ("F", "F_N", "c")}
"""Quantity over the radius, its name in print, and the subscript of pull-off."""
FARTHER = mp.mpf("1.7")
"""A stable radius over that of pull-off."""
SMALL, LARGE = mp.mpf(10) ** -50, mp.mpf(10) ** 60
ROUNDED = mp.mpf(10) ** -15


def unknown_differs(one: Stated, stored: Stored) -> bool:
    """Whether the equations of an unknown do not all hold at one value of it, or its start is another one."""
    problem = one.keys[0].rpartition(".")[0]
    entries, suffixes = stored(problem), [key.rpartition(".")[2] for key in one.keys]
    if base_of(problem, stored) is entries:
        own = chosen(one, graded_unknowns(entries) if nt.k in entries["d"].parameters else solved(entries))
        if own is not None:
            return equations_differ(one, own, entries)
        return any(_place_differs(one, entries, suffix) for suffix in suffixes)
    (suffix,) = suffixes
    differs = _curve_differs if "(1+s)" in one.tex else _excess_differs
    with mp.workdps(WORKING):
        return any(differs(read(one.tex), *LOADS[suffix][1:], *point) for point in _pulled(entries, suffix))


def _solved(node: Node, env: Mapping[str, Any], name: str, want: Any) -> Any:
    """The value of the unknown at which a member has this value."""
    return mp.findroot(lambda x: node({**env, name: x}) - want, (mp.mpf(1), mp.mpf("1.3")), solver="secant")


def _place_differs(one: Stated, entries: Entries, suffix: str) -> bool:
    """A radius and its root over the unknown, at a radius of every case."""
    quantity, name, _ = LOADS[suffix]
    first, *others = read(one.tex)
    if first.members[0].name != "a":
        return True
    met = False
    for case, values in points_of(entries[quantity], "formula", entries, 2, 7):
        with mp.workdps(WORKING):
            env = named(values) | functions(entries, values)
            env |= {name: evaluate(case.expr, values, 2 * DIGITS)}
            if not holds(one.small, env):
                continue
            met = True
            known = {**env, "t": _solved(first.members[-1], env, "t", env["a"])}
            if any(difference(*(member(known) for member in s.members)) > CLOSE for s in others if _says(s, known)):
                return True
    return not met


def _says(statement: Statement, env: Mapping[str, Any]) -> bool:
    """Whether an equation is about this load: F_N(a) = F_N says nothing of a depth."""
    return statement.members[1].name not in ("d", "F_N") or statement.members[1].name in env


def _pulled(entries: Entries, suffix: str) -> Iterator[tuple[dict[str, Any], Callable[[Any], Any]]]:
    """Names at pull-off and the load over the radius, where radius and work of separation belong together."""
    quantity, _, letter = LOADS[suffix]
    radius = entries[f"a{letter}"]
    for case, values in points_of(radius, "formula", entries, 1, 7):
        balance(radius, case, values)

        def loaded(a: Any, values: Mapping[Any, Any] = values) -> Any:
            point = {**values, nt.a: a}
            return at_precision(case_at(entries[quantity], point).expr, point)

        least = values[nt.a_c]
        env = named(values) | {f"a_{letter}": least, f"{quantity}_{letter}": loaded(least)}
        env.pop({"a_c": "a_m", "a_m": "a_c"}[f"a_{letter}"])
        yield env | {f"{quantity}_adh()": loaded}, loaded


def _curve_differs(
    statements: list[Statement], name: str, letter: str, env: Mapping[str, Any], loaded: Callable[[Any], Any]
) -> bool:
    """The universal curve of a power law: one s for radius and load, and a start that is met next to pull-off."""
    radius, equation, *definitions = statements
    least = env[f"a_{letter}"]
    known = environment(definitions, {**env, name: loaded(FARTHER * least)})
    known["s"] = _solved(radius.members[-1], known, "s", FARTHER * least)
    if radius.members[0].name != "a" or difference(*(member(known) for member in equation.members)) > CLOSE:
        return True
    if not definitions:  # s^2 is the excess itself
        return False
    pulled = env[f"{name[0]}_{letter}"]
    near = environment(definitions, {**env, name: pulled * (1 - SMALL)})
    near["s"] = start = near["s_0"](near)
    return bool(difference(*(member(near) for member in equation.members)) > mp.sqrt(SMALL) * 100 or start <= 0)


def _excess_differs(
    statements: list[Statement], name: str, letter: str, env: Mapping[str, Any], loaded: Callable[[Any], Any]
) -> bool:
    """The growth since pull-off: from its radius on to the end, with the root of the share of the load as start."""
    radius, equation, start = statements
    least, pulled = env[f"a_{letter}"], env[f"{name[0]}_{letter}"]

    def at(t: Any) -> Any:
        return radius.members[-1]({**env, "t": t})

    one = at(mp.mpf(1))
    known = {**env, "a": one, name: loaded(one)}
    quarter = {**env, name: pulled + (loaded(one) - pulled) / 4}
    pairs = [
        (at(mp.mpf(0)), least),
        (equation.members[0](known), equation.members[1](known)),
        (start.members[1](known), mp.mpf(1)),
        (start.members[1](quarter), mp.mpf("0.5")),
    ]
    named_else = radius.members[0].name != "a" or start.members[0].name != "t_0"
    ends = not at(LARGE) > least * mp.sqrt(LARGE) and not _reaches(at(LARGE), env)
    return named_else or ends or any(difference(*pair) > CLOSE for pair in pairs)


def _reaches(radius: Any, env: Mapping[str, Any]) -> bool:
    """Whether a radius has come to a length of the profile."""
    return any(difference(radius, env[name]) < CLOSE for name in ("R", "b") if name in env)


def correction_differs(one: Stated, stored: Stored) -> bool:
    """Whether a small error of the radius, of the first order, is not made good."""
    (key,) = one.keys
    problem, _, suffix = key.rpartition(".")
    entries = stored(problem)
    given, result = {"Fd": ("d", "F"), "dF": ("F", "d")}[suffix]
    (statement,) = read(one.tex)
    for _, values in points_of(entries[given], "formula", entries, 1, 7):
        with mp.workdps(WORKING):
            known = functions(entries, values)
            own = {"d": known["g()"], "F": known["F_N()"]}
            exact = {name: function(named(values)["a"]) for name, function in own.items()}
            env = named(values) | known | {"d": exact["d"], "F_N": exact["F"]}
            env["a"] = env["a"] * (1 + ROUNDED)
            env.pop({"d": "d", "F": "F_N"}[result])
            if difference(statement.members[-1](env), exact[result]) > CLOSE:
                return True
    return False
