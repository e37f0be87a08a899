"""Functions, integrals and derivatives in print, and the names of the special functions."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any

import sympy as sp

from ..abel import masters
from .height import bracket
from .order import is_one_group

FUNCTIONS = {
    sp.sin: r"\sin", sp.cos: r"\cos", sp.tan: r"\tan", sp.asin: r"\arcsin", sp.acos: r"\arccos", sp.atan: r"\arctan",
    sp.sinh: r"\sinh", sp.cosh: r"\cosh", sp.tanh: r"\tanh", sp.log: r"\ln", sp.exp: r"\exp",
    sp.acosh: r"\operatorname{arcosh}", sp.asinh: r"\operatorname{arsinh}", sp.atanh: r"\operatorname{artanh}",
}  # fmt: skip
MASTER_NAMES = {
    masters.C0: r"\mathrm{C}_{0}", masters.LegendreChi2: r"\chi_{2}", masters.ArctanIntegral: r"\mathrm{Ti}_{2}",
    masters.Dawson: r"\mathrm{D}", sp.sign: r"\operatorname{sgn}", sp.Max: r"\max",
}  # fmt: skip


class FunctionPrinter(ABC):
    """What stands behind the factors of a product, printed around the sums of its arguments."""

    @abstractmethod
    def sum(self, expr: sp.Expr) -> str:
        """A sum in its order."""

    @abstractmethod
    def exponent(self, exponent: sp.Expr) -> str:
        """An expression on one level, with a solidus."""

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
        if kind is sp.beta:
            return r"\mathrm{B}" + bracket(",".join(map(self.small, e.args[:2])))
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
        name = {"w1D": r"w_{\mathrm{1D}}"}.get(kind.__name__, kind.__name__)
        return name + bracket(",".join(self.sum(x) for x in e.args))

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
        inner, variable = e.expr, e.variables[0]
        if isinstance(inner, sp.Function) and inner.args == (variable,):
            name = {"w1D": r"w_{\mathrm{1D}}"}.get(type(inner).__name__, type(inner).__name__)
            return f"{name}'({self.sum(variable)})"
        if inner.is_Symbol:
            return rf"\frac{{\mathrm{{d}}{self.sum(inner)}}}{{\mathrm{{d}}{self.sum(variable)}}}"
        return rf"\frac{{\mathrm{{d}}}}{{\mathrm{{d}}{self.sum(variable)}}}" + bracket(self.sum(inner))


def _is_small_fraction(argument: sp.Expr) -> bool:
    """pi k/2: symbols over a number, set as one small fraction."""
    number, rest = argument.as_coeff_Mul()
    return bool(number.is_Rational and number.q != 1 and number > 0 and all(x.is_Atom for x in rest.args or (rest,)))
