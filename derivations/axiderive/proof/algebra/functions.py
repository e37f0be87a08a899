"""Functions as generators of the tower: one spelling, sign, and range of real analyticity.

Arguments are brought to the tower's canonical form, so that equal functions are
equal generators; gamma functions are shifted into (0, 1], complete Beta
functions and sinh(asinh(z)/3) are written without themselves.
"""

from __future__ import annotations

import sympy as sp

from ...abel.masters import (
    C0,
    ArctanIntegral,
    CapMoment,
    Dawson,
    Hypergeometric,
    IncompleteBeta,
    Kummer,
    LegendreChi2,
    StruveH,
    StruveL,
    gamma_normalised,
)
from ...notation import theta
from . import special
from .domain import Domain, NotProvedError, require
from .tower import ONE, Element, Tower

ODD = sp.asin | sp.atan | sp.atanh | sp.sinh | sp.asinh | LegendreChi2 | ArctanIntegral
PLAIN = (sp.Add, sp.Mul, sp.Pow, sp.Symbol, sp.Rational, sp.NumberSymbol, sp.Sum, sp.Tuple, sp.Indexed, sp.IndexedBase)
"""What formulas are made of besides functions."""
POSITIVE = sp.acos | sp.acosh | sp.gamma | C0 | IncompleteBeta
"""Positive wherever they are real."""
ENTIRE = (sp.atan, sp.asinh, sp.sinh, sp.exp, ArctanIntegral, Dawson)


def tower(domain: Domain, *exprs: sp.Expr) -> Tower:
    """The tower of expressions in canonical spelling."""
    return Tower(
        domain,
        *exprs,
        positive=lambda function: positive(function, domain),
        below_one=lambda function: isinstance(function, sp.exp) and sign(function.args[0], domain) < 0,
    )


def sign(expr: sp.Expr, domain: Domain) -> int:
    """Sign on the whole domain, 0 if unknown or zero."""
    key = ("sign", expr)
    if key not in domain.memo:
        expr = canonical(expr, domain)
        arithmetic = tower(domain, expr)
        domain.memo[key] = arithmetic.sign(arithmetic.convert(expr))
    return int(domain.memo[key])


def positive(function: sp.Expr, domain: Domain) -> bool:
    """Whether a function is shown to be real and positive on the whole domain."""
    if isinstance(function, sp.tan | sp.sin | sp.cos):
        return bool(function.args[0] == theta) or _in_first_arch(function, domain)
    if function == sp.pi or isinstance(function, sp.exp):
        return True
    in_range = isinstance(function, ODD | POSITIVE) and all(sign(margin, domain) > 0 for margin in margins(function))
    return in_range and (isinstance(function, POSITIVE) or sign(function.args[0], domain) > 0)


def _in_first_arch(function: sp.Expr, domain: Domain) -> bool:
    (phase,) = function.args
    if isinstance(function, sp.tan) or not phase.has(sp.pi):
        return False
    start = sp.S.Zero if isinstance(function, sp.sin) else -sp.pi / 2
    return sign(phase - start, domain) > 0 and sign(start + sp.pi - phase, domain) > 0


def canonical(expr: sp.Expr, domain: Domain) -> sp.Expr:
    """The expression with every function in canonical spelling."""
    if not expr.has(sp.Function):
        return expr
    key = ("canonical", expr)
    if key not in domain.memo:
        args = [canonical(arg, domain) for arg in expr.args]
        if expr.is_Function and not isinstance(expr, sp.Abs):
            spelled = _respelled(expr.func, [normal(arg, domain) for arg in args], domain)
            domain.memo[key] = spelled
            factor, function = spelled.as_coeff_Mul()
            domain.memo.setdefault(("as given", function), expr / factor)
        else:
            domain.memo[key] = expr.func(*args)
    return domain.memo[key]


def as_given(expr: sp.Expr, domain: Domain) -> sp.Expr:
    """Functions as they were first written: a canonical argument may have lost its value at an end."""
    given = {function: domain.memo.get(("as given", function), function) for function in expr.atoms(sp.Function)}
    return expr.xreplace(given)


def normal(arg: sp.Expr, domain: Domain) -> sp.Expr:
    """The tower's canonical form of an expression whose functions are in canonical spelling."""
    arithmetic = tower(domain, arg)
    return arithmetic.expr(arithmetic.collect(arithmetic.convert(arg)))


def _respelled(head: type[sp.Function], args: list[sp.Expr], domain: Domain) -> sp.Expr:
    if head is sp.gamma:
        return gamma_normalised(args[0])
    if head is IncompleteBeta and args[0] == 1:
        _, p, q = args
        if sign(p, domain) > 0 and sign(q, domain) > 0:
            return gamma_normalised(p) * gamma_normalised(q) / gamma_normalised(p + q)
    family = special.respelled(head, args, lambda expr: sign(expr, domain))
    if family is not None:
        return canonical(_normal_arguments(family, domain), domain)
    if head is sp.sinh and isinstance(3 * args[0], sp.asinh):
        return _third_of_angle((3 * args[0]).args[0], domain) or head(*args)
    return head(*args)


def _normal_arguments(expr: sp.Expr, domain: Domain) -> sp.Expr:
    """Members of a family with canonical arguments; they are not respelled again."""
    return expr.replace(
        lambda node: node.is_Function, lambda node: node.func(*(normal(arg, domain) for arg in node.args))
    )


def _third_of_angle(z: sp.Expr, domain: Domain) -> sp.Expr | None:
    """sinh(asinh(z)/3) is the one real s with 4 s^3 + 3 s = z; None if s is not in the tower.

    With z = m Z, m the radicals of z, s = m sigma: 4 m^2 sigma^3 + 3 sigma = Z.
    """
    arithmetic = tower(domain, z)
    element = arithmetic.collect(arithmetic.convert(z))
    if len(element) != 1:
        return None
    ((monomial, polynomial),) = element.items()
    radicals: Element = {frozenset((f, e) for f, e in monomial if not e.is_Integer): arithmetic.ring.one}
    below = sp.Mul(*(f.as_expr() ** e for f, e in monomial if e.is_Integer))
    square = arithmetic.collect(arithmetic.mul(radicals, radicals))
    if set(square) != {ONE}:
        return None
    sigma = sp.Dummy("sigma")
    cubic = 4 * square[ONE].as_expr() * sigma**3 + 3 * sigma - polynomial.as_expr() * below
    _, factors = sp.factor_list(sp.numer(sp.together(cubic)), sigma)
    linear = [sp.Poly(factor, sigma) for factor, _ in factors if sp.degree(factor, sigma) == 1]
    if not linear:
        return None
    root = -linear[0].coeff_monomial(1) / linear[0].coeff_monomial(sigma)
    return root.xreplace(arithmetic.functions) * arithmetic.expr(radicals)


def require_analytic(expr: sp.Expr, domain: Domain) -> None:
    """Every denominator without zeros, radicand positive and function inside its real range on the open domain."""
    key = ("analytic", expr)
    if key in domain.memo:
        return
    for node in sp.preorder_traversal(expr):
        require(isinstance(node, PLAIN) or node.is_Function, "{} is no formula of real numbers", node)
        if node.is_Pow and not (node.exp.is_Integer and node.exp > 0) and not node.base.is_positive:
            found = sign(node.base, domain)
            require(found != 0 and (found >= 0 or node.exp.is_Integer), "{} is not shown to be positive", node.base)
        elif node.is_Function and not isinstance(node, sp.Abs):
            # the tower asks for the sign of every absolute value
            _require_range(node, domain)
    domain.memo[key] = True


def _require_range(function: sp.Expr, domain: Domain) -> None:
    for margin in margins(function):
        require(sign(margin, domain) > 0, "{} > 0, needed for {}, is not shown", margin, function)


def margins(function: sp.Expr) -> tuple[sp.Expr, ...]:
    """What must be positive for the function to be real and analytic."""
    args = function.args
    if isinstance(function, ENTIRE):
        return ()
    if isinstance(function, sp.asin | sp.acos | sp.atanh | LegendreChi2):
        return (1 - args[0], 1 + args[0])
    if isinstance(function, sp.acosh):
        return (args[0] - 1,)
    if isinstance(function, sp.log | sp.gamma):
        return (args[0],)
    if isinstance(function, sp.elliptic_f | sp.elliptic_e):
        return (args[-1], 1 - args[-1])
    if isinstance(function, IncompleteBeta):
        return args[1:] if args[0] == 1 else (args[0], 1 - args[0], args[1])
    if isinstance(function, Hypergeometric):
        return (args[2], 1 - args[3])
    if isinstance(function, Kummer | StruveH | StruveL | sp.besseli):
        # of the last three the argument: their order need not be whole
        return (args[1],)
    if isinstance(function, CapMoment):
        # at the edge b = a it is that of the sphere
        return (args[2] - args[1],) if args[3] == args[1] else (args[2] - args[1], args[3] - args[1])
    if isinstance(function, sp.elliptic_k):
        return (1 - args[0],)
    if isinstance(function, C0):
        return (args[2] - args[0], args[2] - args[1])
    if isinstance(function, sp.sin | sp.cos) or (isinstance(function, sp.tan) and args[0] == theta):
        return ()
    message = f"the real range of {function} is not known"
    raise NotProvedError(message)
