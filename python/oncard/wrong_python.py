"""Why the module cannot be loaded: it is made for one version of Python."""

from __future__ import annotations

import sys
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path


def explain(error: ImportError) -> str:
    """What is wrong, and what to do, in both languages."""
    modules = sorted(Path(__file__).parent.glob("_oncard.*.so"))
    suits = [module for module in modules if module.name.endswith(EXTENSION_SUFFIXES[0])]
    if modules and not suits:
        made_for = modules[0].name.split(".")[1]
        this = EXTENSION_SUFFIXES[0].split(".")[1]
        return (
            f"oncard is built for {made_for}, but {sys.executable} is {this}: use that Python, or "
            "build the package for this one (./x python)\n"
            f"oncard 为 {made_for} 构建，而 {sys.executable} 是 {this}：请使用该版本的 Python，"
            "或为当前版本构建（./x python）"
        )
    if not modules:
        return (
            f"the module of oncard is not in {Path(__file__).parent}: ./x python builds it; then "
            "put build/python into PYTHONPATH, or install the wheel\n"
            f"{Path(__file__).parent} 中没有 oncard 的模块：请用 ./x python 构建，"
            "然后把 build/python 加入 PYTHONPATH，或安装 wheel"
        )
    return f"the module of oncard cannot be loaded: {error}\n无法加载 oncard 的模块：{error}"
