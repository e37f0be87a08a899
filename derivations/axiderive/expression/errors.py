"""What is wrong with an expression, and where in its text."""

from __future__ import annotations

from ..exits import USAGE, CommandError


class ExpressionError(CommandError):
    """The value, the rule and the next step; `position` counts characters of the expression from 0."""

    code = USAGE

    def __init__(self, message: str, text: str = "", position: int | None = None, length: int = 1) -> None:
        self.plain, self.position = message, position
        shown = message
        if position is not None:
            line = "".join(c if c.isprintable() else " " for c in text)
            start = max(0, position - 60)
            shown += f"\n  {line[start : start + 100]}\n  {' ' * (position - start)}{'^' * max(1, min(length, 40))}"
        super().__init__(shown)
