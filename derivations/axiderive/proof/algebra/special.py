"""Special functions in the tower: each family brought to one member by its contiguity relations, and its integral.

Every relation stands here once.  With T = z d/dz,

    2F1(p, j + 1; c) = (1 + T/j) 2F1(p, j; c),  1F1(j + 1; c) = (1 + T/j) 1F1(j; c)
    2F1(p, 1; c; z) = (c - 1) z**(1-c) (1 - z)**(c-p-1) B(z; c - 1, p - c + 1)
                    = 2F1(c - p, 1; c; z/(z - 1))/(1 - z)
    (p + q) B(z; p + 1, q) = p B(z; p, q) - z**p (1 - z)**q
    (p + q) B(z; p, q + 1) = q B(z; p, q) + z**p (1 - z)**q
    1F1(1; c; z) = 1 + z/c 1F1(1; c + 1; z),  T 1F1(1; c; z) = c - 1 + (z - c + 1) 1F1(1; c; z)
    I_{nu-1}(z) - I_{nu+1}(z) = 2 nu/z I_nu(z)
    H_{nu-1}(z) +- H_{nu+1}(z) = 2 nu/z H_nu(z) + (z/2)**nu/(sqrt(pi) Gamma(nu + 3/2)),  - for L
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from ...abel.masters import (
    CapMoment,
    Dawson,
    Hypergeometric,
    IncompleteBeta,
    Kummer,
    StruveH,
    StruveL,
    gamma_normalised,
)

HALF = sp.S.Half
Sign = Callable[[sp.Expr], int]


def _whole(value: sp.Expr, lowest: sp.Expr) -> int:
    """How many units the constant part of `value` lies above [lowest, lowest + 1)."""
    return int(sp.floor(sp.expand(value).as_coeff_Add()[0] - lowest))


def _natural(value: sp.Expr) -> bool:
    return bool(value.is_Integer and value > 0)


def respelled(head: type[sp.Function], args: list[sp.Expr], sign: Sign) -> sp.Expr | None:
    """The function through the member of its family that stands for it; None if it is that member."""
    if head is Hypergeometric:
        return _hypergeometric(sign, *args)
    if head is Kummer:
        return _kummer(sign, *args)
    if head in (StruveH, StruveL):
        return _struve(head, *args)
    if head is CapMoment:
        return _cap(sign, *args)
    if head is sp.besseli:
        return _bessel(*args)
    return None


def beta(z: sp.Expr, p: sp.Expr, q: sp.Expr) -> sp.Expr:
    """B(z; p, q) through the member whose constant parts lie in [0, 1); a number p in (0, 1]."""
    steps = _whole(q, sp.S.Zero)
    if steps > 0:
        return ((q - 1) * beta(z, p, q - 1) + z**p * (1 - z) ** (q - 1)) / (p + q - 1)
    if steps < 0:
        return ((p + q) * beta(z, p, q + 1) - z**p * (1 - z) ** q) / q
    steps = int(sp.ceiling(p)) - 1 if p.is_number else _whole(p, sp.S.Zero)
    if steps > 0:
        return ((p - 1) * beta(z, p - 1, q) - z ** (p - 1) * (1 - z) ** q) / (p - 1 + q)
    if steps < 0:
        return ((p + q) * beta(z, p + 1, q) + z**p * (1 - z) ** q) / p
    return IncompleteBeta(z, p, q)


def elementary(expr: sp.Expr) -> sp.Expr:
    """Incomplete Beta functions with p = 1/2 or 1 and q = 0 or 1/2, up to whole numbers, and arcs, all as atan.

    For z = x^2 and x > 0; each value is shown by its derivative and by what it is at z = 0.
    """
    expr = expr.replace(IncompleteBeta, lambda z, p, q: beta(z, p, q) if p.is_number and q.is_number else None)
    expr = expr.replace(IncompleteBeta, lambda z, p, q: ELEMENTARY[p, q](z) if (p, q) in ELEMENTARY else None)
    expr = expr.replace(sp.asin, lambda x: sp.atan(x / sp.sqrt(1 - x**2)))
    return expr.replace(sp.acos, lambda x: sp.atan(sp.sqrt(1 - x**2) / x))


ELEMENTARY: dict[tuple[sp.Expr, ...], Callable[[sp.Expr], sp.Expr]] = {
    (HALF, HALF): lambda z: 2 * sp.atan(sp.sqrt(z / (1 - z))),
    (HALF, sp.S.Zero): lambda z: 2 * sp.atanh(sp.sqrt(z)),
    (sp.S.One, HALF): lambda z: 2 * (1 - sp.sqrt(1 - z)),
    (sp.S.One, sp.S.Zero): lambda z: -sp.log(1 - z),
}


def _raised(first: sp.Expr, z: sp.Symbol, natural: int) -> sp.Expr:
    """(1 + T/j) for j = 1 ... natural - 1."""
    for i in range(1, natural):
        first = first + z * sp.diff(first, z) / i
    return first


def _hypergeometric(sign: Sign, p: sp.Expr, q: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
    if not _natural(q):
        p, q = q, p
    if not _natural(q) or sign(z) == 0 or sign(c - 1) <= 0:
        return None
    s = sp.Dummy("z", real=True)
    if sign(z) > 0:
        first = (c - 1) * s ** (1 - c) * (1 - s) ** (c - p - 1) * beta(s, c - 1, p - c + 1)
    else:
        y = s / (s - 1)
        first = (c - 1) * y ** (1 - c) * (1 - y) ** (p - 1) / (1 - s) * beta(y, c - 1, 1 - p)
    return _raised(first, s, int(q)).subs(s, z)


def _kummer(sign: Sign, p: sp.Expr, c: sp.Expr, z: sp.Expr) -> sp.Expr | None:
    if not _natural(p):
        return None
    s = sp.Dummy("z", real=True)
    steps = _whole(c, sp.S.One)
    member = sp.Function("member")(s)
    base = sp.expand(c - steps)
    slope = (base - 1 + (s - base + 1) * member) / s
    expr = member
    for i in range(abs(steps)):
        expr = (base + i) * (expr - 1) / s if steps > 0 else 1 + s / (base - 1 - i) * expr
    for i in range(1, int(p)):
        expr = expr + s * sp.diff(expr, s).subs(sp.Derivative(member, s), slope) / i
    if expr == member and not (base == sp.Rational(3, 2) and sign(z) < 0):
        return None
    if base == sp.Rational(3, 2) and sign(z) < 0:
        root = sp.sqrt(-z)
        return expr.subs(member, Dawson(root) / root).subs(s, z)
    return expr.subs(member, Kummer(1, base, z)).subs(s, z)


def _struve(head: type[StruveH], nu: sp.Expr, z: sp.Expr) -> sp.Expr | None:
    """Two members are left, with the constant parts of the order in (-1, 0] and (0, 1]."""
    constant = sp.expand(nu).as_coeff_Add()[0]
    if -1 < constant <= 1:
        return None
    flip = 1 if head is StruveH else -1
    middle = nu + 1 if constant <= -1 else nu - 1
    far = nu + 2 if constant <= -1 else nu - 2
    source = (z / 2) ** middle / (sp.sqrt(sp.pi) * gamma_normalised(middle + sp.Rational(3, 2)))
    inner = 2 * middle / z * _member(head, middle, z) + source
    outer = _member(head, far, z)
    return inner - flip * outer if constant <= -1 else flip * (inner - outer)


def _member(head: type[StruveH], nu: sp.Expr, z: sp.Expr) -> sp.Expr:
    found = _struve(head, nu, z)
    return head(nu, z) if found is None else found


def _bessel(nu: sp.Expr, z: sp.Expr) -> sp.Expr | None:
    """I_nu for a whole nu through I_0 and I_1."""
    if not nu.is_Integer or nu in (0, 1):
        return None
    if nu < 0:
        return sp.besseli(-nu, z)
    one, other = (_bessel(order, z) or sp.besseli(order, z) for order in (nu - 2, nu - 1))
    return one - 2 * (nu - 1) / z * other


def _cap(sign: Sign, k: sp.Expr, b: sp.Expr, R: sp.Expr, a: sp.Expr) -> sp.Expr | None:
    """An angle for k = 0; up to the edge b = a the sphere without a cap."""
    if k == 0:
        return sp.log((a + R) / (sp.sqrt(a**2 - b**2) + sp.sqrt(R**2 - b**2)))
    if a == b and sign(R - b) > 0:
        return (R**2 - b**2) ** (k / 2) * beta(b**2 / R**2, (1 + k) / 2, -k / 2) / 2
    return None


def integrand(function: sp.Expr, t: sp.Symbol) -> tuple[sp.Expr, tuple[sp.Expr, ...]] | None:
    """What the function is the integral of over 0 < t < 1, and what must be positive; None if that is not stated.

    Euler's integral with t**2 for t, Poisson's for the Struve functions (11.97) and I_nu, Legendre's (11.92).
    """
    args = function.args
    if isinstance(function, Hypergeometric):
        p, q, c, z = args
        scale = 2 * gamma_normalised(c) / (gamma_normalised(q) * gamma_normalised(c - q))
        return scale * t ** (2 * q - 1) * (1 - t**2) ** (c - q - 1) * (1 - z * t**2) ** -p, (q, c - q, 1 - z)
    if isinstance(function, StruveH | sp.besseli):
        nu, z = args
        waves = {StruveH: sp.sin, StruveL: lambda x: (sp.exp(x) - sp.exp(-x)) / 2}
        wave = waves.get(function.func, lambda x: (sp.exp(x) + sp.exp(-x)) / 2)(z * t)
        scale = 2 * (z / 2) ** nu / (sp.sqrt(sp.pi) * gamma_normalised(nu + HALF))
        return scale * (1 - t**2) ** (nu - HALF) * wave, (nu + HALF, z)
    if isinstance(function, sp.elliptic_e | sp.elliptic_k) and len(args) == 1:
        power = HALF if isinstance(function, sp.elliptic_e) else -HALF
        return (1 - args[0] * t**2) ** power / sp.sqrt(1 - t**2), (1 - args[0],)
    return None
