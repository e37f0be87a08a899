"""The evaluation forms that are frozen: each is one of a function, and changes its text."""

from __future__ import annotations

import pytest

from axiderive.code.systems import alone
from axiderive.physics.systems import problem
from axiderive.stable.slopes import RATE
from axiderive.stable.variants import CHOSEN


@pytest.mark.parametrize("key", list(CHOSEN))
def test_a_chosen_form_is_another_text_of_a_function(key: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A choice that changed nothing would be kept for nothing, and a mistyped key would go unnoticed."""
    name, _, suffix = key.rpartition(".")
    own, entries = problem(name), problem(name).derive()
    assert suffix in {*entries, RATE}
    before = alone(own.system, entries).source()
    monkeypatch.delitem(CHOSEN, key)
    assert alone(own.system, entries).source() != before
