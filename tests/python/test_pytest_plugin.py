"""Scenarios are tests of pytest."""

import os
import shutil

import pytest
from conftest import SAMPLES
from test_explore import LONG

from oncard import pytest_plugin

PROGRAM = "int sum;\nint main()\n{\n  sum = 3;\n}\n"


@pytest.fixture
def project(pytester, monkeypatch):
    """A project with scenarios in the folder `cards`."""
    pytester.makeini("[pytest]\noncard_scenarios = cards\n")
    cards = pytester.mkdir("cards")
    (cards / "sum.c").write_text(PROGRAM)
    monkeypatch.setenv("ONCARD_LANG", "en")
    return cards


def run(pytester, *arguments):
    """In a process of its own, with the plugin as an installed package has it."""
    return pytester.runpytest_subprocess("-p", "oncard.pytest_plugin", *arguments)


def test_each_scenario_is_a_test(pytester, project):
    (project / "good.toml").write_text('program = "sum.c"\nexpect = ["sum == 3"]\n')
    (project / "bad.toml").write_text('program = "sum.c"\nexpect = ["sum == 4"]\n')
    (project / "idle.toml").write_text('program = "sum.c"\n')
    pytester.makefile(".toml", other='[tool]\nname = "no scenario"\n')
    result = run(pytester, "-rs")
    result.assert_outcomes(passed=1, failed=1, skipped=1)
    result.stdout.fnmatch_lines(["*checks nothing: it has no expectation and no requirement*"])
    result.stdout.fnmatch_lines(["*sum == 4: sum is 3*"])
    assert "Traceback" not in result.stdout.str()


def test_scenarios_of_the_explorer_are_explored(pytester, project):
    for name in ("bounds.toml", "lost.toml", "sum.c"):
        shutil.copy(SAMPLES / "26_lost_update" / name, project)
    wrong = (project / "lost.toml").read_text().replace('"FAILED"', '"PROVED"')
    (project / "wrong.toml").write_text(wrong)
    result = run(pytester)
    result.assert_outcomes(passed=2, failed=1)
    result.stdout.fnmatch_lines(["the verdict should be PROVED:", "*sum is 3, expected 10*"])


def test_a_search_that_is_cut_has_failed_whatever_is_expected(in_folder, monkeypatch):
    (in_folder / "long.c").write_text(LONG["long.c"])
    threads = "".join(
        f'[[thread]]\nthread = {i}\nfunction = "count_up"\npage = {i}\n' for i in range(3)
    )
    (in_folder / "long.toml").write_text(
        'program = "long.c"\nfinal = ["count >= 0"]\n'
        f'explore = {{ verdict = "INCOMPLETE" }}\n{threads}'
    )
    monkeypatch.setattr(pytest_plugin, "_SECONDS", 0.3)
    with pytest.raises(pytest_plugin.ScenarioFailed, match="its limit of 0.3 s"):
        pytest_plugin._test_schedules("long.toml", "INCOMPLETE")


def test_hosts_are_run_by_the_command_or_skipped(pytester, project, monkeypatch):
    (project / "fails.host.toml").write_text('host = { command = ["false"] }\n')
    (project / "none.host.toml").write_text('expect = ["axis1.prfPos == 0"]\n')
    result = run(pytester, "-rs")
    result.assert_outcomes(failed=1, skipped=1)
    result.stdout.fnmatch_lines(
        ["'false' ended with the exit code 1", "*it names no host program: add host =*"]
    )
    monkeypatch.delenv("ONCARD")
    monkeypatch.setenv("PATH", "/nowhere")
    result = run(pytester, "-rs")
    result.assert_outcomes(skipped=2)
    result.stdout.fnmatch_lines(["*run by the command oncard: put it into PATH*"])
    monkeypatch.setenv("ONCARD", "/nowhere/oncard")
    result = run(pytester)
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines(["/nowhere/oncard: No such file or directory"])


def test_mistakes_are_reported_as_they_are(pytester, project):
    (project / "bad.toml").write_text('program = "sum.c"\nexpct = []\n')
    (project / "missing.toml").write_text('program = "none.c"\n')
    result = run(pytester)
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines(["*unknown key 'expct'*", "*cannot open 'cards/none.c'*"])
    assert "Traceback" not in result.stdout.str()


def test_without_the_setting_there_are_no_tests(pytester, project):
    pytester.makeini("[pytest]\n")
    (project / "good.toml").write_text('program = "sum.c"\n')
    run(pytester).assert_outcomes()
