"""Moments of the Abel kernels, by recurrences down to the masters.

Every function returns a `Form` in the symbols a (upper limit), r and the given
break b.  `k` is the exponent of grading; k = 0 is the homogeneous half-space.
"""

from __future__ import annotations

import sympy as sp

from ..notation import a, r
from .form import Form
from .masters import C0, IncompleteBeta, gamma_normalised

ZERO, ONE, HALF = sp.S.Zero, sp.S.One, sp.S.Half


def _is_natural(exponent: sp.Expr) -> bool:
    return bool(exponent.is_Integer and exponent >= 0)


def _odd_moment(order: sp.Expr, base: sp.Expr, sign: int, width: sp.Expr, k: sp.Expr) -> Form:
    """Finite sum for an odd order and every k: y = base**2 + sign*v turns the moment into int v**((k-1)/2) (...) dv."""
    m, half_power = (int(order) - 1) // 2, (k - 1) / 2
    total = sum(
        sp.binomial(m, i) * base ** (2 * (m - i)) * (sign * width) ** i / (half_power + 1 + i) for i in range(m + 1)
    )
    return Form.of(width ** (half_power + 1), total / 2)


def depth_moment(s: sp.Expr, b: sp.Expr = ZERO, k: sp.Expr = ZERO) -> Form:
    """A_s = int_b^a x**s (a**2 - x**2)**((k - 1)/2) dx."""
    if k == 0 and _is_natural(s):
        lowest = int(s) % 2
        root = sp.sqrt(a**2 - b**2)
        if lowest == 0:
            form = Form.of(sp.acos(b / a)) if b != 0 else Form.of(ONE, sp.pi / 2)
        else:
            form = Form.of(root) if b != 0 else Form.of(ONE, a)
        for i in range(lowest + 2, int(s) + 1, 2):  # i A_i = (i - 1) a^2 A_{i-2} + b^(i-1) sqrt(a^2 - b^2)
            form = form * (sp.Rational(i - 1, i) * a**2)
            if b != 0:
                form = form + Form.of(root, b ** (i - 1) / sp.Integer(i))
        return form
    p, q = (1 + k) / 2, (s + 1) / 2
    if b == 0:
        beta = gamma_normalised(p) * gamma_normalised(q) / gamma_normalised(p + q)
        return Form.of(ONE, a ** (s + k) * beta / 2)
    if q.is_Integer and q > 0:
        return _odd_moment(s, a, -1, a**2 - b**2, k)
    return Form.of(IncompleteBeta(1 - b**2 / a**2, p, q), a ** (s + k) / 2)


def pressure_moment(s: sp.Expr, k: sp.Expr = ZERO) -> Form:
    """D_s = int_r^a t**s (t**2 - r**2)**((k - 1)/2) dt."""
    if k == 0 and _is_natural(s):
        lowest = int(s) % 2
        root = sp.sqrt(a**2 - r**2)
        form = Form.of(sp.acosh(a / r)) if lowest == 0 else Form.of(root)
        for i in range(lowest + 2, int(s) + 1, 2):  # i D_i = (i - 1) r^2 D_{i-2} + a^(i-1) sqrt(a^2 - r^2)
            form = form * (sp.Rational(i - 1, i) * r**2) + Form.of(root, a ** (i - 1) / sp.Integer(i))
        return form
    if s.is_Integer and s > 0 and s % 2 == 1:
        return _odd_moment(s, r, +1, a**2 - r**2, k)
    if k == 0 and s in (-HALF, HALF):  # lemniscatic: t = r/cos(phi)^2
        amplitude = sp.asin(sp.sqrt(1 - r / a))
        first, second = sp.elliptic_f(amplitude, HALF), sp.elliptic_e(amplitude, HALF)
        if s == -HALF:
            return Form.of(first, sp.sqrt(2 / r))
        return (
            Form.of(first, sp.sqrt(2 * r))
            + Form.of(second, -2 * sp.sqrt(2 * r))
            + Form.of(sp.sqrt(a**2 - r**2), 2 / sp.sqrt(a))
        )
    return Form.of(IncompleteBeta(1 - r**2 / a**2, (1 + k) / 2, (-s - k) / 2), r ** (s + k) / 2)


def elliptic_moment(order: int, b: sp.Expr, inside: bool) -> Form:
    """E_order = int_{max(b,r)}^a t**order / sqrt((t**2 - b**2)(t**2 - r**2)) dt, even order >= -2; inside means r < b.

    One F and one E of the same amplitude, never K - F: short and real.
    """
    large, small = (b, r) if inside else (r, b)
    amplitude = sp.asin(sp.sqrt((a**2 - large**2) / (a**2 - small**2)))
    m = small**2 / large**2
    first, second = sp.elliptic_f(amplitude, m), sp.elliptic_e(amplitude, m)
    roots = sp.sqrt(a**2 - b**2) * sp.sqrt(a**2 - r**2)
    lower = Form.of(first, 1 / large)
    if order == 0:
        return lower
    current = Form.of(first, large) + Form.of(second, -large) + Form.of(roots, a / (a**2 - small**2))
    if order == -2:  # the step below for j = 0
        return (current + Form.of(roots, -1 / a)) * (1 / (b**2 * r**2))
    for j in range(1, order // 2):
        # (2j+1) E_{2j+2} = a^(2j-1) S_b S_r + 2j (b^2+r^2) E_{2j} - (2j-1) b^2 r^2 E_{2j-2}
        step = current * (sp.Rational(2 * j, 2 * j + 1) * (b**2 + r**2))
        step = step + lower * (-sp.Rational(2 * j - 1, 2 * j + 1) * b**2 * r**2)
        step = step + Form.of(roots, a ** (2 * j - 1) / sp.Integer(2 * j + 1))
        lower, current = current, step
    return current


def arccos_moment(order: int, b: sp.Expr, inside: bool) -> Form:
    """C_order = int_{max(b,r)}^a t**order acos(b/t) / sqrt(t**2 - r**2) dt, even order >= -2."""
    if order == -2:  # the step below for j = 0
        rest = Form.of(sp.sqrt(a**2 - r**2) * sp.acos(b / a), 1 / a) + elliptic_moment(0, b, inside) * -b
        return rest * (1 / r**2) + elliptic_moment(-2, b, inside) * b
    form = Form.of(C0(b, r, a))
    for j in range(1, order // 2 + 1):
        # 2j C_{2j} = (2j-1) r^2 C_{2j-2} + a^(2j-1) S_r acos(b/a) - b E_{2j} + b r^2 E_{2j-2}; both lower ends vanish
        form = form * (sp.Rational(2 * j - 1, 2 * j) * r**2)
        form = form + Form.of(sp.sqrt(a**2 - r**2) * sp.acos(b / a), a ** (2 * j - 1) / sp.Integer(2 * j))
        form = form + elliptic_moment(2 * j, b, inside) * (-b / sp.Integer(2 * j))
        form = form + elliptic_moment(2 * j - 2, b, inside) * (b * r**2 / sp.Integer(2 * j))
    return form


def outside_moment(order: int, b: sp.Expr = ZERO) -> Form:
    """M_order = q int_b^a s**order / ((r**2 - s**2) sqrt(a**2 - s**2)) ds with q = sqrt(r**2 - a**2), r > a."""
    q = sp.sqrt(r**2 - a**2)
    if b == 0:
        form = Form.of(sp.asin(a / r)) if order % 2 else Form.of(ONE, sp.pi / (2 * r))
    elif order % 2:
        form = Form.of(sp.asin(sp.sqrt((a**2 - b**2) / (r**2 - b**2))))
    else:
        form = Form.of(sp.acos(b * q / (a * sp.sqrt(r**2 - b**2))), 1 / r)
    for i in range(order % 2 + 2, order + 1, 2):  # M_i = r^2 M_{i-2} - q A_{i-2}
        lower = depth_moment(sp.Integer(i - 2), b)
        form = form * r**2 + Form({master * q: -coefficient for master, coefficient in lower.items()})
    return form


def outside_kernel(k: sp.Expr = ZERO) -> Form:
    """Phi_k(a/r) = int_0^a t**k (r**2 - t**2)**(-(1 + k)/2) dt, the displacement of the flat punch."""
    if k == 0:
        return Form.of(sp.asin(a / r))
    return Form.of(IncompleteBeta(a**2 / r**2, (1 + k) / 2, (1 - k) / 2), HALF)
