"""What is to be composed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from ..expression.profile import OwnProfile
from ..profiles.profile import Profile


@dataclass(frozen=True)
class Request:
    """What is to be composed."""

    title: str
    module: str
    profile: Profile | None
    own: OwnProfile | None
    physics: str
    quantities: Sequence[str]
    values: Mapping[str, float] = field(default_factory=dict)
    formats: Sequence[str] = ("python", "tex", "json")
    at: tuple[str, float] | None = None
    """Name and value of what the worked example is given at: a, d or F."""
    scene: str = ""
    """Text of the scene, copied into the folder."""
