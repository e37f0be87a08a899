"""Section 11.8: the special functions of the book, (11.81)-(11.99).

The chapter writes elliptic integrals with the modulus k; mpmath, like
`notation`, takes the parameter m = k**2.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import mpmath as mp

from .equation import Draw, Formula, Residual, chain, equation
from .quadrature import derivative, singular, to_infinity, weighted

Function = Callable[[Any], Any]
ZERO, ONE, HALF = mp.mpf(0), mp.mpf(1), mp.mpf(1) / 2


def elliptic_incomplete(theta: Any, k: Any) -> tuple[Any, Any]:
    """F(theta, k) and E(theta, k), both by quadrature; k is the modulus."""
    return (
        singular(lambda phi: 1 / mp.sqrt(1 - k**2 * mp.sin(phi) ** 2), ZERO, theta),
        singular(lambda phi: mp.sqrt(1 - k**2 * mp.sin(phi) ** 2), ZERO, theta),
    )


def elliptic_complete(k: Any) -> tuple[Any, Any, Any, Any]:
    """K(k) by quadrature and as F(pi/2, k), E(k) by quadrature and as E(pi/2, k); k is the modulus."""
    return (
        singular(lambda phi: 1 / mp.sqrt(1 - k**2 * mp.sin(phi) ** 2), ZERO, mp.pi / 2),
        mp.ellipf(mp.pi / 2, k**2),
        singular(lambda phi: mp.sqrt(1 - k**2 * mp.sin(phi) ** 2), ZERO, mp.pi / 2),
        mp.ellipe(mp.pi / 2, k**2),
    )


def gamma_integral(z: Any) -> Any:
    """Gamma(z) by quadrature from 0 to infinity, z complex with a positive real part."""
    return to_infinity(lambda t: t ** (z - 1) * mp.exp(-t), ZERO)


def gamma_incomplete(z: Any, a: Any) -> tuple[Any, Any]:
    """The upper and the lower incomplete Gamma function at a, both by quadrature."""
    return (
        to_infinity(lambda t: t ** (z - 1) * mp.exp(-t), a),
        singular(lambda t: t ** (z - 1) * mp.exp(-t), ZERO, a),
    )


def beta_integral(x: Any, y: Any) -> Any:
    """B(x, y) by tanh-sinh quadrature from 0 to 1."""
    strongest = max(0.0, 1 - float(mp.re(x)), 1 - float(mp.re(y)))
    return singular(lambda u: u ** (x - 1) * (1 - u) ** (y - 1), ZERO, ONE, strongest)


def binomial(n: int, k: int) -> tuple[Any, Any, Any]:
    """n over k by factorials, by Gamma functions and by the Beta function."""
    return (
        mp.factorial(n) / (mp.factorial(k) * mp.factorial(n - k)),
        mp.gamma(n + 1) / (mp.gamma(k + 1) * mp.gamma(n - k + 1)),
        1 / ((n + 1) * mp.beta(k + 1, n - k + 1)),
    )


def beta_incomplete(z: Any, x: Any, y: Any) -> Any:
    """B(z; x, y) by tanh-sinh quadrature from 0 to z."""
    strongest = max(0.0, 1 - float(x))
    return singular(lambda u: u ** (x - 1) * (1 - u) ** (y - 1), ZERO, z, strongest)


def _terms(ratio: Any) -> int:
    """How many terms of a series that falls by `ratio` from term to term, after some that may grow."""
    return int(mp.mp.dps * mp.log(10) / -mp.log(ratio)) + 40


def gauss_series(a: Any, b: Any, c: Any, z: Any) -> Any:
    """2F1(a, b; c; z) summed from its power series, for abs(z) < 1."""

    def term(n: int) -> Any:
        rising = mp.gamma(a + n) * mp.gamma(b + n) * mp.gamma(c) / (mp.gamma(a) * mp.gamma(b) * mp.gamma(c + n))
        return rising * z**n / mp.factorial(n)

    return mp.fsum(term(n) for n in range(_terms(abs(z))))


def struve_series(n: Any, z: Any) -> Any:
    """The Struve function H_n(z) summed from its power series, z complex."""

    def term(k: int) -> Any:
        return (-1) ** k / (mp.gamma(k + mp.mpf(3) / 2) * mp.gamma(k + n + mp.mpf(3) / 2)) * (z / 2) ** (2 * k + n + 1)

    return mp.fsum(term(k) for k in range(_terms(HALF / 2)))


@equation(81, elliptic_incomplete, "quadrature against mpmath with m = k^2 and Carlson's R_F")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    theta, k = draw.number(0.2, 1.5), draw.number(0.1, 0.9)
    first, second = formula(theta, k)
    yield Residual(mp.ellipf(theta, k**2), first)
    yield Residual(mp.ellipe(theta, k**2), second)
    sine, cosine = mp.sin(theta), mp.cos(theta)
    delta = 1 - (k * sine) ** 2
    yield Residual(sine * mp.elliprf(cosine**2, delta, 1), first)


@equation(82, elliptic_complete, "arithmetic-geometric mean, mpmath, Legendre's relation")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    k = draw.number(0.3, 0.9)
    first, first_again, second, second_again = formula(k)
    yield from chain(mp.pi / (2 * mp.agm(1, mp.sqrt((1 - k) * (1 + k)))), (first, first_again))
    yield from chain(mp.ellipe(k**2), (second, second_again))
    other, _, other_second, _ = formula(mp.sqrt((1 - k) * (1 + k)))
    yield Residual(mp.pi / 2, second * other + other_second * first - first * other)


@equation(83, gamma_integral, "Euler's integral of complex z against mpmath; Gamma(1/2)")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z = draw.complex(0.6, 4)
    yield Residual(mp.gamma(z), formula(z))
    yield Residual(mp.sqrt(mp.pi), formula(HALF))


@equation(84, lambda z: (z - 1) * mp.gamma(z - 1), "Euler's integral of complex z")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z = draw.complex(1.6, 4)
    yield Residual(gamma_integral(z), formula(z))


@equation(85, lambda n: mp.factorial(n - 1), "Euler's integral at integers")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    for n in (1, draw.integer(2, 8), draw.integer(9, 15)):
        yield Residual(gamma_integral(mp.mpf(n)), formula(n))


@equation(86, gamma_incomplete, "both integrals against mpmath and Kummer's function, complex z")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z, a = draw.complex(0.6, 3), draw.number(0.3, 3)
    upper, lower = formula(z, a)
    yield Residual(mp.gammainc(z, a), upper)
    yield Residual(mp.gammainc(z, 0, a), lower)
    yield Residual(a**z * mp.exp(-a) / z * mp.hyp1f1(1, 1 + z, a), lower)


@equation(87, lambda upper, lower: upper + lower, "both integrals of (11.86) against Gamma")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z, a = draw.complex(0.6, 3), draw.number(0.3, 3)
    yield Residual(mp.gamma(z), formula(*gamma_incomplete(z, a)))


@equation(
    88,
    lambda x, y: mp.gamma(x) * mp.gamma(y) / mp.gammainc(x, y),
    "Euler's integral (11.89), real and complex x, y",
    corrected=lambda x, y: mp.gamma(x) * mp.gamma(y) / mp.gamma(x + y),
    printed_form="B(x, y) = Gamma(x) Gamma(y) / Gamma(x, y)",
    right_form="B(x, y) = Gamma(x) Gamma(y) / Gamma(x + y)",
    reason="The comma is a plus sign: Gamma(x, y) would be an incomplete Gamma function, and B would not be symmetric",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    x, y = draw.number(0.6, 3), draw.number(0.6, 3)
    left = weighted(lambda u: u ** (x - 1) * (1 - u) ** (y - 1), ZERO, ONE, x - 1, y - 1, density=0.4)
    yield Residual(left, formula(x, y))
    x, y = draw.complex(1, 3), draw.complex(1, 3)
    yield Residual(beta_integral(x, y), formula(x, y))


@equation(89, beta_integral, "Euler's integral of complex x, y against mpmath")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    x, y = draw.complex(0.6, 3), draw.complex(0.6, 3)
    yield Residual(mp.beta(x, y), formula(x, y))


@equation(90, binomial, "Pascal's triangle against the three forms")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    n = draw.integer(2, 30)
    k = draw.integer(1, n - 1)
    row = [1]
    for _ in range(n):
        row = [x + y for x, y in zip([0, *row], [*row, 0], strict=True)]
    yield from chain(mp.mpf(row[k]), formula(n, k))


@equation(91, lambda x, y: mp.beta(x + 1, y) + mp.beta(x, y + 1), "Euler's integral of complex x, y")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    x, y = draw.complex(0.6, 3), draw.complex(0.6, 3)
    yield Residual(beta_integral(x, y), formula(x, y))


@equation(92, beta_incomplete, "quadrature against mpmath and against 2F1")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z, x, y = draw.number(0.1, 0.9), draw.number(0.6, 3), draw.number(0.6, 3)
    right = formula(z, x, y)
    yield Residual(mp.betainc(x, y, 0, z), right)
    yield Residual(z**x / x * mp.hyp2f1(x, 1 - y, x + 1, z), right)


def _gauss(draw: Draw) -> tuple[Any, Any, Any, Any]:
    """Parameters with c > b > 0, for which Euler's integral converges."""
    a, b = draw.number(-2, 2), draw.number(0.5, 1.5)
    return a, b, b + draw.number(0.5, 1.5), draw.sign() * draw.number(0.1, 0.6)


@equation(93, gauss_series, "series against mpmath and against Euler's integral")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, b, c, z = _gauss(draw)
    right = formula(a, b, c, z)
    yield Residual(mp.hyp2f1(a, b, c, z), right)
    euler = weighted(lambda t: t ** (b - 1) * (1 - t) ** (c - b - 1) * (1 - z * t) ** -a, ZERO, ONE, b - 1, c - b - 1)
    yield Residual(euler / mp.beta(b, c - b), right)


def _taylor(f: Function, z: Any, reach: Any) -> tuple[Any, Any, Any]:
    """f, f' and f'' at z."""
    return f(z), derivative(f, z, reach), derivative(f, z, reach, 2)


@equation(
    94,
    lambda a, b, c, z, y, slope, bend: z * (1 - z) * bend + (c - (a + b + 1) * z) * slope - a * b * y,
    "derivatives by Cauchy's integral",
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, b, c, z = _gauss(draw)
    y, slope, bend = _taylor(lambda x: mp.hyp2f1(a, b, c, x), z, mp.mpf("0.18"))
    yield Residual(0, formula(a, b, c, z, y, slope, bend), scale=abs(a * b * y) + abs(c * slope))


@equation(95, lambda a, b, c, z: a * b / c * mp.hyp2f1(a + 1, b + 1, c + 1, z), "derivative by Cauchy's integral")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    a, b, c, z = _gauss(draw)
    yield Residual(derivative(lambda x: mp.hyp2f1(a, b, c, x), z, mp.mpf("0.18")), formula(a, b, c, z))


@equation(96, lambda z: 1 / (1 - z), "series (11.93) and mpmath")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    z = draw.sign() * draw.number(0.1, 0.7)
    yield Residual(gauss_series(ONE, ONE, ONE, z), formula(z))
    yield Residual(mp.hyp2f1(1, 1, 1, z), formula(z))


@equation(97, struve_series, "series against mpmath and against Poisson's integral, complex z, real order")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    n, z = draw.number(0, 2), draw.complex(0.5, 4)
    right = formula(n, z)
    yield Residual(mp.struveh(n, z), right)
    poisson = weighted(lambda t: (1 - t**2) ** (n - HALF) * mp.sin(z * t), ZERO, ONE, 0, n - HALF, density=1)
    yield Residual(2 * (z / 2) ** n / (mp.sqrt(mp.pi) * mp.gamma(n + HALF)) * poisson, right)


@equation(
    98, lambda n, z: 4 / (mp.sqrt(mp.pi) * mp.gamma(n + HALF)) * (z / 2) ** (n + 1), "derivatives by Cauchy's integral"
)
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    n, z = draw.number(0, 2), draw.number(1, 4)
    y, slope, bend = _taylor(lambda x: mp.struveh(n, x), z, mp.mpf("0.4"))
    yield Residual(bend * z**2 + slope * z + (z**2 - n**2) * y, formula(n, z))


@equation(99, lambda n, z: mp.struveh(n - 1, z) - n / z * mp.struveh(n, z), "derivative by Cauchy's integral")
def _(draw: Draw, formula: Formula) -> Iterator[Residual]:
    n, z = draw.number(0, 2), draw.number(1, 4)
    yield Residual(derivative(lambda x: mp.struveh(n, x), z, mp.mpf("0.4")), formula(n, z))
