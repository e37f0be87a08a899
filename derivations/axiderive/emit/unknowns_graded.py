"""What the iteration of an inverse on the graded half-space solves for, and where it begins.

A radius is found from the depth and from the force in the same way, with other powers.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..notation import a, k
from .graded.families import Family, family
from .graded.normal import LIMITS
from .printer import Printer
from .unknowns import (
    BOTH,
    END,
    FIRST,
    JOINT,
    LAST,
    LEADING,
    LOADS,
    NAMES,
    NEXT,
    SHARE,
    Equation,
    T,
    Unknown,
    X,
    is_worth,
    load_of,
    smooth,
)

SHARP = sp.Rational(3, 10)
"""First powers of a load next to an edge from which on the unknown has a bend; below it is another one."""
BENT, JOINED = rf"k\ge {float(SHARP - 1):g}", rf"k< {float(SHARP - 1):g}"
READ = -4
"""The power of ten at which the terms of a load beyond a break are read: CLOSE of the runtime."""


def graded_unknowns(entries: Mapping[str, Entry]) -> Iterator[Unknown]:
    """Of a compact contact on the graded half-space; none for a power law, whose inverse is closed."""
    own = family(entries["d"].profile)
    if own.power is not None:
        return
    profile = own.profile
    lengths = [*profile.parameters, *(symbol for symbol, _ in profile.abbreviations)]
    if own.has("gaussian"):
        yield from (_on_the_bump(entries, lengths[-1], suffix) for suffix in BOTH)
    elif not own.root:
        yield smooth(next((sp.Rational(3, 2) * x for x in lengths if x in (nt.b, nt.wavelength)), sp.S.One))
    elif profile.truncated:
        yield from (_beyond(entries, own, suffix) for suffix in BOTH)
        if own.terms[0].shape in ("flank", "rim"):
            yield from (_joined_beyond(own, suffix) for suffix in BOTH)
    elif own.has("sphere"):
        yield from (_below(entries, profile.chain[-1], suffix) for suffix in BOTH)
    else:
        yield from _across(entries, own)


def _named(suffix: str, place: str) -> str:
    """The load at a radius: g(b)."""
    return LOADS[suffix][1].replace("(a)", f"({place})")


def _worth(entries: Mapping[str, Entry], suffix: str, radius: sp.Expr) -> sp.Expr:
    """The load at a radius, from the formula for the smallest radii."""
    return entries[LOADS[suffix][0]].cases[0].expr.subs(a, radius)


def _tip(suffix: str) -> sp.Expr:
    """The power of the radius that the load of a round tip is."""
    return sp.Integer(2) if suffix == "ad" else 3 + k


def _on_the_bump(entries: Mapping[str, Entry], s: sp.Expr, suffix: str) -> Unknown:
    """The share of the height of the bump, with that of the last radius moved to infinity."""
    unknown, share = is_worth("t", X / (1 - X / LAST)), is_worth("x", 1 - sp.exp(-(a**2) / s**2))
    last = is_worth("x_1", 1 - sp.exp(-(END**2) / s**2))
    top, (_, _, load, name) = _worth(entries, suffix, END), LOADS[suffix]
    begins = rf"x_1 \sqrt{{\frac{{{name}}}{{{_named(suffix, 'a_1')}-{name}}}}}"
    start = Equation("t_0", begins, LAST * sp.sqrt(load / (top - load)))
    ends = Equation("g'(a_1)", "0", sp.S.Zero)
    return Unknown("t", (suffix,), "", (load_of(suffix), unknown, share, last, ends, start))


def _powers(shape: str, suffix: str) -> tuple[sp.Expr, sp.Expr]:
    """With which powers of the root the load of a flat face begins and ends."""
    first, last = LIMITS[shape]
    begins = sp.Integer(int(float(first.removesuffix(" + k"))))
    return begins + k, sp.Integer(int(last)) + (1 + k if suffix == "aF" else 0)


def _beyond(entries: Mapping[str, Entry], own: Family, suffix: str) -> Unknown:
    """A radius beyond a flat face, over a length that grows like the load at both ends."""
    (term,) = own.terms
    first, last = _powers(term.shape, suffix)
    b = own.profile.breaks[0]
    place, (_, _, load, name) = is_worth("a", b * sp.sqrt(1 + T**2)), LOADS[suffix]
    one, shown = (sp.S.One, name) if first == last else (LAST, f"x_1 {name}")
    begins = rf"\frac{{{shown}}}{{{_named(suffix, rf'{Printer()(sp.sqrt(2))} {b}')}}}"
    start = Equation("x_0", begins, one * load / _worth(entries, suffix, sp.sqrt(2) * b))
    remark = "" if first == last else "$x_1$ at $t=1$"
    small = BENT if first == 1 + k else ""
    equations = (load_of(suffix), place, _bent("t", first, last), start)
    return Unknown("x", (suffix,), small, equations, remark)


def _bent(left: str, first: sp.Expr, last: sp.Expr) -> Equation:
    """x**(1/first) below one and x**(1/last) beyond it, joined without a kink."""
    printer = Printer()
    if first == last:
        return is_worth(left, X ** (1 / first))
    value = sp.sqrt(sp.Max(X, 1) ** (2 / last) - 1 + first / last) * sp.Min(X, 1) ** (1 / first)
    far = rf"\max(x,1)^{{{printer.exponent(2 / last)}}}" if last != 2 else r"\max(x,1)"
    near = rf"\min(x,1)^{{{printer.exponent(1 / first)}}}" if first != 1 else r"\min(x,1)"
    above, below = sp.fraction(sp.together(first / last - 1))
    share = printer(abs(above) if above.is_number else above)
    rest = share if below == 1 else rf"\frac{{{share}}}{{{printer(below)}}}"
    return Equation(left, rf"{near} \sqrt{{{far}{'-' if above.is_negative else '+'}{rest}}}", value)


def _joined_beyond(own: Family, suffix: str) -> Unknown:
    """The length instead where the first power is so small that its bend would be sharp."""
    (term,) = own.terms
    return Unknown("x", (suffix,), JOINED, (_joined(T, *_powers(term.shape, suffix)),), half=True)


def _joined(t: sp.Symbol, first: sp.Expr, last: sp.Expr) -> Equation:
    value = t**first * (1 + t**2) ** sp.cancel((last - first) / 2)
    return Equation("x", Printer(names=NAMES)(value), value)


def _below(entries: Mapping[str, Entry], end: sp.Expr, suffix: str) -> Unknown:
    """A radius below the one of a vertical flank, over a length that ends like the load there, for either sign of k."""
    tip, (_, _, load, name) = _tip(suffix), LOADS[suffix]
    place = is_worth("a", end * T / sp.sqrt(1 + T**2))
    power = Printer(names=NAMES)(1 + T**tip)
    exponent = Printer().exponent(-k / tip)
    like = Equation("x", rf"\frac{{1-({power})^{{{exponent}}}}}{{k}}", (1 - (1 + T**tip) ** (-k / tip)) / k)
    start = load / (2 * _worth(entries, suffix, FIRST))
    begins = Equation("x_0", rf"\frac{{{name}}}{{2 {_named(suffix, 'a_0')}}}", start)
    remark = r"$a_0$ at $x=\tfrac{1}{2}$"
    return Unknown("x", (suffix,), "", (load_of(suffix), place, like, begins), remark)


def _across(entries: Mapping[str, Entry], own: Family) -> Iterator[Unknown]:
    """Below a break, where a parabolic tip is met at once, and beyond it, where the excess begins as a power."""
    b, (end, *_) = own.profile.breaks[0], own.profile.parameters
    bends = any(LIMITS.get(term.shape, ("",))[0] == "1.0 + k" for term in own.terms)
    if own.has("tipped"):
        yield Unknown("x", BOTH, f"a<{b}", (_like_the_tip("x", a, end), _like_the_tip("x_1", b, end)))
    for suffix in BOTH:
        text, value = _share(entries, b, suffix)
        if own.has("tipped"):
            letter, begins = "x", Equation("x_0", f"x_1 {text}", LAST * value)
        else:
            letter, begins = "a", Equation("a", f"{b} {text}", b * value)
        yield Unknown(letter, (suffix,), f"a<{b}", (begins,), half=True)
    if not own.has("tipped") and not bends:
        yield Unknown("t", BOTH, f"a>{b}", (is_worth("a", b * sp.sqrt(1 + T**2)),), "start at one")
        return
    least = 1 + k if bends else sp.S.One
    for suffix in BOTH:
        yield _in_excess(entries, b, least, suffix)
    yield Unknown("x", BOTH, BENT if bends else f"a>{b}", (_bent("y", least, sp.Integer(2)),))
    if bends:
        yield Unknown("x", BOTH, JOINED, (_joined(SHARE, least, sp.Integer(2)),))


def _share(entries: Mapping[str, Entry], b: sp.Symbol, suffix: str) -> tuple[str, sp.Expr]:
    """The load over that of the break, to the inverse of the power of a round tip."""
    tip, (_, _, load, name) = _tip(suffix), LOADS[suffix]
    ratio = rf"\frac{{{name}}}{{{_named(suffix, str(b))}}}"
    text = rf"\sqrt{{{ratio}}}" if tip == 2 else rf"\Bigl[{ratio}\Bigr]^{{{Printer().exponent(1 / tip)}}}"
    return text, (load / _worth(entries, suffix, b)) ** (1 / tip)


def _like_the_tip(name: str, place: sp.Symbol, end: sp.Expr) -> Equation:
    v = sp.atanh(place / end)
    return Equation(name, rf"\frac{{1-\exp(-k {Printer()(v)})}}{{k}}", (1 - sp.exp(-k * v)) / k)


def _in_excess(entries: Mapping[str, Entry], b: sp.Symbol, least: sp.Expr, suffix: str) -> Unknown:
    """What the load exceeds that of the break by is c t**least + C t**2, read close to the break."""
    (_, whole, load, name), base = LOADS[suffix], _named(suffix, str(b))
    power = "" if least == 1 else f"^{{{Printer()(least)}}}"
    place = is_worth("a", b * sp.sqrt(1 + JOINT**2 * SHARE**2))
    exponent = Printer().exponent(1 / (2 - least))
    ratio = r"\frac{c}{C}" if least == 1 else rf"\Bigl(\frac{{c}}{{C}}\Bigr)^{{{exponent}}}"
    meet = Equation("t_1", ratio, (LEADING / NEXT) ** (1 / (2 - least)))
    value = (load - _worth(entries, suffix, b)) / (NEXT * JOINT**2)
    start = Equation("x_0", rf"\frac{{{name}-{base}}}{{C t_1^{{2}}}}", value)
    remark = f"${whole}-{base}\\approx c\\,t{power}+C\\,t^2$ in value and slope at $t=t_1 y=10^{{{READ}}}$"
    if suffix == "aF":
        remark += f"; a $t_0>1$ is raised to ${Printer().exponent(2 / _tip(suffix))}$"
    return Unknown("x", (suffix,), f"a>{b}", (load_of(suffix), place, meet, start), remark)
