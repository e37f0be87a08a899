r"""Running text with mathematics in it, written in plain letters, set as LaTeX: r^2 < a as $r^{2}< a$.

Words on profiles and symbols name what they speak of as the notation does, those on the equations of chapter 11 as
these are transcribed. A formula is a run of symbols, numbers and signs between words; nothing but its type changes.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from .. import notation as nt

_ESCAPES = {
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "$": r"\$",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
}


def escaped(text: str) -> str:
    """Plain words with TeX's special characters made harmless."""
    text = "".join(_ESCAPES.get(c, c) for c in text)
    return text.replace(" - ", " -- ").replace("...", r"\dots{}")


RELATIONS = {"<=": r"\le", ">=": r"\ge", "<<": r"\ll", ">>": r"\gg", "~": r"\sim"}
GREEK = ("alpha", "beta", "theta", "mu", "nu", "pi", "rho", "xi", "phi", "Gamma")
COMMON = RELATIONS | {name: "\\" + name for name in (*GREEK, "tan", "sin", "cos", "arcsin", "ln", "exp")}
NAMES = COMMON | {
    "E*": "E^{*}", "w1D": r"w_{\mathrm{1D}}", "p0": "p_0", "c0": "c_0", "u0": "u_0", "h_N": r"h_{\mathrm N}",
    "R_F": r"R_{\mathrm F}", "H_n": "H_n", "dl": r"\Delta\ell", "dgamma": r"\Delta\gamma", "2F1": r"{}_2F_1",
    "drho": r"\,\mathrm d\rho", "dxi": r"\,\mathrm d\xi", "dy": r"\mathrm dy", "dv": r"\mathrm dv",
    "dg": r"\mathrm dg", "dr": r"\,\mathrm dr", "Re": r"\operatorname{Re}",
}  # fmt: skip
"""Names of the transcription of chapter 11 in print; the longest that fits is taken."""
_RECORDED = {n.name: n.latex for n in nt.all_notation() if len(n.name) > 1 or n.latex != n.name}
_NOTATION = COMMON | {
    **{name: tex for name, tex in _RECORDED.items() if "_" in name or len(name) <= 2},
    **{name: rf"{name[0]}_{{\mathrm{{min}}}}" for name in ("F_min", "P_min", "d_min")},
    **{name: rf"c_{{\mathrm {name[-1]}}}" for name in ("c_N", "c_T")},
}
"""The same of the notation, but for those that are English words."""
_SUMS = {
    "1/E_star = sum (1 - nu_i^2)/E_i": r"1/E^{*}=\sum_i(1-\nu_i^2)/E_i",
    "1/G_star = sum (2 - nu_i)/(4 G_i)": r"1/G^{*}=\sum_i(2-\nu_i)/(4 G_i)",
}
"""Formulas of the notation whose sum reads as a word."""
STRONG = ("name", "letter", "number", "call", "int")
NAMING = ("factor ", "radius ")
"""Words before a letter that is no article."""
Token = tuple[str, str]
NONE: Token = ("", "")


@dataclass(frozen=True)
class Typesetter:
    """Sets a text in which these names stand for their LaTeX, and its formulas between two marks."""

    names: dict[str, str]
    marks: tuple[str, str]

    @cached_property
    def _token(self) -> re.Pattern[str]:
        names = "|".join(map(re.escape, sorted(self.names, key=len, reverse=True)))
        return re.compile(
            rf"(?P<reference>\(\d+\.\d+\))|(?P<call>sqrt|abs)(?=\()|(?P<int>int)(?=_)|(?P<dots>\.\.\.)"
            rf"|(?P<name>(?:{names})(?:(?<=\W)|(?![^\W_]))'?)"
            r"|(?P<either>\+-)|(?P<word>[^\W\d_](?:[^\W\d_]|[-'.](?=[^\W\d_]))+)|(?P<number>\d+(?:\.\d+)?)"
            r"|(?P<letter>[A-Za-z]'?)|(?P<space> )|(?P<sign>[-+=<>/^_()\[\];,|])|(?P<other>.)"
        )

    def tokens(self, text: str) -> list[Token]:
        """The kinds and texts of what the text is made of."""
        return [(str(match.lastgroup), match[0]) for match in self._token.finditer(text)]

    def __call__(self, text: str) -> str:
        """The text as LaTeX."""
        tokens = self.tokens(text)
        out, at = "", 0
        while at < len(tokens):
            end = _formula(tokens, at)
            out += self.mathematics(tokens[at:end]).join(self.marks) if end > at else _word(tokens, at)
            at = max(end, at + 1)
        return out

    def mathematics(self, tokens: list[Token]) -> str:
        """A formula as LaTeX, without marks."""
        out, at = "", 0
        while at < len(tokens):
            kind, text = tokens[at]
            if kind == "call":
                end = _closing(tokens, at + 1)
                inside = self.mathematics(tokens[at + 2 : end])
                out, at = out + (rf"\sqrt{{{inside}}}" if text == "sqrt" else rf"\lvert {inside}\rvert "), end + 1
                continue
            if text in ("^", "_"):
                raised, at = _script(tokens, at + 1)
                out += f"{text}{{{self.mathematics(raised)}}}"
                continue
            if kind == "space" and at and tokens[at - 1][0] == "number" and "." in tokens[at - 1][1]:
                out += r"\,"
            elif kind == "name":
                out += self.names[text.rstrip("'")] + ("'" if text.endswith("'") else " ")
            else:
                out += {"int": r"\int", "either": r"\pm ", "dots": r"\dots "}.get(kind, text)
            if text in (",", ";"):
                out += r"\,"
            at += 1
        return re.sub(r" +(?=[^A-Za-z\\\d])|(?<=[-+=<>/(\[]) +|(?<=[^A-Za-z}])\s+$", "", out).strip()


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
    while at < len(tokens) and tokens[at][0] not in ("word", "reference", "other"):
        kind, text = tokens[at]
        if text in ("a", "A") and not _is_symbol(tokens, at):
            break
        if text == "Gamma" and tokens[at + 1 : at + 3] == [("space", " "), ("word", "function")]:
            break
        depth += (text in "([") - (text in ")]") if kind == "sign" else 0
        if depth < 0 or text in (",", ";") and depth == 0:
            break
        at += 1
        if depth == 0 and (kind in STRONG or text in (")", "]")):
            good = at
    inside = {kind for kind, _ in tokens[start:good]}
    first = tokens[start] if start < len(tokens) else NONE
    if first[1] == "-" and tokens[start + 1 : start + 2] and tokens[start + 1][0] == "number":
        return good if start == 0 or tokens[start - 1][0] == "space" else start
    begins = first[0] in STRONG or first[1] in ("-", "(", "[") and bool(inside & {"name", "letter", "call"})
    named = inside & {"name", "letter", "call", "int"} or {text for _, text in tokens[start:good]} & set("=<>/^")
    return good if begins and named and not _is_text(tokens, start) else start


def _is_symbol(tokens: list[Token], at: int) -> bool:
    """Whether a letter that may be the article is none: beside a sign or a symbol, named so, or without a noun."""
    if "".join(text for _, text in tokens[max(0, at - 2) : at]) in NAMING:
        return True
    before = next((t for t in reversed(tokens[:at]) if t[0] != "space"), NONE)
    if tokens[at][1] == "A":
        return before != NONE and before[1] not in ".:" or tokens[at + 2 : at + 3] == [("word", "is")]
    if before[0] in ("letter", "name", "number") or before[0] == "sign" and before[1] not in ",;(":
        return True
    after, noun = [*tokens[at + 1 : at + 3], NONE, NONE][:2]
    return after[0] != "space" or noun[1] == "is" or noun[1] in (*RELATIONS, "=", "<", ">", "+", "-", "/")


def _is_text(tokens: list[Token], at: int) -> bool:
    """A hyphen between words, or a bracket around them."""
    return tokens[at][1] in ("-", "+") and at > 0 and tokens[at - 1][0] in ("word", "reference")


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


typeset = Typesetter(NAMES, (r"\(", r"\)"))
"""Words on the equations of chapter 11."""
_words = Typesetter(_NOTATION, ("$", "$"))
_ALONE = re.compile(r"\\(tan|sin|cos|ln|exp)\((\\?\w+)\)")
"""A function of one symbol, which the rows print without brackets."""


def prose(text: str) -> str:
    """Words on profiles and symbols."""
    for phrase, tex in _SUMS.items():
        before, found, after = text.partition(phrase)
        if found:
            return f"{prose(before)}${tex}${prose(after)}"
    return _ALONE.sub(r"\\\1 \2", _words(text))


def domain(record: nt.Notation) -> str:
    """Domain of a symbol in print: 0 < theta < pi/2; every name in it as its symbol is printed."""
    own = Typesetter(COMMON | _RECORDED | dict.fromkeys((record.name, record.latex), record.latex), ("", ""))
    return own.mathematics(own.tokens(record.domain))
