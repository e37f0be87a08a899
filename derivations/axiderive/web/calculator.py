"""The calculator of a page: its programs as JavaScript, and what the script of the site has to know to ask for numbers.

The fields are the arguments of the functions of a profile; depth, force and radius follow from any one of them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Container, Mapping, Sequence

import sympy as sp

from .. import notation as nt
from ..book.spread import problems_of
from ..entry import Entry, Quantity
from ..languages.javascript import Script
from ..languages.reach import NoProgramError, Package
from ..letters import name_of
from ..physics.adhesive import CONTROLS
from ..physics.medium import Medium
from ..physics.systems import pool_of
from ..rows.row import Row
from ..worked.cases import CASES, Case

Derived = Mapping[str, Mapping[str, Entry]]
STATE = ("F", "P", "d", "a")
"""What a contact is given by, first what a calculator asks for if nothing is said."""
ALONE = {
    **{"E_star": 3.3e6, "p_0": 1e6, "a": 1e-3, "sigma": 0.5, "F": 10.0},
    **{"mu": 0.3, "dgamma": 0.05, "L": 0.05, "e": 2e-4, "H": 5e7, nt.k.name: 0.3, "H_x": 3e7},
    **{"beta": 0.02, "G": 1e6, "z": 0.0, "t": 1.0, "v": 1e-5, "t_0": 1.0, name_of(nt.relaxation): 1.0},
    **{"E_law": 3e6, "E_inf": 1e6, "E_1": 2e6, "eta": 1e6, "alpha": 0.3},
}
"""Values to begin with where no worked example has any."""
STATE_NAMES = "radius", "force", "depth"
"""What a function of pull-off gives, in the order of the keys of its rows."""
SAID = {"E": "Young's modulus of an elastic body under a rigid one, in place of E*", "nu": "its Poisson ratio"}
SIGNS = {"E": "E"}
OF_LAW = {"E": "E_law"}
"""Fields of letters that mean something else in a material law."""
LAST = (
    *("E_star", "E", "nu", "G_star", "H", nt.k.name, "H_x", "mu", "dgamma", "r", "x", nt.c.name, "F_x", "L"),
    *("E_law", "E_inf", "E_1", name_of(nt.relaxation), "eta", "alpha", "t_0", "v", "t"),
)
"""Behind the lengths of the profile: the material, and where a field is asked for."""


def calculator(profile_id: str, derived: Derived, package: Package, shown: Container[str]) -> str | None:
    """The script of the calculator of a profile; None where nothing can be calculated.

    Of the functions under a material law those are taken whose keys are `shown` on the page.  On a half-space the
    contact without adhesion says which depth, force and radius belong together.
    """
    script = Script(package)
    formulas: dict[str, dict[str, object]] = {}
    lines, needed, media, several = [], dict[str, nt.Notation](), list[Medium](), set[str]()
    problems = [
        problem for problem in problems_of(profile_id) if problem.system.physics.printed and problem.key in derived
    ]
    for problem in problems:
        module = problem.module.removeprefix("axicontact/").removesuffix(".py").replace("/", ".")
        first, medium = problem.system.medium not in media, problem.system.medium
        media += [medium] * first
        for suffix, entry in derived[problem.key].items():
            quantity, laws = entry.quantity, problem.system.physics.laws
            if laws and entry.key not in shown:
                continue
            row = entry.key.removeprefix(f"{profile_id}.")
            try:
                name = script.add(module, quantity.function)
            except NoProgramError:
                continue
            order = [one for one in package.arguments(module, quantity.function) if one != "control"]
            records = {name_of(s): nt.describe(s) for s in (*quantity.arguments, *entry.parameters)}
            letters = [OF_LAW.get(one, one) if laws else one for one in order]
            needed |= {own: records.get(one) or nt.describe(one) for own, one in zip(letters, order, strict=True)}
            formulas[row] = {
                "gives": name_of(quantity.symbol),
                "needs": letters,
                "unit": nt.describe(quantity.symbol).unit,
                "place": quantity.place,
                "suffix": suffix if first and not quantity.member else "",
                "medium": media.index(medium),
            }
            if quantity.member or quantity.control:
                several.add(name)
            lines.append(f"  {json.dumps(row)}: (v) => {_call(name, letters, quantity)},")
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
        "(() => {", script.text(),
        f"const once = {{ {', '.join(f'{name}: math.kept({name})' for name in sorted(several))} }};",
        "const formulas = {", *lines, "};",
        f"window.calculator = {{ ...{json.dumps(data, ensure_ascii=False, indent=1)}, evaluate: formulas }};",
        "})();", "",
    ])  # fmt: skip


def _call(name: str, order: Sequence[str], quantity: Quantity) -> str:
    """The call of a program, or one of the numbers that it gives."""
    given = ", ".join([*([repr(quantity.control)] if quantity.control else []), *(f"v.{one}" for one in order)])
    part = quantity.member
    if quantity.control:
        part = STATE_NAMES[CONTROLS[quantity.control].index(quantity.suffix)]
    return f"(once.{name}({given}).{part} ?? NaN)" if part else f"{name}({given})"


def _first(field: tuple[str, nt.Notation]) -> int:
    return LAST.index(field[0]) if field[0] in LAST else -1


def _field(letter: str, record: nt.Notation, case: Case | None) -> dict[str, object]:
    """A field of the form: its letter, what it is, where it may lie, and a value to begin with."""
    low, high, closed = _ends(record.domain)
    return {
        "name": letter,
        "tex": SIGNS.get(letter, record.latex),
        "meaning": SAID.get(letter, record.meaning.partition(",")[0]),
        "unit": record.unit,
        "rule": re.sub(rf"\b{record.name}\b", letter, record.domain),
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


def scripts(
    rows: Mapping[str, Mapping[str, Sequence[Row]]], derived: Derived, modules: Mapping[str, str]
) -> dict[str, str]:
    """The scripts of the calculators by profile, from the rows of each."""
    package = Package(modules)
    shown = {name: {e.key for of in own.values() for row in of for e in row.entries} for name, own in rows.items()}
    found = {name: calculator(name, derived, package, own) for name, own in shown.items()}
    return {name: own for name, own in found.items() if own is not None}
