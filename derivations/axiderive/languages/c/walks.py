"""Searches for branches, radius by radius, and the rule over springs: loops over tables in the place of arrays.

Branches are looked at where they are found, so that there are no lists of them.
"""

from __future__ import annotations

import ast
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from .. import searches
from ..reach import Module
from .calls import Calls
from .values import Closure, Native, Number, Record, Scope, Text, Value, bracketed, literal, number_of, variables_of

MOST = 512
"""Radii of which a search keeps what it found, where the program finds how many there are."""
ABOVE = ast.Lambda(
    ast.arguments([], [ast.arg("a")], None, [], [], None, []),
    ast.parse("_log(steepness(a) / level)", mode="eval").body,
)
CHANGE = ast.parse("_change(above, low, high, _log(before / level), _log(after / level), sign)", mode="eval").body
"""What is asked on both sides of a change of sign, in the words of the search over plain numbers."""


@dataclass(frozen=True)
class Radii:
    """Radii that are told by their places: a function of C of them, times a length."""

    at: Callable[[str], str]
    count: Number
    length: Number
    needs: frozenset[str]

    def radius(self, place: Number) -> Number:
        """The radius of a place."""
        text = f"{self.at(place.text)} * {bracketed(self.length, 7)}"
        return Number(text, "double", 6, place.names | self.length.names | self.count.names | self.needs)

    @property
    def last(self) -> Number:
        """The last one."""
        return self.radius(Number(f"{bracketed(self.count, 6)} - 1", "int", 5))


@dataclass(frozen=True)
class Found:
    """The branches on which a steepness is above a level, before they are looked for."""

    steepness: Value
    radii: Radii
    end: Value
    level: Number


class Walks(Calls):
    """Writes what goes over arrays in Python."""

    def expr(self, node: ast.expr, scope: Scope) -> Value:
        """The value of an expression; of what was sampled the radii."""
        match node:
            case ast.Call(ast.Name(searches.SAMPLES), [radii, _, end, _]):
                return Record({"radii": self.expr(radii, scope), "end": self.expr(end, scope)})
            case ast.Call(ast.Attribute(value, "item"), []):
                return self.expr(value, scope)
        return super().expr(node, scope)

    def _attribute(self, value: Value, attribute: str, scope: Scope) -> Value:
        # both ends of a branch are found together
        return value if isinstance(value, Found) else super()._attribute(value, attribute, scope)

    def _item(self, value: Value, place: ast.expr, scope: Scope) -> Value:
        return value.last if isinstance(value, Radii) else super()._item(value, place, scope)

    def _natively(self, native: Native, given: list[Value], named: Mapping[str, Value], scope: Scope) -> Value:
        match native.name:
            case "branches":
                return self.found(given)
            case "lowest":
                return self.lowest(given[0], given[1], scope)
            case "springs":
                return self.springs(given, scope)
            case "zip" if isinstance(given[0], Found):
                return given[0]
            case name if (searches.BRANCHES, name) in searches.OWN and name != "halfway":
                return self.radii(name, given)
        return super()._natively(native, given, named, scope)

    def radii(self, name: str, given: list[Value]) -> Radii:
        """The radii of a form."""
        if name == "radii_of_waves":
            length, reach = map(number_of, given)
            waves = self.variable("waves", "int")
            text = f"waves_within({reach.text} / {bracketed(length, 7)})"
            self.emit(f"{waves.text} = {text};", waves.text, reach.names | length.names)
            count = Number(f"16 * {waves.text} + 25", "int", 5, waves.names)
            return Radii(lambda place: f"radius_of_waves({place}, {waves.text})", count, length, frozenset())
        values = searches.radii(self._module(searches.BRANCHES).text, name)
        table = name.upper()
        self._table(table, f"[{len(values)}]", [literal(one) for one in values])
        count = Number(str(len(values)), "int")
        length = number_of(given[0]) if given else Number("1.0")
        return Radii(lambda place: f"{table}[{place}]", count, length, frozenset((table,)))

    def _table(self, name: str, size: str, values: list[str]) -> None:
        rows = ",\n".join(f"  {', '.join(values[place : place + 4])}" for place in range(0, len(values), 4))
        self.file.written[name] = Text(f"static const double {name}{size} = {{\n{rows}\n}};\n", frozenset(), ())

    def _module(self, name: str) -> Module:
        module = self.file.package.module(name)
        assert module is not None
        return module

    def found(self, given: list[Value]) -> Found:
        """The branches of a steepness, the radii that were sampled, and a level."""
        steepness, sampled, level = given
        kept = self.variable("level", "double")
        self.set(kept, level)
        return Found(steepness, sampled.fields["radii"], sampled.fields["end"], kept)

    def each_branch(self, found: Found, scope: Scope, look: Callable[[Number, Number], None]) -> None:
        """A loop that looks at the ends of every branch, in ascending order."""
        module = self._module(searches.SINGLE)
        far = self.file.constant(module, "FAR") if "FAR" in module.bound else self.named(Scope(module), "FAR")
        place, opened, rises, rose, over = (
            self.variable(one, "int") for one in ("place", "open", "rises", "rose", "over")
        )
        a, before, own, known, first, last = (
            self.variable(one, "double")
            for one in ("radius", "radius_before", "steep", "steep_before", "first", "last")
        )
        radii = found.radii
        end, count = radii.last, bracketed(radii.count, 5)
        self.emit(f"{opened.text} = 0;", None, opened.names)
        at = len(self.lines)
        head = f"for ({place.text} = 0; {place.text} <= {count}; {place.text}++) {{"
        self.emit(head, None, place.names | radii.count.names)
        self.depth += 1
        scope.divided += 1
        self.emit(f"{over.text} = 0;", None, over.names)
        self.emit(f"if ({place.text} == {count}) {{", None, place.names)
        self.depth += 1
        self.set(last, found.end)
        self.emit(f"{over.text} = {opened.text};", None, over.names | opened.names)
        self.depth -= 1
        self.emit("} else {")
        self.depth += 1
        self.set(a, radii.radius(place))
        kept = self._sample(found, a, own, place, scope, at)
        self.emit(
            f"{rises.text} = {own.text} >= {found.level.text};", None, rises.names | own.names | found.level.names
        )
        self.emit(f"if ({place.text} == 0) {{", None, place.names)
        self.depth += 1
        self.set(first, a)
        self.emit(f"{opened.text} = {rises.text};", None, opened.names | rises.names)
        self.depth -= 1
        self.emit(f"}} else if ({rises.text} != {rose.text} && ({rises.text} || {before.text} < {literal(far)})) {{",
                  None, rises.names | rose.names | before.names)  # fmt: skip
        self.depth += 1
        names = {"steepness": found.steepness, "level": found.level, "low": before, "high": a, "before": known,
                 "after": own, "sign": Number(f"{rises.text} ? 1.0 : -1.0", "double", 0, rises.names)}  # fmt: skip
        inner = Scope(module, names=names, divided=1)
        names["above"] = Closure(ABOVE, module, inner)
        change = self.variable("change", "double")
        if kept:
            known_change, known_level = kept
            test = f"if ({known_level.text} != {found.level.text}) {{"
            self.emit(test, None, known_level.names | found.level.names)
            self.depth += 1
            self.set(change, self.expr(CHANGE, inner))
            self.emit(f"{known_change.text} = {change.text};", None, known_change.names | change.names)
            self.emit(f"{known_level.text} = {found.level.text};", None, known_level.names | found.level.names)
            self.depth -= 1
            self.emit("}")
            self.set(change, known_change)
        else:
            self.set(change, self.expr(CHANGE, inner))
        self.emit(f"if ({rises.text}) {{", None, rises.names)
        self.depth += 1
        self.emit(f"{first.text} = lower({change.text}, nextafter({end.text}, 0.0));", None,
                  first.names | change.names | end.names)  # fmt: skip
        self.depth -= 1
        self.emit("} else {")
        self.depth += 1
        self.set(last, change)
        self.emit(f"{over.text} = {opened.text};", None, over.names | opened.names)
        self.depth -= 1
        self.emit("}")
        self.emit(f"{opened.text} = {rises.text};", None, opened.names | rises.names)
        self.depth -= 1
        self.emit("}")
        for old, new in ((before, a), (known, own)):
            self.set(old, new)
        self.emit(f"{rose.text} = {rises.text};", None, rose.names | rises.names)
        self.depth -= 1
        self.emit("}")
        self.emit(f"if ({over.text}) {{", None, over.names)
        self.depth += 1
        look(first, last)
        self.depth -= 1
        self.emit("}")
        self.depth -= 1
        scope.divided -= 1
        self.emit("}")

    def _sample(self, found: Found, a: Number, own: Number, place: Number, scope: Scope, head: int) -> list[Number]:
        """The steepness at a radius in a loop whose head is that line; what was sampled stays for the same geometry.

        So do, in two further tables, the changes that are found from there on, and the levels they were found for.
        """
        old, before = set(self.kinds), len(self.lines)
        self.depth += 1
        self.set(own, self.call(found.steepness, [a], {}, scope))
        self.depth -= 1
        lines = self.lines[before:]
        radii = found.radii
        read = radii.length.names.union(radii.count.names, *(needs for *_, needs in lines))
        made = {name for _, _, name, _ in lines} | a.names
        given = sorted((read & old) - made)
        if not given:
            self.lines[before:] = [(depth - 1, text, sets, needs) for depth, text, sets, needs in lines]
            return []
        whole = radii.count.text.isdecimal()
        # beyond, the last place serves all radii, each for itself
        count = radii.count.text if whole else str(MOST)
        slot = place.text if whole else f"{place.text} < {MOST - 1} ? {place.text} : {MOST - 1}"
        steep, changes, levels = (self.variable(one, f"kept {count}") for one in ("sampled", "changes", "changes_of"))
        of = self.variable("sampled_of", f"kept {len(given)}")
        there = self.variable("sampled_there", "kept")
        del self.lines[before:]
        names = steep.names | there.names | place.names
        self.emit(f"if ({place.text} < {there.text}) {{", None, names)
        self.emit(f"  {own.text} = {steep.text}[{place.text}];", None, names | own.names)
        self.emit("} else {")
        self.lines += lines
        self.emit(f"  {steep.text}[{slot}] = {own.text};", None, names | own.names)
        self.emit(f"  {levels.text}[{slot}] = NAN;", None, names | levels.names)
        within = "" if whole else f"if ({place.text} < {MOST - 1}) "
        self.emit(f"  {within}{there.text} = {place.text} + 1;", None, names)
        self.emit("}")
        others = " || ".join(f"{of.text}[{at}] != {name}" for at, name in enumerate(given))
        changed = [f"if ({others}) {{", *(f"  {of.text}[{at}] = {name};" for at, name in enumerate(given)),
                   f"  {there.text} = 0;", "}"]  # fmt: skip
        depth = self.lines[head][0]
        self.lines[head:head] = [(depth, text, None, of.names | there.names | {*given}) for text in changed]
        return [replace(one, text=f"{one.text}[{slot}]", names=one.names | place.names) for one in (changes, levels)]

    def lowest(self, found: Found, load: Value, scope: Scope) -> Number:
        """The radius at the start of a branch at which a load is least."""
        best, least = self.variable("lowest", "double"), self.variable("least", "double")
        self.emit(f"{best.text} = NAN;", None, best.names)

        def look(first: Number, _: Number) -> None:
            own = self.variable("load", "double")
            self.set(own, self.call(load, [first], {}, scope))
            known = f"{own.text} == {own.text} && ({best.text} != {best.text} || {own.text} < {least.text})"
            self.emit(f"if ({known}) {{", None, own.names | best.names | least.names)
            self.emit(f"  {best.text} = {first.text};", None, best.names | first.names)
            self.emit(f"  {least.text} = {own.text};", None, least.names | own.names)
            self.emit("}")

        self.each_branch(found, scope, look)
        return best

    def springs(self, given: list[Value], scope: Scope) -> Number:
        """What springs bear, by the nodes of their rule."""
        left, low, high = given
        pairs, under = searches.springs(self._module(searches.RELAXATION).text)
        self._table("SPRINGS", f"[{len(pairs)}][2]", [f"{{{x!r}, {weight!r}}}" for x, weight in pairs])
        total, place = self.variable("total", "sum"), self.variable("place", "int")
        start, length, first = (self.variable(one, "double") for one in ("start", "length", "first"))
        self.set(start, low)
        self.set(length, self._arithmetic(ast.Sub(), high, start, scope))
        self.set(first, self.call(left, [start], {}, scope))
        self.emit(f"{total.text}.high = {total.text}.low = 0.0;", None, total.names)
        self.emit(f"for ({place.text} = 0; {place.text} < {len(pairs)}; {place.text}++) {{", None, place.names)
        self.depth += 1
        scope.divided += 1
        needs = place.names | length.names | {"SPRINGS"}
        node = Number(f"{start.text} + {length.text} * SPRINGS[{place.text}][0]", "double", 5, needs | start.names)
        term = number_of(self.call(left, [node], {}, scope))
        self.add_to(
            total, replace(term, text=f"SPRINGS[{place.text}][1] * {bracketed(term, 6)}", names=term.names | needs)
        )
        scope.divided -= 1
        self.depth -= 1
        self.emit("}")
        text = f"{length.text} * (sum_of(&{total.text}) + {under!r} * {first.text})"
        return Number(text, "double", 6, variables_of((length, total, first)))
