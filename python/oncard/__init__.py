"""Motion programs for Googol GTS motion controllers without the card."""

from __future__ import annotations

try:
    from . import _oncard
except ImportError as error:
    from .wrong_python import explain

    raise ImportError(explain(error)) from error

from .errors import CompileError, Diagnostic, Error, UnknownName, set_language
from .expressions import Expression, var

__version__ = _oncard.version

__all__ = [
    "CompileError",
    "Diagnostic",
    "Error",
    "Expression",
    "UnknownName",
    "set_language",
    "var",
]
