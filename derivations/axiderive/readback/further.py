r"""Formulas in print that are no rows of an entry.

Rows without a key of their own in the compiled source: limits and universal curves.

Which entries they are about stands in the comment above them: `%% limit cone.d`.

The mathematics in the words of the compiled source: everything between dollars that is no row of its own.

Each formula is found by the line it stands in, without the generator: a range
beside a row, an approach to a limit, a domain of a parameter, a number of a
table, a figure, or a sentence.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import mpmath as mp
import sympy as sp

from .. import notation as nt
from ..entry import Entry
from ..oracle.evaluate import case_at, evaluate, evaluate_case
from ..rows.points import points_of
from .compare import DIGITS, difference
from .grammar import read
from .meaning import Node
from .printed import bound, holds, name_in_print, name_of, named
from .source import GAP as LINES
from .source import OPENING, arguments, formulas, without_remark
from .statements import CLOSE

Stored = Callable[[str], Mapping[str, Entry]]
"""The entries of a problem by its key."""
GAP = r",\enspace "
NEAR = sp.Rational(1, 10**60)
"""How near to a limit that is excluded; the logarithms of the tips leave NEAR ln(NEAR)."""
KINDS = ("limit", "universal", "sum")
"""Kinds that are read here; approaches to an end have a reader of their own."""
ENDS = {
    "edge": (r"r\to a", r"x\to a"), "far-field": (r"r\to\infty", r"x\to\infty"), "axis": (r"r\to 0",),
    "middle": (r"x\to 0", r"r\to 0"), "small-contact": (r"a\to 0",), "onset": (r"a\to b",),
}  # fmt: skip
"""Where an approach goes, as it is printed beside its name; a condition may follow."""
_HEADS = re.compile(r"([a-z-]+)((?: [\w.]+\.\w+)+)")


@dataclass(frozen=True)
class Further:
    """A row as TeX sets it: its kind, the keys it is about, its range or approach, its formula."""

    kind: str
    keys: tuple[str, ...]
    small: str
    tex: str


def further(text: str) -> Iterator[Further]:
    """The rows of one source file in their order."""
    comment = ""
    for line in text.splitlines():
        if line.startswith("%% "):
            comment = line.removeprefix("%% ")
        elif line.startswith(r"\further"):
            whole = arguments(line)
            halves = [arguments(half) for half in whole] if line.startswith(r"\furtherpair") else [whole]
            kinds = _HEADS.findall(comment)
            for half, (kind, keys) in zip((half for half in halves if any(half[2:3])), kinds, strict=True):
                yield Further(kind, tuple(keys.split()), half[1].strip("$"), without_remark(half[2]))


def wrong(one: Further, stored: Stored) -> bool:
    """Whether a row says something else than the entries it is about."""
    return {"limit": _limit, "universal": _universal, "sum": _sum}[one.kind](one, stored)


def _limit(one: Further, stored: Stored) -> bool:
    parts = one.tex.split(GAP)
    if len(parts) != len(one.keys):
        return True
    profile = stored(one.keys[0].rpartition(".")[0])[one.keys[0].rpartition(".")[2]].profile
    aim = _aim(one.small, profile.parameters)
    return aim is None or any(
        _limit_differs(key, part, *aim, stored) for key, part in zip(one.keys, parts, strict=True)
    )


def _aim(small: str, parameters: Sequence[sp.Symbol]) -> tuple[sp.Symbol, sp.Expr] | None:
    """Which parameter goes where."""
    name, _, end = small.partition(r"\to")
    ends: dict[str, sp.Expr] = {"0": sp.S.Zero, r"\infty": sp.oo} | {name_in_print(s): s for s in parameters}
    symbol, value = ends.get(name.strip()), ends.get(end.strip())
    if value is None and end.strip().isdigit():
        value = sp.Integer(end)
    return None if symbol not in parameters or value is None else (symbol, value)


def _limit_differs(key: str, part: str, symbol: sp.Symbol, value: sp.Expr, stored: Stored) -> bool:
    problem, _, suffix = key.rpartition(".")
    entry = stored(problem)[suffix]
    left, _, right = part.partition(r"\to ")
    near = {sp.S.Zero: NEAR, sp.oo: 1 / NEAR}.get(value, value)
    tested = []
    # in the case that holds next to the limit, at points of any case: a limit may be that of one of them
    for _, values in points_of(entry, "formula", stored(problem), 1, 11):
        at = values | {symbol: sp.sympify(near).xreplace(values)}
        at |= {short: expr.xreplace(at) for short, expr in entry.profile.abbreviations}
        try:
            case = case_at(entry, at)
        except LookupError:
            continue
        with mp.workdps(DIGITS + 20):
            want = evaluate_case(case, at, DIGITS)
            # a printed limit is a formula of the simpler profile, which does not know the symbol
            env = {name: number for name, number in named(at).items() if name != name_in_print(symbol)}
            own = bound(name_of(entry), want, env)
            own = bound("g(a)", want, own) if suffix == "d" else own
            try:
                tested.append(all(difference(read(text)[0].members[0](own), want) <= CLOSE for text in (left, right)))
            except ValueError:  # a root of the case that does not hold here
                tested.append(False)
    if tested:
        return not any(tested)
    message = f"{key}: no point is near {symbol} = {value}"
    raise LookupError(message)


CURVE = (sp.Rational(3, 10), sp.S.One, sp.Rational(27, 10))
"""Radii over that of pull-off at which a universal curve is compared."""


def _universal(one: Further, stored: Stored) -> bool:
    problem = one.keys[0] if one.keys[0].endswith("adh") else one.keys[0].rpartition(".")[0]
    entries = stored(problem)
    fields = {s for suffix in ("ac", "Fc", "dc", "F", "d") for s in entries[suffix].cases[0].expr.free_symbols}
    values = {s: sp.Rational(11 + 2 * i, 7 + 3 * i) for i, s in enumerate(sorted(fields, key=str))}
    values |= {nt.theta: sp.Rational(2, 5), nt.k: sp.Rational(3, 8), nt.n: sp.Rational(17, 10)}
    with mp.workdps(2 * DIGITS):
        pulled = evaluate(entries["ac"].cases[0].expr, values, DIGITS)
        for ratio in CURVE:
            at = values | {nt.a_c: pulled, nt.a: pulled * mp.mpf(ratio.p) / ratio.q}
            env = named(at) | {"x": mp.mpf(ratio.p) / ratio.q}
            for name, suffix in (("F_adh", "F"), ("d_adh", "d"), ("F_c", "Fc"), ("d_c", "dc")):
                env[name] = evaluate(entries[suffix].cases[0].expr, at, DIGITS)
            if any(_unequal(statement.members, env) for statement in read(one.tex)):
                return True
    wanted = {f"{suffix}_adh" for suffix in ("F", "d") if f"{problem}.{suffix}" in one.keys}
    return not all(name.replace("_adh", r"_{\mathrm{adh}}") in one.tex for name in wanted)


def _unequal(members: Sequence[Node], env: Mapping[str, Any]) -> bool:
    first, *others = [member(env) for member in members]
    return not others or any(abs(other - first) > CLOSE * (1 + abs(first)) for other in others)


_PART = re.compile(
    r"\\text\{(plus |minus )?\\hyperref\[sec:([\w.]+)\]\{[^}]*\}, page~\\pageref\{sec:([\w.]+)\}, with \}(.*)"
)


def _sum(one: Further, stored: Stored) -> bool:
    """Whether the parts that are named do not add to the entries at equal contact radius, in the range beside them."""
    lines = one.tex.removeprefix(OPENING).removesuffix(r"\end{aligned}").split(LINES)
    parts = [match.groups() for match in map(_PART.fullmatch, lines) if match]
    if len(parts) != len(lines) or any(name != page for _, name, page, _ in parts):
        return True
    profile = one.keys[0].rpartition(".")[0]
    entries = stored(profile)
    for suffix in (key.rpartition(".")[2] for key in one.keys):
        for case, values in points_of(entries[suffix], "formula", entries, 1, 13):
            if "<" in one.small and not holds(one.small, named(dict(values))):
                continue
            with mp.workdps(2 * DIGITS):
                want = evaluate(case.expr, values, DIGITS)
                if difference(sum(_share(part, suffix, values, stored) for part in parts), want) > CLOSE:
                    return True
    return False


def _share(part: Sequence[str], suffix: str, values: Mapping[Any, Any], stored: Stored) -> Any:
    """What a part adds to a quantity; nothing while its flat face is not pressed in."""
    sign, name, _, text = part
    entry = stored(name)[suffix]
    own = {name_in_print(symbol): symbol for symbol in entry.profile.parameters}
    given = {}
    for statement in read(text):
        given[own[statement.members[0].name]] = sp.Float(str(statement.members[1](named(dict(values)))), 2 * DIGITS)
    known = {**values, **given}
    if entry.profile.truncated and known[nt.a] < known[nt.b]:
        return 0
    value = evaluate(case_at(entry, known).expr, known, DIGITS)
    return -value if sign == "minus " else value


Where = Literal["range", "approach", "domain", "number", "figure", "sentence"]
Kind = Literal["relation", "value", "symbol"]
_MATHEMATICS = re.compile(r"(?<!\\)\$((?:[^$\\]|\\.)+)\$")
_RELATION = re.compile(r"=|<|>|\\(?:le|ge|to|ll|sim|approx)(?![a-z])")
_VALUE = re.compile(r"\\(?:[dt]?frac|sqrt|int|sum)(?![a-z])|[\w})|]\s*[-+/]\s*[\w({\\|]|\d\\,[A-Za-z\\]|\w\^\{?[\w(]")
_PLAIN = re.compile(
    r"(?:10)?\^\{[^}]*\}|u\^\{\(0\)\}|E\^\{\*\}|G\^\{\*\}|[-\d.]+(?:\\,\d+)*(?:\\times10\^\{-?\d+\})?|1/[\w\\{}]+"
    r"|\\(?:int|surd|circ)_\{\d+\}|\\(?:int|surd|circ)"
)
_LABELS = {"Parameter": "domain", "Parameters": "domain", "Limits": "approach"}


@dataclass(frozen=True)
class Inline:
    """A formula within words: the kind of its place, its LaTeX, and the words it stands in."""

    where: Where
    tex: str
    line: str

    @property
    def kind(self) -> Kind:
        """A relation says something, and so does a value that is more than a name; a symbol or a number does not."""
        if _RELATION.search(self.tex):
            return "relation"
        return "value" if _VALUE.search(self.tex) and not _PLAIN.fullmatch(self.tex) else "symbol"


def inline(text: str) -> list[Inline]:
    """The formulas within the words of one source file, in their order."""
    own = {one.tex for one in formulas(text) if one.kind not in ("row", "further")}
    found = [one for where, line in _places(text) for one in _in_line(where, line)]
    return [one for one in found if one.tex.removeprefix(r"\displaystyle ") not in own]


def _places(text: str) -> Iterator[tuple[Where, str]]:
    """The lines of a source with what they belong to."""
    drawn = counted = tabled = False
    for line in text.splitlines():
        drawn = drawn or r"\begin{tikzpicture}" in line
        tabled = (tabled or line.startswith(r"\parthead{Notation}")) and not line.startswith(r"\end{longtable}")
        counted = counted or line.endswith((r"{Check values}", r"{Worked example}"))
        label, _, content = line.strip().partition(" & ")
        if drawn or line.startswith(r"\figcap"):
            yield "figure", line
        elif counted:
            yield "number", line
        elif line.startswith((r"\frow", r"\fpair", r"\further")):
            yield from _of_row(line)
        elif tabled and line.count(" & ") == 3:
            symbol, unit, domain, meaning = line.split(" & ")
            yield "domain", f"{domain} of {symbol.strip().strip('$')}"
            yield "sentence", f"{symbol} {unit} {meaning}"
        elif line.startswith(" ") and label in _LABELS:
            yield ("approach" if label == "Limits" else "domain"), content
        else:
            yield "sentence", line
        drawn = drawn and r"\end{tikzpicture}" not in line
        counted = counted and not line.startswith((r"\bottomrule", r"\par}"))


def _of_row(line: str) -> Iterator[tuple[Where, str]]:
    """Beside the formula of a row: its range or approach, and the words behind it."""
    halves = arguments(line) if line.startswith((r"\fpair", r"\furtherpair")) else [line]
    for half in halves:
        _, small, tex, *_ = [*arguments(half), "", ""]
        yield ("approach" if r"\to" in small else "range"), small
        yield "sentence", tex.partition(r"\remark{")[2]


def _in_line(where: Where, line: str) -> Iterator[Inline]:
    return (Inline(where, match[1], line) for match in _MATHEMATICS.finditer(line))
