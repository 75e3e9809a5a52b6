"""Motion programs for Googol GTS motion controllers without the card.

    run = oncard.run("trap.toml", trace=True)
    run.passed, run.trace["axis1.prfPos"]

docs/python.md describes the package.
"""

from __future__ import annotations

try:
    from . import _oncard
except ImportError as error:
    from .wrong_python import explain

    raise ImportError(explain(error)) from error

from .errors import CompileError, Diagnostic, Error, UnknownName, set_language
from .explorations import Exploration, explore
from .expressions import Expression, var
from .runs import Failure, Program, Run, Trace, compile, run
from .sessions import Session, Stop

__version__ = _oncard.version

__all__ = [
    "CompileError",
    "Diagnostic",
    "Error",
    "Exploration",
    "Expression",
    "Failure",
    "Program",
    "Run",
    "Session",
    "Stop",
    "Trace",
    "UnknownName",
    "compile",
    "explore",
    "run",
    "set_language",
    "var",
]
