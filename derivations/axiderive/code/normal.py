"""Modules `axicontact.normal.<profile>`: the public functions around the bodies of the normal contact."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

import sympy as sp

from .. import notation as nt
from ..entry import COMPACT, FOUR, Entry, Quantity
from ..letters import name_of
from ..notation import coefficients, r
from ..physics import normal
from ..physics.systems import BY_NAME
from ..stable.forms import evaluation_form
from ..stable.signs import facts_of
from . import docstring
from .bodies import consequences, peak
from .bodies.compact import Compact
from .bodies.complete import Complete
from .bodies.inverses import Inverses
from .bodies.regimes import split
from .function import Function, reached
from .module import Module
from .private import PrivateFunctions
from .text import python
from .writer import Writer, check

SYSTEM = BY_NAME["normal"]
RATES = ("_slope", "_slope_beyond")
"""The rates of growth, which another physics calls where no public function does."""
OVER_CONTACT = {"power_pressure", "power_displacement", "power_punches"}
"""Shapes of the run time that are evaluated as its rules are."""
ITERATIONS = {"inverse", "inverse_across", "inverse_below", "inverse_beyond", "inverse_over_waves"}
ALONE = "A number for numbers."


def module(entries: Mapping[str, Entry]) -> Module:
    """The module of the normal contact of one profile."""
    writer = Writer(SYSTEM, entries, entries)
    profile, functions = writer.profile, PrivateFunctions(writer.profile)
    compact = bodies(functions, entries)
    split(functions, entries, bodies)
    if compact is not None:
        Inverses(compact).add_all()
    known = writer.private = list(functions.functions.values())
    _Interface(writer, functions).add_all()
    rates = [own for own in known if own.name in RATES]
    used = [*rates, *reached(known, [*writer.public, *rates])]
    writer.private = [*([check(profile)] if profile.rules else []), *(own for own in known if own in used)]
    return writer.module()


@dataclass
class _Interface:
    """The public functions of one profile."""

    writer: Writer
    private: PrivateFunctions

    def __post_init__(self) -> None:
        self.profile, self.entries = self.writer.profile, self.writer.entries

    def add_all(self) -> None:
        """One for the shape and for each entry; the ring of the greatest pressure comes with that pressure."""
        known = normal.QUANTITIES[self.profile.contact]
        stated = [own for suffix, own in known.items() if own is COMPACT["f"] or suffix in self.entries]
        together = groupby(stated, key=lambda quantity: quantity.function)
        self.writer.public += [self.public(*reversed(list(own))) for _, own in together]

    def public(self, quantity: Quantity, ring: Quantity | None = None) -> Function:
        """The function of a quantity; with a `ring`, of the greatest pressure and of that radius."""
        writer, profile, entry = self.writer, self.profile, self.entries.get(quantity.suffix)
        symbols = entry.parameters if entry else profile.parameters
        fields = [name_of(symbol) for symbol in (entry.arguments if entry else quantity.arguments)]
        keywords = [name_of(symbol) for symbol in symbols]
        private = self.private[quantity.function]
        body = writer.checks(symbols, reach="a" in fields)
        if writer.summed and "A" not in private.needs:
            body[0] = body[0].removeprefix("A = ")
        evaluated = writer.evaluated(private.name, fields, keywords)
        if ring:
            radius = writer.evaluated(f"_{peak.RADIUS}", fields, keywords)
            body += [f"pressure = {evaluated}", f"radius = {radius}"]
            evaluated = f"{peak.RESULT}(pressure, radius)"
        body.append(f"return {evaluated}")
        # the function itself checks a rule between parameters and a sequence of coefficients; a pair is no number
        if not (writer.summed or profile.rules or ring):
            given = ", ".join([*private.parameters, *(name for name in keywords if name not in private.needs)])
            asked = [f"value = plain.{quantity.function}({given})", "if value is not None:", "    return value"]
            body = [*asked, *body]
        doc, result = self.document(quantity, entry, ring), peak.RESULT if ring else "Result"
        return Function(quantity.function, fields, keywords, body, doc, result)

    def document(self, quantity: Quantity, entry: Entry | None, ring: Quantity | None) -> str:
        """The docstring; with a `ring`, of a result that has it for a member."""
        profile = self.profile
        stated = docstring.formula(profile, quantity, entry)
        said = docstring.measured(docstring.in_words(quantity.symbol), quantity.symbol)
        if ring is not None:
            of_ring = docstring.formula(profile, ring, self.entries[ring.suffix])
            stated += [line for line in of_ring if line not in stated]
            units = [nt.describe(own.symbol).unit for own in (quantity, ring)]
            said = f"Named tuple of pressure [{units[0]}] and radius [{units[1]}]"
        fields = entry.arguments if entry else quantity.arguments
        keywords = entry.parameters if entry else profile.parameters
        rows = docstring.parameters(fields, keywords, docstring.words_of(profile))
        returns = (peak.RESULT if ring else docstring.NUMBERS, f"{said}. {docstring.SHAPE if fields else ALONE}")
        sources = docstring.sources_of(entry) if entry else profile.sources
        example = self.writer.example.lines(quantity.suffix) if entry else self.writer.example.shape()
        notes = self.notes(quantity, "a" in map(str, fields), [quantity] if ring is None else [ring, quantity])
        return docstring.document(quantity.summary, stated, rows, returns, notes, sources, example)

    def notes(self, quantity: Quantity, at_radius: bool, keys: Sequence[Quantity]) -> str:
        """Validity, what gives NaN, evaluation and the keys."""
        profile, private = self.profile, self.private[quantity.function]
        outside = "Negative or NaN field values"
        if profile.truncated and at_radius:
            outside += f", and radii below {profile.breaks[0]} among larger ones,"
        notes = [f"Valid for {profile.validity}. {outside} give NaN."]
        used = private.uses.union(*(own.uses for own in reached(self.writer.private, [private])))
        if used & OVER_CONTACT or any("_integral" in name for name in used):
            notes.append("Evaluated as an integral over the growing contact by a Gauss-Legendre rule.")
        if used & ITERATIONS:
            notes.append("Evaluated by a safeguarded Newton iteration.")
        if profile.note and quantity.suffix in FOUR[:3] and coefficients not in profile.parameters:
            notes.append(f"{docstring.capital(profile.note)}.")
        shown = ", ".join(f"{profile.name}.{own.suffix}" for own in keys)
        notes.append(f"Handbook: {shown}{', the definition of the profile' if quantity is COMPACT['f'] else ''}.")
        return " ".join(notes)


def bodies(functions: PrivateFunctions, entries: Mapping[str, Entry]) -> Compact | None:
    """Add the private functions but for the inverses of a compact contact, which follow its curves."""
    profile_function(functions)
    if functions.profile.complete:
        complete = Complete(entries, functions)
        complete.add_all()
        consequences.of_complete(complete)
        return None
    compact = Compact(entries, functions)
    compact.depth_like("d", "depth")
    compact.depth_like("F", "force")
    compact.pressure()
    compact.displacement()
    form = functions.form(entries["k"], entries["k"].cases[0].expr, facts_of(()))
    compact.stiffness(form)
    compact.depth_like("pm", "mean_pressure")
    peak.bodies(compact, functions, entries)
    consequences.of_compact(compact, entries)
    return compact


def bodies_source(functions: PrivateFunctions, title: str) -> str:
    """A module of private functions alone: to be measured, not to be published."""
    profile, private = functions.profile, list(functions.functions.values())
    return Module(SYSTEM, profile.name, profile.title, title, [], private).source()


def profile_function(functions: PrivateFunctions) -> None:
    """Adds the shape f(r) of the indenter."""
    profile = functions.profile
    lines, values = list[str](), list[tuple[sp.Expr | None, str]]()
    lower: sp.Expr = sp.S.Zero
    for piece in profile.pieces:
        form = evaluation_form(piece.expr, facts_of((lower, r) if lower != 0 else (r,)))
        lines += [line for line in functions.steps(form) if line not in lines]
        values.append((piece.upper, python(form.value)))
        lower = piece.upper
    text = values[-1][1]
    for upper, value in reversed(values[:-1]):
        text = f"np.where(r < {upper}, {value}, {text})"
    if profile.complete:
        text = f"np.where(r <= a, {text}, np.nan)"
    if text == "0":
        text = "np.zeros_like(r)"
    functions.add("profile", ("r",), [*lines, f"return {text}"])
