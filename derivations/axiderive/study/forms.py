"""The race of evaluation forms: variants, their cost, the choice.

What a body costs per value of an array: its operations, counted in multiplications.  Nothing is timed.

Which of the variants of a function the catalogue takes: the cheapest that keeps its digits, by measurement.

Cost is counted, errors are measured against Arb: at the points of the record, and what would win at fresh ones too.
The variant that is chosen now stays unless another is better by a margin that no library of a machine explains.

The functions of a problem in every variant of their evaluation forms, as modules to be measured.

The race of evaluation forms: the functions of a problem in every variant, the cheapest that keeps its digits.

A build writes what `stable.variants` names. This study measures whether another form would be better by now.
"""

from __future__ import annotations

import ast
import inspect
import math
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from importlib import import_module
from typing import Any

from .. import notation as nt
from ..code import normal
from ..code.bodies.growth import add_rate
from ..code.bodies.regimes import Regimes, join, split
from ..code.function import Function
from ..code.physics import loads
from ..code.plane import interface as plane
from ..code.plane.compact import Compact as Strips
from ..code.private import PrivateFunctions
from ..code.python import package_sources
from ..entry import Entry
from ..letters import name_of
from ..physics.systems import Problem, of, problem, problems
from ..stable.measure import ITERATIONS, Sample, closure, count_for, is_rule, loaded, samples, ulps
from ..stable.records import COUNT, OWN, SEED, summary
from ..stable.samples import DOMAINS, Floats
from ..stable.slopes import RATE, rate
from ..stable.variants import FULL, SPLITS, VARIANTS, chosen
from ..store.index import table
from .report import Record

WEIGHTS = {
    "sqrt": 3, "cbrt": 4, "where": 3, "abs": 1, "minimum": 1, "maximum": 1, "ones_like": 1, "zeros_like": 1,
    "log": 3, "log1p": 3, "exp": 3, "expm1": 4, "arctan": 4, "arcsin": 4, "arccos": 5, "arctan2": 7, "sinh": 4,
    "cosh": 4, "tanh": 6, "arcsinh": 7, "arccosh": 7, "arctanh": 5, "sin": 20, "cos": 20, "tan": 5, "arctan_gap": 38,
    "root_gap": 40, "tanh_gap": 28, "difference_root": 5, "lower_power": 14, "nth_root": 30, "without_root": 32,
}  # fmt: skip
"""As measured with NumPy 2 on blocks in the cache of one machine with AVX-512; a quotient is worth a product.

The root inside `root_gap` is one that the formula holds too, and is found once.
"""
POWER, KERNEL = 11, 40
"""A power that is not written as products, and any other function of the runtime."""
WHOLE: dict[object, int] = {2: 1, 3: 2, 4: 2}
"""Products of a whole power, by squares: what `_trace` makes of it."""
STEADY = 2
"""What `arctan2` costs more where one of its arguments is a number: its fast loop wants two arrays."""
NODES, STEPS = 24, 4
"""Values of an integrand where its rule does not state them, and of a curve under an iteration."""


def cost(source: str, function: str, fields: Collection[str]) -> int:
    """Of one value of a private function of a module; what depends on no field is found once per call, for nothing."""
    bodies = {node.name: node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)}
    return _Counter(bodies).function(bodies[function], frozenset(fields))[0]


class _Counter:
    """Cost of a piece of code, and whether it depends on a field."""

    def __init__(self, bodies: dict[str, ast.FunctionDef]) -> None:
        self.bodies = bodies

    def function(self, node: ast.FunctionDef, varying: frozenset[str]) -> tuple[int, bool]:
        """Cost of a function whose arguments in `varying` depend on a field, and True, as its value does."""
        total, names, own = 0, set(varying), dict(self.bodies)
        inner = _Counter(own)
        for line in node.body:
            if isinstance(line, ast.FunctionDef):
                own[line.name] = line
            for value, targets in _values(line):
                spent, depends = inner.value(value, names)
                total += spent
                names |= targets if depends else set()
        return total, True

    def value(self, node: ast.AST, names: Collection[str]) -> tuple[int, bool]:
        """Cost of an expression, and whether it depends on a field; what does not costs nothing."""
        if isinstance(node, ast.Name):
            return 0, node.id in names
        if isinstance(node, ast.Call):
            return self._call(node, names)
        parts = [self.value(child, names) for child in ast.iter_child_nodes(node)]
        spent, depends = sum(part for part, _ in parts), any(own for _, own in parts)
        return spent + (_operation(node) if depends else 0), depends

    def _call(self, node: ast.Call, names: Collection[str]) -> tuple[int, bool]:
        name = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
        parts = [self.value(arg, names) for arg in [*node.args, *(word.value for word in node.keywords)]]
        spent, depends = sum(part for part, _ in parts), any(own for _, own in parts)
        if name in self.bodies:
            body = self.bodies[name]
            given = zip((arg.arg for arg in body.args.args), parts, strict=False)
            varying = frozenset(arg for arg, (_, own) in given if own)
            return spent + (self.function(body, varying)[0] if varying else 0), depends
        repeated = _repetitions(node, name)
        if repeated:
            return spent + repeated * sum(self._integrand(arg) for arg in node.args), True
        steady = STEADY if name == "arctan2" and not all(own for _, own in parts) else 0
        return spent + (WEIGHTS.get(name, KERNEL) + steady if depends else 0), depends

    def _integrand(self, node: ast.AST) -> int:
        """A function that is passed to a rule or an iteration, at one of its points."""
        if isinstance(node, ast.Lambda):
            return self.value(node.body, {arg.arg for arg in node.args.args})[0]
        if isinstance(node, ast.Name) and node.id in self.bodies:
            body = self.bodies[node.id]
            return self.function(body, frozenset(arg.arg for arg in body.args.args[:2]))[0]
        return 0


def _values(line: ast.stmt) -> Iterator[tuple[ast.AST, set[str]]]:
    """What is computed on a line, and the names it is given to."""
    if isinstance(line, ast.Assign):
        targets = {node.id for target in line.targets for node in ast.walk(target) if isinstance(node, ast.Name)}
        yield line.value, targets
    elif isinstance(line, (ast.Return, ast.Expr)) and line.value is not None:
        yield line.value, set()


def _operation(node: ast.AST) -> int:
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
        return WHOLE.get(node.right.value, POWER) if isinstance(node.right, ast.Constant) else POWER
    return int(isinstance(node, (ast.BinOp, ast.UnaryOp, ast.Compare)))


def _repetitions(node: ast.Call, name: str) -> int:
    if name in ITERATIONS:
        return STEPS
    if not is_rule(name):
        return 0
    last = node.args[-1] if node.args else None
    return last.value if isinstance(last, ast.Constant) and isinstance(last.value, int) else NODES


TOLERANCE, MARGIN = 5.0, 1.0
"""Units of the last place: what a function may err, and how far that moves between processors."""
FACTOR = 3.0
"""Where nothing keeps the tolerance another variant must be more accurate by this, and by the margin."""
CHEAPER = 0.9
"""The share of the cost that another variant may have at most: weights are no better than that."""
FEW, MANY = (20, 4711), (300, 1234)
"""Points in either domain and their seeds, at which a variant must keep its digits before it is taken."""
FIRST = 5
"""Of the recorded points in either domain, at which most rivals lose."""
Points = Mapping[str, Sequence[Sample]]
"""Calls and exact values by domain."""
Draw = Callable[[int, int], Points]
"""Points by their number and seed."""


@dataclass
class Candidate:
    """A variant of one function."""

    variant: str
    formula: str
    cost: int
    call: Callable[[Sample], float]
    """The value at a point."""
    worst: float = 0.0
    """Of all points so far, in units of the last place; infinite if a value was lost."""
    errors: dict[str, list[float]] = field(default_factory=dict)
    """By domain, at the points that are recorded."""

    def measure(self, points: Points) -> dict[str, list[float]]:
        """The errors at these points by domain, in units of the last place; they count for `worst`."""
        return self.met(
            {domain: [ulps(self.call(point), point.exact) for point in some] for domain, some in points.items()}
        )

    def met(self, errors: dict[str, list[float]]) -> dict[str, list[float]]:
        """The same errors, once the largest of them counts for `worst`."""
        self.worst = max(self.worst, *(error for some in errors.values() for error in some), 0.0)
        return errors

    def keeps(self, tolerance: float) -> bool:
        """Whether no error so far exceeds the tolerance, in units of the last place."""
        return self.worst <= tolerance


def choose(candidates: Sequence[Candidate], given: Points, draw: Draw) -> tuple[Candidate, Candidate | None]:
    """The best of some candidates and the next best; the first of them is the one chosen so far.

    Parameters
    ----------
    candidates : sequence of Candidate
        All without errors, the first may have its own.
    given : mapping
        The points whose errors are recorded: most candidates lose here, where the exact values are known anyway.
    draw : callable
        Fresh points by their number and seed, for those that do not: a few, then many.
    """
    standing, *others = candidates
    if not others or not any(given.values()):
        return standing, None
    standing.errors = standing.met(standing.errors) if standing.errors else standing.measure(given)
    measured = list(_measured(sorted(others, key=_cost), standing, given))
    rivals = sorted((rival for rival in measured if _wins(rival, standing)), key=_merit)
    best = next((rival for rival in rivals if _confirmed(rival, standing, draw)), standing)
    if best is not standing or not any(rival.keeps(TOLERANCE) for rival in measured):
        _complete(others, given)
        measured = others
    return best, min((candidate for candidate in (standing, *measured) if candidate is not best), key=_merit)


def _cost(candidate: Candidate) -> int:
    return candidate.cost


def _measured(others: Sequence[Candidate], standing: Candidate, given: Points) -> Iterator[Candidate]:
    """Those that may win or come second, in the order of their cost, with all errors.

    What errs too much at a few points can do neither, unless the standing one errs too; nor can what costs as much as
    that and more than one that keeps its digits.
    """
    second = math.inf
    for other in others:
        if other.cost > max(second, CHEAPER * standing.cost) and standing.keeps(TOLERANCE + MARGIN):
            return
        if standing.keeps(TOLERANCE + MARGIN):
            other.errors = other.measure({domain: some[:FIRST] for domain, some in given.items()})
            if not other.keeps(TOLERANCE):
                continue
        _complete([other], given)
        if other.keeps(TOLERANCE):
            second = min(second, other.cost)
        yield other


def _complete(others: Sequence[Candidate], given: Points) -> None:
    """Measure what has not been measured."""
    for other in others:
        left = {domain: some[len(other.errors.get(domain, ())) :] for domain, some in given.items()}
        found = other.measure(left)
        other.errors = {domain: [*other.errors.get(domain, ()), *errors] for domain, errors in found.items()}


def _confirmed(rival: Candidate, standing: Candidate, draw: Draw) -> bool:
    """Whether a rival wins at further points too."""
    for sample in (FEW, MANY):
        points = draw(*sample)
        rival.measure(points)
        standing.measure(points)
        if not any(points.values()) or not _wins(rival, standing):
            return False
    return True


def _merit(candidate: Candidate) -> tuple[bool, float, float, str]:
    """Ascending: the cheapest within the tolerance, then the most accurate."""
    if candidate.keeps(TOLERANCE):
        return False, candidate.cost, candidate.worst, candidate.variant
    return True, candidate.worst, candidate.cost, candidate.variant


def _wins(rival: Candidate, standing: Candidate) -> bool:
    """Whether a rival is better by the margins."""
    if rival.keeps(TOLERANCE - MARGIN):
        return rival.cost <= CHEAPER * standing.cost or not standing.keeps(TOLERANCE + MARGIN)
    return not standing.keeps(TOLERANCE + MARGIN) and FACTOR * rival.worst + MARGIN < standing.worst


PARTS = ("", "_at", "_beyond", "_below", "_above")
"""What the names of the functions of one quantity end on."""
RATES = ("slope", "slope_beyond", "growth", "growth_beyond")
"""Those of the rate of growth, which `rate` joins."""


@dataclass(frozen=True)
class Written:
    """One function in one variant."""

    variant: str
    source: str
    """A module that holds it, its other functions in the chosen variants."""
    function: str
    formula: str
    cost: int
    system: str = "normal"
    """Whose package the module belongs to."""


@dataclass(frozen=True)
class Family:
    """How the modules of a system are written."""

    bodies: Callable[[PrivateFunctions, Mapping[str, Entry]], Regimes | Strips | None]
    source: Callable[[PrivateFunctions, str], str]


FAMILIES = {
    "normal": Family(normal.bodies, normal.bodies_source),
    "plane": Family(plane.bodies, plane.bodies_source),
    "loads": Family(loads.bodies, loads.bodies_source),
}
"""The systems whose functions are written by the rules of `stable`.

All others call them or the shapes of the runtime; the radius of pull-off of a power law and the depth and force of a
flat face have one text in every variant.  So has a partial slip: its bodies call the normal contact, whose stick radius
is the radius of a force, and what a contact gains from c to a is a shape of the runtime for its power, which errs as
much as the rule for any power and takes a hundredth of the time.
"""


def written(entries: Mapping[str, Entry], suffixes: Collection[str] | None = None) -> dict[str, tuple[Written, ...]]:
    """The distinct ways of these functions, all if none are named, that are no iterations along others.

    The one that the published module has comes first; the rate of growth goes with the result it is the rate of.
    """
    first = next(iter(entries.values()))
    system = of(first).name
    if system not in FAMILIES:
        return {}
    wanted = {suffix: entry for suffix, entry in entries.items() if suffixes is None or suffix in suffixes}
    growing = rate(entries)
    if growing is not None and {"P" if "P" in entries else "d"} <= set(wanted):
        wanted[RATE.suffix] = growing
    base = _functions(system, entries, PrivateFunctions(first.profile))
    found: dict[str, dict[tuple[str, ...], Written]] = {suffix: {} for suffix in wanted}
    for suffix, entry in wanted.items():
        _add(found[suffix], chosen(entry.key).name, system, base, base, entry)
    ways: dict[str, PrivateFunctions] = {}
    for variant in VARIANTS:
        functions = _functions(system, entries, PrivateFunctions(first.profile, common=variant))
        ways[variant.name] = functions
        for suffix, entry in wanted.items():
            _add(found[suffix], variant.name, system, base, functions, entry)
    for suffix, entry in wanted.items():
        cheap = _cheap(found[suffix].values())
        for variant in (one for one in SPLITS if one.above.name in cheap):
            functions = replace(ways[FULL.name], functions=dict(ways[FULL.name].functions))
            if join(functions, ways[variant.above.name], entry.quantity.function, variant.beyond):
                _add(found[suffix], variant.name, system, base, functions, entry)
    return {suffix: tuple(own.values()) for suffix, own in found.items() if own}


def _cheap(found: Collection[Written]) -> set[str]:
    """The ways that cost less than half of the one by all rules: that is a rule, which they could relieve."""
    full = next((own.cost for own in found if own.variant == FULL.name), 0)
    return {own.variant for own in found if 2 * own.cost < full}


def _functions(system: str, entries: Mapping[str, Entry], functions: PrivateFunctions) -> PrivateFunctions:
    bodies = FAMILIES[system].bodies
    compact = bodies(functions, entries)
    split(functions, entries, bodies)
    if compact is not None:
        add_rate(compact)
    return functions


def _add(
    found: dict[tuple[str, ...], Written],
    name: str,
    system: str,
    base: PrivateFunctions,
    functions: PrivateFunctions,
    entry: Entry,
) -> None:
    function = entry.quantity.function
    own = _own(functions, function)
    lines = tuple(line for private in own.values() for line in private.lines)
    if lines and lines not in found:
        rest = {key: private for key, private in base.functions.items() if key not in _own(base, function)}
        source = FAMILIES[system].source(replace(base, functions=rest | own), name)
        fields = [str(argument) for argument in entry.quantity.arguments]
        found[lines] = Written(
            name, source, f"_{function}", _formula(own, function), cost(source, f"_{function}", fields), system
        )


def _formula(own: Mapping[str, Function], function: str) -> str:
    """The lines of a body, and those of the bodies of the same quantity that it calls."""
    main = "; ".join(map(str.strip, own[function].lines))
    called = [private for name, private in own.items() if name != function and private.name in own[function].uses]
    return " | ".join([main, *(f"{private.name}: {'; '.join(map(str.strip, private.lines))}" for private in called)])


def _own(functions: PrivateFunctions, function: str) -> dict[str, Function]:
    names = RATES if function == RATE.function else ()
    names = (*(f"{function}{part}" for part in PARTS), *names)
    return {name: functions.functions[name] for name in names if name in functions.functions}


Variants = Mapping[str, Sequence[Written]]
"""The distinct variants of functions by suffix, the chosen one first."""


def names() -> tuple[str, ...]:
    """The problems whose modules hold bodies of their own."""
    return tuple(own.key for own in problems() if own.system in OWN)


def measure(keys: Sequence[str]) -> Record:
    """The race of each of these problems: `{"study": "forms", "problems": {key: {suffix: row}}}`."""
    return {"study": "forms", "problems": {key: _race(problem(key)) for key in keys}}


def text(record: Record) -> str:
    """A line for every function that has several forms; what would be taken instead is said."""
    rows = [["key", "form", "cost", "beside it", "cost", "verdict"]]
    for key, found in record["problems"].items():
        for suffix, row in found.items():
            other = row.get("runner_up", {"form": "", "cost": ""})
            verdict = f"name `{row['better']}` in CHOSEN of stable/chosen.py" if "better" in row else "stays"
            chosen = row["chosen"]
            rows.append([f"{key}.{suffix}", chosen["form"], chosen["cost"], other["form"], other["cost"], verdict])
    return table([[str(cell) for cell in row] for row in rows])


def _race(own: Problem) -> dict[str, Record]:
    entries = own.derive()
    sources = package_sources({own.key: entries})
    return race(own.key, sources, entries, written(entries))


def race(key: str, sources: Mapping[str, str], entries: Mapping[str, Entry], variants: Variants) -> dict[str, Record]:
    """What measurement says of the forms of the functions of a problem, by suffix.

    Parameters
    ----------
    key : str
        Key of the problem, as `cone`.
    sources : mapping of str to str
        The texts of the package by path.
    entries : mapping of str to Entry
        What the functions shall evaluate, by suffix.
    variants : mapping of str to sequence of Written
        Their forms, the one of the published module first.

    Returns
    -------
    dict
        Of each function with several forms the one it has (`chosen`), the next best with its errors (`runner_up`),
        and the name of a better one (`better`) where there is one.
    """
    module = problem(key).module
    growing = rate(entries)
    entries = {**entries, **({RATE.suffix: growing} if growing is not None else {})}
    texts = {
        f"axicontact/{one.system}/{_name(suffix, i)}.py": one.source
        for suffix, own in variants.items()
        for i, one in enumerate(own)
    }
    with loaded(closure({**sources, **texts}, module, *texts), module) as published:
        package = published.__name__.partition(".")[0]
        return {suffix: _row(package, entries, suffix, own) for suffix, own in variants.items() if len(own) > 1}


def _row(package: str, entries: Mapping[str, Entry], suffix: str, own: Sequence[Written]) -> Record:
    def draw(count: int, seed: int) -> Points:
        number = count_for(entries[suffix], count)
        return {domain.name: list(samples(entries, suffix, domain, number, seed)) for domain in DOMAINS}

    candidates = [
        Candidate(one.variant, one.formula, one.cost, _call(package, entries[suffix], own, i))
        for i, one in enumerate(own)
    ]
    standing = candidates[0]
    best, second = choose(candidates, draw(COUNT, SEED), draw)
    row: Record = {"chosen": _described(standing)}
    if best is not standing:
        row["better"], second = best.variant, best
    if second is not None:
        row["runner_up"] = _described(second) | {name: summary(errors) for name, errors in second.errors.items()}
    return row


def _described(candidate: Candidate) -> Record:
    return {"form": candidate.variant, "formula": candidate.formula, "cost": candidate.cost}


def _name(suffix: str, i: int) -> str:
    return f"_{suffix}_{i}"


def _call(package: str, entry: Entry, own: Sequence[Written], i: int) -> Callable[[Sample], float]:
    """The value of a variant at a point, by the array machinery of its package."""
    module = import_module(f"{package}.{own[i].system}.{_name(entry.suffix, i)}")
    body: Callable[..., Any] = getattr(module, own[i].function)
    elementwise = import_module(f"{package}._runtime.interface").elementwise
    known, fields = list(inspect.signature(body).parameters), {str(symbol) for symbol in entry.quantity.arguments}

    def value(point: Sample) -> float:
        values = {name_of(symbol): number for symbol, number in _turned(point.values).items()}
        given = {name: values[name] for name in known if name not in fields}
        several = {name: number for name, number in given.items() if isinstance(number, tuple)}
        function = partial(body, **several) if several else body
        numbers = {name: number for name, number in given.items() if name not in several}
        try:
            return float(elementwise(function, *(values[name] for name in known if name in fields), **numbers))
        except (OverflowError, TypeError):  # TypeError: no rule for numbers beyond the range of doubles
            return math.nan

    return value


def _turned(values: Floats) -> Floats:
    """Seen from the side of x: bodies take distances from the middle."""
    if nt.e in values and values.get(nt.x, 0.0) < 0.0:
        return {**values, nt.x: -values[nt.x], nt.e: -values[nt.e]}
    return values
