"""Fields in print as the generated code sums them: by the kernel of a power, over a threshold, over a circle."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any

import sympy as sp

from .. import notation as nt
from ..contact.medium import HOMOGENEOUS
from ..entry import Entry
from ..notation import E_star, a, d, p_0, psi, r
from ..profiles.loads import Load
from ..profiles.profile import Profile
from ..stable import opaque
from ..stable.forms import evaluation_form
from ..stable.signs import facts_of
from .compact import monomial
from .complete import excess_over_threshold, sunk_power
from .evaluated import SPELLED, Rows, evaluation_row, form_of, printed
from .height import bracket
from .kernels import beside_power
from .naming import LEFT
from .printer import Printer
from .ranges import Pairs, chain_of, condition, regions
from .rows import Region, broken
from .shorthand import LINE
from .width import width

ROOT_INSIDE, ROOT_OUTSIDE = r"\sqrt{(a-r) (a+r)}", r"\sqrt{(r-a) (r+a)}"
ANGLE = rf"\psi=\arctan \frac{{a}}{{{ROOT_OUTSIDE}}}"


def field_rows(profile: Profile, entries: Mapping[str, Entry]) -> Rows:
    """Rows of the fields that are not the evaluation form of their entry."""
    if isinstance(profile, Load):
        return list(_of_load(profile, entries))
    if profile.contact == "compact":
        return list(_beside(profile, entries))
    return list(_capped(entries) if entries["F"].partial is not None else _concave(profile, entries))


@cache
def beside(n: int) -> sp.Expr:
    """pi/2 w/g(a) beside a contact whose depth is the n-th power of its radius, of psi = arcsin(a/r)."""
    if n == 1:  # (1 - cos psi)/sin psi
        return psi - sp.tan(psi / 2)
    sine, cosine = sp.symbols("sine cosine", positive=True)
    punches = sp.expand((psi - beside_power(n, psi, sine, cosine)) * sine**n)
    turns = punches.coeff(psi)
    waves = sp.factor_terms(sp.cancel((turns * psi - punches) / (sine * cosine)))
    common = sp.ilcm(sp.denom(turns), sp.denom(waves.as_coeff_Mul()[0]))
    inside = common * turns * psi - sine * cosine * sp.expand(common * waves)
    return psi - (inside / (common * sine**n)).xreplace({sine: sp.sin(psi), cosine: sp.cos(psi)})


def _row(entry: Entry, pairs: Pairs, chain: tuple[sp.Expr, ...], value: sp.Expr, angle: str) -> Rows:
    """The value in lines that fit, with its angle behind it."""
    printer = Printer(chain, {psi: r"\psi"})
    lines = broken(f"{LEFT[entry.suffix]}=", value, printer)
    if angle and width(lines[-1] + r",\qquad " + angle) <= LINE:
        lines[-1] += r",\qquad " + angle
    elif angle:
        lines[-1] += ","
        lines.append(r"\qquad " + angle)
    region = Region(condition(entry, pairs, chain, Printer(chain)), tuple(lines))
    return [evaluation_row(entry, region)]


def _beside(profile: Profile, entries: Mapping[str, Entry]) -> Iterator[dict[str, Any]]:
    """The displacement of a power, through its kernel."""
    entry, found = entries["w"], None if profile.breaks else monomial(entries["d"].cases[0].expr)
    if found is None:
        return
    depth, n = found
    ((pairs, expr),) = regions(entry)
    chain = chain_of(entry, expr)
    if form_of(entry, expr, chain).cancels:
        yield from _row(entry, pairs, chain, HOMOGENEOUS.displacement_scale * depth * beside(n), ANGLE)


def _capped(entries: Mapping[str, Entry]) -> Iterator[dict[str, Any]]:
    """The face up to its own radius, and beyond the edge a punch sunk by the excess of the depth."""
    partial = entries["F"].partial
    assert partial is not None
    rho = entries["F"].cases[0].chain[0]
    stiffness, whole = entries["k"].cases[-1].expr, entries["F"].cases[-1].expr
    depth = sp.expand(d - (whole - partial.cases[0].expr) / stiffness)
    found = monomial(depth)
    if found is None:
        return
    pairs, expr = regions(entries["F"])[-1]
    force = partial.cases[0].expr + stiffness * (d - depth)
    yield from _row(entries["F"], pairs, chain_of(entries["F"], expr), force, "")
    scale, kernel = HOMOGENEOUS.displacement_scale, beside(found[1])
    for (pairs, expr), angle, value in zip(
        regions(entries["w"]),
        (Printer()(sp.Eq(psi, sp.atan(rho / sp.sqrt(r**2 - rho**2)))), ANGLE),
        (scale * d * kernel, scale * (depth * kernel + (d - depth) * psi)),
        strict=True,
    ):
        yield from _row(entries["w"], pairs, chain_of(entries["w"], expr), value, angle)


def _concave(profile: Profile, entries: Mapping[str, Entry]) -> Iterator[dict[str, Any]]:
    """The pressure over the depth of first contact of the whole face; the displacement as an integral."""
    if "dmin" not in entries:
        return
    ((pairs, expr),) = regions(entries["p"])
    chain, face = chain_of(entries["p"], expr), excess_over_threshold(entries)
    if face is None:
        lines = printed(LEFT["p"], evaluation_form(expr, facts_of(chain)), chain)
        yield evaluation_row(entries["p"], Region(condition(entries["p"], pairs, chain, Printer(chain)), tuple(lines)))
    else:
        inside = f"d-{LEFT['dmin']}+{Printer()(face)}"
        scale = rf"\frac{{{Printer()(E_star)}}}{{\pi {ROOT_INSIDE}}}"
        where = f"{LEFT['dmin']}={Printer()(entries['dmin'].cases[0].expr)}"
        tex = rf"{LEFT['p']}={scale} \, {bracket(inside)},\qquad {where}"
        yield evaluation_row(entries["p"], Region(condition(entries["p"], pairs, chain, Printer(chain)), (tex,)))
    ((pairs, expr),) = regions(entries["w"])
    chain = chain_of(entries["w"], expr)
    if evaluation_form(expr, facts_of((a, r))).cancels:
        sunk, n = sunk_power(entries)
        value = HOMOGENEOUS.displacement_scale * (d * psi + sunk * SPELLED[opaque.PowerPunches](r, a, n))
        yield from _row(entries["w"], pairs, chain, value, ANGLE)


def _of_load(load: Load, entries: Mapping[str, Entry]) -> Iterator[dict[str, Any]]:
    """The integrals of positive terms that the module sums over the circle."""
    entry, exponent = entries["w"], sp.sympify(load.exponent)
    for pairs, expr in regions(entry):
        chain = chain_of(entry, expr)
        inside = chain[0] == r
        value, angle = _over_circle(exponent, inside)
        if value is not None:
            yield from _row(entry, pairs, chain, value, angle)


def _over_circle(s: sp.Expr, inside: bool) -> tuple[sp.Expr | None, str]:
    scale, quarter = p_0 * a / E_star, (psi, 0, sp.pi / 2)
    sine, cosine = sp.sin(psi), sp.cos(psi)
    if s == -sp.S.Half and not inside:
        return 2 * scale * psi, ANGLE
    if s == sp.S.Half and not inside:
        return scale * beside(2), ANGLE
    if s == 0 and not inside:
        mean = sp.Integral(cosine**2 / sp.sqrt(1 - a**2 / r**2 * sine**2), quarter)
        return 4 * scale * a / (sp.pi * r) * mean, ""
    if s == nt.sigma:
        weight = 2 / sp.pi * scale * sp.beta(sp.S.Half, s + 1)
        if inside:
            base = sine**2 + (1 - r**2 / a**2) * cosine**2
            return weight * sp.Integral(base ** (s + sp.S.Half), quarter), ""
        rest = sp.sqrt(sine**2 + r**2 / a**2 - 1)
        integral = sp.Integral(sine ** (2 * s + 2) / rest, quarter)
        return weight * integral, ""
    return None, ""
