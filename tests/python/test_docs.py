"""The code of docs/python.md does what the page says. The tutorial is tested by tests/docs/."""

import re
import shutil

from conftest import ROOT, SAMPLES

import oncard


def test_the_code_of_the_page_runs(in_folder):
    for folder in ("10_trap", "26_lost_update"):
        shutil.copytree(SAMPLES / folder, in_folder, dirs_exist_ok=True)
    page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names = {}
    for block in blocks:
        exec(block, names)
    assert names["run"].passed and names["proof"].verdict == "FAILED"
    assert len(blocks) == 2


def test_the_page_names_all_that_the_package_has():
    page = (ROOT / "docs/python.md").read_text(encoding="utf-8")
    words = set(re.findall(r"\w+", page))
    public = set(oncard.__all__) - {"Diagnostic", "Expression", "Failure", "Stop", "Trace"}
    for kind in (oncard.Program, oncard.Run, oncard.Session, oncard.Exploration, oncard.CompileError):
        public |= {name for name in vars(kind) if not name.startswith("_")}
    assert public <= words
