r"""The LaTeX of running text as HTML: formulas for KaTeX, references as links, the few macros of the book by name.

Formulas stay as they are printed.  A macro that has no words here is an error,
so that no backslash ever reaches a reader.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator
from html import escape

from markupsafe import Markup

from ..book.book import BACK, FRONT

Link = Callable[[str, str], Markup]
"""Label of the book (`sec:cone`, `eq:cone.p`, `part:laws`, `ref:Hertz1882`) or `chapter:11.29`, and words: a link
or the bare words."""

_GROUP = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
_TOKEN = re.compile(
    rf"""(?P<open>\(?)(?<!\\)\$(?P<tex>(?:[^$\\]|\\.)+)\$(?P<close>[,.;:)]*)
    |\\\((?P<quoted>.+?)\\\)
    |\\hyperref\[(?P<label>[^\]]*)\]{_GROUP.replace("(", "(?P<linked>", 1)}
    |\\own\{{(?P<own>[^}}]*)\}}
    |\\eqr\{{(?P<equation>[^}}]*)\}}
    |\\code\{{(?P<code>[^}}]*)\}}
    |\\pageref\{{part:(?P<part>\w+)\}}
    |\\textcolor\{{note\}}{_GROUP.replace("(", "(?P<aside>", 1)}
    |\\rule(?:\[[^\]]*\])?\{{[^}}]*\}}\{{[^}}]*\}}
    |(?P<macro>\\(?:[a-zA-Z]+(?:\{{\}}|\\?[ ])?|.))
    |\((?P<numbered>11\.\d+)\)
    |(?P<dash>---?)
    |(?P<tie>~)
    |(?P<plain>[^\\$~(-]+|.)""",
    re.VERBOSE | re.DOTALL,
)
_MACROS = {
    r"\,": "\N{THIN SPACE}", r"\ ": " ", r"\enspace": " ", r"\quad": " ", r"\newline": Markup("<br>"),
    r"\ok": "\N{CHECK MARK}", r"\ss": "ß", r"\textmu": "µ", r"\dots": "…",
    r"\textasciitilde": "~", r"\textasciicircum": "^", r"\&": "&", r"\%": "%", r"\#": "#", r"\_": "_", r"\$": "$",
    r"\{": "{", r"\}": "}",
}  # fmt: skip
PARTS = {label: title for title, label in (*FRONT, *BACK)}
"""Titles of the parts of the book."""
_DASHES = {"--": "–", "---": "—"}


def formula(tex: str, display: bool = False) -> Markup:
    """A formula for KaTeX; without JavaScript its LaTeX is read."""
    tex = tex.replace(r"\begin{aligned}[t]", r"\begin{aligned}").strip()
    display = display or tex.startswith(r"\displaystyle")
    mode = " data-display" if display else ""
    return Markup(f'<span class="tex"{mode}>{escape(tex.removeprefix(chr(92) + "displaystyle").strip())}</span>')


def slug(text: str) -> str:
    """Words as the end of an address: (11.29) and (11.61) is 11.29-and-11.61."""
    return re.sub(r"[^\w.]+", "-", text).strip("-")


def words(text: str, link: Link) -> Markup:
    """Running text of the page model as HTML; a part is named by its title, for there are no pages."""
    return Markup("").join(_pieces(text.replace(r"on page \pageref", r"under \pageref"), link))


def _pieces(text: str, link: Link) -> Iterator[Markup | str]:
    for match in _TOKEN.finditer(text):
        found = match.groupdict()
        if found["tex"]:
            yield _kept(found["open"], formula(found["tex"]), found["close"])
        elif found["quoted"]:
            yield formula(found["quoted"])
        elif found["label"]:
            yield link(found["label"], found["linked"])
        elif found["own"]:
            yield link(f"own:{found['own']}", f".{found['own']}")
        elif found["equation"]:
            yield link(f"eq:{found['equation']}", found["equation"])
        elif found["code"]:
            yield Markup("<code>{}</code>").format(words(found["code"], link))
        elif found["part"]:
            yield link(f"part:{found['part']}", PARTS[found["part"]])
        elif found["numbered"]:
            yield link(f"chapter:{found['numbered']}", f"({found['numbered']})")
        elif found["aside"]:
            yield Markup('<span class="note">{}</span>').format(words(found["aside"], link))
        elif found["macro"]:
            yield _macro(found["macro"], text)
        elif found["dash"]:
            yield _DASHES[found["dash"]]
        elif found["tie"]:
            yield "\N{NO-BREAK SPACE}"
        elif found["plain"]:
            yield found["plain"]


def _kept(opened: str, inner: Markup, closed: str) -> Markup:
    """A formula on one line with the brackets and the comma beside it: a browser breaks a line at every formula."""
    return Markup('<span class="kept">{}{}{}</span>').format(opened, inner, closed) if opened or closed else inner


def _macro(macro: str, text: str) -> Markup | str:
    name = macro.removesuffix("{}")
    # a backslash blank behind the name is a blank, a blank alone only ends the name
    name, blank = (name[:-2], " ") if name.endswith("\\ ") and name != "\\ " else (name, "")
    name = name.rstrip() or name
    if name not in _MACROS:
        message = f"{name} in {text!r} has no words in HTML; add it to web.words"
        raise ValueError(message)
    return _MACROS[name] + blank


def plain(text: str) -> str:
    """Running text without links and the marks of LaTeX; its formulas in letters."""
    return symbol(str(words(text, lambda label, shown: Markup("{}").format(shown)).striptags()))


def symbol(latex: str) -> str:
    r"""A symbol in letters of Unicode: E^{*} is E*, \Delta\gamma is Δγ, b^{3} is b³."""
    text = re.sub(r"\\bar ?\{?(\w)\}?", "\\1\N{COMBINING MACRON}", latex)
    text = re.sub(r"\^\{?(\d)\}?", lambda match: _POWERS[int(match[1])], text)
    text = re.sub(r"\\([A-Za-z]+) ?", lambda match: _letter(match[1]), text)
    return re.sub(r"[\\{}$^]", "", text)


def _letter(name: str) -> str:
    if name in _LEFT_OUT:
        return ""
    small = name.removeprefix("var").replace("lambda", "lamda")
    size = "CAPITAL" if name[0].isupper() else "SMALL"
    try:
        return unicodedata.lookup(f"GREEK {size} LETTER {small.upper()}")
    except KeyError:
        return f"{name} "


_LEFT_OUT = {"mathrm", "mathbf", "operatorname", "tfrac", "frac", "displaystyle", "left", "right"}
_POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
