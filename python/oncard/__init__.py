"""Motion programs for Googol GTS motion controllers without the card."""

from __future__ import annotations

from . import _oncard
from .errors import CompileError, Diagnostic, Error, UnknownName, set_language

__version__ = _oncard.version

__all__ = [
    "CompileError",
    "Diagnostic",
    "Error",
    "UnknownName",
    "set_language",
]
