"""SymPy expressions as the text of NumPy expressions, in the order a person would type them."""

from __future__ import annotations

import math
import re
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.printing.str import StrPrinter

from .. import notation as nt
from ..abel import masters
from ..stable import opaque
from ..stable.forms import EvaluationForm
from ..stable.signs import squares

# material and load first, then lengths from the contact to the profile, intermediates and functions last
ORDER = (
    "E_star", "F", "P", "d", "n", "A", "h", "a", "r", "x", "L", "t", "u", "b", "R", "R1", "R2", "s", "wavelength",
    "theta", "r_zero",
)  # fmt: skip
FUNCTIONS = {
    sp.Abs: "np.abs",
    sp.tan: "np.tan", sp.sin: "np.sin", sp.cos: "np.cos", sp.asinh: "np.arcsinh", sp.sinh: "np.sinh",
    sp.cosh: "np.cosh", sp.tanh: "np.tanh", sp.exp: "np.exp", sp.log: "np.log", sp.atan: "np.arctan",
    sp.acos: "np.arccos", sp.asin: "np.arcsin", sp.acosh: "np.arccosh", sp.atanh: "np.arctanh",
    opaque.Log1p: "np.log1p", opaque.Expm1: "np.expm1", opaque.Arctan2: "np.arctan2",
    opaque.RootGap: "root_gap", opaque.ArctanGap: "arctan_gap", opaque.TanhGap: "tanh_gap",
    opaque.GammaRatio: "gamma_ratio",
    masters.Dawson: "dawson", opaque.ArcStrips: "arc_strips", opaque.PowerPressure: "power_pressure",
    opaque.PowerDisplacement: "power_displacement", opaque.PowerPunches: "power_punches",
    opaque.PowerStrips: "power_strips", opaque.SineRoot: "sine_root",
    opaque.DepthOverHeight: "depth_over_height",
}  # fmt: skip
VARYING = frozenset(("F", "P", "d", "a", "r", "x", "L", "t", "u", "c", "r_zero", "inner", "rho"))
"""Arguments of the functions and radii made from them: all else is one number where the parameters are numbers."""
SUM, PRODUCT, POWER, ATOM = range(4)


# what orders factors and terms asks for the same parts over and over: it was a tenth of a build
@lru_cache(maxsize=65536)
def written(expr: sp.Basic) -> str:
    """The expression as SymPy writes it, each part of it written once."""
    return str(StrPrinter._print(_TEXT, expr))


class _Text(StrPrinter):
    def _print(self, expr: Any, **settings: Any) -> str:
        return written(expr) if isinstance(expr, sp.Basic) else str(super()._print(expr, **settings))


_TEXT = _Text()


def python(expr: sp.Expr) -> str:
    """The expression as Python source."""
    return _code(sp.sympify(expr))[0]


def printable(form: EvaluationForm) -> bool:
    """Whether every function of the form has a text."""
    known = (*FUNCTIONS, opaque.Root, opaque.Arcosh, masters.StruveH)
    exprs = (form.value, *(expr for _, expr in form.steps))
    return all(isinstance(call, known) for expr in exprs for call in expr.atoms(sp.Function, sp.Integral))


def _wrapped(expr: sp.Expr, level: int) -> str:
    text, own = _code(expr)
    return text if own >= level else f"({text})"


def _code(expr: sp.Expr) -> tuple[str, int]:
    if expr.is_Rational and not expr.is_Integer:
        return f"{expr.p} / {expr.q}", PRODUCT
    if expr.is_Integer:
        return str(int(expr)), ATOM if expr >= 0 else SUM
    if expr.is_Float:
        return repr(float(expr)), ATOM
    if expr is sp.pi or expr is sp.E:
        return f"np.{'pi' if expr is sp.pi else 'e'}", ATOM
    if expr.is_Symbol:
        return str(expr.name), ATOM
    if expr.is_Add:
        return _sum(expr)
    if expr.is_Mul or expr.is_Pow:
        return _product(expr)
    return _function(expr), ATOM


def _function(expr: sp.Expr) -> str:
    if isinstance(expr, opaque.Root):
        x, y = expr.args
        return f"np.sqrt(({python(x - y)}) * ({python(x + y)}))"
    if isinstance(expr, opaque.Arcosh):
        x, y, root = expr.args
        return f"np.log1p(({python(x - y)} + {_wrapped(root, PRODUCT)}) / {_wrapped(y, ATOM)})"
    if isinstance(expr, sp.Sum):
        (index, first, _), base = expr.limits[0], expr.function.atoms(sp.IndexedBase).pop()
        # last, because its product with numbers alone may overflow
        term = f"{_wrapped(expr.function / base[index], PRODUCT)} * {base.label}_{index}"
        # a pressure may be infinite on the axis, also one that no coefficient asks for
        asked = f" if {base.label}_{index}" if expr.function.has(opaque.PowerPressure) else ""
        return f"sum({term} for {index}, {base.label}_{index} in enumerate({base.label}, {first}){asked})"
    if isinstance(expr, masters.StruveH):
        return f"struve_h{expr.args[0]}({python(expr.args[1])})"
    return f"{FUNCTIONS[expr.func]}({', '.join(python(arg) for arg in expr.args)})"


def _sum(expr: sp.Expr) -> tuple[str, int]:
    pair = squares(expr)
    if pair:
        x, y = pair
        return f"({python(x - y)}) * ({python(x + y)})", PRODUCT
    terms = sorted(expr.args, key=lambda term: (term.could_extract_minus_sign(), _rank(term)))
    text = (
        _wrapped(terms[0], PRODUCT) if not terms[0].could_extract_minus_sign() else "-" + _wrapped(-terms[0], PRODUCT)
    )
    for term in terms[1:]:
        minus = term.could_extract_minus_sign()
        text += f" {'-' if minus else '+'} {_wrapped(-term if minus else term, PRODUCT)}"
    return text, SUM


def _rank(expr: sp.Expr) -> tuple[int, list[int], str]:
    """Powers of the contact radius first, as in the handbook; ties by text."""
    names = [symbol.name for symbol in expr.free_symbols]
    return (
        not expr.free_symbols,
        [ORDER.index(name) if name in ORDER else -1 for name in sorted(names)],
        written(expr),
    )


def _factor_rank(factor: sp.Expr) -> tuple[int, int, str]:
    base = factor.as_base_exp()[0]
    if base.is_number:
        return (0, 0, written(base))
    if base.is_Symbol and not isinstance(base, opaque.Named):
        return (1, ORDER.index(base.name) if base.name in ORDER else len(ORDER), base.name)
    if base.is_Function and len(base.free_symbols) == 1 and isinstance(base, (sp.tan, sp.sin, sp.cos)):
        return (2, 0, written(base))
    if base.is_Add:
        return (3, 0, written(base))
    return (4, 0, written(base))


def _product(expr: sp.Expr) -> tuple[str, int]:
    number, factors = sp.S.One, []
    for factor in sp.Mul.make_args(expr):
        if factor.is_Rational:
            number *= factor
        else:
            factors.append(factor)
    radical, number, factors = _radical(number, factors)
    top: list[tuple[str, int]] = []
    bottom: list[tuple[str, int]] = []
    varying: list[tuple[str, int]] = []
    divided = number.q & (number.q - 1) != 0
    for factor in sorted(factors, key=_factor_rank):
        # an exponential is a function here, not a power of e
        base, exponent = (factor, sp.S.One) if isinstance(factor, sp.exp) else factor.as_base_exp()
        if exponent.could_extract_minus_sign():
            bottom.append(_power(base, -exponent))
            divided = True
        else:
            (varying if _varies(factor) else top).append(_power(base, exponent))
    if radical:
        varying.append((radical, PRODUCT if " * (" in radical else ATOM))
    if number < 0:
        text, level = _product(-expr)
        text = text if level >= PRODUCT else f"({text})"
        return "-" + re.sub(r"^(\w+\*\*\w+)", r"(\1)", text), SUM
    if not (divided and top) or any(_varies(x) for x in factors if x.as_base_exp()[1].could_extract_minus_sign()):
        top, varying = [*top, *varying], []
    if number.p != 1 or not top:
        top.insert(0, (str(number.p), ATOM))
    if number.q != 1:
        bottom.insert(0, (str(number.q), ATOM))
    if not varying:
        return _fraction(top, bottom)
    # one number times what varies: as many roundings, and no division of an array
    return _fraction([_fraction(top, bottom), *varying], [])


def _varies(factor: sp.Expr) -> bool:
    return any(isinstance(x, opaque.Named) or x.name in VARYING for x in factor.free_symbols)


def _fraction(top: list[tuple[str, int]], bottom: list[tuple[str, int]]) -> tuple[str, int]:
    if len(top) == 1 and not bottom:
        return top[0]
    text = " * ".join(part if level >= PRODUCT else f"({part})" for part, level in top)
    if not bottom:
        return text, PRODUCT
    if len(bottom) == 1:
        part, level = bottom[0]
        return f"{text} / {part if level >= POWER else f'({part})'}", PRODUCT
    below = " * ".join(part if level >= PRODUCT else f"({part})" for part, level in bottom)
    return f"{text} / ({below})", PRODUCT


def _power(base: sp.Expr, exponent: sp.Expr) -> tuple[str, int]:
    if exponent == 1:
        return _code(base)
    if exponent == sp.S.Half:
        return f"np.sqrt({python(base)})", ATOM
    if exponent == sp.Rational(1, 3):
        return f"np.cbrt({python(base)})", ATOM
    if exponent.is_Rational and exponent.q == 3:
        return f"np.cbrt({python(base)})**{exponent.p}", POWER
    if exponent == sp.Rational(1, 4):
        return f"np.sqrt(np.sqrt({python(base)}))", ATOM
    parts = _root_parts(exponent)
    if parts is not None:
        return _with_root(base, *parts)
    left, right = _wrapped(base, ATOM), _wrapped(exponent, ATOM)
    simple = all(text.replace("_", "").replace(".", "").isalnum() for text in (left, right))
    return (f"{left}**{right}" if simple else f"{left} ** {right}"), POWER


def _root_parts(exponent: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """(whole, inner, degree) of an exponent whole + inner/degree or whole + inner that a double would round; else None.

    n + 1 is 1 + n and n/(n + 1) is 1 - 1/(n + 1): a rounded exponent costs up to ln(x) units of the last place.
    """
    if exponent.is_Rational:
        if exponent.is_Integer or exponent.q <= 3:
            return None
        whole = sp.Integer(sp.floor(exponent + sp.S.Half))
        return whole, (exponent - whole) * exponent.q, sp.Integer(exponent.q)
    if not exponent.has(nt.n):
        return None
    whole, rest = sp.apart(sp.together(exponent), nt.n).as_independent(nt.n, as_Add=True)
    inner, degree = sp.fraction(sp.together(rest))
    if not whole.is_Integer or (whole == 0 and degree == 1):
        return None
    return whole, inner, degree


def _with_root(base: sp.Expr, whole: sp.Expr, inner: sp.Expr, degree: sp.Expr) -> tuple[str, int]:
    """base**(whole + inner/degree) by the helpers that round no exponent."""
    text = python(base)
    if degree != 1:
        shown = _degree(degree)
        special = {(0, 1): f"nth_root({text}, {shown})", (1, -1): f"without_root({text}, {shown})"}
        name = special.get((whole, inner))
        if name is not None:
            return name, ATOM
        if inner == 1:
            return f"{_wrapped(base, PRODUCT)}{_whole_power(whole)} * nth_root({text}, {shown})", PRODUCT
        return f"nth_root({text}, {shown}) ** {python(whole * degree + inner)}", POWER
    if whole == -1:
        return f"lower_power({text}, {python(inner)})", ATOM
    return f"{_power(base, whole)[0]} * {_power(base, inner)[0]}", PRODUCT


def _degree(degree: sp.Expr) -> str:
    """The degree of a root; n + 1 as `n, 1`, because the sum would be rounded."""
    whole, rest = degree.as_independent(nt.n, as_Add=True)
    return f"n, {int(whole)}" if rest == nt.n and whole.is_Integer and whole > 0 else python(degree)


def _whole_power(whole: sp.Expr) -> str:
    return "" if whole == 1 else f"**{whole}"


def _radical(number: sp.Rational, factors: list[sp.Expr]) -> tuple[str, sp.Rational, list[sp.Expr]]:
    """All fractional powers under one root: sqrt(2)*sqrt(F)/sqrt(pi*E) as sqrt(2*F/(pi*E))."""
    whole, roots = [], []
    for factor in factors:
        base, exponent = factor.as_base_exp()
        if not exponent.is_Rational or exponent.is_Integer:
            whole.append(factor)
            continue
        integer = sp.Integer(int(exponent))
        if integer:
            whole.append(base**integer)
        roots.append((base, exponent - integer))
    if not roots:
        return "", number, factors
    if all(base is sp.pi for base, _ in roots):
        return "", number, factors
    degree = math.lcm(*(exponent.q for _, exponent in roots))
    if degree > 3:
        return _separate_powers(number, whole, roots, degree)
    inside = sp.Mul(*(base ** (exponent * degree) for base, exponent in roots))
    if all(factor.is_number for factor in whole):
        inside, number = inside * number**degree, sp.S.One
    text, _ = _power(sp.powdenest(inside), sp.Rational(1, degree))
    return text, number, whole


def _separate_powers(
    number: sp.Rational, whole: list[sp.Expr], roots: list[tuple[sp.Expr, sp.Rational]], degree: int
) -> tuple[str, sp.Rational, list[sp.Expr]]:
    """High roots by exponent, (F/E)**(6/7) and not (F**6/E**6)**(1/7), which would leave the range of doubles."""
    groups: dict[sp.Rational, sp.Expr] = {}
    for base, exponent in roots:
        if base.is_number:
            groups[sp.Rational(1, degree)] = groups.get(sp.Rational(1, degree), sp.S.One) * base ** (exponent * degree)
        else:
            size = abs(exponent)
            groups[size] = groups.get(size, sp.S.One) * (base if exponent > 0 else 1 / base)
    if all(factor.is_number for factor in whole):
        least = sp.Rational(1, degree)
        groups[least], number = groups.get(least, sp.S.One) * number**degree, sp.S.One
    texts = [_power(groups[exponent], exponent)[0] for exponent in sorted(groups, reverse=True)]
    return " * ".join(texts), number, whole
