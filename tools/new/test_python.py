"""Tests of @NAME@.c that need more than the expectations of its scenario."""

from pathlib import Path

import oncard

SCENARIO = str(Path(__file__).with_name("@NAME@.toml"))


def test_the_axis_never_goes_back():
    run = oncard.run(SCENARIO, trace=True)
    assert run.passed, run.failures
    position = run.trace["axis1.prfPos"]
    assert (position[1:] >= position[:-1]).all()


def test_the_axis_is_half_way_in_the_middle_of_the_move():
    with oncard.Session(SCENARIO) as card:
        card.forward("time", ms=600.25)
        assert card.value("axis1.prfPos") == 25000
