"""The handbook: one LaTeX file per profile and a main file, from the same entries as everything else.

The page model is plain data for the templates, which hold layout only.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import jinja2
import mpmath as mp
import sympy as sp

from .. import __version__
from .. import notation as nt
from ..entry import Entry
from ..profiles import COMPLETE_NAMES
from ..profiles.profile import Profile
from . import front, page, references
from .plots import plots
from .printer import Printer
from .prose import escaped, prose
from .rows import kappa_row, lines, ordered
from .sketch import sketch
from .values import Numbers, sketch_values

Derived = Mapping[str, Mapping[str, Entry]] | Iterable[tuple[Profile, Mapping[str, Entry]]]
PLOT_DIGITS = 16
HALF_SPACE = r"homogeneous half-space, $1/E^{*}=\sum_i(1-\nu_i^2)/E_i$"
NOT_ABOVE, NOT_BELOW = r"\le ", r"\ge "
CHAPTERS = ("Compact contact", "Complete contact")


def handbook_sources(derived: Derived, evidence: Mapping[str, Any] | None = None) -> dict[str, str]:
    """All LaTeX files of the handbook.

    Parameters
    ----------
    derived : mapping or iterable of pairs
        Entries by suffix, for each profile by name or as (profile, entries).
    evidence : mapping, optional
        What was checked, by name of profile; missing records are said to be missing.

    Returns
    -------
    dict of str to str
        Text by path relative to the folder of the handbook.
    """
    given = derived.values() if isinstance(derived, Mapping) else (entries for _, entries in derived)
    books = [dict(entries) for entries in given if entries]
    environment = _environment()
    template = environment.get_template("profile.tex.j2")
    numbers = _numbered([next(iter(entries.values())).profile for entries in books])
    files = {}
    models = []
    for entries in books:
        profile = next(iter(entries.values())).profile
        model = _profile_model(profile, entries, numbers[profile.name], (evidence or {}).get(profile.name, {}))
        models.append(model)
        files[f"profiles/{profile.name}.tex"] = template.render(model)
    files["preamble.tex"] = environment.get_template("preamble.tex.j2").render(version=__version__)
    files["handbook.tex"] = environment.get_template("handbook.tex.j2").render(_book_model(models))
    return files


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("axiderive.emit"),
        block_start_string=r"\BLOCK{",
        block_end_string="}",
        variable_start_string=r"\VAR{",
        variable_end_string="}",
        comment_start_string=r"\#{",
        comment_end_string="}",
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
        undefined=jinja2.StrictUndefined,
    )
    environment.globals.update(remark=remark, shade=shade)
    return environment


def remark(one: dict[str, Any]) -> str:
    """The words behind a formula with the keys they refer to."""
    if not one["remark"]:
        return ""
    key = rf" \own{{{one['uses']}}}" if one["uses"] else ""
    return rf"\remark{{{one['remark']}{key}}}"


def shade(index: int, count: int) -> str:
    """Lighter to darker red over the curves of a family."""
    if count == 1:
        return "100!black"
    steps = ("50!white", "75!white", "95!black", "62!black")
    return steps[round(index * (len(steps) - 1) / (count - 1))]


def _numbered(profiles: list[Profile]) -> dict[str, str]:
    """Section numbers: chapter 1 compact, chapter 2 complete contact, counted within the chapter."""
    counts = [0, 0]
    found = {}
    for profile in profiles:
        chapter = int(profile.name in COMPLETE_NAMES or profile.contact == "complete")
        counts[chapter] += 1
        found[profile.name] = f"{chapter + 1}.{counts[chapter]}"
    return found


def _profile_model(
    profile: Profile, entries: dict[str, Entry], number: str, evidence: Mapping[str, Any]
) -> dict[str, Any]:
    values = sketch_values(profile)
    rough = Numbers(profile, entries, values, PLOT_DIGITS)
    rows = ordered(entries)
    return {
        "name": profile.name,
        "title": prose(profile.title),
        "number": number,
        "chapter": int(number[0]),
        "subtitle": prose(profile.subtitle),
        "picture": sketch(profile, rough),
        "plots": plots(profile, rough),
        "complete": profile.contact == "complete",
        "panel": _panel(profile, entries),
        "lines": [[page.printed(one) for one in pair] for pair in lines(rows)],
        "checks": page.check_table(profile, Numbers(profile, entries, values)),
        "calls": page.calls(profile, entries),
        "derivation": page.derivation(profile, entries),
        "evidence": page.evidence_rows(entries, evidence),
        "uncertified": page.missing_certificates(entries, evidence),
        "settings": evidence.get("settings", {}),
        "sources": [(prose(work), references.label(work)) for work in profile.sources],
        "equations": sorted({r for e in entries.values() for r in e.references}, key=_equation_order),
        "master_row": front.master_row(entries),
        "keys": [entry.key for entry in entries.values()],
        "symbols": sorted(page.symbols(entries)),
    }


def _equation_order(text: str) -> tuple[int, ...]:
    return tuple(int(x) for x in text.strip("()").split("."))


def _panel(profile: Profile, entries: dict[str, Entry]) -> list[tuple[str, str]]:
    """Label and content of each line of the definition panel."""
    lines = [("Profile", shape_tex(profile))]
    bounded = {rule.right for rule in profile.rules if rule.left.is_number}
    parameters = [_domain(symbol) for symbol in profile.parameters if symbol not in bounded]
    for rule in profile.rules:
        left, right = Printer()(rule.left), Printer()(rule.right)
        if rule.left.is_number:
            parameters.append(f"${right}{'>' if rule.strict else NOT_BELOW}{left}$")
        else:
            parameters.append(f"${left}{'<' if rule.strict else NOT_ABOVE}{right}$")
    if len(profile.chain) > 1:
        parameters.append("$" + "<".join(Printer()(x) for x in profile.chain) + "$")
    lines.append(("Parameters" if len(parameters) > 1 else "Parameter", ", ".join(p for p in parameters if p)))
    shorthands = [f"${Printer()(symbol)}={Printer()(expr)}$" for symbol, expr in profile.abbreviations]
    if kappa := kappa_row(tuple(entries.values())):
        shorthands.append(rf"$\displaystyle {kappa}$\rule[-4mm]{{0pt}}{{9mm}}")
    if shorthands:
        lines.append(("Shorthand", ", ".join(shorthands)))
    lines.append(("Medium", HALF_SPACE))
    if profile.contact == "compact":
        start = Printer()(profile.breaks[0]) if profile.truncated else None
        lines.append(("Contact", r"frictionless, compact, $0\le r\le a$" + (f", $a\\ge {start}$" if start else "")))
    else:
        lines.append(("Contact", r"frictionless, complete: the edge $r=a$ is fixed, $d$ is free"))
    if profile.largest is not None:
        lines.append(("Largest", f"$a<{_largest(profile.largest)}$; beyond it the contact is not compact"))
    lines.append(("Valid for", prose(profile.validity)))
    if profile.limits:
        lines.append(("Limits", "; ".join(_limit(limit) for limit in profile.limits)))
    if profile.note:
        lines.append(("Note", prose(profile.note)))
    if profile.synonyms:
        lines.append(("Also called", prose(", ".join(profile.synonyms))))
    return lines


def _largest(bound: sp.Expr) -> str:
    number, rest = bound.as_coeff_Mul()
    return f"{mp.nstr(mp.mpf(str(number)), 6)}\\,{Printer()(rest)}"


def _limit(limit: Any) -> str:
    name = limit.target.replace("_", " ")
    approach = rf"${Printer()(limit.symbol)}\to {Printer()(sp.sympify(limit.value))}$"
    return rf"{approach} \hyperref[sec:{limit.target}]{{{name}}}"


def shape_tex(profile: Profile) -> str:
    """f(r), piece by piece."""
    texts = []
    lower = None
    for piece in profile.pieces:
        expr = Printer((nt.r, piece.upper) if piece.upper is not None else ())(piece.expr)
        if len(profile.pieces) == 1:
            texts.append(f"$f(r)={expr}$")
        elif piece.upper is not None:
            texts.append(f"$f(r)={expr}$ for $r\\le {Printer()(piece.upper)}$")
        else:
            texts.append(f"$f(r)={expr}$ for $r>{Printer()(lower)}$")
        lower = piece.upper
    if len(texts) == 1:
        return texts[0]
    return r",\newline ".join(rf"\rule[-2mm]{{0pt}}{{6mm}}{text}" for text in texts).replace(r"\frac", r"\tfrac")


def _domain(symbol: Any) -> str:
    """Domain of a parameter in print: 0 < theta < pi/2."""
    if isinstance(symbol, sp.IndexedBase):
        return r"$A_j\ge 0$, not all zero"
    record = nt.describe(symbol)
    text = record.domain.replace(record.name, record.latex).replace("pi/2", r"\pi/2").replace(">=", r"\ge ")
    return f"${text}$" if text else ""


def _book_model(models: list[dict[str, Any]]) -> dict[str, Any]:
    chapters = [(title, [m for m in models if m["chapter"] == i + 1]) for i, title in enumerate(CHAPTERS)]
    keys = sorted(key for m in models for key in m["keys"])
    return {
        "chapters": [(title, members) for title, members in chapters if members],
        "suffixes": front.suffixes(),
        "notation": front.notation_rows({s for m in models for s in m["symbols"]}),
        "definitions": front.definition_rows(),
        "masters": front.master_rows(),
        "works": [
            (references.label(short), escaped(" ".join(work))) for short, work in sorted(references.WORKS.items())
        ],
        "key_rows": front.columns(keys, 3),
        "keys_count": {"profiles": len(models), "entries": len(keys)},
        "version": __version__,
    }
