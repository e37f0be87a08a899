"""Modules `axicontact.graded.normal.<profile>` of complete contacts, whose edge is fixed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from ...entry import COMPLETE, Entry
from ...letters import name_of
from ...notation import a, d, n, r
from ...physics.medium import GRADED
from ...physics.systems import System
from ...profiles.profile import Profile
from ..module import Module
from ..text import python
from ..writer import Writer, ordered, required
from .compact import add_shape

ORDER = ordered(
    "np.asarray(n) > 1.0 - np.asarray(k)",
    "n > 1 - k",
    "a sharper dimple never reaches complete contact at a finite load; use n > 1 - k",
    ("n", "k"),
)
"""The rule between the exponents of a concave face, which is n > 1 without grading."""


def module(system: System, entries: Mapping[str, Entry]) -> Module:
    """The module of one profile."""
    return _Complete(Writer(system, entries, entries)).module()


def required_face(symbols: Sequence[sp.Symbol]) -> list[str]:
    """The check of these parameters, and that between the exponent of a concave face and that of the grading."""
    return [required(symbols), *(ORDER if n in symbols else [])]


class _Complete:
    def __init__(self, writer: Writer) -> None:
        self.writer, self.entries, self.profile = writer, writer.entries, writer.profile
        self.geometry = [*self.writer.geometry, "k"]
        self.material = [*self.writer.geometry, "H", "k"]
        piece = self.profile.pieces[0].expr
        self.concave = piece.has(a)
        self.order = order_of(self.profile)

    def module(self) -> Module:
        """The whole module."""
        if self.concave:
            self.concave_rules()
        elif self.profile.pieces[0].expr == 0:
            self.flat_rules()
        else:
            self.capped_rules()
        add_shape(self.writer)
        for suffix in COMPLETE:
            if suffix in self.entries:
                self.public(self.entries[suffix])
        return self.writer.module()

    def public(self, entry: Entry) -> None:
        """Adds the public function of one quantity to the module."""
        notes = f"Valid for {self.profile.validity}."
        if entry.arguments:
            notes += " Negative or NaN field values give NaN"
            notes += ", and so do loads below those of complete contact." if self.concave else "."
        self.writer.add(entry, notes, required_face(entry.parameters))

    def rule(self, name: str, fields: list[str], needs: list[str], *lines: str) -> None:
        """Adds a private function of these lines; `needs` are the parameters it takes behind its fields."""
        self.writer.rule(name, fields, needs, lines)

    def flat_rules(self) -> None:
        """Adds the private functions of the flat punch, all in closed form."""
        self.rule("_force", ["d"], ["a", "H", "k"], "return punch_stiffness(a, H, k) * d")
        pressure = "return np.where(d > 0.0, d * punch_pressure(r, a, H, k), 0.0)"
        self.rule("_pressure", ["r", "d"], ["a", "H", "k"], pressure)
        self.rule("_displacement", ["r", "d"], ["a", "k"], "return d * punch_displacement(r, a, k)")
        self.rule("_stiffness", [], ["a", "H", "k"], "return punch_stiffness(a, H, k)")
        self.rule("_depth_from_force", ["F"], ["a", "H", "k"], "return F / punch_stiffness(a, H, k)")

    def capped_rules(self) -> None:
        """The cap alone up to the depth that brings the edge into contact, then the cap and a punch."""
        order = self.order
        shape = f"/ ({python(1 / self.profile.pieces[0].expr.coeff(r, int(float(order))))})"
        state = f"rho, rest = _contact({', '.join(['d', *self.geometry])})"
        self.writer.rule(
            "_contact", ["d"], self.geometry,
            [
                f"free = power_depth(a, {order}, k) {shape}",
                f"rho = a * np.minimum(d / free, 1.0) ** (1.0 / {order})",
                "return rho, np.maximum(d - free, 0.0)",
            ],
            "Contact radius, and the depth that the edge adds.", "tuple[Array, Array]",
        )  # fmt: skip
        self.rule(
            "_force", ["d"], self.material, state,
            f"cap = 2.0 * H / (1.0 + k) * power_force(rho, {order}, k) {shape}",
            "return cap + rest * punch_stiffness(rho, H, k)",
        )  # fmt: skip
        self.rule(
            "_pressure", ["r", "d"], self.material, state,
            "edge = np.where(rest > 0.0, rest * punch_pressure(r, rho, H, k), 0.0)",
            f"cap = H / np.pi * power_pressure(np.minimum(r, rho), rho, {order}, k) {shape}",
            "return np.where(r <= rho, edge + np.where(r < rho, cap, 0.0), 0.0)",
        )  # fmt: skip
        self.rule(
            "_displacement", ["r", "d"], self.geometry, state,
            f"cap = power_displacement(r, rho, {order}, k) {shape}",
            "return cap + rest * punch_displacement(r, rho, k)",
        )  # fmt: skip
        self.rule("_stiffness", ["d"], self.material, state, "return punch_stiffness(rho, H, k)")
        self.rule(
            "_depth_from_force", ["F"], self.material,
            f"full = 2.0 * H / (1.0 + k) * power_force(a, {order}, k) {shape}",
            f"free = power_depth(a, {order}, k) {shape}",
            f"before = free * (F / full) ** ({order} / ({order} + 1.0 + k))",
            "return np.where(full > F, before, free + (F - full) / punch_stiffness(a, H, k))",
        )  # fmt: skip

    def concave_rules(self) -> None:
        """Everything as the punch and the hollow h (r/a)**n, whose depth at the edge is h power_factor(n, k)."""
        order = self.order
        offset = f"h * power_factor({order}, k) * (1.0 + k) / ({order} + 1.0 + k)"
        complete = f"complete = _minimum_depth({', '.join(self.geometry)}) * (1.0 - 1e-15) <= d"
        self.rule(
            "_force", ["d"], self.material, complete,
            f"return np.where(complete, punch_stiffness(a, H, k) * (d + {offset}), np.nan)",
        )  # fmt: skip
        self.concave_pressure(order, complete)
        self.rule(
            "_displacement", ["r", "d"], self.geometry, complete,
            "",
            "def outside() -> Array:",
            f"    return d * punch_share(r, a, k) + h * power_sag(r, a, {order}, k) / a**{order}",
            "",
            f"value = either(r > a, outside, lambda: d - {self.shape()})",
            "return np.where(complete, value, np.nan)",
        )  # fmt: skip
        self.rule("_stiffness", [], ["a", "H", "k"], "return punch_stiffness(a, H, k)")
        self.rule(
            "_depth_from_force", ["F"], self.material,
            f"complete = _minimum_force({', '.join(self.material)}) * (1.0 - 1e-15) <= F",
            f"return np.where(complete, F / punch_stiffness(a, H, k) - {offset}, np.nan)",
        )  # fmt: skip
        self.thresholds(order)
        least = f"_minimum_depth({', '.join(self.geometry)})"
        self.rule("_minimum_force", [], self.material, f"return punch_stiffness(a, H, k) * ({least} + {offset})")

    def shape(self) -> str:
        """The call of f(r) in the module of the homogeneous half-space."""
        used = {name_of(symbol) for symbol in self.profile.pieces[0].expr.free_symbols} | {"a"}
        return (
            f"normal._profile({', '.join(['r', *(f'{name}={name}' for name in self.writer.geometry if name in used)])})"
        )

    def concave_pressure(self, order: str, complete: str) -> None:
        """From the least depth on where the face is algebraic: there nothing cancels."""
        excess = excess_over_threshold(self.entries)
        if excess is not None:
            least = f"least = _minimum_depth({', '.join(self.geometry)})"
            self.rule(
                "_pressure", ["r", "d"], self.material, least,
                f"face = {python(excess)}",
                "pressure = (d - least + face) * punch_pressure(r, a, H, k)",
                "return np.where(least * (1.0 - 1e-15) <= d, pressure, np.nan)",
            )  # fmt: skip
            return
        self.rule(
            "_pressure", ["r", "d"], self.material, complete,
            f"edge = (d + h * power_factor({order}, k)) * punch_pressure(r, a, H, k)",
            f"hollow = H / np.pi * h * power_pressure(np.minimum(r, a), a, {order}, k) / a**{order}",
            "return np.where(complete, np.where(r < a, edge - hollow, edge), np.nan)",
        )  # fmt: skip

    def thresholds(self, order: str) -> None:
        """The ring of zero pressure and the least depth: by their formulas where these are closed."""
        ring, least = (self.entries[suffix] for suffix in ("rz", "dmin"))
        if ring.status == "root":
            place = f"a * ring_of_zero_pressure({order}, k)"
            depth = f"h * power_factor({order}, k) * (1.0 - k) / lifted_at_zero_pressure({order}, k)"
        else:
            place, depth = (python(sp.factor(entry.cases[0].expr)) for entry in (ring, least))
            place = "0.0 * a" if place == "0" else place
        # the parameters that do not count as well
        self.rule("_zero_radius", [], self.geometry, f"return {place} + 0.0 * h")
        self.rule("_minimum_depth", [], self.geometry, f"return {depth} + 0.0 * a")


def excess_over_threshold(entries: Mapping[str, Entry]) -> sp.Expr | None:
    """M(r) >= 0 in p = (d - d_min + M) times the pressure of a punch per depth, where the face is algebraic."""
    depth = sp.powsimp(sp.expand(entries["p"].cases[0].expr / GRADED.punch_pressure()))
    face = sp.factor(sp.expand(depth - d + entries["dmin"].cases[0].expr))
    return face if face.is_polynomial(r) else None


def order_of(profile: Profile) -> str:
    """The exponent of a face of one power of r, as it stands in the code: 2.0, n."""
    piece = sp.expand_power_base(profile.pieces[0].expr)
    exponent = sp.expand_power_base(piece.as_independent(r, as_Add=False)[1]).as_base_exp()[1]
    return repr(float(exponent)) if exponent.is_Integer else python(exponent)
