"""Parts of a page as plain data: rows, definition panel, check values, calls, derivation, evidence, notation."""

from __future__ import annotations

import ast
import doctest
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..abel import masters
from ..entry import Entry
from ..figures.values import Numbers, Values
from ..physics.systems import Problem, pool_of
from ..print.box import width
from ..print.formula import Printer
from ..print.words import domain, prose
from ..profiles.loads import Load
from ..profiles.pools import ELASTIC
from ..profiles.profile import Piece, Profile
from ..rows.row import kappa_row

INSIDE = ("0.1", "0.25", "0.5", "0.75", "0.9", "0.99")
OUTSIDE = ("1.01", "1.25", "1.5", "2", "5", "10")
CHECK_DIGITS = 12
SPECIAL = {
    sp.elliptic_f: "elliptic integrals", sp.elliptic_e: "elliptic integrals", masters.C0: r"$\mathrm C_0$",
    masters.LegendreChi2: r"Legendre's $\chi_2$", masters.ArctanIntegral: r"$\mathrm{Ti}_2$",
    masters.IncompleteBeta: "the incomplete Beta function", masters.StruveH: "Struve functions",
    masters.Dawson: "Dawson's function", sp.gamma: "the Gamma function",
}  # fmt: skip


def spaced(value: Any, digits: int = CHECK_DIGITS) -> str:
    """A number with `digits` decimals in groups of three: 2.993 222 846 126."""
    whole, _, decimals = _rounded(value, digits).partition(".")
    return whole + "." + r"\,".join(decimals[i : i + 3] for i in range(0, len(decimals), 3))


def _rounded(value: Any, digits: int) -> str:
    """Decimal text with exactly `digits` decimals, rounded to nearest."""
    scaled = int(mp.nint(abs(value) * mp.mpf(10) ** digits))
    whole, decimals = divmod(scaled, 10**digits)
    return f"{'-' if value < 0 else ''}{whole}.{decimals:0{digits}d}"


Side = Iterable[tuple[str, Any]]
"""Places over the contact radius as they are printed, and values there."""


def values_table(
    place: str, where: Iterable[str], heads: Side, columns: Sequence[tuple[str, str]], *sides: Side
) -> dict[str, Any]:
    """A table of check values: at which parameters, numbers by name, and two columns with the end of their keys."""
    left, right = ([(x, spaced(value)) for x, value in side] for side in sides)
    return {
        "place": place,
        "where": ", ".join(f"${text}$" for text in where),
        "heads": [(name, spaced(value)) for name, value in heads],
        "columns": tuple(columns),
        "rows": list(zip(left, right, strict=True)),
        "ratios": [],
    }


def check_table(profile: Profile, numbers: Numbers) -> dict[str, Any]:
    """Dimensionless values to twelve decimals, at the parameters of the sketch and E_star = 1."""
    force = "P" if numbers.place("p") == nt.x else r"F_{\mathrm N}"
    shown = [(s, v) for s, v in numbers.values.items() if s != nt.E_star and s not in dict(profile.abbreviations)]
    # the depth of a strip goes with the load, so that of the sketch is none of its parameters
    left_out = (nt.N, nt.d) if force == "P" else (nt.N,)
    where = [
        f"{nt.describe(s).latex if nt.known(s.name) else s.name}={float(v):g}" for s, v in shown if s not in left_out
    ]
    given = [text.partition("=")[0] for text in where]
    if force == "P":
        where.append("L=2.7\\,a")
    if profile.breaks:
        return _over_breaks(profile, numbers, where)
    with mp.workdps(numbers.digits):
        mean, depth, radius = numbers.mean_pressure, numbers.depth, numbers["a"]
        return values_table(
            numbers.place("p").name,
            where,
            # what is given stands among the parameters
            [one for one in (("d", depth), (force, numbers("F")), (r"\bar p", mean)) if one[0] not in given],
            [(r"p/\bar p", "p"), ("w/d", "d" if force == "P" else "w")],
            [(x, numbers("p", mp.mpf(x) * radius) / mean) for x in INSIDE],
            [(x, numbers("w", mp.mpf(x) * radius) / depth) for x in OUTSIDE],
        )


BREAKS = ("0.1", "0.25", "0.4", "0.6", "0.8", "0.95")
"""Of the table of a profile that breaks, over the contact radius; the pressure at half of that may be infinite."""


def _over_breaks(profile: Profile, numbers: Numbers, where: Sequence[str]) -> dict[str, Any]:
    """Depth, force, a pressure and a displacement of contacts that have grown to different sizes beyond the break."""
    (b,) = profile.breaks
    plane = numbers.place("p") == nt.x
    varied = {nt.describe(b).latex, *(nt.describe(s).latex for s in _instead(profile))}
    ratios = []
    with mp.workdps(numbers.digits):
        radius = numbers["a"]
        for text in BREAKS:
            length = numbers.values[nt.a] * sp.Rational(text)
            member = numbers.at(
                **{b.name: length}, **{s.name: x for s, x in _instead(profile, length, numbers).items()}
            )
            values = (
                member.depth,
                member("F"),
                member("p", radius / 2) / member.mean_pressure,
                member("w", 2 * radius) / member.depth,
            )
            ratios.append((text, [spaced(value) for value in values]))
    force, beside = ("P", "d") if plane else (r"F_{\mathrm N}", "w")
    return {
        "place": f"{nt.describe(b).latex}/a",
        "where": ", ".join(f"${text}$" for text in where if text.partition("=")[0] not in varied),
        "heads": [],
        "columns": (("d", "d"), (force, "P" if plane else "F"), (r"p(a/2)/\bar p", "p"), ("w(2a)/d", beside)),
        "rows": [],
        "ratios": ratios,
    }


def _instead(profile: Profile, length: sp.Expr = sp.S.One, numbers: Numbers | None = None) -> dict[sp.Symbol, sp.Expr]:
    """The parameter that a break follows from, where it is not one itself."""
    found = {}
    for symbol, expr in profile.abbreviations:
        own = profile.parameters[0]
        (solution,) = sp.solve(sp.Eq(symbol, expr), own)
        found[own] = solution.xreplace({**(numbers.values if numbers else {}), symbol: length})
    return found


STRIP = r"A flat strip of half-width $t$ under the load $P$ has the pressure $P/(\pi\sqrt{t^2-x^2})$. "
PLANE_START = STRIP + (
    r"A contact grows by strips of the load $P'(t)\,\mathrm dt$; pressure, slope and depth are one "
    r"algebraic integral each."
)
FLAT_START = STRIP + "The punch is such a strip; slope and depth are one integral of its pressure each."
CONCAVE_START = STRIP + (
    "The concave face is a sum of strips of negative load; what they leave of the load is carried by the widest "
    "strip, whose edge is fixed."
)
LOAD_START = (
    r"Equation (11.104) gives $w_{\mathrm{1D}}=(p_0 a/E^{*})\,\mathrm B(\tfrac12,s+1)\,(1-x^2/a^2)^{s+1/2}$ "
    r"with the exponent %s of $1-r^2/a^2$ in the pressure; (11.105) is then one moment, over $(0,r)$ "
    r"inside and over $(0,a)$ outside."
)
TILTED_START = (
    r"The strip carries $p=(\alpha+\beta x)/\sqrt{a^2-x^2}$. Load and moment fix $\alpha$ and $\beta$; the contact "
    r"loses the edge at which the pressure vanishes, $|e|=a/2$, and keeps the other."
)


def derivation(profile_id: str, profile: Profile, entries: Mapping[str, Entry]) -> str:
    """Which rule gives what, and which functions it takes."""
    if not entries or profile == ELASTIC:
        return ""
    if nt.e in profile.parameters:
        return TILTED_START
    if isinstance(profile, Load):
        free = profile.exponent == nt.sigma
        start = LOAD_START % ("$s$" if free else f"$s={Printer()(profile.exponent)}$")
    elif pool_of(profile_id).strip:
        face = CONCAVE_START if nt.h in profile.parameters else FLAT_START
        start = face if profile.complete else PLANE_START
    elif profile.complete:
        start = (
            r"A flat punch carries $E^{*}d/(\pi\sqrt{a^2-r^2})$ (11.15). With $w_{\mathrm{1D}}=d-g$ "
            r"the edge term of (11.107), "
            r"$E^{*}w_{\mathrm{1D}}(a)/(\pi\sqrt{a^2-r^2})$, remains, because the edge is fixed and $d$ is free."
        )
    else:
        start = (
            f"The slope {' and '.join(slopes(profile))} in (11.29) gives $g(a)$; force (11.20), pressure (11.23) and "
            f"displacement (11.26) are then one integral each."
        )
    needed = _functions(entries)
    open_ends = [f"${e.quantity.left}$" for e in entries.values() if e.status == "integral"]
    text = start + (f" The results need {_listed(needed)}." if needed else " All results are elementary.")
    if open_ends:
        names = _listed(open_ends)
        text += f" No closed form of {names} in standard functions was found; the integral that remains is regular."
    return text


def slopes(profile: Profile) -> list[str]:
    """The slope of every piece of a profile, with where it holds."""
    found = []
    for piece, where in _pieces(profile, "r"):
        derivative = sp.diff(piece.expr, nt.r)
        by_terms = sp.Add(*map(sp.factor, sp.Add.make_args(derivative)))
        slope = min((Printer()(form) for form in (derivative, by_terms, sp.factor(derivative))), key=width)
        found.append(f"$f'(r)={slope}${where}")
    return found


def _pieces(profile: Profile, place: str) -> Iterator[tuple[Piece, str]]:
    """Every piece of a profile with the words on where it holds, none of a profile of one piece."""
    lower = None
    for piece in profile.pieces:
        side, end = (r"\le ", piece.upper) if piece.upper is not None else (">", lower)
        yield piece, f" for ${place}{side}{Printer()(end)}$" if end is not None else ""
        lower = piece.upper


def _functions(entries: Mapping[str, Entry]) -> list[str]:
    found: list[str] = []
    for entry in entries.values():
        for case in entry.cases:
            for kind, name in SPECIAL.items():
                if case.expr.has(kind) and name not in found:
                    found.append(name)
    return sorted(found)


def _listed(names: list[str]) -> str:
    return names[0] if len(names) == 1 else ", ".join(names[:-1]) + " and " + names[-1]


PANEL = ("a", "f", "g", "d", "F")
"""Names of the symbols in the definition panel of a round profile."""


def symbols(entries: Mapping[str, Entry], further: Iterable[str] = PANEL) -> set[str]:
    """Names of the symbols that occur in the rows of a profile, and further ones."""
    found = {*further}
    for entry in entries.values():
        printed_symbols = {s.name for case in entry.cases for s in case.expr.free_symbols if isinstance(s, sp.Symbol)}
        found |= printed_symbols | {s.name for s in (entry.quantity.symbol, *entry.quantity.arguments)}
    return found


HALF_SPACE = r"homogeneous half-space, $1/E^{*}=\sum_i(1-\nu_i^2)/E_i$"
NOT_ABOVE, NOT_BELOW = r"\le ", r"\ge "


def panel(profile: Profile, entries: Mapping[str, Entry], plane: bool = False) -> list[tuple[str, str]]:
    """Label and content of each line of the definition panel."""
    if profile.contact == "prescribed":
        return _load_panel(profile)
    if not profile.pieces:
        shorthands = [
            rf"$\displaystyle {Printer()(symbol)}={Printer()(expr)}$" for symbol, expr in profile.abbreviations
        ]
        return [("Valid for", prose(profile.validity)), *(("Shorthand", text) for text in shorthands)]
    place = "x" if plane else "r"
    lines = [("Profile", shape_tex(profile, place))]
    # of these a rule says what their domain says, or more
    bounded = {rule.right for rule in profile.rules if rule.left.is_number}
    bounded |= {rule.left.args[0] for rule in profile.rules if isinstance(rule.left, sp.Abs)}
    parameters = [_domain(symbol) for symbol in profile.parameters if symbol not in bounded]
    for rule in profile.rules:
        left, right = Printer()(rule.left), Printer()(rule.right)
        if rule.left.is_number:
            parameters.append(f"${right}{'>' if rule.strict else NOT_BELOW}{left}$")
        else:
            parameters.append(f"${left}{'<' if rule.strict else NOT_ABOVE}{right}$")
    if len(profile.chain) > 1:
        parameters.append("$" + "<".join(Printer()(x) for x in profile.chain) + "$")
    lines.append(("Parameters" if len(parameters) > 1 else "Parameter", ", ".join(p for p in parameters if p)))
    shorthands = [f"${Printer()(symbol)}={Printer()(expr)}$" for symbol, expr in profile.abbreviations]
    if kappa := kappa_row(tuple(entries.values())):
        shorthands.append(rf"$\displaystyle {kappa}$\rule[-4mm]{{0pt}}{{9mm}}")
    if shorthands:
        lines.append(("Shorthand", ", ".join(shorthands)))
    lines.append(("Medium", HALF_SPACE.replace("half-space", "half-plane") if plane else HALF_SPACE))
    span = r"symmetric, $|x|\le a$" if plane else r"$0\le r\le a$"
    if profile.compact:
        start = Printer()(profile.breaks[0]) if profile.truncated else None
        lines.append(("Contact", rf"frictionless, compact, {span}" + (f", $a\\ge {start}$" if start else "")))
    elif plane:
        shape = "" if nt.e in profile.parameters else "symmetric, "
        lines.append(("Contact", f"frictionless, {shape}complete: edges fixed"))
    else:
        lines.append(("Contact", r"frictionless, complete: the edge $r=a$ is fixed, $d$ is free"))
    if profile.largest is not None:
        lines.append(("Largest", f"$a<{_largest(profile.largest)}$; beyond it the contact is not compact"))
    lines.append(("Valid for", prose(profile.validity)))
    if profile.limits:
        lines.append(("Limits", "; ".join(_limit(limit, "plane." if plane else "") for limit in profile.limits)))
    if profile.note:
        lines.append(("Note", prose(profile.note)))
    if profile.synonyms:
        lines.append(("Also called", prose(", ".join(profile.synonyms))))
    return lines


def _largest(bound: sp.Expr) -> str:
    number, rest = bound.as_coeff_Mul()
    return f"{mp.nstr(mp.mpf(str(number)), 6)}\\,{Printer()(rest)}"


def _limit(limit: Any, prefix: str) -> str:
    name = limit.target.replace("_", " ")
    approach = rf"${Printer()(limit.symbol)}\to {Printer()(sp.sympify(limit.value))}$"
    return rf"{approach} \hyperref[sec:{prefix}{limit.target}]{{{name}}}"


def _load_panel(profile: Profile) -> list[tuple[str, str]]:
    exponent = getattr(profile, "exponent", sp.S.Zero)
    pressure = Printer((nt.r, nt.a))(nt.p_0 * sp.Pow(1 - nt.r**2 / nt.a**2, exponent))
    return [
        ("Pressure", f"$\\displaystyle p(r)={pressure}$ for $r<a$, none outside"),
        ("Parameters", ", ".join(text for symbol in profile.parameters if (text := _domain(symbol)))),
        ("Medium", HALF_SPACE),
        ("Valid for", prose(profile.validity)),
    ]


def shape_tex(profile: Profile, place: str = "r") -> str:
    """f(r), piece by piece."""
    texts = []
    for piece, where in _pieces(profile, place):
        expr = Printer((nt.describe(place).symbol, piece.upper) if piece.upper is not None else ())(piece.expr)
        built_up = r"\rule[-3.6mm]{0pt}{8.4mm}" if r"\frac" in expr or r"\sum" in expr else ""
        texts.append(rf"{built_up}$\displaystyle f({place})={expr}${where}")
    return r",\newline ".join(texts)


def _domain(symbol: Any) -> str:
    """Domain of a parameter in print: 0 < theta < pi/2."""
    if isinstance(symbol, sp.IndexedBase):
        return r"$A_j\ge 0$, not all zero"
    text = domain(nt.describe(symbol))
    return f"${text}$" if text else ""


Signatures = dict[str, ast.arguments]


def signatures(source: str) -> Signatures:
    """The arguments of every public function of a module."""
    functions = (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef))
    return {node.name: node.args for node in functions if not node.name.startswith("_")}


Calls = dict[str, dict[str, str]]
"""Of the arguments, as they are written, by name; of every function, by name."""


def examples(source: str) -> Calls:
    """With what the example of every public function of a module calls it."""
    functions = [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    return {node.name: _values(node) for node in functions if not node.name.startswith("_")}


def _values(function: ast.FunctionDef) -> dict[str, str]:
    shown = doctest.DocTestParser().get_examples(ast.get_docstring(function) or "")
    calls = [
        node
        for one in shown
        for node in ast.walk(ast.parse(one.source))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == function.name
    ]
    if not calls:
        message = f"{function.name} has no example; a call that runs needs the values of one"
        raise ValueError(message)
    given = dict(zip((one.arg for one in function.args.args), calls[0].args, strict=False))
    given |= {one.arg: one.value for one in calls[0].keywords if one.arg}
    return {name: ast.unparse(value) for name, value in given.items()}


def assigned(entry: Entry, known: Calls) -> str:
    """The arguments of the function of an entry with the values of its example, a line each."""
    values = known[entry.quantity.function]
    return "\n".join(f"{name} = {value}" for name, value in values.items() if name != "control")


def imported(problem: Problem) -> str:
    """The import of the module of a problem."""
    folder, _, _ = problem.module.removesuffix(".py").rpartition("/")
    return f"from {folder.replace('/', '.')} import {problem.name}"


def called(problem: Problem, entry: Entry, known: Signatures) -> str:
    """The call of the function of an entry, its arguments by the names they have in print and in the signature."""
    found = known[entry.quantity.function]
    # one function gives pull-off under both controls, and the key says which
    positional = [repr(entry.quantity.control) if one.arg == "control" else one.arg for one in found.args]
    keywords = [f"{one.arg}={one.arg}" for one in found.kwonlyargs]
    return f"{problem.name}.{entry.quantity.function}({', '.join([*positional, *keywords])})"


POWER, ECCENTRICITY = sp.Integer(2), sp.Rational(3, 10)
"""Of the tables: the exponent of a pressure, the place of a load over the half-width."""


def given_table(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """Dimensionless values to twelve decimals, at unit lengths and loads."""
    return _pressed(profile, entries) if isinstance(profile, Load) else _tilted(profile, entries)


def _pressed(load: Load, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The displacement inside and outside the circle."""
    values: Values = {nt.a: sp.S.One, nt.p_0: sp.S.One, nt.E_star: sp.S.One, nt.sigma: POWER}
    numbers = Numbers(load, entries, values)
    free = [f"s={POWER}"] if nt.sigma in load.parameters else []
    with mp.workdps(numbers.digits):
        force = mp.pi / (1 + mp.mpf(str(sp.sympify(load.exponent).subs(nt.sigma, POWER).evalf(numbers.digits))))
        sides = [[(x, numbers("w", mp.mpf(x))) for x in places] for places in (INSIDE, OUTSIDE)]
        columns = [(r"w E^{*}/(p_0 a)", "w")] * 2
        return values_table("r", ["a=1", "p_0=1", *free], [(r"F_{\mathrm N}", force)], columns, *sides)


def _tilted(profile: Profile, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The pressure over its mean on either side of the middle, before an edge lifts off."""
    values: Values = {nt.a: sp.S.One, nt.P: sp.Integer(2), nt.E_star: sp.S.One, nt.e: ECCENTRICITY}
    numbers = Numbers(profile, entries, values)
    with mp.workdps(numbers.digits):
        heads = [(r"\varphi", numbers("phi")), (r"\bar p", mp.mpf(1))]
        sides = [[(s + x, numbers("p", mp.mpf(s + x))) for x in INSIDE] for s in ("-", "")]
        where = ["a=1", "P=2", f"e={float(ECCENTRICITY):g}"]
        return values_table("x", where, heads, [(r"p/\bar p", "p")] * 2, *sides)
