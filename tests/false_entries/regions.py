"""Families that change what stands beside a formula: its region, face, antiderivative, definition, or symbols."""

from __future__ import annotations

from dataclasses import replace
from typing import Any
from zlib import crc32

import sympy as sp

from axiderive import notation as nt
from axiderive.entry import Case, Entry, Primitive

from .entries import (
    JUMPS,
    LENGTHS,
    Found,
    U,
    before_the_edge,
    changed,
    changed_formula,
    derived,
    known,
    renamed,
    stated,
    times,
    with_case,
    with_chain,
    with_formula,
)


def unused_cases(key: str) -> Found:
    """A wrong case beside the right ones: at the end, in front, in the middle, and on a region of its own."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry):
            continue
        own = entry.cases[count % len(entry.cases)]
        wrong = changed_formula(own.expr, lambda true: 2 * true if true != 0 else nt.a / 2)
        names = [symbol for symbol in LENGTHS if symbol in known(entry) and symbol != nt.e]
        ordered = tuple(names[:2]) if len(names) > 1 else own.chain
        shapes = (
            (len(entry.cases), Case(own.chain, wrong)),
            (0, Case(own.chain, wrong)),
            (0, Case(ordered, wrong)),
            (len(entry.cases), Case(ordered[::-1], wrong)),
            (0, Case((), wrong)),
            (len(entry.cases) // 2, Case((), wrong)),
        )
        for place, case in (shapes[count % 6], shapes[(count + 3) % 6]):
            yield "unused case", suffix, with_case(entry, place, case)


def conditions(key: str) -> Found:
    """Conditions that are weaker, stronger, turned or about something else; and regions of complete contact."""
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry):
            continue
        place = count % len(entry.cases)
        chain = entry.cases[place].chain
        family = "region" if entry.profile.contact == "complete" else "condition"
        names = [symbol for symbol in LENGTHS if symbol in known(entry) and symbol not in chain and symbol != nt.e]
        shapes = [chain[::-1]] if len(chain) > 1 else []
        shapes += [(*chain, symbol) for symbol in names[:1]] if chain else [tuple(names[:2])]
        shapes += [(symbol, *chain) for symbol in names[:1]] if chain else []
        shapes += [(), chain[1:], chain[:-1]] if len(chain) > 1 else []
        for shape in shapes:
            yield family, suffix, with_chain(entry, place, shape)
        if len(entry.cases) > 1:
            kept = (*entry.cases[:place], *entry.cases[place + 1 :])
            yield family, suffix, replace(entry, cases=kept)


def exchanged_regions(key: str) -> Found:
    """Formulas and regions in the right order each, but not beside each other."""
    for suffix, entry in derived(key).items():
        if stated(entry) and len(entry.cases) > 1:
            chains = [case.chain for case in entry.cases]
            pairs = zip(entry.cases, (*chains[1:], chains[0]), strict=True)
            cases = tuple(Case(chain, case.expr) for case, chain in pairs)
            yield "exchanged regions", suffix, replace(entry, cases=cases)
            yield "exchanged regions", suffix, replace(entry, cases=cases[::-1])
            exprs = [case.expr for case in entry.cases][::-1]
            cases = tuple(replace(case, expr=expr) for case, expr in zip(entry.cases, exprs, strict=True))
            yield "exchanged regions", suffix, replace(entry, cases=cases)


def fixed_faces(key: str) -> Found:
    """Complete contact: the formula of the region doctored beside a true one for the fixed face, and the reverse."""
    if key not in ("flat_punch", "capped_cylinder", "concave_paraboloid", "concave_quartic", "flat_punch.fgm"):
        return
    for suffix, entry in derived(key).items():
        if not entry.fixed_face:
            continue
        jump = 1 + JUMPS[0].subs(U, 2 * nt.C) if key.startswith("concave") else 1 + JUMPS[0].subs(U, nt.E_star)
        after = [i for i, case in enumerate(entry.cases) if not before_the_edge(case)]
        wrong = entry
        for i in after:
            wrong = with_formula(wrong, i, 2 * wrong.cases[i].expr)
        yield "fixed face", suffix, replace(wrong, fixed_face=entry.fixed_face)
        yield "fixed face", suffix, replace(wrong, fixed_face=())
        loose = sp.S.One + nt.h / nt.a if key.startswith("concave") else jump
        yield "fixed face", suffix, changed(entry, times(loose))


def doctored_primitives(key: str) -> Found:
    """Depths that are not the integral of the slope, with antiderivatives that add up to them."""
    if key not in ("cone", "paraboloid", "sphere", "truncated_cone", "rounded_cone", "paraboloid.fgm", "plane.wedge"):
        return
    suffix = "P" if key.startswith("plane") else "d"
    entry = derived(key)[suffix]
    for factor in (sp.Integer(2), 1 + JUMPS[0].subs(U, 2 * nt.a / (nt.R if nt.R in entry.parameters else nt.b))):
        found = {
            chain: tuple(replace(p, integrand=factor * p.integrand, expr=factor * p.expr) for p in own)
            for chain, own in entry.primitives.items()
        }
        yield "primitive", suffix, replace(changed(entry, times(factor)), primitives=found)
        only = {c: tuple(replace(p, expr=factor * p.expr) for p in own) for c, own in entry.primitives.items()}
        yield "primitive", suffix, replace(changed(entry, times(factor)), primitives=only)


def idle_primitives(key: str) -> Found:
    """Antiderivatives over no interval: they prove nothing of the slope, but an increment of theirs is put in."""
    for suffix in ("d", "P"):
        entry = derived(key).get(suffix)
        if entry is None or not entry.primitives:
            continue
        unit = nt.E_star if suffix == "P" else sp.S.One
        for index, case in enumerate(entry.cases):
            own = entry.primitives.get(case.chain, ())
            ends = [sp.S.Zero, *case.chain[: case.chain.index(nt.a) + 1]]
            for lo, hi in ((ends[-1], ends[-2]), (ends[-1], ends[-1]), (ends[-2], ends[-1])):
                for expr in (unit * nt.x, unit * nt.a):
                    idle = Primitive(lo, hi, sp.S.Zero, expr)
                    shifted = case.expr + expr.subs(nt.x, hi) - expr.subs(nt.x, lo) + (nt.a if lo == hi else 0) * unit
                    wrong = with_formula(entry, index, shifted)
                    yield "primitive", suffix, replace(wrong, primitives={**entry.primitives, case.chain: (*own, idle)})


def definitions(key: str) -> Found:
    """All of an entry that is no formula: its definition, parameters, quantity, profile, composition and status."""
    place = crc32(key.encode())
    entries = derived(key)
    names = list(entries)
    for count, (suffix, entry) in enumerate(entries.items()):
        if not stated(entry):
            continue
        other = entries[names[(count + 1) % len(names)]]
        doctored = [
            replace(entry, definition=_doctored(entry.definition)),
            replace(entry, parameters=entry.parameters[1:]),
            replace(entry, parameters=(*entry.parameters, nt.nu)),
            replace(entry, quantity=other.quantity),
            replace(entry, key=other.key),
            replace(entry, parameters=entry.parameters[::-1]),
            replace(entry, composed=("p", "w")),
            replace(entry, status="closed" if entry.status == "root" else "root"),
            replace(entry, definition=other.definition),
            replace(entry, quantity=replace(entry.quantity, arguments=entry.quantity.arguments[::-1] or (nt.r,))),
            replace(entry, quantity=replace(entry.quantity, symbol=nt.nu, label="Poisson ratio")),
        ]
        yield from (
            ("definition", suffix, wrong)
            for wrong in (doctored[(count + place) % len(doctored)], doctored[(count + place + 4) % len(doctored)])
            if wrong != entry
        )
        if entry.partial is not None:
            doubled = changed(entry.partial, times(2))
            yield "definition", suffix, replace(entry, partial=doubled)
            yield "definition", suffix, replace(entry, partial=None)
    for suffix, modulus in (("E_star", nt.E_star), ("G_star", nt.G_star), ("R", nt.R)) if key == "materials" else ():
        entry = derived("materials")[suffix]
        halved = sp.Eq(1 / modulus, 2 * entry.definition.rhs)
        yield "definition", suffix, replace(changed(entry, times(sp.S.Half)), definition=halved)
        renamed = sp.Eq(1 / nt.E, entry.definition.rhs)
        yield "definition", suffix, replace(entry, definition=renamed)


def _doctored(definition: sp.Expr) -> sp.Expr:
    if isinstance(definition, sp.Equality):
        return sp.Eq(definition.lhs, 2 * definition.rhs, evaluate=False)
    return 2 * definition


def foreign_symbols(key: str) -> Found:
    """A symbol of the same name without its sign, and symbols that only proofs know."""
    kappa, share, shifted = (sp.Symbol(name, positive=True) for name in ("kappa", "s_c", "sigma_1"))
    for count, (suffix, entry) in enumerate(derived(key).items()):
        if not stated(entry) or count % 3:
            continue
        names = sorted(set().union(*(case.expr.free_symbols for case in entry.cases)), key=str)
        if names:
            chosen = names[count % len(names)]
            yield "foreign symbol", suffix, renamed(entry, {chosen: sp.Symbol(chosen.name)})
            yield "foreign symbol", suffix, renamed(entry, {chosen: sp.Symbol(chosen.name, real=True)})
        if any(case.expr.has(nt.k) for case in entry.cases):
            yield "foreign symbol", suffix, renamed(entry, {nt.k: kappa - 1})
    entries = derived(key)
    if key == "loads.power":
        yield "foreign symbol", "w", renamed(entries["w"], {nt.sigma: shifted - 1})
    if key == "paraboloid.adh":
        yield "foreign symbol", "aF", changed(entries["aF"], lambda e: e + nt.a * (share - share**2))
    if key == "paraboloid.tan":
        yield "foreign symbol", "u", renamed(entries["u"], {nt.mu: nt.alpha})
    if key == "paraboloid":
        yield "foreign symbol", "F", renamed(entries["F"], {nt.E_star: nt.E})


def media(key: str) -> Found:
    """The formula of the homogeneous half-space with the moduli of the graded one, and the reverse."""
    if ".fgm" not in key:
        return
    names = {nt.E_star: nt.H, nt.G_star: nt.H_x}
    for suffix, entry in derived(key).items():
        plain = derived(key.replace(".fgm", "")).get(suffix)
        if plain is None or not stated(entry) or [c.chain for c in plain.cases] != [c.chain for c in entry.cases]:
            continue
        yield "another medium", suffix, replace(renamed(plain, names), **_frame(entry))
        limit = {nt.k: sp.S.Zero, nt.H: nt.E_star, nt.H_x: nt.G_star}
        yield "another medium", suffix, replace(renamed(entry, limit), key=plain.key)
        yield "another medium", suffix, renamed(entry, {nt.k: -nt.k})
        yield "another medium", suffix, renamed(entry, {nt.k: nt.k / 2})


def _frame(entry: Entry) -> dict[str, Any]:
    """All of an entry but its formulas."""
    return {
        "key": entry.key,
        "quantity": entry.quantity,
        "definition": entry.definition,
        "parameters": entry.parameters,
        "primitives": entry.primitives,
    }
