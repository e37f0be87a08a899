"""Plain text of the profile files as LaTeX: mathematics written in ASCII becomes mathematics, specials are escaped.

A run of mathematics is what is made of known symbols, numbers, functions and
operators only.  A lone `a` or `A` is the article, a lone `wavelength` the word.
"""

from __future__ import annotations

import re

from .. import notation as nt

_FUNCTION = r"(?:tan|sin|cos|ln|exp|abs)\([^()]*\)"
_SUBSCRIPTED = r"(?:[A-Za-z]_(?:\d|[A-Za-z]+))"
_WORDS = ("theta", "wavelength", "mu")
_NUMBER = r"(?:(?<![^\s(])-)?\d+(?:\.\d+)?"
_ATOM = rf"(?:{_FUNCTION}|{_SUBSCRIPTED}|theta|wavelength|mu|R[12]|[a-zA-Z]'?(?![a-zA-Z])|{_NUMBER})"
_POWER = r"(?:\^(?:\([^()]*\)|\d+|[a-z]))?"
_FACTOR = rf"{_ATOM}{_POWER}"
_LINK = r"(?: ?/ ?| ?[-+*] | ?<< | ?>> | ?<= | ?>= | ?[<>=~] |, (?=-?\d)| \.\.\. | (?=[0-9a-zA-Z(]))"
_RUN = re.compile(rf"(?<![\w'])({_FACTOR}(?:{_LINK}{_FACTOR})*(?: <<| >>)?)(?![\w'])")
_SYMBOL = re.compile(r"[a-zA-Z]\w*")
_RELATIONS = {"<<": r"\ll ", ">>": r"\gg ", "<=": r"\le ", ">=": r"\ge ", "~": r"\sim ", "...": r"\dots ", "*": r"\,"}
_ESCAPES = {
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "$": r"\$",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}
_PHRASES = {
    "1/E_star = sum (1 - nu_i^2)/E_i": r"$1/E^{*}=\sum_i(1-\nu_i^2)/E_i$",
    "F/(pi a^2)": r"$F_{\mathrm N}/(\pi a^2)$",
    "c_N(x) = H |x|^k": r"$c_{\mathrm N}(x)=H\,|x|^k$",
    "c_T(x) = H_x |x|^k": r"$c_{\mathrm T}(x)=H_x\,|x|^k$",
    "1/G_star = sum (2 - nu_i)/(4 G_i)": r"$1/G^{*}=\sum_i(2-\nu_i)/(4 G_i)$",
    "J = (t/t_0)^alpha/E": r"$J=(t/t_0)^\alpha/E$",
}
"""Formulas of the notation that no rule reads."""
_MINIMA = {name: rf"{name[0]}_{{\mathrm{{min}}}}" for name in ("F_min", "P_min", "d_min")}


def prose(text: str) -> str:
    """The text as LaTeX."""
    for phrase, tex in _PHRASES.items():
        if phrase in text:
            before, after = text.split(phrase, 1)
            return prose(before) + tex + prose(after)
    out, end = "", 0
    for match in _RUN.finditer(text):
        run = match[1]
        if not _is_mathematics(run, text[match.end(1) :]):
            continue
        start = match.start(1)
        out += escaped(text[end:start]) + f"${formula(run)}$"
        end = match.end(1)
    return out + escaped(text[end:])


def _is_mathematics(run: str, rest: str) -> bool:
    if run in ("a", "A"):  # the article, unless the sentence goes on without a noun
        return not rest or rest[0] in ",;.:)" or rest.startswith(" is ")
    if run in ("I", "wavelength") or re.fullmatch(r"\d+(\.\d+)?", run):
        return False
    return all(
        name in _WORDS or len(name) <= 2 or "_" in name or name in ("tan", "sin", "cos", "ln", "exp", "abs")
        for name in _names(run)
    )


def _names(run: str) -> list[str]:
    return _SYMBOL.findall(run)


def formula(run: str) -> str:
    """ASCII mathematics as LaTeX."""
    run = re.sub(r"(?<=[\w)']) (?=[\w(])", r"\\,", run)
    run = re.sub(r"\b(tan|sin|cos|ln|exp)\((\w+)\)", lambda m: rf"\{m[1]} {_symbol(m[2])}", run)
    run = re.sub(r"\babs\((\w+)\)", lambda m: f"|{_symbol(m[1])}|", run)
    run = re.sub(r"\^\(([^()]*)\)", lambda m: f"^{{{m[1]}}}", run)
    run = re.sub(r"(?<![\\\w{])[a-zA-Z]\w*(?![^{}]*\}\})", lambda m: _symbol(m[0]), run)
    for plain, tex in _RELATIONS.items():
        run = run.replace(plain, tex)
    return re.sub(r" ?([<>=+-]) ", r"\1", run).strip()


def _symbol(name: str) -> str:
    if name in _MINIMA:
        return _MINIMA[name]
    if "_" in name and not nt.known(name):
        stem, _, subscript = name.partition("_")
        return f"{stem}_{subscript}"
    return nt.describe(name).latex if nt.known(name) else name


def domain(record: nt.Notation) -> str:
    """Domain of a symbol in print: 0 < theta < pi/2; every name in it as its symbol is printed."""
    text = re.sub(r"[A-Za-z]\w*", lambda m: record.latex if m[0] == record.name else _symbol(m[0]), record.domain)
    for plain, tex in ((">=", r"\ge "), ("<=", r"\le "), ("pi/2", r"\pi/2")):
        text = text.replace(plain, tex)
    return text


def escaped(text: str) -> str:
    """Plain words with TeX's special characters made harmless."""
    text = "".join(_ESCAPES.get(c, c) for c in text)
    return text.replace(" - ", " -- ").replace("...", r"\dots{}")
