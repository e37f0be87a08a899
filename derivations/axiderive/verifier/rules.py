"""Which rule shows a quantity of which kind of problem."""

from __future__ import annotations

from collections.abc import Callable

from .above import ADHESIVE, TANGENTIAL, elastic_force, viscous
from .compact import COMPACT
from .complete import COMPLETE, DETACHED
from .peak import PEAK
from .plane import PLANE, PLANE_COMPLETE, TILTED
from .problem import Problem, Rule
from .reading import UnknownError, tree

MODULI = {
    "E_star": "1/((1 - nu_1**2)/young_1 + (1 - nu_2**2)/young_2)",
    "G_star": "1/((2 - nu_1)*(1 + nu_1)/(2*young_1) + (2 - nu_2)*(1 + nu_2)/(2*young_2))",
}


def modulus(problem: Problem, suffix: str) -> None:
    """Shows E_star or G_star as the formula of `MODULI`."""
    (case,) = problem.places(suffix, {()})
    problem.show("the modulus", problem.field(()), case.expr, tree(MODULI[suffix]))


TABLES: dict[str, dict[str, Rule]] = {
    "compact": COMPACT | PEAK, "complete": COMPLETE,
    "adhesive": ADHESIVE, "detachment": DETACHED, "tangential": TANGENTIAL,
    "plane": PLANE, "plane complete": PLANE_COMPLETE, "plane eccentric": TILTED,
    "materials": {s: (modulus, ()) for s in MODULI},
}  # fmt: skip


def kind_of(problem: Problem) -> str:
    """Which quantities a problem has, by the groups of its key and the contact of its profile."""
    first, *groups = problem.key.split(".")
    contact = problem.profile["contact"]
    if first == "plane":
        tilt = any(p["="].startswith("Symbol('e',") for p in problem.profile["parameters"])
        return "plane eccentric" if tilt else "plane" if contact == "compact" else "plane complete"
    if first in ("loads", "materials"):
        return first
    groups = [group for group in groups if group != "fgm"]
    above = {"adh": "adhesive" if contact == "compact" else "detachment", "tan": "tangential", "vis": "viscoelastic"}
    return above[groups[0]] if groups else str(contact)


def rule_of(problem: Problem, suffix: str) -> tuple[Callable[[Problem, str], None], tuple[str, ...], str, str]:
    """The rule of a quantity, what it rests on, its kind and the status it is stated with."""
    kind, stated = kind_of(problem), problem.records[suffix]["status"]
    if kind == "viscoelastic":
        source = "aF" if suffix.startswith("load") else elastic_force(problem, suffix)
        return viscous, (f"plain.{source}",), kind, stated
    if suffix not in TABLES.get(kind, {}):
        message = "there is no second rule for it"
        raise UnknownError(message)
    return (*TABLES[kind][suffix], kind, stated if suffix in ("ac", "am", "aP", "rp") else "closed")
