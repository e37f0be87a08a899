"""The functions of a problem in every variant of their evaluation forms, as modules to be measured."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace

from ..contact.systems import problem
from ..emit import plane, python
from ..emit.physics import loads
from ..emit.plane.compact import Compact as Strips
from ..emit.private import Private, PrivateFunctions
from ..emit.rates import add_rate
from ..emit.regimes import Regimes
from ..emit.splits import join, split
from ..entry import Entry
from ..stable.chosen import chosen
from ..stable.slopes import RATE, rate
from ..stable.variants import FULL, SPLITS, VARIANTS
from .cost import cost

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
    "normal": Family(python.bodies, python.bodies_source),
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
    system = problem(first.key.rpartition(".")[0]).system.name
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


def _formula(own: Mapping[str, Private], function: str) -> str:
    """The lines of a body, and those of the bodies of the same quantity that it calls."""
    main = "; ".join(map(str.strip, own[function].lines))
    called = [private for name, private in own.items() if name != function and own[function].uses(private)]
    return " | ".join([main, *(f"{private.name}: {'; '.join(map(str.strip, private.lines))}" for private in called)])


def _own(functions: PrivateFunctions, function: str) -> dict[str, Private]:
    names = RATES if function == RATE.function else ()
    names = (*(f"{function}{part}" for part in PARTS), *names)
    return {name: functions.functions[name] for name in names if name in functions.functions}
