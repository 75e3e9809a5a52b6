"""Programs are compiled and run as by the command `oncard`."""

import os
import pickle
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy
import pytest
from conftest import SAMPLES, command

import oncard
from oncard import _oncard

SUM = "int sum;\nint main()\n{\n  sum = 3;\n}\n"


def scenarios(kind):
    """The samples that a test treats in this way."""
    return sorted(
        str(path.relative_to(SAMPLES))
        for path in SAMPLES.glob("*/*.toml")
        if _oncard.test_kind(os.fsencode(path), {})[0] == kind
    )


@pytest.mark.parametrize("path", scenarios("run"))
def test_a_sample_has_the_result_of_the_command(samples, path):
    run = oncard.run(path)
    assert run.result == command("run", path)
    assert run.passed and run.hash == run.result["state_hash"]


def test_results_are_attributes(samples):
    run = oncard.run("01_sum/two_threads.toml")
    # 1 + 2 + ... + 100 (GTS manual, example 10-2).
    assert (run.passed, run.values, run.failures, run.end) == (True, {"sum": 5050}, [], "quiet")
    assert [thread["function"] for thread in run.threads] == ["add", "add"]
    assert run.statements == 508 and run.end_ms == 5.25
    assert oncard.run("01_sum/two_threads.toml", show=["thread0.result"]).values.keys() == {
        "thread0.result"
    }


def test_a_run_that_fails_is_a_result():
    scenario = {"program": "a.c", "expect": ["sum == 4"]}
    run = oncard.run(scenario, files={"a.c": SUM})
    assert not run.passed
    assert str(run.failures[0]) == "sum == 4: sum is 3"
    oncard.set_language("zh")
    assert not run.failures[0].message.isascii()


def test_scenarios_are_files_dicts_or_given_by_content(in_folder):
    Path("a.c").write_text(SUM)
    Path("a.toml").write_text('program = "a.c"\nexpect = ["sum == 3"]\n')
    hashes = {
        oncard.run(main, files=files).hash
        for main, files in (
            ("a.toml", None),
            (Path("a.toml"), None),
            ({"program": Path("a.c")}, None),
            ({"program": "b.c"}, {"b.c": SUM}),
            ("b.toml", {"b.toml": 'program = "b.c"', Path("b.c"): SUM.encode()}),
            (oncard.compile("a.c"), None),
        )
    }
    assert len(hashes) == 1


def test_dicts_have_all_that_toml_has():
    scenario = {
        "program": "a.c",
        "globals": {"a": numpy.arange(3), "b": numpy.float64(1.5)},
        "thread": [{"thread": 0, "function": "main"}],
        "expect": [oncard.var("a[2]") == 2, "b == 1.5"],
        "until_ms": 5,
    }
    program = "int a[3];\ndouble b;\nint main()\n{\n  return 0;\n}\n"
    run = oncard.run(scenario, files={"a.c": program})
    assert run.failures == [] and run.end == "until" and run.end_ms == 5


def test_a_program_keeps_its_sources(in_folder):
    Path("a.c").write_text(SUM)
    program = oncard.compile("a.c")
    Path("a.c").write_text(SUM.replace("3", "4"))
    assert oncard.run(program).values == {"sum": 3}
    assert oncard.run("a.c").values == {"sum": 4}
    assert program.path == "a.c" and program.diagnostics == []


def test_objects_are_those_of_the_command(in_folder):
    Path("a.c").write_text(SUM)
    program = oncard.compile("a.c")
    bin_path, ini_path = program.write(in_folder)
    assert Path(bin_path).read_bytes() == program.bin
    assert Path(ini_path).read_bytes() == program.ini
    assert oncard.run("a.bin").hash == oncard.run("a.c").hash
    assert os.spawnl(os.P_WAIT, os.environ["ONCARD"], "oncard", "build", "a.c") == 0
    assert Path("a.bin").read_bytes() == program.bin


def test_names_of_files_need_not_be_utf8(in_folder):
    folder = in_folder / os.fsdecode(b"\xff")
    folder.mkdir()
    (folder / "a.c").write_text(SUM)
    program = oncard.compile(folder / "a.c")
    assert program.path == str(folder / "a.c")
    written = program.write(folder)
    assert written == (str(folder / "a.bin"), str(folder / "a.ini"))
    assert all(Path(path).exists() for path in written)


def test_mistakes_of_a_program_are_diagnostics():
    with pytest.raises(oncard.CompileError) as caught:
        oncard.compile("a.c", files={"a.c": "int main()\n{\n  x = 1;\n}\n"})
    mistake = caught.value.diagnostics[0]
    assert (mistake.code, mistake.severity, mistake.file) == ("MP027", "error", "a.c")
    assert (mistake.line, mistake.column) == (3, 3)
    assert str(mistake).startswith("a.c:3:3: error MP027: 'x' is not declared")
    assert "1 error" in str(caught.value)
    for call in (oncard.run, oncard.explore, oncard.Session):
        with pytest.raises(oncard.CompileError):
            call("a.c", files={"a.c": "int main()\n{\n  x = 1;\n}\n"})
    copy = pickle.loads(pickle.dumps(caught.value))
    assert copy.diagnostics == caught.value.diagnostics and str(copy) == str(caught.value)


def test_a_recording_is_replayed(samples, tmp_path):
    path = str(tmp_path / "r.schedule")
    scenario = "01_sum/two_threads.toml"
    recorded = command("run", scenario, "--record", path)
    assert oncard.run(path).hash == recorded["state_hash"]


def test_refused_commands_fail_if_that_is_wanted():
    # The card has eight axes.
    files = {"a.c": "int main()\n{\n  GT_AxisOn(9);\n}\n"}
    assert oncard.run("a.c", files=files).passed
    assert len(oncard.run("a.c", files=files).warnings) == 1
    assert not oncard.run("a.c", files=files, strict_commands=True).passed


# --- Traces --------------------------------------------------------------------------------------


def test_a_trace_has_the_values_of_the_file(samples, tmp_path):
    run = oncard.run("10_trap/trap.toml", trace=True)
    names = ["time_ms", "axis1.prfPos", "axis1.prfVel", "axis1.prfAcc", "axis1.moving"]
    assert list(run.trace) == names and len(run.trace) == len(names)
    run.trace.write(tmp_path / "t.csv")
    table = numpy.genfromtxt(tmp_path / "t.csv", delimiter=",", names=True, deletechars="")
    for name in names:
        assert numpy.array_equal(run.trace[name], table[name])
    # 50 pulse/ms is reached after 200 ms and 25 ms of smoothing, from 0.25 ms on (example 7-1).
    at = numpy.searchsorted(run.trace["time_ms"], 225.25)
    assert run.trace["axis1.prfPos"][at] == pytest.approx(5625)
    assert run.trace["axis1.prfVel"].max() == pytest.approx(50)


def test_a_trace_has_the_values_that_are_named(samples):
    run = oncard.run("10_trap/trap.toml", trace=["axis1.encPos"])
    assert list(run.trace) == ["time_ms", "axis1.encPos"]
    with pytest.raises(KeyError, match=r"no 'axis1.prfPos'; it has: time_ms, axis1.encPos"):
        run.trace["axis1.prfPos"]
    assert "axis1.prfPos" not in run.trace
    with pytest.raises(oncard.Error, match="'axis1.prfPoz'"):
        oncard.run("10_trap/trap.toml", trace="axis1.prfPoz")
    with pytest.raises(oncard.Error, match="trace=True"):
        oncard.run("10_trap/trap.toml").trace


def test_a_trace_is_a_dataframe(samples):
    pandas = pytest.importorskip("pandas", reason="there is no pandas: python3-pandas")
    frame = oncard.run("10_trap/trap.toml", trace=True).dataframe()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame.columns)[:2] == ["time_ms", "axis1.prfPos"]


def test_notebooks_show_tables_and_pictures(samples, tmp_path, monkeypatch):
    run = oncard.run("10_trap/trap.toml", trace=True)
    assert "<th>trap.acc</th><td>0.25</td>" in run._repr_html_()
    assert "<svg" in run._repr_svg_() and run.trace._repr_svg_() == run._repr_svg_()
    assert oncard.run("10_trap/trap.toml")._repr_svg_() is None
    run.trace.plot(tmp_path / "p.png")
    assert (tmp_path / "p.png").read_bytes().startswith(b"\x89PNG")
    monkeypatch.setenv("PATH", "")
    assert run._repr_svg_() is None
    with pytest.raises(oncard.Error, match="apt-get install gnuplot-nox"):
        run.trace.plot(tmp_path / "p.svg")


def test_html_is_escaped():
    run = oncard.run(
        {"program": "a.c", "expect": ["sum < 1"]}, files={"a.c": SUM}
    )
    assert "sum &lt; 1" in run._repr_html_()


# --- Bad input -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "main, files, message",
    [
        ("none.toml", None, "cannot open 'none.toml'"),
        ({"program": "none.c"}, None, "cannot open 'none.c'"),
        ({"progam": "a.c"}, {"a.c": SUM}, "unknown key 'progam'; did you mean 'program'"),
        ({"program": "a.c", "rate": "fast"}, {"a.c": SUM}, "'rate'"),
        ({"program": "a.c", "globals": {"x": None}}, {"a.c": SUM}, "'globals.x'.*cannot be None"),
        ({"program": "a.c", "expect": [lambda: True]}, {"a.c": SUM}, "not a function of Python"),
        ({3: "a.c"}, {"a.c": SUM}, "keys of a scenario are texts, not 3"),
        (3, None, "3 is neither a file nor a scenario"),
        ("a\0.toml", None, "is no name of a file"),
        ("", None, "is no name of a file"),
        ("a.c", {"a.c": 3}, "must be a text, not 3"),
        ("a.c", [SUM], "'files' must be a dict"),
        ("a.c", {3: 4}, "3 is neither a file nor a scenario"),
        ("a.c", {"a.c": "// \ud800"}, r"'a.c' has '\\ud800', which is no character of UTF-8"),
        ("\ud800.c", None, "is no name of a file"),
        ({"program": Path(os.fsdecode(b"\xff.c"))}, None, r"'<dict>.toml' has '\\udcff'"),
        ("a.calls", {"a.calls": ""}, "record of host calls"),
    ],
)
def test_bad_input_is_an_error_that_says_what_to_do(main, files, message):
    with pytest.raises(oncard.Error, match=message) as caught:
        oncard.run(main, files=files)
    assert not caught.value.message_zh.isascii()
    oncard.set_language("zh")
    assert str(caught.value) == caught.value.message_zh


def test_bad_names_are_errors(samples):
    run = oncard.run("10_trap/trap.toml", trace=True)
    for call, message in (
        (lambda: oncard.run("10_trap/trap.toml", show=["nix"]), "nix"),
        (lambda: oncard.run("10_trap/trap.toml", show=[3]), "'show' must be texts, not 3"),
        (lambda: oncard.run("10_trap/trap.toml", show=3), "'show' must be texts, not 3"),
        (lambda: oncard.run("10_trap/trap.toml", show="\ud800"), "'show' has"),
        (lambda: oncard.run("10_trap/trap.toml", silent=["nix"]), "there are: drive-off"),
        (lambda: oncard.set_language("de"), "use 'en' or 'zh'"),
        (lambda: run.trace.write("t.txt"), "must end in .csv, .vcd, .json or .gnuplot"),
        (lambda: run.trace.plot("t.txt"), "must end in .svg or .png"),
        (lambda: run.trace.write("none/t.csv"), "none/t.csv"),
        (lambda: run.trace.plot("none/t.svg"), "cannot write 'none/t.svg'"),
    ):
        with pytest.raises(oncard.Error, match=message):
            call()


def test_packages_that_are_missing_are_named(samples):
    script = """
import sys
sys.modules["numpy"] = sys.modules["tomli_w"] = sys.modules["pandas"] = None
import oncard
for call in (lambda: oncard.run("10_trap/trap.toml", trace=True).trace,
             lambda: oncard.run({"program": "a.c"})):
    try:
        call()
    except oncard.Error as error:
        print(error.message_en)
"""
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert done.stdout == (
        "traces need numpy: apt-get install python3-numpy\n"
        "scenarios as dicts need tomli-w: apt-get install python3-tomli-w\n"
    ), done.stderr


# --- Threads -------------------------------------------------------------------------------------

ENDLESS = "int i;\nint main()\n{\n  lbl: i = i + 1;\n  goto lbl;\n}\n"


def test_other_threads_go_on_during_a_run():
    scenario = {"program": "a.c", "limit_ms": 60000, "rate": 1000}
    runs = []
    worker = threading.Thread(target=lambda: runs.append(oncard.run(scenario, files={"a.c": ENDLESS})))
    worker.start()
    count = 0
    while worker.is_alive():
        count += 1
        time.sleep(0.001)
    assert runs[0].end == "time-limit" and count > 10


def test_runs_in_threads_have_the_same_result():
    scenario = {"program": "a.c", "until_ms": 100}
    hashes = []
    workers = [
        threading.Thread(
            target=lambda: hashes.append(oncard.run(scenario, files={"a.c": ENDLESS}).hash)
        )
        for _ in range(4)
    ]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert len(hashes) == 4 and len(set(hashes)) == 1
