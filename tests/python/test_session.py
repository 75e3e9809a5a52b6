"""Sessions go forward and back, and are looked into and changed."""

import threading

import numpy
import pytest

import oncard
from oncard import var

FILES = {"a.c": "int v;\nint w;\nint main()\n{\n  int i;\n  v = 1;\n  i = v;\n  v = 2;\n  w = i;\n}\n"}


def test_a_session_drives_a_scenario(samples):
    with oncard.Session("10_trap/trap.toml") as card:
        stop = card.forward("time", ms=500)
        assert stop.reason == "goal" and card.time_ms == 500
        # 5625 pulses up to 225.25 ms, then 50 pulse/ms (example 7-1).
        assert card.value("axis1.prfPos") == pytest.approx(5625 + 50 * (500 - 225.25))
        assert card.back("cycle").reason == "goal" and card.time_ms == 499.75
        card.set_input("home", 1, 1)
        assert card.value("home[1]") == 0
        card.forward("time", ms=1)
        assert card.value("home[1]") == 1
        assert card.forward().reason == "end" and card.over == "until"
        assert card.hash != oncard.run("10_trap/trap.toml").hash


def test_a_whole_run_has_the_hash_of_a_run(samples):
    with oncard.Session("01_sum/two_threads.toml") as card:
        assert card.forward().reason == "end"
        assert card.hash == oncard.run("01_sum/two_threads.toml").hash


def test_values_are_read_and_written():
    with oncard.Session("a.c", files=FILES) as card:
        card.forward("statement", thread=0)
        assert card.value("v") == 1 and card.value("v == 1") is True
        assert card.value(var("v") > 1) is False
        card.write("v", 7)
        card.forward()
        assert card.value("w") == 7 and card.value("v") == 2
        assert card.back("change", name="v").reason == "goal" and card.value("v") == 7
        card.go_to(0)
        assert card.moment == 0 and card.value("v") == 0
        assert {item["name"] for item in card.variables()} >= {"v", "w"}
        assert card.card()["parts"]


def test_stops_end_a_walk():
    with oncard.Session("a.c", files=FILES) as card:
        lines = card.set_stops(lines=[{"line": 9}], conditions=[var("v") == 2])
        assert lines == [9]
        stop = card.forward()
        assert (stop.reason, stop.number) in (("condition", 0), ("line", 0))
        assert card.value("v") == 2


def test_threads_are_chosen(samples):
    with oncard.Session("26_lost_update/lost.toml") as card:
        card.step_thread(1)
        assert [thread["statements"] for thread in card.threads] == [0, 1]
        text = card.record()
        assert text.startswith("oncard-schedule")


def test_values_over_time_are_arrays(samples):
    with oncard.Session("10_trap/trap.toml") as card:
        card.forward("time", ms=500)
        least, largest = card.trace("axis1.prfPos", 0, 500, 5)["axis1.prfPos"]
        assert isinstance(least, numpy.ndarray) and least.shape == (5,)
        assert (numpy.diff(least) > 0).all() and largest[-1] == card.value("axis1.prfPos")


def test_a_walk_has_no_budget():
    endless = "int i;\nint main()\n{\n  lbl: i = i + 1;\n  goto lbl;\n}\n"
    scenario = {"program": "a.c", "until_ms": 300, "rate": 1000}
    with oncard.Session(scenario, files={"a.c": endless}) as card:
        card.forward("time", ms=250.25)
        assert card.time_ms == 250.25 and card.moment > 200_000
        assert card.forward().reason == "end" and card.time_ms == 300
        assert card.back().reason == "start" and card.moment == 0


def test_notebooks_show_the_threads():
    with oncard.Session("a.c", files=FILES) as card:
        assert "<th>thread 0 main</th>" in card._repr_html_()


def test_requests_of_several_threads_wait_for_each_other():
    with oncard.Session("a.c", files=FILES) as card:
        workers = [
            threading.Thread(target=lambda: [card.value("v") for _ in range(50)]) for _ in range(4)
        ]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()
        assert card.value("v") == 0


@pytest.mark.parametrize(
    "use, message",
    [
        (lambda card: card.forward("far"), "goal"),
        (lambda card: card.forward("time"), "ms"),
        (lambda card: card.value("nix"), "nix"),
        (lambda card: card.go_to(99), "the run has reached moment 0, not 99"),
        (lambda card: card.set_input("hom", 1, 1), "'hom' is no type of input"),
        (lambda card: card.write("v", float("nan")), "no number"),
        (lambda card: card.request("fly"), "there is no request 'fly'"),
        (lambda card: card.close() or card.value("v"), "the session is closed"),
    ],
)
def test_bad_requests_are_errors_in_both_languages(use, message):
    card = oncard.Session("a.c", files=FILES)
    with pytest.raises(oncard.Error, match=message) as caught:
        use(card)
    assert not caught.value.message_zh.isascii()
    assert caught.value.message_en.isascii()
    oncard.set_language("zh")
    assert str(caught.value) == caught.value.message_zh


def test_files_of_a_session_are_utf8():
    with pytest.raises(oncard.Error, match="'a.c' is not UTF-8"):
        oncard.Session("a.c", files={"a.c": b"int v; // \xff\n"})
