"""Complete contacts beside the normal contact: modules that say why they hold no functions."""

from __future__ import annotations

from ...physics.medium import GRADED
from ...profiles.profile import Profile
from ..physics import text
from ..physics.refusals import REFUSAL, reason

TANGENTIAL = (
    "{title} is a complete contact and knows no partial slip; it slips as a whole at F_x = mu F,"
    " with F from axicontact.graded.normal.{name}.force"
)


def module_source(profile: Profile, group: str) -> str:
    """A module whose functions do not exist, and which says why."""
    lines = text.wrapped(reason(profile, group, GRADED, TANGENTIAL))
    literal = "\n".join(f'    "{line}{" " if line is not lines[-1] else ""}"' for line in lines)
    return REFUSAL.format(title=profile.title, group=group, wrapped="\n".join(lines) + ".", literal=literal)
