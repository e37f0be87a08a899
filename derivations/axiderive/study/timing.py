"""Paired timings: two calls in turn, of which only the ratio is kept, because times belong to a machine."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any

Call = Callable[[], Any]
SHORTEST, LONGEST = 4e-3, 0.1
"""Seconds that one timing takes at least, shorter calls are repeated; longer ones are timed three times."""


def paired(call: Call, beside: Call, rounds: int) -> float:
    """Median over `rounds` of the processor time of `call` over that of `beside`, which runs right before it."""
    first = [_first(beside), _first(call)]
    counts = [max(1, int(SHORTEST / max(once, 1e-7))) if rounds > 1 else 1 for once in first]
    rounds = min(rounds, 3) if max(first) > LONGEST else rounds
    ratios = []
    for _ in range(rounds):
        own = seconds(beside, counts[0])
        ratios.append(seconds(call, counts[1]) / own)
    return statistics.median(ratios)


def _first(call: Call) -> float:
    """The shorter of two timings, as the first may fill caches; of a long one the first."""
    once = seconds(call)
    return once if once > LONGEST else min(once, seconds(call))


def seconds(call: Call, repeats: int = 1) -> float:
    """Processor time of a call, the mean of `repeats`."""
    start = time.process_time()
    for _ in range(repeats):
        call()
    return (time.process_time() - start) / repeats
