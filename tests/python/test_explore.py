"""Explorations are those of the command `oncard explore`."""

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import command
from test_run import scenarios

import oncard
from oncard import var

# Each of two threads adds 1, in two statements: an addition can be lost.
COUNT = """int count;
int t0() { int copy; copy = count; count = copy + 1; }
int t1() { int copy; copy = count; count = copy + 1; }
"""
SCENARIO = {
    "program": "count.c",
    "thread": [{"thread": 0, "function": "t0"}, {"thread": 1, "function": "t1"}],
}


def explore(**arguments):
    return oncard.explore(SCENARIO, files={"count.c": COUNT}, **arguments)


@pytest.mark.parametrize("path", scenarios("explore"))
def test_a_sample_has_the_verdict_of_the_command(samples, path):
    exploration = oncard.explore(path)
    assert exploration.verdict == command("explore", path)["verdict"]


def test_requirements_are_texts_or_expressions(samples):
    proof = oncard.explore("26_lost_update/lost.toml", final=["sum == 10"],
                           always=[var("sum") < 100])
    assert proof.verdict == "FAILED"
    assert "always: sum < 100" in proof.text and "sum is 3, expected 10" in proof.text
    assert explore(final="count >= 1").verdict == "PROVED"
    assert explore(final=var("count") == 2).verdict == "FAILED"
    assert explore(always=["count >= 0", var("count") <= 2], never="count == 3").verdict == "PROVED"
    assert explore(eventually=var("count") == 2).verdict == "FAILED"
    assert explore(races="none").verdict == "FAILED"


def test_responses_are_requirements():
    assert explore(leads="thread0.result == 0 -> count >= 1").verdict == "PROVED"
    lost = explore(leads=["count == 1 -> count == 2"])
    assert lost.verdict == "FAILED" and "leads: count == 1 -> count == 2" in lost.text
    with pytest.raises(oncard.Error, match="->"):
        explore(leads="count == 1")


# The card sees input 1 after its filter of three cycles, at 2.5 ms. The program, which begins in
# the cycle of 0.25 ms, looks each millisecond, and so sees it at 3.25 ms.
LOOK = """int seen;
int look() { int inputs;
again: GT_Delay(1); GT_GetDi(4, &inputs); inputs = inputs & 1; if (inputs) goto found; goto again;
found: seen = 1; return 0; }
"""
PRESSED = {
    "program": "look.c",
    "until_ms": 10,
    "thread": [{"thread": 0, "function": "look"}],
    "world": {"input": [{"index": 1, "value": 1, "at_ms": 1.75}]},
}


@pytest.mark.parametrize("ms, verdict", [(1, "PROVED"), (0.5, "FAILED")])
def test_a_response_has_a_time(ms, verdict):
    within = {"after": var("gpi[1]") == 1, "then": "seen == 1", "ms": ms}
    files = {"look.c": LOOK}
    assert oncard.explore(PRESSED, files=files, within=within).verdict == verdict
    assert oncard.explore(PRESSED, files=files, within=[within, within]).verdict == verdict


def test_a_response_without_a_time_is_refused():
    with pytest.raises(oncard.Error, match="'within' has dicts"):
        explore(within={"after": "count == 1", "then": "count == 2"})
    with pytest.raises(oncard.Error, match="'ms' must be a number"):
        explore(within={"after": "count == 1", "then": "count == 2", "ms": "5"})


def test_what_is_open_in_a_scenario_is_tried():
    open_instant = {"index": 1, "value": "any", "between_ms": [2, 3]}
    scenario = {**PRESSED, "world": {"input": [open_instant]}, "expect": ["seen == 1 @ 10ms"]}
    exploration = oncard.explore(scenario, files={"look.c": LOOK})
    assert exploration.verdict == "FAILED"
    assert "choice: gpi[1] = 0 at 2 ms" in exploration.text


def test_comments_are_requirements():
    text = "//@ final: count == 2\n" + COUNT
    assert oncard.explore("count.c", files={"count.c": text}).verdict == "FAILED"
    program = oncard.compile("count.c", files={"count.c": text})
    assert oncard.explore(program).verdict == "FAILED"


def test_a_failing_schedule_can_be_run_and_driven():
    proof = explore(final="count == 2")
    files = {"lost.schedule": proof.schedule, "count.c": COUNT}
    run = oncard.run("lost.schedule", files=files)
    assert run.values == {"count": 1}
    with oncard.Session("lost.schedule", files=files) as card:
        assert card.forward().reason in ("end", "schedule-end")
        assert card.value("count") == 1
    assert explore(final="count >= 1").schedule is None


def test_reports_are_those_of_the_command(samples):
    proof = oncard.explore("26_lost_update/lost.toml", engine="stateful")
    assert proof.report == command("explore", "26_lost_update/lost.toml", "--engine=stateful")
    assert len(proof.full_text) > len(proof.text)
    assert proof._repr_html_().startswith("<iframe srcdoc=\"&lt;!DOCTYPE")
    assert proof.html.startswith("<!DOCTYPE")
    oncard.set_language("zh")
    assert not proof.text.isascii() and proof.verdict == "FAILED"
    assert proof.warnings == []


def test_a_schedule_that_is_followed_is_a_file():
    scenario = {**SCENARIO, "final": ["count == 2"], "explore": {"follow": "lost.schedule"}}
    files = {"count.c": COUNT, "lost.schedule": explore(final="count == 2").schedule}
    assert oncard.explore(scenario, files=files).verdict == "FAILED"
    files["lost.schedule"] = "no schedule"
    with pytest.raises(oncard.Error, match="^lost.schedule: ") as caught:
        oncard.explore(scenario, files=files)
    assert caught.value.message_zh.startswith("lost.schedule：")


def test_a_search_that_is_cut_is_incomplete():
    assert explore(engine="dpor", max_executions=1, final="count >= 1").verdict == "INCOMPLETE"


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"always": [lambda: True]}, "not a function of Python.*always=\\['sum < 100'\\]"),
        ({"always": lambda: True}, "not a function of Python"),
        ({"final": True}, "not True"),
        ({"final": ["count =="]}, "'final: count =='"),
        ({"final": ["cuont == 2"]}, "cuont"),
        ({"engine": "fast"}, "use auto, dpor, stateful"),
        ({"races": "all"}, "use any, benign, none"),
        ({"runs": 5}, "'runs' has no effect with the engine auto"),
        ({"engine": "pct", "depth": 0}, "'depth' must be from 1 to"),
        ({"engine": "dpor", "merge_private": True}, "'merge_private' has no effect"),
        ({"engine": "dpor", "merge_private": False}, "'merge_private' has no effect"),
        ({"max_states": 4_000_000_001}, "'max_states' must be from 1 to 4000000000, not 4000000001"),
        ({"max_states": 1.5}, "'max_states' must be a whole number, not 1.5"),
        ({"seconds": -1}, "'seconds' must be a number from 0"),
        ({"memory_mib": -1}, "'memory_mib' must be a number from 0"),
        ({"silent": "nix"}, "'nix' is no warning about the card"),
    ],
)
def test_bad_arguments_are_errors(arguments, message):
    with pytest.raises(oncard.Error, match=message) as caught:
        explore(**arguments)
    assert not caught.value.message_zh.isascii()


# More schedules than any computer can try: three threads that count to a thousand.
LONG = {
    "long.c": """int count;
int count_up() { int i; int c; int copy;
  i = 0;
lbl: copy = count; count = copy + 1; i = i + 1;
  c = i < 1000; if (c) goto lbl;
}
"""
}
LONG_SCENARIO = {
    "program": "long.c",
    "thread": [{"thread": i, "function": "count_up", "page": i} for i in range(3)],
    "final": ["count >= 0"],
}
ENDLESS = {"endless.c": "int i;\nint main()\n{\n  lbl: i = i + 1;\n  goto lbl;\n}\n"}
ENDLESS_SCENARIO = {"program": "endless.c", "limit_ms": 1_000_000_000}


def test_limits_end_a_search():
    for limit in ({"seconds": 0.3}, {"memory_mib": 1}):
        proof = oncard.explore(LONG_SCENARIO, files=LONG, **limit)
        assert proof.verdict == "INCOMPLETE"


def after_ctrl_c(call, text):
    """What a process prints that hears Ctrl-C during a call: the text, an expression."""
    script = f"""
import os, signal, sys, threading
sys.path.insert(0, {str(Path(__file__).parent)!r})
import oncard
from test_explore import *
card = oncard.Session(ENDLESS_SCENARIO, files=ENDLESS)
threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    {call}
except KeyboardInterrupt:
    print({text})
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60)
    return done.stdout + done.stderr


@pytest.mark.parametrize(
    "call",
    [
        "oncard.explore(LONG_SCENARIO, files=LONG)",
        "oncard.run(ENDLESS_SCENARIO, files=ENDLESS)",
        "card.forward()",
    ],
)
def test_ctrl_c_ends_what_takes_long(call):
    assert after_ctrl_c(call, "'interrupted'") == "interrupted\n"


def test_after_ctrl_c_a_session_says_where_it_is():
    here = "card.moment > 0 and card.state == card.request('state')"
    assert after_ctrl_c("card.forward()", here) == "True\n"
