"""Modules `axicontact.graded.normal.<profile>` of profiles with a compact contact."""

from __future__ import annotations

from collections.abc import Mapping

from ...entry import COMPACT, Entry
from ...notation import a
from ...physics.systems import System
from .. import docstring
from ..function import Function
from ..module import Module
from ..text import written
from ..writer import Writer, ordered
from .families import Family, family

METHOD = {
    "inside": "Evaluated as an integral over the growing contact, by a rule that carries the weight of the grading.",
    "outside": "Evaluated as an integral over the displacement inside the contact.",
}


def module(system: System, entries: Mapping[str, Entry]) -> Module:
    """The module of one profile."""
    return _Normal(Writer(system, entries, entries)).module()


def add_shape(writer: Writer) -> None:
    """Adds the public function of the shape of the indenter, which no medium changes."""
    profile, names = writer.profile, writer.geometry
    body = [f"return normal.profile(r, {', '.join(f'{name}={name}' for name in names)})"]
    notes = f"Valid for {profile.validity}. Negative or NaN field values give NaN."
    doc = docstring.of_shape(profile, notes, writer.example.shape())
    writer.public.append(Function("profile", ["r"], names, body, doc, "Result"))


LIMITS = {"flank": ("1.0 + k", 1.0), "rim": ("1.0 + k", 2.0), "rounding": ("3.0 + k", 2.0)}
"""Powers of the root with which the depth of a break begins, and of the radius with which it ends."""


class _Normal:
    def __init__(self, writer: Writer) -> None:
        self.writer, self.entries, self.profile = writer, writer.entries, writer.profile
        self.family: Family = family(self.profile)
        self.geometry = [*self.writer.geometry, "k"]
        self.material = [*self.writer.geometry, "H", "k"]

    def module(self) -> Module:
        """The whole module."""
        self.growth()
        self.fields()
        self.inverses()
        add_shape(self.writer)
        for suffix in COMPACT:
            if suffix in self.entries:
                self.public(self.entries[suffix])
        if self.profile.rules:
            self.check()
        return self.writer.module()

    def public(self, entry: Entry) -> None:
        """Adds the public function of one quantity to the module."""
        profile, at_radius = self.profile, a in entry.arguments
        outside = "Negative or NaN field values"
        if profile.truncated and at_radius:
            outside += f", and radii below {profile.breaks[0]} among larger ones,"
        notes = [f"Valid for {profile.validity}. {outside} give NaN."]
        if entry.quantity.place:
            notes.append(METHOD[entry.quantity.place])
        if entry.quantity.inverts and self.family.power is None:
            notes.append("Evaluated by a safeguarded Newton iteration.")
        self.writer.add(entry, " ".join(notes), self.writer.checks(entry.parameters, reach=at_radius))

    def check(self) -> None:
        """The rules between the parameters; that of the waves depends on the grading."""
        names = self.writer.geometry
        passed = ", ".join(f"{name}={name}" for name in names)
        if not self.family.has("waves"):
            body = [f"normal._check({passed}, k=k, **material)"]
        else:
            (rule,) = self.profile.rules
            body = [
                f"require({passed}, k=k, **material)",
                "R, h, wavelength = np.asarray(R), np.asarray(h), np.asarray(wavelength)",
                *ordered(
                    "elementwise(steepest_waves, k=k) * R * h <= wavelength**2",
                    "steepest_waves(k)*R*h <= wavelength**2",
                    rule.reason,
                    ("R", "h", "wavelength", "k"),
                ),
            ]
        typed = [f"{name}: ArrayLike" for name in names]
        more = ["*", "k: ArrayLike", "**material: ArrayLike"]
        self.writer.private.append(Function("_check", typed, more, body, returns="None"))

    def domain(self) -> str:
        """The condition on the contact radius, "" where there is none."""
        if self.profile.truncated:
            return f"a >= {self.profile.breaks[0]}"
        if self.family.has("sphere"):
            return f"a <= {self.profile.chain[-1]}"
        if self.family.has("gaussian"):
            return f"_rate({', '.join(['a', *self.geometry])}) >= 0.0"
        return ""

    def limited(self, value: str) -> str:
        """The code of a value, NaN outside the range of the contact radius if that has one."""
        return f"np.where({self.domain()}, {value}, np.nan)" if self.domain() else value

    def growth(self) -> None:
        """Depth, its rate and the force, in the radius or in the radius and its root."""
        writer, own = self.writer, self.family
        fields, at = (("a", "root"), "_at") if own.root else (("a",), "")
        needs = {"depth": self.geometry, "rate": self.geometry, "force": self.material}
        for name, symbols in needs.items():
            lines = [f"growth = {own.total(name, *fields)}"]
            value = "2.0 * H / (1.0 + k) * growth" if name == "force" else "growth"
            value = value if own.root or name == "rate" else self.limited(value)
            lines = [*lines, f"return {value}"] if value != "growth" else [f"return {own.total(name, *fields)}"]
            writer.rule(f"_{name}{at}", fields, symbols, lines, "Rate g'(a) of the depth." if name == "rate" else "")
        if own.root:
            for name, symbols in needs.items():
                value = f"_{name}_at({', '.join(['a', own.root, *symbols])})"
                writer.rule(f"_{name}", ["a"], symbols, [f"return {self.limited(value)}"])
        if own.power is None:
            lines = [f"return punch_stiffness(a, H, k) * _rate{at}({', '.join([*fields, *self.geometry])})"]
            writer.rule(f"_force_rate{at}", fields, self.material, lines, "Derivative of the force.")
        writer.rule("_stiffness", ["a"], ["H", "k"], ["return punch_stiffness(a, H, k)"])
        mean = f"_force({', '.join(['a', *self.material])}) / (np.pi * a * a)"
        lines = [f"return {mean if self.profile.truncated else f'np.where(a > 0.0, {mean}, 0.0)'}"]
        if own.power is not None or own.summed:
            lines = [f"growth = {own.total('mean', 'a')}", "return 2.0 * H / (1.0 + k) / np.pi * growth"]
        writer.rule("_mean_pressure", ["a"], self.material, lines)

    def fields(self) -> None:
        """Pressure and displacement."""
        writer, own = self.writer, self.family
        pressure = [
            "inside = np.minimum(r, a)",
            f"growth = {own.total('pressure', 'inside', 'a')}",
            f"return {self.limited('np.where(r < a, H / np.pi * growth, 0.0)')}",
        ]
        writer.rule("_pressure", ["r", "a"], self.material, pressure)
        displacement = [f"return {own.total('displacement', 'r', 'a')}"]
        writer.rule("_displacement", ["r", "a"], self.geometry, displacement)

    def inverses(self) -> None:
        """Adds the private functions for a(d), a(F), F(d) and d(F)."""
        needs = {"depth": self.geometry, "force": self.material}
        for quantity, field in (("depth", "d"), ("force", "F")):
            lines, name = self.inverse(quantity, field, needs[quantity]), f"_radius_from_{quantity}"
            if self.end:
                contact = f"_contact_from_{quantity}"
                doc = f"Contact radius a and its root {self.end}."
                self.writer.rule(contact, [field], needs[quantity], lines, doc, "tuple[Array, Array]")
                lines = [f"return {contact}({', '.join([field, *needs[quantity]])})[0]"]
            self.writer.rule(name, [field], needs[quantity], lines)
        for outer, inner, field in (("force", "depth", "d"), ("depth", "force", "F")):
            lines = self.through(outer, inner, field, needs)
            self.writer.rule(f"_{outer}_from_{inner}", [field], self.material, lines)

    @property
    def end(self) -> str:
        """The root without which a radius says too little: next to the end of a sphere, or to a flat face."""
        if self.family.has("sphere"):
            return f"sqrt({self.profile.chain[-1]}**2 - a**2)"
        return f"sqrt(a**2 - {self.profile.breaks[0]}**2)" if self.profile.truncated else ""

    def through(self, outer: str, inner: str, field: str, needs: Mapping[str, list[str]]) -> list[str]:
        """F(a(d)) or d(a(F)); the radius is rounded, and dF/dd makes good what it lost."""
        radius = f"_radius_from_{inner}({', '.join([field, *needs[inner]])})"
        if (power := self.family.power) is not None:
            # F/d is a lower power of the radius than either, and takes up less of its rounding
            ((n,), gain) = power.texts, f"stiffness = punch_stiffness({radius}, H, k)"
            stiffness = f"stiffness * ({n} / ({n} + (1.0 + k)))"
            value = f"d * ({stiffness})" if outer == "force" else f"F / ({stiffness})"
            return [gain, f"return np.where(({field} > 0.0) & np.isfinite({field}), {value}, {field})"]
        if self.end:
            names, at, found = ["a", "root"], "_at", radius.replace("_radius", "_contact", 1)
        else:
            names, at, found = ["a"], "", radius
        missed = f"{field} - _{inner}{at}({', '.join([*names, *needs[inner]])})"
        return [
            f"{', '.join(names)} = {found}",
            f"return _{outer}{at}({', '.join([*names, *needs[outer]])}) + punch_{outer}({missed}, a, H, k)",
        ]

    def inverse(self, quantity: str, field: str, needs: list[str]) -> list[str]:
        """The lines of a(d) or a(F): in closed form for one power of r, else a safeguarded iteration."""
        own, passed = self.family, f"({', '.join(needs)})"
        rate = "rate" if quantity == "depth" else "force_rate"
        if own.power is not None:
            order = own.power.lengths[0]
            unit = f"{field} / _{quantity}({', '.join([f'np.ones_like({field})', *needs])})"
            exponent = str(float(order)) if order.is_number else written(order)
            if quantity == "force":
                exponent = f"({float(order) + 1.0} + k)" if order.is_number else f"({order} + (1.0 + k))"
            root = {"1.0": unit, "2.0": f"np.sqrt({unit})"}
            return [f"return {root.get(exponent, f'({unit}) ** (1.0 / {exponent})')}"]
        call = f"(_{quantity}{{at}}, _{rate}{{at}}, {field}, {{length}}, {passed}{{more}})"
        if own.has("gaussian"):
            text = call.format(at="", length="gaussian_reach(s, k)", more=", on_the_bump(s)")
            return [f"return radius_up_to{text}"]
        if own.root:
            return [f"return {self.through_root(quantity, call)}"]
        lengths = [*self.writer.geometry, *(str(symbol) for symbol, _ in self.profile.abbreviations)]
        # off the break itself, where the rate is infinite
        start = next((f"1.5 * {name}" for name in ("b", "wavelength") if name in lengths), "1.0")
        return [f"return radius_to(_{quantity}, _{rate}, {field}, {start}, {passed})"]

    def through_root(self, quantity: str, call: str) -> str:
        """The call of the iteration whose unknown is made of the root."""
        own, force = self.family, quantity == "force"
        tip = "3.0 + k" if force else "2.0"
        if self.profile.truncated:
            (term,) = own.terms
            first, last = LIMITS[term.shape]
            more = f", ({first}, {f'{last + 1.0} + k' if force else last})"
            return "contact_beyond" + call.format(at="_at", length=self.profile.breaks[0], more=more)
        if own.has("sphere"):
            return "contact_below" + call.format(at="_at", length=self.profile.chain[-1], more=f", {tip}, k")
        bends = any(LIMITS.get(term.shape, ("",))[0] == "1.0 + k" for term in own.terms)
        more = f", {tip}" + (f", least={LIMITS['rim'][0]}" if bends else "") + (", end=R" if own.has("tipped") else "")
        return "radius_across" + call.format(at="_at", length=self.profile.breaks[0], more=more)
