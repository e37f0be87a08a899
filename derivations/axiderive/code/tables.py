"""The numbers and tables of the runtime as literals: nodes, kernels, domains of parameters.

Gauss-Legendre nodes and weights as literals: certified by Arb, rounded once to double precision.

The rational kernels of the runtime as literals: fitted to functions that cancel near zero.

The tables of parameters and their domains behind `require`, read off the notation.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from functools import cache, partial
from typing import Any

import mpmath as mp
import sympy as sp
from flint import arb, ctx, fmpq

from .. import notation as nt
from ..letters import name_of
from ..physics import normal
from ..profiles import load
from ..stable.kernels import fit
from ..stable.reference import share_of_peak
from .function import call


def gauss_legendre(count: int) -> list[tuple[float, float]]:
    """Nodes on (0, 1) in ascending order with their weights, for an even count."""
    precision, ctx.prec = ctx.prec, 160
    try:
        pairs = [arb.legendre_p_root(count, k, weight=True) for k in range(count)]
        half = arb(fmpq(1, 2))
        return sorted((float((1 + x) * half), float(weight * half)) for x, weight in pairs)
    finally:
        ctx.prec = precision


def nodes_source(counts: Sequence[int]) -> str:
    """The text of `nodes.py`."""
    lines = [
        '"""Gauss-Legendre nodes and weights on (0, 1), rounded from certified enclosures."""',
        "",
        "from __future__ import annotations",
        "",
        "from functools import cache",
        "from typing import Any",
        "",
        "import numpy as np",
        "",
        "# only the lower half, the rule is symmetric;",
        "# the weights of numpy.polynomial.legendre.leggauss are off by 6e-14 at 32 nodes and 1e-11 at 128",
        "_LOWER_HALVES = {",
    ]
    for count in counts:
        lines.append(f"    {count}: [")
        lines += [f"        ({node!r}, {weight!r})," for node, weight in gauss_legendre(count)[: count // 2]]
        lines.append("    ],")
    return "\n".join([*lines, *TAIL])


TAIL = (
    "}",
    "",
    "",
    "@cache",
    "def gauss_legendre(count: int) -> tuple[Any, Any]:",
    '    """Nodes and weights as arrays."""',
    "    nodes, weights = np.array(_LOWER_HALVES[count]).T",
    "    return np.concatenate([nodes, 1.0 - nodes[::-1]]), np.concatenate([weights, weights[::-1]])",
    "",
)


EXPONENTS = (1, 2, 4, 6)
"""Of r**n, for which the displacement beside the contact has a form of its own, from 2 on a kernel."""


def outside(n: int, v: mp.mpf) -> mp.mpf:
    """pi/2 w/g(a) over s = a/r for f ~ r**n, s = sin(x) and v = tan(x/2)**2: (x - int_0^x sin(t)**n dt/s**n)/s."""
    # next to v = 0 the difference loses (n + 1)/2 times the digits of v
    with mp.extradps(40):
        angle = 2 * mp.atan(mp.sqrt(v))
        return beside_power(n, angle, mp.sin(angle), mp.cos(angle)) / mp.sin(angle)


def beside_power(n: int, angle: Any, sine: Any, cosine: Any) -> Any:
    """pi/2 w/g(a) for f ~ r**n, of the angle arcsin(a/r) as numbers or as symbols."""
    punches = [angle, 1 - cosine]
    for k in range(2, n + 1):
        punches.append(((k - 1) * punches[k - 2] - sine ** (k - 1) * cosine) / k)
    return angle - punches[n] / sine**n


def root_gap(q: mp.mpf) -> mp.mpf:
    """(x - atan x)/q**1.5 with x**2 = q (q + 2)."""
    x = mp.sqrt(q * (q + 2))
    return (x - mp.atan(x)) / q**1.5


def tanh_gap(v: mp.mpf) -> mp.mpf:
    """(y - tanh y)/tanh(y)**3 over v = y**2."""
    with mp.extradps(20):
        y = mp.sqrt(v)
        return (y - mp.tanh(y)) / mp.tanh(y) ** 3


def dawson(v: mp.mpf) -> mp.mpf:
    """x/D(x) over v = x**2; D(x) over exp(-x**2) would take up the rounding of that."""
    x = mp.sqrt(v)
    return 2 * x * mp.exp(v) / (mp.sqrt(mp.pi) * mp.erfi(x))


STRUVE_END = mp.mpf(4)
"""Where the series in ascending powers ends; below the first zero of H_0."""


def struve(order: int, u: mp.mpf) -> mp.mpf:
    """H_nu(x)/x**(nu + 1) over u = 16 - x**2, in which all its derivatives are positive."""
    lead = mp.mpf(1) / 2 ** (order + 1) / (mp.gamma(mp.mpf(3) / 2) * mp.gamma(order + mp.mpf(3) / 2))
    return lead * mp.hyp1f2(1, mp.mpf(3) / 2, order + mp.mpf(3) / 2, (u - STRUVE_END**2) / 4)


def hankel(order: int, odd: bool, v: mp.mpf) -> mp.mpf:
    """Hankel's P, or |Q| x, over v = 16/x**2: J + i Y = sqrt(2/(pi x)) (P + i Q) exp(i (x - nu pi/2 - pi/4))."""
    x = STRUVE_END / mp.sqrt(v)
    wave = mp.besselj(order, x) + mp.j * mp.bessely(order, x)
    whole = wave * mp.sqrt(mp.pi * x / 2) * mp.expj((2 * order + 1) * mp.pi / 4 - x)
    return abs(whole.imag) * x if odd else whole.real


def struve_tail(order: int, v: mp.mpf) -> mp.mpf:
    """pi/2 (H_nu - Y_nu) x**(1 - nu) over v = 16/x**2."""
    x = STRUVE_END / mp.sqrt(v)
    with mp.extradps(30):
        return (mp.struveh(order, x) - mp.bessely(order, x)) * mp.pi / 2 * x ** (1 - order)


def legendre_chi(v: mp.mpf) -> mp.mpf:
    """chi(x)/x over v = x**2."""
    x = mp.sqrt(v)
    return (mp.polylog(2, x) - mp.polylog(2, -x)) / (2 * x) if v else mp.mpf(1)


def gamma_ratio(v: mp.mpf) -> mp.mpf:
    """Gamma(x + 1/2)/Gamma(x)/sqrt(w) over v = 1/w**2, w = x - 1/4 (Tricomi and Erdelyi 1951)."""
    w = 1 / mp.sqrt(v)
    return mp.gammaprod([w + mp.mpf(3) / 4], [w + mp.mpf(1) / 4]) / mp.sqrt(w)


def peak(top: float, v: mp.mpf) -> mp.mpf:
    """(r - b)/(a - b) (1 + x)/x for the radius r of the greatest pressure, over x = sqrt(b/a) = top - v."""
    equation, b = _balance()
    # at x = 0 there is no equation left; the share is constant up to x there, and x = 1 is no node
    x = max(top - v, mp.mpf(10) ** -20)
    share = share_of_peak(equation.lhs - equation.rhs, b, x * x)
    return mp.mpf(share.mid().str(60, radius=False)) * (1 + x) / x


ARC_END = 0.8
"""How far beyond the peak of the level of an arc its first kernel goes."""


def arc_level(y: Any) -> Any:
    """Psi of `physics/peak.py` at tanh(y): zero at 1.2 and at infinity, and equal at two places between them."""
    return (y * mp.tanh(y) - 1) / mp.cosh(y) ** 2


@cache
def arc_peak() -> mp.mpf:
    """Where that is greatest, the root of 3 tanh(y) = (3 tanh(y)**2 - 1) y."""
    with mp.workdps(80):
        return mp.findroot(lambda y: 3 * mp.tanh(y) - (3 * mp.tanh(y) ** 2 - 1) * y, 1.7)


@cache
def arc_bend() -> mp.mpf:
    """The level where the first kernel ends."""
    with mp.workdps(80):
        return arc_level(arc_peak() + ARC_END)


def arc_near(v: mp.mpf) -> mp.mpf:
    """How far the place of an equal level lies below that at v beyond the peak, over v."""
    y = arc_peak() + v
    return (y - _place_of(arc_level(y))) / v


def arc_far(v: mp.mpf) -> mp.mpf:
    """The place over what the level falls short of that where the first kernel ends."""
    return _place_of(arc_bend() - v)


def _place_of(level: mp.mpf) -> mp.mpf:
    return mp.findroot(lambda y: arc_level(y) - level, (1.19, arc_peak()), solver="anderson", verify=False)


@cache
def _balance() -> tuple[sp.Equality, sp.Symbol]:
    """The certified equation of that radius, and the radius of the flat face."""
    entry = normal.derive(load("rounded_punch"))["rp"]
    return entry.cases[0].expr, entry.profile.breaks[0]


POLYNOMIALS = ("LEGENDRE_CHI",)
"""Kernels whose difference quotient is wanted too."""
KERNELS: dict[str, tuple[str, Callable[[mp.mpf], mp.mpf], float]] = {
    "ARCTAN_GAP": ("(x - atan x)/x**3, x**2 <= 1", lambda v: (mp.sqrt(v) - mp.atan(mp.sqrt(v))) / v**1.5, 1.0),
    "ROOT_GAP": ("(x - atan x)/q**1.5 with x**2 = q (q + 2), q <= 0.42", root_gap, 0.42),
    "TANH_GAP": ("(y - tanh y)/tanh(y)**3 over y**2 <= 1", tanh_gap, 1.0),
    "LEGENDRE_CHI": ("chi(x)/x with chi(x) = x + x**3/9 + x**5/25 + ..., x**2 <= 0.49", legendre_chi, 0.49),
    "PEAK_SMALL": (
        "(r - b)/(a - b) (1 + x)/x of the greatest pressure over 1/2 - x, x = sqrt(b/a)",
        lambda v: peak(0.5, v),
        0.5,
    ),
    "PEAK_LARGE": ("the same over 1 - x, x >= 1/2", lambda v: peak(1.0, v), 0.5),
    "ARC_NEAR": ("the difference of two y of equal (y tanh(y) - 1)/cosh(y)**2 over y - 1.71792", arc_near, ARC_END),
    "ARC_FAR": ("the lesser y over what that level falls short of its value at 2.51792", arc_far, float(arc_bend())),
    "DAWSON": ("x/D(x), x <= 25/16", dawson, (25 / 16) ** 2),
} | {
    name: (words, function, end)
    for nu in (0, 1)
    for name, words, function, end in (
        (f"STRUVE_{nu}", f"H_{nu}(x)/x**{nu + 1} over 16 - x**2, x <= 4", partial(struve, nu), 16.0),
        (f"HANKEL_P_{nu}", f"P of Y_{nu}(x) over 16/x**2, x >= 4", partial(hankel, nu, False), 1.0),
        (f"HANKEL_Q_{nu}", f"|Q| x of Y_{nu}(x) over 16/x**2, x >= 4", partial(hankel, nu, True), 1.0),
        (
            f"STRUVE_TAIL_{nu}",
            f"pi/2 (H_{nu} - Y_{nu}) x**{1 - nu} over 16/x**2",
            partial(struve_tail, nu),
            1.0,
        ),
    )
}
"""By name: what is fitted as a function of the square v of its argument, in words and in mpmath, and up to which v."""


STARTS: dict[str, tuple[str, Callable[[mp.mpf], mp.mpf], float, mp.mpf]] = {
    "GAMMA_RATIO": (
        "Gamma(x + 1/2)/Gamma(x)/sqrt(w) over 1/w**2, w = x - 1/4, x >= 2", gamma_ratio, 16 / 49, mp.mpf(1)
    ),
    **{
        f"OUTSIDE_{n}": (
            f"displacement beside a contact with r**{n} over tan(asin(a/r)/2)**2", partial(outside, n), 1.0,
            mp.mpf(n) / (n + 1),
        )
        for n in EXPONENTS[1:]
    },
}  # fmt: skip
"""The same of which the value at v = 0 is most: what is fitted is the rest over v."""


@cache
def kernels_source() -> str:
    """The text of `kernels.py`."""
    lines = [
        '"""Rational kernels P(v)/Q(v) as coefficients in ascending order, near-minimax to half a unit of a double."""',
        "",
        "from __future__ import annotations",
    ]
    for name, (words, function, end) in KERNELS.items():
        kernel = fit(function, end, name in POLYNOMIALS)
        lines += ["", f"# {words}", f"{name} = ("]
        for numbers in (kernel.top, kernel.bottom):
            lines += _column(numbers)
        lines.append(")")
    for name, (words, function, end, start) in STARTS.items():
        share = 1 - start / function(mp.mpf(end))
        kernel = fit(partial(_rest, function, start), end, share=share)
        lines += ["", f"# {words}", f"{name} = (", *_column(kernel.top), *_column(kernel.bottom)]
        lines += [f"    {float(start)!r},", ")"]
    places = ", ".join(repr(float(x)) for x in (arc_peak(), ARC_END, arc_bend()))
    lines += ["", "# where the level of ARC_NEAR is greatest, how far beyond the first one goes, and the level there"]
    return "\n".join([*lines, f"ARC_PEAK, ARC_END, ARC_BEND = {places}", ""])


def _rest(function: Callable[[mp.mpf], mp.mpf], start: mp.mpf, v: mp.mpf) -> mp.mpf:
    with mp.extradps(40):
        return (function(v) - start) / v


def _column(numbers: tuple[float, ...]) -> list[str]:
    if len(numbers) == 1:
        return [f"    ({numbers[0]!r},),"]
    return ["    (", *(f"        {number!r}," for number in numbers), "    ),"]


INSTEAD = {
    nt.dgamma: "use dgamma = 0 for a contact without adhesion",
    nt.mu: "give the coefficient as a positive number, or mu = 0 for a contact without friction",
    nt.sigma: "a steeper edge carries an infinite force, use s > -1",
    nt.v: "a shrinking contact does not obey the rule of Lee and Radok, use v > 0; see retract_force",
    nt.alpha: "use the Maxwell law for a fluid (alpha = 1) and the elastic contact for alpha = 0",
    nt.k: "use a modulus that grows less than linearly with depth, or k = 0 for a homogeneous half-space",
}
"""What an error message offers in place of a value outside the domain."""
LOADED = {nt.d: "d >= 0", nt.F: "F >= 0"}
"""A field elsewhere, and where it is a parameter it may be zero."""

OPTIONAL = {nt.t_h: nt.t_m}
"""Parameters that need not be given, and those that then stand for them."""

HEAD = '''"""Domains of the keyword parameters in words, and the units of all arguments: what messages need."""

from __future__ import annotations

from typing import NamedTuple


class Domain(NamedTuple):
    """Where a parameter may lie, and what it is."""

    rule: str
    meaning: str
    closed: str = ""
    """The end that belongs to the domain, "low" or "high"."""
    instead: str = ""
    """What to use for a value outside."""
    letter: str = ""
    """How the interface writes the parameter, where it shares its letter with another one."""
    otherwise: str = ""
    """The parameter that stands for it where it is not given."""


SYMBOLS = {
'''
INTERVALS = '''"""Domains of the keyword parameters in numbers."""

from __future__ import annotations

from math import inf

INSIDE = {
'''


def bounds(domain: str) -> tuple[str, str, str]:
    """The interval a domain such as `0 < theta < pi/2` or `dgamma >= 0` stands for: its ends, and which is closed."""
    two_sided = re.fullmatch(r"(\S+) < \w+ (<=?) (\S+)", domain)
    if two_sided:
        return _number(two_sided[1]), _number(two_sided[3]), "high" if two_sided[2] == "<=" else ""
    above = re.fullmatch(r"\w+ (>=?) (\S+)", domain)
    if above:
        # in order with another parameter, which is positive: that is asked for apart
        return "0.0" if nt.known(above[2]) else _number(above[2]), "inf", "low" if above[1] == ">=" else ""
    message = f"the domain {domain!r} is not an interval; write it as 'low < x < high', 'x > low' or 'x >= low'"
    raise ValueError(message)


def _number(text: str) -> str:
    return repr(float(sp.sympify(text, locals={"pi": sp.pi})))


def symbols_sources(names: Iterable[str], arguments: Iterable[sp.Symbol | sp.IndexedBase] = ()) -> dict[str, str]:
    """The texts of `symbols.py` and `intervals.py` for the parameters of these names in the notation.

    They are apart because every import needs the numbers, and the words are for messages.
    """
    wanted = set(names)
    records = [record for record in nt.all_notation() if record.name in wanted]
    words = [line for record in records for line in _row(record)]
    intervals = [f'    "{record.name}": ({", ".join(bounds(_domain(record))[:2])}),' for record in records]
    return {
        "symbols.py": HEAD + "\n".join([*words, "}", *_units(set(arguments)), ""]),
        "intervals.py": INTERVALS + "\n".join([*intervals, "}", ""]),
    }


def _units(arguments: set[sp.Symbol | sp.IndexedBase]) -> list[str]:
    """Of a letter with two meanings, a length and an exponent, there is no unit to be told."""
    units: dict[str, set[str]] = {}
    for record in nt.all_notation():
        if record.symbol in arguments:
            units.setdefault(name_of(record.symbol), set()).add(record.unit)
    rows = [f'    "{letter}": "{unit}",' for letter, (unit, *others) in units.items() if not others]
    return ["UNITS = {", *rows, "}", '"""Units of the arguments, by their letters in the interface."""']


def _row(record: nt.Notation) -> list[str]:
    domain = _domain(record)
    closed = bounds(domain)[2]
    unit = "" if record.unit == "1" else f", in {record.unit}"
    parts = [f'"{domain}"', f'"{record.meaning}{unit}"']
    instead, letter = INSTEAD.get(record.symbol, ""), record.letter
    named = {"closed": closed, "instead": instead, "letter": letter, "otherwise": str(OPTIONAL.get(record.symbol, ""))}
    parts += [f'{name}="{text}"' for name, text in named.items() if text]
    lines = call(f'"{record.name}": Domain', parts, "),")
    return ["    " + line for line in lines]


def _domain(record: nt.Notation) -> str:
    return LOADED.get(record.symbol, record.domain) or f"-oo < {record.letter or record.name} < oo"
