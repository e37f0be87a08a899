"""The home page: a picture of every profile with what it stands for, by the questions that lead to it."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from ..book.evidence import LEFT_OUT
from ..book.guide import TITLE, cited
from ..book.word_index import WORDS
from ..figures.svg import svg
from ..physics.systems import SYSTEMS

KINDS = {
    "Pointed": "pointed", "Round": "round", "Flatter than round": "round", "Flat": "flat",
    "Edge of contact fixed": "flat", "Long": "long", "Pressure known": "load",
}  # fmt: skip
"""Kind of the bodies that answer a question of the chart."""
FILTERS = {
    "pointed": "pointed", "round": "round", "flat": "flat", "worn": "worn or blunt", "long": "long: plane contact",
    "load": "pressure known",
}  # fmt: skip
"""What the buttons say."""
SMALL = 20.0
"""SVG units to one unit of the outline that the front of the book draws."""
NONE = "–"
"""Status of a physics that has no meaning for a profile."""
_WORN = re.compile(r"worn|blunt")


def home(front: Mapping[str, Any], models: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Groups of pictures, the filters that leave some of them, and the tips that are known by a name."""
    groups = [
        {**group, "cards": [_card(one, KINDS[group["question"]], models) for line in group["lines"] for one in line]}
        for group in front["chart"]
    ]
    shown = {kind for group in groups for card in group["cards"] for kind in card["kinds"]}
    filters = {kind: words for kind, words in FILTERS.items() if kind in shown}
    return {"groups": groups, "filters": filters, "presets": _presets(front["tips"][0], models)} | {
        "citation": (TITLE, cited(front["version"], front["edition"]))
    }


def _card(one: Mapping[str, Any], kind: str, models: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    status = models[one["name"]]["status"]
    kinds = [kind, "worn"] if _WORN.search(one["words"]) else [kind]
    others = sorted((s for s in SYSTEMS if s.said.button), key=lambda s: s.medium.graded)
    physics = [(s.name, s.said.button) for s in others if status.get(s.name, LEFT_OUT) not in (LEFT_OUT, NONE)]
    return {**one, "picture": svg(one["shape"], SMALL), "kinds": kinds, "physics": physics}


def _presets(tip: tuple[str, str, str, str], models: Mapping[str, Mapping[str, Any]]) -> list[tuple[str, str]]:
    """Name of a tip, and the entries for it."""
    name, half, inclination, _ = tip
    blunted = [i for i in WORDS["Berkovich indenter, blunted"].split() if i in models]
    return [
        (name, rf"the \hyperref[sec:cone]{{cone}} of the same area, half-angle {half}°, $\theta={inclination}$°"),
        ("Berkovich, blunted", ", ".join(rf"\hyperref[sec:{i}]{{{models[i]['title']}}}" for i in blunted)),
    ]
