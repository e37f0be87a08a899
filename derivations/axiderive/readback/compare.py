"""Every printed row against the entries it was printed from, through its LaTeX source alone.

A row without a key of its own is about several entries, or about one on its way to a limit: limits, universal curves
and sums.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import case_at, decades, evaluate, evaluated
from ..physics.systems import of
from ..rows import laws
from ..rows.blocks import texts_of
from ..rows.claims import Exact, claim, points_of
from ..rows.row import Row, row
from .claims import (
    CLOSE,
    DIGITS,
    WORKING,
    Claim,
    Entries,
    Printed,
    Stored,
    Values,
    difference,
    functions_of,
    holding,
    holds,
    name_in_print,
    name_of,
    named,
)
from .grammar import read
from .meaning import environment
from .source import GAP as LINES
from .source import OPENING, Further

INTEGRATING = 38
"""Working digits of a row that is an integral, or refers to one."""


def worst_residual(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Any:
    """Largest relative difference between the printed row and its entry over random points of every case.

    `base` are the entries of the normal contact on the same medium, which the rules refer to.

    Raises
    ------
    SyntaxError, KeyError
        If the source cannot be read, or uses what it does not define.
    """
    return max(residuals(one, entries, count, seed, base))


def residuals(one: Row, entries: Entries, count: int = 3, seed: int = 17, base: Entries | None = None) -> Iterator[Any]:
    """The relative differences one after the other; of a row of several those of the rows that it stands for."""
    base = entries if base is None else base
    for part, text in zip(one.parts, texts_of(one.regions[0].tex), strict=True) if one.parts else ():
        own = replace(part, regions=(replace(part.regions[0], lines=(text,)),))
        yield from residuals(own, entries, count, seed, base)
    if one.parts:
        return
    printed = Printed(entries, base)
    for entry in (one.entry, *one.also):
        for case, values in points_of(entry, one.kind, entries, count, seed):
            # a displacement far outside leaves a^7/r of terms of the size of r^5 a
            with mp.workdps(INTEGRATING if integrates(one, base) else WORKING + 10 * decades(values)):
                said, known = claim(one, entry, case, entries, base), dict(values)
                for symbol, exact in said.given:
                    known[symbol] = value_of(exact, known, DIGITS + 15)
                env = _environment(one, entry, printed, known)
                want = None if said.value is None else value_of(said.value, known)
                name = name_of(one.entry) if want is not None and not isinstance(want, tuple) else ""
                yield Claim(env, want, name).residual(holding(one, env).tex)


def integrates(one: Row, base: Entries) -> bool:
    """Whether reading the row back takes a quadrature, of its own or in a row that it refers to."""
    needed = {"p": "p", "tau": "p", "w": "w"}.get(one.suffix)
    rows = [one, row(base[needed])] if needed and needed in base else [one]
    return any(r"\int" in region.tex for own in rows for region in own.regions)


def value_of(exact: Exact, values: Values, digits: int = DIGITS) -> Any:
    """The value at a point: integrals by quadrature, all else to these digits; of an equation that of each side."""
    expr = case_at(exact, values).expr if isinstance(exact, Entry) else exact
    if isinstance(expr, sp.Equality):
        return tuple(value_of(side, values, digits) for side in expr.args)
    return evaluated(expr, values) if expr.has(sp.Integral) else evaluate(expr, values, digits)


def _environment(one: Row, entry: Entry, printed: Printed, values: Values) -> dict[str, Any]:
    """The names a row may use: of the radii of pull-off that of its own control, and the functions of a law."""
    env, physics = printed.environment(values), of(entry).physics
    if entry.quantity.control:
        env.pop({"c": "a_m", "m": "a_c"}[entry.suffix[-1]], None)
    if physics.laws:
        if "Fd" not in printed.base:
            env["F_N()"] = lambda depth, env=dict(env): printed.at("F", {**env, "d": depth})
        law = next(law for law in laws.laws() if entry.suffix.endswith("_" + law.suffix))
        # the power of the depth, which the row defines behind its formula
        env = environment(read(one.regions[0].tex)[1:], env)
        env |= functions_of(law, env)
    return env


KINDS = ("universal", "sum")
"""Kinds that are read here; an approach or a limit says itself what its formula has to be, and where."""
ENDS = {
    "edge": (r"r\to a", r"x\to a"), "far-field": (r"r\to\infty", r"x\to\infty"), "axis": (r"r\to 0",),
    "middle": (r"x\to 0", r"r\to 0"), "small-contact": (r"a\to 0",), "onset": (r"a\to b",),
}  # fmt: skip
"""Where an approach goes, as it is printed beside its name; a condition may follow."""


def wrong(one: Further, stored: Stored) -> bool:
    """Whether a row says something else than the entries it is about."""
    return {"universal": _universal, "sum": _sum}[one.kind](one, stored)


CURVE = (sp.Rational(3, 10), sp.S.One, sp.Rational(27, 10))
"""Radii over that of pull-off at which a universal curve is compared."""


def _universal(one: Further, stored: Stored) -> bool:
    problem = one.keys[0] if one.keys[0].endswith("adh") else one.keys[0].rpartition(".")[0]
    entries = stored(problem)
    fields = {s for suffix in ("ac", "Fc", "dc", "F", "d") for s in entries[suffix].cases[0].expr.free_symbols}
    values = {s: sp.Rational(11 + 2 * i, 7 + 3 * i) for i, s in enumerate(sorted(fields, key=str))}
    values |= {nt.theta: sp.Rational(2, 5), nt.k: sp.Rational(3, 8), nt.n: sp.Rational(17, 10)}
    with mp.workdps(2 * DIGITS):
        pulled = evaluate(entries["ac"].cases[0].expr, values, DIGITS)
        for ratio in CURVE:
            at = values | {nt.a_c: pulled, nt.a: pulled * mp.mpf(ratio.p) / ratio.q}
            env = named(at) | {"x": mp.mpf(ratio.p) / ratio.q}
            for name, suffix in (("F_adh", "F"), ("d_adh", "d"), ("F_c", "Fc"), ("d_c", "dc")):
                env[name] = evaluate(entries[suffix].cases[0].expr, at, DIGITS)
            if any(map(Claim(env).wrong, one.tex.split(r",\qquad "))):
                return True
    wanted = {f"{suffix}_adh" for suffix in ("F", "d") if f"{problem}.{suffix}" in one.keys}
    return not all(name.replace("_adh", r"_{\mathrm{adh}}") in one.tex for name in wanted)


_PART = re.compile(
    r"\\text\{(plus |minus )?\\hyperref\[sec:([\w.]+)\]\{[^}]*\}, page~\\pageref\{sec:([\w.]+)\}, with \}(.*)"
)


def _sum(one: Further, stored: Stored) -> bool:
    """Whether the parts that are named do not add to the entries at equal contact radius, in the range beside them."""
    lines = one.tex.removeprefix(OPENING).removesuffix(r"\end{aligned}").split(LINES)
    parts = [match.groups() for match in map(_PART.fullmatch, lines) if match]
    if len(parts) != len(lines) or any(name != page for _, name, page, _ in parts):
        return True
    profile = one.keys[0].rpartition(".")[0]
    entries = stored(profile)
    for suffix in (key.rpartition(".")[2] for key in one.keys):
        for case, values in points_of(entries[suffix], "formula", entries, 1, 13):
            if "<" in one.small and not holds(one.small, named(dict(values))):
                continue
            with mp.workdps(2 * DIGITS):
                want = evaluate(case.expr, values, DIGITS)
                if difference(sum(_share(part, suffix, values, stored) for part in parts), want) > CLOSE:
                    return True
    return False


def _share(part: Sequence[str], suffix: str, values: Mapping[Any, Any], stored: Stored) -> Any:
    """What a part adds to a quantity; nothing while its flat face is not pressed in."""
    sign, name, _, text = part
    entry = stored(name)[suffix]
    own = {name_in_print(symbol): symbol for symbol in entry.profile.parameters}
    given = {}
    for statement in read(text):
        given[own[statement.members[0].name]] = sp.Float(str(statement.members[1](named(dict(values)))), 2 * DIGITS)
    known = {**values, **given}
    if entry.profile.truncated and known[nt.a] < known[nt.b]:
        return 0
    value = evaluate(case_at(entry, known).expr, known, DIGITS)
    return -value if sign == "minus " else value
