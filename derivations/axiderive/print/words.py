r"""Running text with mathematics in it, set as LaTeX.

Plain text of the profile files as LaTeX: mathematics written in ASCII becomes mathematics, specials are escaped.

A run of mathematics is what is made of known symbols, numbers, functions and
operators only.  A lone `a` or `A` is the article, a lone `wavelength` the word.

Words on equations, transcribed in plain letters, set with their formulas: r^2 < a as \(r^{2}<a\).

A formula is a run of symbols, numbers and signs between words; nothing but its type changes.
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


GREEK = ("alpha", "beta", "theta", "mu", "nu", "pi", "rho", "xi", "phi", "Gamma")
NAMES = {
    **{name: "\\" + name for name in GREEK},
    **{name: "\\" + name for name in ("sin", "cos", "arcsin")},
    "E*": "E^{*}", "w1D": r"w_{\mathrm{1D}}", "p0": "p_0", "c0": "c_0", "u0": "u_0", "h_N": r"h_{\mathrm N}",
    "R_F": r"R_{\mathrm F}", "H_n": "H_n", "dl": r"\Delta\ell", "dgamma": r"\Delta\gamma", "2F1": r"{}_2F_1",
    "drho": r"\,\mathrm d\rho", "dxi": r"\,\mathrm d\xi", "dy": r"\mathrm dy", "dv": r"\mathrm dv",
    "dg": r"\mathrm dg", "<=": r"\le", "dr": r"\,\mathrm dr", "Re": r"\operatorname{Re}",
}  # fmt: skip
"""Names of the transcription in print; the longest that fits is taken."""
SYMBOL = "|".join(map(re.escape, sorted(NAMES, key=len, reverse=True)))
TOKEN = re.compile(
    rf"(?P<reference>\(\d+\.\d+\))|(?P<call>sqrt|abs)(?=\()|(?P<int>int)(?=_)|(?P<name>(?:{SYMBOL})(?![A-Za-z0-9])'?)"
    r"|(?P<either>\+-)|(?P<word>[^\W\d_](?:[^\W\d_]|[-'.](?=[^\W\d_]))+)|(?P<number>\d+(?:\.\d+)?)|(?P<letter>[A-Za-z]'?)"
    r"|(?P<space> )|(?P<sign>[-+=<>/^_()\[\];,])|(?P<other>.)"
)
STRONG = ("name", "letter", "number", "call", "int")
NAMING = ("factor ", "radius ")
"""Words before a letter that is no article."""
Token = tuple[str, str]


def typeset(text: str) -> str:
    """The text as LaTeX."""
    tokens = [(str(match.lastgroup), match[0]) for match in TOKEN.finditer(text)]
    out, at = "", 0
    while at < len(tokens):
        end = _formula(tokens, at)
        if end > at:
            out += rf"\({_mathematics(tokens[at:end])}\)"
        else:
            end = at + 1
            out += _word(tokens, at)
        at = end
    return out


def _word(tokens: list[Token], at: int) -> str:
    kind, text = tokens[at]
    if kind == "sign" and text == "-" and tokens[at - 1 : at] and tokens[at - 1][0] == "reference":
        return "--"
    if kind == "word" and re.fullmatch(r"[A-Z]\w+-[A-Z]\w+", text):
        return escaped(text).replace("-", "--")
    return escaped(text)


def _formula(tokens: list[Token], start: int) -> int:
    """Where a formula that begins here ends; its brackets are closed, and it ends with no space, comma or sign."""
    depth, at, good = 0, start, start
    kinds = []
    while at < len(tokens) and tokens[at][0] not in ("word", "reference", "other"):
        kind, text = tokens[at]
        if text == "a" and not _is_symbol(tokens, at) or text == "Gamma" and "".join(_texts(tokens, at)) == " function":
            break
        depth += (text in "([") - (text in ")]") if kind == "sign" else 0
        if depth < 0 or text in (",", ";") and depth == 0:
            break
        kinds.append(kind)
        at += 1
        if depth == 0 and (kind in STRONG or text in (")", "]")):
            good = at
    inside = {kind for kind, _ in tokens[start:good]}
    first = tokens[start] if start < len(tokens) else ("", "")
    if first[1] == "-" and tokens[start + 1 : start + 2] and tokens[start + 1][0] == "number" and good == start + 2:
        return good if start == 0 or tokens[start - 1][0] == "space" else start
    begins = first[0] in STRONG or first[1] in ("-", "(", "[") and bool(inside & {"name", "letter", "call"})
    named = inside & {"name", "letter", "call", "int"} or len(inside - {"space"}) > 1
    return good if begins and named and not _is_text(tokens, start) else start


def _texts(tokens: list[Token], at: int) -> list[str]:
    """The two tokens behind a place."""
    return [text for _, text in tokens[at + 1 : at + 3]]


def _is_symbol(tokens: list[Token], at: int) -> bool:
    """Whether the letter a is a radius: beside a sign, between symbols or named so; else it is the article."""
    if "".join(text for _, text in tokens[max(0, at - 2) : at]) in NAMING:
        return True
    before = next((t for t in reversed(tokens[:at]) if t[0] != "space"), ("", ""))
    after = next((t for t in tokens[at + 1 :] if t[0] != "space"), ("", ""))
    if before[0] in ("letter", "name") or before[0] == "sign" and before[1] not in (",", ";", "("):
        return True
    if after[0] == "sign":
        return after[1] not in (",", ";", "(") and (after[1] != ")" or before[1] == "(")
    return False


def _is_text(tokens: list[Token], at: int) -> bool:
    """A hyphen between words, or a bracket around them."""
    return tokens[at][1] in ("-", "+") and at > 0 and tokens[at - 1][0] in ("word", "reference")


def _mathematics(tokens: list[Token]) -> str:
    out, at = "", 0
    while at < len(tokens):
        kind, text = tokens[at]
        if kind == "call":
            end = _closing(tokens, at + 1)
            inside = _mathematics(tokens[at + 2 : end])
            out, at = out + (rf"\sqrt{{{inside}}}" if text == "sqrt" else rf"\lvert {inside}\rvert "), end + 1
            continue
        if text in ("^", "_"):
            raised, at = _script(tokens, at + 1)
            out += f"{text}{{{_mathematics(raised)}}}"
            continue
        if kind == "name":
            out += NAMES[text.rstrip("'")] + ("'" if text.endswith("'") else " ")
        else:
            out += {"int": r"\int", "either": r"\pm "}.get(kind, text)
        if text in (",", ";"):
            out += r"\,"
        at += 1
    return re.sub(r" +(?=[^A-Za-z\\\d])|(?<=[^A-Za-z}])\s+$", "", out).strip()


def _script(tokens: list[Token], at: int) -> tuple[list[Token], int]:
    """What is raised or lowered, a bracket without its sides or one token with its sign, and what follows it."""
    if tokens[at][1] == "(":
        end = _closing(tokens, at)
        return tokens[at + 1 : end], end + 1
    end = at + 1 + (tokens[at][1] == "-")
    return tokens[at:end], end


def _closing(tokens: list[Token], start: int) -> int:
    depth = 0
    for at in range(start, len(tokens)):
        depth += (tokens[at][1] in "([") - (tokens[at][1] in ")]") if tokens[at][0] == "sign" else 0
        if depth == 0:
            return at
    message = f"{''.join(text for _, text in tokens)!r} has a bracket that is not closed"
    raise ValueError(message)
