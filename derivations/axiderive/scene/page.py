"""The page of a scene: preamble and the page of its profile under one title, typeset while the rest is written."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Future
from pathlib import Path
from typing import Any

from .. import __version__
from .. import notation as nt
from ..book import notation_table
from ..book.page import PANEL, shape_tex, symbols
from ..build import pdf
from ..build.work import read_entries
from ..code import plane as strips
from ..entry import Entry
from ..exits import CommandError
from ..physics import general
from ..physics.layer import PHYSICS as LAYER
from ..physics.systems import Problem
from ..print.formula import Printer
from ..print.words import prose
from ..profiles.pools import ROUND
from ..profiles.profile import Profile
from ..rows import layer as layer_rows
from ..rows.laws import laws
from ..rows.laws import rows as law_rows
from ..rows.ranges import chain_of, condition, regions
from ..rows.row import Row, ordered
from . import interface
from .linker import library
from .reading import Scene

CLAIMS = {
    "closed": "every formula is derived and compared with its definition, the certified ones are proved",
    "integral": "the definitions as regular integrals; the rules that evaluate them are measured in evidence.json",
}
"""What holds for the formulas of a profile of one's own."""
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
    request: Scene, profile: Profile, entries: Mapping[str, Entry], evidence: Mapping[str, Any]
) -> dict[str, bytes]:
    """LaTeX by path: a main file, the preamble and the page, which the catalogue has already for its own profiles."""
    name = request.kind.system.pool.id(profile.name)
    path = f"profiles/{name}.tex"
    preamble = None if request.own else library.catalogue_text("../handbook/preamble.tex")
    if preamble is None:
        closed = "d" not in entries or entries["d"].status == "closed"
        claim = CLAIMS["closed" if closed else "integral"]
        # that of the catalogue is stored
        from ..book.handbook import templates

        preamble = templates().get_template("preamble.tex.j2").render(version=__version__, claim=claim)
        body = _formulas(profile, entries, evidence) if closed else integrals(profile, entries)
    else:
        body = _sections(profile, request.kind)
    texts = {path: body, "preamble.tex": preamble}
    material = (interface.record(name).name for name in request.kind.material)
    names = {*(p.name for p in profile.parameters if nt.known(p.name)), *material}
    names |= layer_rows.LETTERS if request.kind.physics is LAYER else set()
    here = {interface.record(name, profile).latex: f"; here {_number(v)}" for name, v in request.values.items()}
    panel = PANEL if request.kind.system.pool is ROUND else ()
    meant, used = _meant(request, profile), names | symbols(entries, panel)
    rows = [
        f"${n['latex']}$ & {n['unit']} & {_math(n['domain'])} & "
        f"{meant.get(n['latex'], n['meaning'])}{here.get(n['latex'], '')}\\\\"
        for n in notation_table.recorded(used)
    ]
    main = Path(__file__).with_name("page.tex").read_text(encoding="utf-8") % {
        "title": escaped(request.title.strip() or "Scene"),
        "version": __version__,
        "rows": "\n".join(rows),
        "name": name,
        "laws": _law(request),
    }
    return {name: text.encode() for name, text in sorted({**texts, "page.tex": main}.items())}


def _meant(request: Scene, profile: Profile) -> dict[str, str]:
    """What the letters mean under a strip, where they mean something else."""
    if not request.kind.system.pool.strip:
        return {}
    own = {*strips.MEANING, *strips.OF_PUNCH}
    return {nt.describe(s).latex: prose(strips.meaning(profile, s)) for s in own}


def _law(request: Scene) -> str:
    """What the page of the profile names only: the material law of a viscoelastic contact, the equation of a layer."""
    law = request.kind.law
    if law:
        own = next(row for row in laws() if row.suffix == law.suffix)
        title, lines = own.name, [rf"\par\vspace{{2mm}}\(\displaystyle {line}\)" for line in own.functions().values()]
    elif request.kind.physics is LAYER:
        title, _, rows = layer_rows.sections()[0]
        lines = [rf"\par\vspace{{2mm}}{label} {small}{FITTED % tex}" for row in rows for label, small, tex in row]
    else:
        return ""
    return "\n".join([rf"\par\vspace{{3mm}}\textbf{{{title}}}", *lines, r"\vspace{4mm}", ""])


PRESSURE = r"p(r)=\frac{E^{*}}{\pi}\int_{0}^{\sqrt{a^{2}-r^{2}}}\frac{g'(t)}{t}\,\mathrm{d}u,\quad t=\sqrt{r^{2}+u^{2}}"
FITTED = r"\par\vspace{2mm}\resizebox{\ifdim\width>\linewidth\linewidth\else\width\fi}{!}{$\displaystyle %s$}"


def integrals(profile: Profile, entries: Mapping[str, Entry]) -> str:
    """What is outside the normal form: integrals over the profile, and the pressure as one over g'(t), itself one."""
    lines = [rf"\par {shape_tex(profile)}\par\vspace{{3mm}}"]
    for suffix in ("d", "F", "w"):
        left = entries[suffix].quantity.left
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
    return "\n".join([rf"\par {shape_tex(profile)}\par\vspace{{3mm}}", *_rows(ordered(entries), evidence), ""])


def _sections(profile: Profile, kind: interface.Kind) -> str:
    """Shape and formulas of a profile as they are stored, for a kind of contact and what it superposes."""
    lines = [rf"\par {shape_tex(profile)}\par\vspace{{3mm}}"]
    below: dict[str, Entry] = {}
    for system in dict.fromkeys((kind.system.base or kind.plain, kind.system)):
        own = Problem(system, profile.name)
        record = library.evidence(own.key) or {}
        entries = read_entries(own, record.get("entries", {}))
        rows = law_rows(entries, below) if system.physics.laws else ordered(entries)
        lines += [rf"\sect{{{system.heading}}}", *_rows(rows, record.get("evidence", {}))]
        below = entries
    return "\n".join([*lines, ""])


def _rows(rows: Sequence[Row], evidence: Mapping[str, Any]) -> Iterator[str]:
    for row in rows:
        certified = evidence.get("entries", {}).get(row.suffix, {}).get("certified")
        label, small = row.label
        yield (
            rf"\par\vspace{{2mm}}\textbf{{{label}}} {small} {'(certified)' if certified else ''} \key{{{row.ends}}}\par"
        )
        words = rf"\remark{{{row.remark} {row.uses}}}" if row.remark else ""
        yield from (
            rf"$\displaystyle {region.tex}{words}$ \quad {_math(region.condition)}\par" for region in row.regions
        )


def _number(value: float) -> str:
    digits, _, power = f"{value:.7g}".partition("e")
    return f"${digits}" + (rf"\cdot 10^{{{int(power)}}}$" if power else "$")


def _math(text: str) -> str:
    return f"${text}$" if text else ""


def typeset(made: Future[bytes]) -> bytes:
    """The PDF of a page that is typeset in the background; empty where LaTeX is missing, which is said.

    Raises
    ------
    CommandError
        If the page does not compile.
    """
    try:
        return made.result()
    except (pdf.LatexError, OSError) as error:
        try:  # asked only now: where all is there it would cost a tenth of the pass
            pdf.ensure_latex(install=False, say=print)
        except pdf.NoLatexError as missing:
            print(missing)
            return b""
        if isinstance(error, OSError):
            raise
        message = f"the page does not compile, nothing was written\n{error}"
        raise CommandError(message) from error
