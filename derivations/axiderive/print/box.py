"""The room a printed formula will take, in points at 10 pt, and the brackets that go around it.

Good to a few per cent, enough to decide on line breaks and on the size of brackets.
"""

from __future__ import annotations

import re
from functools import lru_cache
from typing import NamedTuple


class Box(NamedTuple):
    """Width, height above and depth below the line of writing."""

    width: float
    above: float
    below: float


_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d|[^\s]")
_BRACKETS = re.compile(r"\\[{}]|[()\[\]]")
_LETTERS = re.compile(r"\\sqrt\[\d+\]|\(t\)")
# measured with mathpazo
_WIDE = {
    "=": 13.4, r"\to": 15.6, "+": 12.3, "-": 12.3, "(": 4.3, ")": 4.3, "[": 4.3, "]": 4.3, ",": 4.3, ";": 4.3, "/": 5.0,
    r"\,": 1.7, r"\;": 2.8, r"\quad": 10.0, r"\qquad": 20.0, r"\pi": 7.3, r"\psi": 6.8, r"\varphi": 6.7,
    "R": 7.1, "E": 6.2, "F": 5.6, "A": 7.6, "H": 8.4, r"\int": 10.0, r"\sum": 16.0,
    r"\Bigl": 1.9, r"\Bigr": 1.9, r"\bigl": 0.5, r"\bigr": 0.5,
    r"\biggl": 3.1, r"\biggr": 3.1, r"\Biggl": 4.3, r"\Biggr": 4.3,
} | {
    name: 5.2 * len(name[1:]) + 2.0
    for name in (r"\sin", r"\cos", r"\tan", r"\ln", r"\exp", r"\sinh", r"\arcsin", r"\arccos", r"\arctan")
} | dict.fromkeys(
    (r"\displaystyle", r"\mathrm", r"\mathbf", r"\operatorname", r"\left", r"\right", r"\text", r"\!", "&", "{", "}"), 0
)  # fmt: skip
_LETTER = 5.1, 7.0, 0.0
"""Most letters and digits; tails below the line only matter beside a bracket, which reaches as far."""
_TALL = {
    "(": (7.5, 2.5), "[": (7.5, 2.5), r"\{": (7.5, 2.5), "+": (5.5, 0.5), "-": (5.5, 0.5), "=": (5.5, 0.5),
    r"\int": (13.5, 8.5), r"\sum": (9.5, 4.5),
}  # fmt: skip
AXIS, RULE = 2.5, 0.4
_FENCE = {r"\bigl": 6.0, r"\Bigl": 9.0, r"\biggl": 12.0, r"\Biggl": 15.0}
"""Half of the height of a bracket, which stands about the axis."""
_SCRIPT, _RAISED, _LOWERED = 0.72, 3.6, 2.5
SIZES = ((19.0, "big"), (26.0, "Big"), (33.0, "bigg"), (float("inf"), "Bigg"))
"""Height of the content up to which a bracket is large enough: what sticks out by a few points looks right."""
_SCALES = {r"\frac": (1.0, 6.8, 6.9, 3 * RULE), r"\tfrac": (_SCRIPT, 3.9, 3.45, RULE)}
"""Of a fraction in display size and in that of scripts: scale, shifts of both parts, and their least distance."""


@lru_cache(maxsize=4096)
def box(tex: str) -> Box:
    """The room of a formula in display style."""
    return _Reader(_TOKEN.findall(tex)).row()


def width(tex: str) -> float:
    """Width in points."""
    return box(tex).width


def size_around(tex: str) -> str:
    r"""The size of the brackets around a content: big, Big, bigg or Bigg; Big at least around what is built up."""
    _, above, below = box(tex)
    built = any(mark in tex for mark in (r"\frac", r"\int", r"\sum", r"\Bigl", r"\biggl", r"\Biggl"))
    height = max(2 * (above - AXIS), 2 * (below + AXIS), SIZES[0][0] + 1 if built else 0.0)
    return next(size for limit, size in SIZES if height <= limit)


def brackets_around(text: str) -> tuple[str, str]:
    """The pair that fits around the text: () around none, then [], {}, and () again; J(t) counts as a letter."""
    depth = deepest = 0
    for mark in _BRACKETS.findall(_LETTERS.sub("", text)):
        depth += 1 if mark in ("(", "[", r"\{") else -1
        deepest = max(deepest, depth)
    return (("(", ")"), ("[", "]"), (r"\{", r"\}"))[deepest % 3]


def bracket(text: str) -> str:
    """The text in brackets that fit, plain ones where nothing stands but letters, powers and plain fractions."""
    left, right = brackets_around(text)
    if not any(mark in text for mark in (r"\frac", r"\tfrac", r"\int", r"\sum", r"\sqrt", "(", r"\Bigl", r"\biggl")):
        return left + text + right
    size = size_around(text)
    return rf"\{size}l{left}{text}\{size}r{right}"


class _Reader:
    def __init__(self, tokens: list[str]) -> None:
        self.tokens, self.at = tokens, 0

    def next(self) -> str:
        """The next token, which stays in place; an empty one at the end."""
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def row(self, closing: str | None = None) -> Box:
        """The room of the tokens up to the closing one, or to the end, side by side."""
        wide = above = below = 0.0
        while token := self.next():
            if token == closing:
                self.at += 1
                break
            one = self.item()
            wide, above, below = wide + one.width, max(above, one.above), max(below, one.below)
        return Box(wide, above, below)

    def argument(self) -> Box:
        """The room of a TeX argument: a group in braces, or the next item."""
        if self.next() == "{":
            self.at += 1
            return self.row("}")
        return self.item()

    def item(self) -> Box:
        """The room of the next item: a letter, group, fraction, root, scripts or fence."""
        token = self.next()
        self.at += 1
        if token == "{":
            return self.row("}")
        if token in _SCALES:
            return self.fraction(*_SCALES[token])
        if token == r"\sqrt":
            if self.next() == "[":
                self.at = self.tokens.index("]", self.at) + 1
            inside = self.argument()
            return Box(9.5 + inside.width, inside.above + 2.9, inside.below + 0.5)
        if token in ("^", "_"):
            return self.scripts(token)
        if token in _FENCE:
            mark = self.next()
            self.at += 1
            half = _FENCE[token]
            return Box(_WIDE[token] + _WIDE.get(mark, _LETTER[0]), AXIS + half, half - AXIS)
        space = token[0] == "\\" and not token[1:].isalpha() and token != r"\{"
        tall = (0.0, 0.0) if space else _TALL.get(token, _LETTER[1:])
        return Box(_WIDE.get(token, _LETTER[0]), *tall)

    def scripts(self, token: str) -> Box:
        """The room of one script or of two above each other, from the argument of the first on."""
        found = {token: self.argument()}
        if self.next() in ("^", "_") and self.next() != token:
            other = self.next()
            self.at += 1
            found[other] = self.argument()
        above = _RAISED + _SCRIPT * found["^"].above if "^" in found else 0.0
        below = _LOWERED + _SCRIPT * found["_"].below if "_" in found else 0.0
        return Box(max(_SCRIPT * one.width for one in found.values()), above, below)

    def fraction(self, scale: float, raised: float, lowered: float, clearance: float) -> Box:
        """The room of a fraction after its command."""
        top, bottom = self.argument(), self.argument()
        raised = max(raised, AXIS + RULE / 2 + clearance + scale * top.below)
        lowered = max(lowered, clearance + RULE / 2 - AXIS + scale * bottom.above)
        wide = 2.4 + max(top.width, bottom.width) * scale
        return Box(wide, raised + scale * top.above, lowered + scale * bottom.below)
