"""One problem as it is stored: its entries, its domains, and what is asked of every entry at once."""

from __future__ import annotations

import itertools
import time
from collections.abc import Mapping
from typing import Any

from .field import Field, FinerError
from .proof import Domain, Proof
from .reading import ASSUMED, Chain, Tree, UnknownError, definition, ordered, require, summed, symbols, tree
from .theory import THEORY, Section

SECONDS = 60.0
MEDIA: dict[str, dict[str, Tree]] = {
    "": {"M": "E_star", "k": 0, "T": "G_star"},
    "fgm": {"M": "H", "k": "k", "T": "H_x"},
}


class Case:
    """One stored formula and the order it holds in."""

    def __init__(self, record: Mapping[str, Any]) -> None:
        self.chain: Chain = tuple(ordered(tree(member["="])) for member in record["chain"])
        self.expr = tree(record["expr"]["="])


class Problem:
    """The stored entries of one problem, above those of the normal contact it rests on."""

    def __init__(self, record: Mapping[str, Any], plain: Problem | None = None) -> None:
        self.key, self.plain = record["problem"], plain
        self.profile, self.records = record["profile"], record["entries"]
        self.groups = self.key.split(".")
        self.medium = MEDIA["fgm" if "fgm" in self.groups else ""]
        self.entries = {suffix: [Case(case) for case in entry["cases"]] for suffix, entry in self.records.items()}
        self.breaks = [tree(p["upper"]["="]) for p in self.profile["pieces"] if p["upper"] is not None]
        self.pieces = [tree(p["expr"]["="]) for p in self.profile["pieces"]]
        self.chain: Chain = tuple(tree(member["="]) for member in self.profile["chain"])
        self.floor = self.breaks[0] if self.breaks and self.pieces[0] == 0 else None
        end = next((high for low, high in itertools.pairwise(self.chain) if low == "a"), None)
        self.ends: dict[str, Tree] = {name: one for name, one in (("floor", self.floor), ("end", end)) if one}
        self.rules = [(tree(rule["left"]["="]), tree(rule["right"]["="])) for rule in self.profile["rules"]]
        own = {tree(p["="]) for p in self.profile["parameters"] if p["="].startswith("Symbol")}
        shape = set().union(*map(symbols, self.pieces))
        self.flags = {self.profile["contact"], *own, *shape, *self.groups, *self.ends, "normal"}
        self.flags |= {"convex"} if shape and "a" not in shape and self.profile["contact"] == "complete" else set()
        self.kind = next((kind for kind, needs in THEORY.kinds if set(needs) <= self.flags), "")
        self.fields: dict[Any, Field] = {}
        self.finer: dict[str, int] = {}
        self.done: dict[str, str] = {}
        self.proofs: dict[str, Proof] = {}
        self.end = 0.0

    def prove(self, suffix: str) -> str:
        """Why an entry is not shown; empty where it is."""
        if suffix not in self.done:
            self.done[suffix] = "it rests on itself"
            self.done[suffix] = self._attempt(suffix)
        return self.done[suffix]

    def _attempt(self, suffix: str) -> str:
        for _ in range(20):
            try:
                proof = self.proof(suffix)
                for problem, needed in proof.needs():
                    if reason := problem.prove(needed):
                        return f"rests on {problem.key}.{needed}: {reason}"
                self.fields.clear()
                self.end = time.process_time() + SECONDS
                self.formal(suffix, proof.section)
                proof.run()
            except FinerError:
                continue
            except UnknownError as error:
                return str(error)
            except Exception as error:
                return f"{type(error).__name__}: {error}"
            return ""
        return "the exponents do not come to an end"

    def section(self, suffix: str) -> Section:
        """What the theory says of a quantity; `UnknownError` if it says nothing."""
        require((self.kind, suffix) in THEORY.sections, "there is no second rule for it")
        return THEORY.sections[self.kind, suffix]

    def proof(self, suffix: str) -> Proof:
        """The statements about a quantity, found once."""
        if suffix not in self.proofs:
            self.proofs[suffix] = Proof(self, suffix)
        return self.proofs[suffix]

    def formal(self, suffix: str, section: Section) -> None:
        """The entry is one of its quantity: its name, its definition, its status and the symbols of its formulas."""
        entry: dict[str, Any] = self.records[suffix]
        name = entry["quantity"].get("@quantity", "")
        root = entry["status"] == "root"
        letters = {*section.letters, *(section.first("root") if root else ())}
        listed = [one["="] for one in entry["parameters"]]
        parameters = {"A_j" if text.startswith("IndexedBase") else tree(text) for text in listed}
        short = {tree(one["="]) for one, _ in self.profile["abbreviations"]}
        texts = [case.expr for case in self.entries[suffix]]
        known = section.all("graded" if self.medium["k"] else "defined")
        faults = {
            "its key": entry["key"] != f"{self.key}.{suffix}" or entry["profile"] != {"@profile": self.profile["name"]},
            "its quantity": name not in (f"{kind}.{suffix}" for kind in (self.kind, "compact", "plane complete")),
            "its status": entry["status"] != "closed" and not (root and section.all("root")),
            "its definition": definition(entry["definition"]["="]) not in map(definition, known),
            "its composition": entry["composed"] not in (None, section.first("composed")),
            "its parameters": listed not in self.parameters(section),
            "its symbols": not set().union(*map(symbols, texts)) <= parameters | short | letters | {"j", "N"},
            "its contact before the edge": self.kind == "complete" and bool(entry["partial"]) != (len(texts) > 1),
            "its sum": any("j" in symbols(summed(text)) for text in texts),
        }
        for fault, found in faults.items():
            require(not found, "{}: not what the quantity asks for", fault)

    def parameters(self, section: Section) -> list[list[str]]:
        """Those of the profile and the material; of the material none where a level strip does not feel it."""
        own = [one["="] for one in self.profile["parameters"]]
        if section.all("profile"):
            own = [text for text in own if tree(text) in section.first("profile")]
        material = THEORY.material(section, graded=bool(self.medium["k"]))
        whole = [f"Symbol('{name}', {'real' if name in ASSUMED else 'positive'}=True)" for name in material]
        return [[*own, *whole], *([own] if self.kind == "plane complete" and self.pieces == [0] else [])]

    def field(self, domain: Domain) -> Field:
        """The field of an order with the rules of the profile; one for equal arguments."""
        if domain not in self.fields:
            pairs = [*domain.also, *itertools.pairwise(domain.order), *itertools.pairwise(self.chain)]
            pairs += [pair for pair in self.rules if isinstance(pair[1], str)]
            order: list[tuple[Tree, str]] = []
            for low, high in pairs:
                known = low in domain.order and high in domain.order and domain.below(low, high)
                if isinstance(high, str) and (not known or (low, high) in itertools.pairwise(domain.order)):
                    order.append((low, high))
            self.fields[domain] = Field(order, self.finer, self.end)
        return self.fields[domain]

    def power(self) -> Tree:
        """The number, or n, to which the one piece of the profile is a power of the radius."""
        (piece,) = self.pieces
        name = next(iter({"r", "x"} & symbols(piece)), "r")
        field = Field([(name, "a")], self.finer, time.process_time() + SECONDS)
        shape = field.read(piece)
        power = field.slope(shape, name) * field.symbol(name) / shape if shape.num != 0 else field.number(1)
        if power.number is None and (power - field.symbol("n")).num != 0:
            message = "the face is no power of the radius"
            raise UnknownError(message)
        return "n" if power.number is None else power.number

    def cases(self, suffix: str, side: str) -> list[Case]:
        """The cases of a quantity, or what is stored beside them; `UnknownError` if its formulas are not closed."""
        record = self.records[suffix]
        if side == "fixed":
            return [Case(case) for case in record["fixed_face"]]
        if side == "partial":
            return [Case(case) for case in record["partial"]["cases"]] if record["partial"] else []
        if side not in ("own", "left", "right") and record["status"] != "closed":
            message = f"{self.key}.{suffix} is no closed formula"
            raise UnknownError(message)
        return self.entries[suffix]
