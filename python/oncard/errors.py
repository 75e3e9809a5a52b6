"""Errors in English and Chinese, and the choice between both."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Literal

from . import _oncard

Language = Literal["en", "zh"]

_chinese = _oncard.environment_is_chinese()


def set_language(language: Language) -> None:
    """Chooses the language of all texts: "en" or "zh". At first it is that of the environment."""
    global _chinese
    if language not in ("en", "zh"):
        raise Error(
            f"there is no language {language!r}: use 'en' or 'zh'",
            f"没有语言 {language!r}：应使用 'en' 或 'zh'",
        )
    _chinese = language == "zh"


def is_chinese() -> bool:
    """True if the language is Chinese."""
    return _chinese


class Error(Exception):
    """Why a call failed, and what to do. `str()` is in the language of `set_language()`."""

    def __init__(self, message_en: str, message_zh: str) -> None:
        super().__init__(message_en, message_zh)
        self.message_en = message_en
        self.message_zh = message_zh

    @property
    def message(self) -> str:
        """The text in the language of `set_language()`."""
        return self.message_zh if _chinese else self.message_en

    def __str__(self) -> str:
        return self.message


class UnknownName(Error, KeyError):
    """There is no value of this name."""


@dataclass(frozen=True)
class Diagnostic:
    """An error or a warning of the compiler, as `oncard check --format=json` writes it."""

    code: str
    """Such as `MP027`, which `oncard explain` explains."""
    severity: str
    """`error` or `warning`."""
    message_en: str
    message_zh: str
    file: str | None
    line: int | None
    """From 1."""
    column: int | None

    @property
    def message(self) -> str:
        """The text in the language of `set_language()`."""
        return self.message_zh if _chinese else self.message_en

    def __str__(self) -> str:
        place = "" if self.file is None else f"{self.file}:{self.line}:{self.column}: "
        return f"{place}{self.severity} {self.code}: {self.message}"


class CompileError(Error):
    """A program has mistakes. The text is that of `oncard check`; `diagnostics` lists them."""

    def __init__(self, message_en: str, message_zh: str, diagnostics: str) -> None:
        super().__init__(message_en, message_zh)
        self.args = (message_en, message_zh, diagnostics)
        self.diagnostics = read_diagnostics(diagnostics)


def read_diagnostics(text: str) -> list[Diagnostic]:
    """The diagnostics in the compiler's JSON."""
    return [
        Diagnostic(
            item["code"],
            item["severity"],
            item["message_en"],
            item["message_zh"],
            item.get("file"),
            item.get("line"),
            item.get("column"),
        )
        for item in json.loads(text)
    ]
