"""Shorthand for what recurs in a long formula: roots, angles, the Gamma quotient of power laws.

A shorthand never changes the value: every printed row is read back with its
definitions and compared with the unabbreviated result.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, field

import sympy as sp

from ..code.text import written
from ..notation import R, a, b, n, psi, r, u
from ..notation import j as index
from .box import width
from .formula import Printer

LINE = 356.0
"""Points available for a formula between label and key."""

ANGLES = (sp.asin, sp.acos, sp.atan, sp.atanh, sp.log)
ELLIPTIC = (sp.elliptic_f, sp.elliptic_e)
FIXED = {sp.acos(b / a): (r"\varphi_{0}", "phi0"), sp.asin(a / r): (r"\psi", "psi_")}
ANGLE_NAMES = ((r"\varphi", "phi"), (r"\omega", "omega"), (r"\eta", "eta"), (r"\zeta", "zeta"))
ROOTS = {r**2 - a**2: "s", a**2 - r**2: "s", a**2 - b**2: "q", r**2 - b**2: "v", b**2 - r**2: "v", R**2 - b**2: "m"}
ROOT_NAMES = ("s", "q", "v", "m", r"\ell", "y", "z")
RADIUS = "t"


@dataclass
class Short:
    """A formula with its definitions, in the order in which they were made; later ones may stand in earlier ones."""

    expr: sp.Expr
    definitions: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    names: dict[sp.Symbol, str] = field(default_factory=dict)
    taken: set[str] = field(default_factory=set)

    def name(self, target: sp.Expr, candidates: tuple[tuple[str, str], ...]) -> None:
        """Give the target the first free name."""
        for tex, plain in candidates:
            if tex not in self.taken and plain not in self.taken:
                break
        else:
            return
        symbol = sp.Symbol(f"{plain}'", positive=True)
        self.taken |= {tex, plain}
        self.names[symbol] = tex
        self.expr = _replaced(self.expr, target, symbol)
        self.definitions = {s: _replaced(d, target, symbol) for s, d in self.definitions.items()}
        self.definitions[symbol] = target

    def count(self, target: sp.Expr) -> int:
        """Occurrences, a root counted in whatever half power it comes."""
        return sum(_count(e, target) for e in (self.expr, *self.definitions.values()))


def shortened(expr: sp.Expr, chain: tuple[sp.Expr, ...], width_before: float = 0.0) -> Short:
    """The formula with as many definitions as it needs to fit on a line, or to be read."""
    short = with_kappa(_merged_roots(_constants_out(expr)))
    if not short.expr.has(sp.Integral):
        short.expr = _gathered(short.expr)
    short.taken = {s.name for s in expr.free_symbols}
    if expr.has(sp.Integral):
        _name_radius(short)
    amplitudes = {call.args[0] for call in _calls(short.expr, ELLIPTIC) if len(call.args) == 2}
    for amplitude in sorted(amplitudes, key=written):
        short.name(amplitude, ANGLE_NAMES)
    for step in (_recurring_roots, _composite_angles, _recurring_angles, _all_roots):
        if width_before + width(Printer(chain, short.names)(short.expr)) <= LINE and not _nested(short.expr):
            break
        step(short)
    return short


def with_kappa(expr: sp.Expr) -> Short:
    """kappa = sqrt(pi) Gamma(n/2 + 1)/Gamma((n + 1)/2), the depth of a power law r^n at a = 1."""
    short = Short(expr)
    for exponent, name in ((n, r"\kappa"), (index, r"\kappa_{j}")):
        above, below = sp.gamma(exponent / 2 + 1), sp.gamma((exponent + 1) / 2)
        found = short.expr.replace(lambda e: isinstance(e, sp.gamma), lambda e: sp.gamma(sp.factor(e.args[0])))
        if not _calls(found, (sp.gamma,)) or not found.has(exponent):
            continue
        kappa = sp.Symbol("kappa", positive=True) if exponent == n else sp.IndexedBase("kappa")[index]
        low = sp.Symbol("low", positive=True)
        same = {g: kappa * low / sp.sqrt(sp.pi) if sp.expand(g.args[0] - exponent / 2 - 1) == 0 else low
                for g in found.atoms(sp.gamma)}  # fmt: skip
        replaced = found.xreplace(same).replace(lambda e: e.is_Pow, lambda e: sp.Pow(_cancelled(e.base), e.exp))
        if replaced.has(low):
            replaced = sp.factor_terms(sp.expand(replaced))
        if replaced.has(low):  # other Gamma functions take part, as on the graded half-space
            continue
        short.expr = _constants_out(replaced)
        short.definitions[kappa] = sp.sqrt(sp.pi) * above / below
        short.names[kappa] = name
    return short


def _gathered(expr: sp.Expr) -> sp.Expr:
    """Terms of the same root or function under one bracket: d/s + 2 h/s -> (d + 2 h)/s."""

    def collected(total: sp.Add) -> sp.Expr:
        groups: dict[sp.Expr, list[sp.Expr]] = {}
        for term in total.args:
            plain: list[sp.Expr] = []
            special: list[sp.Expr] = []
            for factor in sp.Mul.make_args(term):
                (special if factor.atoms(sp.Function) or _radicands(factor) else plain).append(factor)
            groups.setdefault(sp.Mul(*special), []).append(sp.Mul(*plain))
        if len(groups) == len(total.args):
            return total
        return sp.Add(*(key * (sp.factor(sp.Add(*own)) if key != 1 else sp.Add(*own)) for key, own in groups.items()))

    return expr.replace(lambda e: e.is_Add and (e.atoms(sp.Function) or _radicands(e)), collected)


def _cancelled(base: sp.Expr) -> sp.Expr:
    return sp.factor(base) if base.is_Mul else base


def _constants_out(expr: sp.Expr) -> sp.Expr:
    """Factors that do not depend on j stand before the sum over j."""

    def pulled(total: sp.Sum) -> sp.Expr:
        constant, inside = total.function.as_independent(index)
        return constant * sp.Sum(inside, *total.limits)

    return expr.replace(lambda e: isinstance(e, sp.Sum), pulled)


def _merged_roots(expr: sp.Expr) -> sp.Expr:
    """sqrt(R - b) sqrt(R + b) -> sqrt(R^2 - b^2), wherever both occur."""
    for one, other in itertools.combinations(sorted(_radicands(expr), key=written), 2):
        twice, gap = one + other, one - other
        if len(one.args) == len(other.args) == 2 and not twice.is_Add and not gap.is_Add:
            whole = sp.sqrt(sp.expand(one * other))
            expr = expr.replace(
                lambda e, base=one: e.is_Pow and e.base == base and e.exp.is_Rational and e.exp.q == 2,
                lambda e, rest=other, all_=whole: (all_ / sp.sqrt(rest)) ** (2 * e.exp),
            )
    return expr


def _name_radius(short: Short) -> None:
    """t = sqrt(r^2 + u^2) under an integral over u, t = r sin(psi) under one over psi."""
    t = sp.Symbol("t'", positive=True)
    (variable,) = {e.limits[0][0] for e in short.expr.atoms(sp.Integral)}
    if variable not in (u, psi):
        return
    radius = sp.sqrt(r**2 + u**2) if variable == u else r * sp.sin(psi)

    def renamed(integral: sp.Integral) -> sp.Integral:
        body = (
            integral.function.subs(u, sp.sqrt(t**2 - r**2))
            if variable == u
            else integral.function.subs(sp.sin(psi), t / r)
        )
        weight, slope = (sp.S.One, body) if variable == u else body.as_independent(t, as_Add=False)
        return sp.Integral(weight * _single_terms(slope), integral.limits[0])

    short.expr = short.expr.replace(lambda e: isinstance(e, sp.Integral), renamed)
    short.names[t] = RADIUS
    short.taken.add(RADIUS)
    short.definitions[t] = radius


def _single_terms(body: sp.Expr) -> sp.Expr:
    """The body as a sum of single terms, those of one function together; sums in denominators stay whole."""
    body = body.replace(lambda e: e.is_Pow and e.exp in (sp.S.Half, -sp.S.Half), _one_root)
    functions = sorted(body.atoms(sp.Function), key=lambda f: (-sp.count_ops(f), written(f)))
    dummies = {f: sp.Dummy(f"f{i}", positive=True) for i, f in enumerate(functions)}
    body = body.xreplace(dummies)
    sums = sorted({e.base for e in body.atoms(sp.Pow) if e.base.is_Add and e.exp.is_number}, key=written)
    dummies |= (whole := {e: sp.Dummy(f"s{i}", positive=True) for i, e in enumerate(sums)})
    terms = sp.collect(sp.expand(body.xreplace(whole)), [dummies[f] for f in functions], evaluate=False)
    gathered = [(factor if key == 1 else sp.factor(factor)) * key for key, factor in terms.items()]
    back = {d: f for f, d in dummies.items()}
    return sp.Add(*gathered).xreplace(back).xreplace(back)


def _one_root(power: sp.Expr) -> sp.Expr:
    above, below = sp.fraction(sp.together(power.base))
    return sp.Pow(sp.expand(above), power.exp) / sp.Pow(below, power.exp)


def _recurring_angles(short: Short) -> None:
    for angle, name in FIXED.items():
        if short.count(angle) >= 2:
            short.name(angle, (name,))
    for call in sorted(_calls(short.expr, ANGLES), key=written):
        if short.count(call) >= 2 and call not in FIXED:
            short.name(call, ANGLE_NAMES)


def _composite_angles(short: Short) -> None:
    """Angles whose argument is a root or a quotient of roots."""
    for call in sorted(_calls(short.expr, ANGLES), key=written):
        if call.atoms(sp.Pow) and any(p.exp.is_Rational and p.exp.q == 2 for p in call.atoms(sp.Pow)) and _nested(call):
            short.name(call, ANGLE_NAMES)


def _recurring_roots(short: Short) -> None:
    for base in sorted(_radicands(short.expr), key=_familiar_first):
        if short.count(sp.sqrt(base)) >= 2:
            _name_root(short, base)


def _all_roots(short: Short) -> None:
    for base in sorted(_radicands(short.expr), key=_familiar_first):
        _name_root(short, base)


def _familiar_first(base: sp.Expr) -> tuple[bool, str]:
    return base not in ROOTS, written(base)


def _name_root(short: Short, base: sp.Expr) -> None:
    names = [ROOTS[base]] if base in ROOTS else []
    names += [name for name in ROOT_NAMES if name not in names and not (name in ROOTS.values() and base not in ROOTS)]
    short.name(sp.sqrt(base), tuple((name, name) for name in names))


def _radicands(expr: sp.Expr) -> set[sp.Expr]:
    return {p.base for p in expr.atoms(sp.Pow) if p.exp.is_Rational and p.exp.q == 2 and p.base.is_Add}


def _calls(expr: sp.Expr, kinds: tuple[type, ...]) -> list[sp.Expr]:
    return [e for e in expr.atoms(sp.Function) if isinstance(e, kinds)]


def _nested(expr: sp.Expr) -> bool:
    """Whether a root stands inside a function of a function, which nobody reads."""
    return any(_radicands(call) and len(_radicands(call)) > 1 for call in _calls(expr, ANGLES))


def _count(expr: sp.Expr, target: sp.Expr) -> int:
    if target.is_Pow:
        return sum(
            e.is_Pow and e.base == target.base and e.exp.is_Rational and e.exp.q == 2
            for e in sp.preorder_traversal(expr)
        )
    return sum(e == target for e in sp.preorder_traversal(expr))


def _replaced(expr: sp.Expr, target: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    if target.is_Pow and target.exp == sp.S.Half:
        return expr.replace(
            lambda e: e.is_Pow and e.base == target.base and e.exp.is_Rational and e.exp.q == 2,
            lambda e: symbol ** (2 * e.exp),
        )
    return expr.xreplace({target: symbol})
