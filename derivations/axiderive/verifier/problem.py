"""One problem as it is stored: its entries, the orders its formulas hold in, and what is asked of each at once."""

from __future__ import annotations

import itertools
import json
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from .field import Element, Field, FinerError
from .reading import ASSUMED, Tree, UnknownError, definition, put, symbols, tree

SECONDS = 60.0
Chain = tuple[Tree, ...]
LETTERS = {
    "compact": {"d": "a", "F": "a", "p": "r a", "w": "r a", "k": "a", "pm": "a",
                "ad": "d", "aF": "F", "Fd": "d", "dF": "F", "rp": "a r_peak", "pp": "a r_peak"},
    "complete": {"F": "d", "p": "r d", "w": "r d", "k": "d", "dF": "F",
                 "dmin": "r_zero", "Fmin": "r_zero", "rz": "r_zero"},
    "adhesive": {"Dl": "a", "d": "a", "F": "a", "p": "r a", "w": "r a", "ad": "d", "aF": "F",
                 **dict.fromkeys(("ac", "Fc", "dc", "am", "Fm", "dm"), "a_c")},
    "detachment": {},
    "tangential": {"F": "a c", "tau": "r a c", "u": "a c", "us": "a", "c": "F_x a"},
    "viscoelastic": {f"{kind}_{law}": letters for law in ("mx", "kv", "sls", "pc") for kind, letters in
                     {"ramp": "time", "step": "time d", "load": "time F"}.items()},
    "plane": {"P": "a", "p": "x a", "s": "x a", "d": "L a", "aP": "P"},
    "plane complete": {"p": "x P", "s": "x P", "d": "L P", "xz": "x_zero", "Pmin": "x_zero"},
    "plane eccentric": {"p": "x P", "phi": "P"},
    "materials": {},
}  # fmt: skip
"""What the formulas of a quantity may depend on besides the parameters of the profile and the material."""
UNKNOWNS = {"aP": " a", "step": " F a"}
"""What an equation holds besides."""
COMPOSED = {"Fd": ["F", "ad"], "dF": ["d", "aF"]}
DEFINITIONS: dict[str, dict[str, list[str]]] = json.loads((Path(__file__).parent / "definitions.json").read_text())
"""The defining equations that may stand beside a quantity, and its constants of the material in their order."""
MEDIA: dict[str, dict[str, Tree]] = {
    "": {"M": "E_star", "k": 0, "T": "G_star"},
    "fgm": {"M": "H", "k": "k", "T": "H_x"},
}
PUNCH = {
    "d": "1",
    "F": "2*M*a**(1 + k)/(1 + k)",
    "p": "M/pi*(a**2 - r**2)**((k - 1)/2)",
    "w": "cos(k*pi/2)/pi*IncompleteBeta(a**2/r**2, (1 + k)/2, (1 - k)/2)",
}
"""A flat punch of radius a moved by 1."""
MONOMIAL = "gamma((1 + k)/2)*gamma(n/2 + 1)/gamma((1 + k + n)/2)*a**n"
"""Depth of the profile r**n."""


def summed(formula: Tree) -> Tree:
    """The formula without what stands under a sum."""
    if isinstance(formula, tuple):
        return "A" if formula[0] == "Sum" else (formula[0], *map(summed, formula[1:]))
    return formula


class Case:
    """One stored formula and the order it holds in."""

    def __init__(self, record: Mapping[str, Any]) -> None:
        self.chain: Chain = tuple(tree(member["="]) for member in record["chain"])
        self.expr = tree(record["expr"]["="])


class Problem:
    """The stored entries of one problem, above those of the normal contact it rests on."""

    def __init__(self, record: Mapping[str, Any], rules_of: RulesOf, plain: Problem | None = None) -> None:
        self.key, self.plain, self.rules_of = record["problem"], plain, rules_of
        self.profile, self.records = record["profile"], record["entries"]
        groups = self.key.split(".")
        self.medium = MEDIA["fgm" if "fgm" in groups else ""]
        self.entries = {suffix: [Case(case) for case in entry["cases"]] for suffix, entry in self.records.items()}
        self.breaks = [tree(p["upper"]["="]) for p in self.profile["pieces"] if p["upper"] is not None]
        self.pieces = [tree(p["expr"]["="]) for p in self.profile["pieces"]]
        self.chain: Chain = tuple(tree(member["="]) for member in self.profile["chain"])
        self.floor = self.breaks[0] if self.breaks and self.pieces[0] == 0 else None
        self.rules = [(tree(rule["left"]["="]), tree(rule["right"]["="])) for rule in self.profile["rules"]]
        self.fields: dict[Any, Field] = {}
        self.finer: dict[str, int] = {}
        self.done: dict[str, str] = {}
        self.end = 0.0

    # domains and elements

    def field(self, chain: Chain, *more: tuple[Tree, str]) -> Field:
        """The field of an order, the rules of the profile and more pairs (low, high); one for equal arguments."""
        key = (chain, more)
        if key not in self.fields:
            pairs = [*more, *itertools.pairwise(chain), *itertools.pairwise(self.chain)]
            pairs += [pair for pair in self.rules if isinstance(pair[1], str)]
            members = list(chain)
            order: list[tuple[Tree, str]] = []
            for low, high in pairs:
                known = low in members and high in members and members.index(low) < members.index(high)
                if isinstance(high, str) and (not known or (low, high) in itertools.pairwise(chain)):
                    order.append((low, high))
            self.fields[key] = Field(order, self.finer, self.end)
        return self.fields[key]

    def table(self, formula: str, **values: Tree) -> Tree:
        """A formula of the tables on the medium of the problem."""
        return put(tree(formula), {**self.medium, **values})

    def show(self, what: str, field: Field, left: Tree, right: Tree = 0) -> None:
        """Raises `UnknownError` unless two formulas, trees or elements, are shown to be equal."""
        one = left if isinstance(left, Element) else field.read(left)
        two = right if isinstance(right, Element) else field.read(right)
        self.vanishes(what, one - two)

    def vanishes(self, what: str, gap: Element) -> None:
        """Raises `UnknownError` unless the element is shown to be zero and is linear in the coefficients A_j."""
        index = gap.field.keys.get("A_j", -1)
        if index >= 0 and (gap.num.degrees()[index] > 1 or gap.den.degrees()[index]):
            message = f"{what}: not linear in the coefficients of a polynomial"
            raise UnknownError(message)
        if not gap.field.zero(gap):
            message = f"{what} is not shown"
            raise UnknownError(message)

    # the rules are run here

    def need(self, suffix: str) -> None:
        """Raises `UnknownError` with the reason if another entry is not shown."""
        reason = self.prove(suffix)
        if reason:
            message = f"rests on {self.key}.{suffix}: {reason}"
            raise UnknownError(message)

    def prove(self, suffix: str) -> str:
        """Why an entry is not shown; empty where it is."""
        if suffix not in self.done:
            self.done[suffix] = "it rests on itself"
            self.done[suffix] = self._attempt(suffix)
        return self.done[suffix]

    def _attempt(self, suffix: str) -> str:
        for _ in range(20):
            self.fields.clear()
            self.end = time.process_time() + SECONDS
            try:
                rule, needs, kind, status = self.rules_of(self, suffix)
                for needed in needs:
                    self.below(needed).need(needed.removeprefix("plain."))
                self.end = time.process_time() + SECONDS
                if self.plain:
                    self.plain.fields.clear()
                    self.plain.end = self.end
                self.formal(suffix, kind, status)
                rule(self, suffix)
            except FinerError:
                continue
            except UnknownError as error:
                return str(error)
            except Exception as error:
                return f"{type(error).__name__}: {error}"
            return ""
        return "the exponents do not come to an end"

    def below(self, needed: str) -> Problem:
        """The problem itself, or the normal contact for a name like `plain.F`; `UnknownError` if it is not given."""
        if not needed.startswith("plain."):
            return self
        if self.plain is None:
            message = "the normal contact below is not given"
            raise UnknownError(message)
        return self.plain

    def formal(self, suffix: str, kind: str, status: str) -> None:
        """The entry is one of its quantity: its name, its definition, its status and the symbols of its formulas."""
        entry: dict[str, Any] = self.records[suffix]
        name = entry["quantity"].get("@quantity", "")
        root = entry["status"] == "root"
        letters = (LETTERS[kind].get(suffix, "") + (UNKNOWNS.get(suffix.split("_")[0], "") if root else "")).split()
        listed, own = ([one["="] for one in found] for found in (entry["parameters"], self.profile["parameters"]))
        parameters = {"A_j" if text.startswith("IndexedBase") else tree(text) for text in listed}
        graded = " graded" if self.medium["k"] else ""
        known = DEFINITIONS.get(f"{kind} {suffix}{graded}", {"definitions": [], "material": []})
        short = {tree(one["="]) for one, _ in self.profile["abbreviations"]}
        texts = [case.expr for case in self.entries[suffix]]
        faults = {
            "its key": entry["key"] != f"{self.key}.{suffix}" or entry["profile"] != {"@profile": self.profile["name"]},
            "its quantity": name not in (f"{kind}.{suffix}", f"compact.{suffix}", f"plane complete.{suffix}"),
            "its status": entry["status"] != status,
            "its definition": definition(entry["definition"]["="]) not in map(definition, known["definitions"]),
            "its composition": entry["composed"] not in (None, COMPOSED.get(suffix)),
            "its parameters": listed not in self.parameters(suffix, kind, own, known["material"]),
            "its symbols": not set().union(*map(symbols, texts)) <= parameters | short | {*letters, "j", "N"},
            "its contact before the edge": kind == "complete" and bool(entry["partial"]) != (len(texts) > 1),
            "its sum": any("j" in symbols(summed(text)) for text in texts),
        }
        for fault, found in faults.items():
            if found:
                message = f"{fault}: not what the quantity asks for"
                raise UnknownError(message)

    def parameters(self, suffix: str, kind: str, own: list[str], material: list[str]) -> list[list[str]]:
        """Those of the profile and the material; of the material none where a level strip does not feel it."""
        if suffix == "Dl":
            own = own[:1] if kind == "detachment" else []
        whole = [f"Symbol('{name}', {'real' if name in ASSUMED else 'positive'}=True)" for name in material]
        return [[*own, *whole], *([own] if kind == "plane complete" and self.pieces == [0] else [])]

    def closed(self, suffix: str) -> list[Case]:
        """The cases of a quantity; `UnknownError` if its formulas are not closed."""
        if self.records[suffix]["status"] != "closed":
            message = f"{self.key}.{suffix} is no closed formula"
            raise UnknownError(message)
        return self.entries[suffix]

    def orders(self, *pairs: tuple[Tree, Tree], items: Iterable[Tree] = ()) -> set[Chain]:
        """All orders of a, the breaks and the lengths of the profile in which the pairs hold."""
        members = {"a", *self.breaks, *self.chain, *items}
        known = [*pairs, *itertools.pairwise(self.breaks), *itertools.pairwise(self.chain)]
        known += [(self.floor, "a")] if self.floor else []
        return {
            order for order in itertools.permutations(sorted(members))
            if all(order.index(low) < order.index(high) for low, high in known)
        }  # fmt: skip

    def places(self, suffix: str, wanted: set[Chain]) -> list[Case]:
        """The cases of a quantity; `UnknownError` unless they hold in the wanted orders, each once."""
        cases = self.entries[suffix]
        if {case.chain for case in cases} != wanted or len(cases) != len(wanted):
            message = "its cases are not every place in the order once"
            raise UnknownError(message)
        return cases

    def of(self, suffix: str, chain: Chain, without: str = "") -> Tree:
        """The formula of another quantity in the same order, without a place the quantity does not depend on."""
        wanted = tuple(member for member in chain if member != without)
        found = [case.expr for case in self.closed(suffix) if case.chain == wanted]
        if len(found) != 1:
            message = f"no {suffix} for this order"
            raise UnknownError(message)
        return found[0]


RulesOf = Callable[[Problem, str], tuple[Callable[[Problem, str], None], tuple[str, ...], str, str]]
Rule = tuple[Callable[[Problem, str], None], tuple[str, ...]]
"""How a quantity is shown, and what it rests on: quantities of the problem, and of the normal contact below."""
