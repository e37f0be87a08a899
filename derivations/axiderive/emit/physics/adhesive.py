"""Modules `axicontact.adhesive.<profile>`: the normal contact less the retracted punch."""

from __future__ import annotations

import sympy as sp

from ...contact import adhesive
from ...entry import Entry
from ...notation import n
from ...profiles.profile import Profile
from ...stable.forms import evaluation_form
from ...stable.signs import facts_of
from ..code import HELPERS, python
from . import text
from .text import Function, NormalModule, evaluate, private

IMPORTS = (
    "collections.abc: Callable",
    ".._adhesion: PullOff, XI, lift, power_law_radius, pull, require_control, hess_retraction, tension",
    ".._bounds: require_physics",
    ".._branches: branches, decades, lowest, radii_around, radii_below, radii_beyond, radii_of_waves, radii_to,"
    " stable_radius, Branches",
    ".._domain: numbers, require, require_coefficients, require_order",
    ".._elementwise: Array, Result, elementwise",
    f".._functions: {', '.join(HELPERS)}",
)
SUMMARY = {
    "Dl": "Retraction of the indenter from the state without adhesion, at constant contact radius.",
    "d": "Indentation depth at contact radius a; negative where adhesion pulls the surface up.",
    "F": "Normal force at contact radius a, negative in tension.",
    "p": "Contact pressure, positive in compression, infinite tension at the edge; zero outside the contact.",
    "w": "Displacement of the surface into the half space, inside and outside the contact.",
    "ad": "Contact radius at indentation depth d, on the branch that is stable under a given depth.",
    "aF": "Contact radius under the normal force F, on the branch that is stable under a given force.",
}


def module_source(module: NormalModule) -> str:
    """The module of one profile with a compact contact."""
    entries = adhesive.derive(module.profile)
    return _Adhesive(module, entries).source()


class _Adhesive:
    def __init__(self, module: NormalModule, entries: dict[str, Entry]) -> None:
        self.module, self.entries, self.profile = module, entries, module.profile
        self.keywords = [*module.geometry, "E_star", "dgamma"]
        self.power = _exponent(self.profile)

    def source(self) -> str:
        private_functions = self.rules() + (self.power_law() if self.power is not None else self.general())
        public = [self.public(suffix) for suffix in SUMMARY] + [self.pull_off()]
        body = text.module(
            f"{self.profile.title} with adhesion", self.profile.subtitle, IMPORTS, public, private_functions
        )
        return body.replace(text.NORMAL, self.profile.name)

    # what every profile shares

    def public(self, suffix: str) -> Function:
        entry = self.entries[suffix]
        fields = [str(argument) for argument in entry.quantity.arguments]
        keywords = ["E_star", "dgamma"] if suffix == "Dl" else self.keywords
        body = self.check(keywords)
        summed = self.module.summed and suffix != "Dl"
        name = f"_{entry.quantity.function}"
        if suffix in ("ad", "aF"):
            own = fields[0]
            body += PULLS if self.power == n else []
            value = f'numbers("{own}", {own})'
            body.append(f"return {evaluate(name, [], keywords, summed, **{own: value})}")
        else:
            body.append(f"return {evaluate('hess_retraction' if suffix == 'Dl' else name, fields, keywords, summed)}")
        notes = f"Valid for {self.profile.validity}. Negative or NaN radii give NaN."
        if suffix in ("ad", "aF"):
            notes = f"Valid for {self.profile.validity}. NaN below pull-off."
            if self.power is None:
                notes += " Where several radii are stable, the largest, which is reached on unloading."
        return Function(
            entry.quantity.function,
            fields,
            keywords,
            SUMMARY[suffix],
            text.document(entry, fields, keywords, notes),
            body,
        )

    def check(self, keywords: list[str]) -> list[str]:
        return self.module.check(keywords)

    def rules(self) -> list[str]:
        module, geometry = self.module, self.module.geometry
        needs = [*geometry, "E_star", "dgamma"]
        return [
            private(
                "_depth", ["a"], needs,
                [f"return {module.call('_depth', 'a')} - hess_retraction(a, E_star, dgamma)"],
            ),
            private("_force", ["a"], needs, [f"return {module.call('_force', 'a')} - pull(a, E_star, dgamma)"]),
            private(
                "_pressure", ["r", "a"], needs,
                [f"return {module.call('_pressure', 'r', 'a')} - tension(r, a, E_star, dgamma)"],
            ),
            private(
                "_displacement", ["r", "a"], needs,
                [f"return {module.call('_displacement', 'r', 'a')} - lift(r, a, E_star, dgamma)"],
            ),
        ]  # fmt: skip

    def pull_off(self) -> Function:
        names = ", ".join(f"{name}={name}" for name in self.keywords if not (self.module.summed and name == "A"))
        tail = "partial({}, A=A)" if self.module.summed else "{}"
        body = self.check(self.keywords)
        if self.power == n:
            body += PULLS
        inner = (
            "partial(_pull_off_radius, A=A, control=require_control(control))"
            if self.module.summed
            else ("partial(_pull_off_radius, control=require_control(control))")
        )
        body += [f"radius = elementwise({inner}, {names})"]
        for name in ("force", "depth"):
            own = f"partial(_pull_off_{name}, control=control)" if self.power is not None else tail.format(f"_{name}")
            body.append(f"{name} = elementwise({own}, radius, {names})")
        body.append("return PullOff(radius, force, depth)")
        return Function(
            "pull_off", [], self.keywords, "State at which the contact breaks on unloading.",
            self.pull_off_document(), body, returns="PullOff", leading='control: str = "force"',
        )  # fmt: skip

    def pull_off_document(self) -> list[str]:
        symbols = {text.name_of(symbol): symbol for symbol in self.entries["ac"].parameters}
        lines = ["Under control of the force:", ""]
        lines += [f"    {line}" for suffix in ("ac", "Fc", "dc") for line in text.formula(self.entries[suffix])]
        lines += ["", "Under control of the depth:", ""]
        lines += [f"    {line}" for suffix in ("am", "Fm", "dm") for line in text.formula(self.entries[suffix])]
        lines += ["", "Parameters", "----------", 'control : {"force", "depth"}']
        lines += ["    What is held while the contact is unloaded."]
        lines += text.parameters(self.keywords, symbols, False)
        lines += ["", "Returns", "-------", "PullOff"]
        lines += ["    Named tuple of radius [m], force [N] and depth [m]; NaN without a stable contact."]
        lines += ["", "Raises", "------", "ValueError", "    If a parameter is outside its domain."]
        note = "The least force, or depth, of a stable contact."
        if self.power is None:
            note += " Where it has several minima, or one at a corner of the profile, the lowest."
        return [*lines, "", "Notes", "-----", *text.wrapped(f"{note} Handbook: {self.entries['ac'].key}.")]

    # power laws: one universal curve

    def power_law(self) -> list[str]:
        geometry = self.module.geometry
        needs = [*geometry, "E_star", "dgamma"]
        out = []
        for suffix, control in (("ac", "force"), ("am", "depth")):
            form = evaluation_form(self.entries[suffix].cases[0].expr, facts_of(()))
            lines = [f"{name} = {python(expr)}" for name, expr in form.steps]
            out.append(private(f"_{control}_pull_off_radius", [], needs, [*lines, f"return {python(form.value)}"]))
        passed = ", ".join(needs)
        lines = [
            f'own = _force_pull_off_radius({passed}) if control == "force" else _depth_pull_off_radius({passed})',
            "return np.where(dgamma > 0.0, own, 0.0)",
        ]
        if self.power == n:
            lines = lines[:1] + ["return np.where(n > 0.5, np.where(dgamma > 0.0, own, 0.0), np.nan)"]
        out.append(private("_pull_off_radius", [], [*needs, "control"], lines))
        exponent = sp.sstr(self.power)
        for quantity, field, p, q in (("depth", "d", exponent, "0.5"), ("force", "F", f"{exponent} + 1", "1.5")):
            plain = self.module.call(f"_radius_from_{quantity}", f"np.maximum({field}, 0.0)")
            order = p if p.isalnum() else f"({p})"
            unloaded = f"{self.module.call(f'_{quantity}', 'a')} * (1.0 - 2.0 * {order} / XI[control])"
            doc = "With the retraction 2 a g'(a)/xi of pull-off, free of cancellation."
            out.append(private(f"_pull_off_{quantity}", ["a"], [*needs, "control"], [f"return {unloaded}"], doc))
            passed_control = ", ".join(f"{name}={name}" for name in needs)
            out.append(
                private(
                    f"_radius_from_{quantity}", [field], needs,
                    [
                        f"a_c = _pull_off_radius({passed_control}, control=\"{quantity}\")",
                        f"least = _pull_off_{quantity}(a_c, {passed_control}, control=\"{quantity}\")",
                        f"plain = {plain}",
                        f"return power_law_radius({field}, a_c, least, {p}, {q}, plain)",
                    ],
                )
            )  # fmt: skip
        return out

    # other profiles: branches between refined changes of sign

    def general(self) -> list[str]:
        geometry = self.module.geometry
        needs = [*geometry, "E_star", "dgamma"]
        passed = ", ".join(f"{name}={name}" for name in needs)
        grid, high = self.radii()
        out = [
            private("_rate", ["a"], geometry, self.rate(), "Derivative g'(a) of the depth without adhesion."),
        ]
        rate = f"lambda a: _rate({', '.join(['a', *geometry])})"
        lines = [f"return branches({rate}, {grid}, {high}, control, E_star, dgamma)"]
        out.append(private("_branches", [], [*needs, "control"], lines).replace("-> Array", "-> Branches"))
        arguments = ", ".join(["a", *needs])
        lines = [
            f"found = _branches({passed}, control=control)",
            'load = _force if control == "force" else _depth',
            f"return lowest(found, lambda a: load({arguments}))",
        ]
        out.append(private("_pull_off_radius", [], [*needs, "control"], lines))
        for quantity, field in (("depth", "d"), ("force", "F")):
            lines = [
                f'found = _branches({passed}, control="{quantity}")',
                "return stable_radius(",
                f"    {field},",
                "    found,",
                f"    lambda a: _{quantity}({arguments}),",
                f"    {rate},",
                f'    XI["{quantity}"],',
                "    E_star,",
                "    dgamma,",
                ")",
            ]
            out.append(private(f"_radius_from_{quantity}", [field], needs, lines))
        return out

    def rate(self) -> list[str]:
        functions, profile = self.module.functions, self.profile
        if "_slope_at" in functions:
            return [f"return {self.module.call('_slope_at', 'a')}"]
        if "_slope_beyond" in functions:
            root = "np.sqrt(np.maximum(a - b, 0.0) * (a + b))"
            return [f"root = {root}", f"return {self.module.call('_slope_beyond', 'a', 'root')}"]
        if functions["_slope"][1:2] == ["root"]:
            end = profile.chain[-1]
            return [
                f"root = np.sqrt(np.maximum({end} - a, 0.0) * ({end} + a))",
                f"return {self.module.call('_slope', 'a', 'root')}",
            ]
        return [f"return {self.module.call('_slope', 'a')}"]

    def radii(self) -> tuple[str, str]:
        """The grid that separates the minima of the load, and the largest radius."""
        profile = self.profile
        if profile.largest is not None:
            return f"radii_to({python(profile.largest)})", f"np.atleast_1d({python(profile.largest)})"
        if profile.breaks:
            own = dict(profile.abbreviations)
            end = python(own.get(profile.breaks[0], profile.breaks[0]))
            return f"radii_{'beyond' if profile.truncated else 'around'}({end})", "np.inf"
        if profile.chain:
            end = python(profile.chain[-1])
            return f"radii_below({end})", f"np.atleast_1d({end})"
        if "wavelength" in self.module.geometry:
            reach = "(np.sqrt(4.5 * np.pi * dgamma / E_star) * 2.0 * R) ** (2.0 / 3.0)"
            return f"radii_of_waves(wavelength, {reach})", "np.inf"
        return "decades()", "np.inf"


PULLS = [
    "require_order(",
    "    np.asarray(n) > 0.5,",
    '    "n > 1/2",',
    '    "a sharper profile has no pull-off, its adhesive contact is unstable at every radius;"',
    '    " use n > 1/2, or force(a) and depth(a) for the states of equilibrium",',
    "    n=n,",
    ")",
]


def _exponent(profile: Profile) -> sp.Expr | None:
    """n of a profile that is one power of r, else None."""
    if len(profile.pieces) != 1:
        return None
    from ...notation import r

    power = profile.pieces[0].expr.as_independent(r, as_Add=False)[1] if not profile.pieces[0].expr.is_Add else None
    if power is None:
        return None
    base, exponent = power.as_base_exp()
    return exponent if base == r else None
