"""What the tests of the package share. ONCARD names the command, as for the plugin."""

import json
import os
import subprocess
from pathlib import Path

import pytest

import oncard

pytest_plugins = ["pytester"]

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "samples"


@pytest.fixture(autouse=True)
def english():
    oncard.set_language("en")


@pytest.fixture
def samples(monkeypatch):
    """The folder of samples, which is the current one."""
    monkeypatch.chdir(SAMPLES)
    return SAMPLES


@pytest.fixture
def in_folder(tmp_path, monkeypatch):
    """An empty folder, which is the current one."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def command(*arguments):
    """The output of the command `oncard` as JSON."""
    done = subprocess.run(
        [os.environ["ONCARD"], "--lang=en", *arguments, "--format=json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    return json.loads(done.stdout)
