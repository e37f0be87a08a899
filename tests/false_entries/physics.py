"""Families of one problem alone: the punch under an eccentric load, and the constants of the materials."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from axiderive import notation as nt

from .entries import (
    ECCENTRIC,
    Found,
    changed,
    derived,
    times,
    with_chain,
    with_formula,
)


def eccentric(key: str) -> Found:
    """Absolute values, maxima and signs that hold for e > 0, x > 0 only, and formulas of the substitutes of a proof."""
    if key != ECCENTRIC:
        return
    entries, a, e, x, P = derived(ECCENTRIC), nt.a, nt.e, nt.x, nt.P
    strip, lifted = (case.expr for case in entries["p"].cases)
    tilt, lifted_tilt = (case.expr for case in entries["phi"].cases)
    room = 3 * a + x * sp.sign(e) - 4 * sp.Abs(e)
    bare = P / (2 * sp.pi * sp.sqrt(a - x * sp.sign(e)) * (a - sp.Abs(e)))
    wrong: dict[str, list[tuple[int, sp.Expr]]] = {
        "cw": [
            (1, 4 * (a - e)),
            (1, 4 * (a + e)),
            (1, 4 * (a - sp.Max(0, e))),
            (1, 2 * nt.c),
            (1, sp.Abs(4 * (a - e))),
            (1, 4 * (a - sp.Abs(e)) * sp.sign(e)),
            (1, 2 * (a - sp.Abs(e)) * (1 + sp.sign(e))),
            (1, sp.Max(0, 4 * (a - e))),
            (1, 2 * a),
            (0, 2 * a * sp.sign(e)),
            (0, 4 * e * (a + nt.t) / a),
            (0, 4 * sp.Abs(e) * (a + nt.t) / a),
            (0, 2 * a + sp.Abs(e) - e),
            (0, 2 * a + sp.Abs(x) - x),
            (0, 4 * (a - sp.Abs(e))),
        ],
        "phi": [
            (0, sp.Abs(tilt)),
            (0, tilt * sp.sign(e)),
            (0, -tilt),
            (0, tilt * sp.sign(x)),
            (0, 2 * tilt),
            (1, lifted_tilt * sp.sign(e)),
            (1, P / (sp.pi * nt.E_star * (a - e))),
            (1, P / (sp.pi * nt.E_star * (a - sp.Abs(e)))),
            (1, P * sp.Abs(e) / (e * sp.pi * nt.E_star * (a - e))),
            (1, 2 * P * sp.sign(e) / (sp.pi * nt.E_star * nt.c)),
            (1, lifted_tilt * (1 + sp.sign(e)) / 2),
            (1, lifted_tilt * sp.sign(x) * sp.sign(e)),
        ],
        "p": [
            (0, P * (a**2 + 2 * sp.Abs(e * x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, P * (a**2 + 2 * sp.Abs(e) * sp.Abs(x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, P * sp.Max(0, a**2 + 2 * sp.Abs(e) * sp.Abs(x)) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, strip * (1 + sp.sign(e) ** 2) / 2 + P * (sp.sign(x) * sp.sign(e) - 1) / a),
            (0, P * (a**2 - 2 * e * x) / (sp.pi * a**2 * sp.sqrt(a**2 - x**2))),
            (0, strip * sp.sign(x) ** 2 * sp.sign(e) * sp.sign(x)),
            (1, bare * sp.sqrt(room)),
            (1, bare * sp.sqrt(sp.Abs(room))),
            (1, bare * sp.sqrt(sp.Max(0, 3 * a + sp.Abs(x) - 4 * sp.Abs(e)))),
            (1, lifted.subs(a - sp.Abs(e), nt.c / 2)),
            (1, P * sp.sqrt(sp.Max(0, room)) / (2 * sp.pi * sp.sqrt(a - x * sp.sign(e)) * (a - e))),
            (1, P * sp.sqrt(sp.Max(0, room)) / (2 * sp.pi * sp.sqrt(a - sp.Abs(x)) * (a - sp.Abs(e)))),
            (1, bare * sp.Max(0, sp.sqrt(room))),
            (1, lifted * sp.sign(x) * sp.sign(e)),
        ],
    }
    for suffix, changes in wrong.items():
        for place, expr in changes:
            yield "eccentric", suffix, with_formula(entries[suffix], place, expr)
    for suffix, entry in entries.items():
        one, other = entry.cases
        yield "eccentric", suffix, replace(entry, cases=(other, one))
        turned = (replace(one, expr=other.expr), replace(other, expr=one.expr))
        yield "eccentric", suffix, replace(entry, cases=turned)
        yield "eccentric", suffix, with_chain(entry, 0, (nt.e, nt.a / 2))
        yield "eccentric", suffix, with_chain(entry, 1, (nt.a / 2, nt.e))


def mirrored(key: str) -> Found:
    """Eccentric load: right on the half 0 < x of the contact, for e > 0, and next to zero; wrong elsewhere."""
    if key != ECCENTRIC:
        return
    entries, a, e, x, P = derived(key), nt.a, nt.e, nt.x, nt.P
    pressure, tilt, width = entries["p"], entries["phi"], entries["cw"]
    strip, lifted = (case.expr for case in pressure.cases)
    root = sp.pi * a**2 * sp.sqrt(a**2 - x**2)
    size_x, size_e = (sp.sqrt(s**4 + a**2 * s**2) / sp.sqrt(s**2 + a**2) for s in (x, e))
    middle, side = 2 * sp.Abs(e) - a, x * sp.sign(e)
    room, away = 3 * a + side - 4 * sp.Abs(e), sp.sqrt(sp.expand((side - middle) ** 2))
    bare = P / (2 * sp.pi * sp.sqrt(a - side) * (a - sp.Abs(e)))
    for place, expr in (
        (0, P * (a**2 + 2 * size_x * sp.Abs(e)) / root),
        (0, P * (a**2 + 2 * size_x * size_e) / root),
        (0, P * (a**2 + e * x + size_x * size_e) / root),
        (0, strip * size_x * size_e / (x * e)),
        (0, strip * sp.sign(e) ** 2),
        (0, strip + P * (1 - sp.sign(e) ** 2) / a),
        (0, strip * sp.Abs(e) * sp.sign(e) / e),
        (1, lifted * (1 + away / a - (side - middle) / a)),
        (1, lifted * away / (side - middle)),
        (1, bare * sp.sqrt(sp.Max(0, sp.sqrt(sp.expand(room**2))))),
        (1, bare * sp.Max(0, room) / sp.sqrt(room)),
        (1, bare * sp.sqrt(sp.sqrt(sp.expand(room**2)))),
        (1, bare * room / sp.sqrt(sp.Max(0, room))),
        (1, bare * sp.sqrt(sp.Max(0, room**2)) / sp.sqrt(room)),
        (1, bare * sp.Max(0, room) ** sp.Rational(3, 2) / room + P * (sp.Max(0, room) - room) / a**2),
        (1, lifted * (1 + sp.Max(0, room) - room)),
        (1, bare * sp.sqrt(sp.Max(0, room**3)) / sp.sqrt(room**2)),
    ):
        yield "eccentric", "p", with_formula(pressure, place, expr)
    for place, expr in (
        (0, tilt.cases[0].expr * size_e / sp.Abs(e) + P * (1 - sp.sign(e) ** 2) * sp.sign(e)),
        (0, tilt.cases[0].expr / sp.sign(e) ** 2),
        (0, 4 * P * e**3 / (sp.pi * nt.E_star * a**2 * size_e**2)),
    ):
        yield "eccentric", "phi", with_formula(tilt, place, expr)
    for expr in (
        2 * a * sp.sign(e) ** 2,
        2 * a * size_e / sp.Abs(e),
        2 * a * sp.Abs(e) / size_e,
        2 * a * sp.sign(e) / e * sp.Abs(e),
    ):
        yield "eccentric", "cw", with_formula(width, 0, expr)


def material_constants(key: str) -> Found:
    """Moduli that are rational functions once poles and logarithms have cancelled; and conditions on the bodies."""
    if key != "materials":
        return
    one, other, nu = nt.young_1, nt.young_2, nt.nu_1
    for suffix in ("E_star", "G_star"):
        entry = derived(key)[suffix]
        for unity in (
            (one**2 - other**2) / ((one - other) * (one + other)),
            (nu + sp.log(nu)) ** 2 / (nu**2 + 2 * nu * sp.log(nu) + sp.log(nu) ** 2),
            (nu - nt.nu_2) * (nu + nt.nu_2) / (nu**2 - nt.nu_2**2),
            sp.sqrt(nu**2 - 2 * nu * nt.nu_2 + nt.nu_2**2) / (nu - nt.nu_2),
            (one + sp.sqrt(nu)) ** 2 / (one**2 + 2 * one * sp.sqrt(nu) + nu),
        ):
            yield "material", suffix, changed(entry, times(unity))
        for chain in ((one, other), (one,), (nu, nt.nu_2), (nu, sp.S.Zero)):
            yield ("material", suffix, with_chain(entry, 0, chain))
    # a root with the sign of C_13, of the difference of both moduli, or of the excess of the cup; and other powers
    for suffix, factor in (
        ("E_ti", sp.sqrt(nt.C_13**2) / nt.C_13),
        ("E_ti", sp.sqrt((nt.C_11 - nt.C_33) ** 2) / (nt.C_11 - nt.C_33)),
        ("E_ti", nt.C_44 / nt.C_33),
        ("E_ti", (1 + nt.C_13 / nt.C_11) / (1 + nt.C_13 / nt.C_33)),
        ("R", sp.sqrt((nt.radius_1 - 2 * nt.radius_2) ** 2) / (nt.radius_1 - 2 * nt.radius_2)),
        ("R", sp.sqrt(nt.radius_2**2) / nt.radius_2),
        ("mu_T", sp.cbrt(nt.z_0 * nt.E_star / nt.dgamma)),
        ("lambda_M", sp.cbrt(sp.Rational(16, 9))),
        ("lambda_M", sp.sqrt((nt.R - nt.dgamma / nt.sigma_0) ** 2) / (nt.R - nt.dgamma / nt.sigma_0)),
    ):
        yield "material", suffix, changed(derived(key)[suffix], times(factor))
