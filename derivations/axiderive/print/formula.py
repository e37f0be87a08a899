r"""Formulas as a person would print them, names and functions included.

Order of a product: number, pi, material, load, geometry, root, brackets,
functions.  One root holds all fractional powers, a sum starts with a positive
term, a function without brackets takes exactly one factor (what `readback`
relies on), and \left( is never used.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from .. import notation as nt
from ..abel import masters
from .box import bracket
from .terms import (
    RAISED,
    TRIGONOMETRIC,
    Factor,
    Product,
    Root,
    common_out,
    common_power,
    factor_key,
    has_fraction,
    is_function,
    is_one_group,
    is_scale,
    samples,
    taken_apart,
    term_key,
)

FUNCTIONS = {
    sp.sin: r"\sin", sp.cos: r"\cos", sp.tan: r"\tan", sp.asin: r"\arcsin", sp.acos: r"\arccos", sp.atan: r"\arctan",
    sp.sinh: r"\sinh", sp.cosh: r"\cosh", sp.tanh: r"\tanh", sp.log: r"\ln", sp.exp: r"\exp",
    sp.acosh: r"\operatorname{arcosh}", sp.asinh: r"\operatorname{arsinh}", sp.atanh: r"\operatorname{artanh}",
}  # fmt: skip
MASTER_NAMES = {
    masters.C0: r"\mathrm{C}_{0}", masters.LegendreChi2: r"\chi_{2}", masters.ArctanIntegral: r"\mathrm{Ti}_{2}",
    masters.Dawson: r"\mathrm{D}", sp.sign: r"\operatorname{sgn}",
}  # fmt: skip


def _is_small_fraction(argument: sp.Expr) -> bool:
    """pi k/2: symbols over a number, set as one small fraction."""
    number, rest = argument.as_coeff_Mul()
    return bool(number.is_Rational and number.q != 1 and number > 0 and all(x.is_Atom for x in rest.args or (rest,)))


NAMED = (r"\sin", r"\cos", r"\tan")
PLAIN = (*TRIGONOMETRIC, sp.sign, sp.Abs)
"""Functions of a symbol that a numerator may hold."""
COUNTED = {nt.n, nt.k, nt.sigma, nt.alpha, nt.j, nt.N, sp.Symbol("m", positive=True)}
"""What a plain number is added to behind, as in n + 1; to everything else it is added in front: 1 + x."""
EXPONENTS_OF_GRADING = (sp.Rational(-99, 100), sp.Rational(99, 100))


class Printer:
    """Prints SymPy expressions; `chain` is the ascending order of lengths that is known to hold."""

    def __init__(self, chain: tuple[sp.Expr, ...] = (), names: Mapping[sp.Symbol, str] | None = None) -> None:
        self.names = names or {}
        self.samples = samples(chain)
        self._products, self._signs = _known(chain, frozenset(self.names.items()))

    def __call__(self, expr: sp.Expr) -> str:
        if isinstance(expr, sp.Equality):
            return f"{self.sum(expr.lhs)}={self.sum(expr.rhs)}"
        return self.sum(expr)

    def positive(self, expr: sp.Expr) -> bool:
        """Whether the chain makes the expression positive."""
        if expr not in self._signs:
            self._signs[expr] = self._is_positive(expr)
        return self._signs[expr]

    def _is_positive(self, expr: sp.Expr) -> bool:
        if expr.free_symbols == {nt.k}:
            return all(_is_positive(expr.xreplace({nt.k: end})) for end in EXPONENTS_OF_GRADING)
        if not self.samples or expr.free_symbols - set(self.samples[0]):
            return False
        return all(_is_positive(expr.xreplace(sample)) for sample in self.samples)

    # sums

    def terms(self, expr: sp.Expr) -> list[tuple[int, str]]:
        """Sign and text of each term, the first one positive if any is."""
        rows = [(*self.product(term), term) for term in sp.Add.make_args(expr)]
        if len(rows) > 1:
            counted = expr.free_symbols <= COUNTED
            rows.sort(key=lambda row: (row[0] < 0, counted or not row[2].is_number, term_key(row[2])))
        return [(sign, text) for sign, text, _ in rows]

    def sum(self, expr: sp.Expr) -> str:
        """LaTeX of an expression as a sum with its signs, a positive term first if there is one."""
        out = ""
        for sign, text in self.terms(expr):
            out += ("-" if sign < 0 else "+" if out else "") + text
        return out

    # products

    def product(self, expr: sp.Expr) -> tuple[int, str]:
        """Sign and LaTeX of one term without its sign."""
        if expr not in self._products:
            parts = taken_apart(expr, self.positive)
            self._products[expr] = parts.sign, self._layout(parts)
        return self._products[expr]

    def scaled_sum(self, expr: sp.Expr) -> tuple[int, str, list[tuple[int, str]]] | None:
        """Sign, scale and terms of `scale * (sum)`, for breaking the sum over lines."""
        if expr.is_Add:
            return 1, "", self.terms(expr)
        parts = taken_apart(expr, self.positive)
        sums = [base for base, exponent in parts.factors if base.is_Add and exponent == 1]
        if len(sums) != 1 or any(_stands_behind(base) for base, e in parts.factors if base is not sums[0] and e == 1):
            return None
        rest = tuple((b, e) for b, e in parts.factors if b is not sums[0])
        scale = Product(1, parts.number, rest, parts.root)
        return parts.sign, "" if scale == Product(1, sp.S.One, ()) else self._layout(scale), self.terms(sums[0])

    def _layout(self, parts: Product, under_root: bool = False) -> str:
        """One product: scale as a fraction, then root, brackets and functions; under a root one fraction."""
        above: list[Factor] = []
        below: list[Factor] = []
        behind: list[Factor] = []
        for base, exponent in parts.factors:
            if exponent.could_extract_minus_sign() and not self._grows(exponent):
                below.append((base, -exponent))
            elif is_scale(base):
                above.append((base, exponent))
            else:
                behind.append((base, exponent))
        root_above, root_below = self._root(parts.root)
        number, below_root = parts.number, [root_below] if root_below else []
        sums = [factor for factor in behind if self._plain(*factor)]
        bare_sums = len(sums) == 1 or (sums == behind and len(below) > 0)
        if (below or number.q != 1) and not (above or root_above) and number.p == 1 and sums and bare_sums:
            above, behind = sums, [factor for factor in behind if factor not in sums]
        elif (
            below
            and sums
            and (root_above or len(sums) < len(behind) or any(b.is_Add and not is_scale(b) for b, _ in below))
        ) or (under_root and number.q + len(below) > 1):
            above, behind = above + sums, [factor for factor in behind if factor not in sums]
        alone = bool(below or below_root or number.q != 1) or not (behind or root_above)
        bare = len(above) == 1 and above[0][0].is_Add and above[0][1] == 1 and number.p == 1 and alone
        top = [self.sum(above[0][0])] if bare else self._scale(number.p, above)
        bottom = self._scale(number.q, below)
        place = (number.q != 1) if parts.root and below_root and _is_of_pi(parts.root) else len(bottom)
        bottom[place:place] = below_root
        if parts.root and root_above and _is_of_pi(parts.root):
            top, root_above = [*top[: number.p != 1], root_above, *top[number.p != 1 :]], ""
        out = []
        if below or below_root or (number.q != 1 and any(b.is_Add or isinstance(b, sp.gamma) for b, _ in above)):
            if len(below) == 1 and number.q == 1 and not below_root and below[0][1] == 1 and below[0][0].is_Add:
                bottom = [self.sum(below[0][0])]
            if bottom:
                out.append(rf"\frac{{{' '.join(top) or '1'}}}{{{' '.join(bottom)}}}")
            else:
                out += top
        elif number.q != 1:
            pi = [t for t in top if t == r"\pi"]
            rest = [t for t in top if t != r"\pi"]
            digits = rest[:1] if number.p != 1 else []
            out.append(rf"\tfrac{{{' '.join(digits + pi) or '1'}}}{{{number.q}}}")
            out += ([r"\,"] if rest[len(digits) :] else []) + rest[len(digits) :]
        else:
            out += top
        tail = ([root_above] if root_above else []) + [self._bracketed(b, e) for b, e in behind if b.is_Add]
        for text in (self._power(b, e) for b, e in sorted(behind, key=factor_key) if not b.is_Add):
            apart = tail and (tail[-1][-1] in ")]" or tail[-1].startswith(NAMED)) and text.startswith(r"\math")
            tail += [r"\,", text] if apart else [text]
        if (
            out
            and tail
            and (
                tail[0][-1:] in ")]"
                or tail[0].startswith((r"\Bigl", r"\bigl", r"\biggl", r"\Biggl", r"\operatorname", r"\mathrm", "{}_"))
            )
        ):
            out.append(r"\,")
        return " ".join(out + tail) or "1"

    def _grows(self, exponent: sp.Expr) -> bool:
        """Whether an exponent of the grading is positive as it stands: (1 - k)/2, in which SymPy sees a minus."""
        return exponent.free_symbols == {nt.k} and self.positive(exponent)

    def _plain(self, base: sp.Expr, exponent: sp.Expr) -> bool:
        """Whether a bracket may become the numerator: a short sum without functions of more than a symbol."""
        return (
            base.is_Add
            and exponent.is_Integer
            and len(base.args) <= 3
            and all(isinstance(f, PLAIN) and f.args[0].is_Symbol for f in base.atoms(sp.Function))
            and not has_fraction(base)
        )

    def _scale(self, number: int, factors: list[Factor]) -> list[str]:
        digits = [str(number)] if number != 1 else []
        return digits + [self._power(base, exponent) for base, exponent in sorted(factors, key=factor_key)]

    def _root(self, root: Root | None) -> tuple[str, str]:
        """The root as a factor above or, if its radicand is a mere denominator, below the line."""
        if root is None:
            return "", ""
        below = root.number.p == 1 and all(e < 0 for _, e in root.factors)
        root = root if below else common_out(root)
        factors = tuple((b, -e if below else e) for b, e in root.factors)
        number = 1 / root.number if below else root.number
        if len(factors) == 1 and number == 1 and factors[0][0].is_Add and factors[0][1] == 1:
            inside = self.sum(factors[0][0])
        else:
            inside = self._layout(Product(1, number, factors), under_root=True)
        text = (r"\sqrt{" if root.index == 2 else rf"\sqrt[{root.index}]{{") + inside + "}"
        return ("", text) if below else (text, "")

    # factors

    def _power(self, base: sp.Expr, exponent: sp.Expr) -> str:
        if exponent == 1:
            return self._atom(base)
        base, common = common_power(base)
        exponent *= common
        power = self.exponent(exponent)
        if isinstance(base, RAISED) and exponent.is_Integer and exponent > 0:
            return self._call(base, f"^{{{power}}}")
        if base.is_Symbol or base is sp.pi:
            text = self._atom(base)
            return f"{text[:-1]}{power}}}" if text.endswith("^{*}") else f"{text}^{{{power}}}"
        return f"{self._bracketed(base, sp.S.One)}^{{{power}}}"

    def exponent(self, exponent: sp.Expr) -> str:
        """LaTeX of an exponent, a fraction with a slash: (n+1)/2."""
        above, below = sp.fraction(sp.together(exponent))
        if below == 1:
            return self.sum(exponent)
        top, bottom = self.sum(above), self.sum(below)
        return f"{f'({top})' if above.is_Add else top}/{f'({bottom})' if below.is_Add else bottom}"

    def _bracketed(self, base: sp.Expr, exponent: sp.Expr) -> str:
        text = bracket(self.sum(base))
        return text if exponent == 1 else f"{text}^{{{self.exponent(exponent)}}}"

    def _atom(self, e: sp.Expr) -> str:
        if e.is_Symbol:
            return self.names.get(e) or nt.describe(e).latex
        if isinstance(e, sp.Indexed):
            return self.names.get(e) or f"{e.base.label}_{{{self.sum(e.indices[0])}}}"
        if e is sp.pi:
            return r"\pi"
        if e is sp.E:
            return r"\mathrm{e}"
        if e.is_Add:
            return self._bracketed(e, sp.S.One)
        if e.is_Integer:
            return str(e)
        if e.is_Float:
            return f"{float(e):.6g}"
        if isinstance(e, sp.Integral):
            return self._integral(e)
        if isinstance(e, sp.Sum):
            (j, lo, hi) = e.limits[0]
            sign, body = self.product(e.function)
            return rf"\sum_{{{self.sum(j)}={self.sum(lo)}}}^{{{self.sum(hi)}}}" + (
                f"({'-' + body})" if sign < 0 else rf" {body}"
            )
        if isinstance(e, sp.Derivative):
            return self._derivative(e)
        if isinstance(e, sp.Abs):
            return rf"\lvert {self.sum(e.args[0])}\rvert"
        if isinstance(e, sp.Function):
            return self._call(e)
        if e.is_Pow or e.is_Mul:
            sign, text = self.product(e)
            return f"(-{text})" if sign < 0 else text
        message = f"no print form for {type(e).__name__}: {e}"
        raise TypeError(message)

    # functions, around the sums of their arguments

    def _call(self, e: Any, power: str = "") -> str:
        kind = type(e)
        if kind in FUNCTIONS:
            return self._named(FUNCTIONS[kind] + power, e.args[0], always=kind is sp.exp)
        if kind in MASTER_NAMES:
            return MASTER_NAMES[kind] + bracket(",".join(self.sum(x) for x in e.args))
        if kind in (sp.elliptic_f, sp.elliptic_e):
            letter = r"\mathrm{F}" if kind is sp.elliptic_f else r"\mathrm{E}"
            return letter + bracket(",".join([*map(self.small, e.args[:-1]), self.small(sp.sqrt(e.args[-1]))]))
        if kind is sp.elliptic_k:
            return r"\mathrm{K}" + bracket(self.small(sp.sqrt(e.args[0])))
        if kind is sp.gamma:
            return r"\Gamma" + bracket(self.small(e.args[0]))
        if kind is masters.IncompleteBeta:
            z, p, q = e.args
            return r"\mathrm{B}" + bracket(f"{self.sum(z)};{self.small(p)},{self.small(q)}")
        if kind in (masters.StruveH, masters.StruveL):
            letter = r"\mathbf{H}" if kind is masters.StruveH else r"\mathbf{L}"
            return f"{letter}_{{{self.exponent(e.args[0])}}}" + bracket(self.sum(e.args[1]))
        if kind in (masters.Hypergeometric, masters.Kummer):
            *upper, lower, z = e.args
            inside = ";".join([",".join(map(self.small, upper)), self.small(lower), self.sum(z)])
            return rf"{{}}_{{{len(upper)}}}\mathrm{{F}}_{{1}}" + bracket(inside)
        if kind is masters.CapMoment:
            exponent, *lengths = map(self.sum, e.args)
            return r"\mathrm{J}" + bracket(f"{exponent};" + ",".join(lengths))
        if kind in (masters.Xi, masters.Eta):
            letter = r"\xi" if kind is masters.Xi else r"\eta"
            return letter if e.args[2] == nt.a else f"{letter}_{{{self.exponent(e.args[2])}}}"
        return _function_name(kind) + bracket(",".join(self.sum(x) for x in e.args))

    def _named(self, name: str, argument: sp.Expr, always: bool = False) -> str:
        text = self.small(argument) if _is_small_fraction(argument) else self.sum(argument)
        one_factor = argument.is_Symbol or argument.is_Integer or is_one_group(text)
        return f"{name} {text}" if one_factor and not always else name + bracket(text)

    def small(self, expr: sp.Expr) -> str:
        """An argument with small fractions: Gamma((n + 1)/2), F(phi, r/b)."""
        above, below = sp.fraction(sp.together(expr))
        if below == 1:
            return self.sum(expr).replace(r"\frac", r"\tfrac")
        return rf"\tfrac{{{self.sum(above)}}}{{{self.sum(below)}}}"

    def _integral(self, e: sp.Integral) -> str:
        variable, lo, hi = e.limits[0]
        body = e.function
        text = bracket(self.sum(body)) if body.is_Add else self.sum(body)
        return rf"\int_{{{self.exponent(lo)}}}^{{{self.exponent(hi)}}} {text}\,\mathrm{{d}}{self.sum(variable)}"

    def _derivative(self, e: sp.Derivative) -> str:
        """Of a function of the row, f'(t)."""
        return f"{_function_name(type(e.expr))}'({self.sum(e.variables[0])})"


@lru_cache(maxsize=256)
def _known(
    chain: tuple[sp.Expr, ...], names: frozenset[tuple[sp.Symbol, str]]
) -> tuple[dict[sp.Expr, tuple[int, str]], dict[sp.Expr, bool]]:
    """Products and signs that were found: a formula is set several times over until it fits."""
    return {}, {}


def _function_name(kind: type[sp.Function]) -> str:
    return r"w_{\mathrm{1D}}" if kind.__name__ == "w1D" else kind.__name__


def _is_of_pi(root: Root) -> bool:
    """Whether the root is a number, which stands in front."""
    return [base for base, _ in root.factors] in ([], [sp.pi])


def _stands_behind(base: sp.Expr) -> bool:
    """A function that is no scale of a sum; cos(pi k/2) is one."""
    return is_function(base) and not isinstance(base, TRIGONOMETRIC)


def _is_positive(value: sp.Expr) -> bool:
    """Whether a number is real and positive; outside the range of a formula it may be neither."""
    turned = value.could_extract_minus_sign()
    plain = -value if turned else value
    if all(_is_over_square(term) for term in sp.Add.make_args(plain)):
        return not turned
    number = _number(plain)
    return bool(number.is_Float and (number < 0 if turned else number > 0))


def _is_over_square(term: sp.Expr) -> bool:
    """An integral that is positive without its value, which takes seconds."""
    if not isinstance(term, sp.Integral) or not term.function.is_Pow or term.function.exp != 2:
        return False
    _, low, high = term.limits[0]
    return _is_positive(high - low)


@lru_cache(maxsize=4096)
def _number(value: sp.Expr) -> sp.Expr:
    """In digits; the sign of a bracket is asked for ten times on a page."""
    return value.evalf(15)
