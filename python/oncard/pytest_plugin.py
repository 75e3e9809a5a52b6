"""Scenarios as tests of pytest.

The folders or files of `oncard_scenarios` in its ini file are searched for scenarios, and each is a
test: it is run, or explored if it says so. A scenario of a host program is left to the command
`oncard`, named by the environment variable ONCARD or found in PATH; without it the test is skipped.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import oncard
from oncard import _oncard
from oncard.errors import is_chinese


# The time that an exploration may take, as that of `oncard test`.
_SECONDS = 60.0


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addini(
        "oncard_scenarios", "folders with scenarios of oncard, each a test", "paths", default=[]
    )


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.File | None:
    if file_path.suffix != ".toml":
        return None
    for place in parent.config.getini("oncard_scenarios"):
        if file_path == place or place in file_path.parents:
            return ScenarioFile.from_parent(parent, path=file_path)  # type: ignore[no-any-return]
    return None


class ScenarioFailed(Exception):
    """A scenario does not do what it should; the text is the report."""


class ScenarioFile(pytest.File):
    """A scenario file: one test."""

    def collect(self) -> Iterator[pytest.Item]:
        yield ScenarioTest.from_parent(self, name="scenario")


class ScenarioTest(pytest.Item):
    """The test of a scenario."""

    def runtest(self) -> None:
        # Paths in messages are as short as those of pytest.
        path = os.path.relpath(self.path)
        kind, verdict, checks = _oncard.test_kind(os.fsencode(path), {})
        if kind == "host":
            _test_host(path)
        elif kind == "explore":
            _test_schedules(path, verdict)
        else:
            _test_run(path)
        if not checks:
            pytest.skip(
                "未检查任何内容：既没有期望也没有要求"
                if is_chinese()
                else "checks nothing: it has no expectation and no requirement"
            )

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, (ScenarioFailed, oncard.Error)):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, None, str]:
        return self.path, None, os.path.relpath(self.path)


def _test_run(path: str) -> None:
    run = oncard.run(path)
    if not run.passed:
        raise ScenarioFailed("\n".join(str(failure) for failure in run.failures))


def _test_schedules(path: str, verdict: str) -> None:
    exploration = oncard.explore(path, seconds=_SECONDS)
    if exploration._exploration.cut():
        raise ScenarioFailed(
            f"搜索在完成前达到时间上限 {_SECONDS:g} 秒或内存上限"
            if is_chinese()
            else f"the search was ended by its limit of {_SECONDS:g} s or of memory before it was "
            "complete"
        )
    if exploration.verdict == verdict:
        return
    should = f"结论应为 {verdict}：" if is_chinese() else f"the verdict should be {verdict}:"
    raise ScenarioFailed(f"{should}\n{exploration.text}")


def _test_host(path: str) -> None:
    command = os.environ.get("ONCARD") or shutil.which("oncard")
    if command is None:
        pytest.skip(
            "主机程序由命令 oncard 运行：请将其加入 PATH，或用环境变量 ONCARD 给出"
            if is_chinese()
            else "a host program is run by the command oncard: put it into PATH, or name it in ONCARD"
        )
    try:
        done = subprocess.run(
            [command, f"--lang={'zh' if is_chinese() else 'en'}", "test", "--format=json", path],
            capture_output=True,
            text=True,
        )
    except OSError as error:
        raise ScenarioFailed(f"{command}: {error.strerror}") from None
    try:
        test = json.loads(done.stdout)["tests"][0]
    except (ValueError, KeyError, IndexError):
        raise ScenarioFailed(done.stderr.strip() or done.stdout) from None
    if "why" in test:  # it is skipped, or checks nothing
        pytest.skip(str(test["why"]))
    if not test["passed"]:
        raise ScenarioFailed("\n".join(map(str, test["failures"])))
