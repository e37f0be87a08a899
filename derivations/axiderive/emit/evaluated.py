"""Evaluation forms in print: how the catalogue computes an entry where that differs from the closed form."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import sympy as sp

from .. import notation as nt
from ..contact.medium import HOMOGENEOUS
from ..entry import Entry
from ..profiles.profile import Profile
from ..stable import opaque
from ..stable.chosen import chosen
from ..stable.forms import EvaluationForm, evaluation_form
from ..stable.gaps import angles_of_lengths
from ..stable.signs import facts_of
from ..stable.slopes import rate_key, slope_form
from .compact import Compact
from .naming import LEFT
from .printer import Printer
from .private import PrivateFunctions, without_subtraction
from .ranges import chain_of, condition, regions
from .rows import MOST_LINES, Region, broken, row
from .shorthand import LINE, with_kappa
from .width import width

Rows = list[dict[str, Any]]
SHOWN = {"d": "g(a)", "F": LEFT["F"], "p": LEFT["p"], "w": LEFT["w"]}
"""The quantities whose evaluation forms are printed, with their left sides."""


def evaluation_rows(profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]) -> Rows:
    """A row for each formula that is evaluated as another closed formula of at most three lines, or by a rule.

    `evidence` is that of the normal contact, whose measurements say which functions are closed formulas and which
    are rules; further kernels and iterations are only named in the table of the evidence.
    """
    measured = evidence.get("evaluation", {})
    powers = nt.n in profile.parameters or nt.coefficients in profile.parameters
    rows = []
    for suffix in SHOWN:
        if measured.get(suffix, {}).get("form") not in ("closed", "kernel", *("rule" for _ in [0] if powers)):
            continue
        entry = entries[suffix]
        for pairs, expr in regions(entry):
            chain = chain_of(entry, expr)
            lines = evaluated(SHOWN[suffix], expr, form_of(entry, expr, chain), chain)
            if len(lines) == 1 and lines[0].partition("=")[2] in " ".join(region.tex for region in row(entry).regions):
                continue  # the same in print
            if 0 < len(lines) <= MOST_LINES + 1 and max(map(width, lines)) <= LINE:
                rows.append(evaluation_row(entry, Region(condition(entry, pairs, chain, Printer(chain)), tuple(lines))))
    ruled = [suffix for suffix in ("F", "p", "w") if measured.get(suffix, {}).get("form") == "rule"]
    return rows + _by_rules(profile, entries, ruled)


def form_of(entry: Entry, expr: sp.Expr, chain: tuple[sp.Expr, ...]) -> EvaluationForm:
    """The evaluation form of a case, from what is known of its lengths."""
    facts = facts_of(chain, *((rule.left, rule.right) for rule in entry.profile.rules))
    variant = chosen(entry.key).below
    form = evaluation_form(expr, facts, variant)
    of_radius = entry.suffix in ("d", "F") and "lengths" in variant.rules
    return _short(angles_of_lengths(form) if of_radius else form, entry.profile)


def _short(form: EvaluationForm, profile: Profile) -> EvaluationForm:
    steps = tuple((name, without_subtraction(expr, profile.abbreviations)) for name, expr in form.steps)
    return EvaluationForm(steps, form.value, form.cancels)


def evaluation_row(entry: Entry, region: Region) -> dict[str, Any]:
    """The form of a case with its range."""
    return {
        "half": False,
        "comment": f"evaluation {entry.key}",
        "label": "Evaluated as",
        "small": region.condition and f"${region.condition}$",
        "tex": region.tex,
        "remark": "",
    }


def evaluated(left: str, expr: sp.Expr, form: EvaluationForm, chain: tuple[sp.Expr, ...]) -> list[str]:
    r"""The form as lines of one formula, roots as \sqrt{(x-y) (x+y)}; none if it loses digits or is the closed form."""
    value = form.value
    for name, definition in reversed(form.steps):
        value = value if isinstance(definition, opaque.Root) else value.subs(name, _plain(definition))
    roots = {name: sp.sqrt(x**2 - y**2) for name, (x, y) in _lengths(form).items()}
    if form.cancels or sp.expand(_spelled(value).subs(roots) - expr) == 0:
        return []
    return printed(left, form, chain)


def _integral_of(integrand: Callable[..., sp.Expr], low: sp.Expr, high: sp.Expr) -> sp.Integral:
    return sp.Integral(integrand(nt.t), (nt.t, low, high))


SPELLED: dict[Any, Callable[..., sp.Expr]] = {
    opaque.Arctan2: lambda y, x: sp.atan(y / x),
    opaque.GammaRatio: lambda x: sp.gamma(x + sp.S.Half) / sp.gamma(x),
    opaque.DepthOverHeight: lambda j: sp.sqrt(sp.pi) * sp.gamma(j / 2 + 1) / sp.gamma((j + 1) / 2),
    opaque.ArcStrips: lambda r, a, R: _integral_of(lambda t: sp.atanh(t / R) / sp.sqrt(t**2 - r**2), r, a),
    opaque.PowerPressure: lambda r, a, n: (
        a ** (1 - n) * _integral_of(lambda t: t ** (n - 1) / sp.sqrt(t**2 - r**2), r, a)
    ),
    opaque.PowerDisplacement: lambda r, a, n: (
        n / a**n * _integral_of(lambda t: t ** (n - 1) * sp.asin(t / r), sp.S.Zero, a)
    ),
    opaque.PowerPunches: lambda r, a, n: a**-n * _integral_of(lambda t: t**n / sp.sqrt(r**2 - t**2), sp.S.Zero, a),
    opaque.PowerStrips: lambda x, a, n: (
        n / a**n * _integral_of(lambda t: t ** (n - 1) / sp.sqrt(x**2 - t**2), sp.S.Zero, a)
    ),
}
"""Functions of the generated code without a name in print, as what they are."""


def _spelled(expr: sp.Expr) -> sp.Expr:
    for function, meaning in SPELLED.items():
        expr = expr.replace(function, meaning)
    return expr


GAPS = {
    opaque.ArctanGap: lambda x: x - sp.atan(x), opaque.TanhGap: lambda y, x: y - x,
    opaque.Log1p: lambda x: sp.log(1 + x), opaque.Expm1: lambda x: sp.exp(x) - 1,
}  # fmt: skip
"""Functions that keep the digits of a difference, as that difference."""
ANGLES, ROOTS = (r"\psi", r"\chi"), (r"\ell", "y")
"""Letters of what is named because it comes more than once."""


def printed(left: str, form: EvaluationForm, chain: tuple[sp.Expr, ...]) -> list[str]:
    """The value in lines that fit; an angle or a root that comes more than once by a letter, defined behind it."""
    value, names, angles, roots = form.value, dict[sp.Symbol, str](), list(ANGLES), list(ROOTS)
    shown: dict[sp.Symbol, sp.Expr] = {}
    texts: dict[sp.Symbol, str] = {}
    for name, definition in reversed(form.steps):
        often = _uses(name, (value, *shown.values())) > 1
        if isinstance(definition, opaque.Root) or name.name.startswith("root"):
            texts[name] = _root(definition)
            names[name] = roots.pop(0) if often and roots else texts[name]
        elif often and angles and not isinstance(definition, opaque.GammaRatio):  # that one has the name kappa
            names[name], shown[name] = angles.pop(0), _plain(definition)
        else:
            value = value.subs(name, _plain(definition))
            shown = {own: expr.subs(name, _plain(definition)) for own, expr in shown.items()}
    for gap, difference in GAPS.items():
        value = value.replace(gap, difference)
        shown = {name: expr.replace(gap, difference) for name, expr in shown.items()}

    def opened(x: sp.Expr, y: sp.Expr, root: sp.Expr) -> sp.Expr:
        whole = sp.Symbol(f"{x}-{y}", positive=True)
        names[whole] = f"({Printer(chain)(x - y)})"
        return sp.log(1 + (whole + root) / y)

    # x - y in brackets: in the order x + root - y it would lose digits
    value = value.replace(opaque.Arcosh, opened)
    short = with_kappa(_tidied(_spelled(value)))
    texts |= {name: Printer(chain, names)(expr) for name, expr in shown.items()}
    defined = [f"{names[name]}={texts[name]}" for name in (*shown, *texts) if names[name] != texts[name]]
    lines = broken(f"{left}=", short.expr, Printer(chain, names | short.names))
    for text in dict.fromkeys(defined):
        if width(lines[-1] + r",\qquad " + text) <= LINE:
            lines[-1] += r",\qquad " + text
        else:
            lines[-1] += ","
            lines.append(r"\qquad " + text)
    return lines


def _tidied(expr: sp.Expr) -> sp.Expr:
    """Equal powers taken together, in front of an integral too."""
    if not expr.has(sp.Integral):
        return sp.factor_terms(expr)
    return sp.Add(*(sp.powsimp(term) for term in sp.Add.make_args(sp.expand(expr))))


def _uses(name: sp.Symbol, exprs: tuple[sp.Expr, ...]) -> int:
    """How often the name is printed: a gap prints its argument twice, and a root is not raised to a power."""
    count = 0
    for expr in exprs:
        count += sum(e == name for e in sp.preorder_traversal(expr))
        count += sum(e.has(name) for e in expr.atoms(*GAPS))
        count += any(e.base == name and abs(e.exp) != 1 for e in expr.atoms(sp.Pow))
    return count


def _by_rules(profile: Profile, entries: Mapping[str, Entry], suffixes: list[str]) -> Rows:
    """The integrals that Gauss rules evaluate, and the slope g'(t) under them in its evaluation form."""
    if not suffixes or nt.coefficients in profile.parameters or nt.n in profile.parameters:
        return []
    compact = Compact(entries, PrivateFunctions(profile))
    start = Printer()(profile.breaks[0]) if profile.truncated else "0"
    rows = [
        {
            "half": True,
            "comment": f"rule {entries[suffix].key}",
            "label": "Evaluated as",
            "small": "by Gauss rules",
            "tex": _integral(suffix, start),
            "remark": "",
        }
        for suffix in suffixes
    ]
    for key, case in compact.regimes("d").items():
        form = slope_form(case.expr, compact.facts(case), chosen(rate_key(entries["d"])))
        chain = tuple(nt.t if x == nt.a else x for x in case.chain)
        lines = printed("g'(t)", _short(form, profile), chain)
        if max(map(width, lines)) > LINE:
            return []
        where = {"tip": "t<", "beyond": "t>"}[key] + Printer()(profile.breaks[0]) if len(compact.slopes) > 1 else ""
        rows.append(
            {
                "half": False,
                "comment": f"slope {entries['d'].key}",
                "label": "With the slope",
                "small": where and f"${where}$",
                "tex": Region("", tuple(lines)).tex,
                "remark": "",
            }
        )
    return rows


def _integral(suffix: str, start: str) -> str:
    """(11.23), (11.26) or (11.20) over the radii at which the profile is not flat."""
    if suffix == "p":
        low = "r" if start == "0" else rf"\max(r,{start})"
        scale = Printer()(HOMOGENEOUS.pressure_scale)
        return rf"p(r)={scale}\int_{{{low}}}^{{a}} \frac{{g'(t)}}{{\sqrt{{t^{{2}}-r^{{2}}}}}}\,\mathrm{{d}}t"
    if suffix == "w":
        scale = Printer()(HOMOGENEOUS.displacement_scale)
        return rf"w(r)={scale}\int_{{{start}}}^{{a}} g'(t) \arcsin \frac{{t}}{{r}}\,\mathrm{{d}}t"
    return rf"{LEFT['F']}={Printer()(HOMOGENEOUS.force_scale)}\int_{{{start}}}^{{a}} t g'(t)\,\mathrm{{d}}t"


def _plain(definition: sp.Expr) -> sp.Expr:
    return definition.replace(opaque.Arctan2, lambda y, x: sp.atan(y / x))


def _lengths(form: EvaluationForm) -> dict[sp.Symbol, tuple[sp.Expr, sp.Expr]]:
    return {name: definition.args for name, definition in form.steps if isinstance(definition, opaque.Root)}


def _root(definition: sp.Expr) -> str:
    if not isinstance(definition, opaque.Root):
        return Printer()(definition)
    one, other = map(Printer(), definition.args)
    return rf"\sqrt{{({one}-{other}) ({one}+{other})}}"
