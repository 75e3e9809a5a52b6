"""Sessions: a run that is driven forward and back, looked into and changed.

Each method is a request of the session protocol (docs/session-protocol.md), which says what its
arguments and answers mean.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from types import TracebackType
from typing import TYPE_CHECKING, Any, Union

from . import _oncard
from .errors import Error, is_chinese
from .expressions import Expression
from .inputs import Files, Input, source_of, texts_of
from .pictures import table

if TYPE_CHECKING:
    import numpy
    import numpy.typing

    Column = numpy.typing.NDArray[numpy.float64]

# A walk looks for Ctrl-C after so many steps: a fraction of a second.
_BUDGET = 100_000


@dataclass(frozen=True)
class Stop:
    """Why a walk ended."""

    reason: str
    """goal, line, change, condition, fault, refusal, race, warning, requirement, end, start, ..."""
    thread: int | None = None
    number: int | None = None
    """Which of the wishes of `set_stops`, from 0."""
    text: str | None = None
    failed: tuple[str, ...] = ()
    """At the end: what does not hold."""


class Session:
    """A program or a scenario at a moment of its run.

        with oncard.Session("trap.toml") as card:
            card.forward("time", ms=500)
            card.value("axis1.prfPos")
            card.back("cycle")
    """

    def __init__(
        self,
        main: Input,
        *,
        files: Files | None = None,
        structured: bool = False,
        card: int | None = None,
        opening: int | None = None,
        silent: Sequence[str] = (),
    ) -> None:
        """Loads a file (.c, .bin, .toml, .schedule, .calls), a scenario as a dict, or a Program.

        `card` and `opening` choose from the record of a host. Raises CompileError if the program
        has mistakes.
        """
        self._session: _oncard.Session | None = _oncard.Session()
        self._state: dict[str, Any] = {}
        source = source_of(main, files, structured)
        answer = self.request(
            "load",
            main=os.fsdecode(source.main),
            files={os.fsdecode(path): _text(path, text) for path, text in source.files.items()},
            structured=source.structured,
            card=card,
            opening=opening,
            silent=texts_of("silent", silent),
        )
        if not answer["compiled"]:
            # Raises CompileError: the session has only the diagnostics, without their text.
            _oncard.compile(source.main, source.files, source.structured)
        self._state = answer["state"]

    def __enter__(self) -> Session:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Frees the run. Its last state remains readable."""
        self._session = None

    # --- Where it is ------------------------------------------------------------------------------

    @property
    def state(self) -> dict[str, Any]:
        """The state of the card and its threads."""
        return self._state

    @property
    def moment(self) -> int:
        """Steps since the start."""
        return int(self._state["moment"])

    @property
    def time_ms(self) -> float:
        """The card's time in milliseconds."""
        return float(self._state["time_ms"])

    @property
    def hash(self) -> str:
        """Of the whole card: equal states have equal hashes."""
        return str(self._state["hash"])

    @property
    def over(self) -> str | None:
        """How the run of the scenario has ended; None while it goes on."""
        return self._state.get("over")

    @property
    def threads(self) -> list[dict[str, Any]]:
        """The bound threads."""
        return list(self._state["threads"])

    @property
    def warnings(self) -> list[dict[str, Any]]:
        """What the card's supervisor has warned of up to now."""
        return list(self._state["warnings"])

    # --- Walks ------------------------------------------------------------------------------------

    def forward(
        self, goal: str = "stop", *, thread: int | None = None, ms: float | None = None
    ) -> Stop:
        """Walks forward to a goal or a stop.

        `goal` is step, statement, line, cycle, time, stop, rest or call; statement and line need
        `thread`, time needs `ms`.
        """
        if goal != "time":
            return self._walk("forward", goal=goal, thread=thread, ms=ms)
        # The budget can end a walk on its way: what is left of the time is the next one's.
        begin = self.time_ms
        stop = self._step("forward", goal=goal, thread=thread, ms=ms)
        while stop.reason == "budget" and ms is not None:
            left = round(begin + ms - self.time_ms, 3)
            stop = self._step("forward", goal=goal, ms=max(left, 0.0))
        return stop

    def back(
        self, goal: str = "stop", *, thread: int | None = None, name: str | None = None
    ) -> Stop:
        """Walks back to a goal or a stop.

        `goal` is step, statement, line, cycle, stop, change or call; statement and line need
        `thread`, change needs `name`, the value that has changed.
        """
        return self._walk("back", goal=goal, thread=thread, name=name)

    def step_thread(self, thread: int) -> Stop:
        """Lets this thread execute a statement, whatever the policy of the scenario says."""
        return self._stop(self.request("step_thread", thread=thread))

    def go_to(self, moment: int | None = None, *, ms: float | None = None) -> None:
        """Goes to a moment that has been reached before, or to a time."""
        self._state = self.request("go_to", moment=moment, ms=ms)

    def set_stops(self, **wishes: Any) -> list[int]:
        """Replaces all stops: lines, changes, conditions, faults, refusals, requirements, races,
        warnings. Returns the lines at which those of `lines` are."""
        conditions = wishes.get("conditions")
        if conditions is not None:
            wishes["conditions"] = [str(condition) for condition in conditions]
        return list(self.request("set_stops", **wishes)["lines"])

    # --- Looks ------------------------------------------------------------------------------------

    def value(self, name: str | Expression, thread: int | None = None) -> Any:
        """A value by its name, an array as a list; or whether a condition holds.

        With `thread`, local variables of its function need no page.
        """
        answer = self.request("evaluate", text=str(name), thread=thread)
        return answer["value"] if "value" in answer else answer["holds"]

    def variables(self, page: int | None = None) -> Any:
        """The global variables, or those of the function on a data page."""
        return self.request("variables", page=page)

    def card(self) -> dict[str, Any]:
        """Axes, profiles, encoders and so on with their values; inputs, outputs, switches."""
        parts: dict[str, Any] = self.request("card")
        return parts

    def trace(
        self, names: str | Sequence[str], from_ms: float, to_ms: float, points: int
    ) -> dict[str, tuple[Column, Column]]:
        """Values over a time that has passed, in `points` equal parts: by name the least and the
        largest value of each part."""
        import numpy

        channels = self.request(
            "trace", names=texts_of("names", names), from_ms=from_ms, to_ms=to_ms, points=points
        )
        return {
            channel["name"]: (numpy.array(channel["least"]), numpy.array(channel["largest"]))
            for channel in channels
        }

    # --- Changes and recordings -------------------------------------------------------------------

    def write(self, name: str, value: float) -> None:
        """Changes a variable."""
        self._state = self.request("write", name=name, value=value)

    def set_input(self, type: str, index: int, level: int) -> None:
        """Changes an input pin: `set_input("home", 1, 1)`."""
        self._state = self.request("set_input", type=type, index=index, level=int(level))

    def set_voltage(self, channel: int, volts: float) -> None:
        """Changes the voltage at an analogue input."""
        self._state = self.request("set_voltage", channel=channel, volts=volts)

    def move_switch(
        self, switch: int, *, start: float | None = None, end: float | None = None
    ) -> None:
        """Moves a switch of the scenario, counted from 1: it is then operated between these
        positions in pulses."""
        self._state = self.request("move_switch", **{"switch": switch, "from": start, "to": end})

    def record(self, path: str | None = None) -> str:
        """The run up to now as the text of a schedule file, for `oncard.run`; `path` is where it
        will be kept."""
        return str(self.request("record", path=path)["schedule"])

    # --- The protocol -----------------------------------------------------------------------------

    def request(self, name: str, /, **arguments: Any) -> Any:
        """Any request of the protocol; arguments that are None are left out."""
        given = {key: value for key, value in arguments.items() if value is not None}
        try:
            text = json.dumps({"request": name, "arguments": given}, allow_nan=False)
        except (TypeError, ValueError) as error:
            raise Error(
                f"an argument of '{name}' is no number, text or list: {error}",
                f"“{name}”的参数不是数、文本或列表：{error}",
            ) from None
        answer = self._ask(text, is_chinese())
        if answer["ok"]:
            return answer["result"]
        # A request that fails changes nothing, so that the other language can be asked for.
        other = self._ask(text, not is_chinese())["error"]
        texts = (other, answer["error"]) if is_chinese() else (answer["error"], other)
        raise Error(*texts)

    def _ask(self, text: str, chinese: bool) -> Any:
        if self._session is None:
            raise Error("the session is closed", "会话已关闭")
        language = {"language": "zh" if chinese else "en"}
        self._session.handle(json.dumps({"request": "hello", "arguments": language}).encode())
        return json.loads(self._session.handle(text.encode()).splitlines()[-1])

    def _walk(self, request: str, **arguments: Any) -> Stop:
        """Walks until something other than the budget ends it."""
        while True:
            stop = self._step(request, **arguments)
            if stop.reason != "budget":
                return stop

    def _step(self, request: str, **arguments: Any) -> Stop:
        try:
            return self._stop(self.request(request, budget=_BUDGET, **arguments))
        except KeyboardInterrupt:
            self._state = self.request("state")  # it has gone on
            raise

    def _stop(self, answer: dict[str, Any]) -> Stop:
        self._state = answer["state"]
        stop = answer["stop"]
        return Stop(
            stop["reason"],
            stop.get("thread"),
            stop.get("number"),
            stop.get("text"),
            tuple(stop.get("failed", ())),
        )

    def __repr__(self) -> str:
        return f"<oncard.Session at {self.time_ms} ms>"

    def _repr_html_(self) -> str:
        rows = [(f"thread {item['thread']} {item['function']}", item["status"])
                for item in self.threads]
        return table(repr(self)[1:-1], rows)


def _text(path: bytes, text: bytes) -> str:
    """The protocol has texts in UTF-8 only."""
    try:
        return text.decode()
    except UnicodeDecodeError:
        name = os.fsdecode(path)
        raise Error(
            f"'{name}' is not UTF-8, as files that a session is given must be: save it as a file",
            f"“{name}”不是 UTF-8，而交给会话的文件必须是 UTF-8：请将其保存为文件",
        ) from None
