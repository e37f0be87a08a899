"""The tokens of a printed formula, without what only lays it out."""

from __future__ import annotations

import re

_LAYOUT = re.compile(
    r"\\begin\{aligned\}(?:\[t\])?|\\end\{aligned\}|\\[,;:! ]|\\(?:displaystyle|allowbreak)(?![A-Za-z])"
    r"|\\[bB]igg?[lrm]?(?=\s*(?:[()\[\]/]|\\[{}]|\\[lr]?vert(?![a-z])))"
    r"|\\\\(?:\[[^\]]*\])?|\\enspace|\{\}|~|&"
)
_TOKEN = re.compile(r"\\[A-Za-z]+|\\[{}]|\d+(?:\.\d+)?|\S")
SEPARATORS = (r"\quad", r"\qquad")


class Tokens:
    """A place in the tokens of a formula."""

    def __init__(self, tex: str) -> None:
        # an empty group carries the first index of {}_1F_1, which is none of the letter before it
        self.tokens, self.at = _TOKEN.findall(_LAYOUT.sub(" ", tex.replace("{}_", r"\prescript _"))), 0

    def peek(self) -> str | None:
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def comes(self, *wanted: str) -> bool:
        """Whether these tokens are the next ones."""
        return tuple(self.tokens[self.at : self.at + len(wanted)]) == wanted

    def message(self, wanted: str) -> str:
        return f"expected {wanted} at token {self.at} ({self.peek()}) of {' '.join(self.tokens)}"

    def take(self, wanted: str | None = None) -> str:
        token = self.peek()
        if token is None or (wanted is not None and token != wanted):
            raise SyntaxError(self.message(wanted or "more"))
        self.at += 1
        return token

    def separator(self) -> bool:
        """Skip `,` followed by a quad."""
        if self.peek() == "," and self.at + 1 < len(self.tokens) and self.tokens[self.at + 1] in SEPARATORS:
            self.at += 1
        found = False
        while self.peek() in SEPARATORS:
            self.at, found = self.at + 1, True
        return found

    def first_digit(self) -> None:
        """Of a number that is a TeX argument without braces only the first digit is taken."""
        token = self.peek() or ""
        if token[0:1].isdigit() and len(token) > 1:
            self.tokens[self.at : self.at + 1] = [token[0], token[1:]]

    def text(self) -> str:
        """A TeX argument as letters, without its font."""
        if self.peek() != "{":
            token = self.take()
            return self.text() if token in (r"\mathrm", r"\mathbf") else token.lstrip("\\")
        self.take("{")
        out = ""
        while self.peek() != "}":
            out += self.text() if self.peek() in ("{", r"\mathrm", r"\mathbf") else self.take().lstrip("\\")
        self.take("}")
        return out
