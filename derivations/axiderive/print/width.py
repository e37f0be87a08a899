"""How wide a printed formula will be, in points at 10 pt: good to a few per cent, enough to decide on line breaks."""

from __future__ import annotations

import re

_TOKEN = re.compile(r"\\[A-Za-z]+|\\.|\d|[^\s]")
# measured with mathpazo
_WIDE = {
    "=": 13.4, r"\to": 15.6, "+": 12.3, "-": 12.3, "(": 4.3, ")": 4.3, "[": 4.3, "]": 4.3, ",": 4.3, ";": 4.3, "/": 5.0,
    r"\,": 1.7, r"\;": 2.8, r"\quad": 10.0, r"\qquad": 20.0, r"\pi": 7.3, r"\psi": 6.8, r"\varphi": 6.7,
    "R": 7.1, "E": 6.2, "F": 5.6, "A": 7.6, "H": 8.4, r"\int": 10.0, r"\sum": 16.0,
    r"\Bigl": 1.9, r"\Bigr": 1.9, r"\bigl": 0.5, r"\bigr": 0.5,
    r"\biggl": 3.1, r"\biggr": 3.1, r"\Biggl": 4.3, r"\Biggr": 4.3,
}  # fmt: skip
_FUNCTION = {
    r"\sin": 3, r"\cos": 3, r"\tan": 3, r"\ln": 2, r"\exp": 3, r"\sinh": 4,
    r"\arcsin": 6, r"\arccos": 6, r"\arctan": 6,
}  # fmt: skip
_SILENT = {
    r"\displaystyle",
    r"\mathrm",
    r"\mathbf",
    r"\operatorname",
    r"\left",
    r"\right",
    r"\text",
    "&",
    r"\!",
    "{",
    "}",
}
_SCRIPT = 0.72


def width(tex: str) -> float:
    """Width in points."""
    return _Reader(_TOKEN.findall(tex)).row()


class _Reader:
    def __init__(self, tokens: list[str]) -> None:
        self.tokens, self.at = tokens, 0

    def row(self, closing: str | None = None) -> float:
        """Width in points of the tokens up to the closing one, or to the end."""
        total = 0.0
        while self.at < len(self.tokens):
            token = self.tokens[self.at]
            if token == closing:
                self.at += 1
                return total
            total += self.item()
        return total

    def argument(self) -> float:
        """Width in points of a TeX argument: a group in braces, or the next item."""
        if self.at < len(self.tokens) and self.tokens[self.at] == "{":
            self.at += 1
            return self.row("}")
        return self.item()

    def item(self) -> float:
        """Width in points of the next item: a letter, group, fraction, root, scripts or function."""
        token = self.tokens[self.at]
        self.at += 1
        if token == "{":
            return self.row("}")
        if token in (r"\frac", r"\tfrac"):
            return 2.4 + max(self.argument(), self.argument()) * (_SCRIPT if token == r"\tfrac" else 1.0)
        if token == r"\sqrt":
            if self.at < len(self.tokens) and self.tokens[self.at] == "[":
                while self.tokens[self.at] != "]":
                    self.at += 1
                self.at += 1
            return 9.5 + self.argument()
        if token in "^_":
            first = _SCRIPT * self.argument()
            if self.at < len(self.tokens) and self.tokens[self.at] in "^_" and self.tokens[self.at] != token:
                self.at += 1
                return max(first, _SCRIPT * self.argument())
            return first
        if token in _FUNCTION:
            return 5.2 * _FUNCTION[token] + 2.0
        if token in _SILENT:
            return 0.0
        return _WIDE.get(token, 5.1)
