"""The page of a scene: preamble and the page of its profile under one title, ready for LaTeX."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from .. import __version__
from .. import notation as nt
from ..contact import general
from ..emit import front
from ..emit.handbook import templates
from ..emit.page import symbols
from ..emit.panel import shape_tex
from ..emit.printer import Printer
from ..emit.ranges import chain_of, condition, regions
from ..emit.rows import ordered
from ..entry import Entry
from ..index import NoCatalogueError, load
from ..profiles.profile import Profile

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
    title: str, profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any], *, own: bool
) -> dict[str, bytes]:
    """LaTeX by path: a main file, the preamble and the page, which the catalogue has already for its own profiles."""
    path = f"profiles/{profile.name}.tex"
    texts = None if own else _stored(path)
    if texts is None:
        preamble = templates().get_template("preamble.tex.j2").render(version=__version__)
        closed = entries["d"].status == "closed"
        body = _formulas(profile, entries, evidence) if closed else integrals(profile, entries)
        texts = {path: body, "preamble.tex": preamble}
    rows = [
        f"${n['latex']}$ & {n['unit']} & {_math(n['domain'])} & {n['meaning']}\\\\"
        for n in front.notation_rows(symbols(entries) | {p.name for p in profile.parameters if nt.known(p.name)})
    ]
    main = MAIN % {"title": escaped(title), "version": __version__, "rows": "\n".join(rows), "name": profile.name}
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


def _stored(path: str) -> dict[str, str] | None:
    try:
        folder = load().folder.parent / "handbook"
        return {name: (folder / name).read_text() for name in (path, "preamble.tex")}
    except (NoCatalogueError, OSError):
        return None


def _math(text: str) -> str:
    return f"${text}$" if text else ""
