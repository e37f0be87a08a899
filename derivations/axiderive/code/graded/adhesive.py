"""Modules `axicontact.graded.adhesive.<profile>`: the graded normal contact less the retracted punch."""

from __future__ import annotations

import sympy as sp

from ...entry import Entry
from ...letters import name_of
from ...notation import n
from .. import docstring
from ..function import Function
from ..physics import separation
from ..physics.adhesive import stated
from ..physics.branches import SAMPLED, own_units, pull_off, radii, returned, search, unknowns
from ..text import python
from ..writer import Writer
from .families import family

ORDER = [
    "require_order(",
    "    np.asarray(n) > (1.0 - np.asarray(k)) / 2.0,",
    '    "n > (1 - k)/2",',
    '    "a sharper profile has no pull-off, its adhesive contact is unstable at every radius; "',
    '    "use n > (1 - k)/2, or force(a) and depth(a) for the states of equilibrium",',
    "    n=n,",
    "    k=k,",
    ")",
]
ORDERS = {"depth": ("d", "", "(1.0 - k) / 2.0"), "force": ("F", " + 1.0 + k", "(3.0 + k) / 2.0")}
"""Field, what the exponent of the load gains on that of the profile, and the exponent of the pull."""
REACH = '(2.0 * (1.0 + k) * R * least_steepness("force", H, k, dgamma)) ** (2.0 / (3.0 + k))'
"""Up to where waves are looked at: the load of a paraboloid grows four times as steeply there as at pull-off."""


def interface(writer: Writer) -> None:
    """Adds the public functions of a compact contact."""
    own = _Adhesive(writer)
    own.interface()
    separation.interface(writer, own.order())


def rules(writer: Writer) -> None:
    """Adds what they rest on."""
    own = _Adhesive(writer)
    own.rules()
    if own.power is not None:
        own.power_law(own.power.lengths[0])
    else:
        own.general()
    separation.rules(writer)


class _Adhesive:
    def __init__(self, writer: Writer) -> None:
        self.writer, self.entries, self.profile = writer, writer.entries, writer.profile
        self.family = family(self.profile)
        self.power = self.family.power
        self.geometry = [*self.writer.geometry, "k"]
        self.material = [*self.writer.geometry, "H", "k"]
        self.symbols = [
            *self.profile.parameters,
            *(s for s in self.entries["F"].parameters if s not in self.profile.parameters),
        ]
        self.keywords = [name_of(symbol) for symbol in self.symbols]

    def interface(self) -> None:
        """Adds the public functions."""
        for entry in stated(self.entries):
            self.public(entry)
        self.pull_off()

    def public(self, entry: Entry) -> None:
        """Adds the public function of one quantity to the module."""
        writer, symbols = self.writer, entry.parameters
        keywords = [name_of(symbol) for symbol in symbols]
        # the retraction is the same for every profile
        own = set(self.profile.parameters) <= set(symbols)
        fields = [str(argument) for argument in entry.quantity.arguments]
        notes = f"Valid for {self.profile.validity}. Negative or NaN radii give NaN."
        if entry.quantity.inverts:
            body = [*writer.checks(symbols), *self.order()]
            signed = dict.fromkeys(fields, fields[0])
            evaluated = writer.evaluated(f"_{entry.quantity.function}", [], keywords, **signed)
            notes = f"Valid for {self.profile.validity}. NaN below pull-off."
            if self.power is None:
                notes += " Where several radii are stable, the largest, which is reached on unloading."
        else:
            body = writer.checks(symbols, reach=self.profile.truncated and own)
            function = f"_{entry.quantity.function}" if own else "graded_retraction"
            evaluated = writer.evaluated(function, fields, keywords)
        writer.add(entry, notes, body, evaluated)

    def order(self) -> list[str]:
        """The lines that check a free exponent of a power law; none for any other profile."""
        return ORDER if self.power is not None and self.power.lengths[0] == n else []

    def rules(self) -> None:
        """The rule of Hess for each quantity."""
        moved = "graded_retraction(a, H, k, dgamma)"
        needs = [*self.material, "dgamma"]
        losses = {
            "_depth": (["a"], self.geometry, moved),
            "_force": (["a"], self.material, f"punch_stiffness(a, H, k) * {moved}"),
            "_pressure": (["r", "a"], self.material, "tension(r, a, H, k, dgamma)"),
            "_displacement": (["r", "a"], self.geometry, f"{moved} * punch_displacement(r, a, k)"),
        }
        for name, (fields, own, loss) in losses.items():
            value = f"normal.{name}({', '.join([*fields, *own])}) - {loss}"
            self.writer.rule(name, fields, needs, [f"return {value}"])

    def power_law(self, exponent: sp.Expr) -> None:
        """One universal curve for both controls and all exponents."""
        own = python(exponent)
        own = f"{own}.0" if own.isdigit() else own
        writer, needs = self.writer, [*self.material, "dgamma"]
        lines = [
            f"rate = normal._rate({', '.join(['np.ones_like(H * k)', *self.geometry])})",
            f"own = unloading_radius(rate, {own}, H, k, dgamma, control)",
            "return np.where(dgamma > 0.0, own, 0.0)",
        ]
        writer.rule("_pull_off_radius", [], [*needs, "control"], lines)
        for quantity, (field, gain, order) in ORDERS.items():
            passed = self.material if quantity == "force" else self.geometry
            load = f"normal._{quantity}({', '.join(['a', *passed])})"
            exponent_of_load = f"({own}{gain})" if gain else own
            # at pull-off the retraction is 2 a g'(a)/xi = 2 n g(a)/xi
            lost = f"2.0 * {own} / stationary(control, k)"
            if gain:
                lost = f"2.0 * ({own}{gain}) / stationary(control, k)"
            doc = "With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."
            writer.rule(f"_pull_off_{quantity}", ["a"], [*needs, "control"], [f"return {load} * (1.0 - {lost})"], doc)
            both = ", ".join(needs)
            plain = f"normal._radius_from_{quantity}({', '.join([f'np.maximum({field}, 0.0)', *passed])})"
            lines = [
                f'a_c = _pull_off_radius({both}, control="{quantity}")',
                f'least = _pull_off_{quantity}(a_c, {both}, control="{quantity}")',
                f"plain = {plain}",
                f"return power_law_radius({field}, a_c, least, {exponent_of_load.strip('()')}, {order}, plain)",
            ]
            writer.rule(f"_radius_from_{quantity}", [field], needs, lines)

    def general(self) -> None:
        """Between refined changes of sign of the growth."""
        writer, needs = self.writer, [*self.material, "dgamma"]
        geometry, both = f"({', '.join(self.geometry)})", ", ".join(needs)
        grid = radii(self.profile, REACH, graded=True)
        steepness = f"a ** ((1.0 + k) / 2.0) * normal._rate({', '.join(['a', *self.geometry])})"
        level = "least_steepness(control, H, k, dgamma)"
        own, samples, found = search(self.profile, self.geometry, needs, grid, steepness, level)
        writer.rule("_samples", [], own, samples, SAMPLED, returns="Samples", decorator="Kept")
        writer.rule("_branches", [], [*needs, "control"], found, returns="Branches")
        lines = pull_off(own_units(self.profile, self.geometry, "H", "dgamma"), needs)
        writer.rule("_pull_off_radius", [], [*needs, "control"], lines)
        for quantity, (field, *_) in ORDERS.items():
            units = own_units(self.profile, self.geometry, "H", "dgamma", field)
            unknown = unknowns(self.profile, "k", steep=self.family.has("flank", "rim"))
            given = f"{field}, found, lambda a: _{quantity}(a, {both}), slope, pulled, {unknown}"
            lines = [
                *units,
                f'found = _branches({both}, control="{quantity}")',
                f'slope = growth_of(normal._rate, {geometry}, H, k, dgamma, control="{quantity}")',
                f'pulled = pull_of(H, k, dgamma, control="{quantity}")',
                *returned(f"stable_radius({given})", units),
            ]
            writer.rule(f"_radius_from_{quantity}", [field], needs, lines)

    def pull_off(self) -> None:
        """Adds the public function `pull_off` under control of force or depth."""
        writer = self.writer
        named = ", ".join(f"{name}={name}" for name in self.keywords if not (writer.summed and name == "A"))
        fixed = "A=A, " if writer.summed else ""
        body = [*writer.checks(self.symbols), "require_control(control)", *self.order()]
        body.append(f"radius = elementwise(partial(_pull_off_radius, {fixed}control=control), {named})")
        for name in ("force", "depth"):
            function = f"partial(_{name}, A=A)" if writer.summed else f"_{name}"
            if self.power is not None:
                function = f"partial(_pull_off_{name}, control=control)"
            body.append(f"{name} = elementwise({function}, radius, {named})")
        body.append("return PullOff(radius, force, depth)")
        doc, control = self.document(), 'control: str = "force"'
        writer.public.append(Function("pull_off", [], self.keywords, body, doc, "PullOff", control))

    def document(self) -> str:
        """The docstring of `pull_off`, with the equation of its radius."""
        lines = ["At pull-off the retraction is 2 a g'(a)/xi, with the depth g(a) without adhesion, and", ""]
        lines += ["    a**((1 + k)/2)*g'(a) = xi*sqrt(pi*dgamma/(2*H))", ""]
        lines += docstring.wrapped("where xi = 3 + k under control of the force and 1 - k under control of the depth.")
        several = "" if self.power is not None else docstring.SEVERAL
        return docstring.pull_off(lines, self.symbols, self.entries, several, self.writer.example.state())
