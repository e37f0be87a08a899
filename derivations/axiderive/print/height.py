"""How tall a printed formula will be, in points at 10 pt, and the brackets that go around it."""

from __future__ import annotations

import re

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d|[^\s]")
_BRACKETS = re.compile(r"\\[{}]|[()\[\]]")
_LETTERS = re.compile(r"\\sqrt\[\d+\]|\(t\)")
Extent = tuple[float, float]
"""Height above and depth below the line of writing."""

AXIS, RULE = 2.5, 0.4
LETTER: Extent = (7.0, 0.0)
"""Most letters and digits; tails below the line only matter beside a bracket, which reaches as far."""
_TALL: dict[str, Extent] = {
    "(": (7.5, 2.5), "[": (7.5, 2.5), r"\{": (7.5, 2.5), "+": (5.5, 0.5), "-": (5.5, 0.5), "=": (5.5, 0.5),
    r"\int": (13.5, 8.5), r"\sum": (9.5, 4.5),
}  # fmt: skip
_FENCE = {r"\bigl": 6.0, r"\Bigl": 9.0, r"\biggl": 12.0, r"\Biggl": 15.0}
"""Half of the height of a bracket, which stands about the axis."""
_SCRIPT, _RAISED, _LOWERED = 0.72, 3.6, 2.5
SIZES = ((19.0, "big"), (26.0, "Big"), (33.0, "bigg"), (float("inf"), "Bigg"))
"""Height of the content up to which a bracket is large enough: what sticks out by a few points looks right."""
_TFRAC_SHIFTS, _FRAC_SHIFTS = (3.9, 3.45), (6.8, 6.9)
_CLEARANCE = {True: 3 * RULE, False: RULE}


def extent(tex: str) -> Extent:
    """Height and depth of a formula in display style."""
    return _Reader(_TOKEN.findall(tex)).row()


def size_around(tex: str) -> str:
    r"""The size of the brackets around a content: big, Big, bigg or Bigg; Big at least around what is built up."""
    above, below = extent(tex)
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

    def row(self, closing: str | None = None) -> Extent:
        """Extent of the tokens up to the closing one, or to the end, side by side."""
        above = below = 0.0
        while self.at < len(self.tokens):
            if self.tokens[self.at] == closing:
                self.at += 1
                break
            up, down = self.item()
            above, below = max(above, up), max(below, down)
        return above, below

    def argument(self) -> Extent:
        """Extent of a TeX argument: a group in braces, or the next item."""
        if self.at < len(self.tokens) and self.tokens[self.at] == "{":
            self.at += 1
            return self.row("}")
        return self.item()

    def item(self) -> Extent:
        """Extent of the next item: a letter, group, fraction, root, script or fence."""
        token = self.tokens[self.at]
        self.at += 1
        if token == "{":
            return self.row("}")
        if token in (r"\frac", r"\tfrac"):
            return self.fraction(display=token == r"\frac")
        if token == r"\sqrt":
            return self.root()
        if token in ("^", "_"):
            up, down = self.argument()
            return (_RAISED + _SCRIPT * up, 0.0) if token == "^" else (0.0, _LOWERED + _SCRIPT * down)
        if token in _FENCE:
            self.at += 1
            return AXIS + _FENCE[token], _FENCE[token] - AXIS
        if token[0] == "\\" and not token[1:].isalpha() and token != r"\{":  # space
            return 0.0, 0.0
        return _TALL.get(token, LETTER)

    def fraction(self, *, display: bool) -> Extent:
        """Extent of a fraction after its command, in display size or in that of scripts."""
        scale, (raised, lowered) = (1.0, _FRAC_SHIFTS) if display else (_SCRIPT, _TFRAC_SHIFTS)
        (top, under), (over, bottom) = self.argument(), self.argument()
        clear = AXIS + RULE / 2 + _CLEARANCE[display]
        raised = max(raised, clear + scale * under)
        lowered = max(lowered, _CLEARANCE[display] + RULE / 2 - AXIS + scale * over)
        return raised + scale * top, lowered + scale * bottom

    def root(self) -> Extent:
        """Extent of a root after its command, whose index is skipped."""
        if self.at < len(self.tokens) and self.tokens[self.at] == "[":
            self.at = self.tokens.index("]", self.at) + 1
        up, down = self.argument()
        return up + 2.9, down + 0.5
