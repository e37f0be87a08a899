"""Fields below the surface straight from the transform of the pressure: integrals over the wave number of what remains
of each wave at a depth.

P(k) = int_0^a (d - g(t)) cos(k t) dt with the depths g of the definition, then the integrals over k of
k**(1, 2, 0) P(k) exp(-k z) J_m(k r).  Neither a flat punch nor the slope g' enters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

import mpmath as mp
from flint import arb

from .. import notation as nt
from .half_space import HalfSpace
from .integrals import Homogeneous
from .rules import Rule, at_working_precision, ball, gauss_rule, integrate, middle
from .shape import Number, Shape

Share = tuple[arb, arb]
PARTS = 4
"""Panels of a stretch of the profile at least, for the sake of the waves."""
TURNS, ORDER = 24.0, 44
"""Radians of a wave in a panel of wave numbers, and its nodes."""


def numbers(contact: HalfSpace, shares: Sequence[Share] = ()) -> dict[str, Number]:
    """S0 ... S3, D0 ... D3 and W at the place r, z of a contact, to about its digits where z is of the size of a.

    Its `shares` are those of `pressed`, which all places have in common.
    """
    digits = contact.digits
    with mp.workdps(digits + 20), at_working_precision():
        r, z = contact.at(nt.r), contact.at(nt.z)
        a, _ = contact.contact(contact.at(nt.a))
        shares = shares or pressed(contact)
        highest = (digits + 6) * mp.log(10) / z
        panels = int(mp.ceil(highest * (a + r) / TURNS))
        zero, one = arb(0), arb(1)
        total = {name: zero for name in (*(f"{x}{m}" for x in "SD" for m in range(4)), "W")}
        rule = [(ball(x), ball(w)) for x, w in gauss_rule(ORDER, int(mp.mp.prec))]
        width, place, depth = ball(highest / panels), ball(r), ball(z)
        for i in range(panels):
            for x, weight in rule:
                k = (i + x) * width
                transform = sum((w * (k * t).cos() for t, w in shares), zero)
                wave = weight * width * transform * (-k * depth).exp()
                for m in range(4):
                    surface = wave * k * (k * place).bessel_j(arb(m) * one)
                    total[f"S{m}"] += surface
                    total[f"D{m}"] += surface * k * depth
                total["W"] += wave * (k * place).bessel_j(zero)
        return {name: middle(value) for name, value in total.items()}


def pressed(contact: HalfSpace) -> list[Share]:
    """Radii up to the edge, and weights times what a punch of the radius is pressed in by."""
    with mp.workdps(contact.digits + 20), at_working_precision():
        return [*_pressed(contact, *contact.contact(contact.at(nt.a)))]


def _pressed(contact: HalfSpace, a: Number, free: Number | None) -> Iterator[Share]:
    whole = contact.face(a).shape
    depth = _depth(whole, a, contact.digits) if free is None else free
    for piece in whole.stretches:
        nodes: list[tuple[Number, Number]] = []

        def noted(f: object, rule: Callable[..., Rule], of: tuple[Any, ...], start: Number, length: Number) -> Number:
            nodes.extend((start + length * x, abs(length) * weight) for x, weight in rule(*of))  # noqa: B023
            return length

        singular = (0j, *(z - complex(piece.lo) for z in piece.singular))
        longest = float(piece.hi - piece.lo) / PARTS
        integrate(None, mp.mpf(0), piece.hi - piece.lo, singular, 2 * contact.digits, panel=noted, longest=longest)
        for away, weight in nodes:
            t = piece.lo + away
            yield ball(t), ball(weight * (depth - _depth(whole, t, contact.digits)))


def _depth(whole: Shape, t: Number, digits: int) -> Number:
    """g(t) of a face that a concave one keeps while the radius varies."""
    inside = tuple(replace(piece, hi=min(piece.hi, t)) for piece in whole.stretches if piece.lo < t)
    return Homogeneous(replace(whole, stretches=inside), mp.mpf(0), digits).depth(t)
