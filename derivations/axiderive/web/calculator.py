"""The calculator of a page: its programs as JavaScript, and what the script of the site has to know to ask for numbers.

The fields are the arguments of the functions of a profile; depth, force and radius follow from any one of them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence

import sympy as sp

from .. import notation as nt
from ..book.spread import problems_of
from ..entry import Entry, Quantity
from ..languages.javascript import Script
from ..languages.reach import NoProgramError, Package
from ..letters import name_of
from ..physics.adhesive import CONTROLS
from ..physics.medium import Medium
from ..physics.systems import Problem, pool_of
from ..worked.cases import CASES, Case

Derived = Mapping[str, Mapping[str, Entry]]
STATE = ("F", "P", "d", "a")
"""What a contact is given by, first what a calculator asks for if nothing is said."""
ALONE = {
    **{"E_star": 3.3e6, "p_0": 1e6, "a": 1e-3, "sigma": 0.5, "F": 10.0},
    **{"mu": 0.3, "dgamma": 0.05, "L": 0.05, "e": 2e-4, "H": 5e7, "k": 0.3, "H_x": 3e7},
}
"""Values to begin with where no worked example has any."""
STATE_NAMES = "radius", "force", "depth"
"""What a function of pull-off gives, in the order of the keys of its rows."""
SAID = {"E": "Young's modulus of an elastic body under a rigid one, in place of E*", "nu": "its Poisson ratio"}
SIGNS = {"E": "E"}
LAST = ("E_star", "E", "nu", "G_star", "H", "k", "H_x", "mu", "dgamma", "r", "x", "c", "F_x", "L")
"""Behind the lengths of the profile: the material, and where a field is asked for."""


def calculator(profile_id: str, derived: Derived, package: Package) -> str | None:
    """The script of the calculator of a profile; None where nothing can be calculated.

    On a half-space the contact without adhesion says which depth, force and radius belong together.
    """
    script = Script(package)
    formulas: dict[str, dict[str, object]] = {}
    lines, needed, media = [], dict[str, nt.Notation](), list[Medium]()
    problems = [problem for problem in problems_of(profile_id) if _instant(problem) and problem.key in derived]
    for problem in problems:
        module = problem.module.removeprefix("axicontact/").removesuffix(".py").replace("/", ".")
        first, medium = problem.system.medium not in media, problem.system.medium
        media += [medium] * first
        for suffix, entry in derived[problem.key].items():
            quantity = entry.quantity
            row = entry.key.removeprefix(f"{profile_id}.")
            try:
                name = script.add(module, quantity.function)
            except NoProgramError:
                continue
            order = [one for one in package.arguments(module, quantity.function) if one != "control"]
            records = {name_of(s): nt.describe(s) for s in (*quantity.arguments, *entry.parameters)}
            needed |= {letter: records.get(letter) or nt.describe(letter) for letter in order}
            formulas[row] = {
                "gives": name_of(quantity.symbol),
                "needs": order,
                "unit": nt.describe(quantity.symbol).unit,
                "place": quantity.place,
                "suffix": suffix if first and not quantity.member else "",
                "medium": media.index(medium),
            }
            lines.append(f"  {json.dumps(row)}: (v) => {_call(name, order, quantity)},")
    if not formulas:
        return None
    given = CASES.get(profile_id)
    own = {name_of(symbol) for symbol in problems[0].profile.parameters}
    state = [one for one in STATE if one in needed and one not in own]
    if "E_star" in needed:
        needed |= {"E": nt.describe("young_1"), "nu": nt.describe("nu")}
    fields = [
        _field(letter, record, given) for letter, record in sorted(needed.items(), key=_first) if letter not in state
    ]
    data = {
        "fields": fields,
        "state": [_field(one, needed[one], given) for one in state],
        "formulas": formulas,
        "place": pool_of(profile_id).place.name,
    }
    return "\n".join([
        "(() => {", script.text(), "const formulas = {", *lines, "};",
        f"window.calculator = {{ ...{json.dumps(data, ensure_ascii=False, indent=1)}, evaluate: formulas }};",
        "})();", "",
    ])  # fmt: skip


def _call(name: str, order: Sequence[str], quantity: Quantity) -> str:
    """The call of a program, or one of the numbers that it gives."""
    given = ", ".join([*([repr(quantity.control)] if quantity.control else []), *(f"v.{one}" for one in order)])
    part = quantity.member
    if quantity.control:
        part = STATE_NAMES[CONTROLS[quantity.control].index(quantity.suffix)]
    return f"({name}({given}).{part} ?? NaN)" if part else f"{name}({given})"


def _first(field: tuple[str, nt.Notation]) -> int:
    return LAST.index(field[0]) if field[0] in LAST else -1


def _instant(problem: Problem) -> bool:
    """Whether its functions are of lengths and loads alone, without a history."""
    return not problem.system.physics.laws and problem.system.physics.printed


def _field(letter: str, record: nt.Notation, case: Case | None) -> dict[str, object]:
    """A field of the form: its letter, what it is, where it may lie, and a value to begin with."""
    low, high, closed = _ends(record.domain)
    return {
        "name": letter,
        "tex": SIGNS.get(letter, record.latex),
        "meaning": SAID.get(letter, record.meaning.partition(",")[0]),
        "unit": record.unit,
        "rule": record.domain.replace(record.name, letter),
        "low": low,
        "high": high,
        "closed": closed,
        "value": _beginning(letter, case),
    }


def _ends(domain: str) -> tuple[float | None, float | None, str]:
    """The interval of a domain in words, and which of its ends belong to it; an end at another letter is left out."""
    if between := re.fullmatch(r"(\S+) (<=?) \w+ (<=?) (\S+)", domain):
        low, first, second, high = between.groups()
        return _number(low), _number(high), "low" * (first == "<=") + "high" * (second == "<=")
    above = re.fullmatch(r"\w+ (>=?) (\S+)", domain)
    return (_number(above[2]), None, "low" * (above[1] == ">=")) if above else (None, None, "")


def _number(text: str) -> float | None:
    end = sp.sympify(text)
    return float(end) if end.is_number else None


def _beginning(letter: str, case: Case | None) -> float | str:
    given: Mapping[str, object] = case.parameters if case else {}
    if letter in given:
        return float(str(given[letter]))
    if letter == "A" and "A_1" in given:
        return ", ".join(str(value) for value in given.values())
    if case and letter in ("F", "P"):
        return case.load
    if case and letter in ("E_star", "nu", "mu", "dgamma"):
        material = case.material
        found = {"E_star": float(material.modulus), "nu": float(material.poisson), "mu": float(material.friction)}
        return {**found, "dgamma": material.separation or ALONE["dgamma"]}[letter]
    return ALONE.get(letter, "")


def scripts(ids: Sequence[str], derived: Derived, modules: Mapping[str, str]) -> dict[str, str]:
    """The scripts of the calculators by profile."""
    package = Package(modules)
    found = {name: calculator(name, derived, package) for name in ids}
    return {name: own for name, own in found.items() if own is not None}
