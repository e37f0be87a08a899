"""Front and back of the book as plain data: table of all profiles, definitions, special functions, ends of the keys."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ..abel import masters
from ..entry import COMPACT, COMPLETE, FOUR, Entry
from ..physics import complete, normal, subsurface
from ..physics.medium import GRADED, HOMOGENEOUS
from ..physics.systems import SYSTEMS
from ..print.box import width
from ..print.formula import MASTER_NAMES, Printer
from ..print.shorthand import with_kappa
from ..profiles.pools import ROUND, STRIPS
from ..rows import fields


def master_row(entries: Mapping[str, Entry]) -> dict[str, str]:
    """Depth and force for the table of all profiles; what is too wide for it is referred to."""
    found = {}
    for name, suffixes, room in (("d", ("d",), 158.0), ("F", ("F", "P"), 200.0)):
        own = next((suffix for suffix in suffixes if suffix in entries), None)
        found[name] = _cell(entries[own], room) if own else ""
    return found


def _cell(entry: Entry, room: float) -> str:
    case = entry.cases[-1]
    short = with_kappa(case.expr)
    text = Printer(case.chain, short.names)(short.expr)
    return rf"$\displaystyle {text}$" if width(text) <= room else rf"\eqr{{{entry.key}}}"


def master_rows() -> list[dict[str, str]]:
    """The special functions of the catalogue with their definitions."""
    amplitude = r"\sqrt{1-k^2\sin^2\alpha}"
    struve = r"\frac{2(z/2)^\nu}{\sqrt\pi\,\Gamma(\nu+\frac12)}\int_0^{1}(1-u^2)^{\nu-1/2}\sin(zu)\,\mathrm du"
    rows = (
        (r"\mathrm{F}(\varphi,k)", rf"\int_0^{{\varphi}}\frac{{\mathrm d\alpha}}{{{amplitude}}}", MODULUS),
        (r"\mathrm{E}(\varphi,k)", rf"\int_0^{{\varphi}}{amplitude}\,\mathrm d\alpha", MODULUS),
        (
            r"\mathrm{C}_0(b,r,a)",
            r"\int_{\max(b,r)}^{a}\arccos\frac bt\,\frac{\mathrm dt}{\sqrt{t^2-r^2}}",
            "one for every break; no closed form was found",
        ),
        (
            _name(masters.LegendreChi2),
            r"\int_0^{x}\frac{\operatorname{artanh}t}{t}\,\mathrm dt",
            "Legendre's chi function",
        ),
        (_name(masters.ArctanIntegral), r"\int_0^{x}\frac{\arctan t}{t}\,\mathrm dt", "inverse tangent integral"),
        (
            r"\mathrm{B}(z;p,q)",
            r"\int_0^{z}u^{p-1}(1-u)^{q-1}\,\mathrm du",
            "incomplete Beta function, $p>0$, $0\\le z<1$",
        ),
        (
            r"{}_{2}\mathrm{F}_{1}(p,q;c;z)",
            r"\frac{\Gamma(c)}{\Gamma(q)\,\Gamma(c-q)}\int_0^{1}u^{q-1}(1-u)^{c-q-1}(1-zu)^{-p}\,\mathrm du",
            "Gauss, $c>q>0$, $z<1$ (11.93)",
        ),
        (
            r"{}_{1}\mathrm{F}_{1}(p;c;z)",
            r"\frac{\Gamma(c)}{\Gamma(p)\,\Gamma(c-p)}\int_0^{1}u^{p-1}(1-u)^{c-p-1}\,\mathrm e^{zu}\,\mathrm du",
            "Kummer, $c>p>0$",
        ),
        (
            r"\mathrm{J}(k;b,R,a)",
            r"\int_0^{b}\frac{u\,(a^2-u^2)^{(k-1)/2}}{\sqrt{R^2-u^2}}\,\mathrm du",
            "spherical cap on the graded half-space, $b<a$, $b<R$",
        ),
        (r"\mathbf{H}_{\nu}(z)", struve, "Struve functions (11.97)"),
        (_name(masters.Dawson), r"\mathrm e^{-x^2}\int_0^{x}\mathrm e^{u^2}\,\mathrm du", "Dawson's function"),
    )
    return [{"name": name, "definition": definition, "remark": remark} for name, definition, remark in rows]


MODULUS = "elliptic integral with modulus $k$; SciPy and mpmath take $m=k^2$"


def _name(master: type[masters.Master]) -> str:
    return MASTER_NAMES[master] + "(x)"


def suffixes() -> list[tuple[str, list[tuple[str, str]]]]:
    """What the end of a key means, by kind of contact, in the words of the rows; without the four laws spelled out."""
    found = []
    for own in SYSTEMS:
        physics, ends = own.physics, dict[str, str]()
        if own.medium.graded or own.pool not in (ROUND, STRIPS):
            continue
        group = f"{own.group}." if own.group else ""
        title = own.heading + (f"; graded: .{GRADED.group}.{own.group}" if group and GRADED in physics.wording else "")
        for q in (q for table in physics.quantities.values() for q in table.values()):
            suffix = q.suffix.partition("_")[0] + "_..." if "_" in q.suffix else q.suffix
            words, small = q.heading
            ends.setdefault(f"{group}{suffix}", f"{words}, {small}" if small else words)
        found.append((title, list(ends.items())))
    return found


DEFINED = (*FOUR, "k")
"""Quantities whose definitions stand in front of the book; the depth of a complete contact is free."""


def definition_rows() -> list[tuple[str, str, str]]:
    """Label, general formula and equation numbers of every quantity, compact contact first."""
    printer = Printer()
    rows = []
    for title, quantities, formulas, equations in (
        ("", COMPACT, normal.definitions(), normal.REFERENCES),
        ("complete contact: ", COMPLETE, complete.definitions(HOMOGENEOUS), complete.REFERENCES),
    ):
        for suffix in DEFINED:
            if suffix in formulas:
                left = quantities[suffix].left
                right = "=" + printer(HOMOGENEOUS.stiffness() if suffix == "k" else formulas[suffix])
                rows.append(
                    (
                        title + quantities[suffix].label.lower().replace(" outside", ""),
                        left + right,
                        ", ".join(equations[suffix][0]),
                    )
                )
    return [(label[0].upper() + label[1:], text, numbers) for label, text, numbers in rows]


Section = tuple[str, str, Sequence[Sequence[tuple[str, str, str]]]]
"""Title, note and lines of one row or two, each with label, small words and formula."""


def stress_rows() -> list[Section]:
    """What the numbers below the surface say, each row with the component that it gives."""
    printer = Printer(names={subsurface.ANGLE: r"\varphi"})
    tables = (
        ("Normal load", "tension positive", _component, subsurface.STRESS),
        ("Displacement under the normal load", "", lambda axis: f"u_{{{axis}}}", subsurface.DISPLACEMENT),
        ("What friction adds", r"traction $\mu p$, $\varphi$ from its direction", _component, subsurface.FRICTION),
    )
    return [
        (title, note, [((left, "", f"{_left(left, named)}={printer(right)}"),) for left, right in table.items()])
        for title, note, named, table in tables
    ]


def number_rows() -> tuple[Section, list[Section]]:
    """What profiles are made of; the letters and the numbers of flat punch and slopes."""
    sums = [
        (profile.title, "edge in contact" if fields.touches_later(profile) else "", fields.total(own))
        for profile in map(ROUND.load, ROUND.names)
        if (own := fields.parts(profile)) and set(own) <= set(fields.PRINTED)
    ]
    slopes = [
        ((r"\mbox{}" if i else f"$n={n}$", "" if i else fields.SLOPES[n], fields.beside(line)),)
        for n in fields.PRINTED
        for i, line in enumerate(fields.lines(n))
    ]
    letters = [((title, "", tex),) for title, tex in fields.shorthands()]
    return (
        ("Numbers of a profile", fields.MADE_OF, [*_beside(sums), (("Any profile", "", fields.EVERY),)]),
        [
            ("Letters", "", letters),
            ("Numbers", "a formula with $m$ is for the orders without one of their own", slopes),
        ],
    )


def _beside(rows: list[tuple[str, str, str]]) -> list[Sequence[tuple[str, str, str]]]:
    """Those of one part two on a line, the others by themselves."""
    narrow = [one for one in rows if one[2].count("N_") == 1]
    return [*zip(narrow[::2], narrow[1::2], strict=True), *((one,) for one in rows if one not in narrow)]


def _left(components: str, named: Callable[[str], str]) -> str:
    """rr + tt as a sum of stresses."""
    return "".join(named(part) if part.isalpha() else part for part in components.split())


def _component(axes: str) -> str:
    letter = r"\sigma" if axes[0] == axes[1] else r"\tau"
    return f"{letter}_{{{axes}}}"
