"""Front and back of the book as plain data: table of all profiles, notation, definitions, special functions, keys."""

from __future__ import annotations

import re
from collections.abc import Mapping

from .. import notation as nt
from ..abel import masters
from ..contact import complete, normal
from ..contact.medium import HOMOGENEOUS
from ..entry import COMPACT, COMPLETE, Entry
from .printer import MASTER_NAMES, Printer
from .prose import prose
from .rows import LEFT
from .shorthand import with_kappa
from .width import width


def master_row(entries: Mapping[str, Entry]) -> dict[str, str]:
    """Depth and force for the table of all profiles; what is too wide for it is referred to."""
    return {
        suffix: _cell(entries[suffix], room) if suffix in entries else ""
        for suffix, room in (("d", 158.0), ("F", 200.0))
    }


def _cell(entry: Entry, room: float) -> str:
    case = entry.cases[-1]
    short = with_kappa(case.expr)
    text = Printer(case.chain, short.names)(short.expr)
    return rf"$\displaystyle {text}$" if width(text) <= room else rf"\eqr{{{entry.key}}}"


def notation_rows(used: set[str]) -> list[dict[str, str]]:
    """The symbols that are used, in order of the notation."""
    skip = {"j", "N", "stiffness"}
    return [
        {"latex": n.latex, "unit": _unit(n.unit), "meaning": prose(n.meaning), "domain": _domain(n)}
        for n in nt.all_notation()
        if n.name in used - skip
    ]


def _domain(n: nt.Notation) -> str:
    text = re.sub(rf"(?<!\w){re.escape(n.name)}(?!\w)", lambda m: n.latex, n.domain)
    return text.replace("pi/2", r"\pi/2").replace(">=", r"\ge ")


def _unit(unit: str) -> str:
    text = re.sub(r"\^\(([^()]*)\)", lambda m: f"$^{{{m[1]}}}$", unit)
    return re.sub(r"\^(\d+)", lambda m: f"$^{{{m[1]}}}$", text)


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
        (r"\mathbf{H}_{\nu}(z)", struve, "Struve functions (11.97)"),
        (_name(masters.Dawson), r"\mathrm e^{-x^2}\int_0^{x}\mathrm e^{u^2}\,\mathrm du", "Dawson's function"),
    )
    return [{"name": name, "definition": definition, "remark": remark} for name, definition, remark in rows]


MODULUS = "elliptic integral with modulus $k$; SciPy and mpmath take $m=k^2$"


def _name(master: type[masters.Master]) -> str:
    return MASTER_NAMES[master] + "(x)"


def suffixes() -> list[tuple[str, str]]:
    """What the end of a key means."""
    found = {q.suffix: q.label for q in (*COMPACT.values(), *COMPLETE.values())}
    return list(found.items())


def definition_rows() -> list[tuple[str, str, str]]:
    """Label, general formula and equation numbers of every quantity, compact contact first."""
    printer = Printer()
    rows = []
    for title, quantities, formulas, equations in (
        ("", COMPACT, normal.definitions(), normal.REFERENCES),
        ("complete contact: ", COMPLETE, complete.definitions(HOMOGENEOUS), complete.REFERENCES),
    ):
        for suffix in ("d", "F", "p", "w", "k"):
            if suffix in formulas:
                left = LEFT[suffix]
                right = "=" + printer(HOMOGENEOUS.stiffness() if suffix == "k" else formulas[suffix])
                rows.append(
                    (
                        title + quantities[suffix].label.lower().replace(" outside", ""),
                        left + right,
                        ", ".join(equations[suffix][0]),
                    )
                )
    return [(label[0].upper() + label[1:], text, numbers) for label, text, numbers in rows]


def columns(items: list[str], count: int) -> list[list[str]]:
    """Items in columns read downwards, as rows for a table; the last ones are padded with empty text."""
    height = -(-len(items) // count)
    padded = items + [""] * (height * count - len(items))
    return [[padded[row + column * height] for column in range(count)] for row in range(height)]
