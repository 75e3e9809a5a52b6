"""Pictures of traces by gnuplot, and tables as HTML."""

from __future__ import annotations

import html
import subprocess
from collections.abc import Iterable

from .errors import Error


def draw(script: bytes) -> bytes:
    """The picture that gnuplot makes of a script."""
    try:
        # -d: without the user's initialisation file.
        drawn = subprocess.run(["gnuplot", "-d", "-"], input=script, capture_output=True)
    except FileNotFoundError:
        raise GnuplotMissing(
            "gnuplot is not installed: apt-get install gnuplot-nox",
            "未安装 gnuplot：apt-get install gnuplot-nox",
        ) from None
    if drawn.returncode != 0 or not drawn.stdout:
        text = drawn.stderr.decode(errors="replace").strip()
        raise Error(f"gnuplot: {text}", f"gnuplot：{text}")
    return drawn.stdout


class GnuplotMissing(Error):
    """Pictures need a program that is not installed."""


def table(heading: str, rows: Iterable[tuple[object, object]]) -> str:
    """A heading with a table of names and values, for notebooks."""
    lines = "".join(
        f"<tr><th>{html.escape(str(name))}</th><td>{html.escape(str(value))}</td></tr>"
        for name, value in rows
    )
    return f"<p>{html.escape(heading)}</p><table>{lines}</table>"
