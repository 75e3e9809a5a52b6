"""The package as it is handed out: its types, its wheel, and another Python than its own."""

import ast
import os
import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

import oncard

PACKAGE = Path(oncard.__file__).parent


def python(*arguments, path, **options):
    """Another process of this Python, with packages from `path`."""
    return subprocess.run(
        [sys.executable, *arguments],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(path)},
        **options,
    )


def test_types_are_right(tmp_path):
    pytest.importorskip("mypy", reason="there is no mypy: apt-get install mypy")
    checked = python(
        "-m", "mypy", "--strict", "--ignore-missing-imports", f"--cache-dir={tmp_path}", PACKAGE,
        path=PACKAGE.parent,
    )
    assert checked.returncode == 0, checked.stdout + checked.stderr


def stubs(tree, path=""):
    """The names in a stub, functions with the names of their arguments."""
    for item in tree.body:
        if isinstance(item, ast.FunctionDef):
            yield path + item.name, [argument.arg for argument in item.args.args]
        elif isinstance(item, ast.ClassDef):
            yield path + item.name, None
            yield from stubs(item, f"{path}{item.name}.")
        elif isinstance(item, ast.AnnAssign):
            yield path + item.target.id, None


def names(things, path=""):
    """The same of a module of pybind11, whose functions say what they take in their first line."""
    for name, thing in vars(things).items():
        if name.startswith("_"):
            continue
        if callable(thing) and not isinstance(thing, type):
            yield path + name, re.findall(r"(\w+): ", thing.__doc__.split(" -> ")[0])
        else:
            yield path + name, None
        if isinstance(thing, type):
            yield from names(thing, f"{path}{name}.")


def test_the_stub_has_what_the_module_has():
    stub = ast.parse((PACKAGE / "_oncard.pyi").read_text(encoding="utf-8"))
    assert dict(stubs(stub)) == dict(names(oncard._oncard))


@pytest.fixture
def copy(tmp_path):
    """A copy of the package; its module."""
    shutil.copytree(PACKAGE, tmp_path / "oncard")
    return next((tmp_path / "oncard").glob("_oncard.*.so"))


def test_a_module_for_another_python_is_explained(copy):
    copy.rename(copy.with_name("_oncard.cpython-39-x86_64-linux-gnu.so"))
    done = python("-c", "import oncard", path=copy.parents[1])
    assert done.returncode != 0
    assert f"built for cpython-39-x86_64-linux-gnu, but {sys.executable} is cpython-" in done.stderr
    assert "./x python" in done.stderr and "构建" in done.stderr


def test_a_missing_or_broken_module_is_explained(copy):
    copy.write_bytes(b"no module")
    done = python("-c", "import oncard", path=copy.parents[1])
    assert "the module of oncard cannot be loaded" in done.stderr
    copy.unlink()
    done = python("-c", "import oncard", path=copy.parents[1])
    assert "./x python builds it" in done.stderr


def test_a_wheel_is_for_this_python_and_has_the_plugin(tmp_path):
    pytest.importorskip("build", reason="there is no build: apt-get install python3-build")
    project = tmp_path / "project"
    shutil.copytree(PACKAGE.parent, project, ignore=shutil.ignore_patterns("CMakeFiles"))
    done = python(
        "-m", "build", "--wheel", "--no-isolation", "--outdir", tmp_path, project, path=""
    )
    assert done.returncode == 0, done.stdout + done.stderr
    wheel = next(tmp_path.glob("*.whl"))
    version = f"cp{sys.version_info.major}{sys.version_info.minor}"
    assert wheel.name == f"oncard-{oncard.__version__}-{version}-{version}-linux_x86_64.whl"
    installed = tmp_path / "installed"
    zipfile.ZipFile(wheel).extractall(installed)
    names = {path.name for path in (installed / "oncard").iterdir()}
    assert names == {path.name for path in PACKAGE.iterdir() if path.name != "__pycache__"}
    # pytest finds the plugin by itself.
    for named in ([], ["-p", "oncard.pytest_plugin"]):
        done = python("-m", "pytest", *named, "--help", path=installed, cwd=tmp_path)
        assert "oncard_scenarios" in done.stdout, done.stderr
