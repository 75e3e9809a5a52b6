"""Requirements as expressions: `oncard.var("sum") < 100` is the text `sum < 100`.

Conditions are evaluated by oncard in every state of a run, so they are texts of its language
(docs/scenarios.md), never functions of Python.
"""

from __future__ import annotations

import math
import numbers
import re
from collections.abc import Iterable
from typing import Union

from .errors import Error

_NAME = re.compile(r"[^\W\d][\w.]*(\[\d+\])?(\.\w+)*")


class Expression:
    """A value or a condition on the card. Its operators make larger ones.

    Arithmetic is `+ - *`, comparisons are those of Python, and conditions are combined with
    `&` (and), `|` (or) and `~` (not).
    """

    def __init__(self, text: str, whole: bool = True) -> None:
        """`whole`: it needs no parentheses as a part of another expression."""
        self._text = text
        self._whole = whole

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return f"<oncard.Expression {self._text}>"

    def near(self, value: Operand, tolerance: float) -> Expression:
        """True where it differs from the value by at most the tolerance."""
        return Expression(f"{_part(self)} == {_part(value)} +- {_part(tolerance)}", False)

    def at(self, ms: float) -> str:
        """For `expect`: the condition at this instant, in milliseconds since the start."""
        return f"{self._text} @ {_part(ms)}ms"

    def __add__(self, other: Operand) -> Expression:
        return _join(self, "+", other)

    def __radd__(self, other: Operand) -> Expression:
        return _join(other, "+", self)

    def __sub__(self, other: Operand) -> Expression:
        return _join(self, "-", other)

    def __rsub__(self, other: Operand) -> Expression:
        return _join(other, "-", self)

    def __mul__(self, other: Operand) -> Expression:
        return _join(self, "*", other)

    def __rmul__(self, other: Operand) -> Expression:
        return _join(other, "*", self)

    def __neg__(self) -> Expression:
        return Expression(f"-{_part(self)}", False)

    def __lt__(self, other: Operand) -> Expression:
        return _join(self, "<", other)

    def __le__(self, other: Operand) -> Expression:
        return _join(self, "<=", other)

    def __gt__(self, other: Operand) -> Expression:
        return _join(self, ">", other)

    def __ge__(self, other: Operand) -> Expression:
        return _join(self, ">=", other)

    def __eq__(self, other: Operand) -> Expression:  # type: ignore[override]
        return _join(self, "==", other)

    def __ne__(self, other: Operand) -> Expression:  # type: ignore[override]
        return _join(self, "!=", other)

    def __and__(self, other: Operand) -> Expression:
        return _join(self, "&&", other)

    def __rand__(self, other: Operand) -> Expression:
        return _join(other, "&&", self)

    def __or__(self, other: Operand) -> Expression:
        return _join(self, "||", other)

    def __ror__(self, other: Operand) -> Expression:
        return _join(other, "||", self)

    def __invert__(self) -> Expression:
        return Expression(f"!{_part(self)}", False)

    # What is equal cannot be decided without a card.
    __hash__ = None  # type: ignore[assignment]

    def __bool__(self) -> bool:
        raise Error(
            f"'{self._text}' is true or false only on the card: instead of 'and', 'or', 'not' and "
            "chains such as 0 < x < 5 write &, |, ~ and (0 < x) & (x < 5)",
            f"“{self._text}”的真假只有在控制卡上才能确定：请用 &、|、~ 代替 and、or、not，"
            "并把 0 < x < 5 写成 (0 < x) & (x < 5)",
        )


Operand = Union[Expression, float]
Requirements = Union[str, Expression, Iterable[Union[str, Expression]]]


def var(name: str) -> Expression:
    """A value by its name: `sum`, `a[3]`, `axis1.prfPos`, `thread0.result` (docs/scenarios.md)."""
    if not isinstance(name, str) or not _NAME.fullmatch(name):
        raise Error(
            f"{name!r} is no name of a value: names are such as 'sum', 'a[3]' or 'axis1.prfPos'",
            f"{name!r} 不是值的名称：名称如 'sum'、'a[3]' 或 'axis1.prfPos'",
        )
    return Expression(name)


def condition_text(condition: str | Expression) -> str:
    """The text of a condition. Fails for everything that is none."""
    if isinstance(condition, (str, Expression)):
        return str(condition)
    if callable(condition):
        raise Error(
            "a requirement is a text or an expression, not a function of Python, because it must "
            "hold in states that Python never sees: write always=['sum < 100'] or "
            "always=[oncard.var('sum') < 100]",
            "要求应为文本或表达式，不能是 Python 函数，因为它要在 Python 看不到的状态中成立："
            "应写成 always=['sum < 100'] 或 always=[oncard.var('sum') < 100]",
        )
    raise Error(
        f"a requirement is a text or an expression, not {condition!r}: write 'sum < 100' or "
        "oncard.var('sum') < 100",
        f"要求应为文本或表达式，而不是 {condition!r}：应写成 'sum < 100' 或 "
        "oncard.var('sum') < 100",
    )


def condition_texts(conditions: Requirements) -> list[str]:
    """The texts of one condition, or of several."""
    if isinstance(conditions, Iterable) and not isinstance(conditions, str):
        return [condition_text(condition) for condition in conditions]
    return [condition_text(conditions)]


def _part(operand: Operand) -> str:
    if isinstance(operand, Expression):
        return operand._text if operand._whole else f"({operand._text})"
    if isinstance(operand, numbers.Integral):
        return str(int(operand))
    if isinstance(operand, numbers.Real) and math.isfinite(operand):
        return repr(float(operand))
    raise Error(
        f"an expression is made of names, finite numbers and other expressions, not of {operand!r}:"
        " write oncard.var('sum') for the name of a value",
        f"表达式由名称、有限的数和其他表达式组成，不能含有 {operand!r}："
        "值的名称应写成 oncard.var('sum')",
    )


def _join(left: Operand, operator: str, right: Operand) -> Expression:
    return Expression(f"{_part(left)} {operator} {_part(right)}", False)
