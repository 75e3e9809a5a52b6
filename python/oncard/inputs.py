"""What can be run: files by their names, files by their content, scenarios as dicts."""

from __future__ import annotations

import operator
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, SupportsIndex, Union

from .errors import Error
from .expressions import Expression, condition_text

if TYPE_CHECKING:
    from .runs import Program

Path = Union[str, "os.PathLike[str]"]
Input = Union[Path, Mapping[str, Any], "Program"]
Files = Mapping[Path, Union[str, bytes]]

# Stands for the file of a scenario that is a dict. No file has this name by chance.
_DICT_NAME = b"<dict>.toml"


@dataclass(frozen=True)
class Source:
    """An input as the module takes it."""

    main: bytes
    files: dict[bytes, bytes]
    structured: bool


def source_of(main: Input, files: Files | None, structured: bool) -> Source:
    """The input with the files that are given by content; the others are read when needed."""
    from .runs import Program

    texts = {} if files is None else _texts(files)
    if isinstance(main, Program):
        source = main.source
        return Source(source.main, {**source.files, **texts}, structured or source.structured)
    if isinstance(main, Mapping):
        return Source(_DICT_NAME, {**texts, _DICT_NAME: _toml(main)}, structured)
    return Source(path_bytes(main), texts, structured)


def path_bytes(path: Path) -> bytes:
    """The name of a file as the system has it."""
    try:
        name = os.fsencode(path)
    except TypeError:
        raise Error(
            f"{path!r} is neither a file nor a scenario: give a path, a dict or a program",
            f"{path!r} 既不是文件也不是场景：应给出路径、dict 或程序",
        ) from None
    except UnicodeEncodeError:
        name = b""
    if not name or b"\0" in name:
        raise Error(f"{path!r} is no name of a file", f"{path!r} 不是文件名")
    return name


def texts_of(argument: str, texts: str | Sequence[str]) -> list[str]:
    """One text, or several."""
    items = list(texts) if isinstance(texts, Iterable) and not isinstance(texts, str) else [texts]
    for item in items:
        if not isinstance(item, str):
            raise Error(
                f"'{argument}' must be texts, not {item!r}",
                f"“{argument}”应为文本，而不是 {item!r}",
            )
        _utf8(argument, item)
    return items


def whole_number(argument: str, value: SupportsIndex | None) -> int | None:
    """A whole number of any type."""
    if value is None:
        return None
    try:
        number = operator.index(value)
    except TypeError:
        number = None
    if number is None or isinstance(value, bool) or abs(number) >= 2**63:
        raise Error(
            f"'{argument}' must be a whole number, not {value!r}",
            f"“{argument}”应为整数，而不是 {value!r}",
        )
    return number


def _texts(files: Files) -> dict[bytes, bytes]:
    if not isinstance(files, Mapping):
        raise Error(
            f"'files' must be a dict of texts by their names, not {files!r}",
            f"“files”应为 dict，键为文件名，值为文本，而不是 {files!r}",
        )
    texts = {}
    for name, text in files.items():
        path = path_bytes(name)
        if not isinstance(text, (str, bytes)):
            raise Error(
                f"the content of '{os.fsdecode(name)}' must be a text, not {text!r}",
                f"“{os.fsdecode(name)}”的内容应为文本，而不是 {text!r}",
            )
        texts[path] = _utf8(os.fsdecode(name), text) if isinstance(text, str) else text
    return texts


def _utf8(what: str, text: str) -> bytes:
    """The bytes of a text, which can have halves of characters: names of files in Python do."""
    try:
        return text.encode()
    except UnicodeEncodeError as error:
        half = text[error.start]
        raise Error(
            f"'{what}' has {half!r}, which is no character of UTF-8",
            f"“{what}”含有 {half!r}，它不是 UTF-8 字符",
        ) from None


def _toml(scenario: Mapping[str, Any]) -> bytes:
    try:
        import tomli_w
    except ImportError:
        raise Error(
            "scenarios as dicts need tomli-w: apt-get install python3-tomli-w",
            "以 dict 给出场景需要 tomli-w：apt-get install python3-tomli-w",
        ) from None
    return _utf8(os.fsdecode(_DICT_NAME), tomli_w.dumps(_table(scenario, "")))


def _table(table: Mapping[str, Any], where: str) -> dict[str, Any]:
    plain = {}
    for key, value in table.items():
        if not isinstance(key, str):
            raise Error(
                f"the keys of a scenario are texts, not {key!r}",
                f"场景的键应为文本，而不是 {key!r}",
            )
        plain[key] = _plain(value, f"{where}{key}")
    return plain


def _plain(value: Any, where: str) -> Any:
    """The value as TOML has it."""
    if isinstance(value, (bool, int, float, str)):
        # Subclasses, such as numpy.float64, can have another representation.
        for kind in (bool, int, float, str):
            if isinstance(value, kind):
                return kind(value)
    if isinstance(value, Expression) or callable(value):
        return condition_text(value)
    if isinstance(value, os.PathLike):
        return os.fsdecode(value)
    if isinstance(value, Mapping):
        return _table(value, f"{where}.")
    if hasattr(value, "tolist"):
        return _plain(value.tolist(), where)
    if isinstance(value, Sequence) and not isinstance(value, bytes):
        return [_plain(item, f"{where}[{i}]") for i, item in enumerate(value)]
    raise Error(
        f"'{where}' of the scenario cannot be {value!r}: use texts, numbers, lists and dicts",
        f"场景的“{where}”不能是 {value!r}：应使用文本、数、列表和 dict",
    )
