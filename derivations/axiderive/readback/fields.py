"""The numbers below the surface, read back: letters beside complex numbers, formulas beside the entries.

The letters are those of the flat punch, zeta = z + i a, rho**2 = r**2 + zeta**2, q = rho + zeta: here as they stand,
without oblate coordinates.  A formula in letters has the value of the entry of a profile that is made of one slope, the
sum of a profile that of its own entries, where every part has the value of its formula in print.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import evaluate
from ..oracle.shape import number
from ..profiles.pools import ROUND
from ..rows import fields
from ..rows.blocks import texts_of
from ..rows.fields import FieldRow
from .claims import DIGITS, WORKING, Claim, Line, Stored, Values, named, value
from .grammar import read

POINT: Values = {
    nt.r: sp.Rational(13, 17), nt.z: sp.Rational(7, 11), nt.a: sp.Rational(15, 13), nt.theta: sp.Rational(2, 7),
    nt.R: sp.Rational(19, 5), nt.A: sp.Rational(11, 9), nt.h: sp.Rational(3, 8), nt.d: sp.Rational(5, 4),
}  # fmt: skip
"""Below the contact, the edge of every face in contact."""
INDICES = range(9)
"""Of the letters: the third order of t**5 takes five orders above it."""


def letters(radius: Any, r: Any, z: Any, order: int) -> dict[str, Any]:
    """What every letter is for a contact of a radius, those with m as index for this order."""
    zeta = mp.mpc(z, radius)
    rho = mp.sqrt(r * r + zeta * zeta)
    q = rho + zeta
    centre = mp.hypot(r, z)
    # int_0^a dt/rho is the angle of q less i times the logarithm
    logarithm = mp.log(abs(q) / (z + centre))
    found = {
        "varrho": centre, "delta": abs(rho) ** 2, "xi": mp.re(rho), "eta": mp.im(rho), "omega": mp.arg(q),
        "q": r / (z + centre), "chi": abs(r / q), "Lambda": logarithm, "a": radius, "r": r, "z": z, "m": mp.mpf(order),
    }  # fmt: skip
    for m in INDICES:
        turned = (r / q) ** m
        kernel = turned / rho
        lost = (zeta + m * rho) * kernel / rho**2
        values = (mp.re(turned), -mp.im(turned), mp.re(kernel), -mp.im(kernel), -mp.im(lost))
        own = dict(zip("csxyv", values, strict=True))
        index = {order - 1: "m-1", order: "m", order + 1: "m+1"}.get(m)
        found |= {f"{letter}_{i}": known for letter, known in own.items() for i in (m, index) if i is not None}
    return found


def _at(order: int) -> dict[str, Any]:
    """The letters at the point, and the lengths of the profiles."""
    radius, r, z = (number(POINT[s]) for s in (nt.a, nt.r, nt.z))
    return named(POINT) | letters(radius, r, z, order)


def _several(place: str, tex: str, claims: list[list[Claim]]) -> Line:
    """A line of formulas side by side, each with all that it has to say."""

    def wrong(text: str) -> bool:
        texts = texts_of(text)
        pairs = zip(texts, claims, strict=True) if len(texts) == len(claims) else ()
        return len(texts) != len(claims) or any(own.wrong(one) for one, of in pairs for own in of)

    return Line(place, tex, wrong)


def numbers(stored: Stored) -> list[Line]:
    """All rows of the sections on the numbers."""
    with mp.workdps(WORKING):
        return [*_rows(stored), *sums(stored), _several("any profile", fields.EVERY, [list(_of_any(stored))])]


def _rows(stored: Stored) -> Iterator[Line]:
    """Letters and formulas, in the order of the book."""
    known = _at(2)
    for title, tex in fields.shorthands():
        names = [read(one)[0].members[0].name for one in texts_of(tex)]
        without = [{letter: own for letter, own in known.items() if letter != name} for name in names]
        yield _several(title, tex, [[Claim(env, known[n], n)] for env, n in zip(without, names, strict=True)])
    for n in fields.SLOPES:
        for line in fields.lines(n):
            place = f"slope {n}: {line[0].left}"
            yield _several(place, fields.beside(line), [list(_of(one, n, stored)) for one in line])


def _of(one: FieldRow, n: int, stored: Stored) -> Iterator[Claim]:
    """A formula of a slope: the entry of the profile that has no other, over its share."""
    name, share = _made_of(n)
    entries = stored(f"{name}.sub")
    for order, suffix in enumerate(one.suffixes, (*one.orders, 0)[0]):
        left = read(f"{one.left}=0")[0].members[0].name
        yield Claim(_at(order), _value(entries[suffix], share), left)


def _made_of(n: int) -> tuple[str, sp.Expr]:
    """A profile of one slope, with its share."""
    return next((name, own[n]) for name in ROUND.names if set(own := fields.parts(ROUND.load(name))) == {n})


def _value(entry: Entry, share: sp.Expr = sp.S.One) -> Any:
    """An entry at the point, in the last of its cases, over a share."""
    return evaluate(entry.cases[-1].expr, POINT, DIGITS) / evaluate(share, POINT, DIGITS)


def printed(n: int, suffix: str, known: Mapping[int, Mapping[str, Any]]) -> Any:
    """What the book gives for a number of a slope, with the letters by order."""
    (one,) = (one for one in fields.numbers(n) if suffix in one.suffixes)
    order = int(suffix[1:] or 0)
    return value(one.region.tex, known[order])


def sums(stored: Stored) -> Iterator[Line]:
    """What profiles are made of, number by number."""
    known = {order: _at(order) for order in range(4)}
    for name in filter(lambda name: fields.parts(ROUND.load(name)), ROUND.names):
        own = fields.parts(ROUND.load(name))
        claims = []
        for suffix, entry in stored(f"{name}.sub").items():
            parts = {f"N_{n}": printed(n, suffix, known) for n in own}
            claims.append(Claim(named(POINT) | parts, _value(entry), "N"))
        yield _several(name, fields.total(own), [claims])


def _of_any(stored: Stored) -> Iterator[Claim]:
    """Of a face with an edge: its slope and the depth at the edge as the parts have them."""
    own = fields.parts(ROUND.load("concave_quartic"))
    shares = {n: evaluate(share, POINT, DIGITS) for n, share in own.items()}
    (power,) = shares.keys() - {0}
    r, z = number(POINT[nt.r]), number(POINT[nt.z])
    entries = stored("concave_quartic.sub")
    # S_0 and D_3: a second takes as long as the integral of one of them
    for suffix in [*entries][::7]:
        order = int(suffix[1:])

        def punch(t: Any, order: int = order, suffix: str = suffix) -> Any:
            return printed(0, suffix, {order: letters(t, r, z, order)})

        names = named(POINT) | {
            "N_0()": punch,
            "g'()": lambda t: shares[power] * t ** (power - 1),
            "g()": lambda t: shares[power] * t**power / power,
        }
        yield Claim(names, _value(entries[suffix]), "N")
