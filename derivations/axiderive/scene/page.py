"""The page of a scene: preamble and the page of its profile under one title, ready for LaTeX."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from .. import __version__
from .. import notation as nt
from ..contact import general
from ..emit import front
from ..emit.arrangement import ordered
from ..emit.handbook import templates
from ..emit.page import symbols
from ..emit.panel import shape_tex
from ..emit.printer import Printer
from ..emit.ranges import chain_of, condition, regions
from ..entry import Entry
from ..index import NoCatalogueError, load
from ..profiles.profile import Profile
from . import interface
from .request import Request
from .sections import sections_for

MAIN = r"""\pdfinfoomitdate=1 \pdfsuppressptexinfo=-1 \pdftrailerid{}
\documentclass[10pt,a4paper,twoside]{article}
\input{preamble}
\begin{document}
{\fontsize{17}{22}\selectfont\textcolor{ink}{%(title)s}\par}\vspace{2mm}
{\fontsize{9}{12}\selectfont\sffamily\textcolor{note}{axicontact %(version)s}\par}\vspace{4mm}
{\fontsize{9.4}{12.4}\selectfont
\begin{longtable}{@{}l@{\hspace{6mm}}l@{\hspace{6mm}}l@{\hspace{6mm}}p{92mm}@{}}
\toprule symbol & unit & domain & meaning\\\midrule\endhead
%(rows)s
\bottomrule
\end{longtable}}
\input{profiles/%(name)s}
\end{document}
"""
CLAIMS = {
    "closed": "every formula is derived and compared with its definition, the certified ones are proved",
    "integral": "the definitions as regular integrals; the rules that evaluate them are measured in evidence.json",
}
"""What holds for the formulas of a profile of one's own."""
ELSEWHERE = re.compile(r"\b(?:of|on) page \\pageref\{part:\w+\}")
"""Another part of the handbook: a page of a scene stands alone."""
SPECIAL = {
    "\\": r"\textbackslash{}", "{": r"\{", "}": r"\}", "&": r"\&", "%": r"\%", "#": r"\#", "_": r"\_", "$": r"\$",
    "~": r"\textasciitilde{}", "^": r"\textasciicircum{}", "<": r"\textless{}", ">": r"\textgreater{}",
    "|": r"\textbar{}", '"': "''", "`": "'",
}  # fmt: skip


def escaped(text: str) -> str:
    """Any text as plain words of LaTeX: nothing in it is a command; what the fonts lack is a question mark."""
    latin = (c if c.isprintable() and ord(c) < 0x250 else "?" for c in text)
    return "".join(SPECIAL.get(c, c) for c in latin)


def page_sources(
    request: Request, profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]
) -> dict[str, bytes]:
    """LaTeX by path: a main file, the preamble and the page, which the catalogue has already for its own profiles."""
    name = interface.id_of(request.physics, profile.name)
    path = f"profiles/{name}.tex"
    texts = None if request.own else _stored(path, request.physics)
    if texts is None:
        closed = entries["d"].status == "closed"
        claim = CLAIMS["closed" if closed else "integral"]
        preamble = templates().get_template("preamble.tex.j2").render(version=__version__, claim=claim)
        body = _formulas(profile, entries, evidence) if closed else integrals(profile, entries)
        texts = {path: body, "preamble.tex": preamble}
    material = (interface.record(name).name for name in interface.MATERIAL[request.physics])
    names = {*(p.name for p in profile.parameters if nt.known(p.name)), *material}
    here = {interface.record(name, profile).latex: f"; here {_number(v)}" for name, v in request.values.items()}
    rows = [
        f"${n['latex']}$ & {n['unit']} & {_math(n['domain'])} & {n['meaning']}{here.get(n['latex'], '')}\\\\"
        for n in front.notation_rows(symbols(entries) | names)
    ]
    main = MAIN % {
        "title": escaped(request.title.strip() or "Scene"),
        "version": __version__,
        "rows": "\n".join(rows),
        "name": name,
    }
    return {name: text.encode() for name, text in sorted({**texts, "page.tex": main}.items())}


INTEGRALS = {"d": "d=g(a)", "F": r"F_{\mathrm N}", "w": "w(r)"}
PRESSURE = r"p(r)=\frac{E^{*}}{\pi}\int_{0}^{\sqrt{a^{2}-r^{2}}}\frac{g'(t)}{t}\,\mathrm{d}u,\quad t=\sqrt{r^{2}+u^{2}}"
FITTED = r"\par\vspace{2mm}\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{$\displaystyle %s$}"


def integrals(profile: Profile, entries: Mapping[str, Entry]) -> str:
    """What is outside the normal form: integrals over the profile, and the pressure as one over g'(t), itself one."""
    lines = [rf"\par {shape_tex(profile)}\par\vspace{{3mm}}"]
    for suffix, left in INTEGRALS.items():
        for pairs, expr in regions(entries[suffix]):
            chain = chain_of(entries[suffix], expr)
            printer = Printer(chain, {})
            where = condition(entries[suffix], pairs, chain, printer)
            lines.append(FITTED % (f"{left}={printer(expr)}" + (rf",\quad {where}" if where else "")))
    lines.append(FITTED % PRESSURE)
    for layer in general.layers(profile):
        own = Printer((), {})
        where = rf"\quad\text{{added where }} t>{own(layer.start)}" if layer.start != 0 else ""
        lines.append(FITTED % f"g'(t)={'...+' if where else ''}{own(general.rate(layer))}{where}")
    lines.append(
        r"\par\vspace{3mm}Regular integrals, evaluated by the rules of the module; \(g'\) is itself an integral."
    )
    return "\n".join([*lines, ""])


def _formulas(profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]) -> str:
    """Shape, formulas by range, and whether each is certified."""
    lines = [rf"\par {shape_tex(profile)}\par\vspace{{3mm}}"]
    for row in ordered(entries):
        certified = evidence.get("entries", {}).get(row.suffix, {}).get("certified")
        label, small = row.label
        lines.append(rf"\par\vspace{{2mm}}\textbf{{{label}}} {small} {'(certified)' if certified else ''}\par")
        lines += [rf"$\displaystyle {region.tex}$ \quad {_math(region.condition)}\par" for region in row.regions]
    return "\n".join([*lines, ""])


def _stored(path: str, physics: str) -> dict[str, str] | None:
    try:
        folder = load().folder.parent / "handbook"
        page, preamble = ((folder / name).read_text() for name in (path, "preamble.tex"))
        own = {path: sections_for(page, physics), "preamble.tex": preamble}
        return {name: ELSEWHERE.sub("in the handbook", text) for name, text in own.items()}
    except (NoCatalogueError, OSError):
        return None


def _number(value: float) -> str:
    digits, _, power = f"{value:.7g}".partition("e")
    return f"${digits}" + (rf"\cdot 10^{{{int(power)}}}$" if power else "$")


def _math(text: str) -> str:
    return f"${text}$" if text else ""
