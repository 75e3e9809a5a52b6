"""Drives @NAME@.c to the middle of its move and shows what the card does there."""

from pathlib import Path

import oncard

SCENARIO = str(Path(__file__).with_name("@NAME@.toml"))

with oncard.Session(SCENARIO) as card:
    card.forward("time", ms=600.25)
    print(card.time_ms, "ms:", card.value("axis1.prfPos"), "pulses,", card.value("axis1.prfVel"), "pulse/ms")
